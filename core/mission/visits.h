#pragma once

#include "core/mission/mission.h"

#include <optional>
#include <vector>

namespace berg {

/** One point of a planned or flown path. */
struct TrackPoint
{
    double time_s = 0;
    DubinsState state;
    double u_radps = 0;
    double crossTrack_m = 0; ///< positive left of the leg
};

/** A meeting of the UAV with an iceberg or cluster, planned or flown. */
struct Visit
{
    /** Index; nullopt for home and for the start at the end of a closed route. */
    std::optional<IcebergIndex> iceberg = {};
    double time_s = 0;
    Point position_m = Point::Zero(); ///< true or predicted position of the iceberg at `time_s`
    /** Members of the cluster, `iceberg` among them; empty for a single iceberg. */
    IcebergList members = {};
    double spread_m = 0; ///< distance of the farthest member from `position_m`
};

/**
 * Predicts where and when the scenario's only UAV meets each iceberg of the order (`LegFlight`);
 * estimates drift with their velocity and the current. An iceberg is met at its centre although it
 * comes into view earlier. A cluster is one visit at the middle of the circle around its members at
 * that time. With limited endurance only the first sortie is returned (`thisSortie`), with home as
 * its last visit; a closed route ends with the start. Times are seconds since the start. The
 * scenario must have no errors. Throws `std::out_of_range` if an index does not exist.
 */
[[nodiscard]] std::vector<Visit> plannedVisits(const Scenario& scenario, const IcebergList& order,
                                               const std::vector<IcebergList>& clusters);

/**
 * Returns the targets that UAV `uav` reached, in order and at their true positions; a cluster is at
 * the middle of its members. The list is empty if the mission kept no record.
 */
[[nodiscard]] std::vector<Visit> flownVisits(const Mission& mission, int uav = 0);

/**
 * Returns the icebergs in view at the visit: the members of the cluster, or the single iceberg.
 * Returns no icebergs for home and for the start.
 */
[[nodiscard]] IcebergList icebergsOf(const Visit& visit);

} // namespace berg
