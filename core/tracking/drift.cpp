#include "core/tracking/drift.h"

#include <cmath>

namespace berg {

DriftModel::DriftModel(const DriftSpec& spec, std::uint64_t seed, std::string_view id, bool noise)
    : m_start_m(spec.position_m)
    , m_start_s(spec.start_s)
    , m_velocity_mps(spec.velocity_mps)
    , m_deviation_m(noise ? std::sqrt(spec.q_m2ps) : 0.0)
    , m_random(seed, stableHash(id))
{
    drawStep();
}

void DriftModel::drawStep()
{
    if (m_deviation_m == 0)
        return;
    const double x = m_random.normal();
    const double y = m_random.normal();
    m_step_m = {m_deviation_m * x, m_deviation_m * y};
}

void DriftModel::nextSecond()
{
    m_noise_m += m_step_m;
    ++m_second;
    drawStep();
}

} // namespace berg
