#pragma once

#include "core/io/figure/figure.h"

namespace berg {

/** Device-independent pixels, y down. */
struct Pixel
{
    double x = 0;
    double y = 0;
};

/** Rectangle in pixels; `top` is less than `bottom`. */
struct PixelRect
{
    double left = 0;
    double top = 0;
    double right = 0;
    double bottom = 0;
    [[nodiscard]] double width() const { return right - left; }
    [[nodiscard]] double height() const { return bottom - top; }
    /** Returns true if `other` lies within this rectangle or on its edges. */
    [[nodiscard]] bool contains(const PixelRect& other) const;
    /** Returns true if both rectangles overlap; common edges do not count. */
    [[nodiscard]] bool intersects(const PixelRect& other) const;
};

/** Fonts of a figure. */
enum class FigureFont
{
    Small,
    SmallBold,
    Strong,
    Body
};

/** Text measurement on the device. */
struct FigureFonts
{
    std::function<double(const std::string&, FigureFont)> width_px;
    /** Returns the text, shortened if it is wider than `room_px`. */
    std::function<std::string(const std::string&, FigureFont, double room_px)> elided;
};

/** Horizontal alignment of a text in its rectangle. */
enum class TextAlign
{
    Left,
    Centre,
    Right
};

/** Text, vertically centred in its rectangle. */
struct DrawnText
{
    std::string text;
    PixelRect rect;
    FigureFont font = FigureFont::Small;
    TextAlign align = TextAlign::Left;
    Ink ink{.of = InkOf::Muted};
};

/** A laid-out polyline, in pixels. */
struct DrawnLine
{
    std::vector<Pixel> points;
    Ink ink{};
    double width_px = 1;
    std::vector<double> dash_px{};
    std::string key{};
};

/** A laid-out area with the area of the figure. */
struct DrawnArea
{
    std::vector<Pixel> outline;
    PlotArea of;
};

/** A laid-out mark with the mark of the figure. */
struct DrawnMark
{
    Pixel at;
    PlotMark of;
};

/** A laid-out label with the label of the figure. */
struct DrawnLabel
{
    std::string text;
    PixelRect rect;
    Pixel end; ///< end of its leader or line
    bool inMargin = false;
    PlotLabel of;
};

/** A laid-out tick: its pixel along the axis and its text. */
struct DrawnTick
{
    double at_px = 0;
    std::string text;
};

/** A laid-out item with the item of the figure. */
struct DrawnItem
{
    Pixel at;
    PlotItem of;
};

/** Maps values to pixels along one axis. */
struct PlotScale
{
    double from = 0; ///< value at `from_px`; an exponent of ten on a logarithmic axis
    double to = 1;
    double from_px = 0;
    double to_px = 1;
    double low_px = 0; ///< pixel of the low edge of the plot
    double high_px = 1;
    double step = 1; ///< distance of ticks
    bool isLogarithmic = false;
    /**
     * Returns the pixel of a value; -/+ `kPlotEdge` gives an edge of the plot. On a logarithmic
     * axis values below 1e-6 count as 1e-6.
     */
    [[nodiscard]] double at(double value) const;
};

/** A figure laid out in pixels; it is painted in the order of its members. */
struct Drawing
{
    Pixel size;
    PixelRect plot;
    PlotScale x;
    PlotScale y;
    PlotScale right;
    std::vector<DrawnLine> grid;
    std::vector<DrawnArea> areas;
    std::vector<DrawnLine> lines;
    std::vector<DrawnMark> marks;
    std::vector<DrawnLine> over; ///< includes the leaders of labels
    std::vector<DrawnText> texts;
    std::vector<DrawnTick> xTicks; ///< their texts are in `texts`
    std::vector<DrawnTick> yTicks;
    std::vector<DrawnTick> rightTicks;
    std::vector<DrawnLabel> labels; ///< in the order of the figure; their texts are in `texts`
    std::vector<DrawnItem> items;
    std::string leftTitle; ///< its text is in `texts`
    std::string rightTitle;

    /** Returns the pixel of a point. */
    [[nodiscard]] Pixel at(const PlotPoint& point, bool onRightAxis = false) const;
};

inline constexpr double kFigureTop_px = 62;    ///< space above the plot for title and axis titles
inline constexpr double kFigureBottom_px = 46; ///< space below the plot for numbers and their title
inline constexpr double kFigureSide_px = 18;
inline constexpr double kFootMark_px = 7; ///< height of a small tick at the foot of the plot

/** Lays out everything but the labels, or only `Figure::emptyText` if there is one. */
[[nodiscard]] Drawing layOutPlot(const Figure& figure, const Pixel& size, const FigureFonts& fonts);

/**
 * Places the labels for which there is room. Labels with place `Free` or `Inside` keep clear of the
 * rectangles `taken`; those with place `Left` or `Right` are always placed.
 */
void placeLabels(const Figure& figure, const FigureFonts& fonts, Drawing& drawing,
                 const std::vector<PixelRect>& taken = {});

/** Returns the width right of the plot that the labels need, or 0 if they need none. */
[[nodiscard]] double labelMargin_px(const Figure& figure, const Pixel& size,
                                    const FigureFonts& fonts);

/** Lays out the plot and places the labels, if the figure shows its content. */
[[nodiscard]] Drawing layOut(const Figure& figure, const Pixel& size, const FigureFonts& fonts);

} // namespace berg
