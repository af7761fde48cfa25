#include "core/tracking/drift.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace berg {

namespace {

/** Below this fraction of the velocity time the closed forms lose digits; the series does not. */
constexpr double kSeriesBelow = 0.05;

/** Integrals of e(x) = 1 - exp(-x), each from 0 to x. */
struct FadeIntegrals
{
    double carried = 0; ///< e itself
    double first = 0;   ///< integral of e
    double second = 0;  ///< integral of e^2
    double third = 0;   ///< integral of `second`
};

/** Returns the sum of c[k] x^k (Horner's scheme) times `factor`. */
template <std::size_t Count>
double series(const double (&c)[Count], double x, double factor)
{
    double sum = 0;
    for (std::size_t k = Count; k-- > 0;)
        sum = sum * x + c[k];
    return sum * factor;
}

FadeIntegrals fadeIntegrals(double x)
{
    const double e = -std::expm1(-x);
    if (x >= kSeriesBelow)
        return {.carried = e,
                .first = x - e,
                .second = x - e - e * e / 2,
                .third = (x * x - 3 * x + 3 * e + e * e / 2) / 2};
    // e = x - x^2/2 + ..., e^2 = sum of (-1)^n (2 - 2^n) x^n / n!
    constexpr double kFirst[] = {1.0 / 2, -1.0 / 6, 1.0 / 24, -1.0 / 120, 1.0 / 720, -1.0 / 5040};
    constexpr double kSecond[] = {1.0 / 3, -1.0 / 4, 7.0 / 60, -1.0 / 24, 31.0 / 2520, -1.0 / 320};
    constexpr double kThird[] = {1.0 / 12,   -1.0 / 20,    7.0 / 360,
                                 -1.0 / 168, 31.0 / 20160, -1.0 / 2880};
    return {.carried = e,
            .first = series(kFirst, x, x * x),
            .second = series(kSecond, x, x * x * x),
            .third = series(kThird, x, x * x * x * x)};
}

} // namespace

double carriedFor_s(double velocityTime_s, double dt_s)
{
    return velocityTime_s > 0 ? -velocityTime_s * std::expm1(-dt_s / velocityTime_s) : dt_s;
}

DriftVariances grown(const DriftVariances& now, const DriftProcess& process, double dt_s)
{
    const double t_s = process.velocityTime_s;
    if (!(t_s > 0))
        return {.position_m2 =
                    now.position_m2 + (process.q_m2ps * dt_s +
                                       dt_s * (2 * now.mixed_m2ps + dt_s * now.velocity_m2ps2)),
                .mixed_m2ps = now.mixed_m2ps + dt_s * now.velocity_m2ps2,
                .velocity_m2ps2 = now.velocity_m2ps2};
    const FadeIntegrals fade = fadeIntegrals(dt_s / t_s);
    const double carried_s = t_s * fade.carried;
    const double kept = 1 - fade.carried;
    const double spread_m2ps2 = process.velocitySpread_mps * process.velocitySpread_mps;
    // The noise that maintains the spread is 2 S^2 / T per second; its share of P is that of e^2
    // over T.
    return {.position_m2 = now.position_m2 + process.q_m2ps * dt_s +
                           carried_s * (2 * now.mixed_m2ps + carried_s * now.velocity_m2ps2) +
                           2 * spread_m2ps2 * t_s * t_s * fade.second,
            .mixed_m2ps = kept * (now.mixed_m2ps + carried_s * now.velocity_m2ps2) +
                          spread_m2ps2 * t_s * fade.carried * fade.carried,
            .velocity_m2ps2 =
                kept * kept * now.velocity_m2ps2 + spread_m2ps2 * fade.carried * (1 + kept)};
}

double positionIntegral_m2s(const DriftVariances& now, const DriftProcess& process, double dt_s)
{
    const double white_m2s =
        dt_s * (now.position_m2 + (now.position_m2 + process.q_m2ps * dt_s)) / 2;
    const double t_s = process.velocityTime_s;
    if (!(t_s > 0))
        return white_m2s + dt_s * dt_s * (now.mixed_m2ps + dt_s * now.velocity_m2ps2 / 3);
    const FadeIntegrals fade = fadeIntegrals(dt_s / t_s);
    const double spread_m2ps2 = process.velocitySpread_mps * process.velocitySpread_mps;
    return white_m2s +
           t_s * t_s *
               (2 * now.mixed_m2ps * fade.first +
                t_s * (now.velocity_m2ps2 * fade.second + 2 * spread_m2ps2 * fade.third));
}

