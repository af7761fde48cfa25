#include "core/scenario/scenario.h"

namespace berg {

double initialSigma_m2(const Iceberg& iceberg)
{
    return initialTrack(iceberg, ObserverModel::Kalman).sigma_m2;
}

Track initialTrack(const Iceberg& iceberg, ObserverModel model)
{
    Track track{.anchor_m = iceberg.position_m,
                .velocity_mps = iceberg.velocity_mps,
                .sigma_m2 = iceberg.sigma0_m2,
                .q_m2ps = iceberg.q_m2ps,
                .velocity_m2ps2 = iceberg.velocitySd_mps * iceberg.velocitySd_mps};
    track.grow(iceberg.observed_s);
    if (model == ObserverModel::Simple) // from now on the velocity is the one given
        track.mixed_m2ps = track.velocity_m2ps2 = 0;
    return track;
}

} // namespace berg
