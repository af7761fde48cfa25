#pragma once

#include "core/sim/observer.h"
#include "core/vehicle/safety_guard.h"

#include <variant>

namespace berg {

/** What a UAV is sent to. */
struct Errand
{
    int target = -1;             ///< index into the icebergs; -1: none
    std::optional<AimedLeg> aim; ///< flown instead of the way to the target's estimate
    std::vector<int> members;    ///< the target is the middle of these; empty: it is one iceberg
    double membersBy_s = 0;      ///< when they are overdue
};

/**
 * Flies one UAV: turns what it is sent to into turn rates, within what its `SafetyGuard` allows.
 * Knows of icebergs what the observer tells.
 */
class Autopilot
{
public:
    Autopilot(const Uav& uav, const Scenario& scenario);

    [[nodiscard]] const DubinsState& pose() const { return m_pose; }
    /** Its place before it moved last. */
    [[nodiscard]] const Point& before_m() const { return m_before_m; }
    [[nodiscard]] FlightMode mode() const { return static_cast<FlightMode>(m_mode.index()); }
    /** On its way home or on the ground. */
    [[nodiscard]] bool isHomeward() const { return mode() == FlightMode::Home || isOnGround(); }
    /** On its way home, on the ground or holding it is not. */
    [[nodiscard]] bool isPlanned() const { return !isHomeward() && mode() != FlightMode::Hold; }
    [[nodiscard]] FlightOrder order() const { return m_order; }
    [[nodiscard]] bool isOnGround() const { return mode() == FlightMode::Ground; }
    /** Where it may be; without a geofence everywhere. */
    [[nodiscard]] bool isInsideFence() const;
    /** Null: it is sent to nothing. */
    [[nodiscard]] const Errand* errand() const;
    /** Index of the iceberg it is sent to; -1: none. */
    [[nodiscard]] int target() const { return errand() ? errand()->target : -1; }
    /** Whether it is sent to it, alone or as one of a cluster. */
    [[nodiscard]] bool fliesTo(int iceberg) const;
    /** What is put on record, without what others know: search, planned alone. */
    [[nodiscard]] UavState state() const;

    [[nodiscard]] const Motion& motion() const { return m_guard.uav().motion; }
    [[nodiscard]] double altitude_m() const { return m_altitude_m; }
    [[nodiscard]] const SensorSpec& sensor() const { return m_sensor; }
    [[nodiscard]] const SafetyGuard& guard() const { return m_guard; }
    /** Whether it cannot come within reach of the place without leaving its fence. */
    [[nodiscard]] bool isShutOff(const Point& place_m) const;
    /** Endurance left when it would be home, flying there at once: `SafetyGuard::homeMargin_s`. */
    [[nodiscard]] std::optional<double> homeMargin_s(const Observer& observer) const;

    /** A target of -1: round the last iceberg reached, the nearest one when there is none. */
    void setTarget(Errand errand, const Observer& observer);
    /** Searches for what the observer knows it to search for, before the target. */
    void search();
    void goHome();
    /** None: an order that was given before has come to its end. */
    void obey(FlightOrder order, const Observer& observer);
    void setReached(int iceberg) { m_lastReached = iceberg; }
    /** In mode Ground; false: it would not come home, and tries again later. */
    [[nodiscard]] bool takeOff(const Observer& observer);
    /** Of the endurance: `SafetyGuard::withhold`. */
    void withhold(double withheld_s) { m_guard.withhold(withheld_s); }
    void setWind(const Point& wind_mps, const Observer& observer);
    /** Made for the wind that blows; null: none from now on. */
    void setFence(std::shared_ptr<const Geofence> fence, const Observer& observer);

