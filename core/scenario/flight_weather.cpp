#include "core/scenario/flight_weather.h"

#include "core/scenario/text_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace berg {

namespace {

constexpr double kWeatherHour_s = 3600;
constexpr std::size_t kLatticeNodes = 17;

double secondsAfter(ForecastTime start, ForecastTime time)
{
    return std::chrono::duration<double>(time - start).count();
}

/** Two neighbours of a number in a list that rises; both are the end beyond it. */
struct ListNeighbours
{
    std::size_t first = 0;
    std::size_t second = 0;
    double share = 0; ///< of the second
};

ListNeighbours neighboursIn(const std::vector<double>& list, double number)
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

/** The mean velocity of one iceberg in the weather of a run. */
class WeatherForcing final : public DriftForcing
{
public:
    WeatherForcing(std::shared_ptr<const FlightWeather> weather, const Iceberg& iceberg)
        : m_weather(std::move(weather))
    {
        if (!iceberg.length_m)
            return;
        m_law = driftLaw(*iceberg.length_m);
        m_draft_m = dimensionsOfLength(*iceberg.length_m).draft_m;
    }

    [[nodiscard]] double fastest_mps() const override
    {
        const Forcing& fastest = m_weather->fastest();
        return m_law ? m_law->currentShare * fastest.current_mps.x() +
                           m_law->windShare * fastest.wind_mps.x()
                     : fastest.current_mps.x();
    }

private:
    [[nodiscard]] std::optional<Point> meanAt_mps(const Point& place_m,
                                                  double time_s) const override
    {
        if (!m_law)
            return m_weather->currentAt_mps(place_m, time_s);
        if (const std::optional<double> depth_m = m_weather->depth_m(place_m);
            depth_m && *depth_m < m_draft_m)
            return std::nullopt;
        return driftVelocity_mps(*m_law, m_weather->forcingAt(place_m, time_s),
                                 m_weather->latitude_deg());
    }

    std::shared_ptr<const FlightWeather> m_weather;
    std::optional<DriftLaw> m_law; ///< nullopt if only the current carries it
    double m_draft_m = 0;
};

} // namespace

Point flightPlace_m(const ScenarioWorld& scenario)
{
    Point middle_m = Point::Zero();
    for (const Uav& uav : scenario.uavs)
        middle_m += uav.position_m / static_cast<double>(scenario.uavs.size());
    return middle_m;
}

const ForecastField* usableForecast(const ScenarioWorld& scenario)
{
    const bool isUsable = scenario.forecast && isGrid(*scenario.forecast) &&
                          isUtcTime(scenario.startUtc) && std::isfinite(scenario.duration_s);
    return isUsable ? &*scenario.forecast : nullptr;
}

FlightWeather::FlightWeather(const ScenarioWorld& scenario)
    : m_frame(scenario.origin)
    , m_wind_mps(scenario.wind_mps)
    , m_current_mps(scenario.current_mps)
    , m_gust_mps(scenario.weather.gust_mps)
    , m_fastest{.wind_mps = {m_wind_mps.norm(), 0}, .current_mps = {m_current_mps.norm(), 0}}
{
    require(scenario.forecast && isGrid(*scenario.forecast), "FlightWeather: no grid");
    const std::optional<ForecastTime> start = utcTimeOf(scenario.startUtc);
    require(start.has_value(), "FlightWeather: no start");
    addPlaces(*scenario.forecast, *start);
    addLattice(*scenario.forecast);
    addWind(scenario);
}

