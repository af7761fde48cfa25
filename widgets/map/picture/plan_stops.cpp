#include "widgets/map/picture/plan_stops.h"

#include "core/geometry/enclosing_circle.h"

#include <algorithm>

namespace berg {

std::vector<int> placesOf(const std::vector<int>& icebergs, const ShownPlaces& shown)
{
    std::vector<int> places;
    for (const int iceberg : icebergs)
        if (const std::optional<int>& place = shown[static_cast<std::size_t>(iceberg)])
            places.push_back(*place);
    return places;
}

const std::vector<int>* clusterOf(const MapPicture& picture, int iceberg)
{
    const auto found = std::find_if(
        picture.clusters.begin(), picture.clusters.end(), [&](const std::vector<int>& members) {
            return std::find(members.begin(), members.end(), iceberg) != members.end();
        });
    return found == picture.clusters.end() ? nullptr : &*found;
}

std::span<const int> thisSortie(const MapRoute& route)
{
    const std::span<const int> all(route.plan);
    const auto wanted = static_cast<std::size_t>(
        std::max(0, route.thisSortie.value_or(static_cast<int>(all.size()))));
    return all.first(std::min(wanted, all.size()));
}

Point middleOf_m(const MapPicture& picture, const std::vector<int>& members)
{
    std::vector<Point> places_m;
    for (const int member : members)
        places_m.push_back(picture.icebergs[static_cast<std::size_t>(member)].position_m);
    return enclosingCircle(places_m).centre_m;
}

std::vector<Point> planStops_m(const MapPicture& picture, std::size_t uav)
{
    const MapRoute& route = picture.routes[uav];
    std::vector<Point> stops_m;
    for (const int iceberg : thisSortie(route)) {
        const std::vector<int>* members = clusterOf(picture, iceberg);
        stops_m.push_back(members != nullptr
                              ? middleOf_m(picture, *members)
                              : picture.icebergs[static_cast<std::size_t>(iceberg)].position_m);
    }
    if (const std::optional<Point>& home_m = picture.uavs[uav].home_m; home_m && route.thisSortie)
        stops_m.push_back(*home_m);
    return stops_m;
}

} // namespace berg
