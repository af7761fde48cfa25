#pragma once

#include "core/io/import/maps/map_shapes.h"
#include "widgets/map/picture/map_plane.h"
#include "widgets/map/picture/map_view_transform.h"
#include "widgets/theme/theme.h"

#include <memory>
#include <vector>

class QPainter;

namespace berg {

/** Shapes of a user's file drawn below the map: an ice chart, routes, borders. */
using BackdropShapes = std::vector<MapShape>;
using BackdropPointer = std::shared_ptr<const BackdropShapes>;

/** Style of shapes without a colour of their own. */
struct BackdropStyle
{
    QColor ink;
    QColor ground; ///< halo of names
    QFont font;
    bool isNight = false; ///< shows the shapes' own colours in red
    bool operator==(const BackdropStyle&) const = default;
};

/** Returns the style of a backdrop in `theme`. */
[[nodiscard]] BackdropStyle backdropStyleOf(const Theme& theme);

/** Backdrop projected once to one plane. Use a drawing on one thread at a time. */
class BackdropDrawing
{
public:
    /** Projects the shapes; `shapes` must not be null. */
    BackdropDrawing(BackdropPointer shapes, const MapPlane& plane);

    /** Returns true if this is the drawing of these shapes in this plane. */
    [[nodiscard]] bool isOf(const BackdropPointer& shapes, const MapPlane& plane) const
    {
        return shapes == m_shapes && plane == m_plane;
    }
    /** Draws the shapes inside `rect`; names of places only if at most 200 are in view. */
    void paint(QPainter& painter, const MapViewTransform& view, const QRectF& rect,
               const BackdropStyle& style) const;

private:
    struct BackdropPart
    {
        WorldBounds bounds;
        std::vector<Point> points_m;
    };
    void paintShape(QPainter& painter, std::size_t i, const MapViewTransform& view,
                    const QRectF& wide, const BackdropStyle& style) const;
    void paintPlaces(QPainter& painter, const std::vector<std::size_t>& places,
                     const MapViewTransform& view, const BackdropStyle& style) const;

    BackdropPointer m_shapes;
    MapPlane m_plane;
    std::vector<std::vector<BackdropPart>> m_parts; ///< by shape
};

} // namespace berg
