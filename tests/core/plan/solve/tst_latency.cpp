#include "core/plan/proof/layered_bound.h"
#include "core/plan/solve/engine.h"
#include "core/plan/solve/order_moves.h"
#include "core/plan/solve/subset_solver.h"
#include "tests/support/approx.h"
#include "tests/support/plan/hard_problems.h"

#include <QtTest>

using namespace berg;

namespace {

/** Margin of proofs, relative to the cost, and of sums of some hundred terms. */
constexpr double kProof = 2e-9;
constexpr double kRounding = 1e-11;

/** Returns whether a solve without proof claims nothing false about a problem with this optimum. */
bool isHonest(const TvpProblem& problem, const SolveOutcome& outcome, double optimum)
{
    return isVisitOrder(problem, outcome.order()) &&
           outcome.objective == objective(problem, outcome.order()) &&
           outcome.objective >= optimum * (1 - kRounding) &&
           (!outcome.bound || *outcome.bound <= optimum * (1 + kRounding));
}

bool isProven(const TvpProblem& problem, const SolveOutcome& outcome, double optimum)
{
    return outcome.status == SolveStatus::Optimal && outcome.reason == StopReason::Finished &&
           isVisitOrder(problem, outcome.order()) &&
           std::abs(outcome.objective - optimum) <= kProof * optimum;
}

SolveOutcome byEngine(const TvpProblem& problem, const SolveOptions& options = {})
{
    SolveOutcome outcome = solveByEngine(problem, options, std::nullopt);
    outcome.objective = objective(problem, outcome.order());
    return outcome;
}

} // namespace

