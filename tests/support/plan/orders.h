#pragma once

#include "core/plan/problem/tvp.h"

#include <numeric>

namespace berg::test {

/** Returns the icebergs in the order of their numbers. */
inline VisitOrder ascending(int icebergs)
{
    VisitOrder order(static_cast<std::size_t>(icebergs));
    std::iota(order.begin(), order.end(), 1);
    return order;
}

} // namespace berg::test
