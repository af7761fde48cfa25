#pragma once

#include "core/plan/fleet/fleet_costs.h"
#include "core/plan/proof/large_vector.h"
#include "core/plan/proof/layered_graph.h"

#include <optional>
#include <span>
#include <vector>

namespace berg {

struct FleetRefinement;

/**
 * `LayeredGraph` for UAVs that are alike: it has a root for each of them, and orders may end at any
 * iceberg, or before the first one. The length of a path is the cost of its order - sum lambda over
 * its visits; sum(lambda) + the shortest lengths of all roots of all graphs is a lower bound on the
 * best plan.
 */
class FleetGraph
{
public:
    /**
     * Builds the complete graph without memory: O(n^3) arcs, at most 127 icebergs. `uavs` must be
     * one of the groups of `FleetCosts::alike`. Keeps a reference to `costs`. The graph is unusable
     * if stopped.
     */
    FleetGraph(const FleetCosts& costs, std::vector<int> uavs, const StopCheck& isStopped = {});

    /** Returns the memory, bytes, of the complete graph while it is swept and trimmed. */
    [[nodiscard]] static std::int64_t bytesOfComplete(const FleetCosts& costs,
                                                      const std::vector<int>& uavs);

    /** Finds all shortest lengths to an end. Returns false if stopped. */
    [[nodiscard]] bool sweep(const Eigen::VectorXd& lambda, const StopCheck& isStopped);
    /** Returns the shortest length from a root at the last sweep, at most 0. */
    [[nodiscard]] double shortest(int root) const
    {
        return std::min(0.0, m_completion[static_cast<std::size_t>(root)]);
    }
    /** Returns the sum of the shortest lengths of all roots. */
    [[nodiscard]] double shortestSum() const;
    /** Returns the shortest path from a root at the last sweep: icebergs in visiting order. */
    [[nodiscard]] VisitOrder shortestPath(int root) const;

    /**
     * Deletes everything that is on no path less than `slack` longer than the shortest of its root.
     * Sweep at the same multipliers before, and again afterwards. Returns false if stopped: the
     * graph is then unusable.
     */
    [[nodiscard]] bool trim(const Eigen::VectorXd& lambda, double slack,
                            const StopCheck& isStopped);

    /**
     * Returns the product of this graph with the memory that `sets` prescribe, without the parts
     * that `trim` would delete. Sweep at the same multipliers first. Returns no graph if it would
     * exceed the limits, or if stopped.
     */
    [[nodiscard]] FleetRefinement refined(const NgSets& sets, const Eigen::VectorXd& lambda,
                                          double slack, const GraphLimits& limits,
                                          const StopCheck& isStopped) const;

    /** Returns the UAVs by root. */
    [[nodiscard]] const std::vector<int>& uavs() const { return m_uavs; }
    [[nodiscard]] int rootCount() const { return static_cast<int>(m_uavs.size()); }
    /** Returns the iceberg of a node of the graph; 0 for a root. */
    [[nodiscard]] NodeIndex iceberg(int node) const { return m_iceberg[at(node)]; }
    [[nodiscard]] int nodeCount() const { return static_cast<int>(m_iceberg.size()); }
    [[nodiscard]] std::int64_t arcCount() const { return static_cast<std::int64_t>(m_arcs.size()); }
    /** Returns the memory in use, bytes. */
    [[nodiscard]] std::int64_t bytes() const;
    /** Returns the nodes that may follow `node`. */
    [[nodiscard]] std::span<const int> successors(int node) const
    {
        return std::span(m_arcs).subspan(m_firstArc[at(node)],
                                         m_firstArc[at(node) + 1] - m_firstArc[at(node)]);
    }
    /** Returns the cost of the leg between two nodes. */
    [[nodiscard]] double leg(int node, int to) const
    {
        return costs(node).leg(iceberg(node), iceberg(to));
    }
    /** Returns the length from `to`, its visit included, to an end, at the last sweep. */
    [[nodiscard]] double entry(int to) const { return m_entry[at(to)]; }
    /** Returns the cost of the visit of a node in `layer`, less its multiplier. */
    [[nodiscard]] double visit(int node, int layer, const Eigen::VectorXd& lambda) const
    {
        return costs(node).visit(iceberg(node), layer) - lambda(iceberg(node).number());
    }
    /** Returns the cost of ending at the node. */
    [[nodiscard]] double ending(int node) const { return costs(node).leg(iceberg(node), 0); }

private:
    explicit FleetGraph(const FleetCosts& costs) : m_costs(&costs) {}
    [[nodiscard]] static std::size_t at(int k) { return static_cast<std::size_t>(k); }
    /** Returns the costs of a root's own UAV; beyond the roots all UAVs are alike. */
    [[nodiscard]] const UavCosts& costs(int node) const
    {
        return m_costs->of(m_uavs[node < rootCount() ? at(node) : 0]);
    }
    [[nodiscard]] int layers() const { return static_cast<int>(m_firstNode.size()) - 1; }
    /**
     * Calls `visitor(node, layer)` for each node in order, backwards or not. Returns false if
     * stopped.
     */
    template <class Visitor>
    bool forNodes(bool backwards, const StopCheck& isStopped, const Visitor& visitor) const;
    /**
     * Returns by node the length from its root, less the root's shortest length, its own visit
     * included. Returns nullopt if stopped.
     */
    [[nodiscard]] std::optional<std::vector<double>> lengths(const Eigen::VectorXd& lambda,
                                                             const StopCheck& isStopped) const;

    const FleetCosts* m_costs;
    std::vector<int> m_uavs;             ///< by root; the first nodes are the roots
    std::vector<int> m_firstNode;        ///< layers + 1; layer 0 holds the roots
    LargeVector<NodeIndex> m_iceberg;    ///< by node; 0 for roots
    LargeVector<std::size_t> m_firstArc; ///< nodes + 1
    LargeVector<int> m_arcs;             ///< node each arc leads to
    LargeVector<double> m_completion;    ///< by node, at the last sweep
    LargeVector<double> m_entry;         ///< completion + visit
};

/** Result of `FleetGraph::refined`. */
struct FleetRefinement
{
    std::optional<FleetGraph> graph;
    bool memoryOut = false; ///< whether there is no graph because of `GraphLimits::bytes`
};

} // namespace berg
