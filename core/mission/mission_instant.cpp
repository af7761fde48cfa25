#include "core/mission/mission_instant.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace berg {

namespace {

/** Continues a copy of a keyframe with the mission's recorded plans and interventions. */
class Rewind
{
public:
    Rewind(const Mission& mission, const Simulation& start) : m_mission(mission), m_world(start)
    {
        m_plan = countBefore(mission.plans(), &Plan::time_s);
        m_intervention = countBefore(mission.interventions(), &Intervention::time_s);
        apply();
    }

    void flyTo(std::int64_t step)
    {
        while (m_world.step() < step) {
            const World& world = m_world.world();
            m_world.advanceStep(
                m_mission.poseTracks().posesAt(world.time_s() + world.dt_s(), world.dt_s()));
            apply();
        }
    }

    [[nodiscard]] MissionInstant instant() const
    {
        const std::vector<MissionEvent>& events = m_mission.events();
        const auto end = std::find_if(events.begin(), events.end(), [this](const MissionEvent& e) {
            return stepOf(e.time_s) > m_world.step();
        });
        MissionInstant instant{.simulation = m_world,
                               .planner = m_mission.scenario().planner,
                               .plans = m_plan,
                               .events = static_cast<std::size_t>(end - events.begin()),
                               .interventions = m_intervention};
        for (std::size_t i = 0; i < m_intervention; ++i)
            instant.planner = withChanges(instant.planner, m_mission.interventions()[i]);
        instant.metrics = {.zeta_m2s = m_world.zeta_m2s(),
                           .visits = static_cast<int>(std::count_if(
                               events.begin(), end,
                               [](const MissionEvent& e) { return e.kind == EventKind::Reached; })),
                           .replans = plansMade(),
                           .flown_m = m_world.state().flown_m()};
        return instant;
    }

private:
    [[nodiscard]] int plansMade() const
    {
        const auto first = m_mission.plans().begin();
        return static_cast<int>(
            std::count_if(first, first + static_cast<std::ptrdiff_t>(m_plan),
                          [](const PlanPointer& plan) { return plan->isCounted; }));
    }
    [[nodiscard]] std::int64_t stepOf(double time_s) const
    {
        return std::llround(time_s / m_world.world().dt_s());
    }
    [[nodiscard]] bool isNow(double time_s) const { return stepOf(time_s) == m_world.step(); }

    /** Counts the entries of a chronological record before this step. */
    template <class Entry, class Time>
    [[nodiscard]] std::size_t countBefore(const std::vector<Entry>& record, Time time_s) const
    {
        const auto now =
            std::ranges::lower_bound(record, m_world.step(), {}, [&](const Entry& entry) {
                return stepOf(std::invoke(time_s, entry));
            });
        return static_cast<std::size_t>(now - record.begin());
    }

    /** Applies the plans and interventions of this step in their original order. */
    void apply()
    {
        const std::vector<PlanPointer>& plans = m_mission.plans();
        const std::vector<Intervention>& changes = m_mission.interventions();
        for (;;) {
            if (m_intervention < changes.size() && isNow(changes[m_intervention].time_s) &&
                m_mission.plansBefore(m_intervention) <= m_plan) {
                berg::apply(changes[m_intervention], m_world, m_mission.icebergs(),
                            m_mission.scenario().uavs);
                ++m_intervention;
            } else if (m_plan < plans.size() && isNow(plans[m_plan]->time_s)) {
                const Plan& plan = *plans[m_plan];
                // This interim plan was requested because a plan came into force with a target no
                // longer available.
                const UavPlan& first = plan.uavs.front();
                if (plan.interim && first.reason == PlanReason::Intervention &&
                    m_world.planReason(first.uav) != PlanReason::Intervention)
                    m_world.requestPlan();
                for (const UavPlan& own : plan.uavs)
                    startFlying(plan, own, m_world);
                ++m_plan;
            } else {
                return;
            }
        }
    }

    const Mission& m_mission;
    Simulation m_world;
    std::size_t m_plan = 0;
    std::size_t m_intervention = 0;
};

} // namespace

MissionInstant instantAt(const Mission& mission, double time_s)
{
    const Simulation& head = mission.simulation();
    const std::int64_t step =
        std::clamp<std::int64_t>(std::llround(time_s / head.world().dt_s()), 0, head.step());
    const std::vector<Simulation>& keyframes = mission.recorder().keyframes();
    const auto after = std::ranges::upper_bound(keyframes, step, {}, &Simulation::step);
    require(after != keyframes.begin(), "instantAt: the mission was flown without a record");
    Rewind rewind(mission, *std::prev(after));
    rewind.flyTo(step);
    return rewind.instant();
}

} // namespace berg
