#include "widgets/map/picture/map_weather.h"

#include "widgets/flight/weather_course.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace berg {
namespace {

/** Neighbours of a number in a rising list, and the share of the second; beyond it both are the
 * end. */
struct GridNeighbours
{
    std::size_t first = 0;
    std::size_t second = 0;
    double share = 0;
};

GridNeighbours gridNeighbours(const std::vector<double>& list, double number)
{
    const auto after =
        static_cast<std::size_t>(std::ranges::upper_bound(list, number) - list.begin());
    if (after == 0)
        return {};
    if (after == list.size())
        return {.first = after - 1, .second = after - 1};
    return {.first = after - 1,
            .second = after,
            .share = (number - list[after - 1]) / (list[after] - list[after - 1])};
}

/** Weighted mean of the corners that have the quantity; nullopt if none has. */
std::optional<Point> meanOfCorners(const std::array<const MapWeatherValues*, 4>& corners,
                                   const std::array<double, 4>& weights,
                                   std::optional<Point> MapWeatherValues::*quantity)
{
    Point sum = Point::Zero();
    double weight = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::optional<Point>& value = corners[i]->*quantity;
        if (!value || weights[i] <= 0)
            continue;
        sum += weights[i] * *value;
        weight += weights[i];
    }
    return weight > 0 ? std::optional<Point>(sum / weight) : std::nullopt;
}

} // namespace

MapWeather::MapWeather(const ForecastField& field, ForecastTime time, const LatLon& origin)
    : m_frame(origin)
{
    const std::vector<Forecast>& places = field.places;
    m_middle_deg = places.front().place.longitude_deg;
    m_middle_deg += eastOfMiddle_deg(places[field.columns - 1].place.longitude_deg) / 2;
    for (std::size_t i = 0; i < field.columns; ++i)
        m_easts_deg.push_back(eastOfMiddle_deg(places[i].place.longitude_deg));
    for (std::size_t i = 0; i < places.size(); i += field.columns)
        m_rows_deg.push_back(places[i].place.latitude_deg);
    for (const Forecast& place : places) {
        const ForecastEntry entry = entryAt(place, time);
        m_values.push_back({.wind_mps = entry.wind_mps, .current_mps = entry.current_mps});
        m_givesWind = m_givesWind || entry.wind_mps;
        m_givesCurrent = m_givesCurrent || entry.current_mps;
    }
}

double MapWeather::eastOfMiddle_deg(double longitude_deg) const
{
    const double turns = (longitude_deg - m_middle_deg + 180) / 360;
    return (turns - std::floor(turns)) * 360 - 180;
}

MapWeatherValues MapWeather::at(const Point& place_m) const
{
    if (m_values.size() == 1)
        return m_values.front();
    const LatLon place = m_frame.toGeographic(place_m);
    const GridNeighbours row = gridNeighbours(m_rows_deg, place.latitude_deg);
    const GridNeighbours column =
        gridNeighbours(m_easts_deg, eastOfMiddle_deg(place.longitude_deg));
    const auto corner = [&](std::size_t r, std::size_t c) {
        return &m_values[r * m_easts_deg.size() + c];
    };
    const std::array<const MapWeatherValues*, 4> corners{
        corner(row.first, column.first), corner(row.first, column.second),
        corner(row.second, column.first), corner(row.second, column.second)};
    const std::array<double, 4> weights{(1 - row.share) * (1 - column.share),
                                        (1 - row.share) * column.share,
                                        row.share * (1 - column.share), row.share * column.share};
    return {.wind_mps = meanOfCorners(corners, weights, &MapWeatherValues::wind_mps),
            .current_mps = meanOfCorners(corners, weights, &MapWeatherValues::current_mps)};
}

MapWeatherPointer mapWeatherAt(const Scenario& scenario, double time_s)
{
    const ForecastField* field = usableForecast(scenario);
    if (field == nullptr)
        return nullptr;
    const auto after = std::chrono::milliseconds(std::llround(1000 * time_s));
    return std::make_shared<const MapWeather>(*field, forecastStartOf(scenario) + after,
                                              scenario.origin);
}

MapWeatherPointer MapWeatherCache::at(const Scenario& scenario, std::uint64_t world, double time_s)
{
    constexpr double kMinute_s = 60;
    const double minute = std::floor(time_s / kMinute_s);
    if (m_minute == minute && m_world == world)
        return m_weather;
    m_weather = mapWeatherAt(scenario, minute * kMinute_s);
    m_world = world;
    m_minute = minute;
    return m_weather;
}

} // namespace berg
