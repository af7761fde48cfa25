#pragma once

#include "core/base/find_by_id.h"
#include "core/scenario/limits.h"
#include "core/scenario/scenario.h"

#include <span>
#include <string>
#include <vector>

namespace berg {

// Changes to a scenario that several views use. They keep every number inside the limits of a
// scenario, so that no gesture makes an invalid one.

/** Returns the nearest position that a scenario may hold. */
[[nodiscard]] Point clampedPosition(const Point& position_m);

/** Returns "berg-K" for the smallest unused K beyond the number of icebergs. */
[[nodiscard]] std::string freshIcebergId(const Scenario& scenario);
/** Returns "uav-K" for the smallest unused K. */
[[nodiscard]] std::string freshUavId(const Scenario& scenario);

/**
 * Returns another UAV at that place: a copy of `pattern` one altitude layer above all others, with
 * a fresh id and no name. Its home, if set, moves along. Both places and the altitude are limited
 * to the permitted range, so it may share the highest layer. The caller ensures that the scenario
 * has room for it.
 */
[[nodiscard]] Uav anotherUav(const Scenario& scenario, const Uav& pattern, const Point& place_m);
/** Returns another UAV that is a copy of the first one, or a usual UAV if there is none. */
[[nodiscard]] Uav anotherUav(const Scenario& scenario, const Point& place_m);

/** Gives an iceberg or UAV another, unused id, also in the assignments of icebergs to that UAV. */
void renameObject(Scenario& scenario, const std::string& before, const std::string& after);

/** Returns the multiple of `step` nearest to each coordinate. */
[[nodiscard]] Point roundedTo(const Point& value, double step);

/**
 * Returns the velocity in a direction, degrees clockwise from north; exact for the four main
 * directions.
 */
[[nodiscard]] Point velocityTowards(double speed_mps, double direction_deg);
/**
 * Returns the direction of a velocity, degrees clockwise from north in [0, 360); 0 for no motion.
 */
[[nodiscard]] double directionOf(const Point& velocity_mps);

/** Shortens a velocity, keeping its direction, until its components are within `most_mps`. */
[[nodiscard]] Point clampedVelocity(const Point& velocity_mps,
                                    double most_mps = kLargestVelocity_mps);

/**
 * Moves the objects with these ids, areas as a whole, by one common offset: `offset_m`, reduced to
 * keep all of them within the largest coordinate. Unknown ids are ignored.
 */
void moveObjects(Scenario& scenario, std::span<const std::string> ids, const Point& offset_m);

/** Returns the corners of the area or no-fly area with this key, or null if there is none. */
[[nodiscard]] std::vector<Point>* outlineIn(Scenario& scenario, const std::string& key);
[[nodiscard]] const std::vector<Point>* outlineIn(const Scenario& scenario, const std::string& key);

/** Removes the icebergs with these ids; other ids are ignored. */
void removeIcebergs(Scenario& scenario, std::span<const std::string> ids);
/** Returns the number of UAVs that `removeObjects` removes of these. */
[[nodiscard]] std::size_t removableUavs(const Scenario& scenario, std::span<const std::string> ids);
/**
 * Removes icebergs, UAVs, asset and areas. One UAV always stays, the first of those selected;
 * icebergs assigned to a removed UAV become unassigned.
 */
void removeObjects(Scenario& scenario, std::span<const std::string> ids);

/** Returns the icebergs with these ids, in the order of the scenario. */
[[nodiscard]] std::vector<Iceberg> icebergsOf(const Scenario& scenario,
                                              std::span<const std::string> ids);
/** Returns the UAVs with these ids, in the order of the scenario. */
[[nodiscard]] std::vector<Uav> uavsOf(const Scenario& scenario, std::span<const std::string> ids);

/**
 * Adds copies moved by `offset_m`, reduced to keep the group within the largest coordinate. Each
 * gets a fresh id; a used name gets a number: "Big", "Big 2"; an assignment to a UAV that is not in
 * the scenario is cleared. Returns the ids. The caller ensures that there is room for them.
 */
std::vector<std::string> addCopies(Scenario& scenario, std::span<const Iceberg> icebergs,
                                   const Point& offset_m);

/**
 * Returns the smallest multiple of `step_m`, from one on, by which no copy hides an iceberg. After
 * as many tries as there are icebergs it returns the next multiple.
 */
[[nodiscard]] Point freeOffset(const Scenario& scenario, std::span<const Iceberg> icebergs,
                               const Point& step_m);

/** Returns `place_m`, or the nearest multiple of `step_m` from it without a UAV. */
[[nodiscard]] Point freeUavPlace_m(const Scenario& scenario, const Point& place_m,
                                   const Point& step_m);

/** Returns whether UAVs are less than `kLayerHeight_m` apart in altitude while separation is on. */
[[nodiscard]] bool sharesLayer(const Scenario& scenario);
/** Raises UAVs as little as possible until no two of them share a layer. */
void separateLayers(Scenario& scenario);

} // namespace berg
