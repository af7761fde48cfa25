#pragma once

#include "core/plan/policy/policy.h"

#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

namespace berg {

/** One plan and the trade-offs it is best for. */
struct CurveInterval
{
    double tauFrom = 0;
    double tauTo = 0;
    FleetPlan plan;        ///< an order for each UAV
    double distance_m = 0; ///< D of Eq. (2), in all
    double reward_m2 = 0;  ///< first term of Eq. (1) with its sign changed
    bool proven = false;   ///< optimal for every tau of the interval, to 1e-9 of the cost
    /** That of the first UAV, and the plan when there is one only. */
    [[nodiscard]] const VisitOrder& order() const { return plan.front(); }
    bool operator==(const CurveInterval&) const = default;
};

/**
 * The optimum of Eq. (1) as a function of tau: a concave, piecewise linear curve, since F of a
 * plan is linear in mu and mu in tau, Eq. (14). Also the supported Pareto front of distance
 * against reward: along tau both go down.
 */
struct TauCurve
{
    std::vector<CurveInterval> intervals; ///< without gap over [0, tauMax]; empty: nothing known
    StopReason reason = StopReason::Finished;
    bool complete = false; ///< nothing is left to be searched or proven within the limits
    bool operator==(const TauCurve&) const = default;
};

struct TauCurveOptions
{
    double tauMax = 5; ///< > 0
    /**
     * Of the searches for plans, and as much again of their proofs: moves valued and arcs looked
     * at, 2 to 5 ns each; repeats. Searches at their end leave the curve found so far, which has
     * fewer intervals then. What is left unproven says so. Dynamic programming is not counted.
     */
    std::int64_t workLimit = 10'000'000'000;
    std::stop_token stop;                              ///< checked at least every 10 ms
    std::function<void(const TauCurve&)> onProgress{}; ///< the curve as known so far; may be empty
};

/**
 * All optimal plans of a problem over [0, tauMax] with exact breakpoints, by the dichotomic
 * scheme of Aneja and Nair (1979): where the lines of two known neighbours cross, either a plan
 * below both is found, or the two are neighbours for good. `mu` of the problem is not read. The
 * first interval holds what is optimal for tau -> 0+: ties of sigma broken by distance.
 *
 * Of one UAV proven up to 13 icebergs by dynamic programming, above by `improveBound` as far as the
 * work limit allows. Of several as far as `solveFleet` proves its plans: all up to 14 icebergs,
 * with more those that the limited work for one plan is enough for. `betweenStarts_m`: as
 * `fleetTuningWeight`. Throws `Error{InvalidInput}` for problems that `validate` faults.
 */
[[nodiscard]] TauCurve tauCurve(const FleetProblem& problem, const Eigen::MatrixXd& betweenStarts_m,
                                const TauCurveOptions& options);

/**
 * Index of the interval that holds tau (at a breakpoint the one to its right, outside the curve the
 * nearest one); -1 when there is none.
 */
[[nodiscard]] int intervalAt(const TauCurve& curve, double tau);

} // namespace berg
