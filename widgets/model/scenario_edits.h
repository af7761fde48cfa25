#pragma once

#include "core/base/find_by_id.h"
#include "core/scenario/limits.h"
#include "core/scenario/scenario.h"

#include <span>
#include <string>
#include <vector>

namespace berg {

// Changes to a scenario that more than one view asks for. They keep every number inside the limits
// of a scenario, so that no gesture can make one that is refused.

/** The nearest position a scenario may hold. */
[[nodiscard]] Point clampedPosition(const Point& position_m);

/** "berg-K" for the smallest K beyond the number of icebergs that is no id yet. */
[[nodiscard]] std::string freshIcebergId(const Scenario& scenario);
/** "uav-K" for the smallest K that is no id yet. */
[[nodiscard]] std::string freshUavId(const Scenario& scenario);

/**
 * One more UAV at that place: as `pattern`, an altitude layer above all there are, with a fresh id
 * and no name. A home of its own moves along. The caller sees to it that there is room for it.
 */
[[nodiscard]] Uav anotherUav(const Scenario& scenario, const Uav& pattern, const Point& place_m);
/** As the first UAV. */
[[nodiscard]] Uav anotherUav(const Scenario& scenario, const Point& place_m);

/** Gives an iceberg or UAV another id, which is free, also where icebergs are kept for that UAV. */
void renameObject(Scenario& scenario, const std::string& before, const std::string& after);

/** The multiple of `step` next to each coordinate. */
[[nodiscard]] Point roundedTo(const Point& value, double step);

/** Of this speed towards there, degrees clockwise from north; exact for the four main directions.
 */
[[nodiscard]] Point velocityTowards(double speed_mps, double direction_deg);
/** Where a velocity goes, degrees clockwise from north in [0, 360); 0 of none. */
[[nodiscard]] double directionOf(const Point& velocity_mps);

/** As much of a velocity, its direction kept, as its components may be. */
[[nodiscard]] Point clampedVelocity(const Point& velocity_mps,
                                    double most_mps = kLargestVelocity_mps);

/**
 * Moves what is selected, the area as a whole, by one common offset: as much of `offset_m` as keeps
 * all of it within the largest coordinate. Ids that are not there are ignored.
 */
void moveObjects(Scenario& scenario, std::span<const std::string> ids, const Point& offset_m);

/** Corners of the area or no-fly area of this key; null: there is none. */
[[nodiscard]] std::vector<Point>* outlineIn(Scenario& scenario, const std::string& key);
[[nodiscard]] const std::vector<Point>* outlineIn(const Scenario& scenario, const std::string& key);

/** Removes icebergs; ids of other things are ignored. */
void removeIcebergs(Scenario& scenario, std::span<const std::string> ids);
/** How many UAVs `removeObjects` removes of these. */
[[nodiscard]] std::size_t removableUavs(const Scenario& scenario, std::span<const std::string> ids);
/**
 * Removes icebergs, UAVs, asset and areas. One UAV always stays, the first of those that would have
 * gone; icebergs that were kept for one that is gone are anybody's.
 */
void removeObjects(Scenario& scenario, std::span<const std::string> ids);

/** The icebergs with these ids, in the order of the scenario. */
[[nodiscard]] std::vector<Iceberg> icebergsOf(const Scenario& scenario,
                                              std::span<const std::string> ids);
/** The UAVs with these ids, in the order of the scenario. */
[[nodiscard]] std::vector<Uav> uavsOf(const Scenario& scenario, std::span<const std::string> ids);

/**
 * Adds copies moved by `offset_m`, as far as the largest coordinate lets the group keep its form.
 * Each gets a fresh id; a name that is taken gets a number behind it: "Big", "Big 2"; one that is
 * kept for a UAV that is not there becomes anybody's. Returns the ids. The caller sees to it that
 * there is room for them.
 */
std::vector<std::string> addCopies(Scenario& scenario, std::span<const Iceberg> icebergs,
                                   const Point& offset_m);

/** The smallest multiple of `step_m` beside `icebergs` where no copy hides an iceberg. */
[[nodiscard]] Point freeOffset(const Scenario& scenario, std::span<const Iceberg> icebergs,
                               const Point& step_m);

/** `place_m`, or the nearest multiple of `step_m` from it where no UAV is. */
[[nodiscard]] Point freeUavPlace_m(const Scenario& scenario, const Point& place_m,
                                   const Point& step_m);

/** Two UAVs less than `kLayerHeight_m` apart in altitude are kept apart in flight. */
[[nodiscard]] bool sharesLayer(const Scenario& scenario);
/** Raises UAVs, none more than it takes, until no two of them share a layer. */
void separateLayers(Scenario& scenario);

} // namespace berg
