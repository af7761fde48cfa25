#include "widgets/charts/chart_labels.h"
#include "widgets/charts/decimate.h"
#include "widgets/charts/time_chart.h"
#include "widgets/theme/quantity_text.h"

#include <QFontMetricsF>
#include <QValueAxis>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kLabelHeight_px = 15;
constexpr double kLeader_px = 16;        // between the end of a line and its label in the margin
constexpr double kFarthestLabel_px = 32; // from the end of its line
constexpr double kFlagHeight_px = 17;
constexpr double kFlagSpacing_px = 19;
constexpr double kFlagGap_px = 10;      // between the line of the instant and the flags
constexpr double kFarthestFlag_px = 48; // from the value
constexpr std::size_t kMostFlags = 8;

/** Where the polyline ends within a view that ends at `to`. */
std::optional<QPointF> endOf(const QList<QPointF>& points, const TimeWindow& view)
{
    if (points.empty() || points.back().x() > view.to_s)
        return pointAt(points, view.to_s);
    return points.back().x() < view.from_s ? std::nullopt : std::optional(points.back());
}

QFont labelFont(const Theme& theme, bool isStrong)
{
    QFont font = theme.small();
    font.setBold(isStrong);
    return font;
}

} // namespace

double TimeChart::marginWidth() const
{
    double width_px = 0;
    for (const bool isStrong : {false, true}) {
        const QFontMetricsF metrics(labelFont(m_theme, isStrong));
        for (const TimeLine& line : m_content.lines)
            if (!line.hidden && (line.emphasis == LineEmphasis::Strong) == isStrong)
                width_px = std::max(width_px, metrics.horizontalAdvance(line.label));
    }
    return kLeader_px + width_px;
}

std::vector<std::size_t>
TimeChart::byImportance(const std::vector<std::optional<QPointF>>& points) const
{
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i])
            order.push_back(i);
    const auto isStrong = [this](std::size_t i) {
        return m_content.lines[i].emphasis == LineEmphasis::Strong;
    };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return isStrong(a) != isStrong(b) ? isStrong(a) : points[a]->y() > points[b]->y();
    });
    return order;
}

void TimeChart::placeMarginLabels()
{
    // Where lines crowd, the most uncertain ones are named.
    std::vector<std::optional<QPointF>> ends;
    for (const QList<QPointF>& points : m_drawn)
        ends.push_back(endOf(points, window()));
    const std::vector<std::size_t> named = byImportance(ends);
    const LabelColumn column{.top = m_frame.plot.top() - kLabelHeight_px / 2,
                             .bottom = m_frame.plot.bottom() + kLabelHeight_px / 2,
                             .spacing = kLabelHeight_px};
    std::vector<double> wanted;
    for (const std::size_t i : named)
        wanted.push_back(toView(m_content.lines[i], *ends[i]).y());
    const std::vector<std::optional<double>> middles =
        nameableLabels(wanted, column, kFarthestLabel_px);
    for (std::size_t k = 0; k < named.size(); ++k) {
        if (!middles[k])
            continue;
        const TimeLine& line = m_content.lines[named[k]];
        const QPointF end = toView(line, *ends[named[k]]);
        const bool isStrong = line.emphasis == LineEmphasis::Strong;
        const QFontMetricsF metrics(labelFont(m_theme, isStrong));
        m_frame.labels.push_back(
            {.text = line.label,
             .rect = QRectF(end.x() + kLeader_px, *middles[k] - kLabelHeight_px / 2,
                            metrics.horizontalAdvance(line.label) + 2, kLabelHeight_px),
             .end = end,
             .colour = lineColour(line),
             .inMargin = true,
             .strong = isStrong,
             .key = line.key});
    }
}

void TimeChart::placeInnerLabels()
{
    std::vector<QPolygonF> polygons;
    for (std::size_t i = 0; i < m_drawn.size(); ++i) {
        QPolygonF polygon;
        for (const QPointF& p : m_drawn[i])
            polygon << toView(m_content.lines[i], p);
        polygons.push_back(polygon);
    }
    std::vector<QRectF> taken;
    for (const ChartReference& reference : m_frame.references) {
        const double width_px = QFontMetricsF(m_theme.small()).horizontalAdvance(reference.text);
        taken.emplace_back(m_frame.plot.right() - width_px - 6, reference.at_px - 17, width_px, 17);
    }
    if (m_frame.cursor_px)
        taken.emplace_back(*m_frame.cursor_px - 1, m_frame.plot.top(), 2, m_frame.plot.height());
    if (!m_hover) // the values at the cursor stay
        for (const ReadoutFlag& flag : readout().flags)
            taken.push_back(flag.rect);
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const TimeLine& line = m_content.lines[i];
        const bool isQuiet = line.role == LineRole::Bound;
        const QFontMetricsF metrics(isQuiet ? m_theme.small() : m_theme.strong());
        const QSizeF size(metrics.horizontalAdvance(line.label) + 2, metrics.height());
        const auto rect = labelBesideLine(polygons[i], polygons, taken, size,
                                          m_frame.plot.adjusted(4, 0, -4, -kChartMark_px - 2));
        if (!rect)
            continue;
        taken.push_back(*rect);
        m_frame.labels.push_back({.text = line.label,
                                  .rect = *rect,
                                  .end = polygons[i].back(),
                                  .colour = lineColour(line),
                                  .quiet = isQuiet,
                                  .key = line.key});
    }
}

