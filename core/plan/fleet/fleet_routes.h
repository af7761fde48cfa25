#pragma once

#include "core/plan/fleet/fleet_costs.h"

#include <span>
#include <vector>

namespace berg {

/** Icebergs `begin` .. `end` - 1 (from 0) of the order of `uav`, flown backwards if so said. */
struct RoutePiece
{
    int uav = 0;
    int begin = 0;
    int end = 0;
    bool backwards = false;
};

/** A plan with sums along its orders, so that any order put together from pieces is valued in
 * O(pieces), asymmetric distances and distances by UAV included. */
class FleetRoutes
{
public:
    /** Keeps a reference to `costs`. */
    FleetRoutes(const FleetCosts& costs, FleetPlan plan);

    [[nodiscard]] const FleetPlan& plan() const { return m_plan; }
    [[nodiscard]] int length(int uav) const { return static_cast<int>(order(uav).size()); }
    /** Of the order of `uav`. */
    [[nodiscard]] double cost(int uav) const { return m_tables[at(uav)].cost; }
    /** Of `uav` flying the pieces one after the other; infinite when it may not visit one. */
    [[nodiscard]] double cost(int uav, std::span<const RoutePiece> pieces) const;
    [[nodiscard]] VisitOrder joined(std::span<const RoutePiece> pieces) const;
    void setOrder(int uav, VisitOrder order);

private:
    /** Sums up to each place of an order. */
    struct Table
    {
        double cost = 0;
        std::vector<double> sigma;
        std::vector<double> wait; ///< sigma times place, from 1
        /** By UAV: legs to the place before it within the order, there and back. */
        std::vector<std::vector<double>> forward;
        std::vector<std::vector<double>> back;
        /** For latency, by UAV: sums of sigma times these. */
        std::vector<std::vector<double>> forwardWait;
        std::vector<std::vector<double>> backWait;
        std::vector<std::vector<int>> barred; ///< by UAV: icebergs it may not visit
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
