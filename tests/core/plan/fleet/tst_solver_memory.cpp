#include "core/plan/fleet/fleet_bound.h"
#include "core/plan/fleet/fleet_costs.h"
#include "core/plan/fleet/fleet_ranks.h"
#include "core/plan/fleet/fleet_solver.h"
#include "tests/support/plan/fleet_problems.h"
#include "tests/support/plan/hard_problems.h"

#include <QtTest>

#include <sys/resource.h>

using namespace berg;

namespace {

/** The largest memory of the process so far. */
std::int64_t peak_bytes()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::int64_t{1024} * usage.ru_maxrss;
}

} // namespace

/**
 * Solves keep to their memory limit, as measured by the system. The peak of a process never falls,
 * so rows go from small limits to large ones.
 */
class TestSolverMemory : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void limitIsKept_data()
    {
        QTest::addColumn<int>("uavs");
        QTest::addColumn<int>("icebergs");
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("limit_mb");
        const auto row = [](const char* name, int uavs, int icebergs, test::FleetKind kind,
                            int limit_mb) {
            QTest::newRow(name) << uavs << icebergs << static_cast<int>(kind) << limit_mb;
        };
        // A graph of 127 icebergs takes 9 MB, and each UAV of a closed route needs its own.
        row("closed, no room for the graphs", 30, 127, test::FleetKind::Closed, 50);
        row("unlike, no room for the graphs", 30, 127, test::FleetKind::Unlike, 50);
        row("closed, room for the graphs", 6, 100, test::FleetKind::Closed, 50);
        row("several, states", 3, 60, test::FleetKind::Plain, 50);
        row("one, visitation", 1, 100, test::FleetKind::Plain, 50);
        row("one, latency", 1, 100, test::FleetKind::Latency, 50);
    }
    void limitIsKept()
    {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("sanitizers take memory of their own");
#endif
        QFETCH(int, uavs);
        QFETCH(int, icebergs);
        QFETCH(int, kind);
        QFETCH(int, limit_mb);
        const FleetProblem fleet =
            test::randomFleet(5, uavs, icebergs, 1, static_cast<test::FleetKind>(kind));
        const std::int64_t before = peak_bytes();
        constexpr std::int64_t kWork = 500'000'000;
        const std::int64_t limit = std::int64_t{1'000'000} * limit_mb;
        if (uavs > 1) {
            const SolveOutcome outcome =
                solveFleet(fleet, Backend::Exact, {.workLimit = kWork, .memoryLimit_bytes = limit});
            QVERIFY(outcome.status != SolveStatus::None);
        } else {
            const SolveOutcome outcome =
                makeSolver(Backend::Exact)
                    ->solve(problemOfUav(fleet, 0),
                            {.workLimit = kWork, .memoryLimit_bytes = limit});
            QVERIFY(outcome.status != SolveStatus::None);
        }
        // The limit is approximate: malloc keeps some memory.
        QVERIFY2(peak_bytes() - before <= limit + limit / 10,
                 qPrintable(QString::number(peak_bytes() - before)));
    }

    /** UAVs that fly the same distances between icebergs share those costs. */
    void costsAreShared()
    {
        const FleetProblem alike = test::randomFleet(6, 20, 50, 1, test::FleetKind::Closed);
        const FleetProblem unlike = test::randomFleet(6, 20, 50, 1, test::FleetKind::Unlike);
        QVERIFY(FleetCosts(alike).bytes() < 2 * 2 * 8 * 51 * 51);
        QCOMPARE(FleetCosts(unlike).bytes(), FleetCosts::mostBytesFor(unlike));
    }

    /** A graph that cannot be refined any more and no memory for the states end the proof. */
    void noRoomForTheStates()
    {
        const FleetProblem problem = test::randomFleet(47, 5, 2, 1, test::FleetKind::Assigned);
        const BoundResult result =
            improveFleetBound(FleetCosts(problem), roundRobinPlan(problem),
                              {.workLimit = 10'000'000, .memoryLimit_bytes = 2000});
        QVERIFY(result.memoryOut && !result.reached);
        QVERIFY(result.work < 1'000'000);
    }

    void noRoomForTheCosts()
    {
        const FleetProblem problem = test::randomFleet(7, 3, 20, 1, test::FleetKind::Assigned);
        SolveOptions options{.memoryLimit_bytes = 1000};
        const SolveOutcome outcome = solveFleet(problem, Backend::Auto, options);
        QVERIFY(outcome.status == SolveStatus::Feasible);
        QVERIFY(outcome.reason == StopReason::MemoryLimit);
        QVERIFY(isFleetPlan(problem, outcome.plan));
        options.hint = solveFleet(problem, Backend::Auto, {}).plan;
        QCOMPARE(solveFleet(problem, Backend::Auto, options).plan, options.hint);
    }
};

QTEST_APPLESS_MAIN(TestSolverMemory)
#include "tst_solver_memory.moc"
