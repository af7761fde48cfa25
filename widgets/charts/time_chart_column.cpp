#include "widgets/charts/decimate.h"
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

constexpr double kNarrowest_px = 420; // smallest width of a chart with a column
constexpr double kMostShare = 0.4;    // largest share of the width for one column
constexpr double kMostOfAll = 0.5;    // and for all columns
constexpr double kEdge_px = 8;        // margin above, below and right of the rows
constexpr double kRow_px = 14;
constexpr double kTallRow_px = 33; // row with name and value on two lines
constexpr double kMark_px = 10;    // length of the line's colour mark
constexpr double kMarkGap_px = 5;
constexpr double kGap_px = 8;   // distance between name and value
constexpr double kNear_px = 24; // reach of the pointer
constexpr double kWidthStep_px =
    4; // width steps, so that the plot keeps its width while numbers grow

QFont boldSmall(const Theme& theme)
{
    QFont font = theme.small();
    font.setBold(true);
    return font;
}

} // namespace

/** Rows have two lines, the name above value and unit, if there is room; otherwise one. */
ValueColumn TimeChart::columnFor(const QSizeF& size_px) const
{
    ValueColumn column{.top_px = kEdge_px, .row_px = kRow_px};
    if (!m_isColumnWanted || size_px.width() < kNarrowest_px)
        return column;
    const QFontMetricsF metrics(boldSmall(m_theme));
    std::size_t count = 0;
    double name_px = 0;
    double value_px = metrics.horizontalAdvance(u"00.00"_s);
    double unit_px = 0;
    for (const TimeLine& line : m_content.lines) {
        if (!line.isShown())
            continue;
        ++count;
        double largest = 0;
        for (const QPointF& p : line.points)
            largest = std::max(largest, std::abs(p.y()));
        name_px = std::max(name_px, metrics.horizontalAdvance(line.shownName()));
        const ShownUnit unit = line.onRightAxis ? zetaUnit(largest) : ShownUnit{.name = line.unit};
        const QString value = significantText(unit.fromSi(largest), 4, locale());
        value_px = std::max(value_px, metrics.horizontalAdvance(value));
        unit_px = std::max(unit_px, metrics.horizontalAdvance(u' ' + unit.name));
    }
    if (count == 0)
        return column;
    const double room_px = size_px.height() - 2 * kEdge_px;
    column.hasUnits = static_cast<double>(count) * kTallRow_px <= room_px;
    if (column.hasUnits)
        column.row_px = kTallRow_px;
    column.rows = static_cast<std::size_t>(std::max(1.0, room_px / column.row_px));
    const double text_px =
        column.hasUnits ? std::max(name_px, value_px + unit_px) : name_px + kGap_px + value_px;
    const double wanted_px = kMark_px + kMarkGap_px + text_px + kEdge_px;
    column.width_px = std::min(kWidthStep_px * std::ceil(wanted_px / kWidthStep_px),
                               std::floor(kMostShare * size_px.width()));
    column.columns =
        std::min((count + column.rows - 1) / column.rows,
                 static_cast<std::size_t>(kMostOfAll * size_px.width() / column.width_px));
    column.rows = std::min(column.rows, (count + column.columns - 1) / column.columns);
    column.left_px = size_px.width() - static_cast<double>(column.columns) * column.width_px;
    return column;
}

/** Lines that get a row, in order; if there are too many, the most important ones. */
std::vector<std::size_t> TimeChart::rowsAt(const std::vector<std::optional<QPointF>>& values,
                                           ChartReadout& readout) const
{
    std::vector<std::size_t> rows = byImportance(m_content, values);
    const auto away_px = [&](std::size_t i) {
        return std::abs(m_figure.toView(m_content.lines[i], *values[i]).y - m_hover->y());
    };
    if (m_hover) // lines near the pointer first
        std::ranges::stable_sort(rows, {}, away_px);
    const std::size_t room = m_column.rows * m_column.columns;
    if (rows.size() > room) {
        readout.more = rows.size() - (room - 1); // the last row shows the number of hidden ones
        rows.resize(room - 1);
    }
    std::ranges::sort(rows);
    return rows;
}

void TimeChart::fillColumn(ChartReadout& readout, double time_s) const
{
    std::vector<std::optional<QPointF>> values;
    for (const TimeLine& line : m_content.lines) {
        values.push_back(line.isShown() ? pointAt(line.points, time_s) : std::nullopt);
        if (readout.time.isEmpty() && line.isShown() && !values.back())
            values.back() = line.points.back(); // the line ends earlier
    }
    double nearest_px = kNear_px;
    std::optional<std::size_t> nearest;
    for (const std::size_t i : rowsAt(values, readout)) {
        const std::size_t k = readout.flags.size();
        ReadoutFlag row = flagOf(i, *values[i], 0);
        const std::size_t column = k / m_column.rows;
        row.rect = {m_column.left_px + m_column.width_px * static_cast<double>(column),
                    m_column.top_px + m_column.row_px * static_cast<double>(k % m_column.rows),
                    m_column.width_px, m_column.row_px};
        row.isStrong = m_content.lines[i].emphasis == LineEmphasis::Strong;
        if (m_column.hasUnits && !m_content.lines[i].unit.isEmpty())
            row.value += u' ' + unitOf(m_content.lines[i]).name;
        if (m_hover && std::abs(row.at.y() - m_hover->y()) < nearest_px) {
            nearest_px = std::abs(row.at.y() - m_hover->y());
            nearest = k;
        }
        readout.flags.push_back(std::move(row));
    }
    if (nearest)
        readout.flags[*nearest].isStrong = true;
}

void TimeChart::paintColumn(QPainter& painter, const ChartReadout& readout) const
{
    const PainterState saved(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    const auto left = int{Qt::AlignLeft | Qt::AlignVCenter};
    for (const ReadoutFlag& row : readout.flags) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(row.colour);
        if (!readout.time.isEmpty())
            painter.drawEllipse(row.at, row.isStrong ? 4 : 2.5, row.isStrong ? 4 : 2.5);
        QRectF line(row.rect.left(), row.rect.top(), row.rect.width() - kEdge_px, kRow_px);
        painter.drawRect(QRectF(line.left(), line.center().y() - 1.5, kMark_px, 3));
        line.setLeft(line.left() + kMark_px + kMarkGap_px);
        const QFont font = row.isStrong ? boldSmall(m_theme) : m_theme.small();
        const QFontMetricsF metrics(font);
        const double taken_px =
            m_column.hasUnits ? 0 : metrics.horizontalAdvance(row.value) + kGap_px;
        painter.setFont(font);
        painter.setPen(row.isStrong ? m_theme.text : m_theme.mutedText);
        painter.drawText(line, left,
                         metrics.elidedText(row.name, Qt::ElideRight, line.width() - taken_px));
        painter.setPen(m_theme.text);
        if (m_column.hasUnits)
            painter.drawText(line.translated(0, kRow_px), left, row.value);
        else
            painter.drawText(line, int{Qt::AlignRight | Qt::AlignVCenter}, row.value);
    }
    if (readout.more == 0)
        return;
    const QRectF last(m_column.left_px +
                          m_column.width_px * static_cast<double>(m_column.columns - 1),
                      m_column.top_px + m_column.row_px * static_cast<double>(m_column.rows - 1),
                      m_column.width_px - kEdge_px, kRow_px);
    painter.setFont(m_theme.small());
    painter.setPen(m_theme.mutedText);
    painter.drawText(last, int{Qt::AlignRight | Qt::AlignVCenter},
                     u'+' + locale().toString(readout.more));
}

} // namespace berg
