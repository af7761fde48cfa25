#pragma once

#include "core/io/figure/figure.h"
#include "core/io/figure/figure_layout.h"

#include <vector>

namespace berg {

/**
 * Returns the corners of a mark at `at`, clockwise from the top, in pixels, y pointing down; empty
 * for the round shapes (disk and ring). Shapes with few corners are larger than the mark's radius,
 * so that all shapes look equally heavy.
 */
[[nodiscard]] std::vector<Pixel> markOutline(const PlotMark& mark, const Pixel& at);

} // namespace berg
