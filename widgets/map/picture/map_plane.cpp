#include "widgets/map/picture/map_plane.h"

#include "core/base/angles.h"

namespace berg {

Point toPlane(const MapPlane& plane, LatLon place)
{
    return std::visit([&](const auto& frame) { return frame.toPlane(place); }, plane);
}

LatLon toGeographic(const MapPlane& plane, const Point& position_m)
{
    return std::visit([&](const auto& frame) { return frame.toGeographic(position_m); }, plane);
}

double mapReach_m(const MapPlane& plane)
{
    if (const auto* polar = std::get_if<PolarFrame>(&plane)) {
        const double latitude_deg = 90 - kMapReach_deg;
        return polar->toPlane({polar->pole() == Pole::North ? latitude_deg : -latitude_deg, 0})
            .norm();
    }
    return radFromDeg(kMapReach_deg) * kEarthRadius_m;
}

} // namespace berg
