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
/** Steps of the multipliers; without memory at least. */
constexpr BoundSteps kSteps{.plain = 80, .firstGraph = 60, .later = 20, .trimsAtOnce = true};
/** `kWorkOfRefining` for a state of the exact search. */
constexpr std::int64_t kWorkOfSearching = 25;
/** The exact search is twice as wide after each ascent to the top, at most this many times. */
constexpr int kMostDoublings = 10;
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

template <class Costs>
BoundSteps stepsFor(const Costs& costs, const LayeredBoundOptions& layered)
{
    BoundSteps steps = kSteps;
    // The order of magnitude of a bound matters more than its last tenth.
    steps.plain = layered.lambda ? layered.warmSteps : std::max(steps.plain, 2 * costs.icebergs);
    return steps;
}

/** Runs `improveBound`. */
template <class Costs>
class LayeredBoundSearch final : BoundLoop
{
public:
    LayeredBoundSearch(const Costs& costs, const VisitOrder& order, const BoundOptions& options,
                       const LayeredBoundOptions& layered)
        : BoundLoop(options, {order}, costs.total(order),
                    layered.lambda ? *layered.lambda : firstMultipliers(costs, order),
                    stepsFor(costs, layered))
        , m_costs(costs)
        , m_layered(layered)
        , m_paths(costs)
    {
        require(!layered.lambda || layered.lambda->size() == costs.icebergs + 1,
                "improveBound: needs one multiplier for each node");
    }

    BoundResult improve()
    {
        BoundResult result = run();
        reportStep();
        return result;
    }

    std::vector<MilpArc> arcs()
    {
        m_keepEqual = true;
        relax(m_steps.plain);
        m_stage = firstStage();
        if (isStopped())
            return allPositionArcs(m_costs.icebergs);
        std::vector<MilpArc> arcs = arcsOf(*m_stage->graph);
        constexpr double kPays = 0.98;
        for (bool pays = true; pays && !finished() && climbOnNextGraph();) {
            if (m_stopped)
                break;
            std::vector<MilpArc> fewer = arcsOf(*m_stage->graph);
            pays = m_rounds == 1 ||
                   static_cast<double>(fewer.size()) < kPays * static_cast<double>(arcs.size());
            arcs = std::move(fewer);
            addMemory();
        }
        return arcs;
    }

private:
    [[nodiscard]] double costOf(const FleetPlan& plan) const override
    {
        return m_costs.total(plan.front());
    }
    void renewMultipliers() override
    {
        if (!allowsProof(best().margin, m_cost))
            m_ascent = MultiplierAscent(firstMultipliers(m_costs, m_result.plan.front()));
    }
    [[nodiscard]] Multipliers here() const
    {
        return certifiedMultipliers(m_ascent.here(), cutoff());
    }
    [[nodiscard]] Multipliers best() const
    {
        return certifiedMultipliers(m_ascent.best(), cutoff());
    }
    void relax(int steps) override
    {
        renewMultipliers();
        for (int k = 0; k < steps && !finished(); ++k) {
            const Multipliers multipliers = here();
            const double bound = m_paths.sweep(multipliers, m_stopCheck);
            m_result.work += m_paths.workOfSweep();
            if (!std::isfinite(bound))
                return;
            if (!climb({{m_paths.shortestPath()}, bound, multipliers.margin}))
                break;
            if (k % 10 == 0)
                report();
        }
        report();
    }

