#pragma once

#include "core/earth/geodesy.h"
#include "core/link/message/link_message.h"

#include <cstdint>
#include <optional>
#include <string>

namespace berg {

/** Position and velocity of an aircraft. Times are seconds of the receiver's clock. */
struct AircraftPosition
{
    LatLon place;
    double altitude_m = 0; ///< Above mean sea level.
    double aboveHome_m = 0;
    double north_mps = 0; ///< Velocity over ground.
    double east_mps = 0;
    double down_mps = 0;
    std::optional<double> heading_rad; ///< Clockwise from true north.
    double received_s = 0;
};

/** Attitude of an aircraft, radians. */
struct AircraftAttitude
{
    double roll_rad = 0;
    double pitch_rad = 0;
    double heading_rad = 0; ///< Clockwise from true north, 0 to 2 pi.
    double received_s = 0;
};

/**
 * Wind estimated by an aircraft, as the velocity of the air: last value, and mean and scatter over
 * about a minute.
 */
struct AircraftWind
{
    double north_mps = 0; ///< The last value.
    double east_mps = 0;
    double meanNorth_mps = 0;
    double meanEast_mps = 0;
    double scatter_mps = 0; ///< Standard deviation of both components together.
    double received_s = 0;
};

/** Charge left in the battery. */
struct AircraftBattery
{
    std::optional<double> remaining; ///< 0 to 1.
    std::optional<double> timeRemaining_s;
    std::optional<double> voltage_v;
    std::optional<double> current_a;
    double received_s = 0;
};

/** The mission item that an aircraft flies. */
struct AircraftMission
{
    int item = 0; ///< Numbered as on the link: ArduPilot counts home as 0.
    std::optional<int> total;
    int state = 0;                          ///< MISSION_STATE: 3 active, 4 paused, 5 complete.
    std::optional<std::uint32_t> missionId; ///< Nullopt if the autopilot gives none.
    double received_s = 0;
};

/** Latest telemetry of an aircraft. A member is empty until its first message. */
struct AircraftState
{
    std::optional<AircraftPosition> position;
    std::optional<AircraftAttitude> attitude;
    std::optional<AircraftWind> wind;
    std::optional<AircraftBattery> battery;
    std::optional<AircraftMission> mission;
    std::optional<double> airspeed_mps;
    std::optional<double> groundSpeed_mps;
    std::optional<int> reachedItem; ///< Numbered as on the link.
    std::optional<bool> isFlying;
    std::optional<LatLon> home;
    std::optional<double> homeAltitude_m; ///< Above mean sea level.
};

/**
 * Updates the state from a message received at `now_s`, in seconds of the receiver's clock. A
 * position, home, attitude or wind out of range or not finite leaves the state unchanged; a speed
 * that is not finite empties its member. Messages of other kinds are ignored.
 */
void updateState(AircraftState& state, const LinkMessage& message, double now_s);

} // namespace berg
