#include "widgets/panels/flight/run_time_line.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kMilli = 1000;
constexpr int kStep_ms = 1000;
constexpr int kPage_ms = 30'000;
constexpr double kBar_px = 4;
constexpr double kHandle_px = 6; ///< radius of the handle
constexpr int kHeight_px = 26;
constexpr int kNarrowest_px = 24;
constexpr int kWidth_px = 160;
constexpr double kMark_px = 6;
constexpr double kNear_px = 5;

/** Plans and sightings are too frequent to mark; a return is marked by its landing. */
bool isMarked(EventKind kind)
{
    return kind != EventKind::Planned && kind != EventKind::Sighted && kind != EventKind::HomeBound;
}

} // namespace

RunTimeLine::RunTimeLine(QWidget* parent) : QAbstractSlider(parent)
{
    setOrientation(Qt::Horizontal);
    setSingleStep(kStep_ms);
    setPageStep(kPage_ms);
    setRange(0, 0);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(this, &QAbstractSlider::actionTriggered, this,
            [this] { emit scrubbed(sliderPosition() / kMilli); });
}

void RunTimeLine::setTheme(const Theme& theme)
{
    m_theme = theme;
    update();
}

void RunTimeLine::showTime(double time_s, double newest_s, double duration_s)
{
    const QSignalBlocker silent(this);
    m_duration_s = std::max(duration_s, 1e-3);
    setMaximum(static_cast<int>(std::lround(newest_s * kMilli)));
    setValue(static_cast<int>(std::lround(time_s * kMilli)));
    update();
}

void RunTimeLine::setMarks(std::vector<TimeMark> marks)
{
    std::erase_if(marks, [](const TimeMark& mark) { return !isMarked(mark.kind); });
    m_marks = std::move(marks);
    update();
}

void RunTimeLine::setNoReturn(std::optional<double> time_s)
{
    m_noReturn_s = time_s;
    update();
}

QSize RunTimeLine::sizeHint() const
{
    return {kWidth_px, kHeight_px};
}

QSize RunTimeLine::minimumSizeHint() const
{
    return {kNarrowest_px, kHeight_px};
}

double RunTimeLine::toPixel(double time_s) const
{
    return kHandle_px + (width() - 2 * kHandle_px) * time_s / m_duration_s;
}

double RunTimeLine::toTime(double x_px) const
{
    const double part = (x_px - kHandle_px) / std::max(1.0, width() - 2 * kHandle_px);
    return std::clamp(part * m_duration_s, 0.0, maximum() / kMilli);
}

void RunTimeLine::goTo(double x_px)
{
    const double time_s = toTime(x_px);
    {
        const QSignalBlocker silent(this);
        setValue(static_cast<int>(std::lround(time_s * kMilli)));
    }
    update();
    emit scrubbed(time_s);
}

void RunTimeLine::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        goTo(event->position().x());
}

void RunTimeLine::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons() & Qt::LeftButton)
        goTo(event->position().x());
}

void RunTimeLine::mouseReleaseEvent(QMouseEvent* /*event*/) {}

const TimeMark* RunTimeLine::markAt(double x_px) const
{
    const TimeMark* nearest = nullptr;
    double distance_px = kNear_px;
    for (const TimeMark& mark : m_marks)
        if (const double d_px = std::abs(toPixel(mark.time_s) - x_px); d_px <= distance_px) {
            nearest = &mark;
            distance_px = d_px;
        }
    return nearest;
}

bool RunTimeLine::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QAbstractSlider::event(event);
    const auto& help = *static_cast<QHelpEvent*>(event);
    if (m_noReturn_s && std::abs(toPixel(*m_noReturn_s) - help.pos().x()) <= kNear_px) {
        QToolTip::showText(help.globalPos(),
                           tr("%1: point of no return; a later return uses the reserve")
                               .arg(m_clock.text(*m_noReturn_s)),
                           this);
        return true;
    }
    const TimeMark* mark = markAt(help.pos().x());
    const double time_s = mark != nullptr ? mark->time_s : toTime(help.pos().x());
    const QString text =
        mark != nullptr ? mark->text + u'\n' + m_clock.details(time_s) : m_clock.toolTip(time_s);
    QToolTip::showText(help.globalPos(), text.trimmed(), this);
    return true;
}

void RunTimeLine::paintMarks(QPainter& painter) const
{
    const double bar_px = height() / 2.0;
    std::optional<double> last_px;
    for (const TimeMark& mark : m_marks) {
        const double x_px = toPixel(mark.time_s);
        if (mark.kind == EventKind::Reached) {
            if (std::floor(x_px) == last_px)
                continue; // one mark a pixel is enough
            last_px = std::floor(x_px);
            painter.setPen(QPen(m_theme.uav, 1.4));
            painter.drawLine(QPointF(x_px, bar_px - kBar_px - kMark_px),
                             QPointF(x_px, bar_px - kBar_px));
        } else {
            painter.setPen(QPen(m_theme.text, 1.2));
            painter.setBrush(mark.kind == EventKind::Appeared ? m_theme.chart : m_theme.text);
            const double y_px = bar_px + kBar_px + kMark_px / 2;
            painter.drawPolygon(QPolygonF{QPointF(x_px, y_px - 3), QPointF(x_px + 3, y_px),
                                          QPointF(x_px, y_px + 3), QPointF(x_px - 3, y_px)});
        }
    }
}

/** Paints a vertical mark across the bar. */
void RunTimeLine::paintNoReturn(QPainter& painter) const
{
    if (!m_noReturn_s || *m_noReturn_s > m_duration_s)
        return;
    const double x_px = toPixel(*m_noReturn_s);
    painter.setPen(QPen(m_theme.uav, 2));
    painter.drawLine(QPointF(x_px, kMark_px), QPointF(x_px, height() - kMark_px));
}

void RunTimeLine::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    const auto bar = [&](double until_s, const QColor& colour) {
        painter.setBrush(colour);
        painter.drawRoundedRect(
            QRectF(toPixel(0), (height() - kBar_px) / 2, toPixel(until_s) - toPixel(0), kBar_px),
            kBar_px / 2, kBar_px / 2);
    };
    constexpr double kInk = 0.55; // contrast of 3 : 1 to the window
    const QColor ahead = mixed(m_theme.chart, m_theme.text, kInk);
    bar(m_duration_s, ahead);
    if (maximum() > 0)
        bar(maximum() / kMilli, mixed(ahead, m_theme.plan, 0.6));
    if (value() > 0)
        bar(value() / kMilli, m_theme.plan);
    paintMarks(painter);
    paintNoReturn(painter);
    const QPointF handle(toPixel(value() / kMilli), height() / 2.0);
    painter.setPen(QPen(hasFocus() ? m_theme.text : m_theme.chart, 1.5));
    painter.setBrush(m_theme.plan);
    painter.drawEllipse(handle, kHandle_px - 1, kHandle_px - 1);
}

} // namespace berg
