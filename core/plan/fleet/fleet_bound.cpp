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
/**
 * Steps of the multipliers: before the first suggestion, without memory, on the first graphs with
 * memory, on later ones.
 */
constexpr int kFirstSteps = 10;
constexpr int kPlainSteps = 120;
constexpr int kFirstGraphSteps = 150;
constexpr int kLaterSteps = 100;
/** Least rise of the bound, as a fraction of the cost, that is worth more memory. */
constexpr double kLeastRise = 1e-4;
/** Work counts the arcs of a sweep as 1; the other weights were measured. */
constexpr std::int64_t kWorkOfNode = 3;
constexpr std::int64_t kWorkOfRefining = 10;
constexpr std::int64_t kWorkOfState = 500;
constexpr std::int64_t kWorkOfCandidate = 3;
/** Number of last steps whose relaxed paths make the memory grow where they have cycles. */
constexpr std::size_t kRecentSteps = 20;
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
class FleetBoundSearch
{
public:
    FleetBoundSearch(const FleetCosts& costs, const FleetPlan& plan,
                     const FleetBoundOptions& options)
        : m_costs(costs)
        , m_options(options)
        , m_cost(costs.total(plan))
        , m_ascent(savings(costs, plan))
        , m_stopCheck([this] { return isStopped(); })
    {
        m_result.plan = plan;
    }

    FleetBoundResult run()
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
        if (m_options.relaxationOnly) {
            relax();
            return std::move(m_result);
        }
        ascend(kFirstSteps);
        acceptSuggestion();
        m_suggested = true;
        acceptBound(m_result.bound);
        ascend(kPlainSteps - kFirstSteps);
        for (int cap = kNearest; !finished(); ++cap) {
            if (cap > kNearest)
                forbidCycles(m_sets, m_costs.of(0).shared(), m_recent, cap);
            const bool finer = refine(0);
            if (finished())
                break;
            ascend(cap == kNearest ? kFirstGraphSteps : kLaterSteps);
            combineOrders();
            acceptSuggestion();
            report();
            // A memory that holds all icebergs cannot grow.
            const bool isFinest = !finer || cap > m_costs.icebergs();
            m_result.memoryOut = m_result.memoryOut || (isFinest && m_statesOut);
        }
        return std::move(m_result);
    }

