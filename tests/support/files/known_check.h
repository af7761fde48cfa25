#pragma once

// Checks whether a file of known meaning was read correctly.

#include "core/base/error.h"
#include "core/io/import/import_formats.h"
#include "core/io/import/scenario/import_scenario.h"
#include "tests/support/files/known_sightings.h"

#include <algorithm>
#include <map>
#include <set>

namespace berg::test {

enum class ImportVerdict
{
    Right,
    Listed,  ///< correct except for places that are left out with a reason
    Refused, ///< refused with a reason
    Lost,    ///< a place is neither used nor listed
    Wrong    ///< a place, time, iceberg or velocity silently differs from the file
};

struct ImportFinding
{
    ImportVerdict verdict = ImportVerdict::Right;
    std::string why;
};

/** Returns metres between two places, near enough for some kilometres. */
inline double metresBetween(double latitude_deg, double longitude_deg, const LatLon& other)
{
    const double turn_deg = std::remainder(other.longitude_deg - longitude_deg, 360.0);
    return 111'195 * std::hypot(other.latitude_deg - latitude_deg,
                                turn_deg * std::cos(latitude_deg * 0.017453292519943295));
}

/** Compares the result of reading a file with its meaning. */
class KnownCheck
{
public:
    KnownCheck(const KnownFile& file, const SightingTable& table, const ImportResult& result)
        : m_file(file), m_table(table), m_result(result), m_isTaken(file.places.size(), false)
    {
    }

    ImportFinding find()
    {
        for (const Sighting& sighting : m_table.sightings)
            if (std::string fault = matched(sighting); !fault.empty())
                return wrong(fault);
        const auto untold = static_cast<std::size_t>(
            std::ranges::count_if(m_file.places, [&](const KnownPlace& place) {
                return !isTaken(place) && !isListed(place);
            }));
        if (untold > 0)
            return {.verdict = ImportVerdict::Lost,
                    .why = formatted("%zu places are neither taken nor listed", untold)};
        if (!hasTimes() && isUnused(m_file.timeColumn))
            return {.verdict = ImportVerdict::Listed,
                    .why = "times not taken: column " + m_file.timeColumn + " is listed"};
        for (const KnownPlace* place : m_incomplete)
            if (!isListed(*place))
                return wrong(formatted("a time or another value of row %zu is lost", place->row));
        if (!hasTimes() && !m_incomplete.empty())
            return {.verdict = ImportVerdict::Listed, .why = "all times are listed as unreadable"};
        if (std::string fault = groupFault(); !fault.empty())
            return wrong(fault);
        for (std::size_t berg = 0; berg < m_file.bergs.size(); ++berg)
            if (std::string fault = icebergFault(berg); !fault.empty())
                return wrong(fault);
        std::size_t goodMissing = m_incomplete.size() + m_nameless;
        for (std::size_t i = 0; i < m_isTaken.size(); ++i)
            goodMissing += m_file.places[i].isGood && !m_isTaken[i] ? 1U : 0U;
        return goodMissing > 0
                   ? ImportFinding{.verdict = ImportVerdict::Listed,
                                   .why = formatted("%zu good places, times or names left out",
                                                    goodMissing)}
                   : ImportFinding{};
    }

private:
    static constexpr const char* kUnnamed = "at "; // prefix for a sighting without id

    /** A reported doubt about the dates excuses its consequences. */
    ImportFinding wrong(const std::string& fault) const
    {
        const bool isReported = m_file.isAmbiguous && !m_table.guessedDate.empty();
        return {.verdict = isReported ? ImportVerdict::Listed : ImportVerdict::Wrong, .why = fault};
    }

    [[nodiscard]] bool isTaken(const KnownPlace& place) const
    {
        return m_isTaken[static_cast<std::size_t>(&place - m_file.places.data())];
    }

    [[nodiscard]] bool hasTimes() const
    {
        return std::ranges::any_of(
            m_table.sightings, [](const Sighting& sighting) { return sighting.time.has_value(); });
    }

    /** Returns whether a list has the row, or its iceberg has a note about it. */
    [[nodiscard]] bool isListed(const KnownPlace& place) const
    {
        for (const Rejections* list : {&m_result.rejected, &m_table.noted})
            if (std::ranges::find(list->first, place.row, &RejectedRow::line) != list->first.end())
                return true;
        const auto ids = m_idsOf.find(place.berg);
        const auto report =
            ids == m_idsOf.end()
                ? m_result.icebergs.end()
                : std::ranges::find(m_result.icebergs, *ids->second.begin(), &ImportedIceberg::id);
        return report != m_result.icebergs.end() &&
               std::ranges::any_of(report->notes, [](ImportNote note) {
                   return note == ImportNote::TimeUnknown || note == ImportNote::Jumped ||
                          note == ImportNote::Repeated;
               });
    }

