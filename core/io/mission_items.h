#pragma once

#include "core/io/formats.h"

#include <array>
#include <vector>

namespace berg {

/** MAV_CMD numbers of the MAVLink common message set. */
enum class MavCommand
{
    NavWaypoint = 16,
    NavLoiterUnlimited = 17,
    DoChangeSpeed = 178
};

/**
 * MAV_FRAME numbers. The *_INT twins are deprecated and open in ground stations as raw items only.
 */
enum class MavFrame
{
    Global = 0,
    Mission = 2,
    GlobalRelativeAltitude = 3
};

/** One MAVLink mission item. */
struct MavItem
{
    MavCommand command = MavCommand::NavWaypoint;
    MavFrame frame = MavFrame::GlobalRelativeAltitude;
    std::array<double, 4> params{};
    LatLon place; ///< rounded for export; 0, 0 in frame Mission
    double altitude_m = 0;
};

/** A mission for a fixed-wing autopilot. */
struct MavMission
{
    LatLon home; ///< or the start of the UAV; the sea, so 0 m above mean sea level
    double airspeed_mps = 0;
    std::vector<MavItem> items; ///< never empty; the last one loiters
};

/**
 * The visits of the source as a mission: airspeed, a waypoint per iceberg, then an unlimited
 * loiter where the last one was met (at home when there is none, or with a limited endurance; at
 * the start for a closed route). There is
 * no take-off item: a scenario starts with the UAV in the air, and ArduPlane flies the mission from
 * its first item when it is put into AUTO there.
 */
[[nodiscard]] MavMission mavMission(const ExportSource& source);

/**
 * Acceptance radius of a waypoint, whole metres: the reach radius, or half the smaller extent of
 * the field of view, within which an iceberg is seen whatever the heading. ArduPlane keeps 8 bits
 * of whole metres, so it is cut to 255 m (the default field of view would give 300 m) and not below
 * 1 m (0 would mean the autopilot's own default). At the middle of a cluster whose members are up
 * to `spread_m` away, smaller by that: all of them are in view there.
 */
[[nodiscard]] double acceptanceRadius_m(const Scenario& scenario, double spread_m = 0);

/**
 * Radius of the final loiter, whole metres, multiples of 10 above 255 m (ArduPlane's storage):
 * never below the tightest turn, 106 m by default. A circle over ground in wind W is flown at up to
 * U + W over ground and so needs (1 + W/U)^2 times the turn radius.
 */
[[nodiscard]] double loiterRadius_m(const Scenario& scenario);

} // namespace berg
