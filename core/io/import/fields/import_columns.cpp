#include "core/base/error.h"
#include "core/base/knots.h"
#include "core/base/unit_names.h"
#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/time_columns.h"

#include <algorithm>
#include <initializer_list>
#include <span>

namespace berg {

namespace {

struct Unit
{
    std::string_view suffix;
    double factor = 1;
};

constexpr std::array kNoUnits = {Unit{""}};
constexpr std::array kDegrees = {Unit{""},
                                 Unit{"deg"},
                                 Unit{"degrees"},
                                 Unit{"dd"},
                                 Unit{"decdeg"},
                                 Unit{"decimal"},
                                 Unit{"decimaldegrees"},
                                 Unit{"decimaldegree"},
                                 Unit{"degreesnorth"},
                                 Unit{"degreenorth"},
                                 Unit{"degreesn"},
                                 Unit{"degreen"},
                                 Unit{"degnorth"},
                                 Unit{"degn"},
                                 Unit{"degreeseast"},
                                 Unit{"degreeeast"},
                                 Unit{"degreese"},
                                 Unit{"degreee"},
                                 Unit{"degeast"},
                                 Unit{"dege"},
                                 Unit{"wgs84"}};
constexpr std::array kClock = {Unit{""}, Unit{"utc"}, Unit{"gmt"}, Unit{"z"}, Unit{"data"}};
/** Endings of names of id columns. */
constexpr std::array kIdEndings = {Unit{""},    Unit{"id"},     Unit{"no"},  Unit{"nr"},
                                   Unit{"num"}, Unit{"number"}, Unit{"code"}};
// Grouped by `IdTrust`, in order of precedence.
const std::initializer_list<std::string_view> kIcebergIds = {"iceberg", "berg", "isfjell",
                                                             "isbjerg", "eisberg"};
const std::initializer_list<std::string_view> kTrackerIds = {
    "id",     "beacon",  "imei",       "mmsi",       "esn", "buoy", "drifter", "argos",
    "target", "tracker", "trajectory", "instrument", "wmo", "tag",  "ptt",     "transponder"};
const std::initializer_list<std::string_view> kWeakIds = {
    "track",   "contact", "device", "platform", "reference", "ref",
    "feature", "number",  "no",     "nr",       "num"};

/** Names of the columns for a field, the best first, and the units that may follow them. */
struct ColumnPattern
{
    SightingField field;
    std::span<const Unit> units;
    std::initializer_list<std::string_view> names;
    std::optional<Dimension> dimension = {}; ///< its units may follow, too
    double factor = 1;                       ///< factor without a unit
    bool isAis = false;
};

std::span<const ColumnPattern> columnPatterns()
{
    using enum SightingField;
    static const std::array kPatterns = {
        ColumnPattern{Id, kIdEndings, kIcebergIds},
        ColumnPattern{Id, kIdEndings, kTrackerIds},
        ColumnPattern{Id, kIdEndings, kWeakIds},
        ColumnPattern{Name, kNoUnits, {"name", "icebergname", "label", "title"}},
        ColumnPattern{Date, kClock, {"date", "sightingdate", "utcdate", "gpsdate"}},
        ColumnPattern{Time,
                      kClock,
                      {"datetime",
                       "timestamp",
                       "time",
                       "sightingtime",
                       "observed",
                       "observedat",
                       "lastupdate",
                       "acquisitiontime",
                       "begin",
                       "when",
                       "basedatetime",
                       "utctime",
                       "utc",
                       "utcdatetime",
                       "gpstime",
                       "fixtime",
                       "dateandtime",
                       "obstime",
                       "observationtime",
                       "tid",
                       "tidspunkt",
                       "zeit"}},
        ColumnPattern{Latitude,
                      kDegrees,
                      {"latitude", "lat", "sightinglatitude", "poslat", "breddegrad", "bredde",
                       "breite", "breitengrad"}},
        ColumnPattern{Longitude,
                      kDegrees,
                      {"longitude", "lon", "long", "lng", "sightinglongitude", "poslon",
                       "lengdegrad", "lengde", "lngdegrad", "lngde", "lnge", "lngengrad"}},
        ColumnPattern{Speed, kNoUnits, {"speed", "driftspeed"}, Dimension::Speed},
        ColumnPattern{Speed, kNoUnits, {"sog"}, Dimension::Speed, kKnot_mps}, // as in AIS and NMEA
        ColumnPattern{Direction,
                      kNoUnits,
                      {"direction", "driftdirection", "drifttowards", "towards", "bearing"},
                      Dimension::Angle},
        ColumnPattern{Direction, kNoUnits, {"course", "cog"}, Dimension::Angle, 1, true},
        ColumnPattern{Sigma, kNoUnits, {"sigma", "sigma0", "variance"}, Dimension::Area},
        ColumnPattern{Growth, kNoUnits, {"q", "growth"}, Dimension::Growth},
        ColumnPattern{Length, kNoUnits, {"length", "maxlength", "iabln"}, Dimension::Length},
        ColumnPattern{Radius, kNoUnits, {"radius"}, Dimension::Length},
        ColumnPattern{Area, kNoUnits, {"area", "brgare"}, Dimension::Area},
        ColumnPattern{SizeClass, kNoUnits, {"size", "sizeclass"}},
        ColumnPattern{Remarks, kNoUnits, {"remarks", "remark"}},
        ColumnPattern{
            Source, kNoUnits, {"positionsource", "sightingmethod", "method", "sensor", "source"}}};
    return kPatterns;
}

/**
 * Returns the factor for a column whose plain name has this ending after a known name, or nullopt
 * if the ending is not a unit of the field.
 */
std::optional<double> factorOf(const ColumnPattern& pattern, std::string_view ending)
{
    if (ending.empty())
        return pattern.factor;
    for (const Unit& unit : pattern.units)
        if (ending == unit.suffix)
            return unit.factor;
    if (pattern.dimension)
        for (const NamedUnit& unit : namedUnits())
            for (const std::string_view name : unit.names)
                if (unit.dimension == *pattern.dimension && ending == plainName(name))
                    return unit.inSi;
    return std::nullopt;
}

const ColumnPattern& patternOf(SightingField field)
{
    return *std::find_if(columnPatterns().begin(), columnPatterns().end(),
                         [&](const ColumnPattern& pattern) { return pattern.field == field; });
}

/** Whether the plain name ends with these letters as a separate word: "Draft" is not in feet. */
bool endsWithWord(std::string_view name, std::string_view word)
{
    if (!plainName(name).ends_with(word))
        return false;
    std::size_t at = name.size();
    for (std::size_t left = word.size(); left > 0;)
        left -= plainName(name.substr(--at, 1)).size();
    return at > 0 && std::string_view(" _([/-.,:").find(name[at - 1]) != std::string_view::npos;
}

/** Returns the factor of the unit at the end of a column's name, or that of the usual unit. */
double unitFactor(SightingField field, std::string_view name)
{
    if (const std::optional<FieldUse> guess = fieldOfColumn(name); guess && guess->field == field)
        return guess->factor;
    double factor = 1;
    std::size_t longest = 0;
    for (const NamedUnit& unit : namedUnits())
        for (const std::string_view written : unit.names) {
            const std::string word = plainName(written);
            if (unit.dimension == patternOf(field).dimension && word.size() > longest &&
                endsWithWord(name, word)) {
                longest = word.size();
                factor = unit.inSi;
            }
        }
    return factor;
}

/**
 * Returns the use of a time column with a zone, such as "time (UTC-3)", or nullopt for any other
 * name.
 */
std::optional<FieldUse> zonedTime(std::string_view name)
{
    const std::size_t sign = name.find_last_of("+-");
    if (sign == std::string_view::npos || sign + 1 == name.size())
        return std::nullopt;
    std::size_t start = std::string_view::npos;
    for (std::size_t i = 0; i + 3 <= sign; ++i)
        if (const std::string word = plainName(name.substr(i, 3)); word == "utc" || word == "gmt")
            start = i;
    if (start == std::string_view::npos)
        return std::nullopt;
    const std::size_t end = name.find_last_not_of(" )]");
    const auto offset = parseZone(name.substr(start, end - start + 1));
    std::optional<FieldUse> use = fieldOfColumn(name.substr(0, start));
    if (!offset || !use || (use->field != SightingField::Time && use->field != SightingField::Date))
        return std::nullopt;
    use->offset = offset;
    return use;
}

} // namespace

std::string plainName(std::string_view name)
{
    constexpr std::string_view kSquare = "\u00B2";
    std::string plain;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const char c = name[i];
        if (name.substr(i, kSquare.size()) == kSquare)
            plain += '2';
        else if (c >= 'A' && c <= 'Z')
            plain += static_cast<char>(c - 'A' + 'a');
        else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))
            plain += c;
    }
    return plain;
}

