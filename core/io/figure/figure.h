#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace berg {

// A chart as plain values in the units of its axes, without layout (`figure_layout.h`) or painting.
// Texts are UTF-8.

/** Meaning of a drawn object, from which the painter chooses its colour. */
enum class InkOf
{
    Text,
    Muted,
    Axis,
    Grid,
    Uav, ///< one of several UAVs; `value` is its index in the scenario
    Plan,
    Accumulated,
    Momentary,
    Comparison,
    Policy, ///< a `PolicyKind` as `value`
    Solver, ///< `value` is an index of `kBenchmarkSolverNames`, or negative for the paper's solver
    Sigma,  ///< `value` is a fraction of the maximum of the sigma scale
    Caution,
    Danger
};

/** Colour of a drawn object, by its meaning. */
struct Ink
{
    InkOf of = InkOf::Text;
    double value = 0;
    double strength = 1; ///< from 1 for the full colour down to 0 for that of the background
};

/** Coordinate of the edge of the plot (negative: left or bottom). */
inline constexpr double kPlotEdge = std::numeric_limits<double>::infinity();

/** Point in units of the axes (-/+ `kPlotEdge` for an edge of the plot), shifted by some pixels. */
struct PlotPoint
{
    double x = 0;
    double y = 0;
    double dx_px = 0; ///< to the right
    double dy_px = 0; ///< down
};

/** Polyline of a chart. */
struct PlotLine
{
    std::vector<PlotPoint> points;
    Ink ink{};
    double width_px = 1;
    std::vector<double> dash_px{};
    bool onRightAxis = false;
    bool isOver = false; ///< drawn above all other content, e.g. the cursor time
    std::string key{};   ///< identifies the line; its class in SVG
};

/** Filled polygon of a chart. */
struct PlotArea
{
    std::vector<PlotPoint> outline;
    Ink ink{};
    bool isHatched = false;
    double opacity = 1; ///< below 1, the content underneath shows through
    std::string key{};
    std::string tip{}; ///< tooltip in SVG
};

/** Shape of a plot mark. */
enum class MarkShape
{
    Disk,
    Diamond,
    Square,
    Triangle,
    TriangleDown,
    Hexagon,
    Star,
    Ring ///< circle with an empty inside
};

/** Mark of a chart at a point. */
struct PlotMark
{
    PlotPoint at;
    double radius_px = 3;
    Ink ink{};
    MarkShape shape = MarkShape::Disk;
    bool isHollow = false;
    std::string tip{};
};

/** Placement of a label. */
enum class LabelPlace
{
    Margin, ///< in a column right of the plot, with a leader to its end
    AtEnd,  ///< with a leader beside its end
    Free,   ///< right of its end or above it, clear of lines and other labels
    Inside, ///< along its line in the plot, clear of all lines
    Left,   ///< right-aligned to its end, without looking for free space
    Right   ///< left-aligned to its end, without looking for free space
};

/** Label of a chart. */
struct PlotLabel
{
    std::string text;
    std::string shortText{}; ///< for `Inside`, used if the whole text does not fit
    PlotPoint end{};
    Ink ink{};
    LabelPlace place = LabelPlace::Margin;
    bool onRightAxis = false;
    bool isStrong = false;
    bool isQuiet = false;    ///< in a small font
    bool needsMargin = true; ///< the margin is made wide enough for the label
    std::size_t line = 0;    ///< index of its line, for `Inside`
    std::string key{};
};

/** Point of a chart that the user can select, and the lines of its readout. */
struct PlotItem
{
    std::size_t id = 0;
    PlotPoint at;
    std::vector<std::string> readout{};
};

/** Ends and ticks of an axis. */
enum class AxisEnds
{
    Round,   ///< ends are round numbers around the visible range
    Around0, ///< as `Round`, and the range includes 0
    Exact,   ///< ends are exactly those of the visible range, with round ticks inside
    Powers,  ///< logarithmic, with ticks at powers of ten
    Rows     ///< rows of text from top to bottom
};

/** Axis of a chart. */
struct PlotAxis
{
    AxisEnds ends = AxisEnds::Round;
    double least = 0; ///< lower end of the visible range
    double largest = 1;
    double spacing_px = 40; ///< minimum distance of ticks
    /** Minimum distance for up to four ticks on a short axis; nullopt means `spacing_px`. */
    std::optional<double> fewSpacing_px = {};
    std::function<std::string(double value, int decimals)> text{};
    double inUnit = 1; ///< value of one displayed unit in axis units: 1e6 for an axis in m² s
                       ///< labelled in km² s
    std::string title{};
    bool isTime = false;  ///< seconds: steps of minutes and hours
    double midnight = 0;  ///< for a time axis: ticks are at round times after this instant
    bool isWhole = false; ///< ticks at whole numbers only
    bool hasGrid = true;
    double inset_px = 0;   ///< free space at both ends
    double reserve_px = 0; ///< free space at the far end
    std::vector<std::string> rows{};
    std::vector<std::string> rowEnds{}; ///< texts right of the plot, one per row
    /** Ticks in addition to the round ones. */
    std::vector<std::pair<PlotPoint, std::string>> extra{};

    /** Extends the visible range to `value`. */
    void include(double value)
    {
        least = std::min(least, value);
        largest = std::max(largest, value);
    }
};

/** Chart as plain values. */
struct Figure
{
    std::string name;      ///< for screen readers
    std::string title;     ///< shown in a row of its own, if not empty
    std::string emptyText; ///< if not empty, shown instead of all content
    /** Titles above the plot; the first alternative for which there is room is used. */
    std::vector<std::string> leftTitles;
    std::vector<std::string> rightTitles;
    Ink leftInk{.of = InkOf::Muted};
    Ink rightInk{.of = InkOf::Muted};
    PlotAxis x;
    PlotAxis y;
    std::optional<PlotAxis> right{}; ///< axis from 0 on that uses the grid of the left axis
    double leastLeft_px = 0;         ///< least distances of the plot from the edges, so that the
    double leastRight_px = 0;        ///< time axes of stacked figures are aligned
    std::string markKey{};           ///< explains the small ticks at the foot of the plot
    std::vector<PlotArea> areas;     ///< later areas are drawn above earlier ones, as are lines and
                                     ///< marks
    std::vector<PlotLine> lines;
    std::vector<PlotMark> marks;
    std::vector<PlotLabel> labels; ///< in order of importance
    std::vector<PlotItem> items;   ///< in the order of the arrow keys
    std::string description;       ///< one sentence for screen readers
};

} // namespace berg
