#include "core/tracking/observer.h"

#include <cmath>

namespace berg {

FieldOfView::FieldOfView(const SensorSpec& sensor, const Point& centre_m, double psi_rad)
    : m_centre_m(centre_m)
    , m_along(sensor.shape == FovShape::North ? Point(0, 1)
                                              : Point(std::cos(psi_rad), std::sin(psi_rad)))
    , m_half_m(sensor.fov_m / 2)
    , m_disk(sensor.shape == FovShape::Disk)
{
}

double FieldOfView::reach_m(const SensorSpec& sensor)
{
    return sensor.shape == FovShape::Disk ? sensor.fov_m.x() / 2 : sensor.fov_m.norm() / 2;
}

bool FieldOfView::contains(const Point& p_m) const
{
    const Point d_m = p_m - m_centre_m;
    if (m_disk)
        return d_m.squaredNorm() <= m_half_m.x() * m_half_m.x();
    return std::abs(m_along.dot(d_m)) <= m_half_m.x() &&
           std::abs(cross(m_along, d_m)) <= m_half_m.y();
}

} // namespace berg
