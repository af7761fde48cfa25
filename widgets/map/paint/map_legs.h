#pragma once

#include "widgets/map/paint/map_layout.h"

#include <QPolygonF>

namespace berg {

/**
 * Returns the legs of a UAV's plan on the screen up to its flight home, starting at the UAV: one
 * line per iceberg of this sortie, cut at the symbols, or the paths of a plan with aim points. A
 * leg is empty if there is no room for it, or between icebergs planned as one point.
 */
[[nodiscard]] std::vector<QPolygonF> planLegs(const MapPicture& picture, const MapLayout& layout,
                                              std::size_t uav);

/** Returns the leg from the last iceberg of this sortie to home; empty if the UAV does not fly
 * home. */
[[nodiscard]] QPolygonF homeLeg(const MapPicture& picture, const MapLayout& layout,
                                std::size_t uav);

/** Returns the legs of the replaced plan, from where the UAV was at the replacement. */
[[nodiscard]] std::vector<QPolygonF> formerLegs(const MapPicture& picture, const MapLayout& layout,
                                                std::size_t uav);

} // namespace berg
