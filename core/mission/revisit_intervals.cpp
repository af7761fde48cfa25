#include "core/mission/revisit_intervals.h"

#include <algorithm>
#include <utility>

namespace berg {

namespace {

/** State of one iceberg while the samples are scanned. */
struct Watch
{
    bool known = false;
    bool seen = false; ///< seen at the previous sample
    double sigma_m2 = 0;
    double since_s = 0; ///< last sighting, or start of monitoring
};

} // namespace

std::vector<std::vector<UnseenInterval>>
unseenIntervals(std::span<const Sample> samples, std::span<const std::vector<IcebergSample>> rows)
{
    const std::size_t count = std::min(samples.size(), rows.size());
    std::vector<std::vector<UnseenInterval>> unseen;
    std::vector<Watch> watches;
    for (std::size_t k = 0; k < count; ++k) {
        const double time_s = samples[k].time_s;
        if (rows[k].size() > watches.size()) { // icebergs are only ever added
            watches.resize(rows[k].size());
            unseen.resize(rows[k].size());
        }
        for (std::size_t i = 0; i < rows[k].size(); ++i) {
            const IcebergSample& now = rows[k][i];
            Watch& watch = watches[i];
            if (!now.active) { // before it appears, outside the area or removed
                if (std::exchange(watch.known, false) && !watch.seen && time_s > watch.since_s)
                    unseen[i].push_back({.from_s = watch.since_s, .to_s = time_s});
                continue;
            }
            const bool seen = now.inView || (watch.known && now.sigma_m2 < watch.sigma_m2);
            if (!watch.known || (seen && watch.seen))
                watch.since_s = time_s;
            else if (seen) {
                unseen[i].push_back({.from_s = watch.since_s, .to_s = time_s});
                watch.since_s = time_s;
            }
            // An iceberg seen between two samples is out of view at the later one, so it is unseen
            // from there.
            watch.seen = now.inView;
            watch.known = true;
            watch.sigma_m2 = now.sigma_m2;
        }
    }
    for (std::size_t i = 0; i < watches.size(); ++i)
        if (watches[i].known && !watches[i].seen && samples[count - 1].time_s > watches[i].since_s)
            unseen[i].push_back({.from_s = watches[i].since_s, .to_s = samples[count - 1].time_s});
    return unseen;
}

UnseenTime unseenTime(std::span<const UnseenInterval> intervals, double until_s)
{
    UnseenTime time;
    for (const UnseenInterval& interval : intervals) {
        const double length_s = std::min(interval.to_s, until_s) - interval.from_s;
        if (length_s <= 0)
            break;
        time.total_s += length_s;
        time.longest_s = std::max(time.longest_s, length_s);
    }
    return time;
}

} // namespace berg
