#pragma once

#include "core/earth/geodesy.h"

#include <variant>

namespace berg {

/** Projection plane of a map: the local plane of a scenario or a polar chart. */
using MapPlane = std::variant<LocalFrame, PolarFrame>;

/** Projects a place to metres from the middle of the plane. */
[[nodiscard]] Point toPlane(const MapPlane& plane, LatLon place);
/** Returns the geographic place of a point of the plane (inverse of `toPlane`). */
[[nodiscard]] LatLon toGeographic(const MapPlane& plane, const Point& position_m);

/** Mean radius of the Earth, for approximate lengths. */
inline constexpr double kEarthRadius_m = 6'371'000;

/** Largest arc from the middle of a plane that a map shows; distortion grows too large beyond. */
inline constexpr double kMapReach_deg = 60;

/** Returns the radius of that arc in the plane, metres. */
[[nodiscard]] double mapReach_m(const MapPlane& plane);

} // namespace berg
