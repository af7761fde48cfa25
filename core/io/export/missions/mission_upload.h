#pragma once

#include "core/io/export/missions/mission_items.h"
#include "core/link/mission/mission_sync.h"

#include <vector>

namespace berg {

/** A polygon of the fence of a mission. */
struct MissionFence
{
    bool isInclusion = false;
    std::vector<LatLon> corners; ///< rounded for export, not closed
};

/**
 * Returns the fence of one UAV: the area if it is a geofence, and as exclusions the areas that are
 * closed at its altitude, because polygons have no heights. Both autopilots take such polygons.
 */
[[nodiscard]] std::vector<MissionFence> missionFences(const ExportContent& content,
                                                      const ExportUav& uav);

/**
 * Returns what a link uploads to the autopilot of one UAV: its fence, a rally point at home at the
 * altitude of the mission, and the mission that `mavMission` makes. Without a fence in the plan
 * there is no such part, because an empty one would delete the aircraft's own fence.
 */
[[nodiscard]] std::vector<MissionPart> missionParts(const ExportContent& content,
                                                    const ExportUav& uav);

} // namespace berg
