#include "core/plan/proof/graph_search.h"

#include <algorithm>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

namespace berg {

namespace {

constexpr std::size_t kStatesPerCheck = 128;
/** States and slots of a table between two checks for a stop. */
constexpr std::size_t kSlotsPerCheck = 32'768;
/** A table is pruned when it holds this many times the states to be kept. */
constexpr std::size_t kTableGrowth = 4;

struct State
{
    NodeSet visited;
    double length = 0;   ///< reduced length from the UAV
    double estimate = 0; ///< length + completion
    int node = 0;        ///< node of the graph
    int parent = 0;      ///< index in the previous layer

    /**
     * Breaks ties by graph node, then by parent, so that the same states are kept on every machine.
     */
    friend bool operator<(const State& a, const State& b)
    {
        return std::tie(a.estimate, a.node, a.parent) < std::tie(b.estimate, b.node, b.parent);
    }
};

/** Partitions like `std::nth_element`, in pieces; the result is unusable if stopped. */
void selectLeast(std::span<State> states, std::size_t count, const StopCheck& isStopped)
{
    while (states.size() > kSlotsPerCheck) {
        const State& first = states.front();
        const State& middle = states[states.size() / 2];
        const State& last = states.back();
        const State pivot =
            std::max(std::min(first, middle), std::min(std::max(first, middle), last));
        std::size_t below = 0;
        for (std::size_t k = 0; k < states.size(); ++k) {
            if (k % kSlotsPerCheck == 0 && isStopped && isStopped())
                return;
            if (states[k] < pivot)
                std::swap(states[k], states[below++]);
        }
        if (count < below) {
            states = states.first(below);
        } else {
            states = states.subspan(below);
            count -= below;
        }
        if (below == 0) { // the pivot is the least state
            std::iter_swap(states.begin(), std::min_element(states.begin(), states.end()));
            states = states.subspan(1);
            if (count == 0)
                return;
            --count;
        }
    }
    if (count < states.size())
        std::nth_element(states.begin(), states.begin() + static_cast<std::ptrdiff_t>(count),
                         states.end());
}

/** The best states of one layer by (visited, last iceberg): open addressing, grown by doubling. */
template <class Costs>
class StateTable
{
public:
    StateTable(const LayeredGraph<Costs>& graph, std::size_t most, const StopCheck& isStopped)
        : m_graph(graph), m_limit(most), m_isStopped(isStopped), m_slots(1024, kFree)
    {
    }
    /** Largest memory for each state to be kept. */
    static constexpr std::int64_t kBytes = kTableGrowth * (sizeof(State) + 8 * sizeof(int));

    void offer(const State& state)
    {
        if (m_states.size() >= kTableGrowth * m_limit) {
            prune();
            rebuildSlots(m_slots.size());
        }
        if (2 * m_states.size() >= m_slots.size())
            rebuildSlots(2 * m_slots.size());
        std::size_t slot = slotOf(state);
        for (; m_slots[slot] != kFree; slot = (slot + 1) & (m_slots.size() - 1)) {
            State& other = m_states[static_cast<std::size_t>(m_slots[slot])];
            if (other.visited == state.visited &&
                m_graph.iceberg(other.node) == m_graph.iceberg(state.node)) {
                // Successors that the cheaper state's node lacks have been proven useless for it.
                if (state.length < other.length)
                    other = state;
                return;
            }
        }
        m_slots[slot] = static_cast<int>(m_states.size());
        m_states.push_back(state);
    }

    /** Returns the best states and empties the table. */
    [[nodiscard]] std::vector<State> release()
    {
        prune();
        std::fill(m_slots.begin(), m_slots.end(), kFree);
        std::vector<State> taken(m_states.begin(), m_states.end());
        m_states.clear();
        return taken;
    }
    /** Returns the least estimate of all states that were dropped. */
    [[nodiscard]] double dropped() const { return m_dropped; }

private:
    static constexpr int kFree = -1; ///< slot without a state

