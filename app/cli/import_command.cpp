#include "app/cli/commands.h"
#include "app/cli/forecast_files.h"
#include "app/cli/import_additions.h"
#include "app/cli/import_forecast.h"
#include "app/cli/import_rows.h"
#include "app/cli/options.h"
#include "app/cli/output_gate.h"
#include "app/cli/photo_files.h"
#include "app/cli/typed_values.h"
#include "core/checks/validate.h"
#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/io/import/airspace/import_airspace.h"
#include "core/io/import/import_file.h"
#include "core/io/import/import_formats.h"
#include "core/io/import/import_identity.h"
#include "core/io/import/maps/import_ice_chart.h"
#include "core/io/import/scenario/import_scenario.h"
#include "core/io/text/atomic_file.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <utility>

namespace berg::cli {

namespace {

struct ImportArguments
{
    std::vector<std::string> files;
    std::string file; ///< the first of `files`
    PhotoRunArguments photos;
    std::string format = "auto";
    std::string outputFile;
    std::string intoFile; ///< empty for a new scenario
    std::vector<std::string> mappings;
    std::optional<DateOrder> dates;
    std::optional<std::size_t> headerLine;
    std::string at;
    std::string since;
    std::string until;
    std::string area;
    std::string positionError;
    std::optional<double> spread_mps;
    std::optional<double> velocityTime_s;
    std::optional<double> q_m2ps;
    bool withTracks = false;
    bool oneIceberg = false;
    bool eachRow = false;
    bool acceptDoubtful = false;
    bool replace = false;
    bool force = false;
    bool json = false;
};

constexpr std::array<Named<DateOrder>, 2> kDateOrderNames{{
    {DateOrder::MonthFirst, "month-first"},
    {DateOrder::DayFirst, "day-first"},
}};

constexpr const char* kForecastFormat = "forecast"; ///< no sightings: added to a scenario

std::string formatList()
{
    return "auto, " + joined(importFormats(), ", ", &ImportFormat::id) + ", " + kAirspaceFormat +
           ", " + kIceChartFormat + ", " + kForecastFormat;
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

/** Metres, or how the positions were found. */
std::optional<double> positionErrorOf(const std::string& text)
{
    if (text.empty())
        return std::nullopt;
    if (const auto named = sourceNamed(text))
        return errorOf(*named).sd_m;
    if (const auto said = sourceInWords(text)) // "gps" is short for "gps-beacon"
        return errorOf(*said).sd_m;
    double error_m = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), error_m);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(error_m))
        throw UsageError(
            QT_TRANSLATE_NOOP("CommandLine",
                              "--position-error: %1 is neither a number of metres nor one of %2"),
            {text, sourceNames()});
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
        throw UsageError(QT_TRANSLATE_NOOP(
            "CommandLine",
            "--with-tracks needs --at: tracks consist of the sightings after that time"));
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
    if (result.tooFar > 0)
        add("", result.tooFar, "of them sightings too far from the origin");
    if (result.noted.count > 0)
        add("noted", result.noted.count, "rows taken in part or changed");
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
    for (const auto& [from, name] : kVelocitySourceNames)
        if (const auto count = std::ranges::count_if(result.icebergs,
                                                     [from = from](const ImportedIceberg& iceberg) {
                                                         return iceberg.outcome !=
                                                                    ImportOutcome::LeftOut &&
                                                                iceberg.velocityFrom == from;
                                                     });
            count > 0)
            add("velocity", static_cast<std::size_t>(count), ("from " + std::string(name)).c_str());
    if (result.observerSet)
        text += "observer   kalman: velocities are not known exactly\n";
    if (result.at)
        text += "start      " + result.scenario.startUtc + '\n';
    return text;
}

/** Writes the rows that were rejected, changed or outside, with their reasons, to stderr; of a long
 * list only its start. */
void printDetails(const std::string& file, const ImportResult& result)
{
    printRows(file, result.rejected);
    printRows(file, result.noted);
    printRows(file, result.outside);
    std::size_t notes = 0;
    for (const ImportedIceberg& iceberg : result.icebergs)
        for (const ImportNote note : iceberg.notes)
            if ((iceberg.outcome == ImportOutcome::LeftOut || note == ImportNote::VelocityClamped ||
                 note == ImportNote::GrowthClamped || note == ImportNote::Jumped ||
                 note == ImportNote::Contradicted || note == ImportNote::TooFast ||
                 note == ImportNote::OnLand || note == ImportNote::Repeated ||
                 note == ImportNote::TimeUnknown) &&
                notes++ < kMostListedRows)
                printMessage(word(file) + ": " + word(iceberg.id) + ": " +
                             said(importNoteText(note), {}));
    if (notes > kMostListedRows)
        printMessage(word(file) + ": " +
                     said(QT_TRANSLATE_NOOP("CommandLine", "and %1 more notes about icebergs"),
                          {countOf(notes - kMostListedRows)}));
}

