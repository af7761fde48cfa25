#include "app/cli/commands.h"
#include "app/cli/forecast_files.h"
#include "app/cli/options.h"
#include "app/cli/output_gate.h"
#include "app/cli/typed_values.h"
#include "core/earth/coordinates.h"
#include "core/io/results/forecast_result.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>

namespace berg::cli {

namespace {

struct ForecastArguments
{
    std::vector<std::string> files;
    std::string place;
    std::string area;
    std::string since;
    std::string until;
    std::string outputFile;
    bool force = false;
    bool json = false;
};

/** Headings of `kForecastColumns` for people. */
constexpr std::array<const char*, kForecastColumns.size()> kHeadings{
    "wind m/s",    "from", "gust m/s",    "air C",        "fog %",
    "current m/s", "to",   "dew point C", "visibility m", "ceiling m"};

/** Returns the series as a table, without columns that hold no value. */
std::string seriesTable(const Forecast& forecast)
{
    std::vector<std::array<std::string, kForecastColumns.size()>> cells;
    std::ranges::transform(forecast.series, std::back_inserter(cells), forecastCells);
    std::vector<std::vector<std::string>> rows(cells.size() + 1);
    rows[0].emplace_back("time");
    for (std::size_t i = 0; i < cells.size(); ++i)
        rows[i + 1].push_back(utcText(forecast.series[i].time, 0));
    for (std::size_t column = 0; column < kHeadings.size(); ++column) {
        if (std::ranges::all_of(cells, [column](const auto& row) { return row[column].empty(); }))
            continue;
        rows[0].emplace_back(kHeadings[column]);
        for (std::size_t i = 0; i < cells.size(); ++i)
            rows[i + 1].push_back(cells[i][column].empty() ? "-" : cells[i][column]);
    }
    return tableLines(rows, rows[0].size());
}

/** Returns the names of the quantities that are never given, or "" if there are none. */
std::string missingNames(const Forecast& forecast)
{
    std::string names;
    for (const ForecastQuantity quantity : missingQuantities(forecast))
        names.append(names.empty() ? "" : ", ").append(nameOf(quantity));
    return names;
}

std::string gridText(const ForecastGridFacts& grid)
{
    const auto place = [](const LatLon& corner) {
        return placeText(corner, CoordinateForm::DecimalDegrees, 2);
    };
    return "grid       " + grid.format + ", " + std::to_string(grid.rows) + " x " +
           std::to_string(grid.columns) + " places from " + place(grid.southWest) + " to " +
           place(grid.northEast) + '\n';
}

std::string forecastText(const Forecast& forecast, const std::vector<ForecastGridFacts>& grids)
{
    std::string text = "source     " + forecast.source + '\n';
    text += "issued     " + (forecast.issued ? utcText(*forecast.issued, 0) : "unknown") + '\n';
    text += "place      " + placeText(forecast.place, CoordinateForm::DecimalDegrees, 2) + '\n';
    if (forecast.depth_m)
        text += "depth      " + fixed(*forecast.depth_m, 0) + " m\n";
    for (const ForecastGridFacts& grid : grids)
        text += gridText(grid);
    if (const std::string missing = missingNames(forecast); !missing.empty())
        text += "without    " + missing + '\n';
    return text + seriesTable(forecast);
}

int printForecast(const ForecastArguments& arguments, const std::stop_token& /*stop*/)
{
    if (std::ranges::count(arguments.files, "/dev/stdin") > 1)
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "%1 excludes %2"), {"-", "-"});
    const std::optional<UtcTime> since = timeOf("--since", arguments.since);
    const std::optional<UtcTime> until = timeOf("--until", arguments.until);
    checkFiles({.inputs = arguments.files,
                .outputs = {{.option = "--output", .path = arguments.outputFile}},
                .force = arguments.force,
                .json = arguments.json});
    const ForecastFiles files =
        readForecasts(arguments.files, {.place = placeOf("--place", arguments.place),
                                        .area = areaOf(arguments.area),
                                        .since = since,
                                        .until = until});
    Forecast all = combined(files.forecasts);
    for (const Forecast& forecast : files.forecasts)
        if (!all.depth_m)
            all.depth_m = forecast.depth_m;
    const Forecast forecast = cut(all, since, until);
    if (forecast.series.empty())
        throw UsageError(
            QT_TRANSLATE_NOOP("CommandLine", "--since, --until: the forecast is from %1 to %2"),
            {utcText(all.series.front().time, 0), utcText(all.series.back().time, 0)});
    warnOfOldForecasts(files, forecast.series.front().time);
    warnOfFarForecasts(files, forecast.place);
    const std::vector<ForecastGap> gaps =
        gapsOf(all, forecast.series.front().time, forecast.series.back().time);
    warnOfGaps(gaps);
    std::vector<NewFile> outputs;
    if (!arguments.outputFile.empty())
        outputs.push_back({.path = arguments.outputFile, .content = forecastCsv(forecast)});
    deliver(outputs, arguments.json ? forecastJson(forecast, gaps, files.grids)
                                    : forecastText(forecast, files.grids));
    return kDone;
}

} // namespace

void addForecastCommand(CLI::App& app, Action& action)
{
    CLI::App* command = app.add_subcommand(
        "forecast", "Print forecasts of wind and current: MET Norway's locationforecast and "
                    "oceanforecast, NetCDF and GRIB");
    ForecastArguments& a = argumentsOf(*command, action, printForecast);
    command
        ->add_option("FILE", a.files,
                     "Forecasts (JSON, NetCDF, GRIB); each quantity is from the newest")
        ->required();
    command->add_option("--place", a.place, "Place for the table of a grid (its middle)");
    command->add_option(
        "--area", a.area,
        "SOUTH,WEST,NORTH,EAST in degrees to read of a grid (around the place, or all)");
    command->add_option("--since", a.since, "Start of the time window, UTC");
    command->add_option("--until", a.until, "End of the time window, UTC");
    addOutputFile(*command, "-o,--output", a.outputFile, "CSV file for the table");
    addForce(*command, a.force);
    command->add_flag("--json", a.json, "Print one JSON document");
}

} // namespace berg::cli
