#pragma once

#include "core/mission/recorder.h"
#include "core/plan/policy/planner.h"
#include "core/sim/intervention.h"

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

namespace berg {

/** Options of a flight that are not part of the scenario. */
struct MissionOptions
{
    std::optional<std::int64_t> workLimit; ///< work limit of each solve; the run stays repeatable
    /** Wall-clock limit of each solve, s; the run may not repeat. */
    std::optional<double> timeLimit_s;
    double gap = 0; ///< relative gap at which a solve may stop
    /** Start each solve from the rest of the last plan. */
    bool warmStart = true;
    bool record = true; ///< store samples, keyframes and all events
    double sampleInterval_s = 1;
    double keyframeInterval_s = 60;
    bool operator==(const MissionOptions&) const = default;
};

/** Figures by which runs are compared. */
struct Metrics
{
    double zeta_m2s = 0; ///< Eq. (24)
    int visits = 0;      ///< targets reached
    int replans = 0;     ///< plans made, the first included; a plan for several UAVs counts once
    double flown_m = 0;  ///< distance flown through the air, all UAVs
    bool operator==(const Metrics&) const = default;
};

/** Reason for which `Mission::advance` returned. */
enum class AdvanceStatus
{
    Reached,  ///< the requested time was reached
    Finished, ///< the run is complete
    Cancelled ///< a stop was requested
};

/**
 * The closed loop of `Simulation` and `Planner`. The result depends on scenario, options,
 * interventions and fixes only, not on how calls divide the time; a wall-clock limit on solves is
 * the one exception. Simulated time stands still during a solve. One thread at a time may use a
 * mission.
 */
class Mission
{
public:
    /**
     * Throws `Error{InvalidInput}` if `validate(scenario)` finds errors, and `Error{Unsupported}`
     * for policies and back ends missing in this build. `solver` replaces the scenario's back end.
     * `noise` is empty or the result of `drawNoise` for these icebergs (else `std::logic_error`)
     * and only saves time.
     */
    explicit Mission(const Scenario& scenario, const MissionOptions& options = {},
                     std::unique_ptr<TvpSolver> solver = nullptr,
                     std::span<const DriftNoise> noise = {});

    /**
     * Flies until `until_s` (rounded to a step) or the end of the run. Calls `onProgress(time_s)`
     * once per simulated second. After Cancelled the same call continues unchanged. Throws
     * `std::logic_error` inside a `NoBlockingScope`.
     */
    AdvanceStatus advance(double until_s, const std::stop_token& stop = {},
                          const std::function<void(double)>& onProgress = {});

    /**
     * Adds a pose of a real aircraft: from now on its UAV flies along the fixes instead of the
     * Dubins model (`PoseTracks::add`), except while it is on the ground. To fly with them, advance
     * no further than `poseTracks().knownUntil_s()`.
     */
    void addFix(const PoseFix& fix) { m_poseTracks.add(fix, m_simulation.time_s()); }
    /** Restores the fixes of a recorded run, before it is flown again. */
    void restoreFixes(std::span<const PoseFix> fixes) { m_poseTracks.restore(fixes); }
    [[nodiscard]] const PoseTracks& poseTracks() const { return m_poseTracks; }

    /**
     * Passes samples to `sink` from now on: `Recorder::streamTo`. The mission must keep a record,
     * else there are no samples.
     */
    void streamSamplesTo(SampleSink sink) { m_recorder.streamTo(std::move(sink)); }

    /**
     * Sets a function that is called on the flying thread with each better plan while a solve runs;
     * its status is Feasible.
     */
    void setIncumbentListener(std::function<void(PlanPointer)> listener);

    /**
     * Applies a change now and sets its `time_s` to the present time. A plan that is due is made
     * first, which may take a solve. Throws `Error{InvalidInput}` if the change leads to an invalid
     * scenario or names an iceberg that is not monitored or an unknown UAV; then nothing has
     * changed. Throws `Error{Unsupported}` as `Planner::setSettings` does; then only the plan that
     * was due has been made.
     */
    void intervene(Intervention intervention);

