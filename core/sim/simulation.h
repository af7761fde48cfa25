#pragma once

#include "core/coverage/flight_picture.h"
#include "core/scenario/priority.h"
#include "core/sim/mission_event.h"
#include "core/tracking/drift.h"
#include "core/tracking/lost_search.h"
#include "core/vehicle/los_guidance.h"
#include "core/vehicle/safety_guard.h"

#include <cstdint>
#include <span>
#include <utility>
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
    Sighted,     ///< on a leg with an aim: another iceberg than the target came into view
    Overdue,     ///< on such a leg: the sighting predicted has not come
    Left,        ///< an iceberg has left the area
    Lost,        ///< one was not where it should have been
    Found,       ///< a lost one is in view
    GivenUp,     ///< the search for one has ended without it
    TakeOff,     ///< the next sortie begins
    SeenByOther, ///< another UAV has the target in view
    Fleet        ///< another UAV needs one
};

/** An iceberg that has come into view. */
struct SeenIceberg
{
    int iceberg = -1;
    int uav = -1; ///< the first one that has it in view; -1: reported by somebody else
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

/** What changes about one UAV. */
struct UavState
{
    DubinsState pose;
    double u_radps = 0;
    double crossTrack_m = 0;
    double flown_m = 0; ///< through the air
    FlightMode mode = FlightMode::Idle;
    int target = -1; ///< index into the icebergs; -1: none
    int lastReached = -1;
    bool isAlone = false; ///< planned by itself until all are planned again: see `plannedUavs`
    LosGuidance guidance;
    double runOut_m = 0;         ///< left to fly straight in mode RunOut
    int misses = 0;              ///< times the target was passed without reaching it
    std::optional<AimedLeg> aim; ///< flown in mode Leg instead of the way to the target's estimate
    std::vector<int> members;    ///< the target is the middle of these; empty: it is one iceberg
    double membersBy_s = 0;      ///< when they are overdue
    std::optional<Search> search;
    double aloft_s = 0;         ///< since take-off
    double ground_s = 0;        ///< left to stand in mode Ground
    std::optional<Point> via_m; ///< corner flown to, round which the geofence leads
    /** With fence and endurance: a proven path home from the next command on. */
    std::optional<ReturnPath> returnPath;

    /** On its way home or on the ground: no plan is asked for or taken. */
    [[nodiscard]] bool homeward() const
    {
        return mode == FlightMode::Home || mode == FlightMode::Ground;
    }
    bool operator==(const UavState&) const = default;
};

/** Everything that changes while flying: enough to continue from here, bit for bit. */
struct WorldState
{
    std::int64_t step = 0;
    std::vector<UavState> uavs; ///< one per UAV of the scenario
    std::vector<Track> tracks;  ///< one per iceberg of the scenario, the not yet appeared included
    double sigmaSum_m2 = 0;
    double zeta_m2s = 0;
    std::vector<int> apart; ///< in no cluster until seen: one was passed without them
    /** Of icebergs given up: where they may be, for when the rest is fresh. */
    std::vector<Search> givenUp;
    /** Least horizontal distance so far of two UAVs aloft in one altitude layer. */
    std::optional<double> closest_m;

    /** Through the air, all UAVs. */
    [[nodiscard]] double flown_m() const;
    bool operator==(const WorldState&) const = default;
};

/**
 * The noise of each iceberg of the scenario, in its order: to be drawn once for all simulations of
 * scenarios that differ in planner or duration alone. Holds 32 MB at most; of long runs with many
 * icebergs each simulation draws the end by itself.
 */
[[nodiscard]] std::vector<DriftNoise> drawNoise(const Scenario& scenario);

/**
 * One deterministic world: icebergs, estimates, UAVs and autopilots advanced with a fixed time
 * step. It holds no planner: it says when a plan is needed (`planReason`) and is told the next
 * target of each UAV. One step, in this order: true drift, estimates, guidance, Dubins step, field
 * of view and sigma (22)-(23), zeta (24). UAVs are numbered as in the scenario; an iceberg is in
 * view when it is in that of one of them. Not thread-safe; copyable, so that any instant can be
 * kept and continued.
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
    /** Whether it may be planned for the UAV: active, not lost, in no field of view, not within
     * reach, not kept for another one, and within its endurance. */
    [[nodiscard]] bool available(int uav, int iceberg) const;
    [[nodiscard]] int uavCount() const { return static_cast<int>(m_crafts.size()); }
    /** The UAV that alone is to visit it; -1: any. */
    [[nodiscard]] int assignedTo(int iceberg) const { return m_assigned[index(iceberg)]; }
    /** True position; before it has appeared, that at its start. */
    [[nodiscard]] Point truth_m(int iceberg) const;
    /** By its estimate; the first one among equals, -1: none is available. */
    [[nodiscard]] int nearestAvailable(int uav) const;
    [[nodiscard]] Point estimate_m(int iceberg) const;
    /** What multiplies its sigma in planning: above 1 where an asset is near. */
    [[nodiscard]] double priority(int iceberg) const;
    /** Seen from the asset, by the estimate; none without an asset. */
    [[nodiscard]] std::optional<RelativeMotion> relativeToAsset(int iceberg) const;
    [[nodiscard]] const Track& track(int iceberg) const { return m_state.tracks[index(iceberg)]; }

