#include "widgets/document/scenario_edits.h"
#include "widgets/document/wind.h"
#include "widgets/panels/inspector/field_inputs.h"
#include "widgets/places/places.h"
#include "widgets/words/forecast_text.h"
#include "widgets/words/time_entry.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kFinestWind_mps = 0.001; ///< keeps the numbers in a file short
constexpr double kWindSteps_mps = 0.01;   ///< step of typed numbers

double slowest_mps(const Scenario& scenario)
{
    return scenario.uavs.empty() ? limits::kAirspeed_mps.high : slowestAirspeed_mps(scenario);
}

Limits windSpeeds_mps(const Scenario& scenario)
{
    return {.low = 0, .high = fastestWind_mps(slowest_mps(scenario), kWindSteps_mps)};
}

/**
 * Returns the range of one wind component beside the other one, below the airspeed of the slowest
 * UAV.
 */
Limits windRange(const Scenario& scenario, double other_mps)
{
    const double airspeed_mps = slowest_mps(scenario);
    const double spare_mps =
        std::sqrt(std::max(0.0, airspeed_mps * airspeed_mps - other_mps * other_mps));
    const double largest_mps = std::max(0.0, std::ceil(100 * spare_mps - 1) / 100);
    return {.low = -largest_mps, .high = largest_mps};
}

std::vector<InspectorRow> windRows()
{
    const auto component = [](const QString& key, int axis) {
        NumberRow row = named(FieldInputs<Scenario>("").inSi("wind_mps", axis), key,
                              InspectorRows::tr("Change wind"));
        row.range = [axis](const Scenario& scenario) {
            return windRange(scenario, scenario.wind_mps[1 - axis]);
        };
        return row;
    };
    return velocityRows(
        {.east = component(u"scenarioWindEast"_s, 0),
         .north = component(u"scenarioWindNorth"_s, 1),
         .key = u"scenarioWind"_s,
         .speedLabel = InspectorRows::tr("Wind"),
         .speedToolTip = InspectorRows::tr("Must be below the UAV's airspeed."),
         .directionLabel = InspectorRows::tr("Wind from"),
         .directionToolTip =
             InspectorRows::tr("Direction the wind blows from, clockwise from north."),
         .isFrom = true,
         .componentLimit_mps = limits::kAirspeed_mps.high,
         .finest_mps = kFinestWind_mps,
         .speeds_mps = windSpeeds_mps,
         .direction = {
             .key = u"scenarioWind"_s,
             .text = [](const Scenario& scenario, const std::string&, const QLocale& locale) {
                 return scenario.wind_mps.isZero(0)
                            ? InspectorRows::tr("no wind")
                            : InspectorRows::tr("%1 from %2")
                                  .arg(speedText(scenario.wind_mps.norm(), locale),
                                       bearingText(-scenario.wind_mps));
             }}});
}

std::vector<InspectorRow> currentRows()
{
    const FieldInputs<Scenario> scenario("");
    const QString change = InspectorRows::tr("Change current");
    return velocityRows(
        {.east = named(scenario.inSi("current_mps", 0), u"scenarioCurrentEast"_s, change),
         .north = named(scenario.inSi("current_mps", 1), u"scenarioCurrentNorth"_s, change),
         .key = u"scenarioCurrent"_s,
         .speedLabel = InspectorRows::tr("Current"),
         .speedToolTip = InspectorRows::tr("Carries every iceberg."),
         .directionLabel = InspectorRows::tr("Current towards"),
         .directionToolTip =
             InspectorRows::tr("Direction the current flows to, clockwise from north."),
         .componentLimit_mps = kLargestVelocity_mps,
         .speeds_mps = always(limits::kSpeed_mps)});
}

/** Returns the source of the forecast, which can be removed, and what it replaces. */
std::vector<InspectorRow> forecastRows()
{
    PartRow part{
        .words = {.key = u"scenarioForecast"_s,
                  .label = InspectorRows::tr("Forecast"),
                  .toolTip = InspectorRows::tr(
                      "Where and when it gives a quantity, it replaces the constant one below."),
                  .undoText = InspectorRows::tr("Remove forecast")},
        .removeText = InspectorRows::tr("Remove"),
        .text = [](const Scenario& scenario, const std::string&, const QLocale&) -> QString {
            if (!scenario.forecast)
                return {};
            return scenario.forecast->places.empty() ? InspectorRows::tr("empty")
                                                     : forecastSource(*scenario.forecast);
        },
        .remove = [](Scenario& scenario, const std::string&) { scenario.forecast.reset(); }};
    InfoRow details{
        .key = u"scenarioForecastDetails"_s,
        .text = [](const Scenario& scenario, const std::string&, const QLocale& locale) -> QString {
            if (!scenario.forecast || scenario.forecast->places.empty())
                return {};
            const std::optional<UtcTime> start = parseUtc(scenario.startUtc);
            return (start ? InspectorRows::tr("%1; replaces %2", "time of issue, quantities")
                          : InspectorRows::tr("%1; not used before the start (UTC) is set, then it "
                                              "replaces %2",
                                              "time of issue, quantities"))
                .arg(forecastIssue(*scenario.forecast, start, locale),
                     forecastQuantitiesText(*scenario.forecast));
        }};
    return {std::move(part), std::move(details)};
}