VelocityStep velocityStep(const DriftProcess& process, double dt_s)
{
    if (!(process.velocityTime_s > 0))
        return {.carried_s = dt_s};
    const DriftVariances added = grown({},
                                       {.velocitySpread_mps = process.velocitySpread_mps,
                                        .velocityTime_s = process.velocityTime_s},
                                       dt_s);
    VelocityStep step{.kept = std::exp(-dt_s / process.velocityTime_s),
                      .carried_s = carriedFor_s(process.velocityTime_s, dt_s)};
    if (!(added.velocity_m2ps2 > 0))
        return step;
    step.velocity_mps = std::sqrt(added.velocity_m2ps2);
    step.shared_m = added.mixed_m2ps / step.velocity_mps;
    step.place_m = std::sqrt(std::max(0.0, added.position_m2 - step.shared_m * step.shared_m));
    return step;
}

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
    : DriftNoise(seed, stableHash(id))
{
    if (seconds == 0)
        return;
    std::vector<Point> drawn(seconds);
    std::generate(drawn.begin(), drawn.end(), [this] { return draw(); });
    m_drawn = std::make_shared<const std::vector<Point>>(std::move(drawn));
}

DriftNoise::DriftNoise(std::uint64_t seed, std::uint64_t stream)
    : m_seed(seed), m_stream(stream), m_random(m_seed, m_stream)
{
}

DriftNoise DriftNoise::velocityStream() const
{
    static const std::uint64_t kVelocity = stableHash("velocity");
    return {m_seed, m_stream ^ kVelocity};
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
    , m_forcing(spec.track ? nullptr : spec.forcing)
    , m_mean_mps(spec.mean_mps)
    , m_own_mps(spec.velocity_mps - spec.mean_mps)
    , m_start_m(spec.position_m)
    , m_start_s(spec.start_s)
    , m_velocity_mps(spec.velocity_mps)
    , m_deviation_m(noise && !spec.track ? std::sqrt(spec.q_m2ps) : 0.0)
    , m_isStepped(m_deviation_m != 0 || m_forcing)
    , m_velocitySource(source.velocityStream())
    , m_source(std::move(source))
{
    if (!spec.track && spec.velocityTime_s > 0) {
        m_velocity_mps = spec.mean_mps;
        m_own_mps = Point::Zero();
        m_nextExcess_mps = spec.velocity_mps - spec.mean_mps;
        m_fade = velocityStep({.velocitySpread_mps = noise ? spec.velocitySpread_mps : 0,
                               .velocityTime_s = spec.velocityTime_s},
                              1);
        m_isStepped = true;
    }
    if (m_forcing) {
        m_forcingStep = DriftForcing::stepAt(m_start_s) - 1;
        followForcing();
    }
    drawStep();
}

/** Changes the mean velocity at the beginning of a step, or stops an iceberg that is aground. */
void DriftModel::followForcing()
{
    const auto age_s = static_cast<double>(m_second);
    const std::int64_t step = DriftForcing::stepAt(m_start_s + age_s);
    if (m_isAground || step == m_forcingStep)
        return;
    m_forcingStep = step;
    const Point base_m = m_start_m + m_velocity_mps * (age_s - m_base_s);
    const std::optional<Point> mean_mps = m_forcing->mean_mps(base_m + m_noise_m, step);
    if (mean_mps == m_mean_mps)
        return;
    m_base_s = age_s;
    m_start_m = base_m;
    if (mean_mps) {
        m_mean_mps = *mean_mps;
        m_velocity_mps = m_own_mps + m_mean_mps;
        return;
    }
    m_isAground = true;
    m_start_m += m_noise_m;
    m_noise_m = m_velocity_mps = m_mean_mps = Point::Zero();
    m_excess_mps = m_nextExcess_mps = Point::Zero();
}

Point DriftModel::aheadAt(double time_s) const
{
    DriftModel ahead = *this;
    return ahead.position_m(time_s);
}

double DriftModel::speedLimit_mps() const
{
    if (m_track || m_fade.velocity_mps > 0)
        return std::numeric_limits<double>::infinity();
    const double steady_mps =
        m_forcing ? m_own_mps.norm() + m_forcing->fastest_mps() : m_velocity_mps.norm();
    return m_nextExcess_mps.norm() + steady_mps +
           m_deviation_m * DriftNoise::kLargest * std::numbers::sqrt2;
}

void DriftModel::drawStep()
{
    if (m_isAground) {
        m_step_m = Point::Zero();
        return;
    }
    if (m_deviation_m != 0)
        m_step_m = m_deviation_m * m_source.next();
    else
        m_step_m = Point::Zero();
    m_excess_mps = m_nextExcess_mps;
    if (m_fade.kept == 1)
        return;
    m_step_m += m_fade.carried_s * m_excess_mps;
    m_nextExcess_mps = m_fade.kept * m_excess_mps;
    if (m_fade.velocity_mps == 0)
        return;
    const Point velocity = m_velocitySource.next();
    const Point place = m_velocitySource.next();
    m_step_m += m_fade.shared_m * velocity + m_fade.place_m * place;
    m_nextExcess_mps += m_fade.velocity_mps * velocity;
}

void DriftModel::nextSecond()
{
    m_noise_m += m_step_m;
    ++m_second;
    if (m_forcing)
        followForcing();
    drawStep();
}

} // namespace berg
