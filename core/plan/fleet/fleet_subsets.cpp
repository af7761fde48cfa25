#include "core/plan/fleet/fleet_subsets.h"

#include "core/base/error.h"

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace berg {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Set = std::uint32_t; ///< bit i - 1 is iceberg i

NodeIndex firstOf(Set set)
{
    return NodeIndex::of(std::countr_zero(set) + 1);
}
Set without(Set set, NodeIndex iceberg)
{
    return set & ~(Set{1} << (iceberg.number() - 1));
}

/**
 * Orders of one UAV. Every leg is charged for the sigma still ahead of it in the order, and the
 * first one once more: this sums to sigma t and makes the cost of the rest independent of the
 * position. For latency that sigma is the leg's weight.
 */
class SubsetOrders
{
public:
    /** Considers the icebergs in `among` only. */
    SubsetOrders(const FleetCosts& costs, int uav, Set among)
        : m_costs(costs.of(uav))
        , m_weighted(costs.weighted())
        , m_n(costs.icebergs())
        , m_sigma(std::size_t{1} << m_n, 0.0)
        , m_onwards(m_sigma.size() * static_cast<std::size_t>(m_n), kInfinity)
    {
        for (const NodeIndex i : icebergNodes(m_n))
            if (costs.allows(uav, i))
                m_allowed |= Set{1} << (i.number() - 1);
        m_allowed &= among;
    }

    [[nodiscard]] bool compute(const std::function<bool()>& isStopped)
    {
        int examined = 0;
        for (Set set = 0;; set = (set - m_allowed) & m_allowed) { // the next subset
            if (examined++ % 256 == 0 && isStopped && isStopped())
                return false;
            if (set != 0)
                m_sigma[set] = m_sigma[without(set, firstOf(set))] + m_costs.sigmaOf(firstOf(set));
            for (const NodeIndex i : icebergNodes(m_n))
                if (without(set, i) == set)
                    onwards(set, i) = set == 0 ? m_costs.leg(i, 0) : cheapest(set, i).cost;
            if (set == m_allowed)
                return true;
        }
    }

    /** Returns the least cost of all orders of the set; infinity if the UAV may not visit it. */
    [[nodiscard]] double cost(Set set) const
    {
        if ((set & ~m_allowed) != 0)
            return kInfinity;
        return set == 0 ? 0.0 : cheapest(set, 0).cost + (m_weighted ? 0.0 : m_sigma[set]);
    }
    [[nodiscard]] VisitOrder order(Set set) const
    {
        VisitOrder order;
        for (NodeIndex at; set != 0; set = without(set, at)) {
            at = cheapest(set, at).next;
            order.push_back(at);
        }
        return order;
    }

private:
    struct Step
    {
        double cost = kInfinity;
        NodeIndex next;
    };

    [[nodiscard]] Step cheapest(Set set, NodeIndex from) const
    {
        Step step;
        for (Set left = set; left != 0; left &= left - 1) {
            const NodeIndex i = firstOf(left);
            const double leg = m_costs.leg(from, i);
            const double cost = (m_weighted ? leg * m_sigma[set] : leg + m_sigma[set]) +
                                m_onwards[index(without(set, i), i)];
            if (cost < step.cost)
                step = {cost, i};
        }
        return step;
    }
    [[nodiscard]] std::size_t index(Set set, NodeIndex at) const
    {
        return std::size_t{set} * static_cast<std::size_t>(m_n) + toIndex(at) - 1;
    }
    [[nodiscard]] double& onwards(Set set, NodeIndex at) { return m_onwards[index(set, at)]; }

    const UavCosts& m_costs;
    bool m_weighted;
    int m_n;
    Set m_allowed = 0;
    std::vector<double> m_sigma;   ///< by set
    std::vector<double> m_onwards; ///< by set still to be visited and iceberg before it
};

/** Icebergs of a set that the last UAV visits, while the UAVs before it visit the rest. */
struct Share
{
    double cost = kInfinity;
    Set last = 0;
};

Share bestShare(const std::vector<double>& before, const std::vector<double>& last, Set set)
{
    Share share;
    for (Set part = set;; part = (part - 1) & set) {
        const double cost = last[part] + before[set & ~part];
        if (cost < share.cost)
            share = {cost, part};
        if (part == 0)
            return share;
    }
}

} // namespace

std::optional<FleetPlan> bestFleetPlan(const FleetCosts& costs,
                                       const std::function<bool()>& isStopped)
{
    const int n = costs.icebergs();
    require(n <= kMostFleetSubsets, "bestFleetPlan: too many icebergs");
    const Set all = (Set{1} << n) - 1;
    const auto uavs = static_cast<std::size_t>(costs.uavs());
    std::vector<std::vector<double>> alone(uavs);
    std::vector<std::vector<double>> first(uavs); ///< cost of a set for the UAVs up to this one
    for (std::size_t uav = 0; uav < uavs; ++uav) {
        SubsetOrders orders(costs, static_cast<int>(uav), all);
        if (!orders.compute(isStopped))
            return std::nullopt;
        alone[uav].resize(std::size_t{all} + 1);
        for (Set set = 0; set <= all; ++set)
            alone[uav][set] = orders.cost(set);
        first[uav] = alone[uav];
        for (Set set = 0; uav > 0 && set <= all; ++set) {
            if (set % 64 == 0 && isStopped && isStopped())
                return std::nullopt;
            first[uav][set] = bestShare(first[uav - 1], alone[uav], set).cost;
        }
    }
    FleetPlan plan(uavs);
    Set left = all;
    for (std::size_t uav = uavs; uav-- > 0;) {
        const Set part = uav == 0 ? left : bestShare(first[uav - 1], alone[uav], left).last;
        left &= ~part;
        if (part == 0)
            continue;
        // The orders are computed again: the tables of all UAVs would need most of the memory.
        SubsetOrders orders(costs, static_cast<int>(uav), part);
        if (!orders.compute(isStopped))
            return std::nullopt;
        plan[uav] = orders.order(part);
    }
    return plan;
}

std::int64_t fleetSubsetWork(int uavs, int icebergs)
{
    const double perUav = std::ldexp(icebergs * icebergs / 2.0, icebergs) + std::pow(3.0, icebergs);
    return static_cast<std::int64_t>(uavs * perUav);
}

std::int64_t fleetSubsetBytes(int uavs, int icebergs)
{
    return (std::int64_t{sizeof(double)} * (2 * uavs + icebergs + 1)) << icebergs;
}

} // namespace berg
