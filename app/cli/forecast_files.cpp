#include "app/cli/forecast_files.h"

#include "app/cli/console.h"
#include "core/io/import/import_forecast.h"

namespace berg::cli {

namespace {

/** Prints a warning about a file; an empty name is left out. */
void warn(const std::string& file, const std::string& text)
{
    printNote(word(file) + (file.empty() ? "" : ": ") +
              said(QT_TRANSLATE_NOOP("CommandLine", "warning"), {}) + ": " + text);
}

/** Returns the words for a quantity in the user's language. */
std::string saidQuantity(ForecastQuantity quantity)
{
    switch (quantity) {
    case ForecastQuantity::Wind:
        return said(QT_TRANSLATE_NOOP("CommandLine", "wind"), {});
    case ForecastQuantity::Gust:
        return said(QT_TRANSLATE_NOOP("CommandLine", "gust"), {});
    case ForecastQuantity::AirTemperature:
        return said(QT_TRANSLATE_NOOP("CommandLine", "air temperature"), {});
    case ForecastQuantity::DewPoint:
        return said(QT_TRANSLATE_NOOP("CommandLine", "dew point"), {});
    case ForecastQuantity::Fog:
        return said(QT_TRANSLATE_NOOP("CommandLine", "fog"), {});
    case ForecastQuantity::Visibility:
        return said(QT_TRANSLATE_NOOP("CommandLine", "visibility"), {});
    case ForecastQuantity::Ceiling:
        return said(QT_TRANSLATE_NOOP("CommandLine", "ceiling"), {});
    case ForecastQuantity::Current:
        break;
    }
    return said(QT_TRANSLATE_NOOP("CommandLine", "current"), {});
}

} // namespace

ForecastFiles readForecasts(const std::vector<std::string>& files)
{
    ForecastFiles read{.files = files, .forecasts = {}};
    for (const std::string& file : files)
        read.forecasts.push_back(reading([&] { return loadForecast(file); }));
    return read;
}

void warnOfOldForecasts(const ForecastFiles& files, UtcTime use)
{
    for (std::size_t i = 0; i < files.files.size(); ++i)
        if (const std::optional<double> age_h = ageAt_h(files.forecasts[i], use);
            age_h && *age_h > kOldForecast_h)
            warn(files.files[i],
                 said(QT_TRANSLATE_NOOP("CommandLine",
                                        "issued %1 h before %2; get a newer forecast"),
                      {fixed(*age_h, 0), utcText(use, 0)}));
}

void warnOfFarForecasts(const ForecastFiles& files, LatLon use)
{
    constexpr double kFar_m = 25'000;
    for (std::size_t i = 0; i < files.files.size(); ++i)
        if (const double distance_m = greatCircle_m(files.forecasts[i].place, use);
            distance_m > kFar_m)
            warn(files.files[i], said(QT_TRANSLATE_NOOP("CommandLine", "is for a place %1 km away"),
                                      {fixed(distance_m / 1000, 0)}));
}

void warnOfGaps(const std::vector<ForecastGap>& gaps)
{
    for (const ForecastGap& gap : gaps)
        warn({}, said(QT_TRANSLATE_NOOP("CommandLine", "%1: no values between %2 and %3"),
                      {saidQuantity(gap.quantity), utcText(gap.from, 0), utcText(gap.to, 0)}));
}

} // namespace berg::cli
