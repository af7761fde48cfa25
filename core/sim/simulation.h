#pragma once

#include "core/coverage/flight_picture.h"
#include "core/scenario/priority.h"
#include "core/tracking/drift.h"
#include "core/tracking/lost_search.h"
#include "core/vehicle/los_guidance.h"
#include "core/vehicle/way_home.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace berg {

class Geofence;

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
    Overdue, ///< on such a leg: the sighting predicted has not come
    Left,    ///< an iceberg has left the area
    Lost,    ///< one was not where it should have been
    Found,   ///< a lost one is in view
    GivenUp, ///< the search for one has ended without it
    TakeOff  ///< the next sortie begins
};

/** What the log of a mission names. */
enum class EventKind
{
    Planned,
    Reached,
    Sighted,
    Appeared,
    PlannerFailed, ///< it threw; the last plan is flown on
    Alarm,         ///< found to be on its way into the inner ring of the asset
    Intervention,
    Left, ///< the area
    Lost,
    Found,
    GivenUp,
    HomeBound,
    Landed,
    TookOff,
    LateHome ///< the wind has changed: home cannot be reached in time any more
};

/** Something of the last step that the log should name. */
struct News
{
    EventKind kind = EventKind::Appeared;
    int iceberg = -1; ///< -1: none in particular
};

/** What the autopilot is doing. */
enum class FlightMode
{
    Idle,   ///< no iceberg at all: holding
    Leg,    ///< to the target
    RunOut, ///< passed a target too close to turn onto: straight on before turning back
    Circle, ///< every iceberg in view: round the last one reached
    Search, ///< for a lost iceberg
    Home,   ///< on the way home
    Ground  ///< at home between two sorties
};

/** The search for a lost iceberg. */
struct Search
{
    int iceberg = -1;
    LostSearch way;
    bool operator==(const Search&) const = default;
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
    std::vector<int> members;    ///< the target is the middle of these; empty: it is one iceberg
    double membersBy_s = 0;      ///< when they are overdue
    std::vector<int> apart;      ///< in no cluster until seen: one was passed without them
    std::optional<Search> search;
    double aloft_s = 0;         ///< since take-off
    double ground_s = 0;        ///< left to stand in mode Ground
    std::optional<Point> via_m; ///< corner flown to, round which the geofence leads
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
    /** Whether the iceberg is monitored: it has appeared and has not left the area. */
    [[nodiscard]] bool active(int iceberg) const;
    /** Whether it may be planned: active, not lost, outside the field of view, not within reach. */
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

    /** On its way home or on the ground: no plan is asked for or taken. */
    [[nodiscard]] bool homeward() const
    {
        return m_state.mode == FlightMode::Home || m_state.mode == FlightMode::Ground;
    }
    /** None: unlimited endurance, the UAV never lands. */
    [[nodiscard]] const std::optional<SortieSpec>& sortie() const { return m_sortie; }
    /**
     * Endurance left when it would be home, flying there at once; none: unlimited, or on the
     * ground. Below 0: home cannot be reached in time any more.
     */
    [[nodiscard]] std::optional<double> homeMargin_s() const;
    /**
     * How many icebergs of this order, from its start, can be visited before home must be reached;
     * none: unlimited.
     */
    [[nodiscard]] std::optional<int> thisSortie(std::span<const int> order) const;
    /** What the UAV stays inside; null: nothing. */
    [[nodiscard]] const std::shared_ptr<const Geofence>& fence() const { return m_fence; }

    /** Why a plan is needed now; None: fly on. */
    [[nodiscard]] PlanReason planReason() const { return m_planReason; }

    /**
     * Distances over ground (air distances in wind) and sigmas of the active icebergs, times their
     * priorities.
     */
    [[nodiscard]] PlanRequest planRequest() const;
    /**
     * The same with the available icebergs that one view can cover as one node, where the scenario
     * asks for that: `PlanRequest::clusters`. Its `picture` is still that of single icebergs.
     */
    [[nodiscard]] PlanRequest clusteredRequest() const;
    /** Whether it may be planned as one of a cluster. */
    [[nodiscard]] bool clusterable(int iceberg) const;

    /**
     * Fly to this iceberg from here; -1: none available, circle the last one reached. With an aim:
     * along it until something comes into view. With members of a cluster, the iceberg one of them:
     * to the middle of the circle round their estimates, reached when all of them are at once.
     */
    void setTarget(int iceberg, const std::optional<AimedLeg>& aim = std::nullopt,
                   std::span<const int> members = {});
    /** Where the target is believed to be, the middle of a cluster; there must be one. */
    [[nodiscard]] Point targetPlace_m() const;

    /** Advances one dt. Must not be called while a plan is needed or when finished. */
    void advanceStep();

    [[nodiscard]] const Motion& motion() const { return m_motion; }
    [[nodiscard]] const std::optional<Asset>& asset() const { return m_asset; }
    /** The wind is this from now on, and a new plan is needed. */
    void setWind(const Point& wind_mps);
    /** What is to be protected from now on; a new plan is needed. */
    void setAsset(const Asset& asset);

