#pragma once

#include "core/plan/problem/order_costs.h"
#include "core/plan/proof/certified.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

namespace berg {

/**
 * Called at least every 10 ms during long work; returns true once the work must stop. May be empty.
 */
using StopCheck = std::function<bool()>;

/**
 * Shortest paths by levels in the complete graph (any iceberg after any other one, no memory),
 * which is not built. Any number of icebergs.
 */
template <class Costs>
class LayeredPaths;
template <class Costs>
LayeredPaths(const Costs&) -> LayeredPaths<Costs>;

/** Paths by positions, from the front: O(n^3) vector operations per sweep, O(n^2) memory. */
template <>
class LayeredPaths<VisitCosts>
{
public:
    explicit LayeredPaths(const VisitCosts& costs);

    /**
     * Finds all shortest lengths and returns the lower bound as `LayeredGraph::sweep` does;
     * -infinity if stopped.
     */
    double sweep(const Multipliers& multipliers, const StopCheck& isStopped);
    /**
     * Returns the shortest path of the last sweep, which must not have been stopped: icebergs by
     * position.
     */
    [[nodiscard]] VisitOrder shortestPath() const;
    /**
     * Returns the length from the UAV to `iceberg` (1 .. n) at `position`, its multiplier included.
     */
    [[nodiscard]] double length(NodeIndex iceberg, int position) const
    {
        return m_lengths(iceberg.number() - 1, position - 1);
    }
    /** Returns the work of a sweep, in arcs of a `LayeredGraph`. */
    [[nodiscard]] std::int64_t workOfSweep() const
    {
        const std::int64_t n = m_costs->icebergs;
        return n * n * n / 2;
    }

private:
    const VisitCosts* m_costs;
    Eigen::ArrayXXd m_legs;    ///< n x n, column = from; the diagonal is infinite
    Eigen::ArrayXXd m_lengths; ///< n x n, column = position
    NodeIndex m_last;          ///< last iceberg of the shortest path
};

/**
 * Paths by sigma seen, from the back: O(n^2 levels) vector operations per sweep, O(n levels)
 * memory.
 */
template <>
class LayeredPaths<LatencyCosts>
{
public:
    explicit LayeredPaths(const LatencyCosts& costs);

    /**
     * Finds all shortest lengths and returns the lower bound as `LayeredGraph::sweep` does;
     * -infinity if stopped.
     */
    double sweep(const Multipliers& multipliers, const StopCheck& isStopped);
    /**
     * Returns the shortest path of the last sweep, which must not have been stopped: icebergs in
     * order.
     */
    [[nodiscard]] VisitOrder shortestPath() const;
    /**
     * Returns the length from `iceberg` (1 .. n) at `level` to the end, its own multiplier not
     * included.
     */
    [[nodiscard]] double completion(NodeIndex iceberg, int level) const
    {
        return m_completion(iceberg.number() - 1, level);
    }
    /** Returns the work of a sweep, in arcs of a `LayeredGraph`. */
    [[nodiscard]] std::int64_t workOfSweep() const
    {
        const std::int64_t n = m_costs->icebergs;
        return n * n * m_costs->lastLevel() / 2;
    }

private:
    /**
     * Returns the length to the end through each iceberg next, its visit included; infinity if that
     * exceeds the last level.
     */
    [[nodiscard]] Eigen::ArrayXd onwards(int level) const;
    /**
     * Returns from each iceberg the length of the shortest continuation, whose legs count `weight`
     * times.
     */
    [[nodiscard]] Eigen::ArrayXd leastOnwards(const Eigen::ArrayXd& after, double weight) const;

    const LatencyCosts* m_costs;
    Eigen::ArrayXXd m_legs;       ///< n x n, column = to; the diagonal is infinite
    Eigen::ArrayXXd m_completion; ///< n x (levels + 1), column = level
    Eigen::VectorXd m_lambda;     ///< multipliers of the last sweep
};

} // namespace berg
