#pragma once

#include "core/geometry/geometry.h"

namespace berg {

/** Position in WGS 84 degrees. */
struct LatLon
{
    double latitude_deg = 0;
    double longitude_deg = 0;
    bool operator==(const LatLon&) const = default;
};

/**
 * Returns the distance of two places on a sphere of the Earth's mean radius, m, accurate to half a
 * percent.
 */
[[nodiscard]] double greatCircle_m(const LatLon& a, const LatLon& b);

/**
 * Plane of east and north in metres around an origin: the azimuthal equidistant projection of
 * GeographicLib (Karney 2013), exact in both directions up to rounding, also at the poles and
 * across the antimeridian.
 */
class LocalFrame
{
public:
    explicit LocalFrame(LatLon origin);

    [[nodiscard]] LatLon origin() const { return m_origin; }
    /** Returns east and north of the origin in metres. */
    [[nodiscard]] Point toPlane(LatLon place) const;
    /** Returns the position with longitude in [-180, 180). */
    [[nodiscard]] LatLon toGeographic(const Point& position_m) const;
    /**
     * Returns the direction of true north at the place, radians counter-clockwise from the plane's
     * y axis.
     */
    [[nodiscard]] double trueNorth_rad(const LatLon& place) const;

    bool operator==(const LocalFrame&) const = default;

private:
    LatLon m_origin;
};

enum class Pole
{
    North,
    South
};

/**
 * Plane of a polar chart: the polar stereographic projection of GeographicLib with the scale of
 * UPS, 0.994 at the pole. It contains every place except the other pole.
 */
class PolarFrame
{
public:
    /** The central meridian points down from the North Pole or up from the South Pole. */
    PolarFrame(Pole pole, double centralMeridian_deg);

    [[nodiscard]] Pole pole() const { return m_pole; }
    /** Returns the position to the right of and above the pole, metres. */
    [[nodiscard]] Point toPlane(LatLon place) const;
    /** Returns the position with longitude in [-180, 180). */
    [[nodiscard]] LatLon toGeographic(const Point& position_m) const;

    bool operator==(const PolarFrame&) const = default;

private:
    Pole m_pole;
    double m_centralMeridian_deg;
};

} // namespace berg
