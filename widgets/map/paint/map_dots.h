#pragma once

#include <QColor>
#include <QPointF>

class QPainter;

namespace berg {

struct MapPaint;
struct Theme;

inline constexpr double kIcebergDot_px = 3.2;   ///< radius
inline constexpr double kSmallIceberg_px = 6.5; ///< radius of small symbols in a crowded field

/** Draws an iceberg as a dot with the colour of its sigma, or as a white square if it is in view.
 */
void drawIcebergDot(QPainter& painter, const QPointF& centre, const QColor& sigma, bool inView,
                    const Theme& theme);
/** Draws the number of icebergs of a group; `sigma` is the colour of the most uncertain one. */
void drawIcebergCount(QPainter& painter, const QPointF& centre, int icebergs, const QColor& sigma,
                      const Theme& theme);

/** Paints the dots and numbers of a dense field. */
void paintDots(const MapPaint& p);

} // namespace berg
