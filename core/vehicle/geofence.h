#pragma once

#include "core/vehicle/path_home.h"

#include <vector>

namespace berg {

class SideTurn;

/** Most corners of a geofence, with its holes: ways round them are found by looking from each to
 * each. */
inline constexpr std::size_t kMostFenceCorners = 200;

/** For each corner on a way: the fence may turn the UAV aside there. */
inline constexpr double kCornerReserve_s = 5;

/** Radius of the circle over ground that can be flown for ever in this wind: (1 + W/U)^2 times the
 * UAV's own, and 5 % more. */
[[nodiscard]] double circleOverGround_m(const Motion& motion);

/**
 * Where a UAV stays: inside a simple polygon, concave or not, and outside others, its holes, which
 * may overlap each other and the polygon. Without the first polygon it is unbounded.
 *
 * Holding: the UAV can stay for ever on a circle over ground (`circleOverGround_m`) tangent to its
 * course, left or right. While one of the two lies inside, with no
 * hole in it, the fence can be kept: `turnClearance_m` >= 0. Whoever flies only commands that leave
 * room stays inside.
 *
 * Ways: the shortest in time round the corners that point inwards, those of the polygon that are
 * reflex and those of holes that are not. They are passed at a circle's radius where there is
 * space. Immutable: one object serves several threads.
 */
class Geofence
{
public:
    /** Any direction of the corners; |wind| < airspeed. No corners: holes only. Throws
     * `std::logic_error` for a polygon of less than three corners, for more than
     * `kMostFenceCorners` of all, and for nothing at all. */
    Geofence(std::vector<Point> corners_m, const Motion& motion,
             std::vector<std::vector<Point>> holes_m = {});
    /** The same polygons in another wind. */
    [[nodiscard]] Geofence inWind(const Point& wind_mps) const;

    [[nodiscard]] bool hasHoles() const { return m_rings_m.size() > std::size_t{m_isBounded}; }
    /** Inside the polygon and in no hole. */
    [[nodiscard]] bool contains(const Point& place_m) const;
    /** The place itself, or, when it is in a hole, a place beside the hole that is near it. */
    [[nodiscard]] Point beside_m(const Point& place_m) const;
    /** The place itself, or a place just inside that is nearest to it. */
    [[nodiscard]] Point nearestInside_m(const Point& place_m) const;
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
    [[nodiscard]] double turnClearance_m(const DubinsState& state) const;
    /** Whether on most courses over the place there is no room: it can be seen, but hardly met. */
    [[nodiscard]] bool isShutOff(const Point& place_m) const;
    /** Whether the place lies in a hole so far from its edge that nobody comes so near to it. */
    [[nodiscard]] bool isOutOfReach(const Point& place_m, double reach_m) const;
    /** Turn rate that stays on the circle to the left (`side` 1) or right (-1). */
    [[nodiscard]] double circlingRate_radps(const DubinsState& state, double side) const;

    /** Corners to fly round between two places; empty: straight, or no way is known. Of a place in
     * a hole, `beside_m`, here and in what follows. */
    [[nodiscard]] std::vector<Point> cornersBetween(const Point& start_m, const Point& end_m) const;
    /**
     * As the function of this name, round the corners; where one of the two turns would be cut
     * short by the fence, the other one. With `kCornerReserve_s` for each corner.
     */
    [[nodiscard]] std::optional<Path> pathTo(const DubinsState& start, const MovingPlace& place,
                                             double command_s) const;
    /** An upper bound of its time to a place that stands still, with `circle_s` to spare. */
    [[nodiscard]] double longestPath_s(const DubinsState& start, const Point& place_m,
                                       double command_s) const;
    /** Air distances (airspeed x time) of the ways between the places, row = from. */
    [[nodiscard]] Eigen::MatrixXd distances_m(std::span<const Point> wanted_m) const;

private:
    struct Sight ///< of a corner from a place
    {
        int corner = 0;
        double from_m = 0; ///< air distance from the place to it
        double to_m = 0;   ///< and back
    };

    [[nodiscard]] std::optional<Path> legTo(const DubinsState& start, const MovingPlace& place,
                                            double command_s) const;
    [[nodiscard]] double roomIn_m(const SideTurn& turn, double turn_rad) const;
    void placeCorners();
    [[nodiscard]] bool isClear(const Point& a, const Point& b) const;
    [[nodiscard]] double air_m(const Point& from_m, const Point& to_m) const;
    [[nodiscard]] bool isInHole(const Point& place_m) const;
    [[nodiscard]] double edgeRoom_m(const Point& place_m) const;
    [[nodiscard]] std::vector<Sight> sights(const Point& place_m) const;
    void connectCorners();

    [[nodiscard]] bool meetsEdge(const Point& a, const Point& b) const;
    void placeCorner(const Point& corner_m, const Point& inwards);

    /** Inside is to the left of each edge: the polygon counter-clockwise, then holes clockwise. */
    std::vector<std::vector<Point>> m_rings_m;
    bool m_isBounded; ///< the first of the rings is the polygon
    Motion m_motion;
    double m_radius_m = 0;
    std::vector<Point> m_reflex_m;  ///< corners that point inwards
    std::vector<double> m_space_m;  ///< by reflex corner: how far off it is passed
    std::vector<Point> m_corners_m; ///< by reflex corner: where it is passed
    Eigen::MatrixXd m_path_m;       ///< between those, the shortest
    Eigen::MatrixXi m_next;         ///< on it, after the row; -1: none
};

} // namespace berg
