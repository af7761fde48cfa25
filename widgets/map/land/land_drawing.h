#pragma once

#include "core/land/land_data.h"
#include "widgets/map/picture/map_plane.h"
#include "widgets/map/picture/map_view_transform.h"
#include "widgets/theme/theme.h"

#include <QPainterPath>

#include <optional>

class QPainter;

namespace berg {

/** Colours of land and sea. */
struct LandStyle
{
    QColor sea;
    QColor land;
    QColor coast;
    QColor beyond; ///< beyond the reach of the plane
    bool operator==(const LandStyle&) const = default;
};

/** Returns the land colours of `theme`. */
[[nodiscard]] LandStyle landStyleOf(const Theme& theme);

/** Returns the level of detail to draw at this scale. */
[[nodiscard]] LandDetail landDetailFor(double scale_pxpm);

/**
 * Land in one plane. A cell is projected and cached when it is first drawn; use a drawing on one
 * thread at a time.
 */
class LandDrawing
{
public:
    /** `data` must outlive the drawing. */
    LandDrawing(const LandData& data, const MapPlane& plane);

    /** Paints sea, land and coast in `rect`, and the area beyond the reach of the plane. */
    void paint(QPainter& painter, const MapViewTransform& view, const QRectF& rect,
               const LandStyle& style);

private:
    struct Ring
    {
        WorldBounds bounds;
        std::vector<Point> points_m;
        std::vector<bool>
            isCut; ///< whether the edge ending at each point was made by cutting cells
    };
    struct Cell
    {
        Eigen::Vector3d middle = Eigen::Vector3d::Zero(); ///< on the unit sphere
        double radius_rad = 0;
        std::optional<std::vector<Ring>> rings; ///< nullopt until projected
    };

    const std::vector<Ring>& projected(std::size_t cell);
    void addTo(QPainterPath& land, QPainterPath& coast, const Ring& ring,
               const MapViewTransform& view, const QRectF& rect) const;
    void paintBeyond(QPainter& painter, const MapViewTransform& view, const QRectF& rect,
                     const LandStyle& style) const;

    const LandData& m_data;
    MapPlane m_plane;
    Eigen::Vector3d m_middle;
    std::vector<Cell> m_cells; ///< by cell of the data
};

/**
 * Returns the disk within reach of the plane, on the screen; nullopt if it contains all of `rect`.
 */
[[nodiscard]] std::optional<QPainterPath> reachIn(const QRectF& rect, const MapPlane& plane,
                                                  const MapViewTransform& view);

/** Paints land and sea at once, without a cache. */
void paintLand(QPainter& painter, const MapPlane& plane, const MapViewTransform& view,
               const QRectF& rect, const LandStyle& style);

} // namespace berg
