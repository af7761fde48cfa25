#pragma once

#include "core/link/link_session.h"
#include "core/link/traffic.h"
#include "core/link/transport/transport_link.h"
#include "core/sim/ghost_aircraft.h"
#include "widgets/aircraft/link_log.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace berg {

/** An aircraft without contact where it should be now. */
struct GhostReport
{
    LinkAddress address;
    VehicleReadings readings;
    double silentFor_s = 0; ///< since its last position
    /** Place where contact should return; nullopt without a ground station, or if it never returns.
     */
    std::optional<ExpectedContact> expected;
};

/** An event of the link with its time. */
struct TimedLinkEvent
{
    LinkTime time;
    LinkEvent event;
};

/** Progress of a telemetry log that is played in place of a link. */
struct ReplayReport
{
    std::string path;
    double played_s = 0;
    double part = 0; ///< of the file, 0 to 1
    double speed = 1;
    bool isAtEnd = false;
    std::uint64_t skipped_bytes = 0; ///< damaged parts so far
};

/** State of the live link at one instant. */
struct LinkStatus
{
    bool isListening = false;
    LinkCondition condition;
    bool isSending = false;
    /** The clock of all times of the vehicles: `monotonicNow_s`, or that of a replay. */
    double now_s = 0;
    std::vector<LinkVehicle> vehicles; ///< aircraft, then NMEA trackers (`isTracker`)
    std::vector<GhostReport> ghosts;   ///< of vehicles whose position is old
    std::vector<TrafficTarget> traffic;
    std::vector<TimedLinkEvent> events;                      ///< new ones
    std::map<LinkAddress, std::vector<LatLon>> places;       ///< new positions for tracks
    std::map<LinkAddress, std::vector<MissionPart>> onBoard; ///< as read back last
    LogReport log;
    std::optional<ReplayReport> replay; ///< nullopt on a live link
};

/** Returns true while an upload or comparison runs; rechecks run in the background and give way. */
[[nodiscard]] inline bool isSyncRunning(const LinkVehicle& vehicle)
{
    return vehicle.sync && !vehicle.sync->isRecheck &&
           (vehicle.sync->phase == SyncPhase::Uploading ||
            vehicle.sync->phase == SyncPhase::ReadingBack);
}

/** Data besides telemetry that predict the flight of an aircraft without contact. */
struct AircraftData
{
    UavSpec uav;
    Point wind_mps = Point::Zero();
    std::optional<LatLon> station; ///< ground station
    double range_m = 0;            ///< of its link
};

} // namespace berg
