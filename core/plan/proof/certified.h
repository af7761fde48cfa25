#pragma once

#include <Eigen/Core>

namespace berg {

// Tolerances and margins that make a bound and a proof hold in spite of the rounding of the numbers
// they are computed from. Costs are never negative: objective + shift.

/**
 * A plan that is proven optimal costs at most this much more than the optimum, relative to its
 * cost.
 */
inline constexpr double kProofTolerance = 1e-9;
/**
 * Moves that gain less, relative to the cost, may gain by rounding alone and are not made: a
 * descent must end.
 */
inline constexpr double kLeastGain = 1e-10;

/**
 * Returns the cost below which plans are of interest beside a plan of this cost, for a relative
 * gap.
 */
[[nodiscard]] double cutoffBelow(double cost, double gap);
/**
 * Returns the cost below which plans are of interest if those as good as a plan of this cost are
 * included.
 */
[[nodiscard]] double cutoffAbove(double cost);
/**
 * Returns whether a plan replaces a known one. Half the tolerance suffices, so that a plan that
 * only rounding puts below the cutoff does not block the proof.
 */
[[nodiscard]] bool replaces(double cost, double known);
/**
 * Returns whether a bound that was raised to the cutoff, perhaps that of a slightly costlier plan,
 * is a proof.
 */
[[nodiscard]] bool isProven(double cost, double bound);

/**
 * Returns the largest error of a bound or of the length of a path, for plans with this sum of
 * visits and routes, if `magnitude` is at least their cost + sum |lambda| + the lengths that were
 * subtracted from it.
 *
 * Derivation. A visit adds to a path at most these roundings, each of at most u = eps / 2 of the
 * partial sum or product at hand: mu d, that times the weight, the weight's own sum, sigma times
 * position, and four sums (leg, visit, multiplier, sum of the multipliers). No partial sum exceeds
 * `magnitude`, since costs are not negative and a plan visits each iceberg once; products are parts
 * of the cost. A route adds two sums and the comparison with the cutoff five more at most. So 8
 * (visits + routes) u magnitude (1 + O(u)) bounds the error; this is twice as much. A minimum is
 * never above the length of the plan's own path, rounded in the same way, because rounded addition
 * is monotone: the other paths, however long and often they visit an iceberg, add no error.
 */
[[nodiscard]] double roundingMargin(Eigen::Index visitsAndRoutes, double magnitude);

/** Returns whether a proof beside a plan of this cost is possible with such a margin. */
[[nodiscard]] bool allowsProof(double margin, double cost);

/**
 * Multipliers of "each iceberg once", one per node ([0] is 0), and the cost at which they prune.
 */
struct Multipliers
{
    Eigen::VectorXd lambda;
    double sum = 0;    ///< sum of lambda
    double cutoff = 0; ///< paths of at least this cost are of no interest
    double margin = 0; ///< `roundingMargin` of the orders below the cutoff

    /** Returns the length from which a computed path is on no order below the cutoff. */
    [[nodiscard]] double allowedLength() const { return cutoff + margin - sum; }
    /**
     * Returns a lower bound on the cost of every order below the cutoff, from a computed `bound` of
     * sum(lambda) + shortest length.
     */
    [[nodiscard]] double certified(double bound) const { return bound - margin; }
};

/** Returns the multipliers with the margin for one route. */
[[nodiscard]] Multipliers certifiedMultipliers(const Eigen::VectorXd& lambda, double cutoff);

} // namespace berg
