#include "core/scenario/initial_truth.h"

#include "core/base/random.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace berg {

InitialTruth initialTruth(const Iceberg& iceberg, const ObserverSpec& observer, std::uint64_t seed,
                          bool noise)
{
    InitialTruth start{.position_m = iceberg.position_m, .velocity_mps = iceberg.velocity_mps};
    if (observer.model == ObserverModel::Simple || !noise || !iceberg.track.empty())
        return start;
    Random random(seed, stableHash(iceberg.id + "/start"));
    // The unknown velocity has carried the iceberg away since it was last seen.
    const double sd_m = std::sqrt(iceberg.sigma0_m2 + iceberg.q_m2ps * iceberg.observed_s);
    for (Eigen::Index axis = 0; axis < 2; ++axis)
        start.position_m[axis] += sd_m * random.normal();
    const VelocityStep since = velocityStep({.velocitySpread_mps = iceberg.velocitySpread_mps,
                                             .velocityTime_s = iceberg.velocityTime_s},
                                            iceberg.observed_s);
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
        const double off_mps = iceberg.velocitySd_mps * random.normal();
        start.velocity_mps[axis] += since.kept * off_mps;
        start.position_m[axis] += off_mps * since.carried_s;
        if (since.velocity_mps == 0)
            continue;
        const double changed = random.normal();
        start.velocity_mps[axis] += since.velocity_mps * changed;
        start.position_m[axis] += since.shared_m * changed + since.place_m * random.normal();
    }
    return start;
}

DriftSpec trueDrift(const Iceberg& iceberg, const ObserverSpec& observer, std::uint64_t seed,
                    bool noise, const Point& mean_mps, double start_s,
                    std::shared_ptr<const DriftForcing> forcing)
{
    const InitialTruth start = initialTruth(iceberg, observer, seed, noise);
    const bool isConstant = observer.model == ObserverModel::Simple;
    const Point startMean_mps =
        forcing ? forcing->mean_mps(start.position_m, DriftForcing::stepAt(start_s))
                      .value_or(Point(Point::Zero()))
                : mean_mps;
    return {.position_m = start.position_m,
            .start_s = start_s,
            .velocity_mps = start.velocity_mps + startMean_mps,
            .q_m2ps = iceberg.q_m2ps,
            .mean_mps = startMean_mps,
            .velocitySpread_mps = isConstant ? 0 : iceberg.velocitySpread_mps,
            .velocityTime_s = isConstant ? 0 : iceberg.velocityTime_s,
            .track = iceberg.track.empty() ? nullptr
                                           : std::make_shared<const RecordedTrack>(iceberg.track),
            .forcing = std::move(forcing)};
}

DriftSpec trueDrift(const ScenarioWorld& scenario, const Iceberg& iceberg,
                    const std::shared_ptr<const FlightWeather>& weather, double start_s)
{
    return trueDrift(iceberg, scenario.observer, static_cast<std::uint64_t>(scenario.seed),
                     scenario.noise, meanDrift_mps(scenario, iceberg), start_s,
                     forcingOf(weather, iceberg));
}

Track trackAtStart(const ScenarioWorld& scenario, const Iceberg& iceberg,
                   const std::shared_ptr<const FlightWeather>& weather, double start_s)
{
    const std::shared_ptr<const DriftForcing> forcing = forcingOf(weather, iceberg);
    const std::optional<Point> mean_mps =
        forcing ? forcing->mean_mps(iceberg.position_m, DriftForcing::stepAt(start_s))
                : meanDrift_mps(scenario, iceberg);
    Track track =
        initialTrack(iceberg, scenario.observer.model, mean_mps.value_or(Point(Point::Zero())));
    track.anchor_s = start_s;
    track.seen_s = start_s;
    track.isForced = forcing != nullptr || iceberg.length_m.has_value();
    track.setMean(mean_mps, start_s);
    return track;
}

void growUnseen(Track& track, const DriftForcing* forcing, double from_s, double until_s)
{
    // Steps in which the mean does not change are one, so that a constant forcing changes nothing.
    double grown_s = from_s;
    for (std::int64_t step = DriftForcing::stepAt(from_s) + 1;
         forcing != nullptr && static_cast<double>(step) * DriftForcing::kStep_s < until_s;
         ++step) {
        const double time_s = static_cast<double>(step) * DriftForcing::kStep_s;
        const std::optional<Point> mean_mps = forcing->mean_mps(track.estimate_m(time_s), step);
        if (mean_mps == track.mean_mps)
            continue;
        track.grow(time_s - grown_s);
        track.setMean(mean_mps, time_s);
        grown_s = time_s;
    }
    track.grow(std::max(0.0, until_s - grown_s));
}

} // namespace berg
