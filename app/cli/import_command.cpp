#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/output_gate.h"
#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/io/import/import_airspace.h"
#include "core/io/import/import_formats.h"
#include "core/io/import/import_scenario.h"
#include "core/io/text/atomic_file.h"
#include "core/io/text/json_writer.h"
#include "core/scenario/validate.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>

namespace berg::cli {

namespace {

struct ImportArguments
{
    std::string file;
    std::string format = "auto";
    std::string outputFile;
    std::string intoFile; ///< empty: a new scenario
    std::vector<std::string> mappings;
    std::optional<DateOrder> dates;
    std::string at;
    std::string since;
    std::string until;
    std::string area;
    std::string positionError;
    std::optional<double> spread_mps;
    std::optional<double> velocityTime_s;
    std::optional<double> q_m2ps;
    bool withTracks = false;
    bool force = false;
    bool json = false;
};

constexpr std::array<Named<DateOrder>, 2> kDateOrderNames{{
    {DateOrder::MonthFirst, "month-first"},
    {DateOrder::DayFirst, "day-first"},
}};

constexpr const char* kAirspaceFormat = "airspace"; ///< no sightings: added to a scenario

std::string formatList()
{
    return "auto, " + joined(importFormats(), ", ", &ImportFormat::id) + ", " + kAirspaceFormat;
}

std::optional<UtcTime> timeOf(const std::string& option, const std::string& text)
{
    if (text.empty())
        return std::nullopt;
    const std::optional<UtcTime> time = parseTypedTime(text);
    if (!time)
        throw UsageError(
            QT_TRANSLATE_NOOP("CommandLine", "%1: %2 is no UTC time such as 2026-05-01T12:00:00Z"),
            {option, text});
    return time;
}

/** "S,W,N,E" in degrees. */
std::optional<GeoBox> areaOf(const std::string& text)
{
    if (text.empty())
        return std::nullopt;
    std::array<double, 4> edges_deg{};
    const char* at = text.data();
    const char* const end = at + text.size();
    bool ok = true;
    for (std::size_t i = 0; ok && i < edges_deg.size(); ++i) {
        const auto [next, error] = std::from_chars(at, end, edges_deg[i]);
        const bool last = i + 1 == edges_deg.size();
        ok = error == std::errc() && std::isfinite(edges_deg[i]) &&
             (last ? next == end : next != end && *next == ',');
        at = next + (last ? 0 : 1);
    }
    if (!ok)
        throw UsageError(
            QT_TRANSLATE_NOOP("CommandLine", "--area: %1 is not SOUTH,WEST,NORTH,EAST in degrees"),
            {text});
    return GeoBox{.south_deg = edges_deg[0],
                  .west_deg = edges_deg[1],
                  .north_deg = edges_deg[2],
                  .east_deg = edges_deg[3]};
}

/** "FIELD=COLUMN". */
FieldColumn mappingOf(const std::string& text)
{
    const std::size_t equals = text.find('=');
    const std::optional<SightingField> field = valueOf(kSightingFieldNames, text.substr(0, equals));
    if (equals == std::string::npos || !field)
        throw UsageError(
            QT_TRANSLATE_NOOP("CommandLine", "--map: %1 is not FIELD=COLUMN with a field of %2"),
            {text, allowedNames(kSightingFieldNames)});
    return {.field = *field, .column = text.substr(equals + 1)};
}

/** A column holds one field, and a field is in one column. */
void addMapping(ColumnMapping& mapping, FieldColumn added)
{
    for (const FieldColumn& known : mapping) {
        const bool isColumn = known.column == added.column;
        if (isColumn || known.field == added.field)
            throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "--map: %1 is mapped twice"),
                             {isColumn ? word(added.column)
                                       : std::string(nameOf(kSightingFieldNames, added.field))});
    }
    mapping.push_back(std::move(added));
}

/** Metres, or how the positions were got. */
std::optional<double> positionErrorOf(const std::string& text)
{
    if (text.empty())
        return std::nullopt;
    if (const std::optional<double> known_m = valueOf(kPositionErrorNames, text))
        return known_m;
    double error_m = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), error_m);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(error_m))
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine",
                                           "--position-error: %1 is neither metres nor one of %2"),
                         {text, allowedNames(kPositionErrorNames)});
    return error_m;
}

