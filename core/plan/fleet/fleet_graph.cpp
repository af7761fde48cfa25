#include "core/plan/fleet/fleet_graph.h"

#include "core/plan/proof/label_table.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace berg {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/** Nodes between two checks for a stop. */
constexpr int kNodesPerCheck = 4096;
/** New number of a node that a trim deletes. */
constexpr int kDeleted = -1;

VisitOrder allowedOf(const FleetCosts& costs, int uav)
{
    VisitOrder allowed;
    for (const NodeIndex i : icebergNodes(costs.icebergs()))
        if (costs.allows(uav, i))
            allowed.push_back(i);
    return allowed;
}

/**
 * Memory of a node of a swept graph; while it is trimmed a node needs `kNodeWhileTrimming` more.
 */
constexpr std::size_t kNode = sizeof(int) + sizeof(std::size_t) + 2 * sizeof(double);
constexpr std::size_t kNodeWhileTrimming = sizeof(int) + sizeof(double);

} // namespace

FleetGraph::FleetGraph(const FleetCosts& costs, std::vector<int> uavs, const StopCheck& isStopped)
    : m_costs(&costs), m_uavs(std::move(uavs))
{
    const VisitOrder allowed = allowedOf(costs, m_uavs.front());
    const int width = static_cast<int>(allowed.size());
    m_iceberg.assign(m_uavs.size(), NodeIndex());
    m_firstNode = {0, rootCount()};
    for (int layer = 1; layer <= width; ++layer) {
        m_iceberg.insert(m_iceberg.end(), allowed.begin(), allowed.end());
        m_firstNode.push_back(nodeCount());
    }
    m_arcs.reserve(at(width) * m_iceberg.size());
    m_firstArc.reserve(m_iceberg.size() + 1);
    for (int layer = 0; layer <= width; ++layer) {
        if (isStopped && isStopped())
            return;
        for (int v = m_firstNode[at(layer)]; v < m_firstNode[at(layer) + 1]; ++v) {
            m_firstArc.push_back(m_arcs.size());
            const int next = m_firstNode[at(layer) + 1];
            for (int to = next; layer < width && to < next + width; ++to)
                if (iceberg(to) != iceberg(v))
                    m_arcs.push_back(to);
        }
    }
    m_firstArc.push_back(m_arcs.size());
}

std::int64_t FleetGraph::bytesOfComplete(const FleetCosts& costs, const std::vector<int>& uavs)
{
    const std::size_t width = allowedOf(costs, uavs.front()).size();
    const std::size_t nodes = width * width + uavs.size();
    return static_cast<std::int64_t>(nodes * (width * sizeof(int) + kNode + kNodeWhileTrimming));
}

std::int64_t FleetGraph::bytes() const
{
    return static_cast<std::int64_t>(m_arcs.capacity() * sizeof(int) + m_iceberg.size() * kNode);
}

template <class Visitor>
bool FleetGraph::forNodes(bool backwards, const StopCheck& isStopped, const Visitor& visitor) const
{
    for (int k = 0; k < layers(); ++k) {
        const int layer = backwards ? layers() - 1 - k : k;
        const int begin = m_firstNode[at(layer)];
        const int end = m_firstNode[at(layer) + 1];
        for (int v = begin; v < end; ++v) {
            if ((v - begin) % kNodesPerCheck == 0 && isStopped && isStopped())
                return false;
            visitor(v, layer);
        }
    }
    return true;
}

bool FleetGraph::sweep(const Eigen::VectorXd& lambda, const StopCheck& isStopped)
{
    m_completion.resize(m_iceberg.size());
    m_entry.resize(m_iceberg.size());
    return forNodes(true, isStopped, [&](int v, int layer) {
        const double* const legs = costs(v).legsFrom(iceberg(v));
        double least = ending(v); // 0 at a root
        for (const int to : successors(v))
            least = std::min(least, legs[iceberg(to).number()] + m_entry[at(to)]);
        m_completion[at(v)] = least;
        m_entry[at(v)] = layer > 0 ? least + visit(v, layer, lambda) : least;
    });
}

double FleetGraph::shortestSum() const
{
    double sum = 0;
    for (int root = 0; root < rootCount(); ++root)
        sum += shortest(root);
    return sum;
}

VisitOrder FleetGraph::shortestPath(int root) const
{
    VisitOrder path;
    for (int v = root;;) {
        double least = ending(v);
        std::optional<int> next;
        for (const int to : successors(v))
            if (const double length = leg(v, to) + entry(to); length < least) {
                least = length;
                next = to;
            }
        if (!next)
            return path;
        path.push_back(iceberg(*next));
        v = *next;
    }
}

