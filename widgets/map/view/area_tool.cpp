#include "widgets/map/view/area_tool.h"

#include "core/checks/validate.h"
#include "widgets/document/selection.h"
#include "widgets/map/paint/map_marks.h"
#include "widgets/map/view/drift_arrow.h"
#include "widgets/map/view/map_view.h"
#include "widgets/theme/painter_state.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/issue_text.h"

#include <QCoreApplication>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct AreaToolText
{
    Q_DECLARE_TR_FUNCTIONS(AreaTool)
};

constexpr double kCloseReach_px = 11;
constexpr double kSameCorner_px = 3; // covers both clicks of a double click
constexpr double kCorner_px = 3.5;   // radius
constexpr double kFirstCorner_px = 6;
constexpr std::size_t kFewestCorners = 3;

} // namespace

void AreaTool::press(const MapPointer& pointer)
{
    m_isPressed = true;
    m_press = m_now = pointer;
    m_fault = Fault::None;
    m_corner.reset();
    m_handle = isDrawing() ? std::nullopt : handleAt(handles(), pointer.at_px);
}

void AreaTool::move(const MapPointer& pointer)
{
    m_now = pointer;
    if (m_handle && !m_drag && isDragDistance(m_press.at_px, pointer.at_px)) {
        context().selection.set({m_handle->id});
        m_drag = makeHandleDrag(context(), *m_handle);
    }
    if (m_drag)
        m_drag->move(pointer);
}

void AreaTool::release(const MapPointer& pointer)
{
    if (!m_isPressed)
        return;
    move(pointer);
    if (m_drag) {
        m_drag->end(pointer.isInside);
    } else if (m_handle) {
        if (m_handle->kind == HandleKind::Corner)
            m_corner = m_handle;
        context().selection.set({m_handle->id});
    } else if (pointer.isInside && !context().scene.isOverlay(pointer.at_px)) {
        click(pointer);
    }
    drop();
}

void AreaTool::click(const MapPointer& pointer)
{
    const std::string object = context().scene.objectAt(pointer.at_px);
    if (!isDrawing() && isOwn(object))
        context().selection.set({object});
    else if (closesAt(pointer.at_px))
        finishDrawing();
    else
        addCorner(pointer);
}

bool AreaTool::isOwn(const std::string& key) const
{
    return m_isNoFly ? noFlyPlace(key).has_value() : key == kAreaKey;
}

std::vector<MapHandle> AreaTool::handles() const
{
    if (!m_isNoFly)
        return areaHandles(context().scene, kAreaKey);
    std::vector<MapHandle> all;
    for (std::size_t i = 0; i < context().document.scenario().noFly.size(); ++i)
        for (MapHandle& handle : areaHandles(context().scene, noFlyKey(i)))
            all.push_back(std::move(handle));
    return all;
}

void AreaTool::addCorner(const MapPointer& pointer)
{
    const Point corner_m = placeOf(pointer);
    if (isDrawing()) {
        const QPointF last = context().scene.view().toPixel(m_corners_m.back());
        if (QLineF(last, pointer.at_px).length() < kSameCorner_px)
            return;
        if (!isClearEdge(m_corners_m, corner_m)) {
            m_fault = Fault::Crossing;
            return;
        }
    }
    if (m_corners_m.size() >= kMostAreaCorners ||
        (m_isNoFly && !isDrawing() &&
         context().document.scenario().noFly.size() >= kMostNoFlyAreas))
        m_fault = Fault::TooMany;
    else
        m_corners_m.push_back(corner_m);
}

bool AreaTool::hover(const MapPointer& pointer)
{
    const std::optional<MapHandle> before = m_handle;
    const bool wasFaulty = m_fault != Fault::None;
    m_now = pointer;
    m_isHovering = true;
    m_fault = Fault::None;
    if (!isDrawing()) {
        m_handle = handleAt(handles(), pointer.at_px);
        const bool isSame = before && m_handle ? before->isSame(*m_handle) : !before && !m_handle;
        return wasFaulty || !isSame;
    }
    m_handle.reset();
    if (!closesAt(pointer.at_px) && !isClearEdge(m_corners_m, placeOf(pointer)) &&
        QLineF(context().scene.view().toPixel(m_corners_m.back()), pointer.at_px).length() >
            kSameCorner_px)
        m_fault = Fault::Crossing;
    return true;
}

bool AreaTool::closesAt(const QPointF& at_px) const
{
    if (m_corners_m.size() < kFewestCorners)
        return false;
    const QPointF first = context().scene.view().toPixel(m_corners_m.front());
    return QLineF(first, at_px).length() <= kCloseReach_px;
}

void AreaTool::finishDrawing()
{
    if (m_corners_m.size() < kFewestCorners) {
        m_fault = Fault::TooFew;
        return;
    }
    if (!isSimplePolygon(m_corners_m)) {
        m_fault = Fault::Crossing;
        return;
    }
    const std::vector<Point> area_m = std::move(m_corners_m);
    m_corners_m.clear();
    ScenarioDocument& document = context().document;
    if (m_isNoFly) {
        document.edit(AreaToolText::tr("Add no-fly area"),
                      [&](Scenario& scenario) { scenario.noFly.push_back({.corners_m = area_m}); });
        context().selection.set({noFlyKey(document.scenario().noFly.size() - 1)});
        return;
    }
    document.edit(document.scenario().area_m.empty() ? AreaToolText::tr("Add area")
                                                     : AreaToolText::tr("Replace area"),
                  [&](Scenario& scenario) { scenario.area_m = area_m; });
    context().selection.set({kAreaKey});
}

