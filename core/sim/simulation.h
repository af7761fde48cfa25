#pragma once

#include "core/coverage/flight_picture.h"
#include "core/scenario/priority.h"
#include "core/tracking/drift.h"
#include "core/vehicle/los_guidance.h"

#include <cstdint>
#include <span>
#include <vector>

namespace berg {

/** Why a plan is needed at this instant. */
enum class PlanReason
{
    None,
    Start,
    TargetReached,
    OutOfView,
    Appeared,
    Intervention,
    Sighted, ///< on a leg with an aim: another iceberg than the target came into view
    Overdue  ///< on such a leg: the sighting predicted has not come
};

/** What the autopilot is doing. */
enum class FlightMode
{
    Idle,   ///< no iceberg at all: holding
    Leg,    ///< to the target
    RunOut, ///< passed a target too close to turn onto: straight on before turning back
    Circle  ///< every iceberg in view: round the last one reached
};

/** Everything that changes while flying: enough to continue from here, bit for bit. */
struct WorldState
{
    std::int64_t step = 0;
    DubinsState uav;
    double u_radps = 0;
    double crossTrack_m = 0;
    std::vector<Track> tracks; ///< one per iceberg of the scenario, the not yet appeared included
    double sigmaSum_m2 = 0;
    double zeta_m2s = 0;
    double flown_m = 0; ///< through the air
    FlightMode mode = FlightMode::Idle;
    int target = -1; ///< index into the icebergs; -1: none
    int lastReached = -1;
    LosGuidance guidance;
    double runOut_m = 0;         ///< left to fly straight in mode RunOut
    int misses = 0;              ///< times the target was passed without reaching it
    std::optional<AimedLeg> aim; ///< flown in mode Leg instead of the way to the target's estimate
    bool operator==(const WorldState&) const = default;
};

/**
 * The noise of each iceberg of the scenario, in its order: to be drawn once for all simulations of
 * scenarios that differ in planner or duration alone. Holds 32 MB at most; of long runs with many
 * icebergs each simulation draws the end by itself.
 */
[[nodiscard]] std::vector<DriftNoise> drawNoise(const Scenario& scenario);

/**
 * One deterministic world: icebergs, estimates, UAV and autopilot advanced with a fixed time step.
 * It holds no planner: it says when a plan is needed (`needsPlan`) and is told the next target.
 * One step, in this order: true drift, estimates, guidance, Dubins step, field of view and sigma
 * (22)-(23), zeta (24). Flies the first UAV of the scenario. Not thread-safe; copyable, so that
 * any instant can be kept and continued.
 */
class Simulation
{
public:
    /**
     * The scenario must have no errors (`validate`). Time 0: field of view tested, plan needed.
     * `noise` is empty or what `drawNoise` gave; it only saves time.
     */
    explicit Simulation(const Scenario& scenario, std::span<const DriftNoise> noise = {});

    [[nodiscard]] double time_s() const { return static_cast<double>(m_state.step) * m_dt_s; }
    [[nodiscard]] double dt_s() const { return m_dt_s; }
    [[nodiscard]] std::int64_t lastStep() const { return m_lastStep; }
    [[nodiscard]] bool finished() const { return m_state.step >= m_lastStep; }
    [[nodiscard]] const WorldState& state() const { return m_state; }

    [[nodiscard]] int icebergCount() const { return static_cast<int>(m_state.tracks.size()); }
    /** Whether the iceberg has appeared. */
    [[nodiscard]] bool active(int iceberg) const;
    /** Whether it may be planned: active, outside the field of view, not within reach. */
    [[nodiscard]] bool available(int iceberg) const;
    /** True position; before it has appeared, that at its start. */
    [[nodiscard]] Point truth_m(int iceberg) const;
    /** By its estimate; the first one among equals, -1: none is available. */
    [[nodiscard]] int nearestAvailable() const;
    [[nodiscard]] Point estimate_m(int iceberg) const;
    /** What multiplies its sigma in planning: above 1 where an asset is near. */
    [[nodiscard]] double priority(int iceberg) const;
    /** Seen from the asset, by the estimate; none without an asset. */
    [[nodiscard]] std::optional<RelativeMotion> relativeToAsset(int iceberg) const;
    [[nodiscard]] const Track& track(int iceberg) const { return m_state.tracks[index(iceberg)]; }

