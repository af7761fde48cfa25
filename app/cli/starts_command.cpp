#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/output_gate.h"
#include "core/checks/validate.h"
#include "core/io/figure/figure_svg.h"
#include "core/io/files/scenario_json.h"
#include "core/io/results/start_scan_result.h"
#include "core/io/study/start_figure.h"

#include <CLI/CLI.hpp>
#include <cmath>

namespace berg::cli {

namespace {

struct StartsArguments
{
    std::string file;
    double span_h = 24;
    double every_h = 1;
    std::optional<int> threads;
    std::string outputFile;
    std::string chartFile;
    bool force = false;
    bool json = false;
};

std::string startsTable(const StartScan& scan)
{
    std::vector<std::vector<std::string>> rows{
        {"start", "zeta m2 s", "to first", "visits", "weather", ""}};
    const std::optional<double> first_m2s = scan.starts.front().zeta_m2s;
    for (std::size_t i = 0; i < scan.starts.size(); ++i) {
        const StartOutcome& start = scan.starts[i];
        const double change = start.zeta_m2s && first_m2s && *first_m2s > 0
                                  ? 100 * (*start.zeta_m2s / *first_m2s - 1)
                                  : 0;
        const double shown = std::round(change * 10) / 10;
        rows.push_back({start.startUtc, start.zeta_m2s ? grouped(*start.zeta_m2s) : "-",
                        (shown > 0 ? "+" : "") + fixed(shown == 0 ? 0 : shown, 1) + " %",
                        std::to_string(start.visits), std::string(nameOf(start.weather.state())),
                        (scan.best == i ? "best  " : "") + word(startReasonText(scan, start))});
    }
    std::string text = tableLines(rows, rows.front().size() - 1);
    if (!scan.best)
        text += "no start has weather that is go or marginal\n";
    return text;
}

int runStarts(const StartsArguments& arguments, const std::stop_token& stop)
{
    checkFiles({.inputs = {arguments.file},
                .outputs = {{.option = "--output", .path = arguments.outputFile},
                            {.option = "--chart", .path = arguments.chartFile}},
                .force = arguments.force,
                .json = arguments.json});
    const Scenario scenario = reading([&] { return loadScenario(arguments.file); });
    if (arguments.span_h / arguments.every_h >= static_cast<double>(kMostStarts))
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "--hours, --every: more than %1 starts"),
                         {countOf(kMostStarts)});
    printWarnings(arguments.file, validate(scenario));
    const StartScanSpec spec{.every_s = 3600 * arguments.every_h,
                             .span_s = 3600 * arguments.span_h};
    std::optional<StartScan> scan;
    {
        ProgressBar bar(said(QT_TRANSLATE_NOOP("CommandLine", "flying"), {}), !arguments.json);
        const double count = std::floor(spec.span_s / spec.every_s) + 1;
        scan = naming(arguments.file, [&] {
            return scanStarts(
                scenario, spec,
                {.threads = arguments.threads, .stop = stop, .onProgress = [&](std::size_t done) {
                     bar.update(static_cast<double>(done) / count);
                 }});
        });
    }
    if (!scan)
        throw Interrupted{};
    constexpr double kChartWidth_px = 760;
    constexpr double kChartHeight_px = 320;
    std::vector<NewFile> files;
    if (!arguments.outputFile.empty())
        files.push_back({.path = arguments.outputFile, .content = startScanCsv(*scan)});
    if (!arguments.chartFile.empty())
        files.push_back(
            {.path = arguments.chartFile,
             .content = figureSvgFile(startFigure(*scan), kChartWidth_px, kChartHeight_px)});
    deliver(files, arguments.json ? startScanJson(*scan) : startsTable(*scan));
    return kDone;
}

} // namespace

void addStartsCommand(CLI::App& app, Action& action)
{
    CLI::App* command = app.add_subcommand(
        "starts", "Compare start times: zeta of the flight, and its weather against the limits of "
                  "the UAVs");
    StartsArguments& a = argumentsOf(*command, action, runStarts);
    command->add_option("SCENARIO", a.file, "Scenario with a start time")->required();
    command->add_option("--hours", a.span_h, "Latest start, h after the scenario's (24)")
        ->check(numberFrom(0, 240));
    command->add_option("--every", a.every_h, "Time between two starts, h (1)")
        ->check(numberFrom(1.0 / 60, 240));
    command->add_option("--threads", a.threads, "Threads (one per core)")
        ->transform(wholeFrom(1, 1024));
    addOutputFile(*command, "-o,--output", a.outputFile, "CSV file for the table");
    addOutputFile(*command, "--chart", a.chartFile, "SVG file for the chart");
    addForce(*command, a.force);
    command->add_flag("--json", a.json, "Print one JSON document");
}

} // namespace berg::cli
