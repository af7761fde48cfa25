#include "core/io/figure/figure_layout.h"

#include "core/base/nice_ticks.h"

#include <algorithm>
#include <cmath>

namespace berg {
namespace {

constexpr double kTitle_px = 26;      // height of the title row
constexpr double kBareTop_px = 12;    // above a plot without titles
constexpr double kBareBottom_px = 28; // below a plot without an axis title
constexpr double kTickGap_px = 7;     // between axis and number
constexpr double kTextHeight_px = 16; // height of a line of text
constexpr double kNameShare = 0.3;    // of the width, at most, for row names
constexpr double kTitlesGap_px = 24;  // between the titles above the plot
constexpr double kShortest = 1e-6;    // a logarithm needs a positive value
constexpr double kHeadroom = 0.15;    // of a power of ten, above the largest value
constexpr double kAlmost = 1e-9;

/** Ticks of an axis: `count` steps from `first` on, between its ends. */
struct AxisTicks
{
    double from = 0;
    double to = 1;
    double first = 0;
    double step = 1;
    int count = 0;
    int decimals = 0;
};

AxisTicks roundTicks(const PlotAxis& axis, int most)
{
    if (axis.ends == AxisEnds::Round) {
        const NiceRange range = niceRange(axis.least, axis.largest, most);
        return {range.first, range.at(range.count), range.first,
                range.step,  range.count,           range.decimals()};
    }
    NiceTicks ticks = niceTicksAround(axis.least, axis.largest, most);
    if (axis.isWhole) {
        ticks.step = std::max(1.0, ticks.decimals() > 0 ? 2 * ticks.step : ticks.step);
        ticks.count = std::max(1, static_cast<int>(std::ceil(axis.largest / ticks.step)));
    }
    return {ticks.start(),   ticks.end(), ticks.start(), ticks.step, ticks.below + ticks.count,
            ticks.decimals()};
}

AxisTicks ticksWithin(const PlotAxis& axis, int most)
{
    const double extent = axis.largest - axis.least;
    if (extent <= 0) // puts a single value in the middle
        return {axis.least - 1, axis.least + 1, axis.least, 1, 0, 2};
    NiceTicks ticks = niceTicks(extent, most);
    if (axis.isTime)
        ticks.step = timeStep_s(extent, most);
    if (axis.isWhole)
        ticks.step = std::max(1.0, ticks.decimals() > 0 ? 2 * ticks.step : ticks.step);
    const double first = std::ceil((axis.least - axis.midnight) / ticks.step - kAlmost);
    const double last = std::floor((axis.largest - axis.midnight) / ticks.step + kAlmost);
    return {axis.least,
            axis.largest,
            axis.midnight + first * ticks.step,
            ticks.step,
            static_cast<int>(last - first),
            ticks.decimals()};
}

AxisTicks powerTicks(const PlotAxis& axis, double length_px)
{
    const double from = std::floor(std::log10(std::max(axis.least, kShortest)) + kAlmost);
    const double to = std::log10(axis.largest) + kHeadroom;
    const double step = std::max(1.0, std::ceil((to - from) * axis.spacing_px / length_px));
    return {from, to, from, step, static_cast<int>((to - from) / step), 0};
}

AxisTicks ticksOf(const PlotAxis& axis, double length_px)
{
    constexpr int kFew = 4; // with fewer, round ends would leave much of the axis empty
    int most = std::max(1, static_cast<int>(length_px / axis.spacing_px));
    if (axis.fewSpacing_px)
        most = std::max(most, std::min(kFew, static_cast<int>(length_px / *axis.fewSpacing_px)));
    switch (axis.ends) {
    case AxisEnds::Round:
    case AxisEnds::Around0:
        return roundTicks(axis, most);
    case AxisEnds::Exact:
        return ticksWithin(axis, most);
    case AxisEnds::Powers:
        return powerTicks(axis, length_px);
    case AxisEnds::Rows:
        return {-0.5, static_cast<double>(axis.rows.size()) - 0.5, 0,
                1,    static_cast<int>(axis.rows.size()) - 1,      0};
    }
    return {};
}

/** Returns the ticks of the right axis on the grid of the left axis. */
AxisTicks rightTicksOf(const PlotAxis& axis, const AxisTicks& left)
{
    const int below = static_cast<int>(std::lround(-left.from / left.step));
    const int above = left.count - below;
    const NiceTicks ticks = niceTicksExactly(axis.largest, std::max(1, above));
    return {-below * ticks.step, above * ticks.step, -below * ticks.step,
            ticks.step,          left.count,         ticks.decimals()};
}

std::string tickText(const PlotAxis& axis, const AxisTicks& ticks, int k)
{
    if (axis.ends == AxisEnds::Rows)
        return axis.rows.at(static_cast<std::size_t>(k));
    const double value = ticks.first + k * ticks.step;
    if (axis.ends == AxisEnds::Powers)
        return axis.text(std::pow(10.0, value), ticks.decimals);
    const NiceTicks written{.step = ticks.step / axis.inUnit};
    return axis.text(value / axis.inUnit, axis.inUnit == 1 ? ticks.decimals : written.decimals());
}

/** A figure while it is being laid out. */
struct FigureDraft
{
    const Figure& figure;
    const FigureFonts& fonts;
    Drawing out{};
    AxisTicks xTicks{};
    AxisTicks yTicks{};
    AxisTicks rightTicks{};
    double rightNumbers_px = 0; ///< width of the numbers of the right axis

