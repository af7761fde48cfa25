#pragma once

#include "core/plan/problem/tvp.h"

namespace berg::test {

/**
 * Returns a tolerance: Clp is accurate to about 1e-9 of the nonnegative cost sum(sigma t) + mu D.
 */
inline double toleranceOf(const TvpProblem& problem, double objective)
{
    return 1e-7 * (objective + objectiveShift(problem));
}

inline VisitOrder inNodeOrder(const TvpProblem& problem)
{
    return ascendingOrder(problem.icebergCount());
}

} // namespace berg::test
