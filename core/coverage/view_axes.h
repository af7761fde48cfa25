#pragma once

#include "core/tracking/view_window.h"
#include "core/vehicle/tangent_turn.h"

namespace berg {

/** Axes of the view at one instant. */
struct ViewAxes
{
    Point origin_m;
    Point x;

    /** Returns a point in axes of the view, in metres from the UAV. */
    [[nodiscard]] Point coordinates(const Point& p_m) const
    {
        const Point d_m = p_m - origin_m;
        return {x.dot(d_m), cross(x, d_m)};
    }
};

/** Returns the axes of a view: x points ahead of the UAV if the view turns with it, else north. */
inline ViewAxes axesOf(const ViewWindow& window, const Pose& uav)
{
    return {.origin_m = uav.position_m, .x = window.turns() ? uav.ahead : Point(0, 1)};
}

} // namespace berg
