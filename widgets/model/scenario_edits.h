#pragma once

#include "core/scenario/scenario.h"

#include <span>
#include <string>

namespace berg {

// Changes to a scenario that more than one view asks for. They keep every number inside the limits
// of a scenario, so that no gesture can make one that is refused.

/** The nearest position a scenario may hold. */
[[nodiscard]] Point clampedPosition(const Point& position_m);

/** "berg-K" for the smallest K beyond the number of icebergs that is no id yet. */
[[nodiscard]] std::string freshIcebergId(const Scenario& scenario);
/** "uav-K" for the smallest K that is no id yet. */
[[nodiscard]] std::string freshUavId(const Scenario& scenario);

/** nullptr when there is none. */
[[nodiscard]] const Iceberg* findIceberg(const Scenario& scenario, const std::string& id);
[[nodiscard]] Iceberg* findIceberg(Scenario& scenario, const std::string& id);
[[nodiscard]] const Uav* findUav(const Scenario& scenario, const std::string& id);

/**
 * Moves icebergs and UAVs by one common offset: as much of `offset_m` as keeps all of them within
 * the largest coordinate. Ids that are not there are ignored.
 */
void moveObjects(Scenario& scenario, std::span<const std::string> ids, const Point& offset_m);

/** Removes icebergs; ids of other things are ignored. */
void removeIcebergs(Scenario& scenario, std::span<const std::string> ids);

} // namespace berg
