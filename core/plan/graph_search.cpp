#include "core/plan/graph_search.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace berg {

namespace {

constexpr std::size_t kStatesPerCheck = 1024;

struct State
{
    NodeSet visited;
    double length = 0;   ///< reduced length from the UAV
    double estimate = 0; ///< length + completion
    int node = 0;        ///< of the graph
    int parent = 0;      ///< in the layer before
};

/** States of one layer by (visited, last iceberg): open addressing, grown by doubling. */
template <class Costs>
class StateTable
{
public:
    explicit StateTable(const LayeredGraph<Costs>& graph) : m_graph(graph), m_slots(1024, -1) {}

    void offer(const State& state)
    {
        if (2 * m_states.size() >= m_slots.size())
            grow();
        std::size_t slot = slotOf(state);
        for (; m_slots[slot] >= 0; slot = (slot + 1) & (m_slots.size() - 1)) {
            State& other = m_states[static_cast<std::size_t>(m_slots[slot])];
            if (other.visited == state.visited &&
                m_graph.iceberg(other.node) == m_graph.iceberg(state.node)) {
                // What the cheaper one's node does not lead to has been proven useless for it.
                if (state.length < other.length)
                    other = state;
                return;
            }
        }
        m_slots[slot] = static_cast<int>(m_states.size());
        m_states.push_back(state);
    }

    /** Hands over the states and empties the table. */
    [[nodiscard]] std::vector<State> take()
    {
        std::fill(m_slots.begin(), m_slots.end(), -1);
        return std::exchange(m_states, {});
    }

private:
    [[nodiscard]] std::size_t slotOf(const State& state) const
    {
        const auto last = static_cast<std::size_t>(m_graph.iceberg(state.node));
        return (state.visited.hash() + last * 0x9e3779b97f4a7c15U) & (m_slots.size() - 1);
    }
    void grow()
    {
        m_slots.assign(2 * m_slots.size(), -1);
        for (std::size_t k = 0; k < m_states.size(); ++k) {
            std::size_t slot = slotOf(m_states[k]);
            while (m_slots[slot] >= 0)
                slot = (slot + 1) & (m_slots.size() - 1);
            m_slots[slot] = static_cast<int>(k);
        }
    }

    const LayeredGraph<Costs>& m_graph;
    std::vector<State> m_states;
    std::vector<int> m_slots;
};

/** How often a leg counts that is flown when `visited` have been seen. */
template <class Costs>
double legWeight(const Costs& costs, const NodeSet& visited)
{
    double unseen = 1;
    if constexpr (Costs::kWeighted) {
        unseen = 0;
        for (int i = 1; i <= costs.icebergs; ++i)
            if (!visited.contains(i))
                unseen += costs.sigmaOf(i);
    }
    return unseen;
}

/** Keeps the `most` states of least estimate, returns the least estimate dropped. */
double truncate(std::vector<State>& states, int most)
{
    const auto size = static_cast<std::ptrdiff_t>(states.size());
    if (size <= most)
        return std::numeric_limits<double>::infinity();
    const auto end = states.begin() + most;
    // Ties by graph node, then by parent: the same states everywhere.
    std::nth_element(states.begin(), end, states.end(), [](const State& a, const State& b) {
        return std::tie(a.estimate, a.node, a.parent) < std::tie(b.estimate, b.node, b.parent);
    });
    const double dropped = end->estimate;
    states.erase(end, states.end());
    return dropped;
}

} // namespace

template <class Costs>
GraphSearchResult searchGraph(const LayeredGraph<Costs>& graph, const Prices& prices,
                              const GraphSearchLimits& limits)
{
    const Costs& costs = graph.costs();
    const double allowed = prices.allowedLength();
    GraphSearchResult result;
    double dropped = std::numeric_limits<double>::infinity();
    StateTable<Costs> table(graph);
    std::vector<std::vector<State>> layers(1);
    layers[0].push_back({.visited = {}, .estimate = graph.completion(0)});
    for (int p = 0; p < graph.icebergs(); ++p) {
        const std::vector<State>& from = layers.back();
        for (std::size_t k = 0; k < from.size(); ++k) {
            if (k % kStatesPerCheck == 0 && limits.cut && limits.cut()) {
                result.bound = -std::numeric_limits<double>::infinity();
                return result;
            }
            const int i = graph.iceberg(from[k].node);
            const double weight = legWeight(costs, from[k].visited);
            for (const int to : graph.successors(from[k].node)) {
                const int j = graph.iceberg(to);
                if (from[k].visited.contains(j))
                    continue;
                const double length = from[k].length + weight * costs.leg(i, j) +
                                      costs.visit(j, p + 1) - prices.lambda(j);
                const double estimate = length + graph.completion(to);
                if (estimate < allowed)
                    table.offer({.visited = from[k].visited.with(j),
                                 .length = length,
                                 .estimate = estimate,
                                 .node = to,
                                 .parent = static_cast<int>(k)});
            }
            result.work += static_cast<std::int64_t>(graph.successors(from[k].node).size());
        }
        layers.push_back(table.take());
        dropped = std::min(dropped, truncate(layers.back(), limits.mostStates));
    }

    const auto best =
        std::min_element(layers.back().begin(), layers.back().end(),
                         [](const State& a, const State& b) { return a.estimate < b.estimate; });
    result.bound = dropped + prices.sum;
    if (best == layers.back().end())
        return result;
    result.bound = std::min(result.bound, best->estimate + prices.sum);
    const State* state = &*best;
    for (int p = graph.icebergs(); p >= 1; --p) {
        result.order.push_back(graph.iceberg(state->node));
        state = &layers[static_cast<std::size_t>(p) - 1][static_cast<std::size_t>(state->parent)];
    }
    std::reverse(result.order.begin(), result.order.end());
    return result;
}

template GraphSearchResult searchGraph(const LayeredGraph<VisitCosts>&, const Prices&,
                                       const GraphSearchLimits&);
template GraphSearchResult searchGraph(const LayeredGraph<LatencyCosts>&, const Prices&,
                                       const GraphSearchLimits&);

} // namespace berg
