#pragma once

#include "core/io/import/forecast/forecast_reading.h"
#include "core/scenario/scenario.h"

#include <chrono>
#include <optional>

namespace berg {

/** Distance around what a scenario holds from which a forecast is kept. */
inline constexpr double kForecastMargin_m = 30'000;
/** Time after the run for which a forecast is kept: drift looks 48 h ahead, start times 24 h. */
inline constexpr std::chrono::hours kForecastAfterRun{48};
/** Most places times instants of a forecast that is put into a scenario. */
inline constexpr std::size_t kMostScenarioEntries = 50'000;

/**
 * Returns which part of a forecast a scenario needs: the area of its icebergs, UAVs, monitored
 * area, asset and ground station with `kForecastMargin_m` around, and the time from the start of
 * its run to `kForecastAfterRun` after its end. The run starts at `at`, if that is given, else at
 * the scenario's start. Throws `Error{InvalidInput}` if neither is known.
 */
[[nodiscard]] ForecastReadOptions forecastOptions(const Scenario& scenario,
                                                  const std::optional<ForecastTime>& at = {});

/** Result of putting a forecast into a scenario. */
struct ForecastImport
{
    Scenario scenario;
    std::vector<ForecastQuantity> quantities; ///< that the scenario's forecast gives
    std::vector<ForecastGap> gaps;            ///< during the run, of the place in the middle
    std::optional<double> age_h;              ///< at the start
    bool operator==(const ForecastImport&) const = default;
};

/**
 * Returns the scenario with a forecast that was read with `forecastOptions`. If it has one already,
 * `combined` makes one of both, unless `replace` is true. `at` becomes the start, if it is given.
 * Throws `Error{InvalidInput}`, with `subject`, if the forecast does not overlap the run.
 */
[[nodiscard]] ForecastImport withForecast(const Scenario& base, const ForecastReading& reading,
                                          const std::string& subject, bool replace,
                                          const std::optional<ForecastTime>& at = {});

/** Returns the forecast of the place in the middle of a grid. */
[[nodiscard]] const Forecast& middleOf(const ForecastField& field);

/** Returns the JSON document that the command line prints for an import of a forecast. */
[[nodiscard]] std::string forecastImportJson(const ForecastImport& imported,
                                             const ForecastReading& reading);

} // namespace berg
