#include "widgets/words/forecast_text.h"

#include "core/scenario/utc_time.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct ForecastText
{
    Q_DECLARE_TR_FUNCTIONS(ForecastText)
};

/** "2026-11-30 06:00 UTC". */
QString minuteOf(ForecastTime time)
{
    const QString text = QString::fromStdString(utcText(time, 0));
    return text.left(10) + u' ' + text.mid(11, 5) + u" UTC"_s;
}

QString hoursText(double age_h, const QLocale& locale)
{
    return ForecastText::tr("%1 h").arg(fixedText(std::abs(std::round(age_h)), 0, locale));
}

QString quantityName(ForecastQuantity quantity)
{
    switch (quantity) {
    case ForecastQuantity::Wind:
        return ForecastText::tr("wind");
    case ForecastQuantity::Gust:
        return ForecastText::tr("gusts");
    case ForecastQuantity::AirTemperature:
        return ForecastText::tr("air temperature");
    case ForecastQuantity::DewPoint:
        return ForecastText::tr("dew point");
    case ForecastQuantity::Fog:
        return ForecastText::tr("fog");
    case ForecastQuantity::Visibility:
        return ForecastText::tr("visibility");
    case ForecastQuantity::Ceiling:
        return ForecastText::tr("cloud base");
    case ForecastQuantity::Current:
        return ForecastText::tr("current");
    }
    return {};
}

} // namespace

QString forecastSource(const ForecastField& forecast)
{
    const std::string& source = forecast.places.front().source;
    return source.empty() ? ForecastText::tr("unknown source")
                          : QString::fromStdString(source).simplified();
}

QString forecastIssue(const ForecastField& forecast, const std::optional<ForecastTime>& start,
                      const QLocale& locale)
{
    const Forecast& first = forecast.places.front();
    if (!first.issued)
        return ForecastText::tr("time of issue unknown");
    const QString issued = minuteOf(*first.issued);
    if (!start)
        return ForecastText::tr("issued %1").arg(issued);
    const double age_h = ageAt_h(first, *start).value_or(0);
    return (age_h < 0 ? ForecastText::tr("issued %1, %2 after the start")
                      : ForecastText::tr("issued %1, %2 before the start"))
        .arg(issued, hoursText(age_h, locale));
}

QString forecastText(const ForecastField& forecast, const std::optional<ForecastTime>& start,
                     const QLocale& locale)
{
    return ForecastText::tr("Forecast of %1, %2", "source, time of issue")
        .arg(forecastSource(forecast), forecastIssue(forecast, start, locale));
}

std::optional<double> oldForecast_h(const ForecastField& forecast, ForecastTime time)
{
    const std::optional<double> age_h = ageAt_h(forecast.places.front(), time);
    return age_h && *age_h > kOldForecast_h ? age_h : std::nullopt;
}

QString forecastQuantitiesText(const ForecastField& forecast)
{
    QStringList names;
    for (const ForecastQuantity quantity : kForecastQuantities)
        if (std::ranges::any_of(forecast.places, [quantity](const Forecast& place) {
                return gives(place, quantity);
            }))
            names << quantityName(quantity);
    return names.join(u", "_s);
}

} // namespace berg
