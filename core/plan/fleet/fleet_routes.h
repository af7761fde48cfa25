#pragma once

#include "core/plan/fleet/fleet_costs.h"

#include <span>
#include <vector>

namespace berg {

/**
 * Icebergs at positions `begin` .. `end` - 1 (from 0) of the order of `uav`, in reverse if
 * `backwards`.
 */
struct RoutePiece
{
    int uav = 0;
    int begin = 0;
    int end = 0;
    bool backwards = false;
};

/**
 * A plan with sums along its orders, so that the cost of any order joined from pieces is computed
 * in O(pieces), also with asymmetric distances and distances that differ between UAVs.
 */
class FleetRoutes
{
public:
    /** `plan` must hold one order for each UAV. `costs` must outlive the routes. */
    FleetRoutes(const FleetCosts& costs, FleetPlan plan);

    [[nodiscard]] const FleetPlan& plan() const { return m_plan; }
    [[nodiscard]] int length(int uav) const { return static_cast<int>(order(uav).size()); }
    /** Returns the cost of the order of `uav`. */
    [[nodiscard]] double cost(int uav) const { return m_tables[at(uav)].cost; }
    /**
     * Returns the cost of `uav` flying the pieces one after the other; infinity if it may not visit
     * one of their icebergs.
     */
    [[nodiscard]] double cost(int uav, std::span<const RoutePiece> pieces) const;
    /** Returns the order that the pieces form. */
    [[nodiscard]] VisitOrder joined(std::span<const RoutePiece> pieces) const;
    /** Replaces the order of `uav` and its sums. */
    void setOrder(int uav, VisitOrder order);

private:
    /** Sums up to each position of an order. */
    struct Table
    {
        double cost = 0;
        std::vector<double> sigma;
        std::vector<double> wait; ///< sigma times position, counted from 1
        /** By UAV: legs within the order up to each position, forwards and backwards. */
        std::vector<std::vector<double>> forward;
        std::vector<std::vector<double>> back;
        /** For latency, by UAV: sums of sigma times these lengths. */
        std::vector<std::vector<double>> forwardWait;
        std::vector<std::vector<double>> backWait;
        std::vector<std::vector<int>> barred; ///< by UAV: number of icebergs it may not visit
    };

    [[nodiscard]] static std::size_t at(int k) { return static_cast<std::size_t>(k); }
    [[nodiscard]] static std::vector<std::vector<double>>
    waits(const Table& table, const std::vector<std::vector<double>>& legs);
    [[nodiscard]] double latency(int uav, std::span<const RoutePiece> pieces) const;
    [[nodiscard]] const VisitOrder& order(int uav) const { return m_plan[at(uav)]; }

    const FleetCosts* m_costs;
    FleetPlan m_plan;
    std::vector<Table> m_tables;
};

} // namespace berg
