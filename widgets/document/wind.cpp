#include "widgets/document/wind.h"

#include "core/base/angles.h"
#include "widgets/document/scenario_edits.h"

#include <algorithm>
#include <cmath>

namespace berg {
namespace {

constexpr double kFinest_mps = 0.001; // rounding that keeps the numbers in files short

} // namespace

double slowestAirspeed_mps(const Scenario& scenario)
{
    const auto slowest = std::min_element(
        scenario.uavs.begin(), scenario.uavs.end(),
        [](const Uav& a, const Uav& b) { return a.spec.airspeed_mps < b.spec.airspeed_mps; });
    return slowest == scenario.uavs.end() ? 0 : slowest->spec.airspeed_mps;
}

double windFrom_deg(const Point& wind_mps)
{
    return wind_mps.isZero(0) ? 0 : headingFromPsi(std::atan2(-wind_mps.y(), -wind_mps.x()));
}

Point windOf(double speed_mps, double from_deg)
{
    const double psi_rad = psiFromHeading(from_deg);
    const Point towards(-std::cos(psi_rad), -std::sin(psi_rad));
    return roundedTo(speed_mps * towards, kFinest_mps) + Point::Zero(); // avoids -0 in files
}

double fastestWind_mps(double airspeed_mps, double step_mps)
{
    return std::max(0.0, std::ceil(airspeed_mps / step_mps) - 1) * step_mps;
}

} // namespace berg
