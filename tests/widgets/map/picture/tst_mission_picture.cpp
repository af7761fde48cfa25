#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "widgets/charts/mission_charts.h"
#include "widgets/map/picture/mission_picture.h"

#include <QtTest>

#include <algorithm>
#include <set>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

const QLocale kLocale(QLocale::English);

/** Five icebergs, the last appearing at 100 s, flown for `time_s`. */
Mission fiveIcebergs(double time_s)
{
    FieldSpec field;
    field.icebergs = 5;
    Scenario scenario = randomScenario(7, field);
    scenario.duration_s = 300;
    scenario.name = "Test field";
    scenario.planner.policy = PolicyKind::Nearest;
    scenario.icebergs.back().appears_s = 100;
    scenario.icebergs.front().name = "Big one";
    scenario.current_mps = {0.2, 0};
    Mission mission(scenario);
    mission.advance(time_s);
    return mission;
}

/** Nine icebergs and three UAVs, flown for `time_s`. */
Mission fleetFlown(double time_s)
{
    Scenario scenario = randomScenario(7, {.icebergs = 9});
    scenario.duration_s = 300;
    for (const char* name : {"two", "three"}) {
        Uav uav = scenario.uavs.front();
        uav.id = uav.name = name;
        uav.position_m += 3000.0 * static_cast<double>(scenario.uavs.size()) * Point(1, 0.3);
        uav.spec.altitude_m += 50.0 * static_cast<double>(scenario.uavs.size());
        scenario.uavs.push_back(uav);
    }
    Mission mission(scenario);
    mission.advance(time_s);
    return mission;
}

/** Returns the places of icebergs in a picture that shows all of them. */
MapPlaces sameNumbers(const IcebergList& icebergs)
{
    MapPlaces places;
    for (const IcebergIndex iceberg : icebergs)
        places.push_back(MapPlace::of(iceberg.number()));
    return places;
}

} // namespace

class TestMissionPicture : public QObject
{
    Q_OBJECT

private slots:
    void pictureShowsThePresent()
    {
        const Mission mission = fiveIcebergs(300);
        const MapPicture picture = missionPicture(recordOf(mission), kLocale);
        QCOMPARE(picture.title, u"Test field"_s);
        QCOMPARE(picture.icebergs.size(), std::size_t{5});
        QCOMPARE(picture.icebergs[0].id, u"Big one"_s);
        QCOMPARE(picture.icebergs[1].id, QString::fromStdString(mission.scenario().icebergs[1].id));
        for (const IcebergIndex index : mission.simulation().icebergs()) {
            const std::size_t i = toIndex(index);
            const MapIceberg& shown = picture.icebergs[i];
            QVERIFY(shown.position_m == mission.simulation().observer().estimate_m(index));
            COMPARE_NEAR(shown.sigma_m2, mission.simulation().track(index).sigma_m2, 0);
            QVERIFY(shown.sigma_m2 <= picture.sigmaFull_m2);
            // The arrow shows motion over ground: own velocity and current.
            const Point expected_mps = mission.scenario().icebergs[i].velocity_mps + Point(0.2, 0);
            QVERIFY(shown.velocity_mps == expected_mps);
        }
        QVERIFY(picture.uavs[0].position_m == mission.simulation().state().uavs[0].pose.position_m);
        QCOMPARE(picture.readouts[0].value, u"05:00"_s);
        QCOMPARE(picture.readouts[2].value, QString::number(mission.metrics().visits));
    }

    void wholeTrackIsShown()
    {
        const Mission mission = fiveIcebergs(300);
        const MapPicture picture = missionPicture(recordOf(mission), kLocale);
        QCOMPARE(picture.routes[0].track.size(), mission.recorder().samples().size());
        COMPARE_NEAR(picture.routes[0].track.front().time_s, 0, 0);
        COMPARE_NEAR(picture.routes[0].track.back().time_s, 300, 1e-9);
    }

    void planIsTheOneInForce()
    {
        const Mission mission = fiveIcebergs(300);
        const MapPicture picture = missionPicture(recordOf(mission), kLocale);
        QCOMPARE(picture.routes[0].plan, sameNumbers(mission.plans().back()->uavs[0].order));
        const std::set<MapPlace> once(picture.routes[0].plan.begin(), picture.routes[0].plan.end());
        QCOMPARE(once.size(), picture.routes[0].plan.size());
    }

    void icebergsToComeAreNotShown()
    {
        const Mission mission = fiveIcebergs(50);
        const MapPicture picture = missionPicture(recordOf(mission), kLocale);
        QCOMPARE(picture.icebergs.size(), std::size_t{4});
        for (const MapPlace place : picture.routes[0].plan)
            QVERIFY(place < 4);
    }

