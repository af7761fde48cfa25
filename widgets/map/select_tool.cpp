#include "widgets/map/select_tool.h"

#include "widgets/map/map_marks.h"
#include "widgets/map/map_view.h"
#include "widgets/model/scenario_edits.h"
#include "widgets/theme/quantity_text.h"

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

/** Ways are rounded to this: far below what a screen shows. */
constexpr double kRounding_m = 0.1;

bool addsToSelection(Qt::KeyboardModifiers modifiers)
{
    return modifiers.testFlag(Qt::ControlModifier) || modifiers.testFlag(Qt::ShiftModifier);
}

Point roundedWay(const Point& way_m)
{
    return (way_m / kRounding_m).array().round().matrix() * kRounding_m;
}

std::optional<Point> positionOf(const Scenario& scenario, const std::string& id)
{
    if (const Iceberg* iceberg = findIceberg(scenario, id))
        return iceberg->position_m;
    if (const Uav* uav = findUav(scenario, id))
        return uav->position_m;
    return std::nullopt;
}

} // namespace

void SelectTool::press(const MapPointer& pointer)
{
    m_press = pointer;
    m_now = pointer;
    m_object = context().scene.objectAt(pointer.at_px);
    m_before = context().selection.ids();
    if (m_object.empty())
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
    if ((m_phase == Phase::Object || m_phase == Phase::Water) &&
        isDragDistance(m_press.at_px, pointer.at_px))
        beginDrag();
    if (m_phase == Phase::Moving)
        moveSelection(pointer);
    else if (m_phase == Phase::Banding)
        stretchBand(pointer);
}

void SelectTool::beginDrag()
{
    if (m_phase == Phase::Water) {
        m_phase = Phase::Banding;
    } else if (context().view.isLocked()) {
        m_phase = Phase::Refused;
    } else {
        m_phase = Phase::Moving;
        m_moved = context().selection.ids();
        m_gesture = newGesture(moveText(context().document.scenario(), m_moved));
    }
}

void SelectTool::moveSelection(const MapPointer& pointer)
{
    const Point way_m = roundedWay(pointer.at_m - m_press.at_m);
    m_gesture->apply([&](Scenario& scenario) { moveObjects(scenario, m_moved, way_m); });
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
        if (adds && m_wasSelected)
            selection.toggle(m_object);
        else if (!adds)
            selection.set({m_object});
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
    end();
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
    else if (m_phase == Phase::Banding)
        context().selection.set(m_before);
    end();
}

void SelectTool::documentChanged()
{
    if (m_phase == Phase::Moving && !m_gesture->isApplying())
        end();
}

void SelectTool::end()
{
    m_phase = Phase::Idle;
    m_gesture.reset();
    m_object.clear();
    m_before.clear();
}

void SelectTool::paint(QPainter& painter) const
{
    const Theme& theme = context().scene.theme();
    if (m_phase == Phase::Banding)
        paintRubberBand(painter, QRectF(m_press.at_px, m_now.at_px).normalized(), theme);
    if (m_phase != Phase::Moving)
        return;
    const MapViewTransform& view = context().scene.view();
    const std::optional<Point> from_m = positionOf(m_gesture->start(), m_object);
    const std::optional<Point> to_m = positionOf(m_gesture->now(), m_object);
    if (!from_m || !to_m)
        return;
    const Point way_m = *to_m - *from_m;
    paintDragTrail(painter, {view.toPixel(*from_m), view.toPixel(*to_m)}, theme);
    const QString text =
        u"%1  %2"_s.arg(distanceText(way_m.norm(), context().scene.locale()), bearingText(way_m));
    paintBubble(painter, m_now.at_px, text, context().scene.rect(), theme);
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
    case Phase::Idle:
    case Phase::Object:
    case Phase::Water:
        break;
    }
    return over.empty() ? Qt::ArrowCursor : Qt::PointingHandCursor;
}

QString SelectTool::status() const
{
    if (m_phase == Phase::Moving)
        return SelectToolText::tr("Let go to place it here. Esc takes the move back.");
    if (m_phase == Phase::Refused)
        return SelectToolText::tr(
            "Locked while a flight is under way. Stop the flight to change the scenario.");
    if (m_phase == Phase::Banding)
        return SelectToolText::tr("Everything inside the frame is selected.");
    if (context().view.isLocked())
        return SelectToolText::tr("Click selects. The scenario is locked while flying.");
    return SelectToolText::tr(
        "Click selects, drag moves. Ctrl adds, a drag on water selects what is "
        "inside the frame.");
}

} // namespace berg
