#pragma once

#include "widgets/map/paint/map_layout.h"

namespace berg {

/** Distance of overlays from the edge and from each other. */
inline constexpr double kOverlayGap_px = 12;
/** Height below which a map has a compact legend. */
inline constexpr double kLowMap_px = 600;

/**
 * Places the overlays in the corners: title at the top left, legend at the bottom left if there is
 * room, the others on the right.
 */
void placeOverlays(MapLayout& layout, const MapPicture& picture, const MapStyle& style);

/**
 * Moves title and legend away from icebergs under them if that helps. The title is reduced to its
 * readouts; the legend becomes compact, otherwise moves to a free corner or, in a window, to its
 * icon. Nothing moves in a crowded field, nor does a legend opened by the user. The icebergs must
 * be placed before.
 */
void uncoverIcebergs(MapLayout& layout, const MapPicture& picture, const MapStyle& style);

} // namespace berg
