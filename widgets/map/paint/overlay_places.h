#pragma once

#include "widgets/map/paint/map_layout.h"

namespace berg {

/** Between overlays and the edge, and each other. */
inline constexpr double kOverlayGap_px = 12;
/** The legend of a map that is lower is compact. */
inline constexpr double kLowMap_px = 600;

/**
 * Overlays into their corners: title top left, legend bottom left if there is room, the others on
 * the right.
 */
void placeOverlays(MapLayout& layout, const MapPicture& picture, const MapStyle& style);

} // namespace berg
