#pragma once

#include "core/scenario/scenario.h"
#include "widgets/map/map_picture.h"

namespace berg {

/** Id of the iceberg in the scenario. */
[[nodiscard]] std::string keyOf(const MapIceberg& iceberg);

/** Where the asset is `time_s` after the start, with its rings. */
[[nodiscard]] std::optional<MapAsset> assetOf(const std::optional<Asset>& asset, double time_s);

/**
 * The picture with everything that can be edited taken from the scenario at t = 0: icebergs (those
 * still to come too), UAV, area, asset. The plan keeps the order of the icebergs that are still
 * there. So an edit is seen at once, before it is planned again.
 */
[[nodiscard]] MapPicture withScenario(MapPicture picture, const Scenario& scenario);

} // namespace berg
