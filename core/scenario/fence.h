#pragma once

#include "core/scenario/scenario.h"
#include "core/vehicle/geofence.h"

#include <memory>
#include <span>

namespace berg {

/** Number of corners of a stand-off ring, a polygon around the circle. */
inline constexpr int kRingCorners = 16;

/**
 * Returns the area that no UAV may enter around an asset: its stand-off ring, swept along the path
 * of a moving asset until `duration_s`. Returns nullopt if the asset has no stand-off distance.
 */
[[nodiscard]] std::optional<NoFlyArea> standoffArea(const Asset& asset, double duration_s);

/** Returns the no-fly areas, then the stand-off ring. */
[[nodiscard]] std::vector<NoFlyArea> closedAreas(const Scenario& scenario);

/** Returns true if the area is closed at the altitude, both in metres above sea level. */
[[nodiscard]] bool isClosedAt(const NoFlyArea& area, double altitude_m);
/**
 * Returns the index of the first area that is closed at this altitude and place, or the number of
 * areas if none is.
 */
[[nodiscard]] std::size_t closedAt(std::span<const NoFlyArea> areas, double altitude_m,
                                   const Point& place_m);
/** Returns the number of corners of all areas closed at this altitude. */
[[nodiscard]] std::size_t cornersAt(std::span<const NoFlyArea> areas, double altitude_m);

/**
 * Returns the geofence for one altitude: the area as outer boundary if the scenario has a geofence,
 * and the closed areas as holes. Returns null if the UAV may fly anywhere.
 */
[[nodiscard]] std::shared_ptr<const Geofence> fenceOf(const Scenario& scenario, double altitude_m,
                                                      const Motion& motion);

/**
 * Returns the usable endurance of the UAV and where its sortie ends, or nullopt if the endurance is
 * unlimited. Climb and landing count as time on the ground, like the turn-around, because nothing
 * is seen meanwhile.
 */
[[nodiscard]] std::optional<SortieSpec> sortieOf(const Uav& uav);

} // namespace berg
