#pragma once

#include "core/scenario/scenario.h"
#include "core/tracking/wind_drift.h"
#include "core/vehicle/wind_series.h"

#include <memory>
#include <optional>
#include <vector>

namespace berg {

/** Weather of a flight at one time as the forecast gives it; nullopt where it does not. */
struct ForecastWeather
{
    std::optional<Point> wind_mps;
    std::optional<double> gust_mps;
    std::optional<Point> current_mps;
};

/** Returns the place whose weather is that of the flight: the middle of the UAVs' starts. */
[[nodiscard]] Point flightPlace_m(const ScenarioWorld& scenario);

/**
 * Returns the forecast of a scenario, or null if it has none that can be used: it needs a complete
 * grid, the start of the run and a finite duration.
 */
[[nodiscard]] const ForecastField* usableForecast(const ScenarioWorld& scenario);

/**
 * Wind, gusts and current of a run whose scenario has a forecast. Where and when the forecast does
 * not give a quantity (outside its series, in a gap, in a place without it), the scenario's
 * constant one applies. Directions east and north are those of the scenario's plane.
 *
 * UAVs fly in one wind, that at the middle of their starts; it is constant for `kWindStep_s` at a
 * time, with the value of the middle of that time. Icebergs are in the wind and current of their
 * own places (`DriftForcing`). A wind that the crew reports in flight concerns the UAVs alone, so
 * the drift of a scenario is the same in all of its flights. Immutable.
 */
class FlightWeather
{
public:
    /** Time for which the wind of the flight is constant. */
    static constexpr double kWindStep_s = 30;

    /** Requires a `usableForecast`. */
    explicit FlightWeather(const ScenarioWorld& scenario);

    /** Returns the wind of the flight from the start to the end of the run; never null. */
    [[nodiscard]] const std::shared_ptr<const WindSeries>& wind() const { return m_wind; }
    /** Returns the strongest wind of the flight in the whole run, m/s. */
    [[nodiscard]] double strongestWind_mps() const { return m_strongest_mps; }
    /** Returns the gusts of the flight at a run time, or nullopt if they are unknown. */
    [[nodiscard]] std::optional<double> gust_mps(double time_s) const;
    /** Returns the forecast at the place of the flight, without the scenario's constants. */
    [[nodiscard]] ForecastWeather forecastAt(double time_s) const;

    /** Returns wind and current at a place of the plane and a run time. */
    [[nodiscard]] Forcing forcingAt(const Point& place_m, double time_s) const;
    /** Returns the current of `forcingAt`. */
    [[nodiscard]] Point currentAt_mps(const Point& place_m, double time_s) const;
    /** Returns the depth of the sea at a place, or nullopt where the forecast does not give it. */
    [[nodiscard]] std::optional<double> depth_m(const Point& place_m) const;
    /** Returns the largest speeds of wind and current anywhere, those of the scenario included. */
    [[nodiscard]] const Forcing& fastest() const { return m_fastest; }

    [[nodiscard]] bool givesWind() const { return m_givesWind; }
    [[nodiscard]] bool givesGust() const { return m_givesGust; }
    [[nodiscard]] bool givesCurrent() const { return m_givesCurrent; }
    [[nodiscard]] bool givesDepth() const { return m_givesDepth; }
    /** Returns the latitude of the origin, whose sign decides to which side the wind turns ice. */
    [[nodiscard]] double latitude_deg() const { return m_frame.origin().latitude_deg; }

private:
    /** Values of one quantity at one place, by run time. */
    template <class Value>
    struct Values
    {
        std::vector<double> time_s;
        std::vector<Value> value;
    };
    /** The forecast of one place. */
    struct Place
    {
        Values<Point> wind;
        Values<Point> current;
        Values<double> gust;
        std::optional<double> depth_m;
    };
    /** A position in the grid: two neighbours along each axis, and the share of the second. */
    struct Cell
    {
        std::size_t south = 0;
        std::size_t north = 0;
        double northShare = 0;
        std::size_t west = 0;
        std::size_t east = 0;
        double eastShare = 0;
    };

    /** Latitudes, and degrees east of the middle, of points of the plane on and around the grid. */
    struct Lattice
    {
        Point low_m = Point::Zero();
        double step_m = 0;
        std::vector<Point> nodes_deg; ///< `kLatticeNodes` rows of as many; empty if not used
    };

    template <class Value>
    [[nodiscard]] static std::optional<Value> at(const Values<Value>& values, double time_s);
    template <class Value, class ValueOf>
    [[nodiscard]] std::optional<Value> between(const Cell& cell, const ValueOf& valueOf) const;
    [[nodiscard]] Cell cellOf(const Point& place_m) const;
    [[nodiscard]] Point degreesOf(const Point& place_m) const;
    [[nodiscard]] Point exactDegreesOf(const Point& place_m) const;
    [[nodiscard]] double eastOfMiddle_deg(double longitude_deg) const;
    void addPlaces(const ForecastField& field, ForecastTime start);
    void addLattice(const ForecastField& field);
    void addWind(const ScenarioWorld& scenario);

    LocalFrame m_frame;
    Point m_wind_mps;    ///< where the forecast gives none
    Point m_current_mps; ///< where the forecast gives none
    std::optional<double> m_gust_mps;
    std::vector<Place> m_places;
    std::vector<double> m_latitudes_deg; ///< by row
    std::vector<double> m_easts_deg;     ///< by column: degrees east of `m_middle_deg`
    double m_middle_deg = 0;
    Lattice m_lattice;
    bool m_givesWind = false;
    bool m_givesGust = false;
    bool m_givesCurrent = false;
    bool m_givesDepth = false;
    Forcing m_fastest; ///< speeds, as vectors to the east
    Cell m_flight;     ///< place of the flight
    std::shared_ptr<const WindSeries> m_wind;
    double m_strongest_mps = 0;
};

/** Returns the weather of a run, or null if the scenario has no forecast that can be used. */
[[nodiscard]] std::shared_ptr<const FlightWeather> weatherOf(const ScenarioWorld& scenario);

/** Returns the wind of the flight at the start of the run. */
[[nodiscard]] Point windAtStart_mps(const ScenarioWorld& scenario);
/** Returns the wind of the flight from the start of the run on. */
[[nodiscard]] WindAhead windFromStart(const ScenarioWorld& scenario);

/**
 * Returns the constant mean velocity of an iceberg, which its own velocity comes on top of: the
 * scenario's current, or with a length what wind and current make of it (`driftLaw`).
 */
[[nodiscard]] Point meanDrift_mps(const ScenarioWorld& scenario, const Iceberg& iceberg);

/**
 * Returns the changing mean velocity of an iceberg in this weather; null if `weather` is null or
 * does not concern the iceberg. An iceberg with a length is aground where the forecast gives a
 * depth that its draft (`dimensionsOfLength`) exceeds.
 */
[[nodiscard]] std::shared_ptr<const DriftForcing>
forcingOf(const std::shared_ptr<const FlightWeather>& weather, const Iceberg& iceberg);

} // namespace berg
