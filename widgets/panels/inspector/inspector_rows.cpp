#include "core/base/angles.h"
#include "core/earth/geodesy.h"
#include "widgets/document/scenario_edits.h"
#include "widgets/panels/inspector/field_inputs.h"
#include "widgets/places/places.h"
#include "widgets/theme/quantity_text.h"

#include <cmath>
#include <map>
#include <memory>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMoreDecimals = 3; ///< additional decimals of nautical miles over metres
constexpr double kHalfTurn_deg = 180;
constexpr double kBearingStep_deg = 5; ///< arrow keys step this far beyond north
constexpr double kKnotSteps = 2;       ///< about as large a step as in m/s
constexpr double kFootSteps = 5;       ///< 50 ft for 10 m

/** Returns a row in SI with value and limits converted to a unit. */
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

/** Returns the row of latitude or longitude. */
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
            .apply =
                [half](Scenario& scenario, const std::string& id, const QString& text,
                       const QLocale& locale) {
                    Object* object = objectIn<Object>(scenario, id);
                    return object == nullptr ? QString()
                                             : applyTypedPlace(object->position_m, text, half,
                                                               scenario.origin, locale);
                },
            .faultForSeveral = [half](const QString& text) { return faultForSeveral(text, half); }};
}

} // namespace

template <class Object>
std::vector<InspectorRow> positionRows(const QString& kind, const char* path)
{
    const QString change = InspectorRows::tr("Change position");
    const QString help = InspectorRows::tr("Any form; a whole coordinate sets both.");
    const FieldInputs<Object> inputs(path);
    return {angleRow<Object>({.key = kind + u"Latitude"_s,
                              .label = InspectorRows::tr("Latitude"),
                              .toolTip = help,
                              .undoText = change},
                             PlaceHalf::Latitude),
            angleRow<Object>({.key = kind + u"Longitude"_s,
                              .label = InspectorRows::tr("Longitude"),
                              .toolTip = help,
                              .undoText = change},
                             PlaceHalf::Longitude),
            named(inputs.number("position_m", 0), kind + u"East"_s, change),
            named(inputs.number("position_m", 1), kind + u"North"_s, change)};
}

template std::vector<InspectorRow> positionRows<Iceberg>(const QString& kind, const char* path);
template std::vector<InspectorRow> positionRows<Uav>(const QString& kind, const char* path);
template std::vector<InspectorRow> positionRows<Asset>(const QString& kind, const char* path);

QString changeText(const QString& label)
{
    const bool isWord = label.size() < 2 || label[1].isLower(); // keeps abbreviations
    return InspectorRows::tr("Change %1")
        .arg(isWord ? label.left(1).toLower() + label.mid(1) : label);
}

QString siUnitText(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Text:
    case Quantity::Utc:
    case Quantity::Number:
    case Quantity::Distance:
    case Quantity::Height:
    case Quantity::Speed:
        break;
    case Quantity::Metres:
        return u" m"_s;
    case Quantity::Seconds:
        return u" s"_s;
    case Quantity::Degrees:
        return u"°"_s;
    case Quantity::Percent:
        return u" %"_s;
    case Quantity::Celsius:
        return u" °C"_s;
    case Quantity::Variance:
        return u" m²"_s;
    case Quantity::Growth:
        return u" m²/s"_s;
    }
    return {};
}

NumberRow inUserUnit(NumberRow row, Quantity quantity)
{
    if (quantity == Quantity::Distance)
        return asDistance(std::move(row));
    if (quantity == Quantity::Height)
        return asHeight(std::move(row));
    return quantity == Quantity::Speed ? asSpeed(std::move(row)) : row;
}

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
            given.finest_mps ? roundedTo(velocity_mps, *given.finest_mps) : velocity_mps;
        given.east.write(scenario, id, written_mps.x() + 0.0); // avoids -0 in files
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
    // By scenario and id: an object that stops, even only while a number is typed, keeps its
    // direction.
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
        return InspectorRows::tr("stationary");
    const double psi_rad = std::atan2(velocity_mps.y(), velocity_mps.x());
    const int heading_deg = static_cast<int>(std::lround(headingFromPsi(psi_rad))) % 360;
    return InspectorRows::tr("%1 towards %2°")
        .arg(speedText(speed_mps, locale))
        .arg(heading_deg, 3, 10, QChar(u'0'));
}

} // namespace berg
