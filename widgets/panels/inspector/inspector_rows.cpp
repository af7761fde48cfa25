#include "core/base/angles.h"
#include "core/base/geodesy.h"
#include "widgets/panels/inspector/inspector_row_makers.h"
#include "widgets/theme/quantity_text.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kPositionStep_m = 10;
constexpr int kMoreDecimals = 3; ///< of nautical miles than of metres
constexpr double kKnotSteps = 2; ///< as large a step as in m/s, about

/** Reads, writes and limits what is SI in a unit. */
NumberRow inUnit(NumberRow row, const ShownUnit& unit)
{
    row.read = [read = std::move(row.read), unit](const Scenario& scenario, const std::string& id) {
        return unit.fromSi(read(scenario, id));
    };
    row.write = [write = std::move(row.write), unit](Scenario& scenario, const std::string& id,
                                                     double value) {
        write(scenario, id, unit.toSi(value));
    };
    row.range = [range = std::move(row.range), unit,
                 decimals = row.decimals.most](const Scenario& scenario) {
        return shownLimits(range(scenario), unit, decimals);
    };
    return row;
}

} // namespace

template <class Object>
TextRow nameRow(const QString& key)
{
    return {.words = {.key = key,
                      .label = InspectorRows::tr("Name"),
                      .toolTip = InspectorRows::tr("Shown on the map in place of the id."),
                      .undoText = InspectorRows::tr("Change name")},
            .read =
                [](const Scenario& scenario, const std::string& id) {
                    const Object* object = objectIn<Object>(scenario, id);
                    return object == nullptr ? std::string() : object->name;
                },
            .write =
                [](Scenario& scenario, const std::string& id, const std::string& name) {
                    if (Object* object = objectIn<Object>(scenario, id))
                        object->name = name;
                }};
}

template <class Object>
std::vector<InspectorRow> positionRows(const QString& kind)
{
    const auto row = [&](const QString& key, const QString& label, const QString& toolTip,
                         auto number) {
        return asDistance({.words = {.key = kind + key,
                                     .label = label,
                                     .toolTip = toolTip,
                                     .undoText = InspectorRows::tr("Change position")},
                           .unit = {},
                           .decimals = {.least = 0, .most = 1},
                           .step = kPositionStep_m,
                           .read = reading<Object>(number),
                           .write = writing<Object>(number),
                           .range = always(limits::kCoordinate_m)});
    };
    const auto place = [](const Scenario& scenario, const std::string& id, const QLocale& locale) {
        const Object* object = objectIn<Object>(scenario, id);
        if (object == nullptr)
            return QString();
        const LatLon at = LocalFrame(scenario.origin).toGeographic(object->position_m);
        return u"%1\n%2"_s.arg(latitudeText(at.latitude_deg, 3, locale),
                               longitudeText(at.longitude_deg, 3, locale));
    };
    return {row(
                u"East"_s, InspectorRows::tr("East"),
                InspectorRows::tr("Position at the start, east of the scenario's origin."),
                [](auto& object) -> auto& { return object.position_m.x(); }),
            row(
                u"North"_s, InspectorRows::tr("North"),
                InspectorRows::tr("Position at the start, north of the scenario's origin."),
                [](auto& object) -> auto& { return object.position_m.y(); }),
            InfoRow{.key = kind + u"Place"_s, .text = place}};
}

template TextRow nameRow<Iceberg>(const QString& key);
template TextRow nameRow<Uav>(const QString& key);
template TextRow nameRow<Asset>(const QString& key);
template TextRow nameRow<NoFlyArea>(const QString& key);
template std::vector<InspectorRow> positionRows<Iceberg>(const QString& kind);
template std::vector<InspectorRow> positionRows<Uav>(const QString& kind);
template std::vector<InspectorRow> positionRows<Asset>(const QString& kind);

Limits shownLimits(const Limits& limits, const ShownUnit& unit, int decimals)
{
    const double fine = std::pow(10.0, decimals);
    return {.low = std::ceil(unit.fromSi(limits.low) * fine) / fine,
            .high = std::floor(unit.fromSi(limits.high) * fine) / fine};
}

NumberRow asDistance(NumberRow row)
{
    const ShownUnit unit = distanceUnit();
    row.unit = u' ' + unit.name;
    if (shownUnits().distance == DistanceUnit::Metric)
        return row;
    row.decimals.most += kMoreDecimals;
    row.step = std::pow(10.0, std::round(std::log10(unit.fromSi(row.step))));
    return inUnit(std::move(row), unit);
}

NumberRow asSpeed(NumberRow row)
{
    const ShownUnit unit = speedUnit();
    row.unit = u' ' + unit.name;
    if (shownUnits().speed == SpeedUnit::MetresPerSecond)
        return row;
    row.step *= kKnotSteps;
    return inUnit(std::move(row), unit);
}

QString towardsText(const Point& velocity_mps, const QLocale& locale)
{
    const double speed_mps = velocity_mps.norm();
    if (speed_mps == 0)
        return InspectorRows::tr("stands still");
    const double psi_rad = std::atan2(velocity_mps.y(), velocity_mps.x());
    const int heading_deg = static_cast<int>(std::lround(headingFromPsi(psi_rad))) % 360;
    return InspectorRows::tr("%1 towards %2°")
        .arg(speedText(speed_mps, locale))
        .arg(heading_deg, 3, 10, QChar(u'0'));
}

} // namespace berg
