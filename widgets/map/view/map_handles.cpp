#include "widgets/map/view/map_handles.h"

#include "widgets/document/selection.h"
#include "widgets/map/paint/map_drift.h"
#include "widgets/map/paint/wind_panel.h"
#include "widgets/map/picture/scenario_picture.h"
#include "widgets/map/view/map_scene.h"
#include "widgets/theme/painter_state.h"
#include "widgets/theme/palette.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

namespace berg {
namespace {

constexpr double kReach_px = 8;
constexpr double kLargeReach_px = 12; // for corners, which have no close neighbours
constexpr double kDrift_px = 4;       // radius
constexpr double kRimGap_px = 10;     // distance from the symbol if the drift is too short to see
constexpr double kHeading_px = 34;    // distance from the UAV
constexpr double kCorner_px = 8;      // side
constexpr double kMiddle_px = 3.2;    // radius
constexpr double kShortestEdge_px = 48;

/** Position at the tip of the drift arrow, or north of the symbol if there is no visible arrow. */
QPointF driftHandle(MapScene& scene, std::size_t iceberg)
{
    const MapLayout& layout = scene.layout();
    const LabelDisk& disk = layout.icebergs[iceberg];
    const QLineF arrow = driftArrow(scene.picture(), layout, iceberg);
    const QPointF north(0, -1);
    const QPointF along =
        arrow.isNull() ? north : (arrow.p2() - arrow.p1()) / std::max(1e-9, arrow.length());
    const double length_px = disk.radius_px + std::max(arrow.length(), kRimGap_px);
    return disk.centre_px + along * length_px;
}

void addIcebergHandles(std::vector<MapHandle>& handles, MapScene& scene, const Selection& selection)
{
    const std::unordered_set<std::string> selected(selection.ids().begin(), selection.ids().end());
    const std::vector<MapIceberg>& icebergs = scene.picture().icebergs;
    for (std::size_t i = 0; i < icebergs.size(); ++i)
        if (const std::string id = keyOf(icebergs[i]); selected.contains(id))
            handles.push_back(
                {.kind = HandleKind::Drift, .id = id, .at_px = driftHandle(scene, i)});
}

void addUavHandles(std::vector<MapHandle>& handles, MapScene& scene, const Selection& selection)
{
    for (const MapUav& uav : scene.picture().uavs) {
        if (!uav.key || !selection.contains(*uav.key))
            continue;
        const QPointF along(std::cos(uav.psi_rad), -std::sin(uav.psi_rad));
        handles.push_back({.kind = HandleKind::Heading,
                           .id = *uav.key,
                           .uav = uav.place,
                           .at_px = scene.view().toPixel(uav.position_m) + along * kHeading_px});
    }
}

void dropHidden(std::vector<MapHandle>& handles, MapScene& scene)
{
    std::erase_if(handles, [&](const MapHandle& handle) {
        return !scene.rect().contains(handle.at_px) || scene.isOverlay(handle.at_px);
    });
}

void paintHandle(QPainter& painter, const MapHandle& handle, bool isHovered, bool isCurrent,
                 const Theme& theme)
{
    const double larger_px = isHovered ? 1.5 : 0;
    const QColor ink =
        handle.kind == HandleKind::Heading ? uavColour(theme, handle.uav) : theme.plan;
    painter.setPen(QPen(ink, 1.8));
    painter.setBrush(isHovered || isCurrent ? ink : theme.panel);
    if (handle.kind == HandleKind::Corner) {
        const double side_px = kCorner_px + 2 * larger_px;
        painter.drawRect(QRectF(handle.at_px.x() - side_px / 2, handle.at_px.y() - side_px / 2,
                                side_px, side_px));
        return;
    }
    const double radius_px = (handle.kind == HandleKind::Edge ? kMiddle_px : kDrift_px) + larger_px;
    painter.drawEllipse(handle.at_px, radius_px, radius_px);
}

} // namespace

std::vector<MapHandle> areaHandles(MapScene& scene, const std::string& key)
{
    const QPolygonF outline = scene.outlineOf(key);
    std::vector<MapHandle> handles;
    for (qsizetype i = 0; i < outline.size(); ++i) {
        const QLineF edge(outline[i], outline[(i + 1) % outline.size()]);
        const auto index = static_cast<std::size_t>(i);
        handles.push_back(
            {.kind = HandleKind::Corner, .id = key, .index = index, .at_px = edge.p1()});
        if (edge.length() >= kShortestEdge_px)
            handles.push_back(
                {.kind = HandleKind::Edge, .id = key, .index = index, .at_px = edge.center()});
    }
    dropHidden(handles, scene);
    return handles;
}

std::optional<MapHandle> windHandle(MapScene& scene)
{
    const QRectF& panel = scene.layout().wind;
    if (panel.isNull() || scene.picture().air.isFixed)
        return std::nullopt;
    return MapHandle{.kind = HandleKind::Wind, .at_px = windTip(panel, scene.picture().air)};
}

std::vector<MapHandle> handlesOf(MapScene& scene, const Selection& selection)
{
    std::vector<MapHandle> handles;
    if (selection.isEmpty())
        return handles;
    addIcebergHandles(handles, scene, selection);
    addUavHandles(handles, scene, selection);
    dropHidden(handles, scene);
    for (const std::string& id : selection.ids())
        if (isOutlineKey(id))
            for (MapHandle& handle : areaHandles(scene, id))
                handles.push_back(std::move(handle));
    return handles;
}

std::optional<MapHandle> handleAt(const std::vector<MapHandle>& handles, const QPointF& at)
{
    const MapHandle* nearest = nullptr;
    double nearest_px = std::numeric_limits<double>::infinity();
    for (const MapHandle& handle : handles) {
        const double distance_px = QLineF(at, handle.at_px).length();
        const double reach_px = handle.kind == HandleKind::Corner ? kLargeReach_px : kReach_px;
        if (distance_px > reach_px || distance_px >= nearest_px)
            continue;
        nearest = &handle;
        nearest_px = distance_px;
    }
    return nearest == nullptr ? std::nullopt : std::optional<MapHandle>(*nearest);
}

void paintHandles(QPainter& painter, const std::vector<MapHandle>& handles,
                  const HandleMarks& marks, const Theme& theme)
{
    const PainterState saved(painter);
    for (const MapHandle& handle : handles)
        paintHandle(painter, handle, marks.hovered && marks.hovered->isSame(handle),
                    marks.corner && marks.corner->isSame(handle), theme);
}

} // namespace berg
