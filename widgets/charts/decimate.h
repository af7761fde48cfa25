#pragma once

#include <QList>
#include <QPointF>

#include <optional>
#include <span>

namespace berg {

/** Visible part of the x axis and its width in pixel columns. */
struct DecimationWindow
{
    double from = 0;
    double to = 1;
    int columns = 1;
};

/** Lowest and highest of a set of points. */
struct Extremes
{
    QPointF lowest;
    QPointF highest;

    /** Adds a point to the set. */
    void include(const QPointF& p)
    {
        if (p.y() < lowest.y())
            lowest = p;
        if (p.y() > highest.y())
            highest = p;
    }
};

/**
 * Reduces `points`, ascending in x, to at most two per pixel column: the lowest and the highest in
 * time order, so that no peak is lost. The first and last points in view and the nearest point on
 * either side are kept, so that lines reach the edges. Drops non-finite points. Cost: linear.
 */
[[nodiscard]] QList<QPointF> decimate(std::span<const QPointF> points,
                                      const DecimationWindow& window);

/**
 * Drops points within `tolerance` (in y) of the straight line between kept points, so that long
 * ramps become one segment. The first and last points are kept. Cost: linear.
 */
[[nodiscard]] QList<QPointF> simplified(const QList<QPointF>& points, double tolerance);

/** Interpolates a polyline ascending in x; nullopt if it does not reach `x`. */
[[nodiscard]] std::optional<QPointF> pointAt(const QList<QPointF>& points, double x);

} // namespace berg
