#pragma once

#include "core/io/figure/figure_layout.h"
#include "widgets/theme/theme.h"

#include <QPainter>

namespace berg {

// Paints figures on screen and paper in the colours and fonts of a theme.

/** Colour of an ink, faded towards the chart's background by its strength. */
[[nodiscard]] QColor inkColour(const Ink& ink, const Theme& theme);

/** Text measurement in the theme's fonts. The theme is copied. */
[[nodiscard]] FigureFonts figureFonts(const Theme& theme);

/** Qt values of figure coordinates, which are pixels as well. */
[[nodiscard]] QPointF toQt(const Pixel& pixel);
[[nodiscard]] QRectF toQt(const PixelRect& rect);

/** Paints a plot mark at a point. */
void paintMark(QPainter& painter, const QPointF& at, const PlotMark& mark, const Theme& theme);

/** Paints the drawing without its background; restores the painter. */
void paintDrawing(QPainter& painter, const Drawing& drawing, const Theme& theme);
/** Paints texts and lines around and above data lines that were painted otherwise. */
void paintFrame(QPainter& painter, const Drawing& drawing, const Theme& theme);

} // namespace berg
