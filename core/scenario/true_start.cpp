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
    const double sd_m = std::sqrt(initialSigma_m2(iceberg));
    for (Eigen::Index axis = 0; axis < 2; ++axis)
        start.position_m[axis] += sd_m * random.normal();
    for (Eigen::Index axis = 0; axis < 2; ++axis)
        start.velocity_mps[axis] += iceberg.velocitySd_mps * random.normal();
    return start;
}

} // namespace berg
