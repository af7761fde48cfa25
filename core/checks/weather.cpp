#include "core/checks/weather.h"

#include "core/checks/findings.h"
#include "core/checks/weather_gate.h"
#include "core/scenario/utc_time.h"

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

namespace {

/** Reports the constant weather, at any time and place. */
void adviseConstantWeather(const Scenario& scenario, Findings& findings)
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
        for (const auto& [limit, name] : {std::pair{limits.visibility_m, ".min_visibility_m"},
                                          std::pair{limits.ceiling_m, ".min_ceiling_m"}})
            if (limit)
                findings.hint(path + name, IssueId::LimitUnchecked);
    }
}

/** Field of a limit, quantity of its values and finding about weather beyond it. */
struct LimitWords
{
    const char* field;
    Quantity quantity;
    IssueId beyond;
};

LimitWords wordsOf(WeatherLimit limit)
{
    switch (limit) {
    case WeatherLimit::Wind:
        return {".max_wind_mps", Quantity::Speed, IssueId::ForecastWind};
    case WeatherLimit::Gust:
        return {".max_gust_mps", Quantity::Speed, IssueId::ForecastGust};
    case WeatherLimit::Visibility:
        return {".min_visibility_m", Quantity::Distance, IssueId::ForecastVisibility};
    case WeatherLimit::Ceiling:
        return {".min_ceiling_m", Quantity::Height, IssueId::ForecastCeiling};
    case WeatherLimit::Icing:
        break;
    }
    return {".icing", Quantity::Text, IssueId::ForecastIcing};
}

void adviseUavWeather(const std::string& path, const WeatherReason& reason, const std::string& time,
                      Findings& findings)
{
    const LimitWords words = wordsOf(reason.of);
    const std::string field = path + words.field;
    if (reason.state == WeatherState::Unknown)
        findings.hint(field, IssueId::ForecastLacksLimit, {time});
    else if (reason.of == WeatherLimit::Icing)
        findings.warn(field, words.beyond, {time});
    else {
        const double tenths = std::round(*reason.value * 10) / 10;
        const Findings::Arguments arguments{Amount{tenths, words.quantity},
                                            Amount{*reason.limit, words.quantity}, time};
        if (reason.state == WeatherState::NoGo)
            findings.warn(field, words.beyond, arguments);
        else
            findings.hint(field, IssueId::ForecastNearLimit, arguments);
    }
}

} // namespace

void adviseWeather(const Scenario& scenario, Findings& findings)
{
    const std::optional<ForecastTime> start = startTime(scenario);
    if (!start || !scenario.forecast) {
        adviseConstantWeather(scenario, findings);
        return;
    }
    const WeatherVerdict weather = weatherOfArea(scenario);
    for (std::size_t i = 0; i < weather.uavs.size(); ++i)
        if (const std::optional<WeatherReason>& reason = weather.uavs[i].reason)
            adviseUavWeather(entryPath("uavs", i), *reason, minuteText(*start, reason->time_s),
                             findings);
}

} // namespace berg
