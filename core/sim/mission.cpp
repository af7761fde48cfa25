#include "core/sim/mission.h"

#include "core/base/solving_guard.h"
#include "core/coverage/coverage_policy.h"
#include "core/plan/names.h"
#include "core/scenario/validate.h"
#include "core/sim/clusters.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace berg {

namespace {

const Scenario& checked(const Scenario& scenario)
{
    std::vector<Issue> issues = validate(scenario);
    std::erase_if(issues, [](const Issue& i) { return i.severity != Severity::Error; });
    if (!issues.empty())
        throw Error(ErrorCode::InvalidInput, scenario.name, std::move(issues));
    return scenario;
}

/** What the log keeps of an answer; time and reason are the caller's. */
PlanEvent planEvent(const PlanAnswer& answer)
{
    const SolveOutcome& outcome = answer.outcome;
    PlanEvent event{.target = answer.order.empty() ? -1 : answer.order.front(),
                    .order = answer.order,
                    .clusters = answer.clusters,
                    .legs = answer.legs,
                    .predictedZeta_m2s = answer.predictedZeta_m2s,
                    .outlook = answer.outlook,
                    .status = outcome.status,
                    .stop = outcome.reason,
                    .backend = outcome.backend,
                    .criterion = answer.problem.criterion,
                    .mu = answer.problem.mu,
                    .objective = outcome.objective,
                    .bound = outcome.bound,
                    .elapsed_s = outcome.elapsed_s,
                    .warmStarted = outcome.hintUsed,
                    .fellBack = answer.fellBack};
    if (!outcome.order.empty())
        event.distance_m = flownDistance(answer.problem, outcome.order);
    if (outcome.bound && outcome.status != SolveStatus::None)
        event.gap = relativeGap(answer.problem, outcome.objective, *outcome.bound);
    return event;
}

/** Who is seen with the target; empty: it is no cluster. */
std::string togetherText(const WorldState& state, const std::vector<Iceberg>& icebergs)
{
    std::string text;
    for (const int member : state.members)
        if (member != state.target)
            text += (text.empty() ? "with " : ", ") + icebergs[static_cast<std::size_t>(member)].id;
    return text;
}

/** Of the clusters, what can still be flown to as one point. */
std::vector<std::vector<int>> stillClusters(std::vector<std::vector<int>> clusters,
                                            const Simulation& simulation)
{
    for (std::vector<int>& members : clusters)
        std::erase_if(members, [&](int i) { return !simulation.clusterable(i); });
    std::erase_if(clusters, [](const std::vector<int>& members) { return members.size() < 2; });
    return clusters;
}

} // namespace

Mission::Mission(const Scenario& scenario, const MissionOptions& options,
                 std::unique_ptr<TvpSolver> solver, std::span<const DriftNoise> noise)
    : m_scenario(checked(scenario))
    , m_options(options)
    , m_icebergs(scenario.icebergs)
    , m_simulation(scenario, noise)
    , m_planner(scenario.planner, std::move(solver), makeFlownPolicy)
    , m_recorder(options.sampleInterval_s, options.keyframeInterval_s, scenario.dt_s)
{
    if (m_options.record)
        m_recorder.record(m_simulation);
}

AdvanceStatus Mission::advance(double until_s, const std::stop_token& stop,
                               const std::function<void(double)>& onProgress)
{
    requireSolvingAllowed();
    const double dt_s = m_simulation.dt_s();
    const std::int64_t untilStep = std::llround(until_s / dt_s);
    const std::int64_t second = std::max<std::int64_t>(1, std::llround(1 / dt_s));
    while (!m_simulation.finished()) {
        if (stop.stop_requested())
            return AdvanceStatus::Cancelled;
        if (!planWhenDue(stop))
            return AdvanceStatus::Cancelled;
        if (m_simulation.state().step >= untilStep)
            return AdvanceStatus::Reached;
        m_simulation.advanceStep();
        noteStep();
        if (m_options.record)
            m_recorder.record(m_simulation);
        if (onProgress && m_simulation.state().step % second == 0)
            onProgress(m_simulation.time_s());
    }
    return AdvanceStatus::Finished;
}

