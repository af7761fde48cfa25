#include "widgets/print/brief_weather.h"

#include "core/mission/mission.h"
#include "widgets/flight/weather_course.h"
#include "widgets/print/brief_table.h"
#include "widgets/print/printable_text.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/forecast_text.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr std::size_t kMostWeatherRows = 7; // including start and end
constexpr std::array<double, 9> kWeatherSteps_s{600,   1200,  1800,  3600, 7200,
                                                10800, 21600, 43200, 86400};

struct FlightSpan
{
    double start_s = 0;
    double end_s = 0;
};

FlightSpan spanOf(const ExportContent& content)
{
    FlightSpan span{.start_s = content.uavs.front().start_s};
    for (const ExportUav& uav : content.uavs) {
        span.start_s = std::min(span.start_s, uav.start_s);
        span.end_s = std::max(span.end_s, pathTotals(uav).end_s);
    }
    span.end_s = std::max(span.end_s, span.start_s);
    return span;
}

/** Start, round times in between, and end. */
std::vector<double> rowTimes_s(const FlightSpan& span)
{
    const double length_s = span.end_s - span.start_s;
    std::vector<double> times_s{span.start_s};
    const auto step = std::ranges::find_if(kWeatherSteps_s, [length_s](double step_s) {
        return length_s / step_s < static_cast<double>(kMostWeatherRows - 1);
    });
    const double step_s = step == kWeatherSteps_s.end() ? length_s / (kMostWeatherRows - 1) : *step;
    for (double time_s = span.start_s + step_s; time_s < span.end_s - step_s / 4; time_s += step_s)
        times_s.push_back(time_s);
    if (span.end_s > span.start_s)
        times_s.push_back(span.end_s);
    return times_s;
}

/** Writes the weather of a flight. */
class WeatherWriter
{
public:
    WeatherWriter(const ExportContent& content, const QLocale& locale)
        : m_content(content), m_locale(locale)
    {
    }

    [[nodiscard]] QString speed(const std::optional<double>& speed_mps, int decimals) const
    {
        return speed_mps ? fixedSpeedText(*speed_mps, decimals, m_locale) : u"–"_s;
    }

    [[nodiscard]] QString wind(const std::optional<Point>& wind_mps) const
    {
        if (!wind_mps || wind_mps->isZero(0))
            return wind_mps ? FlightBrief::tr("No wind") : u"–"_s;
        return FlightBrief::tr("%1 from %2", "speed, direction")
            .arg(speed(wind_mps->norm(), 1), bearingText(-trueOf_mps(*wind_mps)));
    }

    [[nodiscard]] QString current(const std::optional<Point>& current_mps) const
    {
        if (!current_mps || current_mps->isZero(0))
            return u"–"_s;
        return FlightBrief::tr("%1 towards %2", "speed, direction")
            .arg(speed(current_mps->norm(), 2), bearingText(trueOf_mps(*current_mps)));
    }

private:
    [[nodiscard]] Point trueOf_mps(const Point& velocity_mps) const
    {
        return eastNorth_mps(m_content, velocity_mps, flightPlace_m(*m_content.scenario));
    }

    const ExportContent& m_content;
    const QLocale& m_locale;
};

/** Warnings about gaps of the quantities that the brief shows. */
QStringList gapLines(const ExportContent& content, const WeatherCourse& course,
                     const FlightSpan& span)
{
    QStringList lines;
    const auto check = [&](const QString& sentence, const auto& isKnown) {
        std::optional<FlightSpan> gap;
        for (const CoursePoint& point : course.points) {
            if (point.time_s < span.start_s || point.time_s > span.end_s || isKnown(point))
                continue;
            gap = FlightSpan{.start_s = gap ? gap->start_s : point.time_s, .end_s = point.time_s};
        }
        if (gap)
            lines << sentence.arg(briefClock(content, gap->start_s),
                                  briefClock(content, gap->end_s));
    };
    check(FlightBrief::tr("The forecast has no wind between %1 and %2: the plan uses the constant "
                          "wind of the scenario."),
          [](const CoursePoint& point) { return point.wind_mps.has_value(); });
    return lines;
}

} // namespace

BriefWeather briefWeather(const ExportContent& content, const QLocale& locale)
{
    BriefWeather weather;
    const ForecastField* forecast = usableForecast(*content.scenario);
    if (forecast == nullptr)
        return weather;
    const ForecastTime start = forecastStartOf(*content.scenario);
    const FlightSpan span = spanOf(content);
    WeatherCourse course = content.mission != nullptr
                               ? courseOf(*content.scenario, content.mission->interventions())
                               : courseOf(*content.scenario);
    weather.source = printable(forecastText(*forecast, start, locale).toStdString());
    weather.rows = {{content.start ? FlightBrief::tr("Time, UTC") : FlightBrief::tr("Time"),
                     FlightBrief::tr("Wind, true"), FlightBrief::tr("Gusts"),
                     FlightBrief::tr("Current, true")}};
    const WeatherWriter text(content, locale);
    for (const double time_s : rowTimes_s(span)) {
        const CoursePoint point = course.at(time_s);
        weather.rows.push_back({briefClock(content, time_s), text.wind(point.wind_mps),
                                text.speed(point.gust_mps, 1), text.current(point.current_mps)});
    }
    const auto takeOff = start + std::chrono::milliseconds(std::llround(1000 * span.start_s));
    if (const std::optional<double> age_h = oldForecast_h(*forecast, takeOff))
        weather.warnings << FlightBrief::tr("The forecast was issued %1 h before the flight: look "
                                            "for a newer one.")
                                .arg(fixedText(std::round(*age_h), 0, locale));
    weather.warnings << gapLines(content, course, span);
    return weather;
}

} // namespace berg
