#include "core/base/label_column.h"
#include "core/io/figure/figure_layout.h"

#include <algorithm>
#include <array>

namespace berg {
namespace {

constexpr double kLeader_px = 16;        // between the plot or a line and a label in the margin
constexpr double kMostShare = 0.34;      // of the width, for labels in the margin
constexpr double kMostShareAtEnd = 0.2;  // of the width, for labels at the ends of many lines
constexpr double kFarthestAtEnd_px = 32; // distance of a label from the end of its line
constexpr double kAnywhere_px = 1e9;
constexpr double kHeight_px = 15;
constexpr double kFreeHeight_px = 14;
constexpr double kStrongHeight_px = 17;
constexpr double kGap_px = 10;   // between the end of a line and its label
constexpr int kPlaces = 24;      // positions tried for a free label
constexpr double kAlong_px = 6;  // between a line and a label along it
constexpr int kPlacesAlong = 60; // positions tried along a line
constexpr double kClear_px = 3;  // free space around a label along a line

struct Heights
{
    double top = 0;
    double bottom = 0;
};

/**
 * Returns the vertical extent of a line (of ascending abscissas) between two abscissas, or nullopt
 * outside it.
 */
std::optional<Heights> heights(const std::vector<Pixel>& line, double from, double to)
{
    std::optional<Heights> range;
    const auto include = [&](double y) {
        if (!range)
            range = {y, y};
        range->top = std::min(range->top, y);
        range->bottom = std::max(range->bottom, y);
    };
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        const Pixel& a = line[k];
        const Pixel& b = line[k + 1];
        if (b.x < from || a.x > to)
            continue;
        const auto at = [&](double x) {
            return b.x > a.x ? a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x) : b.y;
        };
        include(a.x >= from ? a.y : at(from));
        include(b.x <= to ? b.y : at(to));
    }
    return range;
}

bool crosses(const std::vector<Pixel>& line, const PixelRect& rect)
{
    const auto range = heights(line, rect.left, rect.right);
    return range && range->bottom > rect.top && range->top < rect.bottom;
}

PixelRect rectAt(double left_px, double middle_px, double width_px, double height_px)
{
    return {left_px, middle_px - height_px / 2, left_px + width_px, middle_px + height_px / 2};
}

class Labels
{
public:
    Labels(const Figure& figure, const FigureFonts& fonts, Drawing& out,
           const std::vector<PixelRect>& taken)
        : m_figure(figure), m_fonts(fonts), m_out(out), m_taken(taken)
    {
        for (const DrawnLine& line : out.over)
            if (line.dash_px.empty())
                m_over.push_back(line.points);
    }

    void place()
    {
        placeColumn(LabelPlace::Margin, kAnywhere_px);
        placeColumn(LabelPlace::AtEnd, kFarthestAtEnd_px);
        for (const PlotLabel& label : m_figure.labels)
            if (label.place == LabelPlace::Left || label.place == LabelPlace::Right)
                placeFixed(label);
        for (const PlotLabel& label : m_figure.labels)
            if (label.place == LabelPlace::Free)
                placeFree(label);
            else if (label.place == LabelPlace::Inside)
                placeInside(label);
    }

private:
    [[nodiscard]] Pixel endOf(const PlotLabel& label) const
    {
        return m_out.at(label.end, label.onRightAxis);
    }

    [[nodiscard]] double width_px(const std::string& text, FigureFont font) const
    {
        return m_fonts.width_px(text, font) + 2;
    }

    void add(DrawnLabel label, FigureFont font, TextAlign align = TextAlign::Left)
    {
        if (label.inMargin) {
            const double y = (label.rect.top + label.rect.bottom) / 2;
            m_out.over.push_back(
                {.points = {label.end, {label.end.x + 5, y}, {label.rect.left - 3, y}},
                 .ink = label.of.ink});
        }
        const bool isPlain = label.inMargin && label.of.ink.of != InkOf::Muted;
        m_out.texts.push_back(
            {label.text, label.rect, font, align, isPlain ? Ink{} : label.of.ink});
        m_out.labels.push_back(std::move(label));
    }

