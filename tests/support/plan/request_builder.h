#pragma once

#include "core/base/random.h"
#include "core/geometry/geometry.h"
#include "core/plan/policy/fleet_task.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

// Small requests for the tests of policies and planner.

namespace berg::test {

/** An iceberg of a request. */
struct Place
{
    IcebergIndex id;
    Point position_m = Point::Zero();
    double sigma_m2 = 0;
};

inline PlanRequest requestOf(const Point& uav_m, const std::vector<Place>& places)
{
    PlanRequest request{.uavs = std::vector<UavRequest>(1), .sigma_m2 = {0}, .speed_mps = 25};
    UavRequest& uav = request.uavs.front();
    Eigen::MatrixX2d points_m(static_cast<Eigen::Index>(places.size()) + 1, 2);
    points_m.row(0) = uav_m.transpose();
    for (const Place& place : places) {
        request.ids.push_back(place.id);
        uav.available.push_back(true);
        points_m.row(static_cast<Eigen::Index>(request.ids.size())) = place.position_m.transpose();
        request.sigma_m2.push_back(place.sigma_m2);
    }
    uav.distance_m = euclideanDistances(points_m);
    return request;
}

/** Ids without any order, so that an id used as a node number is noticed. */
inline const std::vector<Place> kFive{{10, {1000, 0}, 2},
                                      {7, {0, 1500}, 9},
                                      {42, {3000, 500}, 5},
                                      {3, {3000, -1000}, 9},
                                      {5, {-2000, 500}, 1}};

inline PlanRequest five()
{
    return requestOf({0, 0}, kFive);
}

inline std::vector<Place> randomPlaces(Random& random, int count)
{
    std::vector<Place> places;
    for (int i = 0; i < count; ++i)
        places.push_back({IcebergIndex::of(100 - 7 * i),
                          {random.uniform(0, 5000), random.uniform(0, 4000)},
                          random.uniform(1, 10)});
    return places;
}

/** Returns the request with only these ids available. */
inline PlanRequest withAvailable(PlanRequest request, const std::set<IcebergIndex>& available)
{
    for (std::size_t k = 0; k < request.ids.size(); ++k)
        request.uavs[0].available[k] = available.contains(request.ids[k]);
    return request;
}

/** Returns the request with these ids in view and all others available. */
inline PlanRequest without(PlanRequest request, const std::set<IcebergIndex>& inView)
{
    for (std::size_t k = 0; k < request.ids.size(); ++k)
        request.uavs[0].available[k] = !inView.contains(request.ids[k]);
    return request;
}

inline double pathLength_m(const PlanRequest& request, const IcebergList& ids)
{
    double length_m = 0;
    NodeIndex from;
    for (const IcebergIndex id : ids) {
        const NodeIndex to = nodeOf(request.ids, id);
        length_m += legBetween(request.uavs[0].distance_m, from, to);
        from = to;
    }
    return length_m;
}

/** Calls `visit` with every order of the request's ids. */
template <class Visit>
void forEachOrder(const PlanRequest& request, const Visit& visit)
{
    IcebergList ids = request.ids;
    std::sort(ids.begin(), ids.end());
    do {
        visit(ids);
    } while (std::next_permutation(ids.begin(), ids.end()));
}

} // namespace berg::test
