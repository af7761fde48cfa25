#pragma once

#include "core/plan/fleet/fleet_problem.h"
#include "core/plan/proof/proof_step.h"

#include <stop_token>
#include <vector>

namespace berg {

/** Method by which an independent checker can check a bound; see `certify`. */
enum class ProofMethod
{
    Enumeration, ///< small enough for dynamic programming over subsets of icebergs
    Sorting,     ///< mu = 0: the most uncertain icebergs come first
    Relaxation   ///< the steps of the proof
};

/**
 * Proof that bound <= optimum <= cost, in costs that are sums of positive terms: objective + shift.
 *
 * A relaxation is that of "each iceberg once" on the layered graph, which begins with all arcs
 * (`LayeredGraph`). Each step first adds its memories to the graph, if it has any, and then deletes
 * with its multipliers the arcs that are on no path below the bound; no order that remains is below
 * it. For several UAVs there is one step that deletes nothing: sum(lambda) + the shortest paths are
 * the bound.
 */
struct Proof
{
    double mu = 0;
    FleetPlan orders;
    double cost = 0;
    double bound = 0; ///< lower bound on the cost; the trivial bound 0 without a better one
    ProofMethod method = ProofMethod::Enumeration;
    /**
     * Number of levels by which each iceberg raises a path; [0] is 0. Empty unless the relaxation
     * is that of the latency of one UAV.
     */
    std::vector<int> rises;
    std::vector<ProofStep> steps;
};

/** Everything that a check needs: a problem and proofs for plans of it. */
struct Certificate
{
    FleetProblem problem; ///< problem of one UAV or several; its mu is not read
    std::vector<Proof> proofs;
};

/**
 * Up to this many icebergs the bound comes within 2e-9 of the optimum; with more, because graphs
 * would get large, within 0.1 %.
 */
inline constexpr int kMostCertifiedExactly = 40;

/**
 * Returns a proof for an order of a valid problem, computed again, independent of earlier proofs.
 * If stopped, or with more than 127 icebergs, it uses the bound of the multipliers without
 * memories; if stopped with up to 14 icebergs, the bound is 0. The order need not be optimal: the
 * bound is one on the optimum in any case. Throws `std::logic_error` unless `isVisitOrder`, and
 * with up to 14 icebergs inside a `NoBlockingScope`.
 */
[[nodiscard]] Proof certify(const TvpProblem& problem, const VisitOrder& order,
                            const std::stop_token& stop = {});

/**
 * Returns a proof for a plan of several UAVs: exact up to 14 icebergs, else the bound of
 * multipliers and memories. The bound is 0 if stopped too early or if there are more than 14
 * icebergs and not `isBounded`. A problem of one UAV goes to the function above. Throws
 * `std::logic_error` unless `isFleetPlan`.
 */
[[nodiscard]] Proof certify(const FleetProblem& problem, const FleetPlan& plan,
                            const std::stop_token& stop = {});

} // namespace berg
