#pragma once

#include "core/earth/geodesy.h"

#include <functional>
#include <span>
#include <vector>

namespace berg {

// Straight lines of the local plane as the longitude-latitude lines of RFC 7946: vertices are added
// where the two differ by more than a metre (long legs, high latitudes), and everything is cut at
// the antimeridian, so that no line crosses it.

/** A point of a path with the time at which it is passed. */
struct TimedPoint
{
    Point position_m = Point::Zero();
    double time_s = 0;
};

/**
 * A place of a path with its time; longitude in [-180, 180], +180 if a part ends there eastwards.
 */
struct TimedPlace
{
    LatLon place;
    double time_s = 0;
};

/** Receives points one by one. */
using PointSink = std::function<void(const TimedPoint& point)>;
/** Receives places one by one; `isFirst` is true for the first place of a part. */
using PlaceSink = std::function<void(const TimedPlace& place, bool isFirst)>;

/**
 * Passes the line through the points supplied by `eachPoint` to `take`, in parts of two or more
 * vertices each, for a line of any length; times are interpolated. There is one part if the
 * antimeridian is not crossed, and none for fewer than two points.
 */
void eachPlace(const LocalFrame& frame, const std::function<void(const PointSink&)>& eachPoint,
               const PlaceSink& take);

/**
 * Returns the exterior rings of a simple polygon with at least three corners in any sense. Each
 * ring is counter-clockwise and closed (the first vertex is repeated); one that contains a pole
 * runs along it.
 */
[[nodiscard]] std::vector<std::vector<LatLon>> geographicPolygon(const LocalFrame& frame,
                                                                 std::span<const Point> corners_m);

} // namespace berg
