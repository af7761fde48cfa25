#include "core/scenario/scenario.h"

namespace berg {

double initialSigma_m2(const Iceberg& iceberg)
{
    return initialTrack(iceberg, ObserverModel::Kalman).sigma_m2;
}

Track initialTrack(const Iceberg& iceberg, ObserverModel model, const Point& current_mps)
{
    Track track{.anchor_m = iceberg.position_m,
                .velocity_mps = iceberg.velocity_mps + current_mps,
                .sigma_m2 = iceberg.sigma0_m2,
                .q_m2ps = iceberg.q_m2ps,
                .velocity_m2ps2 = iceberg.velocitySd_mps * iceberg.velocitySd_mps,
                .mean_mps = current_mps,
                .velocitySpread_mps = iceberg.velocityTime_s > 0 ? iceberg.velocitySpread_mps : 0,
                .velocityTime_s = iceberg.velocityTime_s};
    track.setVariances(grown(track.variances(), track.process(), iceberg.observed_s));
    if (model == ObserverModel::Simple) { // the velocity is known from now on
        track.mixed_m2ps = track.velocity_m2ps2 = 0;
        track.velocitySpread_mps = track.velocityTime_s = 0;
    }
    return track;
}

} // namespace berg
