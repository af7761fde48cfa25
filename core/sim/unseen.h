#pragma once

#include "core/sim/recorder.h"

#include <limits>
#include <span>
#include <vector>

namespace berg {

/** A stretch of time in which one iceberg was not seen. */
struct UnseenInterval
{
    double from_s = 0; ///< last seen then, or known of from then on
    double to_s = 0;   ///< seen again, no longer there, or end of the record
    bool operator==(const UnseenInterval&) const = default;
};

/**
 * For each iceberg, by index, when it was known of but out of view; ascending, apart from each
 * other. `rows[i]` are the icebergs at `samples[i]`. Each end is that of a sample, so at most one
 * sample interval too far out; a sighting between two samples, told by a sigma that has fallen,
 * counts at the later one. Cost: linear.
 */
[[nodiscard]] std::vector<std::vector<UnseenInterval>>
unseenIntervals(std::span<const Sample> samples, std::span<const std::vector<IcebergSample>> rows);

/** How long one iceberg was not seen. */
struct UnseenTime
{
    double longest_s = 0;
    double total_s = 0;
    bool operator==(const UnseenTime&) const = default;
};

/** Of what lies before `until_s`. */
[[nodiscard]] UnseenTime unseenTime(std::span<const UnseenInterval> intervals,
                                    double until_s = std::numeric_limits<double>::infinity());

} // namespace berg
