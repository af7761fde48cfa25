#pragma once

#include "core/geometry/geometry.h"

#include <QPointF>
#include <QPolygonF>
#include <QRectF>

#include <span>

namespace berg {

/** Axis-parallel box in the local plane, metres east and north. */
struct WorldBounds
{
    Point min_m = Point::Zero();
    Point max_m = Point::Zero();

    /** Enlarges the box to contain the point. */
    void include(const Point& p_m);
    [[nodiscard]] Point size_m() const { return max_m - min_m; }
    [[nodiscard]] Point centre_m() const { return 0.5 * (min_m + max_m); }
};

/** Returns the smallest box that contains the points; an empty box at the origin without points. */
[[nodiscard]] WorldBounds boundsOf(std::span<const Point> points_m);

/**
 * Map between the local plane (x east, y north, metres) and the screen (x right, y down,
 * device-independent pixels), north up, one scale for both axes.
 */
class MapViewTransform
{
public:
    MapViewTransform() = default;
    /** `centre_m` is shown at `centre_px`; `scale_pxpm` > 0 pixels for each metre. */
    MapViewTransform(const Point& centre_m, const QPointF& centre_px, double scale_pxpm);

    /**
     * Shows `bounds` as large as `target` allows, placed in it by `align`: (0, 0) left and top,
     * (0.5, 0.5) centred, (1, 1) right and bottom. Boxes smaller than `smallest_m` are shown as
     * if they were that large, so that one iceberg does not fill the screen.
     */
    [[nodiscard]] static MapViewTransform fitted(const WorldBounds& bounds, const QRectF& target,
                                                 const QPointF& align = {0.5, 0.5},
                                                 double smallest_m = 2500);

    [[nodiscard]] QPointF toPixel(const Point& p_m) const;
    [[nodiscard]] QPolygonF toPixels(std::span<const Point> points_m) const;
    [[nodiscard]] Point toWorld(const QPointF& p_px) const;
    [[nodiscard]] double scale_pxpm() const { return m_scale_pxpm; }
    /** Returns the part of the plane shown in `rect`. */
    [[nodiscard]] WorldBounds visible(const QRectF& rect) const;

    /** Returns the view scaled by `factor` > 0 with the place under `at_px` unmoved. */
    [[nodiscard]] MapViewTransform zoomed(double factor, const QPointF& at_px) const;
    /** Returns the view shifted by `offset_px`. */
    [[nodiscard]] MapViewTransform moved(const QPointF& offset_px) const;

    bool operator==(const MapViewTransform&) const = default;

private:
    Point m_centre_m = Point::Zero();
    QPointF m_centre_px;
    double m_scale_pxpm = 1;
};

} // namespace berg
