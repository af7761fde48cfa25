#include "core/vehicle/safety_guard.h"

#include "core/base/angles.h"

#include <array>
#include <cmath>

namespace berg {

namespace {

/** Left of the fence by commands that are not made for it. */
constexpr double kRoom_m = 2;
/** Turn rates tried instead, in parts of the limit. */
constexpr std::array<double, 9> kRates{-1, -0.75, -0.5, -0.25, 0, 0.25, 0.5, 0.75, 1};

} // namespace

DubinsState SafetyGuard::heldFor(const DubinsState& pose, double u_radps, std::int64_t steps) const
{
    DubinsState at = pose;
    for (std::int64_t i = 0; i < steps; ++i)
        at = step(at, m_uav.motion.airspeed_mps, u_radps, m_uav.clock.dt_s, m_uav.motion.wind_mps);
    return at;
}

/** What the fence has left after one command; negative when the fence can be left. */
double SafetyGuard::roomAfter_m(const DubinsState& pose, double u_radps) const
{
    DubinsState at = pose;
    for (std::int64_t i = 0; i < m_uav.clock.steps; ++i) {
        at = heldFor(at, u_radps, 1);
        if (m_uav.clock.steps > 1 && !m_uav.fence->contains(at.position_m))
            return -m_uav.fence->radius_m();
    }
    return m_uav.fence->room_m(at);
}

double SafetyGuard::limitedToFence_radps(const DubinsState& pose, double u_radps) const
{
    if (m_uav.fence == nullptr || roomAfter_m(pose, u_radps) >= kRoom_m)
        return u_radps;
    std::vector<double> rates{m_uav.fence->circlingRate_radps(pose, 1),
                              m_uav.fence->circlingRate_radps(pose, -1)};
    for (const double part : kRates)
        rates.push_back(part * m_uav.motion.limit_radps);
    double best_radps = u_radps;
    double best_m = roomAfter_m(pose, u_radps);
    for (const double rate_radps : rates) {
        const double room_m = roomAfter_m(pose, rate_radps);
        const bool nearer = std::abs(rate_radps - u_radps) < std::abs(best_radps - u_radps);
        if (best_m < kRoom_m ? room_m > best_m : room_m >= kRoom_m && nearer) {
            best_m = room_m;
            best_radps = rate_radps;
        }
    }
    return best_radps;
}

std::optional<Way> SafetyGuard::wayTo(const DubinsState& from, const MovingPlace& place) const
{
    return m_uav.fence != nullptr ? m_uav.fence->wayTo(from, place, m_uav.clock.command_s())
                                  : berg::wayTo(from, place, m_uav.motion, m_uav.clock.command_s());
}

std::optional<double> SafetyGuard::timeHome_s(const DubinsState& from) const
{
    const std::optional<Way> way = wayTo(from, {.place_m = m_uav.sortie->home_m});
    if (!way)
        return std::nullopt;
    // The fence may turn it aside once, and round a circle, where the way leads close by.
    return way->time_s + (m_uav.fence != nullptr ? m_uav.fence->circle_s() : 0);
}

bool SafetyGuard::homeInTimeAfter(const DubinsState& pose, double u_radps, double left_s) const
{
    const DubinsState after = heldFor(pose, u_radps, m_uav.clock.steps);
    const double after_s = left_s - m_uav.clock.command_s() - kHomeReserve_s;
    const Point& home_m = m_uav.sortie->home_m;
    const double longest_s =
        m_uav.fence != nullptr ? m_uav.fence->longestWay_s(after, home_m, m_uav.clock.command_s())
                               : longestWay_s(after, home_m, m_uav.motion, m_uav.clock.command_s());
    if (longest_s <= after_s)
        return true;
    const std::optional<double> home_s = timeHome_s(after);
    return home_s && *home_s <= after_s;
}

double SafetyGuard::homeRate_radps(const DubinsState& pose) const
{
    const std::optional<Way> way = wayTo(pose, {.place_m = m_uav.sortie->home_m});
    return way ? turnRateOf(*way, m_uav.motion, m_uav.clock.command_s()) : 0;
}

ReturnSearch SafetyGuard::search() const
{
    return {*m_uav.fence, m_uav.clock, m_uav.sortie->home_m};
}

double SafetyGuard::time_s(const ReturnPath& path) const
{
    return static_cast<double>(path.commands()) * m_uav.clock.command_s();
}

Outlook SafetyGuard::outlookAfter(const DubinsState& pose, double u_radps, double left_s) const
{
    const ReturnSearch paths = search();
    if (!paths.isInside(pose, u_radps, 1))
        return {};
    std::optional<ReturnPath> path = paths.quickPath(paths.after(pose, u_radps, 1));
    if (!path)
        return {};
    if (m_uav.clock.command_s() + time_s(*path) + kHomeReserve_s > left_s)
        return {.back = Return::Late};
    return {.back = Return::InTime, .path = std::move(path)};
}

std::optional<ReturnPath> SafetyGuard::returnPath(const DubinsState& pose) const
{
    return search().anyPath(pose);
}

std::optional<double> SafetyGuard::safeHeading_rad(const DubinsState& pose, double left_s) const
{
    constexpr int kHeadings = 36;
    const ReturnSearch paths = search();
    for (int k = 0; k <= kHeadings; ++k) {
        const int steps = (k % 2 == 1 ? 1 : -1) * ((k + 1) / 2); // right and left in turn
        const double offset_rad = steps * 2 * kPi / kHeadings;
        DubinsState turned = pose;
        turned.psi_rad = k == 0 ? pose.psi_rad : wrapPi(pose.psi_rad + offset_rad);
        const std::optional<ReturnPath> path = paths.quickPath(turned);
        if (path && time_s(*path) + kHomeReserve_s <= left_s)
            return turned.psi_rad;
    }
    return std::nullopt;
}

} // namespace berg
