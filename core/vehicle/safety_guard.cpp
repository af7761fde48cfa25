#include "core/vehicle/safety_guard.h"

#include "core/base/angles.h"
#include "core/vehicle/los_guidance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace berg {

namespace {

/** Clearance that ordinary commands keep from the fence. */
constexpr double kClearance_m = 2;
/** Turn rates tried in place of the requested one, as fractions of the limit. */
constexpr std::array<double, 9> kRates{-1, -0.75, -0.5, -0.25, 0, 0.25, 0.5, 0.75, 1};
/** Time between two attempts to take off while no heading is safe. */
constexpr double kNextTry_s = 60;
/** Winds are weighed until this time after the endurance: the next weighing is that far away. */
constexpr double kWeighed_s = 120;

/** Returns the speed over ground on a course that the UAV keeps in this wind. */
double speedOver_mps(const Motion& motion, const Point& course)
{
    const double across_mps = cross(course, motion.wind_mps);
    return course.dot(motion.wind_mps) +
           std::sqrt(
               std::max(0.0, motion.airspeed_mps * motion.airspeed_mps - across_mps * across_mps));
}

/** Returns the motions in the winds at the corners of a range. */
std::vector<Motion> windCorners(const WindRange& range, const Motion& motion, double strongest_mps)
{
    std::vector<Motion> corners;
    for (const double east_mps : {range.low_mps.x(), range.high_mps.x()})
        for (const double north_mps : {range.low_mps.y(), range.high_mps.y()}) {
            corners.push_back(motion);
            corners.back().wind_mps = {east_mps, north_mps};
            if (corners.back().wind_mps.norm() < motion.airspeed_mps)
                continue;
            // No wind is that strong; in any wind the UAV makes at least this speed.
            Motion slowest = motion;
            slowest.airspeed_mps -= std::min(strongest_mps, 0.99 * motion.airspeed_mps);
            slowest.wind_mps = Point::Zero();
            return {slowest};
        }
    return corners;
}

} // namespace

void SafetyGuard::setWind(const Point& wind_mps)
{
    m_uav.motion.wind_mps = wind_mps;
    m_uav.motion.windLimit_mps = 0;
    if (m_uav.fence)
        m_uav.fence = std::make_shared<const Geofence>(m_uav.fence->inWind(wind_mps));
    m_ahead = wind_mps;
    weighWind();
}

bool SafetyGuard::followWind(const WindAhead& wind, double windLimit_mps)
{
    const Point now_mps = wind.at_mps(0);
    const bool isNew =
        now_mps != m_uav.motion.wind_mps || windLimit_mps != m_uav.motion.windLimit_mps;
    m_ahead = wind;
    if (isNew) {
        m_uav.motion.wind_mps = now_mps;
        m_uav.motion.windLimit_mps = windLimit_mps;
        if (m_uav.fence)
            m_uav.fence =
                std::make_shared<const Geofence>(m_uav.fence->inWind(now_mps, windLimit_mps));
    }
    weighWind();
    return isNew;
}

void SafetyGuard::weighWind()
{
    m_worst.clear();
    m_slowdown = 1;
    m_turnDrift_s = 0;
    m_slowest_mps = 0;
    if (!m_uav.sortie)
        return;
    const Motion& motion = m_uav.motion;
    const WindRange range = m_ahead.range(0, std::max(0.0, slotLeft_s()) + kWeighed_s);
    if (range.low_mps == range.high_mps)
        return;
    m_worst = windCorners(range, motion, motion.widestWind_mps());
    m_longestTurn_s = 0;
    m_slowest_mps = motion.airspeed_mps;
    for (const Motion& worst : m_worst) {
        m_longestTurn_s = std::max(
            m_longestTurn_s, longestPath_s({}, Point::Zero(), worst, m_uav.clock.command_s()));
        m_slowest_mps = std::min(m_slowest_mps, worst.airspeed_mps - worst.wind_mps.norm());
    }
    constexpr int kCourses = 32;
    double slowest_mps = motion.airspeed_mps;
    for (int i = 0; i < kCourses; ++i) {
        const double course_rad = 2 * kPi * i / kCourses;
        const Point course(std::cos(course_rad), std::sin(course_rad));
        const double now_mps = speedOver_mps(motion, course);
        for (const Motion& worst : m_worst) {
            const double least_mps = speedOver_mps(worst, course);
            m_slowdown = std::max(m_slowdown, now_mps / least_mps);
            slowest_mps = std::min(slowest_mps, least_mps);
        }
    }
    m_turnDrift_s =
        2 * kPi / motion.limit_radps * (range.high_mps - range.low_mps).norm() / slowest_mps;
}

