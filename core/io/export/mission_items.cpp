#include "core/io/export/mission_items.h"

#include "core/io/export/thinned_path.h"
#include "core/io/text/export_numbers.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

/** ArduPlane stores loiter radii above 8 bits in steps. */
constexpr double kRadiusStep_m = 10;

/** In DO_CHANGE_SPEED, p1 = 0 means airspeed (1 is ground speed) and p3 = -1 unchanged throttle. */
MavItem changeSpeed(double airspeed_mps)
{
    return {.command = MavCommand::DoChangeSpeed,
            .frame = MavFrame::Mission,
            .params = {0, airspeed_mps, -1, 0},
            .place = {},
            .altitude_m = 0};
}

/** Makes the mission items of one UAV. */
class ItemMaker
{
public:
    ItemMaker(const ExportContent& content, const ExportUav& uav) : m_content(content), m_uav(uav)
    {
    }

    [[nodiscard]] LatLon place(const Point& position_m) const
    {
        return roundedPlace(m_content.frame.toGeographic(position_m));
    }

    [[nodiscard]] MavItem waypoint(const Point& position_m, double acceptance_m) const
    {
        // Param 4, the yaw at a waypoint, is 0 and not NaN: a fixed wing ignores it, and Mission
        // Planner reads numbers only.
        return at(position_m, MavCommand::NavWaypoint, {0, acceptance_m, 0, 0});
    }

    /** Returns a waypoint, or the requested circles. */
    [[nodiscard]] MavItem visit(const Visit& visit) const
    {
        if (m_content.options.loiterTurns == 0)
            return waypoint(visit.position_m, acceptanceRadius_m(m_uav, visit.spread_m));
        return at(
            visit.position_m, MavCommand::NavLoiterTurns,
            {static_cast<double>(m_content.options.loiterTurns), 0, loiterRadius_m(m_uav), 0});
    }

    [[nodiscard]] MavItem lastLoiter(const Point& position_m) const
    {
        return at(position_m, MavCommand::NavLoiterUnlimited, {0, 0, loiterRadius_m(m_uav), 0});
    }

private:
    [[nodiscard]] MavItem at(const Point& position_m, MavCommand command,
                             const std::array<double, 4>& params) const
    {
        return {.command = command,
                .params = params,
                .place = place(position_m),
                .altitude_m = m_uav.uav.spec.altitude_m};
    }

    const ExportContent& m_content;
    const ExportUav& m_uav;
};

/** Returns the items between the first (speed) and the last (loiter). */
std::vector<MavItem> pathItems(const ExportContent& content, const ExportUav& uav,
                               const ItemMaker& maker)
{
    std::vector<MavItem> items;
    if (content.what == ExportScope::Path) {
        const double acceptance_m = uav.reachChosen ? acceptanceRadius_m(uav) : kPathAcceptance_m;
        for (const TimedPoint& corner : pathCorners(uav))
            items.push_back(maker.waypoint(corner.position_m, acceptance_m));
        return items;
    }
    for (const Visit& visit : uav.visits)
        if (visit.iceberg)
            items.push_back(maker.visit(visit));
    return items;
}

} // namespace

std::vector<TimedPoint> pathCorners(const ExportUav& uav)
{
    std::vector<TimedPoint> corners = thinnedPath(pathOf(uav), kPathTolerance_m);
    corners.erase(corners.begin());
    return corners;
}

double acceptanceRadius_m(const ExportUav& uav, double spread_m)
{
    const double radius_m = uav.reachChosen ? uav.reach_m : uav.reach_m - spread_m;
    return std::clamp(std::floor(radius_m), 1.0, kLargestByte_m);
}

double loiterRadius_m(const ExportUav& uav)
{
    const double least_m = std::ceil(uav.circle_m);
    return least_m <= kLargestByte_m ? std::max(1.0, least_m)
                                     : std::ceil(least_m / kRadiusStep_m) * kRadiusStep_m;
}

MavMission mavMission(const ExportContent& content)
{
    require(content.uavs.size() == 1, "mavMission: one UAV for each file");
    const ExportUav& uav = content.uavs.front();
    const ItemMaker maker(content, uav);
    MavMission mission{.home = maker.place(uav.home_m),
                       .airspeed_mps = uav.uav.spec.airspeed_mps,
                       .altitude_m = uav.uav.spec.altitude_m,
                       .items = {changeSpeed(uav.uav.spec.airspeed_mps)}};
    for (MavItem& item : pathItems(content, uav, maker))
        mission.items.push_back(item);
    Point end_m = uav.home_m;
    if (content.what == ExportScope::Path)
        end_m = endOf(uav).position_m;
    else if (!uav.visits.empty())
        end_m = uav.visits.back().position_m;
    mission.items.push_back(maker.lastLoiter(end_m));
    return mission;
}

} // namespace berg
