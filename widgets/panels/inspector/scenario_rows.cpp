#include "core/scenario/advice.h"
#include "widgets/model/scenario_edits.h"
#include "widgets/model/wind.h"
#include "widgets/panels/inspector/inspector_row_makers.h"
#include "widgets/words/time_entry.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kWindStep_mps = 0.5;
constexpr double kFinestWind_mps = 0.001; ///< so that the numbers in a file stay short
constexpr double kWindSteps_mps = 0.01;   ///< of what can be typed

double slowest_mps(const Scenario& scenario)
{
    return scenario.uavs.empty() ? limits::kAirspeed_mps.high : slowestAirspeed_mps(scenario);
}

Limits windSpeeds_mps(const Scenario& scenario)
{
    return {.low = 0, .high = fastestWind_mps(slowest_mps(scenario), kWindSteps_mps)};
}

/** What is left for one component of the wind beside the other: slower than the slowest UAV. */
Limits windRange(const Scenario& scenario, double other_mps)
{
    const double airspeed_mps = slowest_mps(scenario);
    const double room_mps =
        std::sqrt(std::max(0.0, airspeed_mps * airspeed_mps - other_mps * other_mps));
    const double largest_mps = std::max(0.0, std::ceil(100 * room_mps - 1) / 100);
    return {.low = -largest_mps, .high = largest_mps};
}

