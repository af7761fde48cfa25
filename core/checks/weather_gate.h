#pragma once

#include "core/scenario/scenario.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace berg {

/** Share of a limit from which weather within the limit is marginal; 1 / share for a lower limit.
 */
inline constexpr double kMarginalShare = 0.8;

/** Verdict on the weather of a flight, better ones first. */
enum class WeatherState : std::uint8_t
{
    Go,
    Marginal, ///< within all limits, but near one of them (`kMarginalShare`)
    Unknown,  ///< a quantity with a limit is not known, and nothing known exceeds a limit
    NoGo      ///< beyond a limit
};
inline constexpr std::array<WeatherState, 4> kWeatherStates{
    WeatherState::Go, WeatherState::Marginal, WeatherState::Unknown, WeatherState::NoGo};
/** Returns the name of a state in results: "go", "marginal", "unknown" or "no-go". */
[[nodiscard]] std::string_view nameOf(WeatherState state);

/** One of the `WeatherLimits`. */
enum class WeatherLimit : std::uint8_t
{
    Wind,
    Gust,
    Visibility,
    Ceiling,
    Icing
};
inline constexpr std::array<WeatherLimit, 5> kWeatherLimits{
    WeatherLimit::Wind, WeatherLimit::Gust, WeatherLimit::Visibility, WeatherLimit::Ceiling,
    WeatherLimit::Icing};
/** Returns the name of a limit in results: "wind", "gust", "visibility", "ceiling" or "icing". */
[[nodiscard]] std::string_view nameOf(WeatherLimit limit);

/** Why the weather is not simply "go". */
struct WeatherReason
{
    WeatherLimit of = WeatherLimit::Wind;
    WeatherState state = WeatherState::NoGo;
    std::optional<double> value; ///< m/s or m at that time; nullopt if unknown, and for icing
    std::optional<double> limit; ///< nullopt for icing
    double time_s = 0;           ///< run time
    bool operator==(const WeatherReason&) const = default;
};

/** Verdict for one UAV. */
struct UavWeather
{
    WeatherState state = WeatherState::Go;
    /** First instant at which the state is reached; nullopt for Go. */
    std::optional<WeatherReason> reason;
    bool operator==(const UavWeather&) const = default;
};

/** Verdicts for all UAVs of a scenario. */
struct WeatherVerdict
{
    std::vector<UavWeather> uavs; ///< by UAV

    /** Returns the worst state of all UAVs; Go without UAVs. */
    [[nodiscard]] WeatherState state() const;
    /** Returns the UAV that reaches the worst state first, or nullopt if all are Go. */
    [[nodiscard]] std::optional<std::size_t> worstUav() const;
    bool operator==(const WeatherVerdict&) const = default;
};

/** A place of a UAV at a run time. */
struct FlightPlace
{
    double time_s = 0;
    Point position_m = Point::Zero();
    bool isLanding = false; ///< true if the UAV is on the ground from then to the next place
    bool operator==(const FlightPlace&) const = default;
};

/** Returns the UTC time of run time 0, or nullopt if `startUtc` is empty or no time. */
[[nodiscard]] std::optional<ForecastTime> startTime(const ScenarioWorld& scenario);

/**
 * Weather and sea of a scenario by place and run time. A quantity that the forecast gives anywhere
 * is that of the forecast, and nullopt where and when the forecast lacks it; any other quantity is
 * the constant of the scenario, if it has one. Without `startUtc` the forecast is not used. Refers
 * to the scenario, which must outlive it.
 */
class ScenarioWeather
{
public:
    explicit ScenarioWeather(const ScenarioWorld& scenario);

    /** Returns the values at a place of the scenario's plane; `time` is set with a forecast only.
     */
    [[nodiscard]] ForecastEntry at(double time_s, const Point& position_m) const;
    /** Returns true if the forecast gives the quantity anywhere. */
    [[nodiscard]] bool isForecast(ForecastQuantity quantity) const;
    /** Returns the origin of the scenario's plane. */
    [[nodiscard]] LatLon origin() const { return m_frame.origin(); }
    /** Returns the depth of the sea, or nullopt if it is unknown. */
    [[nodiscard]] std::optional<double> depth_m(const Point& position_m) const;

private:
    const ScenarioWorld& m_scenario;
    const ForecastField* m_field = nullptr; ///< null if no forecast is used
    LocalFrame m_frame;
    ForecastTime m_start;
    std::array<bool, kForecastQuantities.size()> m_isForecast{};
};

/**
 * Returns true if some UAV has a limit that can be checked: for wind, gusts, visibility or ceiling,
 * or for icing with temperature and dew point known.
 */
[[nodiscard]] bool hasWeatherLimits(const ScenarioWorld& scenario);

/**
 * Compares the weather along the flight of each UAV with its limits, at every place given and at
 * least once a minute between two places, where the UAV moves straight. `flights` has an entry for
 * each UAV, times rising; an empty one is Go. The limit that comes first in `kWeatherLimits` counts
 * where several are exceeded at once. Icing is compared at the altitude of the UAV (`isIcing`), as
 * long as temperature and dew point are known, and is never marginal or unknown.
 */
[[nodiscard]] WeatherVerdict weatherAlong(const ScenarioWorld& scenario,
                                          std::span<const std::vector<FlightPlace>> flights);

/**
 * Compares the weather with the limits before a plan is known: over the whole run, every ten
 * minutes, at the start of each UAV and at the estimates of up to `kMostWeatherPlaces` icebergs,
 * evenly chosen. A flight later visits some of these places only, so the result may be worse than
 * that of `weatherAlong`.
 */
[[nodiscard]] WeatherVerdict weatherOfArea(const ScenarioWorld& scenario);
inline constexpr std::size_t kMostWeatherPlaces = 12;

} // namespace berg
