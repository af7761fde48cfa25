#pragma once

#include "core/geometry/geometry.h"

#include <span>
#include <vector>

namespace berg {

struct Circle
{
    Point centre_m = Point::Zero();
    double radius_m = 0;
};

/**
 * Returns the smallest circle around the points, exact except for rounding, in any order of them.
 * It has radius 0 for a single point. Throws `std::logic_error` if there are no points. Cost:
 * linear, because many points are taken in random order; for few points cubic at worst. Welzl,
 * Smallest enclosing disks (1991), in its iterative form.
 */
[[nodiscard]] Circle enclosingCircle(std::span<const Point> points_m);

/**
 * Returns the smallest circle around the points `placeOf(number)`. Throws `std::logic_error` if
 * there are no numbers.
 */
template <class Numbers, class PlaceOf>
[[nodiscard]] Circle circleRound(const Numbers& numbers, const PlaceOf& placeOf)
{
    std::vector<Point> places_m;
    places_m.reserve(numbers.size());
    for (const auto& number : numbers)
        places_m.push_back(placeOf(number));
    return enclosingCircle(places_m);
}

} // namespace berg
