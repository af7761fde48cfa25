#pragma once

#include "core/plan/problem/tvp.h"

namespace berg {

/** Quantities of the tuning rule, Eq. (10)-(14). */
struct TuningWeight
{
    double f1Max_m2 = 0; ///< Eq. (10), largest attainable reward (literal weights 0 .. N-1)
    double dEst_m = 0;   ///< Eq. (11)-(12), rough length of a plan
    double mu = 0;       ///< Eq. (14)
    /** Whether every sigma is 0: the plan is then by distance alone, with mu = 1. */
    bool distanceOnly = false;
};

/**
 * Returns mu(tau) for a problem's distances and sigmas (`mu` and `route` are not read), tau >= 0.
 *
 * Eq. (10) is kept as printed: the sorted sigmas include the UAV's 0 and are weighted 0 .. N-1
 * although (1) pays N-2 at most; tau absorbs the difference. Special cases that the paper leaves
 * open: all sigma 0 gives mu = 1; D_est = 0 or N < 2 gives mu = 0.
 */
[[nodiscard]] TuningWeight tuningWeight(const TvpProblem& problem, double tau);

} // namespace berg
