#include "core/vehicle/return_path.h"

#include "core/base/angles.h"
#include "core/vehicle/side_turn.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace berg {

namespace {

/**
 * A path passes home within this distance; landing counts from farther away (`kLandingRadius_m`).
 */
constexpr double kPass_m = 15;
/** Largest number of legs and turns of a path; half round a stand-off ring needs more. */
constexpr int kDeepest = 8;
constexpr int kDeepestRoundHoles = 16;
constexpr int kQuickTries = 24;
constexpr int kAnyTries = 400;
/** Lengths of the straight lines that make room for a turn, in circle radii. */
constexpr std::array<double, 5> kRunOuts{0.5, 1, 2, 4, 8};
/** Turns that make room for the path. */
constexpr double kFirstTurn_rad = kPi / 4;
constexpr int kFirstTurns = 6;

/**
 * Returns the result of repeated `step` without adding up: chords of the circle, one per time step.
 */
DubinsState afterSteps(const DubinsState& from, const Motion& motion, double rate_radps,
                       double steps, double dt_s)
{
    const double half_rad = rate_radps * dt_s / 2;
    const double chords = half_rad == 0 ? steps : std::sin(half_rad * steps) / std::sin(half_rad);
    const double middle_rad = from.psi_rad + half_rad * steps;
    return {.position_m = from.position_m +
                          motion.airspeed_mps * dt_s * chords *
                              Point(std::cos(middle_rad), std::sin(middle_rad)) +
                          motion.wind_mps * (steps * dt_s),
            .psi_rad = wrapPi(from.psi_rad + 2 * half_rad * steps)};
}

} // namespace

std::int64_t ReturnPath::commands() const
{
    std::int64_t sum = 0;
    for (const Part& part : parts)
        sum += part.commands;
    return sum;
}

double ReturnPath::takeNext_radps()
{
    if (parts.empty())
        return 0;
    const double rate_radps = parts.front().rate_radps;
    if (--parts.front().commands == 0)
        parts.erase(parts.begin());
    return rate_radps;
}

ReturnSearch::ReturnSearch(const Geofence& fence, const CommandClock& clock, const Point& home_m)
    : m_fence(fence)
    , m_clock(clock)
    , m_home_m(home_m)
    , m_deepest(fence.hasHoles() ? kDeepestRoundHoles : kDeepest)
{
}

DubinsState ReturnSearch::after(const DubinsState& from, double rate_radps,
                                std::int64_t commands) const
{
    return afterSteps(from, m_fence.motion(), rate_radps,
                      static_cast<double>(commands * m_clock.steps), m_clock.dt_s);
}

bool ReturnSearch::isInside(const DubinsState& from, double rate_radps, std::int64_t commands) const
{
    const Motion& motion = m_fence.motion();
    const auto steps = static_cast<double>(commands * m_clock.steps);
    const auto at_m = [&](double flown) {
        return afterSteps(from, motion, rate_radps, flown, m_clock.dt_s).position_m;
    };
    if (!m_fence.contains(from.position_m))
        return false;
    if (rate_radps == 0)
        return m_fence.clearance_m(from.position_m, at_m(steps)) >= kFenceMargin_m;
    const double step_m = (motion.airspeed_mps + motion.wind_mps.norm()) * m_clock.dt_s;
    for (double flown = 0;;) {
        const double clearance_m = m_fence.clearance_m(at_m(flown));
        if (clearance_m < kFenceMargin_m)
            return false;
        if (flown == steps)
            return true;
        // Until then the UAV is at least half the margin inside, on any course.
        flown = std::min(steps, flown + (clearance_m - kFenceMargin_m / 2) / step_m);
    }
}

/** Returns false, and adds nothing, if the commands would leave the fence. */
bool ReturnSearch::add(Trial& trial, double rate_radps, std::int64_t commands) const
{
    if (commands <= 0)
        return true;
    if (!isInside(trial.at, rate_radps, commands))
        return false;
    trial.at = after(trial.at, rate_radps, commands);
    trial.path.parts.push_back({.rate_radps = rate_radps, .commands = commands});
    trial.commands += commands;
    return true;
}

bool ReturnSearch::turnTo(Trial& trial, const Point& place_m, double side) const
{
    const Motion& motion = m_fence.motion();
    const double command_s = m_clock.command_s();
    const std::optional<Path> path =
        SideTurn(trial.at, {.place_m = place_m}, motion, command_s, side).find();
    if (!path)
        return false;
    const double perCommand_rad = motion.limit_radps * command_s;
    const double turn_rad = std::abs(path->turn_rad);
    const double whole = std::floor(turn_rad / perCommand_rad);
    const double rest_rad = turn_rad - whole * perCommand_rad;
    return add(trial, side * motion.limit_radps, static_cast<std::int64_t>(whole)) &&
           (rest_rad <= 0 || add(trial, side * rest_rad / command_s, 1));
}

/**
 * Corrects the heading error that whole commands leave after the turn, with up to three more
 * commands.
 */
