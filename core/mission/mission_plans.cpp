// The part of `Mission` that requests plans from the planner and puts them into force.

#include "core/mission/mission.h"
#include "core/mission/plan_requests.h"
#include "core/sim/clusters.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace berg {

namespace {

/** Avoids building a list, because it is called at every step. */
bool nobodyIsPlanned(const Fleet& fleet)
{
    for (int uav = 0; uav < fleet.count(); ++uav)
        if (fleet.autopilot(uav).isPlanned())
            return false;
    return true;
}

/** Returns the problem without its matrices, which would fill the memory in long missions. */
FleetProblem withoutNumbers(const FleetProblem& problem)
{
    return {.distance_m = {}, .sigma_m2 = {}, .mu = problem.mu, .criterion = problem.criterion};
}

/** Returns the clusters, reduced to the members that the UAV can still visit as one point. */
std::vector<IcebergList> stillClusters(std::vector<IcebergList> clusters, int uav,
                                       const Simulation& simulation)
{
    for (IcebergList& members : clusters)
        std::erase_if(members,
                      [&](IcebergIndex i) { return !simulation.fleet().clusterable(uav, i); });
    std::erase_if(clusters, [](const IcebergList& members) { return members.size() < 2; });
    return clusters;
}

} // namespace

/** Puts a pending plan into force and requests one where needed. Returns false if cancelled. */
bool Mission::planWhenDue(const std::stop_token& stop)
{
    if (nobodyIsPlanned(m_simulation.fleet())) { // the next flight is planned at take-off
        m_pending.reset();
        m_missed = PlanReason::None;
        return true;
    }
    if (m_pending && m_simulation.step() >= m_pending->step) {
        const bool isTimely = putPendingInForce();
        if (std::exchange(m_missed, PlanReason::None) != PlanReason::None || !isTimely)
            m_simulation.requestPlan();
    }
    if (m_simulation.planReason() == PlanReason::None)
        return true;
    if (!m_pending)
        return planNow(stop);
    m_missed = m_simulation.planReason();
    flyOn();
    return true;
}

bool Mission::putPendingInForce()
{
    Plan plan = std::exchange(m_pending, std::nullopt)->plan;
    const auto isLeft = [this](const UavPlan& own) {
        return !m_simulation.fleet().autopilot(own.uav).isPlanned();
    };
    plan.isCounted = !isLeft(plan.uavs.front());
    std::erase_if(plan.uavs, isLeft);
    plan.time_s = m_simulation.time_s();
    bool isTimely = true;
    for (UavPlan& own : plan.uavs) {
        // Targets that have come into view since are dropped.
        const std::optional<IcebergIndex> target = own.target();
        std::erase_if(own.order,
                      [&](IcebergIndex i) { return !m_simulation.available(own.uav, i); });
        own.clusters = stillClusters(std::move(own.clusters), own.uav, m_simulation);
        if (own.target() == target)
            continue;
        isTimely = false;
        own.legs.clear();
    }
    putInForce(std::move(plan));
    return isTimely;
}

bool Mission::planNow(const std::stop_token& stop)
{
    SolveOptions options;
    options.timeLimit_s = m_options.timeLimit_s;
    options.workLimit = m_options.workLimit;
    options.gap = m_options.gap;
    options.inFlight =
        !m_settingsChanged && std::ranges::any_of(m_plans, [](const PlanPointer& plan) {
            return std::ranges::any_of(plan->uavs,
                                       [](const UavPlan& own) { return !own.order.empty(); });
        });
    options.stop = stop;
    const auto request =
        std::make_shared<const PlanRequest>(requestFor(m_simulation, m_planner.settings().policy));
    if (m_incumbentListener)
        options.onProgress = [&](const SolveProgress& progress) {
            reportIncumbent(progress, *request);
        };
    Plan plan = m_planner.plan(*request, options, m_options.warmStart);
    if (plan.outcome.reason == StopReason::Cancelled)
        return false;

    m_lastRequest = request;
    m_settingsChanged = false;
    if (!plan.failure.empty())
        note({.kind = EventKind::PlannerFailed, .failure = plan.failure});
    plan.problem = withoutNumbers(plan.problem);
    plan.outcome.plan = {};
    plan.outcome.multipliers = {};
    plan.solvedIds = {};
    plan.time_s = m_simulation.time_s();
    for (UavPlan& own : plan.uavs)
        own.reason = m_simulation.planReason(own.uav);
    // The first plan of a mission is made before its start.
    const std::int64_t wait = std::llround(m_scenario.planningTime_s / m_simulation.world().dt_s());
    if (wait == 0 || m_plans.empty()) {
        putInForce(std::move(plan));
        return true;
    }
    m_pending = {.plan = std::move(plan), .step = m_simulation.step() + wait};
    flyOn();
    return true;
}