    /** Returns the graph without memory, and the memory to begin with. */
    Stage<Costs> firstStage()
    {
        const std::int64_t n = m_costs.icebergs;
        const int nearest = n <= 50 ? 3 : 2; // large graphs must grow slowly
        const Multipliers multipliers = best();
        m_paths.sweep(multipliers, m_stopCheck);
        m_result.work += 4 * m_paths.workOfSweep();
        reportStep();
        return {.graph = shared(LayeredGraph(m_costs, m_paths, multipliers, m_stopCheck)),
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
        if (m_layered.onStep)
            m_layered.onStep({.lambda = m_ascent.best(),
                              .sets = sets ? std::make_shared<const NgSets>(*sets) : nullptr});
    }

    [[nodiscard]] static std::shared_ptr<LayeredGraph<Costs>> shared(LayeredGraph<Costs>&& graph)
    {
        return {new LayeredGraph<Costs>(std::move(graph)), DeferredDeleter()};
    }

    /** Returns whether the graph is so large that other gaps are certified first. */
    [[nodiscard]] bool isLarge(const LayeredGraph<Costs>& graph) const
    {
        constexpr std::int64_t kMemoryShare = 20;
        return graph.arcCount() > m_layered.manyArcs ||
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

    bool refine() override
    {
        if (m_costs.icebergs >= NodeSet::kCapacity)
            return false;
        if (!m_stage) {
            m_stage = firstStage();
            if (finished())
                return false;
        }
        if (!m_isStaged && !m_layered.onStep && !m_keepEqual && isLarge(*m_stage->graph)) {
            m_isStaged = true;
            m_gap = nextGap();
            if (m_gap > m_options.gap) {
                m_stage->ascent = m_ascent;
                m_saved = std::make_unique<Stage<Costs>>(*m_stage);
            }
        }
        constexpr std::int64_t kGrowth = 3; // growth of vectors, and memory of the search
        const Multipliers multipliers = best();
        m_stage->graph->sweep(multipliers, m_stopCheck);
        if (isStopped())
            return false;
        const std::int64_t left = m_options.workLimit - m_result.work;
        Refinement<Costs> refined = m_stage->graph->refined(
            m_stage->sets, multipliers,
            {.arcs = left / (kWorkOfRefining + kSteps.later), .bytes = left_bytes() / kGrowth},
            m_stopCheck);
        m_result.memoryOut = refined.memoryOut;
        if (!refined.graph)
            return false;
        m_stage->graph = shared(std::move(*refined.graph));
        reportStep(&m_stage->sets);
        m_result.work += kWorkOfRefining * workOfSweep(*m_stage->graph);
        return true;
    }

    /** Returns the memory that the graphs leave. */
    [[nodiscard]] std::int64_t left_bytes() const
    {
        const bool isOther = m_saved && m_saved->graph != m_stage->graph;
        return m_options.memoryLimit_bytes - m_stage->graph->bytes() -
               (isOther ? m_saved->graph->bytes() : 0);
    }

    std::optional<MultiplierAscent::Relaxed> sweepHere() override
    {
        LayeredGraph<Costs>& graph = *m_stage->graph;
        const Multipliers multipliers = here();
        const double bound = graph.sweep(multipliers, m_stopCheck);
        m_result.work += workOfSweep(graph);
        if (isStopped())
            return std::nullopt;
        VisitOrder path = graph.shortestPath();
        if (path.empty()) {
            acceptBound(kInfinity); // nothing below the cutoff is left
            return std::nullopt;
        }
        remember(path);
        return MultiplierAscent::Relaxed{{std::move(path)}, bound, multipliers.margin};
    }

    void trim() override
    {
        LayeredGraph<Costs>& graph = *m_stage->graph;
        const Multipliers multipliers = best();
        graph.sweep(multipliers, m_stopCheck);
        if (!isStopped() && !graph.trim(multipliers, m_stopCheck))
            m_stopped = true;
        reportStep();
        m_result.work += 3 * workOfSweep(graph);
    }

    void searchOrders() override
    {
        LayeredGraph<Costs>& graph = *m_stage->graph;
        const Multipliers multipliers = best();
        graph.sweep(multipliers, m_stopCheck);
        if (isStopped())
            return;
        // Half the mean width of the graph takes the work of a few sweeps. At the top only a wider
        // search can close the remaining gap.
        const int width = 1 << std::min(m_tops, kMostDoublings);
        const int states = width * std::max(100, graph.nodeCount() / (2 * m_costs.icebergs));
        const GraphSearchResult found = searchGraph(
            graph, multipliers,
            {.mostStates = states, .memory_bytes = left_bytes(), .isStopped = m_stopCheck});
        m_result.work += kWorkOfSearching * found.work;
        if (!found.order.empty())
            acceptPlan({found.order});
        acceptBound(multipliers.certified(found.bound));
    }

    void endRound() override
    {
        if (finished())
            return;
        if (!m_gapReached) {
            addMemory();
            return;
        }
        m_gapReached = false;
        m_gap = nextGap();
        m_stage = *m_saved;
        m_ascent = m_stage->ascent;
        if (m_gap == m_options.gap)
            m_saved.reset();
    }
    void addMemory() { forbidCycles(m_stage->sets, m_costs, m_recent, ++m_stage->cap); }

    const Costs& m_costs;
    const LayeredBoundOptions& m_layered;
    LayeredPaths<Costs> m_paths;
    std::optional<Stage<Costs>> m_stage;   ///< once there is a graph
    std::unique_ptr<Stage<Costs>> m_saved; ///< stage from which the next gap is certified
    bool m_isStaged = false;               ///< whether other gaps are certified first
};

} // namespace

template <class Costs>
BoundResult improveBound(const Costs& costs, const VisitOrder& order, const BoundOptions& options,
                         const LayeredBoundOptions& layered)
{
    return LayeredBoundSearch(costs, order, options, layered).improve();
}

template BoundResult improveBound(const VisitCosts&, const VisitOrder&, const BoundOptions&,
                                  const LayeredBoundOptions&);
template BoundResult improveBound(const LatencyCosts&, const VisitOrder&, const BoundOptions&,
                                  const LayeredBoundOptions&);

std::vector<MilpArc> survivingArcs(const VisitCosts& costs, const VisitOrder& order,
                                   const BoundOptions& options)
{
    return LayeredBoundSearch(costs, order, options, {}).arcs();
}

} // namespace berg
