#pragma once

#include <cstdint>
#include <functional>
#include <limits>

namespace berg {

/**
 * Limit and count of the work of a search. Work: moves evaluated and the like, roughly 2 ns each.
 */
struct SearchEffort
{
    std::function<bool()> isStopped; ///< called at least every 1 ms; may be empty
    std::int64_t limit = std::numeric_limits<std::int64_t>::max();
    std::int64_t work = 0;

    /** Returns whether the search must end. */
    [[nodiscard]] bool spent() const { return work >= limit || (isStopped && isStopped()); }
};

/** Largest number of consecutive icebergs that one move relocates. */
inline constexpr int kLongestPiece = 3;

} // namespace berg
