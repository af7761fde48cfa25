#pragma once

#include "core/io/figure/figure_layout.h"

namespace berg {

// Private to `layOut`: names beside lines.

/** Width right of the plot that names need; 0: none. */
[[nodiscard]] double labelMargin_px(const Figure& figure, const Pixel& size,
                                    const FigureFonts& fonts);

/** Places the names for which there is room; the rest of the figure is laid out. */
void placeLabels(const Figure& figure, const FigureFonts& fonts, Drawing& drawing);

} // namespace berg
