#include "core/bound/true_motion.h"

#include "core/scenario/initial_truth.h"
#include "core/tracking/drift.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <memory>

namespace berg {

namespace {

struct PlaceInTime
{
    double time_s = 0;
    Point position_m = Point::Zero();
};

/**
 * Returns the instants, strictly between the two and ascending, at which the motion may have a
 * corner.
 */
std::vector<double> corners_s(const Scenario& scenario, const Iceberg& iceberg, bool isForced,
                              double from_s, double to_s)
{
    if (!iceberg.track.empty()) {
        const std::vector<double>& times_s = iceberg.track.time_s;
        return {std::upper_bound(times_s.begin(), times_s.end(), from_s),
                std::lower_bound(times_s.begin(), times_s.end(), to_s)};
    }
    std::vector<double> corners; // Drawn motion is linear between whole seconds.
    if (scenario.noise || isForced || iceberg.velocityTime_s > 0)
        for (double s = std::floor(from_s) + 1; s < to_s; s += 1)
            corners.push_back(s);
    return corners;
}

double farthestFromChord_m(const std::vector<PlaceInTime>& points, const PlaceInTime& from,
                           const PlaceInTime& to)
{
    double farthest_m = 0;
    for (const PlaceInTime& p : points) {
        const double share = (p.time_s - from.time_s) / (to.time_s - from.time_s);
        const Point chord_m = from.position_m + share * (to.position_m - from.position_m);
        farthest_m = std::max(farthest_m, (p.position_m - chord_m).norm());
    }
    return farthest_m;
}

} // namespace

TrueMotion::TrueMotion(const Scenario& scenario, const std::stop_token& stop)
    : m_dt_s(scenario.dt_s)
{
    // The number of steps is the one that the simulation flies.
    const std::int64_t steps =
        std::max<std::int64_t>(1, std::llround(scenario.duration_s / scenario.dt_s));
    const std::int64_t blocks = std::min(steps, kMostBlocks);
    for (std::int64_t b = 0; b <= blocks; ++b)
        m_edges.push_back(steps * b / blocks);
    const std::shared_ptr<const FlightWeather> weather = weatherOf(scenario);
    for (const Iceberg& iceberg : scenario.icebergs)
        m_paths.push_back(pathOf(scenario, weather, iceberg, stop));
}

TrueMotion::Path TrueMotion::pathOf(const Scenario& scenario,
                                    const std::shared_ptr<const FlightWeather>& weather,
                                    const Iceberg& iceberg, const std::stop_token& stop) const
{
    const DriftSpec spec = trueDrift(scenario, iceberg, weather);
    const bool isForced = spec.forcing != nullptr;
    DriftModel drift(spec, static_cast<std::uint64_t>(scenario.seed), iceberg.id, scenario.noise);
    Path path;
    PlaceInTime last{.time_s = 0, .position_m = drift.position_m(0)};
    path.position_m.push_back(last.position_m);
    for (int b = 0; b < blocks() && !stop.stop_requested(); ++b) {
        std::vector<PlaceInTime> between;
        for (const double corner_s :
             corners_s(scenario, iceberg, isForced, last.time_s, edge_s(b + 1)))
            between.push_back({.time_s = corner_s, .position_m = drift.position_m(corner_s)});
        const PlaceInTime next{.time_s = edge_s(b + 1),
                               .position_m = drift.position_m(edge_s(b + 1))};
        path.position_m.push_back(next.position_m);
        path.offChord_m.push_back(farthestFromChord_m(between, last, next));
        last = next;
    }
    return path;
}

Circle TrueMotion::enclosure(int iceberg, int fromEdge, int toEdge, const Point& velocity_mps) const
{
    const Path& path = m_paths[at(iceberg)];
    const auto inFrame = [&](int edge) -> Point {
        return path.position_m[at(edge)] - velocity_mps * (edge_s(edge) - edge_s(fromEdge));
    };
    Eigen::AlignedBox2d box;
    double offChord_m = 0;
    for (int edge = fromEdge; edge <= toEdge; ++edge) {
        box.extend(inFrame(edge));
        if (edge > fromEdge)
            offChord_m = std::max(offChord_m, path.offChord_m[at(edge - 1)]);
    }
    Circle result{.centre_m = box.center()};
    for (int edge = fromEdge; edge <= toEdge; ++edge)
        result.radius_m = std::max(result.radius_m, (inFrame(edge) - result.centre_m).norm());
    result.radius_m += offChord_m;
    return result;
}

} // namespace berg
