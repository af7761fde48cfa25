#include "widgets/map/map_legs.h"

#include "core/base/enclosing_circle.h"

#include <algorithm>
#include <span>

namespace berg {
namespace {

/** The icebergs planned as one point with this one; null: it is planned by itself. */
const std::vector<int>* clusterOf(const MapPicture& picture, int iceberg)
{
    const auto found = std::find_if(
        picture.clusters.begin(), picture.clusters.end(), [&](const std::vector<int>& members) {
            return std::find(members.begin(), members.end(), iceberg) != members.end();
        });
    return found == picture.clusters.end() ? nullptr : &*found;
}

/** Where a leg to this iceberg ends. */
LabelDisk stopAt(const MapPicture& picture, const MapLayout& layout, int iceberg)
{
    if (const std::vector<int>* members = clusterOf(picture, iceberg))
        return {.centre_px = layout.view.toPixel(middleOf_m(picture, *members)), .radius_px = 0};
    return layout.icebergs[static_cast<std::size_t>(iceberg)];
}

/** On the way from `from` to `to`, past the edge of its symbol. */
QPointF pastEdge(const LabelDisk& from, const QPointF& to)
{
    const QLineF way(from.centre_px, to);
    return way.length() > 0 ? way.pointAt(from.radius_px / way.length()) : to;
}

/** By way of the corners, cut at the symbols; empty: there is no room between. */
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

/** That leg `k` of the plan goes round. */
QPolygonF cornersOf(const MapPicture& picture, const MapLayout& layout, std::size_t k)
{
    QPolygonF corners;
    if (k < picture.planCorners.size())
        for (const Point& corner_m : picture.planCorners[k])
            corners << layout.view.toPixel(corner_m);
    return corners;
}

std::vector<QPolygonF> legsAlong(const std::vector<MapWay>& ways, const MapViewTransform& view)
{
    std::vector<QPolygonF> legs;
    for (const MapWay& way : ways) {
        QPolygonF& leg = legs.emplace_back();
        for (const Point& point_m : way.path_m)
            leg << view.toPixel(point_m);
    }
    return legs;
}

LabelDisk uavStop(const MapPicture& picture, const MapLayout& layout)
{
    return {.centre_px = layout.view.toPixel(picture.uav->position_m), .radius_px = 0};
}

std::span<const int> thisSortie(const MapPicture& picture)
{
    const std::span<const int> all(picture.plan);
    const auto wanted = static_cast<std::size_t>(
        std::max(0, picture.thisSortie.value_or(static_cast<int>(all.size()))));
    return all.first(std::min(wanted, all.size()));
}

} // namespace

Point middleOf_m(const MapPicture& picture, const std::vector<int>& members)
{
    std::vector<Point> places_m;
    for (const int member : members)
        places_m.push_back(picture.icebergs[static_cast<std::size_t>(member)].position_m);
    return enclosingCircle(places_m).centre_m;
}

std::vector<Point> planStops_m(const MapPicture& picture)
{
    std::vector<Point> stops_m;
    for (const int iceberg : thisSortie(picture)) {
        const std::vector<int>* members = clusterOf(picture, iceberg);
        stops_m.push_back(members != nullptr
                              ? middleOf_m(picture, *members)
                              : picture.icebergs[static_cast<std::size_t>(iceberg)].position_m);
    }
    if (picture.home_m && picture.thisSortie)
        stops_m.push_back(*picture.home_m);
    return stops_m;
}

std::vector<QPolygonF> planLegs(const MapPicture& picture, const MapLayout& layout)
{
    if (!picture.uav)
        return {};
    if (!picture.planWays.empty())
        return legsAlong(picture.planWays, layout.view);
    std::vector<QPolygonF> legs;
    LabelDisk from = uavStop(picture, layout);
    for (const int iceberg : thisSortie(picture)) {
        const LabelDisk to = stopAt(picture, layout, iceberg);
        legs.push_back(legBetween(from, cornersOf(picture, layout, legs.size()), to));
        from = to;
    }
    return legs;
}

QPolygonF homeLeg(const MapPicture& picture, const MapLayout& layout)
{
    if (!picture.uav || !picture.home_m || !picture.thisSortie)
        return {};
    const std::span<const int> flown = thisSortie(picture);
    LabelDisk from = uavStop(picture, layout);
    if (!picture.planWays.empty())
        from.centre_px = layout.view.toPixel(picture.planWays.back().path_m.back());
    else if (!flown.empty())
        from = stopAt(picture, layout, flown.back());
    return legBetween(from, cornersOf(picture, layout, flown.size()),
                      {.centre_px = layout.view.toPixel(*picture.home_m), .radius_px = 0});
}

std::vector<QPolygonF> formerLegs(const MapPicture& picture, const MapLayout& layout)
{
    if (!picture.uav)
        return {};
    if (!picture.formerWays.empty())
        return legsAlong(picture.formerWays, layout.view);
    const Point from_m = picture.formerFrom_m.value_or(picture.uav->position_m);
    std::vector<QPolygonF> legs;
    LabelDisk from{.centre_px = layout.view.toPixel(from_m), .radius_px = 0};
    for (const int iceberg : picture.formerPlan) {
        const LabelDisk to = stopAt(picture, layout, iceberg);
        legs.push_back(legBetween(from, {}, to));
        from = to;
    }
    return legs;
}

} // namespace berg