    /**
     * Places labels in a column, as near as possible to the ends of their lines and as many as fit.
     */
    void placeColumn(LabelPlace place, double farthest_px)
    {
        const LabelColumn column{.top = m_out.plot.top - kHeight_px / 2,
                                 .bottom = m_out.plot.bottom + kHeight_px / 2,
                                 .spacing = kHeight_px};
        std::vector<const PlotLabel*> named;
        std::vector<double> wanted;
        for (const PlotLabel& label : m_figure.labels)
            if (label.place == place) {
                named.push_back(&label);
                wanted.push_back(endOf(label).y);
            }
        const auto middles = nameableLabels(wanted, column, farthest_px);
        for (std::size_t k = 0; k < named.size(); ++k) {
            if (!middles[k])
                continue;
            const PlotLabel& label = *named[k];
            const bool isAtEnd = place == LabelPlace::AtEnd;
            const FigureFont font = label.isStrong ? FigureFont::SmallBold : FigureFont::Small;
            const Pixel end = endOf(label);
            const double left_px = kLeader_px + (isAtEnd ? end.x : m_out.plot.right);
            const double room_px =
                isAtEnd ? kMostShareAtEnd * m_out.size.x : m_out.size.x - left_px - 4;
            const std::string text = m_fonts.elided(label.text, font, room_px);
            add({.text = text,
                 .rect = rectAt(left_px, *middles[k], isAtEnd ? width_px(text, font) : room_px,
                                kHeight_px),
                 .end = end,
                 .inMargin = true,
                 .of = label},
                font);
        }
    }

    [[nodiscard]] bool isTaken(const PixelRect& rect) const
    {
        const auto isHit = [&](const PixelRect& other) { return other.intersects(rect); };
        return std::any_of(m_taken.begin(), m_taken.end(), isHit) ||
               std::any_of(m_out.labels.begin(), m_out.labels.end(),
                           [&](const DrawnLabel& label) { return isHit(label.rect); });
    }

    [[nodiscard]] bool isOnLine(const PixelRect& rect) const
    {
        return std::any_of(m_out.lines.begin(), m_out.lines.end(),
                           [&](const DrawnLine& line) { return crosses(line.points, rect); });
    }

    [[nodiscard]] bool isFree(const PixelRect& rect, bool acrossLines) const
    {
        const PixelRect room{0, m_out.plot.top - kFreeHeight_px, m_out.size.x, m_out.plot.bottom};
        return room.contains(rect) && !isTaken(rect) && (acrossLines || !isOnLine(rect));
    }

    bool placeRight(const PlotLabel& label, bool acrossLines)
    {
        const Pixel end = endOf(label);
        for (int k = 0; k < kPlaces; ++k) {
            // shifts by 0, 1 up, 1 down, 2 up, ... half lines
            const int halves = (k + 1) / 2 * (k % 2 == 0 ? 1 : -1);
            const double shift_px = 0.5 * kFreeHeight_px * halves;
            const PixelRect rect = rectAt(end.x + kGap_px, end.y + shift_px,
                                          width_px(label.text, FigureFont::Small), kFreeHeight_px);
            if (!isFree(rect, acrossLines))
                continue;
            add({.text = label.text, .rect = rect, .end = end, .inMargin = true, .of = label},
                FigureFont::Small);
            return true;
        }
        return false;
    }

    bool placeAbove(const PlotLabel& label)
    {
        const Pixel end = endOf(label);
        const double wide_px = width_px(label.text, FigureFont::Strong);
        const double left_px = std::max(m_out.plot.left + 4, end.x - wide_px / 2);
        for (int k = 1; k <= kPlaces; ++k) {
            const PixelRect rect = rectAt(left_px, end.y - kGap_px - 0.5 * kFreeHeight_px * (k + 1),
                                          wide_px, kFreeHeight_px + 2);
            if (!isFree(rect, false))
                continue;
            add({.text = label.text, .rect = rect, .end = end, .of = label}, FigureFont::Strong);
            return true;
        }
        return false;
    }

    /**
     * Places a label right of the end of its line, moved up or down to avoid labels and lines, or
     * else above the end, or else across lines. It is left out if other labels leave no room.
     */
    void placeFree(const PlotLabel& label)
    {
        if (!placeRight(label, false) && !placeAbove(label))
            placeRight(label, true);
    }

