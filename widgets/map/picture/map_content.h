#pragma once

#include "widgets/map/picture/map_picture.h"

namespace berg {

inline constexpr double kSymbolMargin_px = 44; ///< of the outermost symbols from the edge

/** Everything to be shown, the tips of the drift arrows included; `scale_pxpm` is about right. */
[[nodiscard]] std::vector<Point> contentPoints(const MapPicture& picture, double driftTime_s,
                                               double scale_pxpm);

} // namespace berg
