#include "core/plan/fleet/fleet_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace berg {

namespace {

/**
 * No more strings are removed once this many icebergs are out; the length of the longest string.
 */
constexpr std::size_t kEnoughOut = 16;
constexpr int kLongestString = 10;
/** Probability of skipping a position when an iceberg is inserted. */
constexpr double kBlink = 0.01;
/** Temperatures of the annealing, relative to the mean cost of an iceberg; measured. */
constexpr double kFirstHeat = 1;
constexpr double kLastHeat = 0.01;

std::vector<VisitOrder> nearestOf(const UavCosts& costs)
{
    std::vector<VisitOrder> near(static_cast<std::size_t>(costs.icebergs()) + 1);
    for (const NodeIndex i : icebergNodes(costs.icebergs())) {
        VisitOrder& others = near[toIndex(i)];
        others = ascendingOrder(costs.icebergs());
        const auto key = [&](NodeIndex j) {
            return std::pair(j == i ? -1.0 : costs.leg(i, j) + costs.leg(j, i), j);
        };
        std::sort(others.begin(), others.end(),
                  [&](NodeIndex a, NodeIndex b) { return key(a) < key(b); });
    }
    return near;
}

} // namespace

FleetSearch::FleetSearch(const FleetCosts& costs, SearchEffort& effort)
    : m_costs(costs), m_effort(effort), m_random(1), m_near(nearestOf(costs.of(0)))
{
}

std::int64_t FleetSearch::random(std::int64_t count)
{
    return static_cast<std::int64_t>(m_random.below(static_cast<std::uint64_t>(count)));
}

void FleetSearch::storeIfBetter(const FleetPlan& plan, double cost)
{
    constexpr double kBetter = 1 - 1e-12; // a smaller change may be rounding
    if (!m_best.empty() && cost >= m_bestCost * kBetter)
        return;
    m_best = plan;
    m_bestCost = cost;
    if (onImproved)
        onImproved(m_best);
}

void FleetSearch::accept(const FleetPlan& plan)
{
    storeIfBetter(plan, m_costs.total(plan));
}

void FleetSearch::complete(FleetPlan plan)
{
    std::vector<bool> there(static_cast<std::size_t>(m_costs.icebergs()) + 1, false);
    for (const VisitOrder& order : plan)
        for (const NodeIndex iceberg : order)
            there[toIndex(iceberg)] = true;
    VisitOrder icebergs;
    for (const NodeIndex i : icebergNodes(m_costs.icebergs()))
        if (!there[toIndex(i)])
            icebergs.push_back(i);
    std::stable_sort(icebergs.begin(), icebergs.end(), [&](NodeIndex a, NodeIndex b) {
        return m_costs.of(0).sigmaOf(a) > m_costs.of(0).sigmaOf(b);
    });
    for (const NodeIndex iceberg : icebergs)
        insert(plan, iceberg, false);
    accept(plan);
}

void FleetSearch::descend()
{
    FleetRoutes routes(m_costs, m_best);
    const int uavs = m_costs.uavs();
    // A pair of orders is examined again when one of them has changed since.
    std::vector<int> changed(static_cast<std::size_t>(uavs), 0);
    std::vector<int> examined(static_cast<std::size_t>(uavs) * static_cast<std::size_t>(uavs), -1);
    int time = 0;
    for (bool moved = true; moved;) {
        moved = false;
        for (int a = 0; a < uavs; ++a)
            for (int b = 0; b < uavs; ++b) {
                int& last = examined[static_cast<std::size_t>(a) * static_cast<std::size_t>(uavs) +
                                     static_cast<std::size_t>(b)];
                while (!m_effort.spent() && last < std::max(changed[static_cast<std::size_t>(a)],
                                                            changed[static_cast<std::size_t>(b)])) {
                    const FleetMove move = a == b ? bestMoveWithin(routes, a, m_effort)
                                                  : bestMoveBetween(routes, a, b, m_effort);
                    last = time;
                    if (move.partCount == 0 || !apply(routes, move))
                        break;
                    changed[static_cast<std::size_t>(a)] = ++time;
                    changed[static_cast<std::size_t>(b)] = time;
                    moved = true;
                }
            }
    }
    accept(routes.plan());
}

void FleetSearch::disturb(std::int64_t times)
{
    FleetPlan plan = m_best;
    double cost = m_bestCost;
    const double before = m_bestCost;
    const double first = kFirstHeat * cost / m_costs.icebergs();
    const double cooling = std::log(kLastHeat / kFirstHeat) / static_cast<double>(times);
    for (std::int64_t k = 0; k < times && !m_effort.spent(); ++k) {
        FleetPlan next = plan;
        VisitOrder out = removeStrings(next);
        shuffleForInsertion(out);
        for (const NodeIndex iceberg : out)
            insert(next, iceberg, true);
        const double nextCost = m_costs.total(next);
        m_effort.work += std::int64_t{4} * m_costs.icebergs();
        const double heat = first * std::exp(cooling * static_cast<double>(k));
        if (nextCost >= cost - heat * std::log(1 - m_random.uniform()))
            continue;
        plan = std::move(next);
        cost = nextCost;
        storeIfBetter(plan, cost);
    }
    if (m_bestCost < before)
        descend();
}

