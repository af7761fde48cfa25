#pragma once

#include "widgets/charts/chart_content.h"
#include "widgets/theme/theme.h"

#include <QPen>

namespace berg {

// How the lines of charts over time look, in the window and on paper.

/** Share of the ink of lines in the background. */
inline constexpr float kFaintInk = 0.32F;
/** Of the area below a line. */
inline constexpr float kAreaInk = 0.12F;

/** Of its label and, where it has one colour, of the line: sigma's is that of its last value. */
[[nodiscard]] QColor lineColour(const TimeLine& line, const Theme& theme, double sigmaFull_m2);

/** All but the main line are thin where lines are `crowded`. */
[[nodiscard]] QPen linePen(const TimeLine& line, const QBrush& ink, bool crowded,
                           Qt::PenCapStyle cap);

/** So many segments that single lines can only be told through one another. */
[[nodiscard]] bool isCrowded(qsizetype segments);

} // namespace berg
