#include "widgets/map/view/select_tool.h"

#include "widgets/document/scenario_edits.h"
#include "widgets/map/paint/map_marks.h"
#include "widgets/map/view/drift_arrow.h"
#include "widgets/map/view/map_view.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/intervention_text.h"

#include <QCoreApplication>
#include <QKeyEvent>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct SelectToolText
{
    Q_DECLARE_TR_FUNCTIONS(SelectTool)
};

bool addsToSelection(Qt::KeyboardModifiers modifiers)
{
    return modifiers.testFlag(Qt::ControlModifier) || modifiers.testFlag(Qt::ShiftModifier);
}

std::optional<Point> positionOf(const Scenario& scenario, const std::string& id)
{
    if (const Iceberg* iceberg = findById(scenario.icebergs, id))
        return iceberg->position_m;
    if (const Uav* uav = findById(scenario.uavs, id))
        return uav->position_m;
    if (id == kAssetKey && scenario.asset)
        return scenario.asset->position_m;
    if (const std::vector<Point>* outline_m = outlineIn(scenario, id))
        return outline_m->front();
    return std::nullopt;
}

} // namespace

void SelectTool::press(const MapPointer& pointer)
{
    m_press = pointer;
    m_now = pointer;
    m_object = context().scene.objectAt(pointer.at_px);
    m_before = context().selection.ids();
    m_handle = handleAt(handles(), pointer.at_px);
    m_corner.reset();
    if (m_handle)
        m_phase = Phase::Handle;
    else if (m_object.empty())
        m_phase = Phase::Water;
    else
        pressObject(pointer);
}

void SelectTool::pressObject(const MapPointer& pointer)
{
    m_phase = Phase::Object;
    Selection& selection = context().selection;
    m_wasSelected = selection.contains(m_object);
    if (m_wasSelected)
        return;
    if (addsToSelection(pointer.modifiers))
        selection.toggle(m_object);
    else
        selection.set({m_object});
}

void SelectTool::move(const MapPointer& pointer)
{
    m_now = pointer;
    if ((m_phase == Phase::Object || m_phase == Phase::Water || m_phase == Phase::Handle) &&
        isDragDistance(m_press.at_px, pointer.at_px))
        beginDrag();
    if (m_phase == Phase::Moving)
        moveSelection(pointer);
    else if (m_phase == Phase::Dragging)
        m_drag->move(pointer);
    else if (m_phase == Phase::Banding)
        stretchBand(pointer);
}

void SelectTool::beginDrag()
{
    if (m_phase == Phase::Water) {
        m_phase = Phase::Banding;
    } else if (m_phase == Phase::Handle) {
        m_phase = Phase::Dragging;
        m_drag = makeHandleDrag(context(), *m_handle);
    } else if (context().view.isLocked()) {
        beginInFlight();
    } else {
        m_phase = Phase::Moving;
        m_moved = context().selection.ids();
        m_gesture = makeGesture(context(), moveText(context().document.scenario(), m_moved));
    }
}

/** Starts a drag in flight, where only the asset can be moved. */
void SelectTool::beginInFlight()
{
    if (m_object != kAssetKey || !context().view.mayIntervene()) {
        m_phase = Phase::Refused;
        return;
    }
    m_phase = Phase::Dragging;
    m_drag = makeHandleDrag(context(),
                            {.kind = HandleKind::Asset, .id = kAssetKey, .at_px = m_press.at_px});
}

void SelectTool::moveSelection(const MapPointer& pointer)
{
    const Point path_m = roundedTo(pointer.at_m - m_press.at_m, kPositionStep_m);
    m_gesture->apply([&](Scenario& scenario) { moveObjects(scenario, m_moved, path_m); });
}

void SelectTool::stretchBand(const MapPointer& pointer)
{
    const QRectF band = QRectF(m_press.at_px, pointer.at_px).normalized();
    std::vector<std::string> ids;
    if (addsToSelection(m_press.modifiers))
        ids = m_before;
    for (const std::string& id : context().scene.objectsIn(band))
        ids.push_back(id);
    context().selection.set(std::move(ids));
}

void SelectTool::release(const MapPointer& pointer)
{
    move(pointer);
    Selection& selection = context().selection;
    const bool adds = addsToSelection(m_press.modifiers);
    switch (m_phase) {
    case Phase::Object:
        clickObject(adds);
        break;
    case Phase::Handle:
        clickHandle(pointer);
        break;
    case Phase::Dragging:
        m_drag->end(pointer.isInside);
        break;
    case Phase::Water:
        if (!adds)
            selection.clear();
        break;
    case Phase::Moving:
        if (pointer.isInside)
            m_gesture->finish();
        else
            m_gesture->cancel();
        break;
    case Phase::Idle:
    case Phase::Banding:
    case Phase::Refused:
        break;
    }
    drop();
}

void SelectTool::clickObject(bool adds)
{
    Selection& selection = context().selection;
    if (adds && m_wasSelected)
        selection.toggle(m_object);
    else if (!adds)
        selection.set({m_object});
}

