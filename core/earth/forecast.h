#pragma once

#include "core/earth/geodesy.h"
#include "core/geometry/geometry.h"

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** An instant in UTC, without leap seconds. */
using ForecastTime = std::chrono::sys_time<std::chrono::milliseconds>;

/** Weather and sea at one time; a value that the source does not give is nullopt. */
struct ForecastEntry
{
    ForecastTime time;
    std::optional<Point> wind_mps; ///< velocity of the air at 10 m, towards true east and north
    std::optional<double> gust_mps;
    std::optional<double> airTemperature_degC;
    std::optional<double> dewPoint_degC;
    std::optional<double> fog_percent;
    std::optional<double> visibility_m;
    std::optional<double> ceiling_m;  ///< height of the cloud base above the sea
    std::optional<Point> current_mps; ///< velocity of the water, towards true east and north
    std::string extraJson = {};       ///< unknown members of a scenario file
    bool operator==(const ForecastEntry&) const = default;
};

/** Quantity of a forecast. */
enum class ForecastQuantity : std::uint8_t
{
    Wind,
    Gust,
    AirTemperature,
    DewPoint,
    Fog,
    Visibility,
    Ceiling,
    Current
};
inline constexpr std::array<ForecastQuantity, 8> kForecastQuantities{
    ForecastQuantity::Wind,     ForecastQuantity::Gust,   ForecastQuantity::AirTemperature,
    ForecastQuantity::DewPoint, ForecastQuantity::Fog,    ForecastQuantity::Visibility,
    ForecastQuantity::Ceiling,  ForecastQuantity::Current};

/** Returns the name of a quantity in results: "wind", "gust", "air temperature", ... */
[[nodiscard]] std::string_view nameOf(ForecastQuantity quantity);
/** Returns true if the entry gives the quantity. */
[[nodiscard]] bool gives(const ForecastEntry& entry, ForecastQuantity quantity);

/** Forecast of weather and sea at one place. */
struct Forecast
{
    std::string source;
    std::optional<ForecastTime> issued; ///< time of the model run or of its last update
    LatLon place;
    std::vector<ForecastEntry> series; ///< times rise
    std::optional<double> depth_m;     ///< of the sea
    std::string extraJson = {};        ///< unknown members of a scenario file
    bool operator==(const Forecast&) const = default;
};

/** Longest time between two values of a quantity across which it is interpolated. */
inline constexpr std::chrono::hours kLongestForecastStep{6};

/** Returns true if some entry gives the quantity. */
[[nodiscard]] bool gives(const Forecast& forecast, ForecastQuantity quantity);

/**
 * Returns the values at a time, each linear between the two entries that give it; wind and current
 * through their components, so that directions turn the shorter way. A quantity is nullopt before
 * its first and after its last value, and between two values more than `kLongestForecastStep`
 * apart. Cost: linear in the number of entries without a value near the time.
 */
[[nodiscard]] ForecastEntry entryAt(const Forecast& forecast, ForecastTime time);

/** Age, in hours, above which a forecast is reported as old. */
inline constexpr double kOldForecast_h = 24;
/** Returns the hours from its issue to a time, or nullopt if the time of issue is unknown. */
[[nodiscard]] std::optional<double> ageAt_h(const Forecast& forecast, ForecastTime time);

/** Time between two consecutive values of a quantity that are too far apart to interpolate. */
struct ForecastGap
{
    ForecastQuantity quantity = ForecastQuantity::Wind;
    ForecastTime from;
    ForecastTime to;
    bool operator==(const ForecastGap&) const = default;
};
/**
 * Returns the gaps that overlap the time window, by quantity and time; a missing end means no
 * limit. A quantity that is never given has none.
 */
[[nodiscard]] std::vector<ForecastGap> gapsOf(const Forecast& forecast,
                                              std::optional<ForecastTime> since = {},
                                              std::optional<ForecastTime> until = {});

/**
 * Returns the part of the forecast within a time window, with the values of `entryAt` at the times
 * of its entries and at the ends of the window, unless they are outside the series. A missing end
 * means no limit.
 */
[[nodiscard]] Forecast cut(const Forecast& forecast, std::optional<ForecastTime> since,
                           std::optional<ForecastTime> until);

/**
 * Combines several forecasts, of the atmosphere and the ocean, for the place of the first. Each
 * quantity is from the one that was issued last of those that give it; of equal ones, the first.
 * `issued` is the earliest of the forecasts used, and `source` names all of them. Requires at least
 * one forecast.
 */
[[nodiscard]] Forecast combined(std::span<const Forecast> forecasts);

} // namespace berg
