#pragma once

#include "core/base/geodesy.h"

#include <functional>
#include <span>
#include <vector>

namespace berg {

// Straight lines of the local plane as the longitude-latitude lines of RFC 7946: further vertices
// are put in where the two differ by more than a metre (long legs, high latitudes), and everything
// is cut at the antimeridian, so that no line crosses it.

/** A place and when it is passed. */
struct TimedPoint
{
    Point position_m = Point::Zero();
    double time_s = 0;
};

/** Longitude in [-180, 180], +180 where a part ends there coming from the west. */
struct TimedPlace
{
    LatLon place;
    double time_s = 0;
};

/** Takes points or places in turn. */
using PointSink = std::function<void(const TimedPoint& point)>;
/** `isFirst`: a part begins with it. */
using PlaceSink = std::function<void(const TimedPlace& place, bool isFirst)>;

/**
 * The line through the points that `eachPoint` hands on, in parts of two or more vertices each, as
 * long as it may be; times are interpolated. One part when the antimeridian is not crossed, none
 * for fewer than two points.
 */
void eachPlace(const LocalFrame& frame, const std::function<void(const PointSink&)>& eachPoint,
               const PlaceSink& take);

/**
 * Exterior rings of the simple polygon with these corners (at least three, in any sense), each
 * counter-clockwise and closed (first vertex repeated). One that holds a pole runs along it.
 */
[[nodiscard]] std::vector<std::vector<LatLon>> geographicPolygon(const LocalFrame& frame,
                                                                 std::span<const Point> corners_m);

} // namespace berg