std::vector<InspectorRow> windRows()
{
    const auto component = [](const QString& key, const QString& label, const QString& toolTip,
                              int axis) {
        NumberRow row = scenarioRow(
            {.key = key,
             .label = label,
             .toolTip = toolTip,
             .undoText = InspectorRows::tr("Change wind")},
            {}, [axis](auto& scenario) -> auto& { return scenario.wind_mps[axis]; },
            [axis](const Scenario& scenario) {
                return windRange(scenario, scenario.wind_mps[1 - axis]);
            });
        row.step = kWindStep_mps;
        return row;
    };
    return velocityRows(
        {.east =
             component(u"scenarioWindEast"_s, InspectorRows::tr("Wind east"),
                       InspectorRows::tr("Towards the east; always slower than the UAV flies."), 0),
         .north = component(
             u"scenarioWindNorth"_s, InspectorRows::tr("Wind north"),
             InspectorRows::tr("Towards the north; always slower than the UAV flies."), 1),
         .key = u"scenarioWind"_s,
         .speedLabel = InspectorRows::tr("Wind"),
         .speedToolTip = InspectorRows::tr("Always slower than the UAV flies."),
         .directionLabel = InspectorRows::tr("Wind from"),
         .directionToolTip = InspectorRows::tr("Where it blows from, clockwise from north."),
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
    const auto component = [](const QString& key, const QString& label, const QString& toolTip,
                              int axis) {
        NumberRow row = scenarioRow(
            {.key = key,
             .label = label,
             .toolTip = toolTip,
             .undoText = InspectorRows::tr("Change current")},
            {}, [axis](auto& scenario) -> auto& { return scenario.current_mps[axis]; },
            always(limits::kVelocity_mps));
        row.step = kVelocityStep_mps;
        row.decimals = {.least = 2, .most = 3};
        return row;
    };
    return velocityRows(
        {.east = component(u"scenarioCurrentEast"_s, InspectorRows::tr("Current east"),
                           InspectorRows::tr("Carries every iceberg towards the east."), 0),
         .north = component(u"scenarioCurrentNorth"_s, InspectorRows::tr("Current north"),
                            InspectorRows::tr("Carries every iceberg towards the north."), 1),
         .key = u"scenarioCurrent"_s,
         .speedLabel = InspectorRows::tr("Current"),
         .speedToolTip = InspectorRows::tr("Carries every iceberg."),
         .directionLabel = InspectorRows::tr("Current towards"),
         .directionToolTip = InspectorRows::tr("Where it flows to, clockwise from north."),
         .componentLimit_mps = kLargestVelocity_mps,
         .speeds_mps = always(limits::kSpeed_mps)});
}

NumberRow durationRow()
{
    NumberRow duration =
        scenarioRow({.key = u"scenarioDuration"_s,
                     .label = InspectorRows::tr("Duration"),
                     .toolTip = InspectorRows::tr("Length of the run, at most seven days."),
                     .undoText = InspectorRows::tr("Change duration")},
                    u" s"_s, &Scenario::duration_s, [](const Scenario& scenario) {
                        return Limits{.low = std::max(limits::kTimeStep_s.low, scenario.dt_s),
                                      .high = limits::kDuration_s.high};
                    });
    duration.step = 60;
    return duration;
}

std::vector<InspectorRow> simulationRows()
{
    NumberRow timeStep = scenarioRow(
        {.key = u"scenarioTimeStep"_s,
         .label = InspectorRows::tr("Time step"),
         .toolTip = InspectorRows::tr("Step of the simulation; small is exact and slow."),
         .undoText = InspectorRows::tr("Change time step")},
        u" s"_s, &Scenario::dt_s, [](const Scenario& scenario) {
            return Limits{.low = limits::kTimeStep_s.low,
                          .high = std::min({limits::kTimeStep_s.high, scenario.duration_s,
                                            scenario.observer.interval_s})};
        });
    timeStep.step = 0.05;
    timeStep.decimals = {.least = 2, .most = 3};
    const NumberRow seed{
        .words = {.key = u"scenarioSeed"_s,
                  .label = InspectorRows::tr("Seed"),
                  .toolTip = InspectorRows::tr("Names the random drift: the same seed, the same "
                                               "run."),
                  .undoText = InspectorRows::tr("Change seed")},
        .read = [](const Scenario& scenario,
                   const std::string&) { return static_cast<double>(scenario.seed); },
        .write = [](Scenario& scenario, const std::string&,
                    double value) { scenario.seed = std::llround(value); },
        .range = always({.low = 0, .high = static_cast<double>(kLargestSeed)})};
    return {timeStep, seed,
            flagRow({.key = u"scenarioNoise"_s,
                     .label = InspectorRows::tr("Random drift"),
                     .toolTip = InspectorRows::tr("Off: icebergs drift exactly as known."),
                     .undoText = InspectorRows::tr("Change random drift")},
                    &Scenario::noise)};
}

NumberRow separationRow()
{
    NumberRow row = scenarioRow(
        {.key = u"scenarioSeparation"_s,
         .label = InspectorRows::tr("Separation"),
         .toolTip = InspectorRows::tr("UAVs are kept so far from each other, unless their "
                                      "altitudes are %1 apart.")
                        .arg(heightText(kLayerHeight_m, QLocale())),
         .undoText = InspectorRows::tr("Change separation"),
         .isShown = hasUavsToldApart},
        {}, &Scenario::separation_m, always(limits::kLength_m));
    row.step = 50;
    row.lowestText = InspectorRows::tr("not kept apart");
    return asDistance(row);
}

/** Layers of their own make it needless to keep UAVs apart within one. */
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
    return {.words = {.key = u"scenarioStart"_s,
                      .label = InspectorRows::tr("Start (UTC)"),
                      .toolTip = InspectorRows::tr("Date and time of the start, such as 2026-11-29 "
                                                   "12:00 or 29 Nov 2026 12:00; 1200Z keeps the "
                                                   "date. Empty: times are relative."),
                      .undoText = InspectorRows::tr("Change start")},
            .read = [](const Scenario& scenario, const std::string&,
                       const QLocale&) { return QString::fromStdString(scenario.startUtc); },
            .take = [](Scenario& scenario, const std::string&, const QString& text,
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

std::vector<InspectorRow> placeRows()
{
    const auto degrees = [](const QString& key, const QString& label, const QString& toolTip,
                            auto number, const Limits& range) {
        NumberRow row = scenarioRow({.key = key,
                                     .label = label,
                                     .toolTip = toolTip,
                                     .undoText = InspectorRows::tr("Change origin")},
                                    u"°"_s, number, always(range));
        row.decimals = {.least = 1, .most = 6};
        row.step = 0.1;
        return row;
    };
    return {
        startRow(),
        degrees(
            u"scenarioLatitude"_s, InspectorRows::tr("Latitude"),
            InspectorRows::tr("Of the origin, north positive; everything moves along with it."),
            [](auto& scenario) -> auto& { return scenario.origin.latitude_deg; },
            limits::kLatitude_deg),
        degrees(
            u"scenarioLongitude"_s, InspectorRows::tr("Longitude"),
            InspectorRows::tr("Of the origin, east positive; everything moves along with it."),
            [](auto& scenario) -> auto& { return scenario.origin.longitude_deg; },
            limits::kLongitude_deg),
        InfoRow{.key = u"scenarioPlace"_s,
                .text = [](const Scenario& scenario, const std::string&, const QLocale& locale) {
                    return u"%1\n%2"_s.arg(latitudeText(scenario.origin.latitude_deg, 3, locale),
                                           longitudeText(scenario.origin.longitude_deg, 3, locale));
                }}};
}

} // namespace

std::vector<InspectorRow> scenarioRows()
{
    TextRow notes =
        textRow({.key = u"scenarioNotes"_s,
                 .label = InspectorRows::tr("Notes"),
                 .toolTip = InspectorRows::tr("Anything worth knowing, kept in the file."),
                 .undoText = InspectorRows::tr("Change notes")},
                ofScenario(&Scenario::notes));
    notes.multiLine = true;
    std::vector<InspectorRow> rows{
        textRow({.key = u"scenarioName"_s,
                 .label = InspectorRows::tr("Name"),
                 .toolTip = InspectorRows::tr("Title of the scenario, shown on the map."),
                 .undoText = InspectorRows::tr("Change name")},
                ofScenario(&Scenario::name)),
        notes};
    rows.emplace_back(
        GroupRow{.key = u"scenarioPlaceGroup"_s, .title = InspectorRows::tr("Time and place")});
    append(rows, placeRows());
    rows.emplace_back(durationRow());
    rows.emplace_back(GroupRow{.key = u"scenarioWeatherGroup"_s,
                               .title = InspectorRows::tr("Wind, weather and current")});
    append(rows, windRows());
    append(rows, surroundingsRows());
    append(rows, currentRows());
    rows.emplace_back(
        GroupRow{.key = u"scenarioRulesGroup"_s, .title = InspectorRows::tr("Flight rules")});
    rows.emplace_back(separationRow());
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
    rows.emplace_back(
        GroupRow{.key = u"scenarioObserverGroup"_s, .title = InspectorRows::tr("Observer")});
    append(rows, observerRows());
    rows.emplace_back(
        GroupRow{.key = u"scenarioPlannerGroup"_s, .title = InspectorRows::tr("Planner")});
    append(rows, plannerRows());
    rows.emplace_back(GroupRow{.key = u"scenarioSimulationGroup"_s,
                               .title = InspectorRows::tr("Simulation"),
                               .isFolded = true});
    append(rows, simulationRows());
    return rows;
}

} // namespace berg
