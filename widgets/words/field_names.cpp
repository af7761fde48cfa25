#include "widgets/words/field_names.h"

#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <cmath>
#include <string_view>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct FieldNames
{
    Q_DECLARE_TR_FUNCTIONS(FieldNames)
};

enum class Quantity
{
    Text,
    Number,
    Metres, ///< in any case
    Distance,
    Speed,
    Seconds,
    Degrees,
    Variance,
    Growth
};

/** Labels are those of the inputs: their translations are in the context of these. */
struct FieldName
{
    std::string_view field;
    const char* label;
    Quantity quantity = Quantity::Text;
    const char* context = "InspectorRows";
};

constexpr FieldName kFields[] = {
    {"name", QT_TRANSLATE_NOOP("InspectorRows", "Name")},
    {"notes", QT_TRANSLATE_NOOP("InspectorRows", "Notes")},
    {"origin.latitude_deg", QT_TRANSLATE_NOOP("InspectorRows", "Latitude"), Quantity::Degrees},
    {"origin.longitude_deg", QT_TRANSLATE_NOOP("InspectorRows", "Longitude"), Quantity::Degrees},
    {"duration_s", QT_TRANSLATE_NOOP("InspectorRows", "Duration"), Quantity::Seconds},
    {"dt_s", QT_TRANSLATE_NOOP("InspectorRows", "Time step"), Quantity::Seconds},
    {"seed", QT_TRANSLATE_NOOP("InspectorRows", "Seed"), Quantity::Number},
    {"separation_m", QT_TRANSLATE_NOOP("InspectorRows", "Separation"), Quantity::Distance},
    {"area_m", QT_TRANSLATE_NOOP("FieldNames", "Corner of the area"), Quantity::Distance,
     "FieldNames"},
    {"current_mps[0]", QT_TRANSLATE_NOOP("InspectorRows", "Current east"), Quantity::Speed},
    {"current_mps[1]", QT_TRANSLATE_NOOP("InspectorRows", "Current north"), Quantity::Speed},
    // Findings about a UAV as a whole tell times.
    {"uavs", QT_TRANSLATE_NOOP("OperationPage", "UAV"), Quantity::Seconds, "OperationPage"},
    {"uavs.name", QT_TRANSLATE_NOOP("InspectorRows", "Name")},
    {"uavs.id", QT_TRANSLATE_NOOP("berg::InspectorPanel", "Id"), Quantity::Text,
     "berg::InspectorPanel"},
    {"uavs.position_m[0]", QT_TRANSLATE_NOOP("InspectorRows", "East"), Quantity::Distance},
    {"uavs.position_m[1]", QT_TRANSLATE_NOOP("InspectorRows", "North"), Quantity::Distance},
    {"uavs.heading_deg", QT_TRANSLATE_NOOP("InspectorRows", "Heading"), Quantity::Degrees},
    {"uavs.airspeed_mps", QT_TRANSLATE_NOOP("InspectorRows", "Airspeed"), Quantity::Speed},
    {"uavs.max_bank_deg", QT_TRANSLATE_NOOP("InspectorRows", "Maximum bank angle"),
     Quantity::Degrees},
    {"uavs.fov_m[0]", QT_TRANSLATE_NOOP("InspectorRows", "View along-track"), Quantity::Metres},
    {"uavs.fov_m[1]", QT_TRANSLATE_NOOP("InspectorRows", "View cross-track"), Quantity::Metres},
    {"uavs.altitude_m", QT_TRANSLATE_NOOP("InspectorRows", "Altitude"), Quantity::Metres},
    {"uavs.endurance_s", QT_TRANSLATE_NOOP("InspectorRows", "Endurance"), Quantity::Seconds},
    {"uavs.home_m[0]", QT_TRANSLATE_NOOP("InspectorRows", "Home east"), Quantity::Distance},
    {"uavs.home_m[1]", QT_TRANSLATE_NOOP("InspectorRows", "Home north"), Quantity::Distance},
    {"uavs.turnaround_s", QT_TRANSLATE_NOOP("InspectorRows", "Turn-around"), Quantity::Seconds},
    {"uavs.reserve_percent", QT_TRANSLATE_NOOP("InspectorRows", "Reserve"), Quantity::Number},
    {"uavs.reserve_s", QT_TRANSLATE_NOOP("InspectorRows", "Fixed reserve"), Quantity::Seconds},
    {"uavs.climb_s", QT_TRANSLATE_NOOP("InspectorRows", "Climb"), Quantity::Seconds},
    {"uavs.landing_s", QT_TRANSLATE_NOOP("InspectorRows", "Landing"), Quantity::Seconds},
    {"uavs.max_wind_mps", QT_TRANSLATE_NOOP("InspectorRows", "Wind limit"), Quantity::Speed},
    {"uavs.max_gust_mps", QT_TRANSLATE_NOOP("InspectorRows", "Gust limit"), Quantity::Speed},
    {"uavs.icing", QT_TRANSLATE_NOOP("InspectorRows", "Icing conditions")},
    {"uavs.autopilot_s", QT_TRANSLATE_NOOP("InspectorRows", "Autopilot rate"), Quantity::Seconds},
    {"icebergs.name", QT_TRANSLATE_NOOP("InspectorRows", "Name")},
    {"icebergs.id", QT_TRANSLATE_NOOP("berg::InspectorPanel", "Id"), Quantity::Text,
     "berg::InspectorPanel"},
    {"icebergs.position_m[0]", QT_TRANSLATE_NOOP("InspectorRows", "East"), Quantity::Distance},
    {"icebergs.position_m[1]", QT_TRANSLATE_NOOP("InspectorRows", "North"), Quantity::Distance},
    {"icebergs.velocity_mps[0]", QT_TRANSLATE_NOOP("InspectorRows", "Drift east"), Quantity::Speed},
    {"icebergs.velocity_mps[1]", QT_TRANSLATE_NOOP("InspectorRows", "Drift north"),
     Quantity::Speed},
    {"icebergs.velocity_sd_mps", QT_TRANSLATE_NOOP("InspectorRows", "Drift error"),
     Quantity::Speed},
    {"icebergs.velocity_spread_mps", QT_TRANSLATE_NOOP("InspectorRows", "Drift variation"),
     Quantity::Speed},
    {"icebergs.velocity_time_s", QT_TRANSLATE_NOOP("InspectorRows", "Drift changes in"),
     Quantity::Seconds},
    {"icebergs.q_m2ps", QT_TRANSLATE_NOOP("InspectorRows", "Growth q"), Quantity::Growth},
    {"icebergs.sigma0_m2", QT_TRANSLATE_NOOP("InspectorRows", "Uncertainty σ₀"),
     Quantity::Variance},
    {"icebergs.observed_s", QT_TRANSLATE_NOOP("InspectorRows", "Last seen"), Quantity::Seconds},
    {"icebergs.appears_s", QT_TRANSLATE_NOOP("InspectorRows", "Appears at"), Quantity::Seconds},
    {"icebergs.radius_m", QT_TRANSLATE_NOOP("InspectorRows", "Radius"), Quantity::Metres},
    {"icebergs.uav", QT_TRANSLATE_NOOP("InspectorRows", "Visited by")},
    {"icebergs.track.time_s", QT_TRANSLATE_NOOP("FieldNames", "Time of the recorded track"),
     Quantity::Seconds, "FieldNames"},
    {"icebergs.track.position_m", QT_TRANSLATE_NOOP("FieldNames", "Place of the recorded track"),
     Quantity::Distance, "FieldNames"},
    {"asset.name", QT_TRANSLATE_NOOP("InspectorRows", "Name")},
    {"asset.position_m[0]", QT_TRANSLATE_NOOP("InspectorRows", "East"), Quantity::Distance},
    {"asset.position_m[1]", QT_TRANSLATE_NOOP("InspectorRows", "North"), Quantity::Distance},
    {"asset.velocity_mps[0]", QT_TRANSLATE_NOOP("InspectorRows", "Speed east"), Quantity::Speed},
    {"asset.velocity_mps[1]", QT_TRANSLATE_NOOP("InspectorRows", "Speed north"), Quantity::Speed},
    {"asset.range_m", QT_TRANSLATE_NOOP("InspectorRows", "Range"), Quantity::Distance},
    {"asset.gain", QT_TRANSLATE_NOOP("InspectorRows", "Gain"), Quantity::Number},
    {"asset.alarm_m", QT_TRANSLATE_NOOP("InspectorRows", "Inner ring"), Quantity::Distance},
    {"asset.standoff_m", QT_TRANSLATE_NOOP("InspectorRows", "Stand-off ring"), Quantity::Distance},
    {"asset.standoff_ceiling_m", QT_TRANSLATE_NOOP("InspectorRows", "Stand-off ceiling"),
     Quantity::Metres},
    {"no_fly.name", QT_TRANSLATE_NOOP("InspectorRows", "Name")},
    {"no_fly.area_m", QT_TRANSLATE_NOOP("FieldNames", "Corner of the no-fly area"),
     Quantity::Distance, "FieldNames"},
    {"no_fly.floor_m", QT_TRANSLATE_NOOP("InspectorRows", "Floor"), Quantity::Metres},
    {"no_fly.ceiling_m", QT_TRANSLATE_NOOP("InspectorRows", "Ceiling"), Quantity::Metres},
    {"operation.margin_m", QT_TRANSLATE_NOOP("InspectorRows", "Margin"), Quantity::Metres},
    {"operation.span_m", QT_TRANSLATE_NOOP("InspectorRows", "UAV size"), Quantity::Metres},
    {"operation.position_error_m", QT_TRANSLATE_NOOP("InspectorRows", "Satellite position error"),
     Quantity::Metres},
    {"operation.path_error_m", QT_TRANSLATE_NOOP("InspectorRows", "Path-keeping error"),
     Quantity::Metres},
    {"operation.map_error_m", QT_TRANSLATE_NOOP("InspectorRows", "Map error"), Quantity::Metres},
    {"operation.reaction_s", QT_TRANSLATE_NOOP("InspectorRows", "Reaction time"),
     Quantity::Seconds},
    {"operation.turn_bank_deg", QT_TRANSLATE_NOOP("InspectorRows", "Bank of the turn back"),
     Quantity::Degrees},
    {"operation.height_error_m", QT_TRANSLATE_NOOP("InspectorRows", "Height error"),
     Quantity::Metres},
    {"operation.climb_part", QT_TRANSLATE_NOOP("InspectorRows", "Climb part"), Quantity::Number},
    {"operation.pull_up_part", QT_TRANSLATE_NOOP("InspectorRows", "Pull-up part"),
     Quantity::Number},
    {"operation.buffer_ratio", QT_TRANSLATE_NOOP("InspectorRows", "Buffer ratio"),
     Quantity::Number},
    {"operation.adjacent_s", QT_TRANSLATE_NOOP("InspectorRows", "Adjacent area, time"),
     Quantity::Seconds},
    {"operation.adjacent_least_m", QT_TRANSLATE_NOOP("InspectorRows", "Adjacent area, least"),
     Quantity::Metres},
    {"operation.adjacent_most_m", QT_TRANSLATE_NOOP("InspectorRows", "Adjacent area, most"),
     Quantity::Metres},
    {"operation.crew", QT_TRANSLATE_NOOP("InspectorRows", "Crew")},
    {"operation.call_sign", QT_TRANSLATE_NOOP("InspectorRows", "Call sign")},
    {"operation.contacts", QT_TRANSLATE_NOOP("InspectorRows", "Contacts")},
    {"operation.link", QT_TRANSLATE_NOOP("InspectorRows", "Command link")},
    {"operation.checklist", QT_TRANSLATE_NOOP("InspectorRows", "Checklist")},
    {"airspace", QT_TRANSLATE_NOOP("FieldNames", "Airspace"), Quantity::Text, "FieldNames"},
    {"airspace.name", QT_TRANSLATE_NOOP("InspectorRows", "Name")},
    {"airspace.area_m", QT_TRANSLATE_NOOP("FieldNames", "Corner of the airspace"), Quantity::Metres,
     "FieldNames"},
    {"airspace.floor_m", QT_TRANSLATE_NOOP("InspectorRows", "Floor"), Quantity::Metres},
    {"airspace.ceiling_m", QT_TRANSLATE_NOOP("InspectorRows", "Ceiling"), Quantity::Metres},
    {"airspace.from_utc", QT_TRANSLATE_NOOP("FieldNames", "Start of the airspace"), Quantity::Text,
     "FieldNames"},
    {"airspace.until_utc", QT_TRANSLATE_NOOP("FieldNames", "End of the airspace"), Quantity::Text,
     "FieldNames"},
    {"ground_station.position_m[0]", QT_TRANSLATE_NOOP("InspectorRows", "Station east"),
     Quantity::Distance},
    {"ground_station.position_m[1]", QT_TRANSLATE_NOOP("InspectorRows", "Station north"),
     Quantity::Distance},
    {"ground_station.antenna_m", QT_TRANSLATE_NOOP("InspectorRows", "Antenna height"),
     Quantity::Metres},
    {"ground_station.range_m", QT_TRANSLATE_NOOP("InspectorRows", "Link range"),
     Quantity::Distance},
    {"ground_station", QT_TRANSLATE_NOOP("InspectorRows", "Ground station")},
    {"weather.gust_mps", QT_TRANSLATE_NOOP("InspectorRows", "Gusts"), Quantity::Speed},
    {"weather.temperature_degc", QT_TRANSLATE_NOOP("InspectorRows", "Temperature"),
     Quantity::Number},
    {"weather.dew_point_degc", QT_TRANSLATE_NOOP("InspectorRows", "Dew point"), Quantity::Number},
    {"observer.position_sd_m", QT_TRANSLATE_NOOP("InspectorRows", "Position error"),
     Quantity::Metres},
    {"observer.interval_s", QT_TRANSLATE_NOOP("InspectorRows", "Sensor interval"),
     Quantity::Seconds},
    {"observer.detection", QT_TRANSLATE_NOOP("InspectorRows", "Detection probability"),
     Quantity::Number},
    {"planner.tau", QT_TRANSLATE_NOOP("FieldNames", "Trade-off τ"), Quantity::Number, "FieldNames"},
    {"planner.planning_delay_s", QT_TRANSLATE_NOOP("InspectorRows", "Planning time"),
     Quantity::Seconds},
    {"planner.reach_radius_m", QT_TRANSLATE_NOOP("InspectorRows", "Acceptance radius"),
     Quantity::Distance},
    // Options of the core, called as the dialogs for imports and exports call them.
    {"import.position error", QT_TRANSLATE_NOOP("InspectorRows", "Position error"),
     Quantity::Metres},
    {"import.drift variation", QT_TRANSLATE_NOOP("InspectorRows", "Drift variation"),
     Quantity::Speed},
    {"import.drift time", QT_TRANSLATE_NOOP("InspectorRows", "Drift changes in"),
     Quantity::Seconds},
    {"import.q", QT_TRANSLATE_NOOP("InspectorRows", "Growth q"), Quantity::Growth},
    {"import.area: south", QT_TRANSLATE_NOOP("FieldNames", "South"), Quantity::Degrees,
     "FieldNames"},
    {"import.area: north", QT_TRANSLATE_NOOP("FieldNames", "North"), Quantity::Degrees,
     "FieldNames"},
    {"import.area: west", QT_TRANSLATE_NOOP("FieldNames", "West"), Quantity::Degrees, "FieldNames"},
    {"import.area: east", QT_TRANSLATE_NOOP("FieldNames", "East"), Quantity::Degrees, "FieldNames"},
    {"import.at", QT_TRANSLATE_NOOP("FieldNames", "Start at"), Quantity::Text, "FieldNames"},
    {"import.since", QT_TRANSLATE_NOOP("FieldNames", "Not before"), Quantity::Text, "FieldNames"},
    {"import.until", QT_TRANSLATE_NOOP("FieldNames", "Not after"), Quantity::Text, "FieldNames"},
    {"import.origin", QT_TRANSLATE_NOOP("FieldNames", "Origin"), Quantity::Text, "FieldNames"},
    {"export.altitude", QT_TRANSLATE_NOOP("ExportText", "Altitude"), Quantity::Metres,
     "ExportText"},
    {"export.speed", QT_TRANSLATE_NOOP("ExportText", "Airspeed"), Quantity::Speed, "ExportText"},
    {"export.acceptance", QT_TRANSLATE_NOOP("ExportText", "Acceptance radius"), Quantity::Metres,
     "ExportText"},
    {"export.loiter", QT_TRANSLATE_NOOP("ExportText", "Loiter turns"), Quantity::Number,
     "ExportText"},
    {"export.what", QT_TRANSLATE_NOOP("ExportText", "What"), Quantity::Text, "ExportText"},
};

