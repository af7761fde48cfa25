#include "core/sim/drift_ahead.h"

#include <cmath>
#include <utility>

namespace berg {

DriftAhead::DriftAhead(const Track& track, std::shared_ptr<const DriftForcing> forcing,
                       double start_s)
    : m_track(track), m_forcing(std::move(forcing)), m_start_s(start_s), m_ahead(track)
{
    if (m_forcing)
        m_places_m.push_back(track.estimate_m(start_s));
}

Point DriftAhead::at_m(double after_s)
{
    constexpr double kLongest_s = 604'800; // no run is longer; later places matter to nobody
    if (!m_forcing)
        return m_track.estimate_m(m_start_s + after_s);
    if (!(after_s < kLongest_s))
        after_s = kLongest_s;
    const double steps = after_s / kStep_s;
    const auto before = static_cast<std::size_t>(steps);
    while (m_places_m.size() < before + 2) {
        const double from_s = m_start_s + kStep_s * static_cast<double>(m_places_m.size() - 1);
        m_ahead.setMean(
            m_forcing->mean_mps(m_places_m.back(), DriftForcing::stepAt(from_s + kStep_s / 2)),
            from_s);
        m_places_m.push_back(m_ahead.estimate_m(from_s + kStep_s));
    }
    const Point& from_m = m_places_m[before];
    return from_m + (steps - static_cast<double>(before)) * (m_places_m[before + 1] - from_m);
}

} // namespace berg
