#pragma once

#include "core/link/mission/mission_item.h"

#include <cstdint>

namespace berg {

/** Modes in which an autopilot flies a fixed wing by itself, as custom_mode of HEARTBEAT. */
struct AutopilotModes
{
    std::uint32_t mission = 0;
    std::uint32_t home = 0;
    std::uint32_t hold = 0;
    std::uint32_t guided = 0; ///< In PX4, guided flight is a hold at another place.
};

/** Returns the modes of ArduPlane or PX4; autopilots of kind Other are taken for ArduPlane. */
[[nodiscard]] constexpr AutopilotModes autopilotModes(AutopilotKind kind)
{
    if (kind == AutopilotKind::Px4) // main mode in the third byte, sub-mode in the highest
        return {
            .mission = 0x04040000, .home = 0x05040000, .hold = 0x03040000, .guided = 0x03040000};
    return {.mission = 10, .home = 11, .hold = 12, .guided = 15};
}

} // namespace berg
