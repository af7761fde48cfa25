#include "core/base/angles.h"
#include "core/io/export/content/export_content.h"
#include "core/io/export/content/export_flight.h"
#include "core/io/export/missions/plan_csv.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/flight_tables.h"
#include "tests/support/flight/mission_builder.h"

#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

ExportUav only(const ExportContent& content)
{
    return content.uavs.at(0);
}

ExportUav planned(const ExportOptions& options, const Scenario& scenario = fourIcebergs())
{
    return only(planContent(scenario, fourIcebergPlan(), options));
}

std::vector<int> numbersOf(const IcebergList& order)
{
    std::vector<int> numbers;
    for (const IcebergIndex iceberg : order)
        numbers.push_back(iceberg.number());
    return numbers;
}

/** Returns the icebergs in the order of their visits, -1 for home. */
std::vector<int> visited(const ExportUav& uav)
{
    std::vector<int> icebergs;
    for (const Visit& visit : uav.visits)
        icebergs.push_back(visit.iceberg ? visit.iceberg->number() : -1);
    return icebergs;
}

Scenario twoUavs()
{
    return changed([](Scenario& s) {
        s.uavs.push_back(s.uavs[0]);
        s.uavs[1].id = "uav-2";
        s.uavs[1].position_m = Point(100, 200);
    });
}

} // namespace