    /** Something changed from outside (tau, policy): a new plan is needed now. */
    void requestPlan() { needPlan(PlanReason::Intervention); }

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
    /** What else happened since this was asked last. */
    [[nodiscard]] std::vector<News> takeNews() { return std::exchange(m_news, {}); }

private:
    [[nodiscard]] static std::size_t index(int i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] FieldOfView fieldOfView() const;
    [[nodiscard]] bool withinReach(int iceberg) const;
    [[nodiscard]] int nearest(bool (Simulation::*counts)(int) const) const;
    [[nodiscard]] bool isReached(int iceberg) const;
    [[nodiscard]] bool targetReached() const;
    [[nodiscard]] PlanRequest withClusters(PlanRequest single,
                                           std::vector<std::vector<int>> clusters) const;
    [[nodiscard]] Point middleOf_m(std::span<const int> members) const;
    void setMembers(std::span<const int> members);
    void updateClusters();
    [[nodiscard]] Eigen::MatrixXd legLengths_m(std::span<const Point> places_m) const;
    /** `start_s`: when the iceberg is at its `position_m`; `appearsStep`: known from then on. */
    void insert(const Iceberg& iceberg, DriftNoise noise, double start_s, std::int64_t appearsStep);
    void observe(double dt_s);
    void lookAround(double now_s);
    /** Of this step: held between two commands of the autopilot. */
    [[nodiscard]] double commanded();
    void look(std::size_t iceberg, double now_s, std::optional<FieldOfView>& view);
    void observeFiltered(double now_s, double dt_s);
    void lookForMeasurements(double now_s);
    void measure(std::size_t iceberg, const Point& measured_m, double now_s);
    void miss(std::size_t iceberg, const FieldOfView& view, const FieldOfView& middle);
    void lose(std::size_t iceberg, const FieldOfView& view);
    void giveUpSearch();
    void beginOrEndSearch();
    void watchArea();
    [[nodiscard]] bool appeared(int iceberg) const;
    [[nodiscard]] PlanReason reasonOfNews() const;
    [[nodiscard]] bool isWorthSearching() const;
    [[nodiscard]] double steerSearch();
    [[nodiscard]] std::int64_t firstStepInReach(const DriftModel& drift, double away_m) const;
    [[nodiscard]] double steer();
    [[nodiscard]] double steerLeg();
    [[nodiscard]] double steerAim();
    [[nodiscard]] double steerCluster();
    [[nodiscard]] double steerRunOut();
    [[nodiscard]] double steerCircle();
    [[nodiscard]] double steerHome();
    /** Towards the corner that the geofence leads round on the way there; none: it does not. */
    [[nodiscard]] std::optional<double> steerRoundFence(const Point& end_m);
    /** Unless it is homeward. */
    void needPlan(PlanReason reason);
    /** As `available`, whether or not the endurance allows it. */
    [[nodiscard]] bool visitable(int iceberg) const;
    [[nodiscard]] bool affordable(int iceberg) const;
    [[nodiscard]] std::optional<Way> wayTo(const DubinsState& from, const Point& place_m,
                                           const Point& drift_mps) const;
    [[nodiscard]] std::optional<double> timeHome_s(const DubinsState& from) const;
    [[nodiscard]] DubinsState heldFor(double u_radps, std::int64_t steps) const;
    [[nodiscard]] double enduranceLeft_s() const;
    [[nodiscard]] bool homeInTimeAfter(double u_radps) const;
    [[nodiscard]] bool nothingAffordable() const;
    void goHome();
    void takeOffWhenDue();
    void advanceSortie(const Point& from_m);
    [[nodiscard]] double roomAfter_m(double u_radps) const;
    [[nodiscard]] double guarded(double u_radps) const;
    void buildFence();
    void updatePlanReason();
    void updatePlanReasonOfAim();

    // What the scenario says.
    Motion m_motion;
    SensorSpec m_sensor;
    std::optional<double> m_reachRadius_m;
    bool m_clusters;
    std::optional<Asset> m_asset;
    std::vector<Point> m_area_m; ///< empty: unbounded
    ObserverSpec m_observer;
    Point m_current_mps;
    double m_dt_s;
    std::optional<SortieSpec> m_sortie;
    std::shared_ptr<const Geofence> m_fence;
    std::int64_t m_autopilotSteps; ///< between two commands of the autopilot
    double m_command_s;            ///< the same in seconds
    std::int64_t m_lastStep;
    std::int64_t m_stepsPerSecond;
    std::uint64_t m_seed;
    bool m_noise;
    double m_reach_m; ///< of the field of view
    double m_turnRadius_m;
    bool m_needsRunOut; ///< reach smaller than the turn radius: see FlightMode::RunOut

    std::int64_t m_lookSteps; ///< between two looks of the camera, with measurements

    /** What does not change about an iceberg. */
    struct Body
    {
        std::uint64_t stream = 0; ///< of its random numbers
        double radius_m = 0;
        Point velocity_mps = Point::Zero(); ///< as given
        double velocity_m2ps2 = 0;          ///< variance of that
    };
    std::vector<Body> m_bodies;
    std::vector<DriftModel> m_drift;
    std::vector<std::int64_t> m_appearsStep;
    std::vector<std::int64_t> m_lookStep; ///< before this step it is surely out of view
    std::int64_t m_nextLookStep = 0;      ///< first of them
    WorldState m_state;
    std::vector<int> m_newlySeen;
    std::vector<int> m_newlyAppeared;
    std::vector<News> m_news;
    PlanReason m_planReason = PlanReason::Start;
};

} // namespace berg
