#pragma once

// Private to app/cli: imports of files without sightings, which are added to a scenario.

#include "core/io/import/fields/import_table.h"

#include <stop_token>
#include <string>

namespace berg::cli {

inline constexpr const char* kAirspaceFormat = "airspace";
inline constexpr const char* kIceChartFormat = "ice-chart";
inline constexpr std::size_t kMostRows = 100; ///< of a list on stderr

/** Returns the place of a row in words: "line 3" is translated by whoever says it. */
[[nodiscard]] std::string saidPlace(const Rejections& rejected, std::size_t number);
/** Prints rows of a file with their reasons on stderr; of a long list only its start. */
void printRows(const std::string& file, const Rejections& rows);

/** A file to add to a scenario. */
struct Addition
{
    std::string file;
    std::string intoFile;
    std::string outputFile;
    bool json = false;
};

/** Adds airspace; writes the scenario, prints a summary and returns the exit code. */
int addAirspace(const Addition& arguments, const std::string& text, const std::stop_token& stop);
/** Adds an ice chart; writes the scenario, prints a summary and returns the exit code. */
int addIceChart(const Addition& arguments, const std::string& text, const std::stop_token& stop);

} // namespace berg::cli
