#include "core/plan/layered_graph.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

namespace berg {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/** Nodes of a refined graph made between two looks at the clock. */
constexpr int kNodesPerCheck = 4096;

/** The (old node, memory) pairs of one layer: open addressing, grown by doubling. */
class LabelTable
{
public:
    struct Label
    {
        NodeSet memory;
        double length = kInfinity;
        int node = 0;
    };

    LabelTable() : m_slots(256, -1) {}
    [[nodiscard]] const std::vector<Label>& labels() const { return m_labels; }
    /** Number of the label, which becomes as long as `length` at most. */
    int offer(const Label& label)
    {
        if (4 * m_labels.size() >= m_slots.size())
            resize(2 * m_slots.size());
        std::size_t slot = slotOf(label);
        for (; m_slots[slot] >= 0; slot = (slot + 1) & (m_slots.size() - 1)) {
            Label& other = m_labels[static_cast<std::size_t>(m_slots[slot])];
            if (other.node == label.node && other.memory == label.memory) {
                other.length = std::min(other.length, label.length);
                return m_slots[slot];
            }
        }
        m_slots[slot] = static_cast<int>(m_labels.size());
        m_labels.push_back(label);
        return m_slots[slot];
    }
    void clear()
    {
        m_labels.clear();
        resize(m_slots.size());
    }

private:
    [[nodiscard]] std::size_t slotOf(const Label& label) const
    {
        const auto node = static_cast<std::size_t>(label.node);
        const std::size_t mixed = label.memory.hash() + node * 0x9e3779b97f4a7c15U;
        return (mixed ^ (mixed >> 32)) & (m_slots.size() - 1);
    }
    void resize(std::size_t slots)
    {
        m_slots.assign(slots, -1);
        for (std::size_t k = 0; k < m_labels.size(); ++k) {
            std::size_t slot = slotOf(m_labels[k]);
            while (m_slots[slot] >= 0)
                slot = (slot + 1) & (slots - 1);
            m_slots[slot] = static_cast<int>(k);
        }
    }

    std::vector<Label> m_labels;
    std::vector<int> m_slots; ///< a power of two
};

} // namespace

int NodeSet::size() const
{
    return std::popcount(words[0]) + std::popcount(words[1]);
}

std::size_t NodeSet::hash() const
{
    // Odd 64-bit constants of splitmix64; the upper bits mix best.
    const std::uint64_t mixed = words[0] * 0xbf58476d1ce4e5b9U + words[1] * 0x94d049bb133111ebU;
    return static_cast<std::size_t>(mixed ^ (mixed >> 29));
}

LayeredPaths::LayeredPaths(const VisitCosts& costs)
    : m_costs(&costs)
    , m_legs(costs.legs.bottomRightCorner(costs.icebergs, costs.icebergs).array())
    , m_lengths(costs.icebergs, costs.icebergs)
{
    m_legs.matrix().diagonal().setConstant(kInfinity);
}

double LayeredPaths::sweep(const Prices& prices, const CutQuestion& cut)
{
    const Eigen::Index n = m_costs->icebergs;
    const Eigen::ArrayXd sigma = Eigen::Map<const Eigen::ArrayXd>(m_costs->sigma.data() + 1, n);
    const Eigen::ArrayXd lambda = prices.lambda.tail(n).array();
    m_lengths.col(0) = m_costs->legs.col(0).tail(n).array() + 2 * sigma - lambda;
    Eigen::ArrayXd least(n);
    for (Eigen::Index p = 1; p < n; ++p) {
        if (cut && cut())
            return -kInfinity;
        least.setConstant(kInfinity);
        Eigen::Index i = 0;
        for (; i + 3 < n; i += 4) // four at once: `least` is read and written once
            least = least
                        .min((m_legs.col(i) + m_lengths(i, p - 1))
                                 .min(m_legs.col(i + 1) + m_lengths(i + 1, p - 1)))
                        .min((m_legs.col(i + 2) + m_lengths(i + 2, p - 1))
                                 .min(m_legs.col(i + 3) + m_lengths(i + 3, p - 1)));
        for (; i < n; ++i)
            least = least.min(m_legs.col(i) + m_lengths(i, p - 1));
        m_lengths.col(p) = least + static_cast<double>(p + 2) * sigma - lambda;
    }
    Eigen::Index last = 0;
    const Eigen::ArrayXd wayBack = m_costs->legs.row(0).tail(n).transpose().array();
    const double length = (m_lengths.col(n - 1) + wayBack).minCoeff(&last);
    m_last = static_cast<int>(last) + 1;
    return prices.sum + length;
}

