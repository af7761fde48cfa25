#include "core/bound/stays_inside.h"

#include "core/tracking/drift.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace berg {

namespace {

/** Seen at s, the estimate at t is truth(s) + v (t - s): so far it can be from start + v t. */
double farthestOff_m(const Scenario& scenario, const Iceberg& iceberg, const Point& velocity_mps)
{
    DriftModel drift({.position_m = iceberg.position_m,
                      .velocity_mps = velocity_mps,
                      .q_m2ps = iceberg.q_m2ps,
                      .track = iceberg.track.empty()
                                   ? nullptr
                                   : std::make_shared<const RecordedTrack>(iceberg.track)},
                     static_cast<std::uint64_t>(scenario.seed), iceberg.id, scenario.noise);
    // Between these instants it moves along a line.
    std::vector<double> corners_s = iceberg.track.time_s;
    for (double second = 0; second < scenario.duration_s + 1; second += 1)
        corners_s.push_back(second);
    std::erase_if(corners_s, [&](double s) { return s < 0 || s > scenario.duration_s + 1; });
    std::sort(corners_s.begin(), corners_s.end());
    double off_m = 0;
    for (const double s : corners_s)
        off_m =
            std::max(off_m, (drift.position_m(s) - iceberg.position_m - velocity_mps * s).norm());
    return off_m;
}

} // namespace

bool staysInside(const Scenario& scenario, const Iceberg& iceberg)
{
    if (scenario.area_m.empty())
        return true;
    if (scenario.observer.model == ObserverModel::Kalman)
        return false;
    const Point velocity_mps = iceberg.velocity_mps + scenario.current_mps;
    const double off_m = farthestOff_m(scenario, iceberg, velocity_mps);
    const Point end_m = iceberg.position_m + velocity_mps * scenario.duration_s;
    return insidePolygon(scenario.area_m, iceberg.position_m) &&
           distanceToEdges(scenario.area_m, iceberg.position_m, end_m) > off_m;
}

} // namespace berg
