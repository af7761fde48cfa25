#pragma once

#include "core/plan/fleet/fleet_problem.h"
#include "core/plan/solve/proof_step.h"

#include <stop_token>
#include <vector>

namespace berg {

/** How somebody else can check a bound; see `certify`. */
enum class ProofMethod
{
    Enumeration, ///< small enough for dynamic programming over subsets of icebergs
    Sorting,     ///< mu = 0: the most uncertain icebergs first
    Relaxation   ///< by the steps
};

/**
 * Bound <= optimum <= cost, in costs that are sums of positive terms: objective + shift.
 *
 * A relaxation is that of "each iceberg once" on the layered graph, which begins with all arcs
 * (`LayeredGraph`). Each step makes it remember more, when it has memories, and deletes with its
 * multipliers the arcs that are on no path below the bound; no order that is left is below it. Of
 * several UAVs there is one step that deletes nothing: sum(lambda) + the shortest paths are the
 * bound.
 */
struct Proof
{
    double mu = 0;
    FleetPlan orders;
    double cost = 0;
    double bound = 0; ///< 0 when none is known
    ProofMethod method = ProofMethod::Enumeration;
    std::vector<int> rises; ///< of the level by iceberg, [0] is 0; latency of one UAV only
    std::vector<ProofStep> steps;
};

/** Everything that a check needs. */
struct Certificate
{
    FleetProblem problem; ///< of one UAV or several; its mu is not read
    std::vector<Proof> proofs;
};

/** Up to so many icebergs the bound goes as far as 2e-9 below the optimum; with more, as large
 * graphs would be, to 0.1 %. */
inline constexpr int kMostCertifiedExactly = 40;

/**
 * A proof for the order of a valid problem, made anew whatever was proven before; cut or above 127
 * icebergs, with the bound of the multipliers without memories. The order need not be optimal:
 * then the bound is one on the optimum all the same.
 */
[[nodiscard]] Proof certify(const TvpProblem& problem, const VisitOrder& order,
                            const std::stop_token& stop = {});

/** The same for several UAVs: up to 14 icebergs, or what multipliers and memories prove. */
[[nodiscard]] Proof certify(const FleetProblem& problem, const FleetPlan& plan,
                            const std::stop_token& stop = {});

} // namespace berg