NumberRow durationRow()
{
    NumberRow row = FieldInputs<Scenario>("").number("duration_s");
    row.range = [](const Scenario& scenario) {
        return Limits{.low = std::max(limits::kTimeStep_s.low, scenario.dt_s),
                      .high = limits::kDuration_s.high};
    };
    return row;
}

std::vector<InspectorRow> simulationRows()
{
    const FieldInputs<Scenario> scenario("");
    NumberRow timeStep = scenario.number("dt_s");
    timeStep.range = [](const Scenario& of) {
        return Limits{
            .low = limits::kTimeStep_s.low,
            .high = std::min({limits::kTimeStep_s.high, of.duration_s, of.observer.interval_s})};
    };
    return {timeStep, scenario.number("seed"), scenario.flag("noise")};
}

/** Returns the button that separates altitudes, so that UAVs need no separation within a layer. */
ActionRow layersRow()
{
    return {.words = {.key = u"scenarioLayers"_s,
                      .toolTip = InspectorRows::tr("Raises UAVs until their altitudes are %1 "
                                                   "apart, so that none has to wait for another.")
                                     .arg(heightText(kLayerHeight_m, QLocale())),
                      .undoText = InspectorRows::tr("Separate altitudes"),
                      .isShown = [](const Scenario& scenario,
                                    const std::string&) { return sharesLayer(scenario); }},
            .act = &separateLayers};
}

EntryRow startRow()
{
    return {.words = FieldInputs<Scenario>("").words("start_utc"),
            .read = [](const Scenario& scenario, const std::string&,
                       const QLocale&) { return QString::fromStdString(scenario.startUtc); },
            .apply = [](Scenario& scenario, const std::string&, const QString& text,
                        const QLocale&) -> QString {
                if (text.trimmed().isEmpty()) {
                    scenario.startUtc.clear();
                    return {};
                }
                const auto start = readTime(text, parseUtc(scenario.startUtc));
                if (const auto* fault = std::get_if<QString>(&start))
                    return *fault;
                scenario.startUtc = utcText(std::get<UtcTime>(start), 0);
                return {};
            },
            .placeholder = InspectorRows::tr("relative times")};
}

EntryRow originRow(const RowWords& words, PlaceHalf half)
{
    return {.words = words,
            .read =
                [half](const Scenario& scenario, const std::string&, const QLocale& locale) {
                    const LatLon& at = scenario.origin;
                    return half == PlaceHalf::Latitude
                               ? latitudeText(at.latitude_deg, kPlaceDecimals, locale)
                               : longitudeText(at.longitude_deg, kPlaceDecimals, locale);
                },
            .apply = [half](Scenario& scenario, const std::string&, const QString& text,
                            const QLocale&) -> QString {
                const auto typed = typedPlace(text, half, scenario.origin);
                if (const auto* fault = std::get_if<QString>(&typed))
                    return *fault;
                scenario.origin = std::get<LatLon>(typed);
                return {};
            }};
}

std::vector<InspectorRow> placeRows()
{
    const FieldInputs<LatLon> origin("origin.");
    const QString change = InspectorRows::tr("Change origin");
    return {startRow(),
            originRow(named(origin.inSi("latitude_deg"), u"scenarioLatitude"_s, change).words,
                      PlaceHalf::Latitude),
            originRow(named(origin.inSi("longitude_deg"), u"scenarioLongitude"_s, change).words,
                      PlaceHalf::Longitude)};
}

} // namespace

std::vector<InspectorRow> scenarioRows()
{
    const FieldInputs<Scenario> scenario("");
    std::vector<InspectorRow> rows = scenario.rows("name", "notes");
    beginGroup(rows, u"scenarioPlaceGroup"_s, InspectorRows::tr("Time and place"));
    append(rows, placeRows());
    rows.emplace_back(durationRow());
    beginGroup(rows, u"scenarioWeatherGroup"_s, InspectorRows::tr("Wind, weather and current"));
    append(rows, forecastRows());
    append(rows, windRows());
    append(rows, surroundingsRows());
    append(rows, currentRows());
    beginGroup(rows, u"scenarioRulesGroup"_s, InspectorRows::tr("Flight rules"));
    append(rows, FieldInputs<Scenario>("", hasSeveralUavs).rows("separation_m"));
    rows.emplace_back(layersRow());
    append(rows, permitRows());
    rows.emplace_back(InfoRow{
        .key = u"scenarioNoFly"_s,
        .text = [](const Scenario& scenario, const std::string&, const QLocale& locale) {
            QStringList lines;
            for (const NoFlyArea& area : scenario.noFly) {
                const QString heights = heightsText(area.floor_m, area.ceiling_m, locale);
                lines << (area.name.empty() ? InspectorRows::tr("No-fly area: %1").arg(heights)
                                            : InspectorRows::tr("No-fly area %1: %2")
                                                  .arg(QString::fromStdString(area.name), heights));
            }
            return lines.join(u'\n');
        }});
    beginGroup(rows, u"scenarioObserverGroup"_s, InspectorRows::tr("Observer"));
    append(rows, observerRows());
    beginGroup(rows, u"scenarioPlannerGroup"_s, InspectorRows::tr("Planner"));
    append(rows, plannerRows());
    beginGroup(rows, u"scenarioSimulationGroup"_s, InspectorRows::tr("Simulation"), true);
    append(rows, simulationRows());
    return rows;
}

} // namespace berg
