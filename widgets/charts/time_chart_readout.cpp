#include "core/base/label_column.h"
#include "widgets/charts/decimate.h"
#include "widgets/charts/figure_painter.h"
#include "widgets/charts/line_style.h"
#include "widgets/charts/time_chart.h"
#include "widgets/theme/painter_state.h"
#include "widgets/theme/quantity_text.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kFlagHeight_px = 17;
constexpr double kFlagSpacing_px = 19;
constexpr int kWeatherDecimals = 2;     // no forecast is finer
constexpr double kFlagGap_px = 10;      // distance of the flags from the hover line
constexpr double kFlagEdge_px = 4;      // distance of the flags from the plot's edge
constexpr double kFarthestJoin_px = 60; // largest length of the line from a value to its flag
constexpr double kFarthestFlag_px = 48; // largest distance of a flag from its value
constexpr double kFarthestNear_px = 24; // reach of the pointer
constexpr std::size_t kMostFlags = 8;

} // namespace

QRectF TimeChart::plot() const
{
    return toQt(m_figure.drawing.plot);
}

/** Flags shown without a pointer, which names of lines avoid. */
std::vector<PixelRect> TimeChart::flagsAtCursor() const
{
    std::vector<PixelRect> rects;
    if (!m_hover && !m_valuesBeside)
        for (const ReadoutFlag& flag : readout().flags)
            rects.push_back(
                {flag.rect.left(), flag.rect.top(), flag.rect.right(), flag.rect.bottom()});
    return rects;
}

ChartReadout TimeChart::readout() const
{
    ChartReadout readout;
    const TimeWindow& view = m_figure.window;
    const bool atCursor = m_content.cursor_s && *m_content.cursor_s >= view.from_s &&
                          *m_content.cursor_s <= view.to_s;
    if (!hasPoints(m_content))
        return readout;
    if (!m_hover && !atCursor) {
        if (m_valuesBeside)
            readAll(readout, view.to_s);
        return readout;
    }
    const double time_s = m_hover ? m_figure.viewToTime(m_hover->x()) : *m_content.cursor_s;
    const double at_px = m_figure.drawing.x.at(time_s);
    const QFontMetricsF metrics(m_theme.small());
    if (m_hover)
        readout.hover_px = at_px;
    readout.time = m_content.clock.text(time_s);
    const double timeWidth_px = metrics.horizontalAdvance(readout.time) + 10;
    readout.timeRect = QRectF(at_px - timeWidth_px / 2, m_figure.drawing.plot.bottom + 4,
                              timeWidth_px, kFlagHeight_px);
    if (m_valuesBeside) {
        readAll(readout, time_s);
        return readout;
    }

    std::vector<std::optional<QPointF>> values;
    for (const TimeLine& line : m_content.lines)
        values.push_back(line.hidden ? std::nullopt : pointAt(line.points, time_s));
    std::vector<std::size_t> order = byImportance(m_content, values);
    const auto height = [&](std::size_t i) {
        return m_figure.toView(m_content.lines[i], *values[i]).y;
    };
    if (m_hover) // lines near the pointer first
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return std::abs(height(a) - m_hover->y()) < std::abs(height(b) - m_hover->y());
        });
    order.resize(std::min(order.size(), kMostFlags));
    std::vector<double> wanted;
    for (const std::size_t i : order)
        wanted.push_back(height(i));
    const LabelColumn column{.top = m_figure.drawing.plot.top,
                             .bottom = m_figure.drawing.plot.bottom,
                             .spacing = kFlagSpacing_px};
    const auto middles = nameableLabels(wanted, column, kFarthestFlag_px);
    for (std::size_t k = 0; k < order.size(); ++k)
        if (middles[k])
            readout.flags.push_back(flagOf(order[k], *values[order[k]], *middles[k]));
    alignFlags(readout, at_px);
    return readout;
}

/** Adds the values of all lines; without a time, a line that ends earlier has its last value. */
void TimeChart::readAll(ChartReadout& readout, double time_s) const
{
    const auto away_px = [this](const ReadoutFlag& flag) {
        return m_hover ? std::abs(flag.at.y() - m_hover->y()) : kFarthestNear_px;
    };
    for (std::size_t i = 0; i < m_content.lines.size(); ++i) {
        const TimeLine& line = m_content.lines[i];
        std::optional<QPointF> value = line.isShown() ? pointAt(line.points, time_s) : std::nullopt;
        if (!value && line.isShown() && readout.time.isEmpty())
            value = line.points.back();
        if (!value)
            continue;
        readout.flags.push_back(flagOf(i, *value, 0));
        readout.flags.back().isStrong = line.emphasis == LineEmphasis::Strong;
    }
    const auto nearest = std::ranges::min_element(readout.flags, {}, away_px);
    if (nearest != readout.flags.end() && away_px(*nearest) < kFarthestNear_px)
        nearest->isStrong = true;
}

