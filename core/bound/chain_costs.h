#pragma once

#include "core/bound/view_cells.h"

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace berg {

/** Counts work, so that a limit gives the same result on every machine. */
struct WorkMeter
{
    std::int64_t limit = 0; ///< The largest work; one unit takes about half a nanosecond.
    std::stop_token stop;
    std::int64_t used = 0;

    /** Adds `work`, in units. Returns false if the limit is exceeded or a stop is requested. */
    [[nodiscard]] bool spend(std::int64_t work)
    {
        used += work;
        return continues();
    }
    /** Returns whether the limit still holds and no stop is requested. */
    [[nodiscard]] bool continues() const { return used <= limit && !stop.stop_requested(); }
};

/** Cost of one second of a path, in m2 (rates of sigma, m2/s, times seconds). */
struct StageCost
{
    std::vector<double> perSeen; ///< Each region adds its entry once it has been seen.
    double always = 0;
};

/**
 * Returns, for each set of regions (bit i of the index stands for region i), a lower bound of the
 * cost of any path that ends having touched them all. Each second of the path costs `always` plus
 * `perSeen` of the regions touched before. Returns an empty vector if the work limit or a stop ends
 * the calculation. `price.perSeen` must have one entry for each region.
 *
 * The method is dynamic programming over (set, cell last touched), forward in time: a leg added at
 * the end ages all that were seen before. `fromStart_s` has the least times in seconds from the
 * start of the path to each cell; if it is empty, the path begins anywhere. The calculation spends
 * `chainWork` units of `meter`.
 */
[[nodiscard]] std::vector<double> chainCosts(const ViewCells& cells, const StageCost& price,
                                             std::span<const float> fromStart_s, WorkMeter& meter);

/**
 * Returns the work of `chainCosts`, in units of about half a nanosecond, for this number of regions
 * and of cells for each region.
 */
[[nodiscard]] std::int64_t chainWork(int regions, int perRegion);

} // namespace berg
