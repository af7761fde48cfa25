#pragma once

#include "core/vehicle/way_home.h"

#include <vector>

namespace berg {

class SideTurn;

/** Most corners of a geofence: ways round them are found by looking from each to each. */
inline constexpr std::size_t kMostFenceCorners = 200;

/** For each corner on a way: the fence may turn the UAV aside there. */
inline constexpr double kCornerReserve_s = 5;

/**
 * A simple polygon, concave or not, that a UAV stays inside.
 *
 * Holding: the UAV can stay for ever on a circle over ground of radius (1 + W/U)^2 times its own,
 * and 5 % more, tangent to its course, left or right. While one of the two lies inside, the fence
 * can be kept: `room_m` >= 0. Whoever flies only commands that leave room stays inside.
 *
 * Ways: the shortest in time round the reflex corners, which are passed at a circle's radius where
 * there is space. Immutable: one object serves several threads.
 */
class Geofence
{
public:
    /** Any direction of the corners; |wind| < airspeed. Throws `std::logic_error` for less than
     * three corners or more than `kMostFenceCorners`. */
    Geofence(std::vector<Point> corners_m, const Motion& motion);

    [[nodiscard]] bool contains(const Point& place_m) const;
    [[nodiscard]] const Motion& motion() const { return m_motion; }
    /** To the nearest edge, from either side. */
    [[nodiscard]] double clearance_m(const Point& place_m) const;
    /** Of the straight line between two places; 0 when it meets an edge. */
    [[nodiscard]] double clearance_m(const Point& from_m, const Point& to_m) const;
    /** Radius of the circle over ground. */
    [[nodiscard]] double radius_m() const { return m_radius_m; }
    /** So long it takes to fly round it. */
    [[nodiscard]] double circle_s() const;
    /** From the better of the two circles to the fence; negative: neither is inside. */
    [[nodiscard]] double room_m(const DubinsState& state) const;
    /** Whether on most courses over the place there is no room: it can be seen, but hardly met. */
    [[nodiscard]] bool isShutOff(const Point& place_m) const;
    /** Turn rate that stays on the circle to the left (`side` 1) or right (-1). */
    [[nodiscard]] double circlingRate_radps(const DubinsState& state, double side) const;

    /** Corners to fly round between two places; empty: straight, or no way is known. */
    [[nodiscard]] std::vector<Point> cornersBetween(const Point& from_m, const Point& to_m) const;
    /**
     * As the function of this name, round the corners; where one of the two turns would be cut
     * short by the fence, the other one. With `kCornerReserve_s` for each corner.
     */
    [[nodiscard]] std::optional<Way> wayTo(const DubinsState& start, const MovingPlace& place,
                                           double command_s) const;
    /** An upper bound of its time to a place that stands still, with `circle_s` to spare. */
    [[nodiscard]] double longestWay_s(const DubinsState& start, const Point& place_m,
                                      double command_s) const;
    /** Air distances (airspeed x time) of the ways between the places, row = from. */
    [[nodiscard]] Eigen::MatrixXd distances_m(std::span<const Point> places_m) const;

private:
    struct Sight ///< of a corner from a place
    {
        int corner = 0;
        double from_m = 0; ///< air distance from the place to it
        double to_m = 0;   ///< and back
    };

    [[nodiscard]] std::optional<Way> legTo(const DubinsState& start, const MovingPlace& place,
                                           double command_s) const;
    [[nodiscard]] double roomIn_m(const SideTurn& turn, double turn_rad) const;
    void placeCorners();
    [[nodiscard]] bool isClear(const Point& a, const Point& b) const;
    [[nodiscard]] double air_m(const Point& from_m, const Point& to_m) const;
    [[nodiscard]] double edgeRoom_m(const Point& place_m) const;
    [[nodiscard]] std::vector<Sight> sights(const Point& place_m) const;
    void connectCorners();

    std::vector<Point> m_fence_m; ///< counter-clockwise
    Motion m_motion;
    double m_radius_m = 0;
    std::vector<Point> m_reflex_m;  ///< corners of the fence that point inwards
    std::vector<double> m_space_m;  ///< by reflex corner: how far off it is passed
    std::vector<Point> m_corners_m; ///< by reflex corner: where it is passed
    Eigen::MatrixXd m_way_m;        ///< between those, the shortest
    Eigen::MatrixXi m_next;         ///< on it, after the row; -1: none
};

} // namespace berg
