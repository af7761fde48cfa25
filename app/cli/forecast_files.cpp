#include "app/cli/forecast_files.h"

#include "app/cli/console.h"
#include "core/earth/forecast_merge.h"
#include "core/io/import/import_scenario_forecast.h"

#include <array>
#include <charconv>
#include <cmath>

namespace berg::cli {

namespace {

/** Prints a warning about a file; an empty name is left out. */
void warn(const std::string& file, const std::string& text)
{
    printNote(word(file) + (file.empty() ? "" : ": ") +
              said(QT_TRANSLATE_NOOP("CommandLine", "warning"), {}) + ": " + text);
}

/** Returns a box with no size at a place. */
GeoBox boxAt(const LatLon& place)
{
    return {.south_deg = place.latitude_deg,
            .west_deg = place.longitude_deg,
            .north_deg = place.latitude_deg,
            .east_deg = place.longitude_deg};
}

} // namespace

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

ForecastReading readForecastFile(const std::string& file, const ForecastReadOptions& options)
{
    ProgressBar bar(said(QT_TRANSLATE_NOOP("CommandLine", "reading"), {}), true);
    return reading(
        [&] { return loadForecastFile(file, options, [&](double share) { bar.update(share); }); });
}

ForecastFiles readForecasts(const std::vector<std::string>& files, const ForecastPart& part)
{
    ForecastFiles read{.files = files, .forecasts = {}};
    std::optional<LatLon> place = part.place;
    for (const std::string& file : files) {
        std::optional<GeoBox> area = part.area;
        if (!area && place)
            area = boxAt(*place);
        const ForecastReading made =
            readForecastFile(file, {.area = area, .since = part.since, .until = part.until});
        const std::vector<Forecast>& places = made.field.places;
        if (places.size() > 1)
            read.grids.push_back({.file = file,
                                  .format = made.format,
                                  .rows = places.size() / made.field.columns,
                                  .columns = made.field.columns,
                                  .southWest = places.front().place,
                                  .northEast = places.back().place,
                                  .thinning = made.thinning});
        noteThinning(file, made.thinning);
        // A file for one place is for that place, however far from the wanted one.
        if (places.size() == 1)
            read.forecasts.push_back(places.front());
        else
            read.forecasts.push_back(
                nearForecastAt(made.field, place ? *place : middleOf(made.field).place));
        if (!place)
            place = read.forecasts.back().place;
    }
    return read;
}

std::optional<GeoBox> areaOf(const std::string& text)
{
    if (text.empty())
        return std::nullopt;
    std::array<double, 4> edges_deg{};
    const char* at = text.data();
    const char* const end = at + text.size();
    bool ok = true;
    for (std::size_t i = 0; ok && i < edges_deg.size(); ++i) {
        const auto [next, error] = std::from_chars(at, end, edges_deg[i]);
        const bool last = i + 1 == edges_deg.size();
        ok = error == std::errc() && std::isfinite(edges_deg[i]) &&
             (last ? next == end : next != end && *next == ',');
        at = next + (last ? 0 : 1);
    }
    if (!ok)
        throw UsageError(
            QT_TRANSLATE_NOOP("CommandLine", "--area: %1 is not SOUTH,WEST,NORTH,EAST in degrees"),
            {text});
    return GeoBox{.south_deg = edges_deg[0],
                  .west_deg = edges_deg[1],
                  .north_deg = edges_deg[2],
                  .east_deg = edges_deg[3]};
}

void noteThinning(const std::string& file, std::size_t thinning)
{
    if (thinning > 1)
        printNote(
            word(file) + ": " +
            said(QT_TRANSLATE_NOOP("CommandLine",
                                   "the grid is too large and was thinned by a factor of %1 in "
                                   "each direction; choose a smaller area or time"),
                 {countOf(thinning)}));
}

void warnOfAge(const std::string& file, const std::optional<double>& age_h, UtcTime use)
{
    if (age_h && *age_h > kOldForecast_h)
        warn(file,
             said(QT_TRANSLATE_NOOP("CommandLine", "issued %1 h before %2; get a newer forecast"),
                  {fixed(*age_h, 0), utcText(use, 0)}));
}

void warnOfOldForecasts(const ForecastFiles& files, UtcTime use)
{
    for (std::size_t i = 0; i < files.files.size(); ++i)
        warnOfAge(files.files[i], ageAt_h(files.forecasts[i], use), use);
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