void AreaTool::undoLastPoint()
{
    m_fault = Fault::None;
    if (isDrawing())
        m_corners_m.pop_back();
}

bool AreaTool::cancelDrawing()
{
    const bool wasDrawing = isDrawing();
    m_fault = Fault::None;
    m_corners_m.clear();
    m_corner.reset();
    return wasDrawing;
}

bool AreaTool::removePart()
{
    if (isDrawing()) {
        undoLastPoint();
        return true;
    }
    if (!m_corner)
        return false;
    removeCorner(context(), *m_corner);
    m_corner.reset();
    return true;
}

void AreaTool::cancel()
{
    if (m_drag)
        m_drag->end(false);
    drop();
}

void AreaTool::checkPart()
{
    if (m_corner && !hasCorner(context(), *m_corner))
        m_corner.reset();
}

void AreaTool::drop()
{
    m_isPressed = false;
    m_handle.reset();
    m_drag.reset();
}

void AreaTool::paintNextEdge(QPainter& painter, const QPolygonF& outline) const
{
    const Theme& theme = context().scene.theme();
    const bool isCrossing = m_fault == Fault::Crossing;
    painter.setPen(QPen(isCrossing ? theme.comparison : theme.plan, 1.8, Qt::DashLine));
    painter.drawLine(outline.back(), m_now.at_px);
    if (!isCrossing)
        return;
    for (const QPointF& arm :
         {QPointF(6, 6), QPointF(6, -6)}) // a cross, so that shape shows the error, too
        painter.drawLine(QLineF(m_now.at_px - arm, m_now.at_px + arm));
}

void AreaTool::paintDrawing(QPainter& painter) const
{
    const PainterState saved(painter);
    const Theme& theme = context().scene.theme();
    const QPolygonF outline = context().scene.view().toPixels(m_corners_m);
    QColor fill = theme.plan;
    fill.setAlphaF(0.10F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    QPolygonF covered = outline;
    if (m_isHovering && m_fault == Fault::None)
        covered << m_now.at_px;
    painter.drawPolygon(covered);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.plan, 2));
    painter.drawPolyline(outline);
    const bool closes = m_isHovering && closesAt(m_now.at_px);
    if (m_isHovering)
        paintNextEdge(painter, outline);
    painter.setPen(QPen(theme.plan, 1.8));
    for (qsizetype i = 0; i < outline.size(); ++i) {
        const bool isGoal = i == 0 && m_corners_m.size() >= kFewestCorners;
        painter.setBrush(isGoal && closes ? theme.plan : theme.panel);
        const double radius_px = isGoal ? kFirstCorner_px : kCorner_px;
        painter.drawEllipse(outline[i], radius_px, radius_px);
    }
}

void AreaTool::paint(QPainter& painter) const
{
    MapScene& scene = context().scene;
    if (m_drag)
        paintBubble(painter, m_now.at_px, m_drag->text(), scene.rect(), scene.theme());
    if (!isDrawing()) {
        paintHandles(painter, handles(), {.hovered = m_handle, .corner = m_corner}, scene.theme());
        return;
    }
    paintDrawing(painter);
    const QPointF last = scene.view().toPixel(m_corners_m.back());
    const bool hasEdge = QLineF(last, m_now.at_px).length() >= kSameCorner_px;
    if (m_isHovering && (hasEdge || m_fault != Fault::None) && !closesAt(m_now.at_px))
        paintBubble(painter, m_now.at_px,
                    m_fault == Fault::None
                        ? pathText(m_now.at_m - m_corners_m.back(), scene.locale())
                        : faultText(),
                    scene.rect(), scene.theme());
}

QCursor AreaTool::cursor(const std::string& over) const
{
    if (m_drag || m_handle)
        return Qt::SizeAllCursor;
    if (isDrawing() && closesAt(m_now.at_px))
        return Qt::PointingHandCursor;
    return !isDrawing() && isOwn(over) ? Qt::PointingHandCursor : Qt::CrossCursor;
}

QString AreaTool::faultText() const
{
    switch (m_fault) {
    case Fault::None:
        return {};
    case Fault::Crossing:
        return crossingText();
    case Fault::TooFew:
        return AreaToolText::tr("An area needs at least three corners. Esc cancels the drawing.");
    case Fault::TooMany:
        if (m_isNoFly && !isDrawing())
            return issueSentence(IssueId::NoFlyCount,
                                 {countOf(kMostNoFlyAreas), countOf(kMostNoFlyAreas + 1)});
        return issueSentence(IssueId::AreaCorners,
                             {countOf(kMostAreaCorners), countOf(kMostAreaCorners + 1)});
    }
    return {};
}

QString AreaTool::status() const
{
    if (m_drag)
        return m_drag->status();
    if (m_fault != Fault::None)
        return faultText();
    if (m_corners_m.size() >= kFewestCorners)
        return AreaToolText::tr("Click the first corner or press Enter to close the area. "
                                "Backspace removes a corner, Esc cancels.");
    if (isDrawing())
        return AreaToolText::tr(
            "Click to set the next corner. Backspace removes a corner, Esc cancels.");
    if (m_handle)
        return handleText(context(), *m_handle);
    if (m_isNoFly)
        return AreaToolText::tr(
            "Click to set the first corner of a no-fly area, or drag a corner "
            "or the middle of an edge of an existing one. Esc leaves the tool.");
    if (!context().document.scenario().area_m.empty())
        return AreaToolText::tr(
            "Drag a corner or the middle of an edge; clicking starts a new area. Esc leaves the "
            "tool.");
    return AreaToolText::tr("Click to set the first corner of the area. Esc leaves the tool.");
}

} // namespace berg