    [[nodiscard]] const UavState& uav(int uav) const { return m_state.uavs[index(uav)]; }
    /** None: unlimited endurance, the UAV never lands. */
    [[nodiscard]] const std::optional<SortieSpec>& sortie(int uav) const
    {
        return m_crafts[index(uav)].sortie;
    }
    /**
     * Endurance left when it would be home, flying there at once; none: unlimited, or on the
     * ground. Below 0: home cannot be reached in time any more.
     */
    [[nodiscard]] std::optional<double> homeMargin_s(int uav) const;
    /**
     * How many icebergs of this order, from its start, can be visited before home must be reached;
     * none: unlimited.
     */
    [[nodiscard]] std::optional<int> thisSortie(int uav, std::span<const int> order) const;
    /** What the UAV stays inside; null: nothing. */
    [[nodiscard]] const std::shared_ptr<const Geofence>& fence(int uav) const
    {
        return m_crafts[index(uav)].fence;
    }

    /** Why a plan is needed now, of the first UAV that has a reason of its own; None: fly on. */
    [[nodiscard]] PlanReason planReason() const;
    /** Why the UAV needs one; `Fleet`: because another one does. */
    [[nodiscard]] PlanReason planReason(int uav) const { return m_planReasons[index(uav)]; }
    /** UAVs that plans are made for now: not on the way home or on the ground; of those, when one
     * without a target is to be planned alone, that one. */
    [[nodiscard]] std::vector<int> plannedUavs() const;

    /**
     * Distances over ground (air distances in wind) and sigmas of the active icebergs, times their
     * priorities, of the UAVs that are planned now; of the first one when none is.
     */
    [[nodiscard]] PlanRequest planRequest() const;
    /**
     * The same with the available icebergs that one view can cover as one node, where the scenario
     * asks for that: `PlanRequest::clusters`. Its `picture` is still that of single icebergs. With
     * several UAVs there are no clusters.
     */
    [[nodiscard]] PlanRequest clusteredRequest() const;
    /** Whether it may be planned as one of a cluster. */
    [[nodiscard]] bool clusterable(int iceberg) const;

    /**
     * The UAV is to fly to this iceberg from here; -1: none available, circle the last one reached.
     * With an aim: along it until something comes into view. With members of a cluster, the iceberg
     * one of them: to the middle of the circle round their estimates, reached when all of them are
     * at once.
     */
    void setTarget(int uav, int iceberg, const std::optional<AimedLeg>& aim = std::nullopt,
                   std::span<const int> members = {});
    /** Where the target is believed to be, the middle of a cluster; there must be one. */
    [[nodiscard]] Point targetPlace_m(int uav) const;

    /** Advances one dt. Must not be called while a plan is needed or when finished. */
    void advanceStep();

    [[nodiscard]] const Motion& motion(int uav) const { return m_crafts[index(uav)].motion; }
    [[nodiscard]] const std::optional<Asset>& asset() const { return m_asset; }
    /** The wind is this from now on, and a new plan is needed. */
    void setWind(const Point& wind_mps);
    /** What is to be protected from now on; a new plan is needed. */
    void setAsset(const Asset& asset);

