#include "core/io/import/fields/area_centroid.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

/**
 * Area and first moment about the origin of the plane; both are positive for either sense of a
 * ring.
 */
struct AreaMoment
{
    double area = 0;
    Point moment = Point::Zero();
};

double turnedNear(double x, double near, double turn)
{
    return turn > 0 ? near + std::remainder(x - near, turn) : x;
}

/**
 * Returns the corners without the one that closes the ring, each in the shorter direction from the
 * previous one, the first in the shorter direction from `near_x`. Returns no corners if the ring
 * goes around a pole or has fewer than three.
 */
AreaRing unrolled(const AreaRing& given, double turn, double near_x)
{
    AreaRing ring = given;
    if (ring.size() > 1 && ring.front() == ring.back())
        ring.pop_back();
    if (ring.size() < 3)
        return {};
    double before = near_x;
    for (Point& corner : ring) {
        corner.x() = turnedNear(corner.x(), before, turn);
        before = corner.x();
    }
    const double closing = turnedNear(ring.front().x(), before, turn);
    return std::abs(closing - ring.front().x()) > turn / 2 && turn > 0 ? AreaRing() : ring;
}

AreaMoment momentOf(const AreaRing& ring)
{
    AreaMoment sum;
    const Point& first = ring.front();
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        const Point a = ring[i] - first;
        const Point b = ring[i + 1] - first;
        const double area = (a.x() * b.y() - a.y() * b.x()) / 2;
        sum.area += area;
        sum.moment += area * (a + b) / 3;
    }
    if (sum.area < 0)
        sum = {.area = -sum.area, .moment = -sum.moment};
    sum.moment += sum.area * first;
    return sum;
}

/**
 * Returns the moment of the outline less its holes, with x near `near_x`, or nullopt for a faulty
 * outline.
 */
std::optional<AreaMoment> momentOf(const AreaRings& polygon, double turn, double near_x)
{
    const AreaRing outline = polygon.empty() ? AreaRing() : unrolled(polygon.front(), turn, near_x);
    if (outline.empty())
        return std::nullopt;
    AreaMoment sum = momentOf(outline);
    for (std::size_t i = 1; i < polygon.size(); ++i)
        if (const AreaRing hole = unrolled(polygon[i], turn, outline.front().x()); !hole.empty()) {
            const AreaMoment cut = momentOf(hole);
            sum.area -= cut.area;
            sum.moment -= cut.moment;
        }
    Eigen::AlignedBox2d box;
    Point mean = Point::Zero();
    for (const Point& corner : outline) {
        box.extend(corner);
        mean += corner / static_cast<double>(outline.size());
    }
    const Point middle = sum.moment / sum.area; // not finite without an area
    if (!(sum.area > 0) || !middle.allFinite() || !box.contains(middle))
        return AreaMoment{.area = 0, .moment = mean};
    return sum;
}

Point middleOf(const AreaMoment& sum, double turn)
{
    Point middle = sum.area > 0 ? Point(sum.moment / sum.area) : sum.moment;
    middle.x() = turnedNear(middle.x(), 0, turn);
    return middle;
}

/** Latitudes at which an outline touches the antimeridian, and from which side. */
struct Cut
{
    std::size_t polygon = 0;
    double south = 90;
    double north = -90;
    bool isWest = false; ///< lies west of the antimeridian
    bool isEast = false;
};

std::vector<Cut> cutsOf(std::span<const AreaRings> polygons)
{
    std::vector<Cut> cuts;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        Cut cut{.polygon = i};
        for (const Point& corner : polygons[i].empty() ? AreaRing() : polygons[i].front()) {
            if (std::abs(corner.x()) != kTurn_deg / 2)
                continue;
            (corner.x() > 0 ? cut.isWest : cut.isEast) = true;
            cut.south = std::min(cut.south, corner.y());
            cut.north = std::max(cut.north, corner.y());
        }
        if (cut.isWest != cut.isEast)
            cuts.push_back(cut);
    }
    return cuts;
}

/** Returns for each polygon the earlier one of which it is the other half, else itself. */
std::vector<std::size_t> wholesOf(std::span<const AreaRings> polygons)
{
    constexpr std::size_t kMostCuts = 1000; // each pair is compared
    std::vector<std::size_t> wholes(polygons.size());
    for (std::size_t i = 0; i < wholes.size(); ++i)
        wholes[i] = i;
    const std::vector<Cut> cuts = cutsOf(polygons);
    for (std::size_t i = 0; i < cuts.size() && cuts.size() <= kMostCuts; ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (cuts[i].isWest != cuts[j].isWest &&
                std::min(cuts[i].north, cuts[j].north) > std::max(cuts[i].south, cuts[j].south)) {
                wholes[cuts[i].polygon] = wholes[cuts[j].polygon];
                break;
            }
    return wholes;
}

} // namespace

std::optional<Point> centroidOf(const AreaRings& polygon, double turn)
{
    const double near_x = polygon.empty() || polygon.front().empty() ? 0 : polygon[0][0].x();
    const std::optional<AreaMoment> sum = momentOf(polygon, turn, near_x);
    return sum ? std::optional(middleOf(*sum, turn)) : std::nullopt;
}

std::vector<Point> centroidsOf(std::span<const AreaRings> polygons, double turn)
{
    const std::vector<std::size_t> wholes =
        turn > 0 ? wholesOf(polygons) : std::vector<std::size_t>();
    std::vector<std::optional<AreaMoment>> sums(polygons.size());
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const std::size_t whole = wholes.empty() ? i : wholes[i];
        const double near_x = polygons[whole][0][0].x();
        const AreaMoment part = momentOf(polygons[i], turn, near_x).value_or(AreaMoment{});
        if (!sums[whole]) {
            sums[whole] = part;
        } else {
            sums[whole]->area += part.area;
            sums[whole]->moment += part.moment;
        }
    }
    std::vector<Point> centroids;
    for (const std::optional<AreaMoment>& sum : sums)
        if (sum)
            centroids.push_back(middleOf(*sum, turn));
    return centroids;
}

} // namespace berg
