#pragma once

#include "core/checks/weather_gate.h"
#include "core/plan/fleet/second_opinion.h"
#include "core/plan/policy/policy.h"
#include "core/scenario/scenario.h"

#include <optional>
#include <string>
#include <vector>

namespace berg {

/** Path whose length a plan gives as its distance. */
enum class LengthKind
{
    Order,  ///< straight legs through all icebergs in order, and back if the route is closed
    Round,  ///< the legs of the order and back to its first iceberg
    Flight, ///< legs with aim points beside the icebergs, until all of the order are seen
};

/** Results for a UAV that its part of the plan does not hold. */
struct UavLength
{
    double distance_m = 0;             ///< length of the order, through the air
    std::optional<double> slot_s = {}; ///< end of its recovery slot; nullopt if it needs no slot
};

/** Plan from the start of a scenario, or of a problem without a scenario. */
struct PlanReport
{
    Plan plan; ///< its `problem` is empty if no problem was solved
    /** Scenario with the ids; it must outlive the report. Null for a problem without one. */
    const Scenario* scenario = nullptr;
    double distance_m = 0; ///< sum over the UAVs, each through the air
    LengthKind path = LengthKind::Order;
    std::vector<UavLength> lengths = {}; ///< of each of `plan.uavs`; empty without a scenario
    int firstNumber = 1;                 ///< printed number of the first iceberg
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
    /** Returns the icebergs planned as one point, all UAVs, in ascending order. */
    [[nodiscard]] std::vector<IcebergList> clusters() const;
    /** Returns the numbers of icebergs as they are printed. */
    [[nodiscard]] std::vector<int> numbersOf(const IcebergList& icebergs) const;
    /** Returns the ids of icebergs; empty without a scenario. */
    [[nodiscard]] std::vector<std::string> idsOf(const IcebergList& icebergs) const;
    /** Returns the id of the UAV of `plan.uavs[k]`; empty without a scenario. */
    [[nodiscard]] std::string uavId(std::size_t k) const;
};

/**
 * Builds the report of a plan. `plan` must come from `planFromStart(scenario)`; throws
 * `std::logic_error` for another number of UAVs.
 */
[[nodiscard]] PlanReport planReport(const Scenario& scenario, Plan plan);

/**
 * Returns the report as one JSON document with a stable member order, as `--json` prints it. The
 * orders of several UAVs follow one another, and `uavs` lists each by itself.
 */
[[nodiscard]] std::string planJson(const PlanReport& report);

} // namespace berg
