// Clusters in files: scenarios, runs, exports and what the command line prints.

#include "core/geometry/enclosing_circle.h"
#include "core/io/export/missions/mission_items.h"
#include "core/io/export/missions/plan_csv.h"
#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/io/results/curve_result.h"
#include "core/io/results/plan_result.h"
#include "core/io/results/result_json.h"
#include "core/mission/mission_instant.h"
#include "core/mission/visits.h"
#include "core/sim/clusters.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/files/geojson_view.h"
#include "tests/support/flight/cluster_scenes.h"
#include "tests/support/flight/flown_plans.h"

#include <QTest>

#include <algorithm>

using namespace berg;
using namespace berg::test;

namespace {

/** A dense field flown partly with a route policy that ignores clusters. */
RunFile crowdedRun()
{
    Scenario scenario = crowd(3);
    scenario.duration_s = 400;
    scenario.planner.policy = PolicyKind::Latency;
    Mission mission(scenario, {.keyframeInterval_s = 5});
    mission.advance(100);
    mission.intervene({.policy = PolicyKind::Tour});
    mission.advance(130);
    mission.intervene({.policy = PolicyKind::Visitation});
    mission.advance(400);
    return runOf(mission);
}

const RunFile& recorded()
{
    static const RunFile run = crowdedRun();
    return run;
}

/** Returns the first keyframe on the leg to a cluster. */
std::size_t keyframeWithMembers(const RunFile& run)
{
    const auto found = std::ranges::find_if(
        run.keyframes, [](const WorldState& state) { return !state.uavs[0].members.empty(); });
    return static_cast<std::size_t>(found - run.keyframes.begin());
}

/** Icebergs 0 and 2 of the four drift within one field of view. */
Scenario twoTogether()
{
    Scenario scenario = fourIcebergs();
    scenario.clusters = true;
    scenario.icebergs[2].position_m = scenario.icebergs[0].position_m + Point(100, 350);
    return scenario;
}

Plan planOfTwoTogether()
{
    Plan plan = planOf({3, 0, 2, 1});
    plan.uavs[0].clusters = {{0, 2}};
    return plan;
}

} // namespace

class TestClusterFiles : public QObject
{
    Q_OBJECT

private slots:
    void settingIsReadBack()
    {
        Scenario scenario = fourIcebergs();
        QVERIFY(scenarioToJson(scenario).find("clusters") == std::string::npos);
        scenario.clusters = true;
        const std::string text = scenarioToJson(scenario);
        QVERIFY(text.find(R"("clusters": true)") != std::string::npos);
        QVERIFY(scenarioFromJson(text, "text") == scenario);
    }

    void runsAreReadBackExactly()
    {
        const RunFile& run = recorded();
        QVERIFY(keyframeWithMembers(run) < run.keyframes.size());
        QVERIFY(!run.plans.front()->uavs[0].clusters.empty());
        const std::string text = runToJson(run);
        const RunFile read = runFromJson(text, "text");
        QVERIFY(read == run);
        QCOMPARE(runToJson(read), text);
    }

    void unclusteredIcebergsAreReadBack()
    {
        RunFile run = recorded();
        run.keyframes[2].unclustered = {5, 1};
        QVERIFY(runFromJson(runToJson(run), "text") == run);
        QCOMPARE(compareRun(run, recorded()).front().field, std::string("keyframes[2].apart"));
    }

    void runsReplayBitForBit()
    {
        const RunFile read = runFromJson(runToJson(recorded()), "text");
        const RunFile flown = runOf(replay(read));
        QVERIFY(flown == recorded());
        QVERIFY(compareRun(read, flown).empty());
    }

    void clustersWorkWithSearchesSortiesAndFences_data()
    {
        QTest::addColumn<bool>("measured");
        QTest::addColumn<bool>("sorties");
        QTest::newRow("measurements, lost icebergs") << true << false;
        QTest::newRow("endurance, geofence") << false << true;
        QTest::newRow("all of it") << true << true;
    }

