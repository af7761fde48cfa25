#include "core/plan/solve/graph_search.h"

#include <algorithm>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

namespace berg {

namespace {

constexpr std::size_t kStatesPerCheck = 128;
/** States and slots of a table between two looks at the clock. */
constexpr std::size_t kSlotsPerCheck = 32'768;
/** A table is cut down when it holds so many times what is to be kept of it. */
constexpr std::size_t kTableGrowth = 4;

struct State
{
    NodeSet visited;
    double length = 0;   ///< reduced length from the UAV
    double estimate = 0; ///< length + completion
    int node = 0;        ///< of the graph
    int parent = 0;      ///< in the layer before

    /** Ties by graph node, then by parent: the same states are kept everywhere. */
    friend bool operator<(const State& a, const State& b)
    {
        return std::tie(a.estimate, a.node, a.parent) < std::tie(b.estimate, b.node, b.parent);
    }
};

/** As `std::nth_element`, in pieces; of no use when cut. */
void selectLeast(std::span<State> states, std::size_t count, const CutQuestion& cut)
{
    while (states.size() > kSlotsPerCheck) {
        const State& first = states.front();
        const State& middle = states[states.size() / 2];
        const State& last = states.back();
        const State pivot =
            std::max(std::min(first, middle), std::min(std::max(first, middle), last));
        std::size_t below = 0;
        for (std::size_t k = 0; k < states.size(); ++k) {
            if (k % kSlotsPerCheck == 0 && cut && cut())
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
        if (below == 0) { // the pivot is the least one
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
    StateTable(const LayeredGraph<Costs>& graph, std::size_t most, const CutQuestion& cut)
        : m_graph(graph), m_limit(most), m_cut(cut), m_slots(1024, -1)
    {
    }
    /** Memory for each state to be kept, at most. */
    static constexpr std::int64_t kBytes = kTableGrowth * (sizeof(State) + 8 * sizeof(int));

    void offer(const State& state)
    {
        if (m_states.size() >= kTableGrowth * m_limit) {
            cutDown();
            enterAnew(m_slots.size());
        }
        if (2 * m_states.size() >= m_slots.size())
            enterAnew(2 * m_slots.size());
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

    /** Hands over the best states and empties the table. */
    [[nodiscard]] std::vector<State> take()
    {
        cutDown();
        std::fill(m_slots.begin(), m_slots.end(), -1);
        std::vector<State> taken(m_states.begin(), m_states.end());
        m_states.clear();
        return taken;
    }
    /** Least estimate of all states that were dropped. */
    [[nodiscard]] double dropped() const { return m_dropped; }

private:
    [[nodiscard]] std::size_t slotOf(const State& state) const
    {
        const auto last = static_cast<std::size_t>(m_graph.iceberg(state.node));
        return (state.visited.hash() + last * 0x9e3779b97f4a7c15U) & (m_slots.size() - 1);
    }
    void cutDown()
    {
        if (m_states.size() <= m_limit)
            return;
        selectLeast(m_states, m_limit, m_cut);
        m_dropped = std::min(m_dropped, m_states[m_limit].estimate);
        m_states.resize(m_limit);
    }
    /** Half done when cut, which does no harm: the search is cut as well. */
    void enterAnew(std::size_t slotCount)
    {
        m_slots.assign(slotCount, -1);
        for (std::size_t k = 0; k < m_states.size(); ++k) {
            if (k % kSlotsPerCheck == 0 && m_cut && m_cut())
                return;
            std::size_t slot = slotOf(m_states[k]);
            while (m_slots[slot] >= 0)
                slot = (slot + 1) & (m_slots.size() - 1);
            m_slots[slot] = static_cast<int>(k);
        }
    }

    const LayeredGraph<Costs>& m_graph;
    std::size_t m_limit;
    const CutQuestion& m_cut;
    std::vector<State> m_states;
    std::vector<int> m_slots;
    double m_dropped = std::numeric_limits<double>::infinity();
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

/** So many states of a layer that all layers and the table are within the memory, one at least. */
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
    StateTable<Costs> table(graph, statesFor<Costs>(limits, graph.icebergs()), limits.cut);
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
                                      costs.visit(j, p + 1) - multipliers.lambda(j);
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
    }
    if (limits.cut && limits.cut()) { // the last table may be half done
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
