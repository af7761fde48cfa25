#include "core/coverage/aimed_path.h"
#include "core/coverage/plan_conversion.h"
#include "core/mission/mission.h"
#include "core/mission/plan_requests.h"
#include "core/presets/presets.h"
#include "tests/support/flight/flown_plans.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace berg;
using test::addIceberg;
using test::emptySea;

namespace {

const Motion kCalm{.airspeed_mps = 20, .limit_radps = 0.2}; // The turn radius is 100 m.

/** Returns the position on the paths at that time. */
Point placeAt(const std::vector<AimedPath>& paths, double time_s)
{
    Point at_m = paths.front().points.front().position_m;
    for (const AimedPath& path : paths)
        for (std::size_t i = 1; i < path.points.size(); ++i) {
            const PathPoint& from = path.points[i - 1];
            const PathPoint& to = path.points[i];
            if (time_s >= to.time_s || to.time_s <= from.time_s)
                at_m = to.position_m;
            else if (time_s > from.time_s)
                return from.position_m + (time_s - from.time_s) / (to.time_s - from.time_s) *
                                             (to.position_m - from.position_m);
        }
    return at_m;
}

/** Returns random legs for the present state of a simulation, in the form of a planner's answer. */
DescribedPlan randomPlan(const PlanRequest& request, int legs, Random random)
{
    const CoverageModel model(*request.uavs[0].prediction, {.length_s = 900});
    CoveragePlan plan;
    CoverageState state = model.start();
    while (static_cast<int>(plan.size()) < legs) {
        const CoverageLeg leg{.iceberg = ModelPlace::of(random.below(request.ids.size())),
                              .offset_m = random.uniform(-1, 1) * model.largestOffset_m()};
        if (model.fly(state, leg))
            plan.push_back(leg);
        else if (model.atEnd(state))
            break;
    }
    return describe(model, request.uavs[0], request.ids, plan);
}

/**
 * Returns the largest distance between the paths and a flight of their legs, each begun at its
 * planned time.
 */
double largestMiss_m(const Scenario& scenario, const DescribedPlan& plan,
                     const std::vector<AimedPath>& paths)
{
    Simulation simulation(scenario);
    double miss_m = 0;
    for (std::size_t k = 0; k < paths.size(); ++k) {
        simulation.setTarget(0, plan.legs[k].iceberg, plan.legs[k]);
        while (simulation.time_s() <
               paths[k].points.back().time_s - simulation.world().dt_s() / 2) {
            simulation.advanceStep();
            miss_m = std::max(
                miss_m,
                (placeAt(paths, simulation.time_s()) - simulation.uav(0).pose.position_m).norm());
            if (simulation.planReason() != PlanReason::None)
                simulation.setTarget(0, plan.legs[k].iceberg, simulation.uav(0).aim);
        }
    }
    return miss_m;
}

} // namespace

class TestAimedPath : public QObject
{
    Q_OBJECT

private slots:
    /** The flight follows the predicted paths over many legs in a row, without noise. */
    void theFlightFollowsIt_data()
    {
        QTest::addColumn<FovShape>("shape");
        QTest::addColumn<double>("wind_mps");
        QTest::newRow("body") << FovShape::Body << 0.0;
        QTest::newRow("disk") << FovShape::Disk << 0.0;
        QTest::newRow("wind") << FovShape::Body << 9.0;
    }
    void theFlightFollowsIt()
    {
        QFETCH(FovShape, shape);
        QFETCH(double, wind_mps);
        int legs = 0;
        for (int seed = 1; seed <= 15; ++seed) {
            Scenario scenario = randomScenario(seed);
            scenario.noise = false;
            scenario.fovShape = shape;
            scenario.wind_mps = Point(wind_mps, -wind_mps / 2);
            const Simulation simulation(scenario);
            const DescribedPlan plan =
                randomPlan(planRequest(simulation), 8, Random(static_cast<unsigned>(seed)));
            const PredictionInput input = *planRequest(simulation).uavs[0].prediction;
            const std::vector<AimedPath> paths = aimedPaths(plan.legs, input.uav, 0, input.motion);
            QCOMPARE(paths.size(), plan.legs.size());
            legs += static_cast<int>(plan.legs.size());
            const double miss_m = largestMiss_m(scenario, plan, paths);
            QVERIFY2(miss_m < 6, qPrintable(QString("seed %1: %2 m").arg(seed).arg(miss_m)));
        }
        QVERIFY(legs > 60);
    }

