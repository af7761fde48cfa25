#include "core/plan/proof/layered_bound.h"

#include "core/base/error.h"
#include "core/plan/proof/graph_search.h"
#include "core/plan/proof/layered_graph.h"
#include "core/plan/proof/multiplier_ascent.h"
#include "core/plan/proof/ng_memory.h"
#include "core/plan/proof/piece_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>

namespace berg {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/**
 * Steps of the multipliers: before the first suggestion, at least in total without a graph, on the
 * first graph, on later graphs.
 */
constexpr std::int64_t kFirstSteps = 10;
constexpr std::int64_t kPlainSteps = 80;
constexpr int kFirstGraphSteps = 60;
constexpr int kLaterSteps = 20;
/** Work counts the arcs of a sweep as 1; the other weights were measured. */
constexpr std::int64_t kWorkOfNode = 3;
constexpr std::int64_t kWorkOfRefining = 10;
constexpr std::int64_t kWorkOfSearching = 25;
/** Number of last relaxed paths whose cycles make the memory grow. */
constexpr std::size_t kRecentPaths = 20;
/** Largest width of the exact search, relative to the usual one. */
constexpr int kWidest = 1024;
/**
 * Gaps certified first when the graph gets large: few orders can beat the order by that much, and
 * they are soon deleted.
 */
constexpr std::array kStages{0.005, 0.002};

/** Returns the arcs of a graph without their memories, sorted. */
std::vector<MilpArc> arcsOf(const LayeredGraph<VisitCosts>& graph)
{
    std::vector<MilpArc> arcs;
    const auto less = [](const MilpArc& a, const MilpArc& b) {
        return std::tie(a.position, a.from, a.to) < std::tie(b.position, b.from, b.to);
    };
    int node = 0;
    for (int p = 0; p < graph.icebergs(); ++p) {
        const std::size_t begin = arcs.size();
        for (const int end = graph.layerEnd(p); node < end; ++node)
            for (const int to : graph.successors(node))
                arcs.push_back({graph.iceberg(node), graph.iceberg(to), p + 1});
        const auto first = arcs.begin() + static_cast<std::ptrdiff_t>(begin);
        std::sort(first, arcs.end(), less);
        arcs.erase(std::unique(first, arcs.end()), arcs.end());
    }
    return arcs;
}

/**
 * A graph, the memory for its next refinement, and the multipliers it was made with. Copies share
 * the graph, which its refinement replaces.
 */
template <class Costs>
struct Stage
{
    std::shared_ptr<LayeredGraph<Costs>> graph;
    NgSets sets;
    int cap = 0; ///< largest number of icebergs in a memory
    MultiplierAscent ascent;
};

/** Runs `improveBound`: an incumbent, a bound, and a graph of the orders that may lie between. */
template <class Costs>
class LayeredBoundSearch
{
public:
    LayeredBoundSearch(const Costs& costs, const VisitOrder& order,
                       const LayeredBoundOptions& options)
        : m_costs(costs)
        , m_options(options)
        , m_cost(costs.total(order))
        , m_ascent(options.lambda ? *options.lambda : firstMultipliers(costs, order))
    {
        require(!options.lambda || options.lambda->size() == costs.icebergs + 1,
                "improveBound: needs one multiplier for each node");
        m_result.order = order;
    }

    BoundResult run()
    {
        LayeredPaths<Costs> paths(m_costs);
        relax(paths, kFirstSteps);
        acceptSuggestion();
        m_gap = m_options.gap;
        acceptBound(m_result.bound);
        relax(paths, plainSteps() - kFirstSteps);
        if (!finished() && m_costs.icebergs < NodeSet::kCapacity)
            tighten(paths);
        reportStep();
        m_result.lambda = m_ascent.best();
        return std::move(m_result);
    }

