#include "core/mission/mission.h"
#include "core/mission/plan_requests.h"
#include "core/plan/policy/fleet_task.h"
#include "core/plan/policy/tau_curve.h"
#include "core/plan/problem/tuning.h"
#include "core/plan/solve/subset_solver.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/plan/brute_force.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

using namespace berg;
using namespace berg::test;

namespace {

/** Kinds of test instances. */
enum class Shape
{
    Plain,      ///< sigma 1 .. 10, ties likely
    Asymmetric, ///< distances as in wind
    RealSigma,
    FewSigmas,  ///< two values: distance decides most of the order at tau -> 0
    SomeZero,   ///< icebergs in view have sigma 0
    Coincident, ///< pairs of icebergs at the same place
    Grid        ///< a regular grid with equal sigma: many equal orders
};

/** Returns the curve of one UAV. */
TauCurve tauCurve(const TvpProblem& problem, const TauCurveOptions& options)
{
    return berg::tauCurve(problemOf(problem), {}, options);
}

TvpProblem makeProblem(Shape shape, std::uint64_t seed, int icebergs, Route route)
{
    TvpProblem problem = randomProblem(seed, icebergs, 0, route, shape == Shape::Asymmetric);
    Random random(seed, 5);
    for (int i = 1; i <= icebergs; ++i) {
        double& sigma_m2 = problem.sigma_m2[static_cast<std::size_t>(i)];
        if (shape == Shape::RealSigma)
            sigma_m2 = random.uniform(0.1, 30);
        else if (shape == Shape::FewSigmas)
            sigma_m2 = random.below(2) == 0 ? 5 : 7;
        else if (shape == Shape::SomeZero && random.below(3) == 0)
            sigma_m2 = 0;
        else if (shape == Shape::Grid)
            sigma_m2 = 5;
    }
    Eigen::MatrixX2d points_m(icebergs + 1, 2);
    if (shape == Shape::Coincident || shape == Shape::Grid) {
        for (int i = 0; i <= icebergs; ++i) {
            const int place = shape == Shape::Coincident ? (i + 1) / 2 : i;
            points_m.row(i) << 1000.0 * (place % 3), 1000.0 * (place / 3);
        }
        problem.distance_m = euclideanDistances(points_m);
    }
    return problem;
}

/** F + N sum(sigma) of an order at tau: positive, so that relative differences make sense. */
double costAt(TvpProblem problem, const VisitOrder& order, double tau)
{
    problem.mu = tuningWeight(problem, tau).mu;
    return objective(problem, order) + objectiveShift(problem);
}

/** Returns every order of a small problem as the pair that decides its line. */
std::vector<std::pair<double, double>> allLines(const TvpProblem& problem)
{
    std::set<std::pair<double, double>> lines;
    VisitOrder order = ascendingOrder(problem.icebergCount());
    do
        lines.insert({flownDistance(problem, order), uncertaintyReward(problem, order)});
    while (std::next_permutation(order.begin(), order.end()));
    return {lines.begin(), lines.end()};
}

/**
 * Checks properties of every curve: no gap, orders and figures that agree, both figures decreasing.
 */
void checkShape(const TauCurve& curve, const TvpProblem& problem, double tauMax)
{
    QVERIFY(!curve.intervals.empty());
    QCOMPARE(curve.intervals.front().tauFrom, 0.0);
    QCOMPARE(curve.intervals.back().tauTo, tauMax);
    for (std::size_t i = 0; i < curve.intervals.size(); ++i) {
        const CurveInterval& interval = curve.intervals[i];
        QVERIFY(interval.tauFrom < interval.tauTo);
        QVERIFY(isVisitOrder(problem, interval.order()));
        QCOMPARE(interval.distance_m, flownDistance(problem, interval.order()));
        QCOMPARE(interval.reward_m2, uncertaintyReward(problem, interval.order()));
        if (i == 0)
            continue;
        const CurveInterval& before = curve.intervals[i - 1];
        QCOMPARE(interval.tauFrom, before.tauTo);
        QVERIFY(interval.distance_m < before.distance_m);
        QVERIFY(interval.reward_m2 < before.reward_m2);
        const double here = costAt(problem, interval.order(), interval.tauFrom);
        COMPARE_NEAR(costAt(problem, before.order(), interval.tauFrom), here, 1e-9 * here);
    }
}

bool allProven(const TauCurve& curve)
{
    return std::all_of(curve.intervals.begin(), curve.intervals.end(),
                       [](const CurveInterval& i) { return i.proven; });
}

} // namespace

Q_DECLARE_METATYPE(Shape)

