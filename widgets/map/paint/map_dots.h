#pragma once

#include <QColor>
#include <QPointF>

class QPainter;

namespace berg {

struct MapPaint;
struct Theme;

inline constexpr double kIcebergDot_px = 3.2;   ///< radius
inline constexpr double kSmallIceberg_px = 6.5; ///< of the symbols that a dense field keeps

/** An iceberg where there is no room for its symbol; a white square: seen now. */
void drawIcebergDot(QPainter& painter, const QPointF& centre, const QColor& sigma, bool inView,
                    const Theme& theme);
/** So many icebergs in one place, the most uncertain of this colour. */
void drawIcebergCount(QPainter& painter, const QPointF& centre, int icebergs, const QColor& sigma,
                      const Theme& theme);

/** The dots and numbers of a dense field. */
void paintDots(const MapPaint& p);

} // namespace berg
