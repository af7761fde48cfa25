#pragma once

#include "core/base/geometry.h"

namespace berg {

/** WGS 84 position, degrees. */
struct LatLon
{
    double latitude_deg = 0;
    double longitude_deg = 0;
    bool operator==(const LatLon&) const = default;
};

/**
 * Plane of east/north metres about an origin: the azimuthal equidistant projection of
 * GeographicLib (Karney 2013), exact both ways up to rounding, also at the poles and across
 * the antimeridian.
 */
class LocalFrame
{
public:
    explicit LocalFrame(LatLon origin);

    [[nodiscard]] LatLon origin() const { return m_origin; }
    /** East, north in metres. */
    [[nodiscard]] Point toPlane(LatLon place) const;
    /** Longitude in [-180, 180). */
    [[nodiscard]] LatLon toGeographic(const Point& position_m) const;
    /** Direction of true north there, radians counter-clockwise from the y axis of the plane. */
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
 * UPS, 0.994 at the pole. Only the other pole has no place in it.
 */
class PolarFrame
{
public:
    /** The meridian points down from the North Pole, up from the South Pole. */
    PolarFrame(Pole pole, double centralMeridian_deg);

    [[nodiscard]] Pole pole() const { return m_pole; }
    /** Right and up from the pole in metres. */
    [[nodiscard]] Point toPlane(LatLon place) const;
    /** Longitude in [-180, 180). */
    [[nodiscard]] LatLon toGeographic(const Point& position_m) const;

    bool operator==(const PolarFrame&) const = default;

private:
    Pole m_pole;
    double m_centralMeridian_deg;
};

} // namespace berg
