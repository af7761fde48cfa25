// Mouse, touch and key events of the map. `keyPressEvent` handles all keys.

#include "widgets/map/paint/map_overlays.h"
#include "widgets/map/view/map_tips.h"
#include "widgets/map/view/map_view.h"

#include <QContextMenuEvent>
#include <QGestureEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPinchGesture>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kKeyZoom = 1.25;
constexpr double kWheelZoom = 1.2; // per notch of 120 eighths of a degree
constexpr double kNotch = 120;
constexpr double kPixelZoom = 1.003;    // per pixel of a touch pad
constexpr double kLargestWheelZoom = 4; // limit per event for a fast wheel
constexpr double kPan_px = 60;
constexpr double kLargePan_px = 240;
constexpr double kNudge_px = 2; // approximate; rounded in metres
constexpr double kLargeNudge = 10;

double wheelFactor(const QWheelEvent& event)
{
    const double factor = event.pixelDelta().isNull()
                              ? std::pow(kWheelZoom, event.angleDelta().y() / kNotch)
                              : std::pow(kPixelZoom, event.pixelDelta().y());
    return std::clamp(factor, 1 / kLargestWheelZoom, kLargestWheelZoom);
}

bool isModifier(const QKeyEvent& event)
{
    return event.key() == Qt::Key_Shift || event.key() == Qt::Key_Control ||
           event.key() == Qt::Key_Alt || event.key() == Qt::Key_Meta;
}

/** Returns whether the key acts on an unfinished drawing. */
bool isDrawingKey(const QKeyEvent& event)
{
    return event.key() == Qt::Key_Backspace || event.matches(QKeySequence::Undo) || isEnter(event);
}

} // namespace

MapPointer MapView::pointerOf(const QMouseEvent& event) const
{
    return {.at_px = event.position(),
            .at_m = toWorld(event.position()),
            .modifiers = event.modifiers(),
            .isInside = rect().contains(event.position().toPoint())};
}

void MapView::mousePressEvent(QMouseEvent* event)
{
    event->accept();
    m_tools.endNudges();
    m_cursor = event->position();
    updateHover();
    m_pressedPanel = event->button() == Qt::LeftButton && !m_panFrom && !m_tools.tool().isBusy() &&
                     m_panels.press(event->position());
    if (m_pressedPanel)
        return;
    if (event->button() == Qt::MiddleButton) {
        m_panFrom = event->position();
        setCursor(Qt::ClosedHandCursor);
    } else if (event->button() == Qt::RightButton && m_tools.tool().isBusy()) {
        m_tools.tool().cancel();
        m_tools.refresh();
    } else if (event->button() == Qt::RightButton && m_tools.tool().isDrawing()) {
        m_tools.tool().finishDrawing();
        m_tools.refresh();
    } else if (event->button() == Qt::RightButton) {
        requestContextMenu(event->globalPosition().toPoint(), event->position());
    } else if (event->button() == Qt::LeftButton && !m_panFrom) {
        m_tools.tool().press(pointerOf(*event));
        m_tools.refresh();
    }
}

void MapView::mouseMoveEvent(QMouseEvent* event)
{
    event->accept();
    m_cursor = event->position();
    if (!event->buttons().testFlag(Qt::LeftButton))
        m_panels.release(); // another widget got the release
    if (m_panels.isMoving()) {
        m_panels.move(event->position());
    } else if (m_panFrom && event->buttons().testFlag(Qt::MiddleButton)) {
        m_camera.panBy(event->position() - *m_panFrom);
        m_panFrom = event->position();
    } else if (m_tools.tool().isBusy()) {
        // Another widget, such as a dialog that opened, may have got the release.
        if (event->buttons().testFlag(Qt::LeftButton))
            m_tools.tool().move(pointerOf(*event));
        else
            m_tools.tool().cancel();
        m_tools.refresh();
    } else {
        updateHover();
        if (m_tools.tool().hover(pointerOf(*event)))
            m_tools.refresh();
    }
    emit cursorMoved(toWorld(event->position()));
}

void MapView::mouseReleaseEvent(QMouseEvent* event)
{
    event->accept();
    if (event->button() == Qt::MiddleButton)
        m_panFrom.reset();
    else if (event->button() == Qt::LeftButton && m_panels.isMoving())
        m_panels.release();
    else if (event->button() == Qt::LeftButton && m_tools.tool().isBusy())
        m_tools.tool().release(pointerOf(*event));
    updateHover();
    m_tools.refresh();
}

void MapView::mouseDoubleClickEvent(QMouseEvent* event)
{
    event->accept();
    if (event->button() == Qt::LeftButton && m_pressedPanel)
        return; // the first click was on a panel, which may have moved
    if (event->button() == Qt::LeftButton && m_tools.tool().isDrawing()) {
        m_tools.tool().finishDrawing();
        m_tools.refresh();
        return;
    }
    const std::string id = m_scene.objectAt(event->position());
    if (event->button() == Qt::LeftButton && !id.empty())
        emit editRequested(id);
    else
        mousePressEvent(event);
}

void MapView::contextMenuEvent(QContextMenuEvent* event)
{
    event->accept();
    if (event->reason() != QContextMenuEvent::Keyboard)
        return; // the button press already requested the menu
    QPointF at = m_scene.rect().center();
    const std::string id = m_selection.isEmpty() ? std::string() : m_selection.ids().front();
    std::vector<std::string> ids;
    if (const std::optional<LabelDisk> symbol = m_scene.symbolOf(id)) {
        at = symbol->centre_px;
        ids = m_scene.objectsAt(at);
        std::erase(ids, id);
    }
    if (!id.empty())
        ids.insert(ids.begin(), id);
    emit contextMenuRequested(mapToGlobal(at.toPoint()), toWorld(at), ids);
}

