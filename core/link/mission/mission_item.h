#pragma once

#include "core/link/message/link_frame.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace berg {

/** Firmware whose behaviour an autopilot has. */
enum class AutopilotKind
{
    ArduPilot,
    Px4,
    Other
};

/** Returns the kind for the value of the field `autopilot` of a heartbeat. */
[[nodiscard]] AutopilotKind autopilotKind(std::int64_t mavAutopilot);

/** Lists of items stored by a vehicle; the values are those of MAV_MISSION_TYPE. */
enum class MissionType : std::uint8_t
{
    Mission = 0,
    Fence = 1,
    Rally = 2
};

/** MAV_FRAME values for items. */
enum class ItemFrame : std::uint8_t
{
    Global = 0,     ///< Altitude above mean sea level.
    NoPosition = 2, ///< For commands; x and y are plain numbers.
    AboveHome = 3,
    AboveTerrain = 10
};

/** Commands of the link and of exported missions; MAV_CMD values. */
struct LinkCommandId
{
    static constexpr std::uint16_t kWaypoint = 16;
    static constexpr std::uint16_t kLoiterUnlimited = 17;
    static constexpr std::uint16_t kLoiterTurns = 18;
    static constexpr std::uint16_t kLoiterTime = 19;
    static constexpr std::uint16_t kReturnToLaunch = 20;
    static constexpr std::uint16_t kLand = 21;
    static constexpr std::uint16_t kTakeOff = 22;
    static constexpr std::uint16_t kLoiterToAltitude = 31;
    static constexpr std::uint16_t kOrbit = 34;
    static constexpr std::uint16_t kVtolTakeOff = 84;
    static constexpr std::uint16_t kVtolLand = 85;
    static constexpr std::uint16_t kSetMode = 176;
    static constexpr std::uint16_t kJump = 177;
    static constexpr std::uint16_t kChangeSpeed = 178;
    static constexpr std::uint16_t kLandStart = 189;
    static constexpr std::uint16_t kReposition = 192;
    static constexpr std::uint16_t kPauseContinue = 193;
    static constexpr std::uint16_t kMountControl = 205;
    static constexpr std::uint16_t kTriggerDistance = 206;
    static constexpr std::uint16_t kSetCurrentItem = 224;
    static constexpr std::uint16_t kMissionStart = 300;
    static constexpr std::uint16_t kSetMessageInterval = 511;
    static constexpr std::uint16_t kRequestMessage = 512;
    static constexpr std::uint16_t kStartCapture = 2000;
    static constexpr std::uint16_t kStopCapture = 2001;
    static constexpr std::uint16_t kFenceInside = 5001;  ///< a corner of an inclusion
    static constexpr std::uint16_t kFenceOutside = 5002; ///< a corner of an exclusion
    static constexpr std::uint16_t kRally = 5100;
};

/** One item of a mission, fence or list of rally points, as carried by MISSION_ITEM_INT. */
struct LinkMissionItem
{
    std::uint16_t command = LinkCommandId::kWaypoint;
    std::uint8_t frame = static_cast<std::uint8_t>(ItemFrame::AboveHome); ///< MAV_FRAME.
    /** First four parameters; NaN means the vehicle's default. */
    std::array<float, 4> params{0, 0, 0, std::numeric_limits<float>::quiet_NaN()};
    std::int32_t x = 0; ///< Latitude in 1e-7 degrees, or the fifth parameter.
    std::int32_t y = 0; ///< Longitude in 1e-7 degrees, or the sixth parameter.
    float z = 0;        ///< Altitude in metres, or the seventh parameter.
};

/** Receiver and position of an item in a transfer. */
struct ItemAddress
{
    LinkAddress target;
    MissionType type = MissionType::Mission;
    int seq = 0;
    bool isCurrent = false;
};

/** Returns the message that carries an item. */
[[nodiscard]] LinkMessage itemMessage(const LinkMissionItem& item, const ItemAddress& address);

/**
 * Returns the item of a MISSION_ITEM_INT, or of an old MISSION_ITEM, which has degrees as floats
 * (numbers that do not fit become 0). Throws `std::logic_error` for another message.
 */
[[nodiscard]] LinkMissionItem itemOf(const LinkMessage& message);

/**
 * Returns the items as this autopilot numbers them. An ArduPilot mission that is not empty gets a
 * home in front, whose values the vehicle replaces, and its targets of DO_JUMP increase by one.
 */
[[nodiscard]] std::vector<LinkMissionItem> itemsToSend(std::span<const LinkMissionItem> items,
                                                       MissionType type, AutopilotKind kind);

/** Returns the items of a vehicle without the additions of `itemsToSend`. */
[[nodiscard]] std::vector<LinkMissionItem> itemsReadBack(std::span<const LinkMissionItem> items,
                                                         MissionType type, AutopilotKind kind);

/** A difference between plan and vehicle. */
struct ItemDifference
{
    /** Index of the item in the plan, from 0; nullopt if the number of items differs. */
    std::optional<int> index = {};
    std::string field; ///< "count", "command", "frame", "x", "y", "z" or "param1" to "param4".
    bool operator==(const ItemDifference&) const = default;
};

/**
 * Compares the plan with the items on board. Positions must be equal, altitudes within 0.05 m, and
 * parameters used by the command within 1 % (vehicles store some as whole numbers); NaN equals 0.
 * Items without a position are compared by command and parameters only. Old frame names (5, 6, 11)
 * equal the new ones. Returns an empty list if the vehicle has the plan on board.
 */
[[nodiscard]] std::vector<ItemDifference>
missionDifferences(std::span<const LinkMissionItem> planned,
                   std::span<const LinkMissionItem> onBoard);

} // namespace berg
