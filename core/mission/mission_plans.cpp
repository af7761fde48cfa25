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

/** Returns the first iceberg of the order, or nullopt if the order is empty. */
std::optional<int> firstOfOrder(std::span<const int> order)
{
    return order.empty() ? std::nullopt : std::optional(order.front());
}

/** Copies what the log stores of an answer; the caller adds time, order and reason. */
PlanEvent planEvent(const PlanAnswer& answer)
{
    const SolveOutcome& outcome = answer.outcome;
    return {.predictedZeta_m2s = answer.predictedZeta_m2s,
            .status = outcome.status,
            .stop = outcome.reason,
            .source = outcome.source,
            .criterion = answer.problem.criterion,
            .mu = answer.problem.mu,
            .objective = outcome.objective,
            .bound = outcome.bound,
            .gap = answer.gap,
            .distance_m = answer.distance_m,
            .elapsed_s = outcome.elapsed_s,
            .warmStarted = outcome.hintUsed,
            .fellBack = answer.fellBack};
}

/** Returns one event for each UAV of the request; the caller adds times and reasons. */
std::vector<PlanEvent> planEvents(const PlanAnswer& answer, const PlanRequest& request)
{
    std::vector<PlanEvent> events;
    for (std::size_t k = 0; k < answer.uavs.size(); ++k) {
        const UavAnswer& own = answer.uavs[k];
        PlanEvent event = planEvent(answer);
        event.uav = request.uavs[k].uav;
        event.sameSolve = k > 0;
        event.target = firstOfOrder(own.order);
        event.order = own.order;
        std::ranges::copy_if(answer.clusters, std::back_inserter(event.clusters),
                             [&](const std::vector<int>& members) {
                                 return std::ranges::find(own.order, members.front()) !=
                                        own.order.end();
                             });
        event.legs = own.legs;
        event.outlook = own.outlook;
        event.laterVisits = own.laterVisits;
        events.push_back(std::move(event));
    }
    return events;
}

/** Returns the clusters, reduced to the members that the UAV can still visit as one point. */
std::vector<std::vector<int>> stillClusters(std::vector<std::vector<int>> clusters, int uav,
                                            const Simulation& simulation)
{
    for (std::vector<int>& members : clusters)
        std::erase_if(members, [&](int i) { return !simulation.fleet().clusterable(uav, i); });
    std::erase_if(clusters, [](const std::vector<int>& members) { return members.size() < 2; });
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
    Round plans = std::exchange(m_pending, std::nullopt)->plans;
    std::erase_if(plans, [this](const PlanEvent& plan) {
        return !m_simulation.fleet().autopilot(plan.uav).isPlanned();
    });
    bool isTimely = true;
    for (PlanEvent& plan : plans) {
        // Targets that have come into view since are dropped.
        const auto isGone = [&](int i) { return !m_simulation.available(plan.uav, i); };
        std::erase_if(plan.order, isGone);
        plan.clusters = stillClusters(std::move(plan.clusters), plan.uav, m_simulation);
        plan.time_s = m_simulation.time_s();
        if (!plan.target || !isGone(*plan.target))
            continue;
        isTimely = false;
        plan.target = firstOfOrder(plan.order);
        plan.legs.clear();
    }
    putInForce(std::move(plans));
    return isTimely;
}

