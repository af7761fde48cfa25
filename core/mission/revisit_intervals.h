#pragma once

#include "core/mission/recorder.h"

#include <limits>
#include <span>
#include <vector>

namespace berg {

/** A period in which one iceberg was not seen. */
struct UnseenInterval
{
    double from_s = 0; ///< last sighting, or start of monitoring
    double to_s = 0;   ///< next sighting, end of monitoring, or end of the record
    bool operator==(const UnseenInterval&) const = default;
};

/**
 * Returns, by iceberg, the periods in which it was monitored but out of view, ascending and
 * disjoint. `rows[i]` holds the icebergs at `samples[i]`. The ends are times of samples, so a
 * period is at most one sample interval too long at each end. A sighting between two samples,
 * visible as a drop of sigma, counts at the later one. Cost: linear.
 */
[[nodiscard]] std::vector<std::vector<UnseenInterval>>
unseenIntervals(std::span<const Sample> samples, std::span<const std::vector<IcebergSample>> rows);

/** Time for which one iceberg was not seen. */
struct UnseenTime
{
    double longest_s = 0;
    double total_s = 0;
    bool operator==(const UnseenTime&) const = default;
};

/** Returns the longest and the total time, s, of the parts of ascending intervals before `until_s`.
 */
[[nodiscard]] UnseenTime unseenTime(std::span<const UnseenInterval> intervals,
                                    double until_s = std::numeric_limits<double>::infinity());

} // namespace berg
