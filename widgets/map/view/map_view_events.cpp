// Mouse, touch and key events of the map. `keyPressEvent` handles all keys.

#include "widgets/flight/asset_approach.h"
#include "widgets/map/paint/map_overlays.h"
#include "widgets/map/paint/wind_panel.h"
#include "widgets/map/picture/scenario_picture.h"
#include "widgets/map/view/map_view.h"
#include "widgets/theme/quantity_text.h"

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
#include <utility>

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

bool MapView::pressPanel(const QPointF& at)
{
    const std::optional<MapPanelPart> part = m_scene.panelPartAt(at);
    if (!part || m_tool->isBusy())
        return false;
    if (part->isGrip) {
        m_movedPanel = part->panel;
        m_panelFrom = at - m_scene.panelOffset_px(part->panel);
        return true;
    }
    foldPanel(part->panel);
    return true;
}

void MapView::foldPanel(MapPanel panel)
{
    const bool isIcon = isFolded(panel);
    MapPanelStates states = m_scene.panels();
    MapPanelState& state = states[static_cast<std::size_t>(panel)];
    state.isFolded = !isIcon;
    state.isOpened = isIcon;
    setPanels(states);
    emit panelsChanged();
}

void MapView::movePanel(const QPointF& at)
{
    m_scene.movePanel(*m_movedPanel, at - m_panelFrom);
    placeInset();
    update();
}

void MapView::releasePanel()
{
    if (std::exchange(m_movedPanel, std::nullopt))
        emit panelsChanged();
}

void MapView::mousePressEvent(QMouseEvent* event)
{
    event->accept();
    endNudges();
    m_cursor = event->position();
    updateHover();
    m_pressedPanel =
        event->button() == Qt::LeftButton && !m_panFrom && pressPanel(event->position());
    if (m_pressedPanel)
        return;
    if (event->button() == Qt::MiddleButton) {
        m_panFrom = event->position();
        setCursor(Qt::ClosedHandCursor);
    } else if (event->button() == Qt::RightButton && m_tool->isBusy()) {
        m_tool->cancel();
        updateToolState();
    } else if (event->button() == Qt::RightButton && m_tool->isDrawing()) {
        m_tool->finishDrawing();
        updateToolState();
    } else if (event->button() == Qt::RightButton) {
        requestContextMenu(event->globalPosition().toPoint(), event->position());
    } else if (event->button() == Qt::LeftButton && !m_panFrom) {
        m_tool->press(pointerOf(*event));
        updateToolState();
    }
}

void MapView::mouseMoveEvent(QMouseEvent* event)
{
    event->accept();
    m_cursor = event->position();
    if (!event->buttons().testFlag(Qt::LeftButton))
        releasePanel(); // another widget got the release
    if (m_movedPanel) {
        movePanel(event->position());
    } else if (m_panFrom && event->buttons().testFlag(Qt::MiddleButton)) {
        m_camera.panBy(event->position() - *m_panFrom);
        m_panFrom = event->position();
    } else if (m_tool->isBusy()) {
        // Another widget, such as a dialog that opened, may have got the release.
        if (event->buttons().testFlag(Qt::LeftButton))
            m_tool->move(pointerOf(*event));
        else
            m_tool->cancel();
        updateToolState();
    } else {
        updateHover();
        if (m_tool->hover(pointerOf(*event)))
            updateToolState();
    }
    emit cursorMoved(toWorld(event->position()));
}

void MapView::mouseReleaseEvent(QMouseEvent* event)
{
    event->accept();
    if (event->button() == Qt::MiddleButton)
        m_panFrom.reset();
    else if (event->button() == Qt::LeftButton && m_movedPanel)
        releasePanel();
    else if (event->button() == Qt::LeftButton && m_tool->isBusy())
        m_tool->release(pointerOf(*event));
    updateHover();
    updateToolState();
}