bool ReturnSearch::pointAt(Trial& trial, const Point& place_m) const
{
    constexpr int kMostCommands = 3;
    constexpr double kMiss_m = 2;
    const Motion& motion = m_fence.motion();
    const auto wanted_rad = [&](const Point& from_m) {
        const Point leg_m = place_m - from_m;
        const double across_mps = cross(leg_m.normalized(), motion.wind_mps);
        return std::atan2(leg_m.y(), leg_m.x()) - std::asin(across_mps / motion.airspeed_mps);
    };
    for (int command = 0; command < kMostCommands; ++command) {
        const double away_m = (place_m - trial.at.position_m).norm();
        const double miss_rad = wrapPi(wanted_rad(trial.at.position_m) - trial.at.psi_rad);
        if (away_m < kPass_m || std::abs(miss_rad) * away_m < kMiss_m)
            return true;
        double rate_radps = 0;
        for (int round = 0; round < 4; ++round) {
            const DubinsState next = after(trial.at, rate_radps, 1);
            const double turn_rad = wrapPi(wanted_rad(next.position_m) - trial.at.psi_rad);
            rate_radps =
                std::clamp(turn_rad / m_clock.command_s(), -motion.limit_radps, motion.limit_radps);
        }
        if (!add(trial, rate_radps, 1))
            return false;
    }
    return true;
}

/** Flies straight up to the place, or to the end of the first command beyond it. */
bool ReturnSearch::flyStraight(Trial& trial, const Point& place_m, bool isHome) const
{
    const Motion& motion = m_fence.motion();
    const Point over_mps =
        motion.airspeed_mps * Point(std::cos(trial.at.psi_rad), std::sin(trial.at.psi_rad)) +
        motion.wind_mps;
    const Point leg_m = place_m - trial.at.position_m;
    const double time_s = std::max(0.0, leg_m.dot(over_mps) / over_mps.squaredNorm());
    const auto commands = static_cast<std::int64_t>(std::ceil(time_s / m_clock.command_s() - 1e-9));
    if (!isHome)
        return add(trial, 0, commands);
    // The UAV lands during the last command, so the place where that command ends does not matter.
    const Point end_m = trial.at.position_m + over_mps * time_s;
    if ((end_m - place_m).norm() > kPass_m || !m_fence.contains(trial.at.position_m) ||
        m_fence.clearance_m(trial.at.position_m, end_m) < kFenceMargin_m)
        return false;
    if (commands > 0)
        trial.path.parts.push_back({.rate_radps = 0, .commands = commands});
    trial.commands += commands;
    return true;
}

void ReturnSearch::extend(const Trial& trial, int depth, Found& found) const
{
    if (depth < m_deepest)
        follow(trial, m_fence.cornersBetween(trial.at.position_m, m_home_m), depth, found);
}

/** Follows these corners and then flies home, trying both turns at each of them. */
void ReturnSearch::follow(const Trial& trial, std::span<const Point> corners_m, int depth,
                          Found& found) const
{
    const bool isHome = corners_m.empty();
    const Point& place_m = isHome ? m_home_m : corners_m.front();
    const Point ahead(std::cos(trial.at.psi_rad), std::sin(trial.at.psi_rad));
    const double nearSide = cross(ahead, place_m - trial.at.position_m) >= 0 ? 1 : -1;
    for (const double side : {nearSide, -nearSide}) {
        if (found.triesLeft-- <= 0)
            return;
        Trial next = trial;
        if (!turnTo(next, place_m, side) || !pointAt(next, place_m))
            continue;
        if (found.path && next.commands >= found.commands)
            continue;
        Trial turned = next;
        if (!flyStraight(next, place_m, isHome)) {
            // From the end of the turn the path may lead round another corner.
            if (depth + 1 < m_deepest && turned.commands > trial.commands)
                extend(turned, depth + 1, found);
        } else if (!isHome) {
            if (depth + 1 < m_deepest)
                follow(next, corners_m.subspan(1), depth + 1, found);
        } else if (!found.path || next.commands < found.commands) {
            found.commands = next.commands;
            found.path = std::move(next.path);
        }
    }
}

std::optional<ReturnPath> ReturnSearch::quickPath(const DubinsState& from) const
{
    Found found{.triesLeft = kQuickTries};
    extend({.at = from}, 0, found);
    return found.path;
}

std::optional<ReturnPath> ReturnSearch::anyPath(const DubinsState& from) const
{
    const Motion& motion = m_fence.motion();
    const double command_s = m_clock.command_s();
    Found found{.triesLeft = kAnyTries};
    extend({.at = from}, 0, found);
    if (found.path)
        return found.path;
    const auto commandsFor = [command_s](double time_s) {
        return std::max<std::int64_t>(1, std::llround(time_s / command_s));
    };
    const auto runOuts = [&](const Trial& start) {
        for (const double radii : kRunOuts) {
            Trial trial = start;
            if (!add(trial, 0, commandsFor(radii * m_fence.radius_m() / motion.airspeed_mps)))
                return;
            extend(trial, m_deepest / 2, found);
        }
    };
    runOuts({.at = from});
    for (const double side : {1.0, -1.0}) {
        Trial trial{.at = from};
        const std::int64_t turn = commandsFor(kFirstTurn_rad / motion.limit_radps);
        for (int k = 0; k < kFirstTurns && add(trial, side * motion.limit_radps, turn); ++k) {
            extend(trial, m_deepest / 2, found);
            runOuts(trial);
        }
    }
    return found.path;
}

} // namespace berg
