#pragma once

#include "core/plan/solve/formulation.h"
#include "core/plan/solve/solver.h"

namespace berg {

/** The MILP that CBC is given for `Formulation::Reduced`. */
struct ReducedModel
{
    VisitOrder incumbent;
    MilpModel milp; ///< empty when there was no time to make it
};

/**
 * Position-indexed MILP with the columns of every order that costs no more than the incumbent's
 * cheapest neighbour (two icebergs exchanged, or a stretch turned round). The others are excluded
 * by the Lagrangian bound of our engine: no path through the arc is that cheap. So CBC has a choice
 * of its own to make, and a bound that is wrong by less than the distance to the neighbour does no
 * harm to its proof. The incumbent is that of our engine, started from the options' hint.
 * Deterministic unless cut by the time limit or the stop token.
 */
[[nodiscard]] ReducedModel reducedModel(const TvpProblem& problem, const SolveOptions& options);

} // namespace berg
