#include "widgets/charts/weather_chart.h"

#include "widgets/theme/quantity_text.h"
#include "widgets/words/forecast_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct WeatherChart
{
    Q_DECLARE_TR_FUNCTIONS(WeatherChart)
};

bool isKnownVelocity(const Point& velocity_mps)
{
    return std::isfinite(velocity_mps.x()) && std::isfinite(velocity_mps.y());
}

const Point& noVelocity_mps()
{
    static const Point kNone(std::numeric_limits<double>::quiet_NaN(), 0);
    return kNone;
}

/** Value of one quantity in the unit of the chart. */
using SpeedOf = std::function<std::optional<double>(const CoursePoint&)>;

/** Adds a line for each part of the run in which the quantity is known. */
void addQuantity(TimeChartContent& content, const WeatherCourse& course, TimeLine line,
                 const SpeedOf& speedOf)
{
    const ShownUnit unit = speedUnit();
    line.unit = unit.name;
    const auto end = [&] {
        if (line.points.empty())
            return;
        content.lines.push_back(line);
        line.points.clear();
        line.isContinued = true;
    };
    for (const CoursePoint& point : course.points) {
        if (const std::optional<double> speed_mps = speedOf(point))
            line.points.emplace_back(point.time_s, unit.fromSi(*speed_mps));
        else
            end();
    }
    end();
}

std::vector<TimeVelocity> velocitiesOf(const WeatherCourse& course,
                                       std::optional<Point> CoursePoint::*velocity)
{
    std::vector<TimeVelocity> velocities;
    for (const CoursePoint& point : course.points)
        velocities.push_back(
            {.time_s = point.time_s, .velocity_mps = (point.*velocity).value_or(noVelocity_mps())});
    return velocities;
}

/** Distinct limits of the fleet, m/s. */
std::set<double> limitsOf_mps(const FlightRecord& record,
                              std::optional<double> WeatherLimits::*limit)
{
    std::set<double> limits_mps;
    for (const Uav& uav : record.scenario.uavs)
        if (uav.weather.*limit)
            limits_mps.insert(*(uav.weather.*limit));
    return limits_mps;
}

void addLimits(TimeChartContent& content, const FlightRecord& record, const QLocale& locale)
{
    const auto add = [&](std::optional<double> WeatherLimits::*limit, const QString& text) {
        for (const double limit_mps : limitsOf_mps(record, limit))
            content.references.push_back({.value = speedUnit().fromSi(limit_mps),
                                          .label = text.arg(speedText(limit_mps, locale, 3))});
    };
    add(&WeatherLimits::wind_mps, WeatherChart::tr("Wind limit %1"));
    add(&WeatherLimits::gust_mps, WeatherChart::tr("Gust limit %1"));
}

/** Returns whether the forecast lacks a quantity at some time of the run. */
bool hasGap(const WeatherCourse& course, std::optional<Point> CoursePoint::*velocity)
{
    return course.isForecast() && std::ranges::any_of(course.points, [&](const CoursePoint& point) {
               return !(point.*velocity);
           });
}

/** Shows the constant wind and current that are flown in gaps of the forecast. */
void addGapValues(TimeChartContent& content, const WeatherCourse& course, const Scenario& scenario,
                  const QLocale& locale)
{
    const double wind_mps = scenario.wind_mps.norm();
    const double current_mps = scenario.current_mps.norm();
    if (hasGap(course, &CoursePoint::wind_mps))
        content.references.push_back({.value = speedUnit().fromSi(wind_mps),
                                      .label = WeatherChart::tr("Flown in gaps: constant wind %1")
                                                   .arg(speedText(wind_mps, locale, 3))});
    const bool givesCurrent = std::ranges::any_of(
        course.points, [](const CoursePoint& point) { return point.current_mps.has_value(); });
    if (givesCurrent && hasGap(course, &CoursePoint::current_mps)) // it has an axis of its own
        content.title = WeatherChart::tr("%1; in gaps the constant current of %2", "title, speed")
                            .arg(content.title, speedText(current_mps, locale, 3));
}

/** Returns the weather with the scenario's constant values in gaps, as it is flown. */
CoursePoint flownWeather(CoursePoint weather, const Scenario& scenario)
{
    weather.wind_mps = weather.wind_mps.value_or(scenario.wind_mps);
    weather.gust_mps = weather.gust_mps ? weather.gust_mps : scenario.weather.gust_mps;
    weather.current_mps = weather.current_mps.value_or(scenario.current_mps);
    return weather;
}

