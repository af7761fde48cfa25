#pragma once

#include "core/plan/fleet/fleet_problem.h"
#include "core/plan/solve/solver.h"

namespace berg {

/** What a second solver's answer says about the first one's. */
enum class Verdict
{
    Agrees,     ///< the second one proves that the first one's order is optimal
    Disagrees,  ///< one of them claims a proof that the other one's order refutes
    NotVerified ///< no contradiction, but no proof by the second one either, or of another
                ///< order
};

struct SecondOpinion
{
    SolveOutcome outcome;
    std::optional<Formulation> formulation; ///< the MILP, when `outcome` is CBC's of one UAV
    Verdict verdict = Verdict::NotVerified;
};

/** Objectives count as equal within 1e-6 of F + N sum(sigma), far above what any solver rounds.
 */
[[nodiscard]] Verdict verdictOn(const FleetProblem& problem, const SolveOutcome& first,
                                const SolveOutcome& second);

/**
 * Solves again without a word about the first answer. Our own solvers are checked by CBC: on
 * the position-indexed MILP, which uses nothing of ours, up to 16 icebergs (about a second),
 * beyond on the reduced one, in which CBC decides between what the bound of our engine leaves
 * (see `reducedModel`); another `formulation` can be asked for. Of several UAVs CBC puts the
 * orders together that our bound leaves. CBC is checked by the exact solver. Limits of time and
 * the stop token hold as given; work and gap do not, as a proof is wanted.
 */
[[nodiscard]] SecondOpinion secondOpinion(const FleetProblem& problem, const SolveOutcome& first,
                                          const SolveOptions& options,
                                          std::optional<Formulation> formulation = {});

} // namespace berg