ImportOptions optionsOf(const ImportArguments& arguments)
{
    ImportOptions options{.at = timeOf("--at", arguments.at),
                          .since = timeOf("--since", arguments.since),
                          .until = timeOf("--until", arguments.until),
                          .area = areaOf(arguments.area),
                          .withTracks = arguments.withTracks};
    options.positionSd_m = positionErrorOf(arguments.positionError);
    DriftProcess& drift = options.track.drift;
    drift.velocitySpread_mps = arguments.spread_mps.value_or(drift.velocitySpread_mps);
    drift.velocityTime_s = arguments.velocityTime_s.value_or(drift.velocityTime_s);
    options.q_m2ps = arguments.q_m2ps.value_or(options.q_m2ps);
    if (options.withTracks && !options.at)
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine",
                                           "--with-tracks needs --at: the tracks are what was "
                                           "sighted after it"));
    return options;
}

/** Their names; the start of a long list. */
std::string unusedColumns(const SightingTable& table)
{
    constexpr std::size_t kMost = 20;
    std::string text;
    for (std::size_t i = 0; i < std::min(kMost, table.unused.size()); ++i)
        text += (i > 0 ? ", " : "columns ") + word(table.unused[i]);
    return table.unused.size() > kMost ? text + ", ..." : text;
}

std::string summary(const SightingTable& table, const ImportResult& result)
{
    std::string text = "format     " + table.format + '\n';
    const auto add = [&](const char* what, std::size_t count, const char* of) {
        char line[80];
        std::snprintf(line, sizeof line, "%-10s %s %s\n", what,
                      grouped(static_cast<double>(count)).c_str(), of);
        text += line;
    };
    add("read", table.sightings.size(), "sightings");
    if (result.rejected.count > 0)
        add("rejected", result.rejected.count, "rows");
    if (result.outsideArea > 0)
        add("not taken", result.outsideArea, "sightings outside the area");
    if (result.outsideTime > 0)
        add("not taken", result.outsideTime, "sightings outside the time");
    add("added", result.added, "icebergs");
    add("updated", result.updated, "icebergs");
    add("unchanged", result.unchanged, "icebergs");
    if (result.leftOut > 0)
        add("left out", result.leftOut, "icebergs");
    if (!table.unused.empty())
        text += "not used   " + unusedColumns(table) + '\n';
    for (const SceneFinding& finding : result.scene)
        text += "scene      " + sceneFindingText(finding) + '\n';
    if (result.observerSet)
        text += "observer   kalman: velocities are not known exactly\n";
    if (result.at)
        text += "start      " + result.scenario.startUtc + '\n';
    return text;
}

/** "line 3" is translated by whoever says it. */
std::string saidPlace(const Rejections& rejected, std::size_t number)
{
    if (rejected.place == "feature")
        return said(QT_TRANSLATE_NOOP("CommandLine", "feature %1"), {countOf(number)});
    if (rejected.place == "packet")
        return said(QT_TRANSLATE_NOOP("CommandLine", "packet %1"), {countOf(number)});
    return placeOf(rejected, number);
}

constexpr std::size_t kMostRows = 100; ///< of a list on stderr

void printRejected(const std::string& file, const Rejections& rejected)
{
    std::size_t told = 0;
    for (const RejectedRow& row : rejected.first)
        if (told++ < kMostRows)
            tell(word(file) + ": " +
                 said(Issue{Severity::Error, saidPlace(rejected, row.line), reasonOf(row)}));
    if (rejected.count > kMostRows)
        tell(word(file) + ": " +
             said(QT_TRANSLATE_NOOP("CommandLine", "and %1 more"),
                  {countOf(rejected.count - kMostRows)}));
}

/** What was not taken, and why, on stderr; the start of a long list. */
void printDetails(const std::string& file, const ImportResult& result)
{
    printRejected(file, result.rejected);
    std::size_t notes = 0;
    for (const ImportedIceberg& iceberg : result.icebergs)
        for (const ImportNote note : iceberg.notes)
            if ((iceberg.outcome == ImportOutcome::LeftOut || note == ImportNote::VelocityClamped ||
                 note == ImportNote::GrowthClamped || note == ImportNote::Jumped ||
                 note == ImportNote::Repeated || note == ImportNote::TimeUnknown) &&
                notes++ < kMostRows)
                tell(word(file) + ": " + word(iceberg.id) + ": " + said(importNoteText(note), {}));
    if (notes > kMostRows)
        tell(word(file) + ": " +
             said(QT_TRANSLATE_NOOP("CommandLine", "and %1 more notes on icebergs"),
                  {countOf(notes - kMostRows)}));
}