bool Mission::planNow(const std::stop_token& stop)
{
    SolveOptions options;
    options.timeLimit_s = m_options.timeLimit_s;
    options.workLimit = m_options.workLimit;
    options.gap = m_options.gap;
    options.inFlight =
        !m_settingsChanged &&
        std::ranges::any_of(m_plans, [](const PlanEvent& plan) { return plan.target.has_value(); });
    options.stop = stop;
    const auto request =
        std::make_shared<const PlanRequest>(requestFor(m_simulation, m_planner.settings().policy));
    if (m_incumbentListener)
        options.onProgress = [&](const SolveProgress& progress) {
            reportIncumbent(progress, *request);
        };
    const PlanAnswer answer = m_planner.plan(*request, options, m_options.warmStart);
    if (answer.outcome.reason == StopReason::Cancelled)
        return false;

    m_lastRequest = request;
    m_settingsChanged = false;
    if (!answer.failure.empty())
        note({.kind = EventKind::PlannerFailed, .failure = answer.failure});
    Round plans = planEvents(answer, *request);
    for (PlanEvent& plan : plans) {
        plan.time_s = m_simulation.time_s();
        plan.reason = m_simulation.planReason(plan.uav);
    }
    // The first plan of a mission is made before its start.
    const std::int64_t wait = std::llround(m_scenario.planningTime_s / m_simulation.world().dt_s());
    if (wait == 0 || m_plans.empty()) {
        putInForce(std::move(plans));
        return true;
    }
    m_pending = {.plans = std::move(plans), .step = m_simulation.step() + wait};
    flyOn();
    return true;
}

void Mission::putInForce(Round plans)
{
    for (PlanEvent& plan : plans) {
        plan.zeta_m2s = m_simulation.zeta_m2s();
        plan.thisSortie = thisSortie(m_simulation, plan.uav, plan.order, plan.clusters);
    }
    if (m_options.record) // two forecasts are costly where missions are flown by the thousand
        compareWithLast(plans);
    for (PlanEvent& plan : plans)
        activate(std::move(plan));
}

/** Puts the plan of one UAV into force and records it. */
void Mission::activate(PlanEvent plan)
{
    m_simulation.setTarget(plan.uav, plan.target, firstAim(plan), clusterOfTarget(plan),
                           keepsSearch(plan));
    if (!plan.interim)
        note({.kind = EventKind::Planned,
              .iceberg = plan.target,
              .uav = plan.uav,
              .source = plan.source,
              .fellBack = plan.fellBack});
    noteEvents();
    m_plans.push_back(std::move(plan));
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
    PlanEvent plan{.time_s = m_simulation.time_s(),
                   .uav = uav,
                   .reason = reason,
                   .zeta_m2s = m_simulation.zeta_m2s(),
                   .interim = true};
    plan.order = restOfPlan(uav, reason);
    std::erase_if(plan.order, [&](int i) {
        return !m_simulation.available(uav, i) || isTargetOfOther(uav, i);
    });
    if (plan.order.empty())
        if (const std::optional<int> next = nearest(
                m_simulation.observer(), m_simulation.fleet().autopilot(uav).pose().position_m,
                [&](int i) { return !isTargetOfOther(uav, i) && m_simulation.available(uav, i); });
            next)
            plan.order = {*next};
    if (const PlanEvent* last = lastPlanOf(m_plans, uav))
        plan.clusters = stillClusters(last->clusters, uav, m_simulation);
    plan.thisSortie = thisSortie(m_simulation, uav, plan.order, plan.clusters);
    plan.target = firstOfOrder(plan.order);
    const FlightTarget* now = m_simulation.fleet().autopilot(uav).flightTarget();
    if (plan.target && now != nullptr && plan.target == now->target && now->aim) {
        AimedLeg leg = *now->aim;
        const double planned_s = plan.time_s + m_scenario.planningTime_s;
        leg.sighting_s = std::max(leg.sighting_s, planned_s);
        if (leg.end_s)
            leg.end_s = std::max(*leg.end_s, planned_s);
        plan.legs = {leg};
    }
    activate(std::move(plan));
}

bool Mission::isTargetOfOther(int uav, int iceberg) const
{
    for (int other = 0; other < m_simulation.uavCount(); ++other)
        if (other != uav && m_simulation.fleet().autopilot(other).fliesTo(iceberg))
            return true;
    return false;
}

std::vector<int> Mission::restOfPlan(int uav, PlanReason reason) const
{
    const PlanEvent* last = lastPlanOf(m_plans, uav);
    std::vector<int> rest = last ? last->order : std::vector<int>();
    if (reason == PlanReason::TargetReached && !rest.empty())
        rest.erase(rest.begin());
    return rest;
}

