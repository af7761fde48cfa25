#include "core/plan/proof/certified.h"

#include <algorithm>
#include <limits>

namespace berg {

double cutoffBelow(double cost, double gap)
{
    return cost * (1 - std::max(kProofTolerance, gap));
}

double cutoffAbove(double cost)
{
    // If all costs are 0, a relative tolerance alone would leave nothing.
    return cost * (1 + kProofTolerance) + std::numeric_limits<double>::min();
}

bool replaces(double cost, double known)
{
    return cost < known * (1 - kProofTolerance / 2);
}

bool isProven(double cost, double bound)
{
    return cost - bound <= 2 * kProofTolerance * cost;
}

double roundingMargin(Eigen::Index visitsAndRoutes, double magnitude)
{
    constexpr double kRoundings = 8;
    return kRoundings * static_cast<double>(visitsAndRoutes) *
           std::numeric_limits<double>::epsilon() * magnitude;
}

bool allowsProof(double margin, double cost)
{
    constexpr double kMostOfTolerance = 0.25; // it counts at both ends, and the multipliers grow
    return margin <= kMostOfTolerance * kProofTolerance * cost;
}

Multipliers certifiedMultipliers(const Eigen::VectorXd& lambda, double cutoff)
{
    // The size counts one multiplier for each visit, and [0] for the route.
    return {.lambda = lambda,
            .sum = lambda.sum(),
            .cutoff = cutoff,
            .margin = roundingMargin(lambda.size(), cutoff + lambda.lpNorm<1>())};
}

} // namespace berg
