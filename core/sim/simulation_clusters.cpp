// Several icebergs flown to as one point: the part of `Simulation` that knows clusters.

#include "core/base/enclosing_circle.h"
#include "core/sim/clusters.h"
#include "core/sim/simulation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace berg {

std::optional<int> thisSortie(const Simulation& simulation, int uav, std::span<const int> order,
                              std::span<const std::vector<int>> clusters)
{
    std::optional<int> visits = simulation.thisSortie(uav, order);
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
    return available(0, iceberg) &&
           std::ranges::find(m_state.apart, iceberg) == m_state.apart.end();
}

Point Simulation::middleOf_m(std::span<const int> members) const
{
    std::vector<Point> places_m;
    places_m.reserve(members.size());
    for (const int member : members)
        places_m.push_back(estimate_m(member));
    return enclosingCircle(places_m).centre_m;
}

Point Simulation::targetPlace_m(int uav) const
{
    const UavState& me = m_state.uavs[index(uav)];
    return me.members.empty() ? estimate_m(me.target) : middleOf_m(me.members);
}

void Simulation::setMembers(int uav, std::span<const int> members)
{
    UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    me.members.assign(members.begin(), members.end());
    me.membersBy_s = 0;
    if (members.empty())
        return;
    const std::array leg_m{me.pose.position_m, middleOf_m(members)};
    me.membersBy_s = time_s() + longestTurn_s(craft.motion) +
                     legLengths_m(uav, leg_m)(0, 1) / craft.motion.airspeed_mps;
}

bool Simulation::isReached(int uav, int iceberg) const
{
    return m_reachRadius_m ? withinReach(uav, iceberg) : inOwnView(uav, iceberg);
}

/** Of several UAVs the others may have it in view. */
bool Simulation::inOwnView(int uav, int iceberg) const
{
    return track(iceberg).inView &&
           (uavCount() == 1 || fieldOfView(uav).contains(truth_m(iceberg)));
}

bool Simulation::isReachedByOther(int uav, int iceberg) const
{
    if (uavCount() == 1 || (!m_reachRadius_m && !track(iceberg).inView))
        return false;
    for (int other = 0; other < uavCount(); ++other)
        if (other != uav && isReached(other, iceberg))
            return true;
    return false;
}

bool Simulation::targetReached(int uav) const
{
    const UavState& me = m_state.uavs[index(uav)];
    if (me.members.empty())
        return isReached(uav, me.target);
    return std::ranges::all_of(me.members,
                               [this, uav](int member) { return isReached(uav, member); });
}

/**
 * Ends a cluster that has been flown over, or should have been by now, with members that did not
 * come into view: those are not where they should be, and flown to one by one.
 */
void Simulation::updateClusters(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    std::erase_if(m_state.apart, [this](int iceberg) { return track(iceberg).inView; });
    if (me.members.empty() || planReason(uav) != PlanReason::None || me.mode != FlightMode::Leg)
        return;
    const Point way_m = targetPlace_m(uav) - me.pose.position_m;
    const Point ahead(std::cos(me.pose.psi_rad), std::sin(me.pose.psi_rad));
    const bool flownOver = way_m.norm() <= kFlownOver_m && ahead.dot(way_m) <= 0;
    if (!flownOver && time_s() < me.membersBy_s)
        return;
    for (const int member : me.members)
        if (!isReached(uav, member))
            m_state.apart.push_back(member);
    m_planReasons[index(uav)] = PlanReason::Overdue;
}

/** Straight at the middle instead of along the leg: the view has little to spare beside it. */
double Simulation::steerCluster(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    const Point end_m = targetPlace_m(uav);
    if (const std::optional<double> u_radps = steerRoundFence(uav, end_m))
        return *u_radps;
    const Point from_m = me.guidance.start_m;
    const Point leg_m = end_m - from_m;
    const Point way_m = end_m - me.pose.position_m;
    me.crossTrack_m = leg_m.isZero(0) ? 0 : cross(leg_m.normalized(), me.pose.position_m - from_m);
    return turnRateForCourse(me.pose.psi_rad, std::atan2(way_m.y(), way_m.x()), craft.motion,
                             me.guidance.gains.turn_1ps);
}

} // namespace berg
