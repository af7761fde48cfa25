#include "core/io/export/missions/mission_items.h"

#include "core/io/export/content/thinned_path.h"
#include "core/io/export/missions/mission_camera.h"
#include "core/io/export/missions/mission_ends.h"
#include "core/io/text/export_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace berg {

namespace {

/** ArduPlane stores loiter radii above 8 bits in steps. */
constexpr double kRadiusStep_m = 10;

/** Makes the mission items of one UAV between take-off and end. */
class ItemMaker
{
public:
    ItemMaker(const ExportContent& content, const ExportUav& uav) : m_content(content), m_uav(uav)
    {
    }

    std::vector<MavItem> take()
    {
        addSettings();
        if (m_content.what == ExportScope::Path)
            addPath();
        else
            addVisits();
        return std::move(m_items);
    }

private:
    struct Stop
    {
        Point position_m = Point::Zero();
        const Visit* visit = nullptr; ///< null at home
    };

    void addSettings()
    {
        const AircraftProfile& aircraft = m_uav.uav.aircraft;
        // In DO_CHANGE_SPEED, p1 = 0 means airspeed, 1 ground speed, and p3 = -1 unchanged
        // throttle.
        if (aircraft.speedItems)
            m_items.push_back({.command = LinkCommandId::kChangeSpeed,
                               .frame = ItemFrame::NoPosition,
                               .params = {aircraft.airframe == Airframe::Multirotor ? 1.0 : 0,
                                          m_uav.uav.spec.airspeed_mps, -1, 0}});
        if (aircraft.gimbalDown) // a pitch of -90 degrees; p7 = 2 means that the mission points it
            m_items.push_back({.command = LinkCommandId::kMountControl,
                               .frame = ItemFrame::NoPosition,
                               .params = {-90, 0, 0, 0},
                               .altitude_m = 2});
    }

    void addPath()
    {
        const double acceptance_m =
            m_uav.reachChosen ? acceptanceRadius_m(m_uav) : kPathAcceptance_m;
        const std::vector<CameraWindow> windows = cameraWindows(m_uav);
        const std::vector<TimedPoint> corners = cornersWith(m_uav, windows);
        auto window = windows.begin();
        const auto switchUntil = [&](double time_s) {
            for (; window != windows.end(); ++window) {
                if (!m_isCameraOn && window->from_s <= time_s)
                    setCamera(true);
                if (window->until_s > time_s)
                    return;
                setCamera(false);
            }
        };
        switchUntil(m_uav.start_s);
        for (const TimedPoint& corner : corners) {
            addWaypoint(corner.position_m, acceptance_m);
            switchUntil(corner.time_s);
        }
        setCamera(false);
    }

    void addVisits()
    {
        std::vector<Stop> stops;
        for (const Visit& visit : m_uav.visits)
            stops.push_back({visit.position_m, visit.iceberg ? &visit : nullptr});
        const bool comesHome = endsAtHome(m_content) &&
                               m_uav.uav.aircraft.end != MissionEnd::Loiter &&
                               (stops.empty() || stops.back().visit != nullptr);
        if (comesHome)
            stops.push_back({m_uav.home_m, nullptr});
        Point from_m = m_uav.uav.position_m;
        for (std::size_t i = 0; i < stops.size(); ++i) {
            if (stops[i].visit != nullptr) {
                beginPictures(from_m, stops[i].position_m);
                addVisit(*stops[i].visit);
                endPictures(from_m, stops[i].position_m,
                            i + 1 < stops.size() ? &stops[i + 1] : nullptr);
            }
            from_m = stops[i].position_m;
        }
        setCamera(false);
    }

    /** Switches the camera on where the iceberg ahead may come into view. */
    void beginPictures(const Point& from_m, const Point& to_m)
    {
        if (m_isCameraOn || m_uav.uav.aircraft.camera == CameraTrigger::None)
            return;
        const double length_m = (to_m - from_m).norm();
        const double reach_m = cameraReach_m(m_uav);
        if (length_m > reach_m + kPathAcceptance_m)
            addWaypoint(to_m - reach_m * (to_m - from_m) / length_m, kPathAcceptance_m);
        setCamera(true);
    }

    /**
     * Switches the camera off behind the iceberg, towards the next stop; it stays on if that
     * is an iceberg nearby. Without a next stop, or near home, it is switched off straight on.
     */
    void endPictures(const Point& from_m, const Point& at_m, const Stop* next)
    {
        if (!m_isCameraOn)
            return;
        const double reach_m = cameraReach_m(m_uav);
        const double passed_m = reach_m + kPathAcceptance_m;
        const double next_m = next == nullptr ? 0 : (next->position_m - at_m).norm();
        if (next != nullptr && next->visit != nullptr && next_m <= 2 * passed_m)
            return;
        const Point leg_m =
            next_m > passed_m ? Point(next->position_m - at_m) : Point(at_m - from_m);
        if (leg_m.norm() > 0)
            addWaypoint(at_m + reach_m * leg_m.normalized(), kPathAcceptance_m);
        setCamera(false);
    }

