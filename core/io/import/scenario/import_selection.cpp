#include "core/io/import/scenario/import_selection.h"

#include "core/base/number_text.h"
#include "core/base/stopped.h"
#include "core/io/import/fields/import_fields.h"
#include "core/io/text/read_budget.h"
#include "core/scenario/text_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace berg {

namespace {

/**
 * Returns an id for an iceberg that the file does not name: the same when the file is read again,
 * another for another file. A track is named by its first time, a point by its place.
 */
std::string unnamedId(const Sighting& sighting, const SightingTable& table)
{
    if (const std::optional<UtcTime>& first = table.sightings.front().time; table.oneIceberg)
        return first ? "track " + utcText(*first, 0) : "track";
    const auto angle = [](double angle_deg) {
        return numberText(std::round(std::abs(angle_deg) * 1e4) / 1e4);
    };
    const LatLon& place = sighting.place;
    return angle(place.latitude_deg) + (place.latitude_deg < 0 ? "S " : "N ") +
           angle(place.longitude_deg) + (place.longitude_deg < 0 ? 'W' : 'E');
}

constexpr std::size_t kMostGrouped = 50'000; ///< limit of icebergs in an import

/** Groups the sightings by iceberg. */
class SightingGroups
{
public:
    SightingGroups(const SightingTable& table, std::optional<UtcTime> start)
        : m_table(table), m_start(start)
    {
    }

    void add(const Sighting& sighting)
    {
        std::string id = idOf(sighting);
        const auto [it, isNew] = m_rows.try_emplace(id, m_icebergs.size());
        if (isNew && m_icebergs.size() == readLimit(kMostGrouped))
            failTooLarge("import", IssueId::TooManyGroups, m_icebergs.size());
        if (isNew)
            m_icebergs.push_back({.id = std::move(id), .sightings = {}});
        PlacedSighting placed{.sighting = &sighting, .timeKnown = sighting.time && m_start};
        if (placed.timeKnown)
            placed.fix.time_s = secondsBetween(*m_start, *sighting.time);
        placed.fix.variance_m2 = sighting.sigma_m2.value_or(0);
        m_icebergs[it->second].sightings.push_back(placed);
    }

    std::vector<SightedIceberg> take() { return std::move(m_icebergs); }

private:
    std::string idOf(const Sighting& sighting)
    {
        const bool isNamed = !sighting.id.empty();
        std::string plain = isNamed ? sighting.id : unnamedId(sighting, m_table);
        if (sighting.time || (m_table.oneIceberg && !isNamed))
            return plain;
        // Waypoints at two places are different icebergs, even if they share a name or their ids
        // round to one.
        const std::tuple place(sighting.id, sighting.place.latitude_deg,
                               sighting.place.longitude_deg);
        if (const auto known = m_places.find(place); known != m_places.end())
            return known->second;
        int& number = m_numbers.try_emplace(plain, 1).first->second;
        const auto id = [&] {
            constexpr std::size_t kNumber = 6; // digits, and the blank before them
            return number == 1
                       ? plain
                       : cleanText(plain, kLongestId - kNumber) + ' ' + std::to_string(number);
        };
        while (isOfAnotherWaypoint(id(), isNamed))
            ++number;
        return m_places.emplace(place, id()).first->second;
    }

    [[nodiscard]] bool isOfAnotherWaypoint(const std::string& id, bool isNamed) const
    {
        const auto it = m_rows.find(id);
        if (it == m_rows.end())
            return false;
        const Sighting& first = *m_icebergs[it->second].sightings.front().sighting;
        return !first.time && first.id.empty() != isNamed;
    }

    const SightingTable& m_table;
    std::optional<UtcTime> m_start;
    std::vector<SightedIceberg> m_icebergs;
    std::map<std::string, std::size_t, std::less<>> m_rows;
    std::map<std::tuple<std::string, double, double>, std::string> m_places; ///< ids of waypoints
    std::map<std::string, int> m_numbers; ///< last number given to a place of this id
};

std::string placeWords(const LatLon& place)
{
    return numberText(place.latitude_deg) + ' ' + numberText(place.longitude_deg);
}

void leaveOutOfTime(const Sighting& sighting, ImportResult& result)
{
    ++result.outsideTime;
    result.outside.add({.line = sighting.line,
                        .fault = IssueId::SightedOutsideTime,
                        .detail = utcText(*sighting.time, 0)});
}

} // namespace