/** A click without drag selects a corner, or the object under the handle. */
void SelectTool::clickHandle(const MapPointer& pointer)
{
    if (m_handle->kind == HandleKind::Corner) {
        m_corner = m_handle;
    } else if (!m_object.empty()) {
        pressObject(pointer);
        clickObject(addsToSelection(pointer.modifiers));
    }
}

bool SelectTool::hover(const MapPointer& pointer)
{
    const std::optional<MapHandle> before = m_handle;
    m_handle = handleAt(handles(), pointer.at_px);
    return before && m_handle ? !before->isSame(*m_handle) : before || m_handle;
}

bool SelectTool::removePart()
{
    if (m_corner && !context().selection.contains(m_corner->id))
        m_corner.reset();
    if (!m_corner)
        return false;
    removeCorner(context(), *m_corner);
    m_corner.reset();
    return true;
}

std::vector<MapHandle> SelectTool::handles() const
{
    const MapView& view = context().view;
    std::vector<MapHandle> handles;
    if (!view.isLocked())
        handles = handlesOf(context().scene, context().selection);
    if (!view.isLocked() || view.mayIntervene())
        if (const std::optional<MapHandle> wind = windHandle(context().scene))
            handles.push_back(*wind);
    return handles;
}

bool SelectTool::key(const QKeyEvent& event)
{
    if (event.key() != Qt::Key_Return && event.key() != Qt::Key_Enter)
        return false;
    if (context().selection.ids().size() != 1)
        return false;
    emit context().view.editRequested(context().selection.ids().front());
    return true;
}

void SelectTool::cancel()
{
    if (m_phase == Phase::Moving)
        m_gesture->cancel();
    else if (m_phase == Phase::Dragging)
        m_drag->end(false);
    else if (m_phase == Phase::Banding)
        context().selection.set(m_before);
    drop();
}

bool SelectTool::isApplying() const
{
    return (m_gesture && m_gesture->isApplying()) || (m_drag && m_drag->isApplying());
}

void SelectTool::checkPart()
{
    if (m_corner && !hasCorner(context(), *m_corner))
        m_corner.reset();
}

void SelectTool::drop()
{
    context().view.setDraft(nullptr);
    m_phase = Phase::Idle;
    m_gesture.reset();
    m_drag.reset();
    m_handle.reset();
    m_object.clear();
    m_before.clear();
}

void SelectTool::paint(QPainter& painter) const
{
    const Theme& theme = context().scene.theme();
    if (m_phase == Phase::Banding)
        paintRubberBand(painter, QRectF(m_press.at_px, m_now.at_px).normalized(), theme);
    if (m_phase == Phase::Idle || m_phase == Phase::Handle || m_phase == Phase::Dragging)
        // A dragged handle is hollow, so that the tip of its arrow is visible.
        paintHandles(painter, handles(),
                     {.hovered = m_drag ? std::nullopt : m_handle, .corner = m_corner}, theme);
    if (m_phase == Phase::Dragging && !m_drag->text().isEmpty())
        paintBubble(painter, m_now.at_px, m_drag->text(), context().scene.rect(), theme);
    if (m_phase != Phase::Moving)
        return;
    const MapViewTransform& view = context().scene.view();
    const std::optional<Point> from_m = positionOf(m_gesture->start(), m_object);
    const std::optional<Point> to_m = positionOf(m_gesture->now(), m_object);
    if (!from_m || !to_m)
        return;
    const Point path_m = *to_m - *from_m;
    paintDragTrail(painter, {view.toPixel(*from_m), view.toPixel(*to_m)}, theme);
    paintBubble(painter, m_now.at_px, pathText(path_m, context().scene.locale()),
                context().scene.rect(), theme);
}

QCursor SelectTool::cursor(const std::string& over) const
{
    switch (m_phase) {
    case Phase::Moving:
        return Qt::ClosedHandCursor;
    case Phase::Refused:
        return Qt::ForbiddenCursor;
    case Phase::Banding:
        return Qt::CrossCursor;
    case Phase::Handle:
    case Phase::Dragging:
        return Qt::SizeAllCursor;
    case Phase::Idle:
    case Phase::Object:
    case Phase::Water:
        break;
    }
    if (m_handle)
        return Qt::SizeAllCursor;
    return over.empty() ? Qt::ArrowCursor : Qt::PointingHandCursor;
}

QString SelectTool::status() const
{
    if (m_phase == Phase::Moving)
        return SelectToolText::tr("Release to place it here. Esc cancels.");
    if (m_phase == Phase::Refused)
        return lockedInFlightText();
    if (m_drag)
        return m_drag->status();
    if (m_handle)
        return handleText(context(), *m_handle);
    if (m_phase == Phase::Banding)
        return SelectToolText::tr("Everything inside the frame is selected.");
    if (context().view.isLocked() && context().view.mayIntervene())
        return SelectToolText::tr(
            "Click to select. In flight you can drag the tip of the wind arrow and the asset.");
    if (context().view.isLocked())
        return SelectToolText::tr("Click to select. Choose Stop and edit to change the scenario.");
    return SelectToolText::tr(
        "Click to select, drag to move. Ctrl+click adds; drag on open water to select a box.");
}

} // namespace berg
