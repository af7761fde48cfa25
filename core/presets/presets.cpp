#include "core/presets/presets.h"

#include "core/base/angles.h"
#include "core/presets/field_draws.h"

#include <algorithm>
#include <utility>

namespace berg {

namespace {

constexpr double kUnknown_mps = 0.1;

Scenario inRegime(Scenario scenario, FieldRegime regime)
{
    switch (regime) {
    case FieldRegime::Published:
        break;
    case FieldRegime::UnknownVelocity:
        for (Iceberg& iceberg : scenario.icebergs)
            iceberg.velocitySd_mps = kUnknown_mps;
        [[fallthrough]];
    case FieldRegime::Measured:
        scenario.observer.model = ObserverModel::Kalman;
        break;
    case FieldRegime::FittedDrift:
        return withFittedDrift(std::move(scenario));
    }
    return scenario;
}

} // namespace

Scenario randomScenario(std::int64_t seed, const FieldSpec& field)
{
    require(seed >= 0, "randomScenario: the seed must be at least 0");
    require(field.icebergs >= 0, "randomScenario: the number of icebergs must be at least 0");

    Scenario scenario;
    scenario.name = "Random field " + std::to_string(seed) + ", " + std::to_string(field.icebergs) +
                    " icebergs";
    scenario.seed = seed;

    Uav uav;
    uav.id = "uav-1";
    uav.position_m = {-500, 500};
    uav.heading_deg = 45; // course of the paper's psi of 45 degrees
    scenario.uavs.push_back(std::move(uav));

    const FieldDraws draws{.low_m = Point::Zero(),
                           .high_m = field.size_m,
                           .speed_mps = {0, field.speedMax_mps},
                           .direction_rad = {0, 2 * kPi},
                           .sigma_m2 = {field.sigmaMin_m2, field.sigmaMax_m2},
                           .q_m2ps = field.q_m2ps};
    Random random(static_cast<std::uint64_t>(seed), stableHash("field"));
    for (int i = 1; i <= field.icebergs; ++i) {
        const Point position_m = drawPosition(draws, random);
        Iceberg iceberg = drawIceberg(draws, position_m, random);
        iceberg.id = "berg-" + std::to_string(i);
        scenario.icebergs.push_back(std::move(iceberg));
    }
    return inRegime(std::move(scenario), field.regime);
}

void driftAsFitted(Iceberg& iceberg)
{
    iceberg.velocity_mps = Point::Zero();
    iceberg.velocitySd_mps = kFittedDrift.velocitySpread_mps;
    iceberg.velocitySpread_mps = kFittedDrift.velocitySpread_mps;
    iceberg.velocityTime_s = kFittedDrift.velocityTime_s;
}

Scenario withFittedDrift(Scenario scenario)
{
    scenario.observer.model = ObserverModel::Kalman;
    std::ranges::for_each(scenario.icebergs, driftAsFitted);
    return scenario;
}

Scenario defaultScenario()
{
    Scenario scenario = randomScenario(1);
    scenario.name = "Grand Banks, 12 icebergs";
    scenario.origin = {47, -48};
    return scenario;
}

} // namespace berg