bool GeoBox::contains(const LatLon& place) const
{
    if (place.latitude_deg < south_deg || place.latitude_deg > north_deg)
        return false;
    if (east_deg - west_deg >= 360)
        return true;
    const auto eastOfWest = [&](double longitude_deg) {
        const double turn_deg = std::fmod(longitude_deg - west_deg, 360.0);
        return turn_deg < 0 ? turn_deg + 360 : turn_deg;
    };
    return eastOfWest(place.longitude_deg) <= eastOfWest(east_deg);
}

double secondsBetween(UtcTime from, UtcTime to)
{
    return std::chrono::duration<double>(to - from).count();
}

std::vector<const Sighting*> selected(const SightingTable& table, const ImportOptions& options,
                                      ImportResult& result)
{
    std::vector<const Sighting*> kept;
    for (const Sighting& sighting : table.sightings) {
        const std::optional<UtcTime>& time = sighting.time;
        const bool early = time && options.since && *time < *options.since;
        const bool late = time && options.until && *time > *options.until;
        if (options.area && !options.area->contains(sighting.place)) {
            ++result.outsideArea;
            result.outside.add({.line = sighting.line,
                                .fault = IssueId::SightedOutsideArea,
                                .detail = placeWords(sighting.place)});
        } else if (early || late) {
            leaveOutOfTime(sighting, result);
        } else {
            kept.push_back(&sighting);
        }
    }
    return kept;
}

void leaveOutLater(std::vector<const Sighting*>& sightings, UtcTime at, ImportResult& result)
{
    std::erase_if(sightings, [&](const Sighting* sighting) {
        const bool isLater = sighting->time && *sighting->time > at;
        if (isLater)
            leaveOutOfTime(*sighting, result);
        return isLater;
    });
}

std::optional<UtcTime> startOf(const Scenario& base, const std::vector<const Sighting*>& sightings,
                               const ImportOptions& options)
{
    if (options.at)
        return options.at;
    std::optional<UtcTime> start = parseUtc(base.startUtc);
    for (const Sighting* sighting : sightings)
        if (sighting->time && (!start || *sighting->time > *start))
            start = sighting->time;
    return start;
}

std::vector<SightedIceberg> grouped(const std::vector<const Sighting*>& sightings,
                                    const SightingTable& table, std::optional<UtcTime> start,
                                    const std::stop_token& stop)
{
    SightingGroups grouping(table, start);
    for (const Sighting* sighting : sightings) {
        throwIfStopped(stop);
        grouping.add(*sighting);
    }
    return grouping.take();
}

void leaveOutUntimed(std::vector<SightedIceberg>& icebergs, Rejections& rejected)
{
    const auto isTimed = [](const PlacedSighting& placed) {
        return placed.sighting->time.has_value();
    };
    for (SightedIceberg& iceberg : icebergs) {
        if (std::ranges::none_of(iceberg.sightings, isTimed))
            continue;
        std::erase_if(iceberg.sightings, [&](const PlacedSighting& placed) {
            if (isTimed(placed))
                return false;
            rejected.add({.line = placed.sighting->line,
                          .fault = IssueId::TimeBesideTimes,
                          .detail = iceberg.id});
            return true;
        });
    }
}

void place(std::vector<SightedIceberg>& icebergs, const LocalFrame& frame, ImportResult& result,
           const std::stop_token& stop)
{
    for (SightedIceberg& iceberg : icebergs)
        std::erase_if(iceberg.sightings, [&](PlacedSighting& placed) {
            throwIfStopped(stop);
            const Sighting& sighting = *placed.sighting;
            placed.fix.position_m = frame.toPlane(sighting.place);
            if (onPlane(placed.fix.position_m))
                return false;
            ++result.tooFar;
            result.rejected.add({.line = sighting.line,
                                 .fault = IssueId::TooFar,
                                 .detail = placeWords(sighting.place)});
            return true;
        });
    std::erase_if(icebergs,
                  [](const SightedIceberg& iceberg) { return iceberg.sightings.empty(); });
}

} // namespace berg
