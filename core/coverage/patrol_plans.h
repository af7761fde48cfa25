#pragma once

#include "core/coverage/coverage_search.h"
#include "core/coverage/patrol_search.h"

#include <span>
#include <vector>

namespace berg {

// This file decides when `coverage` plans a patrol, makes the problem from what is known of the
// flight, and turns the beginning of a patrol into aimed legs.

/** Kind of the last plan of a flight. */
enum class LastPlan
{
    None,
    Legs,
    Patrol
};

/**
 * Returns whether a patrol leads to less zeta than short aimed plans. This is so if the rest of the
 * run is longer than the whole horizon of those (1000 s) and a round takes more than 800 s, or 600
 * s if the flight has a patrol already. With measurements a flight has patrols from its first plan
 * to its last or never, because a change would discard the searches of aimed plans. Returns false
 * for velocities that fade, which patrols cannot predict.
 */
[[nodiscard]] bool needsPatrol(std::span<const PredictionInput> inputs, LastPlan last);

/**
 * Returns whether a patrol finds every iceberg at its predicted position a round later: no iceberg
 * is lost, and no deviation grows by more than a quarter of the view.
 */
[[nodiscard]] bool knowsVelocities(std::span<const PredictionInput> inputs);

/**
 * Returns the length of a patrol in seconds: two rounds and at least an hour, or to the end of the
 * run if that is not much longer.
 */
[[nodiscard]] double patrolLength_s(std::span<const PredictionInput> inputs);

/**
 * Returns the icebergs of a patrol, with the weights of the inputs. The growth after the first
 * visit is that of a track which was out of view for half a round and then in view for a pass;
 * after later visits it was out of view for a whole round before the next pass.
 */
[[nodiscard]] std::vector<PatrolIceberg> patrolIcebergs(std::span<const PredictionInput> inputs);

/**
 * Returns the problem of a patrol. `inputs` and `limits` have one entry for each UAV; empty
 * `limits` allow all icebergs.
 */
[[nodiscard]] PatrolProblem patrolProblem(std::span<const PredictionInput> inputs,
                                          std::span<const CoverageLimits> limits);

/**
 * Effort of a plan with a patrol. Work is counted as in `CoverageSearch`; a move of the patrol's
 * search counts as `kWorkOfMove`.
 */
struct PatrolEffort
{
    static constexpr std::int64_t kWorkOfMove = 100;

    std::int64_t startMoves = 0; ///< Moves from each start of the first patrol.
    std::int64_t moves = 0;    ///< Moves from the best start, or from the rest of the last patrol.
    std::int64_t headWork = 0; ///< Work of all aimed legs.
};

/** Returns the effort of a plan, within the work limit if there is one. */
[[nodiscard]] PatrolEffort patrolEffort(const PatrolProblem& problem, bool isFirst,
                                        std::optional<std::int64_t> workLimit);

/**
 * Searches for the first patrol from round tours and a greedy patrol, and from `start` unless that
 * is empty. `search` holds the best patrol afterwards. The watch may stop it early.
 */
void findPatrol(PatrolSearch& search, const PatrolRoutes& start, const Random& random,
                const PatrolEffort& effort, const SolveWatch& watch);
/**
 * Improves the rest of the last patrol, extended to the end of the problem. `search` holds the best
 * patrol afterwards. The watch may stop it early.
 */
void improvePatrol(PatrolSearch& search, PatrolRoutes rest, const PatrolEffort& effort,
                   const SolveWatch& watch);

/**
 * Returns, for each UAV, the number of visits at the beginning of its patrol that are flown as
 * aimed legs: those of the next 800 s, five at least, forty at most, and none after a landing.
 */
[[nodiscard]] std::vector<std::size_t> headsOf(const PatrolSearch& search);

/** Consecutive visits of a UAV's patrol, `end` excluded. */
struct PatrolPart
{
    std::size_t begin = 0;
    std::size_t end = 0;
};

/**
 * Returns a part of a UAV's patrol as legs with the offsets of their aims. `model` must have the
 * icebergs of the patrol.
 */
[[nodiscard]] CoveragePlan legsOf(const PatrolSearch& search, std::size_t uav,
                                  const PatrolPart& part, const CoverageModel& model);

} // namespace berg
