#pragma once

#include "core/base/geodesy.h"

#include <variant>

namespace berg {

/** A plane that a map can be drawn in: about a scenario, or a polar chart. */
using MapPlane = std::variant<LocalFrame, PolarFrame>;

/** In metres; the middle of the plane is (0, 0). */
[[nodiscard]] Point toPlane(const MapPlane& plane, LatLon place);
[[nodiscard]] LatLon toGeographic(const MapPlane& plane, const Point& position_m);

/** Mean radius; for what need not be exact. */
inline constexpr double kEarthRadius_m = 6'371'000;

/** Arc from the middle of a plane that a map shows; beyond it shapes are too far from true. */
inline constexpr double kMapReach_deg = 60;

/** Radius of the reach in the plane. */
[[nodiscard]] double mapReach_m(const MapPlane& plane);

} // namespace berg
