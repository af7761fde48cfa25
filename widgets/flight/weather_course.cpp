#include "widgets/flight/weather_course.h"

#include "core/base/error.h"
#include "core/scenario/utc_time.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

constexpr double kFinestStep_s = 30;
constexpr double kCoursePoints = 300; // speeds are not linear between the times of a forecast
constexpr double kJump_s = 1e-3;      // duration of the change to a reported wind

double runTime_s(ForecastTime start, ForecastTime time)
{
    return std::chrono::duration<double>(time - start).count();
}

template <class Value>
std::optional<Value> courseBetween(const std::optional<Value>& from, const std::optional<Value>& to,
                                   double share)
{
    if (share <= 0)
        return from;
    if (share >= 1)
        return to;
    return from && to ? std::optional<Value>(*from + share * (*to - *from)) : std::nullopt;
}

std::vector<double> courseTimes_s(const Scenario& scenario, const ForecastField& field,
                                  ForecastTime start)
{
    const double end_s = scenario.duration_s;
    std::vector<double> times_s{0, end_s};
    const double step_s = std::max(kFinestStep_s, end_s / kCoursePoints);
    for (double time_s = step_s; time_s < end_s; time_s += step_s)
        times_s.push_back(time_s);
    for (const ForecastEntry& entry : field.places.front().series)
        if (const double time_s = runTime_s(start, entry.time); time_s > 0 && time_s < end_s)
            times_s.push_back(time_s);
    std::ranges::sort(times_s);
    times_s.erase(std::unique(times_s.begin(), times_s.end()), times_s.end());
    return times_s;
}

void addForecast(WeatherCourse& course, const Scenario& scenario, const ForecastField& field)
{
    const ForecastTime start = forecastStartOf(scenario);
    course.source = sourceOf(field);
    if (const auto& issued = field.places.front().issued)
        course.issued_s = runTime_s(start, *issued);
    const FlightWeather weather(scenario);
    const CoursePoint constant = course.points.front();
    course.points.clear();
    for (const double time_s : courseTimes_s(scenario, field, start)) {
        const ForecastWeather now = weather.forecastAt(time_s);
        course.points.push_back(
            {.time_s = time_s,
             .wind_mps = weather.givesWind() ? now.wind_mps : constant.wind_mps,
             .gust_mps = weather.givesGust() ? now.gust_mps : constant.gust_mps,
             .current_mps = weather.givesCurrent() ? now.current_mps : constant.current_mps});
    }
}

/** Sets the wind from a time on. */
void reportWind(WeatherCourse& course, double time_s, const Point& wind_mps)
{
    const auto insert = [&](const CoursePoint& point) {
        const auto after =
            std::ranges::lower_bound(course.points, point.time_s, {}, &CoursePoint::time_s);
        if (after == course.points.end() || after->time_s > point.time_s)
            course.points.insert(after, point);
    };
    if (time_s > 0)
        insert(course.at(time_s));
    if (time_s + kJump_s < course.points.back().time_s) {
        CoursePoint changed = course.at(time_s + kJump_s);
        changed.wind_mps = wind_mps;
        insert(changed);
    }
    for (CoursePoint& point : course.points)
        if (point.time_s > time_s || time_s <= 0)
            point.wind_mps = wind_mps;
    course.reported_s = course.reported_s.value_or(time_s);
}

} // namespace

CoursePoint WeatherCourse::at(double time_s) const
{
    const auto after = std::ranges::lower_bound(points, time_s, {}, &CoursePoint::time_s);
    CoursePoint found;
    if (after == points.begin() || after == points.end()) {
        found = after == points.end() ? points.back() : points.front();
    } else {
        const CoursePoint& before = *std::prev(after);
        const double share = (time_s - before.time_s) / (after->time_s - before.time_s);
        found = {.wind_mps = courseBetween(before.wind_mps, after->wind_mps, share),
                 .gust_mps = courseBetween(before.gust_mps, after->gust_mps, share),
                 .current_mps = courseBetween(before.current_mps, after->current_mps, share)};
    }
    found.time_s = time_s;
    return found;
}

ForecastTime forecastStartOf(const Scenario& scenario)
{
    const std::optional<UtcTime> start = parseUtc(scenario.startUtc);
    require(start.has_value(), "forecastStartOf: no start");
    return *start;
}

std::string sourceOf(const ForecastField& forecast)
{
    const std::string& source = forecast.places.front().source;
    return source.empty() ? "?" : source;
}

WeatherCourse courseOf(const Scenario& scenario, std::span<const Intervention> changes)
{
    CoursePoint constant{.wind_mps = scenario.wind_mps, .gust_mps = scenario.weather.gust_mps};
    if (!scenario.current_mps.isZero(0))
        constant.current_mps = scenario.current_mps;
    WeatherCourse course{.points = {constant, constant}, .source = {}};
    course.points.back().time_s = scenario.duration_s;
    if (const ForecastField* field = usableForecast(scenario))
        addForecast(course, scenario, *field);
    for (const Intervention& change : changes)
        if (change.wind_mps)
            reportWind(course, change.time_s, *change.wind_mps);
    return course;
}

CoursePoint weatherAtStart(const Scenario& scenario)
{
    CoursePoint weather{.wind_mps = scenario.wind_mps,
                        .gust_mps = scenario.weather.gust_mps,
                        .current_mps = scenario.current_mps};
    if (usableForecast(scenario) == nullptr)
        return weather;
    const ForecastWeather start = FlightWeather(scenario).forecastAt(0);
    weather.wind_mps = start.wind_mps ? start.wind_mps : weather.wind_mps;
    weather.gust_mps = start.gust_mps ? start.gust_mps : weather.gust_mps;
    weather.current_mps = start.current_mps ? start.current_mps : weather.current_mps;
    return weather;
}

} // namespace berg
