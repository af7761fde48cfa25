#include "core/base/error.h"
#include "core/io/import/import_fields.h"

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

constexpr double kNauticalMile_m = 1852;
constexpr double kKnot_mps = kNauticalMile_m / 3600;

constexpr std::array kNoUnits = {Unit{""}};
constexpr std::array kDegrees = {Unit{""}, Unit{"deg"}, Unit{"degrees"}, Unit{"dd"}};
constexpr std::array kClock = {Unit{""}, Unit{"utc"}, Unit{"gmt"}, Unit{"z"}, Unit{"data"}};
constexpr std::array kSpeeds = {Unit{""},
                                Unit{"mps"},
                                Unit{"ms"},
                                Unit{"kn", kKnot_mps},
                                Unit{"kt", kKnot_mps},
                                Unit{"kts", kKnot_mps},
                                Unit{"knots", kKnot_mps},
                                Unit{"kmh", 1 / 3.6},
                                Unit{"cms", 0.01}};
/** Of AIS and NMEA. */
constexpr auto kSpeedsOverGround = [] {
    auto units = kSpeeds;
    units[0].factor = kKnot_mps;
    return units;
}();
constexpr std::array kLengths = {Unit{""},
                                 Unit{"m"},
                                 Unit{"km", 1000},
                                 Unit{"nm", kNauticalMile_m},
                                 Unit{"nmi", kNauticalMile_m},
                                 Unit{"ft", 0.3048}};
constexpr std::array kAreas = {Unit{""}, Unit{"m2"}, Unit{"km2", 1e6}};
constexpr std::array kVariances = {Unit{""}, Unit{"m2"}};
constexpr std::array kGrowths = {Unit{""}, Unit{"m2ps"}};

/** Names of the columns that hold a field, the best first, and the units they may end with. */
struct Custom
{
    SightingField field;
    std::span<const Unit> units;
    std::initializer_list<std::string_view> names;
};

std::span<const Custom> customs()
{
    using enum SightingField;
    static const std::array kCustoms = {
        Custom{Id,
               kNoUnits,
               {"id", "icebergid", "bergid", "icebergnumber", "bergnumber", "beaconid", "iceberg",
                "berg", "beacon", "number", "imei", "platformid"}},
        Custom{Name, kNoUnits, {"name", "icebergname", "label", "title"}},
        Custom{Date, kClock, {"date", "sightingdate"}},
        Custom{Time,
               kClock,
               {"datetime", "timestamp", "time", "sightingtime", "observed", "observedat",
                "lastupdate", "acquisitiontime", "begin", "when", "basedatetime"}},
        Custom{Latitude, kDegrees, {"latitude", "lat", "sightinglatitude"}},
        Custom{Longitude, kDegrees, {"longitude", "lon", "long", "lng", "sightinglongitude"}},
        Custom{Speed, kSpeeds, {"speed", "driftspeed"}},
        Custom{Speed, kSpeedsOverGround, {"sog"}},
        Custom{Direction, kDegrees, {"direction", "driftdirection", "course", "cog", "bearing"}},
        Custom{Sigma, kVariances, {"sigma", "sigma0", "variance"}},
        Custom{Growth, kGrowths, {"q", "growth"}},
        Custom{Length, kLengths, {"length", "maxlength", "iabln"}},
        Custom{Radius, kLengths, {"radius"}},
        Custom{Area, kAreas, {"area", "brgare"}},
        Custom{SizeClass, kNoUnits, {"size", "sizeclass"}},
        Custom{Remarks, kNoUnits, {"remarks", "remark"}}};
    return kCustoms;
}

const Custom& customOf(SightingField field)
{
    return *std::find_if(customs().begin(), customs().end(),
                         [&](const Custom& custom) { return custom.field == field; });
}

/** Whether the plain name ends with these letters, and something else is in front of them in the
 * name itself: "Draft" is not in feet. */
bool endsWithWord(std::string_view name, std::string_view word)
{
    if (!plainName(name).ends_with(word))
        return false;
    std::size_t at = name.size();
    for (std::size_t left = word.size(); left > 0;)
        left -= plainName(name.substr(--at, 1)).size();
    return at > 0 && std::string_view(" _([/-.,:").find(name[at - 1]) != std::string_view::npos;
}

/** Factor of the unit that a column's name ends with; the customary one without. */
double unitFactor(SightingField field, std::string_view name)
{
    if (const std::optional<FieldUse> guess = fieldOfColumn(name); guess && guess->field == field)
        return guess->factor;
    double factor = 1;
    std::size_t longest = 0;
    for (const Unit& unit : customOf(field).units)
        if (unit.suffix.size() > longest && endsWithWord(name, unit.suffix)) {
            longest = unit.suffix.size();
            factor = unit.factor;
        }
    return factor;
}

} // namespace

std::string plainName(std::string_view name)
{
    std::string plain;
    for (const char c : name) {
        if (c >= 'A' && c <= 'Z')
            plain += static_cast<char>(c - 'A' + 'a');
        else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))
            plain += c;
    }
    return plain;
}

std::optional<FieldUse> fieldOfColumn(std::string_view name)
{
    const std::string plain = plainName(name);
    std::size_t rank = 0;
    for (const Custom& custom : customs()) {
        for (const std::string_view known : custom.names) {
            ++rank;
            if (!plain.starts_with(known))
                continue;
            const std::string_view rest = std::string_view(plain).substr(known.size());
            for (const Unit& unit : custom.units)
                if (rest == unit.suffix)
                    return FieldUse{.field = custom.field, .factor = unit.factor, .rank = rank};
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
        if (plain == axis.letters)
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
    const std::size_t end = name.find_first_of(" _([/-.,:");
    if (end == std::string_view::npos || fieldOfColumn(name))
        return std::nullopt;
    const std::optional<FieldUse> use = fieldOfColumn(name.substr(0, end));
    const bool isTime =
        use && (use->field == SightingField::Time || use->field == SightingField::Date);
    return isTime ? std::optional(use->field) : std::nullopt;
}

std::optional<FieldUse> ColumnNames::of(const std::string& column)
{
    const auto it = m_known.find(column);
    if (it != m_known.end())
        return it->second;
    // A file with a new name in every feature must not make this grow without end.
    if (m_known.size() >= kMostColumns)
        return find(column);
    return m_known.emplace(column, find(column)).first->second;
}

std::optional<FieldUse> ColumnNames::find(const std::string& column)
{
    for (const FieldColumn& mapped : m_mapping)
        if (mapped.column == column) {
            m_found.insert(column);
            return FieldUse{.field = mapped.field, .factor = unitFactor(mapped.field, column)};
        }
    const std::optional<FieldUse> guess = fieldOfColumn(column);
    const bool taken =
        guess && std::any_of(m_mapping.begin(), m_mapping.end(), [&](const FieldColumn& mapped) {
            return mapped.field == guess->field;
        });
    return taken ? std::nullopt : guess;
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
