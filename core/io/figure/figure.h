#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace berg {

// A chart as plain values: what it shows, in the units of its axes, and nothing of where that is in
// a picture (`figure_layout.h`) nor of what paints it. Texts are UTF-8.

/** What is drawn stands for; the painter knows its colour. */
enum class InkOf
{
    Text,
    Muted,
    Axis,
    Grid,
    Uav, ///< one of several, its place in the scenario as value
    Plan,
    Accumulated,
    Momentary,
    Comparison,
    Policy, ///< a `PolicyKind`
    Solver, ///< place in `kBenchmarkSolverNames`; below 0: the paper's
    Sigma   ///< as a part of the end of its scale
};

struct Ink
{
    InkOf of = InkOf::Text;
    double value = 0;
    double strength = 1; ///< less: mixed with the ground
};

inline constexpr double kPlotEdge = std::numeric_limits<double>::infinity();

/** In units of the axes, -/+ `kPlotEdge` for an edge of the plot, moved by some pixels. */
struct PlotPoint
{
    double x = 0;
    double y = 0;
    double dx_px = 0; ///< to the right
    double dy_px = 0; ///< down
};

struct PlotLine
{
    std::vector<PlotPoint> points;
    Ink ink{};
    double width_px = 1;
    std::vector<double> dash_px{};
    bool onRightAxis = false;
    bool isOver = false; ///< above all that is shown, such as the instant looked at
    std::string key{};   ///< tells lines apart; class of it in SVG
};

struct PlotArea
{
    std::vector<PlotPoint> outline;
    Ink ink{};
    bool isHatched = false;
    double opacity = 1; ///< what is below shines through
    std::string key{};
    std::string tip{}; ///< said of it under the pointer, in SVG
};

enum class MarkShape
{
    Disk,
    Diamond,
    Square,
    Triangle,
    TriangleDown,
    Hexagon,
    Star,
    Ring ///< nothing inside
};

struct PlotMark
{
    PlotPoint at;
    double radius_px = 3;
    Ink ink{};
    MarkShape shape = MarkShape::Disk;
    bool isHollow = false;
    std::string tip{};
};

enum class LabelPlace
{
    Margin, ///< in a column right of the plot, joined to its end by a leader
    AtEnd,  ///< as that, but beside its end
    Free,   ///< right of its end or above it, where no line and no other label is
    Inside, ///< along its line in the plot, clear of all lines
    Left,   ///< as it is, right-aligned to its end
    Right   ///< as it is, left-aligned
};

struct PlotLabel
{
    std::string text;
    std::string shortText{}; ///< for `Inside`, where there is no room for the whole
    PlotPoint end{};
    Ink ink{};
    LabelPlace place = LabelPlace::Margin;
    bool onRightAxis = false;
    bool isStrong = false;
    bool isQuiet = false;    ///< small
    bool needsMargin = true; ///< the margin has room for it
    std::size_t line = 0;    ///< its own one, for `Inside`
    std::string key{};
};

/** What can be pointed at and chosen, and what is read there, one line for each quantity. */
struct PlotItem
{
    std::size_t id = 0;
    PlotPoint at;
    std::vector<std::string> readout{};
};

enum class AxisEnds
{
    Round,   ///< ticks round what is to be seen
    Around0, ///< as that, and 0
    Exact,   ///< just what is to be seen, round ticks inside
    Powers,  ///< logarithmic
    Rows     ///< names from above
};

struct PlotAxis
{
    AxisEnds ends = AxisEnds::Round;
    double least = 0; ///< to be seen
    double largest = 1;
    double spacing_px = 40;   ///< of ticks, at least
    double fewSpacing_px = 0; ///< of up to four of them, where the axis is short
    std::function<std::string(double value, int decimals)> text{};
    std::string title{};
    bool isTime = false;  ///< seconds: steps of minutes and hours
    double midnight = 0;  ///< of a time axis: ticks are round times from this instant on
    bool isWhole = false; ///< whole steps only
    bool hasGrid = true;
    double inset_px = 0;   ///< free at both ends
    double reserve_px = 0; ///< free at the far end
    std::vector<std::string> rows{};
    std::vector<std::string> rowEnds{}; ///< right of the plot
    /** Numbers of its own, beside the round ones. */
    std::vector<std::pair<PlotPoint, std::string>> extra{};
};

struct Figure
{
    std::string name;      ///< for screen readers
    std::string title;     ///< in a row of its own; empty: none
    std::string emptyText; ///< in place of everything
    /** Above the plot; of alternatives the first for which there is room. */
    std::vector<std::string> leftTitles;
    std::vector<std::string> rightTitles;
    Ink leftInk{.of = InkOf::Muted};
    Ink rightInk{.of = InkOf::Muted};
    PlotAxis x;
    PlotAxis y;
    std::optional<PlotAxis> right{}; ///< from 0 on, with the grid of the left one
    double leastLeft_px = 0;         ///< of the plot from the edges, so that figures
    double leastRight_px = 0;        ///< one below the other have one axis
    std::string markKey{};           ///< what small ticks at the foot of the plot are
    std::vector<PlotArea> areas;     ///< from below, as all that follows
    std::vector<PlotLine> lines;
    std::vector<PlotMark> marks;
    std::vector<PlotLabel> labels; ///< by importance
    std::vector<PlotItem> items;   ///< in the order of the arrow keys
    std::string description;       ///< in a sentence, for screen readers
};

} // namespace berg