void FlightWeather::addPlaces(const ForecastField& field, ForecastTime start)
{
    const auto add = [](auto& values, double time_s, const auto& value) {
        if (!value)
            return;
        values.time_s.push_back(time_s);
        values.value.push_back(*value);
    };
    for (const Forecast& forecast : field.places) {
        Place& place = m_places.emplace_back(Place{.depth_m = forecast.depth_m});
        m_givesDepth = m_givesDepth || forecast.depth_m;
        for (const ForecastEntry& entry : forecast.series) {
            const double time_s = secondsAfter(start, entry.time);
            add(place.wind, time_s, entry.wind_mps);
            add(place.current, time_s, entry.current_mps);
            add(place.gust, time_s, entry.gust_mps);
            const auto speed_mps = [](const std::optional<Point>& velocity_mps) {
                return velocity_mps ? velocity_mps->norm() : 0;
            };
            double& wind_mps = m_fastest.wind_mps.x();
            double& current_mps = m_fastest.current_mps.x();
            wind_mps = std::max(wind_mps, speed_mps(entry.wind_mps));
            current_mps = std::max(current_mps, speed_mps(entry.current_mps));
            m_givesWind = m_givesWind || entry.wind_mps;
            m_givesGust = m_givesGust || entry.gust_mps;
            m_givesCurrent = m_givesCurrent || entry.current_mps;
        }
    }
    for (std::size_t i = 0; i < field.places.size(); i += field.columns)
        m_latitudes_deg.push_back(field.places[i].place.latitude_deg);
    // Measured from the middle of the grid, so that a place outside is beyond its nearer edge.
    m_middle_deg = field.places.front().place.longitude_deg;
    m_middle_deg += eastOfMiddle_deg(field.places[field.columns - 1].place.longitude_deg) / 2;
    for (std::size_t i = 0; i < field.columns; ++i)
        m_easts_deg.push_back(eastOfMiddle_deg(field.places[i].place.longitude_deg));
}

/**
 * Prepares what replaces the geodesic of each position of an iceberg. Between points of at most
 * 20 km a straight line is wrong by less than 50 m up to 80 degrees of latitude.
 */
void FlightWeather::addLattice(const ForecastField& field)
{
    constexpr double kLongest_m = 20'000;
    constexpr double kHighest_deg = 80;
    if (m_places.size() == 1)
        return;
    Point low_m = Point::Constant(std::numeric_limits<double>::infinity());
    Point high_m = -low_m;
    for (const Forecast& forecast : field.places) {
        if (std::abs(forecast.place.latitude_deg) > kHighest_deg)
            return;
        const Point place_m = m_frame.toPlane(forecast.place);
        low_m = low_m.cwiseMin(place_m);
        high_m = high_m.cwiseMax(place_m);
    }
    constexpr double kSteps = kLatticeNodes - 1;
    const double size_m = (high_m - low_m).maxCoeff();
    if (!(size_m <= kSteps * kLongest_m) || size_m == 0)
        return;
    // Icebergs drift out of the grid, too.
    const double step_m = std::min(3 * size_m / kSteps, kLongest_m);
    low_m = (low_m + high_m) / 2 - Point::Constant(step_m * kSteps / 2);
    m_lattice = {.low_m = low_m, .step_m = step_m, .nodes_deg = {}};
    for (std::size_t row = 0; row < kLatticeNodes; ++row)
        for (std::size_t column = 0; column < kLatticeNodes; ++column)
            m_lattice.nodes_deg.push_back(exactDegreesOf(
                low_m + step_m * Point(static_cast<double>(column), static_cast<double>(row))));
}

void FlightWeather::addWind(const ScenarioWorld& scenario)
{
    m_flight = cellOf(flightPlace_m(scenario));
    WindSeries series;
    const auto steps = static_cast<std::int64_t>(std::ceil(scenario.duration_s / kWindStep_s));
    const auto windOf = [this](double time_s) {
        return between<Point>(m_flight, [&](const Place& place) { return at(place.wind, time_s); })
            .value_or(m_wind_mps);
    };
    const auto add = [&](double from_s, double middle_s) {
        const Point wind_mps = windOf(middle_s);
        if (!series.wind_mps.empty() && series.wind_mps.back() == wind_mps)
            return;
        series.from_s.push_back(from_s);
        series.wind_mps.push_back(wind_mps);
    };
    for (std::int64_t step = 0; step < std::max<std::int64_t>(1, steps); ++step) {
        const double from_s = static_cast<double>(step) * kWindStep_s;
        add(from_s, from_s + kWindStep_s / 2);
    }
    m_strongest_mps = strongest_mps(series, 0, std::numeric_limits<double>::infinity());
    m_wind = std::make_shared<const WindSeries>(std::move(series));
}

