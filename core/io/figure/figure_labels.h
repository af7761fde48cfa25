#pragma once

#include "core/io/figure/figure_layout.h"

namespace berg {

// Private to `layOutPlot`: room for names.

/** Width right of the plot that names need; 0: none. */
[[nodiscard]] double labelMargin_px(const Figure& figure, const Pixel& size,
                                    const FigureFonts& fonts);

} // namespace berg
