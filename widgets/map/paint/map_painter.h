#pragma once

#include "widgets/map/paint/graticule.h"
#include "widgets/map/paint/map_layout.h"

#include <QImage>

namespace berg {

class LandLayer;
class MapSprites;
class SweptLayer;

/** A picture with its layout. All members are borrowed. */
struct MapFrame
{
    const MapPicture& picture;
    const MapStyle& style;
    const MapLayout& layout;
    const Graticule& graticule;
    MapSprites* sprites = nullptr; ///< cache of drawings; null draws everything at its exact place
    LandLayer* land = nullptr;     ///< null draws the land at once
    SweptLayer* swept = nullptr;   ///< null draws the water seen at once
    std::optional<QPointF> pointer = {}; ///< a panel under it that hides a symbol is faded
};

// Layers of a map from bottom to top; each stays inside `layout.rect`. They work on any paint
// device whose logical unit is the device-independent pixel.

/** Paints sea, land and graticule, which depend on the view only. */
void paintMapGround(QPainter& painter, const MapFrame& frame);
/** Paints areas, water seen, tracks, plans, icebergs, UAVs with their names. */
void paintMapContent(QPainter& painter, const MapFrame& frame);
/** Paints the names of icebergs with their order, and the numbers of the graticule. */
void paintMapLabels(QPainter& painter, const MapFrame& frame);
/** Paints title, legend, scale bar, north arrow, wind, and the message on an empty map. */
void paintMapOverlays(QPainter& painter, const MapFrame& frame);

/** Paints all layers of a picture. */
void paintMap(QPainter& painter, const MapPicture& picture, const MapStyle& style,
              const MapLayout& layout);

/** Renders the picture to an image of `size_px`, with `scale` device pixels per layout unit. */
[[nodiscard]] QImage mapImage(const MapPicture& picture, const MapStyle& style,
                              const QSize& size_px, double scale);

} // namespace berg
