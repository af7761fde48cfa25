#include "core/io/import/fields/import_clock.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <span>
#include <vector>

namespace berg {

namespace {

using namespace std::chrono;

constexpr milliseconds kRollover = weeks(1024);
constexpr milliseconds kFar = weeks(512);
/** Largest distance from the others of a moved time that still counts as one of them. */
constexpr milliseconds kMargin = days(31);

struct Group
{
    UtcTime first;
    UtcTime last;
    std::ptrdiff_t count = 0;
};

/** Returns the largest group of times, or nullopt unless it has at least two thirds of all. */
std::optional<Group> mainGroup(std::span<const UtcTime> sorted)
{
    std::optional<Group> best;
    for (std::size_t i = 0; i < sorted.size();) {
        std::size_t end = i + 1;
        while (end < sorted.size() && sorted[end] - sorted[end - 1] <= kFar)
            ++end;
        const Group group{.first = sorted[i],
                          .last = sorted[end - 1],
                          .count = static_cast<std::ptrdiff_t>(end - i)};
        if (!best || group.count > best->count)
            best = group;
        i = end;
    }
    return best && 3 * best->count >= 2 * std::ssize(sorted) ? best : std::nullopt;
}

/** Returns the time moved into the group, or nullopt if no move brings it there. */
std::optional<UtcTime> movedInto(const Group& group, UtcTime time)
{
    for (const int times : {-1, 1, -2, 2}) {
        const UtcTime moved = time + times * kRollover;
        if (moved >= group.first - kMargin && moved <= group.last + kMargin)
            return moved;
    }
    return std::nullopt;
}

} // namespace

void correctTimes(SightingTable& table)
{
    std::vector<UtcTime> times;
    for (const Sighting& sighting : table.sightings)
        if (sighting.time)
            times.push_back(*sighting.time);
    std::ranges::sort(times);
    const std::optional<Group> group = mainGroup(times);
    if (!group || group->count == std::ssize(times))
        return;
    for (Sighting& sighting : table.sightings) {
        if (!sighting.time || (*sighting.time >= group->first && *sighting.time <= group->last))
            continue;
        const std::optional<UtcTime> moved = movedInto(*group, *sighting.time);
        table.noted.add({.line = sighting.line,
                         .fault = moved ? IssueId::TimeRolledOver : IssueId::TimeFarOff,
                         .detail = utcText(*sighting.time, 0)});
        sighting.time = moved;
    }
}

} // namespace berg