    /** Why a plan is needed now; None: fly on. */
    [[nodiscard]] PlanReason planReason() const { return m_planReason; }

    /**
     * Distances over ground (air distances in wind) and sigmas of the active icebergs, times their
     * priorities.
     */
    [[nodiscard]] PlanRequest planRequest() const;

    /**
     * Fly to this iceberg from here; -1: none available, circle the last one reached. With an aim:
     * along it until something comes into view.
     */
    void setTarget(int iceberg, const std::optional<AimedLeg>& aim = std::nullopt);

    /** Advances one dt. Must not be called while a plan is needed or when finished. */
    void advanceStep();

    [[nodiscard]] const Motion& motion() const { return m_motion; }
    [[nodiscard]] const std::optional<Asset>& asset() const { return m_asset; }
    /** The wind is this from now on, and a new plan is needed. */
    void setWind(const Point& wind_mps);
    /** What is to be protected from now on; a new plan is needed. */
    void setAsset(const Asset& asset);

    /** Something changed from outside (tau, policy): a new plan is needed now. */
    void requestPlan() { m_planReason = PlanReason::Intervention; }

    /**
     * An iceberg that has appeared is reported by somebody else: its position is known now as if it
     * were in view, and a new plan is needed.
     */
    void reportSighting(int iceberg);

    /** Adds an iceberg that appears now; its index is the new last one. */
    void addIceberg(const Iceberg& iceberg);

    /** Icebergs that came into view in the last step, by index, ascending. */
    [[nodiscard]] std::span<const int> newlySeen() const { return m_newlySeen; }
    /** Icebergs that appeared in the last step. */
    [[nodiscard]] std::span<const int> newlyAppeared() const { return m_newlyAppeared; }

private:
    [[nodiscard]] static std::size_t index(int i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] FieldOfView fieldOfView() const;
    [[nodiscard]] bool withinReach(int iceberg) const;
    [[nodiscard]] int nearest(bool (Simulation::*counts)(int) const) const;
    /** `start_s`: when the iceberg is at its `position_m`; `appearsStep`: known from then on. */
    void insert(const Iceberg& iceberg, DriftNoise noise, double start_s, std::int64_t appearsStep);
    void observe(double dt_s);
    void lookAround(double now_s);
    /** Of this step: held between two commands of the autopilot. */
    [[nodiscard]] double commanded();
    void look(std::size_t iceberg, double now_s, std::optional<FieldOfView>& view);
    [[nodiscard]] std::int64_t firstStepInReach(const DriftModel& drift, double away_m) const;
    [[nodiscard]] double steer();
    [[nodiscard]] double steerLeg();
    [[nodiscard]] double steerAim();
    [[nodiscard]] double steerRunOut();
    [[nodiscard]] double steerCircle();
    void updatePlanReason();
    void updatePlanReasonOfAim();

    // What the scenario says.
    Motion m_motion;
    SensorSpec m_sensor;
    std::optional<double> m_reachRadius_m;
    std::optional<Asset> m_asset;
    Point m_current_mps;
    double m_dt_s;
    std::int64_t m_autopilotSteps; ///< between two commands of the autopilot
    double m_command_s;            ///< the same in seconds
    std::int64_t m_lastStep;
    std::int64_t m_stepsPerSecond;
    std::uint64_t m_seed;
    bool m_noise;
    double m_reach_m; ///< of the field of view
    double m_turnRadius_m;
    bool m_needsRunOut; ///< reach smaller than the turn radius: see FlightMode::RunOut

    std::vector<DriftModel> m_drift;
    std::vector<std::int64_t> m_appearsStep;
    std::vector<std::int64_t> m_lookStep; ///< before this step it is surely out of view
    std::int64_t m_nextLookStep = 0;      ///< first of them
    WorldState m_state;
    std::vector<int> m_newlySeen;
    std::vector<int> m_newlyAppeared;
    PlanReason m_planReason = PlanReason::Start;
};

} // namespace berg
