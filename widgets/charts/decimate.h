#pragma once

#include <QList>
#include <QPointF>

#include <optional>
#include <span>

namespace berg {

/** The part of the x axis on screen and how many pixel columns show it. */
struct DecimationWindow
{
    double from = 0;
    double to = 1;
    int columns = 1;
};

/** Lowest and highest of some points. */
struct Extremes
{
    QPointF lowest;
    QPointF highest;

    void include(const QPointF& p)
    {
        if (p.y() < lowest.y())
            lowest = p;
        if (p.y() > highest.y())
            highest = p;
    }
};

/**
 * At most two points for each pixel column, the lowest and the highest in the order of time, so
 * that no peak is lost; the first and last points in view are kept, and so is the nearest point on
 * either side of the view, so that lines run to its edges. Points that are not finite are dropped.
 * `points` ascending in x. Cost: linear.
 */
[[nodiscard]] QList<QPointF> decimate(std::span<const QPointF> points,
                                      const DecimationWindow& window);

/**
 * Leaves out points that lie within `tolerance` (in y) of the straight line between those kept, so
 * that long ramps become one segment. First and last point are kept. Cost: linear.
 */
[[nodiscard]] QList<QPointF> simplified(const QList<QPointF>& points, double tolerance);

/** The polyline at an abscissa it reaches; `points` ascending in x. */
[[nodiscard]] std::optional<QPointF> pointAt(const QList<QPointF>& points, double x);

} // namespace berg
