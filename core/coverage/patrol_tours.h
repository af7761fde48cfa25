#pragma once

#include "core/base/random.h"
#include "core/coverage/patrol_search.h"

#include <span>
#include <vector>

namespace berg {

/**
 * Shortens a closed tour over places by reversing stretches and moving up to three stops elsewhere,
 * until neither shortens it further. `tour` holds indices of `places_m`. The calculation takes time
 * in proportion to a few times the square of the number of stops.
 */
void shortenTour(std::vector<int>& tour, std::span<const Point> places_m);

/** Choice of round tours. */
struct PatrolRounds
{
    bool reversed = false; ///< The tours are flown in the opposite direction.
    int tries = 20;        ///< Number of tours that are compared for the first round.
};

/**
 * Returns routes in which every UAV flies round tours over a part of the icebergs to the end of the
 * problem. The parts are pieces of equal length of a short tour over all icebergs, one for each
 * UAV, and each UAV enters its piece at the nearest stop. Each later round is the one before,
 * shortened for the places at its time.
 */
[[nodiscard]] PatrolRoutes patrolRounds(const PatrolProblem& problem, const PatrolRounds& rounds,
                                        Random& random);

} // namespace berg
