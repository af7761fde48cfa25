#include "core/bound/sigma_floor.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

DriftVariances smaller(const DriftVariances& a, const DriftVariances& b)
{
    return {.position_m2 = std::min(a.position_m2, b.position_m2),
            .velocity_m2ps2 = std::min(a.velocity_m2ps2, b.velocity_m2ps2)};
}

} // namespace

SigmaFloor::SigmaFloor(const Scenario& scenario, const Iceberg& iceberg, const TrueMotion& motion)
{
    Track track = initialTrack(iceberg, ObserverModel::Kalman);
    m_process = track.process();
    m_given = track.variances();
    const std::int64_t perSample =
        std::max<std::int64_t>(1, std::llround(scenario.observer.interval_s / scenario.dt_s));
    const double variance_m2 = scenario.observer.positionSd_m * scenario.observer.positionSd_m;
    const std::int64_t appears = std::llround(iceberg.appears_s / scenario.dt_s);
    std::int64_t step = 0;
    std::int64_t sample = (appears + perSample - 1) / perSample * perSample;
    DriftVariances last = m_given;
    std::size_t complete = 0; // Edges before this one have their least variances.
    for (int edge = 0; edge <= motion.blocks(); ++edge) {
        m_least.push_back(last);
        bool isFirst = true;
        for (; sample <= motion.edgeStep(edge); sample += perSample) {
            track.grow(static_cast<double>(sample - step) * scenario.dt_s);
            step = sample;
            track.measured(track.anchor_m, variance_m2, track.anchor_s);
            last = track.variances();
            m_least.back() = isFirst ? last : smaller(m_least.back(), last);
            if (isFirst) // A known velocity may fade to the mean between two samples.
                for (; complete + 1 < m_least.size(); ++complete)
                    m_least[complete] = smaller(m_least[complete], last);
            complete = m_least.size();
            isFirst = false;
        }
    }
}

DriftVariances SigmaFloor::least(int from, int end) const
{
    DriftVariances least = m_least[static_cast<std::size_t>(from)];
    for (int edge = from + 1; edge <= end; ++edge)
        least = smaller(least, m_least[static_cast<std::size_t>(edge)]);
    least.mixed_m2ps = 0;
    return least;
}

double SigmaFloor::unseen_m2(double time_s) const
{
    return grown(m_given, m_process, time_s).position_m2;
}

FloorLine SigmaFloor::lineAt(const DriftVariances& least, double age_s, double most_s) const
{
    constexpr int kPieces = 2000;
    constexpr double kBeside_s = 1;
    FloorLine line{.slope_m2ps =
                       (seen_m2(least, age_s + kBeside_s) - seen_m2(least, age_s)) / kBeside_s,
                   .offset_m2 = -seen_m2(least, 0),
                   .least = least};
    // The curve never falls, so each piece is no lower than at its beginning.
    const double piece_s = most_s / kPieces;
    for (int k = 0; k < kPieces; ++k)
        line.offset_m2 = std::max(line.offset_m2, line.slope_m2ps * (k + 1) * piece_s -
                                                      seen_m2(least, k * piece_s));
    return line;
}

} // namespace berg
