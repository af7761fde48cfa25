#include "widgets/words/field_names.h"

#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <cmath>
#include <string_view>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

enum class Quantity
{
    Text,
    Number,
    Metres, ///< in any case
    Distance,
    Height,
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

struct Fields
{
    Q_DECLARE_TR_FUNCTIONS(InspectorRows)

public:
    using enum Quantity;
    static constexpr FieldName kAll[]{
        {"name", QT_TR_NOOP("Name")},
        {"notes", QT_TR_NOOP("Notes")},
        {"origin.latitude_deg", QT_TR_NOOP("Latitude"), Degrees},
        {"origin.longitude_deg", QT_TR_NOOP("Longitude"), Degrees},
        {"duration_s", QT_TR_NOOP("Duration"), Seconds},
        {"dt_s", QT_TR_NOOP("Time step"), Seconds},
        {"seed", QT_TR_NOOP("Seed"), Number},
        {"separation_m", QT_TR_NOOP("Separation"), Distance},
        {"area_m", QT_TRANSLATE_NOOP("FieldNames", "Corner of the area"), Distance, "FieldNames"},
        {"current_mps[0]", QT_TR_NOOP("Current east"), Speed},
        {"current_mps[1]", QT_TR_NOOP("Current north"), Speed},
        // Findings about a UAV as a whole tell times.
        {"uavs", QT_TRANSLATE_NOOP("OperationPage", "UAV"), Seconds, "OperationPage"},
        {"uavs.name", QT_TR_NOOP("Name")},
        {"uavs.id", QT_TRANSLATE_NOOP("berg::InspectorPanel", "Id"), Text, "berg::InspectorPanel"},
        {"uavs.position_m[0]", QT_TR_NOOP("East"), Distance},
        {"uavs.position_m[1]", QT_TR_NOOP("North"), Distance},
        {"uavs.heading_deg", QT_TR_NOOP("Heading"), Degrees},
        {"uavs.airspeed_mps", QT_TR_NOOP("Airspeed"), Speed},
        {"uavs.max_bank_deg", QT_TR_NOOP("Maximum bank angle"), Degrees},
        {"uavs.fov_m[0]", QT_TR_NOOP("View along-track"), Metres},
        {"uavs.fov_m[1]", QT_TR_NOOP("View cross-track"), Metres},
        {"uavs.altitude_m", QT_TR_NOOP("Altitude"), Height},
        {"uavs.endurance_s", QT_TR_NOOP("Endurance"), Seconds},
        {"uavs.home_m[0]", QT_TR_NOOP("Home east"), Distance},
        {"uavs.home_m[1]", QT_TR_NOOP("Home north"), Distance},
        {"uavs.turnaround_s", QT_TR_NOOP("Turn-around"), Seconds},
        {"uavs.reserve_percent", QT_TR_NOOP("Reserve"), Number},
        {"uavs.reserve_s", QT_TR_NOOP("Fixed reserve"), Seconds},
        {"uavs.climb_s", QT_TR_NOOP("Climb"), Seconds},
        {"uavs.landing_s", QT_TR_NOOP("Landing"), Seconds},
        {"uavs.max_wind_mps", QT_TR_NOOP("Wind limit"), Speed},
        {"uavs.max_gust_mps", QT_TR_NOOP("Gust limit"), Speed},
        {"uavs.icing", QT_TR_NOOP("Icing conditions")},
        {"uavs.autopilot_s", QT_TR_NOOP("Autopilot rate"), Seconds},
        {"icebergs.name", QT_TR_NOOP("Name")},
        {"icebergs.id", QT_TRANSLATE_NOOP("berg::InspectorPanel", "Id"), Text,
         "berg::InspectorPanel"},
        {"icebergs.position_m[0]", QT_TR_NOOP("East"), Distance},
        {"icebergs.position_m[1]", QT_TR_NOOP("North"), Distance},
        {"icebergs.velocity_mps[0]", QT_TR_NOOP("Drift east"), Speed},
        {"icebergs.velocity_mps[1]", QT_TR_NOOP("Drift north"), Speed},
        {"icebergs.velocity_sd_mps", QT_TR_NOOP("Drift error"), Speed},
        {"icebergs.velocity_spread_mps", QT_TR_NOOP("Drift variation"), Speed},
        {"icebergs.velocity_time_s", QT_TR_NOOP("Drift changes in"), Seconds},
        {"icebergs.q_m2ps", QT_TR_NOOP("Growth q"), Growth},
        {"icebergs.sigma0_m2", QT_TR_NOOP("Uncertainty σ₀"), Variance},
        {"icebergs.observed_s", QT_TR_NOOP("Last seen"), Seconds},
        {"icebergs.appears_s", QT_TR_NOOP("Appears at"), Seconds},
        {"icebergs.radius_m", QT_TR_NOOP("Radius"), Metres},
        {"icebergs.uav", QT_TR_NOOP("Visited by")},
        {"icebergs.track.time_s", QT_TRANSLATE_NOOP("FieldNames", "Time of the recorded track"),
         Seconds, "FieldNames"},
        {"icebergs.track.position_m",
         QT_TRANSLATE_NOOP("FieldNames", "Place of the recorded track"), Distance, "FieldNames"},
        {"asset.name", QT_TR_NOOP("Name")},
        {"asset.position_m[0]", QT_TR_NOOP("East"), Distance},
        {"asset.position_m[1]", QT_TR_NOOP("North"), Distance},
        {"asset.velocity_mps[0]", QT_TR_NOOP("Speed east"), Speed},
        {"asset.velocity_mps[1]", QT_TR_NOOP("Speed north"), Speed},
        {"asset.range_m", QT_TR_NOOP("Range"), Distance},
        {"asset.gain", QT_TR_NOOP("Gain"), Number},
        {"asset.alarm_m", QT_TR_NOOP("Inner ring"), Distance},
        {"asset.standoff_m", QT_TR_NOOP("Stand-off ring"), Distance},
        {"asset.standoff_ceiling_m", QT_TR_NOOP("Stand-off ceiling"), Height},
        {"no_fly.name", QT_TR_NOOP("Name")},
        {"no_fly.area_m", QT_TRANSLATE_NOOP("FieldNames", "Corner of the no-fly area"), Distance,
         "FieldNames"},
        {"no_fly.floor_m", QT_TR_NOOP("Floor"), Height},
        {"no_fly.ceiling_m", QT_TR_NOOP("Ceiling"), Height},
        {"operation.margin_m", QT_TR_NOOP("Margin"), Metres},
        {"operation.span_m", QT_TR_NOOP("UAV size"), Metres},
        {"operation.position_error_m", QT_TR_NOOP("Satellite position error"), Metres},
        {"operation.path_error_m", QT_TR_NOOP("Path-keeping error"), Metres},
        {"operation.map_error_m", QT_TR_NOOP("Map error"), Metres},
        {"operation.reaction_s", QT_TR_NOOP("Reaction time"), Seconds},
        {"operation.turn_bank_deg", QT_TR_NOOP("Bank of the turn back"), Degrees},
        {"operation.height_error_m", QT_TR_NOOP("Height error"), Metres},
        {"operation.climb_part", QT_TR_NOOP("Climb part"), Number},
        {"operation.pull_up_part", QT_TR_NOOP("Pull-up part"), Number},
        {"operation.buffer_ratio", QT_TR_NOOP("Buffer ratio"), Number},
        {"operation.adjacent_s", QT_TR_NOOP("Adjacent area, time"), Seconds},
        {"operation.adjacent_least_m", QT_TR_NOOP("Adjacent area, least"), Metres},
        {"operation.adjacent_most_m", QT_TR_NOOP("Adjacent area, most"), Metres},
        {"operation.crew", QT_TR_NOOP("Crew")},
        {"operation.call_sign", QT_TR_NOOP("Call sign")},
        {"operation.contacts", QT_TR_NOOP("Contacts")},
        {"operation.link", QT_TR_NOOP("Command link")},
        {"operation.checklist", QT_TR_NOOP("Checklist")},
        {"airspace", QT_TRANSLATE_NOOP("FieldNames", "Airspace"), Text, "FieldNames"},
        {"airspace.name", QT_TR_NOOP("Name")},
        {"airspace.area_m", QT_TRANSLATE_NOOP("FieldNames", "Corner of the airspace"), Metres,
         "FieldNames"},
        {"airspace.floor_m", QT_TR_NOOP("Floor"), Height},
        {"airspace.ceiling_m", QT_TR_NOOP("Ceiling"), Height},
        {"airspace.from_utc", QT_TRANSLATE_NOOP("FieldNames", "Start of the airspace"), Text,
         "FieldNames"},
        {"airspace.until_utc", QT_TRANSLATE_NOOP("FieldNames", "End of the airspace"), Text,
         "FieldNames"},
        {"ground_station.position_m[0]", QT_TR_NOOP("Station east"), Distance},
        {"ground_station.position_m[1]", QT_TR_NOOP("Station north"), Distance},
        {"ground_station.antenna_m", QT_TR_NOOP("Antenna height"), Height},
        {"ground_station.range_m", QT_TR_NOOP("Link range"), Distance},
        {"ground_station", QT_TR_NOOP("Ground station")},
        {"weather.gust_mps", QT_TR_NOOP("Gusts"), Speed},
        {"weather.temperature_degc", QT_TR_NOOP("Temperature"), Number},
        {"weather.dew_point_degc", QT_TR_NOOP("Dew point"), Number},
        {"observer.position_sd_m", QT_TR_NOOP("Position error"), Metres},
        {"observer.interval_s", QT_TR_NOOP("Sensor interval"), Seconds},
        {"observer.detection", QT_TR_NOOP("Detection probability"), Number},
        {"planner.tau", QT_TRANSLATE_NOOP("FieldNames", "Trade-off τ"), Number, "FieldNames"},
        {"planner.planning_delay_s", QT_TR_NOOP("Planning time"), Seconds},
        {"planner.reach_radius_m", QT_TR_NOOP("Acceptance radius"), Distance},
        // Options of the core, called as the dialogs for imports and exports call them.
        {"import.position error", QT_TR_NOOP("Position error"), Metres},
        {"import.drift variation", QT_TR_NOOP("Drift variation"), Speed},
        {"import.drift time", QT_TR_NOOP("Drift changes in"), Seconds},
        {"import.q", QT_TR_NOOP("Growth q"), Growth},
        {"import.area: south", QT_TRANSLATE_NOOP("FieldNames", "South"), Degrees, "FieldNames"},
        {"import.area: north", QT_TRANSLATE_NOOP("FieldNames", "North"), Degrees, "FieldNames"},
        {"import.area: west", QT_TRANSLATE_NOOP("FieldNames", "West"), Degrees, "FieldNames"},
        {"import.area: east", QT_TRANSLATE_NOOP("FieldNames", "East"), Degrees, "FieldNames"},
        {"import.at", QT_TRANSLATE_NOOP("FieldNames", "Start at"), Text, "FieldNames"},
        {"import.since", QT_TRANSLATE_NOOP("FieldNames", "Not before"), Text, "FieldNames"},
        {"import.until", QT_TRANSLATE_NOOP("FieldNames", "Not after"), Text, "FieldNames"},
        {"import.origin", QT_TRANSLATE_NOOP("FieldNames", "Origin"), Text, "FieldNames"},
        {"export.altitude", QT_TRANSLATE_NOOP("ExportText", "Altitude"), Height, "ExportText"},
        {"export.speed", QT_TRANSLATE_NOOP("ExportText", "Airspeed"), Speed, "ExportText"},
        {"export.acceptance", QT_TRANSLATE_NOOP("ExportText", "Acceptance radius"), Metres,
         "ExportText"},
        {"export.loiter", QT_TRANSLATE_NOOP("ExportText", "Loiter turns"), Number, "ExportText"},
        {"export.return-home", QT_TRANSLATE_NOOP("ExportText", "Return home"), Text, "ExportText"},
        {"export.no-return-home", QT_TRANSLATE_NOOP("ExportText", "Return home"), Text,
         "ExportText"},
        {"export.what", QT_TRANSLATE_NOOP("ExportText", "What"), Text, "ExportText"},
    };
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
        for (const FieldName& name : Fields::kAll)
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

/** In feet with one decimal, as the fields have them. */
QString heightFieldText(double height_m, const QLocale& locale)
{
    const ShownUnit unit = heightUnit();
    const bool isExact = shownUnits().height == HeightUnit::Metres;
    const double shown = unit.fromSi(height_m);
    return u"%1 %2"_s.arg(numberText(isExact ? shown : std::round(10 * shown) / 10, locale),
                          unit.name);
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
    case Quantity::Height:
        return heightFieldText(value, locale);
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
