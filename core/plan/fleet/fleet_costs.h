#pragma once

#include "core/plan/fleet/fleet_problem.h"
#include "core/plan/problem/order_costs.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace berg {

/**
 * Costs of one UAV as if it were alone. UAVs that fly the same distances between icebergs share
 * those costs: a matrix for each of many UAVs would be most of the memory of a solve.
 */
class UavCosts
{
public:
    /** Keeps `shared`, whose legs from and to the start are not read. */
    UavCosts(std::shared_ptr<const VisitCosts> shared, const FleetProblem& problem, int uav);

    [[nodiscard]] int icebergs() const { return m_shared->icebergs; }
    /** Returns the cost of a leg; `from` 0 is the start, `to` 0 the end of the route. */
    [[nodiscard]] double leg(NodeIndex from, NodeIndex to) const
    {
        return to == 0 ? end(from) : legsFrom(from)[to.number()];
    }
    /** Returns the legs to each iceberg; [0] is not the leg to the end. */
    [[nodiscard]] const double* legsFrom(NodeIndex from) const
    {
        return from == 0 ? m_start.data()
                         : m_between + std::ptrdiff_t{from.number()} * m_start.size();
    }
    /** Returns the cost of the return leg from `from`; 0 on open routes and from the start. */
    [[nodiscard]] double end(NodeIndex from) const { return m_end(from.number()); }
    [[nodiscard]] double sigmaOf(NodeIndex iceberg) const { return m_sigma[iceberg.number()]; }
    /** Returns the cost of visiting an iceberg at a position, counted from 1. */
    [[nodiscard]] double visit(NodeIndex iceberg, int position) const
    {
        return sigmaOf(iceberg) * (position + 1);
    }
    /** Returns the cost of an order by Eq. (1), plus the shift. */
    [[nodiscard]] double total(std::span<const NodeIndex> order) const
    {
        return costOfVisits(*this, order);
    }
    /** Returns the cost of an order by latency. */
    [[nodiscard]] double latency(std::span<const NodeIndex> order) const
    {
        return weightedLength(*this, order);
    }
    /** Returns the costs that may be shared with other UAVs. */
    [[nodiscard]] const VisitCosts& shared() const { return *m_shared; }

private:
    std::shared_ptr<const VisitCosts> m_shared;
    const double* m_between; ///< legs of `m_shared`
    const double* m_sigma;   ///< sigmas of `m_shared`
    Eigen::VectorXd m_start; ///< N, legs from the start; [0] is 0
    Eigen::VectorXd m_end;   ///< N, return legs; 0 on open routes
};

/**
 * `FleetProblem` in a layout for inner loops. The sum over the orders of a plan is `fleetObjective`
 * + `objectiveShift`, which is never negative.
 */
class FleetCosts
{
public:
    /** Keeps a reference to `problem`, which must outlive the costs. */
    explicit FleetCosts(const FleetProblem& problem);

    /**
     * Returns the memory, bytes, of the costs of a problem; takes as long as `FleetCosts` itself.
     */
    [[nodiscard]] static std::int64_t bytesFor(const FleetProblem& problem);
    /** Returns an upper bound of `bytesFor`: the memory if no UAVs share costs. It is quick. */
    [[nodiscard]] static std::int64_t mostBytesFor(const FleetProblem& problem);
    [[nodiscard]] std::int64_t bytes() const { return m_bytes; }

    [[nodiscard]] int uavs() const { return static_cast<int>(m_uavs.size()); }
    [[nodiscard]] int icebergs() const { return m_problem->icebergCount(); }
    /** Returns the costs of one UAV. */
    [[nodiscard]] const UavCosts& of(int uav) const
    {
        return m_uavs[static_cast<std::size_t>(uav)];
    }
    /**
     * Returns whether the criterion is latency: a leg is then multiplied by the sigma not yet
     * visited in its order. The legs are those of `of`, whose other members apply to Eq. (1).
     */
    [[nodiscard]] bool weighted() const { return m_problem->criterion == Criterion::Latency; }
    [[nodiscard]] bool isPlan(const FleetPlan& plan) const { return isFleetPlan(*m_problem, plan); }
    [[nodiscard]] bool allows(int uav, NodeIndex iceberg) const
    {
        return m_problem->allows(uav, iceberg);
    }
    /** Returns the cost of an order of one UAV by the criterion of the problem. */
    [[nodiscard]] double total(int uav, std::span<const NodeIndex> order) const
    {
        return weighted() ? of(uav).latency(order) : of(uav).total(order);
    }
    /** Returns the cost of a plan: `fleetObjective` + `objectiveShift`, up to rounding. */
    [[nodiscard]] double total(const FleetPlan& plan) const
    {
        double sum = 0;
        for (int uav = 0; uav < uavs(); ++uav)
            sum += total(uav, plan[static_cast<std::size_t>(uav)]);
        return sum;
    }

    /**
     * Returns groups of UAVs that differ only in their start: they may visit the same icebergs, at
     * the same distances, on open routes.
     */
    [[nodiscard]] std::vector<std::vector<int>> alike() const;

private:
    [[nodiscard]] bool areAlike(int a, int b) const;

    const FleetProblem* m_problem;
    std::vector<UavCosts> m_uavs;
    std::int64_t m_bytes = 0;
};

/**
 * Returns, by node, the saving if an iceberg is left out of the plan: about the multiplier at which
 * its visit pays. It is negative if the order without the iceberg costs more, but at least minus
 * the cost of the order; [0] is 0.
 */
[[nodiscard]] Eigen::VectorXd savings(const FleetCosts& costs, const FleetPlan& plan);

} // namespace berg
