#pragma once

#include "widgets/map/paint/map_layout.h"

#include <QLineF>
#include <QPen>

namespace berg {

struct MapPaint;

inline constexpr double kCappedArrow_px = 120; ///< largest length for a horizon chosen by the user

/** Returns the longest of the usual horizons whose drift at this speed fits an arrow; zero if none
 * does. */
[[nodiscard]] double driftTimeFor_s(double speed_mps, double scale_pxpm);

/** Returns the drift arrow from the edge of an iceberg's symbol. Returns a null line if the iceberg
 * hardly moves, or in a dense field. */
[[nodiscard]] QLineF driftArrow(const MapPicture& picture, const MapLayout& layout,
                                std::size_t iceberg);
/** Returns true if the drift is longer than the arrow drawn. */
[[nodiscard]] bool isCapped(const QLineF& arrow);

/** Returns the pen of predicted drift. */
[[nodiscard]] QPen driftTrackPen(const Theme& theme);
/**
 * Paints the predicted drift of the icebergs: a line with marks at the times of the tracks' points,
 * a circle of one standard deviation around each, and the hours ("+12 h") where there is room. An
 * iceberg that runs aground has a square at its end. In a dense field, and of many icebergs, there
 * are lines only.
 */
void paintDriftTracks(const MapPaint& p);

} // namespace berg