/** Puts a pending plan in force and asks for one where it is needed. False: cancelled. */
bool Mission::planWhenDue(const std::stop_token& stop)
{
    if (m_simulation.homeward()) { // what is flown next is planned at take-off
        m_pending.reset();
        m_missed = PlanReason::None;
        return true;
    }
    if (m_pending && m_simulation.state().step >= m_pending->step) {
        PlanEvent plan = std::exchange(m_pending, std::nullopt)->plan;
        // What has come into view since is not flown to.
        std::erase_if(plan.order, [this](int i) { return !m_simulation.available(i); });
        plan.clusters = stillClusters(std::move(plan.clusters), m_simulation);
        const bool outdated = plan.target >= 0 && !m_simulation.available(plan.target);
        if (outdated) {
            plan.target = plan.order.empty() ? -1 : plan.order.front();
            plan.legs.clear();
        }
        const PlanReason missed = std::exchange(m_missed, PlanReason::None);
        plan.time_s = m_simulation.time_s();
        putInForce(std::move(plan));
        if (missed != PlanReason::None || outdated)
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

bool Mission::planNow(const std::stop_token& stop)
{
    SolveOptions options;
    options.timeLimit_s = m_options.timeLimit_s;
    options.workLimit = m_options.workLimit;
    options.gap = m_options.gap;
    options.stop = stop;
    const auto request =
        std::make_shared<const PlanRequest>(requestFor(m_simulation, m_planner.settings().policy));
    if (m_incumbentListener)
        options.onProgress = [&](const SolveProgress& progress) {
            tellIncumbent(progress, *request);
        };
    const PlanAnswer answer = m_planner.plan(*request, options, m_options.warmStart);
    if (answer.outcome.reason == StopReason::Cancelled)
        return false;

    m_lastRequest = request;
    if (!answer.failure.empty())
        note(EventKind::PlannerFailed, -1, answer.failure);
    PlanEvent event = planEvent(answer);
    event.time_s = m_simulation.time_s();
    event.reason = m_simulation.planReason();
    if (event.outlook && !event.outlook->sightings_s.empty())
        event.distance_m = request->speed_mps * (event.outlook->sightings_s.back() - event.time_s);
    // The first plan of a sortie is made before take-off.
    const std::int64_t wait = std::llround(m_scenario.planningTime_s / m_simulation.dt_s());
    if (wait == 0 || m_plans.empty() || event.reason == PlanReason::TakeOff) {
        putInForce(std::move(event));
        return true;
    }
    m_pending = {.plan = std::move(event), .step = m_simulation.state().step + wait};
    flyOn();
    return true;
}

void Mission::putInForce(PlanEvent plan)
{
    plan.zeta_m2s = m_simulation.state().zeta_m2s;
    plan.thisSortie = thisSortie(m_simulation, plan.order, plan.clusters);
    if (m_options.record) // two forecasts: dear where missions are flown by the thousand
        plan.change = changeTo(plan);
    m_simulation.setTarget(plan.target, firstAim(plan), clusterWith(plan.clusters, plan.target));
    note(EventKind::Planned, plan.target, plan.fellBack ? "last plan kept" : plan.backend);
    noteNews();
    m_plans.push_back(std::move(plan));
}

/** The autopilot's part while a plan is pending: the leg under way, or the next of the last plan.
 */
void Mission::flyOn()
{
    const PlanReason reason = m_simulation.planReason();
    PlanEvent plan{.time_s = m_simulation.time_s(),
                   .reason = reason,
                   .zeta_m2s = m_simulation.state().zeta_m2s,
                   .interim = true};
    plan.order = restOfPlan(reason);
    std::erase_if(plan.order, [this](int i) { return !m_simulation.available(i); });
    if (plan.order.empty())
        if (const int nearest = m_simulation.nearestAvailable(); nearest >= 0)
            plan.order = {nearest};
    plan.clusters = stillClusters(m_plans.back().clusters, m_simulation);
    plan.thisSortie = thisSortie(m_simulation, plan.order, plan.clusters);
    plan.target = plan.order.empty() ? -1 : plan.order.front();
    if (plan.target >= 0 && plan.target == m_simulation.state().target &&
        m_simulation.state().aim) {
        AimedLeg leg = *m_simulation.state().aim;
        leg.sighting_s = std::max(leg.sighting_s, plan.time_s + m_scenario.planningTime_s);
        plan.legs = {leg};
    }
    m_simulation.setTarget(plan.target, firstAim(plan), clusterWith(plan.clusters, plan.target));
    noteNews();
    m_plans.push_back(std::move(plan));
}

std::vector<int> Mission::restOfPlan(PlanReason reason) const
{
    std::vector<int> rest = m_plans.back().order;
    if (reason == PlanReason::TargetReached && !rest.empty())
        rest.erase(rest.begin());
    return rest;
}

/** What `next` changes about the plan in force, seen from here. */
std::optional<PlanChange> Mission::changeTo(const PlanEvent& next) const
{
    if (m_plans.empty())
        return std::nullopt;
    std::vector<int> rest = restOfPlan(m_plans.back().interim ? PlanReason::None : next.reason);
    // Those in view are passed over, unless the new order keeps them, as fixed routes do.
    std::erase_if(rest, [&](int iceberg) {
        return !m_simulation.available(iceberg) &&
               std::find(next.order.begin(), next.order.end(), iceberg) == next.order.end();
    });
    // Of both what can be flown.
    const ChangedClusters clusters{.before = m_plans.back().clusters, .after = next.clusters};
    const auto ofSortie = [this](std::vector<int> order,
                                 std::span<const std::vector<int>> together) {
        if (const std::optional<int> visits = thisSortie(m_simulation, order, together))
            order.resize(static_cast<std::size_t>(*visits));
        return order;
    };
    ForecastStart start{.world = m_simulation.state(),
                        .time_s = m_simulation.time_s(),
                        .airspeed_mps = m_simulation.motion().airspeed_mps,
                        .wind_mps = m_simulation.motion().wind_mps};
    for (int i = 0; i < m_simulation.icebergCount(); ++i)
        start.active.push_back(m_simulation.active(i));
    const double left_s =
        static_cast<double>(m_simulation.lastStep()) * m_simulation.dt_s() - start.time_s;
    return planChange(start, ofSortie(std::move(rest), clusters.before),
                      ofSortie(next.order, clusters.after), left_s, clusters);
}

void Mission::setIncumbentListener(std::function<void(const PlanEvent&)> listener)
{
    m_incumbentListener = std::move(listener);
}

void Mission::tellIncumbent(const SolveProgress& progress, const PlanRequest& request)
{
    if (progress.order.empty())
        return;
    m_incumbentListener({.time_s = m_simulation.time_s(),
                         .reason = m_simulation.planReason(),
                         .target = progress.order.front(),
                         .order = progress.order,
                         .clusters = request.clusters,
                         .thisSortie = thisSortie(m_simulation, progress.order, request.clusters),
                         .legs = progress.legs,
                         .status = SolveStatus::Feasible,
                         .objective = progress.objective,
                         .bound = progress.bound,
                         .elapsed_s = progress.elapsed_s});
}

void Mission::note(EventKind kind, int iceberg, std::string detail)
{
    const bool isInEveryRun =
        kind == EventKind::Planned || kind == EventKind::Reached || kind == EventKind::Sighted;
    if (m_options.record || !isInEveryRun)
        m_events.push_back({m_simulation.time_s(), kind, iceberg, std::move(detail)});
}

void Mission::noteStep()
{
    for (const int iceberg : m_simulation.newlyAppeared())
        note(EventKind::Appeared, iceberg, {});
    for (const int iceberg : m_simulation.newlySeen())
        note(EventKind::Sighted, iceberg, {});
    noteNews();
    if (m_simulation.planReason() == PlanReason::TargetReached) {
        ++m_visits;
        note(EventKind::Reached, m_simulation.state().target,
             togetherText(m_simulation.state(), m_icebergs));
    }
    const auto second =
        static_cast<std::int64_t>(std::max(1LL, std::llround(1 / m_simulation.dt_s())));
    if (m_simulation.asset() && m_simulation.state().step % second == 0)
        noteAlarms();
}

void Mission::noteNews()
{
    for (const News& news : m_simulation.takeNews())
        note(news.kind, news.iceberg, {});
}

/** One for each time an iceberg is found to be on its way into the inner ring. */
void Mission::noteAlarms()
{
    m_alarmed.resize(static_cast<std::size_t>(m_simulation.icebergCount()));
    const double radius_m = alarmRadius_m(*m_simulation.asset());
    for (int i = 0; i < m_simulation.icebergCount(); ++i) {
        if (!m_simulation.active(i))
            continue;
        const std::optional<double> entry_s =
            entryTime_s(*m_simulation.relativeToAsset(i), radius_m, kApproachHorizon_s);
        const auto k = static_cast<std::size_t>(i);
        if (entry_s && !m_alarmed[k])
            note(EventKind::Alarm, i, "in " + std::to_string(std::llround(*entry_s)) + " s");
        m_alarmed[k] = entry_s.has_value();
    }
}

void Mission::intervene(Intervention intervention)
{
    PlannerSettings settings = m_planner.settings();
    settings.tau = intervention.tau.value_or(settings.tau);
    settings.policy = intervention.policy.value_or(settings.policy);
    Scenario after = m_scenario;
    after.planner = settings;
    after.icebergs = m_icebergs;
    after.wind_mps = intervention.wind_mps.value_or(m_simulation.motion().wind_mps);
    after.asset = intervention.asset ? intervention.asset : m_simulation.asset();
    if (intervention.appears)
        after.icebergs.push_back(*intervention.appears);
    checked(after);
    const int seen = intervention.seen ? appearedIceberg(*intervention.seen) : -1;
    // A plan still due is made before the change, as a replay does: it comes to this instant by
    // `advance`, which leaves no plan due.
    if (!m_simulation.finished())
        static_cast<void>(planWhenDue({}));

    m_planner.setSettings(settings);
    intervention.time_s = m_simulation.time_s();
    if (intervention.tau || intervention.policy) {
        m_simulation.requestPlan();
        note(EventKind::Intervention, -1, nameOf(kPolicyNames, settings.policy));
    }
    if (intervention.wind_mps) {
        m_simulation.setWind(*intervention.wind_mps);
        note(EventKind::Intervention, -1, kWindChanged);
    }
    if (intervention.asset) {
        m_simulation.setAsset(*intervention.asset);
        note(EventKind::Intervention, -1, kAssetChanged);
    }
    if (intervention.appears) {
        m_icebergs.push_back(*intervention.appears);
        m_simulation.addIceberg(*intervention.appears);
        note(EventKind::Appeared, m_simulation.icebergCount() - 1, {});
    }
    if (seen >= 0) {
        m_simulation.reportSighting(seen);
        note(EventKind::Sighted, seen, kReported);
    }
    m_interventions.push_back(std::move(intervention));
    m_plansBefore.push_back(m_plans.size());
}

int Mission::appearedIceberg(const std::string& id) const
{
    for (int i = 0; i < m_simulation.icebergCount(); ++i)
        if (m_icebergs[static_cast<std::size_t>(i)].id == id && m_simulation.active(i))
            return i;
    throw Error(ErrorCode::InvalidInput, m_scenario.name,
                {{Severity::Error, "seen", "no iceberg \"" + id + "\" is there at this time"}});
}

Metrics Mission::metrics() const
{
    return {.zeta_m2s = m_simulation.state().zeta_m2s,
            .visits = m_visits,
            .replans = static_cast<int>(std::count_if(
                m_plans.begin(), m_plans.end(), [](const PlanEvent& p) { return !p.interim; })),
            .flown_m = m_simulation.state().flown_m};
}

PlanAnswer planFromStart(const Scenario& scenario, const SolveOptions& options)
{
    const PlanRequest request = requestFor(Simulation(checked(scenario)), scenario.planner.policy);
    return Planner(scenario.planner, nullptr, makeFlownPolicy).plan(request, options);
}

} // namespace berg