    /**
     * Whether the rectangle is clear of labels and lines; with `acrossLines` it may cross other
     * lines.
     */
    [[nodiscard]] bool isClear(const PixelRect& rect, const PlotLabel& label,
                               bool acrossLines) const
    {
        const PixelRect wide{rect.left - kClear_px, rect.top - kClear_px, rect.right + kClear_px,
                             rect.bottom + kClear_px};
        const PixelRect& plot = m_out.plot;
        const PixelRect room{plot.left + 4, plot.top, plot.right - 4,
                             plot.bottom - kFootMark_px - 2};
        return room.contains(rect) && !isTaken(wide) &&
               std::none_of(m_over.begin(), m_over.end(),
                            [&](const auto& line) { return crosses(line, wide); }) &&
               (acrossLines ? !crosses(m_out.lines[label.line].points, rect) : !isOnLine(wide));
    }

    /** Places a label beside its line, preferably late in time. */
    bool placeAlong(const PlotLabel& label, const std::string& text, FigureFont font,
                    bool acrossLines)
    {
        const std::vector<Pixel>& own = m_out.lines[label.line].points;
        const double wide_px = width_px(text, font);
        const double high_px = font == FigureFont::Strong ? kStrongHeight_px : kFreeHeight_px;
        const double last = std::min(own.back().x, m_out.plot.right - 4) - wide_px - 2;
        for (int k = 0; k < kPlacesAlong; ++k) {
            const double left = last - (last - m_out.plot.left) * k / kPlacesAlong;
            const auto line = heights(own, left, left + wide_px);
            if (!line)
                continue;
            const double away_px = kAlong_px + high_px / 2;
            for (const double middle : {line->top - away_px, line->bottom + away_px}) {
                const PixelRect rect = rectAt(left, middle, wide_px, high_px);
                if (!isClear(rect, label, acrossLines))
                    continue;
                add({.text = text, .rect = rect, .end = own.back(), .of = label}, font);
                return true;
            }
        }
        return false;
    }

    /**
     * Places a label along its line. The first label matters most: it is shortened, made small or
     * placed across lines before it is left out.
     */
    void placeInside(const PlotLabel& label)
    {
        if (m_out.lines[label.line].points.size() < 2)
            return;
        const FigureFont font = label.isQuiet ? FigureFont::Small : FigureFont::Strong;
        const std::string& brief = label.shortText.empty() ? label.text : label.shortText;
        const bool isFirst = &label == &m_figure.labels.front();
        if (placeAlong(label, label.text, font, false) || !isFirst)
            return;
        for (const bool acrossLines : {false, true})
            for (const FigureFont smaller : {font, FigureFont::SmallBold})
                if (placeAlong(label, brief, smaller, acrossLines))
                    return;
    }

    void placeFixed(const PlotLabel& label)
    {
        const Pixel end = endOf(label);
        const double wide_px = width_px(label.text, FigureFont::Small);
        const bool isLeft = label.place == LabelPlace::Left;
        add({.text = label.text,
             .rect = rectAt(isLeft ? end.x - wide_px : end.x, end.y, wide_px, kHeight_px),
             .end = end,
             .of = label},
            FigureFont::Small, isLeft ? TextAlign::Right : TextAlign::Left);
    }

    const Figure& m_figure;
    const FigureFonts& m_fonts;
    Drawing& m_out;
    const std::vector<PixelRect>& m_taken;
    std::vector<std::vector<Pixel>> m_over; ///< lines drawn above all content, which labels avoid
};

} // namespace

double labelMargin_px(const Figure& figure, const Pixel& size, const FigureFonts& fonts)
{
    double margin_px = 0;
    for (const PlotLabel& label : figure.labels) {
        if (!label.needsMargin)
            continue;
        const double share = label.place == LabelPlace::AtEnd ? kMostShareAtEnd : kMostShare;
        const FigureFont font = label.isStrong ? FigureFont::SmallBold : FigureFont::Small;
        margin_px =
            std::max(margin_px, std::min(fonts.width_px(label.text, font) + 2, share * size.x));
    }
    return margin_px > 0 ? kLeader_px + margin_px - kGap_px : 0;
}

void placeLabels(const Figure& figure, const FigureFonts& fonts, Drawing& drawing,
                 const std::vector<PixelRect>& taken)
{
    Labels(figure, fonts, drawing, taken).place();
}

} // namespace berg
