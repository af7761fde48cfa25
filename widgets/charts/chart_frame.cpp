#include "widgets/charts/chart_frame.h"

#include <QFontMetricsF>

#include <algorithm>

namespace berg {
namespace {

int flags(Qt::Alignment alignment)
{
    return static_cast<int>(alignment) | static_cast<int>(Qt::TextDontClip);
}

void paintAxes(QPainter& painter, const ChartFrame& frame, const Theme& theme)
{
    const QRectF& plot = frame.plot;
    painter.setPen(QPen(theme.chartAxis, 1));
    painter.drawLine(plot.bottomLeft(), plot.bottomRight());
    painter.setFont(theme.small());
    painter.setPen(theme.mutedText);
    for (const ChartTick& tick : frame.left)
        painter.drawText(QRectF(0, tick.at_px - 8, plot.left() - kChartTickGap_px, 16),
                         flags(Qt::AlignRight | Qt::AlignVCenter), tick.text);
    for (const ChartTick& tick : frame.right)
        painter.drawText(QRectF(plot.right() + kChartTickGap_px, tick.at_px - 8, 100, 16),
                         flags(Qt::AlignLeft | Qt::AlignVCenter), tick.text);
    for (const ChartTick& tick : frame.times)
        painter.drawText(QRectF(tick.at_px - 40, plot.bottom() + 5, 80, 16), flags(Qt::AlignCenter),
                         tick.text);
    painter.drawText(QRectF(plot.left(), plot.bottom() + 22, plot.width(), 16),
                     flags(Qt::AlignCenter), frame.timeTitle);
}

/** Width of the key of the marks at the right end of the title row; 0: none, or no room. */
double marksKeyWidth(const ChartFrame& frame, const Theme& theme)
{
    if (frame.marks_px.empty() || !frame.emptyText.isEmpty())
        return 0;
    const QFontMetricsF small(theme.small());
    const double width_px = small.horizontalAdvance(frame.marksTitle) + 14;
    if (!frame.title.isEmpty())
        return width_px < 0.3 * frame.size.width() ? width_px : 0;
    const double titles_px =
        2 * std::max(small.horizontalAdvance(frame.leftTitle),
                     small.horizontalAdvance(frame.rightTitle)); // the key is in the middle
    return titles_px + width_px + 40 < frame.size.width() ? width_px : 0;
}

void paintTitles(QPainter& painter, const ChartFrame& frame, const Theme& theme)
{
    const double width_px = frame.size.width() - 2 * kChartSide_px - marksKeyWidth(frame, theme);
    painter.setFont(theme.strong());
    painter.setPen(theme.text);
    painter.drawText(
        QRectF(kChartSide_px, 12, width_px, 18), flags(Qt::AlignLeft | Qt::AlignVCenter),
        QFontMetricsF(theme.strong()).elidedText(frame.title, Qt::ElideRight, width_px));
    painter.setFont(theme.small());
    QRectF row(kChartSide_px, chartTop(frame) - 27, frame.size.width() - 2 * kChartSide_px, 16);
    painter.setPen(frame.leftColour);
    painter.drawText(row, flags(Qt::AlignLeft | Qt::AlignVCenter), frame.leftTitle);
    painter.setPen(frame.rightColour);
    row.setRight(frame.rightEdge_px.value_or(row.right()));
    painter.drawText(row, flags(Qt::AlignRight | Qt::AlignVCenter), frame.rightTitle);
}

void paintMarks(QPainter& painter, const ChartFrame& frame, const Theme& theme)
{
    painter.setPen(QPen(theme.uav, 1.6, Qt::SolidLine, Qt::FlatCap));
    const double foot = frame.plot.bottom();
    for (const double x : frame.marks_px)
        painter.drawLine(QPointF(x, foot - kChartMark_px), QPointF(x, foot));
    const double key_px = marksKeyWidth(frame, theme);
    if (key_px == 0)
        return;
    const bool titled = !frame.title.isEmpty();
    const double left_px =
        (titled ? frame.size.width() - kChartSide_px - key_px : (frame.size.width() - key_px) / 2) +
        14;
    const double top_px = titled ? 12 : chartTop(frame) - 28;
    painter.drawLine(QPointF(left_px - 7, top_px + 5),
                     QPointF(left_px - 7, top_px + 5 + kChartMark_px));
    painter.setFont(theme.small());
    painter.setPen(theme.mutedText);
    painter.drawText(QRectF(left_px, top_px, key_px, 18), flags(Qt::AlignLeft | Qt::AlignVCenter),
                     frame.marksTitle);
}

void paintReferences(QPainter& painter, const ChartFrame& frame, const Theme& theme)
{
    painter.setFont(theme.small());
    for (const ChartReference& reference : frame.references) {
        painter.setPen(QPen(theme.mutedText, 1, Qt::DashLine, Qt::FlatCap));
        painter.drawLine(QPointF(frame.plot.left(), reference.at_px),
                         QPointF(frame.plot.right(), reference.at_px));
        painter.setPen(theme.mutedText);
        painter.drawText(
            QRectF(frame.plot.left() + 6, reference.at_px - 17, frame.plot.width() - 12, 16),
            flags(Qt::AlignRight | Qt::AlignVCenter), reference.text);
    }
}

void paintCursor(QPainter& painter, const ChartFrame& frame, const Theme& theme)
{
    if (!frame.cursor_px)
        return;
    painter.setPen(QPen(theme.uav, 1.2));
    painter.drawLine(QPointF(*frame.cursor_px, frame.plot.top()),
                     QPointF(*frame.cursor_px, frame.plot.bottom()));
}

void paintLabels(QPainter& painter, const ChartFrame& frame, const Theme& theme)
{
    for (const ChartLabel& label : frame.labels) {
        const bool isSmall = label.inMargin || label.quiet;
        QFont font = isSmall ? theme.small() : theme.strong();
        font.setBold(!isSmall || label.strong);
        painter.setFont(font);
        if (label.inMargin) {
            painter.setPen(QPen(label.colour, 1));
            const double y = label.rect.center().y();
            painter.drawPolyline(QPolygonF{label.end, QPointF(label.end.x() + 5, y),
                                           QPointF(label.rect.left() - 3, y)});
        }
        painter.setPen(label.inMargin ? theme.text : label.colour);
        painter.drawText(label.rect, flags(Qt::AlignLeft | Qt::AlignVCenter), label.text);
    }
}

} // namespace

double chartTop(const ChartFrame& frame)
{
    return frame.title.isEmpty() ? kChartTop_px - kChartTitle_px : kChartTop_px;
}

void paintChartGrid(QPainter& painter, const ChartFrame& frame, const Theme& theme)
{
    painter.setPen(QPen(theme.chartGrid, 1));
    const QRectF& plot = frame.plot;
    for (const ChartTick& tick : frame.left)
        painter.drawLine(QPointF(plot.left(), tick.at_px), QPointF(plot.right(), tick.at_px));
    for (const ChartTick& tick : frame.times)
        painter.drawLine(QPointF(tick.at_px, plot.top()), QPointF(tick.at_px, plot.bottom()));
}

void paintChartFrame(QPainter& painter, const ChartFrame& frame, const Theme& theme)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    paintAxes(painter, frame, theme);
    paintTitles(painter, frame, theme);
    if (frame.emptyText.isEmpty()) {
        paintMarks(painter, frame, theme);
        paintReferences(painter, frame, theme);
        paintCursor(painter, frame, theme);
        paintLabels(painter, frame, theme);
    } else {
        painter.setFont(theme.body());
        painter.setPen(theme.mutedText);
        painter.drawText(frame.plot, flags(Qt::AlignCenter), frame.emptyText);
    }
    painter.restore();
}