    /** Finds the place of the file for a sighting; returns the fault if there is none. */
    std::string matched(const Sighting& sighting)
    {
        std::size_t best = m_file.places.size();
        double least_m = 3 * m_file.rounding_m + 2;
        for (std::size_t i = 0; i < m_file.places.size(); ++i) {
            const KnownPlace& place = m_file.places[i];
            const double away_m =
                metresBetween(place.latitude_deg, place.longitude_deg, sighting.place);
            if (away_m < least_m && !m_isTaken[i]) {
                least_m = away_m;
                best = i;
            }
        }
        if (best == m_file.places.size())
            return formatted("place %.5f %.5f is not in the file", sighting.place.latitude_deg,
                             sighting.place.longitude_deg);
        const KnownPlace& place = m_file.places[best];
        m_isTaken[best] = true;
        if (place.isSpoilt || (place.time_s && !sighting.time))
            m_incomplete.push_back(&place);
        if (place.isGood) {
            m_idsOf[place.berg].insert(idOf(sighting));
            m_namesOf[place.berg].insert(sighting.name);
        }
        if (place.time_s && !sighting.time)
            return {};
        if (!place.time_s)
            return sighting.time ? "a time that the file does not have" : "";
        const double off_s =
            std::abs(std::chrono::duration<double>(sighting.time->time_since_epoch()).count() -
                     static_cast<double>(*place.time_s));
        return off_s > m_file.rounding_s + 1 ? formatted("time is off by %.0f s", off_s) : "";
    }

    [[nodiscard]] std::string idOf(const Sighting& sighting) const
    {
        return sighting.id.empty() && !m_table.oneIceberg
                   ? formatted("%s%.6f %.6f", kUnnamed, sighting.place.latitude_deg,
                               sighting.place.longitude_deg)
                   : sighting.id;
    }

    /** Whether the window and the command line list the column as not used. */
    [[nodiscard]] bool isUnused(const std::string& column) const
    {
        return !column.empty() && std::ranges::find(m_table.unused, column) != m_table.unused.end();
    }

    [[nodiscard]] std::string groupFault()
    {
        std::map<std::string, std::size_t> bergOf;
        for (const auto& [berg, ids] : m_idsOf)
            for (const std::string& id : ids)
                if (const auto [it, isNew] = bergOf.try_emplace(id, berg);
                    !isNew && it->second != berg)
                    return "two icebergs became one";
        for (const auto& [berg, ids] : m_idsOf) {
            if (m_file.hasIds && ids.size() > 1)
                return "one iceberg became two";
            const bool isCalledSo = ids.contains(m_file.bergs[berg].id) ||
                                    m_namesOf[berg] == std::set{m_file.bergs[berg].id};
            if (m_file.hasOneName)
                continue;
            if (m_file.hasIds && !isCalledSo && !isUnused(m_file.idColumn))
                return "iceberg " + m_file.bergs[berg].id + " is called " + *ids.begin();
            m_nameless += m_file.hasIds && !isCalledSo ? 1U : 0U;
        }
        return {};
    }

    /** Finds the last good place of an iceberg, and counts them. */
    [[nodiscard]] std::pair<const KnownPlace*, std::size_t> lastOf(std::size_t berg) const
    {
        const KnownPlace* last = nullptr;
        std::size_t count = 0;
        for (std::size_t i = 0; i < m_file.places.size(); ++i) {
            const KnownPlace& place = m_file.places[i];
            if (place.berg != berg || !place.isGood || !m_isTaken[i])
                continue;
            ++count;
            if (last == nullptr || place.time_s.value_or(0) >= last->time_s.value_or(0))
                last = &place;
        }
        return {last, count};
    }

    /** Returns the id in the scenario: a file of one iceberg without id has one of its own. */
    [[nodiscard]] std::string scenarioId(const std::string& id) const
    {
        return id.empty() && m_result.icebergs.size() == 1 ? m_result.icebergs.front().id : id;
    }

