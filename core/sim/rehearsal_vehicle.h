#pragma once

#include "core/earth/geodesy.h"
#include "core/link/vehicle/vehicle_side.h"
#include "core/vehicle/dubins.h"
#include "core/vehicle/uav_spec.h"

#include <map>
#include <optional>
#include <vector>

namespace berg {

/** Distance at which a rehearsal vehicle has reached a waypoint without an acceptance radius. */
inline constexpr double kRehearsalReach_m = 50;
/** Returns the radius of the smallest circle that a rehearsal vehicle flies, m. */
[[nodiscard]] double smallestCircle_m(const UavSpec& uav);

/** The aircraft of a rehearsal and the world in which it flies. */
struct RehearsalOptions
{
    VehicleSideOptions side; ///< Behaviour of its autopilot and its id on the link.
    UavSpec uav;             ///< Airspeed, bank limit and altitude; endurance 0 drains no battery.
    LatLon home;
    double homeAltitude_m = 0;      ///< Above mean sea level.
    Point wind_mps = Point::Zero(); ///< Wind over ground, east and north.
    std::optional<LatLon> start;    ///< Nullopt means home.
    double heading_deg = 90;        ///< At the start, clockwise from north.
    double speed = 1;               ///< Seconds of flight in each second of the link.
    /** Radius of circles that are given without one; `smallestCircle_m` if it is smaller. */
    double loiterRadius_m = 0;
};

/**
 * A simulated fixed-wing aircraft at the vehicle's end of a link. Any ground station can monitor it
 * and upload missions. It starts in the air, circling home. It flies the mission on board
 * (waypoints, circles, jumps, speeds, return) with the Dubins model, and follows mode changes and
 * guided targets. After the last item it flies home as ArduPilot or circles as PX4. In any other
 * mode the pilot is taken to be in control, and it flies straight on. NaN in an item or a command
 * means its own value, as MAVLink defines it: the altitude stays, and a circle has the radius of
 * the options. Used by one thread; the caller supplies the time.
 */
class RehearsalVehicle
{
public:
    /** `link` must outlive the vehicle. */
    RehearsalVehicle(ByteLink& link, RehearsalOptions options);

    /** Puts a list on board, as an upload does. */
    void load(MissionType type, std::span<const LinkMissionItem> items)
    {
        m_side.load(type, items);
    }
    /** Switches to automatic flight of the mission on board. */
    void flyMission();
    /** Flies up to `now` in steps of at most 0.1 s, then answers the messages received. */
    void advance(LinkTime now);
    /**
     * Switches the mode as the pilot's transmitter does; `mode` is the custom_mode of HEARTBEAT.
     */
    void setMode(std::uint32_t mode);
    /** Flies straight on until the next change of the mode or of a guided target. */
    void flyStraightOn() { m_flight = Flight::Pilot; }
    /** Sets altitude above mean sea level and present item, from 0 and without home. */
    void setProgress(double altitude_m, int item);
    /**
     * Restarts the autopilot: for `off_s` seconds the link receives and sends nothing. The aircraft
     * flies on.
     */
    void reboot(double off_s) { m_side.reboot(m_now, off_s); }

    [[nodiscard]] const VehicleReadings& readings() const { return m_readings; }
    [[nodiscard]] const VehicleSide& side() const { return m_side; }

private:
    enum class Flight
    {
        Mission,
        Home,
        Circle, ///< Around `m_centre_m`, on hold or guided.
        Pilot
    };

    void execute(const VehicleOrder& order);
    void flyStep(double dt_s);
    /** Executes items that take no time and returns the item to fly, or nullopt after the last. */
    [[nodiscard]] std::optional<LinkMissionItem> itemToFly();
    /** Returns the turn rate towards an item, rad/s, and moves on once it is reached. */
    [[nodiscard]] double turnRateFor(const LinkMissionItem& item, double dt_s);
    [[nodiscard]] double turnRateToPoint(const Point& target_m) const;
    [[nodiscard]] double turnRateRound(const Point& centre_m, double radius_m) const;
    [[nodiscard]] double turnRateToCourse(double course_rad) const;
    [[nodiscard]] bool isReached(const LinkMissionItem& item, const Point& target_m) const;
    void reachItem();
    void endMission();
    [[nodiscard]] Point placeOf(const LinkMissionItem& item) const;
    /** Returns an altitude above mean sea level; `frame` is a MAV_FRAME, above home if not sea. */
    [[nodiscard]] double altitudeIn(std::uint8_t frame, double altitude_m) const;
    /** Returns the radius of a circle for which `radius_m` is given; 0 means none. */
    [[nodiscard]] double flownRadius_m(double radius_m) const;
    void updateReadings(double turnRate_radps, double climb_mps);

    RehearsalOptions m_options;
    VehicleSide m_side;
    LocalFrame m_frame;
    DubinsState m_motion;
    double m_airspeed_mps;
    double m_altitude_m;       ///< Above mean sea level.
    double m_targetAltitude_m; ///< Above mean sea level.
    Flight m_flight = Flight::Circle;
    Point m_centre_m = Point::Zero();
    double m_radius_m = 0; ///< Radius of the circle; 0 selects that of the options.
    std::size_t m_item = 0;
    double m_itemFlown_s = 0;           ///< Time spent on the circle of the present item.
    std::map<std::size_t, int> m_jumps; ///< Number of times each jump was taken, by item.
    LinkTime m_now;
    double m_flown_s = 0;
    std::vector<LinkMissionItem> m_items;
    VehicleReadings m_readings;
};

} // namespace berg
