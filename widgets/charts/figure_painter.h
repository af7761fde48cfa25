#pragma once

#include "core/io/figure/figure_layout.h"
#include "widgets/theme/theme.h"

#include <QPainter>

namespace berg {

// Figures on screen and paper, in the colours and fonts of a theme.

[[nodiscard]] QColor inkColour(const Ink& ink, const Theme& theme);

/** Sizes of texts in the theme's fonts. The theme is copied. */
[[nodiscard]] FigureFonts figureFonts(const Theme& theme);

[[nodiscard]] QPointF toQt(const Pixel& pixel);
[[nodiscard]] QRectF toQt(const PixelRect& rect);

void paintMark(QPainter& painter, const QPointF& at, const PlotMark& mark, const Theme& theme);

/** All of it but the ground; the painter is left as it was. */
void paintDrawing(QPainter& painter, const Drawing& drawing, const Theme& theme);
/** What is round and over the lines, which something else has painted. */
void paintFrame(QPainter& painter, const Drawing& drawing, const Theme& theme);

} // namespace berg
