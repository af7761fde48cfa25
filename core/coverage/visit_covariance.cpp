#include "core/coverage/visit_covariance.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

/** Longest time in view that is treated as one step; with 5 s sigma is right within 0.4 %. */
constexpr double kLongestPart_s = 10;
/** Measurements with less noise than this count as this good. */
constexpr double kLeastSd_m = 0.01;
/** Time in view, in the mean, of an iceberg that is found again. */
constexpr double kFound_s = 10;

/** A measurement of the position with this information (1 / variance). */
void measurePosition(DriftVariances& known, double information_1pm2)
{
    const double gain = 1 / (1 + known.position_m2 * information_1pm2);
    known.position_m2 *= gain;
    known.velocity_m2ps2 -= known.mixed_m2ps * known.mixed_m2ps * information_1pm2 * gain;
    known.mixed_m2ps *= gain;
}

/** Takes in a measurement of the velocity with this information, s2/m2. */
void measureVelocity(DriftVariances& known, double information_s2pm2)
{
    const double gain = 1 / (1 + known.velocity_m2ps2 * information_s2pm2);
    known.position_m2 -= known.mixed_m2ps * known.mixed_m2ps * information_s2pm2 * gain;
    known.mixed_m2ps *= gain;
    known.velocity_m2ps2 *= gain;
}

} // namespace

VisitCovariance::VisitCovariance(const Track& track, const ObserverSpec& observer, double weight)
    : m_start{.position_m2 = weight * track.sigma_m2,
              .mixed_m2ps = weight * track.mixed_m2ps,
              .velocity_m2ps2 = weight * track.velocity_m2ps2}
    , m_process{.q_m2ps = weight * track.q_m2ps,
                .velocitySpread_mps = std::sqrt(weight) * track.velocitySpread_mps,
                .velocityTime_s = track.velocityTime_s}
    , m_weight(weight)
{
    if (observer.model == ObserverModel::Simple)
        return;
    const double sd_m = std::max(observer.positionSd_m, kLeastSd_m);
    m_information_1pm2s = observer.detection / (observer.interval_s * sd_m * sd_m * weight);
}

/**
 * Applies the information of a visit in n steps. Each step takes the information of its samples at
 * its middle: about the position there and, since the samples are spread over the step, about the
 * velocity. Between the samples sigma is P / (1 + P L t), whose integral is a logarithm; the growth
 * within the step is added as a triangle.
 */
double VisitCovariance::filter(DriftVariances& known, double seen_s) const
{
    if (!(seen_s > 0))
        return 0;
    const double steps = seen_s > kLongestPart_s ? std::ceil(seen_s / kLongestPart_s) : 1;
    const double step_s = steps > 1 ? seen_s / steps : seen_s;
    const double information_1pm2 = m_information_1pm2s * step_s;
    double product = 1;
    double grown_m2s = 0;
    DriftVariances now = known; // A local copy stays in registers.
    for (double k = 0; k < steps; ++k) {
        const double factor = 1 + now.position_m2 * information_1pm2;
        product *= factor;
        const double still_m2 = now.position_m2 / factor;
        grow(now, step_s / 2);
        measurePosition(now, information_1pm2);
        measureVelocity(now, information_1pm2 * step_s * step_s / 12);
        grow(now, step_s / 2);
        grown_m2s += (now.position_m2 - still_m2) * step_s / 2;
    }
    known = now;
    return grown_m2s + std::log(product) / m_information_1pm2s;
}

void VisitCovariance::searchLost(DriftVariances& known, double chance) const
{
    DriftVariances found = known;
    sample(found, kFound_s);
    known.position_m2 += chance * (found.position_m2 - known.position_m2);
    known.mixed_m2ps += chance * (found.mixed_m2ps - known.mixed_m2ps);
    known.velocity_m2ps2 += chance * (found.velocity_m2ps2 - known.velocity_m2ps2);
}

} // namespace berg
