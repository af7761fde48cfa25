#pragma once

#include "core/geometry/polygon_area.h"
#include "core/vehicle/path_home.h"

#include <vector>

namespace berg {

class SideTurn;

/**
 * Largest number of corners of a geofence and its holes together; the cost of the paths round them
 * grows with its third power.
 */
inline constexpr std::size_t kMostFenceCorners = 200;

/**
 * Time added to a path for each corner it rounds, because the fence may turn the UAV aside there.
 */
inline constexpr double kCornerReserve_s = 5;

/** Distance from the edge at which a UAV flies to view a place in a hole. */
inline constexpr double kBeside_m = 5;

/**
 * Returns the radius, m, of the circle over ground that can be flown for ever in this wind: (1 +
 * W/U)^2 times the UAV's own, and 5 % more.
 */
[[nodiscard]] double circleOverGround_m(const Motion& motion);

/**
 * Area that a UAV must not leave (`PolygonArea`), and the paths inside it.
 *
 * Holding: the UAV can stay for ever on a circle over ground (`circleOverGround_m`) tangent to its
 * course, left or right. The fence can be kept while one of the two circles lies inside and
 * contains no part of a hole: `turnClearance_m` >= 0. A UAV that flies only commands that keep this
 * clearance stays inside.
 *
 * Paths: the quickest ones round the corners that point inwards, which are the reflex corners of
 * the polygon and the convex corners of holes. They pass a corner at a circle's radius where there
 * is space. Immutable: one object may be used by several threads.
 */
class Geofence
{
public:
    /**
     * Takes the corners of the polygon and of the holes in either direction of rotation. An empty
     * `corners_m` makes an unbounded area with holes. Requires |wind| < airspeed. Throws
     * `std::logic_error` if a polygon has fewer than three corners, if all have more than
     * `kMostFenceCorners` together, or if there is no polygon at all.
     */
    Geofence(std::vector<Point> corners_m, const Motion& motion,
             std::vector<std::vector<Point>> holes_m = {});
    /**
     * Returns a fence with these polygons for another wind over ground, and another
     * `Motion::windLimit_mps`.
     */
    [[nodiscard]] Geofence inWind(const Point& wind_mps, double windLimit_mps = 0) const;

    [[nodiscard]] bool hasHoles() const { return m_area.hasHoles(); }
    /** Returns whether the place is inside the polygon and in no hole. */
    [[nodiscard]] bool contains(const Point& place_m) const { return m_area.contains(place_m); }
    /**
     * Returns the place itself if it is in no hole, else `nearestInside_m`: the nearest permitted
     * place 5 m from an edge of the fence.
     */
    [[nodiscard]] Point beside_m(const Point& place_m) const;
    /**
     * Returns the place itself if the fence contains it, else the nearest place that is 5 m from an
     * edge and that the fence contains. Returns the place itself if there is no such place.
     */
    [[nodiscard]] Point nearestInside_m(const Point& place_m) const
    {
        return m_area.nearestInside_m(place_m, kBeside_m);
    }
    /** Returns airspeed, turn limit and wind of the fence. */
    [[nodiscard]] const Motion& motion() const { return m_motion; }
    /** Returns the distance, m, to the nearest edge, from either side. */
    [[nodiscard]] double clearance_m(const Point& place_m) const
    {
        return m_area.clearance_m(place_m);
    }
    /**
     * Returns the least distance, m, of the straight line between two places to an edge; 0 if they
     * meet.
     */
    [[nodiscard]] double clearance_m(const Point& from_m, const Point& to_m) const
    {
        return m_area.clearance_m(from_m, to_m);
    }
    /** Returns the radius, m, of the holding circle over ground. */
    [[nodiscard]] double radius_m() const { return m_radius_m; }
    /** Returns the time, s, to fly once round that circle in the wind of the fence. */
    [[nodiscard]] double circle_s() const;
    /**
     * Returns the distance, m, of the better of the two holding circles to the fence; it is
     * negative if neither circle is inside.
     */
    [[nodiscard]] double turnClearance_m(const DubinsState& state) const;
    /**
     * Returns whether more than half of the courses over the place leave no holding circle inside:
     * the place can be seen, but hardly overflown.
     */
    [[nodiscard]] bool isShutOff(const Point& place_m) const;
    /**
     * Returns whether the place lies so deep in a hole that a UAV outside never comes within
     * `reach_m`.
     */
    [[nodiscard]] bool isOutOfReach(const Point& place_m, double reach_m) const;
    /**
     * Returns the turn rate, rad/s and within the limit, that stays on the holding circle to the
     * left
     * (`side` 1) or right (-1).
     */
    [[nodiscard]] double circlingRate_radps(const DubinsState& state, double side) const;

    /**
     * Returns the places to fly over on the quickest path between two places. Empty if the straight
     * line is clear, or if no path is known. A place in a hole is replaced by `beside_m` of it,
     * here, in `pathTo` (for its end) and in `distances_m`.
     */
    [[nodiscard]] std::vector<Point> cornersBetween(const Point& start_m, const Point& end_m) const;
    /**
     * Returns the path of `berg::pathTo` led round the corners, with `kCornerReserve_s` added for
     * each. Where the fence would cut one of the two turns short, the other is taken. Returns
     * nullopt if the place may outrun the UAV.
     */
    [[nodiscard]] std::optional<Path> pathTo(const DubinsState& start, const MovingPlace& place,
                                             double command_s) const;
    /**
     * Returns an upper bound, s, of the time of `pathTo` to a fixed place, which must not be in a
     * hole, plus `circle_s`.
     */
    [[nodiscard]] double longestPath_s(const DubinsState& start, const Point& place_m,
                                       double command_s) const;
    /**
     * Returns the air distances (airspeed x time, m) of the paths between the places: N x N, where
     * a row holds the distances from one place. Where no path is known, the distance is that of the
     * straight line.
     */
    [[nodiscard]] Eigen::MatrixXd distances_m(std::span<const Point> wanted_m) const;

private:
    struct Sight ///< a corner that is visible from a place
    {
        int corner = 0;
        double from_m = 0; ///< air distance from the place to the corner
        double to_m = 0;   ///< air distance from the corner to the place
    };

    [[nodiscard]] std::optional<Path> legTo(const DubinsState& start, const MovingPlace& place,
                                            double command_s) const;
    [[nodiscard]] double clearanceOnTurn_m(const SideTurn& turn, double turn_rad) const;
    void placeCorners();
    [[nodiscard]] bool isClear(const Point& a, const Point& b) const;
    [[nodiscard]] double air_m(const Point& from_m, const Point& to_m) const;
    [[nodiscard]] std::vector<Sight> sights(const Point& place_m) const;
    void connectCorners();

    void placeCorner(const Point& corner_m, const Point& inwards);

    PolygonArea m_area;
    Motion m_motion;
    Point m_pathWind_mps = Point::Zero(); ///< wind for which `m_path_m` was computed
    double m_radius_m = 0;
    std::vector<Point> m_reflex_m;  ///< corners that point inwards
    std::vector<double> m_space_m;  ///< by reflex corner: distance at which it is passed
    std::vector<Point> m_corners_m; ///< by reflex corner: place at which it is passed
    Eigen::MatrixXd m_path_m;       ///< shortest air distances between those places
    Eigen::MatrixXi m_next; ///< place after the row on that path; `kNoCorner` if none is known
};

} // namespace berg
