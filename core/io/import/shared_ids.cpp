#include "core/io/import/shared_ids.h"

#include "core/io/import/fields/import_fields.h"
#include "core/io/import/scenario/import_scenario.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace berg {

namespace {

constexpr double kPositions_m = 200;       ///< error of two positions together
constexpr std::size_t kMostCompared = 100; ///< icebergs of one name

/** Places of an iceberg by time. */
using Drift = std::multimap<UtcTime, LatLon>;

bool isReachable(const Drift::value_type& a, const Drift::value_type& b)
{
    const double apart_s = std::abs(std::chrono::duration<double>(a.first - b.first).count());
    return greatCircle_m(a.second, b.second) <= kDoubtfulSpeed_mps * apart_s + kPositions_m;
}

/** Whether the iceberg of `drift` can have been at the places of the other, from fix to fix. */
bool isContinuedBy(const Drift& drift, const Drift& other)
{
    return std::ranges::all_of(other, [&](const Drift::value_type& fix) {
        const auto after = drift.lower_bound(fix.first);
        const auto own = other.lower_bound(fix.first);
        // If fixes of the other are in between, the step is the other's own.
        const bool isNextOwn = after == drift.end() || (std::next(own) != other.end() &&
                                                        std::next(own)->first <= after->first);
        const bool isLastOwn =
            after == drift.begin() ||
            (own != other.begin() && std::prev(own)->first >= std::prev(after)->first);
        return (isNextOwn || isReachable(fix, *after)) &&
               (isLastOwn || isReachable(*std::prev(after), fix));
    });
}

/** Ids of a file, and new ids that differ from all of them. */
class FreeIds
{
public:
    explicit FreeIds(const SightingTable& table)
    {
        for (const Sighting& sighting : table.sightings)
            m_known.insert(sighting.id);
    }

    /** Returns the id of iceberg `number` among those that share this id. */
    const std::string& numbered(const std::string& id, std::size_t number)
    {
        std::string& given = m_numbered[{id, number}];
        constexpr std::size_t kNumber = 6; // digits, and the blank before them
        for (std::size_t tried = number; given.empty(); ++tried) {
            std::string wanted = cleanText(id, kLongestId - kNumber) + ' ' + std::to_string(tried);
            if (m_known.insert(wanted).second)
                given = std::move(wanted);
        }
        return given;
    }

private:
    std::set<std::string> m_known;
    std::map<std::pair<std::string, std::size_t>, std::string> m_numbered;
};

/** Range of rows of one track. */
struct TrackRows
{
    std::size_t first = 0;
    std::size_t end = 0;
};

std::vector<TrackRows> tracksOf(const SightingTable& table, ReadBudget& budget)
{
    std::vector<TrackRows> tracks;
    for (std::size_t row = 0; row < table.sightings.size(); ++row) {
        const std::optional<std::uint32_t>& track = table.sightings[row].track;
        if (!track)
            continue;
        if (!tracks.empty() && tracks.back().end == row &&
            table.sightings[row - 1].track == track) {
            ++tracks.back().end;
            continue;
        }
        budget.take(2 * sizeof(TrackRows));
        tracks.push_back({.first = row, .end = row + 1});
    }
    return tracks;
}

Drift driftOf(const SightingTable& table, const TrackRows& track)
{
    Drift fixes;
    for (std::size_t row = track.first; row < track.end; ++row)
        if (const Sighting& sighting = table.sightings[row]; sighting.time)
            fixes.emplace(*sighting.time, sighting.place);
    return fixes;
}

void separateTracks(SightingTable& table, FreeIds& ids, ReadBudget& budget)
{
    std::map<std::string, std::vector<Drift>> known; // icebergs by id
    for (const TrackRows& track : tracksOf(table, budget)) {
        budget.throwIfStopped();
        const std::string id = table.sightings[track.first].id;
        Drift fixes = driftOf(table, track);
        if (id.empty() || fixes.empty())
            continue;
        std::vector<Drift>& icebergs = known[id];
        const std::size_t compared = std::min(icebergs.size(), kMostCompared);
        const auto same =
            std::find_if(icebergs.end() - static_cast<std::ptrdiff_t>(compared), icebergs.end(),
                         [&](const Drift& drift) { return isContinuedBy(drift, fixes); });
        const auto number = static_cast<std::size_t>(same - icebergs.begin()) + 1;
        if (same == icebergs.end())
            icebergs.push_back(std::move(fixes));
        else
            same->merge(fixes);
        if (number == 1)
            continue;
        const std::string& own = ids.numbered(id, number);
        for (std::size_t row = track.first; row < track.end; ++row)
            table.sightings[row].id = own;
        table.noted.add({.line = table.sightings[track.first].line,
                         .fault = IssueId::TrackOfOther,
                         .detail = own});
    }
}

} // namespace

void separateSharedIds(SightingTable& table, ReadBudget& budget)
{
    const bool isShared = std::ranges::any_of(table.sightings, [](const Sighting& sighting) {
        return sighting.track > 1 || sighting.part > 1;
    });
    if (!isShared)
        return;
    FreeIds ids(table);
    separateTracks(table, ids, budget);
    for (Sighting& sighting : table.sightings)
        if (sighting.part > 1 && !sighting.id.empty())
            sighting.id = ids.numbered(sighting.id, sighting.part);
}

} // namespace berg