    std::vector<MilpArc> arcs()
    {
        m_keepEqual = true;
        LayeredPaths<Costs> paths(m_costs);
        relax(paths, plainSteps());
        Stage<Costs> stage = firstStage(paths);
        if (isStopped())
            return allPositionArcs(m_costs.icebergs);
        std::vector<MilpArc> arcs = arcsOf(*stage.graph);
        if (m_costs.icebergs >= NodeSet::kCapacity)
            return arcs;
        constexpr double kPays = 0.98;
        for (bool pays = true; pays && !finished() && refine(stage, 0);) {
            ascend(*stage.graph);
            if (m_stopped)
                break;
            std::vector<MilpArc> fewer = arcsOf(*stage.graph);
            pays = m_graphs == 1 ||
                   static_cast<double>(fewer.size()) < kPays * static_cast<double>(arcs.size());
            arcs = std::move(fewer);
            forbidCycles(stage.sets, m_costs, m_recent, ++stage.cap);
        }
        return arcs;
    }

private:
    /** After a poor order the multipliers may be so large that rounding hides the cost. */
    void renewMultipliers()
    {
        if (!allowsProof(best().margin, m_cost))
            m_ascent = MultiplierAscent(firstMultipliers(m_costs, m_result.order));
    }
    /** Returns the cost from which orders are of no interest. */
    [[nodiscard]] double cutoff() const
    {
        return m_keepEqual ? cutoffAbove(m_cost) : cutoffBelow(m_cost, m_gap);
    }
    [[nodiscard]] Multipliers here() const
    {
        return certifiedMultipliers(m_ascent.here(), cutoff());
    }
    [[nodiscard]] Multipliers best() const
    {
        return certifiedMultipliers(m_ascent.best(), cutoff());
    }
    bool isStopped()
    {
        m_stopped = m_stopped || (m_options.isStopped && m_options.isStopped());
        return m_stopped;
    }
    bool finished()
    {
        return m_result.reached || m_result.memoryOut || m_workOut ||
               m_result.work >= m_options.workLimit || isStopped();
    }
    [[nodiscard]] StopCheck stopCheck()
    {
        return [this] { return isStopped(); };
    }
    [[nodiscard]] std::int64_t plainSteps() const
    {
        // The order of magnitude of a bound matters more than its last tenth.
        return m_options.lambda ? m_options.warmSteps
                                : std::max<std::int64_t>(kPlainSteps, 2 * m_costs.icebergs);
    }

    [[nodiscard]] static std::int64_t workOfSweep(const LayeredGraph<Costs>& graph)
    {
        return graph.arcCount() + kWorkOfNode * graph.nodeCount();
    }

    /** Accepts a certified lower bound on all orders below the cutoff. */
    void acceptBound(double bound)
    {
        bound = std::max(bound, 0.0); // no cost is negative
        if (bound >= cutoff()) {
            m_result.bound = std::max(m_result.bound, cutoff());
            m_stageDone = true;
            m_result.reached = m_gap <= m_options.gap;
        } else {
            m_result.bound = std::max(m_result.bound, bound);
        }
    }
    /** Accepts an order; returns whether it is better. */
    bool acceptOrder(const VisitOrder& order)
    {
        const double cost = m_costs.total(order);
        if (m_keepEqual || !replaces(cost, m_cost))
            return false;
        m_cost = cost;
        m_result.order = order;
        return true;
    }
    void acceptPath(const std::vector<int>& path)
    {
        NodeSet visited;
        for (const int i : path) {
            if (i >= NodeSet::kCapacity || visited.contains(i))
                return;
            visited.insert(i);
        }
        if (acceptOrder(path))
            report();
    }
    void acceptSuggestion()
    {
        if (!m_options.suggest || finished())
            return;
        const OrderSuggestion found =
            m_options.suggest(m_result.work, m_options.workLimit - m_result.work);
        m_result.work += found.work;
        if (!found.order.empty() && acceptOrder(found.order))
            report();
    }
    void report() const
    {
        if (m_options.onImproved && !m_keepEqual)
            m_options.onImproved(m_result.order, m_result.bound);
    }

    void relax(LayeredPaths<Costs>& paths, std::int64_t steps)
    {
        renewMultipliers();
        for (std::int64_t k = 0; k < steps && !finished(); ++k) {
            const Multipliers multipliers = here();
            const double bound = paths.sweep(multipliers, stopCheck());
            m_result.work += paths.workOfSweep();
            if (!std::isfinite(bound))
                return;
            if (!climb(paths.shortestPath(), bound, multipliers.margin))
                break;
            if (k % kFirstSteps == 0)
                report();
        }
        report();
    }

