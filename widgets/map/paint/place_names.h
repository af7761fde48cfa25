#pragma once

#include "widgets/model/gazetteer.h"

#include <QRectF>

#include <vector>

namespace berg {

struct MapLayout;
struct MapPaint;
struct MapPicture;
struct Theme;

/** Name of a place of the gazetteer where it stands on the map. */
struct MapPlaceName
{
    const GazetteerPlace* place = nullptr; ///< of the gazetteer, which stays
    QPointF at_px;                         ///< the place itself
    QRectF rect;                           ///< of the name
};

/**
 * Names of places in sight that suit the scale, those of lower rank first: seas and towns that
 * everybody knows on a map of the ocean, villages on that of a bay. They give way to panels, to
 * names and symbols of the mission and to each other, and none is at the asset, which often is one
 * of these places. `layout` has all but them.
 */
[[nodiscard]] std::vector<MapPlaceName> placeNamesOn(const MapLayout& layout,
                                                     const MapPicture& picture, const Theme& theme);

/** Below everything of the mission. */
void paintPlaceNames(const MapPaint& p);

} // namespace berg
