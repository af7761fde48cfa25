#include "core/sim/departure.h"

#include "core/base/angles.h"
#include "core/sim/holding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace berg {

namespace {

constexpr std::array kLengths_s{8.0, 12.0, 16.0, 20.0, 26.0, 32.0, 40.0, 50.0};
/** Number of turn angles tried to either side. */
constexpr int kTurns = 6;
constexpr double kLargestTurn_rad = kPi;
/** Shares of the turn rate limit, and seconds of straight flight before the turn. */
constexpr std::array kRateParts{1.0, 0.5};
constexpr std::array kLeads_s{0.0, 4.0};
/** Longest common period of commands with which UAVs depart together. */
constexpr double kLongestRound_s = 30;
constexpr int kMostTries = 4'000;

/**
 * Returns the number of steps after which every UAV has a command due, or 0 if that takes too long.
 */
std::int64_t commonSteps(std::span<const Departing> uavs)
{
    std::int64_t steps = 1;
    for (const Departing& uav : uavs) {
        steps = std::lcm(steps, uav.guard.uav().clock.steps);
        if (static_cast<double>(steps) * uav.guard.uav().clock.dt_s > kLongestRound_s)
            return 0;
    }
    return steps;
}

/**
 * Builds departures of straight flight, a turn and straight flight, each with both discs at its
 * end.
 */
std::vector<Departure> candidates(const Departing& uav, std::int64_t steps)
{
    const GuardedUav& own = uav.guard.uav();
    const std::int64_t commands = steps / own.clock.steps;
    std::vector<Departure> found;
    for (int turn = 0; turn <= 2 * kTurns; ++turn) // smallest turn first, right before left
        for (const double part : kRateParts)
            for (const double lead_s : kLeads_s) {
                const double rate_radps = (turn % 2 == 1 ? -1 : 1) * part * own.motion.limit_radps;
                const int size = (turn + 1) / 2;
                const double turn_rad = kLargestTurn_rad * size / kTurns;
                const std::int64_t lead = std::llround(lead_s / own.clock.command_s());
                const std::int64_t turned =
                    lead + std::llround(turn_rad / std::abs(rate_radps) / own.clock.command_s());
                Departure departure{.path_m = {uav.pose.position_m}};
                DubinsState at = uav.pose;
                for (std::int64_t command = 0; command < commands; ++command) {
                    departure.rates_radps.push_back(command >= lead && command < turned ? rate_radps
                                                                                        : 0);
                    for (std::int64_t i = 0; i < own.clock.steps; ++i) {
                        at = uav.guard.heldFor(at, departure.rates_radps.back(), 1);
                        departure.path_m.push_back(at.position_m);
                    }
                }
                for (const double side : {-1.0, 1.0}) {
                    departure.side = side;
                    departure.middle_m = middleBeside_m(at, own.motion, side);
                    found.push_back(departure);
                }
                if (turn == 0)
                    break; // straight flight does not depend on the rate
            }
    return found;
}

/** Permitted approach of two departing UAVs. */
struct Nearness
{
    double ofStart = 0;      ///< share of their distance at the start, until they are apart
    double ofSeparation = 0; ///< share of the separation, after they have been apart
};

/**
 * Requirements tried in this order. The last two serve UAVs that are apart but start towards each
 * other.
 */
constexpr std::array kNearest{Nearness{0.99, 1}, Nearness{0.5, 1}, Nearness{0, 1}, Nearness{0, 0.5},
                              Nearness{0, 0}};

bool isApart(const Departure& a, const Departure& b, double discs_m, double separation_m,
             const Nearness& nearest)
{
    if ((a.middle_m - b.middle_m).norm() < discs_m + separation_m)
        return false;
    double least_m = nearest.ofStart * (a.path_m.front() - b.path_m.front()).norm();
    for (std::size_t i = 0; i < a.path_m.size(); ++i) {
        const double apart_m = (a.path_m[i] - b.path_m[i]).norm();
        if (apart_m < least_m)
            return false;
        if (apart_m >= separation_m)
            least_m = nearest.ofSeparation * separation_m;
    }
    return true;
}

/** Chooses one departure for each UAV, one UAV after another. */
class Choice
{
public:
    Choice(std::span<const Departing> uavs, double separation_m)
        : m_uavs(uavs), m_separation_m(separation_m), m_candidates(uavs.size())
    {
    }
    [[nodiscard]] std::vector<Departure> find(std::int64_t steps, const Nearness& nearest,
                                              const MayDepart& mayDepart)
    {
        for (std::size_t uav = 0; uav < m_uavs.size(); ++uav) {
            m_candidates[uav] = candidates(m_uavs[uav], steps);
            std::erase_if(m_candidates[uav],
                          [&](const Departure& departure) { return !mayDepart(uav, departure); });
        }
        m_nearest = nearest;
        m_triesLeft = kMostTries;
        m_chosen.clear();
        return choose() ? m_chosen : std::vector<Departure>();
    }

private:
    bool choose()
    {
        const std::size_t uav = m_chosen.size();
        if (uav == m_uavs.size())
            return true;
        for (const Departure& departure : m_candidates[uav]) {
            if (--m_triesLeft < 0)
                return false;
            bool fits = true;
            for (std::size_t other = 0; other < uav && fits; ++other)
                fits = isApart(departure, m_chosen[other],
                               m_uavs[uav].radius_m + m_uavs[other].radius_m, m_separation_m,
                               m_nearest);
            if (!fits)
                continue;
            m_chosen.push_back(departure);
            if (choose())
                return true;
            m_chosen.pop_back();
        }
        return false;
    }

    std::span<const Departing> m_uavs;
    double m_separation_m;
    std::vector<std::vector<Departure>> m_candidates; ///< by UAV
    std::vector<Departure> m_chosen;
    Nearness m_nearest;
    int m_triesLeft = 0;
};

} // namespace

std::optional<double> Departure::takeNext_radps(std::int64_t steps)
{
    if (rates_radps.empty())
        return std::nullopt;
    const double rate_radps = rates_radps.front();
    rates_radps.erase(rates_radps.begin());
    path_m.erase(path_m.begin(), path_m.begin() + steps);
    if (rates_radps.empty())
        path_m.clear();
    return rate_radps;
}

std::vector<Departure> departuresOf(std::span<const Departing> uavs, double separation_m,
                                    const MayDepart& mayDepart)
{
    const std::int64_t round = commonSteps(uavs);
    if (round == 0)
        return {};
    const double round_s = static_cast<double>(round) * uavs.front().guard.uav().clock.dt_s;
    Choice choice(uavs, separation_m);
    for (const Nearness& nearest : kNearest)
        for (const double length_s : kLengths_s) {
            const auto rounds = static_cast<std::int64_t>(std::ceil(length_s / round_s));
            std::vector<Departure> found = choice.find(rounds * round, nearest, mayDepart);
            if (!found.empty())
                return found;
        }
    return {};
}

} // namespace berg
