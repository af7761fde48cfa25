#pragma once

#include "widgets/map/paint/graticule.h"
#include "widgets/map/paint/map_layout.h"

#include <QImage>

namespace berg {

class LandLayer;
class MapSprites;
class SweptLayer;

/** One picture and where its parts go. Everything is borrowed. */
struct MapFrame
{
    const MapPicture& picture;
    const MapStyle& style;
    const MapLayout& layout;
    const Graticule& graticule;
    MapSprites* sprites = nullptr;       ///< null: everything is drawn afresh, at its exact place
    LandLayer* land = nullptr;           ///< null: the land is drawn here and now
    SweptLayer* swept = nullptr;         ///< null: the water seen is painted afresh
    std::optional<QPointF> pointer = {}; ///< a panel below it that hides something is faint
};

// The layers of a map from below; each keeps to the inside of `layout.rect`. They work on any paint
// device whose logical unit is the device-independent pixel.

/** Sea, land and graticule: the same as long as the view is. */
void paintMapGround(QPainter& painter, const MapFrame& frame);
/** Area, water seen, track, plan, icebergs, UAVs with their names. */
void paintMapContent(QPainter& painter, const MapFrame& frame);
/** Names of the icebergs with their order, numbers of the graticule. */
void paintMapLabels(QPainter& painter, const MapFrame& frame);
/** Title, legend, scale bar, north arrow, wind; the words on an empty map. */
void paintMapOverlays(QPainter& painter, const MapFrame& frame);

/** All layers of a picture where its layout put things. */
void paintMap(QPainter& painter, const MapPicture& picture, const MapStyle& style,
              const MapLayout& layout);

/** The picture as an image of `size_px`; `scale` device pixels for each unit of the layout. */
[[nodiscard]] QImage mapImage(const MapPicture& picture, const MapStyle& style,
                              const QSize& size_px, double scale);

} // namespace berg