class TestExportContent : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void orderIsTheDefaultUntilSomethingIsFlown()
    {
        const ExportContent plan = planContent(fourIcebergs());
        QCOMPARE(plan.what, ExportScope::Order);
        QCOMPARE(plan.now_s, 0.0);
        QVERIFY(visited(only(plan)) == numbersOf(fourIcebergPlan().uavs[0].order));
        QVERIFY(only(plan).track.empty());
        const Mission mission = flown(fourIcebergs(), 100);
        const ExportContent run = runContent(mission);
        QCOMPARE(run.what, ExportScope::Track);
        QCOMPARE(run.now_s, 100.0);
        QCOMPARE(only(run).track.size(), mission.recorder().samples().size());
        QCOMPARE(only(run).visits.size(), flownVisits(mission).size());
    }

    void firstLegIsOneVisit()
    {
        QCOMPARE(visited(planned({.what = ExportScope::FirstLeg})), std::vector<int>{0});
        const std::vector<int> home =
            visited(planned({.what = ExportScope::FirstLeg, .returnHome = true}));
        QCOMPARE(home, (std::vector<int>{0, -1}));
    }

    void homeIsTheLastVisitIfChosen()
    {
        Scenario scenario = fourIcebergs();
        QVERIFY(planned({}).visits.back().iceberg);
        const ExportUav away = planned({.returnHome = true}, scenario);
        QVERIFY(!away.visits.back().iceberg);
        const Visit& last = away.visits[away.visits.size() - 2];
        const double leg_m = (last.position_m - away.home_m).norm();
        COMPARE_NEAR(away.visits.back().time_s - last.time_s, leg_m / 22, 1e-9);
        scenario.uavs[0].spec.endurance_s = 1e5;
        scenario.uavs[0].home_m = Point(10, 20);
        QVERIFY(!planned({}, scenario).visits.back().iceberg);
        QCOMPARE(planned({.returnHome = true}, scenario).visits.size(), std::size_t{5});
        QVERIFY(planned({.returnHome = false}, scenario).visits.back().iceberg);
        QVERIFY(planned({.returnHome = true}, scenario).visits.back().position_m == Point(10, 20));
    }

    /** The path has the turns that straight legs lack, none of them sharper than the aircraft's. */
    void pathIsFlyable()
    {
        const Scenario scenario = changed([](Scenario& s) { s.wind_mps = Point(3, -5); });
        const ExportUav uav = planned({.what = ExportScope::Path}, scenario);
        QVERIFY(visited(uav) == numbersOf(fourIcebergPlan().uavs[0].order));
        const double limit_radps = maxTurnRate_radps(scenario.uavs[0].spec);
        double turned_radps = 0;
        const std::vector<TrackPoint> track = uav.track.all();
        for (std::size_t i = 1; i < track.size(); ++i) {
            const TrackPoint& from = track[i - 1];
            const TrackPoint& to = track[i];
            const double dt_s = to.time_s - from.time_s;
            QVERIFY(dt_s > 0);
            const double rate_radps =
                std::remainder(to.state.psi_rad - from.state.psi_rad, 2 * M_PI) / dt_s;
            turned_radps = std::max(turned_radps, std::abs(rate_radps));
            const Point air_m =
                to.state.position_m - from.state.position_m - scenario.wind_mps * dt_s;
            QVERIFY(air_m.norm() < 22 * dt_s + 1e-6);
        }
        QVERIFY(turned_radps < limit_radps + 1e-9);
        QVERIFY(turned_radps > limit_radps / 2);
        QVERIFY(uav.track.front().state.position_m == scenario.uavs[0].position_m);
    }

    /**
     * A path with aim points passes icebergs at a distance, so the probability over them does not
     * apply.
     */
    void chanceIsGivenWhereTheUavFliesOverAnIceberg()
    {
        const Scenario scenario =
            changed([](Scenario& s) { s.planner.policy = PolicyKind::Coverage; });
        const Plan plan = planFromStart(scenario);
        for (const ExportScope what : {ExportScope::Order, ExportScope::Path}) {
            const ExportContent content = planContent(scenario, plan, {.what = what});
            const ExportUav uav = only(content);
            const auto chance =
                chanceInView(content, uav, uav.visits.front(), *uav.visits.front().iceberg);
            QCOMPARE(chance.has_value(), what == ExportScope::Order);
            const std::string csv = planCsv(content);
            QCOMPARE(csv.ends_with(",\n"), what == ExportScope::Path);
        }
    }

    /** For a lost iceberg it is the probability that a planned search place shows it. */
    void chanceOfSearchesIsGiven()
    {
        Scenario scenario = randomScenario(1, {.icebergs = 6});
        scenario.planner.policy = PolicyKind::Coverage;
        scenario.observer.model = ObserverModel::Kalman;
        for (Iceberg& iceberg : scenario.icebergs)
            iceberg.velocitySd_mps = 0.8;
        Mission mission(scenario, {.workLimit = 20'000});
        const auto searches = [&] {
            const PlanPointer plan = lastPlanOf(mission.plans(), 0);
            return plan && plan->uavs[0].outlook ? plan->uavs[0].outlook->searches
                                                 : std::vector<PlannedSearch>{};
        };
        for (int time_s = 20; searches().empty() && time_s < 1000; time_s += 20)
            mission.advance(time_s);
        QVERIFY(!searches().empty());
        const Plan none;
        const ExportContent content = exportContent(
            {.scenario = scenario, .plan = none, .mission = &mission}, {.what = ExportScope::Path});
        const ExportUav uav = only(content);
        const std::vector<PlannedSearch> planned = searches();
        const PlannedSearch first = planned.front();
        double chance = 0;
        for (const PlannedSearch& search : planned)
            chance += search.iceberg == first.iceberg ? search.chance : 0;
        const auto visit = std::ranges::find(uav.visits, first.iceberg, &Visit::iceberg);
        QVERIFY(visit != uav.visits.end());
        QCOMPARE(visit->time_s, first.time_s);
        QVERIFY(visit->position_m == first.place_m);
        QVERIFY(std::ranges::is_sorted(uav.visits, {}, &Visit::time_s));
        COMPARE_NEAR(chanceInView(content, uav, *visit, first.iceberg).value(), chance, 1e-12);
        for (const IcebergIndex other : IcebergRange(6))
            if (std::ranges::find(planned, other, &PlannedSearch::iceberg) == planned.end())
                QVERIFY(!chanceInView(content, uav, *visit, other));
    }

    /** The next leg begins when the iceberg is in view, 300 m before the middle. */
    void pathReachesEachIceberg()
    {
        const ExportUav uav = planned({.what = ExportScope::Path, .returnHome = true});
        QCOMPARE(visited(uav), (std::vector<int>{0, 3, 1, 2, -1}));
        const std::vector<TrackPoint> track = uav.track.all();
        for (const Visit& visit : uav.visits) {
            const auto at =
                std::ranges::lower_bound(track, visit.time_s - 1e-6, {}, &TrackPoint::time_s);
            QVERIFY(at != track.end());
            const double distance_m = (at->state.position_m - visit.position_m).norm();
            QVERIFY2(distance_m < 300 * std::sqrt(2.0) + 22,
                     qPrintable(QString::number(distance_m)));
        }
        QVERIFY(uav.track.back().state.position_m == uav.home_m);
    }

    void pathWithEnduranceEndsAtHome()
    {
        const Scenario scenario = changed([](Scenario& s) { s.uavs[0].spec.endurance_s = 250; });
        const ExportUav uav = planned({.what = ExportScope::Path}, scenario);
        QVERIFY(uav.visits.size() < 5);
        QVERIFY(!uav.visits.back().iceberg);
        QVERIFY(uav.visits.back().time_s <= 250);
        QVERIFY((uav.track.back().state.position_m - uav.home_m).norm() < 50);
    }

    /** In flight the order starts here and now, with the icebergs at their estimates. */
    void orderOfAMissionStartsHereAndNow()
    {
        const Mission mission = flown(fourIcebergs(), 100);
        const ExportContent content = runContent(mission, {.what = ExportScope::Order});
        const ExportUav uav = only(content);
        QVERIFY(visited(uav) == numbersOf(mission.plans().back()->uavs[0].order));
        QVERIFY(uav.uav.position_m == mission.simulation().uav(0).pose.position_m);
        QCOMPARE(uav.start_s, 100.0);
        QVERIFY(uav.visits.front().time_s > 100);
        QVERIFY(uav.home_m == mission.scenario().uavs[0].position_m);
        for (std::size_t i = 0; i < content.icebergs.size(); ++i)
            QVERIFY(content.icebergs[i].position_m ==
                    mission.simulation().observer().estimate_m(IcebergIndex::of(i)));
        const ExportUav path = only(runContent(mission, {.what = ExportScope::Path}));
        QCOMPARE(path.track.front().time_s, 100.0);
        QVERIFY(path.track.front().state.position_m == uav.uav.position_m);
        QVERIFY(visited(path) == numbersOf(mission.plans().back()->uavs[0].order));
    }

    void optionsOverrideTheScenario()
    {
        const ExportUav uav = planned({.altitude_m = 80, .airspeed_mps = 11, .acceptance_m = 42.5});
        QCOMPARE(uav.uav.spec.altitude_m, 80.0);
        QCOMPARE(uav.reach_m, 42.5);
        QVERIFY(uav.reachChosen);
        // Half the speed gives later visits and a quarter of the circle.
        QVERIFY(uav.visits.front().time_s > 1.9 * planned({}).visits.front().time_s);
        COMPARE_NEAR(uav.circle_m * 4, planned({}).circle_m, 1e-9);
    }

    void oneOfSeveralUavsCanBeChosen()
    {
        const ExportContent all = planContent(twoUavs());
        QCOMPARE(all.uavs.size(), std::size_t{2});
        QCOMPARE(all.uavs[1].row, std::size_t{1});
        QVERIFY(all.uavs[1].home_m == Point(100, 200));
        const ExportContent one = planContent(twoUavs(), fourIcebergPlan(), {.uav = "uav-2"});
        QCOMPARE(one.uavs.size(), std::size_t{1});
        QCOMPARE(only(one).uav.id, std::string("uav-2"));
    }

    /** Each UAV flies its own part of the plan, and is exported with its own track. */
    void everyUavOfAFleetHasItsOwnPath()
    {
        Scenario scenario = twoUavs();
        scenario.planner.policy = PolicyKind::Visitation;
        const Plan plan = planFromStart(scenario);
        QCOMPARE(plan.uavs.size(), std::size_t{2});
        const ExportContent order = planContent(scenario, plan);
        const ExportContent path = planContent(scenario, plan, {.what = ExportScope::Path});
        for (std::size_t row = 0; row < 2; ++row) {
            QVERIFY(visited(order.uavs[row]) == numbersOf(plan.uavs[row].order));
            QVERIFY(visited(path.uavs[row]) == numbersOf(plan.uavs[row].order));
            QVERIFY(path.uavs[row].track.front().state.position_m == scenario.uavs[row].position_m);
        }
        const Mission mission = flown(scenario);
        const ExportContent run = runContent(mission);
        std::size_t visits = 0;
        for (const ExportUav& uav : run.uavs) {
            QVERIFY(uav.track.back().state.position_m ==
                    mission.simulation().uav(static_cast<int>(uav.row)).pose.position_m);
            visits += uav.visits.size();
        }
        QCOMPARE(visits, static_cast<std::size_t>(mission.metrics().visits));
        QVERIFY(findExportFormat("csv")->text(run) == trajectoryCsv(mission));
        const ExportContent now = runContent(mission, {.what = ExportScope::Order});
        for (const ExportUav& uav : now.uavs)
            QVERIFY(visited(uav) ==
                    numbersOf(presentPlan({.scenario = scenario, .plan = plan, .mission = &mission},
                                          uav.row)
                                  .order));
    }

    void directionsAreTrueOverTheEarth_data()
    {
        QTest::addColumn<double>("latitude_deg");
        QTest::addColumn<double>("longitude_deg");
        QTest::newRow("Grand Banks") << 47.0 << -48.0;
        QTest::newRow("across 180, south") << -70.0 << 179.99;
        QTest::newRow("near the North Pole") << 89.0 << 10.0;
        QTest::newRow("North Pole") << 90.0 << 0.0;
        QTest::newRow("South Pole") << -90.0 << 0.0;
    }

    /** A motion in the plane is converted to true east and north by the parallels and meridians. */
    void directionsAreTrueOverTheEarth()
    {
        QFETCH(double, latitude_deg);
        QFETCH(double, longitude_deg);
        const Scenario scenario = changed([&](Scenario& s) {
            s.origin = {.latitude_deg = latitude_deg, .longitude_deg = longitude_deg};
        });
        const ExportContent content = planContent(scenario);
        const Point at_m(30000, -20000);
        const LatLon from = content.frame.toGeographic(at_m);
        const double latitude_rad = radFromDeg(from.latitude_deg);
        const double e2 = 0.00669437999014;
        const double w = std::sqrt(1 - e2 * std::pow(std::sin(latitude_rad), 2));
        const double parallel_m = 6378137 / w * std::cos(latitude_rad);
        const double meridian_m = 6378137 * (1 - e2) / std::pow(w, 3);
        for (const double heading_deg : {0.0, 45.0, 130.0, 270.0, -1.0}) {
            const double heading_rad = radFromDeg(heading_deg);
            const Point step_m = 10 * Point(std::sin(heading_rad), std::cos(heading_rad));
            const LatLon to = content.frame.toGeographic(at_m + step_m);
            const double east_m =
                parallel_m *
                radFromDeg(std::remainder(to.longitude_deg - from.longitude_deg, 360.0));
            const double north_m = meridian_m * radFromDeg(to.latitude_deg - from.latitude_deg);
            const Point moved_m = eastNorth_mps(content, step_m, at_m);
            // 10 m at 36 km and more from a pole; the plane is stretched by 1e-5 there.
            COMPARE_NEAR((moved_m - Point(east_m, north_m)).norm(), 0, 0.02);
            COMPARE_NEAR(moved_m.norm(), 10, 1e-7);
            const double true_deg = trueHeading_deg(content, heading_deg, at_m);
            QVERIFY(true_deg >= 0 && true_deg < 360);
            const double flown_deg = degFromRad(std::atan2(moved_m.x(), moved_m.y()));
            COMPARE_NEAR(std::remainder(true_deg - flown_deg, 360.0), 0, 2e-6);
        }
    }

    void trueHeadingsAreBelow360()
    {
        const ExportContent content = planContent(fourIcebergs());
        const Point origin_m = Point::Zero();
        QCOMPARE(trueHeading_deg(content, 359.9999999, origin_m), 0.0);
        QCOMPARE(trueHeading_deg(content, 765, origin_m), 45.0);
        QCOMPARE(trueHeading_deg(content, -90, origin_m), 270.0);
    }

    void impossibleOptionsAreRejected_data()
    {
        QTest::addColumn<QString>("option");
        QTest::addColumn<int>("row");
        int row = 0;
        for (const char* option :
             {"what", "uav", "altitude", "speed", "speed", "acceptance", "loiter", "loiter"})
            QTest::addRow("%s %d", option, row) << QString::fromLatin1(option) << row, ++row;
    }

    void impossibleOptionsAreRejected()
    {
        QFETCH(QString, option);
        QFETCH(int, row);
        const Scenario windy = changed([](Scenario& s) { s.wind_mps = Point(10, 0); });
        const std::vector<ExportOptions> options{{.what = ExportScope::Track},
                                                 {.uav = "uav-9"},
                                                 {.altitude_m = 0},
                                                 {.airspeed_mps = std::nan("")},
                                                 {.airspeed_mps = 10},
                                                 {.acceptance_m = -1},
                                                 {.loiterTurns = -1},
                                                 {.loiterTurns = 256}};
        const std::optional<Error> error = errorOf([&] {
            (void)planContent(windy, fourIcebergPlan(), options[static_cast<std::size_t>(row)]);
        });
        QVERIFY(error.has_value());
        QCOMPARE(error->code(), ErrorCode::InvalidInput);
        QCOMPARE(QString::fromStdString(error->subject()), option);
    }

    void contentThatNoFileCanHoldIsRejected_data()
    {
        QTest::addColumn<int>("row");
        QTest::newRow("not finite") << 0;
        QTest::newRow("off the plane") << 1;
        QTest::newRow("later than any date") << 2;
    }
    void contentThatNoFileCanHoldIsRejected()
    {
        QFETCH(const int, row);
        const std::vector<Scenario> scenarios{
            changed([](Scenario& s) { s.uavs[0].spec.airspeed_mps = 1e-300; }),
            changed([](Scenario& s) { // can be flown, but it takes years to catch up
                s.uavs[0].spec.airspeed_mps = 1;
                s.wind_mps = s.current_mps = Point::Zero();
                s.icebergs[0].position_m = Point(9e5, 0);
                s.icebergs[0].velocity_mps = Point(0.99, 0);
            }),
            changed([](Scenario& s) { s.uavs[0].spec.airspeed_mps = 1e-6; })};
        const Scenario& scenario = scenarios[static_cast<std::size_t>(row)];
        const std::optional<Error> error =
            errorOf([&] { (void)planContent(scenario, fourIcebergPlan(), {}); });
        QVERIFY(error.has_value());
        QCOMPARE(error->code(), ErrorCode::Unsupported);
        QVERIFY(std::string(error->what()).find("cannot be exported") != std::string::npos);
    }

    /** Limited endurance makes home the end of a path, unless the user deselects it. */
    void pathWithoutLegHomeEndsOverTheLastIceberg()
    {
        const Scenario scenario = changed([](Scenario& s) { s.uavs[0].spec.endurance_s = 400; });
        const ExportUav home = planned({.what = ExportScope::Path}, scenario);
        QVERIFY(!home.visits.back().iceberg);
        const ExportUav stays = planned({.what = ExportScope::Path, .returnHome = false}, scenario);
        QCOMPARE(stays.visits.size() + 1, home.visits.size());
        QVERIFY(!stays.visits.empty());
        QVERIFY(stays.track.back().time_s <= stays.visits.back().time_s);
        QVERIFY(stays.track.back().time_s > stays.visits.back().time_s - 1.1);
    }
};

QTEST_APPLESS_MAIN(TestExportContent)
#include "tst_export_content.moc"
