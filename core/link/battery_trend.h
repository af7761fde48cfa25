#pragma once

#include "core/link/aircraft_state.h"

#include <deque>
#include <optional>

namespace berg {

/**
 * Estimates how long a battery lasts: the time that the autopilot reports, else one computed from
 * the charge reported over the last ten minutes.
 */
class BatteryTrend
{
public:
    /**
     * Adds a report, unless it has been added before. A charge that rises by more than 3 % is that
     * of another battery, and the trend begins again.
     */
    void add(const AircraftBattery& battery);

    /**
     * Returns the time after `now_s`, on the receiver's clock, until the battery is empty, at least
     * 0 s. Returns nullopt if nothing is reported, or too little to compute it: the charge must
     * have fallen by 2 % in a minute or more.
     */
    [[nodiscard]] std::optional<double> left_s(double now_s) const;
    /** Returns true if `left_s` is computed rather than reported. */
    [[nodiscard]] bool isComputed() const { return !m_reported_s; }

private:
    struct Charge
    {
        double time_s = 0;
        double remaining = 0; ///< 0 to 1
    };

    std::deque<Charge> m_charges;
    double m_received_s = -1;
    std::optional<double> m_reported_s; ///< as reported last
};

} // namespace berg