void paintReadout(QPainter& painter, const ChartReadout& readout, const QRectF& plot,
                  const Theme& theme)
{
    if (readout.time.isEmpty())
        return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (readout.hover_px) {
        painter.setPen(QPen(theme.chartAxis, 1));
        painter.drawLine(QPointF(*readout.hover_px, plot.top()),
                         QPointF(*readout.hover_px, plot.bottom()));
    }
    painter.setFont(theme.small());
    const auto flag = [&](const QRectF& rect, const QString& text, const QColor& line) {
        painter.setPen(QPen(line, 1));
        painter.setBrush(theme.panel);
        painter.drawRoundedRect(rect, 3, 3);
        painter.setPen(theme.text);
        painter.drawText(rect, flags(Qt::AlignCenter), text);
    };
    flag(readout.timeRect, readout.time, theme.chartAxis);
    for (const ReadoutFlag& one : readout.flags) {
        const bool isRight = one.rect.left() > one.at.x();
        painter.setPen(QPen(one.colour, 1));
        painter.drawLine(
            one.at, QPointF(isRight ? one.rect.left() : one.rect.right(), one.rect.center().y()));
        painter.setBrush(one.colour);
        painter.drawEllipse(one.at, 3, 3);
        flag(one.rect, one.text, one.colour);
    }
    painter.restore();
}

} // namespace berg