IdTrust idTrust(std::size_t rank)
{
    if (rank <= kIcebergIds.size())
        return IdTrust::Iceberg;
    return rank <= kIcebergIds.size() + kTrackerIds.size() ? IdTrust::Tracker : IdTrust::Weak;
}

std::optional<FieldUse> fieldOfColumn(std::string_view name)
{
    if (const std::optional<FieldUse> zoned = zonedTime(name))
        return zoned;
    const std::string plain = plainName(name);
    std::size_t rank = 0;
    for (const ColumnPattern& pattern : columnPatterns()) {
        for (const std::string_view known : pattern.names) {
            ++rank;
            if (!plain.starts_with(known))
                continue;
            const std::string_view rest = std::string_view(plain).substr(known.size());
            if (const std::optional<double> factor = factorOf(pattern, rest))
                return FieldUse{.field = pattern.field,
                                .factor = *factor,
                                .rank = rank,
                                .isAis = pattern.isAis};
        }
    }
    return std::nullopt;
}

std::optional<PlacePart> placePartOf(std::string_view name)
{
    using enum PlacePart::Kind;
    struct Axis
    {
        SightingField field;
        std::initializer_list<std::string_view> names;
        std::string_view letters;
    };
    static const std::array kAxes = {
        Axis{SightingField::Latitude, {"latitude", "lat"}, "ns"},
        Axis{SightingField::Longitude, {"longitude", "long", "lon", "lng"}, "ew"}};
    static const std::map<std::string_view, PlacePart::Kind> kKinds{
        {"min", Minutes},    {"mins", Minutes},        {"minutes", Minutes},
        {"sec", Seconds},    {"secs", Seconds},        {"seconds", Seconds},
        {"hem", Hemisphere}, {"hemi", Hemisphere},     {"hemisphere", Hemisphere},
        {"dir", Hemisphere}, {"direction", Hemisphere}};
    const std::string plain = plainName(name);
    for (const Axis& axis : kAxes) {
        if (plain.starts_with(axis.letters))
            if (const std::string_view rest = std::string_view(plain).substr(2);
                rest.empty() || rest == "ind" || rest == "indicator" || rest == "hem" ||
                rest == "hemisphere")
                return PlacePart{axis.field, Hemisphere};
        for (const std::string_view known : axis.names) {
            if (!plain.starts_with(known))
                continue;
            const std::string_view rest = std::string_view(plain).substr(known.size());
            if (rest == axis.letters)
                return PlacePart{axis.field, Hemisphere};
            if (const auto kind = kKinds.find(rest); kind != kKinds.end())
                return PlacePart{axis.field, kind->second};
        }
    }
    return std::nullopt;
}