SightingTable sightingsOf(const std::string& file, const ReadOptions& formats)
{
    const std::string text = readFile(file);
    try {
        return readSightings(text, file, formats);
    } catch (const Error& error) {
        constexpr std::size_t kHead = 100;
        const bool isOurs =
            std::string_view(text).substr(0, kHead).find("\"bergwatch-") != std::string_view::npos;
        const bool isUnknown = error.issues().front().reason.id == IssueId::UnknownFormat;
        if (isUnknown && isOpenAir(text))
            throw UsageError(
                QT_TRANSLATE_NOOP("CommandLine",
                                  "%1 is airspace: use --format airspace with --into SCENARIO"),
                {file});
        if (!isOurs || !isUnknown)
            throw;
        throw Error(ErrorCode::WrongFormat, file,
                    {{Severity::Error,
                      "format",
                      {IssueId::OtherFormat, {"sightings", formatOf(text, file)}}}});
    }
}

std::pair<SightingTable, ImportResult>
imported(const ImportArguments& arguments, const ReadOptions& formats, const ImportOptions& options)
{
    const std::string& output = arguments.outputFile;
    const std::filesystem::path named = isOpenDescriptor(output) ? arguments.file : output;
    const Scenario base = arguments.intoFile.empty() ? newScenarioForImport(named.stem().string())
                                                     : loadScenario(arguments.intoFile);
    SightingTable table = sightingsOf(arguments.file, formats);
    try {
        ImportResult result = importSightings(base, table, options);
        return {std::move(table), std::move(result)};
    } catch (const Error& error) {
        if (error.code() != ErrorCode::FileTooLarge)
            throw;
        throw Error(error.code(), arguments.file, error.issues());
    }
}

/** What of the file was not taken, on stderr, and how much was. */
std::string airspaceSummary(const std::string& file, const AirspaceResult& result)
{
    printRejected(file, result.rejected);
    std::string text = "added      " + std::to_string(result.added) + " areas\n";
    if (result.known > 0)
        text += "known      " + std::to_string(result.known) + " areas\n";
    if (result.far > 0)
        text += "left out   " + std::to_string(result.far) + " areas farther than 100 km\n";
    if (result.tooMany > 0)
        text += "left out   " + std::to_string(result.tooMany) + " areas: a scenario holds " +
                std::to_string(kMostAirspaceAreas) + '\n';
    if (result.rejected.count > 0)
        text += "rejected   " + std::to_string(result.rejected.count) + " areas\n";
    return text;
}

/** Whether there is an option that is about sightings. */
bool isAboutSightings(const ImportArguments& given)
{
    const auto isGiven = [](const std::string& text) { return !text.empty(); };
    return !given.mappings.empty() || given.dates || given.spread_mps || given.velocityTime_s ||
           given.q_m2ps || given.withTracks || isGiven(given.at) || isGiven(given.since) ||
           isGiven(given.until) || isGiven(given.area) || isGiven(given.positionError);
}

int importAirspaceFile(const ImportArguments& arguments)
{
    if (arguments.intoFile.empty())
        throw UsageError(QT_TRANSLATE_NOOP(
            "CommandLine", "--format airspace needs --into, the scenario that it is added to"));
    if (isAboutSightings(arguments))
        throw UsageError(QT_TRANSLATE_NOOP(
            "CommandLine",
            "--format airspace goes with --into, --output, --force and --json alone"));
    checkFiles({.inputs = {arguments.file},
                .outputs = {{.option = "--output", .path = arguments.outputFile}},
                .force = arguments.force,
                .json = arguments.json});
    const AirspaceResult result = reading([&] {
        return importAirspace(loadScenario(arguments.intoFile), readFile(arguments.file),
                              arguments.file);
    });
    const NewFile file{.path = arguments.outputFile, .content = scenarioToJson(result.scenario)};
    JsonObject json;
    json.add("added", result.added);
    json.add("known", result.known);
    json.add("far", result.far);
    json.add("too_many", result.tooMany);
    json.add("rejected", result.rejected.count);
    deliver({&file, 1},
            arguments.json ? json.inLines(0) + '\n' : airspaceSummary(arguments.file, result));
    return kDone;
}

