#pragma once

#include "core/tracking/observer.h"
#include "core/vehicle/geofence.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace berg {

class Simulation;

/**
 * How many of the order can be visited before home must be reached, clusters as a whole; none:
 * unlimited. Takes them as visited one by one, which is a longer way than to their middle.
 */
[[nodiscard]] std::optional<int> thisSortie(const Simulation& simulation, int uav,
                                            std::span<const int> order,
                                            std::span<const std::vector<int>> clusters);

/** Passing nearer to its middle than this is flying over a cluster. */
inline constexpr double kFlownOver_m = 10;

/** How one UAV flies to clusters, and what they may be for it. */
struct ClusterRules
{
    double time_s = 0;
    DubinsState uav;
    Motion motion;
    double cover_m = 0; ///< largest distance of a member from the UAV at which it counts
    std::shared_ptr<const Geofence> fence; ///< null: none
    std::vector<bool> visitable;           ///< by track: what it may visit; empty: all
};

/** Whether the UAV may visit all of them. */
[[nodiscard]] bool mayVisit(const ClusterRules& rules, std::span<const int> members);

/** What turning onto the straight way to a cluster adds to it at most: a full turn. */
[[nodiscard]] double longestTurn_s(const Motion& motion);

/**
 * Icebergs that can be planned as one point: flying over the middle of the smallest circle round
 * their estimates brings all of them into view at once. That circle is no larger than `cover_m`
 * less 2 standard deviations of the least certain one and the error of flying, now and when the
 * UAV, on a straight way after a full turn, is there. (In between it is no larger either: estimates
 * move straight, and the radius is then a convex function of time.) The UAV can turn onto the
 * middle at once, and fly over it on any course inside the fence. With several UAVs that holds for
 * each that may visit all of the members, of which there is one at least.
 *
 * Returns groups of indices into `tracks`, two and more in each, ascending, as are the first of
 * the groups; each index once at most. Groups grow out of single icebergs, the two that come into
 * the smallest circle first, while that is allowed: so they do not depend on the order of the
 * tracks but for ties, and tight ones, which are seen early and surely, come before wide ones. (The
 * fewest groups would be a disk cover, NP-hard, and would take wide ones first.) Cost: the square
 * of the count.
 */
[[nodiscard]] std::vector<std::vector<int>> clustersOf(std::span<const Track> tracks,
                                                       std::span<const ClusterRules> uavs);

/** The cluster that this one leads or is in; empty: none. */
[[nodiscard]] std::span<const int> clusterWith(std::span<const std::vector<int>> clusters,
                                               int iceberg);

} // namespace berg
