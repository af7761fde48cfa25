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

private:
    LatLon m_origin;
};

} // namespace berg