std::optional<double> SafetyGuard::command_radps(const DubinsState& pose, double requested_radps)
{
    const double u_radps = limitedToFence_radps(pose, requested_radps);
    if (provesReturn())
        return provenCommand_radps(pose, u_radps);
    if (!m_uav.sortie || homeInTimeAfter(pose, u_radps, slotLeft_s()))
        return u_radps;
    return std::nullopt;
}

/**
 * Returns the requested turn rate if a path home is proven after it, else the next command of the
 * proven path. Returns nullopt, so that the UAV flies home, if time is short or that path ends.
 */
std::optional<double> SafetyGuard::provenCommand_radps(const DubinsState& pose,
                                                       double requested_radps)
{
    std::optional<ReturnPath>& path = m_sortie.returnPath;
    const double left_s = slotLeft_s();
    Outlook outlook = outlookAfter(pose, requested_radps, left_s);
    if (outlook.back == Return::InTime) {
        path = std::move(outlook.path);
        return requested_radps;
    }
    if (path && !path->parts.empty())
        return outlook.back == Return::Unknown && path->commands() > 1
                   ? std::optional(path->takeNext_radps())
                   : std::nullopt;
    if (homeInTimeAfter(pose, requested_radps, left_s)) {
        path.reset();
        return requested_radps;
    }
    path = returnPath(pose);
    return std::nullopt;
}

double SafetyGuard::homeCommand_radps(const DubinsState& pose, bool maySearch)
{
    std::optional<ReturnPath>& path = m_sortie.returnPath;
    if (provesReturn() && !path && maySearch)
        path = returnPath(pose);
    return path ? path->takeNext_radps() : limitedToFence_radps(pose, homeRate_radps(pose));
}

void SafetyGuard::requireHome(const SortieSpec& home)
{
    if (m_uav.sortie)
        return;
    m_uav.sortie = home;
    const std::int64_t slowest = std::llround(kSlowestHoming_s / m_uav.clock.dt_s);
    m_uav.clock.steps = std::min(m_uav.clock.steps, std::max<std::int64_t>(1, slowest));
}

void SafetyGuard::proveReturn(const DubinsState& pose, double u_radps, std::int64_t step)
{
    m_sortie.returnPath.reset();
    if (provesReturn() && m_sortie.isAloft)
        m_sortie.returnPath = returnPath(heldFor(pose, u_radps, stepsHeld(step)));
}

/** Returns the time steps until the next command. */
std::int64_t SafetyGuard::stepsHeld(std::int64_t step) const
{
    return (m_uav.clock.steps - step % m_uav.clock.steps) % m_uav.clock.steps;
}

std::optional<double> SafetyGuard::homeMargin_s(const DubinsState& pose, double u_radps,
                                                std::int64_t step) const
{
    if (!m_uav.sortie || !m_sortie.isAloft)
        return std::nullopt;
    const std::int64_t held = stepsHeld(step);
    const std::optional<double> home_s = m_sortie.returnPath
                                             ? worstTime_s(time_s(*m_sortie.returnPath))
                                             : timeHome_s(heldFor(pose, u_radps, held));
    return home_s ? enduranceLeft_s() - static_cast<double>(held) * m_uav.clock.dt_s - *home_s
                  : -m_uav.sortie->endurance_s;
}

double SafetyGuard::enduranceLeft_s() const
{
    return m_uav.sortie->endurance_s - (m_sortie.isAloft ? m_sortie.aloft_s : 0);
}

