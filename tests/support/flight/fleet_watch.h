#pragma once

#include "core/checks/validate.h"
#include "core/io/export/content/export_flight.h"
#include "core/io/export/formats.h"
#include "core/io/files/run_json.h"
#include "core/mission/mission_instant.h"
#include "core/scenario/limits.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/flight/random_fleet.h"

#include <array>

namespace berg::test {

/** Faults that must not occur in a flight. */
enum class Fault
{
    Unsearched, ///< an iceberg is lost, all others are fresh, and nobody searches
    /**
     * A UAV circles although an unseen iceberg (with kept routes: one assigned to it) has no other
     * visitor.
     */
    Idle,
    Outside, ///< it left a fence that it could have kept
    /**
     * It returned late although a timely path existed; with separation: after the whole endurance,
     * see `reserves`.
     */
    Late,
    LookBack, ///< an instant of the record differs from the flight
    Replay,   ///< the run file does not repeat
    Export,   ///< a format cannot be written, or contains an invalid number
    Thrown
};
inline constexpr std::array kFaultNames{"unsearched", "idle",   "outside", "late",
                                        "look-back",  "replay", "export",  "thrown"};

struct FleetFaults
{
    std::array<int, kFaultNames.size()> seconds{}; ///< seconds, or occurrences, by `Fault`
    std::string first;                             ///< description of the first fault
    int losses = 0;
    int sorties = 0;
    int landings = 0;
    int reserves = 0; ///< landings that used part of the reserve because others were in the way

