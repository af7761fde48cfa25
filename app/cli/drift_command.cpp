#include "app/cli/commands.h"
#include "app/cli/drift_scenario.h"
#include "app/cli/forecast_files.h"
#include "app/cli/options.h"
#include "app/cli/output_gate.h"
#include "app/cli/typed_values.h"
#include "core/base/knots.h"
#include "core/base/stopped.h"
#include "core/earth/coordinates.h"
#include "core/io/import/import_tracks.h"
#include "core/io/results/drift_result.h"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace berg::cli {

namespace {

struct DriftArguments
{
    std::string scenario;
    std::optional<double> length_m;
    std::string size;
    std::string coefficients{kCCoreDrag.name};
    std::optional<double> wind_mps;
    std::optional<double> windFrom_deg;
    std::optional<double> current_mps;
    std::optional<double> currentTo_deg;
    std::optional<double> latitude_deg;
    std::vector<std::string> forecasts;
    std::string at;
    std::optional<double> duration_h;
    std::optional<double> every_h;
    std::string place;
    std::string track;
    std::string outputFile;
    bool force = false;
    bool json = false;
};

constexpr double kUsualDuration_h = 48;

constexpr const char* kNeeds = QT_TRANSLATE_NOOP("CommandLine", "%1 needs %2");

/** Throws `UsageError` if an option is given without another one that it needs. */
void requireBeside(bool isGiven, const char* option, bool isOtherGiven, const char* other)
{
    if (isGiven && !isOtherGiven)
        throw UsageError(kNeeds, {option, other});
}

/** Throws `UsageError` for options that do not belong to the icebergs of a scenario. */
void checkScenarioOptions(const DriftArguments& given)
{
    for (const auto& [isGiven, option] : {std::pair{given.length_m.has_value(), "--length"},
                                          {!given.size.empty(), "--size"},
                                          {given.wind_mps.has_value(), "--wind-speed"},
                                          {given.windFrom_deg.has_value(), "--wind-from"},
                                          {given.current_mps.has_value(), "--current-speed"},
                                          {given.currentTo_deg.has_value(), "--current-to"},
                                          {given.latitude_deg.has_value(), "--latitude"},
                                          {!given.forecasts.empty(), "--forecast"},
                                          {!given.at.empty(), "--at"},
                                          {!given.place.empty(), "--place"},
                                          {!given.track.empty(), "--track"}})
        if (isGiven)
            throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "%1 excludes %2"),
                             {option, "SCENARIO"});
}

void checkOptions(const DriftArguments& given)
{
    requireBeside(given.every_h.has_value(), "--every", false, "SCENARIO");
    const bool hasForecast = !given.forecasts.empty();
    const bool hasTrack = !given.track.empty();
    if (!given.length_m && given.size.empty())
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "%1 is required"), {"--length, --size"});
    requireBeside(given.wind_mps.has_value(), "--wind-speed", given.windFrom_deg.has_value(),
                  "--wind-from");
    requireBeside(given.windFrom_deg.has_value(), "--wind-from", given.wind_mps.has_value(),
                  "--wind-speed");
    requireBeside(given.current_mps.has_value(), "--current-speed", given.currentTo_deg.has_value(),
                  "--current-to");
    requireBeside(given.currentTo_deg.has_value(), "--current-to", given.current_mps.has_value(),
                  "--current-speed");
    if (!given.wind_mps && !given.current_mps && !hasForecast)
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "%1 is required"),
                         {"--wind-speed, --current-speed, --forecast"});
    requireBeside(!given.at.empty(), "--at", hasForecast, "--forecast");
    requireBeside(!given.place.empty(), "--place", hasForecast, "--forecast");
    requireBeside(given.duration_h.has_value(), "--hours", hasForecast, "--forecast");
    requireBeside(!given.outputFile.empty(), "--output", hasForecast || hasTrack,
                  "--forecast, --track");
    for (const auto& [isGiven, option] : {std::pair{!given.at.empty(), "--at"},
                                          {!given.place.empty(), "--place"},
                                          {given.duration_h.has_value(), "--hours"}})
        if (isGiven && hasTrack)
            throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "%1 excludes %2"),
                             {option, "--track"});
}

double lengthOf(const DriftArguments& given)
{
    if (given.length_m)
        return *given.length_m;
    return std::ranges::find(kIcebergSizes, given.size, &IcebergSize::name)->length_m;
}

