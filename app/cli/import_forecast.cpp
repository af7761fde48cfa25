#include "app/cli/import_forecast.h"

#include "app/cli/console.h"
#include "app/cli/forecast_files.h"
#include "app/cli/output_gate.h"
#include "app/cli/typed_values.h"
#include "core/io/files/scenario_json.h"
#include "core/io/import/import_scenario_forecast.h"

namespace berg::cli {

namespace {

std::string forecastSummary(const ForecastImport& imported, const ForecastReading& read)
{
    const ForecastField& field = *imported.scenario.forecast;
    const Forecast& first = field.places.front();
    std::string names;
    for (const ForecastQuantity quantity : imported.quantities)
        names.append(names.empty() ? "" : ", ").append(nameOf(quantity));
    return "format     " + read.format + "\nsource     " + first.source + "\nissued     " +
           (first.issued ? utcText(*first.issued, 0) : "unknown") + "\nplaces     " +
           std::to_string(field.places.size() / field.columns) + " x " +
           std::to_string(field.columns) + "\ntimes      " + std::to_string(first.series.size()) +
           " from " + utcText(first.series.front().time, 0) + " to " +
           utcText(first.series.back().time, 0) + "\ngives      " + names + '\n';
}

} // namespace

int importForecast(const ForecastImportArguments& given)
{
    if (given.intoFile.empty())
        throw UsageError(QT_TRANSLATE_NOOP(
            "CommandLine", "--format forecast needs --into, the scenario to add it to"));
    const std::optional<UtcTime> at = timeOf("--at", given.at);
    checkFiles({.inputs = {given.file},
                .outputs = {{.option = "--output", .path = given.outputFile}},
                .force = given.force,
                .json = given.json});
    const Scenario base = reading([&] { return loadScenario(given.intoFile); });
    const ForecastReadOptions options =
        naming(given.intoFile, [&] { return forecastOptions(base, at); });
    const ForecastReading read = readForecastFile(given.file, options);
    const ForecastImport imported = withForecast(base, read, given.file, given.replace, at);
    noteThinning(given.file, read.thinning);
    warnOfAge(given.file, imported.age_h, *options.since);
    warnOfGaps(imported.gaps);
    const NewFile file{.path = given.outputFile, .content = scenarioToJson(imported.scenario)};
    deliver({&file, 1},
            given.json ? forecastImportJson(imported, read) : forecastSummary(imported, read));
    return kDone;
}

} // namespace berg::cli
