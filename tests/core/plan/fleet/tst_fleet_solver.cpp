#include "core/base/solving_guard.h"
#include "core/plan/fleet/fleet_solver.h"
#include "core/plan/fleet/fleet_subsets.h"
#include "tests/support/expect_error.h"
#include "tests/support/plan/fleet_rows.h"

#include <QtTest>

#include <thread>

using namespace berg;

namespace {

constexpr double kProven = 2e-9; // the margin of a proof

/** Returns the fault of an outcome, given the optimum; empty if there is none. */
QString faultOf(const FleetProblem& problem, const SolveOutcome& outcome, double optimum)
{
    const double scale = optimum + objectiveShift(problem);
    if (outcome.status == SolveStatus::None)
        return outcome.plan.empty() && !outcome.bound ? QString() : QStringLiteral("not empty");
    if (!isFleetPlan(problem, outcome.plan))
        return QStringLiteral("no plan");
    if (outcome.objective != fleetObjective(problem, outcome.plan))
        return QStringLiteral("wrong objective");
    if (outcome.bound && *outcome.bound > optimum + kProven * scale)
        return QStringLiteral("bound above the optimum");
    if (outcome.bound && *outcome.bound > outcome.objective)
        return QStringLiteral("bound above the objective");
    if (outcome.status == SolveStatus::Optimal && outcome.objective > optimum + kProven * scale)
        return QStringLiteral("not optimal");
    return {};
}

double optimumOf(const FleetProblem& problem)
{
    return solveFleet(problem, Backend::Exact, {}).objective;
}

} // namespace

