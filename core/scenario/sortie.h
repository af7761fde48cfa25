#pragma once

#include "core/scenario/scenario.h"
#include "core/vehicle/path_home.h"

namespace berg {

/**
 * What a flight of the UAV may use of its endurance, and where it ends; none: it is unlimited.
 * Climb and landing, like the turn-around, pass on the ground: nothing is seen meanwhile.
 */
[[nodiscard]] std::optional<SortieSpec> sortieOf(const Uav& uav);

} // namespace berg