std::optional<int> SafetyGuard::visitsInTime(const DubinsState& pose,
                                             std::span<const MovingPlace> places) const
{
    if (!m_uav.sortie)
        return std::nullopt;
    const double left_s = slotLeft_s() - kHomeReserve_s - kVisitReserve_s;
    DubinsState at = pose;
    double flown_s = 0;
    int visits = 0;
    for (const MovingPlace& place : places) {
        const std::optional<Path> path =
            pathTo(at, {.place_m = place.place_m + place.drift_mps * flown_s,
                        .drift_mps = place.drift_mps});
        if (!path)
            break;
        if (!m_worst.empty()) { // the rest of the leg is flown in the wind of then
            const Point leg_m = place.place_m + place.drift_mps * flown_s - at.position_m;
            const double airspeed_mps = m_uav.motion.airspeed_mps;
            flown_s += flightTime_s(leg_m, airspeed_mps, place.drift_mps, m_ahead, flown_s) -
                       flightTime_s(leg_m, airspeed_mps, m_uav.motion.wind_mps - place.drift_mps);
        }
        flown_s += path->time_s;
        at = path->end;
        if (!isHomeWithin(left_s - flown_s, at))
            break;
        ++visits;
    }
    return visits;
}

bool SafetyGuard::tick()
{
    const double dt_s = m_uav.clock.dt_s;
    if (!m_sortie.isAloft) {
        m_sortie.ground_s = std::max(0.0, m_sortie.ground_s - dt_s);
        return false;
    }
    m_sortie.aloft_s += dt_s;
    return m_sortie.aloft_s > m_uav.sortie->endurance_s &&
           m_sortie.aloft_s - dt_s <= m_uav.sortie->endurance_s;
}

bool SafetyGuard::isLanding(const Point& from_m, const Point& to_m) const
{
    return distanceToSegment(from_m, to_m, m_uav.sortie->home_m) <= kLandingRadius_m;
}

void SafetyGuard::land()
{
    m_sortie.isAloft = false;
    m_sortie.ground_s = m_uav.sortie->turnaround_s;
    m_sortie.withheld_s = 0;
    m_sortie.returnPath.reset();
}

std::optional<double> SafetyGuard::takeOff(const DubinsState& pose)
{
    const std::optional<double> heading_rad =
        provesReturn() ? safeHeading_rad(pose, slotLeft_s()) : pose.psi_rad;
    if (heading_rad) {
        m_sortie.isAloft = true;
        m_sortie.aloft_s = 0;
    } else {
        m_sortie.ground_s = kNextTry_s;
    }
    return heading_rad;
}

DubinsState SafetyGuard::heldFor(const DubinsState& pose, double u_radps, std::int64_t steps) const
{
    DubinsState at = pose;
    for (std::int64_t i = 0; i < steps; ++i)
        at = step(at, m_uav.motion.airspeed_mps, u_radps, m_uav.clock.dt_s, m_uav.motion.wind_mps);
    return at;
}

/** Returns the clearance, m, after one command; negative if the command may leave the fence. */
double SafetyGuard::clearanceAfter_m(const DubinsState& pose, double u_radps) const
{
    DubinsState at = pose;
    for (std::int64_t i = 0; i < m_uav.clock.steps; ++i) {
        at = heldFor(at, u_radps, 1);
        if (m_uav.clock.steps > 1 && !m_uav.fence->contains(at.position_m))
            return -m_uav.fence->radius_m();
    }
    return m_uav.fence->turnClearance_m(at);
}

/**
 * Outside, the UAV takes the shortest path back: the rate with the largest clearance would lead
 * along the edge.
 */
double SafetyGuard::backInside_radps(const DubinsState& pose) const
{
    const Point path_m = m_uav.fence->nearestInside_m(pose.position_m) - pose.position_m;
    return turnRateForCourse(pose.psi_rad, std::atan2(path_m.y(), path_m.x()), m_uav.motion,
                             1 / std::max(1.0, m_uav.clock.command_s()));
}

