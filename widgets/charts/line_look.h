#pragma once

#include "core/io/figure/figure.h"
#include "widgets/charts/chart_content.h"

#include <QtGlobal>

namespace berg {

// How the lines of charts over time look, in the window and on paper.

/** Share of the ink of lines in the background. */
inline constexpr double kFaintInk = 0.32;
/** Of the area below a line. */
inline constexpr double kAreaInk = 0.12;

/** Of its label and, where it has one colour, of the line: sigma's is that of its last value. */
[[nodiscard]] Ink lineInk(const TimeLine& line, double sigmaFull_m2);
/** Of sigma on a scale that ends at `full_m2`. */
[[nodiscard]] Ink sigmaInk(double sigma_m2, double full_m2);

/** All but the main line are thin where lines are `crowded`. */
[[nodiscard]] double lineWidth_px(const TimeLine& line, bool crowded);

/** So many segments that single lines can only be told through one another. */
[[nodiscard]] bool isCrowded(qsizetype segments);

} // namespace berg
