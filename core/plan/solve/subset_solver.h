#pragma once

#include "core/plan/solve/solver.h"

namespace berg {

/**
 * Finds the proven optimum by dynamic programming over subsets of icebergs (Held and Karp 1962,
 * with the position-dependent cost of Eq. (1), or latency): 2^n n states, n <= 20 icebergs (168
 * MB). Ties go to the smallest node numbers. Fastest for small problems, and an independent check
 * of the engine. Work unit: entries of the table, roughly 2 ns each.
 */
class SubsetSolver final : public TvpSolver
{
public:
    static constexpr int kMostIcebergs = 20;

    /** Returns the work of a solve, the same for all problems of one size. */
    [[nodiscard]] static constexpr std::int64_t workFor(int icebergs)
    {
        return (std::int64_t{1} << icebergs) * icebergs;
    }
    /** Returns the memory of a solve, bytes. */
    [[nodiscard]] static constexpr std::int64_t bytesFor(int icebergs)
    {
        const int rows = (icebergs + 3) / 4 * 4; // a row is padded to whole vectors
        return (std::int64_t{1} << icebergs) * rows * static_cast<std::int64_t>(sizeof(double));
    }

    [[nodiscard]] AnswerSource source() const override { return AnswerSource::Subsets; }
    [[nodiscard]] std::optional<IssueReason>
    unsupportedReason(const TvpProblem& problem) const override;

protected:
    [[nodiscard]] SolveOutcome doSolve(const TvpProblem& problem,
                                       const SolveOptions& options) const override;
};

} // namespace berg