double SafetyGuard::limitedToFence_radps(const DubinsState& pose, double u_radps) const
{
    if (m_uav.fence && !m_uav.fence->contains(pose.position_m))
        return backInside_radps(pose);
    if (!m_uav.fence || clearanceAfter_m(pose, u_radps) >= kClearance_m)
        return u_radps;
    std::vector<double> rates{m_uav.fence->circlingRate_radps(pose, 1),
                              m_uav.fence->circlingRate_radps(pose, -1)};
    for (const double part : kRates)
        rates.push_back(part * m_uav.motion.limit_radps);
    double best_radps = u_radps;
    double best_m = clearanceAfter_m(pose, u_radps);
    for (const double rate_radps : rates) {
        const double clearance_m = clearanceAfter_m(pose, rate_radps);
        const bool nearer = std::abs(rate_radps - u_radps) < std::abs(best_radps - u_radps);
        if (best_m < kClearance_m ? clearance_m > best_m : clearance_m >= kClearance_m && nearer) {
            best_m = clearance_m;
            best_radps = rate_radps;
        }
    }
    return best_radps;
}

std::optional<Path> SafetyGuard::pathTo(const DubinsState& from, const MovingPlace& place) const
{
    return m_uav.fence ? m_uav.fence->pathTo(from, place, m_uav.clock.command_s())
                       : berg::pathTo(from, place, m_uav.motion, m_uav.clock.command_s());
}

std::optional<double> SafetyGuard::timeHome_s(const DubinsState& from) const
{
    const std::optional<Path> path = pathTo(from, {.place_m = m_uav.sortie->home_m});
    if (!path)
        return std::nullopt;
    // The fence may turn the UAV aside once, round a circle, where the path passes close to it.
    const double now_s = path->time_s + (m_uav.fence ? m_uav.fence->circle_s() : 0);
    if (m_worst.empty() || m_uav.fence)
        return worstTime_s(now_s);
    double longest_s = now_s;
    for (const Motion& motion : m_worst) {
        const std::optional<Path> worst =
            berg::pathTo(from, {.place_m = m_uav.sortie->home_m}, motion, m_uav.clock.command_s());
        if (!worst)
            return std::nullopt;
        longest_s = std::max(longest_s, worst->time_s);
    }
    return longest_s + m_turnDrift_s;
}

bool SafetyGuard::isHomeWithin(double left_s, const DubinsState& from) const
{
    const Point& home_m = m_uav.sortie->home_m;
    const double command_s = m_uav.clock.command_s();
    if (m_uav.fence) {
        if (m_worst.empty() && m_uav.fence->longestPath_s(from, home_m, command_s) <= left_s)
            return true;
        const std::optional<double> home_s = timeHome_s(from);
        return home_s && *home_s <= left_s;
    }
    if (m_uav.motion.wind_mps.norm() >= m_uav.motion.airspeed_mps)
        return false;
    const double path_s = left_s - m_turnDrift_s;
    const double away_m = (home_m - from.position_m).norm();
    if (m_slowest_mps > 0 && m_longestTurn_s + away_m / m_slowest_mps <= path_s)
        return true;
    const auto reaches = [&](const Motion& motion) {
        return motion.wind_mps.norm() < motion.airspeed_mps &&
               reachesWithin(path_s, from, home_m, motion, command_s);
    };
    return reaches(m_uav.motion) && std::ranges::all_of(m_worst, reaches);
}

bool SafetyGuard::homeInTimeAfter(const DubinsState& pose, double u_radps, double left_s) const
{
    return isHomeWithin(left_s - m_uav.clock.command_s() - kHomeReserve_s,
                        heldFor(pose, u_radps, m_uav.clock.steps));
}

double SafetyGuard::homeRate_radps(const DubinsState& pose) const
{
    const std::optional<Path> path = pathTo(pose, {.place_m = m_uav.sortie->home_m});
    return path ? turnRateOf(*path, m_uav.motion, m_uav.clock.command_s()) : 0;
}

SafetyGuard::Outlook SafetyGuard::outlookAfter(const DubinsState& pose, double u_radps,
                                               double left_s) const
{
    const ReturnSearch paths = search();
    if (!paths.isInside(pose, u_radps, 1))
        return {};
    std::optional<ReturnPath> path = paths.quickPath(paths.after(pose, u_radps, 1));
    if (!path)
        return {};
    if (m_uav.clock.command_s() + worstTime_s(time_s(*path)) + kHomeReserve_s > left_s)
        return {.back = Return::Late};
    return {.back = Return::InTime, .path = std::move(path)};
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
        if (path && worstTime_s(time_s(*path)) + kHomeReserve_s <= left_s)
            return turned.psi_rad;
    }
    return std::nullopt;
}

} // namespace berg
