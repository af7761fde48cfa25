#include "widgets/model/mission_snapshot.h"

#include "core/sim/clusters.h"
#include "core/sim/mission_instant.h"

#include <algorithm>
#include <iterator>

namespace berg {

namespace {

template <class Entry>
void join(std::vector<Entry>& known, std::size_t first, std::vector<Entry> news)
{
    known.resize(std::min(known.size(), first));
    std::move(news.begin(), news.end(), std::back_inserter(known));
}

MissionSnapshot worldOf(const Mission& mission, const Simulation& simulation)
{
    MissionSnapshot snapshot{.time_s = simulation.time_s(),
                             .world = simulation.state(),
                             .icebergs = mission.icebergs(),
                             .motion = simulation.motion(),
                             .asset = simulation.asset(),
                             .fence = simulation.fence()};
    // At an earlier instant some have not been added yet.
    snapshot.icebergs.resize(static_cast<std::size_t>(simulation.icebergCount()));
    for (int i = 0; i < simulation.icebergCount(); ++i) {
        snapshot.truth_m.push_back(simulation.truth_m(i));
        snapshot.active.push_back(simulation.active(i));
    }
    return snapshot;
}

void setPlan(MissionSnapshot& snapshot, const Mission& mission, std::size_t count)
{
    snapshot.planCount = count;
    if (count > 0)
        snapshot.plan = mission.plans()[count - 1];
}

std::vector<Intervention> worldChangesOf(const Mission& mission)
{
    std::vector<Intervention> changes;
    for (const Intervention& change : mission.interventions())
        if (change.wind_mps || change.asset || change.appears)
            changes.push_back({.time_s = change.time_s,
                               .wind_mps = change.wind_mps,
                               .asset = change.asset,
                               .appears = change.appears});
    return changes;
}

} // namespace

void append(MissionHistory& history, HistoryNews news)
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
            .airspeed_mps = snapshot.motion.airspeed_mps,
            .wind_mps = snapshot.motion.wind_mps};
}

std::vector<AimedWay> waysOf(const PlanEvent& plan, const DubinsState& uav, double time_s,
                             const Motion& motion)
{
    if (plan.legs.empty())
        return {};
    std::vector<AimedWay> ways = aimedWays(plan.legs, uav, time_s, motion);
    constexpr double kSlack_s = 1; // a leg that starts with the last sighting sees nothing new
    if (plan.outlook && !plan.outlook->sightings_s.empty())
        std::erase_if(ways, [last_s = plan.outlook->sightings_s.back()](const AimedWay& way) {
            return way.points.front().time_s > last_s - kSlack_s;
        });
    else // not judged yet
        ways.resize(std::min(ways.size(), plan.order.size()));
    return ways;
}

std::vector<AimedWay> waysAhead(const MissionSnapshot& snapshot)
{
    if (!snapshot.plan)
        return {};
    PlanEvent plan = *snapshot.plan;
    if (snapshot.world.aim && !plan.legs.empty())
        plan.legs.front() = *snapshot.world.aim; // what is left of its turn
    return waysOf(plan, snapshot.world.uav, snapshot.time_s, snapshot.motion);
}

MissionSnapshot snapshotOf(const Mission& mission)
{
    MissionSnapshot snapshot = worldOf(mission, mission.simulation());
    snapshot.planner = mission.plannerSettings();
    snapshot.metrics = mission.metrics();
    snapshot.request = mission.lastRequest();
    snapshot.worldChanges = worldChangesOf(mission);
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
    if (snapshot.plan) // as it was asked for: where the UAV was then, what was known then
        snapshot.request = std::make_shared<const PlanRequest>(requestFor(
            instantAt(mission, snapshot.plan->time_s).simulation, snapshot.planner.policy));
    return snapshot;
}

} // namespace berg