std::vector<int> LayeredPaths::shortestPath() const
{
    std::vector<int> path(static_cast<std::size_t>(m_costs->icebergs));
    path.back() = m_last;
    for (int p = m_costs->icebergs - 1; p >= 1; --p) {
        Eigen::Index before = 0;
        const int to = path[static_cast<std::size_t>(p)];
        // Only the least one matters: what the step adds to it is the same for all.
        (m_lengths.col(p - 1) + m_legs.row(to - 1).transpose()).minCoeff(&before);
        path[static_cast<std::size_t>(p) - 1] = static_cast<int>(before) + 1;
    }
    return path;
}

LayeredGraph::LayeredGraph(const VisitCosts& costs, const LayeredPaths& paths, const Prices& prices)
    : m_costs(&costs)
{
    const int n = costs.icebergs;
    // Completion of the complete graph, from the back; column p - 1 for position p.
    Eigen::ArrayXXd completion(n, n);
    completion.col(n - 1) = costs.legs.row(0).tail(n).transpose().array();
    Eigen::ArrayXd onwards(n);
    const auto enter = [&](int p) {
        for (int j = 1; j <= n; ++j)
            onwards(j - 1) = costs.visit(j, p) - prices.lambda(j) + completion(j - 1, p - 1);
    };
    for (int p = n - 1; p >= 1; --p) {
        enter(p + 1);
        for (int i = 1; i <= n; ++i) {
            Eigen::ArrayXd lengths = costs.legs.col(i).tail(n).array() + onwards;
            lengths(i - 1) = kInfinity;
            completion(i - 1, p - 1) = lengths.minCoeff();
        }
    }

    const double allowed = prices.cutoff - prices.sum;
    Eigen::ArrayXXi id = Eigen::ArrayXXi::Constant(n, n, -1);
    m_iceberg.push_back(0);
    m_firstNode = {0, 1};
    for (int p = 1; p <= n; ++p) {
        for (int i = 1; i <= n; ++i)
            if (paths.length(i, p) + completion(i - 1, p - 1) < allowed) {
                id(i - 1, p - 1) = nodeCount();
                m_iceberg.push_back(i);
            }
        m_firstNode.push_back(nodeCount());
    }
    for (int p = 0; p < n; ++p) {
        enter(p + 1);
        for (int v = layerBegin(p); v < layerBegin(p + 1); ++v) {
            const int i = iceberg(v);
            m_firstArc.push_back(m_arcs.size());
            const double length = p == 0 ? 0.0 : paths.length(i, p);
            for (int j = 1; j <= n; ++j)
                if (j != i && id(j - 1, p) >= 0 &&
                    length + costs.leg(i, j) + onwards(j - 1) < allowed)
                    m_arcs.push_back(id(j - 1, p));
        }
    }
    m_firstArc.resize(m_iceberg.size() + 1, m_arcs.size());
}

std::int64_t LayeredGraph::bytes() const
{
    constexpr std::size_t kNode = sizeof(int) + sizeof(std::size_t) + 2 * sizeof(double);
    return static_cast<std::int64_t>(m_arcs.size() * sizeof(int) + m_iceberg.size() * kNode);
}

double LayeredGraph::sweep(const Prices& prices, const CutQuestion& cut)
{
    m_completion.resize(m_iceberg.size());
    m_entry.resize(m_iceberg.size());
    for (int p = icebergs(); p >= 0; --p) {
        if (cut && cut())
            return -kInfinity;
        for (int v = layerBegin(p); v < layerBegin(p + 1); ++v) {
            const int i = iceberg(v);
            const double least = p == icebergs() ? m_costs->leg(i, 0) : leastOnwards(v);
            m_completion[static_cast<std::size_t>(v)] = least;
            m_entry[static_cast<std::size_t>(v)] = least + m_costs->visit(i, p) - prices.lambda(i);
        }
    }
    return prices.sum + completion(0);
}

double LayeredGraph::leastOnwards(int node) const
{
    const double* const legs = m_costs->legs.col(iceberg(node)).data();
    const auto onwards = [this, legs](int to) {
        return legs[iceberg(to)] + m_entry[static_cast<std::size_t>(to)];
    };
    // Four minima at once: a single one would wait for each comparison.
    std::array<double, 4> least{kInfinity, kInfinity, kInfinity, kInfinity};
    const std::span<const int> to = successors(node);
    std::size_t k = 0;
    for (; k + 3 < to.size(); k += 4)
        for (std::size_t m = 0; m < 4; ++m)
            least[m] = std::min(least[m], onwards(to[k + m]));
    for (; k < to.size(); ++k)
        least[0] = std::min(least[0], onwards(to[k]));
    return std::min(std::min(least[0], least[1]), std::min(least[2], least[3]));
}

std::vector<int> LayeredGraph::shortestPath() const
{
    std::vector<int> path;
    if (completion(0) == kInfinity)
        return path;
    path.reserve(static_cast<std::size_t>(icebergs()));
    for (int v = 0; v < layerBegin(icebergs());) {
        double least = kInfinity;
        int next = v;
        for (const int to : successors(v)) {
            const double length =
                m_costs->leg(iceberg(v), iceberg(to)) + m_entry[static_cast<std::size_t>(to)];
            if (length < least) {
                least = length;
                next = to;
            }
        }
        path.push_back(iceberg(next));
        v = next;
    }
    return path;
}

