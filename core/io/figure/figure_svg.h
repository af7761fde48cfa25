#pragma once

#include "core/io/figure/figure.h"

namespace berg {

/**
 * The figure as SVG of `width_px` x `height_px` for a page: what is drawn has a class for its ink
 * and one for its key, the page's style sheet (`kReportStyle`) colours them, so that light, dark
 * and print are the same drawing.
 */
[[nodiscard]] std::string figureSvg(const Figure& figure, double width_px, double height_px);

} // namespace berg