    /** The paths of the policy's own plans are right from the middle of the first leg, too. */
    void aLegUnderWay()
    {
        Scenario scenario = randomScenario(4);
        scenario.noise = false;
        scenario.planner.policy = PolicyKind::Coverage;
        Mission mission(scenario, {.workLimit = 100'000});
        int checked = 0;
        for (int k = 0; k < 40; ++k) {
            mission.advance(mission.simulation().time_s() + 7);
            const WorldState& world = mission.simulation().state();
            const test::FlownPlan plan = test::flownPlans(mission).back();
            if (!world.uavs[0].aim || plan.legs.size() < 2)
                continue;
            std::vector<AimedLeg> legs = plan.legs;
            legs.front() = *world.uavs[0].aim;
            const Motion& motion = mission.lastRequest()->uavs[0].prediction->motion;
            const double now_s = mission.simulation().time_s();
            const std::vector<AimedPath> now = aimedPaths(legs, world.uavs[0].pose, now_s, motion);
            const std::vector<AimedPath> planned = aimedPaths(
                plan.legs, mission.lastRequest()->uavs[0].prediction->uav, plan.time_s, motion);
            QVERIFY(now.front().points.front().position_m == world.uavs[0].pose.position_m);
            QVERIFY((placeAt(planned, now_s) - world.uavs[0].pose.position_m).norm() < 3);
            for (const double later_s : {0.0, 10.0, 60.0})
                QVERIFY((placeAt(now, now_s + later_s) - placeAt(planned, now_s + later_s)).norm() <
                        6);
            ++checked;
        }
        QVERIFY(checked > 20);
    }

    /**
     * One leg, a quarter circle to the left and then 300 m north, agrees with a calculation by
     * hand.
     */
    void oneLeg()
    {
        const AimedLeg leg{.iceberg = 0,
                           .turn_rad = M_PI / 2,
                           .from_m = {100, 100},
                           .abeam_m = {100, 1100},
                           .sighting_s = 5 + M_PI / 2 / 0.2 + 15};
        const std::vector<AimedPath> paths = aimedPaths({&leg, 1}, {}, 5, kCalm);
        QCOMPARE(paths.size(), std::size_t{1});
        QVERIFY(paths.front().aim_m == leg.abeam_m);
        const std::vector<PathPoint>& path = paths.front().points;
        QVERIFY((path[path.size() - 2].position_m - leg.from_m).norm() < 1e-9);
        QVERIFY((path.back().position_m - Point(100, 400)).norm() < 1e-9);
        QVERIFY(std::abs(path.back().time_s - leg.sighting_s) < 1e-9);
        for (const PathPoint& point : path) // The points are on the circle until the line begins.
            if (point.position_m.y() < 100)
                QVERIFY(std::abs((point.position_m - Point(0, 100)).norm() - 100) < 1e-9);
        QVERIFY(std::abs(lengthUntil_m(paths, leg.sighting_s) - (100 * M_PI / 2 + 300)) < 0.1);
        QVERIFY(std::abs(lengthUntil_m(paths, leg.sighting_s - 10) - (100 * M_PI / 2 + 100)) < 0.1);
        QCOMPARE(lengthUntil_m(paths, 5), 0.0);
        QVERIFY(std::abs(lengthUntil_m(paths, 1e6) - (100 * M_PI / 2 + 300)) < 0.1);
    }

    /** A hold is flown to its end and has no aim. */
    void holds()
    {
        const std::vector<AimedLeg> legs{
            {.from_m = {0, 0}, .abeam_m = {20, 0}, .sighting_s = 4, .end_s = 5},
            {.turn_rad = M_PI / 2, .from_m = {200, 100}, .abeam_m = {200, 120}, .end_s = 14}};
        const std::vector<AimedPath> paths = aimedPaths(legs, {}, 0, kCalm);
        QVERIFY(!paths[0].aim_m && !paths[1].aim_m);
        QVERIFY((paths[0].points.back().position_m - Point(100, 0)).norm() < 1e-9);
        QVERIFY(std::abs(paths[0].points.back().time_s - 5) < 1e-9);
        QVERIFY((paths[1].points[paths[1].points.size() - 2].position_m - Point(200, 100)).norm() <
                1e-9);
        QVERIFY(paths[1].points.back().time_s <= 14);
    }

    /** An iceberg may be seen during the turn, and the next leg then begins there. */
    void legsMayEndInTheirTurn()
    {
        const std::vector<AimedLeg> legs{
            {.turn_rad = M_PI, .from_m = {0, 200}, .abeam_m = {-1000, 200}, .sighting_s = 3},
            // The second leg begins after a quarter circle and turns right, east again.
            {.turn_rad = -M_PI / 2, .from_m = {200, 200}, .abeam_m = {900, 200}, .sighting_s = 25}};
        const std::vector<AimedPath> paths = aimedPaths(legs, {}, 0, kCalm);
        QVERIFY((paths[0].points.back().position_m - Point(100, 100)).norm() < 1e-9);
        QVERIFY(std::abs(paths[0].points.back().time_s - M_PI / 2 / 0.2) < 1e-9);
        QVERIFY((paths[1].points.front().position_m - Point(100, 100)).norm() < 1e-9);
        for (const PathPoint& point : paths[1].points)
            QVERIFY(point.position_m.x() > 99.9 && point.position_m.y() < 200.1);
    }

    void withoutLegsThereIsNoWay()
    {
        QVERIFY(aimedPaths({}, {}, 0, kCalm).empty());
        QCOMPARE(lengthUntil_m({}, 100), 0.0);
    }
};

QTEST_APPLESS_MAIN(TestAimedPath)
#include "tst_aimed_path.moc"
