#pragma once

#include "core/io/export/export_content.h"

#include <array>
#include <vector>

namespace berg {

/** MAV_CMD numbers of the MAVLink common message set. */
enum class MavCommand
{
    NavWaypoint = 16,
    NavLoiterUnlimited = 17,
    NavLoiterTurns = 18,
    DoChangeSpeed = 178
};

/**
 * MAV_FRAME numbers. The *_INT variants are deprecated, and ground stations show them as raw items
 * only.
 */
enum class MavFrame
{
    Global = 0,
    Mission = 2,
    GlobalRelativeAltitude = 3
};

/** A MAVLink mission item. */
struct MavItem
{
    MavCommand command = MavCommand::NavWaypoint;
    MavFrame frame = MavFrame::GlobalRelativeAltitude;
    std::array<double, 4> params{};
    LatLon place; ///< rounded for export; 0, 0 in frame Mission
    double altitude_m = 0;
};

/** Mission for a fixed-wing autopilot. */
struct MavMission
{
    LatLon home; ///< home of the UAV or its start, at 0 m above mean sea level
    double airspeed_mps = 0;
    double altitude_m = 0;
    std::vector<MavItem> items; ///< never empty; the last item is a loiter
};

/**
 * Returns the path of the content's only UAV as a mission: airspeed, a waypoint for each visit (or
 * `loiterTurns` circles over it), then an unlimited loiter at the last of them (at home if there is
 * none, or if the path ends there). A path is represented by its corners, the points of its track
 * that stay within `kPathTolerance_m` of it. There is no take-off item: a scenario starts with the
 * UAV in the air, and ArduPlane flies the mission from its first item when it is set to AUTO there.
 * Throws `std::logic_error` unless the content has exactly one UAV.
 */
[[nodiscard]] MavMission mavMission(const ExportContent& content);

/** Largest distance between a path through the waypoints of a mission and the original path. */
inline constexpr double kPathTolerance_m = 5;
/** Acceptance radius of waypoints that represent a path, which are close to one another. */
inline constexpr double kPathAcceptance_m = 30;

/**
 * Returns waypoints that represent the path of a UAV: the corners of its track without its start.
 */
[[nodiscard]] std::vector<TimedPoint> pathCorners(const ExportUav& uav);

/** Largest radius that ArduPlane stores in whole metres, in 8 bits. */
inline constexpr double kLargestByte_m = 255;

/**
 * Returns the acceptance radius of a waypoint in whole metres: the chosen one, or the acceptance
 * radius of the scenario, or half the smaller extent of the field of view, within which an iceberg
 * is seen at any heading. It is limited to 255 m (the default field of view would give 300 m) and
 * at least 1 m (0 means the autopilot's own default). At the centre of a cluster whose members are
 * up to `spread_m` away, it is reduced by that unless it was chosen, so that all of them are in
 * view there.
 */
[[nodiscard]] double acceptanceRadius_m(const ExportUav& uav, double spread_m = 0);

/**
 * Returns the radius of a loiter in whole metres, in multiples of 10 above 255 m (ArduPlane's
 * storage), never below the tightest turn (106 m by default). A circle over ground in wind W is
 * flown at up to U + W over ground and so needs (1 + W/U)^2 times the turn radius.
 */
[[nodiscard]] double loiterRadius_m(const ExportUav& uav);

} // namespace berg
