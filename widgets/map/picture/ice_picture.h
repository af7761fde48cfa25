#pragma once

#include "core/scenario/scenario.h"
#include "widgets/map/picture/map_picture.h"

namespace berg {

/** Returns the ice chart of the scenario for a map; null without one. May run on any thread. */
[[nodiscard]] IceChartPointer iceChartOf(const Scenario& scenario);

/** Returns the colour of a class of ice below the symbols of a map, 0xAARRGGBB. */
[[nodiscard]] std::uint32_t iceFill(IceClass iceClass);

/** Returns the uppermost area of the chart at a place of the plane, or null. */
[[nodiscard]] const IceArea* iceAreaAt(const MapIceChart& chart, const Point& place_m);

} // namespace berg
