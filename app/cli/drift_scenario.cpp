#include "app/cli/drift_scenario.h"

#include "app/cli/console.h"
#include "app/cli/output_gate.h"
#include "core/base/stopped.h"
#include "core/checks/validate.h"
#include "core/io/files/scenario_json.h"
#include "core/io/results/drift_tracks_result.h"
#include "core/scenario/utc_time.h"

#include <algorithm>

namespace berg::cli {

namespace {

/** Throws `UsageError` if one iceberg would have too many points, or all of them together. */
void checkSize(const DriftScenarioArguments& arguments, std::size_t icebergs)
{
    constexpr double kMostPoints = 1e6;
    const double points = arguments.spec.duration_s / arguments.spec.every_s + 1;
    if (points * static_cast<double>(icebergs) > kMostPoints)
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "--hours, --every: more than %1 points"),
                         {kMostPoints});
}

DriftTracksReport reportOf(const Scenario& scenario, const DriftTrackSpec& spec,
                           const std::stop_token& stop)
{
    try {
        DriftTracksReport report{
            .scenario = scenario, .tracks = driftTracks(scenario, spec, stop), .errors = {}};
        for (const Iceberg& iceberg : scenario.icebergs)
            report.errors.push_back(iceberg.track.empty()
                                        ? std::vector<DriftLeadError>()
                                        : recordedDriftErrors(scenario, iceberg, spec.drag, stop));
        return report;
    } catch (const Stopped&) {
        throw Interrupted{};
    }
}

/** Notes how far the forecast goes, once for all icebergs, and which icebergs ground. */
void noteEnds(const DriftTracksReport& report)
{
    std::optional<double> shortest_s;
    for (const DriftTrack& track : report.tracks) {
        const double known_s = track.points.empty() ? 0 : track.points.back().time_s;
        if (track.end == DriftTrackEnd::ForecastEnds)
            shortest_s = std::min(shortest_s.value_or(known_s), known_s);
        if (track.grounded_s)
            printNote(said(QT_TRANSLATE_NOOP("CommandLine", "%1 is aground from hour %2 on"),
                           {word(report.scenario.icebergs[track.iceberg].id),
                            fixed(*track.grounded_s / 3600, 1)}));
    }
    if (shortest_s)
        printNote(said(
            QT_TRANSLATE_NOOP("CommandLine", "the forecast gives wind and current for %1 h only"),
            {fixed(*shortest_s / 3600, 1)}));
}

std::string tracksTable(const DriftTracksReport& report)
{
    const bool hasErrors = std::ranges::any_of(
        report.errors, [](const std::vector<DriftLeadError>& errors) { return !errors.empty(); });
    const std::optional<ForecastTime> start = startTime(report.scenario);
    std::vector<std::vector<std::string>> rows{{"iceberg", start ? "UTC" : "time", "after h",
                                                "latitude", "longitude", "m/s", "towards",
                                                "sd km"}};
    if (hasErrors)
        rows.front().emplace_back("error km");
    for (const DriftTrack& track : report.tracks)
        for (const DriftTrackPoint& point : track.points) {
            rows.push_back(
                {word(report.scenario.icebergs[track.iceberg].id),
                 start ? minuteText(*start, point.time_s) : fixed(point.time_s, 0) + " s",
                 fixed(point.time_s / 3600, 1), fixed(point.place.latitude_deg, 4),
                 fixed(point.place.longitude_deg, 4),
                 point.isAground ? "aground" : fixed(point.velocity_mps.norm(), 3),
                 fixed(directionTo_deg(point.velocity_mps), 0), fixed(point.sd_m / 1000, 2)});
            if (hasErrors)
                rows.back().push_back(point.error_m ? fixed(*point.error_m / 1000, 2) : "-");
        }
    return tableLines(rows, rows.front().size()) +
           "sd: standard deviation of the position along each axis\n";
}

} // namespace

int driftOfScenario(const DriftScenarioArguments& arguments, const std::stop_token& stop)
{
    checkFiles({.inputs = {arguments.file},
                .outputs = {{.option = "--output", .path = arguments.outputFile}},
                .force = arguments.force,
                .json = arguments.json});
    const Scenario scenario = reading([&] { return loadScenario(arguments.file); });
    printWarnings(arguments.file, validate(scenario));
    checkSize(arguments, scenario.icebergs.size());
    const DriftTracksReport report = reportOf(scenario, arguments.spec, stop);
    noteEnds(report);
    std::vector<NewFile> files;
    if (!arguments.outputFile.empty())
        files.push_back({.path = arguments.outputFile,
                         .content = arguments.outputFile.ends_with(".geojson")
                                        ? driftTracksGeoJson(report)
                                        : driftTracksCsv(report)});
    deliver(files, arguments.json ? driftTracksJson(report) : tracksTable(report));
    return kDone;
}

} // namespace berg::cli
