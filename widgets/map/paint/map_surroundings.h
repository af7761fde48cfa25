#pragma once

#include "widgets/map/picture/map_picture.h"
#include "widgets/theme/theme.h"

#include <QPen>

#include <utility>

namespace berg {

struct MapPaint;

// Objects besides icebergs and paths, as parts of the content of a map.

/** Places names of areas clear of panels, symbols and each other. */
class AreaNames
{
public:
    explicit AreaNames(const MapPaint& p);
    /**
     * Draws two lines at a free place; nothing if there is none. `shown` is the visible part of the
     * area, `shares` are the heights in it to try, best first.
     */
    void paint(const QRectF& shown, const std::array<QString, 2>& lines,
               const std::array<double, 5>& shares);
    /** Excludes a rectangle for further names. */
    void reserve(const QRectF& place) { m_taken.push_back(place); }

private:
    [[nodiscard]] bool isFree(const QRectF& label) const;

    const MapPaint& m_p;
    std::vector<QRectF> m_taken;
};

/** Paints the monitored area, with fence posts if the UAVs stay inside. */
void paintArea(const MapPaint& p);
/** Paints no-fly areas and the stand-off ring: hatched, with names and heights. */
void paintClosedAreas(const MapPaint& p, AreaNames& names);
/** Paints the outlines of airspace and of the operation volume. */
void paintPermit(const MapPaint& p, AreaNames& names);
/** Returns the line style of a part of the operation volume. */
[[nodiscard]] QPen volumePen(VolumePart part, const Theme& theme);
/** Returns the line style of airspace. */
[[nodiscard]] QPen airspacePen(const Theme& theme);
/** Paints the landing places of the UAVs. */
void paintHomes(const MapPaint& p);
/** Paints the protected asset with its rings. */
void paintAsset(const MapPaint& p);
/** Paints the ground station and its radio range. */
void paintStation(const MapPaint& p);
/** Paints the points of no return of the plans, with dotted paths from the visits before them. */
void paintNoReturns(const MapPaint& p);
/** Paints outlines around icebergs that are planned as one point. */
void paintClusters(const MapPaint& p);
/** Paints the 95 % position circles. */
void paintCircles(const MapPaint& p);
/** Paints true positions that differ visibly from the estimates. */
void paintTruths(const MapPaint& p);
/** Paints an alarm at icebergs that will enter the asset's inner ring. */
void paintAlarms(const MapPaint& p);
/** Paints a pin at icebergs assigned to one UAV of a fleet. */
void paintPins(const MapPaint& p);
/** Paints an alarm around UAVs that are too close to each other. */
void paintTooClose(const MapPaint& p);

/**
 * Returns pairs of indices in `uavs`: aloft, in one altitude layer and nearer than `separation_m`.
 */
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>>
pairsTooClose(const MapPicture& picture);

} // namespace berg
