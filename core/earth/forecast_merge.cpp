#include "core/earth/forecast_merge.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace berg {

namespace {

/** First and second of the two neighbours around a value; both are the end beyond it. */
std::pair<std::size_t, std::size_t> neighboursOf(const std::vector<double>& rising, double value)
{
    const auto after =
        static_cast<std::size_t>(std::ranges::upper_bound(rising, value) - rising.begin());
    if (after == 0)
        return {0, 0};
    if (after == rising.size() || rising[after - 1] == value)
        return {after - 1, after - 1};
    return {after - 1, after};
}

double turned_deg(double offset)
{
    return offset - 360 * std::floor((offset + 180) / 360);
}

/** Adds the names of a list ("a, b") that another list does not hold yet. */
void addSources(std::string& all, const std::string& more)
{
    if (more.empty() || all.find(more) != std::string::npos)
        return;
    all += (all.empty() ? "" : ", ") + more;
}

} // namespace

Forecast nearForecastAt(const ForecastField& field, const LatLon& place)
{
    std::vector<double> rows;
    std::vector<double> columns;
    for (std::size_t i = 0; i < field.places.size(); i += field.columns)
        rows.push_back(field.places[i].place.latitude_deg);
    // From the middle, so that a place beside the grid is beyond its nearer edge.
    const double west = field.places.front().place.longitude_deg;
    const double width = turned_deg(field.places[field.columns - 1].place.longitude_deg - west);
    const double middle = west + width / 2;
    for (std::size_t i = 0; i < field.columns; ++i)
        columns.push_back(turned_deg(field.places[i].place.longitude_deg - middle));
    const auto [south, north] = neighboursOf(rows, place.latitude_deg);
    const auto [first, last] = neighboursOf(columns, turned_deg(place.longitude_deg - middle));
    ForecastField near{.columns = first == last ? 1U : 2U, .places = {}};
    for (const std::size_t row : {south, north}) {
        near.places.push_back(field.places[row * field.columns + first]);
        if (first != last)
            near.places.push_back(field.places[row * field.columns + last]);
        if (south == north)
            break;
    }
    Forecast forecast = forecastAt(near, place);
    forecast.place = place;
    return forecast;
}

ForecastField combined(std::span<const ForecastField> fields)
{
    require(!fields.empty(), "combined: no forecast");
    const auto size = [](const ForecastField& field) { return field.places.size(); };
    ForecastField all = *std::ranges::max_element(fields, {}, size);
    if (fields.size() == 1)
        return all;
    std::string source;
    std::optional<ForecastTime> issued;
    for (Forecast& place : all.places) {
        std::vector<Forecast> here;
        for (const ForecastField& field : fields)
            here.push_back(nearForecastAt(field, place.place));
        Forecast made = combined(here);
        made.place = place.place;
        for (const Forecast& forecast : here)
            if (!made.depth_m)
                made.depth_m = forecast.depth_m;
        addSources(source, made.source);
        if (made.issued && (!issued || *made.issued < *issued))
            issued = made.issued;
        place = std::move(made);
    }
    // Every place needs the instants of all: those of the first are the grid's.
    std::vector<ForecastTime> times;
    for (const Forecast& place : all.places)
        for (const ForecastEntry& entry : place.series)
            times.push_back(entry.time);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    for (Forecast& place : all.places) {
        place.source = source;
        place.issued = issued;
        std::vector<ForecastEntry> series;
        for (const ForecastTime time : times)
            series.push_back(entryAt(place, time));
        place.series = std::move(series);
    }
    return all;
}

} // namespace berg
