#pragma once

#include "core/plan/solve/large_vector.h"
#include "core/plan/solve/layered_paths.h"

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

    [[nodiscard]] bool contains(int node) const { return (word(node) >> (node & 63) & 1U) != 0; }
    void insert(int node)
    {
        words[static_cast<std::size_t>(node >> 6)] |= std::uint64_t{1} << (node & 63);
    }
    [[nodiscard]] NodeSet with(int node) const
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
    [[nodiscard]] std::uint64_t word(int node) const
    {
        return words[static_cast<std::size_t>(node >> 6)];
    }
};

/** What is remembered where: one set per band 1 .. n (`bandOf`) and iceberg 1 .. n. */
class NgSets
{
public:
    explicit NgSets(int icebergs)
        : m_icebergs(icebergs)
        , m_sets(static_cast<std::size_t>(icebergs + 1) * static_cast<std::size_t>(icebergs + 1))
    {
    }
    [[nodiscard]] const NodeSet& at(int band, int iceberg) const
    {
        return m_sets[index(band, iceberg)];
    }
    [[nodiscard]] NodeSet& at(int band, int iceberg) { return m_sets[index(band, iceberg)]; }

private:
    [[nodiscard]] std::size_t index(int band, int iceberg) const
    {
        return static_cast<std::size_t>(band) * static_cast<std::size_t>(m_icebergs + 1) +
               static_cast<std::size_t>(iceberg);
    }

    int m_icebergs;
    std::vector<NodeSet> m_sets;
};

/** Levels 1 .. `lastLevel` in as many bands as there are icebergs: positions, if these are levels.
 */
template <class Costs>
[[nodiscard]] int bandOf(const Costs& costs, int level)
{
    if constexpr (Costs::kWeighted)
        return 1 + static_cast<int>(std::int64_t{level - 1} * costs.icebergs / costs.lastLevel());
    else
        return level;
}

/** How large a graph may become. */
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
 * whose cost is below the cutoffs it was trimmed with; those that visit an iceberg twice are what
 * the multipliers are for. The length of a path is its cost - sum lambda over its visits, so that
 * sum(lambda) + shortest length is a lower bound on the best order still inside.
 *
 * Where legs are weighted by the sigma unseen, a node counts them with the least that any path to
 * it leaves unseen; that gets truer with every path deleted and every memory added.
 *
 * Node 0 is the UAV; nodes are ordered by level. At most 127 icebergs.
 */
template <class Costs>
class LayeredGraph
{
public:
    /**
     * Graph without memory, with the arcs on paths below the cutoff, from paths swept at the same
     * prices. Cost: a few sweeps of them. Of no use when cut.
     */
    LayeredGraph(const Costs& costs, const LayeredPaths<Costs>& paths,
                 const Multipliers& multipliers, const CutQuestion& cut = {});

    /**
     * Finds all shortest lengths to the end. Returns the lower bound sum(lambda) + shortest
     * length, +infinity when no path is left, -infinity when cut.
     */
    double sweep(const Multipliers& multipliers, const CutQuestion& cut = {});
    /** Shortest path of the last sweep: icebergs in turn; empty when there is none. */
    [[nodiscard]] std::vector<int> shortestPath() const;
    /** Length from `node` to the end at the last sweep's multipliers. */
    [[nodiscard]] double completion(int node) const
    {
        return m_completion[static_cast<std::size_t>(node)];
    }

    /**
     * Deletes for good what is on no path below the cutoff. Sweep at the same prices first, and
     * again afterwards. False when cut: the graph is of no use any more then.
     */
    [[nodiscard]] bool trim(const Multipliers& multipliers, const CutQuestion& cut);

    /**
     * The product of this graph with the memory that `sets` prescribe, less what is on no path
     * below the cutoff. Sweep at the same prices first. No graph when it would exceed the limits
     * or when cut. Needs up to three times `GraphLimits::bytes` on the way.
     */
    [[nodiscard]] Refinement<Costs> refined(const NgSets& sets, const Multipliers& multipliers,
                                            const GraphLimits& limits,
                                            const CutQuestion& cut) const;

    [[nodiscard]] const Costs& costs() const { return *m_costs; }
    [[nodiscard]] int icebergs() const { return m_costs->icebergs; }
    [[nodiscard]] int iceberg(int node) const { return m_iceberg[static_cast<std::size_t>(node)]; }
    [[nodiscard]] int nodeCount() const { return static_cast<int>(m_iceberg.size()); }
    /** Nodes of `layer` 0 .. `lastLevel` are numbered from `layerEnd(layer - 1)` to this less one.
     */
    [[nodiscard]] int layerEnd(int layer) const { return layerBegin(layer + 1); }
    [[nodiscard]] std::int64_t arcCount() const { return static_cast<std::int64_t>(m_arcs.size()); }
    /** Memory in use. */
    [[nodiscard]] std::int64_t bytes() const;
    /** Nodes that may follow `node`. */
    [[nodiscard]] std::span<const int> successors(int node) const
    {
        const auto v = static_cast<std::size_t>(node);
        return std::span(m_arcs).subspan(m_firstArc[v], m_firstArc[v + 1] - m_firstArc[v]);
    }

private:
    struct Making;

    explicit LayeredGraph(const Costs& costs) : m_costs(&costs) {}
    [[nodiscard]] static std::int64_t bytesOf(std::size_t nodes, std::size_t arcs);
    void build(const LayeredPaths<Costs>& paths, const Multipliers& multipliers,
               const CutQuestion& cut);
    [[nodiscard]] int lastLayer() const { return m_costs->lastLevel(); }
    [[nodiscard]] int layerBegin(int layer) const
    {
        return m_firstNode[static_cast<std::size_t>(layer)];
    }
    /** Length by node from the UAV, its own visit included; empty when cut. */
    [[nodiscard]] std::vector<double> lengthsFromStart(const Multipliers& multipliers,
                                                       const CutQuestion& cut) const;
    [[nodiscard]] double leastOnwards(int node) const;
    /** How often legs from the node count. */
    [[nodiscard]] double weight(int node) const
    {
        if constexpr (Costs::kWeighted)
            return m_unseen[static_cast<std::size_t>(node)];
        else
            return 1;
    }
    /** Finds the least sigma unseen of every node anew, where legs have weights. False when cut:
     * the graph is of no use any more then. */
    [[nodiscard]] bool refreshUnseen(const CutQuestion& cut);

    const Costs* m_costs;
    std::vector<int> m_firstNode;        ///< levels + 2: nodes of layer p are [p] .. [p + 1] - 1
    LargeVector<int> m_iceberg;          ///< by node
    LargeVector<std::size_t> m_firstArc; ///< nodes + 1
    LargeVector<int> m_arcs;             ///< node each arc leads to; its cost follows from its ends
    LargeVector<double> m_unseen;        ///< by node, the least; empty when legs have no weight
    LargeVector<double> m_completion;    ///< by node, of the last sweep
    LargeVector<double> m_entry;         ///< completion + cost of the visit - its multiplier
};

/** What `LayeredGraph::refined` made. */
template <class Costs>
struct Refinement
{
    std::optional<LayeredGraph<Costs>> graph;
    bool memoryOut = false; ///< no graph because of `GraphLimits::bytes`
};

} // namespace berg
