#include "core/io/import/fields/area_outline.h"

#include "core/io/export/content/thinned_path.h"
#include "core/scenario/limits.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace berg {

namespace {

using Ring = std::vector<LatLon>;

constexpr double kSamePlace_deg = 1e-8; // a millimetre
/**
 * Distance within which the line between two vertices is straight, for `geographicLine` and
 * rounding.
 */
constexpr double kCut_m = 1.1;
constexpr double kLargestTolerance_m = 1;
constexpr double kTolerance = 1e-5; ///< of the size: bend in other planes

bool isClose(double a_deg, double b_deg)
{
    return std::abs(a_deg - b_deg) <= kSamePlace_deg;
}

bool onBorder(const LatLon& place)
{
    return isClose(std::abs(place.longitude_deg), 180);
}

/** Whether the edge was inserted where a polygon was cut: along the antimeridian, or at a pole. */
bool isCut(const LatLon& a, const LatLon& b)
{
    const bool atPole =
        isClose(std::abs(a.latitude_deg), 90) && isClose(a.latitude_deg, b.latitude_deg);
    return onBorder(a) && onBorder(b) && (atPole || isClose(a.longitude_deg, b.longitude_deg));
}

/** Returns the ring with each vertex once. */
Ring opened(const Ring& closed)
{
    Ring ring;
    for (const LatLon& place : closed)
        if (ring.empty() || !(ring.back() == place))
            ring.push_back(place);
    while (ring.size() > 1 && ring.back() == ring.front())
        ring.pop_back();
    return ring;
}

/** Returns the stretches of a ring between cuts; none if there is no cut. */
std::vector<Ring> stretchesOf(const Ring& ring)
{
    std::vector<Ring> stretches;
    const std::size_t count = ring.size();
    std::size_t start = 0;
    while (start < count && !isCut(ring[(start + count - 1) % count], ring[start]))
        ++start;
    if (start == count)
        return stretches;
    for (std::size_t i = 0; i < count; ++i) {
        const LatLon& place = ring[(start + i) % count];
        if (i == 0 || isCut(ring[(start + i - 1) % count], place))
            stretches.emplace_back();
        stretches.back().push_back(place);
    }
    std::erase_if(stretches, [](const Ring& stretch) { return stretch.size() < 2; });
    return stretches;
}

/**
 * Whether a line that ends at `end` continues at `start`, on the other side of the antimeridian.
 */
bool continues(const LatLon& end, const LatLon& start)
{
    return isClose(end.latitude_deg, start.latitude_deg) &&
           isClose(end.longitude_deg, -start.longitude_deg);
}

/** A vertex of the outline; at a cut there are two at one place. */
struct OutlineVertex
{
    LatLon place;
    bool beginsStretch = false;
    bool endsStretch = false;
};

/**
 * Joins all stretches one after the other. Returns no vertices if they do not form a single ring.
 */
std::vector<OutlineVertex> chained(const std::vector<Ring>& stretches)
{
    std::vector<OutlineVertex> outline;
    std::vector<bool> used(stretches.size(), false);
    std::size_t at = 0;
    for (std::size_t n = 0; n < stretches.size(); ++n) {
        used[at] = true;
        for (const LatLon& place : stretches[at])
            outline.push_back({.place = place});
        outline[outline.size() - stretches[at].size()].beginsStretch = true;
        outline.back().endsStretch = true;
        const bool isLast = n + 1 == stretches.size();
        std::size_t next = 0;
        while (next < stretches.size() &&
               !(continues(stretches[at].back(), stretches[next].front()) &&
                 (isLast ? next == 0 : !used[next])))
            ++next;
        if (next == stretches.size())
            return {};
        at = next;
    }
    return outline;
}

std::vector<OutlineVertex> verticesOf(std::span<const Ring> rings)
{
    std::vector<Ring> stretches;
    std::size_t uncut = 0;
    for (const Ring& closed : rings) {
        const std::vector<Ring> added = stretchesOf(opened(closed));
        uncut += added.empty() ? std::size_t{1} : std::size_t{0};
        stretches.insert(stretches.end(), added.begin(), added.end());
    }
    if (uncut == 0)
        if (std::vector<OutlineVertex> outline = chained(stretches); !outline.empty())
            return outline;
    std::vector<OutlineVertex> outline;
    if (rings.size() == 1)
        for (const LatLon& place : opened(rings.front()))
            outline.push_back({.place = place});
    return outline;
}

/**
 * Removes the vertices at cuts unless there is a corner; the times of the points are their order.
 */
std::vector<TimedPoint> withoutCuts(const std::vector<OutlineVertex>& vertices,
                                    const LocalFrame& frame)
{
    std::vector<TimedPoint> outline;
    const std::size_t count = vertices.size();
    const auto at = [&](std::size_t i) { return frame.toPlane(vertices[i % count].place); };
    for (std::size_t i = 0; i < count; ++i) {
        const OutlineVertex& vertex = vertices[i];
        if (vertex.beginsStretch ||
            (vertex.endsStretch &&
             distanceToSegment(at(i + count - 1), at(i + 2), at(i)) <= kCut_m))
            continue;
        outline.push_back({.position_m = at(i), .time_s = static_cast<double>(i)});
    }
    return outline;
}

/**
 * Removes vertices on straight lines, beginning at the farthest vertex, which is certainly a
 * corner.
 */
std::vector<Point> thinnedRing(std::vector<TimedPoint> ring)
{
    const Point from_m = ring.front().position_m;
    const auto farthest =
        std::max_element(ring.begin(), ring.end(), [&](const TimedPoint& a, const TimedPoint& b) {
            return (a.position_m - from_m).squaredNorm() < (b.position_m - from_m).squaredNorm();
        });
    const double size_m = (farthest->position_m - from_m).norm();
    std::rotate(ring.begin(), farthest, ring.end());
    ring.push_back(ring.front());
    std::vector<TimedPoint> corners =
        thinnedPath(ring, std::min(kLargestTolerance_m, kTolerance * size_m), kMostAreaCorners + 1);
    corners.pop_back();
    std::rotate(corners.begin(),
                std::min_element(
                    corners.begin(), corners.end(),
                    [](const TimedPoint& a, const TimedPoint& b) { return a.time_s < b.time_s; }),
                corners.end());
    std::vector<Point> outline_m;
    for (const TimedPoint& corner : corners)
        outline_m.push_back(corner.position_m);
    return outline_m;
}

} // namespace

std::vector<Point> areaOutline(std::span<const std::vector<LatLon>> rings, const LocalFrame& frame)
{
    const std::vector<OutlineVertex> vertices = verticesOf(rings);
    std::vector<TimedPoint> outline = withoutCuts(vertices, frame);
    if (outline.empty())
        return {};
    return thinnedRing(std::move(outline));
}

} // namespace berg
