#pragma once

#include "widgets/map/land/land_data.h"
#include "widgets/map/picture/map_plane.h"
#include "widgets/map/picture/map_view_transform.h"
#include "widgets/theme/theme.h"

#include <QPainterPath>

#include <optional>

class QPainter;

namespace berg {

/** Colours of land and sea. */
struct LandLook
{
    QColor sea;
    QColor land;
    QColor coast;
    QColor beyond; ///< what is out of reach
    bool operator==(const LandLook&) const = default;
};

[[nodiscard]] LandLook landLookOf(const Theme& theme);

/** The detail that is drawn at this scale. */
[[nodiscard]] LandDetail landDetailFor(double scale_pxpm);

/**
 * The land in one plane. Projects a cell when it is first drawn and keeps it; a drawing belongs to
 * one thread at a time.
 */
class LandDrawing
{
public:
    /** `data` must outlive the drawing. */
    LandDrawing(const LandData& data, const MapPlane& plane);

    /** Sea, land and coast in `rect`, and what is out of reach. */
    void paint(QPainter& painter, const MapViewTransform& view, const QRectF& rect,
               const LandLook& look);

private:
    struct Ring
    {
        WorldBounds bounds;
        std::vector<Point> points_m;
        std::vector<bool> isCut; ///< the edge that ends in the point
    };
    struct Cell
    {
        Eigen::Vector3d middle = Eigen::Vector3d::Zero(); ///< on the unit sphere
        double radius_rad = 0;
        std::optional<std::vector<Ring>> rings; ///< none: not projected yet
    };

    const std::vector<Ring>& projected(std::size_t cell);
    void addTo(QPainterPath& land, QPainterPath& coast, const Ring& ring,
               const MapViewTransform& view, const QRectF& rect) const;
    void paintBeyond(QPainter& painter, const MapViewTransform& view, const QRectF& rect,
                     const LandLook& look) const;

    const LandData& m_data;
    MapPlane m_plane;
    Eigen::Vector3d m_middle;
    std::vector<Cell> m_cells; ///< by cell of the data
};

/** The disk that is within reach, on the screen; none: there is nothing else in `rect`. */
[[nodiscard]] std::optional<QPainterPath> reachIn(const QRectF& rect, const MapPlane& plane,
                                                  const MapViewTransform& view);

/** Draws land and sea here and now. */
void paintLand(QPainter& painter, const MapPlane& plane, const MapViewTransform& view,
               const QRectF& rect, const LandLook& look);

} // namespace berg
