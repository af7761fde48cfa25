#pragma once

#include "core/plan/policy/policy.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace berg {

/** A plan and the range of tau for which it is best. */
struct CurveInterval
{
    double tauFrom = 0;
    double tauTo = 0;
    FleetPlan plan;        ///< an order for each UAV
    double distance_m = 0; ///< D of Eq. (2), total of all UAVs
    double reward_m2 = 0;  ///< negative of the first term of Eq. (1)
    /** Whether the plan is optimal for every tau of the interval, to 1e-9 of the cost. */
    bool proven = false;
    /** Returns the order of the first UAV, which is the plan if there is only one. */
    [[nodiscard]] const VisitOrder& order() const { return plan.front(); }
    bool operator==(const CurveInterval&) const = default;
};

/**
 * The optimum of Eq. (1) as a function of tau: a concave, piecewise linear curve, because F of a
 * plan is linear in mu and mu in tau, Eq. (14). It is also the supported Pareto front of distance
 * against reward: both decrease along tau.
 */
struct TauCurve
{
    /** Intervals that cover [0, tauMax] without gaps; empty if nothing is known. */
    std::vector<CurveInterval> intervals;
    /** `Cancelled` if stopped, `WorkLimit` if it ended with intervals that are not proven. */
    StopReason reason = StopReason::Finished;
    /** Whether the search ended: nothing is left to find or prove within the limits. */
    bool complete = false;
    bool operator==(const TauCurve&) const = default;
};

/** Options of `tauCurve`. */
struct TauCurveOptions
{
    double tauMax = 5; ///< end of the curve; > 0
    /**
     * Limit of the searches for plans, and again of the proofs: moves evaluated and arcs examined,
     * 2 to 5 ns each; the result repeats. When the searches reach it the curve found so far
     * remains, which then has fewer intervals; unproven intervals are marked. Dynamic programming
     * is not counted.
     */
    std::int64_t workLimit = 10'000'000'000;
    std::stop_token stop; ///< checked at least every 10 ms
    /** Called with the curve so far; may be empty. */
    std::function<void(const TauCurve&)> onProgress{};
};

/**
 * Returns all optimal plans of a problem over [0, tauMax] with exact breakpoints, by the dichotomic
 * scheme of Aneja and Nair (1979): where the lines of two known neighbours cross, either a plan
 * below both is found, or the two are final neighbours. `mu` of the problem is not read. The first
 * interval holds the optimum for tau -> 0+: ties of sigma broken by distance.
 *
 * With one UAV, plans are proven by dynamic programming up to 13 icebergs, and by `improveBound`
 * beyond as far as the work limit allows. With several UAVs they are proven as far as `solveFleet`
 * does: all up to 14 icebergs, beyond that those for which the limited work per plan suffices.
 * `betweenStarts_m` is that of `fleetTuningWeight`. If stopped, returns the curve found so far,
 * with `StopReason::Cancelled`. Throws `Error{InvalidInput}` for problems in which `validate` finds
 * faults with mu = 0 or with mu(tauMax), and `std::logic_error` if `tauMax` is not above 0, if
 * `betweenStarts_m` has the wrong size or inside a `NoBlockingScope`.
 */
[[nodiscard]] TauCurve tauCurve(const FleetProblem& problem, const Eigen::MatrixXd& betweenStarts_m,
                                const TauCurveOptions& options);

/**
 * Returns the index of the interval that holds tau (at a breakpoint the one to its right, outside
 * the curve the nearest one), or nullopt for an empty curve.
 */
[[nodiscard]] std::optional<int> intervalAt(const TauCurve& curve, double tau);

} // namespace berg
