#pragma once

#include "core/plan/policy/policy.h"

#include <map>

namespace berg {

/**
 * The paper's strategy around a policy: stores the last orders, passes what is left of them to the
 * solver as warm start, and falls back to it when a limit leaves the solver without an order
 * (section 4 of the paper, its second advantage). So the autopilot always has a next iceberg. Not
 * thread-safe.
 */
class Planner
{
public:
    /**
     * Makes the policy of the settings with `maker`. A `solver` that is not null replaces the back
     * end of the settings (tests, fault injection). Throws `Error{Unsupported}` as `makePolicy` and
     * `makeSolver` do.
     */
    explicit Planner(const PlannerSettings& settings, std::unique_ptr<TvpSolver> solver = nullptr,
                     PolicyMaker maker = makePolicy);

    [[nodiscard]] const PlannerSettings& settings() const { return m_settings; }

    /**
     * Changes the settings in flight and makes a new policy, unless they are equal; the last orders
     * stay as warm start. A solver given to the constructor stays in use. Throws
     * `Error{Unsupported}` as `makePolicy` and `makeSolver` do; the settings are then unchanged.
     */
    void setSettings(const PlannerSettings& settings);

    /**
     * Returns the orders to fly now. All are empty only if no iceberg is available, or if the
     * request was cancelled; cancelled requests leave no trace. A policy that throws counts as one
     * that finds no order, and `failure` holds the reason. Among several UAVs some may have nothing
     * to fly; if none has an order, each falls back, and no two fly to the same iceberg. Without
     * `warmStart` the solver does not get the last orders (the fallback still uses them). Throws
     * `std::logic_error` inside a `NoBlockingScope`.
     */
    [[nodiscard]] Plan plan(const PlanRequest& request, const SolveOptions& options,
                            bool warmStart = true);

private:
    /**
     * Gives each UAV the rest of its last order, else the nearest iceberg that no other UAV flies
     * to. Returns false if there is nothing to fly to.
     */
    [[nodiscard]] bool fallBack(const PlanRequest& request, std::vector<UavPlan>& answers) const;

    PlannerSettings m_settings;
    PolicyMaker m_maker;
    bool m_hasGivenSolver = false;
    std::unique_ptr<TvpSolver> m_solver;
    std::unique_ptr<Policy> m_policy;
    std::map<int, IcebergList> m_lastOrders; ///< by `UavRequest::uav`
};

} // namespace berg
