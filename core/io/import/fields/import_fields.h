#pragma once

// Private to core/io: converts the texts of one row or feature to a sighting, for every format.

#include "core/io/import/fields/import_source.h"
#include "core/scenario/text_checks.h"

#include <chrono>
#include <map>
#include <set>
#include <variant>

namespace berg {

/** Number of fields of a sighting. */
inline constexpr std::size_t kFieldCount = kSightingFieldNames.size();

/**
 * Confidence that a column holds ids of icebergs. Ids have one order of precedence, by the rank of
 * `FieldUse`, lowest first:
 *
 *     0                    a column that the user has mapped
 *     from 1               columns and properties by their names (`fieldOfColumn`): iceberg,
 *                          then trackers and tracks, then those that may count rows
 *     `kNameRank`          the name of a placemark, waypoint, packet, track or row
 *     `kFeatureIdRank`     the id of a feature, placemark or packet, which programs count
 *
 * `decideIdentity` says when a lower rank yields to a higher one.
 */
enum class IdTrust : std::uint8_t
{
    Iceberg, ///< the name says so: "iceberg id"
    Tracker, ///< "IMEI", "target", and "id", which may be that of a message
    Weak     ///< perhaps something else: "number", "track" (a course), names, ids of features
};
inline constexpr std::size_t kNameRank = 1000;
inline constexpr std::size_t kFeatureIdRank = 1001;
/** Returns the confidence in a column of this rank. */
[[nodiscard]] IdTrust idTrust(std::size_t rank);

/** Use of a column: its field, the factor to SI units and how well its name fits. */
struct FieldUse
{
    SightingField field = SightingField::Id;
    double factor = 1;
    std::size_t rank = 0; ///< of several columns for one field, the lowest is used
    bool isAis = false;   ///< a course of 360 degrees means none
    std::optional<std::chrono::minutes> offset = {}; ///< ahead of UTC, if the name states it
};

/**
 * Returns a time or time of day with the offset from UTC appended, or `time` itself if that would
 * not be a time, e.g. because it has an offset already.
 */
[[nodiscard]] std::string withZone(const std::string& time, std::chrono::minutes offset);

/** Returns the field that a column of this name usually holds, or nullopt for any other name. */
[[nodiscard]] std::optional<FieldUse> fieldOfColumn(std::string_view name);

/** A part of a latitude or longitude whose degrees are in another column. */
struct PlacePart
{
    enum class Kind
    {
        Minutes,
        Seconds,
        Hemisphere
    };
    SightingField field = SightingField::Latitude;
    Kind kind = Kind::Minutes;
};

/**
 * Returns the part that a column of this name holds ("lat_min": minutes of the latitude, "E/W": the
 * hemisphere), or nullopt for any other name.
 */
[[nodiscard]] std::optional<PlacePart> placePartOf(std::string_view name);

/**
 * Returns Date or Time if the name begins or ends as such a column but has an unknown word besides,
 * as "time (EST)" or "ship time", or nullopt for any other name.
 */
[[nodiscard]] std::optional<SightingField> unclearTimeOf(std::string_view name);

/** Columns of one file: those mapped explicitly, and guesses for the remaining fields. */
class ColumnNames
{
public:
    explicit ColumnNames(const ColumnMapping& mapping) : m_mapping(mapping) {}

    /** Returns the use of a column, or nullopt if it has none. */
    [[nodiscard]] std::optional<FieldUse> of(const std::string& column);
    /** Returns the queried names that have no use. */
    [[nodiscard]] std::vector<std::string> unknown() const;
    /** Throws `Error{InvalidInput}` for mapped columns that were never queried. */
    void requireMapped(const std::string& subject) const;

private:
    [[nodiscard]] std::optional<FieldUse> find(const std::string& column);

    const ColumnMapping& m_mapping;
    std::set<std::string> m_found; ///< mapped columns that were found
    std::map<std::string, std::optional<FieldUse>> m_known;
};

/** Texts of one row or feature by field. */
class FieldTexts
{
public:
    void clear();
    /**
     * Sets the text, cut to 500 bytes, unless a column that fits as well or better has set one
     * already; blank texts are ignored. A text for the id is added to `ids` too.
     */
    void set(const FieldUse& use, std::string_view text);
    void set(SightingField field, std::string_view text) { set(FieldUse{.field = field}, text); }
    /** Appends minutes, seconds or the letter of the hemisphere to a text that is not empty. */
    void append(const PlacePart& part, std::string_view text);
    /** Adds an offset from UTC to the time, unless it has its own. */
    void setZone(std::chrono::minutes offset)
    {
        std::string& time = m_entries[static_cast<std::size_t>(SightingField::Time)].text;
        if (!time.empty())
            time = withZone(time, offset);
    }
    void drop(SightingField field) { m_entries[static_cast<std::size_t>(field)] = {}; }
    [[nodiscard]] const std::string& text(SightingField field) const { return at(field).text; }
    [[nodiscard]] double factor(SightingField field) const { return at(field).factor; }
    [[nodiscard]] bool isAis(SightingField field) const { return at(field).isAis; }
    /**
     * Returns the texts that were set as ids, the first of each rank, in the order of the ranks.
     */
    [[nodiscard]] const std::vector<IdText>& ids() const { return m_ids; }

private:
    struct Entry
    {
        std::string text; ///< without surrounding blanks
        double factor = 1;
        std::size_t rank = 0;
        bool isAis = false;
    };
    void addId(std::size_t rank, std::string_view text);
    [[nodiscard]] const Entry& at(SightingField field) const
    {
        return m_entries[static_cast<std::size_t>(field)];
    }

