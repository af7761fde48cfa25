#pragma once

#include "core/bound/view_cells.h"

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace berg {

/** Counts work, so that what is found within a limit is the same on every machine. */
struct WorkMeter
{
    std::int64_t limit = 0; ///< units of about half a nanosecond
    std::stop_token stop;
    std::int64_t used = 0;

    /** False when the work is not to be done any more. */
    [[nodiscard]] bool spend(std::int64_t work)
    {
        used += work;
        return continues();
    }
    [[nodiscard]] bool continues() const { return used <= limit && !stop.stop_requested(); }
};

/** What a second on the way costs. */
struct ChainPrice
{
    std::vector<double> perSeen; ///< for each region seen so far
    double always = 0;
};

/**
 * For each set of regions (bit i for region i) a lower bound of the cost of any way that ends
 * having touched them all: each second costs `always` and what is due for the regions touched
 * before. Empty when the work is not done.
 *
 * Dynamic programming over (set, cell last touched), forward in time: a leg added at the end ages
 * all that were seen before. `fromStart_s`: least times from where the way begins to each cell;
 * empty: it begins anywhere. Work: `chainWork`.
 */
[[nodiscard]] std::vector<double> chainCosts(const ViewCells& cells, const ChainPrice& price,
                                             std::span<const float> fromStart_s, WorkMeter& meter);

/** Work of `chainCosts`, in units of about half a nanosecond. */
[[nodiscard]] std::int64_t chainWork(int regions, int perRegion);

} // namespace berg