    [[nodiscard]] std::size_t slotOf(const State& state) const
    {
        const std::size_t last = toIndex(m_graph.iceberg(state.node));
        return (state.visited.hash() + last * 0x9e3779b97f4a7c15U) & (m_slots.size() - 1);
    }
    void prune()
    {
        if (m_states.size() <= m_limit)
            return;
        selectLeast(m_states, m_limit, m_isStopped);
        m_dropped = std::min(m_dropped, m_states[m_limit].estimate);
        m_states.resize(m_limit);
    }
    /** Rebuilds the slots. It may stop halfway, which does no harm: the search stops as well. */
    void rebuildSlots(std::size_t slotCount)
    {
        m_slots.assign(slotCount, kFree);
        for (std::size_t k = 0; k < m_states.size(); ++k) {
            if (k % kSlotsPerCheck == 0 && m_isStopped && m_isStopped())
                return;
            std::size_t slot = slotOf(m_states[k]);
            while (m_slots[slot] != kFree)
                slot = (slot + 1) & (m_slots.size() - 1);
            m_slots[slot] = static_cast<int>(k);
        }
    }

    const LayeredGraph<Costs>& m_graph;
    std::size_t m_limit;
    const StopCheck& m_isStopped;
    std::vector<State> m_states;
    std::vector<int> m_slots;
    double m_dropped = std::numeric_limits<double>::infinity();
};

/** Returns the factor of a leg that is flown when `visited` have been seen. */
template <class Costs>
double legWeight(const Costs& costs, const NodeSet& visited)
{
    double unseen = 1;
    if constexpr (Costs::kWeighted) {
        unseen = 0;
        for (const NodeIndex i : icebergNodes(costs.icebergs))
            if (!visited.contains(i))
                unseen += costs.sigmaOf(i);
    }
    return unseen;
}

/**
 * Returns the number of states of a layer with which all layers and the table fit the memory limit,
 * at least one.
 */
template <class Costs>
std::size_t statesFor(const GraphSearchLimits& limits, int icebergs)
{
    const std::int64_t bytes =
        std::int64_t{sizeof(State)} * (icebergs + 1) + StateTable<Costs>::kBytes;
    return static_cast<std::size_t>(std::max<std::int64_t>(
        1, std::min<std::int64_t>(limits.memory_bytes / bytes, limits.mostStates)));
}

} // namespace

template <class Costs>
GraphSearchResult searchGraph(const LayeredGraph<Costs>& graph, const Multipliers& multipliers,
                              const GraphSearchLimits& limits)
{
    const Costs& costs = graph.costs();
    const double allowed = multipliers.allowedLength();
    GraphSearchResult result;
    StateTable<Costs> table(graph, statesFor<Costs>(limits, graph.icebergs()), limits.isStopped);
    std::vector<std::vector<State>> layers(1);
    layers[0].push_back({.visited = {}, .estimate = graph.completion(0)});
    for (int p = 0; p < graph.icebergs(); ++p) {
        const std::vector<State>& from = layers.back();
        for (std::size_t k = 0; k < from.size(); ++k) {
            if (k % kStatesPerCheck == 0 && limits.isStopped && limits.isStopped()) {
                result.bound = -std::numeric_limits<double>::infinity();
                return result;
            }
            const NodeIndex i = graph.iceberg(from[k].node);
            const double weight = legWeight(costs, from[k].visited);
            for (const int to : graph.successors(from[k].node)) {
                const NodeIndex j = graph.iceberg(to);
                if (from[k].visited.contains(j))
                    continue;
                const double length = from[k].length + weight * costs.leg(i, j) +
                                      costs.visit(j, p + 1) - multipliers.lambda(j.number());
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
        layers.push_back(table.release());
    }
    if (limits.isStopped && limits.isStopped()) { // the last table may be incomplete
        result.bound = -std::numeric_limits<double>::infinity();
        return result;
    }
    const double dropped = table.dropped();

    const auto best =
        std::min_element(layers.back().begin(), layers.back().end(),
                         [](const State& a, const State& b) { return a.estimate < b.estimate; });
    result.bound = dropped + multipliers.sum;
    if (best == layers.back().end())
        return result;
    result.bound = std::min(result.bound, best->estimate + multipliers.sum);
    const State* state = &*best;
    for (int p = graph.icebergs(); p >= 1; --p) {
        result.order.push_back(graph.iceberg(state->node));
        state = &layers[static_cast<std::size_t>(p) - 1][static_cast<std::size_t>(state->parent)];
    }
    std::reverse(result.order.begin(), result.order.end());
    return result;
}

template GraphSearchResult searchGraph(const LayeredGraph<VisitCosts>&, const Multipliers&,
                                       const GraphSearchLimits&);
template GraphSearchResult searchGraph(const LayeredGraph<LatencyCosts>&, const Multipliers&,
                                       const GraphSearchLimits&);

} // namespace berg
