#include "tests/support/approx.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/panel_test.h"
#include "widgets/flight/planned_sorties.h"
#include "widgets/map/picture/mission_picture.h"

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/**
 * Returns two icebergs in a row in calm air at 20 m/s; the farther one is left for the next sortie.
 */
Scenario twoInARow()
{
    Scenario scenario = test::emptySea(4000);
    scenario.planner.policy = PolicyKind::Nearest;
    scenario.uavs.front().position_m = Point::Zero();
    scenario.uavs.front().spec = {.airspeed_mps = 20, .endurance_s = 1000};
    test::addIceberg(scenario, 3000, 0);
    test::addIceberg(scenario, 12'000, 0);
    return scenario;
}

/** Returns the record of the plan at the start. */
FlightRecord recordFrom(const Scenario& scenario)
{
    Mission mission(scenario);
    mission.advance(0);
    return recordOf(mission);
}

} // namespace

class TestPlannedSorties : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void thePlanIsFlownAhead()
    {
        const FlightRecord record = recordFrom(twoInARow());
        const auto paths = plannedPaths(record.now, record.scenario);
        QCOMPARE(paths.size(), std::size_t{1});
        const PlannedPath& path = paths.front().value();
        QVERIFY(path.places_m.size() >= 2);
        QVERIFY(path.places_m[0] == Point(0, 0));
        QVERIFY((path.places_m[1] - Point(3000, 0)).norm() < 1e-6);
        QCOMPARE(path.thisSortie, std::size_t{2});
        const PlannedSortie sortie = plannedSorties(record.now, record.scenario).front().value();
        COMPARE_NEAR(sortie.outlook.margin_s.value(), 800.0 - 300, 1e-6);
        QVERIFY(sortie.lowMargin_s.value() < *sortie.outlook.margin_s);
    }

    /** Each UAV has a slot of its own; a single UAV needs none. */
    void slotsOfAPad()
    {
        Scenario scenario = twoInARow();
        QVERIFY(!plannedSorties(recordFrom(scenario).now, scenario).front()->slot_s);
        scenario.uavs.push_back(scenario.uavs.front());
        scenario.uavs.back().id = "second";
        const FlightRecord record = recordFrom(scenario);
        const auto sorties = plannedSorties(record.now, record.scenario);
        COMPARE_NEAR(sorties[0].value().slot_s.value(), 770.0, 1e-6);
        COMPARE_NEAR(sorties[1].value().slot_s.value(), 740.0, 1e-6);
        QCOMPARE(sorties[1]->uav, std::string("second"));
    }

    void noNoticeOnTheReturn()
    {
        FlightRecord record = recordFrom(twoInARow());
        record.now.world.uavs[0].mode = FlightMode::Home;
        QVERIFY(!plannedPaths(record.now, record.scenario).front());
        QVERIFY(!plannedSorties(record.now, record.scenario).front());
    }

    /** Each of two icebergs is near enough, but not both together. */
    void thePointOfNoReturnIsOnTheMap()
    {
        Scenario scenario = twoInARow();
        scenario.icebergs[1].position_m = {0, 7000};
        const FlightRecord record = recordFrom(scenario);
        const std::vector<Point> path_m =
            missionPicture(record, QLocale::c()).routes[0].toNoReturn_m;
        QCOMPARE(path_m.size(), std::size_t{2});
        QVERIFY((path_m[0] - scenario.icebergs[0].position_m).norm() < 1);
        // At that point, at 20 m/s, the usable endurance is that of the straight path home.
        const double flown_m = path_m[0].norm() + (path_m[1] - path_m[0]).norm();
        COMPARE_NEAR((flown_m + path_m[1].norm()) / 20, 800.0, 0.05);
        scenario.uavs[0].spec.endurance_s = 0;
        QVERIFY(missionPicture(recordFrom(scenario), QLocale::c()).routes[0].toNoReturn_m.empty());
    }
};

QTEST_MAIN(TestPlannedSorties)
#include "tst_planned_sorties.moc"