    /** Returns what is wrong with an iceberg of the scenario. */
    [[nodiscard]] std::string icebergFault(std::size_t berg) const
    {
        const auto ids = m_idsOf.find(berg);
        if (ids == m_idsOf.end() || !m_file.hasIds)
            return {};
        const std::string id = scenarioId(*ids->second.begin());
        if (id.starts_with(kUnnamed))
            return {}; // the scenario names it by its position
        const auto report = std::ranges::find(m_result.icebergs, id, &ImportedIceberg::id);
        if (report == m_result.icebergs.end())
            return "iceberg " + id + " is not reported";
        if (report->outcome == ImportOutcome::LeftOut)
            return {};
        const std::vector<Iceberg>& icebergs = m_result.scenario.icebergs;
        const auto iceberg = std::ranges::find(icebergs, id, &Iceberg::id);
        if (iceberg == icebergs.end())
            return "iceberg " + id + " is not in the scenario";
        const auto [last, count] = lastOf(berg);
        const LocalFrame frame(m_result.scenario.origin);
        const LatLon place = frame.toGeographic(iceberg->position_m);
        const double away_m = metresBetween(last->latitude_deg, last->longitude_deg, place);
        if (away_m > 3 * m_file.rounding_m + 60 + report->age_s)
            return formatted("iceberg %s is %.0f m from its last place", id.c_str(), away_m);
        if (metresBetween(last->latitude_deg, last->longitude_deg, m_result.scenario.origin) > 2e5)
            return "the origin is far from " + id;
        return velocityFault(m_file.bergs[berg], *iceberg, *report, count);
    }

    [[nodiscard]] std::string velocityFault(const KnownBerg& berg, const Iceberg& iceberg,
                                            const ImportedIceberg& report, std::size_t fixes) const
    {
        const bool isKnown =
            std::ranges::find(report.notes, ImportNote::VelocityUnknown) == report.notes.end();
        if (!isKnown || (fixes < 2 && !berg.givesVelocity))
            return iceberg.velocity_mps.norm() > 0 ? "a velocity without a source" : "";
        const double off_mps = (iceberg.velocity_mps - Point(berg.east_mps, berg.north_mps)).norm();
        // An estimate leans towards the current if velocities may change, also if a stated drift is
        // included.
        const bool isStatedOnly = berg.givesVelocity && fixes < 2;
        const double lean_mps = isStatedOnly ? 0.01 : 0.25 * berg.speed_mps();
        return off_mps > 0.02 + lean_mps + 3 * m_file.rounding_m / 3600
                   ? formatted("velocity of %s is off by %.2f m/s", berg.id.c_str(), off_mps)
                   : "";
    }

    const KnownFile& m_file;
    const SightingTable& m_table;
    const ImportResult& m_result;
    std::vector<bool> m_isTaken; ///< for each place of the file, whether a sighting matched it
    std::vector<const KnownPlace*> m_incomplete; ///< used without their time or another value
    std::size_t m_nameless = 0; ///< icebergs that lost their name with an unused column
    std::map<std::size_t, std::set<std::string>> m_idsOf;
    std::map<std::size_t, std::set<std::string>> m_namesOf;
};

/**
 * Returns whether the reader needs an answer about identity, which the command line does not guess.
 */
template <class Table>
bool asksWhoIsWho(const Table& table)
{
    if constexpr (requires { table.isIdentityUnclear; })
        return table.isIdentityUnclear;
    else
        return false;
}

/** Returns whether the result needs consent, e.g. for icebergs on land. */
template <class Result>
bool asksForConsent(const Result& result)
{
    if constexpr (requires { needsConsent(result); })
        return needsConsent(result);
    else
        return false;
}

/** Reads the file as the command line does without options. */
inline ImportFinding findingOf(const KnownFile& file)
{
    try {
        const SightingTable table = readSightings(file.bytes, file.name);
        if (asksWhoIsWho(table))
            return {.verdict = ImportVerdict::Refused, .why = "which rows are one iceberg?"};
        const ImportResult result = importSightings(newScenarioForImport("known"), table);
        if (result.added == 0)
            return {.verdict = ImportVerdict::Refused, .why = "no iceberg could be taken"};
        if (asksForConsent(result))
            return {.verdict = ImportVerdict::Refused, .why = "an iceberg is on land or too fast"};
        return KnownCheck(file, table, result).find();
    } catch (const Error& error) {
        return {.verdict = ImportVerdict::Refused, .why = error.what()};
    }
}

} // namespace berg::test
