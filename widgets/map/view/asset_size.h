#pragma once

#include "core/scenario/limits.h"
#include "core/scenario/scenario.h"
#include "widgets/map/paint/map_overlays.h"

#include <algorithm>

namespace berg {

/**
 * Returns a new asset. The radius of its outer ring is 0.3 of the map's smaller side, rounded down
 * to 1, 2 or 5 times a power of ten: a fixed 10 km would be out of sight in a field of 5 km, and a
 * dot in one of 500.
 */
[[nodiscard]] inline Asset assetFor(const MapViewTransform& view, const QSizeF& shown_px)
{
    constexpr double kShare = 0.3; // radius relative to the smaller side
    Asset asset;
    const double radius_px = kShare * std::min(shown_px.width(), shown_px.height());
    asset.range_m = std::min(roundDown125(radius_px / view.scale_pxpm()), kLargestLength_m);
    return asset;
}

} // namespace berg