    /** Something changed from outside (tau, policy): a new plan is needed now. */
    void requestPlan() { needPlans(PlanReason::Intervention); }
    /** From now on plans are this policy's: routes that are repeated are planned for all at once.
     */
    void setPolicy(PolicyKind policy);
    /** The iceberg is to be visited by this UAV alone, -1: by any; a new plan is needed. */
    void assign(int iceberg, int uav);

    /**
     * An iceberg that has appeared is reported by somebody else: its position is known now as if it
     * were in view, and a new plan is needed.
     */
    void reportSighting(int iceberg);

    /** Adds an iceberg that appears now; its index is the new last one. */
    void addIceberg(const Iceberg& iceberg);

    /** Icebergs that came into view in the last step, by index, ascending. */
    [[nodiscard]] std::span<const SeenIceberg> newlySeen() const { return m_newlySeen; }
    /** Icebergs that appeared in the last step. */
    [[nodiscard]] std::span<const int> newlyAppeared() const { return m_newlyAppeared; }
    /** What else happened since this was asked last, without times; asking changes nothing about
     * the flight. */
    [[nodiscard]] std::vector<MissionEvent> takeEvents() { return std::exchange(m_events, {}); }

private:
    /** What does not change about a UAV, but for the wind. */
    struct Craft
    {
        std::string id;
        Motion motion;
        SensorSpec sensor;
        double altitude_m = 0;
        double reach_m = 0; ///< of the field of view
        double turnRadius_m = 0;
        bool needsRunOut = false; ///< reach smaller than the turn radius: see FlightMode::RunOut
        std::int64_t autopilotSteps = 1; ///< between two commands of the autopilot
        double command_s = 0;            ///< the same in seconds
        std::optional<SortieSpec> sortie;
        std::shared_ptr<const Geofence> fence;
    };
    /** The fields of view of the UAVs, made when they are first needed: each costs a sine. */
    using Views = std::vector<std::optional<FieldOfView>>;

