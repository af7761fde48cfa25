#pragma once

#include "widgets/map/picture/map_picture.h"

#include <span>

namespace berg {

/** Icebergs as places in the picture, by iceberg in `shown`; those at -1 are left out. */
[[nodiscard]] std::vector<int> placesOf(const std::vector<int>& icebergs,
                                        const std::vector<int>& shown);

/** The icebergs planned as one point with this one; null: it is planned by itself. */
[[nodiscard]] const std::vector<int>* clusterOf(const MapPicture& picture, int iceberg);

/** The icebergs of the plan that are visited before home. */
[[nodiscard]] std::span<const int> thisSortie(const MapRoute& route);

/** Where the legs of this sortie end, the way home last; the same twice within a cluster. */
[[nodiscard]] std::vector<Point> planStops_m(const MapPicture& picture, std::size_t uav);

/** The point that icebergs planned as one are flown to. */
[[nodiscard]] Point middleOf_m(const MapPicture& picture, const std::vector<int>& members);

} // namespace berg
