#pragma once

// Private to app/cli: imports of files without sightings, which are added to a scenario.

#include <stop_token>
#include <string>

namespace berg::cli {

inline constexpr const char* kAirspaceFormat = "airspace";
inline constexpr const char* kIceChartFormat = "ice-chart";

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