std::vector<QRectF> TimeChart::labelRects() const
{
    std::vector<QRectF> rects;
    for (const ChartLabel& label : m_frame.labels)
        rects.push_back(label.rect);
    return rects;
}

ChartReadout TimeChart::readout() const
{
    ChartReadout readout;
    if (!hasPoints() || (!m_hover && !m_frame.cursor_px))
        return readout;
    const double time_s = m_hover ? viewToTime(m_hover->x()) : *m_content.cursor_s;
    const double at_px = timeToView(time_s);
    const QFontMetricsF metrics(m_theme.small());
    if (m_hover)
        readout.hover_px = at_px;
    readout.time = clockText(time_s);
    const double timeWidth_px = metrics.horizontalAdvance(readout.time) + 10;
    readout.timeRect =
        QRectF(at_px - timeWidth_px / 2, m_frame.plot.bottom() + 4, timeWidth_px, kFlagHeight_px);

    std::vector<std::optional<QPointF>> values;
    for (const TimeLine& line : m_content.lines)
        values.push_back(line.hidden ? std::nullopt : pointAt(line.points, time_s));
    std::vector<std::size_t> order = byImportance(values);
    const auto height = [&](std::size_t i) { return toView(m_content.lines[i], *values[i]).y(); };
    if (m_hover) // those near the pointer
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return std::abs(height(a) - m_hover->y()) < std::abs(height(b) - m_hover->y());
        });
    order.resize(std::min(order.size(), kMostFlags));
    std::vector<double> wanted;
    for (const std::size_t i : order)
        wanted.push_back(height(i));
    const LabelColumn column{
        .top = m_frame.plot.top(), .bottom = m_frame.plot.bottom(), .spacing = kFlagSpacing_px};
    const auto middles = nameableLabels(wanted, column, kFarthestFlag_px);
    for (std::size_t k = 0; k < order.size(); ++k)
        if (middles[k])
            readout.flags.push_back(flagOf(order[k], *values[order[k]], *middles[k]));
    alignFlags(readout, at_px);
    return readout;
}

QString TimeChart::valueText(const TimeLine& line, double value) const
{
    // As fine as the eye could read the axis, and no finer.
    const QValueAxis& axis = line.onRightAxis ? *m_right : *m_left;
    const double finest = (axis.max() - axis.min()) / 1000;
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(finest))), 0, 6);
    if (decimals == 0)
        return significantText(value, 4, locale());
    const double unit = std::pow(10.0, -decimals);
    const double rounded = std::round(value / unit) * unit;
    return fixedText(rounded == 0 ? 0 : rounded, decimals, locale()); // never -0
}

ReadoutFlag TimeChart::flagOf(std::size_t index, const QPointF& value, double middle_px) const
{
    const TimeLine& line = m_content.lines[index];
    ReadoutFlag flag{.at = toView(line, value), .text = line.name, .colour = lineColour(line)};
    if (line.role == LineRole::Sigma)
        flag.colour = m_theme.sigma.colour(value.y(), m_content.sigmaFull_m2);
    if (flag.text.isEmpty())
        flag.text = line.label;
    flag.text += u' ' + valueText(line, value.y());
    if (!line.unit.isEmpty())
        flag.text += u' ' + line.unit;
    const double width_px = QFontMetricsF(m_theme.small()).horizontalAdvance(flag.text) + 10;
    flag.rect = QRectF(0, middle_px - kFlagHeight_px / 2, width_px, kFlagHeight_px);
    return flag;
}

void TimeChart::alignFlags(ChartReadout& readout, double at_px) const
{
    double widest_px = 0;
    for (const ReadoutFlag& flag : readout.flags)
        widest_px = std::max(widest_px, flag.rect.width());
    const bool isRight = at_px + kFlagGap_px + widest_px <= viewport()->width() - 2;
    for (ReadoutFlag& flag : readout.flags)
        flag.rect.moveLeft(isRight ? at_px + kFlagGap_px : at_px - kFlagGap_px - flag.rect.width());
}

} // namespace berg
