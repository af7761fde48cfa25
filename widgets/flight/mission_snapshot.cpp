#include "widgets/flight/mission_snapshot.h"

#include "core/mission/mission_instant.h"
#include "core/mission/plan_requests.h"
#include "core/sim/clusters.h"
#include "widgets/words/object_names.h"

#include <algorithm>
#include <iterator>

namespace berg {

namespace {

template <class Record>
void join(std::vector<Record>& known, std::size_t first, std::vector<Record> news)
{
    known.resize(std::min(known.size(), first));
    std::move(news.begin(), news.end(), std::back_inserter(known));
}

std::vector<double> airspeedsOf(const std::vector<Motion>& motions)
{
    std::vector<double> airspeeds_mps;
    for (const Motion& motion : motions)
        airspeeds_mps.push_back(motion.airspeed_mps);
    return airspeeds_mps;
}

MissionSnapshot worldOf(const Mission& mission, const Simulation& simulation)
{
    MissionSnapshot snapshot{.time_s = simulation.time_s(),
                             .world = simulation.state(),
                             .icebergs = mission.icebergs(),
                             .asset = simulation.world().asset()};
    snapshot.wind = simulation.windAhead();
    snapshot.forcings = simulation.world().forcings();
    for (int uav = 0; uav < simulation.uavCount(); ++uav) {
        snapshot.motions.push_back(simulation.motion(uav));
        const Autopilot& autopilot = simulation.fleet().autopilot(uav);
        snapshot.homes_m.push_back(autopilot.home_m());
        snapshot.fences.push_back(autopilot.guard().uav().fence);
        snapshot.homeMargins_s.push_back(autopilot.homeMargin_s(simulation.observer()));
    }
    // At an earlier instant some icebergs have not been added yet.
    snapshot.icebergs.resize(static_cast<std::size_t>(simulation.icebergCount()));
    for (const IcebergIndex i : simulation.icebergs()) {
        snapshot.truth_m.push_back(simulation.truth_m(i));
        snapshot.active.push_back(simulation.active(i));
        const std::optional<int>& assigned = simulation.world().parameters(i).assignedUav;
        snapshot.assigned.push_back(areDistinguished(snapshot.world.uavs) ? assigned
                                                                          : std::nullopt);
    }
    return snapshot;
}

void setPlan(MissionSnapshot& snapshot, const Mission& mission, std::size_t count)
{
    snapshot.planCount = count;
    const std::span<const PlanPointer> made(mission.plans().data(), count);
    for (std::size_t uav = 0; uav < snapshot.world.uavs.size(); ++uav)
        snapshot.plans.push_back(lastPlanOf(made, static_cast<int>(uav)));
    if (count > 0)
        snapshot.plan = made.back();
}

std::vector<Intervention> worldChangesOf(const Mission& mission)
{
    std::vector<Intervention> changes;
    for (const Intervention& change : mission.interventions())
        if (change.wind_mps || change.asset || change.appears || change.removed || change.home)
            changes.push_back({.time_s = change.time_s,
                               .wind_mps = change.wind_mps,
                               .asset = change.asset,
                               .appears = change.appears,
                               .removed = change.removed,
                               .home = change.home});
    return changes;
}

} // namespace

void append(MissionHistory& history, HistoryUpdate news)
{
    if (news.firstSample < history.samples.size() || news.firstEvent < history.events.size())
        ++history.rewrites;
    join(history.samples, news.firstSample, std::move(news.part.samples));
    join(history.rows, news.firstSample, std::move(news.part.rows));
    join(history.plans, news.firstPlan, std::move(news.part.plans));
    join(history.events, news.firstEvent, std::move(news.part.events));
}

ForecastStart forecastStart(const MissionSnapshot& snapshot)
{
    return {.world = snapshot.world,
            .active = snapshot.active,
            .time_s = snapshot.time_s,
            .airspeeds_mps = airspeedsOf(snapshot.motions),
            .wind_mps = snapshot.wind,
            .forcings = snapshot.forcings};
}

const UavPlan* planOf(const MissionSnapshot& snapshot, int uav)
{
    const auto k = static_cast<std::size_t>(uav);
    return k < snapshot.plans.size() && snapshot.plans[k] ? snapshot.plans[k]->of(uav) : nullptr;
}

std::vector<std::string> sortieIcebergs(const MissionSnapshot& snapshot, int uav)
{
    std::vector<std::string> ids;
    const UavPlan* plan = planOf(snapshot, uav);
    if (plan == nullptr)
        return ids;
    const int all = static_cast<int>(plan->order.size());
    const int visits = std::clamp(plan->thisSortie.value_or(all), 0, all);
    for (int i = 0; i < visits; ++i)
        ids.push_back(snapshot.icebergs[toIndex(plan->order[toIndex(i)])].id);
    return ids;
}

OrdersByUav ordersOf(const MissionSnapshot& snapshot)
{
    OrdersByUav orders(snapshot.world.uavs.size());
    for (std::size_t uav = 0; uav < orders.size(); ++uav)
        if (const UavPlan* plan = planOf(snapshot, static_cast<int>(uav)))
            orders[uav] = plan->order;
    return orders;
}

std::vector<AimedPath> pathsOf(const UavPlan& plan, const DubinsState& uav, double time_s,
                               const Motion& motion)
{
    if (plan.legs.empty())
        return {};
    std::vector<AimedPath> paths = aimedPaths(plan.legs, uav, time_s, motion);
    constexpr double kSlack_s = 1; // a leg that starts at the last sighting sees no further iceberg
    if (plan.outlook && !plan.outlook->sightings_s.empty())
        std::erase_if(paths, [last_s = plan.outlook->sightings_s.back()](const AimedPath& path) {
            return path.points.front().time_s > last_s - kSlack_s;
        });
    else // without an outlook the plan has not been evaluated yet
        paths.resize(std::min(paths.size(), plan.order.size()));
    return paths;
}

std::vector<AimedPath> pathsAhead(const MissionSnapshot& snapshot, int uav)
{
    const UavPlan* inForce = planOf(snapshot, uav);
    if (inForce == nullptr)
        return {};
    UavPlan plan = *inForce;
    const auto k = static_cast<std::size_t>(uav);
    const UavState& state = snapshot.world.uavs[k];
    if (state.aim && !plan.legs.empty())
        plan.legs.front() = *state.aim; // the remaining part of its turn
    return pathsOf(plan, state.pose, snapshot.time_s, snapshot.motions[k]);
}

MissionSnapshot snapshotOf(const Mission& mission)
{
    MissionSnapshot snapshot = worldOf(mission, mission.simulation());
    snapshot.planner = mission.plannerSettings();
    snapshot.metrics = mission.metrics();
    snapshot.request = mission.lastRequest();
    snapshot.worldChanges = worldChangesOf(mission);
    snapshot.lastChange = lastChangeOf(mission.interventions());
    setPlan(snapshot, mission, mission.plans().size());
    return snapshot;
}

MissionSnapshot snapshotAt(const Mission& mission, double time_s)
{
    const MissionInstant instant = instantAt(mission, time_s);
    MissionSnapshot snapshot = worldOf(mission, instant.simulation);
    snapshot.planner = instant.planner;
    snapshot.metrics = instant.metrics;
    setPlan(snapshot, mission, instant.plans);
    if (snapshot.plan) // rebuilt from the state at the time of the plan
        snapshot.request = std::make_shared<const PlanRequest>(requestFor(
            instantAt(mission, snapshot.plan->time_s).simulation, snapshot.planner.policy));
    return snapshot;
}

} // namespace berg
