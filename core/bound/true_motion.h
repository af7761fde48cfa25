#pragma once

#include "core/base/enclosing_circle.h"
#include "core/scenario/scenario.h"

#include <cstdint>
#include <stop_token>
#include <vector>

namespace berg {

/**
 * Where the icebergs of a scenario truly are, the drawn noise included, over blocks of whole time
 * steps: at most `kMostBlocks` of them, so that a run of a week costs no more memory than one of an
 * hour. Block b holds the steps edgeStep(b) + 1 ... edgeStep(b + 1).
 */
class TrueMotion
{
public:
    static constexpr std::int64_t kMostBlocks = 2000;

    /** Draws the motion once. A requested stop leaves it unusable: ask the token afterwards. */
    TrueMotion(const Scenario& scenario, const std::stop_token& stop);

    [[nodiscard]] int blocks() const { return static_cast<int>(m_edges.size()) - 1; }
    [[nodiscard]] std::int64_t edgeStep(int edge) const { return m_edges[at(edge)]; }
    [[nodiscard]] double edge_s(int edge) const
    {
        return static_cast<double>(m_edges[at(edge)]) * m_dt_s;
    }
    [[nodiscard]] Point position_m(int iceberg, int edge) const
    {
        return m_paths[at(iceberg)].position_m[at(edge)];
    }

    /**
     * Holds the iceberg at every instant between the two edges, in the frame that moves with
     * `velocity_mps` and is that of the map at the first of them.
     */
    [[nodiscard]] Circle enclosure(int iceberg, int fromEdge, int toEdge,
                                   const Point& velocity_mps) const;

private:
    /** One iceberg: at the edges, and how far off the chord between them it gets. */
    struct Path
    {
        std::vector<Point> position_m;
        std::vector<double> offChord_m;
    };
    [[nodiscard]] static std::size_t at(int i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] Path pathOf(const Scenario& scenario, const Iceberg& iceberg,
                              const std::stop_token& stop) const;

    double m_dt_s;
    std::vector<std::int64_t> m_edges;
    std::vector<Path> m_paths;
};

} // namespace berg
