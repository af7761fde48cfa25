#pragma once

#include "core/base/index.h"
#include "core/tracking/observer.h"
#include "core/vehicle/geofence.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace berg {

class Simulation;

/**
 * Returns how many icebergs of the order UAV `uav` can visit before it must turn home, clusters
 * counted only as a whole, or nullopt if the endurance is unlimited. Members are counted as visited
 * one by one, which is longer than the flight to the middle of their cluster.
 */
[[nodiscard]] std::optional<int> thisSortie(const Simulation& simulation, int uav,
                                            std::span<const IcebergIndex> order,
                                            std::span<const IcebergList> clusters);

/** A pass closer than this to the middle counts as flying over the cluster, m. */
inline constexpr double kFlownOver_m = 10;

/** Conditions under which one UAV may fly to clusters. */
struct ClusterRules
{
    double time_s = 0;
    DubinsState uav;
    Motion motion;
    /** Largest distance between UAV and member at which the member counts as seen. */
    double cover_m = 0;
    std::shared_ptr<const Geofence> fence; ///< null if there is no fence
    /** By track: whether the UAV may visit it; empty means every track. */
    std::vector<bool> visitable;
};

/** Returns true if the UAV may visit every member; members are indices of tracks. */
[[nodiscard]] bool mayVisit(const ClusterRules& rules, std::span<const int> members);

/**
 * Returns the time of a full turn, s: the most that turning onto the straight path to a cluster
 * adds.
 */
[[nodiscard]] double longestTurn_s(const Motion& motion);

/**
 * Groups icebergs that can be planned as one point, because flying over the middle of the smallest
 * circle around their estimates brings all of them into view at once.
 * For each UAV that may visit all members (at least one), the radius of that circle is at most
 * `cover_m` less 2 standard deviations of the least certain member and the guidance error, both now
 * and at arrival after a full turn and a straight leg. In between it is no larger, because
 * estimates move in straight lines and the radius is then a convex function of time. The UAV can
 * also turn onto the middle at once and fly over it on any course inside the fence.
 *
 * Returns groups of two or more indices into `tracks`, each ascending and ordered by their first
 * index; an index appears at most once. Groups grow from single icebergs by repeatedly uniting the
 * two whose union has the smallest circle. The result therefore does not depend on the order of the
 * tracks except for ties, and tight groups, which are seen early and reliably, form before wide
 * ones. (The smallest number of groups is a disk cover problem, NP-hard, and would prefer wide
 * groups.) There must be at least one UAV. Cost: quadratic in the number of tracks.
 */
[[nodiscard]] std::vector<std::vector<int>> clustersOf(std::span<const Track> tracks,
                                                       std::span<const ClusterRules> uavs);

/** Returns the members of the cluster that contains the iceberg, or an empty span if none does. */
[[nodiscard]] std::span<const IcebergIndex> clusterWith(std::span<const IcebergList> clusters,
                                                        IcebergIndex iceberg);

} // namespace berg