void Mission::putInForce(Plan plan)
{
    if (plan.uavs.empty())
        return;
    plan.zeta_m2s = m_simulation.zeta_m2s();
    for (UavPlan& own : plan.uavs)
        own.thisSortie = thisSortie(m_simulation, own.uav, own.order, own.clusters);
    if (m_options.record) // two forecasts are costly where missions are flown by the thousand
        compareWithLast(plan);
    activate(std::move(plan));
}

/** Puts the plan into force and records it. */
void Mission::activate(Plan plan)
{
    for (const UavPlan& own : plan.uavs) {
        startFlying(plan, own, m_simulation);
        if (!plan.interim)
            note({.kind = EventKind::Planned,
                  .iceberg = own.target(),
                  .uav = own.uav,
                  .source = plan.outcome.source,
                  .fellBack = plan.fellBack});
        noteEvents();
    }
    m_plans.push_back(std::make_shared<const Plan>(std::move(plan)));
}

/** Continues the previous plans while a new one is pending. */
void Mission::flyOn()
{
    for (const int uav : m_simulation.trigger().plannedUavs(m_simulation.fleet()))
        if (m_simulation.planReason(uav) != PlanReason::None)
            flyOn(uav);
}

/** Continues the present leg or flies to the next iceberg of the last plan. */
void Mission::flyOn(int uav)
{
    const PlanReason reason = m_simulation.planReason(uav);
    UavPlan own{.uav = uav, .order = restOfPlan(uav, reason), .reason = reason};
    std::erase_if(own.order, [&](IcebergIndex i) {
        return !m_simulation.available(uav, i) || isTargetOfOther(uav, i);
    });
    if (own.order.empty())
        if (const std::optional<IcebergIndex> next = nearest(
                m_simulation.observer(), m_simulation.fleet().autopilot(uav).pose().position_m,
                [&](IcebergIndex i) {
                    return !isTargetOfOther(uav, i) && m_simulation.available(uav, i);
                });
            next)
            own.order = {*next};
    if (const PlanPointer last = lastPlanOf(m_plans, uav))
        own.clusters = stillClusters(last->of(uav)->clusters, uav, m_simulation);
    own.thisSortie = thisSortie(m_simulation, uav, own.order, own.clusters);
    const double time_s = m_simulation.time_s();
    const FlightTarget* now = m_simulation.fleet().autopilot(uav).flightTarget();
    if (own.target() && now != nullptr && own.target() == now->target && now->aim) {
        AimedLeg leg = *now->aim;
        const double planned_s = time_s + m_scenario.planningTime_s;
        leg.sighting_s = std::max(leg.sighting_s, planned_s);
        if (leg.end_s)
            leg.end_s = std::max(*leg.end_s, planned_s);
        own.legs = {leg};
    }
    activate({.time_s = time_s,
              .zeta_m2s = m_simulation.zeta_m2s(),
              .interim = true,
              .isCounted = false,
              .uavs = {std::move(own)}});
}

bool Mission::isTargetOfOther(int uav, IcebergIndex iceberg) const
{
    for (int other = 0; other < m_simulation.uavCount(); ++other)
        if (other != uav && m_simulation.fleet().autopilot(other).fliesTo(iceberg))
            return true;
    return false;
}

IcebergList Mission::restOfPlan(int uav, PlanReason reason) const
{
    const PlanPointer last = lastPlanOf(m_plans, uav);
    IcebergList rest = last ? last->of(uav)->order : IcebergList();
    if (reason == PlanReason::TargetReached && !rest.empty())
        rest.erase(rest.begin());
    return rest;
}

