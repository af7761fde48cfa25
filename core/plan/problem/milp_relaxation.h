#pragma once

#include "core/plan/problem/formulation.h"

namespace berg {

/**
 * Admissible flow: valid inequalities of the position-indexed MILP (Abeledo, Fukasawa, Pessoa and
 * Uchoa 2013). A UAV that flies i -> j from position k continues from j to another iceberg than i,
 * z(i,j,k) <= sum over l != i of z(j,l,k+1). There are about n^3 of them, so they are added when
 * violated. Borrows the model.
 */
class AdmissibleFlow
{
public:
    /** `model` must come from `positionModel`. */
    explicit AdmissibleFlow(const MilpModel& model);

    /**
     * Returns the rows that a solution of the relaxation (one value per column) violates by more
     * than `leastViolation`. Throws `std::logic_error` unless there is one value per column. Cost:
     * n times the arcs that carry flow.
     */
    [[nodiscard]] std::vector<MilpRow> violated(std::span<const double> relaxed,
                                                double leastViolation) const;

private:
    [[nodiscard]] const std::vector<int>& onwardFrom(const MilpArc& arc) const;

    const MilpModel& m_model;
    std::vector<std::vector<int>> m_outgoing; ///< columns that leave [position * N + node]
};

/**
 * Returns a good order from a solution of the relaxation (one value per column, of either
 * formulation): the icebergs by their mean position in it, improved by moving one iceberg or
 * reversing one stretch as long as that lowers Eq. (1). Deterministic. Throws `std::logic_error`
 * unless there is one value per column. Cost: n^3 for each round of moves, a few rounds.
 */
[[nodiscard]] VisitOrder roundRelaxation(const TvpProblem& problem, const MilpModel& model,
                                         std::span<const double> relaxed);

} // namespace berg
