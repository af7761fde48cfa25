#include "widgets/words/weather_words.h"

#include "core/scenario/utc_time.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

namespace berg {
namespace {

/** Translation context of free functions, which lupdate would otherwise omit. */
struct WeatherWords
{
    Q_DECLARE_TR_FUNCTIONS(WeatherWords)
};

QString limitName(WeatherLimit limit)
{
    switch (limit) {
    case WeatherLimit::Wind:
        return WeatherWords::tr("wind");
    case WeatherLimit::Gust:
        return WeatherWords::tr("gusts");
    case WeatherLimit::Visibility:
        return WeatherWords::tr("visibility");
    case WeatherLimit::Ceiling:
        return WeatherWords::tr("cloud base");
    case WeatherLimit::Icing:
        break;
    }
    return WeatherWords::tr("icing");
}

QString valueText(WeatherLimit limit, double value, const QLocale& locale)
{
    switch (limit) {
    case WeatherLimit::Visibility:
        return distanceText(value, locale);
    case WeatherLimit::Ceiling:
        return heightText(value, locale);
    case WeatherLimit::Wind:
    case WeatherLimit::Gust:
    case WeatherLimit::Icing:
        break;
    }
    return speedText(value, locale, 3);
}

QString timeText(const ScenarioWorld& scenario, double time_s)
{
    constexpr int kClock = 11;
    if (const std::optional<ForecastTime> start = startTime(scenario))
        return WeatherWords::tr("%1 UTC").arg(
            QString::fromStdString(minuteText(*start, time_s)).mid(kClock));
    return clockText(time_s);
}

} // namespace

QString weatherStateText(WeatherState state)
{
    switch (state) {
    case WeatherState::Go:
        return WeatherWords::tr("Go");
    case WeatherState::Marginal:
        return WeatherWords::tr("Marginal");
    case WeatherState::Unknown:
        return WeatherWords::tr("Not known");
    case WeatherState::NoGo:
        break;
    }
    return WeatherWords::tr("No-go");
}

QString weatherReasonText(const WeatherReason& reason, const QLocale& locale)
{
    const QString name = limitName(reason.of);
    if (!reason.limit)
        return name;
    const QString limit = valueText(reason.of, *reason.limit, locale);
    if (!reason.value)
        return WeatherWords::tr("%1 not known, limit %2").arg(name, limit);
    return WeatherWords::tr("%1 %2, limit %3", "wind, its value, its limit")
        .arg(name, valueText(reason.of, *reason.value, locale), limit);
}

QString weatherText(const ScenarioWorld& scenario, const WeatherVerdict& weather,
                    const QLocale& locale)
{
    const QString state = weatherStateText(weather.state());
    const std::optional<std::size_t> worst = weather.worstUav();
    if (!worst)
        return state;
    const WeatherReason& reason = *weather.uavs[*worst].reason;
    QString why = weatherReasonText(reason, locale);
    if (scenario.uavs.size() > 1) {
        const Uav& uav = scenario.uavs[*worst];
        why = WeatherWords::tr("%1, %2", "a UAV and what concerns it")
                  .arg(QString::fromStdString(uav.name.empty() ? uav.id : uav.name), why);
    }
    return WeatherWords::tr("%1: %2, from %3", "state, reason, time")
        .arg(state, why, timeText(scenario, reason.time_s));
}

} // namespace berg