ForecastStart Mission::forecastStart() const
{
    ForecastStart start{.world = m_simulation.state(),
                        .time_s = m_simulation.time_s(),
                        .wind_mps = m_simulation.windAhead(),
                        .forcings = m_simulation.world().forcings()};
    for (int uav = 0; uav < m_simulation.uavCount(); ++uav)
        start.airspeeds_mps.push_back(m_simulation.motion(uav).airspeed_mps);
    for (const IcebergIndex i : m_simulation.icebergs())
        start.active.push_back(m_simulation.active(i));
    return start;
}

/** Records what the plan changes compared with those in force, predicted from now. */
void Mission::compareWithLast(Plan& plan) const
{
    if (m_plans.empty())
        return;
    OrdersByUav before(static_cast<std::size_t>(m_simulation.uavCount()));
    OrdersByUav after = before;
    // Both orders are cut to what this sortie can fly.
    const auto ofSortie = [this](int uav, IcebergList order,
                                 std::span<const IcebergList> together) {
        if (const std::optional<int> visits = thisSortie(m_simulation, uav, order, together))
            order.resize(static_cast<std::size_t>(*visits));
        return order;
    };
    const auto isPlanned = [&plan](IcebergIndex iceberg) {
        return std::ranges::any_of(plan.uavs, [iceberg](const UavPlan& own) {
            return std::ranges::find(own.order, iceberg) != own.order.end();
        });
    };
    std::vector<IcebergList> clustersBefore;
    std::vector<IcebergList> clustersAfter;
    const auto append = [](auto& all, const std::vector<IcebergList>& own) {
        all.insert(all.end(), own.begin(), own.end());
    };
    for (const UavPlan& next : plan.uavs) {
        const PlanPointer last = lastPlanOf(m_plans, next.uav);
        if (last == nullptr)
            continue;
        const std::vector<IcebergList>& clusters = last->of(next.uav)->clusters;
        append(clustersBefore, clusters);
        append(clustersAfter, next.clusters);
        IcebergList rest = restOfPlan(next.uav, last->interim ? PlanReason::None : next.reason);
        // Icebergs in view are left out, unless the new order contains them, as fixed routes do.
        std::erase_if(rest, [&](IcebergIndex iceberg) {
            return !m_simulation.available(next.uav, iceberg) && !isPlanned(iceberg);
        });
        const auto k = static_cast<std::size_t>(next.uav);
        before[k] = ofSortie(next.uav, std::move(rest), clusters);
        after[k] = ofSortie(next.uav, next.order, next.clusters);
    }
    const double left_s =
        static_cast<double>(m_simulation.world().lastStep()) * m_simulation.world().dt_s() -
        m_simulation.time_s();
    std::vector<std::optional<PlanChange>> changes = planChanges(
        forecastStart(), before, after, left_s, {.before = clustersBefore, .after = clustersAfter});
    for (UavPlan& own : plan.uavs)
        own.change = std::move(changes[static_cast<std::size_t>(own.uav)]);
}

void Mission::reportIncumbent(const SolveProgress& progress, const PlanRequest& request)
{
    if (std::ranges::all_of(progress.orders, &IcebergList::empty))
        return;
    Plan plan{.time_s = m_simulation.time_s(),
              .outcome = {.status = SolveStatus::Feasible,
                          .objective = progress.objective,
                          .bound = progress.bound,
                          .elapsed_s = progress.elapsed_s}};
    for (std::size_t k = 0; k < progress.orders.size(); ++k) {
        const int uav = request.uavs[k].uav;
        plan.uavs.push_back(
            {.uav = uav,
             .order = progress.orders[k],
             .clusters = request.clusters,
             .legs = progress.legs.empty() ? std::vector<AimedLeg>() : progress.legs[k],
             .reason = m_simulation.planReason(uav),
             .thisSortie = thisSortie(m_simulation, uav, progress.orders[k], request.clusters)});
    }
    m_incumbentListener(std::make_shared<const Plan>(std::move(plan)));
}

} // namespace berg
