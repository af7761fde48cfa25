#pragma once

#include "core/world/world_state.h"

#include <optional>
#include <span>

namespace berg {

/** The camera of one UAV and its pose. */
struct Camera
{
    SensorSpec sensor;
    double airspeed_mps = 0;
    DubinsState pose;
    bool isOn = true;      ///< false on the ground
    bool maySearch = true; ///< false while the UAV flies home or holds
    /** Distance beyond which nothing is in view, m. */
    double reach_m = FieldOfView::reach_m(sensor);

    [[nodiscard]] FieldOfView view() const { return part(1); }
    /** Returns the inner half of the view. An iceberg whose estimate is in it should be seen. */
    [[nodiscard]] FieldOfView middle() const { return part(kMiddleOfView); }

private:
    static constexpr double kMiddleOfView = 0.5;

    [[nodiscard]] FieldOfView part(double share) const;
};

/** Returns the index of the first view that contains the place, or nullopt if none does. */
[[nodiscard]] std::optional<int> firstWith(std::span<const FieldOfView> views,
                                           const Point& place_m);

/** Fields of view and reach of all UAVs, by UAV. */
class Cameras
{
public:
    /**
     * With `reachRadius_m` an iceberg is reached within that distance, else as soon as it is in
     * view.
     */
    Cameras(std::optional<double> reachRadius_m, const Point& wind_mps)
        : m_reachRadius_m(reachRadius_m), m_wind_mps(wind_mps.norm())
    {
    }

    [[nodiscard]] int count() const { return static_cast<int>(m_cameras.size()); }
    [[nodiscard]] const Camera& of(int uav) const { return m_cameras[toIndex(uav)]; }
    void add(const Camera& camera);
    /** Sets the pose of the UAV. Its camera is off in mode Ground. */
    void setPose(int uav, const DubinsState& pose, FlightMode mode);
    /** Nothing is in view of the UAV until its next pose. */
    void switchOff(int uav);
    void setWind(const Point& wind_mps) { m_wind_mps = wind_mps.norm(); }

    /** Returns the fields of view by UAV; that of a UAV on the ground contains no place. */
    [[nodiscard]] std::vector<FieldOfView> views() const;
    /** Returns `Camera::middle` by UAV. */
    [[nodiscard]] std::vector<FieldOfView> middles() const;
    /** Returns the first UAV that has the place in view now, or nullopt if none has. */
    [[nodiscard]] std::optional<int> viewer(const Point& place_m);

    [[nodiscard]] const std::optional<double>& reachRadius_m() const { return m_reachRadius_m; }
    /** Returns true if there is a reach radius and the place is within it. */
    [[nodiscard]] bool isWithinReach(int uav, const Point& place_m) const;
    /** Returns true if there is a reach radius and the place is within it of any UAV. */
    [[nodiscard]] bool isWithinReachOfAny(const Point& place_m) const;
    /**
     * Returns the number of steps, at least 1, before a place now out of view can come into view,
     * if the UAVs and the place approach each other at their highest speeds.
     */
    [[nodiscard]] std::int64_t stepsOutOfReach(const Point& place_m, double speedLimit_mps,
                                               double dt_s) const;

private:
    std::optional<double> m_reachRadius_m;
    double m_wind_mps; ///< wind speed
    std::vector<Camera> m_cameras;
    /** Views computed on first use after a move, since each costs a sine. */
    std::vector<std::optional<FieldOfView>> m_views;
};

} // namespace berg
