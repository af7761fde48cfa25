#include "core/base/angles.h"
#include "core/base/geodesy.h"
#include "widgets/model/places.h"
#include "widgets/model/scenario_edits.h"
#include "widgets/panels/inspector/inspector_row_makers.h"
#include "widgets/theme/quantity_text.h"

#include <cmath>
#include <map>
#include <memory>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kPositionArrowStep_m = 10;
constexpr int kMoreDecimals = 3; ///< of nautical miles than of metres
constexpr double kHalfTurn_deg = 180;
constexpr double kBearingStep_deg = 5; ///< beyond north on either side the arrows go round
constexpr double kKnotSteps = 2;       ///< as large a step as in m/s, about
constexpr double kFootSteps = 5;       ///< of 10 m: 50 ft

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

/** A half of the place on the globe. */
template <class Object>
EntryRow angleRow(const RowWords& words, PlaceHalf half)
{
    return {.words = words,
            .read =
                [half](const Scenario& scenario, const std::string& id, const QLocale& locale) {
                    const Object* object = objectIn<Object>(scenario, id);
                    if (object == nullptr)
                        return QString();
                    const LatLon at = LocalFrame(scenario.origin).toGeographic(object->position_m);
                    return half == PlaceHalf::Latitude
                               ? latitudeText(at.latitude_deg, kPlaceDecimals, locale)
                               : longitudeText(at.longitude_deg, kPlaceDecimals, locale);
                },
            .take =
                [half](Scenario& scenario, const std::string& id, const QString& text,
                       const QLocale& locale) {
                    Object* object = objectIn<Object>(scenario, id);
                    return object == nullptr
                               ? QString()
                               : takePlace(object->position_m, text, half, scenario.origin, locale);
                },
            .faultForSeveral = [half](const QString& text) { return faultForSeveral(text, half); }};
}

} // namespace

template <class Object>
TextRow nameRow(const QString& key)
{
    return textRow({.key = key,
                    .label = InspectorRows::tr("Name"),
                    .toolTip = InspectorRows::tr("Shown on the map in place of the id."),
                    .undoText = InspectorRows::tr("Change name")},
                   memberOf<Object>(&Object::name));
}

template <class Object>
std::vector<InspectorRow> positionRows(const QString& kind)
{
    const auto row = [&](const QString& key, const QString& label, const QString& toolTip,
                         auto number) {
        return asDistance(objectRow<Object>({.key = kind + key,
                                             .label = label,
                                             .toolTip = toolTip,
                                             .undoText = InspectorRows::tr("Change position")},
                                            {}, number, limits::kCoordinate_m,
                                            kPositionArrowStep_m));
    };
    return {angleRow<Object>(
                {.key = kind + u"Latitude"_s,
                 .label = InspectorRows::tr("Latitude"),
                 .toolTip = InspectorRows::tr("In any form; a whole coordinate sets both."),
                 .undoText = InspectorRows::tr("Change position")},
                PlaceHalf::Latitude),
            angleRow<Object>(
                {.key = kind + u"Longitude"_s,
                 .label = InspectorRows::tr("Longitude"),
                 .toolTip = InspectorRows::tr("In any form; a whole coordinate sets both."),
                 .undoText = InspectorRows::tr("Change position")},
                PlaceHalf::Longitude),
            row(
                u"East"_s, InspectorRows::tr("East"),
                InspectorRows::tr("Position at the start, east of the scenario's origin."),
                [](auto& object) -> auto& { return object.position_m.x(); }),
            row(
                u"North"_s, InspectorRows::tr("North"),
                InspectorRows::tr("Position at the start, north of the scenario's origin."),
                [](auto& object) -> auto& { return object.position_m.y(); })};
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

std::vector<InspectorRow> velocityRows(const VelocityRows& given)
{
    if (shownUnits().vectors == VectorForm::Components) {
        std::vector<InspectorRow> rows{asSpeed(given.east), asSpeed(given.north)};
        if (given.direction.text)
            rows.emplace_back(given.direction);
        return rows;
    }
    const double turn_deg = given.isFrom ? kHalfTurn_deg : 0;
    const auto read = [given](const Scenario& scenario, const std::string& id) {
        return Point(given.east.read(scenario, id), given.north.read(scenario, id));
    };
    const auto direction_deg = [read, turn_deg](const Scenario& scenario, const std::string& id) {
        const Point velocity_mps = read(scenario, id);
        return velocity_mps.isZero(0)
                   ? 0
                   : std::fmod(directionOf(velocity_mps) + turn_deg, 2 * kHalfTurn_deg);
    };
    const auto write = [given, turn_deg](Scenario& scenario, const std::string& id,
                                         double speed_mps, double shown_deg) {
        const Point velocity_mps = clampedVelocity(velocityTowards(speed_mps, shown_deg + turn_deg),
                                                   given.componentLimit_mps);
        const Point written_mps =
            given.finest_mps > 0 ? roundedTo(velocity_mps, given.finest_mps) : velocity_mps;
        given.east.write(scenario, id, written_mps.x() + 0.0); // no -0 in files
        given.north.write(scenario, id, written_mps.y() + 0.0);
    };
    NumberRow speed = given.east;
    speed.words.key = given.key + u"Speed"_s;
    speed.words.label = given.speedLabel;
    speed.words.toolTip = given.speedToolTip;
    speed.range = given.speeds_mps;
    speed.read = [read](const Scenario& scenario, const std::string& id) {
        return read(scenario, id).norm();
    };
    // By scenario and id: what is stopped, if only while a number is typed, goes on where it went.
    const auto last_deg = std::make_shared<std::map<std::string, double>>();
    speed.write = [write, read, direction_deg, last_deg](Scenario& scenario, const std::string& id,
                                                         double speed_mps) {
        double& shown_deg = (*last_deg)[scenario.name + '\n' + id];
        if (!read(scenario, id).isZero(0))
            shown_deg = direction_deg(scenario, id);
        write(scenario, id, speed_mps, shown_deg);
    };
    NumberRow direction{
        .words = given.east.words,
        .unit = u"°"_s,
        .decimals = {.least = 0, .most = 1},
        .step = kBearingStep_deg,
        .read = direction_deg,
        .write =
            [write, read](Scenario& scenario, const std::string& id, double value_deg) {
                write(scenario, id, read(scenario, id).norm(), value_deg);
            },
        .range = always({.low = -kBearingStep_deg, .high = 2 * kHalfTurn_deg + kBearingStep_deg})};
    direction.words.key = given.key + u"Direction"_s;
    direction.words.label = given.directionLabel;
    direction.words.toolTip = given.directionToolTip;
    direction.words.isShown = [read](const Scenario& scenario, const std::string& id) {
        return !read(scenario, id).isZero(0);
    };
    return {asSpeed(speed), direction};
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

NumberRow asHeight(NumberRow row)
{
    const ShownUnit unit = heightUnit();
    row.unit = u' ' + unit.name;
    if (shownUnits().height == HeightUnit::Metres)
        return row;
    row.step *= kFootSteps;
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
