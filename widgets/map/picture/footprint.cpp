#include "widgets/map/picture/footprint.h"

#include "core/base/angles.h"

#include <cmath>

namespace berg {

std::vector<Point> footprintCorners(const SensorSpec& sensor, int diskCorners)
{
    const Point half_m = 0.5 * sensor.fov_m;
    if (sensor.shape != FovShape::Disk)
        return {{half_m.x(), half_m.y()},
                {-half_m.x(), half_m.y()},
                {-half_m.x(), -half_m.y()},
                {half_m.x(), -half_m.y()}};
    std::vector<Point> corners_m;
    for (int i = 0; i < diskCorners; ++i) {
        const double angle_rad = 2 * kPi * (i + 0.5) / diskCorners;
        corners_m.emplace_back(half_m.x() * Point(std::cos(angle_rad), std::sin(angle_rad)));
    }
    return corners_m;
}

double footprintTurn_rad(const SensorSpec& sensor, double psi_rad)
{
    switch (sensor.shape) {
    case FovShape::Body:
        return psi_rad;
    case FovShape::North:
        return kPi / 2;
    case FovShape::Disk:
        return 0;
    }
    return 0;
}

std::vector<Point> fieldCorners(const MapUav& uav)
{
    constexpr int kDiskCorners = 72;
    const double turn_rad = footprintTurn_rad(uav.sensor, uav.psi_rad);
    const Point along(std::cos(turn_rad), std::sin(turn_rad));
    const Point across(-along.y(), along.x());
    std::vector<Point> corners_m = footprintCorners(uav.sensor, kDiskCorners);
    for (Point& corner_m : corners_m)
        corner_m = Point(uav.position_m + along * corner_m.x() + across * corner_m.y());
    return corners_m;
}

QPolygonF fieldOutline(const MapUav& uav, const MapViewTransform& view)
{
    QPolygonF outline = view.toPixels(fieldCorners(uav));
    outline << outline.front();
    return outline;
}

} // namespace berg
