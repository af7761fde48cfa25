#pragma once

#include "core/io/export/missions/mission_items.h"

#include <optional>
#include <vector>

namespace berg {

/** Begin and end of a mission in the plane. */
struct LandingPattern
{
    Point from_m = Point::Zero(); ///< centre of the loiter, or waypoint, before the approach
    Point home_m = Point::Zero();
    double slope_deg = 0; ///< of the descent to home
};

/** Returns the climb of a fixed wing to the altitude at the pitch of its take-off, m over ground.
 */
[[nodiscard]] double climbDistance_m(const AircraftProfile& aircraft, double altitude_m);

/**
 * Returns the place of the take-off item: the start, or for a fixed wing the place ahead of it at
 * which it is at the take-off altitude. Returns nullopt if there is no such item.
 */
[[nodiscard]] std::optional<Point> takeOffPlace_m(const ExportUav& uav);

/** Returns the landing pattern at the end of the mission; nullopt if it ends without one. */
[[nodiscard]] std::optional<LandingPattern> landingPattern(const ExportContent& content,
                                                           const ExportUav& uav);

/** Returns the last place of the path before the end of the mission. */
[[nodiscard]] Point lastPlace_m(const ExportContent& content, const ExportUav& uav);

/** Returns the take-off item; none if the mission has none. */
[[nodiscard]] std::vector<MavItem> takeOffItems(const ExportContent& content, const ExportUav& uav);

/** Returns the items that end the mission. */
[[nodiscard]] std::vector<MavItem> endItems(const ExportContent& content, const ExportUav& uav);

} // namespace berg
