#include "core/geometry/polygon_area.h"

#include "core/base/error.h"

#include <algorithm>
#include <limits>

namespace berg {

namespace {

constexpr double kFarAway = std::numeric_limits<double>::infinity();

} // namespace

PolygonArea::PolygonArea(std::vector<Point> corners_m, std::vector<std::vector<Point>> holes_m)
    : m_rings_m(std::move(holes_m)), m_isBounded(!corners_m.empty())
{
    if (m_isBounded)
        m_rings_m.insert(m_rings_m.begin(), std::move(corners_m));
    for (std::size_t k = 0; k < m_rings_m.size(); ++k) {
        require(m_rings_m[k].size() >= 3, "PolygonArea: wrong number of corners");
        if ((signedArea(m_rings_m[k]) < 0) == (m_isBounded && k == 0))
            std::reverse(m_rings_m[k].begin(), m_rings_m[k].end());
    }
}

bool PolygonArea::isInHole(const Point& place_m) const
{
    return std::any_of(
        m_rings_m.begin() + (m_isBounded ? 1 : 0), m_rings_m.end(),
        [&](const std::vector<Point>& hole_m) { return insidePolygon(hole_m, place_m); });
}

bool PolygonArea::contains(const Point& place_m) const
{
    return (!m_isBounded || insidePolygon(m_rings_m.front(), place_m)) && !isInHole(place_m);
}

Point PolygonArea::nearestInside_m(const Point& place_m, double margin_m) const
{
    if (contains(place_m))
        return place_m;
    double least_m = kFarAway;
    Point best_m = place_m;
    for (const std::vector<Point>& ring_m : m_rings_m)
        for (std::size_t i = 0, j = ring_m.size() - 1; i < ring_m.size(); j = i++) {
            const Point edge_m = ring_m[i] - ring_m[j];
            const double share =
                std::clamp((place_m - ring_m[j]).dot(edge_m) / edge_m.squaredNorm(), 0.0, 1.0);
            const Point inwards = Point(-edge_m.y(), edge_m.x()).normalized();
            const Point beside_m = ring_m[j] + share * edge_m + margin_m * inwards;
            const double away_m = (beside_m - place_m).norm();
            if (away_m < least_m && contains(beside_m)) {
                least_m = away_m;
                best_m = beside_m;
            }
        }
    return best_m;
}

double PolygonArea::clearance_m(const Point& place_m) const
{
    double least_m = kFarAway;
    for (const std::vector<Point>& ring_m : m_rings_m)
        least_m = std::min(least_m, distanceToEdges(ring_m, place_m));
    return least_m;
}

double PolygonArea::clearance_m(const Point& from_m, const Point& to_m) const
{
    double least_m = kFarAway;
    for (const std::vector<Point>& ring_m : m_rings_m)
        least_m = std::min(least_m, distanceToEdges(ring_m, from_m, to_m));
    return least_m;
}

double PolygonArea::signedClearance_m(const Point& place_m) const
{
    const double distance_m = clearance_m(place_m);
    return contains(place_m) ? distance_m : -distance_m;
}

bool PolygonArea::meetsEdge(const Point& a, const Point& b) const
{
    for (const std::vector<Point>& ring_m : m_rings_m)
        for (std::size_t i = 0, j = ring_m.size() - 1; i < ring_m.size(); j = i++)
            if (segmentsMeet(a, b, ring_m[j], ring_m[i]))
                return true;
    return false;
}

} // namespace berg