    /** With searches, legs home and fences, all icebergs of clusters are visited in time. */
    void clustersWorkWithSearchesSortiesAndFences()
    {
        QFETCH(const bool, measured);
        QFETCH(const bool, sorties);
        Scenario scenario = crowd(6);
        scenario.duration_s = 1500;
        scenario.planningTime_s = 1;
        if (measured) {
            scenario.observer = {.model = ObserverModel::Kalman, .detection = 0.8};
            for (Iceberg& iceberg : scenario.icebergs)
                iceberg.velocitySd_mps = 0.5;
        }
        if (sorties) {
            scenario.uavs[0].spec.endurance_s = 500;
            scenario.uavs[0].turnaround_s = 60;
            scenario.geofence = true;
            scenario.area_m = {Point(-800, -800), Point(3300, -800), Point(3300, 2800),
                               Point(-800, 2800)};
        }
        Mission mission(scenario, {.keyframeInterval_s = 30});
        mission.advance(1500);
        const RunFile run = runFromJson(runToJson(runOf(mission)), "text");
        QVERIFY(compareRun(run, runOf(replay(run))).empty());
        const std::vector<test::FlownPlan> plans = test::flownPlans(mission);
        const auto toCluster = std::ranges::count_if(
            plans, [](const test::FlownPlan& plan) { return !clusterOfTarget(plan).empty(); });
        QVERIFY2(toCluster >= 5, QByteArray::number(static_cast<qlonglong>(toCluster)));
        QVERIFY2(plans.size() < 300, QByteArray::number(static_cast<qlonglong>(plans.size())));
        for (const IcebergIndex i : IcebergRange(14))
            QVERIFY(std::ranges::any_of(mission.events(), [i](const MissionEvent& event) {
                return event.kind == EventKind::Sighted && event.iceberg == i;
            }));
    }

    void differencesAreNamed()
    {
        const std::size_t k = keyframeWithMembers(recorded());
        const std::string path = "keyframes[" + std::to_string(k) + "].members";
        RunFile other = recorded();
        other.keyframes[k].uavs[0].members.push_back(other.keyframes[k].uavs[0].members.front());
        QCOMPARE(compareRun(recorded(), other).front().field, path);
        other = recorded();
        ++other.keyframes[k].uavs[0].members.back();
        QCOMPARE(compareRun(recorded(), other).front().field,
                 path + '[' + std::to_string(other.keyframes[k].uavs[0].members.size() - 1) + ']');
        other = recorded();
        other.keyframes[k].uavs[0].membersBy_s += 1;
        QCOMPARE(compareRun(recorded(), other).front().field, path + "_by_s");
        other = recorded();
        test::changePlan(other.plans[0], [](UavPlan& own) { own.clusters.pop_back(); });
        QCOMPARE(compareRun(recorded(), other).front().field, std::string("plans[0].clusters"));
    }

    void brokenRunsAreRejected_data()
    {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("field");
        QTest::newRow("no list") << R"("clusters": [[)"
                                 << R"("clusters": 3, "was": [[)"
                                 << "plans[0].clusters";
        QTest::newRow("no list of lists") << R"("clusters": [[)"
                                          << R"("clusters": [7, [)"
                                          << "plans[0].clusters[0]";
        QTest::newRow("one alone") << R"("clusters": [[)"
                                   << R"("clusters": [[13], [)"
                                   << "plans[0].clusters[0]";
        QTest::newRow("nobody") << R"("clusters": [[)"
                                << R"("clusters": [[14, )"
                                << "plans[0].clusters[0][0]";
        QTest::newRow("no members") << R"("members": [)"
                                    << R"("members": ["a", )"
                                    << "keyframes[1].members[0]";
        QTest::newRow("a text") << R"("members": [)"
                                << R"("members": "a", "were": [)"
                                << "keyframes[1].members";
    }

    void brokenRunsAreRejected()
    {
        QFETCH(const QString, from);
        QFETCH(const QString, to);
        QFETCH(const QString, field);
        QString text = QString::fromStdString(runToJson(recorded()));
        const auto at = text.indexOf(from);
        QVERIFY(at > 0);
        text.replace(at, from.size(), to);
        const std::optional<Error> error =
            errorOf([&] { (void)runFromJson(text.toStdString(), "text"); });
        QVERIFY(error);
        QVERIFY2(names(error->issues(), field.toStdString()), error->what());
    }

    void icebergInTwoClustersIsRejected()
    {
        RunFile run = recorded();
        test::changePlan(run.plans[0],
                         [](UavPlan& own) { own.clusters.push_back(own.clusters.front()); });
        const std::optional<Error> error =
            errorOf([&] { (void)runFromJson(runToJson(run), "text"); });
        QVERIFY(error && error->issues().front().message() == "must not repeat an iceberg");
    }

    /** Both icebergs drift, and so does their midpoint, the place of the waypoint. */
    void plannedVisitIsTheMiddle()
    {
        const Scenario scenario = twoTogether();
        const std::vector<Visit> visits = plannedVisits(scenario, planOfTwoTogether());
        QCOMPARE(visits.size(), std::size_t{3});
        const Visit& visit = visits[1];
        QCOMPARE(visit.iceberg, std::optional(IcebergIndex(0)));
        QCOMPARE(visit.members, (IcebergList{0, 2}));
        std::vector<Point> then_m;
        for (const IcebergIndex member : visit.members) {
            const Iceberg& iceberg = scenario.icebergs[toIndex(member)];
            then_m.push_back(iceberg.position_m +
                             (iceberg.velocity_mps + scenario.current_mps) * visit.time_s);
        }
        const Circle circle = enclosingCircle(then_m);
        COMPARE_NEAR((visit.position_m - circle.centre_m).norm(), 0, 1e-9);
        COMPARE_NEAR(visit.spread_m, circle.radius_m, 1e-9);
        COMPARE_NEAR((visit.position_m - visits[0].position_m).norm() / 22,
                     visit.time_s - visits[0].time_s, 1e-9);
    }

