#pragma once

#include "core/io/export/missions/mission_items.h"

#include <vector>

namespace berg {

/** Returns the item that starts the camera of the profile, which must have one, or stops it. */
[[nodiscard]] MavItem cameraItem(const AircraftProfile& aircraft, bool isOn);

/** Time in which the camera is on along a path. */
struct CameraWindow
{
    double from_s = 0;
    double until_s = 0;
};

/**
 * Returns the times at which icebergs of the path may be in view, apart from each other and in
 * order; none without a camera.
 */
[[nodiscard]] std::vector<CameraWindow> cameraWindows(const ExportUav& uav);

/** Returns the distance from an iceberg within which it may be in view: half the field of view. */
[[nodiscard]] double cameraReach_m(const ExportUav& uav);

/** Returns the corners of the path, and its places at the begin and end of each window. */
[[nodiscard]] std::vector<TimedPoint> cornersWith(const ExportUav& uav,
                                                  const std::vector<CameraWindow>& windows);

} // namespace berg
