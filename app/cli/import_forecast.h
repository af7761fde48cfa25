#pragma once

#include <string>

namespace berg::cli {

/** Arguments of `import --format forecast`. */
struct ForecastImportArguments
{
    std::string file;
    std::string intoFile;
    std::string outputFile;
    std::string at;
    bool replace = false;
    bool force = false;
    bool json = false;
};

/**
 * Reads a forecast, cuts it to a scenario and writes the scenario with it; returns the exit code.
 * Throws `UsageError` without a scenario.
 */
[[nodiscard]] int importForecast(const ForecastImportArguments& given);

} // namespace berg::cli