    void setCamera(bool isOn)
    {
        if (m_isCameraOn != isOn)
            m_items.push_back(cameraItem(m_uav.uav.aircraft, isOn));
        m_isCameraOn = isOn;
    }

    /** Adds a waypoint, or the requested circles. */
    void addVisit(const Visit& visit)
    {
        const int turns = m_content.options.loiterTurns;
        if (turns == 0 || m_uav.uav.aircraft.airframe != Airframe::FixedWing) {
            const double acceptance_m = acceptanceRadius_m(m_uav, visit.spread_m);
            addWaypoint(visit.position_m, isOverflown(m_uav)
                                              ? std::min(acceptance_m, kPathAcceptance_m)
                                              : acceptance_m);
        } else if (isArduPilot(m_uav)) {
            add(visit.position_m, LinkCommandId::kLoiterTurns,
                {static_cast<double>(turns), 0, loiterRadius_m(m_uav), 0});
        } else {
            const double turn_s =
                2 * std::numbers::pi * loiterRadius_m(m_uav) / m_uav.uav.spec.airspeed_mps;
            add(visit.position_m, LinkCommandId::kLoiterTime,
                {std::ceil(turns * turn_s), 0, loiterRadius_m(m_uav), 0});
        }
    }

    void addWaypoint(const Point& position_m, double acceptance_m)
    {
        // Param 4, the yaw at a waypoint, is 0 and not NaN: a fixed wing ignores it, and Mission
        // Planner reads numbers only.
        add(position_m, LinkCommandId::kWaypoint, {0, acceptance_m, 0, 0});
    }

    void add(const Point& position_m, std::uint16_t command, const std::array<double, 4>& params)
    {
        m_items.push_back({.command = command,
                           .params = params,
                           .place = roundedPlace(m_content.frame.toGeographic(position_m)),
                           .altitude_m = m_uav.uav.spec.altitude_m});
    }

    const ExportContent& m_content;
    const ExportUav& m_uav;
    std::vector<MavItem> m_items;
    bool m_isCameraOn = false;
};

/**
 * Lets PX4 choose the yaw of aircraft that can turn on the spot; 0 would turn them to the north.
 * ArduPilot does so anyway.
 */
void freeYaw(std::vector<MavItem>& items, const AircraftProfile& aircraft)
{
    if (aircraft.firmware != AutopilotFirmware::Px4 || aircraft.airframe == Airframe::FixedWing)
        return;
    for (MavItem& item : items)
        if (hasPlace(item))
            item.params[3] = std::numeric_limits<double>::quiet_NaN();
}

} // namespace

bool isArduPilot(const ExportUav& uav)
{
    return uav.uav.aircraft.firmware == AutopilotFirmware::ArduPilot;
}

bool isOverflown(const ExportUav& uav)
{
    return uav.uav.aircraft.camera != CameraTrigger::None && !uav.reachChosen;
}

bool hasPlace(const MavItem& item)
{
    return item.frame != ItemFrame::NoPosition;
}

bool endsAtHome(const ExportContent& content)
{
    return content.options.returnHome.value_or(content.what != ExportScope::FirstLeg);
}

std::vector<TimedPoint> pathCorners(const ExportUav& uav)
{
    std::vector<TimedPoint> corners = thinnedPath(pathOf(uav), kPathTolerance_m);
    corners.erase(corners.begin());
    return corners;
}

double acceptanceRadius_m(const ExportUav& uav, double spread_m)
{
    const double radius_m =
        std::max(1.0, std::floor(uav.reachChosen ? uav.reach_m : uav.reach_m - spread_m));
    return isArduPilot(uav) ? std::min(radius_m, kLargestByte_m) : radius_m;
}

double loiterRadius_m(const ExportUav& uav)
{
    const double wanted_m = uav.uav.aircraft.loiterRadius_m.value_or(1);
    const double least_m = std::ceil(std::max({1.0, wanted_m, uav.circle_m}));
    return least_m <= kLargestByte_m || !isArduPilot(uav)
               ? least_m
               : std::ceil(least_m / kRadiusStep_m) * kRadiusStep_m;
}

MavMission mavMission(const ExportContent& content, const ExportUav& uav)
{
    MavMission mission{.aircraft = uav.uav.aircraft,
                       .home = roundedPlace(content.frame.toGeographic(uav.home_m)),
                       .airspeed_mps = uav.uav.spec.airspeed_mps,
                       .altitude_m = uav.uav.spec.altitude_m,
                       .items = takeOffItems(content, uav)};
    for (const std::vector<MavItem>& more :
         {ItemMaker(content, uav).take(), endItems(content, uav)})
        mission.items.insert(mission.items.end(), more.begin(), more.end());
    freeYaw(mission.items, mission.aircraft);
    return mission;
}

MavMission mavMission(const ExportContent& content)
{
    require(content.uavs.size() == 1, "mavMission: one UAV for each file");
    return mavMission(content, content.uavs.front());
}

} // namespace berg
