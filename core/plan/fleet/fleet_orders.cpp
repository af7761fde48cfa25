#include "core/plan/fleet/fleet_orders.h"

#include <algorithm>

namespace berg {

namespace {

/** States between two checks for a stop. */
constexpr std::size_t kStatesPerCheck = 64;

} // namespace

bool FleetOrders::add(const FleetGraph& graph, const Eigen::VectorXd& lambda, double slack,
                      std::size_t mostStates, const StopCheck& isStopped)
{
    for (int root = 0; root < graph.rootCount(); ++root) {
        const int uav = graph.uavs()[static_cast<std::size_t>(root)];
        if (-graph.shortest(root) < slack)
            m_orders.push_back({.uav = uav, .visited = {}, .excess = -graph.shortest(root)});
        if (!addPaths(graph, root, lambda, slack, mostStates, isStopped))
            return false;
    }
    return true;
}

bool FleetOrders::addPaths(const FleetGraph& graph, int root, const Eigen::VectorXd& lambda,
                           double slack, std::size_t mostStates, const StopCheck& isStopped)
{
    const int uav = graph.uavs()[static_cast<std::size_t>(root)];
    NumberTable next;
    std::size_t begin = m_states.size();
    m_states.push_back({.node = root, .length = -graph.shortest(root)});
    for (int layer = 1; begin < m_states.size(); ++layer) {
        const std::size_t end = m_states.size();
        next.clear();
        for (std::size_t k = begin; k < end; ++k) {
            if (k % kStatesPerCheck == 0 && isStopped && isStopped())
                return false;
            const State from = m_states[k];
            for (const int to : graph.successors(from.node)) {
                const double there = from.length + graph.leg(from.node, to);
                const NodeIndex iceberg = graph.iceberg(to);
                if (from.visited.contains(iceberg) || there + graph.entry(to) >= slack)
                    continue;
                offer({.node = to,
                       .iceberg = iceberg,
                       .visited = from.visited.with(iceberg),
                       .length = there + graph.visit(to, layer, lambda),
                       .before = static_cast<int>(k)},
                      next);
            }
            if (m_states.size() > mostStates)
                return false;
        }
        if (!addOrders(graph, uav, end, slack, isStopped))
            return false;
        begin = end;
    }
    return true;
}

void FleetOrders::offer(const State& state, NumberTable& states)
{
    const auto at = [this](int number) -> State& {
        return m_states[static_cast<std::size_t>(number)];
    };
    const std::size_t last = toIndex(state.iceberg) * 0x9e3779b97f4a7c15U;
    int& number = states.entry(state.visited.hash() + last, [&](int other) {
        return at(other).iceberg == state.iceberg && at(other).visited == state.visited;
    });
    if (number == NumberTable::kNoNumber) {
        number = static_cast<int>(m_states.size());
        m_states.push_back(state);
    } else if (state.length < at(number).length) {
        at(number) = state;
    }
}

bool FleetOrders::addOrders(const FleetGraph& graph, int uav, std::size_t begin, double slack,
                            const StopCheck& isStopped)
{
    NumberTable best;
    for (std::size_t k = begin; k < m_states.size(); ++k) {
        if (k % (64 * kStatesPerCheck) == 0 && isStopped && isStopped())
            return false;
        const State& state = m_states[k];
        const Order order{.uav = uav,
                          .visited = state.visited,
                          .excess = state.length + graph.ending(state.node),
                          .state = static_cast<int>(k)};
        if (order.excess >= slack)
            continue;
        int& number = best.entry(order.visited.hash(), [&](int other) {
            return m_orders[static_cast<std::size_t>(other)].visited == order.visited;
        });
        if (number == NumberTable::kNoNumber) {
            number = static_cast<int>(m_orders.size());
            m_orders.push_back(order);
        } else if (order.excess < m_orders[static_cast<std::size_t>(number)].excess) {
            m_orders[static_cast<std::size_t>(number)] = order;
        }
    }
    return true;
}

VisitOrder FleetOrders::icebergsOf(const Order& order) const
{
    VisitOrder icebergs;
    for (int state = order.state; state != kNoState;) {
        const State& here = m_states[static_cast<std::size_t>(state)];
        if (here.before != kNoState)
            icebergs.push_back(here.iceberg);
        state = here.before;
    }
    std::reverse(icebergs.begin(), icebergs.end());
    return icebergs;
}

} // namespace berg