QString weatherSummary(const CoursePoint& weather, const QLocale& locale)
{
    QStringList parts;
    if (weather.wind_mps)
        parts << (weather.wind_mps->isZero(0)
                      ? WeatherChart::tr("no wind")
                      : WeatherChart::tr("wind %1 from %2")
                            .arg(speedText(weather.wind_mps->norm(), locale),
                                 bearingText(-*weather.wind_mps)));
    if (weather.gust_mps)
        parts << WeatherChart::tr("gusts %1").arg(speedText(*weather.gust_mps, locale));
    if (weather.current_mps && !weather.current_mps->isZero(0))
        parts << WeatherChart::tr("current %1 towards %2")
                     .arg(speedText(weather.current_mps->norm(), locale),
                          bearingText(*weather.current_mps));
    return parts.isEmpty() ? WeatherChart::tr("unknown") : parts.join(u", "_s);
}

} // namespace

QString TimeDirections::textAt(LineRole role, double time_s) const
{
    if (role != LineRole::Wind && role != LineRole::Current)
        return {};
    const bool isWind = role == LineRole::Wind;
    const auto velocity_mps = velocityAt_mps(isWind ? wind : current, time_s);
    if (!velocity_mps || velocity_mps->isZero(0))
        return {};
    return isWind ? WeatherChart::tr("from %1").arg(bearingText(-*velocity_mps))
                  : WeatherChart::tr("towards %1").arg(bearingText(*velocity_mps));
}

std::optional<Point> velocityAt_mps(const std::vector<TimeVelocity>& velocities, double time_s)
{
    const auto after = std::ranges::lower_bound(velocities, time_s, {}, &TimeVelocity::time_s);
    if (after == velocities.end())
        return std::nullopt;
    Point found_mps = after->velocity_mps;
    if (after->time_s > time_s) {
        if (after == velocities.begin())
            return std::nullopt;
        const TimeVelocity& before = *std::prev(after);
        const double share = (time_s - before.time_s) / (after->time_s - before.time_s);
        found_mps = before.velocity_mps + share * (after->velocity_mps - before.velocity_mps);
    }
    return isKnownVelocity(found_mps) ? std::optional<Point>(found_mps) : std::nullopt;
}

void fillWeather(TimeChartContent& content, const FlightRecord& record, const QLocale& locale)
{
    const std::shared_ptr<const WeatherCourse> course = weatherOfRun(record);
    const double now_s = record.shown().time_s;
    const QString unit = speedUnit().name;
    content.title = course->isForecast() ? WeatherChart::tr("Forecast of wind and current")
                                         : WeatherChart::tr("Wind and current");
    content.leftTitle = WeatherChart::tr("Wind, %1").arg(unit);
    content.duration_s = std::max(record.scenario.duration_s, record.now.time_s);
    content.followed_s = record.now.time_s;
    if (record.inFlight())
        content.cursor_s = now_s;
    content.marks_s.clear(); // visits say nothing about the weather
    content.directions = {.wind = velocitiesOf(*course, &CoursePoint::wind_mps),
                          .current = velocitiesOf(*course, &CoursePoint::current_mps),
                          .isSouthern = record.scenario.origin.latitude_deg < 0};
    const auto norm = [](const std::optional<Point>& velocity_mps) {
        return velocity_mps ? std::optional(velocity_mps->norm()) : std::nullopt;
    };
    const auto key = [](const char* name) -> QString {
        return QLatin1String(name) +
               (shownUnits().speed == SpeedUnit::Knots ? u"_kn"_s : u"_mps"_s);
    };
    addQuantity(content, *course,
                {.label = WeatherChart::tr("Wind"),
                 .points = {},
                 .role = LineRole::Wind,
                 .key = key("wind")},
                [&](const CoursePoint& point) { return norm(point.wind_mps); });
    addQuantity(content, *course,
                {.label = WeatherChart::tr("Gusts"),
                 .points = {},
                 .role = LineRole::Gust,
                 .key = key("gust")},
                [](const CoursePoint& point) { return point.gust_mps; });
    addQuantity(content, *course,
                {.label = WeatherChart::tr("Current"),
                 .points = {},
                 .role = LineRole::Current,
                 .onRightAxis = true,
                 .key = key("current")},
                [&](const CoursePoint& point) { return norm(point.current_mps); });
    if (std::ranges::any_of(content.lines, &TimeLine::onRightAxis))
        content.rightTitle = WeatherChart::tr("Current, %1").arg(unit);
    addLimits(content, record, locale);
    addGapValues(content, *course, record.scenario, locale);
    content.emptyText = WeatherChart::tr("The forecast does not cover this run");
    content.summary =
        WeatherChart::tr("Weather at %1: %2.")
            .arg(content.clock.text(now_s),
                 weatherSummary(flownWeather(course->at(now_s), record.scenario), locale));
    if (const ForecastField* forecast = usableForecast(record.scenario))
        content.summary +=
            u' ' + forecastText(*forecast, forecastStartOf(record.scenario), locale) + u'.';
}

} // namespace berg