ShownUnit TimeChart::unitOf(const TimeLine& line) const
{
    return line.onRightAxis && line.role != LineRole::Current ? zetaUnit(m_figure.axisOf(line).to)
                                                              : ShownUnit{.name = line.unit};
}

QString TimeChart::valueText(const TimeLine& line, double value) const
{
    // Precision matches what can be read from the axis.
    const PlotScale& axis = m_figure.axisOf(line);
    const ShownUnit unit = unitOf(line);
    value = unit.fromSi(value);
    const double finest = unit.fromSi(axis.to - axis.from) / 1000;
    const bool isWeather = line.role == LineRole::Wind || line.role == LineRole::Gust ||
                           line.role == LineRole::Current;
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(finest))), 0,
                                    isWeather ? kWeatherDecimals : 6);
    if (decimals == 0)
        return significantText(value, 4, locale());
    const double step = std::pow(10.0, -decimals);
    const double rounded = std::round(value / step) * step;
    return fixedText(rounded == 0 ? 0 : rounded, decimals, locale()); // avoids -0
}

ReadoutFlag TimeChart::flagOf(std::size_t index, const QPointF& value, double middle_px) const
{
    const TimeLine& line = m_content.lines[index];
    ReadoutFlag flag{.at = toQt(m_figure.toView(line, value)),
                     .text = {},
                     .colour = colourOf(line),
                     .name = line.shownName(),
                     .value = valueText(line, value.y()),
                     .key = line.key,
                     .isDashed = isDashed(line.role)};
    if (line.role == LineRole::Sigma)
        flag.colour = inkColour(sigmaInk(value.y(), m_content.sigmaFull_m2), m_theme);
    flag.text = flag.name + u' ' + flag.value;
    if (!line.unit.isEmpty())
        flag.unit = unitOf(line).name;
    const QString direction = m_content.directions.textAt(line.role, value.x());
    flag.unit = (flag.unit + u' ' + direction).trimmed();
    if (!flag.unit.isEmpty())
        flag.text += u' ' + flag.unit;
    const double width_px = QFontMetricsF(m_theme.small()).horizontalAdvance(flag.text) + 10;
    flag.rect = QRectF(0, middle_px - kFlagHeight_px / 2, width_px, kFlagHeight_px);
    return flag;
}

/** Aligns the flags in a column at the right, or at the left if the hover line is in its place. */
void TimeChart::alignFlags(ChartReadout& readout, double at_px) const
{
    double widest_px = 0;
    for (const ReadoutFlag& flag : readout.flags)
        widest_px = std::max(widest_px, flag.rect.width());
    const bool hasRightAxis = m_figure.figure.right.has_value(); // its numbers stay visible
    const double right = hasRightAxis ? plot().right() - kFlagEdge_px : viewport()->width() - 2;
    const bool isRight = at_px + kFlagGap_px <= right - widest_px;
    const double left = isRight ? right - widest_px : plot().left() + kFlagEdge_px;
    for (ReadoutFlag& flag : readout.flags)
        flag.rect = QRectF(left, flag.rect.top(), widest_px, flag.rect.height());
}

void TimeChart::paintReadout(QPainter& painter) const
{
    const ChartReadout readout = this->readout();
    if (readout.time.isEmpty())
        return;
    const PainterState saved(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    if (readout.hover_px) {
        painter.setPen(QPen(m_theme.chartAxis, 1));
        painter.drawLine(QPointF(*readout.hover_px, plot().top()),
                         QPointF(*readout.hover_px, plot().bottom()));
    }
    painter.setFont(m_theme.small());
    const auto flag = [&](const QRectF& rect, const QString& text, const QColor& line) {
        painter.setPen(QPen(line, 1));
        painter.setBrush(m_theme.panel);
        painter.drawRoundedRect(rect, 3, 3);
        painter.setPen(m_theme.text);
        painter.drawText(
            rect, static_cast<int>(Qt::AlignCenter) | static_cast<int>(Qt::TextDontClip), text);
    };
    flag(readout.timeRect, readout.time, m_theme.chartAxis);
    for (const ReadoutFlag& one : readout.flags) {
        painter.setPen(QPen(one.colour, 1));
        painter.setBrush(one.colour);
        const double radius_px = one.isStrong ? 4 : 3;
        painter.drawEllipse(one.at, radius_px, radius_px);
        if (m_valuesBeside)
            continue;
        const bool isRight = one.rect.left() > one.at.x();
        const QPointF edge(isRight ? one.rect.left() : one.rect.right(), one.rect.center().y());
        // Farther flags are recognised by colour and name.
        if (std::abs(edge.x() - one.at.x()) <= kFarthestJoin_px)
            painter.drawLine(one.at, edge);
        flag(one.rect, one.text, one.colour);
    }
}

} // namespace berg
