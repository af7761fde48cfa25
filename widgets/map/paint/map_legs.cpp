#include "widgets/map/paint/map_legs.h"

#include "widgets/map/picture/plan_stops.h"

namespace berg {
namespace {

/** End of a leg to this iceberg: its symbol, or the middle of its cluster. */
LabelDisk stopAt(const MapPicture& picture, const MapLayout& layout, MapPlace iceberg)
{
    if (const MapPlaces* members = clusterOf(picture, iceberg))
        return {.centre_px = layout.view.toPixel(middleOf_m(picture, *members)), .radius_px = 0};
    return layout.icebergs[toIndex(iceberg)];
}

/** Point towards `to` at the edge of the symbol `from`. */
QPointF pastEdge(const LabelDisk& from, const QPointF& to)
{
    const QLineF path(from.centre_px, to);
    return path.length() > 0 ? path.pointAt(from.radius_px / path.length()) : to;
}

/** Leg through `corners`, cut at the symbols; empty if there is no room between them. */
QPolygonF legBetween(const LabelDisk& from, const QPolygonF& corners, const LabelDisk& to)
{
    const double length_px = QLineF(from.centre_px, to.centre_px).length();
    if (corners.isEmpty() && length_px <= from.radius_px + to.radius_px + 1)
        return {};
    QPolygonF leg{pastEdge(from, corners.isEmpty() ? to.centre_px : corners.front())};
    leg << corners;
    leg << pastEdge(to, corners.isEmpty() ? from.centre_px : corners.back());
    return leg;
}

/** Geofence corners of leg `k` of the plan. */
QPolygonF cornersOf(const MapRoute& route, const MapLayout& layout, std::size_t k)
{
    return k < route.planCorners.size() ? layout.view.toPixels(route.planCorners[k]) : QPolygonF();
}

std::vector<QPolygonF> legsAlong(const std::vector<MapPath>& paths, const MapViewTransform& view)
{
    std::vector<QPolygonF> legs;
    for (const MapPath& path : paths)
        legs.push_back(view.toPixels(path.path_m));
    return legs;
}

LabelDisk pointAt(const Point& place_m, const MapLayout& layout)
{
    return {.centre_px = layout.view.toPixel(place_m), .radius_px = 0};
}

} // namespace

std::vector<QPolygonF> planLegs(const MapPicture& picture, const MapLayout& layout, std::size_t uav)
{
    const MapRoute& route = picture.routes[uav];
    if (!route.planPaths.empty())
        return legsAlong(route.planPaths, layout.view);
    std::vector<QPolygonF> legs;
    LabelDisk from = pointAt(picture.uavs[uav].position_m, layout);
    for (const MapPlace iceberg : thisSortie(route)) {
        const LabelDisk to = stopAt(picture, layout, iceberg);
        legs.push_back(legBetween(from, cornersOf(route, layout, legs.size()), to));
        from = to;
    }
    return legs;
}

QPolygonF homeLeg(const MapPicture& picture, const MapLayout& layout, std::size_t uav)
{
    const MapRoute& route = picture.routes[uav];
    const std::optional<Point>& home_m = picture.uavs[uav].home_m;
    if (!home_m || !route.thisSortie)
        return {};
    const std::span<const MapPlace> flown = thisSortie(route);
    LabelDisk from = pointAt(picture.uavs[uav].position_m, layout);
    if (!route.planPaths.empty())
        from = pointAt(route.planPaths.back().path_m.back(), layout);
    else if (!flown.empty())
        from = stopAt(picture, layout, flown.back());
    return legBetween(from, cornersOf(route, layout, flown.size()), pointAt(*home_m, layout));
}

std::vector<QPolygonF> formerLegs(const MapPicture& picture, const MapLayout& layout,
                                  std::size_t uav)
{
    const MapRoute& route = picture.routes[uav];
    if (!route.formerPaths.empty())
        return legsAlong(route.formerPaths, layout.view);
    std::vector<QPolygonF> legs;
    LabelDisk from = pointAt(route.formerFrom_m.value_or(picture.uavs[uav].position_m), layout);
    for (const MapPlace iceberg : route.formerPlan) {
        const LabelDisk to = stopAt(picture, layout, iceberg);
        legs.push_back(legBetween(from, {}, to));
        from = to;
    }
    return legs;
}

} // namespace berg
