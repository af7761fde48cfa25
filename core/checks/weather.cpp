#include "core/checks/weather.h"

#include "core/checks/findings.h"

#include <cmath>

namespace berg {

bool isIcing(const Weather& weather, double height_m)
{
    constexpr double kTemperatureFall_degCpm = 6.5e-3; // standard atmosphere
    constexpr double kDewPointFall_degCpm = 1.8e-3;
    constexpr double kNearlySaturated_degC = 2;
    if (!weather.temperature_degC || !weather.dewPoint_degC)
        return false;
    const double temperature_degC = *weather.temperature_degC - kTemperatureFall_degCpm * height_m;
    const double dewPoint_degC = *weather.dewPoint_degC - kDewPointFall_degCpm * height_m;
    return temperature_degC < 0 && temperature_degC - dewPoint_degC <= kNearlySaturated_degC;
}

void adviseWeather(const Scenario& scenario, Findings& findings)
{
    const double wind_mps = scenario.wind_mps.norm();
    const double shownWind_mps = std::round(wind_mps * 100) / 100;
    const double gust_mps = scenario.weather.gust_mps.value_or(0);
    for (std::size_t i = 0; i < scenario.uavs.size(); ++i) {
        const Uav& uav = scenario.uavs[i];
        const WeatherLimits& limits = uav.weather;
        const std::string path = entryPath("uavs", i);
        if (limits.wind_mps && wind_mps > *limits.wind_mps)
            findings.warn(path + ".max_wind_mps", IssueId::WindLimit,
                          {Amount{shownWind_mps, Quantity::Speed},
                           Amount{*limits.wind_mps, Quantity::Speed}});
        if (limits.gust_mps && gust_mps > *limits.gust_mps)
            findings.warn(
                path + ".max_gust_mps", IssueId::GustLimit,
                {Amount{gust_mps, Quantity::Speed}, Amount{*limits.gust_mps, Quantity::Speed}});
        if (!limits.icing && isIcing(scenario.weather, uav.spec.altitude_m))
            findings.warn(path + ".icing", IssueId::Icing);
    }
}

} // namespace berg
