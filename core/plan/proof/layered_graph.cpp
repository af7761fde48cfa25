#include "core/plan/proof/layered_graph.h"

#include "core/plan/proof/label_table.h"
#include "core/plan/proof/piece_list.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <memory>
#include <utility>

namespace berg {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/** Nodes between two checks for a stop. */
constexpr int kNodesPerCheck = 2048;
/** Number where there is no node; an optional would double the tables of numbers. */
constexpr int kNoNode = -1;
/** Arcs between two checks for a stop while a graph is built. */
constexpr std::size_t kArcsPerCheck = 16'384;

template <class Costs>
int longestStep(const Costs& costs)
{
    int longest = 1;
    for (const NodeIndex i : icebergNodes(costs.icebergs))
        longest = std::max(longest, costs.step(i));
    return longest;
}

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

template <class Costs>
LayeredGraph<Costs>::LayeredGraph(const Costs& costs, const LayeredPaths<Costs>& paths,
                                  const Multipliers& multipliers, const StopCheck& isStopped)
    : m_costs(&costs)
{
    build(paths, multipliers, isStopped);
}

/** Builds the graph with positions in the order as layers. */
template <>
void LayeredGraph<VisitCosts>::build(const LayeredPaths<VisitCosts>& paths,
                                     const Multipliers& multipliers, const StopCheck& isStopped)
{
    const VisitCosts& costs = *m_costs;
    const int n = costs.icebergs;
    // Completion of the complete graph, from the back; column p - 1 for position p.
    Eigen::ArrayXXd completion(n, n);
    completion.col(n - 1) = costs.legs.row(0).tail(n).transpose().array();
    Eigen::ArrayXd onwards(n);
    const auto enter = [&](int p) {
        for (int j = 1; j <= n; ++j)
            onwards(j - 1) =
                costs.visit(NodeIndex::of(j), p) - multipliers.lambda(j) + completion(j - 1, p - 1);
    };
    for (int p = n - 1; p >= 1; --p) {
        if (isStopped && isStopped())
            return;
        enter(p + 1);
        for (int i = 1; i <= n; ++i) {
            Eigen::ArrayXd lengths = costs.legs.col(i).tail(n).array() + onwards;
            lengths(i - 1) = kInfinity;
            completion(i - 1, p - 1) = lengths.minCoeff();
        }
    }

    const double allowed = multipliers.allowedLength();
    Eigen::ArrayXXi id = Eigen::ArrayXXi::Constant(n, n, kNoNode);
    m_iceberg.push_back(0);
    m_firstNode = {0, 1};
    for (int p = 1; p <= n; ++p) {
        for (int i = 1; i <= n; ++i)
            if (paths.length(NodeIndex::of(i), p) + completion(i - 1, p - 1) < allowed) {
                id(i - 1, p - 1) = nodeCount();
                m_iceberg.push_back(NodeIndex::of(i));
            }
        m_firstNode.push_back(nodeCount());
    }
    PieceList<int> arcs;
    for (int p = 0; p < n; ++p) {
        if (isStopped && isStopped())
            return;
        enter(p + 1);
        for (int v = layerBegin(p); v < layerBegin(p + 1); ++v) {
            const NodeIndex i = iceberg(v);
            m_firstArc.push_back(arcs.size());
            const double length = p == 0 ? 0.0 : paths.length(i, p);
            for (const NodeIndex j : icebergNodes(n)) {
                const int row = j.number() - 1;
                if (j != i && id(row, p) != kNoNode &&
                    length + costs.leg(i, j) + onwards(row) < allowed)
                    arcs.push_back(id(row, p));
            }
        }
    }
    m_firstArc.resize(m_iceberg.size() + 1, arcs.size());
    (void)arcs.moveTo(m_arcs, isStopped);
}

template <>
bool LayeredGraph<LatencyCosts>::refreshUnseen(const StopCheck& isStopped)
{
    if (!fillInPieces(m_unseen, m_iceberg.size(), kInfinity, isStopped))
        return false;
    // The value is rounded down, or a difference of large sums could exceed the true one by its
    // rounding.
    const double rounding = roundingMargin(1, m_costs->sigmaSum);
    m_unseen[0] = m_costs->sigmaSum - rounding * icebergs();
    for (int level = 0; level <= lastLayer(); ++level)
        for (int v = layerBegin(level); v < layerBegin(level + 1); ++v) {
            if (v % kNodesPerCheck == 0 && isStopped && isStopped())
                return false;
            double& unseen = m_unseen[static_cast<std::size_t>(v)];
            const double alongPaths = unseen - m_costs->sigmaOf(iceberg(v)) - rounding;
            const double ofAnySet = m_costs->leastUnseen(level);
            unseen = alongPaths < kInfinity ? std::max(alongPaths, ofAnySet) : ofAnySet;
            for (const int to : successors(v)) {
                double& there = m_unseen[static_cast<std::size_t>(to)];
                there = std::min(there, unseen);
            }
        }
    return true;
}

/** Builds the graph with levels of the sigma seen as layers. */
template <>
void LayeredGraph<LatencyCosts>::build(const LayeredPaths<LatencyCosts>& paths,
                                       const Multipliers& multipliers, const StopCheck& isStopped)
{
    const LatencyCosts& costs = *m_costs;
    const int n = costs.icebergs;
    const double allowed = multipliers.allowedLength();
    Eigen::ArrayXXd length = Eigen::ArrayXXd::Constant(n, lastLayer() + 1, kInfinity);
    // Calls `visitor(j, level, length)` for every leg from the node that is on a path below the
    // cutoff.
    const auto forLegs = [&](NodeIndex i, int level, const auto& visitor) {
        const double weight = costs.leastUnseen(level);
        const double here = i == 0 ? 0.0 : length(i.number() - 1, level);
        for (const NodeIndex j : icebergNodes(n)) {
            const int next = level + costs.step(j);
            if (j == i || next > lastLayer())
                continue;
            const double there = here + weight * costs.leg(i, j) - multipliers.lambda(j.number());
            if (there + paths.completion(j, next) < allowed)
                visitor(j, next, there);
        }
    };
    const auto offer = [&length](NodeIndex j, int level, double there) {
        double& least = length(j.number() - 1, level);
        least = std::min(least, there);
    };
    Eigen::ArrayXXi id = Eigen::ArrayXXi::Constant(n, lastLayer() + 1, kNoNode);
    m_iceberg.push_back(0);
    m_firstNode = {0, 1};
    forLegs(0, 0, offer);
    for (int level = 1; level <= lastLayer(); ++level) {
        if (isStopped && isStopped())
            return;
        for (const NodeIndex i : icebergNodes(n))
            if (length(i.number() - 1, level) < kInfinity) {
                id(i.number() - 1, level) = nodeCount();
                m_iceberg.push_back(i);
                forLegs(i, level, offer);
            }
        m_firstNode.push_back(nodeCount());
    }
    PieceList<int> arcs;
    for (int level = 0; level <= lastLayer(); ++level) {
        if (isStopped && isStopped())
            return;
        for (int v = layerBegin(level); v < layerBegin(level + 1); ++v) {
            m_firstArc.push_back(arcs.size());
            forLegs(iceberg(v), level, [&](NodeIndex j, int next, double) {
                arcs.push_back(id(j.number() - 1, next));
            });
        }
    }
    m_firstArc.push_back(arcs.size());
    if (arcs.moveTo(m_arcs, isStopped))
        (void)refreshUnseen(isStopped);
}

template <class Costs>
std::int64_t LayeredGraph<Costs>::bytes() const
{
    return bytesOf(m_iceberg.size(), m_arcs.size());
}

template <class Costs>
std::int64_t LayeredGraph<Costs>::bytesOf(std::size_t nodes, std::size_t arcs)
{
    constexpr std::size_t kNode =
        sizeof(int) + sizeof(std::size_t) + (Costs::kWeighted ? 3 : 2) * sizeof(double);
    return static_cast<std::int64_t>(arcs * sizeof(int) + nodes * kNode);
}

template <class Costs>
double LayeredGraph<Costs>::sweep(const Multipliers& multipliers, const StopCheck& isStopped)
{
    for (LargeVector<double>* const values : {&m_completion, &m_entry})
        if (values->size() != m_iceberg.size() &&
            !fillInPieces(*values, m_iceberg.size(), 0.0, isStopped))
            return -kInfinity;
    for (int p = lastLayer(); p >= 0; --p) {
        for (int v = layerBegin(p); v < layerBegin(p + 1); ++v) {
            if (v % kNodesPerCheck == 0 && isStopped && isStopped())
                return -kInfinity;
            const NodeIndex i = iceberg(v);
            const double least = p == lastLayer() ? m_costs->leg(i, 0) : leastOnwards(v);
            m_completion[static_cast<std::size_t>(v)] = least;
            m_entry[static_cast<std::size_t>(v)] =
                least + m_costs->visit(i, p) - multipliers.lambda(i.number());
        }
    }
    return multipliers.sum + completion(0);
}

template <class Costs>
double LayeredGraph<Costs>::leastOnwards(int node) const
{
    const double* const legs = m_costs->legs.col(iceberg(node).number()).data();
    const double factor = weight(node);
    const auto onwards = [this, legs, factor](int to) {
        return factor * legs[iceberg(to).number()] + m_entry[static_cast<std::size_t>(to)];
    };
    // Four minima run in parallel: a single one would wait for each comparison.
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

template <class Costs>
VisitOrder LayeredGraph<Costs>::shortestPath() const
{
    VisitOrder path;
    if (completion(0) == kInfinity)
        return path;
    path.reserve(static_cast<std::size_t>(icebergs()));
    for (int v = 0; v < layerBegin(lastLayer());) {
        double least = kInfinity;
        int next = v;
        for (const int to : successors(v)) {
            const double length = weight(v) * m_costs->leg(iceberg(v), iceberg(to)) +
                                  m_entry[static_cast<std::size_t>(to)];
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

template <class Costs>
std::vector<double> LayeredGraph<Costs>::lengthsFromStart(const Multipliers& multipliers,
                                                          const StopCheck& isStopped) const
{
    std::vector<double> length;
    if (!fillInPieces(length, m_iceberg.size(), kInfinity, isStopped))
        return {};
    length[0] = 0;
    for (int p = 0; p <= lastLayer(); ++p) {
        for (int v = layerBegin(p); v < layerBegin(p + 1); ++v) {
            if (v % kNodesPerCheck == 0 && isStopped && isStopped())
                return {};
            const NodeIndex i = iceberg(v);
            double& here = length[static_cast<std::size_t>(v)];
            here += m_costs->visit(i, p) - multipliers.lambda(i.number());
            for (const int to : successors(v)) {
                double& there = length[static_cast<std::size_t>(to)];
                there = std::min(there, here + weight(v) * m_costs->leg(i, iceberg(to)));
            }
        }
    }
    return length;
}

template <class Costs>
bool LayeredGraph<Costs>::trim(const Multipliers& multipliers, const StopCheck& isStopped)
{
    const std::vector<double> length = lengthsFromStart(multipliers, isStopped);
    if (length.empty())
        return false;
    const double allowed = multipliers.allowedLength();
    const auto at = [](int v) { return static_cast<std::size_t>(v); };

    std::vector<int> id;
    if (!fillInPieces(id, m_iceberg.size(), kNoNode, isStopped))
        return false;
    int kept = 0;
    for (int v = 0; v < nodeCount(); ++v) {
        if (v % kNodesPerCheck == 0 && isStopped && isStopped())
            return false;
        if (v == 0 || length[at(v)] + completion(v) < allowed)
            id[at(v)] = kept++;
    }

    std::size_t arcs = 0;
    std::vector<int> firstNode(m_firstNode.size(), kept);
    std::size_t layer = 0;
    for (int v = 0; v < nodeCount(); ++v) {
        if (v % kNodesPerCheck == 0 && isStopped && isStopped())
            return false;
        if (id[at(v)] == kNoNode)
            continue;
        while (m_firstNode[layer] <= v)
            firstNode[layer++] = id[at(v)];
        const std::size_t begin = m_firstArc[at(v)];
        const std::size_t end = m_firstArc[at(v) + 1];
        const std::size_t newBegin = arcs;
        for (std::size_t a = begin; a < end; ++a) {
            const int to = m_arcs[a];
            const double onwards =
                weight(v) * m_costs->leg(iceberg(v), iceberg(to)) + m_entry[at(to)];
            if (id[at(to)] != kNoNode && length[at(v)] + onwards < allowed)
                m_arcs[arcs++] = id[at(to)];
        }
        // Moving in place is safe: the new numbers never overtake the old ones that are still to be
        // read.
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
    if constexpr (Costs::kWeighted)
        return refreshUnseen(isStopped);
    return true;
}

/** A refined graph under construction. */
template <class Costs>
struct LayeredGraph<Costs>::Construction
{
    explicit Construction(const Costs& costs) : graph(costs), tables(longestStep(costs)) {}
    [[nodiscard]] std::int64_t bytes() const
    {
        return graph.bytes() + labelOf.bytes() + icebergs.bytes() + firstArc.bytes() + arcs.bytes();
    }

    LayeredGraph graph;
    LabelTables tables;
    PieceList<int> labelOf; ///< number of each node's label
    PieceList<NodeIndex> icebergs;
    PieceList<std::size_t> firstArc;
    PieceList<int> arcs; ///< numbers of the labels that arcs lead to
};

template <class Costs>
Refinement<Costs> LayeredGraph<Costs>::refined(const NgSets& sets, const Multipliers& multipliers,
                                               const GraphLimits& limits,
                                               const StopCheck& isStopped) const
{
    const std::unique_ptr<Construction, DeferredDeleter> construction(new Construction(*m_costs));
    auto& [result, tables, labelOf, icebergs, firstArc, arcs] = *construction;
    result.m_firstNode.push_back(0);
    const double allowed = multipliers.allowedLength();
    tables.offer(0, {.memory = {}, .length = 0, .node = 0});
    std::size_t checked = 0; // arcs tried before the last check for a stop
    std::size_t tried = 0;
    for (int level = 0; level <= lastLayer(); ++level) {
        for (const LabelTable::Label& label : tables.at(level).labels()) {
            const std::span<const int> onwards = successors(label.node);
            tried += 1 + onwards.size();
            if (tried - checked > kArcsPerCheck) {
                checked = tried;
                if (isStopped && isStopped())
                    return {};
            }
            if constexpr (Costs::kWeighted)
                labelOf.push_back(label.number);
            const NodeIndex i = iceberg(label.node);
            const double length =
                label.length + m_costs->visit(i, level) - multipliers.lambda(i.number());
            const double factor = weight(label.node);
            const NodeSet visited = i == 0 ? label.memory : label.memory.with(i);
            icebergs.push_back(i);
            firstArc.push_back(arcs.size());
            for (const int to : onwards) {
                const NodeIndex j = iceberg(to);
                const double leg = factor * m_costs->leg(i, j);
                if (label.memory.contains(j) ||
                    length + leg + m_entry[static_cast<std::size_t>(to)] >= allowed)
                    continue;
                const int next = level + m_costs->step(j);
                const NodeSet memory = visited & sets.at(bandOf(*m_costs, next), j);
                arcs.push_back(
                    tables.offer(next, {.memory = memory, .length = length + leg, .node = to}));
            }
        }
        tables.at(level).clear();
        result.m_firstNode.push_back(static_cast<int>(icebergs.size()));
        if (bytesOf(icebergs.size(), arcs.size()) > limits.bytes)
            return {.graph = {}, .memoryOut = true};
        if (static_cast<std::int64_t>(arcs.size()) > limits.arcs)
            return {};
    }
    firstArc.push_back(arcs.size());
    if (!icebergs.moveTo(result.m_iceberg, isStopped) ||
        !firstArc.moveTo(result.m_firstArc, isStopped))
        return {};
    if constexpr (Costs::kWeighted) {
        std::vector<int> nodeOf;
        if (!fillInPieces(nodeOf, labelOf.size(), 0, isStopped))
            return {};
        int node = 0;
        const auto enter = [&](int number) { nodeOf[static_cast<std::size_t>(number)] = node++; };
        if (!labelOf.forEach(isStopped, enter) ||
            !arcs.moveTo(result.m_arcs, isStopped,
                         [&](int number) { return nodeOf[static_cast<std::size_t>(number)]; }))
            return {};
        if (!result.refreshUnseen(isStopped))
            return {};
    } else if (!arcs.moveTo(result.m_arcs, isStopped)) {
        return {};
    }
    return {.graph = std::move(result)};
}

template class LayeredGraph<VisitCosts>;
template class LayeredGraph<LatencyCosts>;

} // namespace berg