/** Solvers, search and bound with `Criterion::Latency`; the policy is in tst_policy. */
class TestLatency : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void objectiveByHand()
    {
        TvpProblem problem{.distance_m = Eigen::MatrixXd::Zero(3, 3),
                           .sigma_m2 = {0, 2, 5},
                           .mu = 0.5,
                           .route = Route::Closed,
                           .criterion = Criterion::Latency};
        problem.distance_m << 0, 10, 40, 1000, 0, 20, 1000, 30, 0;
        // The icebergs are reached after 10 and 30 m, or after 40 and 70 m. The return leg costs
        // nothing.
        QCOMPARE(objective(problem, VisitOrder{1, 2}), 0.5 * (2 * 10 + 5 * 30));
        QCOMPARE(objective(problem, VisitOrder{2, 1}), 0.5 * (5 * 40 + 2 * 70));
        QCOMPARE(objectiveShift(problem), 0.0);
        QCOMPARE(relativeGap(problem, 80, 60), 0.25);
        QVERIFY(restrictedTo(problem, VisitOrder{2}).criterion == Criterion::Latency);
    }

    /** Computes the objective by arrival times, by legs, and in the layout of the solvers. */
    void threeFormulasAgree()
    {
        for (int k = 0; k < 48; ++k) {
            const TvpProblem problem = test::variedLatencyProblem(9, k);
            const double cost = objective(problem, ascendingOrder(9));
            COMPARE_NEAR(test::costByLegs(problem, ascendingOrder(9)), cost, kRounding * cost);
            COMPARE_NEAR(LatencyCosts(problem).total(ascendingOrder(9)), cost, kRounding * cost);
        }
    }

    void movesAreDifferencesOfCost()
    {
        for (int k = 12; k < 144; k += 24) {
            const TvpProblem problem = test::variedLatencyProblem(7, k);
            const LatencyCosts costs(problem);
            const double cost = costs.total(ascendingOrder(7));
            const OrderMoves start(costs, ascendingOrder(7));
            const auto check = [&](double delta, OrderMove move) {
                OrderMoves changed(costs, ascendingOrder(7));
                changed.apply(move);
                COMPARE_NEAR(costs.total(changed.order()) - cost, delta, kRounding * cost);
                COMPARE_NEAR(changed.cost(), cost + delta, kRounding * cost);
            };
            using Kind = OrderMove::Kind;
            for (int a = 1; a < 7; ++a)
                for (int b = a + 1; b <= 7; ++b) {
                    check(start.reversal(a, b), {.kind = Kind::Reverse, .first = a, .last = b});
                    check(start.exchange(a, b), {.kind = Kind::Exchange, .first = a, .last = b});
                    for (int after = 0; after <= 7; ++after)
                        for (const bool turned : {false, true})
                            if (after < a - 1 || after > b)
                                check(start.relocation(a, b, after, turned),
                                      {.kind = Kind::Relocate,
                                       .first = a,
                                       .last = b,
                                       .after = after,
                                       .turned = turned});
                }
        }
    }

    void agreesWithTryingAllOrders_data()
    {
        QTest::addColumn<int>("icebergs");
        for (int n = 1; n <= 8; ++n)
            QTest::addRow("%d icebergs", n) << n;
    }
    /** Zero and equal sigmas, icebergs in one place, grids, wind: every back end is right. */
    void agreesWithTryingAllOrders()
    {
        QFETCH(int, icebergs);
        for (int k = 0; k < 144; k += icebergs <= 6 ? 1 : 23) {
            const TvpProblem problem = test::variedLatencyProblem(icebergs, k);
            const double optimum = test::bruteForce(problem).objective;
            QVERIFY(isProven(problem, SubsetSolver().solve(problem, {}), optimum));
            QVERIFY(isProven(problem, byEngine(problem), optimum));
            for (const Backend backend : {Backend::Exact, Backend::Auto, Backend::Heuristic})
                QVERIFY(isProven(problem, makeSolver(backend)->solve(problem, {}), optimum));
        }
    }

    void agreesWithSubsets_data()
    {
        QTest::addColumn<int>("icebergs");
        for (int n = 9; n <= 16; ++n)
            QTest::addRow("%d icebergs", n) << n;
    }
    void agreesWithSubsets()
    {
        QFETCH(int, icebergs);
        for (int k = 0; k < 144; k += icebergs <= 13 ? 2 : 11) {
            const TvpProblem problem = test::variedLatencyProblem(icebergs, k);
            const double optimum = SubsetSolver().solve(problem, {}).objective;
            QVERIFY2(isProven(problem, byEngine(problem), optimum), qPrintable(QString::number(k)));
        }
    }

    void provesFromABadOrder_data()
    {
        QTest::addColumn<int>("icebergs");
        for (const int n : {1, 2, 3, 5, 8, 11, 14})
            QTest::addRow("%d icebergs", n) << n;
    }
    /** Without the local search the bound has to find the optimum by itself. */
    void provesFromABadOrder()
    {
        QFETCH(int, icebergs);
        for (int k = 0; k < 144; k += 5) {
            const TvpProblem problem = test::variedLatencyProblem(icebergs, k);
            const double optimum = SubsetSolver().solve(problem, {}).objective;
            BoundOptions options;
            options.workLimit = 3'000'000'000;
            options.onImproved = [&](const FleetPlan& plan, double bound) {
                QVERIFY(objective(problem, plan.front()) >= optimum * (1 - kRounding));
                QVERIFY(bound <= optimum * (1 + kRounding));
            };
            const LatencyCosts costs(problem);
            const BoundResult result = improveBound(costs, ascendingOrder(icebergs), options);
            QVERIFY2(result.reached, qPrintable(QString::number(k)));
            QVERIFY(result.bound <= optimum * (1 + kRounding));
            QVERIFY(costs.total(result.plan.front()) <= optimum * (1 + kProof));
        }
    }

    /** A bound is valid, however coarse or early. */
    void boundsAreBounds()
    {
        for (int k = 0; k < 144; k += 3) {
            const TvpProblem problem = test::variedLatencyProblem(12, k);
            const double optimum = SubsetSolver().solve(problem, {}).objective;
            for (const std::int64_t workLimit : {100'000, 1'000'000, 4'000'000})
                QVERIFY(isHonest(problem, byEngine(problem, {.workLimit = workLimit}), optimum));
        }
    }

    /** No sigma is a multiple of another: the levels are never exact. */
    void proves30RealSigmas()
    {
        for (int k = 24; k < 48; k += 6) {
            const TvpProblem problem = test::variedLatencyProblem(30, k);
            const SolveOutcome outcome = byEngine(problem);
            QVERIFY(outcome.status == SolveStatus::Optimal);
            const SolveOutcome again = byEngine(problem, {.hint = outcome.plan});
            QVERIFY(isProven(problem, again, outcome.objective));
            QVERIFY(again.hintUsed);
        }
    }

    void largeProblemsHaveABound()
    {
        TvpProblem problem = test::variedLatencyProblem(150, 24);
        const SolveOutcome outcome = byEngine(problem, {.workLimit = 100'000'000});
        QVERIFY(outcome.status == SolveStatus::Feasible);
        QVERIFY(isVisitOrder(problem, outcome.order()));
        QVERIFY(outcome.bound && *outcome.bound > 0 && *outcome.bound < outcome.objective);
        QVERIFY(makeSolver(Backend::Exact)->unsupportedReason(problem).has_value());
    }

    /** The order repeats; among equals the smallest numbers come first, up to 16 icebergs. */
    void tiesAreDeterministic()
    {
        for (const int n : {5, 16, 20}) {
            TvpProblem problem = test::variedLatencyProblem(n, 0);
            problem.distance_m.setConstant(100);
            std::fill(problem.sigma_m2.begin() + 1, problem.sigma_m2.end(), 4.0);
            const SolveOutcome first = makeSolver(Backend::Auto)->solve(problem, {});
            QVERIFY(first.status == SolveStatus::Optimal);
            QVERIFY(makeSolver(Backend::Auto)->solve(problem, {}).order() == first.order());
            if (n <= 16)
                QVERIFY(first.order() == ascendingOrder(n));
        }
    }

    void theRouteDoesNotMatter()
    {
        TvpProblem problem = test::variedLatencyProblem(18, 12);
        problem.route = Route::Open;
        const SolveOutcome open = byEngine(problem);
        problem.route = Route::Closed;
        const SolveOutcome closed = byEngine(problem);
        QVERIFY(open.plan == closed.plan);
        QCOMPARE(open.objective, closed.objective);
    }

    void limitsAreOutcomes_data()
    {
        QTest::addColumn<int>("reason");
        QTest::newRow("time") << static_cast<int>(StopReason::TimeLimit);
        QTest::newRow("work") << static_cast<int>(StopReason::WorkLimit);
        QTest::newRow("memory") << static_cast<int>(StopReason::MemoryLimit);
        QTest::newRow("gap") << static_cast<int>(StopReason::GapReached);
        QTest::newRow("cancelled") << static_cast<int>(StopReason::Cancelled);
    }
    void limitsAreOutcomes()
    {
        QFETCH(int, reason);
        const auto wanted = static_cast<StopReason>(reason);
        const TvpProblem problem = test::variedLatencyProblem(24, 24);
        const double optimum = byEngine(problem).objective;
        std::stop_source stop;
        SolveOptions options{.stop = stop.get_token()};
        if (wanted == StopReason::TimeLimit)
            options.timeLimit_s = 0;
        if (wanted == StopReason::WorkLimit)
            options.workLimit = 2'000'000;
        if (wanted == StopReason::MemoryLimit)
            options.memoryLimit_bytes = 500'000;
        if (wanted == StopReason::GapReached)
            options.gap = 0.3;
        if (wanted == StopReason::Cancelled)
            options.onProgress = [&](const SolveProgress&) { stop.request_stop(); };
        const SolveOutcome outcome = byEngine(problem, options);
        QVERIFY(outcome.status == SolveStatus::Feasible);
        QCOMPARE(static_cast<int>(outcome.reason), reason);
        QVERIFY(isVisitOrder(problem, outcome.order()));
        QVERIFY(objective(problem, outcome.order()) >= optimum * (1 - kProof));
        QVERIFY(!outcome.bound || *outcome.bound <= optimum * (1 + kProof));
    }

    /** Orders get better, bounds stay below the optimum; the last report is the outcome. */
    void progressIsHonest()
    {
        const TvpProblem problem = test::variedLatencyProblem(24, 30);
        std::vector<SolveProgress> reports;
        SolveOptions options;
        options.onProgress = [&](const SolveProgress& progress) { reports.push_back(progress); };
        const SolveOutcome outcome = makeSolver(Backend::Exact)->solve(problem, options);
        QVERIFY(reports.size() > 2);
        for (std::size_t k = 0; k < reports.size(); ++k) {
            QCOMPARE(reports[k].objective, objective(problem, reports[k].plan.front()));
            QVERIFY(k == 0 || reports[k].objective <= reports[k - 1].objective);
            QVERIFY(!reports[k].bound || *reports[k].bound <= outcome.objective * (1 + kRounding));
        }
        QCOMPARE(reports.back().objective, outcome.objective);
    }
};

QTEST_APPLESS_MAIN(TestLatency)
#include "tst_latency.moc"