std::optional<SightingField> unclearTimeOf(std::string_view name)
{
    constexpr std::string_view kBetween = " _([/-.,:";
    const std::size_t end = name.find_first_of(kBetween);
    if (end == std::string_view::npos || fieldOfColumn(name) || timePartOf(name))
        return std::nullopt;
    const std::optional<FieldUse> use = fieldOfColumn(name.substr(0, end));
    if (use && (use->field == SightingField::Time || use->field == SightingField::Date))
        return use->field;
    const std::string last = plainName(name.substr(name.find_last_of(kBetween) + 1));
    if (last == "time" || last == "datetime" || last == "timestamp")
        return SightingField::Time;
    return last == "date" ? std::optional(SightingField::Date) : std::nullopt;
}

std::optional<FieldUse> ColumnNames::of(const std::string& column)
{
    const auto it = m_known.find(column);
    if (it != m_known.end())
        return it->second;
    // A file with a new name in every feature must not let this grow without limit.
    if (m_known.size() >= kMostColumns)
        return find(column);
    return m_known.emplace(column, find(column)).first->second;
}

std::optional<FieldUse> ColumnNames::find(const std::string& column)
{
    for (const FieldColumn& mapped : m_mapping)
        if (mapped.column == column) {
            m_found.insert(column);
            const std::optional<FieldUse> guess = fieldOfColumn(column);
            return FieldUse{.field = mapped.field,
                            .factor = unitFactor(mapped.field, column),
                            .isAis = guess && guess->isAis,
                            .offset = guess ? guess->offset : std::nullopt};
        }
    const std::optional<FieldUse> guess = fieldOfColumn(column);
    const bool taken =
        guess && std::any_of(m_mapping.begin(), m_mapping.end(), [&](const FieldColumn& mapped) {
            return mapped.field == guess->field;
        });
    return taken ? std::nullopt : guess;
}

std::vector<std::string> ColumnNames::unknown() const
{
    std::vector<std::string> names;
    for (const auto& [name, use] : m_known)
        if (!use)
            names.push_back(name);
    return names;
}

void ColumnNames::requireMapped(const std::string& subject) const
{
    std::vector<Issue> issues;
    for (const FieldColumn& mapped : m_mapping)
        if (!m_found.contains(mapped.column))
            issues.push_back({Severity::Error,
                              nameOf(kSightingFieldNames, mapped.field),
                              {IssueId::NoSuchColumn, {printable(mapped.column)}}});
    if (!issues.empty())
        throw Error(ErrorCode::InvalidInput, subject, std::move(issues));
}

} // namespace berg
