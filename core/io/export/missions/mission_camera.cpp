#include "core/io/export/missions/mission_camera.h"

#include <algorithm>

namespace berg {

MavItem cameraItem(const AircraftProfile& aircraft, bool isOn)
{
    MavItem item{.command = LinkCommandId::kTriggerDistance, .frame = ItemFrame::NoPosition};
    if (aircraft.camera == CameraTrigger::Distance) {
        // p1 = 0 stops the trigger; p3 = 1 takes the first picture at once.
        item.params = {isOn ? aircraft.trigger_m : 0, 0, isOn ? 1.0 : 0, 0};
        return item;
    }
    item.command = isOn ? LinkCommandId::kStartCapture : LinkCommandId::kStopCapture;
    if (isOn)
        item.params[1] = aircraft.trigger_s; // p3 = 0 means without end
    return item;
}

double cameraReach_m(const ExportUav& uav)
{
    return uav.uav.fov_m.maxCoeff() / 2;
}

std::vector<CameraWindow> cameraWindows(const ExportUav& uav)
{
    std::vector<CameraWindow> windows;
    if (uav.uav.aircraft.camera == CameraTrigger::None)
        return windows;
    const double around_s = cameraReach_m(uav) / uav.uav.spec.airspeed_mps;
    for (const Visit& visit : uav.visits) {
        if (!visit.iceberg)
            continue;
        const double from_s = visit.time_s - around_s;
        if (windows.empty() || windows.back().until_s < from_s)
            windows.push_back({.from_s = from_s, .until_s = visit.time_s + around_s});
        else
            windows.back().until_s = visit.time_s + around_s;
    }
    return windows;
}

std::vector<TimedPoint> cornersWith(const ExportUav& uav, const std::vector<CameraWindow>& windows)
{
    std::vector<TimedPoint> corners = pathCorners(uav);
    std::vector<double> times_s;
    for (const CameraWindow& window : windows)
        times_s.insert(times_s.end(), {window.from_s, window.until_s});
    auto next = times_s.begin();
    eachPoint(uav, [&](const TimedPoint& point) {
        bool isEdge = false;
        for (; next != times_s.end() && *next <= point.time_s; ++next)
            isEdge = *next > uav.start_s;
        if (isEdge)
            corners.push_back(point);
    });
    std::ranges::stable_sort(corners, {}, &TimedPoint::time_s);
    const auto isSameTime = [](const TimedPoint& one, const TimedPoint& other) {
        return one.time_s == other.time_s;
    };
    corners.erase(std::unique(corners.begin(), corners.end(), isSameTime), corners.end());
    return corners;
}

} // namespace berg
