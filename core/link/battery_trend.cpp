#include "core/link/battery_trend.h"

#include <algorithm>

namespace berg {

namespace {

constexpr double kChargeStep_s = 5; ///< Between two charges that are stored.
constexpr double kWindow_s = 600;
constexpr double kShortestWindow_s = 60;
constexpr double kLeastDrop = 0.02; ///< Charges are whole per cent.
constexpr double kOtherBattery = 0.03;

} // namespace

void BatteryTrend::add(const AircraftBattery& battery)
{
    if (battery.received_s <= m_received_s)
        return;
    m_received_s = battery.received_s;
    m_reported_s = battery.timeRemaining_s;
    if (!battery.remaining)
        return;
    if (!m_charges.empty() && *battery.remaining > m_charges.back().remaining + kOtherBattery)
        m_charges.clear();
    if (!m_charges.empty() && battery.received_s - m_charges.back().time_s < kChargeStep_s)
        return;
    m_charges.push_back({.time_s = battery.received_s, .remaining = *battery.remaining});
    while (m_charges.back().time_s - m_charges.front().time_s > kWindow_s)
        m_charges.pop_front();
}

std::optional<double> BatteryTrend::left_s(double now_s) const
{
    const double age_s = std::max(0.0, now_s - m_received_s);
    if (m_reported_s)
        return std::max(0.0, *m_reported_s - age_s);
    if (m_charges.empty())
        return std::nullopt;
    const Charge& first = m_charges.front();
    const Charge& last = m_charges.back();
    if (last.time_s - first.time_s < kShortestWindow_s ||
        first.remaining - last.remaining < kLeastDrop)
        return std::nullopt;
    // A line of least squares through all charges: their steps of one per cent average out.
    const auto count = static_cast<double>(m_charges.size());
    double time_s = 0;
    double remaining = 0;
    for (const Charge& charge : m_charges) {
        time_s += charge.time_s / count;
        remaining += charge.remaining / count;
    }
    double above = 0;
    double below = 0;
    for (const Charge& charge : m_charges) {
        above += (charge.time_s - time_s) * (charge.remaining - remaining);
        below += (charge.time_s - time_s) * (charge.time_s - time_s);
    }
    const double rate_1ps = above / below;
    if (rate_1ps >= 0)
        return std::nullopt;
    const double empty_s = time_s - remaining / rate_1ps;
    return std::max(0.0, empty_s - now_s);
}

} // namespace berg
