#pragma once

#include "core/scenario/scenario.h"
#include "core/vehicle/geofence.h"

#include <memory>

namespace berg {

/** Corners of a stand-off ring: it is drawn about the circle. */
inline constexpr int kRingCorners = 16;

/** What no UAV flies over within the stand-off: of an asset that moves, all that its ring sweeps
 * until the end of the run. None: there is no stand-off. */
[[nodiscard]] std::optional<NoFlyArea> standoffArea(const Asset& asset, double duration_s);

/** The no-fly areas, then the stand-off ring. */
[[nodiscard]] std::vector<NoFlyArea> closedAreas(const Scenario& scenario);

[[nodiscard]] bool isClosedAt(const NoFlyArea& area, double altitude_m);

/** What a UAV stays inside and outside at one altitude. */
struct FenceShape
{
    std::vector<Point> corners_m; ///< of the area, when it is a geofence
    std::vector<std::vector<Point>> holes_m;

    [[nodiscard]] std::size_t cornerCount() const;
};

[[nodiscard]] FenceShape fenceShape(const Scenario& scenario, double altitude_m);

/** That of one UAV, for its motion; null: it may fly anywhere. */
[[nodiscard]] std::shared_ptr<const Geofence> fenceOf(const Scenario& scenario, double altitude_m,
                                                      const Motion& motion);

} // namespace berg
