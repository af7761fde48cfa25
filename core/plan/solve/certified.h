#pragma once

#include <Eigen/Core>

namespace berg {

// Everything that lets a bound be called a bound and an order proven, with the rounding of the
// numbers they are computed from. Costs are those that are never negative: objective + shift.

/** What is proven optimal costs at most this much more than the optimum, relative to its cost. */
inline constexpr double kProofTolerance = 1e-9;
/** Moves that gain less may gain by rounding alone, relative to the cost: a descent must end. */
inline constexpr double kLeastGain = 1e-10;

/** Beside a plan of this cost, plans are of interest that cost less than this. */
[[nodiscard]] double cutoffBelow(double cost, double gap);
/** The same when plans as good as that one are of interest too. */
[[nodiscard]] double cutoffAbove(double cost);
/** Whether a plan takes the place of a known one. Half the tolerance suffices, so that one which
 * only rounding leaves below the cutoff does not stay in the way of the proof. */
[[nodiscard]] bool replaces(double cost, double known);
/** Whether a bound that was raised to the cutoff, perhaps of a slightly dearer plan, is a proof. */
[[nodiscard]] bool isProven(double cost, double bound);

/**
 * Largest error of a bound or of the length of a path, for plans of so many visits and routes, when
 * `magnitude` is at least their cost + sum |lambda| + the lengths that were subtracted from it.
 *
 * Derivation. A visit adds to a path at most these roundings, each of at most u = eps / 2 of the
 * partial sum or product at hand: mu d, that times the weight, the weight's own sum, sigma times
 * position, and four sums (leg, visit, multiplier, sum of the multipliers). No partial sum exceeds
 * `magnitude`, since costs are not negative and a plan visits each iceberg once; products are parts
 * of the cost. A route adds two sums and the comparison with the cutoff five more at most. So
 * 8 (visits + routes) u magnitude (1 + O(u)) bounds the error; this is twice as much. A minimum is
 * never above what the plan's own path comes to, rounded in the same way, because rounded addition
 * is monotone: the other paths, however long and often they visit an iceberg, add no error.
 */
[[nodiscard]] double roundingMargin(Eigen::Index visitsAndRoutes, double magnitude);

/** Whether a proof beside a plan of this cost is possible with such a margin. */
[[nodiscard]] bool allowsProof(double margin, double cost);

/** Multipliers of "each iceberg once", one per node ([0] is 0), and the cost they prune at. */
struct Multipliers
{
    Eigen::VectorXd lambda;
    double sum = 0;    ///< of lambda
    double cutoff = 0; ///< paths of at least this cost are not wanted
    double margin = 0; ///< `roundingMargin` of the orders below the cutoff

    /** Paths whose computed length is at least this are on no order below the cutoff. */
    [[nodiscard]] double allowedLength() const { return cutoff + margin - sum; }
    /** Below the cost of every order that is below the cutoff, from sum(lambda) + shortest length.
     */
    [[nodiscard]] double certified(double bound) const { return bound - margin; }
};

/** With the margin for one route. */
[[nodiscard]] Multipliers certifiedMultipliers(const Eigen::VectorXd& lambda, double cutoff);

} // namespace berg
