#include "core/mission/mission.h"
#include "core/mission/plan_requests.h"
#include "core/plan/policy/fleet_task.h"
#include "core/plan/policy/tau_curve.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/flight/fleet_flight.h"
#include "tests/support/plan/fleet_problems.h"

#include <algorithm>

using namespace berg;
using namespace berg::test;

namespace {

void checkFleetShape(const TauCurve& curve, const FleetProblem& problem, double tauMax)
{
    QVERIFY(!curve.intervals.empty());
    QCOMPARE(curve.intervals.front().tauFrom, 0.0);
    QCOMPARE(curve.intervals.back().tauTo, tauMax);
    for (std::size_t i = 0; i < curve.intervals.size(); ++i) {
        const CurveInterval& interval = curve.intervals[i];
        QVERIFY(interval.tauFrom < interval.tauTo);
        QVERIFY(isFleetPlan(problem, interval.plan));
        QCOMPARE(interval.distance_m, fleetDistance(problem, interval.plan));
        if (i == 0)
            continue;
        QCOMPARE(interval.tauFrom, curve.intervals[i - 1].tauTo);
        QVERIFY(interval.distance_m < curve.intervals[i - 1].distance_m);
        QVERIFY(interval.reward_m2 < curve.intervals[i - 1].reward_m2);
    }
}

} // namespace

class TestFleetCurve : public QObject
{
    Q_OBJECT

private slots:
    /** Every tau has its best plan, whatever the differences between the UAVs. */
    void fleetsByBruteForce_data()
    {
        QTest::addColumn<int>("kind");
        QTest::newRow("alike") << static_cast<int>(FleetKind::Plain);
        QTest::newRow("unlike, asymmetric") << static_cast<int>(FleetKind::Unlike);
        QTest::newRow("icebergs assigned") << static_cast<int>(FleetKind::Assigned);
        QTest::newRow("round trips") << static_cast<int>(FleetKind::Closed);
    }
    void fleetsByBruteForce()
    {
        QFETCH(int, kind);
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            const int uavs = 2 + static_cast<int>(seed % 2);
            FleetProblem problem = randomFleet(seed, uavs, 5, 1, static_cast<FleetKind>(kind));
            const Eigen::MatrixXd apart_m = Eigen::MatrixXd::Constant(uavs, uavs, 1000);
            const TauCurve curve = tauCurve(problem, apart_m, {.tauMax = 3});
            checkFleetShape(curve, problem, 3);
            QVERIFY(curve.complete && std::ranges::all_of(curve.intervals, &CurveInterval::proven));
            for (double tau = 0.02; tau < 3; tau += 0.11) {
                problem.mu = fleetTuningWeight(problem, apart_m, tau).mu;
                const CurveInterval& here =
                    curve.intervals[static_cast<std::size_t>(intervalAt(curve, tau).value())];
                const double shift = objectiveShift(problem);
                const double best = bruteForceFleet(problem) + shift;
                COMPARE_NEAR(fleetObjective(problem, here.plan) + shift, best, 1e-9 * best);
            }
        }
    }

    /**
     * With more icebergs than can be proven the curve has no gap, repeats, and is close to the
     * planner's.
     */
    void manyOfSeveralUavs()
    {
        const Scenario scenario = withUavs(randomScenario(4, {.icebergs = 24}), 3);
        const FleetTask task = visitationTask(planRequest(Simulation(scenario)), Route::Open);
        const TauCurveOptions options{.tauMax = 2, .workLimit = 400'000'000};
        const TauCurve curve = tauCurve(task.problem, task.betweenStarts_m, options);
        checkFleetShape(curve, task.problem, 2);
        QVERIFY(curve.complete && curve.reason == StopReason::WorkLimit);
        QCOMPARE(curve, tauCurve(task.problem, task.betweenStarts_m, options));
        FleetProblem problem = task.problem;
        problem.mu = fleetTuningWeight(problem, task.betweenStarts_m, 1).mu;
        const double shift = objectiveShift(problem);
        const double planned = planFromStart(scenario).outcome.objective + shift;
        const auto at = static_cast<std::size_t>(intervalAt(curve, 1).value());
        QVERIFY(fleetObjective(problem, curve.intervals[at].plan) + shift < 1.02 * planned);
    }

    void curveHoldsThePlanShown()
    {
        for (std::int64_t seed = 1; seed <= 4; ++seed) {
            Scenario scenario = withUavs(randomScenario(seed, {.icebergs = 8}), 2);
            scenario.planner.tau = 0.3 * static_cast<double>(seed);
            const PlanRequest request = planRequest(Simulation(scenario));
            const FleetTask task = visitationTask(request, Route::Open);
            const Plan plan = planFromStart(scenario);
            const TauCurve curve = tauCurve(task.problem, task.betweenStarts_m, {});
            const auto at =
                static_cast<std::size_t>(intervalAt(curve, scenario.planner.tau).value());
            const std::vector<IcebergList> orders =
                ordersInIds(request, task, curve.intervals[at].plan);
            for (std::size_t u = 0; u < 2; ++u)
                QCOMPARE(orders[u], plan.uavs[u].order);
        }
    }

    void stoppedCurveIsValid()
    {
        const FleetProblem problem = randomFleet(1, 3, 20, 1);
        std::stop_source source;
        int reports = 0;
        const TauCurve curve =
            tauCurve(problem, Eigen::MatrixXd::Constant(3, 3, 1000),
                     {.stop = source.get_token(), .onProgress = [&](const TauCurve&) {
                          if (++reports == 2)
                              source.request_stop();
                      }});
        QVERIFY(curve.reason == StopReason::Cancelled && !curve.complete);
        checkFleetShape(curve, problem, 5);
        QVERIFY(
            tauCurve(problem, Eigen::MatrixXd::Constant(3, 3, 1000), {.stop = source.get_token()})
                .intervals.empty());
    }
};

QTEST_APPLESS_MAIN(TestFleetCurve)
#include "tst_fleet_curve.moc"
