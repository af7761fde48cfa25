#include "core/plan/solve/engine.h"
#include "core/plan/solve/order_moves.h"
#include "core/plan/solve/subset_solver.h"
#include "tests/support/approx.h"
#include "tests/support/plan/hard_problems.h"

#include <QtTest>

using namespace berg;

namespace {

/** Relative to F + N sum(sigma): the margin of a proof, and the rounding of sums. */
constexpr double kProven = 2e-9;
constexpr double kRounding = 1e-11;

VisitOrder shuffled(int icebergs, std::uint64_t seed)
{
    VisitOrder order = ascendingOrder(icebergs);
    Random random(seed, 5);
    for (std::size_t k = order.size(); k > 1; --k)
        std::swap(order[k - 1], order[static_cast<std::size_t>(random.below(k))]);
    return order;
}

/** Reports of a solve, and their fault given the optimum; empty if there is none. */
class Reports
{
public:
    explicit Reports(const TvpProblem& problem) : m_problem(problem) {}

    [[nodiscard]] std::function<void(const SolveProgress&)> taker()
    {
        return [this](const SolveProgress& report) { m_reports.push_back(report); };
    }
    [[nodiscard]] const std::vector<SolveProgress>& all() const { return m_reports; }

    [[nodiscard]] QString fault(double optimum) const
    {
        const double scale = optimum + objectiveShift(m_problem);
        for (std::size_t k = 0; k < m_reports.size(); ++k) {
            const SolveProgress& report = m_reports[k];
            if (!isVisitOrder(m_problem, report.plan.front()))
                return QStringLiteral("report %1 has no order").arg(k);
            if (report.objective != objective(m_problem, report.plan.front()))
                return QStringLiteral("report %1 has a wrong objective").arg(k);
            if (report.bound && *report.bound > optimum + kRounding * scale)
                return QStringLiteral("report %1 has a bound above the optimum").arg(k);
            if (k == 0)
                continue;
            const SolveProgress& before = m_reports[k - 1];
            if (report.objective > before.objective + kRounding * scale)
                return QStringLiteral("report %1 has a worse order").arg(k);
            if (before.bound && (!report.bound || *report.bound < *before.bound))
                return QStringLiteral("report %1 has a worse bound").arg(k);
        }
        return {};
    }

private:
    const TvpProblem& m_problem;
    std::vector<SolveProgress> m_reports;
};

} // namespace