DragCoefficients dragOf(const DriftArguments& given)
{
    return given.coefficients == kOpenBergDrag.name ? kOpenBergDrag : kCCoreDrag;
}

DriftLaw lawFor(const DriftArguments& given)
{
    return driftLaw(lengthOf(given), dragOf(given));
}

Forcing constantForcing(const DriftArguments& given)
{
    Forcing forcing;
    if (given.wind_mps)
        forcing.wind_mps = windFrom_mps(*given.wind_mps, *given.windFrom_deg);
    if (given.current_mps)
        forcing.current_mps = currentTo_mps(*given.current_mps, *given.currentTo_deg);
    return forcing;
}

double secondsOf(UtcTime time)
{
    return std::chrono::duration<double>(time.time_since_epoch()).count();
}

/** Throws `UsageError` if a forecast and options give the same quantity, or neither does. */
void requireOneSource(bool isForecast, bool isGiven, const char* options, const char* missing)
{
    if (isForecast && isGiven)
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "%1 excludes %2"),
                         {options, "--forecast"});
    if (!isForecast && !isGiven)
        throw UsageError(missing, {options});
}

/** Returns the combined forecast; throws `UsageError` if an option gives what it holds or lacks. */
Forecast forecastFor(const DriftArguments& given, const ForecastFiles& files)
{
    Forecast forecast = combined(files.forecasts);
    requireOneSource(
        gives(forecast, ForecastQuantity::Wind), given.wind_mps.has_value(),
        "--wind-speed, --wind-from",
        QT_TRANSLATE_NOOP("CommandLine",
                          "the forecasts hold no wind: add one that does, or give %1"));
    requireOneSource(
        gives(forecast, ForecastQuantity::Current), given.current_mps.has_value(),
        "--current-speed, --current-to",
        QT_TRANSLATE_NOOP("CommandLine",
                          "the forecasts hold no current: add one that does, or give %1"));
    return forecast;
}

/** Warns of the gaps in wind and current. */
void warnOfDriftGaps(const Forecast& forecast)
{
    std::vector<ForecastGap> gaps = gapsOf(forecast);
    std::erase_if(gaps, [](const ForecastGap& gap) {
        return gap.quantity != ForecastQuantity::Wind && gap.quantity != ForecastQuantity::Current;
    });
    warnOfGaps(gaps);
}

/** Returns the first time at which the forecast gives all that it ever gives of wind and current.
 */
std::optional<double> firstKnown_s(const Forecast& forecast, const ForcingAt& forcing)
{
    for (const ForecastEntry& entry : forecast.series)
        if (forcing(secondsOf(entry.time)))
            return secondsOf(entry.time);
    return std::nullopt;
}

std::vector<DriftPoint> forecastPath(const DriftArguments& given, const ForecastFiles& files,
                                     const Forecast& forecast, const ForcingAt& forcing)
{
    const std::optional<UtcTime> at = timeOf("--at", given.at);
    const double duration_h = given.duration_h.value_or(kUsualDuration_h);
    const std::optional<double> start_s =
        at ? std::optional(secondsOf(*at)) : firstKnown_s(forecast, forcing);
    const LatLon place = placeOf("--place", given.place).value_or(forecast.place);
    std::vector<DriftPoint> path;
    if (start_s)
        path = driftPath(
            {.place = place, .start_s = *start_s, .duration_s = duration_h * 3600, .every_s = 3600},
            lawFor(given), forcing);
    if (path.empty())
        throw UsageError(
            QT_TRANSLATE_NOOP("CommandLine", "--at: wind and current are not both known then; the "
                                             "forecast is from %1 to %2"),
            {utcText(forecast.series.front().time, 0), utcText(forecast.series.back().time, 0)});
    warnOfOldForecasts(files, UtcTime() + std::chrono::milliseconds(std::llround(*start_s * 1e3)));
    warnOfFarForecasts(files, place);
    if (const double known_h = (path.back().time_s - *start_s) / 3600; known_h + 1 <= duration_h)
        printNote(said(QT_TRANSLATE_NOOP("CommandLine", "wind and current are known for %1 h only"),
                       {fixed(known_h, 0)}));
    return path;
}

std::vector<DriftLeadError> trackErrors(const DriftArguments& given, const ForcingAt& forcing,
                                        const std::stop_token& stop)
{
    const std::vector<PlacedTrack> tracks = reading([&] { return loadTracks(given.track); });
    try {
        return driftErrors(tracks, lawFor(given), forcing, {}, stop);
    } catch (const Stopped&) {
        throw Interrupted{};
    }
}

