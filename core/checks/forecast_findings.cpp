#include "core/checks/forecast_findings.h"

#include "core/scenario/fields.h"
#include "core/scenario/flight_weather.h"

#include <array>
#include <cmath>
#include <type_traits>

namespace berg {

namespace {

constexpr double kHours_s = 3600;

template <class T>
void checkForecastNumbers(const T& object, const std::string& path, Findings& findings)
{
    for (const Field<T>& field : fieldsOf<T>())
        withField(field, object, [&]<class Value>(const Value& value) {
            constexpr bool kIsNumber = std::is_same_v<Value, double> ||
                                       std::is_same_v<Value, std::optional<double>> ||
                                       std::is_same_v<Value, std::optional<Point>>;
            if constexpr (kIsNumber)
                findings.inRange(value, *field.limits, path + field.name);
        });
}

void checkForecastPlace(const Forecast& place, const std::string& path, Findings& findings)
{
    checkForecastNumbers(place, path + '.', findings);
    const std::string series = path + ".series";
    if (place.series.empty())
        findings.error(series, IssueId::ForecastEmpty);
    for (std::size_t i = 0; i < place.series.size(); ++i) {
        const std::string entry = entryPath(series, i);
        checkForecastNumbers(place.series[i], entry + '.', findings);
        if (i > 0 && place.series[i].time <= place.series[i - 1].time)
            findings.error(entry + ".time", IssueId::TrackNotRising);
    }
}

/** Returns the forecast of the place for which the flight's wind is taken. */
Forecast forecastOfFlight(const Scenario& scenario)
{
    Point middle_m = Point::Zero();
    for (const Uav& uav : scenario.uavs)
        middle_m += uav.position_m / static_cast<double>(scenario.uavs.size());
    return forecastAt(*scenario.forecast, LocalFrame(scenario.origin).toGeographic(middle_m));
}

double hoursAfter(ForecastTime start, ForecastTime time)
{
    return std::chrono::duration<double>(time - start).count() / kHours_s;
}

/** Rounds to a tenth for a message. */
double tenth(double value)
{
    return std::round(10 * value) / 10;
}

/** Warns of the part of the run before the first and after the last value of a quantity. */
void adviseEnds(const Forecast& forecast, ForecastQuantity quantity, ForecastTime start,
                double duration_h, Findings& findings)
{
    std::optional<double> first_h;
    double last_h = 0;
    for (const ForecastEntry& entry : forecast.series) {
        if (!gives(entry, quantity))
            continue;
        last_h = hoursAfter(start, entry.time);
        first_h = first_h.value_or(last_h);
    }
    if (!first_h)
        return;
    const double given_h = std::max(0.0, std::min(last_h, duration_h) - std::max(*first_h, 0.0));
    if (const double missing_h = tenth(duration_h - given_h); missing_h > 0)
        findings.warn("forecast", IssueId::ForecastOutside,
                      {std::string(nameOf(quantity)), missing_h});
}

} // namespace

void checkForecast(const Scenario& scenario, Findings& findings)
{
    if (!scenario.forecast)
        return;
    const ForecastField& field = *scenario.forecast;
    if (field.places.empty() || field.places.size() > kMostForecastPlaces) {
        findings.error("forecast.places", IssueId::ForecastPlaces,
                       {countOf(kMostForecastPlaces), countOf(field.places.size())});
        return;
    }
    std::size_t entries = 0;
    for (const Forecast& place : field.places)
        entries += place.series.size();
    if (entries > kMostForecastEntries) {
        findings.error("forecast.places", IssueId::ForecastEntries,
                       {countOf(kMostForecastEntries), countOf(entries)});
        return;
    }
    findings.utf8(field.places.front().source, "forecast.source");
    for (std::size_t i = 0; i < field.places.size(); ++i)
        checkForecastPlace(field.places[i], entryPath("forecast.places", i), findings);
    if (!findings.has("forecast.places") && !isGrid(field))
        findings.error("forecast.places", IssueId::ForecastNoGrid);
    if (scenario.startUtc.empty())
        findings.conflict("forecast", IssueId::ForecastNoStart);
}

void adviseForecast(const Scenario& scenario, Findings& findings)
{
    if (!scenario.forecast)
        return;
    const ForecastTime start = utcTimeOf(scenario.startUtc).value();
    const ForecastTime end =
        start + std::chrono::milliseconds(std::llround(1e3 * scenario.duration_s));
    const Forecast forecast = forecastOfFlight(scenario);
    constexpr std::array kUsed{ForecastQuantity::Wind, ForecastQuantity::Gust,
                               ForecastQuantity::Current};
    for (const ForecastQuantity quantity : kUsed)
        adviseEnds(forecast, quantity, start, scenario.duration_s / kHours_s, findings);
    for (const ForecastGap& gap : gapsOf(forecast, start, end))
        if (std::ranges::find(kUsed, gap.quantity) != kUsed.end())
            findings.warn("forecast", IssueId::ForecastGap,
                          {std::string(nameOf(gap.quantity)), tenth(hoursAfter(start, gap.from)),
                           tenth(hoursAfter(start, gap.to))});
    if (const std::optional<double> age_h = ageAt_h(forecast, start);
        age_h && *age_h > kOldForecast_h)
        findings.warn("forecast.issued", IssueId::ForecastOld, {std::round(*age_h)});
}

void adviseIceChart(const Scenario& scenario, Findings& findings)
{
    if (!scenario.iceChart)
        return;
    if (const std::optional<double> age_s = ageOf_s(*scenario.iceChart, scenario.startUtc);
        age_s > kOldIceChart_s)
        findings.hint("ice_chart.date_utc", IssueId::IceChartOld,
                      {static_cast<std::int64_t>(std::floor(*age_s / 3600))});
}

} // namespace berg
