#pragma once

#include "core/plan/proof/large_vector.h"
#include "core/plan/proof/layered_paths.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace berg {

/** A set of nodes 0 .. 127. */
struct NodeSet
{
    static constexpr int kCapacity = 128;

    [[nodiscard]] bool contains(NodeIndex node) const
    {
        return (words[wordOf(node)] >> bitOf(node) & 1U) != 0;
    }
    void insert(NodeIndex node) { words[wordOf(node)] |= std::uint64_t{1} << bitOf(node); }
    [[nodiscard]] NodeSet with(NodeIndex node) const
    {
        NodeSet result = *this;
        result.insert(node);
        return result;
    }
    [[nodiscard]] NodeSet operator&(const NodeSet& other) const
    {
        return {{words[0] & other.words[0], words[1] & other.words[1]}};
    }
    [[nodiscard]] int size() const;
    [[nodiscard]] std::size_t hash() const;
    bool operator==(const NodeSet&) const = default;

    std::array<std::uint64_t, 2> words{};

private:
    [[nodiscard]] static std::size_t wordOf(NodeIndex node)
    {
        return static_cast<std::size_t>(node.number() >> 6);
    }
    [[nodiscard]] static int bitOf(NodeIndex node) { return node.number() & 63; }
};

/** Memory of each node: one set of icebergs per band 1 .. n (`bandOf`) and iceberg 1 .. n. */
class NgSets
{
public:
    explicit NgSets(int icebergs)
        : m_icebergs(icebergs)
        , m_sets(static_cast<std::size_t>(icebergs + 1) * static_cast<std::size_t>(icebergs + 1))
    {
    }
    /** Returns the memory of an iceberg in a band. */
    [[nodiscard]] const NodeSet& at(int band, NodeIndex iceberg) const
    {
        return m_sets[index(band, iceberg)];
    }
    [[nodiscard]] NodeSet& at(int band, NodeIndex iceberg) { return m_sets[index(band, iceberg)]; }

private:
    [[nodiscard]] std::size_t index(int band, NodeIndex iceberg) const
    {
        return static_cast<std::size_t>(band) * static_cast<std::size_t>(m_icebergs + 1) +
               toIndex(iceberg);
    }

    int m_icebergs;
    std::vector<NodeSet> m_sets;
};

/**
 * Returns the band of a level: levels 1 .. `lastLevel` are divided into as many bands as there are
 * icebergs. If levels are positions, bands are too.
 */
template <class Costs>
[[nodiscard]] int bandOf(const Costs& costs, int level)
{
    if constexpr (Costs::kWeighted)
        return 1 + static_cast<int>(std::int64_t{level - 1} * costs.icebergs / costs.lastLevel());
    else
        return level;
}

/** Limits of the size of a graph. */
struct GraphLimits
{
    std::int64_t arcs = std::numeric_limits<std::int64_t>::max();
    std::int64_t bytes = std::numeric_limits<std::int64_t>::max();
};

template <class Costs>
struct Refinement;

/**
 * The layered graph of Picard and Queyranne (1978): a node is an iceberg at a level (position; or
 * sigma seen), with a memory of icebergs visited before that may not be visited next (ng-paths:
 * Baldacci, Mingozzi and Roberti 2011). Paths from the UAV to the last level include every order
 * whose cost is below the cutoffs it was trimmed with; the multipliers penalise paths that visit an
 * iceberg twice. The length of a path is its cost - sum lambda over its visits, so that sum(lambda)
 * + shortest length is a lower bound on the best order still inside.
 *
 * If legs are weighted by the sigma unseen, a node weights them with the least sigma that any path
 * to it leaves unseen; this becomes more accurate with every path deleted and every memory added.
 *
 * Node 0 is the UAV; nodes are ordered by level. At most 127 icebergs.
 */
template <class Costs>
class LayeredGraph
{
public:
    /**
     * Builds a graph without memory, with the arcs on paths below the cutoff, from paths swept at
     * the same multipliers. Cost: a few sweeps of them. The graph is unusable if stopped. Keeps a
     * reference to `costs`, which must outlive the graph.
     */
    LayeredGraph(const Costs& costs, const LayeredPaths<Costs>& paths,
                 const Multipliers& multipliers, const StopCheck& isStopped = {});

