#pragma once

#include "core/plan/fleet/second_opinion.h"
#include "core/plan/policy/policy.h"
#include "core/scenario/scenario.h"

#include <optional>
#include <string>
#include <vector>

namespace berg {

/** The plan of one UAV. */
struct UavReport
{
    std::string id;
    std::vector<int> order;            ///< as printed: 1-based
    std::vector<std::string> ids;      ///< iceberg ids in visiting order; empty for a bare problem
    double distance_m = 0;             ///< of the order; in wind through the air
    std::optional<int> thisSortie;     ///< visits before home must be reached; none: all
    std::optional<double> slot_s = {}; ///< end of its recovery slot; nullopt if it needs no slot
};

/** A plan from a scenario's start, or of a bare problem. */
struct PlanReport
{
    FleetProblem problem;  ///< empty when none was solved
    SolveOutcome outcome;  ///< of the solve for all of them
    double distance_m = 0; ///< of all UAVs, each through its own air
    std::vector<UavReport> uavs;
    std::vector<std::vector<std::string>> clusters = {}; ///< ids that are planned as one point each
    std::optional<SecondOpinion> secondOpinion = {};

    /** What Eq. (1) or latency says of it; none without a plan, or when no problem was solved. */
    [[nodiscard]] std::optional<double> objective() const;
    [[nodiscard]] std::optional<double> gap() const; ///< relative
    [[nodiscard]] std::optional<double> mu() const;  ///< none when no problem was solved
};

/** `answer` is that of `planFromStart(scenario)`. */
[[nodiscard]] PlanReport planReport(const Scenario& scenario, const PlanAnswer& answer);

/** What `--json` prints: one document, stable member order; the orders one after the other and, of
 * several UAVs, `uavs` with each by itself. */
[[nodiscard]] std::string planJson(const PlanReport& report);

} // namespace berg