    std::array<Entry, kFieldCount> m_entries;
    std::vector<IdText> m_ids;
};

/**
 * Returns the sighting that the texts describe, or why there is none; both have `line`. An optional
 * value, a time or an id that cannot be used as it is does not reject the place: it is left out or
 * changed, and noted.
 */
[[nodiscard]] std::variant<Sighting, RejectedRow>
sightingOf(const FieldTexts& texts, const RowRules& rules, std::size_t line);

/**
 * Returns the sighting of a row with date and time in one text. Records in the table whether the
 * date shows the order of all dates, or is ambiguous.
 */
[[nodiscard]] std::variant<Sighting, RejectedRow> sightingIn(SightingTable& table,
                                                             const ImportText& source,
                                                             const FieldTexts& texts,
                                                             std::size_t line, bool timeNeeded);

/** Components of a drift over ground in the plane, m/s, as Bergwatch exports write them. */
struct DriftTexts
{
    std::string east;
    std::string north;
};
/**
 * Returns the row with its drift; a drift that cannot be read is left out and noted in the table.
 */
[[nodiscard]] std::variant<Sighting, RejectedRow>
withDrift(SightingTable& table, std::variant<Sighting, RejectedRow> row, const DriftTexts& drift);

/**
 * Returns the change of drift whose values `numberOf` finds by the names of Bergwatch exports, or
 * nullopt if there is none; values out of range are ignored.
 */
template <class NumberOf>
[[nodiscard]] std::optional<SightedDriftChange> changeOf(const NumberOf& numberOf)
{
    const auto read = [&](const char* name, const Limits& limits) {
        const std::optional<double> value = numberOf(name);
        return value && !outOfLimits(*value, limits) ? *value : 0.0;
    };
    const SightedDriftChange change{.velocitySd_mps = read("velocity_sd_mps", limits::kSpeed_mps),
                                    .velocitySpread_mps =
                                        read("velocity_spread_mps", limits::kSpeed_mps),
                                    .velocityTime_s = read("velocity_time_s", limits::kTime_s)};
    const bool isThere = change.velocitySd_mps > 0 || change.velocityTime_s > 0;
    return isThere ? std::optional(change) : std::nullopt;
}

/**
 * Returns date and time of day from one text or from two; empty if `timeApart` and one is missing.
 */
[[nodiscard]] std::string timeText(const FieldTexts& texts, bool timeApart);

/**
 * Reads a number in the C locale or with a decimal comma; returns nullopt for anything else,
 * including NaN.
 */
[[nodiscard]] std::optional<double> decimalOf(std::string_view text);

/**
 * Returns UTF-8 without surrounding blanks, cut to `most` bytes, and without the apostrophe that
 * keeps spreadsheets from running it as a formula. Control characters become blanks; in a text that
 * is not UTF-8 every byte above 127 becomes "?".
 */
[[nodiscard]] std::string cleanText(std::string_view given, std::size_t most);

/**
 * Returns the start of a long text and a hash of its first 4096 bytes, together at most `most`
 * bytes (at least 10), so that two texts that differ within these bytes stay distinct.
 */
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most);

/** Returns the text without surrounding blanks. */
[[nodiscard]] std::string_view trimmed(std::string_view text);

/**
 * Returns the ASCII letters, in lower case, and digits of a name, for comparisons: "Length (NM)"
 * gives "lengthnm"; ² counts as 2.
 */
[[nodiscard]] std::string plainName(std::string_view name);

/** Adds a sighting or rejected row to the table and charges the budget. */
void addRow(SightingTable& table, std::variant<Sighting, RejectedRow> row, ReadBudget& budget);

/**
 * Numbers the tracks of one file (`Sighting::track`) and names those without an id, all
 * differently: "track", their first time, a number.
 */
class TrackIds
{
public:
    /** Marks the rows from `first` on as one track. */
    void give(SightingTable& table, std::size_t first);

private:
    std::uint32_t m_tracks = 0;
    std::map<std::string, int> m_numbers;
};

} // namespace berg
