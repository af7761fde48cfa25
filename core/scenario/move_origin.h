#pragma once

#include "core/scenario/scenario.h"

namespace berg {

/** What stays when a scenario gets another origin. */
enum class MoveMode
{
    KeepLayout, ///< metres about the origin: everything moves along with it
    KeepPlaces  ///< places on the Earth: everything gets other metres
};

/**
 * The scenario about another origin. With `KeepPlaces` positions, tracks and the area are those of
 * the same places; velocities and headings are turned by the change of grid north where they are,
 * wind and current where the scene is, and the known drift of icebergs by what is left, so that all
 * move over the Earth as before. An uniform wind in one plane is not quite uniform in another.
 * Throws `Error{InvalidInput, "origin"}` with the errors that `validate` finds in it and not in the
 * present one, e.g. what would be too far from the origin, or when the origin is no place.
 */
[[nodiscard]] Scenario movedTo(const Scenario& scenario, const LatLon& origin, MoveMode mode);

} // namespace berg