/** How to get at sightings that are off the plane. */
void printFar(const std::string& file, const ImportResult& result, bool isInto)
{
    if (result.tooFar == 0)
        return;
    const LatLon& origin = result.scenario.origin;
    const std::string place =
        numberText(origin.latitude_deg) + ' ' + numberText(origin.longitude_deg);
    printMessage(
        word(file) + ": " +
        said(isInto ? QT_TRANSLATE_NOOP(
                          "CommandLine",
                          "%1 sightings are too far from the origin of the scenario, %2; import "
                          "them without --into, or choose others with --area")
                    : QT_TRANSLATE_NOOP("CommandLine",
                                        "%1 sightings are too far from the origin, %2, which lies "
                                        "in their densest group; choose others with --area"),
             {countOf(result.tooFar), place}));
}

SightingTable sightingsOf(const std::string& text, const std::string& file,
                          const ReadOptions& formats)
{
    try {
        SightingTable table = readSightings(text, file, formats);
        requireIdentity(table, text, file, formats);
        return table;
    } catch (const Error& error) {
        constexpr std::size_t kHead = 100;
        const bool isOurs =
            std::string_view(text).substr(0, kHead).find("\"bergwatch-") != std::string_view::npos;
        const bool isUnknown = error.issues().front().reason.id == IssueId::UnknownFormat;
        if (looksLikeForecast(text))
            throw UsageError(
                QT_TRANSLATE_NOOP("CommandLine",
                                  "%1 is a forecast; use --format forecast with --into SCENARIO"),
                {file});
        if (isUnknown && isOpenAir(text))
            throw UsageError(
                QT_TRANSLATE_NOOP("CommandLine",
                                  "%1 is airspace; use --format airspace with --into SCENARIO"),
                {file});
        if (!isOurs || !isUnknown)
            throw;
        throw Error(ErrorCode::WrongFormat, file,
                    {{Severity::Error,
                      "format",
                      {IssueId::OtherFormat, {"sightings", formatOf(text, file)}}}});
    }
}

/** The sightings of a file or of photographs, and what was made of them. */
struct Imported
{
    SightingTable table;
    ImportResult result;
    std::optional<PhotoYield> photos;
};

Imported imported(const std::string& text, const ImportArguments& arguments,
                  const ReadOptions& formats, const ImportOptions& options,
                  const std::stop_token& stop)
{
    const std::string& output = arguments.outputFile;
    const std::filesystem::path named = isOpenDescriptor(output) ? arguments.file : output;
    const Scenario base = arguments.intoFile.empty() ? newScenarioForImport(named.stem().string())
                                                     : loadScenario(arguments.intoFile);
    std::optional<PhotoYield> photos;
    if (arePhotos(arguments.files))
        photos = readPhotoFiles(arguments.files, arguments.photos, stop);
    SightingTable table = photos ? photos->table : sightingsOf(text, arguments.file, formats);
    try {
        ImportResult result = importSightings(base, table, options);
        return {std::move(table), std::move(result), std::move(photos)};
    } catch (const Error& error) {
        if (error.code() != ErrorCode::FileTooLarge)
            throw;
        throw Error(error.code(), arguments.file, error.issues());
    }
}

/** Throws `Error{InvalidInput}` with the icebergs that somebody must agree to. */
void requireConsent(const std::string& file, const ImportResult& result)
{
    if (!needsConsent(result))
        return;
    std::vector<Issue> issues;
    for (const ImportedIceberg& iceberg : result.icebergs)
        if (isDoubtful(iceberg) && issues.size() < kMostListedRows)
            issues.push_back({Severity::Error, word(iceberg.id), {IssueId::ImportDoubtful}});
    throw Error(ErrorCode::InvalidInput, file, std::move(issues));
}

