#include "core/coverage/coverage_model.h"

#include <algorithm>
#include <cmath>

// This file finds the turn and the line of a leg.

namespace berg {

TangentTurn CoverageModel::turnOf(const CoverageState& state, const CoverageLeg& leg) const
{
    // The aim is the position of the iceberg at its sighting, which is found by iteration because
    // the time depends on it.
    constexpr int kMostRounds = 8;
    constexpr double kGoodEnough_m = 0.3;
    /** An offset is reduced by a little more than the view is narrowed. */
    constexpr double kInside = 1.02;
    const double drift_mps =
        m_carried_m.empty() ? berg(leg.iceberg).velocity_mps.norm() : m_fastest_mps;
    double ahead_s =
        std::max(0.0, distance_m(state, leg.iceberg) - m_window.half_m().x()) / m_speed_mps;
    const auto& account = accountOf(state, leg.iceberg);
    const ViewWindow window =
        windowOf(leg.iceberg, growthUntil(leg.iceberg, account, state.time_s + ahead_s).sigma_m2);
    const double offset_m =
        leg.offset_m * (1 - kInside * (1 - window.largestOffset_m() / m_window.largestOffset_m()));
    TangentTurn turn;
    for (int round = 0; round < kMostRounds; ++round) {
        turn = turnOntoLine(
            state.uav,
            {.target_m = place_m(leg.iceberg, state.time_s + ahead_s), .offset_m = offset_m},
            m_radius_m);
        double entry_m = window.entry_m(turn.end.ahead, offset_m);
        if (const ViewWindow* reach = reachOf(leg.iceberg))
            entry_m = std::min(entry_m, reach->entry_m(turn.end.ahead, offset_m));
        const double was_s = ahead_s;
        ahead_s = std::abs(turn.turn_rad) / m_limit_radps +
                  std::max(0.0, turn.length_m - entry_m) / m_speed_mps;
        if (std::abs(ahead_s - was_s) * drift_mps < kGoodEnough_m)
            break;
    }
    return turn;
}

/** Returns the turn of a hold at the limit to its side, or a straight line. */
TangentTurn CoverageModel::holdTurn(const CoverageState& state, const CoverageLeg& leg) const
{
    TangentTurn hold{.turn_rad = leg.side * m_limit_radps * leg.stay_s, .end = state.uav};
    if (leg.side == 0)
        hold.length_m = m_speed_mps * leg.stay_s;
    else
        hold.end = turnedTo(
            state.uav, rotated(state.uav.ahead, std::cos(hold.turn_rad), std::sin(hold.turn_rad)),
            leg.side, m_radius_m);
    return hold;
}

CoverageModel::Course CoverageModel::course(const CoverageState& state,
                                            const CoverageLeg& leg) const
{
    Course course{.turn = leg.isHold() ? holdTurn(state, leg) : turnOf(state, leg),
                  .abeam_m = Point::Zero()};
    if (leg.isHold()) // The line lasts until the next leg begins.
        course.turn.length_m = std::max(course.turn.length_m, m_speed_mps);
    const Pose& end = course.turn.end;
    const double turned_s = state.time_s + std::abs(course.turn.turn_rad) / m_limit_radps;
    const double abeam_s = turned_s + course.turn.length_m / m_speed_mps;
    course.abeam_m = end.position_m + end.ahead * course.turn.length_m + windPath_m(abeam_s);
    course.turn.end.position_m += windPath_m(turned_s);
    return course;
}

} // namespace berg
