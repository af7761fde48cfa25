#include "core/bound/leg_times.h"

#include "core/vehicle/dubins.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace berg {

namespace {

/** This exceeds the rounding of positions in a run. */
constexpr double kPositionSlack_m = 1e-3;
/** Times of flight are reduced by this share, which exceeds their rounding. */
constexpr double kLegRounding = 1e-9;
/** Above this share of the airspeed the direction of the wind is not used. */
constexpr double kStrongLegWind = 0.95;
/** Each iceberg has this number of legs in a frame that moves with both ends. */
constexpr int kNearest = 12;

/** An imaginary UAV with the largest view and the highest airspeed of all UAVs. */
struct BestUav
{
    Point half_m = Point::Zero();
    bool isDisk = true;
    double airspeed_mps = 0;
};

Point viewHalf_m(const Uav& uav, FovShape shape)
{
    if (shape != FovShape::North)
        return Point::Constant(FieldOfView::reach_m({.fov_m = uav.fov_m, .shape = shape}));
    return Point(uav.fov_m.y(), uav.fov_m.x()) / 2; // The first extent of the view points north.
}

BestUav bestUav(const Scenario& scenario)
{
    BestUav best{.isDisk = scenario.fovShape != FovShape::North};
    for (const Uav& uav : scenario.uavs) {
        best.half_m = best.half_m.cwiseMax(viewHalf_m(uav, scenario.fovShape));
        best.airspeed_mps = std::max(best.airspeed_mps, uav.spec.airspeed_mps);
    }
    return best;
}

/** The possible displacements of a leg, as a disk or a rectangle. */
struct Displacement
{
    Point centre_m = Point::Zero();
    Point half_m = Point::Zero();
    bool isDisk = true;
};

/**
 * Returns the least time of flight over all displacements. The time is convex in the displacement,
 * so it is nowhere below its tangent plane; the gradient is a / (U + a.W), where a is the unit
 * vector of the flight through the air.
 */
double least_s(const Displacement& leg, double airspeed_mps, Point wind_mps)
{
    if (wind_mps.norm() > kStrongLegWind * airspeed_mps) {
        airspeed_mps += wind_mps.norm();
        wind_mps.setZero();
    }
    const double middle_s = flightTime_s(leg.centre_m, airspeed_mps, wind_mps);
    if (!(middle_s > 0))
        return 0;
    const Point air = (leg.centre_m / middle_s - wind_mps) / airspeed_mps;
    const Point slope_spm = air / (airspeed_mps + air.dot(wind_mps));
    const double off_s =
        leg.isDisk ? slope_spm.norm() * leg.half_m.x() : slope_spm.cwiseAbs().dot(leg.half_m);
    return std::max(0.0, middle_s * (1 - kLegRounding) - off_s);
}

double leastBothWays_s(Displacement leg, double airspeed_mps, const Point& wind_mps)
{
    const double there_s = least_s(leg, airspeed_mps, wind_mps);
    leg.centre_m = -leg.centre_m;
    return std::min(there_s, least_s(leg, airspeed_mps, wind_mps));
}

Displacement between(const Circle& a, const Circle& b, const BestUav& uav)
{
    Displacement leg{
        .centre_m = b.centre_m - a.centre_m, .half_m = 2 * uav.half_m, .isDisk = uav.isDisk};
    leg.half_m.array() += a.radius_m + b.radius_m + 2 * kPositionSlack_m;
    return leg;
}

Point shift_m(const TrueMotion& motion, int iceberg, EdgeRange range)
{
    return motion.position_m(iceberg, range.to) - motion.position_m(iceberg, range.from);
}

} // namespace

LegTimes::LegTimes(const Scenario& scenario, const TrueMotion& motion,
                   std::span<const int> icebergs, EdgeRange range, const std::stop_token& stop)
    : m_size(static_cast<int>(icebergs.size())), m_legs_s(icebergs.size() * icebergs.size(), 0.0)
{
    const auto n = icebergs.size();
    const BestUav uav = bestUav(scenario);
    const double range_s = motion.edge_s(range.to) - motion.edge_s(range.from);
    Point mean_mps = Point::Zero();
    for (const int i : icebergs)
        mean_mps += shift_m(motion, i, range) / (range_s * static_cast<double>(n));
    std::vector<Circle> circles;
    for (const int i : icebergs)
        circles.push_back(motion.enclosure(i, range.from, range.to, mean_mps));
    for (std::size_t a = 0; a < n && !stop.stop_requested(); ++a)
        for (std::size_t b = a + 1; b < n; ++b)
            m_legs_s[a * n + b] = m_legs_s[b * n + a] =
                leastBothWays_s(between(circles[a], circles[b], uav), uav.airspeed_mps,
                                scenario.wind_mps - mean_mps);
    // Near icebergs have a second bound in a frame of their own, in which they move less.
    std::vector<std::size_t> others(n);
    for (std::size_t a = 0; a < n && !stop.stop_requested(); ++a) {
        std::iota(others.begin(), others.end(), std::size_t{0});
        // The list includes the iceberg itself.
        const std::size_t near = std::min<std::size_t>(n, kNearest + 1);
        std::partial_sort(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(near),
                          others.end(), [&](std::size_t x, std::size_t y) {
                              const double dx_m =
                                  (circles[x].centre_m - circles[a].centre_m).norm();
                              const double dy_m =
                                  (circles[y].centre_m - circles[a].centre_m).norm();
                              return dx_m != dy_m ? dx_m < dy_m : x < y;
                          });
        for (std::size_t k = 0; k < near; ++k) {
            const std::size_t b = others[k];
            if (b == a)
                continue;
            const Point both_mps =
                (shift_m(motion, icebergs[a], range) + shift_m(motion, icebergs[b], range)) /
                (2 * range_s);
            const double leg_s = leastBothWays_s(
                between(motion.enclosure(icebergs[a], range.from, range.to, both_mps),
                        motion.enclosure(icebergs[b], range.from, range.to, both_mps), uav),
                uav.airspeed_mps, scenario.wind_mps - both_mps);
            m_legs_s[a * n + b] = std::max(m_legs_s[a * n + b], leg_s);
            m_legs_s[b * n + a] = m_legs_s[a * n + b];
        }
    }
}

double firstLeg_s(const Scenario& scenario, const TrueMotion& motion, const Uav& uav, int iceberg,
                  int to)
{
    const EdgeRange range{.from = 0, .to = to};
    const Point velocity_mps = shift_m(motion, iceberg, range) / motion.edge_s(to);
    const Circle circle = motion.enclosure(iceberg, 0, to, velocity_mps);
    Displacement leg{.centre_m = circle.centre_m - uav.position_m,
                     .half_m = viewHalf_m(uav, scenario.fovShape),
                     .isDisk = scenario.fovShape != FovShape::North};
    leg.half_m.array() += circle.radius_m + kPositionSlack_m;
    return least_s(leg, uav.spec.airspeed_mps, scenario.wind_mps - velocity_mps);
}

} // namespace berg
