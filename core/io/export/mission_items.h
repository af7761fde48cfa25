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
    double altitude_m = 0;
    std::vector<MavItem> items; ///< never empty; the last one loiters
};

/**
 * The way of the only UAV of the content as a mission: airspeed, a waypoint for each visit (with
 * `loiterTurns` that many circles over it), then an unlimited loiter where the last one was (at
 * home when there is none, or when the way ends there). Of a path its corners: the points of its
 * track that keep within `kPathTolerance_m` of it. There is no take-off item: a scenario starts
 * with the UAV in the air, and ArduPlane flies the mission from its first item when it is put into
 * AUTO there.
 */
[[nodiscard]] MavMission mavMission(const ExportContent& content);

/** How far a path through the waypoints of a mission may be from the one flown. */
inline constexpr double kPathTolerance_m = 5;
/** Acceptance radius of those waypoints: they follow each other closely. */
inline constexpr double kPathAcceptance_m = 30;

/** Waypoints that stand for the path of a UAV: the corners of its track, without its start. */
[[nodiscard]] std::vector<TimedPoint> pathCorners(const ExportUav& uav);

/** Largest radius of 8 bits, in which ArduPlane keeps whole metres. */
inline constexpr double kLargestByte_m = 255;

/**
 * Acceptance radius of a waypoint, whole metres: the one chosen, or the reach radius, or half the
 * smaller extent of the field of view, within which an iceberg is seen whatever the heading. Cut to
 * 255 m (the default field of view would give 300 m) and not below 1 m (0 would mean the
 * autopilot's own default). At the middle of a cluster whose members are up to `spread_m` away,
 * smaller by that unless it was chosen: all of them are in view there.
 */
[[nodiscard]] double acceptanceRadius_m(const ExportUav& uav, double spread_m = 0);

/**
 * Radius of a loiter, whole metres, multiples of 10 above 255 m (ArduPlane's storage): never below
 * the tightest turn, 106 m by default. A circle over ground in wind W is flown at up to U + W over
 * ground and so needs (1 + W/U)^2 times the turn radius.
 */
[[nodiscard]] double loiterRadius_m(const ExportUav& uav);

} // namespace berg