ForecastStart Mission::forecastStart() const
{
    ForecastStart start{.world = m_simulation.state(),
                        .time_s = m_simulation.time_s(),
                        .wind_mps = m_simulation.motion(0).wind_mps};
    for (int uav = 0; uav < m_simulation.uavCount(); ++uav)
        start.airspeeds_mps.push_back(m_simulation.motion(uav).airspeed_mps);
    for (int i = 0; i < m_simulation.icebergCount(); ++i)
        start.active.push_back(m_simulation.active(i));
    return start;
}

/** Records what the plans change compared with those in force, predicted from now. */
void Mission::compareWithLast(Round& plans) const
{
    if (m_plans.empty())
        return;
    OrdersByUav before(static_cast<std::size_t>(m_simulation.uavCount()));
    OrdersByUav after = before;
    // Both orders are cut to what this sortie can fly.
    const auto ofSortie = [this](int uav, std::vector<int> order,
                                 std::span<const std::vector<int>> together) {
        if (const std::optional<int> visits = thisSortie(m_simulation, uav, order, together))
            order.resize(static_cast<std::size_t>(*visits));
        return order;
    };
    const auto isPlanned = [&plans](int iceberg) {
        return std::ranges::any_of(plans, [iceberg](const PlanEvent& plan) {
            return std::ranges::find(plan.order, iceberg) != plan.order.end();
        });
    };
    std::vector<std::vector<int>> clustersBefore;
    std::vector<std::vector<int>> clustersAfter;
    const auto append = [](auto& all, const std::vector<std::vector<int>>& own) {
        all.insert(all.end(), own.begin(), own.end());
    };
    for (const PlanEvent& next : plans) {
        const PlanEvent* last = lastPlanOf(m_plans, next.uav);
        if (last == nullptr)
            continue;
        append(clustersBefore, last->clusters);
        append(clustersAfter, next.clusters);
        std::vector<int> rest =
            restOfPlan(next.uav, last->interim ? PlanReason::None : next.reason);
        // Icebergs in view are left out, unless the new order contains them, as fixed routes do.
        std::erase_if(rest, [&](int iceberg) {
            return !m_simulation.available(next.uav, iceberg) && !isPlanned(iceberg);
        });
        const auto k = static_cast<std::size_t>(next.uav);
        before[k] = ofSortie(next.uav, std::move(rest), last->clusters);
        after[k] = ofSortie(next.uav, next.order, next.clusters);
    }
    const double left_s =
        static_cast<double>(m_simulation.world().lastStep()) * m_simulation.world().dt_s() -
        m_simulation.time_s();
    std::vector<std::optional<PlanChange>> changes = planChanges(
        forecastStart(), before, after, left_s, {.before = clustersBefore, .after = clustersAfter});
    for (PlanEvent& plan : plans)
        plan.change = std::move(changes[static_cast<std::size_t>(plan.uav)]);
}

void Mission::reportIncumbent(const SolveProgress& progress, const PlanRequest& request)
{
    PlanEvent event{.time_s = m_simulation.time_s(),
                    .clusters = request.clusters,
                    .status = SolveStatus::Feasible,
                    .objective = progress.objective,
                    .bound = progress.bound,
                    .elapsed_s = progress.elapsed_s};
    if (std::ranges::all_of(progress.plan, &std::vector<int>::empty))
        return;
    for (std::size_t k = 0; k < progress.plan.size(); ++k) {
        event.uav = request.uavs[k].uav;
        event.sameSolve = k > 0;
        event.order = progress.plan[k];
        event.reason = m_simulation.planReason(event.uav);
        event.target = firstOfOrder(event.order);
        event.thisSortie = thisSortie(m_simulation, event.uav, event.order, event.clusters);
        event.legs = progress.legs.empty() ? std::vector<AimedLeg>() : progress.legs[k];
        m_incumbentListener(event);
    }
}

} // namespace berg
