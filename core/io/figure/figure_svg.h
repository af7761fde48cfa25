#pragma once

#include "core/io/figure/figure.h"

namespace berg {

/**
 * Returns the figure as SVG of `width_px` x `height_px` for a page. Drawn objects have a class for
 * their ink and one for their key; the page's style sheet (`kReportStyle`) colours them, so that
 * light, dark and print use the same drawing. Inks other than text, muted, axis, grid, policy,
 * caution and danger have the class of plans.
 */
[[nodiscard]] std::string figureSvg(const Figure& figure, double width_px, double height_px);

/** Returns the figure as an SVG file of its own, with a style sheet for light and dark readers. */
[[nodiscard]] std::string figureSvgFile(const Figure& figure, double width_px, double height_px);

} // namespace berg
