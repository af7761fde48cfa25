#pragma once

#include "core/sim/pose_tracks.h"
#include "core/vehicle/safety_guard.h"
#include "core/world/observer.h"

#include <variant>

namespace berg {

/** The iceberg, cluster or aimed leg that a UAV flies to. */
struct FlightTarget
{
    std::optional<IcebergIndex> target; ///< index of the iceberg; nullopt while nothing is flown to
    /** Leg to fly in place of the straight leg to the target's estimate. */
    std::optional<AimedLeg> aim;
    IcebergList members;    ///< icebergs of the cluster to fly over; empty for a single iceberg
    double membersBy_s = 0; ///< run time from which the cluster is overdue, s
};

/**
 * Flies one UAV: turns its flight target into turn rates that its `SafetyGuard` allows. It learns
 * about icebergs only from the observer.
 */
class Autopilot
{
public:
    /**
     * Starts at the UAV's start pose in mode Idle. The fence and endurance are those of `scenario`,
     * which must have no errors (`validate`). `weather` is that of the scenario, or null.
     */
    Autopilot(const Uav& uav, const Scenario& scenario, const FlightWeather* weather);

    [[nodiscard]] const DubinsState& pose() const { return m_pose; }
    /** Returns the position before the last call of `move`, m. */
    [[nodiscard]] const Point& before_m() const { return m_before_m; }
    [[nodiscard]] FlightMode mode() const { return static_cast<FlightMode>(m_mode.index()); }
    /** Returns true if the UAV flies home or is on the ground. */
    [[nodiscard]] bool isHomeward() const { return mode() == FlightMode::Home || isOnGround(); }
    /**
     * Returns true if plans are made for the UAV: it neither flies home, nor holds, nor is on the
     * ground.
     */
    [[nodiscard]] bool isPlanned() const { return !isHomeward() && mode() != FlightMode::Hold; }
    /** Returns the operator's order in force. */
    [[nodiscard]] FlightOrder order() const { return m_order; }
    [[nodiscard]] bool isOnGround() const { return mode() == FlightMode::Ground; }
    /** Returns true if the UAV is inside its geofence, or has none. */
    [[nodiscard]] bool isInsideFence() const;
    /**
     * Returns the target, or null if the UAV has none. The pointer is valid until the next change.
     */
    [[nodiscard]] const FlightTarget* flightTarget() const;
    /** Returns the index of the target iceberg, or nullopt if there is none. */
    [[nodiscard]] std::optional<IcebergIndex> target() const
    {
        return flightTarget() ? flightTarget()->target : std::nullopt;
    }
    /** Returns true if the iceberg is the target or a member of the target cluster. */
    [[nodiscard]] bool fliesTo(IcebergIndex iceberg) const;
    /**
     * Returns the recorded state, except `search` and `isAlone`, which the autopilot does not know.
     */
    [[nodiscard]] UavState state() const;

    [[nodiscard]] const Motion& motion() const { return m_guard.uav().motion; }
    [[nodiscard]] double altitude_m() const { return m_altitude_m; }
    [[nodiscard]] const SensorSpec& sensor() const { return m_sensor; }
    [[nodiscard]] const SafetyGuard& guard() const { return m_guard; }
    /** Returns the place where the UAV lands, even if its endurance is unlimited. */
    [[nodiscard]] const Point& home_m() const { return m_withoutLimit.home_m; }
    /** Returns true if the UAV cannot come within reach of the place without leaving its fence. */
    [[nodiscard]] bool isShutOff(const Point& place_m) const;
    /**
     * Returns the endurance left on arrival if the UAV flew home now, s, below 0 if it would be
     * late: `SafetyGuard::homeMargin_s`. Returns nullopt if the endurance is unlimited.
     */
    [[nodiscard]] std::optional<double> homeMargin_s(const Observer& observer) const;

    /**
     * Flies to the target. Without one the UAV circles the last iceberg reached, else the nearest
     * active one, else it holds where it is (Idle).
     */
    void setTarget(FlightTarget flightTarget, const Observer& observer);
    /** Flies the observer's search for this UAV; the present target is kept for afterwards. */
    void search();
    /** Switches to mode Home. */
    void goHome();
    /**
     * Carries out an operator's order. `FlightOrder::None` ends the order in force. On the ground
     * the order is only stored; any order but None prevents the next take-off.
     */
    void obey(FlightOrder order, const Observer& observer);
    /** Records the iceberg reached last, which the UAV circles when it has no target. */
    void setReached(IcebergIndex iceberg) { m_lastReached = iceberg; }
    /**
     * Takes off on a course with a safe return. The UAV must be on the ground. Returns false, and
     * stays there, if no safe return would exist after take-off.
     */
    [[nodiscard]] bool takeOff(const Observer& observer);
    /** Withholds part of the endurance, s, from this sortie: `SafetyGuard::withhold`. */
    void withhold(double withheld_s) { m_guard.withhold(withheld_s); }
    /** Sets the wind from now on and proves the return path again. */
    void setWind(const Point& wind_mps, const Observer& observer);
    /**
     * Sets the wind of now and what is known of the wind to come, none of it stronger than
     * `windLimit_mps`. A UAV on its way home proves its path again.
     */
    void followWind(const WindAhead& wind, double windLimit_mps, const Observer& observer);
    /**
     * Sets the landing place from now on and proves the return path again. On the ground the UAV
     * moves along.
     */
    void setHome(const Point& home_m, const Observer& observer);
    /** Sets the fence, built for the present wind; null removes it. */
    void setFence(std::shared_ptr<const Geofence> fence, const Observer& observer);