    [[nodiscard]] double width_px(const std::string& text) const
    {
        return fonts.width_px(text, FigureFont::Small);
    }
    void text(std::string text, const PixelRect& rect, TextAlign align,
              const Ink& ink = {.of = InkOf::Muted}, FigureFont font = FigureFont::Small)
    {
        out.texts.push_back({std::move(text), rect, font, align, ink});
    }
};

double titlesTop(const Figure& figure)
{
    return figure.title.empty() ? kFigureTop_px - kTitle_px : kFigureTop_px;
}

/** Explains the small ticks where there is room. Returns the width used in the title row. */
double placeMarkKey(FigureDraft& l)
{
    if (l.figure.markKey.empty())
        return 0;
    const bool isTitled = !l.figure.title.empty();
    const double key_px = l.width_px(l.figure.markKey) + 14;
    const double titles_px =
        2 * std::max(l.width_px(l.out.leftTitle), l.width_px(l.out.rightTitle));
    if (isTitled ? key_px >= 0.3 * l.out.size.x : titles_px + key_px + 40 >= l.out.size.x)
        return 0;
    const double left_px =
        (isTitled ? l.out.size.x - kFigureSide_px - key_px : (l.out.size.x - key_px) / 2) + 14;
    const double top_px = isTitled ? 12 : titlesTop(l.figure) - 28;
    l.out.over.push_back(
        {.points = {{left_px - 7, top_px + 5}, {left_px - 7, top_px + 5 + kFootMark_px}},
         .ink = {.of = InkOf::Uav},
         .width_px = 1.6});
    l.text(l.figure.markKey, {left_px, top_px, left_px + key_px, top_px + 18}, TextAlign::Left);
    return isTitled ? key_px : 0;
}

/** Chooses the longest alternatives of both titles that fit above the plot. */
void chooseTitles(FigureDraft& l, double room_px)
{
    const std::vector<std::string> none{{}};
    for (const std::string& left : l.figure.leftTitles.empty() ? none : l.figure.leftTitles)
        for (const std::string& right :
             l.figure.rightTitles.empty() ? none : l.figure.rightTitles) {
            l.out.leftTitle = left;
            l.out.rightTitle = right;
            if (l.width_px(left) + l.width_px(right) + kTitlesGap_px <= room_px)
                return;
        }
}

void placeTitles(FigureDraft& l)
{
    const double room_px = l.out.size.x - 2 * kFigureSide_px;
    chooseTitles(l, room_px);
    const double rightRoom_px =
        room_px - (l.out.leftTitle.empty() ? 0 : l.width_px(l.out.leftTitle) + kTitlesGap_px);
    l.out.rightTitle = l.fonts.elided(l.out.rightTitle, FigureFont::Small, rightRoom_px);
    const double key_px = placeMarkKey(l);
    PixelRect row{kFigureSide_px, 12, l.out.size.x - kFigureSide_px, 30};
    if (!l.figure.title.empty())
        l.text(l.fonts.elided(l.figure.title, FigureFont::Strong, room_px - key_px), row,
               TextAlign::Left, {}, FigureFont::Strong);
    row.top = titlesTop(l.figure) - 27;
    row.bottom = row.top + kTextHeight_px;
    l.text(l.out.leftTitle, row, TextAlign::Left, l.figure.leftInk);
    if (l.figure.right)
        row.right = l.out.plot.right + kTickGap_px + l.rightNumbers_px;
    l.text(l.out.rightTitle, row, TextAlign::Right, l.figure.rightInk);
}

double widest(const FigureDraft& l, const std::vector<std::string>& texts)
{
    double widest_px = 0;
    for (const std::string& text : texts)
        widest_px = std::max(widest_px, l.width_px(text));
    return widest_px;
}

std::vector<std::string> numbersOf(const PlotAxis& axis, const AxisTicks& ticks)
{
    std::vector<std::string> numbers;
    for (int k = 0; k <= ticks.count; ++k)
        numbers.push_back(tickText(axis, ticks, k));
    return numbers;
}

/** Sets the plot's rectangle from the space needed around it. */
void setPlot(FigureDraft& l)
{
    const PlotAxis& y = l.figure.y;
    const bool hasTitles =
        !l.figure.title.empty() || !l.figure.leftTitles.empty() || !l.figure.rightTitles.empty();
    PixelRect& plot = l.out.plot;
    plot.top = hasTitles ? titlesTop(l.figure) : kBareTop_px;
    const double below_px = l.figure.x.title.empty() ? kBareBottom_px : kFigureBottom_px;
    plot.bottom = std::max(plot.top + 20, l.out.size.y - below_px);
    l.yTicks = ticksOf(y, plot.height());
    plot.left = kFigureSide_px + kTickGap_px + widest(l, numbersOf(y, l.yTicks));
    if (y.ends == AxisEnds::Rows)
        plot.left = std::min(plot.left, kFigureSide_px + kTickGap_px + kNameShare * l.out.size.x);
    plot.left = std::max(plot.left, l.figure.leastLeft_px);
    double beside_px = y.rowEnds.empty() ? 0 : kTickGap_px + widest(l, y.rowEnds);
    if (l.figure.right) {
        l.rightTicks = rightTicksOf(*l.figure.right, l.yTicks);
        l.rightNumbers_px = widest(l, numbersOf(*l.figure.right, l.rightTicks));
        beside_px = kTickGap_px + l.rightNumbers_px;
    }
    beside_px = std::max(beside_px, labelMargin_px(l.figure, l.out.size, l.fonts));
    beside_px = std::max(l.figure.leastRight_px, kFigureSide_px + beside_px);
    plot.right = std::max(plot.left + 40, l.out.size.x - beside_px);
}

PlotScale scaleOf(const PlotAxis& axis, const AxisTicks& ticks, double low_px, double high_px)
{
    const double sign = high_px > low_px ? 1 : -1;
    return {.from = ticks.from,
            .to = ticks.to,
            .from_px = low_px + sign * axis.inset_px,
            .to_px = high_px - sign * (axis.inset_px + axis.reserve_px),
            .low_px = low_px,
            .high_px = high_px,
            .step = ticks.step,
            .isLogarithmic = axis.ends == AxisEnds::Powers};
}

void setScales(FigureDraft& l)
{
    const PixelRect& plot = l.out.plot;
    const PlotAxis& x = l.figure.x;
    l.xTicks = ticksOf(x, plot.width() - x.reserve_px - 2 * x.inset_px);
    l.out.x = scaleOf(x, l.xTicks, plot.left, plot.right);
    const bool isFromAbove = l.figure.y.ends == AxisEnds::Rows;
    l.out.y = scaleOf(l.figure.y, l.yTicks, plot.bottom, plot.top);
    if (isFromAbove)
        std::swap(l.out.y.from_px, l.out.y.to_px);
    if (l.figure.right)
        l.out.right = scaleOf(*l.figure.right, l.rightTicks, plot.bottom, plot.top);
}

void placeNumber(FigureDraft& l, double at_px, const std::string& text)
{
    const double top_px = l.out.plot.bottom + 5;
    l.out.xTicks.push_back({at_px, text});
    l.text(text, {at_px - 40, top_px, at_px + 40, top_px + kTextHeight_px}, TextAlign::Centre);
}

void placeX(FigureDraft& l)
{
    const PixelRect& plot = l.out.plot;
    const PlotAxis& axis = l.figure.x;
    const auto add = [&](double at_px, const std::string& text) {
        if (axis.hasGrid)
            l.out.grid.push_back(
                {.points = {{at_px, plot.top}, {at_px, plot.bottom}}, .ink = {.of = InkOf::Grid}});
        placeNumber(l, at_px, text);
    };
    if (axis.text)
        for (int k = 0; k <= l.xTicks.count; ++k)
            add(l.out.x.at(l.xTicks.first + k * l.xTicks.step), tickText(axis, l.xTicks, k));
    for (const auto& [point, text] : axis.extra)
        add(l.out.at(point).x, text);
    l.text(axis.title, {plot.left, plot.bottom + 22, plot.right, plot.bottom + 38},
           TextAlign::Centre);
    l.out.grid.push_back({.points = {{plot.left, plot.bottom}, {plot.right, plot.bottom}},
                          .ink = {.of = InkOf::Axis}});
}

void placeY(FigureDraft& l)
{
    const PixelRect& plot = l.out.plot;
    const PlotAxis& axis = l.figure.y;
    const double room_px = plot.left - kFigureSide_px - kTickGap_px;
    for (int k = 0; k <= l.yTicks.count; ++k) {
        const double tick = l.yTicks.first + k * l.yTicks.step;
        const double at_px = l.out.y.at(l.out.y.isLogarithmic ? std::pow(10.0, tick) : tick);
        const double top_px = at_px - kTextHeight_px / 2;
        if (axis.hasGrid)
            l.out.grid.push_back(
                {.points = {{plot.left, at_px}, {plot.right, at_px}}, .ink = {.of = InkOf::Grid}});
        const std::string text =
            l.fonts.elided(tickText(axis, l.yTicks, k), FigureFont::Small, room_px + 1);
        l.out.yTicks.push_back({at_px, text});
        l.text(text, {0, top_px, plot.left - kTickGap_px, top_px + kTextHeight_px},
               TextAlign::Right);
        const auto atRight = [&](const std::string& end) {
            l.text(end, {plot.right + kTickGap_px, top_px, l.out.size.x, top_px + kTextHeight_px},
                   TextAlign::Left);
        };
        if (static_cast<std::size_t>(k) < axis.rowEnds.size())
            atRight(axis.rowEnds[static_cast<std::size_t>(k)]);
        if (l.figure.right) {
            l.out.rightTicks.push_back({at_px, tickText(*l.figure.right, l.rightTicks, k)});
            atRight(l.out.rightTicks.back().text);
        }
    }
}

std::vector<Pixel> pixels(const Drawing& drawing, const std::vector<PlotPoint>& points,
                          bool onRightAxis = false)
{
    std::vector<Pixel> out;
    out.reserve(points.size());
    for (const PlotPoint& point : points)
        out.push_back(drawing.at(point, onRightAxis));
    return out;
}

void placeContent(FigureDraft& l)
{
    Drawing& out = l.out;
    for (const PlotArea& area : l.figure.areas)
        out.areas.push_back({.outline = pixels(out, area.outline), .of = area});
    for (const PlotLine& line : l.figure.lines)
        (line.isOver ? out.over : out.lines)
            .push_back({.points = pixels(out, line.points, line.onRightAxis),
                        .ink = line.ink,
                        .width_px = line.width_px,
                        .dash_px = line.dash_px,
                        .key = line.key});
    for (const PlotMark& mark : l.figure.marks)
        out.marks.push_back({.at = out.at(mark.at), .of = mark});
    for (const PlotItem& item : l.figure.items)
        out.items.push_back({.at = out.at(item.at), .of = item});
}

} // namespace

bool PixelRect::contains(const PixelRect& other) const
{
    return left <= other.left && right >= other.right && top <= other.top && bottom >= other.bottom;
}

bool PixelRect::intersects(const PixelRect& other) const
{
    return left < other.right && right > other.left && top < other.bottom && bottom > other.top;
}

double PlotScale::at(double value) const
{
    if (std::isinf(value))
        return value < 0 ? low_px : high_px;
    const double on = isLogarithmic ? std::log10(std::max(value, kShortest)) : value;
    return from_px + (to_px - from_px) * (on - from) / (to - from);
}

Pixel Drawing::at(const PlotPoint& point, bool onRightAxis) const
{
    return {x.at(point.x) + point.dx_px, (onRightAxis ? right : y).at(point.y) + point.dy_px};
}

Drawing layOutPlot(const Figure& figure, const Pixel& size, const FigureFonts& fonts)
{
    FigureDraft l{.figure = figure, .fonts = fonts};
    l.out.size = size;
    if (!figure.emptyText.empty()) {
        l.out.plot = {0, 0, size.x, size.y};
        l.text(figure.emptyText, l.out.plot, TextAlign::Centre, {.of = InkOf::Muted},
               FigureFont::Body);
        return std::move(l.out);
    }
    setPlot(l);
    setScales(l);
    placeTitles(l);
    placeY(l);
    placeX(l);
    placeContent(l);
    return std::move(l.out);
}

Drawing layOut(const Figure& figure, const Pixel& size, const FigureFonts& fonts)
{
    Drawing drawing = layOutPlot(figure, size, fonts);
    if (figure.emptyText.empty())
        placeLabels(figure, fonts, drawing);
    return drawing;
}

} // namespace berg
