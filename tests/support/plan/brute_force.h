#pragma once

#include "core/base/random.h"
#include "core/plan/problem/tuning.h"
#include "core/plan/problem/tvp.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace berg::test {

/** Optimum over all orders; `order` is the lexicographically first of the best. */
struct BruteForce
{
    double objective = 0; ///< objective by the problem's criterion
    VisitOrder order;
};

/**
 * Returns Eq. (1)-(2) by the visiting numbers t_i of the paper, deliberately computed in another
 * form than `objective`, so that a fault is not repeated.
 */
inline double costByVisitingNumbers(const TvpProblem& problem, const VisitOrder& order)
{
    const std::size_t N = problem.sigma_m2.size();
    std::vector<std::size_t> t(N, 0);
    t[0] = 1;
    for (std::size_t k = 0; k < order.size(); ++k)
        t[toIndex(order[k])] = k + 2;

    double reward = 0;
    double distance_m = 0;
    for (std::size_t i = 0; i < N; ++i) {
        reward += problem.sigma_m2[i] * static_cast<double>(N - t[i]);
        for (std::size_t j = 0; j < N; ++j) {
            const bool pathBack = problem.route == Route::Closed && j == 0 && i != 0 && t[i] == N;
            if (t[j] == t[i] + 1 || pathBack)
                distance_m += problem.distance_m(static_cast<Eigen::Index>(i), //
                                                 static_cast<Eigen::Index>(j));
        }
    }
    return -reward + problem.mu * distance_m;
}

/** Returns the weighted latency, leg by leg: each counts with the sigma that is not yet visited. */
inline double costByLegs(const TvpProblem& problem, const VisitOrder& order)
{
    double cost = 0;
    NodeIndex from;
    for (std::size_t k = 0; k < order.size(); ++k) {
        double unseen_m2 = 0;
        for (std::size_t later = k; later < order.size(); ++later)
            unseen_m2 += problem.sigma_m2[toIndex(order[later])];
        cost += problem.mu * legBetween(problem.distance_m, from, order[k]) * unseen_m2;
        from = order[k];
    }
    return cost;
}

/** Returns the objective by the independent formula. */
inline double independentCost(const TvpProblem& problem, const VisitOrder& order)
{
    return problem.criterion == Criterion::Latency ? costByLegs(problem, order)
                                                   : costByVisitingNumbers(problem, order);
}

/** Tries all permutations: (icebergs)! of them, meant for at most 8 icebergs. */
inline BruteForce bruteForce(const TvpProblem& problem)
{
    VisitOrder order = ascendingOrder(problem.icebergCount());
    BruteForce best{.objective = std::numeric_limits<double>::infinity(), .order = {}};
    do {
        const double cost = independentCost(problem, order);
        if (cost < best.objective)
            best = {.objective = cost, .order = order};
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

/**
 * The paper's Table 1 instances: icebergs uniform in 5 km x 5 km, sigma an integer from 1 to 10,
 * UAV at (-500, -500) m, mu by Eq. (14). `asymmetric` lengthens each arc by its own factor
 * from 1 to 1.5, as wind does.
 */
inline TvpProblem randomProblem(std::uint64_t seed, int icebergs, double tau, Route route,
                                bool asymmetric = false)
{
    Random random(seed, 77);
    Eigen::MatrixX2d points_m(icebergs + 1, 2);
    points_m.row(0) << -500.0, -500.0;
    TvpProblem problem{.distance_m = {}, .sigma_m2 = {0.0}, .mu = 0, .route = route};
    for (int i = 1; i <= icebergs; ++i) {
        points_m(i, 0) = random.uniform(0, 5000);
        points_m(i, 1) = random.uniform(0, 5000);
        problem.sigma_m2.push_back(1.0 + static_cast<double>(random.below(10)));
    }
    problem.distance_m = euclideanDistances(points_m);
    if (asymmetric)
        for (int i = 0; i <= icebergs; ++i)
            for (int j = 0; j <= icebergs; ++j)
                problem.distance_m(i, j) *= random.uniform(1.0, 1.5);
    problem.mu = tuningWeight(problem, tau).mu;
    return problem;
}

} // namespace berg::test