    /**
     * Finds all shortest lengths to the end. Returns the lower bound sum(lambda) + shortest length,
     * +infinity if no path is left, -infinity if stopped.
     */
    double sweep(const Multipliers& multipliers, const StopCheck& isStopped = {});
    /**
     * Returns the shortest path of the last sweep, icebergs in visiting order; empty if there is
     * none.
     */
    [[nodiscard]] VisitOrder shortestPath() const;
    /** Returns the length from `node` to the end at the last sweep's multipliers. */
    [[nodiscard]] double completion(int node) const
    {
        return m_completion[static_cast<std::size_t>(node)];
    }

    /**
     * Deletes everything that is on no path below the cutoff. Sweep at the same multipliers before,
     * and again afterwards. Returns false if stopped: the graph is then unusable.
     */
    [[nodiscard]] bool trim(const Multipliers& multipliers, const StopCheck& isStopped);

    /**
     * Returns the product of this graph with the memory that `sets` prescribe, without the parts
     * that are on no path below the cutoff. Sweep at the same multipliers first. Returns no graph
     * if it would exceed the limits, or if stopped. Needs up to three times `GraphLimits::bytes`
     * meanwhile.
     */
    [[nodiscard]] Refinement<Costs> refined(const NgSets& sets, const Multipliers& multipliers,
                                            const GraphLimits& limits,
                                            const StopCheck& isStopped) const;

    [[nodiscard]] const Costs& costs() const { return *m_costs; }
    [[nodiscard]] int icebergs() const { return m_costs->icebergs; }
    /** Returns the iceberg of a node of the graph; 0 for the UAV. */
    [[nodiscard]] NodeIndex iceberg(int node) const
    {
        return m_iceberg[static_cast<std::size_t>(node)];
    }
    [[nodiscard]] int nodeCount() const { return static_cast<int>(m_iceberg.size()); }
    /**
     * Returns the end of the node numbers of `layer` 0 .. `lastLevel`, which begin at
     * `layerEnd(layer - 1)`.
     */
    [[nodiscard]] int layerEnd(int layer) const { return layerBegin(layer + 1); }
    [[nodiscard]] std::int64_t arcCount() const { return static_cast<std::int64_t>(m_arcs.size()); }
    /** Returns the memory in use, bytes. */
    [[nodiscard]] std::int64_t bytes() const;
    /** Returns the nodes that may follow `node`. */
    [[nodiscard]] std::span<const int> successors(int node) const
    {
        const auto v = static_cast<std::size_t>(node);
        return std::span(m_arcs).subspan(m_firstArc[v], m_firstArc[v + 1] - m_firstArc[v]);
    }

private:
    struct Construction;

    explicit LayeredGraph(const Costs& costs) : m_costs(&costs) {}
    [[nodiscard]] static std::int64_t bytesOf(std::size_t nodes, std::size_t arcs);
    void build(const LayeredPaths<Costs>& paths, const Multipliers& multipliers,
               const StopCheck& isStopped);
    [[nodiscard]] int lastLayer() const { return m_costs->lastLevel(); }
    [[nodiscard]] int layerBegin(int layer) const
    {
        return m_firstNode[static_cast<std::size_t>(layer)];
    }
    /** Returns by node the length from the UAV, its own visit included; empty if stopped. */
    [[nodiscard]] std::vector<double> lengthsFromStart(const Multipliers& multipliers,
                                                       const StopCheck& isStopped) const;
    [[nodiscard]] double leastOnwards(int node) const;
    /** Returns the factor of legs from the node. */
    [[nodiscard]] double weight(int node) const
    {
        if constexpr (Costs::kWeighted)
            return m_unseen[static_cast<std::size_t>(node)];
        else
            return 1;
    }
    /**
     * Recomputes the least sigma unseen of every node, if legs have weights. Returns false if
     * stopped: the graph is then unusable.
     */
    [[nodiscard]] bool refreshUnseen(const StopCheck& isStopped);

    const Costs* m_costs;
    std::vector<int> m_firstNode;        ///< levels + 2; nodes of layer p are [p] .. [p + 1] - 1
    LargeVector<NodeIndex> m_iceberg;    ///< by node
    LargeVector<std::size_t> m_firstArc; ///< nodes + 1
    LargeVector<int> m_arcs;             ///< node each arc leads to; its cost follows from its ends
    LargeVector<double> m_unseen; ///< by node, the least sigma unseen; empty if legs have no weight
    LargeVector<double> m_completion; ///< by node, at the last sweep
    LargeVector<double> m_entry;      ///< completion + cost of the visit - its multiplier
};

/** Result of `LayeredGraph::refined`. */
template <class Costs>
struct Refinement
{
    std::optional<LayeredGraph<Costs>> graph;
    bool memoryOut = false; ///< whether there is no graph because of `GraphLimits::bytes`
};

} // namespace berg