/** "icebergs[3].position_m[1]" is "icebergs.position_m[1]". */
std::string withoutEntry(const std::string& field)
{
    const std::size_t open = field.find('[');
    const std::size_t close = field.find(']');
    if (!field.starts_with("icebergs[") && !field.starts_with("uavs[") &&
        !field.starts_with("no_fly["))
        return field;
    return close == std::string::npos ? field : field.substr(0, open) + field.substr(close + 1);
}

/** "icebergs[3].q_m2ps" is "icebergs.q_m2ps". */
std::string withoutIndices(const std::string& field)
{
    std::string name;
    bool inside = false;
    for (const char c : field) {
        inside = inside || c == '[';
        if (!inside)
            name += c;
        inside = inside && c != ']';
    }
    return name;
}

const FieldName* findField(const std::string& field)
{
    for (const std::string& path : {withoutEntry(field), withoutIndices(field)})
        for (const FieldName& name : kFields)
            if (name.field == path)
                return &name;
    return nullptr;
}

/** No more decimals than the number has; six at most. */
QString numberText(double value, const QLocale& locale)
{
    constexpr double kSmallest = 1e-6;
    constexpr double kPlain = 1e9;
    constexpr int kMostDecimals = 6;
    if (value != 0 && (std::abs(value) < kSmallest || std::abs(value) >= kPlain))
        return locale.toString(value, 'g', kMostDecimals);
    const auto isRough = [value](int decimals) {
        const double shifted = value * std::pow(10.0, decimals);
        return std::abs(std::round(shifted) - shifted) > kSmallest * std::abs(shifted);
    };
    int decimals = 0;
    while (decimals < kMostDecimals && isRough(decimals))
        ++decimals;
    return fixedText(value, decimals, locale);
}