/** Throws `UsageError` if the wind turns the drift to a side that depends on an unknown latitude.
 */
void requireLatitude(const DriftArguments& given)
{
    const bool isKnown = given.latitude_deg || !given.forecasts.empty() || !given.track.empty();
    if (lawFor(given).turn_deg != 0 && given.wind_mps && !isKnown)
        throw UsageError(QT_TRANSLATE_NOOP(
            "CommandLine", "--latitude is required: growlers and bergy bits drift to the right of "
                           "the wind in the north, to the left in the south"));
}

std::string velocityText(const Point& velocity_mps)
{
    const double speed_mps = velocity_mps.norm();
    return fixed(speed_mps, 3) + " m/s (" + fixed(speed_mps / kKnot_mps, 2) + " kn) towards " +
           fixed(directionTo_deg(velocity_mps), 0) + " deg";
}

std::string lawText(const DriftReport& report)
{
    const IcebergDimensions& d = report.dimensions;
    std::string text = "length     " + fixed(d.length_m, 1) + " m";
    const DriftLaw& law = report.law;
    if (law == kSmallIceDrift)
        return text + "\nlaw        the current and 2 % of the wind, turned 20 deg to the right in "
                      "the north, left in the south\n";
    text += ", draft " + fixed(d.draft_m, 0) + " m, sail " + fixed(d.sail_m2, 0) + " m2\n";
    return text + "law        " + fixed(100 * law.currentShare, 2) + " % of the current and " +
           fixed(100 * law.windShare, 2) + " % of the wind\n";
}

std::string pathTable(const std::vector<DriftPoint>& path)
{
    std::vector<std::vector<std::string>> rows{{"time", "latitude", "longitude", "m/s", "towards"}};
    for (const DriftPoint& point : path)
        rows.push_back({utcTextOf(point.time_s), fixed(point.place.latitude_deg, 4),
                        fixed(point.place.longitude_deg, 4), fixed(point.velocity_mps.norm(), 3),
                        fixed(directionTo_deg(point.velocity_mps), 0)});
    return tableLines(rows, rows[0].size());
}

std::string errorsTable(const std::vector<DriftLeadError>& errors)
{
    std::vector<std::vector<std::string>> rows{
        {"after h", "starts", "moved km", "error km", "last velocity km"}};
    for (const DriftLeadError& error : errors) {
        const auto km = [&](double distance_m) {
            return error.starts > 0 ? fixed(distance_m / 1000, 1) : std::string("-");
        };
        rows.push_back({fixed(error.lead_s / 3600, 0), std::to_string(error.starts),
                        km(error.moved_m), km(error.drift_m), km(error.lastVelocity_m)});
    }
    return tableLines(rows, rows[0].size()) +
           "mean distances from the recorded positions; last velocity: that of the 3 h before each "
           "start\n";
}

std::string reportText(const DriftReport& report)
{
    std::string text = lawText(report);
    if (report.velocity_mps)
        text += "drift      " + velocityText(*report.velocity_mps) + '\n';
    if (!report.path.empty())
        text += pathTable(report.path);
    if (!report.errors.empty())
        text += errorsTable(report.errors);
    return text;
}

int runDrift(const DriftArguments& given, const std::stop_token& stop)
{
    if (!given.scenario.empty()) {
        checkScenarioOptions(given);
        constexpr double kUsualInterval_h = 3;
        return driftOfScenario(
            {.file = given.scenario,
             .spec = {.every_s = 3600 * given.every_h.value_or(kUsualInterval_h),
                      .duration_s = 3600 * given.duration_h.value_or(kUsualDuration_h),
                      .drag = dragOf(given)},
             .outputFile = given.outputFile,
             .force = given.force,
             .json = given.json},
            stop);
    }
    checkOptions(given);
    requireLatitude(given);
    std::vector<std::string> inputs = given.forecasts;
    if (!given.track.empty())
        inputs.push_back(given.track);
    checkFiles({.inputs = inputs,
                .outputs = {{.option = "--output", .path = given.outputFile}},
                .force = given.force,
                .json = given.json});
    DriftReport report{.dimensions = dimensionsOfLength(lengthOf(given)), .law = lawFor(given)};
    const Forcing constant = constantForcing(given);
    ForcingAt forcing = [&constant](double) { return Forcing(constant); };
    if (given.forecasts.empty()) {
        if (given.latitude_deg || report.law.turn_deg == 0 || !given.wind_mps)
            report.velocity_mps =
                driftVelocity_mps(report.law, constant, given.latitude_deg.value_or(0));
    } else {
        const ForecastFiles files =
            readForecasts(given.forecasts, {.place = placeOf("--place", given.place)});
        const Forecast forecast = forecastFor(given, files);
        warnOfDriftGaps(forecast);
        forcing = forcingOf(forecast, constant);
        if (given.track.empty())
            report.path = forecastPath(given, files, forecast, forcing);
    }
    if (!given.track.empty())
        report.errors = trackErrors(given, forcing, stop);
    std::vector<NewFile> files;
    if (!given.outputFile.empty())
        files.push_back({.path = given.outputFile,
                         .content = given.track.empty() ? driftPathCsv(report.path)
                                                        : driftErrorsCsv(report.errors)});
    deliver(files, given.json ? driftJson(report) : reportText(report));
    return kDone;
}

