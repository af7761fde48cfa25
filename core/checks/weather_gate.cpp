#include "core/checks/weather_gate.h"

#include "core/base/error.h"
#include "core/checks/weather.h"
#include "core/scenario/utc_time.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

constexpr double kWeatherStep_s = 60;
constexpr double kAreaStep_s = 600;

/** Returns the state of a value that must not exceed a limit. */
WeatherState upperState(double value, double limit)
{
    if (value > limit)
        return WeatherState::NoGo;
    return value > kMarginalShare * limit ? WeatherState::Marginal : WeatherState::Go;
}

/** Returns the state of a value that must not be below a limit. */
WeatherState lowerState(double value, double limit)
{
    if (value < limit)
        return WeatherState::NoGo;
    return value * kMarginalShare < limit ? WeatherState::Marginal : WeatherState::Go;
}

/** Compares the weather at one place and time with the limits of one UAV. */
class LimitCheck
{
public:
    LimitCheck(const ScenarioWeather& weather, const Uav& uav) : m_weather(weather), m_uav(uav) {}

    /** Keeps the first reason of the worst state. */
    void note(double time_s, const Point& position_m);
    [[nodiscard]] const UavWeather& result() const { return m_result; }

private:
    void compare(WeatherLimit of, std::optional<double> value, std::optional<double> limit,
                 WeatherState (*state)(double, double));
    void keep(const WeatherReason& reason);

    const ScenarioWeather& m_weather;
    const Uav& m_uav;
    double m_time_s = 0;
    UavWeather m_result;
};

void LimitCheck::note(double time_s, const Point& position_m)
{
    m_time_s = time_s;
    const ForecastEntry now = m_weather.at(time_s, position_m);
    const WeatherLimits& limits = m_uav.weather;
    compare(WeatherLimit::Wind, now.wind_mps ? std::optional(now.wind_mps->norm()) : std::nullopt,
            limits.wind_mps, upperState);
    compare(WeatherLimit::Gust, now.gust_mps, limits.gust_mps, upperState);
    compare(WeatherLimit::Visibility, now.visibility_m, limits.visibility_m, lowerState);
    compare(WeatherLimit::Ceiling, now.ceiling_m, limits.ceiling_m, lowerState);
    const Weather air{.temperature_degC = now.airTemperature_degC,
                      .dewPoint_degC = now.dewPoint_degC};
    if (!limits.icing && isIcing(air, m_uav.spec.altitude_m))
        keep({.of = WeatherLimit::Icing, .time_s = time_s});
}

void LimitCheck::compare(WeatherLimit of, std::optional<double> value, std::optional<double> limit,
                         WeatherState (*state)(double, double))
{
    if (limit)
        keep({.of = of,
              .state = value ? state(*value, *limit) : WeatherState::Unknown,
              .value = value,
              .limit = limit,
              .time_s = m_time_s});
}

void LimitCheck::keep(const WeatherReason& reason)
{
    const bool isEarlier = m_result.reason && reason.state == m_result.state &&
                           reason.time_s < m_result.reason->time_s;
    if (reason.state > m_result.state || isEarlier)
        m_result = {.state = reason.state, .reason = reason};
}

/** Calls `note` for each minute of a flight and for each of its places. */
template <class Note>
void eachMinute(const std::vector<FlightPlace>& flight, const Note& note)
{
    for (std::size_t i = 0; i < flight.size(); ++i) {
        note(flight[i].time_s, flight[i].position_m);
        if (i + 1 == flight.size())
            return;
        if (flight[i].isLanding)
            continue;
        const FlightPlace& next = flight[i + 1];
        const double steps = std::ceil((next.time_s - flight[i].time_s) / kWeatherStep_s);
        for (double k = 1; k < steps; ++k) {
            const double part = k / steps;
            note(flight[i].time_s + part * (next.time_s - flight[i].time_s),
                 Point(flight[i].position_m + part * (next.position_m - flight[i].position_m)));
        }
    }
}

} // namespace

std::string_view nameOf(WeatherState state)
{
    switch (state) {
    case WeatherState::Go:
        return "go";
    case WeatherState::Marginal:
        return "marginal";
    case WeatherState::Unknown:
        return "unknown";
    case WeatherState::NoGo:
        return "no-go";
    }
    return {};
}

std::string_view nameOf(WeatherLimit limit)
{
    switch (limit) {
    case WeatherLimit::Wind:
        return "wind";
    case WeatherLimit::Gust:
        return "gust";
    case WeatherLimit::Visibility:
        return "visibility";
    case WeatherLimit::Ceiling:
        return "ceiling";
    case WeatherLimit::Icing:
        return "icing";
    }
    return {};
}

WeatherState WeatherVerdict::state() const
{
    WeatherState worst = WeatherState::Go;
    for (const UavWeather& uav : uavs)
        worst = std::max(worst, uav.state);
    return worst;
}

