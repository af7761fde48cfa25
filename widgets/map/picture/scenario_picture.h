#pragma once

#include "core/scenario/scenario.h"
#include "widgets/map/picture/map_picture.h"

namespace berg {

/** Id of the iceberg in the scenario. */
[[nodiscard]] std::string keyOf(const MapIceberg& iceberg);

/** An iceberg of the scenario at t = 0. */
[[nodiscard]] MapIceberg mapIceberg(const Iceberg& iceberg, const Scenario& scenario);

/** Where the asset is `time_s` after the start, with its rings. */
[[nodiscard]] std::optional<MapAsset> assetOf(const std::optional<Asset>& asset, double time_s);

[[nodiscard]] std::vector<MapAirspace> airspaceOf(const Scenario& scenario);

/** No-fly areas and stand-off ring. */
[[nodiscard]] std::vector<MapClosedArea> closedOf(const std::vector<NoFlyArea>& noFly,
                                                  const std::optional<NoFlyArea>& ring);
/** Wind and current of the scenario. */
[[nodiscard]] MapAir airOf(const Scenario& scenario);

/**
 * Everything but icebergs and UAVs: areas, airspace, wind, and `asset` at `time_s`, which may not
 * be that of the scenario any more.
 */
void setSurroundings(MapPicture& picture, const Scenario& scenario,
                     const std::optional<Asset>& asset, double time_s);

/**
 * UAV i of the scenario at t = 0, named when it is one of several. It has no home while its
 * endurance is unlimited and it has none of its own.
 */
[[nodiscard]] MapUav mapUav(const Scenario& scenario, std::size_t i);

/**
 * The picture with everything that can be edited taken from the scenario at t = 0: icebergs (those
 * still to come too), UAVs, area, asset, wind. The plans keep the order of the icebergs that
 * are still there. So an edit is seen at once, before it is planned again. The colour scale of
 * sigma stays until then; a picture without icebergs gets that of the scenario.
 */
[[nodiscard]] MapPicture withScenario(MapPicture picture, const Scenario& scenario);

} // namespace berg
