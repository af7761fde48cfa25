#include "core/coverage/aimed_path.h"

#include "core/base/angles.h"
#include "core/vehicle/tangent_turn.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace berg {

namespace {

constexpr double kLongestArc_rad = 0.1;
/** Lines shorter than this have no direction of their own. */
constexpr double kShortestLine_m = 1e-3;
/** A turn that ends early by less than this was flown to its end. */
constexpr double kSameCourse_rad = 1e-3;

Point unit(double psi_rad)
{
    return {std::cos(psi_rad), std::sin(psi_rad)};
}

/** The place of a leg in the plan. */
struct LaidLeg
{
    Point start_m = Point::Zero();
    double psi_rad = 0;  ///< Course at the beginning of the leg.
    double turn_rad = 0; ///< Flown part of the turn.
    bool whole = true;   ///< The leg does not end in its turn.
};

class PathOfLegs
{
public:
    PathOfLegs(std::span<const AimedLeg> legs, const Motion& motion)
        : m_legs(legs), m_motion(motion), m_radius_m(motion.airspeed_mps / motion.limit_radps)
    {
    }

    [[nodiscard]] std::vector<AimedPath> from(const DubinsState& uav, double time_s) const
    {
        const std::vector<LaidLeg> laid = layOut(uav);
        std::vector<AimedPath> paths;
        for (std::size_t k = 0; k < laid.size(); ++k) {
            std::vector<PathPoint> path{{.position_m = laid[k].start_m, .time_s = time_s}};
            if (k + 1 < laid.size())
                flyTo(path, laid[k], laid[k + 1].start_m);
            else
                flyUntil(path, laid[k], m_legs[k].end_s.value_or(m_legs[k].sighting_s));
            time_s = path.back().time_s;
            paths.push_back({.points = std::move(path)});
            if (!m_legs[k].end_s)
                paths.back().aim_m = m_legs[k].abeam_m;
        }
        return paths;
    }

private:
    [[nodiscard]] double turnTime_s(double turn_rad) const
    {
        return std::abs(turn_rad) / m_motion.limit_radps;
    }

    /** Returns the displacement over ground of a turn that begins at `psi_rad`. */
    [[nodiscard]] Point turned_m(double psi_rad, double turn_rad) const
    {
        const Pose end = turnedTo({.ahead = unit(psi_rad)}, unit(psi_rad + turn_rad),
                                  turn_rad < 0 ? -1 : 1, m_radius_m);
        return end.position_m + turnTime_s(turn_rad) * m_motion.wind_mps;
    }

    /** Returns the course through the air along a leg's line, or nullopt if the leg has no line. */
    [[nodiscard]] std::optional<double> lineCourse_rad(const AimedLeg& leg) const
    {
        const Point line_m = leg.abeam_m - leg.from_m;
        if (line_m.norm() < kShortestLine_m)
            return std::nullopt;
        const double time_s = flightTime_s(line_m, m_motion.airspeed_mps, m_motion.wind_mps);
        const Point air_mps = line_m / time_s - m_motion.wind_mps;
        return std::atan2(air_mps.y(), air_mps.x());
    }

    /** Finds the beginning of each leg, from which its turn leads onto its line. */
    [[nodiscard]] std::vector<LaidLeg> layOut(const DubinsState& uav) const
    {
        std::vector<LaidLeg> laid;
        double psi_rad = uav.psi_rad;
        for (const AimedLeg& leg : m_legs) {
            const double end_rad = lineCourse_rad(leg).value_or(psi_rad + leg.turn_rad);
            LaidLeg next{.start_m = uav.position_m,
                         .psi_rad = end_rad - leg.turn_rad,
                         .turn_rad = leg.turn_rad};
            if (!laid.empty()) {
                next.start_m = leg.from_m - turned_m(next.psi_rad, leg.turn_rad);
                breakOff(laid.back(), psi_rad, next.psi_rad);
            }
            laid.push_back(next);
            psi_rad = end_rad;
        }
        return laid;
    }

    /** Ends the turn to `end_rad` at the course with which the next leg begins. */
    static void breakOff(LaidLeg& leg, double end_rad, double next_rad)
    {
        const double side = leg.turn_rad < 0 ? -1 : 1;
        double left_rad = std::remainder(side * (end_rad - next_rad), 2 * kPi);
        if (left_rad < -kSameCourse_rad)
            left_rad += 2 * kPi;
        leg.whole = left_rad < kSameCourse_rad || left_rad > std::abs(leg.turn_rad);
        if (!leg.whole)
            leg.turn_rad -= side * left_rad;
    }

    void turn(std::vector<PathPoint>& path, const LaidLeg& leg, double turn_rad) const
    {
        const PathPoint start = path.back();
        const int arcs = static_cast<int>(std::ceil(std::abs(turn_rad) / kLongestArc_rad));
        for (int i = 1; i <= arcs; ++i) {
            const double part_rad = turn_rad * i / arcs;
            path.push_back({.position_m = start.position_m + turned_m(leg.psi_rad, part_rad),
                            .time_s = start.time_s + turnTime_s(part_rad)});
        }
    }

    void flyTo(std::vector<PathPoint>& path, const LaidLeg& leg, const Point& end_m) const
    {
        turn(path, leg, leg.turn_rad);
        if (!leg.whole) {
            path.back().position_m = end_m;
            return;
        }
        const Point line_m = end_m - path.back().position_m;
        path.push_back({.position_m = end_m,
                        .time_s = path.back().time_s +
                                  flightTime_s(line_m, m_motion.airspeed_mps, m_motion.wind_mps)});
    }

    void flyUntil(std::vector<PathPoint>& path, const LaidLeg& leg, double end_s) const
    {
        const double most_rad = std::max(0.0, end_s - path.back().time_s) * m_motion.limit_radps;
        turn(path, leg, std::clamp(leg.turn_rad, -most_rad, most_rad));
        const double left_s = end_s - path.back().time_s;
        if (left_s <= 0)
            return;
        const Point line_m = m_legs.back().abeam_m - path.back().position_m;
        if (line_m.norm() < kShortestLine_m)
            return;
        const double length_s = flightTime_s(line_m, m_motion.airspeed_mps, m_motion.wind_mps);
        path.push_back(
            {.position_m = path.back().position_m + line_m * std::min(1.0, left_s / length_s),
             .time_s = path.back().time_s + std::min(left_s, length_s)});
    }

    std::span<const AimedLeg> m_legs;
    const Motion& m_motion;
    double m_radius_m;
};

} // namespace

std::vector<AimedPath> aimedPaths(std::span<const AimedLeg> legs, const DubinsState& uav,
                                  double time_s, const Motion& motion)
{
    return PathOfLegs(legs, motion).from(uav, time_s);
}

double lengthUntil_m(std::span<const AimedPath> paths, double time_s)
{
    double length_m = 0;
    for (const AimedPath& path : paths)
        for (std::size_t i = 1; i < path.points.size(); ++i) {
            const PathPoint& from = path.points[i - 1];
            const PathPoint& to = path.points[i];
            if (time_s <= from.time_s)
                return length_m;
            const double span_s = to.time_s - from.time_s;
            const double share = span_s > 0 ? std::min(1.0, (time_s - from.time_s) / span_s) : 1;
            length_m += share * (to.position_m - from.position_m).norm();
        }
    return length_m;
}

} // namespace berg