    [[nodiscard]] static std::size_t index(int i) { return static_cast<std::size_t>(i); }
    void addUav(const Uav& uav, const Scenario& scenario);
    [[nodiscard]] int uavOf(const std::string& id) const;
    [[nodiscard]] FieldOfView fieldOfView(int uav) const;
    /** The first UAV that has the place in view; -1: none. */
    [[nodiscard]] int viewer(const Point& place_m, Views& views) const;
    [[nodiscard]] bool withinReach(int uav, int iceberg) const;
    [[nodiscard]] bool withinReachOfAny(int iceberg) const;
    template <class Counts>
    [[nodiscard]] int nearest(int uav, const Counts& counts) const;
    [[nodiscard]] bool inOwnView(int uav, int iceberg) const;
    [[nodiscard]] bool isReached(int uav, int iceberg) const;
    [[nodiscard]] bool isReachedByOther(int uav, int iceberg) const;
    [[nodiscard]] bool targetReached(int uav) const;
    [[nodiscard]] PlanRequest withClusters(PlanRequest single,
                                           std::vector<std::vector<int>> clusters) const;
    [[nodiscard]] UavRequest uavRequest(int uav, const std::vector<int>& ids) const;
    [[nodiscard]] Eigen::MatrixXd nodeDistances_m(int uav, std::span<const Point> places_m) const;
    [[nodiscard]] Point middleOf_m(std::span<const int> members) const;
    void setMembers(int uav, std::span<const int> members);
    void updateClusters(int uav);
    [[nodiscard]] Eigen::MatrixXd legLengths_m(int uav, std::span<const Point> places_m) const;
    /** `start_s`: when the iceberg is at its `position_m`; `appearsStep`: known from then on. */
    void insert(const Iceberg& iceberg, DriftNoise noise, double start_s, std::int64_t appearsStep);
    void fly(int uav);
    void watchSeparation(std::span<const Point> before_m);
    [[nodiscard]] bool isJustAloft(int uav) const;
    void observe(double dt_s);
    void lookAround(double now_s);
    /** Of this step: held between two commands of the autopilot. */
    [[nodiscard]] double commanded(int uav);
    [[nodiscard]] double commandedHome(int uav);
    [[nodiscard]] double commandedWithReturn(int uav, double wished_radps);
    void proveReturn(int uav);
    [[nodiscard]] std::int64_t stepsHeld(int uav) const;
    void look(std::size_t iceberg, double now_s, Views& views);
    [[nodiscard]] std::int64_t stepsOutOfReach(std::size_t iceberg, const Point& truth_m) const;
    void observeFiltered(double now_s, double dt_s);
    void lookForMeasurements(double now_s);
    void measure(std::size_t iceberg, const Point& measured_m, double now_s, int seenBy);
    void miss(std::size_t iceberg, std::span<const FieldOfView> views,
              std::span<const FieldOfView> middles);
    void lose(std::size_t iceberg, int uav, std::span<const FieldOfView> views);
    void watchEstimates();
    void growSearches(std::size_t iceberg, double added_m2);
    void endSearchFor(int iceberg);
    void giveUp(Search search, int uav);
    void giveUpSearch(int uav);
    void handSearchOn(int uav);
    void beginOrEndSearch(int uav);
    void searchAgain(int uav);
    [[nodiscard]] bool maySearch(int uav, int iceberg) const;
    [[nodiscard]] bool hasSomethingToSearch(int uav) const;
    void watchArea();
    [[nodiscard]] bool appeared(int iceberg) const;
    void triggerPlans(PlanReason reason);
    [[nodiscard]] bool isWorthSearching(int uav, const Search& search) const;
    [[nodiscard]] double searchGain_m2ps(int uav, const Search& search) const;
    [[nodiscard]] double steerSearch(int uav);
    [[nodiscard]] double steer(int uav);
    [[nodiscard]] double steerLeg(int uav);
    [[nodiscard]] double steerAim(int uav);
    [[nodiscard]] double steerCluster(int uav);
    [[nodiscard]] double steerRunOut(int uav);
    [[nodiscard]] double steerCircle(int uav);
    [[nodiscard]] double circleRadius_m(int uav) const;
    [[nodiscard]] double steerHome(int uav);
    /** Towards the corner that the geofence leads round on the way there; none: it does not. */
    [[nodiscard]] std::optional<double> steerRoundFence(int uav, const Point& end_m);
    /** Unless it is homeward. */
    void needPlan(int uav, PlanReason reason);
    void needPlans(PlanReason reason);
    /** As `available`, whether or not the endurance allows it. */
    [[nodiscard]] bool visitable(int uav, int iceberg) const;
    [[nodiscard]] bool affordable(int uav, int iceberg) const;
    [[nodiscard]] SafetyGuard guardOf(int uav) const;
    [[nodiscard]] double enduranceLeft_s(int uav) const;
    [[nodiscard]] bool nothingAffordable(int uav) const;
    void goHome(int uav);
    [[nodiscard]] PlanReason takeOffWhenDue(int uav);
    void advanceSortie(int uav, const Point& from_m);
    void buildFence(int uav);
    void updatePlanReasons();
    [[nodiscard]] PlanReason reasonOf(int uav);
    [[nodiscard]] PlanReason reasonOfAim(int uav);
    [[nodiscard]] bool somethingForIdle(int uav) const;
    [[nodiscard]] bool othersFly() const;
    /** Target of a UAV that is not planned now. */
    [[nodiscard]] bool isTargetOfUnplanned(int iceberg) const;

    // What the scenario says.
    std::vector<Craft> m_crafts;
    std::optional<double> m_reachRadius_m;
    bool m_clusters;
    bool m_plansIdleAlone = false; ///< as the policy allows
    std::optional<Asset> m_asset;
    std::vector<Point> m_area_m; ///< empty: unbounded
    bool m_geofence;
    double m_separation_m;
    ObserverSpec m_observer;
    Point m_current_mps;
    double m_dt_s;
    std::int64_t m_lastStep;
    std::int64_t m_stepsPerSecond;
    std::uint64_t m_seed;
    bool m_noise;

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
    std::vector<int> m_assigned; ///< by iceberg: the UAV that alone is to visit it, or -1
    std::vector<std::int64_t> m_appearsStep;
    std::vector<std::int64_t> m_lookStep; ///< before this step it is surely out of view
    std::int64_t m_nextLookStep = 0;      ///< first of them
    WorldState m_state;
    std::vector<SeenIceberg> m_newlySeen;
    std::vector<int> m_newlyAppeared;
    std::vector<MissionEvent> m_events;
    PlanReason m_trigger = PlanReason::None; ///< of this step, for every UAV: the first there was
    std::vector<PlanReason> m_planReasons;   ///< by UAV
};

} // namespace berg
