#pragma once

#include "core/plan/fleet_problem.h"
#include "core/plan/order_costs.h"

#include <span>
#include <vector>

namespace berg {

/**
 * `FleetProblem` laid out for inner loops: costs of each UAV as if it were alone. The sum over the
 * orders of a plan is `fleetObjective` + `fleetObjectiveShift`, which is never negative.
 */
class FleetCosts
{
public:
    /** Keeps a reference to `problem`. */
    explicit FleetCosts(const FleetProblem& problem) : m_problem(&problem)
    {
        for (int uav = 0; uav < problem.uavCount(); ++uav)
            m_uavs.emplace_back(problemOfUav(problem, uav));
    }

    [[nodiscard]] int uavs() const { return static_cast<int>(m_uavs.size()); }
    [[nodiscard]] int icebergs() const { return m_problem->icebergCount(); }
    [[nodiscard]] const VisitCosts& of(int uav) const
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
    std::vector<VisitCosts> m_uavs;
};

/** What the plan saves when an iceberg is left out, one per node: about the price at which it is
 * worth while. */
[[nodiscard]] Eigen::VectorXd savings(const FleetCosts& costs, const FleetPlan& plan);

} // namespace berg
