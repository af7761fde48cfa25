#pragma once

#include "core/sim/mission.h"

#include <vector>

namespace berg {

/** One point of a way that is or was flown. */
struct TrackPoint
{
    double time_s = 0;
    DubinsState state;
    double u_radps = 0;
    double crossTrack_m = 0;
};

/** The UAV over an iceberg, planned or flown. */
struct Visit
{
    int iceberg = -1; ///< index; -1: home, or back at the start at the end of a closed route
    double time_s = 0;
    Point position_m = Point::Zero(); ///< true or predicted position of the iceberg at `time_s`
    std::vector<int> members = {};    ///< of a cluster, the iceberg one of them; else empty
    double spread_m = 0;              ///< distance of the farthest member from `position_m`
};

/**
 * Where and when the only UAV of the scenario meets each iceberg of the order (`LegFlight`): the
 * estimates drift with their velocity and the current. An iceberg is met at its centre, although it
 * comes into view earlier. The icebergs of a cluster are one visit, at the middle of the circle
 * round them as they will be then. With a limited endurance those of the first sortie
 * (`Simulation::thisSortie`), and home as the last.
 */
[[nodiscard]] std::vector<Visit> plannedVisits(const Scenario& scenario,
                                               const std::vector<int>& order,
                                               const std::vector<std::vector<int>>& clusters);

/** Targets that UAV `uav` of the scenario reached, in order, at their true positions, clusters at
 * the middle of theirs. Empty when the mission kept no record. */
[[nodiscard]] std::vector<Visit> flownVisits(const Mission& mission, int uav = 0);

/** Those in view at a visit that is one of icebergs: the iceberg, or the members of the cluster. */
[[nodiscard]] std::vector<int> icebergsOf(const Visit& visit);

} // namespace berg
