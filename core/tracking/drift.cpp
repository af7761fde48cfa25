#include "core/tracking/drift.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

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

DriftNoise::DriftNoise(std::uint64_t seed, std::string_view id, std::size_t seconds)
    : m_seed(seed), m_stream(stableHash(id)), m_random(m_seed, m_stream)
{
    if (seconds == 0)
        return;
    std::vector<Point> drawn(seconds);
    std::generate(drawn.begin(), drawn.end(), [this] { return draw(); });
    m_drawn = std::make_shared<const std::vector<Point>>(std::move(drawn));
}

Point DriftNoise::draw()
{
    const double x = m_random.normal();
    const double y = m_random.normal();
    return {x, y};
}

DriftModel::DriftModel(const DriftSpec& spec, std::uint64_t seed, std::string_view id, bool noise)
    : DriftModel(spec, DriftNoise(seed, id), noise)
{
}

DriftModel::DriftModel(const DriftSpec& spec, DriftNoise source, bool noise)
    : m_track(spec.track)
    , m_start_m(spec.position_m)
    , m_start_s(spec.start_s)
    , m_velocity_mps(spec.velocity_mps)
    , m_deviation_m(noise && !spec.track ? std::sqrt(spec.q_m2ps) : 0.0)
    , m_source(std::move(source))
{
    drawStep();
}

Point DriftModel::aheadAt(double time_s) const
{
    DriftModel ahead = *this;
    return ahead.position_m(time_s);
}

double DriftModel::speedLimit_mps() const
{
    if (m_track)
        return std::numeric_limits<double>::infinity();
    return m_velocity_mps.norm() + m_deviation_m * DriftNoise::kLargest * std::numbers::sqrt2;
}

void DriftModel::drawStep()
{
    if (m_deviation_m != 0)
        m_step_m = m_deviation_m * m_source.next();
}

void DriftModel::nextSecond()
{
    m_noise_m += m_step_m;
    ++m_second;
    drawStep();
}

} // namespace berg
