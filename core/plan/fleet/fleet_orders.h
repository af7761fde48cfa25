#pragma once

#include "core/plan/fleet/fleet_graph.h"
#include "core/plan/proof/number_table.h"

#include <span>
#include <vector>

namespace berg {

/**
 * The orders that may be part of a plan better than a known one: for each UAV and set of icebergs
 * the cheapest, found by dynamic programming over (set, last iceberg) along the paths of
 * `FleetGraph`.
 */
class FleetOrders
{
public:
    /** An order of one UAV. */
    struct Order
    {
        int uav = 0;
        NodeSet visited;
        double excess = 0; ///< length above the shortest one of its root
        int state = 0;     ///< state that `icebergsOf` starts from; 0, a root, for an empty order
    };

    FleetOrders(int uavs, int icebergs) : m_uavs(uavs), m_icebergs(icebergs) {}

    /**
     * Adds the orders in the graph whose excess is less than `slack`. The graph must have been
     * swept at the multipliers `lambda`. Returns false if there are more than `mostStates` states,
     * those of earlier calls included, or if stopped: some orders are then missing.
     */
    [[nodiscard]] bool add(const FleetGraph& graph, const Eigen::VectorXd& lambda, double slack,
                           std::size_t mostStates, const StopCheck& isStopped);

    [[nodiscard]] int uavs() const { return m_uavs; }
    [[nodiscard]] int icebergs() const { return m_icebergs; }
    [[nodiscard]] std::size_t stateCount() const { return m_states.size(); }
    /** Returns all orders added. */
    [[nodiscard]] std::span<const Order> all() const { return m_orders; }
    /** Returns the icebergs of an order of `all`, in visiting order. */
    [[nodiscard]] VisitOrder icebergsOf(const Order& order) const;

private:
    static constexpr int kNoState = -1; ///< saves memory: there are millions of states

    struct State
    {
        int node = 0;
        NodeIndex iceberg;
        NodeSet visited;
        double length = 0;     ///< length less the root's shortest one, own visit included
        int before = kNoState; ///< previous state; `kNoState` at a root
    };

    [[nodiscard]] bool addPaths(const FleetGraph& graph, int root, const Eigen::VectorXd& lambda,
                                double slack, std::size_t mostStates, const StopCheck& isStopped);
    /** Keeps the shortest state of each set and last iceberg. */
    void offer(const State& state, NumberTable& states);
    [[nodiscard]] bool addOrders(const FleetGraph& graph, int uav, std::size_t begin, double slack,
                                 const StopCheck& isStopped);

    int m_uavs;
    int m_icebergs;
    std::vector<State> m_states;
    std::vector<Order> m_orders;
};

} // namespace berg