CLI::Validator oneOf(const std::vector<std::string>& names)
{
    return {[names](const std::string& text) {
                return std::ranges::find(names, text) != names.end()
                           ? std::string()
                           : inOne(sentence(QT_TRANSLATE_NOOP("CommandLine", "%1 is none of %2"),
                                            {word(text), joined(names, ", ")}));
            },
            joined(names, ", ")};
}

std::vector<std::string> sizeNames()
{
    std::vector<std::string> names;
    for (const IcebergSize& size : kIcebergSizes)
        names.emplace_back(size.name);
    return names;
}

} // namespace

void addDriftCommand(CLI::App& app, Action& action)
{
    constexpr double kLongest_m = 1000; // tabular icebergs beyond are of other proportions
    constexpr double kLongest_h = 240;  // about as far as forecasts go
    CLI::App* command = app.add_subcommand(
        "drift", "Predict the drift of an iceberg from wind and current, or of the icebergs of a "
                 "scenario, and compare it with a recorded track");
    DriftArguments& a = argumentsOf(*command, action, runDrift);
    command->add_option(
        "SCENARIO", a.scenario,
        "Scenario whose icebergs drift in its forecast, else in its wind and current");
    CLI::Option* length = command->add_option("--length", a.length_m, "Length at the waterline, m")
                              ->check(numberFrom(0.1, kLongest_m));
    command->add_option("--size", a.size, "Size class in place of a length")
        ->check(oneOf(sizeNames()))
        ->excludes(length);
    command->add_option("--wind-speed", a.wind_mps, "Wind at 10 m, m/s")
        ->check(numberFrom(0, limits::kWindSpeed_mps.high));
    command->add_option("--wind-from", a.windFrom_deg, "Direction the wind comes from, degrees")
        ->check(numberFrom(0, 360));
    command->add_option("--current-speed", a.current_mps, "Current over the draft, m/s")
        ->check(numberFrom(0, limits::kSpeed_mps.high));
    command->add_option("--current-to", a.currentTo_deg, "Direction the current flows to, degrees")
        ->check(numberFrom(0, 360));
    command
        ->add_option("--latitude", a.latitude_deg, "Latitude, degrees; for growlers and bergy bits")
        ->check(numberFrom(-90, 90));
    command
        ->add_option("--coefficients", a.coefficients, "Densities and drag coefficients (c-core)")
        ->check(oneOf({std::string(kCCoreDrag.name), std::string(kOpenBergDrag.name)}));
    command->add_option("--forecast", a.forecasts,
                        "Forecast in place of a constant wind or current; may be repeated");
    command->add_option("--at", a.at, "Start of the drift, UTC (when wind and current are known)");
    command->add_option("--hours", a.duration_h, "Length of the drift, h (48)")
        ->check(numberFrom(1, kLongest_h));
    command
        ->add_option("--every", a.every_h,
                     "Hours between two points, for the scenario's icebergs (3)")
        ->check(numberFrom(0.25, kLongest_h));
    command->add_option("--place", a.place, "Start of the drift (the place of the forecast)");
    command->add_option("--track", a.track,
                        "Recorded positions to compare with, in any import format");
    addOutputFile(*command, "-o,--output", a.outputFile,
                  "CSV file for the path or the errors; for a scenario also .geojson");
    addForce(*command, a.force);
    command->add_flag("--json", a.json, "Print one JSON document");
}

} // namespace berg::cli
