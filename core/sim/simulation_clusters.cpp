// Several icebergs flown to as one point: the part of `Simulation` that knows clusters.

#include "core/base/enclosing_circle.h"
#include "core/sim/clusters.h"
#include "core/sim/simulation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace berg {

std::optional<int> thisSortie(const Simulation& simulation, std::span<const int> order,
                              std::span<const std::vector<int>> clusters)
{
    std::optional<int> visits = simulation.thisSortie(order);
    while (visits && *visits > 0 && *visits < static_cast<int>(order.size())) {
        const auto next = static_cast<std::size_t>(*visits);
        const std::span<const int> members = clusterWith(clusters, order[next - 1]);
        if (std::ranges::find(members, order[next]) == members.end())
            break;
        --*visits;
    }
    return visits;
}

bool Simulation::clusterable(int iceberg) const
{
    return available(iceberg) && std::ranges::find(m_state.apart, iceberg) == m_state.apart.end();
}

Point Simulation::middleOf_m(std::span<const int> members) const
{
    std::vector<Point> places_m;
    places_m.reserve(members.size());
    for (const int member : members)
        places_m.push_back(estimate_m(member));
    return enclosingCircle(places_m).centre_m;
}

Point Simulation::targetPlace_m() const
{
    return m_state.members.empty() ? estimate_m(m_state.target) : middleOf_m(m_state.members);
}

void Simulation::setMembers(std::span<const int> members)
{
    m_state.members.assign(members.begin(), members.end());
    m_state.membersBy_s = 0;
    if (members.empty())
        return;
    const std::array leg_m{m_state.uav.position_m, middleOf_m(members)};
    m_state.membersBy_s =
        time_s() + longestTurn_s(m_motion) + legLengths_m(leg_m)(0, 1) / m_motion.airspeed_mps;
}

bool Simulation::isReached(int iceberg) const
{
    return m_reachRadius_m ? withinReach(iceberg) : track(iceberg).inView;
}

bool Simulation::targetReached() const
{
    if (m_state.members.empty())
        return isReached(m_state.target);
    return std::ranges::all_of(m_state.members, [this](int member) { return isReached(member); });
}

/**
 * Ends a cluster that has been flown over, or should have been by now, with members that did not
 * come into view: those are not where they should be, and flown to one by one.
 */
void Simulation::updateClusters()
{
    std::erase_if(m_state.apart, [this](int iceberg) { return track(iceberg).inView; });
    if (m_state.members.empty() || m_planReason != PlanReason::None ||
        m_state.mode != FlightMode::Leg)
        return;
    const Point way_m = targetPlace_m() - m_state.uav.position_m;
    const Point ahead(std::cos(m_state.uav.psi_rad), std::sin(m_state.uav.psi_rad));
    const bool flownOver = way_m.norm() <= kFlownOver_m && ahead.dot(way_m) <= 0;
    if (!flownOver && time_s() < m_state.membersBy_s)
        return;
    for (const int member : m_state.members)
        if (!isReached(member))
            m_state.apart.push_back(member);
    m_planReason = PlanReason::Overdue;
}

/** Straight at the middle instead of along the leg: the view has little to spare beside it. */
double Simulation::steerCluster()
{
    const Point end_m = targetPlace_m();
    if (const std::optional<double> u_radps = steerRoundFence(end_m))
        return *u_radps;
    const Point from_m = m_state.guidance.start_m;
    const Point leg_m = end_m - from_m;
    const Point way_m = end_m - m_state.uav.position_m;
    m_state.crossTrack_m =
        leg_m.isZero(0) ? 0 : cross(leg_m.normalized(), m_state.uav.position_m - from_m);
    return turnRateForCourse(m_state.uav.psi_rad, std::atan2(way_m.y(), way_m.x()), m_motion,
                             m_state.guidance.gains.turn_1ps);
}

} // namespace berg