double FlightWeather::eastOfMiddle_deg(double longitude_deg) const
{
    const double turns = (longitude_deg - m_middle_deg + 180) / 360;
    return (turns - std::floor(turns)) * 360 - 180;
}

Point FlightWeather::exactDegreesOf(const Point& place_m) const
{
    const LatLon place = m_frame.toGeographic(place_m);
    return {place.latitude_deg, eastOfMiddle_deg(place.longitude_deg)};
}

/** Returns latitude and degrees east of the middle; in the lattice they are bilinear. */
Point FlightWeather::degreesOf(const Point& place_m) const
{
    if (m_lattice.nodes_deg.empty())
        return exactDegreesOf(place_m);
    const Point at = (place_m - m_lattice.low_m) / m_lattice.step_m;
    constexpr double kLast = kLatticeNodes - 1;
    if (!(at.minCoeff() >= 0) || !(at.maxCoeff() < kLast))
        return exactDegreesOf(place_m);
    const auto column = static_cast<std::size_t>(at.x());
    const auto row = static_cast<std::size_t>(at.y());
    const double east = at.x() - static_cast<double>(column);
    const double north = at.y() - static_cast<double>(row);
    const Point* south_deg = &m_lattice.nodes_deg[row * kLatticeNodes + column];
    const Point* north_deg = south_deg + kLatticeNodes;
    return (1 - north) * ((1 - east) * south_deg[0] + east * south_deg[1]) +
           north * ((1 - east) * north_deg[0] + east * north_deg[1]);
}

FlightWeather::Cell FlightWeather::cellOf(const Point& place_m) const
{
    if (m_places.size() == 1)
        return {};
    const Point place_deg = degreesOf(place_m);
    const ListNeighbours row = neighboursIn(m_latitudes_deg, place_deg.x());
    const ListNeighbours column = neighboursIn(m_easts_deg, place_deg.y());
    return {.south = row.first,
            .north = row.second,
            .northShare = row.share,
            .west = column.first,
            .east = column.second,
            .eastShare = column.share};
}

template <class Value>
std::optional<Value> FlightWeather::at(const Values<Value>& values, double time_s)
{
    constexpr double kLongest_s =
        kWeatherHour_s * static_cast<double>(kLongestForecastStep.count());
    const std::vector<double>& times_s = values.time_s;
    if (times_s.empty() || time_s < times_s.front() || time_s > times_s.back())
        return std::nullopt;
    const ListNeighbours around = neighboursIn(times_s, time_s);
    const Value& first = values.value[around.first];
    if (around.share == 0)
        return first;
    if (times_s[around.second] - times_s[around.first] > kLongest_s)
        return std::nullopt;
    const Value& second = values.value[around.second];
    // In this form equal values stay what they are, to the last bit.
    return Value(first + around.share * (second - first));
}

