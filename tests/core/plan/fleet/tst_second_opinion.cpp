#include "core/plan/fleet/second_opinion.h"
#include "tests/support/approx.h"
#include "tests/support/plan/brute_force.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;

Q_DECLARE_METATYPE(berg::SolveOutcome)

namespace {

SolveOutcome proven(double objective)
{
    return {.status = SolveStatus::Optimal, .objective = objective, .bound = objective};
}

SolveOutcome found(double objective, std::optional<double> bound)
{
    return {.status = SolveStatus::Feasible,
            .reason = StopReason::TimeLimit,
            .objective = objective,
            .bound = bound};
}

} // namespace

class TestSecondOpinion : public QObject
{
    Q_OBJECT

private slots:
    void verdictsFollowBoundsAndPlans_data()
    {
        QTest::addColumn<SolveOutcome>("first");
        QTest::addColumn<SolveOutcome>("second");
        QTest::addColumn<Verdict>("verdict");
        const auto row = [](const char* name, const SolveOutcome& first, const SolveOutcome& second,
                            Verdict verdict) { QTest::newRow(name) << first << second << verdict; };
        row("both proven, equal", proven(-10), proven(-10), Verdict::Agrees);
        row("equal but for rounding", proven(-10), proven(-10 + 1e-7), Verdict::Agrees);
        row("first better", proven(-10), proven(-9.9), Verdict::Disagrees);
        row("second better", proven(-10), proven(-10.1), Verdict::Disagrees);
        row("first not proven, but optimal", found(-10, {}), proven(-10), Verdict::Agrees);
        row("first not proven, nor optimal", found(-10, -12), proven(-11), Verdict::NotVerified);
        row("first's bound is false", found(-10, -10.5), proven(-11), Verdict::Disagrees);
        row("second's bound is false", found(-10, {}), found(-8, -9), Verdict::Disagrees);
        row("second came to a limit", proven(-10), found(-10, -10.5), Verdict::NotVerified);
        row("second knows nothing", proven(-10), {}, Verdict::NotVerified);
        row("second found a better one than proven", proven(-10), found(-11, {}),
            Verdict::Disagrees);
        row("first has no plan", {}, proven(-10), Verdict::NotVerified);
    }

    void verdictsFollowBoundsAndPlans()
    {
        QFETCH(SolveOutcome, first);
        QFETCH(SolveOutcome, second);
        QFETCH(Verdict, verdict);
        const TvpProblem problem = randomProblem(1, 3, 1, Route::Open);
        QCOMPARE(verdictOn(problemOf(problem), first, second), verdict);
    }

#if BERG_EXPECT_CBC
    void usesTheOtherSolver_data()
    {
        QTest::addColumn<Backend>("backend");
        QTest::addColumn<int>("icebergs");
        QTest::addColumn<AnswerSource>("second");
        QTest::addColumn<std::optional<Formulation>>("formulation");
        const std::optional<Formulation> none;
        QTest::newRow("exact, small")
            << Backend::Exact << 9 << AnswerSource::Cbc << std::optional(Formulation::Position);
        QTest::newRow("heuristic, large")
            << Backend::Heuristic << 25 << AnswerSource::Cbc << std::optional(Formulation::Reduced);
        QTest::newRow("cbc") << Backend::Cbc << 9 << AnswerSource::Exact << none;
    }

    void usesTheOtherSolver()
    {
        QFETCH(Backend, backend);
        QFETCH(int, icebergs);
        QFETCH(AnswerSource, second);
        QFETCH(std::optional<Formulation>, formulation);
        const TvpProblem problem = randomProblem(2, icebergs, 0.5, Route::Open);
        const SolveOutcome first = makeSolver(backend)->solve(problem, {});
        const SecondOpinion opinion = secondOpinion(problemOf(problem), first, {});
        QCOMPARE(opinion.outcome.source, second);
        QVERIFY(opinion.formulation == formulation);
        QCOMPARE(opinion.verdict, Verdict::Agrees);
    }

    void usesTheRequestedFormulation()
    {
        const TvpProblem problem = randomProblem(3, 5, 1, Route::Open);
        const SolveOutcome first = makeSolver(Backend::Exact)->solve(problem, {});
        const SecondOpinion opinion =
            secondOpinion(problemOf(problem), first, {}, Formulation::Printed);
        QVERIFY(opinion.formulation == Formulation::Printed);
        QCOMPARE(opinion.verdict, Verdict::Agrees);
    }

    void limitsAndInabilityAreNoVerdict()
    {
        const TvpProblem problem = randomProblem(4, 12, 1, Route::Open);
        const SolveOutcome first = makeSolver(Backend::Auto)->solve(problem, {});
        const SecondOpinion late = secondOpinion(problemOf(problem), first, {.timeLimit_s = 0.0});
        QCOMPARE(late.verdict, Verdict::NotVerified);
        QCOMPARE(late.outcome.reason, StopReason::TimeLimit);
        const TvpProblem large = randomProblem(4, 70, 0, Route::Open);
        const SolveOutcome sorted = makeSolver(Backend::Heuristic)->solve(large, {});
        const SecondOpinion unable = secondOpinion(problemOf(large), sorted, {});
        QCOMPARE(unable.verdict, Verdict::NotVerified);
        QCOMPARE(unable.outcome.reason, StopReason::Unable);
    }
#endif
};

QTEST_APPLESS_MAIN(TestSecondOpinion)
#include "tst_second_opinion.moc"
