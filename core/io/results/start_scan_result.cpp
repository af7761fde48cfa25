#include "core/io/results/start_scan_result.h"

#include "core/base/number_text.h"
#include "core/io/results/result_csv.h"
#include "core/io/results/result_parts.h"
#include "core/io/results/weather_result.h"
#include "core/scenario/utc_time.h"

namespace berg {

namespace {

using Json = ResultJson;

/** UAV, reason and time of the worst weather of a start. */
struct StartReason
{
    std::string uav;
    WeatherReason reason;
    std::string time; ///< UTC
};

std::optional<StartReason> startReasonOf(const StartScan& scan, const StartOutcome& start)
{
    const std::optional<std::size_t> worst = start.weather.worstUav();
    const std::optional<UtcTime> time = parseUtc(start.startUtc);
    if (!worst || !time)
        return std::nullopt;
    const WeatherReason& reason = *start.weather.uavs[*worst].reason;
    return StartReason{
        .uav = scan.uavs.at(*worst), .reason = reason, .time = utcText(*time, reason.time_s)};
}

bool isBest(const StartScan& scan, std::size_t index)
{
    return scan.best == index;
}

} // namespace

std::string startReasonText(const StartScan& scan, const StartOutcome& start)
{
    const std::optional<StartReason> found = startReasonOf(scan, start);
    if (!found)
        return {};
    const std::optional<UtcTime> time = parseUtc(found->time);
    return found->uav + ": " + reasonText(found->reason) + ", from " +
           minuteText(*time, 0).substr(11) + " UTC";
}

std::string startScanJson(const StartScan& scan)
{
    Json json{{"starts", Json::array()}};
    for (const StartOutcome& start : scan.starts) {
        Json entry{{"start_utc", start.startUtc},
                   {"delay_h", start.delay_s / 3600},
                   {"zeta_m2s", orNull(start.zeta_m2s)},
                   {"visits", start.visits},
                   {"weather", nameOf(start.weather.state())}};
        if (const std::optional<StartReason> found = startReasonOf(scan, start))
            entry["reason"] = {{"uav", found->uav},
                               {"limit", nameOf(found->reason.of)},
                               {"value", orNull(found->reason.value)},
                               {"limit_value", orNull(found->reason.limit)},
                               {"time", found->time}};
        json["starts"].push_back(std::move(entry));
    }
    json["best"] = scan.best ? Json(scan.starts[*scan.best].startUtc) : Json(nullptr);
    return resultText(json);
}

std::string startScanCsv(const StartScan& scan)
{
    const auto number = [](const std::optional<double>& value) {
        return value ? numberText(*value) : std::string();
    };
    std::string text =
        "start_utc,delay_h,zeta_m2s,visits,weather,uav,limit,value,limit_value,time,best\n";
    for (std::size_t i = 0; i < scan.starts.size(); ++i) {
        const StartOutcome& start = scan.starts[i];
        text += start.startUtc + ',' + numberText(start.delay_s / 3600) + ',' +
                number(start.zeta_m2s) + ',' + std::to_string(start.visits) + ',' +
                std::string(nameOf(start.weather.state())) + ',';
        if (const std::optional<StartReason> found = startReasonOf(scan, start))
            text += csvField(found->uav) + ',' + std::string(nameOf(found->reason.of)) + ',' +
                    number(found->reason.value) + ',' + number(found->reason.limit) + ',' +
                    found->time + ',';
        else
            text += ",,,,,";
        text += isBest(scan, i) ? "1\n" : "0\n";
    }
    return text;
}

} // namespace berg
