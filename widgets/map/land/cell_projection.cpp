#include "widgets/map/land/cell_projection.h"

#include "core/base/angles.h"

#include <cmath>

namespace berg {
namespace {

/** Chebyshev points of [0, 1] with both ends; they spread the error evenly. */
double nodeAt(std::size_t index, std::size_t count)
{
    return 0.5 - 0.5 * std::cos(kPi * static_cast<double>(index) / static_cast<double>(count - 1));
}

} // namespace

CellProjection::CellProjection(const MapPlane& plane, LatLon southWest, double side_deg)
    : m_southWest(southWest), m_side_deg(side_deg)
{
    for (std::size_t i = 0; i < kNodes; ++i)
        for (std::size_t j = 0; j < kNodes; ++j)
            m_nodes_m[i][j] =
                toPlane(plane, {southWest.latitude_deg + side_deg * nodeAt(i, kNodes),
                                southWest.longitude_deg + side_deg * nodeAt(j, kNodes)});
}

/** Weights of the nodes at a point of the side, by the barycentric formula (Salzer 1972). */
CellProjection::Weights CellProjection::weightsAt(double share)
{
    Weights weights{};
    double sum = 0;
    for (std::size_t i = 0; i < kNodes; ++i) {
        const double away = share - nodeAt(i, kNodes);
        if (away == 0) {
            weights.fill(0);
            weights[i] = 1;
            return weights;
        }
        const bool isEnd = i == 0 || i + 1 == kNodes;
        weights[i] = (i % 2 == 0 ? 1.0 : -1.0) * (isEnd ? 0.5 : 1.0) / away;
        sum += weights[i];
    }
    for (double& weight : weights)
        weight /= sum;
    return weights;
}

Point CellProjection::operator()(LatLon place) const
{
    const Weights north = weightsAt((place.latitude_deg - m_southWest.latitude_deg) / m_side_deg);
    const Weights east = weightsAt((place.longitude_deg - m_southWest.longitude_deg) / m_side_deg);
    Point p_m = Point::Zero();
    for (std::size_t i = 0; i < kNodes; ++i) {
        Point row_m = Point::Zero();
        for (std::size_t j = 0; j < kNodes; ++j)
            row_m += east[j] * m_nodes_m[i][j];
        p_m += north[i] * row_m;
    }
    return p_m;
}

} // namespace berg