    [[nodiscard]] const Scenario& scenario() const { return m_scenario; }
    [[nodiscard]] const MissionOptions& options() const { return m_options; }
    [[nodiscard]] const Simulation& simulation() const { return m_simulation; }
    /** Returns the planner settings in force now, interventions applied. */
    [[nodiscard]] const PlannerSettings& plannerSettings() const { return m_planner.settings(); }
    [[nodiscard]] Metrics metrics() const;
    [[nodiscard]] const Recorder& recorder() const { return m_recorder; }
    [[nodiscard]] const std::vector<PlanPointer>& plans() const { return m_plans; }
    /** Returns the request of the last plan; null before the first. */
    [[nodiscard]] const std::shared_ptr<const PlanRequest>& lastRequest() const
    {
        return m_lastRequest;
    }
    [[nodiscard]] const std::vector<MissionEvent>& events() const { return m_events; }
    [[nodiscard]] const std::vector<Intervention>& interventions() const { return m_interventions; }
    /**
     * Returns the number of plans made before intervention `i`. Throws `std::out_of_range` if there
     * is no such intervention.
     */
    [[nodiscard]] std::size_t plansBefore(std::size_t i) const { return m_plansBefore.at(i); }
    /** Returns the icebergs of the scenario, then those added in flight, by index. */
    [[nodiscard]] const std::vector<Iceberg>& icebergs() const { return m_icebergs; }
    /**
     * Returns the number of targets that the UAV has reached. Throws `std::out_of_range` if there
     * is no such UAV.
     */
    [[nodiscard]] int visits(int uav) const { return m_visits.at(static_cast<std::size_t>(uav)); }

private:
    /** A finished plan that comes into force later. */
    struct PendingPlan
    {
        Plan plan;
        std::int64_t step = 0; ///< step at which it comes into force
    };
    [[nodiscard]] bool planWhenDue(const std::stop_token& stop);
    [[nodiscard]] bool planNow(const std::stop_token& stop);
    /** Returns false if a target has come into view since and was replaced. */
    [[nodiscard]] bool putPendingInForce();
    void putInForce(Plan plan);
    void activate(Plan plan);
    void flyOn();
    void flyOn(int uav);
    [[nodiscard]] bool isTargetOfOther(int uav, IcebergIndex iceberg) const;
    [[nodiscard]] IcebergList restOfPlan(int uav, PlanReason reason) const;
    void compareWithLast(Plan& plan) const;
    [[nodiscard]] ForecastStart forecastStart() const;
    void reportIncumbent(const SolveProgress& progress, const PlanRequest& request);
    void note(MissionEvent event);
    void noteStep();
    void noteEvents();
    void noteAlarms();
    void requireNames(const Intervention& intervention) const;
    void noteChanges(const Intervention& intervention);

    Scenario m_scenario;
    MissionOptions m_options;
    std::vector<Iceberg> m_icebergs;
    Simulation m_simulation;
    PoseTracks m_poseTracks;
    Planner m_planner;
    Recorder m_recorder;
    std::vector<PlanPointer> m_plans;
    std::optional<PendingPlan> m_pending;
    /** Reason for a plan that was due while another was pending. */
    PlanReason m_missed = PlanReason::None;
    /** Settings changed since the last plan; the next one gets the work limit of a first plan. */
    bool m_settingsChanged = false;
    std::shared_ptr<const PlanRequest> m_lastRequest;
    std::vector<MissionEvent> m_events;
    std::vector<Intervention> m_interventions;
    std::vector<std::size_t> m_plansBefore; ///< by intervention
    std::function<void(PlanPointer)> m_incumbentListener;
    std::vector<bool> m_alarmed; ///< by iceberg: predicted to enter the asset's inner ring
    std::vector<int> m_visits;   ///< by UAV
};

/**
 * Returns the plan that `Mission` flies at t = 0. Throws
 * `Error{InvalidInput}` if the scenario has errors, `Error{Unsupported}` for policies and back ends
 * missing in this build, and `std::logic_error` inside a `NoBlockingScope`.
 */
[[nodiscard]] Plan planFromStart(const Scenario& scenario, const SolveOptions& options = {});

} // namespace berg