template <class Value, class ValueOf>
std::optional<Value> FlightWeather::between(const Cell& cell, const ValueOf& valueOf) const
{
    const std::size_t columns = m_easts_deg.size();
    const auto placeAt = [&](std::size_t row, std::size_t column) -> std::optional<Value> {
        return valueOf(m_places[row * columns + column]);
    };
    if (cell.south == cell.north && cell.west == cell.east)
        return placeAt(cell.south, cell.west);
    const std::array<std::optional<Value>, 4> values{
        placeAt(cell.south, cell.west), placeAt(cell.south, cell.east),
        placeAt(cell.north, cell.west), placeAt(cell.north, cell.east)};
    if (values[0] && values[1] && values[2] && values[3]) {
        const Value south = *values[0] + cell.eastShare * (*values[1] - *values[0]);
        const Value north = *values[2] + cell.eastShare * (*values[3] - *values[2]);
        return Value(south + cell.northShare * (north - south));
    }
    const std::array<double, 4> weights{
        (1 - cell.northShare) * (1 - cell.eastShare), (1 - cell.northShare) * cell.eastShare,
        cell.northShare * (1 - cell.eastShare), cell.northShare * cell.eastShare};
    std::optional<Value> sum;
    double weight = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!values[i] || weights[i] <= 0)
            continue;
        sum = sum ? Value(*sum + weights[i] * *values[i]) : Value(weights[i] * *values[i]);
        weight += weights[i];
    }
    return sum ? std::optional<Value>(*sum / weight) : std::nullopt;
}

std::optional<double> FlightWeather::gust_mps(double time_s) const
{
    const std::optional<double> gust_mps =
        between<double>(m_flight, [&](const Place& place) { return at(place.gust, time_s); });
    return gust_mps ? gust_mps : m_gust_mps;
}

ForecastWeather FlightWeather::forecastAt(double time_s) const
{
    const auto velocity_mps = [&](const Values<Point> Place::*values) {
        return between<Point>(m_flight,
                              [&](const Place& place) { return at(place.*values, time_s); });
    };
    return {.wind_mps = velocity_mps(&Place::wind),
            .gust_mps = between<double>(m_flight,
                                        [&](const Place& place) { return at(place.gust, time_s); }),
            .current_mps = velocity_mps(&Place::current)};
}

Forcing FlightWeather::forcingAt(const Point& place_m, double time_s) const
{
    const Cell cell = cellOf(place_m);
    const auto valueOf = [&](const Values<Point> Place::*values) {
        return between<Point>(cell, [&](const Place& place) { return at(place.*values, time_s); });
    };
    return {.wind_mps = valueOf(&Place::wind).value_or(m_wind_mps),
            .current_mps = valueOf(&Place::current).value_or(m_current_mps)};
}

Point FlightWeather::currentAt_mps(const Point& place_m, double time_s) const
{
    return between<Point>(cellOf(place_m),
                          [&](const Place& place) { return at(place.current, time_s); })
        .value_or(m_current_mps);
}

std::optional<double> FlightWeather::depth_m(const Point& place_m) const
{
    if (!m_givesDepth)
        return std::nullopt;
    return between<double>(cellOf(place_m), [](const Place& place) { return place.depth_m; });
}

std::shared_ptr<const FlightWeather> weatherOf(const ScenarioWorld& scenario)
{
    return usableForecast(scenario) ? std::make_shared<const FlightWeather>(scenario) : nullptr;
}

Point windAtStart_mps(const ScenarioWorld& scenario)
{
    return windFromStart(scenario).at_mps(0);
}

WindAhead windFromStart(const ScenarioWorld& scenario)
{
    const std::shared_ptr<const FlightWeather> weather = weatherOf(scenario);
    return weather ? WindAhead(weather->wind(), 0) : WindAhead(scenario.wind_mps);
}

Point meanDrift_mps(const ScenarioWorld& scenario, const Iceberg& iceberg)
{
    if (!iceberg.length_m)
        return scenario.current_mps;
    return driftVelocity_mps(driftLaw(*iceberg.length_m),
                             {.wind_mps = scenario.wind_mps, .current_mps = scenario.current_mps},
                             scenario.origin.latitude_deg);
}

std::shared_ptr<const DriftForcing> forcingOf(const std::shared_ptr<const FlightWeather>& weather,
                                              const Iceberg& iceberg)
{
    const bool isConcerned =
        weather && (weather->givesCurrent() ||
                    (iceberg.length_m && (weather->givesWind() || weather->givesDepth())));
    return isConcerned ? std::make_shared<const WeatherForcing>(weather, iceberg) : nullptr;
}

} // namespace berg