class TestFleetSolver : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void backEndsAgreeWithBruteForce_data() { test::addFleetRows(); }
    void backEndsAgreeWithBruteForce()
    {
        for (const int uavs : {1, 2, 3}) {
            const FleetProblem problem = test::fetchedFleet(41, uavs, 8 - uavs);
            const double optimum = test::bruteForceFleet(problem);
            for (const Backend backend : {Backend::Exact, Backend::Auto, Backend::Heuristic}) {
                const SolveOutcome outcome = solveFleet(problem, backend, {});
                QCOMPARE(faultOf(problem, outcome, optimum), QString());
                QVERIFY(test::sameObjective(problem, outcome.objective, optimum));
                QVERIFY(outcome.reason == StopReason::Finished);
                QVERIFY(outcome.work > 0);
                if (backend == Backend::Heuristic && problem.criterion == Criterion::Latency) {
                    QVERIFY(outcome.status == SolveStatus::Feasible && !outcome.bound);
                    continue;
                }
                QVERIFY(outcome.status == SolveStatus::Optimal);
                QCOMPARE(*outcome.bound, outcome.objective);
                QVERIFY(!outcome.hintUsed);
            }
        }
    }

    /** CBC proves the optimum among the orders that our bound leaves. */
    void cbcAgreesWithTheEngine_data() { test::addFleetRows(false); }
    void cbcAgreesWithTheEngine()
    {
        const FleetProblem problem = test::fetchedFleet(42, 3, 11);
        if (!BERG_EXPECT_CBC && problem.mu > 0) {
            const std::optional<Error> error =
                test::errorOf([&] { (void)solveFleet(problem, Backend::Cbc, {}); });
            QVERIFY(error && error->code() == ErrorCode::Unsupported);
            return;
        }
        const SolveOutcome outcome = solveFleet(problem, Backend::Cbc, {});
        QCOMPARE(faultOf(problem, outcome, optimumOf(problem)), QString());
        QVERIFY(outcome.status == SolveStatus::Optimal);
        QCOMPARE(outcome.source, problem.mu > 0 ? AnswerSource::Cbc : AnswerSource::Assignment);
    }

    /** Compares the engine's proof with dynamic programming. */
    void engineAgreesWithSubsets_data() { test::addFleetRows(false); }
    void engineAgreesWithSubsets()
    {
        for (const int uavs : {2, 4}) {
            const FleetProblem problem = test::fetchedFleet(42, uavs, 11);
            const SolveOutcome outcome = solveFleet(problem, Backend::Heuristic, {});
            QCOMPARE(faultOf(problem, outcome, optimumOf(problem)), QString());
            QVERIFY(outcome.status == SolveStatus::Optimal);
        }
    }

    /** Without a bound the search is as good as dynamic programming. */
    void latencyIsFoundBySearch()
    {
        for (const int uavs : {2, 3}) {
            const FleetProblem problem =
                test::randomFleet(42, uavs, 14, 1, test::FleetKind::Latency);
            const SolveOutcome outcome = solveFleet(problem, Backend::Heuristic, {});
            QVERIFY(outcome.status == SolveStatus::Feasible && !outcome.bound);
            QVERIFY(outcome.reason == StopReason::Finished);
            QVERIFY(test::sameObjective(problem, outcome.objective, optimumOf(problem)));
        }
        const FleetProblem larger = test::randomFleet(42, 2, 15, 1, test::FleetKind::Latency);
        QVERIFY(solveFleet(larger, Backend::Exact, {}).reason == StopReason::Unable);
    }

    void middlingProblemsAreProven()
    {
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            const FleetProblem problem = test::randomFleet(seed, 2, 20, 1);
            QVERIFY(solveFleet(problem, Backend::Auto, {}).status == SolveStatus::Optimal);
        }
    }

    void oddProblemsAreSolved_data()
    {
        QTest::addColumn<double>("sigma_m2");
        QTest::addColumn<double>("scale");
        QTest::addRow("no sigma") << 0.0 << 1.0;
        QTest::addRow("equal sigmas") << 5.0 << 1.0;
        QTest::addRow("all in one place") << 5.0 << 0.0;
        QTest::addRow("nothing costs anything") << 0.0 << 0.0;
    }
    void oddProblemsAreSolved()
    {
        QFETCH(double, sigma_m2);
        QFETCH(double, scale);
        FleetProblem problem = test::randomFleet(43, 2, 7, 1);
        std::fill(problem.sigma_m2.begin() + 1, problem.sigma_m2.end(), sigma_m2);
        for (Eigen::MatrixXd& distance_m : problem.distance_m)
            distance_m *= scale;
        const double optimum = test::bruteForceFleet(problem);
        for (const Backend backend : {Backend::Exact, Backend::Heuristic}) {
            const SolveOutcome outcome = solveFleet(problem, backend, {});
            QCOMPARE(faultOf(problem, outcome, optimum), QString());
            QVERIFY(test::sameObjective(problem, outcome.objective, optimum));
        }
    }

    /**
     * At tau = 0 sigma decides the positions, and distance which UAV takes which. UAVs are at 0 and
     * 10 km on a line.
     */
    void tiesGoToTheShorterPlan()
    {
        const std::vector<double> places_m{9000, 1000, 4000, 6000};
        FleetProblem problem{.sigma_m2 = {0, 9, 8, 5, 5}};
        for (const double start_m : {0.0, 10000.0}) {
            Eigen::MatrixX2d points_m = Eigen::MatrixX2d::Zero(5, 2);
            points_m(0, 0) = start_m;
            for (Eigen::Index i = 1; i < 5; ++i)
                points_m(i, 0) = places_m[static_cast<std::size_t>(i) - 1];
            problem.distance_m.push_back(euclideanDistances(points_m));
        }
        for (const Backend backend : {Backend::Exact, Backend::Auto, Backend::Heuristic}) {
            const SolveOutcome outcome = solveFleet(problem, backend, {});
            QVERIFY(outcome.status == SolveStatus::Optimal);
            QCOMPARE(outcome.plan, (FleetPlan{{2, 3}, {1, 4}}));
        }
        // The two most uncertain icebergs are assigned to the second UAV.
        test::assign(problem, 2, 1);
        test::assign(problem, 1, 1);
        const SolveOutcome outcome = solveFleet(problem, Backend::Auto, {});
        QVERIFY(test::sameObjective(problem, outcome.objective, test::bruteForceFleet(problem)));
        QCOMPARE(outcome.plan[1].front(), NodeIndex(1));
    }

    /** Compares the assignment with dynamic programming, and plans many icebergs quickly. */
    void ranksAreOptimal()
    {
        for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
            const FleetProblem problem =
                test::randomFleet(seed, 3, 10, 0, test::FleetKind::Assigned);
            const std::optional<FleetPlan> best = bestFleetPlan(FleetCosts(problem), {});
            const SolveOutcome outcome = solveFleet(problem, Backend::Auto, {});
            QVERIFY(
                test::sameObjective(problem, outcome.objective, fleetObjective(problem, *best)));
        }
        const FleetProblem large = test::randomFleet(5, 5, 60, 0);
        QVERIFY(solveFleet(large, Backend::Auto, {}).status == SolveStatus::Optimal);
    }

    void noIcebergsNeedNoWork()
    {
        const FleetProblem problem{.distance_m = {3, Eigen::MatrixXd::Zero(1, 1)}, .sigma_m2 = {0}};
        const SolveOutcome outcome = solveFleet(problem, Backend::Auto, {});
        QVERIFY(outcome.status == SolveStatus::Optimal);
        QCOMPARE(outcome.plan, FleetPlan(3));
        QCOMPARE(outcome.objective, 0.0);
    }

    void faultyProblemsThrow()
    {
        FleetProblem problem = test::randomFleet(44, 2, 5, 1);
        problem.allowed.assign(2, std::vector<bool>(6, false));
        const std::optional<Error> error =
            test::errorOf([&] { (void)solveFleet(problem, Backend::Auto, {}); });
        QVERIFY(error && error->code() == ErrorCode::InvalidInput);
        QVERIFY(test::names(error->issues(), "allowed[][1]"));
    }

    void unableIsAnOutcome()
    {
        const FleetProblem latency = test::randomFleet(45, 2, 5, 1, test::FleetKind::Latency);
        const FleetProblem large = test::randomFleet(45, 2, 128, 1);
        for (const SolveOutcome& outcome :
             {solveFleet(latency, Backend::Cbc, {}), solveFleet(large, Backend::Exact, {}),
              solveFleet(large, Backend::Cbc, {})}) {
            QVERIFY(outcome.status == SolveStatus::None);
            QVERIFY(outcome.reason == StopReason::Unable);
            QVERIFY(!outcome.detail.empty());
        }
    }

    void manyIcebergsArePlannedWithoutBound()
    {
        const FleetProblem problem = test::randomFleet(46, 4, 140, 1);
        const SolveOutcome outcome = solveFleet(problem, Backend::Auto, {.workLimit = 30'000'000});
        QVERIFY(outcome.status == SolveStatus::Feasible);
        QVERIFY(outcome.reason == StopReason::WorkLimit);
        QVERIFY(!outcome.bound);
        QVERIFY(isFleetPlan(problem, outcome.plan));
    }

    void solvingMayBeForbidden()
    {
        const NoBlockingScope guard;
        const FleetProblem problem = test::randomFleet(47, 2, 5, 1);
        QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)solveFleet(problem, Backend::Auto, {}));
    }

    void limitsAreOutcomes_data()
    {
        QTest::addColumn<int>("icebergs");
        QTest::addColumn<int>("backend");
        for (const int icebergs : {7, 20})
            for (const Backend backend : {Backend::Exact, Backend::Auto, Backend::Heuristic})
                QTest::addRow("%d icebergs, back end %d", icebergs, static_cast<int>(backend))
                    << icebergs << static_cast<int>(backend);
    }
    void limitsAreOutcomes()
    {
        QFETCH(int, icebergs);
        QFETCH(int, backend);
        const FleetProblem problem = test::randomFleet(48, 2, icebergs, 1);
        const double optimum = optimumOf(problem);
        const auto solve = [&](const SolveOptions& options) {
            return solveFleet(problem, static_cast<Backend>(backend), options);
        };
        for (const std::int64_t work : {0, 1, 1000}) {
            const SolveOutcome outcome = solve({.workLimit = work});
            QCOMPARE(faultOf(problem, outcome, optimum), QString());
            QVERIFY(outcome.status == SolveStatus::Feasible);
            QVERIFY(outcome.reason == StopReason::WorkLimit);
        }
        const SolveOutcome late = solve({.timeLimit_s = 0});
        QCOMPARE(faultOf(problem, late, optimum), QString());
        QVERIFY(late.status != SolveStatus::Optimal);
        QVERIFY(late.reason == StopReason::TimeLimit);
        const SolveOutcome narrow = solve({.memoryLimit_bytes = 100});
        QCOMPARE(faultOf(problem, narrow, optimum), QString());
        QVERIFY(narrow.status == SolveStatus::Feasible);
        QVERIFY(narrow.reason == StopReason::MemoryLimit);
    }

    void cancelledBeforeTheStart()
    {
        std::stop_source stop;
        stop.request_stop();
        const SolveOutcome outcome =
            solveFleet(test::randomFleet(49, 2, 20, 1), Backend::Exact, {.stop = stop.get_token()});
        QVERIFY(outcome.status == SolveStatus::None);
        QVERIFY(outcome.reason == StopReason::Cancelled);
        QVERIFY(outcome.plan.empty());
    }

    void cancelledOnTheWay()
    {
        const FleetProblem problem = test::randomFleet(50, 5, 60, 1);
        std::stop_source stop;
        SolveOptions options{.stop = stop.get_token()};
        options.onProgress = [&](const SolveProgress& progress) {
            if (progress.bound)
                stop.request_stop();
        };
        const SolveOutcome outcome = solveFleet(problem, Backend::Exact, options);
        QVERIFY(outcome.status == SolveStatus::Feasible);
        QVERIFY(outcome.reason == StopReason::Cancelled);
        QVERIFY(isFleetPlan(problem, outcome.plan));
        QVERIFY(outcome.bound && *outcome.bound < outcome.objective);
    }

    void aGapIsEnough()
    {
        const FleetProblem problem = test::randomFleet(51, 3, 30, 1);
        const SolveOutcome outcome = solveFleet(problem, Backend::Exact, {.gap = 0.05});
        QCOMPARE(faultOf(problem, outcome, optimumOf(problem)), QString());
        QVERIFY(outcome.reason == StopReason::GapReached || outcome.status == SolveStatus::Optimal);
        QVERIFY(relativeGap(problem, outcome.objective, *outcome.bound) <= 0.05 + kProven);
    }

    void hintsAreNeverMadeWorse()
    {
        const FleetProblem problem = test::randomFleet(52, 3, 20, 1);
        const FleetPlan best = solveFleet(problem, Backend::Exact, {}).plan;
        const SolveOutcome outcome =
            solveFleet(problem, Backend::Heuristic, {.workLimit = 1, .hint = best});
        QVERIFY(outcome.hintUsed);
        QCOMPARE(outcome.plan, best);

        QVERIFY(!solveFleet(problem, Backend::Heuristic, {.hint = {{1}, {2}}}).hintUsed);
        QVERIFY(!solveFleet(problem, Backend::Heuristic, {.hint = FleetPlan(3)}).hintUsed);
    }

    /** Icebergs that an optimal plan lacks are inserted where they cost least. */
    void hintsAreRepaired()
    {
        const FleetProblem problem = test::randomFleet(52, 3, 20, 1);
        const FleetPlan best = solveFleet(problem, Backend::Exact, {}).plan;
        FleetPlan broken = best;
        const NodeIndex taken = broken[0].back();
        broken[0].pop_back();
        broken[1].push_back(broken[2].front()); // it is there twice; the second visit is removed
        broken[2].insert(broken[2].begin(), 99);
        const SolveOutcome outcome =
            solveFleet(problem, Backend::Heuristic, {.workLimit = 1, .hint = broken});
        QVERIFY(outcome.hintUsed);
        QVERIFY(isFleetPlan(problem, outcome.plan));
        FleetPlan without = outcome.plan;
        for (VisitOrder& order : without)
            std::erase(order, taken);
        FleetPlan expected = validPart(problem, broken);
        QCOMPARE(without, expected);
    }

    void progressOnlyImproves()
    {
        const FleetProblem problem = test::randomFleet(53, 3, 25, 1);
        const double optimum = optimumOf(problem);
        const double scale = optimum + objectiveShift(problem);
        std::vector<SolveProgress> reports;
        SolveOptions options;
        options.onProgress = [&](const SolveProgress& progress) { reports.push_back(progress); };
        const SolveOutcome outcome = solveFleet(problem, Backend::Heuristic, options);
        QVERIFY(reports.size() > 2);
        for (std::size_t k = 0; k < reports.size(); ++k) {
            QVERIFY(isFleetPlan(problem, reports[k].plan));
            QCOMPARE(reports[k].objective, fleetObjective(problem, reports[k].plan));
            QVERIFY(!reports[k].bound || *reports[k].bound <= optimum + kProven * scale);
            if (k == 0)
                continue;
            QVERIFY(reports[k].objective <= reports[k - 1].objective);
            QVERIFY(!reports[k - 1].bound ||
                    (reports[k].bound && *reports[k].bound >= *reports[k - 1].bound));
        }
        QCOMPARE(reports.back().objective, outcome.objective);
    }

    /** Solves repeat whatever else runs at the same time. */
    void solvesRepeatExactly()
    {
        const FleetProblem problem = test::randomFleet(54, 4, 40, 0.5);
        const SolveOptions options{.workLimit = 40'000'000};
        std::array<SolveOutcome, 2> outcomes;
        {
            std::jthread other([&] { outcomes[1] = solveFleet(problem, Backend::Auto, options); });
            outcomes[0] = solveFleet(problem, Backend::Auto, options);
        }
        QCOMPARE(outcomes[0].plan, outcomes[1].plan);
        QCOMPARE(outcomes[0].bound, outcomes[1].bound);
        QCOMPARE(outcomes[0].work, outcomes[1].work);
    }

    /** An iceberg assigned to another UAV is visited by it, and the rest is optimal for that. */
    void assignmentsAreKept()
    {
        FleetProblem problem = test::randomFleet(55, 3, 18, 1);
        const SolveOutcome free = solveFleet(problem, Backend::Auto, {});
        const NodeIndex handed = free.plan[0].front();
        test::assign(problem, handed.number(), 2);
        const SolveOutcome bound = solveFleet(problem, Backend::Auto, {.hint = free.plan});
        QVERIFY(bound.hintUsed);
        QVERIFY(bound.status == SolveStatus::Optimal);
        QCOMPARE(std::count(bound.plan[2].begin(), bound.plan[2].end(), handed), 1);
        QVERIFY(bound.objective > free.objective);
    }
};

QTEST_APPLESS_MAIN(TestFleetSolver)
#include "tst_fleet_solver.moc"