class TestTauCurve : public QObject
{
    Q_OBJECT

private slots:
    void agreesWithEveryOrder_data()
    {
        QTest::addColumn<Shape>("shape");
        QTest::addColumn<Route>("route");
        const std::vector<std::pair<const char*, Shape>> shapes{
            {"plain", Shape::Plain},          {"asymmetric", Shape::Asymmetric},
            {"real sigma", Shape::RealSigma}, {"few sigmas", Shape::FewSigmas},
            {"some zero", Shape::SomeZero},   {"coincident", Shape::Coincident},
            {"grid of equal", Shape::Grid}};
        for (const auto& [name, shape] : shapes) {
            QTest::addRow("%s, open", name) << shape << Route::Open;
            QTest::addRow("%s, closed", name) << shape << Route::Closed;
        }
    }

    /** On a fine grid of tau: the order is optimal, and no optimal line is missing. */
    void agreesWithEveryOrder()
    {
        QFETCH(Shape, shape);
        QFETCH(Route, route);
        constexpr int kSteps = 500;
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            const int icebergs = 1 + static_cast<int>(seed % 7);
            const TvpProblem problem = makeProblem(shape, seed, icebergs, route);
            const TauCurve curve = tauCurve(problem, {});
            checkShape(curve, problem, 5);
            if (QTest::currentTestFailed())
                return;
            QVERIFY(curve.complete);
            QVERIFY(allProven(curve));

            const std::vector<std::pair<double, double>> lines = allLines(problem);
            const double shift = objectiveShift(problem);
            std::set<int> seen;
            for (int k = 1; k <= kSteps; ++k) {
                const double tau = 5.0 * k / kSteps;
                const double mu = tuningWeight(problem, tau).mu;
                double best = std::numeric_limits<double>::infinity();
                for (const auto& [distance_m, reward_m2] : lines)
                    best = std::min(best, mu * distance_m - reward_m2);
                const int index = intervalAt(curve, tau).value();
                seen.insert(index);
                const VisitOrder& order = curve.intervals[static_cast<std::size_t>(index)].order();
                COMPARE_NEAR(costAt(problem, order, tau), best + shift, 1e-9 * (best + shift));
            }
            QVERIFY(seen.size() <= curve.intervals.size());
        }
    }

    /** Right of 0 the ties of the sort are broken by distance. */
    void atZeroTiesGoToTheShorterPath()
    {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const TvpProblem problem = makeProblem(Shape::FewSigmas, seed, 6, Route::Open);
            double most_m2 = 0;
            for (const auto& [distance_m, reward_m2] : allLines(problem))
                most_m2 = std::max(most_m2, reward_m2);
            double shortest_m = std::numeric_limits<double>::infinity();
            for (const auto& [distance_m, reward_m2] : allLines(problem))
                if (reward_m2 > most_m2 - 1e-9)
                    shortest_m = std::min(shortest_m, distance_m);
            const TauCurve curve = tauCurve(problem, {});
            COMPARE_NEAR(curve.intervals.front().reward_m2, most_m2, 1e-9);
            COMPARE_NEAR(curve.intervals.front().distance_m, shortest_m, 1e-6);
        }
    }

    /** Sigmas that differ by rounding are ties: their orders get no intervals. */
    void roundingMakesNoIntervals()
    {
        for (const int icebergs : {7, 15}) {
            TvpProblem problem = makeProblem(Shape::FewSigmas, 4, icebergs, Route::Open);
            const TauCurve curve = tauCurve(problem, {});
            for (std::size_t i = 1; i < problem.sigma_m2.size(); i += 2)
                problem.sigma_m2[i] = std::nextafter(problem.sigma_m2[i], 10);
            const TauCurve rounded = tauCurve(problem, {});
            checkShape(rounded, problem, 5);
            if (QTest::currentTestFailed())
                return;
            QCOMPARE(rounded.intervals.size(), curve.intervals.size());
            for (std::size_t i = 0; i < curve.intervals.size(); ++i)
                QCOMPARE(rounded.intervals[i].order(), curve.intervals[i].order());
        }
    }

    void agreesWithDynamicProgramming_data()
    {
        QTest::addColumn<int>("icebergs");
        QTest::addColumn<Shape>("shape");
        QTest::addColumn<Route>("route");
        for (const int icebergs : {10, 12, 13, 14, 15, 17}) {
            QTest::addRow("%d open", icebergs) << icebergs << Shape::Plain << Route::Open;
            QTest::addRow("%d closed", icebergs) << icebergs << Shape::Plain << Route::Closed;
            QTest::addRow("%d wind", icebergs) << icebergs << Shape::Asymmetric << Route::Open;
            QTest::addRow("%d real", icebergs) << icebergs << Shape::RealSigma << Route::Open;
            QTest::addRow("%d few", icebergs) << icebergs << Shape::FewSigmas << Route::Closed;
            QTest::addRow("%d zero", icebergs) << icebergs << Shape::SomeZero << Route::Open;
            QTest::addRow("%d pairs", icebergs) << icebergs << Shape::Coincident << Route::Open;
        }
        QTest::addRow("20 open") << 20 << Shape::Plain << Route::Open;
    }

    void agreesWithDynamicProgramming()
    {
        QFETCH(int, icebergs);
        QFETCH(Shape, shape);
        QFETCH(Route, route);
        TvpProblem problem = makeProblem(shape, 40, icebergs, route);
        const TauCurve curve = tauCurve(problem, {});
        checkShape(curve, problem, 5);
        if (QTest::currentTestFailed())
            return;
        QVERIFY(allProven(curve));
        Random random(9, static_cast<std::uint64_t>(icebergs));
        for (int k = 0; k < (icebergs < 16 ? 10 : 3); ++k) {
            const double tau = k % 2 == 0 ? random.uniform(0, 5) : random.uniform(0, 1);
            problem.mu = tuningWeight(problem, tau).mu;
            const SolveOutcome best = SubsetSolver().solve(problem, {});
            const int index = intervalAt(curve, tau).value();
            const VisitOrder& order = curve.intervals[static_cast<std::size_t>(index)].order();
            const double cost = best.objective + objectiveShift(problem);
            COMPARE_NEAR(objective(problem, order) + objectiveShift(problem), cost, 1e-9 * cost);
        }
    }

    void noneOrOneToVisitGivesOneInterval()
    {
        const TauCurve none = tauCurve(makeProblem(Shape::Plain, 1, 0, Route::Open), {});
        QVERIFY(none.complete);
        QCOMPARE(none.intervals.size(), 1U);
        QVERIFY(none.intervals[0].order().empty());
        QVERIFY(none.intervals[0].proven);
        const TauCurve one = tauCurve(makeProblem(Shape::Plain, 1, 1, Route::Closed), {});
        QCOMPARE(one.intervals.size(), 1U);
        QCOMPARE(one.intervals[0].order(), VisitOrder{1});
    }

    /** By the rule for sigma all 0 the distance alone counts, whatever tau. */
    void sigmaAllZeroIsTheShortestPath()
    {
        for (const int icebergs : {6, 16}) {
            TvpProblem problem = makeProblem(Shape::Plain, 3, icebergs, Route::Open);
            std::fill(problem.sigma_m2.begin(), problem.sigma_m2.end(), 0.0);
            problem.mu = 1;
            const double shortest_m = SubsetSolver().solve(problem, {}).objective;
            const TauCurve curve = tauCurve(problem, {});
            QCOMPARE(curve.intervals.size(), 1U);
            COMPARE_NEAR(curve.intervals[0].distance_m, shortest_m, 1e-6);
            QVERIFY(curve.intervals[0].proven);
        }
    }

    /** All icebergs are at the UAV: distance has no weight, and the sort is best for every tau. */
    void noDistancesGiveOneInterval()
    {
        TvpProblem problem = makeProblem(Shape::Plain, 3, 5, Route::Open);
        problem.distance_m.setZero();
        const TauCurve curve = tauCurve(problem, {.tauMax = 2});
        checkShape(curve, problem, 2);
        QCOMPARE(curve.intervals.size(), 1U);
        QVERIFY(curve.complete && curve.intervals[0].proven);
    }

    void intervalsAreFound()
    {
        TauCurve curve;
        QVERIFY(!intervalAt(curve, 1));
        curve.intervals = {{.tauFrom = 0, .tauTo = 1}, {.tauFrom = 1, .tauTo = 5}};
        QCOMPARE(intervalAt(curve, 0), std::optional(0));
        QCOMPARE(intervalAt(curve, 0.999), std::optional(0));
        QCOMPARE(intervalAt(curve, 1), std::optional(1));
        QCOMPARE(intervalAt(curve, 5), std::optional(1));
        QCOMPARE(intervalAt(curve, 90), std::optional(1));
        QCOMPARE(intervalAt(curve, -1), std::optional(0));
    }

    /** Each report is a whole curve, never worse anywhere than the one before. */
    void reportsGetBetter()
    {
        const TvpProblem problem = makeProblem(Shape::Plain, 8, 16, Route::Open);
        TauCurve last;
        int reports = 0;
        TauCurveOptions options;
        options.onProgress = [&](const TauCurve& curve) {
            ++reports;
            QVERIFY(!curve.complete);
            checkShape(curve, problem, 5);
            for (double tau = 0.05; tau < 5 && !last.intervals.empty(); tau += 0.1) {
                const auto at = [tau](const TauCurve& c) {
                    return c.intervals[static_cast<std::size_t>(intervalAt(c, tau).value())];
                };
                QVERIFY(costAt(problem, at(curve).order(), tau) <=
                        costAt(problem, at(last).order(), tau) * (1 + 1e-12));
                QVERIFY(at(curve).proven || !at(last).proven);
            }
            last = curve;
        };
        const TauCurve curve = tauCurve(problem, options);
        QVERIFY(curve.complete);
        QVERIFY(reports >= 2 * static_cast<int>(curve.intervals.size()));
        QCOMPARE(last.intervals, curve.intervals);
    }

    void cancellingLeavesWhatIsKnown()
    {
        const TvpProblem problem = makeProblem(Shape::Plain, 8, 40, Route::Open);
        std::stop_source stop;
        TauCurveOptions options;
        options.stop = stop.get_token();
        int reports = 0;
        options.onProgress = [&](const TauCurve&) {
            if (++reports == 5)
                stop.request_stop();
        };
        const TauCurve curve = tauCurve(problem, options);
        QCOMPARE(reports, 5);
        QCOMPARE(curve.reason, StopReason::Cancelled);
        QVERIFY(!curve.complete);
        checkShape(curve, problem, 5);

        const TauCurve again = tauCurve(problem, options); // cancelled before it begins
        QCOMPARE(again.reason, StopReason::Cancelled);
        checkShape(again, problem, 5);
    }

    void workLimitLeavesIntervalsUnproven()
    {
        for (const int icebergs : {25, 130}) {
            const TvpProblem problem = makeProblem(Shape::Plain, 8, icebergs, Route::Open);
            const TauCurve curve = tauCurve(problem, {.workLimit = 1'000'000});
            QCOMPARE(curve.reason, StopReason::WorkLimit);
            QVERIFY(curve.complete);
            QVERIFY(!allProven(curve));
            checkShape(curve, problem, 5);
        }
    }

    /** The limit ends searches as well: a curve of hundreds of icebergs has as many intervals. */
    void workLimitEndsSearches()
    {
        const TvpProblem problem = makeProblem(Shape::RealSigma, 8, 200, Route::Open);
        std::size_t fewer = 0;
        for (const std::int64_t work : {0LL, 3'000'000LL, 30'000'000LL}) {
            const TauCurve curve = tauCurve(problem, {.workLimit = work});
            QCOMPARE(curve.reason, StopReason::WorkLimit);
            QVERIFY(curve.complete);
            QVERIFY(!allProven(curve));
            checkShape(curve, problem, 5);
            QVERIFY(curve.intervals.size() > fewer);
            fewer = curve.intervals.size();
        }
    }

    void curvesRepeatExactly()
    {
        for (const int icebergs : {9, 18}) {
            const TvpProblem problem = makeProblem(Shape::RealSigma, 3, icebergs, Route::Closed);
            QCOMPARE(tauCurve(problem, {}), tauCurve(problem, {}));
        }
    }

    void faultyProblemsAreRefused()
    {
        TvpProblem problem = makeProblem(Shape::Plain, 1, 4, Route::Open);
        problem.sigma_m2[2] = -1;
        QCOMPARE(codeOf([&] { static_cast<void>(tauCurve(problem, {})); }),
                 std::string("InvalidInput"));
        problem.sigma_m2[2] = 1;
        problem.mu = -1; // not read
        QVERIFY(tauCurve(problem, {}).complete);
    }

    void curveHoldsThePlanShown_data()
    {
        QTest::addColumn<Route>("route");
        QTest::addColumn<bool>("windy");
        QTest::newRow("one way") << Route::Open << false;
        QTest::newRow("round trip") << Route::Closed << false;
        QTest::newRow("one way in wind") << Route::Open << true;
    }

    /** The curve at the scenario's tau holds the plan that the mission starts with. */
    void curveHoldsThePlanShown()
    {
        QFETCH(Route, route);
        QFETCH(bool, windy);
        for (std::int64_t seed = 1; seed <= 6; ++seed) {
            Scenario scenario = randomScenario(seed);
            scenario.planner.route = route;
            scenario.planner.tau = 0.15 * static_cast<double>(seed);
            scenario.icebergs[3].position_m = scenario.uavs[0].position_m; // in view: not planned
            if (windy)
                scenario.wind_mps = {6, -3};
            const FleetTask task = visitationTask(planRequest(Simulation(scenario)), route);
            const Plan plan = planFromStart(scenario);
            QCOMPARE(task.ids, plan.solvedIds);
            QVERIFY(task.problem.distance_m == plan.problem.distance_m);
            QCOMPARE(task.problem.sigma_m2, plan.problem.sigma_m2);
            QCOMPARE(task.problem.route, plan.problem.route);

            const TauCurve curve = tauCurve(task.problem, task.betweenStarts_m, {});
            const int index = intervalAt(curve, scenario.planner.tau).value();
            QCOMPARE(curve.intervals[static_cast<std::size_t>(index)].order(),
                     plan.outcome.order());
        }
    }
};

QTEST_APPLESS_MAIN(TestTauCurve)
#include "tst_tau_curve.moc"