/** Whether there is an option that is about sightings. */
bool isAboutSightings(const ImportArguments& given)
{
    const auto isGiven = [](const std::string& text) { return !text.empty(); };
    return !given.mappings.empty() || given.oneIceberg || given.eachRow || given.acceptDoubtful ||
           given.dates || given.headerLine || given.spread_mps || given.velocityTime_s ||
           given.q_m2ps || given.withTracks || isGiven(given.at) || isGiven(given.since) ||
           isGiven(given.until) || isGiven(given.area) || isGiven(given.positionError);
}

/** Refuses options about sightings for a file of another kind, and a missing scenario. */
void requireAddition(const ImportArguments& arguments, const char* format)
{
    if (arguments.intoFile.empty())
        throw UsageError(
            QT_TRANSLATE_NOOP("CommandLine", "--format %1 needs --into, the scenario to add it to"),
            {format});
    if (isAboutSightings(arguments))
        throw UsageError(
            QT_TRANSLATE_NOOP("CommandLine",
                              "--format %1 accepts only --into, --output, --force and --json"),
            {format});
}

int importForecastFile(ImportArguments arguments)
{
    const std::string at = std::exchange(arguments.at, {});
    if (isAboutSightings(arguments))
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine",
                                           "--format forecast accepts only --into, --at, "
                                           "--replace, --output, --force and --json"));
    return importForecast({.file = arguments.file,
                           .intoFile = arguments.intoFile,
                           .outputFile = arguments.outputFile,
                           .at = at,
                           .replace = arguments.replace,
                           .force = arguments.force,
                           .json = arguments.json});
}

ReadOptions readOptionsOf(const ImportArguments& given)
{
    ReadOptions options{.format = given.format,
                        .mapping = {},
                        .dates = given.dates,
                        .headerLine = given.headerLine};
    if (given.oneIceberg || given.eachRow)
        options.rows = given.oneIceberg ? RowIdentity::OneIceberg : RowIdentity::EachRow;
    for (const std::string& mapping : given.mappings)
        addMapping(options.mapping, mappingOf(mapping));
    return options;
}

int importFile(const ImportArguments& given, const std::stop_token& stop)
{
    ImportArguments arguments = given;
    arguments.file = given.files.front();
    const bool isPhotos = arePhotos(given.files);
    if (!isPhotos && !given.photos.runFile.empty())
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "--run is about photographs only"));
    if (isPhotos && given.format != "auto" && given.format != "photo")
        throw UsageError(
            QT_TRANSLATE_NOOP("CommandLine", "--format: %1 has one file, not photographs"),
            {given.format});
    if (arguments.file == "/dev/stdin" && arguments.intoFile == arguments.file)
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "%1 excludes %2"),
                         {"FILE -", "--into -"});
    const bool isAirspace = arguments.format == kAirspaceFormat;
    const bool isChart = arguments.format == kIceChartFormat;
    const bool isFound = arguments.format == "auto";
    if (arguments.replace && arguments.format != kForecastFormat)
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "%1 needs %2"),
                         {"--replace", "--format forecast"});
    if (arguments.format == kForecastFormat)
        return importForecastFile(arguments);
    if (isAirspace || isChart)
        requireAddition(arguments, isAirspace ? kAirspaceFormat : kIceChartFormat);
    else if (!isFound && findImportFormat(arguments.format) == nullptr)
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "--format: %1 is none of %2"),
                         {arguments.format, formatList()});
    const ReadOptions formats = readOptionsOf(arguments);
    const ImportOptions options = optionsOf(arguments);
    // Not an input that must stay: an import adds to the scenario, which --force may overwrite.
    checkFiles({.inputs = arguments.files,
                .outputs = {{.option = "--output", .path = arguments.outputFile}},
                .force = arguments.force,
                .json = arguments.json});
    const std::string text =
        isPhotos ? std::string()
                 : reading([&] { return readImportFile(arguments.file, arguments.file, stop); });
    const Addition addition{arguments.file, arguments.intoFile, arguments.outputFile,
                            arguments.json};
    if (isAirspace)
        return addAirspace(addition, text, stop);
    if (isChart || (isFound && !isPhotos && isIceChart(text))) {
        if (isFound && arguments.intoFile.empty())
            throw UsageError(
                QT_TRANSLATE_NOOP("CommandLine", "%1 is an ice chart; use --into SCENARIO"),
                {arguments.file});
        requireAddition(arguments, kIceChartFormat);
        return addIceChart(addition, text, stop);
    }
    const auto [table, result, photos] =
        reading([&] { return imported(text, arguments, formats, options, stop); });
    if (!table.guessedDate.empty())
        printWarnings(arguments.file, {{Severity::Warning,
                                        saidPlace(table.rejected, table.guessedLine),
                                        {IssueId::MonthFirst, {table.guessedDate}}}});
    if (!arguments.json)
        printDetails(arguments.file, result);
    printFar(arguments.file, result, !arguments.intoFile.empty());
    if (result.added + result.updated + result.unchanged == 0)
        throw Error(ErrorCode::InvalidInput, arguments.file,
                    {IssueId::NothingTaken, {countOf(table.sightings.size())}});
    if (!arguments.acceptDoubtful)
        requireConsent(arguments.file, result);
    const NewFile file{.path = arguments.outputFile, .content = scenarioToJson(result.scenario)};
    deliver({&file, 1}, arguments.json
                            ? importJson(table, result, photos ? photoYieldJson(*photos) : "")
                            : (photos ? photoSummary(*photos) : "") + summary(table, result));
    return kDone;
}

} // namespace

