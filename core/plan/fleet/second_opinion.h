#pragma once

#include "core/plan/fleet/fleet_problem.h"
#include "core/plan/solve/solver.h"

namespace berg {

/** Result of comparing the answer of a second solver with the first. */
enum class Verdict
{
    Agrees,    ///< the second solver proves that the first one's order is optimal
    Disagrees, ///< one of them claims a proof that the other one's order refutes
    /** No contradiction, but the second solver has no proof, or only one of another order. */
    NotVerified
};

/** Answer of a second solver, and the verdict. */
struct SecondOpinion
{
    SolveOutcome outcome;
    /** The MILP, if `outcome` is an answer of CBC for one UAV. */
    std::optional<Formulation> formulation;
    Verdict verdict = Verdict::NotVerified;
};

/**
 * Compares two answers. Objectives count as equal within 1e-6 of F + N sum(sigma), far above the
 * rounding of any solver.
 */
[[nodiscard]] Verdict verdictOn(const FleetProblem& problem, const SolveOutcome& first,
                                const SolveOutcome& second);

/**
 * Solves again without using the first answer. Our own solvers are checked by CBC: up to 16
 * icebergs (about a second) on the position-indexed MILP, which uses nothing of ours; beyond on the
 * reduced one, in which CBC decides between the orders that the bound of our engine leaves (see
 * `reducedModel`). `formulation` selects another MILP. For several UAVs CBC combines the orders
 * that our bound leaves. CBC is checked by the exact solver, or by `Auto` if that is unable. The
 * time limit and the stop token of the options apply; the other options do not, because the aim is
 * a proof. Throws `Error{Unsupported}` if this build lacks CBC, and as `solve` does.
 */
[[nodiscard]] SecondOpinion secondOpinion(const FleetProblem& problem, const SolveOutcome& first,
                                          const SolveOptions& options,
                                          std::optional<Formulation> formulation = {});

} // namespace berg
