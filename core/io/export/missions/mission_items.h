#pragma once

#include "core/io/export/content/export_content.h"
#include "core/link/mission/mission_item.h"

#include <array>
#include <cstdint>
#include <vector>

namespace berg {

/** An item of a mission. */
struct MavItem
{
    std::uint16_t command = LinkCommandId::kWaypoint; ///< MAV_CMD
    /**
     * The *_INT variants of frames are deprecated, and ground stations show them as raw items only.
     */
    ItemFrame frame = ItemFrame::AboveHome;
    /** NaN is the autopilot's own choice. */
    std::array<double, 4> params{};
    LatLon place;          ///< rounded for export; 0, 0 without a position
    double altitude_m = 0; ///< or the seventh parameter, without a position
};

/** Returns true if the autopilot of the UAV is ArduPilot. */
[[nodiscard]] bool isArduPilot(const ExportUav& uav);

/**
 * Returns true if the UAV flies over icebergs within `kPathAcceptance_m` to take their pictures,
 * and does not turn away as soon as they are in view.
 */
[[nodiscard]] bool isOverflown(const ExportUav& uav);

/** Returns true if the item names a place. */
[[nodiscard]] bool hasPlace(const MavItem& item);

/** Mission of one UAV: what files and uploads of it are made of. */
struct MavMission
{
    AircraftProfile aircraft;
    LatLon home; ///< home of the UAV or its start, at 0 m above mean sea level
    double airspeed_mps = 0;
    double altitude_m = 0;
    std::vector<MavItem> items; ///< never empty; the last one ends the mission
};

/**
 * Returns the path of the UAV as a mission for the autopilot and airframe of its profile:
 *
 * - a take-off item, unless it is launched by hand or in the air already;
 * - the airspeed, and the gimbal pointed down, if the profile says so;
 * - a waypoint for each visit, or `loiterTurns` circles over it (a loiter of that time for PX4; for
 *   a fixed wing only). A path is represented by its corners, the points of its track that stay
 *   within `kPathTolerance_m` of it. A camera is switched on before each iceberg and off after it;
 * - the end of the profile if `endsAtHome`, else an endless loiter where the path ends.
 */
[[nodiscard]] MavMission mavMission(const ExportContent& content, const ExportUav& uav);

/**
 * Returns the mission of the content's only UAV. Throws `std::logic_error` unless it has exactly
 * one.
 */
[[nodiscard]] MavMission mavMission(const ExportContent& content);

/**
 * Returns true if the mission comes home at its end: as the user chose, else unless only the first
 * leg is exported.
 */
[[nodiscard]] bool endsAtHome(const ExportContent& content);

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
 * is seen at any heading. It is limited to 255 m for ArduPilot (the default field of view would
 * give 300 m) and at least 1 m (0 means the autopilot's own default). At the centre of a cluster
 * whose members are up to `spread_m` away, it is reduced by that unless it was chosen, so that all
 * of them are in view there.
 */
[[nodiscard]] double acceptanceRadius_m(const ExportUav& uav, double spread_m = 0);

/**
 * Returns the radius of a loiter in whole metres, for ArduPilot in multiples of 10 above 255 m (its
 * storage), never below the radius of the profile or the tightest turn (106 m by default). A circle
 * over ground in wind W is flown at up to U + W over ground and so needs (1 + W/U)^2 times the turn
 * radius.
 */
[[nodiscard]] double loiterRadius_m(const ExportUav& uav);

} // namespace berg