QString withUnit(double value, const ShownUnit& unit, const QLocale& locale)
{
    return u"%1 %2"_s.arg(numberText(unit.fromSi(value), locale), unit.name);
}

QString quantityText(Quantity quantity, double value, const QLocale& locale)
{
    switch (quantity) {
    case Quantity::Text:
    case Quantity::Number:
        break;
    case Quantity::Metres:
        return withUnit(value, {.name = u"m"_s}, locale);
    case Quantity::Distance:
        return withUnit(value, distanceUnit(), locale);
    case Quantity::Speed:
        return withUnit(value, speedUnit(), locale);
    case Quantity::Seconds:
        return withUnit(value, {.name = u"s"_s}, locale);
    case Quantity::Degrees:
        return numberText(value, locale) + u'°';
    case Quantity::Variance:
        return withUnit(value, {.name = u"m²"_s}, locale);
    case Quantity::Growth:
        return withUnit(value, {.name = u"m²/s"_s}, locale);
    }
    return numberText(value, locale);
}

} // namespace

QString fieldName(const std::string& field)
{
    const FieldName* const name = findField(field);
    return name == nullptr ? QString::fromStdString(field)
                           : QCoreApplication::translate(name->context, name->label);
}

QString fieldValue(const std::string& field, const IssueArgument& value, const QLocale& locale)
{
    if (const auto* const count = std::get_if<std::int64_t>(&value))
        return locale.toString(static_cast<qlonglong>(*count));
    if (const auto* const text = std::get_if<std::string>(&value))
        return QString::fromStdString(*text);
    const FieldName* const name = findField(field);
    return quantityText(name == nullptr ? Quantity::Number : name->quantity,
                        std::get<double>(value), locale);
}

} // namespace berg
