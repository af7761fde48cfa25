#include "core/io/figure/figure_labels.h"

#include "core/base/label_column.h"

#include <algorithm>

namespace berg {
namespace {

constexpr double kLeader_px = 16;   // between the plot and a name in the margin
constexpr double kMostShare = 0.34; // of the width, for names
constexpr double kHeight_px = 15;
constexpr double kFreeHeight_px = 14;
constexpr double kGap_px = 10; // between the end of a line and its name
constexpr int kPlaces = 24;    // tried for a free name

bool isInMargin(const PlotLabel& label)
{
    return label.place == LabelPlace::Margin;
}

/** Whether a line, of ascending abscissas, runs through a rectangle. */
bool crosses(const std::vector<Pixel>& line, const PixelRect& rect)
{
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        const Pixel& a = line[k];
        const Pixel& b = line[k + 1];
        if (b.x <= rect.left || a.x >= rect.right || b.x <= a.x)
            continue;
        const auto at = [&](double x) { return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x); };
        const double y1 = at(std::max(a.x, rect.left));
        const double y2 = at(std::min(b.x, rect.right));
        if (std::max(y1, y2) > rect.top && std::min(y1, y2) < rect.bottom)
            return true;
    }
    return false;
}

class Labels
{
public:
    Labels(const Figure& figure, const FigureFonts& fonts, Drawing& out)
        : m_figure(figure), m_fonts(fonts), m_out(out)
    {
    }

    void place()
    {
        placeInMargin();
        for (const PlotLabel& label : m_figure.labels) {
            if (label.place == LabelPlace::Free)
                placeFree(label);
            else if (!isInMargin(label))
                placeFixed(label);
        }
    }

private:
    [[nodiscard]] Pixel endOf(const PlotLabel& label) const { return m_out.at(label.end); }

    [[nodiscard]] double width_px(const std::string& text, FigureFont font) const
    {
        return m_fonts.width_px(text, font) + 2;
    }

    void add(DrawnLabel label, FigureFont font, TextAlign align = TextAlign::Left)
    {
        if (label.inMargin) {
            const double y = (label.rect.top + label.rect.bottom) / 2;
            m_out.leaders.push_back(
                {.points = {label.end, {label.end.x + 5, y}, {label.rect.left - 3, y}},
                 .ink = label.of.ink});
        }
        const bool isPlain = label.inMargin && label.of.ink.of != InkOf::Muted;
        m_out.texts.push_back(
            {label.text, label.rect, font, align, isPlain ? Ink{} : label.of.ink});
        m_out.labels.push_back(std::move(label));
    }

    /** In a column, as near as possible to the ends of their lines. */
    void placeInMargin()
    {
        const LabelColumn column{.top = m_out.plot.top - kHeight_px / 2,
                                 .bottom = m_out.plot.bottom + kHeight_px / 2,
                                 .spacing = kHeight_px};
        std::vector<const PlotLabel*> named;
        std::vector<double> wanted;
        const auto room = static_cast<std::size_t>((column.bottom - column.top) / column.spacing);
        for (const PlotLabel& label : m_figure.labels)
            if (isInMargin(label) && named.size() < room) {
                named.push_back(&label);
                wanted.push_back(endOf(label).y);
            }
        const std::vector<double> middles = spreadLabels(wanted, column);
        const double left_px = m_out.plot.right + kLeader_px;
        const double room_px = m_out.size.x - left_px - 4;
        for (std::size_t k = 0; k < named.size(); ++k) {
            const double top_px = middles[k] - kHeight_px / 2;
            add({.text = m_fonts.elided(named[k]->text, FigureFont::Small, room_px),
                 .rect = {left_px, top_px, left_px + room_px, top_px + kHeight_px},
                 .end = endOf(*named[k]),
                 .inMargin = true,
                 .of = *named[k]},
                FigureFont::Small);
        }
    }

    [[nodiscard]] bool isFree(const PixelRect& rect, bool acrossLines) const
    {
        const PixelRect room{0, m_out.plot.top - kFreeHeight_px, m_out.size.x, m_out.plot.bottom};
        return room.contains(rect) &&
               std::none_of(m_out.labels.begin(), m_out.labels.end(),
                            [&](const DrawnLabel& o) { return o.rect.intersects(rect); }) &&
               (acrossLines ||
                std::none_of(m_out.lines.begin(), m_out.lines.end(),
                             [&](const DrawnLine& line) { return crosses(line.points, rect); }));
    }

    bool placeRight(const PlotLabel& label, bool acrossLines)
    {
        const Pixel end = endOf(label);
        for (int k = 0; k < kPlaces; ++k) {
            // 0, 1 up, 1 down, 2 up, ... halves of a line
            const double shift_px = 0.5 * kFreeHeight_px * ((k + 1) / 2) * (k % 2 == 0 ? 1 : -1);
            PixelRect rect{.left = end.x + kGap_px, .top = end.y + shift_px - kFreeHeight_px / 2};
            rect.right = rect.left + width_px(label.text, FigureFont::Small);
            rect.bottom = rect.top + kFreeHeight_px;
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
        for (int k = 1; k <= kPlaces; ++k) {
            PixelRect rect{.left = std::max(m_out.plot.left + 4, end.x - wide_px / 2),
                           .top = end.y - kGap_px - 0.5 * kFreeHeight_px * (k + 2)};
            rect.right = rect.left + wide_px;
            rect.bottom = rect.top + kFreeHeight_px + 2;
            if (!isFree(rect, false))
                continue;
            add({.text = label.text, .rect = rect, .end = end, .of = label}, FigureFont::Strong);
            return true;
        }
        return false;
    }

    /**
     * Right of the end of its line, moved up or down where another label or line is; else above the
     * end; else across lines. Not shown where other labels leave no room.
     */
    void placeFree(const PlotLabel& label)
    {
        if (!placeRight(label, false) && !placeAbove(label))
            placeRight(label, true);
    }

    void placeFixed(const PlotLabel& label)
    {
        const Pixel end = endOf(label);
        const double wide_px = width_px(label.text, FigureFont::Small);
        const bool isLeft = label.place == LabelPlace::Left;
        const double left_px = isLeft ? end.x - wide_px : end.x;
        add({.text = label.text,
             .rect = {left_px, end.y - kHeight_px / 2, left_px + wide_px, end.y + kHeight_px / 2},
             .end = end,
             .of = label},
            FigureFont::Small, isLeft ? TextAlign::Right : TextAlign::Left);
    }

    const Figure& m_figure;
    const FigureFonts& m_fonts;
    Drawing& m_out;
};

} // namespace

double labelMargin_px(const Figure& figure, const Pixel& size, const FigureFonts& fonts)
{
    double widest_px = 0;
    for (const PlotLabel& label : figure.labels)
        if (label.needsMargin)
            widest_px = std::max(widest_px, fonts.width_px(label.text, FigureFont::Small) + 2);
    return widest_px > 0 ? kLeader_px + std::min(widest_px, kMostShare * size.x) - kGap_px : 0;
}

void placeLabels(const Figure& figure, const FigureFonts& fonts, Drawing& drawing)
{
    Labels(figure, fonts, drawing).place();
}

} // namespace berg