    /** The turn rate of the step that ends now, held between two commands. False: it has to go home
     * and is on its way. */
    [[nodiscard]] bool command(int uav, Observer& observer, StepReport& report);
    /** Whether it is given a command in the step that ends now. */
    [[nodiscard]] bool isCommanded(const World& world) const;
    [[nodiscard]] double turnRate_radps() const { return m_u_radps; }
    /** In place of its command, until the next one. */
    void deviateTo(double u_radps);
    /** Flies that step, or takes the pose at its end from outside. */
    void move(int uav, const DubinsState* measured, StepReport& report);

private:
    template <FlightMode>
    struct Alone
    {
    };
    template <FlightMode>
    struct Sent
    {
        Errand errand;
    };
    struct Hold
    {
        Point place_m;
    };
    using Idle = Alone<FlightMode::Idle>;
    using Leg = Sent<FlightMode::Leg>;
    using RunOut = Sent<FlightMode::RunOut>;
    using Circle = Alone<FlightMode::Circle>;
    using Searching = Sent<FlightMode::Search>;
    using Home = Alone<FlightMode::Home>;
    using Ground = Alone<FlightMode::Ground>;
    /** In the order of `FlightMode`. */
    using Mode = std::variant<Idle, Leg, RunOut, Circle, Searching, Home, Ground, Hold>;

    void watchFence(int uav, StepReport& report) const;
    void limitTurnGain();
    [[nodiscard]] double steer(int uav, Observer& observer, StepReport& report);
    [[nodiscard]] double steerLeg(const Observer& observer);
    [[nodiscard]] double steerAim(AimedLeg& aim);
    [[nodiscard]] double steerRunOut();
    [[nodiscard]] double steerRound(const Point& place_m);
    [[nodiscard]] double steerSearch(int uav, Observer& observer, StepReport& report);
    /** Towards the corner that the geofence leads round on the way there; none: it does not. */
    [[nodiscard]] std::optional<double> steerRoundFence(const Point& end_m);
    /** Where the leg to the target ends: beside a no-fly area that it is in. */
    [[nodiscard]] Point legEnd_m(const Errand& errand, const Observer& observer) const;
    [[nodiscard]] LosGuidance::Command steerAlong(const Point& end_m,
                                                  const Point& drift_mps = Point::Zero());
    [[nodiscard]] double steerAt(const Point& place_m) const;

    SensorSpec m_sensor;
    SortieSpec m_withoutLimit; ///< for a return that is ordered where the endurance is unlimited
    double m_altitude_m;
    double m_turnRadius_m;
    double m_reach_m;   ///< so near an iceberg it has reached it, or surely sees it
    bool m_needsRunOut; ///< reach smaller than the turn radius: see `FlightMode::RunOut`
    SafetyGuard m_guard;

    DubinsState m_pose;
    Point m_before_m = Point::Zero();
    double m_u_radps = 0;
    double m_crossTrack_m = 0;
    double m_flown_m = 0; ///< through the air
    Mode m_mode;
    FlightOrder m_order = FlightOrder::None;
    int m_lastReached = -1;
    LosGuidance m_guidance;
    double m_runOut_m = 0;        ///< left to fly straight in mode RunOut
    int m_misses = 0;             ///< times the target was passed without reaching it
    std::optional<Point> m_via_m; ///< corner flown to, round which the geofence leads
};

/** Where the target is believed to be, the middle of a cluster. */
[[nodiscard]] Point targetPlace_m(const Errand& errand, const Observer& observer);
/** Of the circle flown while every iceberg is in view. */
[[nodiscard]] double circleRadius_m(const Motion& motion);
/** Of the legs between places: over ground, through the air in wind; round the fence. */
[[nodiscard]] Eigen::MatrixXd legLengths_m(const GuardedUav& uav, std::span<const Point> places_m);
/** How many icebergs of this order, from its start, can be visited before home must be reached;
 * none: unlimited. */
[[nodiscard]] std::optional<int> thisSortie(const Autopilot& uav, std::span<const int> order,
                                            const Observer& observer);
/** Chance per second of finding it, times what that takes away. */
[[nodiscard]] double searchGain_m2ps(const Autopilot& uav, const Search& search,
                                     const Observer& observer);
/** Whether the search gains more per second than flying to the target: its sigma, which the
 * sighting takes away, over the time until then. */
[[nodiscard]] bool isWorthSearching(const Autopilot& uav, const Search& search,
                                    const Observer& observer);

} // namespace berg
