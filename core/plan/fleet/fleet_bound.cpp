#include "core/plan/fleet/fleet_bound.h"

#include "core/plan/fleet/fleet_graph.h"
#include "core/plan/proof/multiplier_ascent.h"
#include "core/plan/proof/ng_memory.h"
#include "core/plan/proof/piece_list.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace berg {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr BoundSteps kSteps{.plain = 120, .firstGraph = 150, .later = 100};
/** Least rise of the bound, as a fraction of the cost, that is worth more memory. */
constexpr double kLeastRise = 1e-4;
/** `kWorkOfRefining` for a state and an order examined. */
constexpr std::int64_t kWorkOfState = 500;
constexpr std::int64_t kWorkOfCandidate = 3;
constexpr int kNearest = 3;
/** States of the first attempt to combine orders, and the maximum; each attempt doubles them. */
constexpr std::size_t kFirstStates = 50'000;
constexpr std::size_t kMostStates = 200'000;
/**
 * Larger graphs are not built: sweeps would take too long between two checks for a stop, and memory
 * of tens of megabytes takes as long to allocate.
 */
constexpr std::int64_t kMostArcs = 4'000'000;
constexpr std::int64_t kBytesOfState = 400; // with tables, and an order that ends there
/** Gaps certified before the final one. */
constexpr std::array kStages{0.02, 0.01, 0.005, 0.002};

struct FleetGraphs
{
    [[nodiscard]] std::int64_t bytes() const
    {
        std::int64_t sum = 0;
        for (const FleetGraph& graph : all)
            sum += graph.bytes();
        return sum;
    }

    std::vector<FleetGraph> all;
};

/** Runs `improveFleetBound`. */
class FleetBoundSearch final : BoundLoop
{
public:
    FleetBoundSearch(const FleetCosts& costs, const FleetPlan& plan, const BoundOptions& options,
                     const FleetBoundOptions& fleet)
        : BoundLoop(options, plan, costs.total(plan), savings(costs, plan), kSteps)
        , m_costs(costs)
        , m_fleet(fleet)
    {
        m_mayEnd = false; // until the first suggestion
    }

    BoundResult improve()
    {
        if (!isBounded(m_costs)) {
            while (!finished() && acceptSuggestion() > 0) {
            }
            return std::move(m_result);
        }
        std::vector<std::vector<int>> groups = m_costs.alike();
        std::int64_t all_bytes = 0;
        for (const std::vector<int>& uavs : groups)
            all_bytes += FleetGraph::bytesOfComplete(m_costs, uavs);
        if (all_bytes > m_options.memoryLimit_bytes) {
            acceptSuggestion(); // the result is a good plan without a bound
            m_result.memoryOut = true;
            return std::move(m_result);
        }
        for (std::vector<int>& uavs : groups)
            if (!isStopped())
                m_graphs->all.emplace_back(m_costs, std::move(uavs), m_stopCheck);
        m_sets = nearestSets(m_costs.of(0).shared(), kNearest);
        if (!m_fleet.relaxationOnly)
            return run();
        relaxOnly();
        return std::move(m_result);
    }

private:
    void relaxOnly()
    {
        ascend(2 * kSteps.plain);
        double before = -1;
        while (!finished() && m_result.bound > before + kLeastRise * m_cost) {
            before = m_result.bound;
            if (!makeFiner(kInfinity))
                break;
            m_result.step.sets = std::make_shared<const NgSets>(m_sets);
            ascend(kSteps.firstGraph);
            addMemory();
        }
        m_result.step.lambda = m_ascent.best();
    }

    [[nodiscard]] double costOf(const FleetPlan& plan) const override
    {
        return m_costs.total(plan);
    }

    /** Result of a sweep. */
    struct Sweep
    {
        double bound = 0;  ///< sum of the multipliers and of the shortest paths
        double margin = 0; ///< rounding margin of the bound and of the excess of paths

        /** Orders whose computed excess is at least this are in no plan of less than the cost. */
        [[nodiscard]] double slackBelow(double cost) const { return cost - bound + margin; }
    };
    /** Returns nullopt if stopped. */
    std::optional<Sweep> sweep(const Eigen::VectorXd& lambda)
    {
        Sweep result{.bound = lambda.sum()};
        for (FleetGraph& graph : m_graphs->all) {
            if (!graph.sweep(lambda, m_stopCheck))
                return std::nullopt;
            m_result.work += workOfSweep(graph);
            result.bound += graph.shortestSum();
        }
        result.margin = marginOf(lambda, lambda.sum() - result.bound);
        return result;
    }
    /** `lengths` is the sum of the shortest paths without its sign. */
    [[nodiscard]] double marginOf(const Eigen::VectorXd& lambda, double lengths) const
    {
        return roundingMargin(m_costs.icebergs() + m_costs.uavs(),
                              m_cost + lambda.lpNorm<1>() + lengths);
    }

    std::optional<MultiplierAscent::Relaxed> sweepHere() override
    {
        const std::optional<Sweep> swept = sweep(m_ascent.here());
        if (!swept)
            return std::nullopt;
        FleetPlan paths(m_result.plan.size());
        for (const FleetGraph& graph : m_graphs->all)
            for (int root = 0; root < graph.rootCount(); ++root) {
                const int uav = graph.uavs()[static_cast<std::size_t>(root)];
                paths[static_cast<std::size_t>(uav)] = graph.shortestPath(root);
                remember(paths[static_cast<std::size_t>(uav)]);
            }
        return MultiplierAscent::Relaxed{std::move(paths), swept->bound, swept->margin};
    }

