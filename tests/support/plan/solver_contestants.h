#pragma once

#include "core/plan/solve/engine.h"
#include "core/plan/solve/solver.h"
#include "tests/support/plan/brute_force.h"

#include <QtTest>

#include <array>
#include <numeric>

namespace berg::test {

// Back ends and their promises for the conformance suite. BERG_EXPECT_CBC states whether this build
// has CBC.

/** The engine of `ExactSolver` at sizes at which that solver uses dynamic programming. */
class BareEngine final : public TvpSolver
{
public:
    [[nodiscard]] AnswerSource source() const override { return AnswerSource::Exact; }
    [[nodiscard]] std::optional<IssueReason> unsupportedReason(const TvpProblem&) const override
    {
        return std::nullopt;
    }

protected:
    [[nodiscard]] SolveOutcome doSolve(const TvpProblem& problem,
                                       const SolveOptions& options) const override
    {
        return solveByEngine(problem, options, std::nullopt);
    }
};

/** A back end of `makeSolver` (nullopt for the bare engine) and its promises. */
struct BenchmarkEntry
{
    const char* name = "";
    std::optional<Backend> backend;
    bool proves = false;     ///< whether small problems always get status Optimal
    double tolerance = 2e-9; ///< tolerance of its proofs, relative to F + N sum(sigma)
};

#if BERG_EXPECT_CBC
inline constexpr std::size_t kBenchmarkEntries = 5;
#else
inline constexpr std::size_t kBenchmarkEntries = 4;
#endif

inline constexpr std::array<BenchmarkEntry, kBenchmarkEntries> kAll{{
    {.name = "exact", .backend = Backend::Exact, .proves = true},
    {.name = "heuristic", .backend = Backend::Heuristic, .proves = true},
    {.name = "engine", .proves = true},
    {.name = "auto", .backend = Backend::Auto, .proves = true},
#if BERG_EXPECT_CBC
    // its linear programmes are solved to about 1e-7
    {.name = "cbc", .backend = Backend::Cbc, .proves = true, .tolerance = 1e-6},
#endif
}};

/** Checks an answer to a problem with known optimum; returns the fault, or an empty text. */
inline QString faultOf(const BenchmarkEntry& contestant, const TvpProblem& problem,
                       const SolveOutcome& outcome, double optimum)
{
    const double scale = optimum + objectiveShift(problem);
    const double tolerance = contestant.tolerance * scale + 1e-9;
    if (outcome.source == AnswerSource::None)
        return QStringLiteral("no name");
    if (outcome.elapsed_s < 0 || outcome.work < 0)
        return QStringLiteral("negative effort");
    if (outcome.status == SolveStatus::None) {
        if (outcome.reason == StopReason::Finished)
            return QStringLiteral("finished without an order");
        return outcome.order().empty() ? QString() : QStringLiteral("an order, but status None");
    }
    if (!isVisitOrder(problem, outcome.order()))
        return QStringLiteral("not an order");
    if (outcome.objective != objective(problem, outcome.order()))
        return QStringLiteral("objective is not that of the order");
    if (std::abs(outcome.objective - costByVisitingNumbers(problem, outcome.order())) >
        1e-11 * scale + 1e-9)
        return QStringLiteral("objective is not that of the visiting numbers");
    if (outcome.objective < optimum - 1e-11 * scale - 1e-9)
        return QStringLiteral("better than the optimum");
    if (outcome.bound && *outcome.bound > optimum + tolerance)
        return QStringLiteral("bound %1 above the optimum %2").arg(*outcome.bound).arg(optimum);
    if (outcome.bound && *outcome.bound > outcome.objective)
        return QStringLiteral("bound above the objective");
    if (outcome.status != SolveStatus::Optimal)
        return {};
    if (outcome.bound != outcome.objective)
        return QStringLiteral("proven, but bound and objective differ");
    if (outcome.objective > optimum + tolerance)
        return QStringLiteral("claims %1 to be optimal, not %2")
            .arg(outcome.objective)
            .arg(optimum);
    return {};
}

inline bool same(const SolveOutcome& a, const SolveOutcome& b)
{
    return a.status == b.status && a.reason == b.reason && a.plan == b.plan &&
           a.objective == b.objective && a.bound == b.bound && a.work == b.work &&
           a.hintUsed == b.hintUsed && a.source == b.source;
}

// Rows and columns of the tests; the column `contestant` is the index in `kAll`.

template <class Action>
void forEach(Action&& action)
{
    for (std::size_t k = 0; k < kAll.size(); ++k)
        action(static_cast<int>(k), kAll[k].name);
}

inline void solvers_data()
{
    QTest::addColumn<int>("contestant");
    forEach([](int index, const char* name) { QTest::newRow(name) << index; });
}

inline const BenchmarkEntry& contestant()
{
    QFETCH(int, contestant);
    return kAll.at(static_cast<std::size_t>(contestant));
}

inline std::unique_ptr<TvpSolver> made(const BenchmarkEntry& contestant)
{
    if (contestant.backend)
        return makeSolver(*contestant.backend);
    return std::make_unique<BareEngine>();
}

inline std::unique_ptr<TvpSolver> solver()
{
    return made(contestant());
}

inline SolveOptions hinted(const VisitOrder& hint)
{
    SolveOptions options;
    options.hint = {hint};
    return options;
}

} // namespace berg::test
