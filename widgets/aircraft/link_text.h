#pragma once

#include "core/sim/steering.h"
#include "widgets/aircraft/link_status.h"

#include <QLocale>
#include <QString>

namespace berg {

/** Returns the name of an aircraft by its id on the link, e.g. "Aircraft 3". */
[[nodiscard]] QString aircraftName(LinkAddress address);
/** Returns the name of other traffic, or its id. */
[[nodiscard]] QString trafficName(const TrafficTarget& target);
/** Returns whether a link is open, or why not. */
[[nodiscard]] QString linkConditionText(const LinkCondition& condition);
/** Returns an age in words, e.g. "0.4 s ago" or "02:10 ago". */
[[nodiscard]] QString positionAgeText(double age_s, const QLocale& locale);
/** Returns the number of an item of a mission on the link, from 1 and without ArduPilot's home. */
[[nodiscard]] int itemNumber(int item, AutopilotKind autopilot);
/** Returns the progress or result of an upload or comparison, in a sentence. */
[[nodiscard]] QString syncText(const SyncStatus& sync, AutopilotKind autopilot);
/** Returns the sentence of an event; `vehicle` may be null. */
[[nodiscard]] QString linkEventText(const LinkEvent& event, const LinkVehicle* vehicle);
/** Returns true for events that the user must notice. */
[[nodiscard]] bool isAlarming(const LinkEvent& event);
/**
 * Returns what Bergwatch does to the flight of an aircraft; empty while it does not steer. It
 * steers only while the flight in the window follows the aircraft (`isLive`).
 */
[[nodiscard]] QString steeringText(const Steering& steering, bool isLive);

} // namespace berg
