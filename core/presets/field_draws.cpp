#include "core/presets/field_draws.h"

#include <cmath>

namespace berg {

namespace {

/** Rounds to multiples of 1/`perUnit`. */
double rounded(double value, double perUnit)
{
    return std::round(value * perUnit) / perUnit;
}

double draw(const Span& span, Random& random)
{
    return random.uniform(span.low, span.high);
}

constexpr double kPerMetre = 100;
constexpr double kPerSpeed = 10000;
constexpr double kPerSigma = 1000;

} // namespace

Point drawPosition(const FieldDraws& draws, Random& random)
{
    const double east_m = draw({draws.low_m.x(), draws.high_m.x()}, random);
    const double north_m = draw({draws.low_m.y(), draws.high_m.y()}, random);
    return {rounded(east_m, kPerMetre), rounded(north_m, kPerMetre)};
}

Iceberg drawIceberg(const FieldDraws& draws, const Point& position_m, Random& random)
{
    Iceberg iceberg;
    iceberg.position_m = position_m;
    const double speed_mps = draw(draws.speed_mps, random);
    const double direction_rad = draw(draws.direction_rad, random);
    iceberg.velocity_mps = {rounded(speed_mps * std::cos(direction_rad), kPerSpeed),
                            rounded(speed_mps * std::sin(direction_rad), kPerSpeed)};
    iceberg.sigma0_m2 = rounded(draw(draws.sigma_m2, random), kPerSigma);
    iceberg.q_m2ps = draws.q_m2ps;
    return iceberg;
}

} // namespace berg
