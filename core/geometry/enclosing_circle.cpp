#include "core/geometry/enclosing_circle.h"

#include "core/base/error.h"
#include "core/base/random.h"

#include <array>
#include <utility>
#include <vector>

namespace berg {

namespace {

/** Number of points for which the cubic cost does not matter. */
constexpr std::size_t kFew = 50;
/** Relative distance outside the radius that counts as rounding. */
constexpr double kRounding = 1e-12;

bool isInside(const Circle& circle, const Point& p_m)
{
    return (p_m - circle.centre_m).norm() <= circle.radius_m * (1 + kRounding);
}

Circle over(const Point& a_m, const Point& b_m)
{
    return {.centre_m = (a_m + b_m) / 2, .radius_m = (b_m - a_m).norm() / 2};
}

/** Circle through all three points, or over the two farthest apart if they are on a line. */
Circle through(const Point& a_m, const Point& b_m, const Point& c_m)
{
    const Point ab_m = b_m - a_m;
    const Point ac_m = c_m - a_m;
    const double twice_m2 = 2 * cross(ab_m, ac_m);
    const Point numerator(ac_m.y() * ab_m.squaredNorm() - ab_m.y() * ac_m.squaredNorm(),
                          ab_m.x() * ac_m.squaredNorm() - ac_m.x() * ab_m.squaredNorm());
    const Point toCentre_m = numerator / twice_m2;
    if (toCentre_m.allFinite())
        return {.centre_m = a_m + toCentre_m, .radius_m = toCentre_m.norm()};
    Circle largest = over(a_m, b_m);
    for (const Circle& circle : std::array{over(a_m, c_m), over(b_m, c_m)})
        if (circle.radius_m > largest.radius_m)
            largest = circle;
    return largest;
}

/** Smallest circle around `points_m` that passes through `a_m` and `b_m`. */
Circle withTwoOn(const Point& a_m, const Point& b_m, std::span<const Point> points_m)
{
    Circle circle = over(a_m, b_m);
    for (const Point& p_m : points_m)
        if (!isInside(circle, p_m))
            circle = through(a_m, b_m, p_m);
    return circle;
}

/** Smallest circle around `points_m` that passes through `a_m`. */
Circle withOneOn(const Point& a_m, std::span<const Point> points_m)
{
    Circle circle{.centre_m = a_m};
    for (std::size_t i = 0; i < points_m.size(); ++i)
        if (!isInside(circle, points_m[i]))
            circle = withTwoOn(a_m, points_m[i], points_m.first(i));
    return circle;
}

Circle around(std::span<const Point> points_m)
{
    Circle circle{.centre_m = points_m.front()};
    for (std::size_t i = 1; i < points_m.size(); ++i)
        if (!isInside(circle, points_m[i]))
            circle = withOneOn(points_m[i], points_m.first(i));
    return circle;
}

/**
 * Shuffles deterministically: in the order of a path nearly every point would be outside the circle
 * of those before.
 */
std::vector<Point> shuffled(std::span<const Point> points_m)
{
    std::vector<Point> places_m(points_m.begin(), points_m.end());
    Random random(0, points_m.size());
    for (std::size_t i = places_m.size() - 1; i > 0; --i)
        std::swap(places_m[i], places_m[random.below(i + 1)]);
    return places_m;
}

} // namespace

Circle enclosingCircle(std::span<const Point> points_m)
{
    require(!points_m.empty(), "enclosingCircle: no points");
    return points_m.size() > kFew ? around(shuffled(points_m)) : around(points_m);
}

} // namespace berg
