#include "core/vehicle/geofence.h"

#include "core/base/angles.h"
#include "core/base/error.h"
#include "core/vehicle/side_turn.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace berg {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
/** Entry of the matrix of paths where no path is known. */
constexpr int kNoCorner = -1;
/** Factor by which the circle over ground is wider than necessary. */
constexpr double kCircleMargin = 1.05;
/** A path passes a corner at a distance where this fraction of it is free of the fence. */
constexpr double kSpace = 0.95;
/**
 * The straight lines of a path pass a corner nearer than the point where they meet: half as near at
 * a bend of 120 degrees.
 */
constexpr double kNearer = 0.5;
/** Change of wind after which the paths between the corners are computed again. */
constexpr double kPathWind_mps = 0.5;

} // namespace

double circleOverGround_m(const Motion& motion)
{
    const double faster = 1 + motion.widestWind_mps() / motion.airspeed_mps;
    return kCircleMargin * faster * faster * motion.airspeed_mps / motion.limit_radps;
}

Geofence::Geofence(std::vector<Point> corners_m, const Motion& motion,
                   std::vector<std::vector<Point>> holes_m)
    : m_area(std::move(corners_m), std::move(holes_m)), m_motion(motion)
{
    std::size_t corners = 0;
    for (const std::vector<Point>& ring_m : m_area.rings_m())
        corners += ring_m.size();
    require(corners >= 3 && corners <= kMostFenceCorners, "Geofence: wrong number of corners");
    m_radius_m = circleOverGround_m(motion);
    placeCorners();
    connectCorners();
}

Geofence Geofence::inWind(const Point& wind_mps, double windLimit_mps) const
{
    Motion motion = m_motion;
    motion.wind_mps = wind_mps;
    motion.windLimit_mps = windLimit_mps;
    if (windLimit_mps > 0 &&
        circleOverGround_m(motion) == m_radius_m) { // the corners stay where they are
        Geofence fence = *this;
        fence.m_motion = motion;
        if ((wind_mps - m_pathWind_mps).norm() > kPathWind_mps)
            fence.connectCorners();
        return fence;
    }
    std::vector<std::vector<Point>> holes_m = m_area.rings_m();
    std::vector<Point> corners_m;
    if (m_area.isBounded()) {
        corners_m = std::move(holes_m.front());
        holes_m.erase(holes_m.begin());
    }
    return {std::move(corners_m), motion, std::move(holes_m)};
}

Point Geofence::beside_m(const Point& place_m) const
{
    return m_area.isInHole(place_m) ? nearestInside_m(place_m) : place_m;
}

/**
 * Integrates 1/speed over ground round all courses: the time lost upwind exceeds the time gained
 * downwind.
 */
double Geofence::circle_s() const
{
    const double airspeed_mps = m_motion.airspeed_mps;
    const double wind_mps = m_motion.wind_mps.norm();
    return 4 * m_radius_m * airspeed_mps * std::comp_ellint_2(wind_mps / airspeed_mps) /
           (airspeed_mps * airspeed_mps - wind_mps * wind_mps);
}

double Geofence::turnClearance_m(const DubinsState& state) const
{
    const Point over_mps =
        m_motion.airspeed_mps * Point(std::cos(state.psi_rad), std::sin(state.psi_rad)) +
        m_motion.wind_mps;
    const Point ahead = over_mps.normalized();
    const Point side_m = m_radius_m * Point(-ahead.y(), ahead.x());
    return std::max(m_area.signedClearance_m(state.position_m + side_m),
                    m_area.signedClearance_m(state.position_m - side_m)) -
           m_radius_m;
}

bool Geofence::isShutOff(const Point& place_m) const
{
    constexpr int kCourses = 24;
    int open = 0;
    for (int i = 0; i < kCourses; ++i)
        open += turnClearance_m({.position_m = place_m, .psi_rad = 2 * kPi * i / kCourses}) >= 0
                    ? 1
                    : 0;
    return open < kCourses / 2;
}

/**
 * A UAV that flies straight at a hole turns aside before its edge, by less than half a circle's
 * radius.
 */
bool Geofence::isOutOfReach(const Point& place_m, double reach_m) const
{
    return m_area.isInHole(place_m) &&
           (beside_m(place_m) - place_m).norm() + m_radius_m / 2 > reach_m;
}

