#pragma once

#include "widgets/map/picture/map_picture.h"
#include "widgets/map/picture/map_view_transform.h"

#include <QRectF>

namespace berg {

/** An iceberg's place in the plans. */
struct MapStop
{
    int order = 0; ///< 1-based; 0: not planned
    std::size_t uav = 0;
    std::vector<int> later{}; ///< places of further visits in the same plan
};

/** By iceberg. Where two plans have one, one of them being old, the sooner visit counts. */
[[nodiscard]] std::vector<MapStop> stopsOf(const MapPicture& picture);

/** How an iceberg is drawn. */
enum class IcebergMark
{
    Symbol, ///< with ring, drift and name
    Dot,
    Counted ///< with others as one number
};

/** Icebergs that lie so close together that they are drawn as a number. */
struct MapCount
{
    QPointF centre_px;
    int icebergs = 0;
    double sigma_m2 = 0; ///< the largest of theirs
};

/** How much room the icebergs of one view have. */
struct MapCrowding
{
    /** Rings would cover each other: symbols are small, their colour alone shows sigma. */
    bool isCrowded = false;
    bool isDense = false; ///< even small symbols would: all but the next ones are dots
};

/** How the icebergs of one view are drawn. A dense one is crowded, too. */
struct MapDensity : MapCrowding
{
    [[nodiscard]] const MapCrowding& crowding() const { return *this; }

    std::vector<IcebergMark> marks; ///< by iceberg
    std::vector<MapCount> counts;
};

/** So many icebergs of each plan keep symbol, number and name however crowded the field is. */
inline constexpr int kNumberedNext = 10;

/** One of the next visits of a plan. */
[[nodiscard]] inline bool isNext(const MapStop& stop)
{
    return stop.order > 0 && stop.order <= kNumberedNext;
}

/**
 * Where most of at least 40 icebergs in sight have another within 34 px, the field is crowded.
 * Where they have one within 20 px, the next ten of each plan, lost ones and those on their way to
 * an asset keep their symbols; the others are dots, three and more that cover each other a number.
 * `before`: in the frame before, so that a field at a limit does not flicker. Cost: linear.
 */
[[nodiscard]] MapDensity densityOf(const MapPicture& picture, const MapViewTransform& view,
                                   const QRectF& shown, const std::vector<MapStop>& stops,
                                   const MapCrowding& before);

} // namespace berg
