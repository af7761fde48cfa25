#pragma once

#include "core/geometry/enclosing_circle.h"
#include "core/scenario/flight_weather.h"

#include <cstdint>
#include <stop_token>
#include <vector>

namespace berg {

/**
 * The true positions of the icebergs of a scenario, drawn noise included, over blocks of whole time
 * steps. There are at most `kMostBlocks` blocks, so a run of a week needs no more memory than one
 * of an hour. Block b holds the steps edgeStep(b) + 1 ... edgeStep(b + 1).
 */
class TrueMotion
{
public:
    static constexpr std::int64_t kMostBlocks = 2000;

    /**
     * Draws the motion once and copies what it needs. A requested stop leaves the object unusable,
     * so callers check the token afterwards.
     */
    TrueMotion(const Scenario& scenario, const std::stop_token& stop);

    /** Returns the number of blocks; the edges are 0 to `blocks()`. */
    [[nodiscard]] int blocks() const { return static_cast<int>(m_edges.size()) - 1; }
    /** Returns the time step at an edge. */
    [[nodiscard]] std::int64_t edgeStep(int edge) const { return m_edges[at(edge)]; }
    /** Returns the time of an edge since the start of the run. */
    [[nodiscard]] double edge_s(int edge) const
    {
        return static_cast<double>(m_edges[at(edge)]) * m_dt_s;
    }
    /**
     * Returns the true position of an iceberg at an edge. `iceberg` is an index in the scenario.
     */
    [[nodiscard]] Point position_m(int iceberg, int edge) const
    {
        return m_paths[at(iceberg)].position_m[at(edge)];
    }

    /**
     * Returns a circle that holds the iceberg at every instant between the two edges, `fromEdge` <=
     * `toEdge`, in the frame that moves with `velocity_mps` and agrees with the map at the first
     * edge.
     */
    [[nodiscard]] Circle enclosure(int iceberg, int fromEdge, int toEdge,
                                   const Point& velocity_mps) const;

private:
    /** Positions of one iceberg at the edges, and its largest distance from the chord between. */
    struct Path
    {
        std::vector<Point> position_m;
        std::vector<double> offChord_m;
    };
    [[nodiscard]] static std::size_t at(int i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] Path pathOf(const Scenario& scenario,
                              const std::shared_ptr<const FlightWeather>& weather,
                              const Iceberg& iceberg, const std::stop_token& stop) const;

    double m_dt_s;
    std::vector<std::int64_t> m_edges;
    std::vector<Path> m_paths;
};

} // namespace berg
