#pragma once

#include "core/io/export/export_content.h"

namespace berg {

/**
 * QGroundControl `.plan` (JSON) of the only UAV of the content that QGroundControl, MAVSDK and
 * Mission Planner all read. The geofence of the scenario becomes an inclusion fence, whether or not
 * start and icebergs lie within it, no-fly areas and stand-off ring at the altitude of the UAV
 * exclusion fences; home is the rally point.
 */
[[nodiscard]] std::string qgcPlan(const ExportContent& content);

} // namespace berg
