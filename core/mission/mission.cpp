#include "core/mission/mission.h"

#include "core/base/solving_guard.h"
#include "core/checks/validate.h"
#include "core/coverage/coverage_policy.h"
#include "core/mission/plan_requests.h"
#include "core/plan/policy/policy.h"

#include <algorithm>
#include <cmath>
#include <numeric>
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

/** Returns the other members of the target's cluster; empty for a single iceberg. */
IcebergList seenWithTarget(const FlightTarget& flightTarget)
{
    IcebergList others = flightTarget.members;
    std::erase(others, *flightTarget.target);
    return others;
}

} // namespace

Mission::Mission(const Scenario& scenario, const MissionOptions& options,
                 std::unique_ptr<TvpSolver> solver, std::span<const DriftNoise> noise)
    : m_scenario(checked(scenario))
    , m_options(options)
    , m_icebergs(scenario.icebergs)
    , m_simulation(scenario, noise)
    , m_poseTracks(scenario.uavs.size())
    , m_planner(scenario.planner, std::move(solver), makeFlownPolicy)
    , m_recorder(options.sampleInterval_s, options.keyframeInterval_s, scenario.dt_s)
    , m_visits(scenario.uavs.size())
{
    if (m_options.record)
        m_recorder.record(m_simulation);
}

AdvanceStatus Mission::advance(double until_s, const std::stop_token& stop,
                               const std::function<void(double)>& onProgress)
{
    requireSolvingAllowed();
    const std::int64_t untilStep = std::llround(until_s / m_simulation.world().dt_s());
    while (!m_simulation.finished()) {
        if (stop.stop_requested())
            return AdvanceStatus::Cancelled;
        if (!planWhenDue(stop))
            return AdvanceStatus::Cancelled;
        if (m_simulation.step() >= untilStep)
            return AdvanceStatus::Reached;
        const World& world = m_simulation.world();
        m_simulation.advanceStep(m_poseTracks.posesAt(world.time_s() + world.dt_s(), world.dt_s()));
        noteStep();
        if (m_options.record)
            m_recorder.record(m_simulation);
        if (onProgress && m_simulation.world().isWholeSecond())
            onProgress(m_simulation.time_s());
    }
    return AdvanceStatus::Finished;
}

void Mission::setIncumbentListener(std::function<void(PlanPointer)> listener)
{
    m_incumbentListener = std::move(listener);
}

/** Adds an event with the present time. */
void Mission::note(MissionEvent event)
{
    const bool isInEveryRun = event.kind == EventKind::Planned ||
                              event.kind == EventKind::Sighted || event.kind == EventKind::Reached;
    if (!m_options.record && isInEveryRun)
        return;
    event.time_s = m_simulation.time_s();
    m_events.push_back(std::move(event));
}

void Mission::noteStep()
{
    for (const IcebergIndex iceberg : m_simulation.observer().newlyAppeared())
        note({.kind = EventKind::Appeared, .iceberg = iceberg});
    for (const SeenIceberg& sighting : m_simulation.observer().newlySeen())
        note({.kind = EventKind::Sighted, .iceberg = sighting.iceberg, .uav = sighting.uav});
    noteEvents();
    for (int uav = 0; uav < m_simulation.uavCount(); ++uav)
        if (m_simulation.planReason(uav) == PlanReason::TargetReached) {
            ++m_visits.at(static_cast<std::size_t>(uav));
            const FlightTarget& flightTarget = *m_simulation.fleet().autopilot(uav).flightTarget();
            note({.kind = EventKind::Reached,
                  .iceberg = flightTarget.target,
                  .uav = uav,
                  .together = seenWithTarget(flightTarget)});
        }
    if (m_simulation.world().asset() && m_simulation.world().isWholeSecond())
        noteAlarms();
}

void Mission::noteEvents()
{
    for (MissionEvent& event : m_simulation.drainEvents())
        note(std::move(event));
}

/** Adds an alarm each time an iceberg is newly predicted to enter the inner ring. */
void Mission::noteAlarms()
{
    m_alarmed.resize(static_cast<std::size_t>(m_simulation.icebergCount()));
    const double radius_m = alarmRadius_m(*m_simulation.world().asset());
    for (const IcebergIndex i : m_simulation.icebergs()) {
        if (!m_simulation.active(i))
            continue;
        const std::optional<double> entry_s =
            entryTime_s(*relativeToAsset(m_simulation.observer(), i), radius_m, kApproachHorizon_s);
        const std::size_t k = toIndex(i);
        if (entry_s && !m_alarmed[k])
            note({.kind = EventKind::Alarm, .iceberg = i, .entry_s = *entry_s});
        m_alarmed[k] = entry_s.has_value();
    }
}