    /**
     * Accepts the result of a sweep at the multipliers `here`; returns false if there are no better
     * ones.
     */
    bool climb(std::vector<int> path, double bound, double margin)
    {
        acceptPath(path);
        const bool steps =
            m_ascent.step({.visits = std::move(path), .bound = bound, .margin = margin}, m_cost);
        acceptBound(m_ascent.bound());
        return steps;
    }

    /** Returns the graph without memory, and the memory to begin with. */
    Stage<Costs> firstStage(LayeredPaths<Costs>& paths)
    {
        const std::int64_t n = m_costs.icebergs;
        const int nearest = n <= 50 ? 3 : 2; // large graphs must grow slowly
        const Multipliers multipliers = best();
        paths.sweep(multipliers, stopCheck());
        m_result.work += 4 * paths.workOfSweep();
        reportStep();
        return {.graph = shared(LayeredGraph(m_costs, paths, multipliers, stopCheck())),
                .sets = nearestSets(m_costs, nearest),
                .cap = nearest,
                .ascent = m_ascent};
    }

    /**
     * Reports a step of the proof: arcs have been deleted at the best multipliers, or nothing below
     * the cutoff is left.
     */
    void reportStep(const NgSets* sets = nullptr) const
    {
        if (m_options.onStep)
            m_options.onStep({.lambda = m_ascent.best(),
                              .sets = sets ? std::make_shared<const NgSets>(*sets) : nullptr});
    }

    [[nodiscard]] static std::shared_ptr<LayeredGraph<Costs>> shared(LayeredGraph<Costs>&& graph)
    {
        return {new LayeredGraph<Costs>(std::move(graph)), DeferredDeleter()};
    }

    /** Repeats refining, ascent, exact search and memory growth. */
    void tighten(LayeredPaths<Costs>& paths)
    {
        Stage<Costs> stage = firstStage(paths);
        std::optional<Stage<Costs>> saved; // stage from which the next gap is certified
        bool staged = false;
        while (!finished()) {
            if (!staged && !m_options.onStep && isLarge(*stage.graph)) {
                staged = true;
                m_gap = nextGap();
                if (m_gap > m_options.gap) {
                    stage.ascent = m_ascent;
                    saved = stage;
                }
            }
            const std::int64_t saved_bytes = saved ? saved->graph->bytes() : 0;
            if (!refine(stage, saved && saved->graph != stage.graph ? saved_bytes : 0))
                return;
            ascend(*stage.graph);
            if (!finished() && !m_stageDone)
                searchIn(*stage.graph, saved_bytes);
            report();
            acceptSuggestion();
            if (finished())
                return;
            if (m_stageDone) {
                m_stageDone = false;
                m_gap = nextGap();
                stage = *saved;
                m_ascent = stage.ascent;
                if (m_gap == m_options.gap)
                    saved.reset();
            } else {
                forbidCycles(stage.sets, m_costs, m_recent, ++stage.cap);
            }
        }
    }

    /** Returns whether the graph is so large that other gaps are certified first. */
    [[nodiscard]] bool isLarge(const LayeredGraph<Costs>& graph) const
    {
        constexpr std::int64_t kMemoryShare = 20;
        return graph.arcCount() > m_options.manyArcs ||
               graph.bytes() > m_options.memoryLimit_bytes / kMemoryShare;
    }

    /** Returns the next gap worth certifying. */
    [[nodiscard]] double nextGap() const
    {
        for (const double gap : kStages)
            if (gap > m_options.gap && m_result.bound < m_cost * (1 - gap))
                return gap;
        return m_options.gap;
    }

    /**
     * Refines the graph of a stage. Returns false if stopped, or if the refined graph would exceed
     * the limits.
     */
    bool refine(Stage<Costs>& stage, std::int64_t otherBytes)
    {
        constexpr std::int64_t kGrowth = 3; // growth of vectors, and memory of the search
        const Multipliers multipliers = best();
        stage.graph->sweep(multipliers, stopCheck());
        if (isStopped())
            return false;
        const std::int64_t left = m_options.workLimit - m_result.work;
        const std::int64_t left_bytes =
            m_options.memoryLimit_bytes - stage.graph->bytes() - otherBytes;
        Refinement<Costs> refined = stage.graph->refined(
            stage.sets, multipliers,
            {.arcs = left / (kWorkOfRefining + kLaterSteps), .bytes = left_bytes / kGrowth},
            stopCheck());
        m_result.memoryOut = refined.memoryOut;
        m_workOut = !refined.graph;
        if (!refined.graph)
            return false;
        stage.graph = shared(std::move(*refined.graph));
        reportStep(&stage.sets);
        m_result.work += kWorkOfRefining * workOfSweep(*stage.graph);
        ++m_graphs;
        return true;
    }

