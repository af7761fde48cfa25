#pragma once

#include "core/plan/solve/certified.h"
#include "core/plan/solve/order_costs.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

namespace berg {

/** Asked at least every 10 ms during long work; true ends it. May be empty. */
using CutQuestion = std::function<bool()>;

/**
 * Shortest paths by levels in the complete graph (any iceberg after any other one, no memory),
 * without building it. Any n.
 */
template <class Costs>
class LayeredPaths;
template <class Costs>
LayeredPaths(const Costs&) -> LayeredPaths<Costs>;

/** By positions, from the front: O(n^3) vector operations a sweep, O(n^2) memory. */
template <>
class LayeredPaths<VisitCosts>
{
public:
    explicit LayeredPaths(const VisitCosts& costs);

    /** As `LayeredGraph::sweep`; -infinity when cut. */
    double sweep(const Multipliers& multipliers, const CutQuestion& cut);
    /** Shortest path of the last sweep, which was not cut: icebergs by position. */
    [[nodiscard]] std::vector<int> shortestPath() const;
    /** Length from the UAV to `iceberg` (1 .. n) in `position`, its multiplier included. */
    [[nodiscard]] double length(int iceberg, int position) const
    {
        return m_lengths(iceberg - 1, position - 1);
    }
    /** Work of a sweep in arcs of a `LayeredGraph`. */
    [[nodiscard]] std::int64_t workOfSweep() const
    {
        const std::int64_t n = m_costs->icebergs;
        return n * n * n / 2;
    }

private:
    const VisitCosts* m_costs;
    Eigen::ArrayXXd m_legs;    ///< n x n, column = from; the diagonal is infinite
    Eigen::ArrayXXd m_lengths; ///< n x n, column = position
    int m_last = 0;            ///< iceberg the shortest path ends at
};

/** By sigma seen, from the back: O(n^2 levels) vector operations a sweep, O(n levels) memory. */
template <>
class LayeredPaths<LatencyCosts>
{
public:
    explicit LayeredPaths(const LatencyCosts& costs);

    /** As `LayeredGraph::sweep`; -infinity when cut. */
    double sweep(const Multipliers& multipliers, const CutQuestion& cut);
    /** Shortest path of the last sweep, which was not cut: icebergs in turn. */
    [[nodiscard]] std::vector<int> shortestPath() const;
    /** Length from `iceberg` (1 .. n) at `level` to the end, its own multiplier not included. */
    [[nodiscard]] double completion(int iceberg, int level) const
    {
        return m_completion(iceberg - 1, level);
    }
    /** Work of a sweep in arcs of a `LayeredGraph`. */
    [[nodiscard]] std::int64_t workOfSweep() const
    {
        const std::int64_t n = m_costs->icebergs;
        return n * n * m_costs->lastLevel() / 2;
    }

private:
    /** Length to the end by way of each iceberg next, its visit included; infinite beyond it. */
    [[nodiscard]] Eigen::ArrayXd onwards(int level) const;
    /** From each iceberg the shortest way on, whose legs count `weight` times. */
    [[nodiscard]] Eigen::ArrayXd leastOnwards(const Eigen::ArrayXd& after, double weight) const;

    const LatencyCosts* m_costs;
    Eigen::ArrayXXd m_legs;       ///< n x n, column = to; the diagonal is infinite
    Eigen::ArrayXXd m_completion; ///< n x (levels + 1), column = level
    Eigen::VectorXd m_lambda;     ///< of the last sweep
};

} // namespace berg
