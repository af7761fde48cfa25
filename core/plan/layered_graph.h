#pragma once

#include "core/plan/order_moves.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
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

/** What is remembered where: one set per position 1 .. n and iceberg 1 .. n. */
class NgSets
{
public:
    explicit NgSets(int icebergs)
        : m_icebergs(icebergs)
        , m_sets(static_cast<std::size_t>(icebergs + 1) * static_cast<std::size_t>(icebergs + 1))
    {
    }
    [[nodiscard]] const NodeSet& at(int position, int iceberg) const
    {
        return m_sets[index(position, iceberg)];
    }
    [[nodiscard]] NodeSet& at(int position, int iceberg)
    {
        return m_sets[index(position, iceberg)];
    }

private:
    [[nodiscard]] std::size_t index(int position, int iceberg) const
    {
        return static_cast<std::size_t>(position) * static_cast<std::size_t>(m_icebergs + 1) +
               static_cast<std::size_t>(iceberg);
    }

    int m_icebergs;
    std::vector<NodeSet> m_sets;
};

/** Asked at least every 10 ms during long work; true ends it. May be empty. */
using CutQuestion = std::function<bool()>;

/** Multipliers of "each iceberg once", one per node ([0] is 0), and the cost they cut at. */
struct Prices
{
    Eigen::VectorXd lambda;
    double sum = 0;    ///< of lambda
    double cutoff = 0; ///< paths of at least this cost are not wanted
};

/** How large a graph may become. */
struct GraphLimits
{
    std::int64_t arcs = std::numeric_limits<std::int64_t>::max();
    std::int64_t bytes = std::numeric_limits<std::int64_t>::max();
};

/**
 * Shortest paths by positions 1 .. n in the complete graph (any iceberg after any other one, no
 * memory), without building it: O(n^3) vector operations a sweep, O(n^2) memory. Any n.
 */
class LayeredPaths
{
public:
    explicit LayeredPaths(const VisitCosts& costs);

    /** As `LayeredGraph::sweep`; -infinity when cut. */
    double sweep(const Prices& prices, const CutQuestion& cut);
    /** Shortest path of the last sweep, which was not cut: icebergs by position. */
    [[nodiscard]] std::vector<int> shortestPath() const;
    /** Length from the UAV to `iceberg` (1 .. n) in `position`, its multiplier included. */
    [[nodiscard]] double length(int iceberg, int position) const
    {
        return m_lengths(iceberg - 1, position - 1);
    }

private:
    const VisitCosts* m_costs;
    Eigen::ArrayXXd m_legs;    ///< n x n, column = from; the diagonal is infinite
    Eigen::ArrayXXd m_lengths; ///< n x n, column = position
    int m_last = 0;            ///< iceberg the shortest path ends at
};

struct Refinement;

/**
 * The position-layered graph of Picard and Queyranne (1978): a node is an iceberg in a position,
 * with a memory of icebergs visited before that may not be visited next (ng-paths: Baldacci,
 * Mingozzi and Roberti 2011). Paths from the UAV through all layers include every order whose
 * cost is below the cutoffs it was trimmed with; those that visit an iceberg twice are what the
 * multipliers are for. The length of a path is its cost - sum lambda over its visits, so that
 * sum(lambda) + shortest length is a lower bound on the best order still inside.
 *
 * Node 0 is the UAV; nodes are ordered by layer. At most 127 icebergs.
 */
class LayeredGraph
{
public:
    /** Graph without memory, with the arcs on paths below the cutoff. Cost: O(n^3). */
    LayeredGraph(const VisitCosts& costs, const LayeredPaths& paths, const Prices& prices);

    /**
     * Finds all shortest lengths to the end. Returns the lower bound sum(lambda) + shortest
     * length, +infinity when no path is left, -infinity when cut.
     */
    double sweep(const Prices& prices, const CutQuestion& cut = {});
    /** Shortest path of the last sweep: icebergs by position; empty when there is none. */
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
    [[nodiscard]] bool trim(const Prices& prices, const CutQuestion& cut);

    /**
     * The product of this graph with the memory that `sets` prescribe, less what is on no path
     * below the cutoff. Sweep at the same prices first. No graph when it would exceed the limits
     * or when cut. Needs up to three times `GraphLimits::bytes` on the way.
     */
    [[nodiscard]] Refinement refined(const NgSets& sets, const Prices& prices,
                                     const GraphLimits& limits, const CutQuestion& cut) const;

    [[nodiscard]] const VisitCosts& costs() const { return *m_costs; }
    [[nodiscard]] int icebergs() const { return m_costs->icebergs; }
    [[nodiscard]] int iceberg(int node) const { return m_iceberg[static_cast<std::size_t>(node)]; }
    [[nodiscard]] int nodeCount() const { return static_cast<int>(m_iceberg.size()); }
    /** Nodes of `layer` 0 .. n are numbered from `layerEnd(layer - 1)` to this less one. */
    [[nodiscard]] int layerEnd(int layer) const { return layerBegin(layer + 1); }
    [[nodiscard]] std::int64_t arcCount() const { return static_cast<std::int64_t>(m_arcs.size()); }
    /** Memory in use. */
    [[nodiscard]] std::int64_t bytes() const;
    /** Nodes of the next layer that may follow `node`. */
    [[nodiscard]] std::span<const int> successors(int node) const
    {
        const auto v = static_cast<std::size_t>(node);
        return std::span(m_arcs).subspan(m_firstArc[v], m_firstArc[v + 1] - m_firstArc[v]);
    }

private:
    explicit LayeredGraph(const VisitCosts& costs) : m_costs(&costs) {}
    [[nodiscard]] int layerBegin(int layer) const
    {
        return m_firstNode[static_cast<std::size_t>(layer)];
    }
    /** Length by node from the UAV, its own visit included; empty when cut. */
    [[nodiscard]] std::vector<double> lengthsFromStart(const Prices& prices,
                                                       const CutQuestion& cut) const;
    [[nodiscard]] double leastOnwards(int node) const;

    const VisitCosts* m_costs;
    std::vector<int> m_firstNode;        ///< n + 2: nodes of layer p are [p] .. [p + 1] - 1
    std::vector<int> m_iceberg;          ///< by node
    std::vector<std::size_t> m_firstArc; ///< nodes + 1
    std::vector<int> m_arcs;             ///< node each arc leads to; its cost follows from its ends
    std::vector<double> m_completion;    ///< by node, of the last sweep
    std::vector<double> m_entry;         ///< completion + cost of the visit - its multiplier
};

/** What `LayeredGraph::refined` made. */
struct Refinement
{
    std::optional<LayeredGraph> graph;
    bool memoryOut = false; ///< no graph because of `GraphLimits::bytes`
};

} // namespace berg
