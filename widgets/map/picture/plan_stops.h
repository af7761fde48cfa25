#pragma once

#include "widgets/map/picture/map_picture.h"

#include <optional>
#include <span>
#include <vector>

namespace berg {

/** By iceberg of a mission or an export, its place in the picture; nullopt if it is not shown. */
using ShownPlaces = std::vector<std::optional<MapPlace>>;

/** Returns the places of the icebergs that are shown. */
[[nodiscard]] MapPlaces placesOf(const IcebergList& icebergs, const ShownPlaces& shown);

/** Returns the cluster that contains `iceberg`; null if it is planned separately. */
[[nodiscard]] const MapPlaces* clusterOf(const MapPicture& picture, MapPlace iceberg);

/** Returns the icebergs of the plan that are visited before the flight home. */
[[nodiscard]] std::span<const MapPlace> thisSortie(const MapRoute& route);

/** Returns the end of each leg of this sortie; members of a cluster have the same end. The home
 * place is the last one if the UAV has one and the sortie ends there (`MapRoute::thisSortie`). */
[[nodiscard]] std::vector<Point> planStops_m(const MapPicture& picture, std::size_t uav);

/**
 * Returns the point that a UAV flies to for a cluster: the centre of the circle around `members`.
 */
[[nodiscard]] Point middleOf_m(const MapPicture& picture, const MapPlaces& members);

} // namespace berg
