#pragma once

#include "widgets/map/paint/map_overlays.h"

#include <functional>
#include <vector>

namespace berg {

/** One sign of the map: a small drawing and what it means. */
struct LegendRow
{
    QString text;
    QString word;                                       ///< the same where there is little room
    std::function<void(QPainter&, const QRectF&)> draw; ///< into a swatch
    double height_px = 0;
};

inline constexpr double kLegendSwatch_px = 34;
inline constexpr double kLegendBar_px = 190;
inline constexpr double kLegendUnits_px = 34; ///< room for "m²" after the last number of the bar

/** The signs that are in the picture. Theme and picture are borrowed: they must outlive the rows.
 */
[[nodiscard]] std::vector<LegendRow> legendRows(const MapPicture& picture, const MapStyle& style,
                                                const SymbolScale& scale);

} // namespace berg
