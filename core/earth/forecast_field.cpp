#include "core/earth/forecast_field.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace berg {

namespace {

/** Returns the degrees from `from` east to `to`, in [-180, 180). */
double eastOf_deg(double from, double to)
{
    const double turns = (to - from + 180) / 360;
    return (turns - std::floor(turns)) * 360 - 180;
}

/** Two neighbours in a row or column, and the weight of the second. */
struct Neighbours
{
    std::size_t first = 0;
    std::size_t second = 0;
    double share = 0;
};

/** Returns the neighbours of 0 among offsets that rise; both are the end if it is outside. */
Neighbours neighboursOfZero(const std::vector<double>& offsets)
{
    const auto after =
        static_cast<std::size_t>(std::ranges::upper_bound(offsets, 0.0) - offsets.begin());
    if (after == 0)
        return {};
    if (after == offsets.size())
        return {.first = after - 1, .second = after - 1};
    const double before = offsets[after - 1];
    return {.first = after - 1, .second = after, .share = -before / (offsets[after] - before)};
}

Neighbours columnsAround(const ForecastField& field, double longitude_deg)
{
    // Measured from the middle of the grid, so that a place outside is beyond its nearer edge.
    const double west = field.places.front().place.longitude_deg;
    const double width = eastOf_deg(west, field.places[field.columns - 1].place.longitude_deg);
    const double middle = west + width / 2;
    const double place = eastOf_deg(middle, longitude_deg);
    std::vector<double> offsets;
    for (std::size_t i = 0; i < field.columns; ++i)
        offsets.push_back(eastOf_deg(middle, field.places[i].place.longitude_deg) - place);
    return neighboursOfZero(offsets);
}

Neighbours rowsAround(const ForecastField& field, double latitude_deg)
{
    std::vector<double> offsets;
    for (std::size_t i = 0; i < field.places.size(); i += field.columns)
        offsets.push_back(field.places[i].place.latitude_deg - latitude_deg);
    return neighboursOfZero(offsets);
}

/** Four values around a place, and their weights. */
template <class T>
struct Weighted
{
    std::array<T, 4> values;
    std::array<double, 4> weights{};
};

/** Returns `valueAt(i)` of the four places i around a place, with their weights. */
template <class ValueAt>
auto valuesAround(const ForecastField& field, const LatLon& place, const ValueAt& valueAt)
{
    const Neighbours row = rowsAround(field, place.latitude_deg);
    const Neighbours column = columnsAround(field, place.longitude_deg);
    const auto at = [&](std::size_t r, std::size_t c) { return valueAt(r * field.columns + c); };
    return Weighted<decltype(valueAt(0))>{
        .values = {at(row.first, column.first), at(row.first, column.second),
                   at(row.second, column.first), at(row.second, column.second)},
        .weights = {(1 - row.share) * (1 - column.share), (1 - row.share) * column.share,
                    row.share * (1 - column.share), row.share * column.share}};
}

/** Returns the weighted mean of a member over the values that have it. */
template <class T, class Value>
std::optional<Value> weightedMean(const Weighted<T>& around, std::optional<Value> T::*member)
{
    std::optional<Value> sum;
    double weight = 0;
    for (std::size_t i = 0; i < around.values.size(); ++i) {
        const std::optional<Value>& value = around.values[i].*member;
        if (!value || around.weights[i] <= 0)
            continue;
        sum = sum ? Value(*sum + around.weights[i] * *value) : Value(around.weights[i] * *value);
        weight += around.weights[i];
    }
    return sum ? std::optional<Value>(*sum / weight) : std::nullopt;
}

ForecastEntry weightedMean(const Weighted<ForecastEntry>& around, ForecastTime time)
{
    return {.time = time,
            .wind_mps = weightedMean(around, &ForecastEntry::wind_mps),
            .gust_mps = weightedMean(around, &ForecastEntry::gust_mps),
            .airTemperature_degC = weightedMean(around, &ForecastEntry::airTemperature_degC),
            .dewPoint_degC = weightedMean(around, &ForecastEntry::dewPoint_degC),
            .fog_percent = weightedMean(around, &ForecastEntry::fog_percent),
            .visibility_m = weightedMean(around, &ForecastEntry::visibility_m),
            .ceiling_m = weightedMean(around, &ForecastEntry::ceiling_m),
            .current_mps = weightedMean(around, &ForecastEntry::current_mps)};
}

/** Depth of the sea at one place. */
struct SeaDepth
{
    std::optional<double> depth_m;
};

} // namespace

bool isGrid(const ForecastField& field)
{
    if (field.columns == 0 || field.places.empty() || field.places.size() % field.columns != 0)
        return false;
    for (std::size_t i = 0; i < field.places.size(); ++i) {
        const Forecast& forecast = field.places[i];
        const Forecast& west = field.places[i - i % field.columns];
        const Forecast& south = field.places[i % field.columns];
        if (forecast.source != west.source || forecast.issued != south.issued ||
            forecast.place.latitude_deg != west.place.latitude_deg ||
            forecast.place.longitude_deg != south.place.longitude_deg)
            return false;
        if (i % field.columns > 0 &&
            eastOf_deg(field.places[i - 1].place.longitude_deg, forecast.place.longitude_deg) <= 0)
            return false;
        if (i >= field.columns &&
            forecast.place.latitude_deg <= field.places[i - field.columns].place.latitude_deg)
            return false;
    }
    return true;
}

ForecastEntry entryAt(const ForecastField& field, const LatLon& place, ForecastTime time)
{
    require(isGrid(field), "entryAt: no grid");
    if (field.places.size() == 1)
        return entryAt(field.places.front(), time);
    return weightedMean(
        valuesAround(field, place, [&](std::size_t i) { return entryAt(field.places[i], time); }),
        time);
}

std::optional<double> depthAt_m(const ForecastField& field, const LatLon& place)
{
    require(isGrid(field), "depthAt_m: no grid");
    return weightedMean(
        valuesAround(field, place,
                     [&](std::size_t i) { return SeaDepth{field.places[i].depth_m}; }),
        &SeaDepth::depth_m);
}

Forecast forecastAt(const ForecastField& field, const LatLon& place)
{
    require(isGrid(field), "forecastAt: no grid");
    Forecast forecast = field.places.front();
    if (field.places.size() == 1)
        return forecast;
    forecast.place = place;
    forecast.depth_m = depthAt_m(field, place);
    for (ForecastEntry& entry : forecast.series)
        entry = entryAt(field, place, entry.time);
    return forecast;
}

} // namespace berg
