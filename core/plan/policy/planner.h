#pragma once

#include "core/plan/policy/policy.h"

#include <map>

namespace berg {

/**
 * The paper's strategy around a policy: remembers the last orders, gives their rests as warm start,
 * and falls back to that rest when a limit leaves the solver without an order (section 4 of the
 * paper, its second advantage). The autopilot therefore always has a next iceberg.
 */
class Planner
{
public:
    /**
     * `solver` replaces the back end of the settings when given (tests, fault injection);
     * `maker` makes the policy.
     */
    explicit Planner(const PlannerSettings& settings, std::unique_ptr<TvpSolver> solver = nullptr,
                     PolicyMaker maker = makePolicy);

    [[nodiscard]] const PlannerSettings& settings() const { return m_settings; }

    /** Changes tau, policy or back end in flight; the last order stays as warm start. */
    void setSettings(const PlannerSettings& settings);

    /**
     * The orders to fly now; all are empty only when no iceberg is available, or when cancelled. A
     * policy that throws is as one that finds no order, with `failure` saying why. Of several UAVs
     * some may have nothing to fly; when none has, each falls back, and no two fly to one iceberg.
     * `warmStart` off keeps the last order from the solver (the fall-back still uses it).
     */
    [[nodiscard]] PlanAnswer plan(const PlanRequest& request, const SolveOptions& options,
                                  bool warmStart = true);

private:
    /** Each UAV flies the rest of its last order, else to the nearest that no other one flies to.
     * False when there is nothing to fly to. */
    [[nodiscard]] bool fallBack(const PlanRequest& request, std::vector<UavAnswer>& answers) const;

    PlannerSettings m_settings;
    PolicyMaker m_maker;
    bool m_ownSolver = false;
    std::unique_ptr<TvpSolver> m_solver;
    std::unique_ptr<Policy> m_policy;
    std::map<int, std::vector<int>> m_lastOrders; ///< by number of the UAV
};

} // namespace berg
