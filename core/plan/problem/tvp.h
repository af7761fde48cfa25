#pragma once

#include "core/base/error.h"
#include "core/base/index.h"

#include <Eigen/Core>

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

namespace berg {

/**
 * Open: a path that ends at the last iceberg, (3)-(5). Closed: a tour that returns to the start.
 */
enum class Route
{
    Open,
    Closed
};

/** Criterion of a plan. */
enum class Criterion
{
    Visitation, ///< Eq. (1): uncertain icebergs early, and mu times the distance
    Latency     ///< mu times the sum of sigma_i times the distance flown until iceberg i
};

/**
 * The target visitation problem of Eq. (1)-(9): N nodes, node 0 is the UAV (the paper's node 1),
 * nodes 1 .. N-1 are icebergs. It holds distances and uncertainties, and nothing else about
 * icebergs.
 */
struct TvpProblem
{
    Eigen::MatrixXd distance_m;   ///< N x N, row = from; may be asymmetric; diagonal ignored
    std::vector<double> sigma_m2; ///< N values; [0] belongs to the UAV and is 0
    double mu = 0;                ///< weight of distance, Eq. (14), >= 0
    Route route = Route::Open;    ///< with `Criterion::Latency` the return leg costs nothing
    Criterion criterion = Criterion::Visitation;

    [[nodiscard]] int nodeCount() const { return static_cast<int>(sigma_m2.size()); }
    [[nodiscard]] int icebergCount() const { return nodeCount() - 1; }
};

/** Iceberg nodes 1 .. N-1, each once, in visiting order. */
using VisitOrder = std::vector<NodeIndex>;

/** One order for each UAV, which may be empty. */
using FleetPlan = std::vector<VisitOrder>;

/** Returns the nodes 1 .. of so many icebergs, for loops. */
[[nodiscard]] constexpr NodeRange icebergNodes(int icebergs)
{
    return {1, NodeIndex::of(std::max(icebergs, 0) + 1)};
}

/** Returns the nodes 1 .. of so many icebergs as an order. */
[[nodiscard]] VisitOrder ascendingOrder(int icebergs);

/** Returns the nodes with these numbers, as files and messages hold them. */
[[nodiscard]] VisitOrder nodesOf(std::span<const int> numbers);

/** Returns the numbers of nodes, the reverse of `nodesOf`. */
[[nodiscard]] std::vector<int> numbersOf(std::span<const NodeIndex> nodes);

/** Returns the length of a leg by a matrix with one row and column for each node. */
[[nodiscard]] inline double legBetween(const Eigen::MatrixXd& distance_m, NodeIndex from,
                                       NodeIndex to)
{
    return distance_m(from.number(), to.number());
}

/** Returns whether `order` holds each iceberg node of the problem exactly once. */
[[nodiscard]] bool isVisitOrder(const TvpProblem& problem, std::span<const NodeIndex> order);

/**
 * Returns the length of the order's route; calls `visit` with each node and the distance flown to
 * it.
 */
template <class Visit>
double follow(const Eigen::MatrixXd& distance_m, Route route, std::span<const NodeIndex> order,
              const Visit& visit)
{
    double flown_m = 0;
    NodeIndex from;
    for (const NodeIndex node : order) {
        flown_m += legBetween(distance_m, from, node);
        visit(node, flown_m);
        from = node;
    }
    if (route == Route::Closed && !order.empty())
        flown_m += legBetween(distance_m, from, 0);
    return flown_m;
}

/**
 * Returns the sum of sigma_i times the distance flown until iceberg i, m^3: a leg costs its length
 * times the sigma still unvisited.
 */
[[nodiscard]] double weightedLatency(const Eigen::MatrixXd& distance_m,
                                     std::span<const double> sigma_m2,
                                     std::span<const NodeIndex> order);

/** Returns D of Eq. (2), m, with the return leg of a closed route. */
[[nodiscard]] double flownDistance(const TvpProblem& problem, std::span<const NodeIndex> order);

/**
 * Returns the objective, by which all plans are compared. Visitation: F of Eq. (1) with t(UAV) = 1,
 * -sum sigma_i (N - t_i) + mu D. Latency: mu sum sigma_i d_i, d_i the distance flown until iceberg
 * i; with mu = 1 / airspeed it is sum sigma_i t_i in m^2 s, t_i the arrival time. Throws
 * `std::logic_error` unless `isVisitOrder`.
 */
[[nodiscard]] double objective(const TvpProblem& problem, std::span<const NodeIndex> order);

/** Returns the reward sum sigma_i (N - t_i), the negative of the first term of Eq. (1). */
[[nodiscard]] double uncertaintyReward(const TvpProblem& problem, std::span<const NodeIndex> order);

/**
 * Returns the constant that makes the objective a sum of costs, which is never negative: N
 * sum(sigma), which added to F gives sum(sigma t) + mu D; 0 for latency.
 */
template <class Problem>
[[nodiscard]] double objectiveShift(const Problem& problem)
{
    if (problem.criterion == Criterion::Latency)
        return 0;
    return problem.nodeCount() *
           std::accumulate(problem.sigma_m2.begin(), problem.sigma_m2.end(), 0.0);
}

/**
 * Returns (objective - bound) / (objective + `objectiveShift`), at least 0; 0 if that divisor is 0.
 */
template <class Problem>
[[nodiscard]] double relativeGap(const Problem& problem, double objective, double bound)
{
    const double scale = objective + objectiveShift(problem);
    return scale > 0 ? std::max(0.0, objective - bound) / scale : 0.0;
}

/**
 * Returns the sub-problem of the UAV and `nodes` (iceberg nodes of `problem`), in the order given.
 */
[[nodiscard]] TvpProblem restrictedTo(const TvpProblem& problem, std::span<const NodeIndex> nodes);

/** Returns the Euclidean distances, m, between points given as rows of an N x 2 matrix. */
[[nodiscard]] Eigen::MatrixXd euclideanDistances(const Eigen::MatrixX2d& points_m);

/**
 * Returns all faults of a problem: wrong sizes or signs, numbers that are not finite, and costs too
 * large or too small to compute with.
 */
[[nodiscard]] std::vector<Issue> validate(const TvpProblem& problem);

} // namespace berg
