#include "core/geometry/geometry.h"

#include "core/geometry/edge_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace berg {

namespace {

int orientation(const Point& a, const Point& b, const Point& c)
{
    const double area = cross(b - a, c - a);
    return area > 0 ? 1 : (area < 0 ? -1 : 0);
}

bool onSegment(const Point& a, const Point& b, const Point& p)
{
    return p.x() >= std::min(a.x(), b.x()) && p.x() <= std::max(a.x(), b.x()) &&
           p.y() >= std::min(a.y(), b.y()) && p.y() <= std::max(a.y(), b.y());
}

/** Returns true if the edges a-b and b-c fold back on each other. */
bool foldsBack(const Point& a, const Point& b, const Point& c)
{
    return orientation(a, b, c) == 0 && (b - a).dot(c - b) <= 0;
}

} // namespace

bool segmentsMeet(const Point& a, const Point& b, const Point& c, const Point& d)
{
    const int abc = orientation(a, b, c);
    const int abd = orientation(a, b, d);
    const int cda = orientation(c, d, a);
    const int cdb = orientation(c, d, b);
    if (abc != abd && cda != cdb)
        return true;
    return (abc == 0 && onSegment(a, b, c)) || (abd == 0 && onSegment(a, b, d)) ||
           (cda == 0 && onSegment(c, d, a)) || (cdb == 0 && onSegment(c, d, b));
}

Point turned(const Point& vector, double angle_rad)
{
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    return {c * vector.x() - s * vector.y(), s * vector.x() + c * vector.y()};
}

bool insidePolygon(std::span<const Point> polygon, const Point& p)
{
    bool inside = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Point& a = polygon[i];
        const Point& b = polygon[j];
        if ((a.y() > p.y()) == (b.y() > p.y()))
            continue;
        if (p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x())
            inside = !inside;
    }
    return inside;
}

Point nearestOnSegment(const Point& a, const Point& b, const Point& p)
{
    const Point path = b - a;
    const double length2 = path.squaredNorm();
    const double share = length2 > 0 ? std::clamp((p - a).dot(path) / length2, 0.0, 1.0) : 0.0;
    return a + share * path;
}

double distanceToSegment(const Point& a, const Point& b, const Point& p)
{
    return (p - nearestOnSegment(a, b, p)).norm();
}

double distanceToEdges(std::span<const Point> polygon, const Point& p)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
        least = std::min(least, distanceToSegment(polygon[j], polygon[i], p));
    return least;
}

double distanceToEdges(std::span<const Point> polygon, const Point& a, const Point& b)
{
    // If two segments do not meet, an end of one is nearest to the other.
    double least = std::min(distanceToEdges(polygon, a), distanceToEdges(polygon, b));
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        if (segmentsMeet(polygon[j], polygon[i], a, b))
            return 0;
        least = std::min(least, distanceToSegment(a, b, polygon[i]));
    }
    return least;
}

bool isSimplePolygon(std::span<const Point> polygon)
{
    const std::size_t n = polygon.size();
    if (n < 3)
        return false;
    std::vector<SweptEdge> edges;
    for (std::size_t i = 0; i < n; ++i) {
        if (foldsBack(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]))
            return false;
        edges.push_back({.from = polygon[i], .to = polygon[(i + 1) % n], .index = i});
    }
    return !anyMeet(std::move(edges), [n](const SweptEdge& a, const SweptEdge& b) {
        const bool areNeighbours = (a.index + 1) % n == b.index || (b.index + 1) % n == a.index;
        return !areNeighbours && segmentsMeet(a.from, a.to, b.from, b.to);
    });
}

bool isClearEdge(std::span<const Point> path, const Point& next)
{
    const Point& end = path.back();
    if (next == end)
        return false;
    const std::size_t edges = path.size() - 1;
    if (edges > 0 && foldsBack(path[edges - 1], end, next))
        return false;
    for (std::size_t i = 0; i + 1 < edges; ++i)
        if (segmentsMeet(path[i], path[i + 1], end, next))
            return false;
    return true;
}

double signedArea(std::span<const Point> polygon)
{
    double twice = 0;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
        twice += cross(polygon[j], polygon[i]);
    return twice / 2;
}

} // namespace berg
