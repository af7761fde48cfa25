#pragma once

#include "widgets/map/picture/map_picture.h"
#include "widgets/theme/theme.h"

#include <QPen>

#include <utility>

namespace berg {

struct MapPaint;

// What there is beside icebergs and ways, as parts of the content of a map.

/** Names of areas with their heights: they give way to panels, to all that has a symbol and to each
 * other. */
class AreaNames
{
public:
    explicit AreaNames(const MapPaint& p);
    /** `shown`: of the area; `shares` of its height, the best first. Nothing without a free place.
     */
    void paint(const QRectF& shown, const std::array<QString, 2>& lines,
               const std::array<double, 5>& shares);
    /** No further name there. */
    void keepOff(const QRectF& place) { m_taken.push_back(place); }

private:
    [[nodiscard]] bool isFree(const QRectF& label) const;

    const MapPaint& m_p;
    std::vector<QRectF> m_taken;
};

/** The area that is monitored, with a fence the one that the UAVs stay inside. */
void paintArea(const MapPaint& p);
/** No-fly areas and the stand-off ring: hatched, with their names and heights. */
void paintClosedAreas(const MapPaint& p, AreaNames& names);
/** Outlines of airspace and of the operation volume. */
void paintPermit(const MapPaint& p, AreaNames& names);
[[nodiscard]] QPen volumePen(VolumePart part, const Theme& theme);
[[nodiscard]] QPen airspacePen(const Theme& theme);
/** Where the UAVs land. */
void paintHomes(const MapPaint& p);
/** What is to be protected, with its rings. */
void paintAsset(const MapPaint& p);
/** Where the radio link is kept from, and how far it reaches. */
void paintStation(const MapPaint& p);
/** Points of no return on the plans. */
void paintNoReturns(const MapPaint& p);
/** Outlines round icebergs that are planned as one point. */
void paintClusters(const MapPaint& p);
/** The circles that hold 95 %. */
void paintCircles(const MapPaint& p);
/** True positions that are apart from the estimates. */
void paintTruths(const MapPaint& p);
/** Signs at icebergs on their way into the inner ring of the asset. */
void paintAlarms(const MapPaint& p);
/** At icebergs that one of several UAVs alone is to visit. */
void paintPins(const MapPaint& p);
/** Round UAVs that are nearer to each other than they should be. */
void paintTooClose(const MapPaint& p);

/** Places in `uavs` of those aloft in one altitude layer, nearer than `separation_m`. */
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>>
pairsTooClose(const MapPicture& picture);

} // namespace berg
