#include "core/earth/geodesy.h"

#include "core/base/angles.h"

#include <GeographicLib/AzimuthalEquidistant.hpp>
#include <GeographicLib/PolarStereographic.hpp>
#include <algorithm>
#include <cmath>

namespace berg {

namespace {

// Short on the scale of the Earth, long compared with rounding errors.
constexpr double kArm_deg = 0.001;

const GeographicLib::AzimuthalEquidistant& projection()
{
    static const GeographicLib::AzimuthalEquidistant instance(GeographicLib::Geodesic::WGS84());
    return instance;
}

Eigen::Vector3d directionTo(const LatLon& place)
{
    const double latitude_rad = radFromDeg(place.latitude_deg);
    const double longitude_rad = radFromDeg(place.longitude_deg);
    return {std::cos(latitude_rad) * std::cos(longitude_rad),
            std::cos(latitude_rad) * std::sin(longitude_rad), std::sin(latitude_rad)};
}

} // namespace

double greatCircle_m(const LatLon& a, const LatLon& b)
{
    constexpr double kEarth_m = 6371008.8;
    const double chord = (directionTo(a) - directionTo(b)).norm();
    return 2 * kEarth_m * std::asin(std::min(1.0, chord / 2));
}

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
    // Never steps past a pole.
    const double step_deg = place.latitude_deg > 0 ? -kArm_deg : kArm_deg;
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
