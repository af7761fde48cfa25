#include "core/tracking/view_window.h"

namespace berg {

namespace {

double narrowed(double half_m, double margin_m)
{
    return std::max(half_m - margin_m, half_m / 2);
}

/**
 * A view that turns is entered through its front, where a position error costs a moment and not the
 * sighting; the others are entered from any side.
 */
Point plannedHalf_m(const SensorSpec& sensor, double margin_m)
{
    const double front_m = sensor.shape == FovShape::Body ? margin_m / 3 : margin_m;
    const double x_m = narrowed(sensor.fov_m.x() / 2, front_m);
    return {x_m, sensor.shape == FovShape::Disk ? x_m : narrowed(sensor.fov_m.y() / 2, margin_m)};
}

} // namespace

ViewWindow::ViewWindow(const SensorSpec& sensor, double margin_m)
    : m_shape(sensor.shape)
    , m_half_m(plannedHalf_m(sensor, margin_m))
    , m_largestOffset_m(m_shape == FovShape::Body ? m_half_m.y() : m_half_m.minCoeff())
{
}

std::optional<ViewSpan> ViewWindow::crossingDisk(const Point& from_m, const Point& to_m) const
{
    const Point path_m = to_m - from_m;
    const double c = from_m.squaredNorm() - m_half_m.x() * m_half_m.x();
    const double a = path_m.squaredNorm();
    if (a == 0)
        return c <= 0 ? std::optional(ViewSpan{}) : std::nullopt;
    const double b = from_m.dot(path_m);
    const double discriminant = b * b - a * c;
    if (discriminant < 0)
        return std::nullopt;
    const double root = std::sqrt(discriminant);
    const ViewSpan span{.enter = std::max(0.0, (-b - root) / a),
                        .leave = std::min(1.0, (-b + root) / a)};
    return span.enter <= span.leave ? std::optional(span) : std::nullopt;
}

double ViewWindow::entry_m(const Point& ahead, double offset_m) const
{
    switch (m_shape) {
    case FovShape::Body:
        return m_half_m.x();
    case FovShape::Disk:
        return std::sqrt(std::max(0.0, m_half_m.x() * m_half_m.x() - offset_m * offset_m));
    case FovShape::North:
        break;
    }
    // In the view's axes, north and west, this is the point `entry_m` ahead and `offset_m` to the
    // left.
    const Point along(ahead.y(), -ahead.x());
    const Point left(-along.y(), along.x());
    double entry_m = reach_m();
    for (int axis = 0; axis < 2; ++axis)
        if (along[axis] != 0) {
            const double side = std::copysign(1.0, along[axis]);
            entry_m = std::min(entry_m, (m_half_m[axis] - side * left[axis] * offset_m) /
                                            std::abs(along[axis]));
        }
    return entry_m;
}

double viewMargin_m(double q_m2ps)
{
    constexpr double kLeast_m = 10;
    constexpr double kBetween_s = 300;
    return std::max(kLeast_m, 3 * std::sqrt(q_m2ps * kBetween_s));
}

} // namespace berg
