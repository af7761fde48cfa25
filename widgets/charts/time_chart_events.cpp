#include "widgets/charts/figure_painter.h"
#include "widgets/charts/time_chart.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace berg {
namespace {

constexpr double kNotch = 1.25; // zoom per notch of the wheel or key press
constexpr int kNotchAngle = 120;
constexpr double kKeyPan = 0.1;      // share of the window
constexpr double kFollow_s = 300;    // window length when following starts with all in view
constexpr double kShortest_s = 1e-3; // smallest length of an axis
constexpr double kPlotEdge_px = 4;   // tolerance for presses beside the plot

} // namespace

TimeWindow TimeChart::windowFor(const TimeChartContent& content) const
{
    if (!m_zoom)
        return {.from_s = 0, .to_s = std::max(kShortest_s, content.duration_s)};
    if (!m_following)
        return *m_zoom;
    const double end_s = std::max(kShortest_s, content.followed_s.value_or(content.duration_s));
    return {.from_s = std::max(0.0, end_s - m_zoom->length_s()), .to_s = end_s};
}

void TimeChart::changeWindow()
{
    m_isLaidOut = false;
    emit windowChanged();
    if (!m_isLaidOut) // no receiver set new content, which also lays out
        layOut();
}

void TimeChart::setWindow(const TimeWindow& window)
{
    m_following = false;
    m_zoom = window;
    changeWindow();
}

void TimeChart::showAll()
{
    m_following = false;
    m_zoom.reset();
    changeWindow();
}

void TimeChart::shareWindow(const TimeChart& other)
{
    if (m_zoom == other.m_zoom && m_following == other.m_following)
        return;
    m_zoom = other.m_zoom;
    m_following = other.m_following;
    changeWindow();
}

void TimeChart::setFollowing(bool on)
{
    if (on == isFollowing())
        return;
    if (on && !m_zoom)
        m_zoom = TimeWindow{.from_s = 0, .to_s = kFollow_s};
    else if (!on)
        m_zoom = window();
    m_following = on;
    changeWindow();
}

void TimeChart::zoom(double factor, double anchor_s)
{
    const double duration_s = std::max(kShortest_s, m_content.duration_s);
    const TimeWindow now = window();
    if (now.length_s() * factor >= duration_s) {
        if (m_zoom)
            showAll();
        return;
    }
    m_zoom = zoomed(now, factor, m_following ? now.to_s : anchor_s, duration_s);
    changeWindow();
}

void TimeChart::pan(double by_s)
{
    if (!m_zoom || by_s == 0)
        return;
    m_zoom = shifted(window(), by_s, m_content.duration_s);
    m_following = false;
    changeWindow();
}

void TimeChart::pick(const QMouseEvent& event)
{
    if (hasPoints(m_content))
        emit timePicked(m_figure.viewToTime(event.position().x()));
}

QString TimeChart::lineAt(const QPointF& position) const
{
    const std::vector<DrawnLabel>& labels = m_figure.drawing.labels;
    const auto found = std::find_if(labels.begin(), labels.end(), [&](const DrawnLabel& label) {
        return label.inMargin && toQt(label.rect).contains(position);
    });
    return found == labels.end() ? QString() : QString::fromStdString(found->of.key);
}

void TimeChart::hoverAt(std::optional<QPointF> position)
{
    if (position && !plot().contains(*position))
        position.reset();
    if (!position && !m_hover)
        return;
    m_hover = position;
    viewport()->update();
    emit readoutChanged();
}

void TimeChart::mousePressEvent(QMouseEvent* event)
{
    const bool shifted = event->modifiers().testFlag(Qt::ShiftModifier);
    if (event->button() != Qt::LeftButton || shifted) {
        m_panFrom = event->position();
        m_hasPanned = false; // becomes true after the drag distance
        hoverAt({});
        return;
    }
    if (const QString key = lineAt(event->position()); !key.isEmpty()) {
        emit linePicked(key);
        return;
    }
    m_picking = plot()
                    .adjusted(-kPlotEdge_px, -kPlotEdge_px, kPlotEdge_px, kPlotEdge_px)
                    .contains(event->position());
    if (m_picking)
        pick(*event);
}

void TimeChart::mouseMoveEvent(QMouseEvent* event)
{
    if (m_panFrom) {
        const QPointF moved = event->position() - *m_panFrom;
        m_hasPanned = m_hasPanned || moved.manhattanLength() >= QApplication::startDragDistance();
        if (!m_hasPanned)
            return;
        const double moved_px = moved.x();
        m_panFrom = event->position();
        pan(-moved_px / m_figure.drawing.plot.width() * window().length_s());
        return;
    }
    if (m_picking && event->buttons().testFlag(Qt::LeftButton))
        pick(*event);
    hoverAt(event->position());
    viewport()->setCursor(lineAt(event->position()).isEmpty() ? Qt::ArrowCursor
                                                              : Qt::PointingHandCursor);
}

void TimeChart::mouseReleaseEvent(QMouseEvent* event)
{
    const bool isClick = m_panFrom && !m_hasPanned && event->button() == Qt::RightButton;
    m_panFrom.reset();
    m_picking = false;
    if (isClick)
        emit menuRequested(event->globalPosition().toPoint());
}

void TimeChart::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        showAll();
}

void TimeChart::wheelEvent(QWheelEvent* event)
{
    const QPoint angle = event->angleDelta();
    if (angle.x() != 0)
        pan(-kKeyPan * window().length_s() * angle.x() / kNotchAngle);
    if (angle.y() != 0)
        zoom(std::pow(kNotch, -static_cast<double>(angle.y()) / kNotchAngle),
             m_figure.viewToTime(event->position().x()));
    event->accept(); // keeps widgets behind the chart from scrolling
}

void TimeChart::keyPressEvent(QKeyEvent* event)
{
    const TimeWindow now = window();
    const double middle_s = (now.from_s + now.to_s) / 2;
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal: // plus without Shift on many keyboards
        return zoom(1 / kNotch, middle_s);
    case Qt::Key_Minus:
        return zoom(kNotch, middle_s);
    case Qt::Key_Left:
        return pan(-kKeyPan * now.length_s());
    case Qt::Key_Right:
        return pan(kKeyPan * now.length_s());
    case Qt::Key_Home:
        return showAll();
    case Qt::Key_End:
        return setFollowing(true);
    default:
        event->ignore();
    }
}

void TimeChart::contextMenuEvent(QContextMenuEvent* event)
{
    event->accept(); // the right button pans unless it is a click
    if (event->reason() == QContextMenuEvent::Keyboard)
        emit menuRequested(mapToGlobal(rect().center()));
}

bool TimeChart::viewportEvent(QEvent* event)
{
    if (event->type() == QEvent::Leave)
        hoverAt({});
    return QChartView::viewportEvent(event);
}

void TimeChart::focusInEvent(QFocusEvent* event)
{
    QChartView::focusInEvent(event);
    viewport()->update();
}

void TimeChart::focusOutEvent(QFocusEvent* event)
{
    QChartView::focusOutEvent(event);
    viewport()->update();
}

} // namespace berg
