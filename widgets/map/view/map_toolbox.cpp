#include "widgets/map/view/map_toolbox.h"

#include "widgets/map/view/map_view.h"

namespace berg {

MapToolbox::MapToolbox(const MapToolContext& context)
    : m_context(context), m_tool(makeMapTool(m_kind, context))
{
}

void MapToolbox::setKind(MapToolKind kind)
{
    if (kind == m_kind || (m_context.view.isLocked() && isLockedInFlight(kind)))
        return;
    m_tool->cancel();
    endNudges();
    m_tool = makeMapTool(kind, m_context);
    m_kind = kind;
    refresh();
    emit kindChanged(kind);
}

void MapToolbox::cancel()
{
    m_tool->cancel();
    refresh();
}

void MapToolbox::leave()
{
    if (m_tool->isBusy())
        m_tool->cancel();
    else if (m_tool->cancelDrawing())
        return;
    else if (m_kind != MapToolKind::Select)
        setKind(MapToolKind::Select);
    else
        m_context.selection.clear();
}

void MapToolbox::undoLastPoint()
{
    m_tool->undoLastPoint();
    refresh();
}

bool MapToolbox::removePart()
{
    if (!m_tool->removePart())
        return false;
    refresh();
    return true;
}

void MapToolbox::measureFrom(const Point& from_m)
{
    setKind(MapToolKind::Measure);
    m_tool->cancelDrawing();
    const MapPointer pointer{
        .at_px = m_context.scene.view().toPixel(from_m), .at_m = from_m, .isInside = true};
    m_tool->press(pointer);
    m_tool->release(pointer);
    refresh();
}

void MapToolbox::endNudges()
{
    // A tool's gesture ends with its own release, not in the middle of it.
    if (!m_tool->isBusy())
        m_context.document.endGesture();
}

void MapToolbox::setHovered(const std::string& id)
{
    if (m_hovered == id)
        return;
    m_hovered = id;
    m_context.view.setCursor(m_tool->cursor(m_hovered));
    m_context.view.update();
    emit hoveredChanged(m_hovered);
}

void MapToolbox::refresh()
{
    m_context.view.setCursor(m_tool->cursor(m_hovered));
    if (const QString status = m_tool->status(); status != m_status) {
        m_status = status;
        emit statusText(m_status);
    }
    m_context.view.update();
}

} // namespace berg