VisitOrder FleetSearch::removeStrings(FleetPlan& plan)
{
    const auto seed = static_cast<std::size_t>(1 + random(m_costs.icebergs()));
    const auto mostStrings = static_cast<std::int64_t>(m_costs.uavs());
    const auto strings = static_cast<std::size_t>(1 + random(mostStrings));
    std::vector<bool> ruined(plan.size(), false);
    VisitOrder out;
    std::size_t done = 0;
    for (const NodeIndex iceberg : m_near[seed]) {
        const auto order = std::find_if(plan.begin(), plan.end(), [&](const VisitOrder& other) {
            return std::find(other.begin(), other.end(), iceberg) != other.end();
        });
        if (order == plan.end() || ruined[static_cast<std::size_t>(order - plan.begin())])
            continue;
        ruined[static_cast<std::size_t>(order - plan.begin())] = true;
        removeString(*order, iceberg, out);
        if (++done == strings || out.size() >= kEnoughOut)
            break;
    }
    return out;
}

void FleetSearch::removeString(VisitOrder& order, NodeIndex iceberg, VisitOrder& out)
{
    const auto size = static_cast<std::int64_t>(order.size());
    const std::int64_t length = 1 + random(std::min<std::int64_t>(size, kLongestString));
    const std::int64_t place = std::find(order.begin(), order.end(), iceberg) - order.begin();
    const std::int64_t lowest = std::max<std::int64_t>(0, place - length + 1);
    const std::int64_t highest = std::min(place, size - length);
    const auto begin = order.begin() + lowest + random(highest - lowest + 1);
    out.insert(out.end(), begin, begin + length);
    order.erase(begin, begin + length);
}

void FleetSearch::shuffleForInsertion(VisitOrder& icebergs)
{
    for (std::size_t k = icebergs.size(); k > 1; --k)
        std::swap(icebergs[k - 1],
                  icebergs[static_cast<std::size_t>(random(static_cast<std::int64_t>(k)))]);
    if (random(2) == 0)
        std::stable_sort(icebergs.begin(), icebergs.end(), [&](NodeIndex a, NodeIndex b) {
            return m_costs.of(0).sigmaOf(a) > m_costs.of(0).sigmaOf(b);
        });
}

void FleetSearch::insert(FleetPlan& plan, NodeIndex iceberg, bool blink)
{
    Place best{.cost = std::numeric_limits<double>::infinity()};
    for (int uav = 0; uav < m_costs.uavs(); ++uav) {
        if (!m_costs.allows(uav, iceberg))
            continue;
        const VisitOrder& order = plan[static_cast<std::size_t>(uav)];
        m_effort.work += 3 * static_cast<std::int64_t>(order.size() + 1);
        if (m_costs.weighted())
            offerPlaces<true>(order, uav, iceberg, blink, best);
        else
            offerPlaces<false>(order, uav, iceberg, blink, best);
    }
    VisitOrder& order = plan[static_cast<std::size_t>(best.uav)];
    order.insert(order.begin() + best.index, iceberg);
}

template <bool kWeighted>
void FleetSearch::offerPlaces(const VisitOrder& order, int uav, NodeIndex iceberg, bool blink,
                              Place& best)
{
    const UavCosts& costs = m_costs.of(uav);
    double sigmaBehind = 0;
    double flown = 0; // length flown until `last`
    if constexpr (kWeighted)
        for (std::size_t k = 0; k < order.size(); ++k)
            flown += costs.leg(k > 0 ? order[k - 1] : NodeIndex(), order[k]);
    const double* const onwards = costs.legsFrom(iceberg);
    NodeIndex next;
    for (auto index = static_cast<std::ptrdiff_t>(order.size()); index >= 0; --index) {
        const NodeIndex last = index > 0 ? order[static_cast<std::size_t>(index - 1)] : NodeIndex();
        const double* const legs = costs.legsFrom(last);
        const double there = legs[iceberg.number()];
        const double detour = next == 0 ? there + costs.end(iceberg) - costs.end(last)
                                        : there + onwards[next.number()] - legs[next.number()];
        double cost = 0;
        if constexpr (kWeighted)
            cost = detour * sigmaBehind + (flown + there) * costs.sigmaOf(iceberg);
        else
            cost = detour + sigmaBehind + costs.visit(iceberg, static_cast<int>(index) + 1);
        const bool better = cost < best.cost;
        if (better && !(blink && best.uav != kNoUav && m_random.uniform() < kBlink))
            best = {.cost = cost, .uav = uav, .index = index};
        sigmaBehind += costs.sigmaOf(last);
        if constexpr (kWeighted)
            if (index > 0)
                flown -= costs.leg(
                    index > 1 ? order[static_cast<std::size_t>(index - 2)] : NodeIndex(), last);
        next = last;
    }
}

} // namespace berg
