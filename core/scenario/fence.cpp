#include "core/scenario/fence.h"

#include "core/base/angles.h"
#include "core/geometry/outline.h"

#include <algorithm>
#include <cmath>

namespace berg {

std::optional<NoFlyArea> standoffArea(const Asset& asset, double duration_s)
{
    if (!(asset.standoff_m > 0))
        return std::nullopt;
    const double radius_m = asset.standoff_m / std::cos(kPi / kRingCorners);
    std::vector<Point> swept_m;
    for (const double time_s : {0.0, duration_s})
        for (int i = 0; i < kRingCorners; ++i) {
            const double angle_rad = 2 * kPi * (i + 0.5) / kRingCorners;
            swept_m.emplace_back(asset.position_m + asset.velocity_mps * time_s +
                                 radius_m * Point(std::cos(angle_rad), std::sin(angle_rad)));
        }
    if (asset.velocity_mps.isZero(0))
        swept_m.resize(kRingCorners);
    else
        swept_m = convexHull(std::move(swept_m));
    return NoFlyArea{
        .name = asset.name, .corners_m = std::move(swept_m), .ceiling_m = asset.standoffCeiling_m};
}

std::vector<NoFlyArea> closedAreas(const Scenario& scenario)
{
    std::vector<NoFlyArea> areas = scenario.noFly;
    if (scenario.asset)
        if (std::optional<NoFlyArea> ring = standoffArea(*scenario.asset, scenario.duration_s))
            areas.push_back(std::move(*ring));
    return areas;
}

bool isClosedAt(const NoFlyArea& area, double altitude_m)
{
    return area.floor_m <= altitude_m && altitude_m <= area.ceiling_m.value_or(altitude_m);
}

std::size_t closedAt(std::span<const NoFlyArea> areas, double altitude_m, const Point& place_m)
{
    return static_cast<std::size_t>(std::ranges::find_if(areas,
                                                         [&](const NoFlyArea& area) {
                                                             return isClosedAt(area, altitude_m) &&
                                                                    insidePolygon(area.corners_m,
                                                                                  place_m);
                                                         }) -
                                    areas.begin());
}

std::size_t cornersAt(std::span<const NoFlyArea> areas, double altitude_m)
{
    std::size_t corners = 0;
    for (const NoFlyArea& area : areas)
        corners += isClosedAt(area, altitude_m) ? area.corners_m.size() : 0;
    return corners;
}

std::shared_ptr<const Geofence> fenceOf(const Scenario& scenario, double altitude_m,
                                        const Motion& motion)
{
    std::vector<std::vector<Point>> holes_m;
    for (NoFlyArea& area : closedAreas(scenario))
        if (isClosedAt(area, altitude_m))
            holes_m.push_back(std::move(area.corners_m));
    if (!scenario.geofence && holes_m.empty())
        return nullptr;
    return std::make_shared<const Geofence>(
        scenario.geofence ? scenario.area_m : std::vector<Point>(), motion, std::move(holes_m));
}

std::optional<SortieSpec> sortieOf(const Uav& uav)
{
    if (uav.spec.endurance_s == 0)
        return std::nullopt;
    return SortieSpec{.endurance_s = usableEndurance_s(uav.spec),
                      .turnaround_s = uav.spec.landing_s + uav.turnaround_s + uav.spec.climb_s,
                      .home_m = uav.home_m.value_or(uav.position_m)};
}

} // namespace berg
