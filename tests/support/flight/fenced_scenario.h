#pragma once

#include "core/base/angles.h"
#include "core/base/random.h"
#include "core/presets/presets.h"
#include "core/vehicle/geofence.h"

#include <cmath>

namespace berg::test {

/**
 * Returns `randomScenario` in a random star of 6 to 15 corners, usually concave: icebergs outside
 * are moved inside, and the UAV starts two turn circles from the fence. `area_m` is a geofence by
 * default.
 */
inline Scenario fencedScenario(std::int64_t seed, const Point& wind_mps = Point::Zero())
{
    Scenario s = randomScenario(seed);
    s.wind_mps = wind_mps;
    s.geofence = true;
    Random random(static_cast<std::uint64_t>(seed), 99);
    const auto corners = static_cast<int>(6 + random.below(10));
    for (int i = 0; i < corners; ++i) {
        const double angle_rad = 2 * kPi * (i + random.uniform(-0.3, 0.3)) / corners;
        const Point away_m =
            random.uniform(900, 3500) * Point(std::cos(angle_rad), std::sin(angle_rad));
        s.area_m.push_back(Point(2500, 2000) + away_m);
    }
    const auto anywhere_m = [&random] {
        const double x_m = random.uniform(-1000, 6000);
        return Point(x_m, random.uniform(-1500, 5500));
    };
    for (Iceberg& iceberg : s.icebergs) {
        iceberg.velocity_mps *= 0.25; // so that few of them leave
        while (!insidePolygon(s.area_m, iceberg.position_m))
            iceberg.position_m = anywhere_m();
    }
    Uav& uav = s.uavs[0];
    const Geofence fence(s.area_m, {.airspeed_mps = uav.spec.airspeed_mps,
                                    .limit_radps = maxTurnRate_radps(uav.spec),
                                    .wind_mps = wind_mps});
    do
        uav.position_m = anywhere_m();
    while (!fence.contains(uav.position_m) ||
           distanceToEdges(s.area_m, uav.position_m) < 2 * fence.radius_m());
    uav.heading_deg = random.uniform(0, 360);
    return s;
}

} // namespace berg::test
