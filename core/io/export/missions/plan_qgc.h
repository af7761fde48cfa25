#pragma once

#include "core/io/export/content/export_content.h"

namespace berg {

/**
 * Returns the QGroundControl `.plan` (JSON) of the content's only UAV, readable by QGroundControl,
 * MAVSDK and Mission Planner. The geofence of the scenario becomes an inclusion fence, whether or
 * not start and icebergs lie within it; no-fly areas and stand-off ring at the altitude of the UAV
 * become exclusion fences; home is the rally point. Throws as `mavMission`.
 */
[[nodiscard]] std::string qgcPlan(const ExportContent& content);

} // namespace berg
