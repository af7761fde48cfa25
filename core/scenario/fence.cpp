#include "core/scenario/fence.h"

#include "core/base/angles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace berg {

namespace {

/** Counter-clockwise, without corners on its edges. */
std::vector<Point> convexHull(std::vector<Point> points)
{
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    });
    std::vector<Point> hull;
    for (const bool isUpper : {false, true}) {
        const std::size_t first = hull.size();
        for (const Point& point : points) {
            while (hull.size() >= first + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0)
                hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back(); // the first one of the other half
        if (!isUpper)
            std::reverse(points.begin(), points.end());
    }
    return hull;
}

} // namespace

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

std::size_t FenceShape::cornerCount() const
{
    std::size_t count = corners_m.size();
    for (const std::vector<Point>& hole_m : holes_m)
        count += hole_m.size();
    return count;
}

FenceShape fenceShape(const Scenario& scenario, double altitude_m)
{
    FenceShape shape;
    if (scenario.geofence)
        shape.corners_m = scenario.area_m;
    for (NoFlyArea& area : closedAreas(scenario))
        if (isClosedAt(area, altitude_m))
            shape.holes_m.push_back(std::move(area.corners_m));
    return shape;
}

std::shared_ptr<const Geofence> fenceOf(const Scenario& scenario, double altitude_m,
                                        const Motion& motion)
{
    FenceShape shape = fenceShape(scenario, altitude_m);
    if (shape.cornerCount() == 0)
        return nullptr;
    return std::make_shared<const Geofence>(std::move(shape.corners_m), motion,
                                            std::move(shape.holes_m));
}

} // namespace berg
