#pragma once

#include <Eigen/Core>

#include <memory>

namespace berg {

class NgSets;

/** What somebody else must do to prove the same: see `Proof`. */
struct ProofStep
{
    Eigen::VectorXd lambda;               ///< multipliers, one per node, [0] is 0
    std::shared_ptr<const NgSets> sets{}; ///< what the graph is to remember; none: nothing more
};

} // namespace berg
