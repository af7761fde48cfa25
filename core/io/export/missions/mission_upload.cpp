#include "core/io/export/missions/mission_upload.h"

#include "core/io/text/export_numbers.h"
#include "core/scenario/fence.h"

#include <cmath>

namespace berg {

namespace {

std::int32_t linkDegrees(double angle_deg)
{
    return static_cast<std::int32_t>(std::lround(angle_deg * 1e7));
}

LinkMissionItem placedItem(std::uint16_t command, ItemFrame frame, const LatLon& place)
{
    return {.command = command,
            .frame = static_cast<std::uint8_t>(frame),
            .params = {0, 0, 0, 0},
            .x = linkDegrees(place.latitude_deg),
            .y = linkDegrees(place.longitude_deg)};
}

LinkMissionItem linkItem(const MavItem& item)
{
    LinkMissionItem sent = placedItem(item.command, item.frame, item.place);
    for (std::size_t i = 0; i < item.params.size(); ++i)
        sent.params[i] = static_cast<float>(item.params[i]);
    sent.z = static_cast<float>(item.altitude_m);
    return sent;
}

} // namespace

std::vector<MissionFence> missionFences(const ExportContent& content, const ExportUav& uav)
{
    std::vector<MissionFence> fences;
    const auto add = [&](const std::vector<Point>& corners_m, bool isInclusion) {
        MissionFence& fence = fences.emplace_back(MissionFence{.isInclusion = isInclusion});
        for (const Point& corner_m : corners_m)
            fence.corners.push_back(roundedPlace(content.frame.toGeographic(corner_m)));
    };
    if (content.geofence && !content.area_m.empty())
        add(content.area_m, true);
    for (const NoFlyArea& area : closedAreas(content))
        if (isClosedAt(area, uav.uav.spec.altitude_m))
            add(area.corners_m, false);
    return fences;
}

std::vector<MissionPart> missionParts(const ExportContent& content, const ExportUav& uav)
{
    const MavMission mission = mavMission(content, uav);
    MissionPart fence{.type = MissionType::Fence};
    for (const MissionFence& polygon : missionFences(content, uav))
        for (const LatLon& corner : polygon.corners) {
            fence.items.push_back(placedItem(polygon.isInclusion ? LinkCommandId::kFenceInside
                                                                 : LinkCommandId::kFenceOutside,
                                             ItemFrame::Global, corner));
            fence.items.back().params[0] = static_cast<float>(polygon.corners.size());
        }
    MissionPart rally{
        .type = MissionType::Rally,
        .items = {placedItem(LinkCommandId::kRally, ItemFrame::AboveHome, mission.home)}};
    rally.items.front().z = static_cast<float>(mission.altitude_m);
    MissionPart flown;
    for (const MavItem& item : mission.items)
        flown.items.push_back(linkItem(item));
    std::vector<MissionPart> parts{rally, flown};
    if (!fence.items.empty())
        parts.insert(parts.begin(), fence);
    return parts;
}

} // namespace berg
