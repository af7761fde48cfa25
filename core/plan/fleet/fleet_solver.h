#pragma once

#include "core/plan/fleet/fleet_problem.h"
#include "core/plan/solve/solver.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>

namespace berg {

/** As `SolveProgress`. */
struct FleetProgress
{
    FleetPlan plan;
    double objective = 0;
    std::optional<double> bound;
    double elapsed_s = 0;
};

/** As `SolveOptions`. */
struct FleetOptions
{
    std::optional<double> timeLimit_s;
    std::optional<std::int64_t> workLimit; ///< units of about 2 ns
    std::optional<std::int64_t> memoryLimit_bytes = 1'500'000'000;
    double gap = 0;
    /** Warm start: what is valid of it (`validPart`), the rest put where it costs least. Ignored
     * when it has not one order for each UAV or nothing is left of it. */
    FleetPlan hint;
    std::stop_token stop; ///< checked at least every 10 ms
    std::function<void(const FleetProgress&)> onProgress;
};

/** As `SolveOutcome`. */
struct FleetOutcome
{
    SolveStatus status = SolveStatus::None;
    StopReason reason = StopReason::Finished;
    FleetPlan plan; ///< empty when status is None
    double objective = 0;
    std::optional<double> bound;
    double elapsed_s = 0;
    std::int64_t work = 0;
    bool hintUsed = false;
    std::string backend = {};
    std::string detail = {}; ///< why not, when unable
};

/**
 * Solves the problem by the fleet's counterpart of that back end, with the same promises about
 * status, limits and determinism as `TvpSolver::solve`. Up to 14 icebergs `Exact` and `Auto` use
 * dynamic programming over subsets; else a local search and a bound take turns: `Exact` until the
 * proof, `Auto` and `Heuristic` for about a second's work. Latency has no bound: beyond 14 icebergs
 * `Exact` is unable, and the other two search for some tenths of a second. `Cbc` is `Exact` without
 * dynamic programming, with the orders that the bound leaves put together by CBC: a proof relies on
 * our bound for what is left out. Unable for latency. At mu = 0
 * an assignment is the proof (`bestRanks`), whatever the back end, the work and the memory. A
 * problem that `validate` faults throws `Error{InvalidInput}`.
 */
[[nodiscard]] FleetOutcome solveFleet(const FleetProblem& problem, Backend backend,
                                      const FleetOptions& options);

} // namespace berg
