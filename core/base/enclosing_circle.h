#pragma once

#include "core/base/geometry.h"

#include <span>
#include <vector>

namespace berg {

struct Circle
{
    Point centre_m = Point::Zero();
    double radius_m = 0;
};

/**
 * The smallest circle round the points, exact but for rounding, whatever their order; needs one
 * point at least, and of one alone it is that point. Cost: linear, as the order they are taken in
 * is drawn; of few, the cube at worst.
 * Welzl, Smallest enclosing disks (1991), in its iterative form.
 */
[[nodiscard]] Circle enclosingCircle(std::span<const Point> points_m);

/** The same round the places that things of these numbers have. */
template <class PlaceOf>
[[nodiscard]] Circle circleRound(std::span<const int> numbers, const PlaceOf& placeOf)
{
    std::vector<Point> places_m;
    places_m.reserve(numbers.size());
    for (const int number : numbers)
        places_m.push_back(placeOf(number));
    return enclosingCircle(places_m);
}

} // namespace berg