int importFile(const ImportArguments& arguments, const std::stop_token& /*stop*/)
{
    if (arguments.file == "/dev/stdin" && arguments.intoFile == arguments.file)
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "%1 excludes %2"),
                         {"FILE -", "--into -"});
    if (arguments.format == kAirspaceFormat)
        return importAirspaceFile(arguments);
    if (arguments.format != "auto" && findImportFormat(arguments.format) == nullptr)
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "--format: %1 is none of %2"),
                         {arguments.format, formatList()});
    ReadOptions formats{.format = arguments.format, .mapping = {}, .dates = arguments.dates};
    for (const std::string& mapping : arguments.mappings)
        addMapping(formats.mapping, mappingOf(mapping));
    const ImportOptions options = optionsOf(arguments);
    // Not an input that must stay: an import adds to the scenario, which --force may overwrite.
    checkFiles({.inputs = {arguments.file},
                .outputs = {{.option = "--output", .path = arguments.outputFile}},
                .force = arguments.force,
                .json = arguments.json});
    const auto [table, result] = reading([&] { return imported(arguments, formats, options); });
    if (!table.guessedDate.empty())
        printWarnings(arguments.file, {{Severity::Warning,
                                        saidPlace(table.rejected, table.guessedLine),
                                        {IssueId::MonthFirst, {table.guessedDate}}}});
    if (!arguments.json)
        printDetails(arguments.file, result);
    if (result.added + result.updated + result.unchanged == 0)
        throw Error(ErrorCode::InvalidInput, arguments.file,
                    {IssueId::NothingTaken, {countOf(table.sightings.size())}});
    const NewFile file{.path = arguments.outputFile, .content = scenarioToJson(result.scenario)};
    deliver({&file, 1}, arguments.json ? importJson(table, result) : summary(table, result));
    return kDone;
}

} // namespace

void addImportCommand(CLI::App& app, Action& action)
{
    CLI::App* command =
        app.add_subcommand("import", "Make a scenario of sightings of real icebergs");
    ImportArguments& a = argumentsOf(*command, action, importFile);
    command->add_option("FILE", a.file, "File of sightings")->required();
    command->add_option("-f,--format", a.format, formatList())->capture_default_str();
    addOutputFile(*command, "-o,--output", a.outputFile, "Scenario to write")->required();
    addForce(*command, a.force);
    command->add_option("--into", a.intoFile, "Scenario to add to (a new one)");
    command->add_option("--map", a.mappings,
                        "FIELD=COLUMN (columns by their names): " +
                            allowedNames(kSightingFieldNames));
    addNamed(*command, "--dates", a.dates, kDateOrderNames,
             "Dates such as 05/02/2021 (as the file's other dates tell)");
    command->add_option("--at", a.at, "Start, UTC (the last sighting)");
    command->add_option("--since", a.since, "Leave out what was sighted before, UTC");
    command->add_option("--until", a.until, "Leave out what was sighted after, UTC");
    command->add_option("--area", a.area, "SOUTH,WEST,NORTH,EAST in degrees (everywhere)");
    command->add_option("--position-error", a.positionError,
                        "Standard deviation of positions where the file has none: metres, " +
                            allowedNames(kPositionErrorNames) + " (by the format)");
    command
        ->add_option("--drift-variation", a.spread_mps,
                     "Standard deviation of velocities that are not known, m/s (0.15)")
        ->check(numberFrom(0, kLargestVelocity_mps));
    command
        ->add_option("--drift-time", a.velocityTime_s,
                     "Time in which velocities change, s; 0: never (36000)")
        ->check(numberFrom(0, kLargestTime_s));
    command
        ->add_option("--variance-growth", a.q_m2ps, "q where it cannot be estimated, m^2/s (0.025)")
        ->check(numberFrom(0, kLargestGrowth_m2ps));
    command->add_flag("--with-tracks", a.withTracks, "Sightings after --at become the true motion");
    command->add_flag("--json", a.json, "Print one JSON document");
}

} // namespace berg::cli
