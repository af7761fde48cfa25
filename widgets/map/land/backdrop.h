#pragma once

#include "core/io/import/map_shapes.h"
#include "widgets/map/picture/map_plane.h"
#include "widgets/map/picture/map_view_transform.h"
#include "widgets/theme/theme.h"

#include <memory>
#include <vector>

class QPainter;

namespace berg {

/** What a file of the user draws below the map: an ice chart, routes, borders. */
using BackdropShapes = std::vector<MapShape>;
using BackdropPointer = std::shared_ptr<const BackdropShapes>;

/** Of shapes without a colour of their own. */
struct BackdropLook
{
    QColor ink;
    QColor ground; ///< round names
    QFont font;
    bool isNight = false; ///< colours of the shapes' own are shown in red
    bool operator==(const BackdropLook&) const = default;
};

[[nodiscard]] BackdropLook backdropLookOf(const Theme& theme);

/** A backdrop in one plane, projected once. A drawing belongs to one thread at a time. */
class BackdropDrawing
{
public:
    BackdropDrawing(BackdropPointer shapes, const MapPlane& plane);

    [[nodiscard]] bool isOf(const BackdropPointer& shapes, const MapPlane& plane) const
    {
        return shapes == m_shapes && plane == m_plane;
    }
    void paint(QPainter& painter, const MapViewTransform& view, const QRectF& rect,
               const BackdropLook& look) const;

private:
    struct Part
    {
        WorldBounds bounds;
        std::vector<Point> points_m;
    };
    void paintShape(QPainter& painter, std::size_t i, const MapViewTransform& view,
                    const QRectF& wide, const BackdropLook& look) const;
    void paintPlaces(QPainter& painter, const std::vector<std::size_t>& places,
                     const MapViewTransform& view, const BackdropLook& look) const;

    BackdropPointer m_shapes;
    MapPlane m_plane;
    std::vector<std::vector<Part>> m_parts; ///< by shape
};

} // namespace berg
