#pragma once

#include "core/scenario/scenario.h"

namespace berg {

/** Property of a scenario that a new origin preserves. */
enum class MoveMode
{
    KeepLayout, ///< positions in metres; everything moves with the origin
    KeepPlaces  ///< positions on the Earth; all positions in metres change
};

/**
 * Returns the scenario with another origin. With `KeepPlaces` positions, tracks and areas stay at
 * the same places on the Earth. Velocities and headings are turned by the change of grid north at
 * their places, wind and current by that at the centre of the scene. The known drift of each
 * iceberg takes up the rest, so that all icebergs move over the Earth as before. A wind that is
 * uniform in one plane is not quite uniform in another.
 * Throws `Error{InvalidInput, "origin"}` if the origin is not on the Earth, or with the errors that
 * `validate` finds in the new scenario in fields about which it finds nothing in the present one,
 * such as places too far from the origin.
 */
[[nodiscard]] Scenario movedTo(const Scenario& scenario, const LatLon& origin, MoveMode mode);

} // namespace berg