    /** Before take-off an edit is on the map at once, with the plan made before it. */
    void editIsShownWithTheLastPlan()
    {
        FlightRecord record = recordOf(fiveIcebergs(0));
        SweptPaths swept;
        const MapPlaces plan = mapPicture(record, kLocale, swept).routes[0].plan;
        QCOMPARE(plan.size(), std::size_t{4});
        record.scenario.icebergs[2].position_m = {2500, 2000};
        record.scenario.name = "Edited";
        const MapPicture picture = mapPicture(record, kLocale, swept);
        QCOMPARE(picture.title, u"Edited"_s);
        QCOMPARE(picture.icebergs.size(), std::size_t{5}); // with the one to come
        QVERIFY(picture.icebergs[2].position_m == Point(2500, 2000));
        QCOMPARE(picture.routes[0].plan, plan);
    }

    void flightIsShownAsItIs()
    {
        FlightRecord record = recordOf(fiveIcebergs(50));
        record.now.phase = RunPhase::Paused;
        QVERIFY(record.inFlight());
        record.scenario.icebergs[2].position_m = {2500, 2000};
        SweptPaths swept;
        const MapPicture picture = mapPicture(record, kLocale, swept);
        QCOMPARE(picture.icebergs.size(), std::size_t{4});
        QVERIFY(picture.icebergs[2].position_m == record.estimate_m(2));
    }

    void eachUavHasItsRoute()
    {
        const Mission mission = fleetFlown(120);
        const FlightRecord record = recordOf(mission);
        const MapPicture picture = missionPicture(record, kLocale);
        QCOMPARE(picture.uavs.size(), std::size_t{3});
        QCOMPARE(picture.routes.size(), std::size_t{3});
        std::set<MapPlace> planned;
        std::size_t count = 0;
        for (std::size_t uav = 0; uav < 3; ++uav) {
            const MapRoute& route = picture.routes[uav];
            const DubinsState pose = mission.simulation().state().uavs[uav].pose;
            QVERIFY(picture.uavs[uav].position_m == pose.position_m);
            QCOMPARE(route.plan, sameNumbers(planOf(record.now, static_cast<int>(uav))->order));
            QVERIFY(route.track.front().position_m == mission.scenario().uavs[uav].position_m);
            QVERIFY(route.track.back().position_m == pose.position_m);
            QCOMPARE(route.swept->size(), mission.recorder().samples().size());
            QCOMPARE(route.swept->back().psi_rad, pose.psi_rad);
            planned.insert(route.plan.begin(), route.plan.end());
            count += route.plan.size();
        }
        QVERIFY(count > 0);
        QCOMPARE(planned.size(), count); // no iceberg in two plans
        QCOMPARE(picture.uavs[1].label, u"two"_s);
    }

    /** Other UAVs now visit the icebergs of its plan. */
    void whoHoldsOrGoesHomeHasNoPlan()
    {
        FlightRecord record = recordOf(fleetFlown(0));
        QVERIFY(!missionPicture(record, kLocale).routes[1].plan.empty());
        for (const FlightMode mode : {FlightMode::Hold, FlightMode::Home, FlightMode::Ground}) {
            record.now.world.uavs[1].mode = mode;
            QVERIFY(missionPicture(record, kLocale).routes[1].plan.empty());
            QVERIFY(!missionPicture(record, kLocale).routes[0].plan.empty());
            // The home leg is drawn if the UAV is flying home.
            QCOMPARE(missionPicture(record, kLocale).routes[1].thisSortie,
                     mode == FlightMode::Home ? std::optional(0) : std::nullopt);
        }
    }

    void onTheGroundNothingIsTooClose()
    {
        FlightRecord record = recordOf(fleetFlown(0));
        QVERIFY(missionPicture(record, kLocale).uavs[1].isAloft);
        record.now.world.uavs[1].mode = FlightMode::Ground;
        QVERIFY(!missionPicture(record, kLocale).uavs[1].isAloft);
        QVERIFY(missionPicture(record, kLocale).uavs[2].isAloft);
    }

    /** The one that has to land first, with its name. */
    void leastEnduranceIsShown()
    {
        FlightRecord record = recordOf(fleetFlown(0));
        QCOMPARE(missionPicture(record, kLocale).readouts.size(), std::size_t{3});
        record.scenario.uavs[0].spec.endurance_s = 900;
        record.scenario.uavs[1].spec.endurance_s = 2250; // the third flies on for ever
        record.now.world.uavs[0].aloft_s = 300;
        record.now.world.uavs[1].aloft_s = 1500;
        record.now.world.uavs[2].aloft_s = 5000;
        const std::vector<MapReadout> readouts = missionPicture(record, kLocale).readouts;
        QCOMPARE(readouts.back().value, u"–"_s); // the margin has no value yet, but its column
        const MapReadout& left = readouts[readouts.size() - 2];
        QCOMPARE(left.caption, u"Until the reserve"_s);
        QCOMPARE(left.value, u"05:00"_s); // 20 % of the 2250 s are the reserve
        QCOMPARE(left.unit, u"two"_s);
        record.now.homeMargins_s = {std::nullopt, 95, 0}; // ordered home, it has no limit either
        const MapReadout margin = missionPicture(record, kLocale).readouts.back();
        QCOMPARE(margin.caption, u"Above the reserve"_s);
        QCOMPARE(margin.value, u"01:35"_s);
        QCOMPARE(margin.unit, u"if home now"_s);
    }

