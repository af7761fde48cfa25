#pragma once

#include "core/io/figure/figure.h"

namespace berg {

/** Device-independent pixels, y down. */
struct Pixel
{
    double x = 0;
    double y = 0;
};

struct PixelRect
{
    double left = 0;
    double top = 0;
    double right = 0;
    double bottom = 0;
    [[nodiscard]] double width() const { return right - left; }
    [[nodiscard]] double height() const { return bottom - top; }
    [[nodiscard]] bool contains(const PixelRect& other) const;
    [[nodiscard]] bool intersects(const PixelRect& other) const;
};

enum class FigureFont
{
    Small,
    SmallBold,
    Strong,
    Body
};

/** Sizes of texts on the device. */
struct FigureFonts
{
    std::function<double(const std::string&, FigureFont)> width_px;
    /** The text, or as much of it as there is room for. */
    std::function<std::string(const std::string&, FigureFont, double room_px)> elided;
};

enum class TextAlign
{
    Left,
    Centre,
    Right
};

/** In the middle of the height of its rectangle. */
struct DrawnText
{
    std::string text;
    PixelRect rect;
    FigureFont font = FigureFont::Small;
    TextAlign align = TextAlign::Left;
    Ink ink{.of = InkOf::Muted};
};

struct DrawnLine
{
    std::vector<Pixel> points;
    Ink ink{};
    double width_px = 1;
    std::vector<double> dash_px{};
    std::string key{};
};

struct DrawnArea
{
    std::vector<Pixel> outline;
    PlotArea of;
};

struct DrawnMark
{
    Pixel at;
    PlotMark of;
};

struct DrawnLabel
{
    std::string text;
    PixelRect rect;
    Pixel end; ///< of its line
    bool inMargin = false;
    PlotLabel of;
};

struct DrawnTick
{
    double at_px = 0;
    std::string text;
};

struct DrawnItem
{
    Pixel at;
    PlotItem of;
};

/** From values to pixels along one axis. */
struct PlotScale
{
    double from = 0; ///< of a logarithmic one powers of ten
    double to = 1;
    double from_px = 0;
    double to_px = 1;
    double low_px = 0; ///< edges of the plot
    double high_px = 1;
    double step = 1; ///< between ticks
    bool isLogarithmic = false;
    [[nodiscard]] double at(double value) const;
};

/** A figure laid out; painted in the order of its members. */
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
    std::vector<DrawnLine> over; ///< leaders of names, too
    std::vector<DrawnText> texts;
    std::vector<DrawnTick> xTicks; ///< among the texts
    std::vector<DrawnTick> yTicks;
    std::vector<DrawnTick> rightTicks;
    std::vector<DrawnLabel> labels; ///< among the texts, in the order of the figure
    std::vector<DrawnItem> items;
    std::string leftTitle; ///< among the texts
    std::string rightTitle;

    [[nodiscard]] Pixel at(const PlotPoint& point, bool onRightAxis = false) const;
};

inline constexpr double kFigureTop_px = 62;    ///< title and axis titles
inline constexpr double kFigureBottom_px = 46; ///< numbers and their title
inline constexpr double kFigureSide_px = 18;
inline constexpr double kFootMark_px = 7; ///< height of a small tick at the foot of the plot

/** Places everything but the names for a picture of this size. */
[[nodiscard]] Drawing layOutPlot(const Figure& figure, const Pixel& size, const FigureFonts& fonts);

/** Places the names for which there is room, clear of `taken`. */
void placeLabels(const Figure& figure, const FigureFonts& fonts, Drawing& drawing,
                 const std::vector<PixelRect>& taken = {});

/** Width right of the plot that they need; 0: none. */
[[nodiscard]] double labelMargin_px(const Figure& figure, const Pixel& size,
                                    const FigureFonts& fonts);

/** Both. */
[[nodiscard]] Drawing layOut(const Figure& figure, const Pixel& size, const FigureFonts& fonts);

} // namespace berg
