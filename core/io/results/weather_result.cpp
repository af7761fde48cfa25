#include "core/io/results/weather_result.h"

#include "core/base/number_text.h"
#include "core/io/results/result_parts.h"
#include "core/scenario/utc_time.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

std::string unitOf(WeatherLimit limit)
{
    const bool isSpeed = limit == WeatherLimit::Wind || limit == WeatherLimit::Gust;
    return isSpeed ? " m/s" : " m";
}

std::string timeText(const ScenarioWorld& scenario, double time_s)
{
    const std::optional<ForecastTime> start = startTime(scenario);
    return start ? minuteText(*start, time_s) + " UTC" : fixedText(time_s, 0) + " s";
}

} // namespace

std::string reasonText(const WeatherReason& reason)
{
    std::string text{nameOf(reason.of)};
    if (reason.state == WeatherState::Unknown)
        text += " unknown";
    else if (reason.value)
        text += ' ' + numberText(std::round(*reason.value * 10) / 10) + unitOf(reason.of);
    if (reason.limit)
        text += ", limit " + numberText(*reason.limit) + unitOf(reason.of);
    return text;
}

std::string weatherLine(const ScenarioWorld& scenario, const WeatherVerdict& weather)
{
    std::string text{nameOf(weather.state())};
    const std::optional<std::size_t> worst = weather.worstUav();
    if (!worst)
        return text;
    const WeatherReason& reason = *weather.uavs[*worst].reason;
    text += "  " + scenario.uavs[*worst].id + ": ";
    const std::string words = reasonText(reason);
    const std::size_t comma = std::min(words.find(','), words.size());
    return text + words.substr(0, comma) + " at " + timeText(scenario, reason.time_s) +
           words.substr(comma);
}

nlohmann::ordered_json weatherTree(const std::vector<std::string>& uavIds,
                                   const WeatherVerdict& weather)
{
    ResultJson json{{"state", nameOf(weather.state())}, {"uavs", ResultJson::array()}};
    for (std::size_t i = 0; i < weather.uavs.size(); ++i) {
        const UavWeather& uav = weather.uavs[i];
        ResultJson entry{{"id", uavIds.at(i)}, {"state", nameOf(uav.state)}};
        if (uav.reason) {
            entry["limit"] = nameOf(uav.reason->of);
            entry["value"] = orNull(uav.reason->value);
            entry["limit_value"] = orNull(uav.reason->limit);
            entry["time_s"] = uav.reason->time_s;
        }
        json["uavs"].push_back(std::move(entry));
    }
    return json;
}

} // namespace berg
