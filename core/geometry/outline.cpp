#include "core/geometry/outline.h"

#include "core/base/angles.h"
#include "core/geometry/edge_sweep.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

constexpr int kArcsOfCircle = 24;
/**
 * Number of places at which the outline of a non-convex polygon is computed; straight lines join
 * them.
 */
constexpr std::size_t kPlacesOfEdges = 2400;
constexpr std::size_t kMostStepsOfEdge = 48;
constexpr double kAll = 1 - 1e-9; ///< factor on distances that allows for rounding

/** Appends an arc around the centre from the direction of `normal` on, as a tangent polygon. */
void appendArc(std::vector<Point>& outline, const Point& centre_m, const Point& normal,
               double turn_rad, double radius_m)
{
    const int arcs = std::max(1, static_cast<int>(std::ceil(turn_rad * kArcsOfCircle / (2 * kPi))));
    const double half_rad = turn_rad / arcs / 2;
    for (int i = 0; i < arcs; ++i)
        outline.emplace_back(centre_m + turned(normal, (2 * i + 1) * half_rad) * radius_m /
                                            std::cos(half_rad));
}

/** Returns the angle by which edges turn left at a corner, half a turn at the end of a line. */
double turnAt(const Point& in, const Point& out)
{
    const double side = cross(in, out);
    return side == 0 && in.dot(out) < 0 ? kPi : std::atan2(side, in.dot(out));
}

/** Grows a counter-clockwise polygon without consecutive equal corners. */
class Growth
{
public:
    Growth(std::span<const Point> corners_m, double by_m) : m_corners_m(corners_m), m_by_m(by_m)
    {
        for (std::size_t i = 0; i < corners_m.size(); ++i)
            m_isConvex = m_isConvex && turnAt(edge(i + corners_m.size() - 1), edge(i)) >= 0;
    }

    [[nodiscard]] std::vector<Point> outline() const
    {
        std::vector<Point> outline_m;
        const int steps =
            static_cast<int>(std::min(kMostStepsOfEdge, 4 + kPlacesOfEdges / m_corners_m.size()));
        for (std::size_t i = 0; i < m_corners_m.size(); ++i) {
            const std::size_t before = i + m_corners_m.size() - 1;
            std::vector<Point> part_m;
            if (const double turn_rad = turnAt(edge(before), edge(i)); turn_rad > 0)
                appendArc(part_m, at(i), normal(before), turn_rad, m_by_m);
            for (int step = 0; !m_isConvex && step <= steps; ++step)
                part_m.emplace_back(at(i) + edge(i) * step / steps + normal(i) * m_by_m);
            for (const Point& place_m : part_m)
                if (m_isConvex || isOutside(place_m))
                    append(outline_m, place_m);
        }
        return outline_m;
    }

private:
    [[nodiscard]] const Point& at(std::size_t i) const
    {
        return m_corners_m[i % m_corners_m.size()];
    }
    [[nodiscard]] Point edge(std::size_t i) const { return at(i + 1) - at(i); }
    /** Outward unit normal of an edge. */
    [[nodiscard]] Point normal(std::size_t i) const
    {
        const Point along = edge(i).normalized();
        return {along.y(), -along.x()};
    }
    /** Returns true if the place is outside the grown polygon or on its outline. */
    [[nodiscard]] bool isOutside(const Point& place_m) const
    {
        return distanceToEdges(m_corners_m, place_m) >= m_by_m * kAll &&
               !insidePolygon(m_corners_m, place_m);
    }
    /** Appends a place and removes a corner on a straight line. */
    static void append(std::vector<Point>& outline_m, const Point& place_m)
    {
        constexpr double kStraight_m = 1e-6;
        const std::size_t count = outline_m.size();
        if (count > 1) {
            const Point along = (outline_m[count - 1] - outline_m[count - 2]).normalized();
            const Point next_m = place_m - outline_m[count - 1];
            if (std::abs(cross(along, next_m)) < kStraight_m && along.dot(next_m) >= 0) {
                outline_m.back() = place_m;
                return;
            }
        }
        outline_m.push_back(place_m);
    }

    std::span<const Point> m_corners_m;
    double m_by_m;
    bool m_isConvex = true;
};

/** Returns true if the outline is a single line that surrounds the polygon at the distance. */
bool isRound(std::span<const Point> outline_m, std::span<const Point> polygon_m, double by_m)
{
    if (outline_m.size() < 3 || !insidePolygon(outline_m, polygon_m.front()))
        return false;
    for (std::size_t i = 0; polygon_m.size() > 2 && i < outline_m.size(); ++i)
        if (distanceToEdges(polygon_m, outline_m[i], outline_m[(i + 1) % outline_m.size()]) <
            by_m * (1 - 1e-6))
            return false;
    return isSimplePolygon(outline_m);
}

Eigen::AlignedBox2d boxOf(std::span<const Point> corners)
{
    Eigen::AlignedBox2d box;
    for (const Point& corner : corners)
        box.extend(corner);
    return box;
}

} // namespace

std::vector<Point> convexHull(std::vector<Point> points)
{
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 2)
        return points;
    std::vector<Point> hull;
    for (const bool isUpper : {false, true}) {
        const std::size_t first = hull.size();
        for (const Point& point : points) {
            while (hull.size() >= first + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0)
                hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back(); // it is the first of the other half
        if (!isUpper)
            std::reverse(points.begin(), points.end());
    }
    return hull;
}

std::vector<Point> grownOutline(std::span<const Point> corners_m, double by_m)
{
    std::vector<Point> polygon_m;
    for (const Point& corner_m : corners_m)
        if (polygon_m.empty() || polygon_m.back() != corner_m)
            polygon_m.push_back(corner_m);
    while (polygon_m.size() > 1 && polygon_m.back() == polygon_m.front())
        polygon_m.pop_back();
    std::vector<Point> outline_m;
    if (polygon_m.size() < 2) {
        if (!polygon_m.empty())
            appendArc(outline_m, polygon_m.front(), {1, 0}, 2 * kPi, by_m);
        return outline_m;
    }
    if (signedArea(polygon_m) < 0)
        std::reverse(polygon_m.begin(), polygon_m.end());
    outline_m = Growth(polygon_m, by_m).outline();
    if (isRound(outline_m, polygon_m, by_m))
        return outline_m;
    return Growth(convexHull(std::move(polygon_m)), by_m).outline();
}

bool polygonsMeet(std::span<const Point> a, std::span<const Point> b)
{
    const Eigen::AlignedBox2d common = boxOf(a).intersection(boxOf(b));
    if (a.size() < 3 || b.size() < 3 || common.isEmpty())
        return false;
    if (insidePolygon(a, b.front()) || insidePolygon(b, a.front()))
        return true;
    std::vector<SweptEdge> edges;
    const auto add = [&](std::span<const Point> polygon, std::size_t whose) {
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Point& from = polygon[i];
            const Point& to = polygon[(i + 1) % polygon.size()];
            if (common.intersects({from.cwiseMin(to), from.cwiseMax(to)}))
                edges.push_back({.from = from, .to = to, .index = whose});
        }
    };
    add(a, 0);
    add(b, 1);
    return anyMeet(std::move(edges), [](const SweptEdge& one, const SweptEdge& other) {
        return one.index != other.index && segmentsMeet(one.from, one.to, other.from, other.to);
    });
}

} // namespace berg
