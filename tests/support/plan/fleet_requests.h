#pragma once

#include "tests/support/plan/request_builder.h"

#include <cstdint>

namespace berg::test {

/** Returns a request for places seen by UAVs at these points, numbered 20, 21, …, all available. */
inline PlanRequest fleetRequestOf(const std::vector<Point>& uavs_m,
                                  const std::vector<Place>& places)
{
    PlanRequest request = requestOf(uavs_m.front(), places);
    request.uavs.clear();
    Eigen::MatrixX2d starts_m(static_cast<Eigen::Index>(uavs_m.size()), 2);
    for (std::size_t k = 0; k < uavs_m.size(); ++k) {
        request.uavs.push_back(requestOf(uavs_m[k], places).uavs.front());
        request.uavs.back().uav = 20 + static_cast<int>(k);
        starts_m.row(static_cast<Eigen::Index>(k)) = uavs_m[k].transpose();
    }
    request.betweenUavs_m = euclideanDistances(starts_m);
    return request;
}

/** Returns a request with random UAVs and icebergs; airspeeds differ if `unlike`. Deterministic. */
inline PlanRequest randomFleetRequest(std::uint64_t seed, int uavs, int icebergs,
                                      bool unlike = false)
{
    Random random(seed, 17);
    std::vector<Point> uavs_m;
    for (int k = 0; k < uavs; ++k)
        uavs_m.emplace_back(random.uniform(0, 5000), random.uniform(0, 4000));
    PlanRequest request = fleetRequestOf(uavs_m, randomPlaces(random, icebergs));
    for (std::size_t k = 0; unlike && k < request.uavs.size(); ++k)
        request.uavs[k].distance_m *= 1 + 0.2 * static_cast<double>(k);
    return request;
}

/** Returns the request with about this share of its icebergs available. */
inline PlanRequest thinnedOut(PlanRequest request, Random& random, double share)
{
    for (UavRequest& uav : request.uavs)
        for (std::size_t k = 0; k < uav.available.size(); ++k)
            uav.available[k] = random.uniform() < share;
    return request;
}

/** Returns the request that UAV k would make alone. */
inline PlanRequest aloneOf(const PlanRequest& request, std::size_t k)
{
    PlanRequest alone = request;
    alone.uavs = {request.uavs[k]};
    return alone;
}

/** Returns the request with nothing available to UAV k. */
inline PlanRequest withoutUav(PlanRequest request, std::size_t k)
{
    request.uavs[k].available.assign(request.ids.size(), false);
    return request;
}

/** Returns the request without the iceberg of this id for any UAV. */
inline PlanRequest withoutIceberg(PlanRequest request, IcebergIndex id)
{
    for (UavRequest& uav : request.uavs)
        uav.available[toIndex(nodeOf(request.ids, id)) - 1] = false;
    return request;
}

} // namespace berg::test
