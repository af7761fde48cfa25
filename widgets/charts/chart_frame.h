#pragma once

#include "widgets/theme/theme.h"

#include <QPainter>

#include <optional>
#include <vector>

namespace berg {

/** A number at an axis: its place along the axis and what it says. */
struct ChartTick
{
    double at_px = 0;
    QString text;
};

/** A name beside a line. */
struct ChartLabel
{
    QString text;
    QRectF rect{};
    QPointF end; ///< of its line
    QColor colour;
    bool inMargin = false; ///< right of the plot, joined to its line by a leader
    bool strong = false;
    bool quiet = false; ///< of a line in the background: small
    QString key{};      ///< of its line
};

/** A dashed line across the plot. */
struct ChartReference
{
    double at_px = 0;
    QString text;
};

/** The value of one line at the instant read. */
struct ReadoutFlag
{
    QRectF rect{};
    QPointF at; ///< on the line
    QString text;
    QColor colour; ///< of the line
};

/** What all lines say at one instant. */
struct ChartReadout
{
    std::optional<double> hover_px; ///< abscissa of the thin line; none: the cursor is there
    QRectF timeRect;
    QString time;
    std::vector<ReadoutFlag> flags;
};

/** Everything round and on top of the lines of a chart, device-independent pixels. */
struct ChartFrame
{
    QSizeF size;
    QRectF plot;
    QString title; ///< empty: what is around the chart says it, and its row is left out
    QString leftTitle;
    QString rightTitle;
    std::optional<double> rightEdge_px; ///< where that ends; none: at the edge of the chart
    QString timeTitle;
    QColor leftColour; ///< of the axis titles: those of their lines
    QColor rightColour;
    std::vector<ChartTick> times;
    std::vector<ChartTick> left;
    std::vector<ChartTick> right;
    std::vector<ChartReference> references;
    std::vector<double> marks_px; ///< abscissas of the small ticks at the foot of the plot
    QString marksTitle;
    std::optional<double> cursor_px; ///< abscissa of the instant looked at
    std::vector<ChartLabel> labels;
    QString emptyText; ///< in the middle; empty when there is something to see
};

// Room round the plot and sizes of its furniture.
inline constexpr double kChartTop_px = 62;    ///< title and axis titles
inline constexpr double kChartTitle_px = 26;  ///< of that, the title
inline constexpr double kChartBottom_px = 46; ///< times and their title
inline constexpr double kChartSide_px = 18;
inline constexpr double kChartTickGap_px = 7; ///< between axis and number
inline constexpr double kChartMark_px = 7;

/** Top of the plot. */
[[nodiscard]] double chartTop(const ChartFrame& frame);

/** Paints a line for each tick of the left and of the lower axis. */
void paintChartGrid(QPainter& painter, const ChartFrame& frame, const Theme& theme);
/** Paints titles, numbers, marks and labels; the painter is left as it was. */
void paintChartFrame(QPainter& painter, const ChartFrame& frame, const Theme& theme);

/** Paints the read-out over a chart; the painter is left as it was. */
void paintReadout(QPainter& painter, const ChartReadout& readout, const QRectF& plot,
                  const Theme& theme);

} // namespace berg
