#include "core/scenario/true_start.h"

#include "core/base/random.h"

#include <cmath>

namespace berg {

TrueStart trueStart(const Iceberg& iceberg, const ObserverSpec& observer, std::uint64_t seed,
                    bool noise)
{
    TrueStart start{.position_m = iceberg.position_m, .velocity_mps = iceberg.velocity_mps};
    if (observer.model == ObserverModel::Simple || !noise || !iceberg.track.empty())
        return start;
    Random random(seed, stableHash(iceberg.id + "/start"));
    // Since it was last seen the velocity that nobody knows has carried it away.
    const double sd_m = std::sqrt(iceberg.sigma0_m2 + iceberg.q_m2ps * iceberg.observed_s);
    for (Eigen::Index axis = 0; axis < 2; ++axis)
        start.position_m[axis] += sd_m * random.normal();
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
        const double off_mps = iceberg.velocitySd_mps * random.normal();
        start.velocity_mps[axis] += off_mps;
        start.position_m[axis] += off_mps * iceberg.observed_s;
    }
    return start;
}

} // namespace berg
