#pragma once

#include "widgets/map/picture/map_picture.h"

namespace berg {

inline constexpr double kSymbolMargin_px =
    44; ///< distance of the outermost symbols from the map's edge

/**
 * Returns all points that a view of the whole picture must contain: metres, with the tips of drift
 * arrows of `driftTime_s`. Large rings of the asset are cut, so that they take at most half of the
 * view. `scale_pxpm` is the approximate scale of that view.
 */
[[nodiscard]] std::vector<Point> contentPoints(const MapPicture& picture, double driftTime_s,
                                               double scale_pxpm);

} // namespace berg
