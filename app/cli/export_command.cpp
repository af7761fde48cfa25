#include "app/cli/options.h"
#include "app/cli/output_gate.h"
#include "app/cli/program.h"
#include "core/base/stopped.h"
#include "core/checks/validate.h"
#include "core/io/export/export_notes.h"
#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/io/text/atomic_file.h"
#include "core/io/text/file_set.h"
#include "core/io/text/stop_scope.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace berg::cli {

namespace {

std::string formatIds()
{
    return joined(exportFormats(), ", ", &ExportFormat::id);
}

struct ExportArguments
{
    std::string file;
    std::string format;
    std::string outputFile;
    ExportOptions options;
    bool force = false;
    ExportPainter painter; ///< if empty, the program bergwatch paints, with the arguments `argv`
    char** argv = nullptr;
};

void printNotes(const ExportFormat& format, const ExportContent& content)
{
    for (const ExportNote& note : exportNotes(format, content))
        printNote(said(QT_TRANSLATE_NOOP("CommandLine", "note: %1"),
                       {word(said(notePattern(note.kind), noteArguments(note)))}));
}

/** Adds the files made from `source` to the set and prints notes for the user. Options that
 * cannot be met are wrong usage. */
void addExported(FileSet& set, const ExportSource& source, const ExportArguments& arguments,
                 const ExportFormat& format)
try {
    const ExportContent content =
        reading([&] { return format.content(source, arguments.options); });
    const bool isAdded = format.table != nullptr && source.mission != nullptr; // `rowsInto`
    if (format.holds.fleet && !format.holds.painted && !isAdded) { // as long as it may be
        StagedFile& file = set.add(arguments.outputFile);
        format.put(content, [&file](std::string_view piece) { file.append(piece); });
    } else if (!isAdded) {
        for (const ExportFile& file : reading([&] {
                 return exportFiles(format, content, arguments.outputFile, arguments.painter);
             }))
            set.add(file.path).append(file.content);
    }
    printNotes(format, content);
} catch (const Error& error) {
    if (error.code() != ErrorCode::InvalidInput)
        throw;
    throw UsageError(
        Sentence{.english = std::string("--") + error.what(), .said = "--" + said(error)});
}

/** Adds the rows of each sample, so that memory does not grow with the length of the flight. */
SampleSink rowsInto(StagedFile& file, const SampleTable& table, SampleTables tables)
{
    file.append((tables.*table.header)());
    return [&file, &table, tables = std::move(tables), rows = std::string()](
               const Sample& sample, std::span<const IcebergSample> icebergs) mutable {
        rows.clear();
        table.addRows(tables, rows, sample, icebergs);
        file.append(rows);
    };
}

/** Keeps where each UAV is, or only where it is last, and of a sample nothing else. */
SampleSink pointsInto(std::vector<TrackPoints>& flown, std::size_t uavs, bool all)
{
    flown.resize(uavs);
    return [&flown, all](const Sample& sample, std::span<const IcebergSample> /*icebergs*/) {
        for (std::size_t row = 0; row < flown.size(); ++row) {
            if (!all)
                flown[row].clear();
            flown[row].append(trackPointOf(sample, row));
        }
    };
}

/** Before any work: the files that an export of the scenario's UAVs comes to. */
void checkOutputs(const ExportArguments& arguments, const ExportFormat& format,
                  const Scenario& scenario)
{
    std::vector<ExportUavId> uavs;
    for (std::size_t row = 0; row < scenario.uavs.size(); ++row)
        if (const std::string& id = scenario.uavs[row].id;
            !arguments.options.uav || arguments.options.uav == id)
            uavs.push_back({.row = row, .id = id});
    CommandFiles files{.inputs = {arguments.file}, .outputs = {}, .force = arguments.force};
    const std::vector<std::string> paths = exportPaths(format, uavs, arguments.outputFile);
    if (paths.size() > 1 && isOpenDescriptor(arguments.outputFile))
        throw UsageError(QT_TRANSLATE_NOOP(
            "CommandLine",
            "--output: this format writes one file per UAV; choose a UAV with --uav"));
    for (const std::string& path : paths)
        files.outputs.push_back({.option = "--output", .path = path});
    checkFiles(files);
}

void addFiles(FileSet& set, const ExportArguments& arguments, const ExportFormat& format,
              const std::stop_token& stop)
{
    const std::string text = reading([&] { return readFile(arguments.file); });
    const auto planned = [&](const Scenario& scenario) {
        Plan plan = naming(arguments.file, [&] { return planFromStart(scenario, {.stop = stop}); });
        if (stop.stop_requested())
            throw Interrupted{};
        return plan;
    };
    if (formatOf(text, arguments.file) != "bergwatch-run") {
        const Scenario scenario = reading([&] { return scenarioFromJson(text, arguments.file); });
        checkOutputs(arguments, format, scenario);
        printWarnings(arguments.file, validate(scenario));
        const Plan plan = planned(scenario);
        addExported(set, {.scenario = scenario, .plan = plan, .words = reportLanguage()}, arguments,
                    format);
        return;
    }
    const RunFile run = reading([&] { return runFromJson(text, arguments.file); });
    checkOutputs(arguments, format, run.scenario);
    std::vector<TrackPoints> flown;
    SampleSink sink;
    if (format.table != nullptr)
        sink = rowsInto(set.add(arguments.outputFile), *format.table,
                        sampleTables(run.scenario, run.interventions));
    else if (!format.holds.flownOnly && !format.holds.painted)
        sink = pointsInto(flown, run.scenario.uavs.size(), format.holds.path);
    const Mission mission =
        naming(arguments.file, [&] { return replay(run, stop, {}, std::move(sink)); });
    if (stop.stop_requested())
        throw Interrupted{};
    const Plan plan = planned(run.scenario);
    std::optional<ZetaPrediction> predicted;
    if (format.holds.predicted)
        predicted =
            naming(arguments.file, [&] { return predictZeta(run.scenario, {.stop = stop}); });
    if (stop.stop_requested())
        throw Interrupted{};
    addExported(set,
                {.scenario = run.scenario,
                 .plan = plan,
                 .mission = &mission,
                 .flown = flown,
                 .predicted = predicted,
                 .words = reportLanguage()},
                arguments, format);
}

/** That of --format, else the first one whose files end as --output does. */
const ExportFormat& chosenFormat(const ExportArguments& arguments)
{
    if (const ExportFormat* format = findExportFormat(arguments.format))
        return *format;
    if (!arguments.format.empty())
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "--format: %1 is none of %2"),
                         {arguments.format, formatIds()});
    const std::string suffix = std::filesystem::path(arguments.outputFile).extension().string();
    for (const ExportFormat& format : exportFormats())
        if (suffix == '.' + std::string(format.extension))
            return format;
    throw UsageError(
        QT_TRANSLATE_NOOP("CommandLine",
                          "--output: no format has the suffix of %1; choose one with --format: %2"),
        {arguments.outputFile, formatIds()});
}

