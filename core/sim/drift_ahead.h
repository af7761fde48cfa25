#pragma once

#include "core/tracking/observer.h"

#include <memory>
#include <vector>

namespace berg {

/**
 * Predicted places of one iceberg from an instant on. If its mean velocity changes
 * (`DriftForcing`), the prediction follows it in steps of `kStep_s`, straight within each; else it
 * is that of the track. Places are computed on first use.
 */
class DriftAhead
{
public:
    static constexpr double kStep_s = 300;

    /** Predicts from run time `start_s` on; `forcing` may be null. */
    DriftAhead(const Track& track, std::shared_ptr<const DriftForcing> forcing, double start_s);

    /** Returns the place `after_s` >= 0 from the start. */
    [[nodiscard]] Point at_m(double after_s);
    /** Returns true if the place is that of a track with a constant velocity. */
    [[nodiscard]] bool isSteady() const { return !m_forcing && m_track.velocityTime_s == 0; }
    [[nodiscard]] const Track& track() const { return m_track; }

private:
    Track m_track;
    std::shared_ptr<const DriftForcing> m_forcing;
    double m_start_s;
    Track m_ahead;                 ///< prediction at the last of `m_places_m`
    std::vector<Point> m_places_m; ///< every `kStep_s` from the start on
};

} // namespace berg