    void nearMissesAreShown()
    {
        FlightRecord record = recordOf(fleetFlown(0));
        record.scenario.separation_m = 150;
        record.now.world.closest_m = 301;
        QCOMPARE(missionPicture(record, kLocale).readouts.size(), std::size_t{3});
        record.now.world.closest_m = 142.6;
        const MapReadout closest = missionPicture(record, kLocale).readouts.back();
        QCOMPARE(closest.caption, u"Closest so far"_s);
        QCOMPARE(closest.value, u"143"_s);
        QCOMPARE(closest.unit, u"m"_s);
        record.scenario.separation_m = 0; // not watched
        QCOMPARE(missionPicture(record, kLocale).readouts.size(), std::size_t{3});
    }

    void assignedUavsAreInThePicture()
    {
        FlightRecord record = recordOf(fleetFlown(0));
        record.now.assigned[1] = 2;
        const MapPicture picture = missionPicture(record, kLocale);
        QVERIFY(!picture.icebergs[0].assignedUav);
        QCOMPARE(picture.icebergs[1].assignedUav, std::optional(2));
    }

    void zetaChartEndsAtTheMetrics()
    {
        const Mission mission = fiveIcebergs(300);
        const TimeChartContent content = missionChart(ChartKind::Zeta, recordOf(mission), kLocale);
        QCOMPARE(content.lines.size(), std::size_t{2});
        const TimeLine& zeta = content.lines[0];
        QVERIFY(zeta.onRightAxis);
        COMPARE_NEAR(zeta.points.back().y(), mission.metrics().zeta_m2s, 1e-9);
        COMPARE_NEAR(zeta.points.back().x(), 300, 1e-9);
        QCOMPARE(static_cast<int>(content.marks_s.size()), mission.metrics().visits);
        COMPARE_NEAR(content.duration_s, 300, 1e-9);
    }

    /** With an asset, beside the sum that makes zeta; the bound stays the last line. */
    void weightedSumIsShownWithAnAsset()
    {
        FlightRecord record = recordOf(fiveIcebergs(300));
        ZetaBound bound{.zeta_m2s = 1, .curve = {{.time_s = 0}, {.time_s = 300, .zeta_m2s = 1}}};
        record.bound = {.zeta_m2s = 1, .share = 1, .whole = std::make_shared<ZetaBound>(bound)};
        QCOMPARE(missionChart(ChartKind::Zeta, record, kLocale).lines.size(), std::size_t{3});
        record.now.asset.emplace();
        for (Sample& sample : record.history.samples)
            sample.weightedSum_m2 = 3 * sample.sigmaSum_m2;
        const TimeChartContent content = missionChart(ChartKind::Zeta, record, kLocale);
        QCOMPARE(content.lines.size(), std::size_t{4});
        QCOMPARE(content.lines[2].key, u"weighted_sum_m2"_s);
        QCOMPARE(content.lines[3].key, u"zeta_bound_m2s"_s);
        const Sample& last = record.history.samples.back();
        COMPARE_NEAR(content.lines[1].points.back().y(), last.sigmaSum_m2, 1e-12);
        COMPARE_NEAR(content.lines[2].points.back().y(), 3 * last.sigmaSum_m2, 1e-12);
        QVERIFY(content.summary.contains(u"Weighted by priority"_s));
    }

    void sigmaChartHasALineForEachIceberg()
    {
        const Mission mission = fiveIcebergs(300);
        const TimeChartContent content = missionChart(ChartKind::Sigma, recordOf(mission), kLocale);
        QCOMPARE(content.lines.size(), std::size_t{5});
        QCOMPARE(content.lines[0].label, u"Big one"_s);
        for (std::size_t i = 0; i < content.lines.size(); ++i) {
            QVERIFY(!content.lines[i].points.empty());
            COMPARE_NEAR(content.lines[i].points.back().y(),
                         mission.simulation().track(IcebergIndex::of(i)).sigma_m2, 1e-12);
        }
    }

    /** The pictures of a flight share one list that grows; one looked back at has its own. */
    void sweptListGrowsWithTheFlight()
    {
        Mission mission = fleetFlown(60);
        SweptPaths paths;
        const SweptPointer first =
            missionPicture(recordOf(mission), kLocale, paths).routes[1].swept;
        const std::size_t before = first->size();
        mission.advance(120);
        FlightRecord record = recordOf(mission);
        const SweptPointer later = missionPicture(record, kLocale, paths).routes[1].swept;
        QVERIFY(later == first);
        QVERIFY(later->size() > before);
        QVERIFY(*later == *missionPicture(record, kLocale).routes[1].swept);
        record.instant = snapshotAt(mission, 30);
        const SweptPointer back = missionPicture(record, kLocale, paths).routes[1].swept;
        QVERIFY(back != later && back->size() < before);
        COMPARE_NEAR(back->back().time_s, 30, 1e-9);
        record.instant.reset();
        ++record.history.rewrites;
        QVERIFY(missionPicture(record, kLocale, paths).routes[1].swept != later);
    }
};

QTEST_MAIN(TestMissionPicture)
#include "tst_mission_picture.moc"