    /**
     * Sets the turn rate for the step that ends now, if a command is due. Returns false if the UAV
     * had to turn home with this command.
     */
    [[nodiscard]] bool command(int uav, Observer& observer, StepReport& report);
    /** Returns true if a command is due in the step that ends now. */
    [[nodiscard]] bool isCommanded(const World& world) const;
    [[nodiscard]] double turnRate_radps() const { return m_u_radps; }
    /** Replaces the turn rate, rad/s, until the next command. */
    void deviateTo(double u_radps);
    /**
     * Moves the UAV by one step of the Dubins model, or to the pose in `measured` if that is not
     * null; on the ground it stays. A returning UAV lands where it passes home, with a measured
     * pose once it stands there. Reports landing, fence crossings and late returns.
     */
    void move(int uav, const ExternalPose* measured, StepReport& report);

private:
    template <FlightMode>
    struct Untargeted
    {
    };
    template <FlightMode>
    struct Targeted
    {
        FlightTarget flightTarget;
    };
    struct Hold
    {
        Point place_m;
    };
    using Idle = Untargeted<FlightMode::Idle>;
    using Leg = Targeted<FlightMode::Leg>;
    using RunOut = Targeted<FlightMode::RunOut>;
    using Circle = Untargeted<FlightMode::Circle>;
    using Searching = Targeted<FlightMode::Search>;
    using Home = Untargeted<FlightMode::Home>;
    using Ground = Untargeted<FlightMode::Ground>;
    /** Alternatives in the order of `FlightMode`. */
    using Mode = std::variant<Idle, Leg, RunOut, Circle, Searching, Home, Ground, Hold>;

    [[nodiscard]] bool isFlying(const ExternalPose& measured) const;
    void watchFence(int uav, StepReport& report) const;
    void limitTurnGain();
    [[nodiscard]] double steer(int uav, Observer& observer, StepReport& report);
    [[nodiscard]] double steerLeg(const Observer& observer);
    [[nodiscard]] double steerAim(AimedLeg& aim);
    [[nodiscard]] double steerRunOut();
    [[nodiscard]] double steerRound(const Point& place_m);
    [[nodiscard]] double steerSearch(int uav, Observer& observer, StepReport& report);
    /**
     * Returns the turn rate to the next fence corner on the path to `end_m`, or nullopt if the
     * straight path is clear.
     */
    [[nodiscard]] std::optional<double> steerRoundFence(const Point& end_m);
    /**
     * End of the leg to the target, moved to the nearest edge if the target is in a no-fly area.
     */
    [[nodiscard]] Point legEnd_m(const FlightTarget& flightTarget, const Observer& observer) const;
    [[nodiscard]] LosGuidance::Command steerAlong(const Point& end_m,
                                                  const Point& drift_mps = Point::Zero());
    [[nodiscard]] double steerAt(const Point& place_m) const;

    SensorSpec m_sensor;
    SortieSpec m_withoutLimit; ///< sortie for an ordered return when the endurance is unlimited
    double m_altitude_m;
    double m_turnRadius_m;
    double m_reach_m;   ///< distance at which an iceberg is reached or certainly in view
    bool m_needsRunOut; ///< true if `m_reach_m` is below the turn radius: see `FlightMode::RunOut`
    SafetyGuard m_guard;

    DubinsState m_pose;
    Point m_before_m = Point::Zero();
    double m_u_radps = 0;
    double m_crossTrack_m = 0;
    double m_flown_m = 0; ///< distance flown through the air
    Mode m_mode;
    FlightOrder m_order = FlightOrder::None;
    std::optional<IcebergIndex> m_lastReached;
    LosGuidance m_guidance;
    double m_runOut_m = 0;        ///< distance left to fly straight in mode RunOut
    int m_misses = 0;             ///< number of times the target was passed without reaching it
    std::optional<Point> m_via_m; ///< fence corner that the UAV flies to now
};

/**
 * Returns the estimated position of the target now, m; for a cluster the middle of the smallest
 * circle around its members. The target must be an iceberg or cluster.
 */
[[nodiscard]] Point targetPlace_m(const FlightTarget& flightTarget, const Observer& observer);
/**
 * Returns the radius of the circle over ground that a UAV flies while every iceberg is in view, m:
 * 1.2 times the tightest turn, wind included.
 */
[[nodiscard]] double circleRadius_m(const Motion& motion);
/**
 * Returns the N x N matrix of leg lengths between the places, row = from, in metres: air distance U
 * t_ij in wind, distance over ground without; around the fence where there is one.
 */
[[nodiscard]] Eigen::MatrixXd legLengths_m(const GuardedUav& uav, std::span<const Point> places_m);
/**
 * Returns how many icebergs of the order, from its first, can be visited before the UAV must turn
 * home, or nullopt if the endurance is unlimited.
 */
[[nodiscard]] std::optional<int>
thisSortie(const Autopilot& uav, std::span<const IcebergIndex> order, const Observer& observer);
/** Lets the search begin at the corner that is best for the UAV (`LostSearch::startAtBestCorner`).
 */
void startAtBestCorner(const Autopilot& uav, Search& search, const Observer& observer);
/**
 * Returns the expected gain of the search per second, m^2/s: the chance of finding the iceberg per
 * second times its weighted variance.
 */
[[nodiscard]] double searchGain_m2ps(const Autopilot& uav, const Search& search,
                                     const Observer& observer);
/**
 * Returns true if the search gains more per second than the flight to the target, which gains the
 * target's weighted sigma over its flight time. Returns false if the search has no corner left, and
 * otherwise true if there is no target.
 */
[[nodiscard]] bool isWorthSearching(const Autopilot& uav, const Search& search,
                                    const Observer& observer);

} // namespace berg
