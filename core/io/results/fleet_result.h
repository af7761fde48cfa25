#pragma once

#include "core/plan/policy/policy.h"
#include "core/scenario/scenario.h"

#include <optional>
#include <string>
#include <vector>

namespace berg {

/** The plan of one UAV of several. */
struct UavReport
{
    std::string id;
    std::vector<int> order;        ///< as printed: 1-based
    std::vector<std::string> ids;  ///< iceberg ids in visiting order
    double distance_m = 0;         ///< of the order; in wind through the air
    std::optional<int> thisSortie; ///< visits before home must be reached; none: all
};

/** The plan of several UAVs from a scenario's start. */
struct FleetReport
{
    SolveOutcome outcome;            ///< of the solve for all of them; it holds no order
    std::optional<double> objective; ///< none without a plan, and of the policy coverage
    std::optional<double> gap;       ///< relative
    std::optional<double> mu;        ///< weight of distance, of the policy visitation
    std::vector<UavReport> uavs;

    [[nodiscard]] double distance_m() const;
};

/** `answer` is that of `planFromStart(scenario)`, which has several UAVs. */
[[nodiscard]] FleetReport fleetReport(const Scenario& scenario, const PlanAnswer& answer);

/** What `solveJson` prints, the orders one after the other, and `uavs` with each by itself. */
[[nodiscard]] std::string fleetJson(const FleetReport& report);

} // namespace berg
