#pragma once

#include "widgets/map/paint/map_layout.h"

#include <QPolygonF>

namespace berg {

/**
 * The legs of a UAV's plan on the screen until it goes home, from the UAV on, one for each iceberg
 * of the order: lines cut at the symbols, or the ways of a plan with aim points; empty where there
 * is no room, and between those that are planned as one point.
 */
[[nodiscard]] std::vector<QPolygonF> planLegs(const MapPicture& picture, const MapLayout& layout,
                                              std::size_t uav);

/** From the last iceberg of this sortie to home; empty: there is no home, or all are flown to. */
[[nodiscard]] QPolygonF homeLeg(const MapPicture& picture, const MapLayout& layout,
                                std::size_t uav);

/** The legs of what the plan took the place of, from where the UAV was then. */
[[nodiscard]] std::vector<QPolygonF> formerLegs(const MapPicture& picture, const MapLayout& layout,
                                                std::size_t uav);

} // namespace berg
