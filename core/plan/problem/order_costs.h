#pragma once

#include "core/plan/problem/tvp.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace berg {

/** Returns the sum of the legs and visits of an order. */
template <class Costs>
[[nodiscard]] double costOfVisits(const Costs& costs, std::span<const NodeIndex> order)
{
    double sum = 0;
    NodeIndex from;
    int position = 0;
    for (const NodeIndex node : order) {
        sum += costs.leg(from, node) + costs.visit(node, ++position);
        from = node;
    }
    return sum + costs.leg(from, 0);
}

/** Returns the sum of the sigmas, each times the length flown until there. */
template <class Costs>
[[nodiscard]] double weightedLength(const Costs& costs, std::span<const NodeIndex> order)
{
    double length = 0;
    double sum = 0;
    NodeIndex from;
    for (const NodeIndex node : order) {
        length += costs.leg(from, node);
        sum += costs.sigmaOf(node) * length;
        from = node;
    }
    return sum;
}

/**
 * Data shared by the costs of both criteria, in a layout for inner loops. Search, graph and bound
 * are templates over `VisitCosts` and `LatencyCosts`, which have the same members:
 *
 * - levels: an iceberg raises the level of a path by `step(iceberg)` >= 1, from 0 at the UAV to
 *   `lastLevel()` at the end of every order. Levels are the layers of the relaxation's graph.
 * - `visit(iceberg, level)` is added where the visit raises the path to that level.
 * - `kWeighted`: whether a leg counts as many times as there is sigma unseen, or once.
 */
struct LegTable
{
    explicit LegTable(const TvpProblem& problem);

    /** Returns the cost of a leg; `from` 0 is the UAV, `to` 0 the end of the route. */
    [[nodiscard]] double leg(NodeIndex from, NodeIndex to) const
    {
        return legs(to.number(), from.number());
    }
    [[nodiscard]] double sigmaOf(NodeIndex node) const { return sigma[toIndex(node)]; }
    int icebergs = 0;
    /**
     * N x N, column = from, row = to, mu d; row 0 is the end of the route: 0 if open, the return
     * leg if closed.
     */
    Eigen::MatrixXd legs;
    std::vector<double> sigma; ///< N, m^2
};

/**
 * Eq. (1) plus the constant N sum(sigma): a leg from i to j flown into position p (1 for the first
 * iceberg, so t = p + 1) costs mu d(i,j) + sigma_j (p + 1) >= 0. Levels are positions.
 */
struct VisitCosts : LegTable
{
    static constexpr bool kWeighted = false;

    explicit VisitCosts(const TvpProblem& problem) : LegTable(problem) {}

    [[nodiscard]] static int step(NodeIndex /*iceberg*/) { return 1; }
    [[nodiscard]] int lastLevel() const { return icebergs; }
    [[nodiscard]] double visit(NodeIndex node, int position) const
    {
        return sigmaOf(node) * (position + 1);
    }
    /** Returns the sum of an order's costs: `objective` + `objectiveShift`. */
    [[nodiscard]] double total(std::span<const NodeIndex> order) const
    {
        return costOfVisits(*this, order);
    }
};

/**
 * Weighted latency: a leg costs mu d(i,j) times the sigma still unseen, that of j included. Levels
 * count the sigma seen in units of about a fourteenth of the mean sigma (with more than 112
 * icebergs a larger part of it, up to a fourth), rounded for each iceberg. The sigmas themselves
 * are not rounded; but a node of the graph, which holds only its level, has only bounds on the
 * sigma unseen.
 */
struct LatencyCosts : LegTable
{
    static constexpr bool kWeighted = true;

    explicit LatencyCosts(const TvpProblem& problem);

    [[nodiscard]] int step(NodeIndex iceberg) const { return steps[toIndex(iceberg)]; }
    [[nodiscard]] int lastLevel() const { return last; }
    [[nodiscard]] static double visit(NodeIndex /*node*/, int /*level*/) { return 0; }
    /** Returns the sum of an order's costs: `objective`. */
    [[nodiscard]] double total(std::span<const NodeIndex> order) const
    {
        return weightedLength(*this, order);
    }

    double sigmaSum = 0;
    std::vector<int> steps; ///< N values, at least 1; [0] is 0
    int last = 0;           ///< sum of the steps
    /**
     * By level: the least sigma that a set of icebergs leaves unseen; infinite if no set has that
     * level.
     */
    Eigen::ArrayXd leastUnseen;
};

} // namespace berg
