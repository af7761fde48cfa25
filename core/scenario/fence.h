#pragma once

#include "core/scenario/scenario.h"
#include "core/vehicle/geofence.h"

#include <memory>
#include <span>

namespace berg {

/** Corners of a stand-off ring: it is drawn about the circle. */
inline constexpr int kRingCorners = 16;

/** What no UAV flies over within the stand-off: of an asset that moves, all that its ring sweeps
 * until the end of the run. None: there is no stand-off. */
[[nodiscard]] std::optional<NoFlyArea> standoffArea(const Asset& asset, double duration_s);

/** The no-fly areas, then the stand-off ring. */
[[nodiscard]] std::vector<NoFlyArea> closedAreas(const Scenario& scenario);

[[nodiscard]] bool isClosedAt(const NoFlyArea& area, double altitude_m);
/** Place of the first of the areas that is closed there; their count: none is. */
[[nodiscard]] std::size_t closedAt(std::span<const NoFlyArea> areas, double altitude_m,
                                   const Point& place_m);
/** Corners of those that are closed at that altitude. */
[[nodiscard]] std::size_t cornersAt(std::span<const NoFlyArea> areas, double altitude_m);

/** What a UAV stays inside of and outside of at one altitude: the area when it is a geofence, and
 * what is closed there; null: it may fly anywhere. */
[[nodiscard]] std::shared_ptr<const Geofence> fenceOf(const Scenario& scenario, double altitude_m,
                                                      const Motion& motion);

/**
 * What a flight of the UAV may use of its endurance, and where it ends; none: it is unlimited.
 * Climb and landing, like the turn-around, pass on the ground: nothing is seen meanwhile.
 */
[[nodiscard]] std::optional<SortieSpec> sortieOf(const Uav& uav);

} // namespace berg
