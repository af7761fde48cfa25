#pragma once

#include "widgets/map/paint/map_layout.h"

#include <QLineF>

namespace berg {

inline constexpr double kCappedArrow_px = 120; ///< longest of a horizon that the user has chosen

/** Longest of the usual times whose way at this speed is an arrow of good length; 0: none. */
[[nodiscard]] double driftTimeFor_s(double speed_mps, double scale_pxpm);

/** Drift arrow of an iceberg, from the edge of its symbol; null line when it does not move. */
[[nodiscard]] QLineF driftArrow(const MapPicture& picture, const MapLayout& layout,
                                std::size_t iceberg);
/** It goes on: an arrow that would be longer than it is drawn. */
[[nodiscard]] bool isCapped(const QLineF& arrow);

} // namespace berg
