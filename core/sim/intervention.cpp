#include "core/sim/intervention.h"

namespace berg {

PlannerSettings withChanges(PlannerSettings settings, const Intervention& intervention)
{
    settings.tau = intervention.tau.value_or(settings.tau);
    settings.policy = intervention.policy.value_or(settings.policy);
    return settings;
}

void apply(const Intervention& intervention, Simulation& world,
           const std::vector<Iceberg>& icebergs, const std::vector<Uav>& uavs)
{
    if (intervention.policy)
        world.setPolicy(*intervention.policy);
    if (intervention.tau || intervention.policy)
        world.requestPlan();
    if (intervention.wind_mps)
        world.setWind(*intervention.wind_mps);
    if (intervention.asset)
        world.setAsset(*intervention.asset);
    if (intervention.appears)
        world.addIceberg(*intervention.appears);
    if (intervention.seen)
        world.reportSighting(indexOfId(icebergs, *intervention.seen), intervention.seenAge_s);
    if (intervention.removed)
        world.removeIceberg(indexOfId(icebergs, *intervention.removed));
    if (intervention.assigned)
        world.assign(indexOfId(icebergs, intervention.assigned->iceberg),
                     indexOfId(uavs, intervention.assigned->uav));
    if (intervention.commanded)
        world.order(indexOfId(uavs, intervention.commanded->uav), intervention.commanded->order);
}

} // namespace berg
