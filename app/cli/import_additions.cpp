#include "app/cli/import_additions.h"

#include "app/cli/import_rows.h"
#include "app/cli/options.h"
#include "app/cli/output_gate.h"
#include "core/io/files/scenario_json.h"
#include "core/io/import/airspace/import_airspace.h"
#include "core/io/import/maps/import_ice_chart.h"
#include "core/io/text/file_set.h"

namespace berg::cli {

namespace {

/** Prints on stderr which parts of the file were not imported, and how much was. */
std::string airspaceSummary(const std::string& file, const AirspaceResult& result)
{
    printRows(file, result.rejected);
    printRows(file, result.noted);
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
    if (result.noted.count > 0)
        text += "noted      " + std::to_string(result.noted.count) + " lines or areas\n";
    return text;
}

/** Prints on stderr which features were not taken, and how much was. */
std::string iceChartSummary(const std::string& file, const IceChartResult& result)
{
    printRows(file, result.rejected);
    const IceChart& chart = result.scenario.iceChart.value();
    std::string text = "ice chart  " + std::to_string(result.taken) + " areas\n";
    text += "date       " + (chart.dateUtc.empty() ? "unknown" : chart.dateUtc) + '\n';
    if (result.far > 0)
        text += "left out   " + std::to_string(result.far) + " areas farther than 300 km\n";
    if (result.leftOut > 0)
        text += "left out   " + std::to_string(result.leftOut) + " small areas\n";
    if (result.rejected.count > 0)
        text += "rejected   " + std::to_string(result.rejected.count) + " areas\n";
    return text + "outlines   within " + numberText(result.thinned_m) + " m\n";
}

} // namespace

int addAirspace(const Addition& arguments, const std::string& text, const std::stop_token& stop)
{
    const AirspaceResult result = reading([&] {
        return importAirspace(loadScenario(arguments.intoFile), text, arguments.file, stop);
    });
    const NewFile file{.path = arguments.outputFile, .content = scenarioToJson(result.scenario)};
    deliver({&file, 1},
            arguments.json ? airspaceJson(result) : airspaceSummary(arguments.file, result));
    return kDone;
}

int addIceChart(const Addition& arguments, const std::string& text, const std::stop_token& stop)
{
    const IceChartResult result = reading([&] {
        return importIceChart(loadScenario(arguments.intoFile), text, arguments.file, stop);
    });
    const NewFile file{.path = arguments.outputFile, .content = scenarioToJson(result.scenario)};
    deliver({&file, 1},
            arguments.json ? iceChartJson(result) : iceChartSummary(arguments.file, result));
    return kDone;
}

} // namespace berg::cli
