#pragma once

#include "core/plan/fleet/fleet_costs.h"
#include "core/plan/solve/large_vector.h"
#include "core/plan/solve/layered_graph.h"

#include <optional>
#include <span>
#include <vector>

namespace berg {

struct FleetRefinement;

/**
 * `LayeredGraph` for UAVs that are alike: a root for each of them, and orders that end at any
 * iceberg, or before the first one. The length of a path is the cost of its order - sum lambda over
 * its visits; sum(lambda) + the shortest lengths of all roots of all graphs is a lower bound on the
 * best plan.
 */
class FleetGraph
{
public:
    /** Complete, without memory: O(n^3) arcs. Keeps a reference to `costs`. At most 127 icebergs.
     * Of no use when cut. */
    FleetGraph(const FleetCosts& costs, std::vector<int> uavs, const CutQuestion& cut = {});

    /** Memory of the complete graph, swept and trimmed. */
    [[nodiscard]] static std::int64_t bytesOfComplete(const FleetCosts& costs,
                                                      const std::vector<int>& uavs);

    /** Finds all shortest lengths to an end. False when cut. */
    [[nodiscard]] bool sweep(const Eigen::VectorXd& lambda, const CutQuestion& cut);
    /** Shortest length from a root at the last sweep, at most 0. */
    [[nodiscard]] double shortest(int root) const
    {
        return std::min(0.0, m_completion[static_cast<std::size_t>(root)]);
    }
    /** Of all roots. */
    [[nodiscard]] double shortestSum() const;
    /** That path of the last sweep: icebergs in turn. */
    [[nodiscard]] std::vector<int> shortestPath(int root) const;

    /**
     * Deletes what is on no path that is less than `slack` longer than the shortest of its root.
     * Sweep at the same multipliers first, and again afterwards. False when cut: the graph is of no
     * use any more then.
     */
    [[nodiscard]] bool trim(const Eigen::VectorXd& lambda, double slack, const CutQuestion& cut);

    /**
     * The product of this graph with the memory that `sets` prescribe, less what `trim` would
     * delete. Sweep at the same multipliers first. No graph when it exceeds the limits or when cut.
     */
    [[nodiscard]] FleetRefinement refined(const NgSets& sets, const Eigen::VectorXd& lambda,
                                          double slack, const GraphLimits& limits,
                                          const CutQuestion& cut) const;

    [[nodiscard]] const std::vector<int>& uavs() const { return m_uavs; }
    [[nodiscard]] int rootCount() const { return static_cast<int>(m_uavs.size()); }
    [[nodiscard]] int iceberg(int node) const { return m_iceberg[at(node)]; }
    [[nodiscard]] int nodeCount() const { return static_cast<int>(m_iceberg.size()); }
    [[nodiscard]] std::int64_t arcCount() const { return static_cast<std::int64_t>(m_arcs.size()); }
    [[nodiscard]] std::int64_t bytes() const;
    [[nodiscard]] std::span<const int> successors(int node) const
    {
        return std::span(m_arcs).subspan(m_firstArc[at(node)],
                                         m_firstArc[at(node) + 1] - m_firstArc[at(node)]);
    }
    [[nodiscard]] double leg(int node, int to) const
    {
        return costs(node).leg(iceberg(node), iceberg(to));
    }
    /** From the node before `to`, its visit included, to an end, at the last sweep. */
    [[nodiscard]] double entry(int to) const { return m_entry[at(to)]; }
    /** Cost of the visit of a node in `layer`, less its multiplier. */
    [[nodiscard]] double visit(int node, int layer, const Eigen::VectorXd& lambda) const
    {
        return costs(node).visit(iceberg(node), layer) - lambda(iceberg(node));
    }
    /** What ending at the node costs. */
    [[nodiscard]] double ending(int node) const { return costs(node).leg(iceberg(node), 0); }

private:
    explicit FleetGraph(const FleetCosts& costs) : m_costs(&costs) {}
    [[nodiscard]] static std::size_t at(int k) { return static_cast<std::size_t>(k); }
    /** Of a root's own UAV; beyond the roots all are alike. */
    [[nodiscard]] const UavCosts& costs(int node) const
    {
        return m_costs->of(m_uavs[node < rootCount() ? at(node) : 0]);
    }
    [[nodiscard]] int layers() const { return static_cast<int>(m_firstNode.size()) - 1; }
    /** Calls `look(node, layer)` for each in turn, backwards or not; false when cut. */
    template <class Look>
    bool forNodes(bool backwards, const CutQuestion& cut, const Look& look) const;
    /** By node from its root, less the root's shortest length, its own visit included. */
    [[nodiscard]] std::optional<std::vector<double>> lengths(const Eigen::VectorXd& lambda,
                                                             const CutQuestion& cut) const;

    const FleetCosts* m_costs;
    std::vector<int> m_uavs;             ///< by root; nodes 0 .. are the roots
    std::vector<int> m_firstNode;        ///< layers + 1, layer 0 are the roots
    LargeVector<int> m_iceberg;          ///< by node, 0 for roots
    LargeVector<std::size_t> m_firstArc; ///< nodes + 1
    LargeVector<int> m_arcs;             ///< node each arc leads to
    LargeVector<double> m_completion;    ///< by node, of the last sweep
    LargeVector<double> m_entry;         ///< completion + visit
};

/** What `FleetGraph::refined` made. */
struct FleetRefinement
{
    std::optional<FleetGraph> graph;
    bool memoryOut = false; ///< no graph because of `GraphLimits::bytes`
};

} // namespace berg
