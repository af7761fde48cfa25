#pragma once

#include "widgets/map/picture/map_plane.h"

#include <array>

namespace berg {

/**
 * Polynomial approximation of the projection in one cell of longitude and latitude. It is some
 * hundred times faster than the projection, and accurate to a millimetre for cells of 5 degrees
 * within reach of the plane.
 */
class CellProjection
{
public:
    /** Interpolates `plane` in the square cell with this corner and side. */
    CellProjection(const MapPlane& plane, LatLon southWest, double side_deg);

    /** Projects a place, which must be in the cell; metres. */
    [[nodiscard]] Point operator()(LatLon place) const;

private:
    static constexpr std::size_t kNodes = 6; ///< per side

    using Weights = std::array<double, kNodes>;
    [[nodiscard]] static Weights weightsAt(double share);

    LatLon m_southWest;
    double m_side_deg;
    std::array<std::array<Point, kNodes>, kNodes> m_nodes_m; ///< by latitude, then longitude
};

} // namespace berg
