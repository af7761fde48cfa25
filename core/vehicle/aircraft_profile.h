#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace berg {

/** Firmware that flies the mission. */
enum class AutopilotFirmware
{
    ArduPilot,
    Px4
};

enum class Airframe
{
    FixedWing,
    Vtol,      ///< takes off and lands like a multirotor, and flies like a fixed wing
    Multirotor ///< hovers
};

/** How a mission begins. */
enum class TakeOffMethod
{
    Item, ///< an item of the mission
    Hand  ///< launched by hand: the mission is started in the air
};

/** How a mission ends when it is not to end over the last iceberg. */
enum class MissionEnd
{
    Return,  ///< return to launch, as the autopilot is set up
    Landing, ///< a landing pattern at home
    Loiter   ///< loiter until another command comes
};

/** Trigger of the camera over an iceberg. */
enum class CameraTrigger
{
    None,
    Distance,
    Time
};

/** Aircraft for which missions are exported. No simulated flight depends on it. */
struct AircraftProfile
{
    AutopilotFirmware firmware = AutopilotFirmware::ArduPilot;
    Airframe airframe = Airframe::FixedWing;
    TakeOffMethod takeOff = TakeOffMethod::Item;
    double takeOffAltitude_m = 50; ///< above the take-off, where the first leg begins
    double takeOffPitch_deg = 15;  ///< of a fixed wing
    MissionEnd end = MissionEnd::Return;
    double approach_m = 600;        ///< from the centre of the last loiter to the landing place
    double approachAltitude_m = 40; ///< above home, to which it descends in that loiter
    /** Course of the approach, clockwise from north; empty means into the wind. */
    std::optional<double> approachCourse_deg;
    std::optional<double> loiterRadius_m; ///< least radius; empty means that of the tightest turn
    double hoverSpeed_mps = 5;            ///< of a VTOL before and after its transitions
    bool speedItems = true;               ///< whether the airspeed is an item of the mission
    CameraTrigger camera = CameraTrigger::None;
    double trigger_m = 50;
    double trigger_s = 2;
    bool gimbalDown = false; ///< whether an item points the gimbal straight down
    bool operator==(const AircraftProfile&) const = default;
};

/** A profile to choose from. */
struct ReadyProfile
{
    std::string_view id;
    AircraftProfile profile;
};

/** Returns the ready profiles; the first is the default. */
[[nodiscard]] std::span<const ReadyProfile> readyProfiles();

} // namespace berg