/** Returns only where there is no such program. */
int handOver(const ExportArguments& arguments)
{
    checkFiles({.inputs = {arguments.file},
                .outputs = {{.option = "--output", .path = arguments.outputFile}},
                .force = arguments.force});
    becomeBergwatch(arguments.argv);
    printMessage(said(QT_TRANSLATE_NOOP("CommandLine",
                                        "--format %1: the program bergwatch paints this format, "
                                        "but it is neither in this folder nor on the PATH"),
                      {std::string(chosenFormat(arguments).id)}));
    return kFailure;
}

int exportFile(const ExportArguments& arguments, const std::stop_token& stop)
{
    const ExportFormat& format = chosenFormat(arguments);
    if (format.holds.painted && !arguments.painter)
        return handOver(arguments);
    FileSet set;
    try {
        const StopScope scope(stop);
        addFiles(set, arguments, format, stop);
    } catch (const Stopped&) {
        throw Interrupted{};
    }
    if (stop.stop_requested())
        throw Interrupted{};
    set.write();
    return kDone;
}

void addOptions(CLI::App& command, ExportArguments& arguments)
{
    ExportOptions& options = arguments.options;
    command.add_option("FILE", arguments.file, "Scenario (.berg) or run (.bergrun)")->required();
    command.add_option("-f,--format", arguments.format,
                       formatIds() + " (that of the suffix of --output)");
    addOutputFile(command, "-o,--output", arguments.outputFile,
                  "File to write; with several UAVs, formats that hold one UAV write one file "
                  "per UAV, with its id in the name")
        ->required();
    addNamed(command, "--what", options.what, kExportScopeNames,
             "What to export (a run: track, a scenario: order)");
    command.add_option("--uav", options.uav, "Id of one UAV (all of them)");
    command.add_option("--altitude", options.altitude_m, "Flight altitude, m (the scenario's)")
        ->check(numberFrom(limits::kExtent_m.low, limits::kExtent_m.high));
    command.add_option("--speed", options.airspeed_mps, "Airspeed, m/s (the scenario's)")
        ->check(numberFrom(limits::kAirspeed_mps.low, limits::kAirspeed_mps.high));
    command
        .add_option("--acceptance", options.acceptance_m,
                    "Radius within which a waypoint counts as reached, m (the scenario's "
                    "acceptance radius, else the field of view's)")
        ->check(numberFrom(limits::kExtent_m.low, limits::kExtent_m.high));
    command.add_option("--loiter", options.loiterTurns, "Turns over each iceberg (0)")
        ->transform(wholeFrom(0, kMostLoiterTurns));
    CLI::Option* home = command.add_flag_callback(
        "--return-home", [&options] { options.returnHome = true; },
        "End at home (with limited endurance or a closed route)");
    command
        .add_flag_callback(
            "--no-return-home", [&options] { options.returnHome = false; },
            "End over the last iceberg")
        ->excludes(home);
    addForce(command, arguments.force);
}

/** The arguments live as long as `app` does. */
ExportArguments& addCommand(CLI::App& app, Action& action)
{
    CLI::App* command = app.add_subcommand(
        "export",
        "Write a scenario's plan or a run's flight in another tool's format, or on paper");
    ExportArguments& arguments = argumentsOf(*command, action, exportFile);
    addOptions(*command, arguments);
    return arguments;
}

} // namespace

void addExportCommand(CLI::App& app, Action& action, char** argv)
{
    addCommand(app, action).argv = argv;
}

void addExportCommand(CLI::App& app, Action& action, const ExportPainter& painter)
{
    addCommand(app, action).painter = painter;
}

} // namespace berg::cli
