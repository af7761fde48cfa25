#pragma once

#include "core/mission/mission.h"

#include <vector>

// The plans of a mission as a list with an entry for each UAV, in order of time.

namespace berg::test {

/** The plan of one UAV, with the members that tests compare. */
struct FlownPlan : UavPlan
{
    PlanPointer plan;
    double time_s = 0;
    bool interim = false;
    bool fellBack = false;
};

[[nodiscard]] inline std::vector<FlownPlan> flownPlans(const std::vector<PlanPointer>& plans)
{
    std::vector<FlownPlan> flown;
    for (const PlanPointer& plan : plans)
        for (const UavPlan& own : plan->uavs)
            flown.push_back({own, plan, plan->time_s, plan->interim, plan->fellBack});
    return flown;
}

[[nodiscard]] inline std::vector<FlownPlan> flownPlans(const Mission& mission)
{
    return flownPlans(mission.plans());
}

/** Replaces the plan by one in which the first UAV's part and the time are changed. */
template <class Change>
void changePlan(PlanPointer& plan, Change change, double later_s = 0)
{
    Plan changed = *plan;
    changed.time_s += later_s;
    change(changed.uavs.front());
    plan = std::make_shared<const Plan>(std::move(changed));
}

} // namespace berg::test
