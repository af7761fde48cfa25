#pragma once

// Private to core/io: from the texts of one row or feature to a sighting, for every format.

#include "core/io/import/import_formats.h"
#include "core/scenario/checks.h"

#include <map>
#include <set>
#include <variant>

namespace berg {

inline constexpr std::size_t kFieldCount = kSightingFieldNames.size();

/** How a column is taken: the field, the factor to SI units and how well the name fits. */
struct FieldUse
{
    SightingField field = SightingField::Id;
    double factor = 1;
    std::size_t rank = 0; ///< of several columns for one field the lowest serves
};

/** Field that a column of this name holds by the customs of the trade; none for any other name. */
[[nodiscard]] std::optional<FieldUse> fieldOfColumn(std::string_view name);

/** A column that holds a part of a latitude or longitude whose degrees have one of their own. */
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

/** "lat_min" holds minutes of the latitude, "E/W" the hemisphere; none for any other name. */
[[nodiscard]] std::optional<PlacePart> placePartOf(std::string_view name);

/** Date or time whose column this would be but for what follows, as "time (EST)"; none else. */
[[nodiscard]] std::optional<SightingField> unclearTimeOf(std::string_view name);

/** The columns of one file: those mapped explicitly, and guesses for the fields left. */
class ColumnNames
{
public:
    explicit ColumnNames(const ColumnMapping& mapping) : m_mapping(mapping) {}

    /** What the column serves as. */
    [[nodiscard]] std::optional<FieldUse> of(const std::string& column);
    /** Throws `Error{InvalidInput}` for mapped columns that nobody has asked for. */
    void requireMapped(const std::string& subject) const;

private:
    [[nodiscard]] std::optional<FieldUse> find(const std::string& column);

    const ColumnMapping& m_mapping;
    std::set<std::string> m_found; ///< of the mapped ones
    std::map<std::string, std::optional<FieldUse>> m_known;
};

/** Texts of one row or feature by field. */
class FieldTexts
{
public:
    void clear();
    /** Taken unless a column that fits better has given one that is not blank. */
    void set(const FieldUse& use, std::string_view text);
    void set(SightingField field, std::string_view text) { set(FieldUse{.field = field}, text); }
    /** Behind what the field has: minutes, seconds or the letter of the hemisphere. */
    void append(const PlacePart& part, std::string_view text);
    void drop(SightingField field) { m_entries[static_cast<std::size_t>(field)] = {}; }
    [[nodiscard]] const std::string& text(SightingField field) const { return at(field).text; }
    [[nodiscard]] double factor(SightingField field) const { return at(field).factor; }

private:
    struct Entry
    {
        std::string text; ///< without blanks around it
        double factor = 1;
        std::size_t rank = 0;
    };
    [[nodiscard]] const Entry& at(SightingField field) const
    {
        return m_entries[static_cast<std::size_t>(field)];
    }

    std::array<Entry, kFieldCount> m_entries;
};

/** The sighting that the texts describe, or why there is none; `line` is set in both. */
[[nodiscard]] std::variant<Sighting, RejectedRow>
sightingOf(const FieldTexts& texts, const RowRules& rules, std::size_t line);

/** The same of a row whose date and time are not apart; notes in the table whether the date shows
 * the order of all, or has two readings. */
[[nodiscard]] std::variant<Sighting, RejectedRow> sightingIn(SightingTable& table,
                                                             const ImportText& source,
                                                             const FieldTexts& texts,
                                                             std::size_t line, bool timeNeeded);

/** Components of a drift over ground in the plane, m/s, as exports of our own write them. */
struct DriftTexts
{
    std::string east;
    std::string north;
};
/** A row with its drift; rejected when that is out of range. Without either text as it is. */
[[nodiscard]] std::variant<Sighting, RejectedRow> withDrift(std::variant<Sighting, RejectedRow> row,
                                                            const DriftTexts& drift);

/** What `numberOf` finds by the names that exports of our own give it; none of it out of range. */
template <class NumberOf>
[[nodiscard]] std::optional<SightedChange> changeOf(const NumberOf& numberOf)
{
    const auto read = [&](const char* name, const Limits& limits) {
        const std::optional<double> value = numberOf(name);
        return value && !outOfLimits(*value, limits) ? *value : 0.0;
    };
    const SightedChange change{.velocitySd_mps = read("velocity_sd_mps", limits::kSpeed_mps),
                               .velocitySpread_mps =
                                   read("velocity_spread_mps", limits::kSpeed_mps),
                               .velocityTime_s = read("velocity_time_s", limits::kTime_s)};
    const bool isThere = change.velocitySd_mps > 0 || change.velocityTime_s > 0;
    return isThere ? std::optional(change) : std::nullopt;
}

/** Date and time of day from one text, or from two; with `timeApart` neither may be missing. */
[[nodiscard]] std::string timeText(const FieldTexts& texts, bool timeApart);

/** Number in the C locale or with a decimal comma; none for anything else, and for NaN. */
[[nodiscard]] std::optional<double> decimalOf(std::string_view text);

/** UTF-8 without control characters and blanks around it, cut to `most` bytes; without the
 * apostrophe that keeps spreadsheets from running it as a formula. */
[[nodiscard]] std::string cleanText(std::string_view given, std::size_t most);

/** Without blanks on either side. */
[[nodiscard]] std::string_view trimmed(std::string_view text);

/** Small letters and digits of a name, for comparing: "Length (NM)" is "lengthnm". */
[[nodiscard]] std::string plainName(std::string_view name);

/** Adds what was read of a row to the table. */
void addRow(SightingTable& table, std::variant<Sighting, RejectedRow> row, ReadBudget& budget);

/** Ids of the tracks of one file that have none, each another: "track", its first time, a number.
 */
class TrackIds
{
public:
    /** Of the rows from `first` on, those of one track. */
    void give(SightingTable& table, std::size_t first);

private:
    std::map<std::string, int> m_numbers;
};

/**
 * Of rows without ids: where each has a name, and not all the same, the name is the id; else, at
 * different times, they are the track of one beacon (`oneIceberg`).
 */
void decideIdentity(SightingTable& table);

} // namespace berg
