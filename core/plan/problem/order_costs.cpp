#include "core/plan/problem/order_costs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace berg {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/**
 * Returns the levels of an iceberg of mean sigma. With fewer than ten the bounds on the sigma seen
 * are so loose that some proofs at 40 icebergs never end; more make the graph larger. Measured.
 */
double levelsPerIceberg(int icebergs)
{
    constexpr double kFinest = 14;
    constexpr double kCoarsest = 4;
    constexpr double kMostWork = 2e7; // work of a sweep: levels times icebergs squared
    const double n = icebergs;
    return std::clamp(kMostWork / (n * n * n), kCoarsest, kFinest);
}

/**
 * Returns `leastUnseen`, from sums of the sigmas unseen: differences would lose the small ones
 * among large sigmas. Cost: icebergs times levels.
 */
Eigen::ArrayXd unseenByLevel(const LatencyCosts& costs)
{
    Eigen::ArrayXd unseen = Eigen::ArrayXd::Constant(costs.lastLevel() + 1, kInfinity);
    unseen(costs.lastLevel()) = 0;
    int reached = costs.lastLevel();
    for (const NodeIndex i : icebergNodes(costs.icebergs)) {
        const int step = costs.step(i);
        for (int level = reached; level <= costs.lastLevel(); ++level)
            unseen(level - step) = std::min(unseen(level - step), unseen(level) + costs.sigmaOf(i));
        reached -= step;
    }
    return unseen;
}

} // namespace

LegTable::LegTable(const TvpProblem& problem)
    : icebergs(problem.icebergCount())
    , legs(problem.mu * problem.distance_m.transpose())
    , sigma(problem.sigma_m2)
{
    legs.diagonal().setZero(); // never read; the problem may hold anything here
    if (problem.route == Route::Open || problem.criterion == Criterion::Latency)
        legs.row(0).setZero();
}

LatencyCosts::LatencyCosts(const TvpProblem& problem)
    : LegTable(problem)
    , sigmaSum(std::accumulate(sigma.begin(), sigma.end(), 0.0))
    , steps(sigma.size(), 0)
{
    const double levels = icebergs * levelsPerIceberg(icebergs);
    for (int i = 1; i <= icebergs; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double share = sigmaSum > 0 ? sigma[k] / sigmaSum : 0.0;
        steps[k] = std::max(1, static_cast<int>(std::lround(share * levels)));
        last += steps[k];
    }
    leastUnseen = unseenByLevel(*this);
}

} // namespace berg