void Mission::intervene(Intervention intervention)
{
    const PlannerSettings settings = withChanges(m_planner.settings(), intervention);
    Scenario after = m_scenario;
    after.planner = settings;
    after.icebergs = m_icebergs;
    after.wind_mps = intervention.wind_mps.value_or(m_simulation.motion(0).wind_mps);
    after.asset = intervention.asset ? intervention.asset : m_simulation.world().asset();
    if (intervention.appears)
        after.icebergs.push_back(*intervention.appears);
    if (const auto& home = intervention.home)
        if (const std::optional<int> uav = indexOfId(after.uavs, home->uav))
            after.uavs[toIndex(*uav)].home_m = home->place_m;
    checked(after);
    requireNames(intervention);
    // A plan still due is made before the change, as in a replay, which reaches this instant
    // through `advance` and so leaves no plan due.
    if (!m_simulation.finished())
        static_cast<void>(planWhenDue({}));

    m_settingsChanged = m_settingsChanged || settings != m_planner.settings();
    m_planner.setSettings(settings);
    intervention.time_s = m_simulation.time_s();
    m_icebergs = std::move(after.icebergs);
    apply(intervention, m_simulation, m_icebergs, m_scenario.uavs);
    noteChanges(intervention);
    m_interventions.push_back(std::move(intervention));
    m_plansBefore.push_back(m_plans.size());
}

void Mission::noteChanges(const Intervention& intervention)
{
    const auto changed = [this](ChangedPart part) {
        note({.kind = EventKind::Intervention,
              .changed = part,
              .policy = m_planner.settings().policy,
              .tau = m_planner.settings().tau});
    };
    if (intervention.tau || intervention.policy)
        changed(ChangedPart::Planner);
    if (intervention.wind_mps)
        changed(ChangedPart::Wind);
    if (intervention.asset)
        changed(ChangedPart::Asset);
    if (intervention.appears)
        note({.kind = EventKind::Appeared,
              .iceberg = IcebergIndex::of(m_simulation.icebergCount() - 1),
              .reported = true});
    if (intervention.seen)
        note({.kind = EventKind::Sighted,
              .iceberg = indexOfId(m_icebergs, *intervention.seen),
              .reported = true});
    if (intervention.removed)
        note({.kind = EventKind::Intervention,
              .iceberg = indexOfId(m_icebergs, *intervention.removed),
              .changed = ChangedPart::Removal});
    if (const std::optional<Assignment>& assigned = intervention.assigned) {
        const IcebergIndex iceberg = *indexOfId(m_icebergs, assigned->iceberg);
        m_icebergs[toIndex(iceberg)].uav = assigned->uav;
        note({.kind = EventKind::Intervention,
              .iceberg = iceberg,
              .uav = indexOfId(m_scenario.uavs, assigned->uav),
              .changed = ChangedPart::Assignment});
    }
    if (intervention.commanded)
        note({.kind = EventKind::Intervention,
              .uav = indexOfId(m_scenario.uavs, intervention.commanded->uav),
              .changed = ChangedPart::Order,
              .order = intervention.commanded->order});
}

/**
 * Throws `Error{InvalidInput}` if an iceberg that is named is not monitored now, or a UAV is not
 * in the scenario. An iceberg to remove may have left the area already: a comparison flies the
 * same interventions with another policy, whose estimates differ.
 */
void Mission::requireNames(const Intervention& intervention) const
{
    const auto isMonitored = [this](const std::string& id) {
        const std::optional<IcebergIndex> index = indexOfId(m_icebergs, id);
        return index && m_simulation.active(*index);
    };
    const auto isRemovable = [&](const std::string& id) {
        const std::optional<IcebergIndex> index = indexOfId(m_icebergs, id);
        return isMonitored(id) || (index && m_simulation.track(*index).left);
    };
    std::vector<Issue> faults = unknownNames(
        intervention, m_scenario.uavs, {.isMonitored = isMonitored, .isRemovable = isRemovable});
    if (!faults.empty())
        throw Error(ErrorCode::InvalidInput, m_scenario.name, std::move(faults));
}

Metrics Mission::metrics() const
{
    return {.zeta_m2s = m_simulation.zeta_m2s(),
            .visits = std::accumulate(m_visits.begin(), m_visits.end(), 0),
            .replans = static_cast<int>(std::ranges::count(m_plans, true, &Plan::isCounted)),
            .flown_m = m_simulation.state().flown_m()};
}

Plan planFromStart(const Scenario& scenario, const SolveOptions& options)
{
    const PlanRequest request = requestFor(Simulation(checked(scenario)), scenario.planner.policy);
    return Planner(scenario.planner, nullptr, makeFlownPolicy).plan(request, options);
}

} // namespace berg
