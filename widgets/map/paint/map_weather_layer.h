#pragma once

#include "widgets/map/picture/map_picture.h"
#include "widgets/map/picture/map_view_transform.h"
#include "widgets/theme/theme.h"

#include <QPainter>
#include <QRectF>

#include <memory>
#include <vector>

namespace berg {

struct MapLayout;
struct MapPaint;

/** Wind and current at one place of the screen. */
struct MapWeatherMark
{
    QPointF at_px;
    MapWeatherValues values;
};

/** Marks of a forecast in one view. Pictures of one minute and view share them. */
struct MapWeatherMarks
{
    MapWeatherPointer weather;
    MapViewTransform view;
    QRectF rect;
    std::vector<MapWeatherMark> marks;
};
using MapWeatherMarksPointer = std::shared_ptr<const MapWeatherMarks>;

/** Largest distance that a mark reaches from its place. */
inline constexpr double kWeatherMark_px = 30;

/**
 * Returns the marks of a picture's forecast in a view: at the knots of a grid that is fixed to the
 * sea, so that marks move with the map, and as dense as the view has room. Returns `known` if it is
 * of this forecast and view; null without a forecast.
 */
[[nodiscard]] MapWeatherMarksPointer weatherMarksIn(const MapPicture& picture,
                                                    const MapViewTransform& view,
                                                    const QRectF& rect,
                                                    const MapWeatherMarksPointer& known);

/** Paints wind barbs and current arrows, except where labels and panels are. */
void paintMapWeather(const MapPaint& p);

/** Draws a wind barb with its station at `at`. */
void drawWindBarb(QPainter& painter, const QPointF& at, const Point& wind_mps, bool isSouthern,
                  const Theme& theme);
/** Draws an arrow of the current in its middle; longer for faster water. */
void drawCurrentArrow(QPainter& painter, const QPointF& middle, const Point& current_mps,
                      const Theme& theme);

} // namespace berg
