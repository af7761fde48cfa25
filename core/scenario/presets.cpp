#include "core/scenario/presets.h"

#include "core/base/angles.h"
#include "core/base/random.h"

#include <cmath>

namespace berg {

namespace {

/** Rounded to 1/`perUnit`, so that tables and files show short numbers. */
double rounded(double value, double perUnit)
{
    return std::round(value * perUnit) / perUnit;
}

constexpr double kPerMetre = 100;
constexpr double kPerSpeed = 10000;
constexpr double kPerSigma = 1000;

/** One iceberg; the order of the draws is part of the preset and must not change. */
Iceberg drawIceberg(const FieldSpec& field, Random& random)
{
    Iceberg iceberg;
    iceberg.position_m.x() = rounded(random.uniform(0, field.size_m.x()), kPerMetre);
    iceberg.position_m.y() = rounded(random.uniform(0, field.size_m.y()), kPerMetre);
    const double speed_mps = random.uniform(0, field.speedMax_mps);
    const double direction_rad = random.uniform(0, 2 * kPi);
    iceberg.velocity_mps = {rounded(speed_mps * std::cos(direction_rad), kPerSpeed),
                            rounded(speed_mps * std::sin(direction_rad), kPerSpeed)};
    iceberg.sigma0_m2 = rounded(random.uniform(field.sigmaMin_m2, field.sigmaMax_m2), kPerSigma);
    iceberg.q_m2ps = field.q_m2ps;
    return iceberg;
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
    uav.heading_deg = 45; // the paper's psi of 45 degrees is the same course
    scenario.uavs.push_back(std::move(uav));

    Random random(static_cast<std::uint64_t>(seed), stableHash("field"));
    for (int i = 1; i <= field.icebergs; ++i) {
        Iceberg iceberg = drawIceberg(field, random);
        iceberg.id = "berg-" + std::to_string(i);
        scenario.icebergs.push_back(std::move(iceberg));
    }
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
