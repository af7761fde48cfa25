#include "core/sim/mission.h"

#include "core/base/solving_guard.h"
#include "core/coverage/coverage_policy.h"
#include "core/plan/policy/policy.h"
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

/** Who is seen with the target; empty: it is no cluster. */
std::string togetherText(const UavState& uav, const std::vector<Iceberg>& icebergs)
{
    std::string text;
    for (const int member : uav.members)
        if (member != uav.target)
            text += (text.empty() ? "with " : ", ") + icebergs[static_cast<std::size_t>(member)].id;
    return text;
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

void Mission::setIncumbentListener(std::function<void(const PlanEvent&)> listener)
{
    m_incumbentListener = std::move(listener);
}

void Mission::note(EventKind kind, int iceberg, int uav, std::string detail)
{
    // Who of several has reached what is told nowhere else.
    const bool isInEveryRun = kind == EventKind::Planned || kind == EventKind::Sighted ||
                              (kind == EventKind::Reached && m_simulation.uavCount() == 1);
    if (m_options.record || !isInEveryRun)
        m_events.push_back({m_simulation.time_s(), kind, iceberg, uav, std::move(detail)});
}

void Mission::noteStep()
{
    for (const int iceberg : m_simulation.newlyAppeared())
        note(EventKind::Appeared, iceberg, -1);
    for (const SeenIceberg& sighting : m_simulation.newlySeen())
        note(EventKind::Sighted, sighting.iceberg, sighting.uav);
    noteNews();
    for (int uav = 0; uav < m_simulation.uavCount(); ++uav)
        if (m_simulation.planReason(uav) == PlanReason::TargetReached) {
            ++m_visits;
            note(EventKind::Reached, m_simulation.uav(uav).target, uav,
                 togetherText(m_simulation.uav(uav), m_icebergs));
        }
    const auto second =
        static_cast<std::int64_t>(std::max(1LL, std::llround(1 / m_simulation.dt_s())));
    if (m_simulation.asset() && m_simulation.state().step % second == 0)
        noteAlarms();
}

void Mission::noteNews()
{
    for (const News& news : m_simulation.takeNews()) {
        std::string detail;
        if (news.otherUav >= 0)
            detail = m_scenario.uavs[static_cast<std::size_t>(news.otherUav)].id + ", " +
                     std::to_string(std::llround(news.distance_m)) + " m";
        note(news.kind, news.iceberg, news.uav, std::move(detail));
    }
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
            note(EventKind::Alarm, i, -1, "in " + std::to_string(std::llround(*entry_s)) + " s");
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
    after.wind_mps = intervention.wind_mps.value_or(m_simulation.motion(0).wind_mps);
    after.asset = intervention.asset ? intervention.asset : m_simulation.asset();
    if (intervention.appears)
        after.icebergs.push_back(*intervention.appears);
    checked(after);
    if (intervention.seen)
        static_cast<void>(appearedIceberg(*intervention.seen, "seen"));
    if (intervention.assigned) {
        static_cast<void>(appearedIceberg(intervention.assigned->iceberg, "assigned.iceberg"));
        static_cast<void>(uavIndex(intervention.assigned->uav));
    }
    // A plan still due is made before the change, as a replay does: it comes to this instant by
    // `advance`, which leaves no plan due.
    if (!m_simulation.finished())
        static_cast<void>(planWhenDue({}));

    m_planner.setSettings(settings);
    intervention.time_s = m_simulation.time_s();
    apply(intervention, settings);
    m_interventions.push_back(std::move(intervention));
    m_plansBefore.push_back(m_plans.size());
}

void Mission::apply(const Intervention& intervention, const PlannerSettings& settings)
{
    if (intervention.tau || intervention.policy) {
        m_simulation.setPolicy(settings.policy);
        m_simulation.requestPlan();
        note(EventKind::Intervention, -1, -1, nameOf(kPolicyNames, settings.policy));
    }
    if (intervention.wind_mps) {
        m_simulation.setWind(*intervention.wind_mps);
        note(EventKind::Intervention, -1, -1, kWindChanged);
    }
    if (intervention.asset) {
        m_simulation.setAsset(*intervention.asset);
        note(EventKind::Intervention, -1, -1, kAssetChanged);
    }
    if (intervention.appears) {
        m_icebergs.push_back(*intervention.appears);
        m_simulation.addIceberg(*intervention.appears);
        note(EventKind::Appeared, m_simulation.icebergCount() - 1, -1);
    }
    if (intervention.seen) {
        const int seen = appearedIceberg(*intervention.seen, "seen");
        m_simulation.reportSighting(seen);
        note(EventKind::Sighted, seen, -1, kReported);
    }
    if (intervention.assigned) {
        const int iceberg = appearedIceberg(intervention.assigned->iceberg, "assigned.iceberg");
        const int uav = uavIndex(intervention.assigned->uav);
        m_icebergs[static_cast<std::size_t>(iceberg)].uav = intervention.assigned->uav;
        m_simulation.assign(iceberg, uav);
        note(EventKind::Intervention, iceberg, uav, kAssigned);
    }
}

int Mission::appearedIceberg(const std::string& id, const char* field) const
{
    for (int i = 0; i < m_simulation.icebergCount(); ++i)
        if (m_icebergs[static_cast<std::size_t>(i)].id == id && m_simulation.active(i))
            return i;
    throw Error(ErrorCode::InvalidInput, m_scenario.name,
                {{Severity::Error, field, "no iceberg \"" + id + "\" is there at this time"}});
}

/** -1: any UAV, the id is empty. */
int Mission::uavIndex(const std::string& id) const
{
    if (id.empty())
        return -1;
    const auto it = std::ranges::find(m_scenario.uavs, id, &Uav::id);
    if (it != m_scenario.uavs.end())
        return static_cast<int>(it - m_scenario.uavs.begin());
    throw Error(ErrorCode::InvalidInput, m_scenario.name,
                {{Severity::Error, "assigned.uav", "no UAV is named \"" + id + "\""}});
}

Metrics Mission::metrics() const
{
    return {.zeta_m2s = m_simulation.state().zeta_m2s,
            .visits = m_visits,
            .replans = static_cast<int>(std::ranges::count_if(m_plans, isReplan)),
            .flown_m = m_simulation.state().flown_m()};
}

PlanAnswer planFromStart(const Scenario& scenario, const SolveOptions& options)
{
    const PlanRequest request = requestFor(Simulation(checked(scenario)), scenario.planner.policy);
    return Planner(scenario.planner, nullptr, makeFlownPolicy).plan(request, options);
}

} // namespace berg
