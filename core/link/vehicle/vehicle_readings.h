#pragma once

// This header is private to core/link. It converts readings of a vehicle to messages.

#include "core/link/vehicle/vehicle_side.h"

namespace berg {

/** Returns the HEARTBEAT of an autopilot. */
[[nodiscard]] LinkMessage heartbeatOf(const VehicleReadings& readings,
                                      const VehicleSideOptions& options);

/**
 * Returns message `id` with these readings, or nullopt if the readings do not make this message.
 * `sinceBoot_s` is the time since the vehicle was switched on.
 */
[[nodiscard]] std::optional<LinkMessage> readingsMessage(MessageId id,
                                                         const VehicleReadings& readings,
                                                         AutopilotKind kind, double sinceBoot_s);

} // namespace berg
