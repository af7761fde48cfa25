#include "core/tracking/drift.h"

#include <algorithm>
#include <cmath>

namespace berg {

Point RecordedTrack::at(double instant_s) const
{
    const auto next = std::upper_bound(time_s.begin(), time_s.end(), instant_s);
    if (next == time_s.begin())
        return position_m.front();
    if (next == time_s.end())
        return position_m.back();
    const auto i = static_cast<std::size_t>(next - time_s.begin());
    const double share = (instant_s - time_s[i - 1]) / (time_s[i] - time_s[i - 1]);
    return position_m[i - 1] + share * (position_m[i] - position_m[i - 1]);
}

DriftModel::DriftModel(const DriftSpec& spec, std::uint64_t seed, std::string_view id, bool noise)
    : m_track(spec.track)
    , m_start_m(spec.position_m)
    , m_start_s(spec.start_s)
    , m_velocity_mps(spec.velocity_mps)
    , m_deviation_m(noise && !spec.track ? std::sqrt(spec.q_m2ps) : 0.0)
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
