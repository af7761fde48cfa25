#pragma once

#include "core/io/figure/figure.h"
#include "widgets/charts/chart_content.h"

#include <QtGlobal>

namespace berg {

// Style of the lines of charts over time, in the window and on paper.

/** Strength of faint lines. */
inline constexpr double kFaintInk = 0.32;
/** Strength of the area below a line. */
inline constexpr double kAreaInk = 0.12;

/** Ink of a line's label, and of the line unless it has a gradient (sigma: of its last value). */
[[nodiscard]] Ink lineInk(const TimeLine& line, double sigmaFull_m2);
/** Ink of a sigma on a scale that ends at `full_m2`. */
[[nodiscard]] Ink sigmaInk(double sigma_m2, double full_m2);

/** Width of a line; if `crowded`, all but emphasised and main lines are thin. */
[[nodiscard]] double lineWidth_px(const TimeLine& line, bool crowded);

/** Returns whether lines of this role are dashed. */
[[nodiscard]] bool isDashed(LineRole role);

/** Returns whether there are so many segments that lines must be thin. */
[[nodiscard]] bool isCrowded(qsizetype segments);

} // namespace berg
