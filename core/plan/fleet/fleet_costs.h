#pragma once

#include "core/plan/fleet/fleet_problem.h"
#include "core/plan/solve/order_costs.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace berg {

/**
 * Costs of one UAV as if it were alone. Those between icebergs are shared with the UAVs that fly
 * the same distances there: a matrix for each of many UAVs would be most of the memory of a solve.
 */
class UavCosts
{
public:
    /** Keeps `shared`, whose own start and way back are not read. */
    UavCosts(std::shared_ptr<const VisitCosts> shared, const FleetProblem& problem, int uav);

    [[nodiscard]] int icebergs() const { return m_shared->icebergs; }
    [[nodiscard]] double leg(int from, int to) const
    {
        return to == 0 ? end(from) : legsFrom(from)[to];
    }
    /** Legs to each iceberg; [0] is not that to the end. */
    [[nodiscard]] const double* legsFrom(int from) const
    {
        return from == 0 ? m_start.data() : m_between + std::ptrdiff_t{from} * m_start.size();
    }
    /** The way back from there: 0 on open routes, and from the start. */
    [[nodiscard]] double end(int from) const { return m_end(from); }
    [[nodiscard]] double sigmaOf(int iceberg) const { return m_sigma[iceberg]; }
    [[nodiscard]] double visit(int iceberg, int position) const
    {
        return sigmaOf(iceberg) * (position + 1);
    }
    [[nodiscard]] double total(std::span<const int> order) const
    {
        return costOfVisits(*this, order);
    }
    [[nodiscard]] double latency(std::span<const int> order) const
    {
        return weightedLength(*this, order);
    }
    [[nodiscard]] const VisitCosts& shared() const { return *m_shared; }

private:
    std::shared_ptr<const VisitCosts> m_shared;
    const double* m_between; ///< its legs
    const double* m_sigma;   ///< its sigmas
    Eigen::VectorXd m_start; ///< N, legs from the start; [0] is 0
    Eigen::VectorXd m_end;   ///< N, return legs; 0 on open routes
};

/**
 * `FleetProblem` laid out for inner loops. The sum over the orders of a plan is `fleetObjective` +
 * `objectiveShift`, which is never negative.
 */
class FleetCosts
{
public:
    /** Keeps a reference to `problem`. */
    explicit FleetCosts(const FleetProblem& problem);

    /** Memory of the costs of a problem; finding out takes as long as `FleetCosts` itself. */
    [[nodiscard]] static std::int64_t bytesFor(const FleetProblem& problem);
    /** The same if no UAV shared anything. */
    [[nodiscard]] static std::int64_t mostBytesFor(const FleetProblem& problem);
    [[nodiscard]] std::int64_t bytes() const { return m_bytes; }

    [[nodiscard]] int uavs() const { return static_cast<int>(m_uavs.size()); }
    [[nodiscard]] int icebergs() const { return m_problem->icebergCount(); }
    [[nodiscard]] const UavCosts& of(int uav) const
    {
        return m_uavs[static_cast<std::size_t>(uav)];
    }
    /** Criterion latency: a leg counts as many times as there is sigma ahead of it in its order.
     * The legs are those of `of`, the rest of which is Eq. (1)'s. */
    [[nodiscard]] bool weighted() const { return m_problem->criterion == Criterion::Latency; }
    [[nodiscard]] bool isPlan(const FleetPlan& plan) const { return isFleetPlan(*m_problem, plan); }
    [[nodiscard]] bool allows(int uav, int iceberg) const
    {
        return m_problem->allows(uav, iceberg);
    }
    [[nodiscard]] double total(int uav, std::span<const int> order) const
    {
        return weighted() ? of(uav).latency(order) : of(uav).total(order);
    }
    [[nodiscard]] double total(const FleetPlan& plan) const
    {
        double sum = 0;
        for (int uav = 0; uav < uavs(); ++uav)
            sum += total(uav, plan[static_cast<std::size_t>(uav)]);
        return sum;
    }

    /**
     * UAVs between which only the start differs, in lists: they may visit the same icebergs, at the
     * same distances, on open routes.
     */
    [[nodiscard]] std::vector<std::vector<int>> alike() const;

private:
    [[nodiscard]] bool areAlike(int a, int b) const;

    const FleetProblem* m_problem;
    std::vector<UavCosts> m_uavs;
    std::int64_t m_bytes = 0;
};

/** What the plan saves when an iceberg is left out, one per node: about the price at which it is
 * worth while. */
[[nodiscard]] Eigen::VectorXd savings(const FleetCosts& costs, const FleetPlan& plan);

} // namespace berg