    void renewMultipliers() override
    {
        if (!allowsProof(marginOf(m_ascent.best(), 0), m_cost))
            m_ascent = MultiplierAscent(savings(m_costs, m_result.plan));
    }

    void trim() override
    {
        if (!m_mayEnd)
            return;
        const std::optional<Sweep> swept = sweep(m_ascent.best());
        if (!swept)
            return;
        for (FleetGraph& graph : m_graphs->all) {
            m_result.work += 3 * workOfSweep(graph);
            if (!graph.trim(m_ascent.best(), swept->slackBelow(cutoff()), m_stopCheck))
                return; // stopped, so finished
        }
    }

    bool refine() override
    {
        m_isFinest = !makeFiner(0) || m_cap > m_costs.icebergs();
        return !finished();
    }
    /**
     * Refines the graphs; parts less than `allowance` above the cutoff stay too. Returns false if
     * stopped, or if the refined graphs would exceed the limits.
     */
    bool makeFiner(double allowance)
    {
        const std::optional<Sweep> swept = sweep(m_ascent.best());
        if (!swept)
            return false;
        for (FleetGraph& graph : m_graphs->all) {
            constexpr std::int64_t kGrowth = 3; // growth of vectors and labels
            const GraphLimits limits{.arcs = std::min((m_options.workLimit - m_result.work) /
                                                          (kWorkOfRefining + kSteps.later),
                                                      kMostArcs),
                                     .bytes = (m_options.memoryLimit_bytes - m_graphs->bytes()) /
                                              kGrowth};
            FleetRefinement refined =
                graph.refined(m_sets, m_ascent.best(), swept->slackBelow(cutoff()) + allowance,
                              limits, m_stopCheck);
            m_result.memoryOut = refined.memoryOut;
            if (!refined.graph)
                return false;
            graph = std::move(*refined.graph);
            m_result.work += kWorkOfRefining * workOfSweep(graph);
        }
        return true;
    }

    void addMemory() { forbidCycles(m_sets, m_costs.of(0).shared(), m_recent, ++m_cap); }

    /**
     * Combines the remaining orders into the best plan, beginning with the few that beat the plan
     * by much.
     */
    void searchOrders() override
    {
        report();
        const std::optional<Sweep> swept = sweep(m_ascent.best());
        if (!swept)
            return;
        for (const double gap : kStages)
            if (gap > m_options.gap && swept->bound < cutoffBelow(m_cost, gap) &&
                (finished() || !isBestWithin(*swept, cutoffBelow(m_cost, gap))))
                return;
        if (!finished())
            isBestWithin(*swept, cutoff());
    }

    /**
     * Returns whether it is now proven that no plan costs less than `cost`; accepts the best plan
     * that does. `swept` must be the last sweep, at the best multipliers.
     */
    bool isBestWithin(const Sweep& swept, double cost)
    {
        const double slack = swept.slackBelow(cost);
        FleetOrders orders(m_costs.uavs(), m_costs.icebergs());
        const auto mostByMemory = static_cast<std::size_t>(
            std::max<std::int64_t>(0, m_options.memoryLimit_bytes - m_graphs->bytes()) /
            kBytesOfState);
        bool all = true;
        for (const FleetGraph& graph : m_graphs->all)
            all = all && orders.add(graph, m_ascent.best(), slack, std::min(m_states, mostByMemory),
                                    m_stopCheck);
        m_result.work += kWorkOfState * static_cast<std::int64_t>(orders.stateCount());
        if (!all || isStopped()) {
            m_statesOut = m_states >= std::min(kMostStates, mostByMemory);
            m_states = std::min(2 * m_states, kMostStates);
            return false;
        }
        const std::int64_t left = (m_options.workLimit - m_result.work) / kWorkOfCandidate;
        const FleetCover found =
            m_fleet.cover(orders, slack, std::min(left, m_coverWork), m_stopCheck);
        m_result.work += kWorkOfCandidate * found.work;
        // No plan is cheaper than the one found, as far as rounding lets both be known.
        const double least = found.plan ? m_costs.total(*found.plan) - 2 * swept.margin : kInfinity;
        const bool better = found.plan && acceptPlan(*found.plan);
        if (!found.complete) {
            m_coverWork *= 2;
            return false;
        }
        acceptBound(std::min(least, cost));
        return !better;
    }

    void endRound() override
    {
        // A memory that holds all icebergs cannot grow.
        m_result.memoryOut = m_result.memoryOut || (m_isFinest && m_statesOut);
        if (!finished())
            addMemory();
    }

    const FleetCosts& m_costs;
    const FleetBoundOptions& m_fleet;
    NgSets m_sets{0};
    int m_cap = kNearest; ///< largest number of icebergs in a memory
    std::unique_ptr<FleetGraphs, DeferredDeleter> m_graphs{new FleetGraphs};
    std::size_t m_states = kFirstStates;
    std::int64_t m_coverWork = 20'000'000;
    bool m_isFinest = false;  ///< whether the graphs cannot be refined any more
    bool m_statesOut = false; ///< whether there are more states than allowed
};

} // namespace

bool isBounded(const FleetCosts& costs)
{
    return costs.icebergs() < NodeSet::kCapacity && !costs.weighted();
}

BoundResult improveFleetBound(const FleetCosts& costs, const FleetPlan& plan,
                              const BoundOptions& options, const FleetBoundOptions& fleet)
{
    return FleetBoundSearch(costs, plan, options, fleet).improve();
}

} // namespace berg
