#pragma once

#include "core/plan/solve/solver.h"

namespace berg {

/**
 * Returns the problem with `Criterion::Latency` and mu = 1: the objective is the sum of sigma times
 * the distance flown until there. If all sigmas are 0 each place counts 1, which is the minimum
 * latency problem of the literature. The route is open.
 */
[[nodiscard]] TvpProblem latencyProblem(TvpProblem problem);

/**
 * Returns a problem of latency in which the arrival back at the start is one more place, the last
 * node, of sigma 1, at the distances of the start. A flight on from it is 2 (1 + 1 / s) times as
 * long as the longest distance d, s the least sigma: while S >= s is unseen that costs at least 2
 * (S + 1) mu d, and returning last saves more than half of it. So every optimal order ends there,
 * and optimum and bounds are those of the minimum latency problem that counts the return. Throws
 * `std::logic_error` if the criterion is another one or an iceberg has sigma 0.
 */
[[nodiscard]] TvpProblem withReturn(const TvpProblem& problem);

/**
 * Moves the return of a `withReturn` problem to the end of the plan, because a solver that was
 * stopped may have left it elsewhere; the objective does not rise. Does nothing without a plan.
 */
void putReturnLast(const TvpProblem& withReturn, SolveOutcome& outcome);

} // namespace berg
