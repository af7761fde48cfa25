#include "core/base/geodesy.h"

#include <GeographicLib/AzimuthalEquidistant.hpp>
#include <GeographicLib/PolarStereographic.hpp>
#include <cmath>

namespace berg {

namespace {

constexpr double kArm_deg = 0.001; // short against the Earth, long against rounding

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

double LocalFrame::trueNorth_rad(const LatLon& place) const
{
    const double step_deg = place.latitude_deg > 0 ? -kArm_deg : kArm_deg; // never past a pole
    const LatLon beside{.latitude_deg = place.latitude_deg + step_deg,
                        .longitude_deg = place.longitude_deg};
    const Point north_m = (toPlane(beside) - toPlane(place)) * (step_deg > 0 ? 1 : -1);
    return std::atan2(-north_m.x(), north_m.y());
}

PolarFrame::PolarFrame(Pole pole, double centralMeridian_deg)
    : m_pole(pole), m_centralMeridian_deg(centralMeridian_deg)
{
}

Point PolarFrame::toPlane(LatLon place) const
{
    Point p_m = Point::Zero();
    GeographicLib::PolarStereographic::UPS().Forward(m_pole == Pole::North, place.latitude_deg,
                                                     place.longitude_deg - m_centralMeridian_deg,
                                                     p_m.x(), p_m.y());
    return p_m;
}

LatLon PolarFrame::toGeographic(const Point& position_m) const
{
    LatLon place;
    GeographicLib::PolarStereographic::UPS().Reverse(m_pole == Pole::North, position_m.x(),
                                                     position_m.y(), place.latitude_deg,
                                                     place.longitude_deg);
    place.longitude_deg = std::remainder(place.longitude_deg + m_centralMeridian_deg, 360.0);
    if (place.longitude_deg >= 180)
        place.longitude_deg -= 360;
    return place;
}

} // namespace berg