double Geofence::circlingRate_radps(const DubinsState& state, double side) const
{
    const Point ahead(std::cos(state.psi_rad), std::sin(state.psi_rad));
    const Point over_mps = m_motion.airspeed_mps * ahead + m_motion.wind_mps;
    const double ground2_m2ps2 = over_mps.squaredNorm();
    // Course rate = heading rate x (airspeed x component of the heading along the course) / speed.
    const double gain = m_motion.airspeed_mps * ahead.dot(over_mps) / ground2_m2ps2;
    const double course_radps = std::sqrt(ground2_m2ps2) / m_radius_m;
    return std::clamp(side * course_radps / gain, -m_motion.limit_radps, m_motion.limit_radps);
}

void Geofence::placeCorners()
{
    for (const std::vector<Point>& ring_m : m_area.rings_m())
        for (std::size_t i = 0; i < ring_m.size(); ++i) {
            const Point& corner_m = ring_m[i];
            const Point in =
                (corner_m - ring_m[(i + ring_m.size() - 1) % ring_m.size()]).normalized();
            const Point out = (ring_m[(i + 1) % ring_m.size()] - corner_m).normalized();
            if (cross(in, out) < 0)
                placeCorner(corner_m, (in - out).normalized());
        }
}

/**
 * Places the point on the inward bisector: one radius off the corner, halved until there is space.
 */
void Geofence::placeCorner(const Point& corner_m, const Point& inwards)
{
    double space_m = m_radius_m;
    Point place_m = corner_m + space_m * inwards;
    for (int round = 0; round < 12; ++round) {
        if (m_area.signedClearance_m(place_m) >= kSpace * space_m)
            break;
        space_m /= 2;
        place_m = corner_m + space_m * inwards;
    }
    if (hasHoles() && !contains(place_m))
        return; // covered by another polygon
    m_reflex_m.push_back(corner_m);
    m_space_m.push_back(space_m);
    m_corners_m.push_back(place_m);
}

bool Geofence::isClear(const Point& a, const Point& b) const
{
    if (m_area.meetsEdge(a, b))
        return false;
    for (std::size_t k = 0; k < m_reflex_m.size(); ++k) {
        const Point& corner_m = m_reflex_m[k];
        const double least_m =
            kNearer * std::min({m_space_m[k], (a - corner_m).norm(), (b - corner_m).norm()});
        if (distanceToSegment(a, b, corner_m) < least_m)
            return false;
    }
    return true;
}

double Geofence::air_m(const Point& from_m, const Point& to_m) const
{
    return m_motion.airspeed_mps *
           flightTime_s(to_m - from_m, m_motion.airspeed_mps, m_motion.wind_mps);
}

/** Computes all shortest paths between the corners (Floyd-Warshall). */
void Geofence::connectCorners()
{
    m_pathWind_mps = m_motion.wind_mps;
    const auto n = static_cast<Eigen::Index>(m_corners_m.size());
    const auto at = [this](Eigen::Index i) { return m_corners_m[static_cast<std::size_t>(i)]; };
    m_path_m = Eigen::MatrixXd::Constant(n, n, kFar);
    m_next = Eigen::MatrixXi::Constant(n, n, kNoCorner);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
            if (i == j || isClear(at(i), at(j))) {
                m_path_m(i, j) = air_m(at(i), at(j));
                m_next(i, j) = static_cast<int>(j);
            }
    for (Eigen::Index k = 0; k < n; ++k)
        for (Eigen::Index i = 0; i < n; ++i)
            for (Eigen::Index j = 0; j < n; ++j)
                if (m_path_m(i, k) + m_path_m(k, j) < m_path_m(i, j)) {
                    m_path_m(i, j) = m_path_m(i, k) + m_path_m(k, j);
                    m_next(i, j) = m_next(i, k);
                }
}

std::vector<Geofence::Sight> Geofence::sights(const Point& place_m) const
{
    std::vector<Sight> seen;
    for (std::size_t k = 0; k < m_corners_m.size(); ++k)
        if (isClear(place_m, m_corners_m[k]))
            seen.push_back({.corner = static_cast<int>(k),
                            .from_m = air_m(place_m, m_corners_m[k]),
                            .to_m = air_m(m_corners_m[k], place_m)});
    return seen;
}