void addImportCommand(CLI::App& app, Action& action)
{
    CLI::App* command =
        app.add_subcommand("import", "Make a scenario from sightings of real icebergs");
    ImportArguments& a = argumentsOf(*command, action, importFile);
    command
        ->add_option("FILE", a.files,
                     "File of sightings; or photographs with GPS (JPEG), or a folder of them")
        ->required();
    command->add_option("-f,--format", a.format, formatList())->capture_default_str();
    addOutputFile(*command, "-o,--output", a.outputFile, "Scenario to write")->required();
    addForce(*command, a.force);
    command->add_option("--into", a.intoFile, "Scenario to add to (a new one)");
    command->add_option("--map", a.mappings,
                        "FIELD=COLUMN (columns by their names): " +
                            allowedNames(kSightingFieldNames));
    addNamed(*command, "--dates", a.dates, kDateOrderNames,
             "Dates such as 05/02/2021 (decided by the file's other dates)");
    command->add_option("--at", a.at,
                        "Start, UTC (the later of the scenario's start and the last sighting)");
    command
        ->add_option("--header-line", a.headerLine,
                     "Line of a table that names its columns (the first that names a latitude and "
                     "a longitude)")
        ->check(CLI::Range(1, 1'000'000));
    CLI::Option* one =
        command->add_flag("--one-iceberg", a.oneIceberg, "All rows are sightings of one iceberg");
    command->add_flag("--each-row", a.eachRow, "Each row is an iceberg of its own")->excludes(one);
    command->add_flag("--accept-doubtful", a.acceptDoubtful,
                      "Also import icebergs faster than 1.5 m/s or on land");
    command->add_option("--since", a.since, "Leave out earlier sightings, UTC");
    command->add_option("--until", a.until, "Leave out later sightings, UTC");
    command->add_option("--area", a.area, "SOUTH,WEST,NORTH,EAST in degrees (everywhere)");
    command->add_option("--position-error", a.positionError,
                        "Standard deviation of positions where the file has none: metres, " +
                            sourceNames() + " (by the format, or each row's own source)");
    command
        ->add_option("--drift-variation", a.spread_mps,
                     "Standard deviation of unknown velocities, m/s (0.15)")
        ->check(numberFrom(0, kLargestVelocity_mps));
    command
        ->add_option("--drift-time", a.velocityTime_s,
                     "Time constant of velocity changes, s; 0: constant velocity (36000)")
        ->check(numberFrom(0, kLargestTime_s));
    command
        ->add_option("--variance-growth", a.q_m2ps, "q where it cannot be estimated, m^2/s (0.025)")
        ->check(numberFrom(0, kLargestGrowth_m2ps));
    command->add_flag("--replace", a.replace,
                      "Replace the scenario's forecast; without it both are combined");
    command->add_flag("--with-tracks", a.withTracks, "Sightings after --at become the true motion");
    CLI::Option* const run =
        command->add_option("--run", a.photos.runFile,
                            "Run file of the flight of the photographs, which places those without "
                            "a position and finds their icebergs");
    command->add_option("--uav", a.photos.uav, "UAV with the camera (the first)")->needs(run);
    command->add_flag("--json", a.json, "Print one JSON document");
}

} // namespace berg::cli
