#pragma once

#include "tests/support/request_builder.h"

#include <cstdint>

namespace berg::test {

/** The places seen by UAVs at these points, numbered 20, 21, ...; everything is available. */
inline PlanRequest fleetRequestOf(const std::vector<Point>& uavs_m,
                                  const std::vector<Place>& places)
{
    PlanRequest request = requestOf(uavs_m.front(), places);
    Eigen::MatrixX2d starts_m(static_cast<Eigen::Index>(uavs_m.size()), 2);
    for (std::size_t k = 0; k < uavs_m.size(); ++k) {
        const PlanRequest alone = requestOf(uavs_m[k], places);
        request.fleet.push_back({.uav = 20 + static_cast<int>(k),
                                 .distance_m = alone.problem.distance_m,
                                 .available = alone.available,
                                 .picture = nullptr});
        starts_m.row(static_cast<Eigen::Index>(k)) = uavs_m[k].transpose();
    }
    request.betweenUavs_m = euclideanDistances(starts_m);
    return request;
}

/** UAVs and icebergs anywhere; airspeeds differ when so said. Deterministic. */
inline PlanRequest randomFleetRequest(std::uint64_t seed, int uavs, int icebergs,
                                      bool unlike = false)
{
    Random random(seed, 17);
    std::vector<Point> uavs_m;
    for (int k = 0; k < uavs; ++k)
        uavs_m.emplace_back(random.uniform(0, 5000), random.uniform(0, 4000));
    PlanRequest request = fleetRequestOf(uavs_m, randomPlaces(random, icebergs));
    for (std::size_t k = 0; unlike && k < request.fleet.size(); ++k)
        request.fleet[k].distance_m *= 1 + 0.2 * static_cast<double>(k);
    return request;
}

/** About so much of what there is stays available. */
inline PlanRequest thinnedOut(PlanRequest request, Random& random, double share)
{
    for (UavRequest& uav : request.fleet)
        for (std::size_t k = 0; k < uav.available.size(); ++k)
            uav.available[k] = random.uniform() < share;
    return request;
}

/** The request as UAV k would make it alone. */
inline PlanRequest aloneOf(const PlanRequest& request, std::size_t k)
{
    PlanRequest alone = request;
    alone.problem.distance_m = request.fleet[k].distance_m;
    alone.available = request.fleet[k].available;
    alone.fleet.clear();
    return alone;
}

/** Nothing is available to UAV k. */
inline PlanRequest withoutUav(PlanRequest request, std::size_t k)
{
    request.fleet[k].available.assign(request.ids.size(), false);
    return request;
}

/** The iceberg of that id is not available to any UAV. */
inline PlanRequest withoutIceberg(PlanRequest request, int id)
{
    for (UavRequest& uav : request.fleet)
        uav.available[static_cast<std::size_t>(nodeOf(request, id) - 1)] = false;
    return request;
}

} // namespace berg::test