std::vector<Point> Geofence::cornersBetween(const Point& start_m, const Point& end_m) const
{
    const Point from_m = beside_m(start_m);
    const Point to_m = beside_m(end_m);
    if (isClear(from_m, to_m))
        return {};
    double best_m = kFar;
    std::optional<std::pair<int, int>> ends; // first and last corner
    const std::vector<Sight> arriving = sights(to_m);
    for (const Sight& a : sights(from_m))
        for (const Sight& b : arriving) {
            const double path_m = a.from_m + m_path_m(a.corner, b.corner) + b.to_m;
            if (path_m < best_m) {
                best_m = path_m;
                ends = {a.corner, b.corner};
            }
        }
    if (!ends)
        return {};
    auto [first, last] = *ends;
    std::vector<Point> corners{m_corners_m[static_cast<std::size_t>(first)]};
    while (first != last) {
        first = m_next(first, last);
        corners.push_back(m_corners_m[static_cast<std::size_t>(first)]);
    }
    return corners;
}

/**
 * Returns the quicker path among the turns to the left and to the right that keep the fence. If
 * neither does, returns the one that violates it less: the guard of the fence corrects the rest.
 */
std::optional<Path> Geofence::legTo(const DubinsState& start, const MovingPlace& place,
                                    double command_s) const
{
    if ((m_motion.wind_mps - place.drift_mps).norm() >= m_motion.airspeed_mps)
        return std::nullopt;
    std::optional<Path> best;
    double bestClearance_m = 0;
    for (const double side : {1.0, -1.0}) {
        const SideTurn turn(start, place, m_motion, command_s, side);
        const std::optional<Path> path = turn.find();
        if (!path)
            continue;
        const double clearance_m = std::min(0.0, clearanceOnTurn_m(turn, std::abs(path->turn_rad)));
        const bool better = clearance_m != bestClearance_m ? clearance_m > bestClearance_m
                                                           : best && path->time_s < best->time_s;
        if (!best || better) {
            best = path;
            bestClearance_m = clearance_m;
        }
    }
    return best;
}

/** Returns the least clearance along the turn. */
double Geofence::clearanceOnTurn_m(const SideTurn& turn, double turn_rad) const
{
    constexpr double kSample_rad = kPi / 12;
    double least_m = turnClearance_m(turn.turned(turn_rad));
    for (double turned_rad = kSample_rad; turned_rad < turn_rad; turned_rad += kSample_rad)
        least_m = std::min(least_m, turnClearance_m(turn.turned(turned_rad)));
    return least_m;
}

std::optional<Path> Geofence::pathTo(const DubinsState& start, const MovingPlace& place,
                                     double command_s) const
{
    const std::vector<Point> corners_m = cornersBetween(start.position_m, place.place_m);
    Path path{.end = start};
    for (std::size_t k = 0; k <= corners_m.size(); ++k) {
        const bool last = k == corners_m.size();
        MovingPlace next{.place_m = last ? place.place_m : corners_m[k]};
        if (last) {
            next.place_m = beside_m(next.place_m + place.drift_mps * path.time_s);
            next.drift_mps = place.drift_mps;
        }
        const std::optional<Path> leg = legTo(path.end, next, command_s);
        if (!leg)
            return std::nullopt;
        if (k == 0)
            path.turn_rad = leg->turn_rad;
        path.time_s += leg->time_s + (last ? 0 : kCornerReserve_s);
        path.end = leg->end;
    }
    return path;
}

double Geofence::longestPath_s(const DubinsState& start, const Point& place_m,
                               double command_s) const
{
    double time_s = circle_s();
    DubinsState from = start;
    for (const Point& corner_m : cornersBetween(start.position_m, place_m)) {
        time_s += berg::longestPath_s(from, corner_m, m_motion, command_s) + kCornerReserve_s;
        from.position_m = corner_m;
    }
    return time_s + berg::longestPath_s(from, place_m, m_motion, command_s);
}

Eigen::MatrixXd Geofence::distances_m(std::span<const Point> wanted_m) const
{
    const auto n = static_cast<Eigen::Index>(wanted_m.size());
    std::vector<Point> places_m;
    std::vector<std::vector<Sight>> seen;
    for (const Point& place_m : wanted_m) {
        places_m.push_back(beside_m(place_m));
        seen.push_back(sights(places_m.back()));
    }
    Eigen::MatrixXd result_m(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) {
            const auto from = static_cast<std::size_t>(i);
            const auto to = static_cast<std::size_t>(j);
            double best_m = kFar;
            if (!isClear(places_m[from], places_m[to]))
                for (const Sight& a : seen[from])
                    for (const Sight& b : seen[to])
                        best_m = std::min(best_m, a.from_m + m_path_m(a.corner, b.corner) + b.to_m);
            // If no path is known the distance is straight: the guard keeps the fence in flight.
            result_m(i, j) = best_m < kFar ? best_m : air_m(places_m[from], places_m[to]);
        }
    return result_m;
}

} // namespace berg