void MapView::mouseDoubleClickEvent(QMouseEvent* event)
{
    event->accept();
    if (event->button() == Qt::LeftButton && m_pressedPanel)
        return; // the first click was on a panel, which may have moved
    if (event->button() == Qt::LeftButton && m_tool->isDrawing()) {
        m_tool->finishDrawing();
        updateToolState();
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
    if (m_tool->isDrawing() && isDrawingKey(*event)) {
        if (isEnter(*event))
            m_tool->finishDrawing();
        else
            m_tool->undoLastPoint();
        event->accept();
        updateToolState();
        return;
    }
    const bool isArrow = event->key() == Qt::Key_Left || event->key() == Qt::Key_Right ||
                         event->key() == Qt::Key_Up || event->key() == Qt::Key_Down;
    if (!isArrow)
        endNudges();
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
    else if (event->key() == Qt::Key_Escape && m_tool->isBusy())
        m_tool->cancel();
    else if (event->key() == Qt::Key_Escape)
        leave();
    else if (!m_tool->key(*event)) {
        QWidget::keyPressEvent(event);
        return;
    }
    event->accept();
    updateToolState();
}

/** Handles Esc one step at a time: cancels the drawing, leaves the tool, clears the selection. */
void MapView::leave()
{
    if (m_tool->cancelDrawing())
        return;
    if (m_toolKind != MapToolKind::Select)
        setTool(MapToolKind::Select);
    else
        m_selection.clear();
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
    if (m_selection.isEmpty() || m_tool->isDrawing() || isLocked()) {
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
    if (event->type() == QEvent::ToolTip)
        return showToolTip(*static_cast<QHelpEvent*>(event));
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if ((m_tool->isBusy() && key.key() == Qt::Key_Escape) ||
            (m_tool->isDrawing() && isDrawingKey(key))) {
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
    m_tool->cancel(); // the first finger looked like a press
    const QPointF centre = mapFromGlobal(pinch->centerPoint());
    if (pinch->changeFlags().testFlag(QPinchGesture::CenterPointChanged) &&
        pinch->state() != Qt::GestureStarted)
        m_camera.panBy(centre - mapFromGlobal(pinch->lastCenterPoint()));
    if (pinch->changeFlags().testFlag(QPinchGesture::ScaleFactorChanged))
        m_camera.zoomBy(pinch->scaleFactor(), centre);
    event.accept();
    return true;
}

bool MapView::showToolTip(const QHelpEvent& event)
{
    if (!m_tool->isBusy() && m_scene.layout().wind.contains(event.pos())) {
        QToolTip::showText(event.globalPos(), windToolTip(m_scene.picture().air, m_scene.locale()),
                           this);
        return true;
    }
    const TimesAhead& times = m_scene.picture().times;
    if (!m_tool->isBusy() && times.clock.start && m_scene.layout().title.contains(event.pos())) {
        QToolTip::showText(event.globalPos(), times.clock.details(times.now_s), this);
        return true;
    }
    const std::string id = m_tool->isBusy() ? std::string() : m_scene.objectAt(event.pos());
    const std::vector<MapIceberg>& icebergs = m_scene.picture().icebergs;
    const auto iceberg = std::ranges::find(icebergs, id, keyOf);
    if (iceberg == icebergs.end()) {
        QToolTip::hideText();
        return true;
    }
    const QLocale& words = m_scene.locale();
    const double speed_mps = iceberg->velocity_mps.norm();
    const QString drift =
        speed_mps > 0 ? tr("drifting %1 towards %2")
                            .arg(speedText(speed_mps, words), bearingText(iceberg->velocity_mps))
                      : tr("not drifting");
    QString text = tr("%1: %2, %3", "name, uncertainty, drift")
                       .arg(iceberg->id, uncertaintyText(iceberg->sigma_m2, words), drift);
    if (iceberg->ringEntry_s)
        text += u'\n' + ringEntryText(iceberg->id, *iceberg->ringEntry_s, words, times);
    QToolTip::showText(event.globalPos(), text, this);
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
    endNudges();
    m_hasKeyboardFocus = false;
    update();
}

void MapView::cancelGesture()
{
    m_tool->cancel();
    updateToolState();
}

bool MapView::isDrawing() const
{
    return m_tool->isDrawing();
}

void MapView::undoLastPoint()
{
    m_tool->undoLastPoint();
    updateToolState();
}

std::optional<Point> MapView::cursor_m() const
{
    return m_cursor ? std::optional<Point>(toWorld(*m_cursor)) : std::nullopt;
}

bool MapView::removePart()
{
    if (!m_tool->removePart())
        return false;
    updateToolState();
    return true;
}

} // namespace berg
