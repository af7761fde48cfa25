#include "core/bound/remains_in_area.h"

#include "core/scenario/flight_weather.h"
#include "core/tracking/drift.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace berg {

namespace {

constexpr std::int64_t kSecondsPerCheck = 4096;

/** The drift of one iceberg, whose estimate is compared with start + v t. */
struct IcebergRun
{
    const Scenario& scenario;
    const Iceberg& iceberg;
    Point velocity_mps = Point::Zero();
    std::int64_t seconds = 0; ///< Duration of the run, rounded up.
};

bool trackKeepsWithin(const IcebergRun& drift, double clearance_m)
{
    const RecordedTrack& track = drift.iceberg.track;
    const auto isWithin = [&](double s) {
        return (track.at(s) - drift.iceberg.position_m - drift.velocity_mps * s).norm() <
               clearance_m;
    };
    // Between these instants the iceberg moves along a line.
    return isWithin(0) && isWithin(static_cast<double>(drift.seconds)) &&
           std::all_of(track.time_s.begin(), track.time_s.end(), [&](double s) {
               return s < 0 || s > drift.scenario.duration_s + 1 || isWithin(s);
           });
}

bool noiseKeepsWithin(const IcebergRun& drift, double clearance_m, const std::stop_token& stop)
{
    DriftModel noise({.q_m2ps = drift.iceberg.q_m2ps},
                     static_cast<std::uint64_t>(drift.scenario.seed), drift.iceberg.id,
                     drift.scenario.noise);
    const double fastest_mps = noise.speedLimit_mps();
    for (std::int64_t second = 0; second <= drift.seconds; ++second) {
        if (second % kSecondsPerCheck == 0 && stop.stop_requested())
            return false;
        const double left_m = clearance_m - noise.position_m(static_cast<double>(second)).norm();
        if (left_m <= 0)
            return false;
        if (left_m > fastest_mps * static_cast<double>(drift.seconds - second))
            return true; // No further noise can take the iceberg out of the area.
    }
    return true;
}

} // namespace

bool remainsInArea(const Scenario& scenario, const Iceberg& iceberg, const std::stop_token& stop)
{
    if (stop.stop_requested())
        return false;
    if (scenario.area_m.empty())
        return true;
    if (scenario.observer.model == ObserverModel::Kalman ||
        !insidePolygon(scenario.area_m, iceberg.position_m))
        return false;
    if (forcingOf(weatherOf(scenario), iceberg)) // its estimate does not follow a straight line
        return false;
    // After a sighting at s the estimate at t is truth(s) + v (t - s), which is as far from start +
    // v t as the truth was at s.
    const IcebergRun drift{.scenario = scenario,
                           .iceberg = iceberg,
                           .velocity_mps = iceberg.velocity_mps + meanDrift_mps(scenario, iceberg),
                           .seconds = static_cast<std::int64_t>(std::ceil(scenario.duration_s))};
    const Point end_m = iceberg.position_m + drift.velocity_mps * scenario.duration_s;
    const double clearance_m = distanceToEdges(scenario.area_m, iceberg.position_m, end_m);
    return iceberg.track.empty() ? noiseKeepsWithin(drift, clearance_m, stop)
                                 : trackKeepsWithin(drift, clearance_m);
}

} // namespace berg
