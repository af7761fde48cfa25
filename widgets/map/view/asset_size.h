#pragma once

#include "core/scenario/limits.h"
#include "core/scenario/scenario.h"
#include "widgets/map/paint/map_overlays.h"

#include <algorithm>

namespace berg {

/** An asset whose outer ring takes about half of what is shown: one of 10 km is out of sight in a
 * field of 5 km, and a dot in one of 500. */
[[nodiscard]] inline Asset assetFor(const MapViewTransform& view, const QSizeF& shown_px)
{
    constexpr double kShare = 0.3; // of the smaller side, for the radius
    Asset asset;
    const double radius_px = kShare * std::min(shown_px.width(), shown_px.height());
    asset.range_m = std::min(roundDown125(radius_px / view.scale_pxpm()), kLargestLength_m);
    return asset;
}

} // namespace berg
