#pragma once

#include <Eigen/Core>

#include <memory>

namespace berg {

class NgSets;

/** One step of a proof, which an independent checker can repeat; see `Proof`. */
struct ProofStep
{
    Eigen::VectorXd lambda; ///< multipliers, one per node, [0] is 0
    /** Memory to add to the graph; null if there is none to add. */
    std::shared_ptr<const NgSets> sets{};
};

} // namespace berg
