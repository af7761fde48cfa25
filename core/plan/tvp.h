#pragma once

#include "core/base/error.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace berg {

/** Open: a path that ends at the last iceberg, (3)-(5). Closed: back to the start. */
enum class Route
{
    Open,
    Closed
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
    Route route = Route::Open;

    [[nodiscard]] int nodeCount() const { return static_cast<int>(sigma_m2.size()); }
    [[nodiscard]] int icebergCount() const { return nodeCount() - 1; }
};

/** Iceberg nodes 1 .. N-1, each once, in visiting order. */
using VisitOrder = std::vector<int>;

/** True when `order` holds each iceberg node of the problem exactly once. */
[[nodiscard]] bool isVisitOrder(const TvpProblem& problem, std::span<const int> order);

/** D of Eq. (2) in metres, the way back included on a closed route. */
[[nodiscard]] double flownDistance(const TvpProblem& problem, std::span<const int> order);

/**
 * F of Eq. (1) with t(UAV) = 1, the only judge of plans: -sum sigma_i (N - t_i) + mu D.
 * `order` must satisfy `isVisitOrder`.
 */
[[nodiscard]] double objective(const TvpProblem& problem, std::span<const int> order);

/** Reward sum sigma_i (N - t_i), the first term of Eq. (1) with its sign changed. */
[[nodiscard]] double uncertaintyReward(const TvpProblem& problem, std::span<const int> order);

/** N sum(sigma): added to F it gives sum(sigma t) + mu D, which is never negative. */
[[nodiscard]] double objectiveShift(const TvpProblem& problem);

/** (objective - bound) / (objective + N sum sigma), at least 0; 0 when that divisor is 0. */
[[nodiscard]] double relativeGap(const TvpProblem& problem, double objective, double bound);

/** Sub-problem of the UAV and `nodes` (iceberg nodes of `problem`), in the order given. */
[[nodiscard]] TvpProblem restrictedTo(const TvpProblem& problem, std::span<const int> nodes);

/** Euclidean distances between points given as rows of an N x 2 matrix, metres. */
[[nodiscard]] Eigen::MatrixXd euclideanDistances(const Eigen::MatrixX2d& points_m);

/** All faults of a problem: sizes, signs, numbers that are not finite. */
[[nodiscard]] std::vector<Issue> validate(const TvpProblem& problem);

} // namespace berg