void MapView::requestContextMenu(const QPoint& globalPos, const QPointF& at)
{
    const std::vector<std::string> ids = m_scene.objectsAt(at);
    if (!ids.empty() && !m_selection.contains(ids.front()))
        m_selection.set({ids.front()});
    emit contextMenuRequested(globalPos, toWorld(at), ids);
}

void MapView::wheelEvent(QWheelEvent* event)
{
    event->accept();
    m_camera.zoomBy(wheelFactor(*event), event->position());
}

void MapView::leaveEvent(QEvent*)
{
    m_cursor.reset();
    updateHover();
    emit cursorLeft();
}

void MapView::keyPressEvent(QKeyEvent* event)
{
    if (isModifier(*event)) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (m_tools.tool().isDrawing() && isDrawingKey(*event)) {
        if (isEnter(*event))
            m_tools.tool().finishDrawing();
        else
            m_tools.tool().undoLastPoint();
        event->accept();
        m_tools.refresh();
        return;
    }
    const bool isArrow = event->key() == Qt::Key_Left || event->key() == Qt::Key_Right ||
                         event->key() == Qt::Key_Up || event->key() == Qt::Key_Down;
    if (!isArrow)
        m_tools.endNudges();
    const QPointF middle = m_scene.rect().center();
    if (isArrow)
        pressArrow(*event);
    else if (event->matches(QKeySequence::SelectAll))
        m_edits.selectAll();
    else if (event->key() == Qt::Key_Delete)
        m_edits.deleteSelected();
    else if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal)
        m_camera.zoomBy(kKeyZoom, middle);
    else if (event->key() == Qt::Key_Minus)
        m_camera.zoomBy(1 / kKeyZoom, middle);
    else if (event->key() == Qt::Key_F && event->modifiers() == Qt::NoModifier)
        m_camera.fit();
    else if (event->key() == Qt::Key_Escape)
        m_tools.leave();
    else if (!m_tools.tool().key(*event)) {
        QWidget::keyPressEvent(event);
        return;
    }
    event->accept();
    m_tools.refresh();
}

void MapView::pressArrow(const QKeyEvent& event)
{
    const bool isLarge = event.modifiers().testFlag(Qt::ShiftModifier);
    Point direction = Point::Zero(); // east, north
    if (event.key() == Qt::Key_Left)
        direction.x() = -1;
    else if (event.key() == Qt::Key_Right)
        direction.x() = 1;
    else if (event.key() == Qt::Key_Up)
        direction.y() = 1;
    else
        direction.y() = -1;
    if (m_selection.isEmpty() || m_tools.tool().isDrawing() || isLocked()) {
        // The view moves in the direction of the arrow, so the map moves against it.
        const double pan_px = isLarge ? kLargePan_px : kPan_px;
        m_camera.panBy(QPointF(-direction.x(), direction.y()) * pan_px);
        return;
    }
    const double step_m = roundDown125(kNudge_px / view().scale_pxpm());
    direction *= isLarge ? kLargeNudge * step_m : step_m;
    m_edits.nudge(direction.x(), direction.y());
}

bool MapView::event(QEvent* event)
{
    if (event->type() == QEvent::NativeGesture)
        return nativeGesture(*static_cast<QNativeGestureEvent*>(event)) || QWidget::event(event);
    if (event->type() == QEvent::Gesture)
        return gesture(*static_cast<QGestureEvent*>(event)) || QWidget::event(event);
    if (event->type() == QEvent::ToolTip) {
        const auto& help = *static_cast<QHelpEvent*>(event);
        QToolTip::showText(help.globalPos(),
                           m_tools.tool().isBusy() ? QString() : mapToolTip(m_scene, help.pos()),
                           this);
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if ((m_tools.tool().isBusy() && key.key() == Qt::Key_Escape) ||
            (m_tools.tool().isDrawing() && isDrawingKey(key))) {
            event->accept(); // the tool's action has priority over shortcuts
            return true;
        }
    }
    return QWidget::event(event);
}

bool MapView::nativeGesture(const QNativeGestureEvent& event)
{
    if (event.gestureType() != Qt::ZoomNativeGesture)
        return false;
    m_camera.zoomBy(std::max(0.1, 1 + event.value()), event.position());
    return true;
}

bool MapView::gesture(QGestureEvent& event)
{
    const auto* pinch = qobject_cast<QPinchGesture*>(event.gesture(Qt::PinchGesture));
    if (pinch == nullptr)
        return false;
    m_tools.tool().cancel(); // the first finger looked like a press
    const QPointF centre = mapFromGlobal(pinch->centerPoint());
    if (pinch->changeFlags().testFlag(QPinchGesture::CenterPointChanged) &&
        pinch->state() != Qt::GestureStarted)
        m_camera.panBy(centre - mapFromGlobal(pinch->lastCenterPoint()));
    if (pinch->changeFlags().testFlag(QPinchGesture::ScaleFactorChanged))
        m_camera.zoomBy(pinch->scaleFactor(), centre);
    event.accept();
    return true;
}

void MapView::focusInEvent(QFocusEvent* event)
{
    m_hasKeyboardFocus = event->reason() == Qt::TabFocusReason ||
                         event->reason() == Qt::BacktabFocusReason ||
                         event->reason() == Qt::ShortcutFocusReason;
    update();
}

void MapView::focusOutEvent(QFocusEvent*)
{
    m_tools.endNudges();
    m_hasKeyboardFocus = false;
    update();
}

std::optional<Point> MapView::cursor_m() const
{
    return m_cursor ? std::optional<Point>(toWorld(*m_cursor)) : std::nullopt;
}

} // namespace berg