    void add(Fault fault, const std::string& where)
    {
        ++seconds[static_cast<std::size_t>(fault)];
        if (first.empty())
            first = std::string(kFaultNames[static_cast<std::size_t>(fault)]) + ": " + where;
    }
    [[nodiscard]] bool any() const
    {
        return std::ranges::any_of(seconds, [](int count) { return count > 0; });
    }
};

/** Flies a `RandomFleet` and checks it once a second. */
class FleetWatch
{
public:
    explicit FleetWatch(const RandomFleet& fleet)
        : m_fleet(fleet)
        , m_mission(fleet.scenario(), {.workLimit = 5'000})
        , m_idle_s(fleet.scenario().uavs.size())
    {
        for (const Issue& issue : validate(fleet.scenario()))
            m_isSafe = m_isSafe && issue.reason.id != IssueId::StartNearFence &&
                       issue.reason.id != IssueId::NoSafeReturn &&
                       issue.reason.id != IssueId::NoPathHome &&
                       issue.reason.id != IssueId::HomeNearFence;
    }

    [[nodiscard]] FleetFaults fly()
    {
        const double end_s = m_fleet.scenario().duration_s;
        const double kept_s = std::round(0.6 * end_s * 10) / 10 + 0.3;
        std::optional<WorldState> kept;
        for (double time_s = 1; time_s < end_s; time_s += 1) {
            if (!kept && time_s > kept_s) {
                m_mission.advance(kept_s);
                kept = m_mission.simulation().state();
            }
            m_mission.advance(time_s);
            for (const Intervention& change : m_fleet.changes())
                if (time_s == change.time_s)
                    intervene(change);
            watchLost(time_s);
            watchIdle(time_s);
        }
        m_mission.advance(end_s);
        countEvents();
        if (instantAt(m_mission, kept_s).simulation.state() != *kept)
            m_faults.add(Fault::LookBack, std::to_string(kept_s) + " s");
        if (m_fleet.scenario().seed % kFilesOfEach == 0)
            checkFiles();
        return m_faults;
    }

private:
    /** One in this many flights is replayed from its run file and exported. */
    static constexpr std::int64_t kFilesOfEach = 4;

    /** Planning time plus the rounding of whole seconds. */
    [[nodiscard]] double delay_s() const { return m_fleet.scenario().planningTime_s + 2; }
    [[nodiscard]] double round_s(int uav) const
    {
        const Motion& motion = m_mission.simulation().motion(uav);
        return 2 * kPi * circleRadius_m(motion) / motion.airspeed_mps;
    }
    [[nodiscard]] bool isTargeted(IcebergIndex iceberg) const
    {
        return std::ranges::any_of(m_mission.simulation().fleet().autopilots(),
                                   [iceberg](const Autopilot& uav) {
                                       const FlightTarget* flightTarget = uav.flightTarget();
                                       return uav.target() == iceberg ||
                                              (flightTarget != nullptr &&
                                               std::ranges::find(flightTarget->members, iceberg) !=
                                                   flightTarget->members.end());
                                   });
    }

    void intervene(const Intervention& change)
    {
        try {
            m_mission.intervene(change);
        } catch (const Error&) {
            return; // for example, an iceberg that has left
        }
        m_isSafe = m_isSafe && !change.wind_mps;
    }
    /** Returns the whole endurance, s. */
    [[nodiscard]] double endurance_s(int uav) const
    {
        const double endurance_s = m_fleet.scenario().uavs[toIndex(uav)].spec.endurance_s;
        return endurance_s > 0 ? endurance_s : std::numeric_limits<double>::infinity();
    }
    [[nodiscard]] bool isKeptApart(int uav) const
    {
        const std::vector<Uav>& uavs = m_fleet.scenario().uavs;
        const auto shares = [&](const Uav& other) {
            return std::abs(other.spec.altitude_m - uavs[toIndex(uav)].spec.altitude_m) <
                   kLayerHeight_m;
        };
        return m_fleet.scenario().separation_m > 0 && std::ranges::count_if(uavs, shares) > 1;
    }

    /**
     * Returns whether a UAV may search for the iceberg, can return from there, and has no other
     * search.
     */
    [[nodiscard]] bool hasSearcher(IcebergIndex iceberg) const
    {
        const Simulation& now = m_mission.simulation();
        const std::optional<int>& assigned = now.world().parameters(iceberg).assignedUav;
        for (int uav = 0; uav < now.uavCount(); ++uav)
            if (const Autopilot& me = now.fleet().autopilot(uav);
                me.isPlanned() && !now.observer().searches().of(uav) &&
                (!assigned || assigned == uav) &&
                thisSortie(me, std::span(&iceberg, 1), now.observer()).value_or(1) == 1)
                return true;
        return false;
    }
    [[nodiscard]] bool isSearched(IcebergIndex iceberg) const
    {
        const Simulation& now = m_mission.simulation();
        for (int uav = 0; uav < now.uavCount(); ++uav)
            if (const std::optional<Search>& search = now.observer().searches().of(uav))
                if (search->iceberg == iceberg)
                    return true;
        return false;
    }

    /**
     * Counts rounds without a search: every other iceberg was seen since the search was abandoned,
     * and a UAV has had time to fly a circle.
     */
    void watchLost(double time_s)
    {
        const Simulation& now = m_mission.simulation();
        m_since_s.resize(static_cast<std::size_t>(now.icebergCount()), -1);
        for (const IcebergIndex i : now.icebergs()) {
            double& since_s = m_since_s[toIndex(i)];
            const bool isAlone = now.active(i) && now.track(i).status != TrackStatus::Tracked &&
                                 !isSearched(i) && hasSearcher(i);
            if (!isAlone) {
                since_s = -1;
                continue;
            }
            if (since_s < 0)
                since_s = time_s;
            bool isRound = time_s - since_s > round_s(0) + delay_s();
            for (const IcebergIndex other : now.icebergs())
                isRound = isRound &&
                          (!now.active(other) || now.track(other).status != TrackStatus::Tracked ||
                           now.track(other).inView || now.track(other).seen_s > since_s);
            if (isRound)
                m_faults.add(Fault::Unsearched,
                             std::to_string(i.number()) + " at " + std::to_string(time_s));
        }
    }

    void watchIdle(double time_s)
    {
        const bool keepsRoute = traitsOf(m_mission.plannerSettings().policy).keepsRoute();
        const Simulation& now = m_mission.simulation();
        for (int uav = 0; uav < now.uavCount(); ++uav) {
            const Autopilot& me = now.fleet().autopilot(uav);
            std::optional<IcebergIndex> beside;
            for (const IcebergIndex i : now.icebergs())
                if (!beside && now.available(uav, i) && !isTargeted(i) &&
                    time_s - now.track(i).seen_s > round_s(uav) &&
                    (!keepsRoute || now.world().parameters(i).assignedUav == uav))
                    beside = i;
            double& idle_s = m_idle_s[static_cast<std::size_t>(uav)];
            const bool isIdle =
                !me.target() && me.isPlanned() && me.mode() != FlightMode::Search && beside;
            idle_s = isIdle ? idle_s + 1 : 0;
            if (idle_s > 2 * delay_s())
                m_faults.add(Fault::Idle, std::to_string(uav) + " beside " +
                                              std::to_string(beside->number()) + " at " +
                                              std::to_string(time_s));
        }
    }

    void countEvents()
    {
        std::vector<double> since_s(m_fleet.scenario().uavs.size());
        for (const MissionEvent& event : m_mission.events()) {
            m_faults.losses += event.kind == EventKind::Lost ? 1 : 0;
            m_faults.sorties += event.kind == EventKind::TookOff ? 1 : 0;
            if (m_isSafe && event.kind == EventKind::LeftFence)
                m_faults.add(Fault::Outside, std::to_string(event.time_s));
            m_faults.landings += event.kind == EventKind::Landed ? 1 : 0;
            if (event.kind == EventKind::TookOff)
                since_s[toIndex(*event.uav)] = event.time_s;
            if (!m_isSafe || (event.kind != EventKind::LateHome && event.kind != EventKind::Landed))
                continue;
            if (event.kind == EventKind::LateHome && isKeptApart(*event.uav))
                ++m_faults.reserves;
            else if (event.kind == EventKind::LateHome ||
                     event.time_s - since_s[toIndex(*event.uav)] > endurance_s(*event.uav))
                m_faults.add(Fault::Late, std::to_string(event.time_s));
        }
    }

    void checkFiles()
    {
        const RunFile run = runFromJson(runToJson(runOf(m_mission)), "run");
        for (const Issue& issue : compareRun(run, runOf(replay(run))))
            m_faults.add(Fault::Replay, issue.field + ' ' + issue.message());
        const Plan& plan = *m_mission.plans().front();
        for (const ExportFormat& format : exportFormats()) {
            if (format.holds.painted || format.id == "sightings") // which need a start time
                continue;
            for (const Uav& uav : m_fleet.scenario().uavs) {
                const std::string text =
                    format.write({m_fleet.scenario(), plan, &m_mission}, {.uav = uav.id});
                if (text.empty())
                    m_faults.add(Fault::Export, std::string(format.id));
            }
        }
    }

    const RandomFleet& m_fleet;
    Mission m_mission;
    bool m_isSafe = true; ///< whether it can keep its fence and return in time
    FleetFaults m_faults;
    /** By iceberg: start of being lost and unsearched; negative if it is not. */
    std::vector<double> m_since_s;
    std::vector<double> m_idle_s; ///< idle time by UAV
};

[[nodiscard]] inline FleetFaults faultsOf(std::uint64_t seed, bool isChanging = false)
{
    try {
        const RandomFleet fleet =
            isChanging ? RandomFleet::withChangingVelocities(seed) : RandomFleet(seed);
        return FleetWatch(fleet).fly();
    } catch (const std::exception& failure) {
        FleetFaults faults;
        faults.add(Fault::Thrown, failure.what());
        return faults;
    }
}

} // namespace berg::test
