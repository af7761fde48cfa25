#pragma once

#include "core/scenario/scenario.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace berg {

/** Wind and current towards east and north; nullopt where the forecast does not give them. */
struct MapWeatherValues
{
    std::optional<Point> wind_mps;
    std::optional<Point> current_mps;
};

/** Wind and current of a forecast at one time, by place. Immutable. */
class MapWeather
{
public:
    /** Requires a complete grid (`isGrid`). Cost: linear in its places. */
    MapWeather(const ForecastField& field, ForecastTime time, const LatLon& origin);

    /**
     * Returns the values at a place of the plane, bilinear as in `entryAt`; beyond the grid those
     * of its edge. Cost: logarithmic in the grid.
     */
    [[nodiscard]] MapWeatherValues at(const Point& place_m) const;
    /** Returns whether barbs at the origin are those of the southern hemisphere. */
    [[nodiscard]] bool isSouthern() const { return m_frame.origin().latitude_deg < 0; }
    /** Returns whether any place has a current. */
    [[nodiscard]] bool givesCurrent() const { return m_givesCurrent; }
    [[nodiscard]] bool givesWind() const { return m_givesWind; }

private:
    [[nodiscard]] double eastOfMiddle_deg(double longitude_deg) const;

    LocalFrame m_frame;
    double m_middle_deg = 0;         ///< longitude of the grid's middle
    std::vector<double> m_rows_deg;  ///< latitudes, rising
    std::vector<double> m_easts_deg; ///< columns, degrees east of the middle, rising
    std::vector<MapWeatherValues> m_values;
    bool m_givesWind = false;
    bool m_givesCurrent = false;
};

/** Shared by pictures; null if there is no forecast. */
using MapWeatherPointer = std::shared_ptr<const MapWeather>;

/** Returns the forecast of a scenario at a run time; null without a usable one. */
[[nodiscard]] MapWeatherPointer mapWeatherAt(const Scenario& scenario, double time_s);

/** Keeps the forecast of the minute shown, so that pictures of a flight share it. GUI thread. */
class MapWeatherCache
{
public:
    /** Returns the forecast at the begin of the minute of a time; `world` identifies the scenario.
     */
    [[nodiscard]] MapWeatherPointer at(const Scenario& scenario, std::uint64_t world,
                                       double time_s);

private:
    MapWeatherPointer m_weather;
    std::uint64_t m_world = 0;
    double m_minute = -1;
};

} // namespace berg
