#pragma once

#include "core/checks/weather_gate.h"
#include "core/plan/fleet/second_opinion.h"
#include "core/plan/policy/policy.h"
#include "core/scenario/scenario.h"

#include <optional>
#include <string>
#include <vector>

namespace berg {

/** Plan of one UAV. */
struct UavReport
{
    std::string id;
    std::vector<int> order;            ///< 1-based numbers, as printed
    std::vector<std::string> ids;      ///< iceberg ids in visiting order; empty for a bare problem
    double distance_m = 0;             ///< length of the order, through the air
    std::optional<int> thisSortie;     ///< visits of this sortie before the UAV must fly home;
                                       ///< nullopt if it makes all of them
    std::optional<double> slot_s = {}; ///< end of its recovery slot; nullopt if it needs no slot
};

/** Path whose length a plan gives as its distance. */
enum class LengthKind
{
    Order,  ///< straight legs through all icebergs in order, and back if the route is closed
    Round,  ///< the legs of the order and back to its first iceberg
    Flight, ///< legs with aim points beside the icebergs, until all of the order are seen
};

/** Plan from the start of a scenario, or of a problem without a scenario. */
struct PlanReport
{
    FleetProblem problem;  ///< empty if no problem was solved
    SolveOutcome outcome;  ///< outcome of the solve for all UAVs
    double distance_m = 0; ///< sum over the UAVs, each through the air
    LengthKind path = LengthKind::Order;
    std::vector<UavReport> uavs;
    std::vector<std::vector<std::string>> clusters = {}; ///< ids planned as one point
    std::optional<SecondOpinion> secondOpinion = {};
    /** Along the predicted flights (`plannedFlights`); nullopt if no UAV has a limit. */
    std::optional<WeatherVerdict> weather = {};
    std::vector<std::string> weatherUavs = {}; ///< ids of its UAVs
    std::string weatherLine = {};              ///< the same in words; empty without it

    /** Returns the value of Eq. (1) or of the latency; nullopt without a plan, or if no problem was
     * solved. */
    [[nodiscard]] std::optional<double> objective() const;
    /** Returns the relative gap between objective and bound; nullopt if either is missing. */
    [[nodiscard]] std::optional<double> gap() const;
    /** Returns the distance weight of the problem; nullopt if no problem was solved. */
    [[nodiscard]] std::optional<double> mu() const;
};

/**
 * Builds the report of a plan. `answer` must come from `planFromStart(scenario)`; throws
 * `std::logic_error` for another number of UAVs.
 */
[[nodiscard]] PlanReport planReport(const Scenario& scenario, const Plan& answer);

/**
 * Returns the report as one JSON document with a stable member order, as `--json` prints it. The
 * orders of several UAVs follow one another, and `uavs` lists each by itself.
 */
[[nodiscard]] std::string planJson(const PlanReport& report);

} // namespace berg
