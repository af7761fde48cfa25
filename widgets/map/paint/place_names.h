#pragma once

#include "widgets/places/gazetteer.h"

#include <QRectF>

#include <vector>

namespace berg {

struct MapLayout;
struct MapPaint;
struct MapPicture;
struct Theme;

/** Name of a gazetteer place as it appears on the map. */
struct MapPlaceName
{
    const GazetteerPlace* place = nullptr; ///< entry of the gazetteer, which is permanent
    QPointF at_px;                         ///< position of the place
    QRectF rect;                           ///< rectangle of the name
};

/**
 * Returns the names of places in sight that suit the scale, better known ones first: seas and large
 * towns on a map of the ocean, villages on a map of a bay. They avoid panels, the mission's names
 * and symbols and each other. The asset's surroundings stay free, because it often is one of these
 * places. `layout` must be complete but for them.
 */
[[nodiscard]] std::vector<MapPlaceName> placeNamesOn(const MapLayout& layout,
                                                     const MapPicture& picture, const Theme& theme);

/** Paints the names, which lie below all objects of the mission. */
void paintPlaceNames(const MapPaint& p);

} // namespace berg
