#pragma once

#include "core/plan/problem/tvp.h"

#include <numeric>

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
    VisitOrder order(static_cast<std::size_t>(problem.icebergCount()));
    std::iota(order.begin(), order.end(), 1);
    return order;
}

} // namespace berg::test
