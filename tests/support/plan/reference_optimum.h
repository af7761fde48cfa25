#pragma once

#include "core/plan/fleet/fleet_problem.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

namespace berg::test {

/** Least cost by subsets, and an order with this cost. Cost is objective + `objectiveShift`. */
struct ReferenceOptimum
{
    long double cost = 0;
    VisitOrder order;
};

/**
 * Dynamic programming over subsets with 64 bits of mantissa, deliberately different from
 * `SubsetSolver`: from the start, and with the costs of Eq. (1) by position. For a dozen icebergs.
 */
class ReferenceTable
{
public:
    using Set = std::uint32_t; ///< bit i - 1 is iceberg i
    static constexpr long double kInfinity = std::numeric_limits<long double>::infinity();

    /**
     * Latency as in `FleetProblem`, where a leg weighs the icebergs still ahead: a set has the cost
     * that it has as the whole order.
     */
    explicit ReferenceTable(const TvpProblem& problem)
        : m_problem(problem)
        , m_n(problem.icebergCount())
        , m_backwards(problem.criterion == Criterion::Latency)
        , m_least((std::size_t{1} << m_n) * static_cast<std::size_t>(m_n), kInfinity)
    {
        for (Set set = 1; set < Set{1} << m_n; ++set)
            for (int i = 1; i <= m_n; ++i)
                if ((set & bit(i)) != 0)
                    least(set, i) = cheapest(set, i).cost;
    }

    /** Returns the optimum of all orders of exactly these icebergs. */
    [[nodiscard]] ReferenceOptimum optimum(Set set) const
    {
        ReferenceOptimum best;
        if (set == 0)
            return best;
        int at = 0;
        best.cost = kInfinity;
        for (int i = 1; i <= m_n; ++i)
            if ((set & bit(i)) != 0 && least(set, i) + end(set, i) < best.cost) {
                best.cost = least(set, i) + end(set, i);
                at = i;
            }
        while (at != 0) {
            best.order.push_back(NodeIndex::of(at));
            const int next = cheapest(set, at).neighbour;
            set &= ~bit(at);
            at = next;
        }
        if (!m_backwards)
            std::reverse(best.order.begin(), best.order.end());
        return best;
    }
    [[nodiscard]] Set all() const { return (Set{1} << m_n) - 1; }

private:
    struct Step
    {
        long double cost = kInfinity;
        int neighbour = 0;
    };

    [[nodiscard]] static Set bit(int iceberg) { return Set{1} << (iceberg - 1); }
    [[nodiscard]] long double leg(int from, int to) const
    {
        return static_cast<long double>(m_problem.mu) * m_problem.distance_m(from, to);
    }
    [[nodiscard]] long double sigma(int i) const
    {
        return m_problem.sigma_m2[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] long double sigmaOf(Set set) const
    {
        long double sum = 0;
        for (int i = 1; i <= m_n; ++i)
            sum += (set & bit(i)) != 0 ? sigma(i) : 0;
        return sum;
    }
    /**
     * Visitation: the set is visited and `i` is its last iceberg. Latency: the set is still to
     * visit and `i` is its first iceberg; the leg to `i` is not included yet.
     */
    [[nodiscard]] Step cheapest(Set set, int i) const
    {
        const Set rest = set & ~bit(i);
        const long double visit =
            m_backwards ? 0 : sigma(i) * static_cast<long double>(std::popcount(set) + 1);
        if (rest == 0)
            return {m_backwards ? 0 : leg(0, i) + visit, 0};
        const long double unseen = m_backwards ? sigmaOf(rest) : 0;
        Step best;
        for (int j = 1; j <= m_n; ++j) {
            if ((rest & bit(j)) == 0)
                continue;
            const long double cost =
                least(rest, j) + (m_backwards ? unseen * leg(i, j) : leg(j, i) + visit);
            if (cost < best.cost)
                best = {cost, j};
        }
        return best;
    }
    /** Returns the cost of the outer end of an order of the set. */
    [[nodiscard]] long double end(Set set, int i) const
    {
        if (m_backwards)
            return sigmaOf(set) * leg(0, i);
        return m_problem.route == Route::Closed ? leg(i, 0) : 0;
    }
    [[nodiscard]] std::size_t index(Set set, int i) const
    {
        return std::size_t{set} * static_cast<std::size_t>(m_n) + static_cast<std::size_t>(i - 1);
    }
    [[nodiscard]] long double& least(Set set, int i) { return m_least[index(set, i)]; }
    [[nodiscard]] long double least(Set set, int i) const { return m_least[index(set, i)]; }

    const TvpProblem& m_problem;
    int m_n;
    bool m_backwards;
    std::vector<long double> m_least;
};

[[nodiscard]] inline ReferenceOptimum referenceOptimum(const TvpProblem& problem)
{
    const ReferenceTable table(problem);
    return table.optimum(table.all());
}

/** Returns the least cost of all plans: objective + `objectiveShift`. */
[[nodiscard]] inline long double referenceFleetCost(const FleetProblem& problem)
{
    using Set = ReferenceTable::Set;
    std::vector<long double> best{0};
    best.resize(std::size_t{1} << problem.icebergCount(), ReferenceTable::kInfinity);
    for (int uav = 0; uav < problem.uavCount(); ++uav) {
        Set allowed = 0;
        for (const NodeIndex i : icebergNodes(problem.icebergCount()))
            allowed |= problem.allows(uav, i) ? Set{1} << (i.number() - 1) : 0;
        const TvpProblem own = problemOfUav(problem, uav);
        const ReferenceTable table(own);
        std::vector<long double> alone(best.size(), ReferenceTable::kInfinity);
        for (Set set = 0; set < alone.size(); ++set)
            if ((set & ~allowed) == 0)
                alone[set] = table.optimum(set).cost;
        std::vector<long double> next(best.size(), ReferenceTable::kInfinity);
        for (Set set = 0; set < next.size(); ++set)
            for (Set part = set;; part = (part - 1) & set) {
                next[set] = std::min(next[set], best[set & ~part] + alone[part]);
                if (part == 0)
                    break;
            }
        best = std::move(next);
    }
    return best.back();
}

} // namespace berg::test
