#include "core/scenario/initial_truth.h"

#include "core/base/random.h"

#include <cmath>

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
                    bool noise, const Point& current_mps, double start_s)
{
    const InitialTruth start = initialTruth(iceberg, observer, seed, noise);
    const bool isConstant = observer.model == ObserverModel::Simple;
    return {.position_m = start.position_m,
            .start_s = start_s,
            .velocity_mps = start.velocity_mps + current_mps,
            .q_m2ps = iceberg.q_m2ps,
            .mean_mps = current_mps,
            .velocitySpread_mps = isConstant ? 0 : iceberg.velocitySpread_mps,
            .velocityTime_s = isConstant ? 0 : iceberg.velocityTime_s,
            .track = iceberg.track.empty() ? nullptr
                                           : std::make_shared<const RecordedTrack>(iceberg.track)};
}

} // namespace berg