std::optional<std::vector<double>> FleetGraph::lengths(const Eigen::VectorXd& lambda,
                                                       const StopCheck& isStopped) const
{
    std::vector<double> length(m_iceberg.size(), kInfinity);
    for (int root = 0; root < rootCount(); ++root)
        length[at(root)] = -shortest(root);
    const bool done = forNodes(false, isStopped, [&](int v, int layer) {
        double& here = length[at(v)];
        if (layer > 0)
            here += visit(v, layer, lambda);
        for (const int to : successors(v))
            length[at(to)] = std::min(length[at(to)], here + leg(v, to));
    });
    return done ? std::optional(std::move(length)) : std::nullopt;
}

bool FleetGraph::trim(const Eigen::VectorXd& lambda, double slack, const StopCheck& isStopped)
{
    const std::optional<std::vector<double>> length = lengths(lambda, isStopped);
    if (!length)
        return false;
    std::vector<int> id(m_iceberg.size(), kDeleted);
    std::vector<int> firstNode{0};
    int kept = 0;
    for (int layer = 0; layer < layers(); ++layer) {
        for (int v = m_firstNode[at(layer)]; v < m_firstNode[at(layer) + 1]; ++v)
            if (layer == 0 || (*length)[at(v)] + m_completion[at(v)] < slack)
                id[at(v)] = kept++;
        if (kept == firstNode.back())
            break;
        firstNode.push_back(kept);
    }
    std::size_t arcs = 0;
    const bool done = forNodes(false, isStopped, [&](int v, int) {
        if (id[at(v)] == kDeleted)
            return;
        const std::size_t begin = m_firstArc[at(v)];
        const std::size_t end = m_firstArc[at(v) + 1];
        const std::size_t newBegin = arcs;
        for (std::size_t a = begin; a < end; ++a) {
            const int to = m_arcs[a];
            if (id[at(to)] != kDeleted && (*length)[at(v)] + leg(v, to) + entry(to) < slack)
                m_arcs[arcs++] = id[at(to)];
        }
        m_firstArc[at(v)] = newBegin;
    });
    if (!done)
        return false;
    // The new numbers never overtake the old ones, which `leg` has read so far.
    for (std::size_t v = 0; v < id.size(); ++v)
        if (id[v] != kDeleted) {
            m_iceberg[at(id[v])] = m_iceberg[v];
            m_firstArc[at(id[v])] = m_firstArc[v];
        }
    m_firstNode = std::move(firstNode);
    m_arcs.resize(arcs);
    if (m_arcs.capacity() > 2 * arcs)
        m_arcs.shrink_to_fit(); // the graphs of many UAVs share the memory
    m_iceberg.resize(at(kept));
    m_firstArc.resize(at(kept) + 1);
    m_firstArc[at(kept)] = arcs;
    return true;
}

FleetRefinement FleetGraph::refined(const NgSets& sets, const Eigen::VectorXd& lambda, double slack,
                                    const GraphLimits& limits, const StopCheck& isStopped) const
{
    FleetGraph result(*m_costs);
    result.m_uavs = m_uavs;
    result.m_firstNode.push_back(0);
    LabelTables tables(1);
    for (int root = 0; root < rootCount(); ++root)
        tables.offer(0, {.memory = {}, .length = -shortest(root), .node = root});
    for (int layer = 0; layer < layers(); ++layer) {
        int examined = 0;
        for (const LabelTable::Label& label : tables.at(layer).labels()) {
            if (examined++ % kNodesPerCheck == 0 && isStopped && isStopped())
                return {};
            const int v = label.node;
            const double length = label.length + (layer > 0 ? visit(v, layer, lambda) : 0.0);
            const NodeSet visited = layer > 0 ? label.memory.with(iceberg(v)) : label.memory;
            result.m_iceberg.push_back(iceberg(v));
            result.m_firstArc.push_back(result.m_arcs.size());
            for (const int to : successors(v)) {
                const double there = length + leg(v, to);
                if (label.memory.contains(iceberg(to)) || there + entry(to) >= slack)
                    continue;
                const NodeSet memory = visited & sets.at(layer + 1, iceberg(to));
                result.m_arcs.push_back(
                    tables.offer(layer + 1, {.memory = memory, .length = there, .node = to}));
            }
        }
        tables.at(layer).clear();
        if (result.nodeCount() == result.m_firstNode.back())
            break;
        result.m_firstNode.push_back(result.nodeCount());
        if (result.bytes() > limits.bytes)
            return {.graph = {}, .memoryOut = true};
        if (result.arcCount() > limits.arcs)
            return {};
    }
    result.m_firstArc.push_back(result.m_arcs.size());
    return {.graph = std::move(result)};
}

} // namespace berg
