#include "core/scenario/priority.h"

#include <cmath>

namespace berg {

RelativeMotion relativeToAsset(const Asset& asset, double time_s, const Point& iceberg_m,
                               const Point& velocity_mps)
{
    return {.offset_m = iceberg_m - (asset.position_m + asset.velocity_mps * time_s),
            .velocity_mps = velocity_mps - asset.velocity_mps};
}

double priority(const Asset& asset, const RelativeMotion& motion)
{
    const double ratio = closestApproach(motion, kApproachHorizon_s).distance_m / asset.range_m;
    return 1 + asset.gain * std::exp(-ratio * ratio);
}

double alarmRadius_m(const Asset& asset)
{
    return asset.alarm_m.value_or(asset.range_m / 2);
}

} // namespace berg