private:
    void relax()
    {
        ascend(2 * kPlainSteps);
        double before = -1;
        for (int cap = kNearest; !finished() && m_result.bound > before + kLeastRise * m_cost;
             ++cap) {
            before = m_result.bound;
            if (cap > kNearest)
                forbidCycles(m_sets, m_costs.of(0).shared(), m_recent, cap);
            if (!refine(kInfinity))
                break;
            m_result.step.sets = std::make_shared<const NgSets>(m_sets);
            ascend(kFirstGraphSteps);
        }
        m_result.step.lambda = m_ascent.best();
    }

    /** Returns the cost from which plans are of no interest. */
    [[nodiscard]] double cutoff() const
    {
        return cutoffBelow(m_cost, m_suggested ? m_options.gap : 0.0);
    }
    bool isStopped()
    {
        m_stopped = m_stopped || (m_options.isStopped && m_options.isStopped());
        return m_stopped;
    }
    bool finished()
    {
        return m_result.reached || m_result.memoryOut || m_result.work >= m_options.workLimit ||
               isStopped();
    }
    /** Accepts a certified bound. */
    void acceptBound(double bound)
    {
        bound = std::max(bound, 0.0); // no cost is negative
        if (bound >= cutoff()) {
            m_result.bound = std::max(m_result.bound, cutoff());
            m_result.reached = m_suggested;
        } else {
            m_result.bound = std::max(m_result.bound, bound);
        }
    }
    bool acceptPlan(const FleetPlan& plan)
    {
        const double cost = m_costs.total(plan);
        if (!replaces(cost, m_cost))
            return false;
        m_cost = cost;
        m_result.plan = plan;
        report();
        return true;
    }
    /** Returns the work of the suggestion. */
    std::int64_t acceptSuggestion()
    {
        if (!m_options.suggest || finished())
            return 0;
        const FleetSuggestion found =
            m_options.suggest(m_result.work, m_options.workLimit - m_result.work);
        m_result.work += found.work;
        acceptPlan(found.plan);
        return found.work;
    }
    void report() const
    {
        if (m_options.onImproved)
            m_options.onImproved(m_result.plan, m_result.bound);
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
    [[nodiscard]] static std::int64_t workOfSweep(const FleetGraph& graph)
    {
        return graph.arcCount() + kWorkOfNode * graph.nodeCount();
    }

    /**
     * Returns the visits of the shortest paths of the last sweep. Accepts the paths if they form a
     * plan.
     */
    std::vector<int> acceptPaths()
    {
        std::vector<int> visits;
        FleetPlan plan(static_cast<std::size_t>(m_costs.uavs()));
        for (const FleetGraph& graph : m_graphs->all)
            for (int root = 0; root < graph.rootCount(); ++root) {
                const VisitOrder path = graph.shortestPath(root);
                visits.insert(visits.end(), path.begin(), path.end());
                plan[static_cast<std::size_t>(graph.uavs()[static_cast<std::size_t>(root)])] = path;
                m_recent.push_back(path);
            }
        const std::size_t most = kRecentSteps * static_cast<std::size_t>(m_costs.uavs());
        if (m_recent.size() > most)
            m_recent.erase(m_recent.begin(), m_recent.end() - static_cast<std::ptrdiff_t>(most));
        if (m_costs.isPlan(plan))
            acceptPlan(plan);
        return visits;
    }

    /** After a poor plan the multipliers may be so large that rounding hides the cost. */
    void renewMultipliers()
    {
        if (!allowsProof(marginOf(m_ascent.best(), 0), m_cost))
            m_ascent = MultiplierAscent(savings(m_costs, m_result.plan));
    }

    void ascend(int steps)
    {
        renewMultipliers();
        m_ascent.restart();
        m_recent.clear();
        for (int k = 0; k < steps && !finished(); ++k) {
            const std::optional<Sweep> swept = sweep(m_ascent.here());
            if (!swept)
                return;
            const bool climbs = m_ascent.step(
                {.visits = acceptPaths(), .bound = swept->bound, .margin = swept->margin}, m_cost);
            acceptBound(m_ascent.bound());
            if (!climbs)
                break;
            if (k % 20 == 6 && m_suggested)
                trim();
        }
        if (m_suggested && !finished())
            trim();
        report();
    }

    void trim()
    {
        const std::optional<Sweep> swept = sweep(m_ascent.best());
        if (!swept)
            return;
        for (FleetGraph& graph : m_graphs->all) {
            m_result.work += 3 * workOfSweep(graph);
            if (!graph.trim(m_ascent.best(), swept->slackBelow(cutoff()), m_stopCheck))
                return; // stopped, so finished
        }
    }

    /**
     * Refines the graphs; parts less than `allowance` above the cutoff stay too. Returns false if
     * stopped, or if the refined graphs would exceed the limits.
     */
    bool refine(double allowance)
    {
        const std::optional<Sweep> swept = sweep(m_ascent.best());
        if (!swept)
            return false;
        for (FleetGraph& graph : m_graphs->all) {
            constexpr std::int64_t kGrowth = 3; // growth of vectors and labels
            const GraphLimits limits{.arcs = std::min((m_options.workLimit - m_result.work) /
                                                          (kWorkOfRefining + kLaterSteps),
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

    /**
     * Combines the remaining orders into the best plan, beginning with the few that beat the plan
     * by much.
     */
    void combineOrders()
    {
        const std::optional<Sweep> swept = finished() ? std::nullopt : sweep(m_ascent.best());
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
            m_options.cover(orders, slack, std::min(left, m_coverWork), m_stopCheck);
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

    const FleetCosts& m_costs;
    const FleetBoundOptions& m_options;
    FleetBoundResult m_result;
    double m_cost; ///< cost of `m_result.plan`
    MultiplierAscent m_ascent;
    NgSets m_sets{0};
    StopCheck m_stopCheck;
    std::unique_ptr<FleetGraphs, DeferredDeleter> m_graphs{new FleetGraphs};
    std::vector<std::vector<int>> m_recent; ///< relaxed paths of the last steps
    std::size_t m_states = kFirstStates;
    std::int64_t m_coverWork = 20'000'000;
    bool m_suggested = false; ///< the gap is not checked before the first suggestion
    bool m_statesOut = false; ///< whether there are more states than allowed
    bool m_stopped = false;
};

} // namespace

bool isBounded(const FleetCosts& costs)
{
    return costs.icebergs() < NodeSet::kCapacity && !costs.weighted();
}

FleetBoundResult improveFleetBound(const FleetCosts& costs, const FleetPlan& plan,
                                   const FleetBoundOptions& options)
{
    return FleetBoundSearch(costs, plan, options).run();
}

} // namespace berg
