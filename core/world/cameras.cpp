#include "core/world/cameras.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace berg {

namespace {

/** Margin on the reach of a view that covers all rounding. */
constexpr double kReachMargin_m = 1;

} // namespace

FieldOfView Camera::part(double share) const
{
    SensorSpec seen = sensor;
    if (isOn)
        seen.fov_m *= share;
    else // no point is within NaN extents
        seen.fov_m.setConstant(std::numeric_limits<double>::quiet_NaN());
    return {seen, pose.position_m, pose.psi_rad};
}

std::optional<int> firstWith(std::span<const FieldOfView> views, const Point& place_m)
{
    const auto it = std::ranges::find_if(
        views, [&](const FieldOfView& view) { return view.contains(place_m); });
    return it == views.end() ? std::nullopt : std::optional(static_cast<int>(it - views.begin()));
}

void Cameras::add(const Camera& camera)
{
    m_cameras.push_back(camera);
    m_views.emplace_back();
}

void Cameras::setPose(int uav, const DubinsState& pose, FlightMode mode)
{
    Camera& camera = m_cameras[toIndex(uav)];
    camera.pose = pose;
    camera.isOn = mode != FlightMode::Ground;
    camera.maySearch = camera.isOn && mode != FlightMode::Home && mode != FlightMode::Hold;
    m_views[toIndex(uav)].reset();
}

void Cameras::switchOff(int uav)
{
    m_cameras[toIndex(uav)].isOn = false;
    m_views[toIndex(uav)].reset();
}

std::vector<FieldOfView> Cameras::views() const
{
    std::vector<FieldOfView> views;
    std::ranges::transform(m_cameras, std::back_inserter(views), &Camera::view);
    return views;
}

std::vector<FieldOfView> Cameras::middles() const
{
    std::vector<FieldOfView> middles;
    std::ranges::transform(m_cameras, std::back_inserter(middles), &Camera::middle);
    return middles;
}

std::optional<int> Cameras::viewer(const Point& place_m)
{
    for (std::size_t uav = 0; uav < m_cameras.size(); ++uav) {
        const double near_m = m_cameras[uav].reach_m + kReachMargin_m;
        if ((place_m - m_cameras[uav].pose.position_m).squaredNorm() > near_m * near_m)
            continue; // most places are this far: saves a sine
        if (!m_views[uav])
            m_views[uav] = m_cameras[uav].view();
        if (m_views[uav]->contains(place_m))
            return static_cast<int>(uav);
    }
    return std::nullopt;
}

bool Cameras::isWithinReach(int uav, const Point& place_m) const
{
    return m_reachRadius_m && (place_m - of(uav).pose.position_m).norm() <= *m_reachRadius_m;
}

bool Cameras::isWithinReachOfAny(const Point& place_m) const
{
    for (int uav = 0; m_reachRadius_m && uav < count(); ++uav)
        if (isWithinReach(uav, place_m))
            return true;
    return false;
}

std::int64_t Cameras::stepsOutOfReach(const Point& place_m, double speedLimit_mps,
                                      double dt_s) const
{
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (const Camera& camera : m_cameras) {
        const double away_m =
            (place_m - camera.pose.position_m).norm() - camera.reach_m - kReachMargin_m;
        if (away_m <= 0)
            return 1;
        const double closing_mps = camera.airspeed_mps + m_wind_mps + speedLimit_mps;
        least = std::min(least, static_cast<std::int64_t>(away_m / closing_mps / dt_s));
    }
    return std::max<std::int64_t>(1, least);
}

} // namespace berg