std::vector<double> LayeredGraph::lengthsFromStart(const Prices& prices,
                                                   const CutQuestion& cut) const
{
    std::vector<double> length(m_iceberg.size(), kInfinity);
    length[0] = 0;
    for (int p = 0; p <= icebergs(); ++p) {
        if (cut && cut())
            return {};
        for (int v = layerBegin(p); v < layerBegin(p + 1); ++v) {
            const int i = iceberg(v);
            double& here = length[static_cast<std::size_t>(v)];
            here += m_costs->visit(i, p) - prices.lambda(i);
            for (const int to : successors(v)) {
                double& there = length[static_cast<std::size_t>(to)];
                there = std::min(there, here + m_costs->leg(i, iceberg(to)));
            }
        }
    }
    return length;
}

bool LayeredGraph::trim(const Prices& prices, const CutQuestion& cut)
{
    const std::vector<double> length = lengthsFromStart(prices, cut);
    if (length.empty())
        return false;
    const double allowed = prices.cutoff - prices.sum;
    const auto at = [](int v) { return static_cast<std::size_t>(v); };

    std::vector<int> id(m_iceberg.size(), -1);
    int kept = 0;
    for (int v = 0; v < nodeCount(); ++v)
        if (v == 0 || length[at(v)] + completion(v) < allowed)
            id[at(v)] = kept++;

    std::size_t arcs = 0;
    std::vector<int> firstNode(m_firstNode.size(), kept);
    std::size_t layer = 0;
    for (int v = 0; v < nodeCount(); ++v) {
        if (id[at(v)] < 0)
            continue;
        while (m_firstNode[layer] <= v) {
            if (cut && cut())
                return false;
            firstNode[layer++] = id[at(v)];
        }
        const std::size_t begin = m_firstArc[at(v)];
        const std::size_t end = m_firstArc[at(v) + 1];
        const std::size_t newBegin = arcs;
        for (std::size_t a = begin; a < end; ++a) {
            const int to = m_arcs[a];
            const double onwards = m_costs->leg(iceberg(v), iceberg(to)) + m_entry[at(to)];
            if (id[at(to)] >= 0 && length[at(v)] + onwards < allowed)
                m_arcs[arcs++] = id[at(to)];
        }
        // In place: the new numbers never overtake the old ones that are still to be read.
        m_iceberg[at(id[at(v)])] = m_iceberg[at(v)];
        m_completion[at(id[at(v)])] = m_completion[at(v)];
        m_firstArc[at(id[at(v)])] = newBegin;
    }
    m_firstNode = std::move(firstNode);
    m_arcs.resize(arcs);
    m_iceberg.resize(at(kept));
    m_firstArc.resize(at(kept) + 1);
    m_firstArc[at(kept)] = arcs;
    m_completion.resize(at(kept));
    return true;
}

Refinement LayeredGraph::refined(const NgSets& sets, const Prices& prices,
                                 const GraphLimits& limits, const CutQuestion& cut) const
{
    LayeredGraph result(*m_costs);
    result.m_firstNode.push_back(0);
    const double allowed = prices.cutoff - prices.sum;
    LabelTable current;
    LabelTable next;
    current.offer({.memory = {}, .length = 0, .node = 0});
    for (int p = 0;; ++p) {
        const int begin = result.nodeCount();
        const int end = begin + static_cast<int>(current.labels().size());
        result.m_firstNode.push_back(end);
        for (const LabelTable::Label& label : current.labels()) {
            if (result.nodeCount() % kNodesPerCheck == 0 && cut && cut())
                return {};
            const int i = iceberg(label.node);
            const double length = label.length + m_costs->visit(i, p) - prices.lambda(i);
            const NodeSet visited = i == 0 ? label.memory : label.memory.with(i);
            result.m_iceberg.push_back(i);
            result.m_firstArc.push_back(result.m_arcs.size());
            for (const int to : successors(label.node)) {
                const int j = iceberg(to);
                const double leg = m_costs->leg(i, j);
                if (label.memory.contains(j) ||
                    length + leg + m_entry[static_cast<std::size_t>(to)] >= allowed)
                    continue;
                const int id = next.offer(
                    {.memory = visited & sets.at(p + 1, j), .length = length + leg, .node = to});
                result.m_arcs.push_back(end + id);
            }
        }
        if (result.bytes() > limits.bytes)
            return {.graph = {}, .memoryOut = true};
        if (result.arcCount() > limits.arcs || (cut && cut()))
            return {};
        if (p == icebergs())
            break;
        std::swap(current, next);
        next.clear();
    }
    result.m_firstArc.push_back(result.m_arcs.size());
    return {.graph = std::move(result)};
}

} // namespace berg
