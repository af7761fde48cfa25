#include "core/tracking/observer.h"

#include "core/base/random.h"

#include <algorithm>
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

double surelySeen_m(const SensorSpec& sensor)
{
    return (sensor.shape == FovShape::Disk ? sensor.fov_m.x() : sensor.fov_m.minCoeff()) / 2;
}

bool FieldOfView::contains(const Point& p_m) const
{
    const Point d_m = p_m - m_centre_m;
    if (m_disk)
        return d_m.squaredNorm() <= m_half_m.x() * m_half_m.x();
    return std::abs(m_along.dot(d_m)) <= m_half_m.x() &&
           std::abs(cross(m_along, d_m)) <= m_half_m.y();
}

Point Track::fadedEstimate_m(double time_s) const
{
    return anchor_m + mean_mps * (time_s - anchor_s) +
           (velocity_mps - mean_mps) * carriedFor_s(velocityTime_s, time_s - anchor_s);
}

void Track::setMean(const std::optional<Point>& mean, double time_s)
{
    Point newMean_mps = Point::Zero();
    Point newVelocity_mps = Point::Zero();
    if (mean) {
        if (*mean == mean_mps)
            return;
        newMean_mps = *mean;
        newVelocity_mps = *mean + (velocity_mps - mean_mps);
    } else if (!(velocityTime_s > 0)) {
        // The known velocity above the mean is kept for the case that the iceberg floats after all.
        newMean_mps = mean_mps - velocity_mps;
    }
    if (newMean_mps == mean_mps && newVelocity_mps == velocity_mps)
        return;
    anchor_m = estimate_m(time_s);
    anchor_s = time_s;
    velocity_mps = newVelocity_mps;
    mean_mps = newMean_mps;
}

void Track::moveOn(double dt_s)
{
    anchor_m = estimate_m(anchor_s + dt_s);
    anchor_s += dt_s;
    velocity_mps = mean_mps + (velocity_mps - mean_mps) * std::exp(-dt_s / velocityTime_s);
    setVariances(grown(variances(), process(), dt_s));
}

void Track::measured(const Point& position_m, double variance_m2, double time_s)
{
    const Point predicted_m = estimate_m(time_s);
    const double innovation_m2 = sigma_m2 + variance_m2;
    anchor_s = time_s;
    seen_s = time_s;
    if (!(innovation_m2 > 0)) { // both are exact, so the measurement is the position
        anchor_m = position_m;
        return;
    }
    const double positionGain = sigma_m2 / innovation_m2;
    const double velocityGain_1ps = mixed_m2ps / innovation_m2;
    anchor_m = predicted_m + positionGain * (position_m - predicted_m);
    velocity_mps += velocityGain_1ps * (position_m - predicted_m);
    // In this form rounding cannot make a variance negative.
    sigma_m2 = positionGain * variance_m2;
    velocity_m2ps2 = std::max(0.0, velocity_m2ps2 - velocityGain_1ps * mixed_m2ps);
    mixed_m2ps *= variance_m2 / innovation_m2;
}

SampleDraw sampleDraw(std::uint64_t seed, std::uint64_t stream, std::int64_t sample)
{
    // The golden ratio of 2^64 separates the streams of consecutive samples.
    Random random(seed, stream ^ (static_cast<std::uint64_t>(sample + 1) * 0x9e3779b97f4a7c15ULL));
    const double chance = random.uniform();
    const double x = random.normal();
    const double y = random.normal();
    return {.chance = chance, .noise = {x, y}};
}

} // namespace berg
