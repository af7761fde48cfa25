#pragma once

#include "core/plan/fleet/fleet_graph.h"
#include "core/plan/solve/number_table.h"

#include <span>
#include <vector>

namespace berg {

/**
 * The orders that may be part of a plan better than a known one: of each UAV and set of icebergs
 * the cheapest, found by dynamic programming over (set, last iceberg) along the paths of
 * `FleetGraph`.
 */
class FleetOrders
{
public:
    struct Order
    {
        int uav = 0;
        NodeSet visited;
        double excess = 0; ///< length above the shortest of its root
        int state = -1;    ///< for `icebergsOf`
    };

    FleetOrders(int uavs, int icebergs) : m_uavs(uavs), m_icebergs(icebergs) {}

    /**
     * Adds those in the graph whose excess is less than `slack`. Sweep first. False when more than
     * `mostStates` would be needed or when cut: then some are missing.
     */
    [[nodiscard]] bool add(const FleetGraph& graph, const Eigen::VectorXd& lambda, double slack,
                           std::size_t mostStates, const CutQuestion& cut);

    [[nodiscard]] int uavs() const { return m_uavs; }
    [[nodiscard]] int icebergs() const { return m_icebergs; }
    [[nodiscard]] std::size_t stateCount() const { return m_states.size(); }
    [[nodiscard]] std::span<const Order> all() const { return m_orders; }
    [[nodiscard]] VisitOrder icebergsOf(const Order& order) const;

private:
    struct State
    {
        int node = 0;
        int iceberg = 0;
        NodeSet visited;
        double length = 0; ///< less the root's shortest, own visit included
        int before = -1;   ///< state before it
    };

    [[nodiscard]] bool addPaths(const FleetGraph& graph, int root, const Eigen::VectorXd& lambda,
                                double slack, std::size_t mostStates, const CutQuestion& cut);
    /** Keeps the shortest state of each set and last iceberg. */
    void offer(const State& state, NumberTable& states);
    [[nodiscard]] bool addOrders(const FleetGraph& graph, int uav, std::size_t begin, double slack,
                                 const CutQuestion& cut);

    int m_uavs;
    int m_icebergs;
    std::vector<State> m_states;
    std::vector<Order> m_orders;
};

} // namespace berg
