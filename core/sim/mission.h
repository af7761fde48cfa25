#pragma once

#include "core/plan/policy/planner.h"
#include "core/sim/intervention.h"
#include "core/sim/recorder.h"

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

namespace berg {

/** How a mission is flown beyond what the scenario says. */
struct MissionOptions
{
    std::optional<std::int64_t> workLimit; ///< of each solve; the run stays repeatable
    std::optional<double> timeLimit_s;     ///< of each solve; the run may not repeat
    double gap = 0;                        ///< relative gap at which a solve may stop
    bool warmStart = true;
    bool record = true; ///< keep samples, keyframes and all events
    double sampleInterval_s = 1;
    double keyframeInterval_s = 60;
    bool operator==(const MissionOptions&) const = default;
};

/** The numbers a run is judged by. */
struct Metrics
{
    double zeta_m2s = 0; ///< Eq. (24)
    int visits = 0;      ///< targets reached
    int replans = 0;     ///< plans made, the first included; of several UAVs one for all
    double flown_m = 0;  ///< through the air, all UAVs
    bool operator==(const Metrics&) const = default;
};

enum class AdvanceStatus
{
    Reached,
    Finished,
    Cancelled
};

/**
 * The closed loop: `Simulation` and `Planner`. The result depends on scenario, options and
 * interventions only, not on how the time is sliced. Simulated time stands still during a solve.
 * Used by one thread at a time.
 */
class Mission
{
public:
    /**
     * Throws `Error{InvalidInput}` when `validate(scenario)` finds errors and `Error{Unsupported}`
     * for policies and back ends this build lacks. `solver` replaces the scenario's back end;
     * `noise` is empty or what `drawNoise` gave for this field of icebergs: it only saves time.
     */
    explicit Mission(const Scenario& scenario, const MissionOptions& options = {},
                     std::unique_ptr<TvpSolver> solver = nullptr,
                     std::span<const DriftNoise> noise = {});

    /**
     * Flies until `until_s` (rounded to a step) or the end of the run. `onProgress(time_s)` is
     * called about once per simulated second. After Cancelled the same call carries on unchanged.
     */
    AdvanceStatus advance(double until_s, const std::stop_token& stop = {},
                          const std::function<void(double)>& onProgress = {});

    /** Of a mission with a record: `Recorder::handOn`. */
    void handSamplesOn(SampleSink sink) { m_recorder.handOn(std::move(sink)); }

    /** Told of each better order while a solve runs, on the flying thread; `status` is Feasible. Of
     * several UAVs for each of them, `sameSolve` from the second on. */
    void setIncumbentListener(std::function<void(const PlanEvent&)> listener);

    /**
     * Applies the change now; its `time_s` is set to the present time. A plan that is due is made
     * first. Throws as the constructor; then nothing has changed.
     */
    void intervene(Intervention intervention);

    [[nodiscard]] const Scenario& scenario() const { return m_scenario; }
    [[nodiscard]] const MissionOptions& options() const { return m_options; }
    [[nodiscard]] const Simulation& simulation() const { return m_simulation; }
    /** In force now, interventions applied. */
    [[nodiscard]] const PlannerSettings& plannerSettings() const { return m_planner.settings(); }
    [[nodiscard]] Metrics metrics() const;
    [[nodiscard]] const Recorder& recorder() const { return m_recorder; }
    [[nodiscard]] const std::vector<PlanEvent>& plans() const { return m_plans; }
    /** What the last of the plans was asked for; null: none yet. */
    [[nodiscard]] const std::shared_ptr<const PlanRequest>& lastRequest() const
    {
        return m_lastRequest;
    }
    [[nodiscard]] const std::vector<MissionEvent>& events() const { return m_events; }
    [[nodiscard]] const std::vector<Intervention>& interventions() const { return m_interventions; }
    /** So many plans had been made when intervention `i` came. */
    [[nodiscard]] std::size_t plansBefore(std::size_t i) const { return m_plansBefore.at(i); }
    /** Icebergs of the scenario and those added in flight, by index. */
    [[nodiscard]] const std::vector<Iceberg>& icebergs() const { return m_icebergs; }
    /** Targets that the UAV has reached. */
    [[nodiscard]] int visits(int uav) const { return m_visits.at(static_cast<std::size_t>(uav)); }

private:
    /** Of one re-planning, one for each UAV that is planned. */
    using Round = std::vector<PlanEvent>;
    /** A plan that is made, but not in force before its time. */
    struct PendingPlan
    {
        Round plans;
        std::int64_t step = 0; ///< from which on it is in force
    };
    [[nodiscard]] bool planWhenDue(const std::stop_token& stop);
    [[nodiscard]] bool planNow(const std::stop_token& stop);
    /** False: it is overtaken by what has come into view since. */
    [[nodiscard]] bool putPendingInForce();
    void putInForce(Round plans);
    void tell(PlanEvent plan);
    void flyOn();
    void flyOn(int uav);
    [[nodiscard]] bool isTargetOfOther(int uav, int iceberg) const;
    [[nodiscard]] std::vector<int> restOfPlan(int uav, PlanReason reason) const;
    void compareWithLast(Round& plans) const;
    [[nodiscard]] ForecastStart forecastStart() const;
    void reportIncumbent(const SolveProgress& progress, const PlanRequest& request);
    void note(MissionEvent event);
    void noteStep();
    void noteEvents();
    void noteAlarms();
    void requireAppeared(const std::string& iceberg, const char* field) const;
    void requireUav(const std::string& uav, const char* field) const;
    void noteChanges(const Intervention& intervention);

    Scenario m_scenario;
    MissionOptions m_options;
    std::vector<Iceberg> m_icebergs;
    Simulation m_simulation;
    Planner m_planner;
    Recorder m_recorder;
    std::vector<PlanEvent> m_plans;
    std::optional<PendingPlan> m_pending;
    PlanReason m_missed = PlanReason::None; ///< another plan was needed while one was pending
    bool m_settingsChanged = false; ///< since the last plan: the next one has a first plan's work
    std::shared_ptr<const PlanRequest> m_lastRequest;
    std::vector<MissionEvent> m_events;
    std::vector<Intervention> m_interventions;
    std::vector<std::size_t> m_plansBefore; ///< by intervention
    std::function<void(const PlanEvent&)> m_incumbentListener;
    std::vector<bool> m_alarmed; ///< by iceberg: on its way into the asset's inner ring
    std::vector<int> m_visits;   ///< by UAV
};

/** The plan a scenario starts with, ids = iceberg indices: what `Mission` flies at t = 0. */
[[nodiscard]] PlanAnswer planFromStart(const Scenario& scenario, const SolveOptions& options = {});

} // namespace berg
