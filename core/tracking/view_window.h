#pragma once

#include "core/tracking/observer.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace berg {

/** Part of a straight line, as fractions of its length. */
struct ViewSpan
{
    double enter = 0;
    double leave = 1;
};

/**
 * The field of view as planners need it: it finds when a point that moves past the UAV is in view.
 * Points are in the view's own axes, m (`x` along the first extent, `y` to its left, UAV at the
 * origin).
 */
class ViewWindow
{
public:
    /**
     * Makes a view that is `margin_m` narrower on each side than the sensor, but at least half as
     * wide. A view that turns with the UAV is narrowed by only a third of the margin in front and
     * behind.
     */
    ViewWindow(const SensorSpec& sensor, double margin_m);

    /**
     * Returns the view for a point whose position is uncertain by `deviation_m`: it is that much
     * smaller on each side, but by a quarter at most.
     */
    [[nodiscard]] ViewWindow narrowed(double deviation_m) const
    {
        ViewWindow narrow = *this;
        narrow.m_half_m -= (kMostNarrowed * m_half_m).cwiseMin(deviation_m);
        narrow.m_largestOffset_m =
            m_shape == FovShape::Body ? narrow.m_half_m.y() : narrow.m_half_m.minCoeff();
        return narrow;
    }

    /** Returns the middle `share` (0 to 1) of the view. */
    [[nodiscard]] ViewWindow scaled(double share) const
    {
        ViewWindow part = *this;
        part.m_half_m *= share;
        part.m_largestOffset_m *= share;
        return part;
    }

    /** Returns whether the axes turn with the UAV. */
    [[nodiscard]] bool turns() const { return m_shape == FovShape::Body; }
    [[nodiscard]] FovShape shape() const { return m_shape; }
    /** Returns the half extents, m; those of a disk are equal. */
    [[nodiscard]] const Point& half_m() const { return m_half_m; }
    /** Returns the distance, m, beyond which no point is in view. */
    [[nodiscard]] double reach_m() const
    {
        return m_shape == FovShape::Disk ? m_half_m.x() : m_half_m.norm();
    }
    /**
     * Returns the largest distance, m, at which a line that passes a point brings it into view, on
     * any course.
     */
    [[nodiscard]] double largestOffset_m() const { return m_largestOffset_m; }

    /** Returns whether the point, in the view's axes, is in view. */
    [[nodiscard]] bool contains(const Point& p_m) const
    {
        if (m_shape == FovShape::Disk)
            return p_m.squaredNorm() <= m_half_m.x() * m_half_m.x();
        return std::abs(p_m.x()) <= m_half_m.x() && std::abs(p_m.y()) <= m_half_m.y();
    }

    /**
     * Returns the part of the straight line between the two points that is in view; nullopt if none
     * is.
     */
    [[nodiscard]] std::optional<ViewSpan> crossing(const Point& from_m, const Point& to_m) const
    {
        if (m_shape == FovShape::Disk)
            return crossingDisk(from_m, to_m);
        for (int axis = 0; axis < 2; ++axis)
            if ((from_m[axis] > m_half_m[axis] && to_m[axis] > m_half_m[axis]) ||
                (from_m[axis] < -m_half_m[axis] && to_m[axis] < -m_half_m[axis]))
                return std::nullopt;
        return inside_m(from_m, to_m) >= 0 ? std::optional(ViewSpan{})
                                           : crossingRectangle(from_m, to_m);
    }

    /**
     * Returns the distance, m, of the whole line from the edge of the view; negative if part of the
     * line is outside, or if the view is a disk.
     */
    [[nodiscard]] double inside_m(const Point& from_m, const Point& to_m) const
    {
        if (m_shape == FovShape::Disk)
            return -1;
        const double x_m = std::max(std::abs(from_m.x()), std::abs(to_m.x()));
        const double y_m = std::max(std::abs(from_m.y()), std::abs(to_m.y()));
        return std::min(m_half_m.x() - x_m, m_half_m.y() - y_m);
    }

    /**
     * Returns how far, m, before abeam a point comes into view that is passed on a straight course
     * `ahead` (a unit vector, east and north) and lies `offset_m` left of it.
     */
    [[nodiscard]] double entry_m(const Point& ahead, double offset_m) const;

private:
    [[nodiscard]] std::optional<ViewSpan> crossingRectangle(const Point& from_m,
                                                            const Point& to_m) const
    {
        ViewSpan span;
        for (int axis = 0; axis < 2; ++axis) {
            const double path_m = to_m[axis] - from_m[axis];
            if (path_m == 0) {
                if (std::abs(from_m[axis]) > m_half_m[axis])
                    return std::nullopt;
                continue;
            }
            const double a = (-m_half_m[axis] - from_m[axis]) / path_m;
            const double b = (m_half_m[axis] - from_m[axis]) / path_m;
            span.enter = std::max(span.enter, std::min(a, b));
            span.leave = std::min(span.leave, std::max(a, b));
        }
        return span.enter <= span.leave ? std::optional(span) : std::nullopt;
    }
    [[nodiscard]] std::optional<ViewSpan> crossingDisk(const Point& from_m,
                                                       const Point& to_m) const;

    /** Limit of `narrowed`; smaller views would make first passes slow. */
    static constexpr double kMostNarrowed = 0.25;

    FovShape m_shape;
    Point m_half_m;
    double m_largestOffset_m;
};

/**
 * Returns the margin, m, by which a planned view is narrower than the sensor, so that a drift of
 * `q_m2ps` over the minutes between plan and sighting does not carry an iceberg past its edge.
 */
[[nodiscard]] double viewMargin_m(double q_m2ps);

} // namespace berg
