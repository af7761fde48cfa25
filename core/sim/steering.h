#pragma once

#include "core/link/command_queue.h"
#include "core/link/link_session.h"

#include <cstdint>
#include <optional>
#include <string>

namespace berg {

/** How Bergwatch directs an aircraft in flight. */
enum class SteeringKind
{
    None,
    Mission, ///< It flies the mission on board, which Bergwatch replaces when the plan changes.
    Guided   ///< It flies to single points, which Bergwatch sends one after another.
};

/** Whether Bergwatch may direct an aircraft now. */
enum class SteeringState
{
    Off,
    Waiting, ///< The aircraft has not entered the required mode yet.
    Active,
    PilotTookOver ///< The aircraft has left that mode: nothing is sent until the user decides.
};

/**
 * Decides whether Bergwatch may direct an aircraft: only while the aircraft is in the mode that
 * belongs to the chosen kind of steering. Any other mode means that the pilot has taken over. PX4
 * is guided in its hold mode, which its pilot may choose, too: it counts only after a target.
 */
class Steering
{
public:
    /** Starts to steer an aircraft that is in `mode` now; `None` ends it. */
    void begin(SteeringKind kind, AutopilotKind autopilot, std::uint32_t mode);
    /** Processes the aircraft's present mode. */
    void setMode(std::uint32_t mode);
    /** Notes that a target was sent to the aircraft; false if it was refused or not answered. */
    void setTargetSent(bool isSent) { m_isTargetSent = isSent; }

    [[nodiscard]] SteeringKind kind() const { return m_kind; }
    [[nodiscard]] SteeringState state() const { return m_state; }

private:
    SteeringKind m_kind = SteeringKind::None;
    SteeringState m_state = SteeringState::Off;
    std::uint32_t m_wanted = 0;
    std::uint32_t m_former = 0; ///< Mode at the start.
    bool m_needsTarget = false; ///< The wanted mode counts only after a target.
    bool m_isTargetSent = false;
};

/** Returns the mode, as in HEARTBEAT, in which an autopilot accepts this kind of steering. */
[[nodiscard]] std::uint32_t steeringMode(SteeringKind kind, AutopilotKind autopilot);

/** Returns the autopilot's name of a mode, such as "AUTO", or its number if it is unknown. */
[[nodiscard]] std::string modeName(AutopilotKind autopilot, std::uint32_t mode);

/** Returns the command that selects a mode, as in HEARTBEAT. */
[[nodiscard]] LinkCommand modeCommand(AutopilotKind autopilot, std::uint32_t mode);

/** Returns the command that makes an item of the mission, from 0 and without home, the next one. */
[[nodiscard]] LinkCommand itemCommand(AutopilotKind autopilot, int item);

/** A point for an aircraft to fly to. */
struct GuidedPoint
{
    LatLon place;
    double aboveHome_m = 0;
    double radius_m = 0; ///< Radius of the circle flown there.
};

/**
 * Returns the command that sends an aircraft to a point, or nullopt for PX4 without the altitude of
 * its home, because PX4 expects altitudes above mean sea level.
 */
[[nodiscard]] std::optional<LinkCommand> guidedCommand(AutopilotKind autopilot,
                                                       const GuidedPoint& point,
                                                       const std::optional<double>& homeAltitude_m);

/**
 * Returns the distance beyond an iceberg at which a guided point is placed, m: autopilots circle
 * the point, and so would not pass over an iceberg there. It is 1.5 radii of that circle and the
 * distance flown during `delay_s` of the link.
 */
[[nodiscard]] double beyond_m(double radius_m, double speed_mps, double delay_s);

} // namespace berg
