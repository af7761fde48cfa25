#pragma once

#include <cstdint>
#include <functional>
#include <limits>

namespace berg {

/** What a search may do and has done. Work: moves valued and the like, roughly 2 ns each. */
struct SearchEffort
{
    std::function<bool()> cut; ///< asked at least every 1 ms; true ends the search; may be empty
    std::int64_t limit = std::numeric_limits<std::int64_t>::max();
    std::int64_t work = 0;

    [[nodiscard]] bool spent() const { return work >= limit || (cut && cut()); }
};

/** Icebergs in turn that a move takes elsewhere together, at most. */
inline constexpr int kLongestPiece = 3;

} // namespace berg
