#pragma once

#include "core/sim/world_state.h"

#include <span>

namespace berg {

/** The camera of one UAV, and where it is. */
struct Camera
{
    SensorSpec sensor;
    double airspeed_mps = 0;
    DubinsState pose;
    bool isOn = true;      ///< off on the ground
    bool maySearch = true; ///< not on the way home, nor holding
    double reach_m = FieldOfView::reach_m(sensor);

    [[nodiscard]] FieldOfView view() const { return part(1); }
    /** An iceberg whose estimate is in this part of it should be seen. */
    [[nodiscard]] FieldOfView middle() const { return part(kMiddleOfView); }

private:
    static constexpr double kMiddleOfView = 0.5;

    [[nodiscard]] FieldOfView part(double share) const;
};

/** Index of the first view with the place in it; -1: none. */
[[nodiscard]] int firstWith(std::span<const FieldOfView> views, const Point& place_m);

/** What the UAVs can see from where they are, by UAV. */
class Cameras
{
public:
    /** With a reach radius an iceberg is reached within it, else in view. */
    Cameras(std::optional<double> reachRadius_m, const Point& wind_mps)
        : m_reachRadius_m(reachRadius_m), m_wind_mps(wind_mps.norm())
    {
    }

    [[nodiscard]] int count() const { return static_cast<int>(m_cameras.size()); }
    [[nodiscard]] const Camera& of(int uav) const { return m_cameras[toIndex(uav)]; }
    void add(const Camera& camera);
    /** The UAV is there now. */
    void point(int uav, const DubinsState& pose, FlightMode mode);
    void setWind(const Point& wind_mps) { m_wind_mps = wind_mps.norm(); }

    [[nodiscard]] std::vector<FieldOfView> views() const;
    [[nodiscard]] std::vector<FieldOfView> middles() const;
    /** The first UAV that has the place in view; -1: none. */
    [[nodiscard]] int viewer(const Point& place_m);

    [[nodiscard]] const std::optional<double>& reachRadius_m() const { return m_reachRadius_m; }
    [[nodiscard]] bool isWithinReach(int uav, const Point& place_m) const;
    [[nodiscard]] bool isWithinReachOfAny(const Point& place_m) const;
    /** For a place in no view, the steps until it may be, at least 1: UAVs and place being as fast
     * as they can. */
    [[nodiscard]] std::int64_t stepsOutOfReach(const Point& place_m, double speedLimit_mps,
                                               double dt_s) const;

private:
    std::optional<double> m_reachRadius_m;
    double m_wind_mps; ///< its speed
    std::vector<Camera> m_cameras;
    /** Made when they are first needed, as each costs a sine. */
    std::vector<std::optional<FieldOfView>> m_views;
};

} // namespace berg
