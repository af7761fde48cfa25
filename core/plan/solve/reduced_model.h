#pragma once

#include "core/plan/problem/formulation.h"
#include "core/plan/solve/solver.h"

namespace berg {

/** The MILP that CBC gets for `Formulation::Reduced`. */
struct ReducedModel
{
    VisitOrder incumbent; ///< empty if there was no time to find one
    MilpModel milp;       ///< empty if there was no time to build it
};

/**
 * Returns the position-indexed MILP with the columns of every order that costs no more than the
 * incumbent's cheapest neighbour (two icebergs exchanged, or a stretch reversed). The others are
 * excluded by the Lagrangian bound of our engine: no path through the arc is that cheap. So CBC
 * makes a choice of its own, and a bound that is wrong by less than the distance to the neighbour
 * does not affect its proof. The incumbent is that of our engine, started from the options' hint.
 * Deterministic unless stopped by the time limit or the stop token. The criterion must be
 * Visitation. Throws as `TvpSolver::solve` does.
 */
[[nodiscard]] ReducedModel reducedModel(const TvpProblem& problem, const SolveOptions& options);

} // namespace berg