    void flownVisitIsTheMiddle()
    {
        const Mission mission = replay(recorded());
        int clusters = 0;
        for (const Visit& visit : flownVisits(mission)) {
            const Simulation then = instantAt(mission, visit.time_s).simulation;
            if (visit.members.empty()) {
                QVERIFY(visit.position_m == then.truth_m(visit.iceberg.value()));
                continue;
            }
            std::vector<Point> places_m;
            for (const IcebergIndex member : visit.members) {
                QVERIFY(then.track(member).inView);
                places_m.push_back(then.truth_m(member));
            }
            QVERIFY(visit.position_m == enclosingCircle(places_m).centre_m);
            QVERIFY(std::ranges::find(visit.members, visit.iceberg.value()) != visit.members.end());
            ++clusters;
        }
        QVERIFY(clusters >= 3);
    }

    void clusterHasOneWaypoint()
    {
        const Scenario scenario = twoTogether();
        const Plan plan = planOfTwoTogether();
        const std::vector<Visit> visits = plannedVisits(scenario, plan);
        const MavMission mission = mavMission(planContent(scenario, plan));
        std::vector<MavItem> waypoints;
        std::ranges::copy_if(mission.items, std::back_inserter(waypoints), [](const MavItem& item) {
            return item.command == LinkCommandId::kWaypoint;
        });
        QCOMPARE(waypoints.size(), std::size_t{3});
        // 300 m less the distance of each member, so that both are in view on arrival.
        QCOMPARE(waypoints[1].params[1], std::floor(300 - visits[1].spread_m));
        QVERIFY(waypoints[1].params[1] < 130);
        QCOMPARE(waypoints[0].params[1], 255.0);
        const LatLon place = LocalFrame(scenario.origin).toGeographic(visits[1].position_m);
        COMPARE_NEAR(waypoints[1].place.latitude_deg, place.latitude_deg, 1e-8);
        COMPARE_NEAR(waypoints[1].place.longitude_deg, place.longitude_deg, 1e-8);
    }

    void tableHasARowForEachMember()
    {
        const QString table =
            QString::fromStdString(planCsv(planContent(twoTogether(), planOfTwoTogether())));
        const QStringList rows = table.split('\n', Qt::SkipEmptyParts);
        QCOMPARE(rows.size(), 6); // one name has two lines
        QVERIFY(rows[2].startsWith("2,berg-1,"));
        QVERIFY(rows[3].startsWith("2,berg-3,"));
        QVERIFY(rows[4].startsWith("3,berg-2,"));
    }

    void geojsonNamesTheMembers()
    {
        const QByteArray text = planText(twoTogether(), planOfTwoTogether());
        const QList<QJsonObject> visits = features(text, u"visit"_s);
        QCOMPARE(visits.size(), 3);
        QCOMPARE(visits[1][u"properties"].toObject()[u"cluster"].toArray(),
                 (QJsonArray{u"berg-1"_s, u"berg-3"_s}));
        QVERIFY(!visits[0][u"properties"].toObject().contains(u"cluster"));
    }

    void curvesNameAllMembers()
    {
        const TauCurve curve;
        const Scenario scenario = twoTogether();
        const IcebergList ids{0, 1, 3};
        const std::vector<int> uavs{0};
        const Clusters clusters{{0, 2}};
        const CurveReport report{
            .curve = curve, .scenario = scenario, .ids = ids, .uavs = uavs, .clusters = clusters};
        QCOMPARE(icebergNumbers(report, {3, 1, 2}), (std::vector<int>{4, 1, 3, 2}));
    }

    void planNamesTheMembers()
    {
        const Scenario scenario = twoTogether();
        PlanReport report{.plan = {.uavs = {{.order = {0, 2}}}},
                          .scenario = &scenario,
                          .lengths = std::vector<UavLength>(1)};
        QVERIFY(planJson(report).find("clusters") == std::string::npos);
        report.plan.uavs.front().clusters = {{0, 2}};
        const QJsonObject json = QJsonDocument::fromJson(bytes(planJson(report))).object();
        QCOMPARE(json[u"clusters"].toArray(), (QJsonArray{QJsonArray{u"berg-1"_s, u"berg-3"_s}}));
    }
};

QTEST_APPLESS_MAIN(TestClusterFiles)
#include "tst_cluster_files.moc"
