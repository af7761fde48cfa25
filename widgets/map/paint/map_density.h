#pragma once

#include "widgets/map/picture/map_picture.h"
#include "widgets/map/picture/map_view_transform.h"

#include <QRectF>

#include <optional>

namespace berg {

/** Place of an iceberg in the plans. */
struct MapStop
{
    std::optional<int> order; ///< 1-based visit number; nullopt if it is not planned
    std::size_t uav = 0;
    std::vector<int> later{}; ///< visit numbers of its further visits in the same plan
};

/** Returns the stops by iceberg. If two plans contain one (one of them outdated), the earlier visit
 * counts. */
[[nodiscard]] std::vector<MapStop> stopsOf(const MapPicture& picture);

/** Form in which an iceberg is drawn. */
enum class IcebergMark
{
    Symbol, ///< with ring, drift and name
    Dot,
    Counted ///< part of a group drawn as one number
};

/** A group of icebergs so close together that they are drawn as a number. */
struct MapCount
{
    QPointF centre_px;
    int icebergs = 0;
    double sigma_m2 = 0; ///< the largest in the group
};

/** Whether the icebergs of a view have room for full symbols. */
struct MapCrowding
{
    /** Rings would overlap: symbols are small, and only their colour shows sigma. */
    bool isCrowded = false;
    bool isDense = false; ///< small symbols would overlap too: most icebergs are dots
};

/** Form of each iceberg in one view. A dense view is crowded as well. */
struct MapDensity : MapCrowding
{
    [[nodiscard]] const MapCrowding& crowding() const { return *this; }

    std::vector<IcebergMark> marks; ///< by iceberg
    std::vector<MapCount> counts;
};

/** Number of next icebergs per plan that keep symbol, number and name in a dense field. */
inline constexpr int kNumberedNext = 10;

/** Returns true if the stop is among the next visits of its plan. */
[[nodiscard]] inline bool isNext(const MapStop& stop)
{
    return stop.order && *stop.order <= kNumberedNext;
}

/**
 * Chooses the form of each iceberg. The field is crowded if most of at least 40 icebergs in sight
 * have a neighbour within 34 px, and dense if within 20 px. In a dense field the next ten of each
 * plan, lost icebergs and those approaching an asset keep their symbols; the others are dots, and
 * three or more dots that overlap become a number. `before` is the state of the previous frame, for
 * hysteresis. Cost: linear.
 */
[[nodiscard]] MapDensity densityOf(const MapPicture& picture, const MapViewTransform& view,
                                   const QRectF& shown, const std::vector<MapStop>& stops,
                                   const MapCrowding& before);

} // namespace berg
