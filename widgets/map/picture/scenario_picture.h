#pragma once

#include "core/scenario/scenario.h"
#include "widgets/map/picture/map_picture.h"

namespace berg {

/** Returns the scenario id of an iceberg of the picture. */
[[nodiscard]] std::string keyOf(const MapIceberg& iceberg);

/** Returns an iceberg of the scenario at t = 0, as the map shows it. */
[[nodiscard]] MapIceberg mapIceberg(const Iceberg& iceberg, const Scenario& scenario);

/** Returns the asset with its rings, `time_s` after the start; nullopt without one. */
[[nodiscard]] std::optional<MapAsset> assetOf(const std::optional<Asset>& asset, double time_s);

/** Returns the airspace of the scenario. */
[[nodiscard]] std::vector<MapAirspace> airspaceOf(const Scenario& scenario);

/** Returns the no-fly areas, then the stand-off ring if there is one. */
[[nodiscard]] std::vector<MapClosedArea> closedOf(const std::vector<NoFlyArea>& noFly,
                                                  const std::optional<NoFlyArea>& ring);
/**
 * Returns the wind and current of the flight at the start, with the airspeed of the slowest UAV.
 */
[[nodiscard]] MapAir airOf(const Scenario& scenario);

/**
 * Sets all of the picture but icebergs and UAVs: areas, airspace, ice, wind, and `asset` at
 * `time_s`. In flight the asset may differ from that of the scenario.
 */
void setSurroundings(MapPicture& picture, const Scenario& scenario,
                     const std::optional<Asset>& asset, double time_s);

/**
 * Returns UAV i of the scenario at t = 0, with a label in a fleet. A UAV without a home place lands
 * at its start if its endurance is limited, else nowhere.
 */
[[nodiscard]] MapUav mapUav(const Scenario& scenario, std::size_t i);

/**
 * Replaces what the user can edit by the scenario at t = 0: icebergs (future ones included), UAVs,
 * areas, asset, wind. Plans keep the order of the icebergs that still exist, so that an edit is
 * visible before the new plan; curved paths are removed if places or wind are no longer those they
 * were planned for. The sigma colour scale is kept, unless the picture had no icebergs.
 */
[[nodiscard]] MapPicture withScenario(MapPicture picture, const Scenario& scenario);

} // namespace berg