std::optional<std::size_t> WeatherVerdict::worstUav() const
{
    std::optional<std::size_t> worst;
    for (std::size_t i = 0; i < uavs.size(); ++i) {
        if (uavs[i].state != state() || !uavs[i].reason)
            continue;
        if (!worst || uavs[i].reason->time_s < uavs[*worst].reason->time_s)
            worst = i;
    }
    return worst;
}

std::optional<ForecastTime> startTime(const ScenarioWorld& scenario)
{
    return parseUtc(scenario.startUtc);
}

ScenarioWeather::ScenarioWeather(const ScenarioWorld& scenario)
    : m_scenario(scenario), m_frame(scenario.origin)
{
    const std::optional<ForecastTime> start = startTime(scenario);
    if (!start || !scenario.forecast || !isGrid(*scenario.forecast))
        return;
    m_start = *start;
    m_field = &*scenario.forecast;
    for (std::size_t i = 0; i < kForecastQuantities.size(); ++i)
        m_isForecast[i] = std::ranges::any_of(m_field->places, [i](const Forecast& place) {
            return gives(place, kForecastQuantities[i]);
        });
}

bool ScenarioWeather::isForecast(ForecastQuantity quantity) const
{
    const auto at = std::ranges::find(kForecastQuantities, quantity);
    return m_isForecast[static_cast<std::size_t>(at - kForecastQuantities.begin())];
}

ForecastEntry ScenarioWeather::at(double time_s, const Point& position_m) const
{
    ForecastEntry now;
    if (m_field)
        now = entryAt(*m_field, m_frame.toGeographic(position_m),
                      m_start + std::chrono::milliseconds(std::llround(time_s * 1e3)));
    const auto fill = [this](auto& value, ForecastQuantity quantity, const auto& constant) {
        if (!isForecast(quantity))
            value = constant;
    };
    fill(now.wind_mps, ForecastQuantity::Wind, m_scenario.wind_mps);
    fill(now.current_mps, ForecastQuantity::Current, m_scenario.current_mps);
    fill(now.gust_mps, ForecastQuantity::Gust, m_scenario.weather.gust_mps);
    fill(now.airTemperature_degC, ForecastQuantity::AirTemperature,
         m_scenario.weather.temperature_degC);
    fill(now.dewPoint_degC, ForecastQuantity::DewPoint, m_scenario.weather.dewPoint_degC);
    return now;
}

std::optional<double> ScenarioWeather::depth_m(const Point& position_m) const
{
    return m_field ? depthAt_m(*m_field, m_frame.toGeographic(position_m)) : std::nullopt;
}

bool hasWeatherLimits(const ScenarioWorld& scenario)
{
    const ScenarioWeather weather(scenario);
    const bool isAirKnown =
        (weather.isForecast(ForecastQuantity::AirTemperature) ||
         scenario.weather.temperature_degC) &&
        (weather.isForecast(ForecastQuantity::DewPoint) || scenario.weather.dewPoint_degC);
    return std::ranges::any_of(scenario.uavs, [isAirKnown](const Uav& uav) {
        const WeatherLimits& limits = uav.weather;
        return limits.wind_mps || limits.gust_mps || limits.visibility_m || limits.ceiling_m ||
               (isAirKnown && !limits.icing);
    });
}

WeatherVerdict weatherAlong(const ScenarioWorld& scenario,
                            std::span<const std::vector<FlightPlace>> flights)
{
    require(flights.size() == scenario.uavs.size(), "weatherAlong: a flight for each UAV");
    const ScenarioWeather weather(scenario);
    WeatherVerdict result;
    for (std::size_t i = 0; i < flights.size(); ++i) {
        LimitCheck check(weather, scenario.uavs[i]);
        eachMinute(flights[i], [&check](double time_s, const Point& position_m) {
            check.note(time_s, position_m);
        });
        result.uavs.push_back(check.result());
    }
    return result;
}

WeatherVerdict weatherOfArea(const ScenarioWorld& scenario)
{
    if (!hasWeatherLimits(scenario))
        return {.uavs = std::vector<UavWeather>(scenario.uavs.size())};
    const ScenarioWeather weather(scenario);
    const std::size_t icebergs = std::min(scenario.icebergs.size(), kMostWeatherPlaces);
    std::vector<Point> places_m;
    for (std::size_t k = 0; k < icebergs; ++k)
        places_m.push_back(scenario.icebergs[k * scenario.icebergs.size() / icebergs].position_m);
    const double steps = std::max(1.0, std::ceil(scenario.duration_s / kAreaStep_s));
    WeatherVerdict result;
    for (const Uav& uav : scenario.uavs) {
        LimitCheck check(weather, uav);
        for (double k = 0; k <= steps; ++k) {
            const double time_s = k / steps * scenario.duration_s;
            check.note(time_s, uav.position_m);
            for (const Point& place_m : places_m)
                check.note(time_s, place_m);
        }
        result.uavs.push_back(check.result());
    }
    return result;
}

} // namespace berg