/** Properties of this back end; the conformance suite tests the common ones. */
class TestExactSolver : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    /** Two sizes for both methods, which never see each other's answer. */
    void agreesWithDynamicProgramming_data()
    {
        QTest::addColumn<int>("icebergs");
        QTest::newRow("15 icebergs") << 15;
        QTest::newRow("17 icebergs") << 17;
    }

    void agreesWithDynamicProgramming()
    {
        QFETCH(int, icebergs);
        for (int number = 0; number < 144; number += 5) {
            const TvpProblem problem = test::variedProblem(icebergs, number);
            const double optimum = SubsetSolver().solve(problem, {}).objective;
            Reports reports(problem);
            SolveOptions options;
            options.hint = {shuffled(icebergs, static_cast<std::uint64_t>(number))};
            options.onProgress = reports.taker();
            const SolveOutcome outcome = ExactSolver().solve(problem, options);
            QVERIFY(outcome.status == SolveStatus::Optimal);
            QVERIFY(outcome.reason == StopReason::Finished);
            const double scale = optimum + objectiveShift(problem);
            COMPARE_NEAR(outcome.objective, optimum, kProven * scale);
            QCOMPARE(reports.fault(optimum), QString());
        }
    }

    /** Tests the size at which one method takes over from the other. */
    void usesTheFasterMethod()
    {
        const auto work = [](int icebergs, const SolveOptions& options) {
            return ExactSolver()
                .solve(test::randomProblem(1, icebergs, 1, Route::Open), options)
                .work;
        };
        QCOMPARE(work(14, {}), SubsetSolver::workFor(14));
        QVERIFY(work(15, {}) < SubsetSolver::workFor(15));
        // A table that the limits do not allow is not begun.
        SolveOptions options;
        options.memoryLimit_bytes = SubsetSolver::bytesFor(14) - 1;
        QVERIFY(work(14, options) != SubsetSolver::workFor(14));
        options = {};
        options.workLimit = 1000;
        const SolveOutcome outcome =
            ExactSolver().solve(test::randomProblem(1, 14, 1, Route::Open), options);
        QVERIFY(outcome.status == SolveStatus::Feasible);
        QVERIFY(outcome.reason == StopReason::WorkLimit);
    }

    /** Any number of icebergs is a sort without distances; proofs have their limit. */
    void refusesWhatItCannotProve()
    {
        QVERIFY(!ExactSolver().unsupportedReason(test::randomProblem(1, 127, 1, Route::Open)));
        const TvpProblem large = test::randomProblem(1, 128, 1, Route::Open);
        const SolveOutcome outcome = ExactSolver().solve(large, {});
        QVERIFY(outcome.reason == StopReason::Unable);
        QVERIFY(outcome.detail.find("127") != std::string::npos);

        const TvpProblem sorted = test::randomProblem(1, 150, 0, Route::Open);
        const SolveOutcome order = ExactSolver().solve(sorted, {});
        QVERIFY(order.status == SolveStatus::Optimal);
        QVERIFY(order.order() == sigmaOrder(sorted));
    }

    void provesFortyIcebergs_data()
    {
        QTest::addColumn<double>("tau");
        QTest::addColumn<bool>("closed");
        for (const double tau : {0.25, 1.0, 10.0, 100.0})
            for (const bool closed : {false, true})
                QTest::addRow("tau %g, %s", tau, closed ? "closed, wind" : "open") << tau << closed;
    }

    /** No other method proves this size, so the bound is compared with increasing limits. */
    void provesFortyIcebergs()
    {
        QFETCH(double, tau);
        QFETCH(bool, closed);
        const TvpProblem problem =
            test::randomProblem(3, 40, tau, closed ? Route::Closed : Route::Open, closed);
        Reports reports(problem);
        SolveOptions options;
        options.onProgress = reports.taker();
        const SolveOutcome outcome = ExactSolver().solve(problem, options);
        QVERIFY(outcome.status == SolveStatus::Optimal);
        QCOMPARE(reports.fault(outcome.objective), QString());
        // The first bound comes with the first local optimum, long before the proof.
        const auto bounded = std::find_if(reports.all().begin(), reports.all().end(),
                                          [](const SolveProgress& r) { return r.bound; });
        QVERIFY(bounded != reports.all().end());
        QVERIFY(bounded->objective > outcome.objective || bounded->bound < outcome.objective);

        // Another start gives the same optimum.
        options = {};
        options.hint = {shuffled(40, 1)};
        const SolveOutcome hinted = ExactSolver().solve(problem, options);
        QVERIFY(hinted.hintUsed);
        COMPARE_NEAR(hinted.objective, outcome.objective,
                     kProven * (outcome.objective + objectiveShift(problem)));
    }

    void difficultProblemsAreProven_data()
    {
        QTest::addColumn<int>("oddity");
        QTest::addColumn<bool>("closed");
        QTest::newRow("real sigmas") << static_cast<int>(test::Oddity::RealSigmas) << false;
        QTest::newRow("zero sigmas") << static_cast<int>(test::Oddity::ZeroSigmas) << false;
        QTest::newRow("equal sigmas") << static_cast<int>(test::Oddity::EqualSigmas) << true;
        QTest::newRow("coincident") << static_cast<int>(test::Oddity::Coincident) << false;
        QTest::newRow("grid") << static_cast<int>(test::Oddity::Grid) << true;
    }

    /** Ties and the like do not take forever: two hundred times the usual work is the limit. */
    void difficultProblemsAreProven()
    {
        QFETCH(int, oddity);
        QFETCH(bool, closed);
        const Route route = closed ? Route::Closed : Route::Open;
        const TvpProblem problem = test::madeOdd(test::randomProblem(4, 24, 1, route),
                                                 static_cast<test::Oddity>(oddity), 4);
        SolveOptions options;
        options.workLimit = 800'000'000;
        QVERIFY(ExactSolver().solve(problem, options).status == SolveStatus::Optimal);
    }

    /** At any work limit bounds and orders are valid, and repeat. */
    void anyWorkLimitLeavesValidAnswers()
    {
        for (const int number : {3, 20, 40, 64}) {
            const TvpProblem problem = test::variedProblem(17, number);
            const double optimum = SubsetSolver().solve(problem, {}).objective;
            const double scale = optimum + objectiveShift(problem);
            double lastBound = -std::numeric_limits<double>::infinity();
            double lastObjective = std::numeric_limits<double>::infinity();
            SolveStatus status = SolveStatus::None;
            for (std::int64_t limit = 1; status != SolveStatus::Optimal; limit += limit / 4 + 1) {
                Reports reports(problem);
                SolveOptions options;
                options.workLimit = limit;
                options.onProgress = reports.taker();
                const SolveOutcome outcome = ExactSolver().solve(problem, options);
                status = outcome.status;
                QVERIFY(isVisitOrder(problem, outcome.order()));
                QVERIFY(status == SolveStatus::Optimal || outcome.reason == StopReason::WorkLimit);
                QCOMPARE(reports.fault(optimum), QString());
                QVERIFY(outcome.bound.value_or(lastBound) >= lastBound - kRounding * scale);
                QVERIFY(outcome.bound.value_or(optimum) <= optimum + kRounding * scale);
                QVERIFY(outcome.objective <= lastObjective + kRounding * scale);
                lastBound = outcome.bound.value_or(lastBound);
                lastObjective = outcome.objective;

                const SolveOutcome again = ExactSolver().solve(problem, options);
                QVERIFY(again.plan == outcome.plan);
                QVERIFY(again.bound == outcome.bound);
                QCOMPARE(again.work, outcome.work);
                QVERIFY(limit < 1'000'000'000);
            }
            COMPARE_NEAR(lastObjective, optimum, kProven * scale);
        }
    }

    /** A solve cancelled at any of its reports ends there, with the result it reported. */
    void cancelledAtAnyReport()
    {
        const TvpProblem problem = test::randomProblem(5, 36, 3, Route::Closed, true);
        const double optimum = ExactSolver().solve(problem, {}).objective;
        for (int atReport = 1;; ++atReport) {
            std::stop_source stop;
            int reports = 0;
            SolveProgress last;
            SolveOptions options;
            options.stop = stop.get_token();
            options.onProgress = [&](const SolveProgress& progress) {
                last = progress;
                if (++reports == atReport)
                    stop.request_stop();
            };
            const SolveOutcome outcome = ExactSolver().solve(problem, options);
            if (outcome.status == SolveStatus::Optimal)
                break;
            QVERIFY(outcome.reason == StopReason::Cancelled);
            QCOMPARE(outcome.objective, last.objective);
            QVERIFY(outcome.bound == last.bound);
            QVERIFY(outcome.bound.value_or(optimum) <= optimum);
            QVERIFY(reports <= atReport + 1); // the result at the time of the stop
            QVERIFY(atReport < 1000);
        }
    }

    /** Less memory proves less, but the bound is valid at every limit. */
    void memoryLimitLeavesAValidBound()
    {
        const TvpProblem problem = test::randomProblem(6, 40, 3, Route::Open);
        const double optimum = ExactSolver().solve(problem, {}).objective;
        bool limited = false;
        bool proven = false;
        for (std::int64_t limit_bytes = 1000; !proven; limit_bytes *= 4) {
            Reports reports(problem);
            SolveOptions options;
            options.memoryLimit_bytes = limit_bytes;
            options.onProgress = reports.taker();
            const SolveOutcome outcome = ExactSolver().solve(problem, options);
            proven = outcome.status == SolveStatus::Optimal;
            QVERIFY(proven || outcome.reason == StopReason::MemoryLimit);
            QVERIFY(proven || outcome.status == SolveStatus::Feasible);
            QVERIFY(outcome.bound.has_value());
            QVERIFY(*outcome.bound <= optimum);
            QCOMPARE(reports.fault(optimum), QString());
            limited = limited || !proven;
            QVERIFY(limit_bytes < 2'000'000'000);
        }
        QVERIFY(limited);
        SolveOptions unlimited;
        unlimited.memoryLimit_bytes.reset();
        QCOMPARE(ExactSolver().solve(problem, unlimited).objective, optimum);
    }

    void stopsAtTheGap()
    {
        const TvpProblem problem = test::randomProblem(7, 36, 1, Route::Open);
        const double optimum = ExactSolver().solve(problem, {}).objective;
        std::int64_t lastWork = 0;
        for (const double gap : {0.05, 0.01, 0.002}) {
            SolveOptions options;
            options.gap = gap;
            const SolveOutcome outcome = ExactSolver().solve(problem, options);
            QVERIFY(outcome.reason == StopReason::GapReached);
            QVERIFY(relativeGap(problem, outcome.objective, outcome.bound.value()) <= gap + 1e-12);
            QVERIFY(*outcome.bound <= optimum);
            QVERIFY(outcome.work > lastWork);
            lastWork = outcome.work;
        }
    }
};

QTEST_APPLESS_MAIN(TestExactSolver)
#include "tst_exact_solver.moc"