    void ascend(LayeredGraph<Costs>& graph)
    {
        const int steps = m_graphs == 1 ? kFirstGraphSteps : kLaterSteps;
        renewMultipliers();
        m_ascent.restart();
        m_recent.clear();
        for (int k = 0; k < steps && !finished() && !m_stageDone; ++k) {
            const Multipliers multipliers = here();
            const double bound = graph.sweep(multipliers, stopCheck());
            m_result.work += workOfSweep(graph);
            if (isStopped())
                return;
            std::vector<int> path = graph.shortestPath();
            if (path.empty()) {
                acceptBound(kInfinity); // nothing below the cutoff is left
                return;
            }
            m_recent.push_back(path);
            if (m_recent.size() > kRecentPaths)
                m_recent.erase(m_recent.begin());
            if (!climb(std::move(path), bound, multipliers.margin)) {
                // Only the exact search can close the remaining gap.
                m_width = std::min(2 * m_width, kWidest);
                break;
            }
            // Early steps gain most, so the graph is trimmed sooner after them.
            if (k == 0 || k % 20 == 6)
                trim(graph);
        }
        if (!finished())
            trim(graph);
    }

    void trim(LayeredGraph<Costs>& graph)
    {
        const Multipliers multipliers = best();
        graph.sweep(multipliers, stopCheck());
        if (!isStopped() && !graph.trim(multipliers, stopCheck()))
            m_stopped = true;
        reportStep();
        m_result.work += 3 * workOfSweep(graph);
    }

    void searchIn(LayeredGraph<Costs>& graph, std::int64_t otherBytes)
    {
        const Multipliers multipliers = best();
        graph.sweep(multipliers, stopCheck());
        if (isStopped())
            return;
        // Half the mean width of the graph takes the work of a few sweeps.
        const int states = m_width * std::max(100, graph.nodeCount() / (2 * m_costs.icebergs));
        const GraphSearchResult found =
            searchGraph(graph, multipliers,
                        {.mostStates = states,
                         .memory_bytes = m_options.memoryLimit_bytes - graph.bytes() - otherBytes,
                         .isStopped = stopCheck()});
        m_result.work += kWorkOfSearching * found.work;
        if (!found.order.empty())
            acceptOrder(found.order);
        acceptBound(multipliers.certified(found.bound));
    }

    const Costs& m_costs;
    const LayeredBoundOptions& m_options;
    BoundResult m_result;
    double m_cost; ///< cost of `m_result.order`
    MultiplierAscent m_ascent;
    std::vector<std::vector<int>> m_recent; ///< relaxed paths of the last steps
    double m_gap = 0;                       ///< gap that is being certified
    int m_graphs = 0;                       ///< number of graphs refined so far
    int m_width = 1;                        ///< width of the exact search, in usual widths
    bool m_stageDone = false;               ///< whether `m_gap` has been certified
    bool m_keepEqual = false; ///< whether arcs of orders as good as the given one stay
    bool m_workOut = false;   ///< whether the remaining work does not suffice for a refined graph
    bool m_stopped = false;
};

} // namespace

template <class Costs>
BoundResult improveBound(const Costs& costs, const VisitOrder& order,
                         const LayeredBoundOptions& options)
{
    return LayeredBoundSearch(costs, order, options).run();
}

template BoundResult improveBound(const VisitCosts&, const VisitOrder&, const LayeredBoundOptions&);
template BoundResult improveBound(const LatencyCosts&, const VisitOrder&,
                                  const LayeredBoundOptions&);

std::vector<MilpArc> survivingArcs(const VisitCosts& costs, const VisitOrder& order,
                                   const LayeredBoundOptions& options)
{
    return LayeredBoundSearch(costs, order, options).arcs();
}

} // namespace berg
