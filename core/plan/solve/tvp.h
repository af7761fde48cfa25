#pragma once

#include "core/base/error.h"

#include <Eigen/Core>

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

namespace berg {

/** Open: a path that ends at the last iceberg, (3)-(5). Closed: back to the start. */
enum class Route
{
    Open,
    Closed
};

/** What a plan is judged by. */
enum class Criterion
{
    Visitation, ///< Eq. (1): uncertain icebergs early, and mu times the distance
    Latency     ///< mu times the sum of sigma_i times the distance flown until iceberg i
};

/**
 * The target visitation problem of Eq. (1)-(9): N nodes, node 0 is the UAV (the paper's node 1),
 * nodes 1 .. N-1 are icebergs. It knows distances and uncertainties, nothing of icebergs.
 */
struct TvpProblem
{
    Eigen::MatrixXd distance_m;   ///< N x N, row = from; may be asymmetric; diagonal ignored
    std::vector<double> sigma_m2; ///< N; [0] is the UAV's and 0
    double mu = 0;                ///< weight of distance, Eq. (14), >= 0
    Route route = Route::Open;    ///< `Criterion::Latency`: the way back costs nothing
    Criterion criterion = Criterion::Visitation;

    [[nodiscard]] int nodeCount() const { return static_cast<int>(sigma_m2.size()); }
    [[nodiscard]] int icebergCount() const { return nodeCount() - 1; }
};

/** Iceberg nodes 1 .. N-1, each once, in visiting order. */
using VisitOrder = std::vector<int>;

/** One order for each UAV, which may be empty. */
using FleetPlan = std::vector<VisitOrder>;

/** True when `order` holds each iceberg node of the problem exactly once. */
[[nodiscard]] bool isVisitOrder(const TvpProblem& problem, std::span<const int> order);

/** Length of the order's route; tells `visit` each node and the distance flown to it. */
template <class Visit>
double follow(const Eigen::MatrixXd& distance_m, Route route, std::span<const int> order,
              const Visit& visit)
{
    double flown_m = 0;
    int from = 0;
    for (const int node : order) {
        flown_m += distance_m(from, node);
        visit(node, flown_m);
        from = node;
    }
    if (route == Route::Closed && !order.empty())
        flown_m += distance_m(from, 0);
    return flown_m;
}

/** sum of sigma_i times the distance flown until iceberg i, m^3: a leg costs its length times the
 * sigma still unvisited. */
[[nodiscard]] double weightedLatency(const Eigen::MatrixXd& distance_m,
                                     std::span<const double> sigma_m2, std::span<const int> order);

/** D of Eq. (2) in metres, the way back included on a closed route. */
[[nodiscard]] double flownDistance(const TvpProblem& problem, std::span<const int> order);

/**
 * The only judge of plans. Visitation: F of Eq. (1) with t(UAV) = 1, -sum sigma_i (N - t_i) + mu D.
 * Latency: mu sum sigma_i d_i, d_i the distance flown until iceberg i; with mu = 1 / airspeed that
 * is sum sigma_i t_i in m^2 s, t_i the arrival time.
 * `order` must satisfy `isVisitOrder`.
 */
[[nodiscard]] double objective(const TvpProblem& problem, std::span<const int> order);

/** Reward sum sigma_i (N - t_i), the first term of Eq. (1) with its sign changed. */
[[nodiscard]] double uncertaintyReward(const TvpProblem& problem, std::span<const int> order);

/**
 * What makes the objective a sum of costs, which is never negative: N sum(sigma), which added to F
 * gives sum(sigma t) + mu D; 0 for latency.
 */
template <class Problem>
[[nodiscard]] double objectiveShift(const Problem& problem)
{
    if (problem.criterion == Criterion::Latency)
        return 0;
    return problem.nodeCount() *
           std::accumulate(problem.sigma_m2.begin(), problem.sigma_m2.end(), 0.0);
}

/** (objective - bound) / (objective + `objectiveShift`), at least 0; 0 when that divisor is 0. */
template <class Problem>
[[nodiscard]] double relativeGap(const Problem& problem, double objective, double bound)
{
    const double scale = objective + objectiveShift(problem);
    return scale > 0 ? std::max(0.0, objective - bound) / scale : 0.0;
}

/** Sub-problem of the UAV and `nodes` (iceberg nodes of `problem`), in the order given. */
[[nodiscard]] TvpProblem restrictedTo(const TvpProblem& problem, std::span<const int> nodes);

/** Euclidean distances between points given as rows of an N x 2 matrix, metres. */
[[nodiscard]] Eigen::MatrixXd euclideanDistances(const Eigen::MatrixX2d& points_m);

/** All faults of a problem: sizes, signs, numbers that are not finite. */
[[nodiscard]] std::vector<Issue> validate(const TvpProblem& problem);

} // namespace berg
