#include "widgets/map/picture/plan_stops.h"

#include "core/geometry/enclosing_circle.h"

#include <algorithm>

namespace berg {

MapPlaces placesOf(const IcebergList& icebergs, const ShownPlaces& shown)
{
    MapPlaces places;
    for (const IcebergIndex iceberg : icebergs)
        if (const std::optional<MapPlace>& place = shown[toIndex(iceberg)])
            places.push_back(*place);
    return places;
}

const MapPlaces* clusterOf(const MapPicture& picture, MapPlace iceberg)
{
    const auto found = std::find_if(
        picture.clusters.begin(), picture.clusters.end(), [&](const MapPlaces& members) {
            return std::find(members.begin(), members.end(), iceberg) != members.end();
        });
    return found == picture.clusters.end() ? nullptr : &*found;
}

std::span<const MapPlace> thisSortie(const MapRoute& route)
{
    const std::span<const MapPlace> all(route.plan);
    const auto wanted = static_cast<std::size_t>(
        std::max(0, route.thisSortie.value_or(static_cast<int>(all.size()))));
    return all.first(std::min(wanted, all.size()));
}

Point middleOf_m(const MapPicture& picture, const MapPlaces& members)
{
    std::vector<Point> places_m;
    for (const MapPlace member : members)
        places_m.push_back(picture.icebergs[toIndex(member)].position_m);
    return enclosingCircle(places_m).centre_m;
}

std::vector<Point> planStops_m(const MapPicture& picture, std::size_t uav)
{
    const MapRoute& route = picture.routes[uav];
    std::vector<Point> stops_m;
    for (const MapPlace iceberg : thisSortie(route)) {
        const MapPlaces* members = clusterOf(picture, iceberg);
        stops_m.push_back(members != nullptr ? middleOf_m(picture, *members)
                                             : picture.icebergs[toIndex(iceberg)].position_m);
    }
    if (const std::optional<Point>& home_m = picture.uavs[uav].home_m; home_m && route.thisSortie)
        stops_m.push_back(*home_m);
    return stops_m;
}

} // namespace berg
