#include "core/base/geodesy.h"

#include <GeographicLib/AzimuthalEquidistant.hpp>

namespace berg {

namespace {

const GeographicLib::AzimuthalEquidistant& projection()
{
    static const GeographicLib::AzimuthalEquidistant instance(GeographicLib::Geodesic::WGS84());
    return instance;
}

} // namespace

LocalFrame::LocalFrame(LatLon origin) : m_origin(origin) {}

Point LocalFrame::toPlane(LatLon place) const
{
    Point p_m = Point::Zero();
    projection().Forward(m_origin.latitude_deg, m_origin.longitude_deg, place.latitude_deg,
                         place.longitude_deg, p_m.x(), p_m.y());
    return p_m;
}

LatLon LocalFrame::toGeographic(const Point& position_m) const
{
    LatLon place;
    projection().Reverse(m_origin.latitude_deg, m_origin.longitude_deg, position_m.x(),
                         position_m.y(), place.latitude_deg, place.longitude_deg);
    if (place.longitude_deg >= 180)
        place.longitude_deg -= 360;
    return place;
}

} // namespace berg
