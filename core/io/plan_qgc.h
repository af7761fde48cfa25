#pragma once

#include "core/io/formats.h"

namespace berg {

/**
 * QGroundControl `.plan` (JSON) that QGroundControl, MAVSDK and Mission Planner all read. The area
 * of the scenario becomes an inclusion fence, whether or not start and icebergs lie within it.
 */
[[nodiscard]] std::string qgcPlan(const ExportSource& source);

} // namespace berg
