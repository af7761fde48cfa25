#pragma once

#include "core/plan/problem/tvp.h"
#include "core/plan/proof/layered_paths.h"
#include "core/plan/proof/multiplier_ascent.h"
#include "core/plan/proof/proof_step.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

namespace berg {

/** A plan from another search, and the work spent on it. */
struct Suggestion
{
    FleetPlan plan; ///< an order for each UAV; with one UAV there must be its order
    std::int64_t work = 0;
};

/** Limits and callbacks of `improveBound` and `improveFleetBound`. */
struct BoundOptions
{
    double gap = 0;             ///< stop at this gap relative to the plan's cost
    std::int64_t workLimit = 0; ///< arcs examined, roughly 2 ns each; checked now and then
    /**
     * Larger graphs are not built. The limit is approximate; n^3 / 250 kB at least are used in
     * addition.
     */
    std::int64_t memoryLimit_bytes = 1'500'000'000;
    StopCheck isStopped = {}; ///< called at least every 10 ms; true ends the work
    std::function<void(const FleetPlan& plan, double bound)> onImproved = {}; ///< may be empty
    /**
     * Called for a better plan right after the first bound (the gap is not checked before) and then
     * after every round; `work` is the work done, `most` the work left. May be empty.
     */
    std::function<Suggestion(std::int64_t work, std::int64_t most)> suggest = {};
};

/** Result of `improveBound` and `improveFleetBound`. */
struct BoundResult
{
    double bound = 0;     ///< lower bound on the cost of every plan, at most the plan's cost
    FleetPlan plan;       ///< the best plan known, at least as good as the given one
    bool reached = false; ///< whether bound and cost are as close as requested (`kProofTolerance`)
    bool memoryOut = false; ///< whether the memory limit ended the work
    std::int64_t work = 0;  ///< arcs examined, with the work of the suggestions
    ProofStep step{};       ///< the best multipliers, and the memory of `relaxationOnly`
};

/** Steps of the multipliers. */
struct BoundSteps
{
    int plain = 0;            ///< in total without memory
    int firstGraph = 0;       ///< on the first graphs with memory
    int later = 0;            ///< on each later one
    bool trimsAtOnce = false; ///< whether graphs are trimmed after the first step
};

/** Work counts the arcs of a sweep as 1; the other weights were measured. */
inline constexpr std::int64_t kWorkOfRefining = 10;

/** Returns the work of a sweep of a graph. */
template <class Graph>
[[nodiscard]] std::int64_t workOfSweep(const Graph& graph)
{
    constexpr std::int64_t kWorkOfNode = 3;
    return graph.arcCount() + kWorkOfNode * graph.nodeCount();
}

/**
 * The loop of a proof, for one UAV and for several: a plan, a bound, and in derived classes graphs
 * of the orders that may lie between. The multipliers climb without memory, then in rounds on
 * graphs with more and more memory, each ended by a search of the orders left. Borrows the options.
 */
class BoundLoop
{
public:
    virtual ~BoundLoop() = default;

protected:
    /** Starts from a plan of that cost, and from multipliers (`MultiplierAscent`). */
    BoundLoop(const BoundOptions& options, FleetPlan plan, double cost, Eigen::VectorXd lambda,
              const BoundSteps& steps)
        : m_options(options), m_steps(steps), m_cost(cost), m_ascent(std::move(lambda))
    {
        m_result.plan = std::move(plan);
    }

    /** Returns the cost of any plan. */
    [[nodiscard]] virtual double costOf(const FleetPlan& plan) const = 0;
    /** Replaces multipliers so large, after a poor plan, that rounding hides the cost. */
    virtual void renewMultipliers() = 0;
    /** Makes steps of the multipliers without memory. */
    virtual void relax(int steps)
    {
        ascend(steps);
        report();
    }
    /** Makes the next graphs. Returns false if the loop must end. */
    virtual bool refine() = 0;
    /**
     * Sweeps the graphs at the multipliers `MultiplierAscent::here`. Returns nullopt if stopped, or
     * if no path is left.
     */
    virtual std::optional<MultiplierAscent::Relaxed> sweepHere() = 0;
    /** Deletes parts of the graphs that cannot beat the plan. */
    virtual void trim() = 0;
    /** Searches the orders left in the graphs for a better plan and a better bound. */
    virtual void searchOrders() = 0;
    /** Ends a round: adds memory for the next one. */
    virtual void endRound() = 0;

    BoundResult run()
    {
        constexpr int kFirstSteps = 10;
        relax(kFirstSteps);
        acceptSuggestion();
        m_gap = m_options.gap;
        m_mayEnd = true;
        acceptBound(m_result.bound);
        relax(m_steps.plain - kFirstSteps);
        while (!finished() && climbOnNextGraph()) {
            if (!finished() && !m_gapReached)
                searchOrders();
            report();
            acceptSuggestion();
            endRound();
        }
        m_result.step.lambda = m_ascent.best();
        return std::move(m_result);
    }

    /** Returns false if there is no next graph. */
    bool climbOnNextGraph()
    {
        if (!refine())
            return false;
        ascend(++m_rounds == 1 ? m_steps.firstGraph : m_steps.later);
        return true;
    }
    /** Makes steps of the multipliers on the graphs and trims these meanwhile. */
    void ascend(int steps)
    {
        renewMultipliers();
        m_ascent.restart();
        m_recent.clear();
        for (int k = 0; k < steps && !finished() && !m_gapReached; ++k) {
            const std::optional<MultiplierAscent::Relaxed> relaxed = sweepHere();
            if (!relaxed)
                return;
            if (!climb(*relaxed)) {
                ++m_tops;
                break;
            }
            // Early steps gain most, so the graphs are trimmed sooner after them.
            if ((k == 0 && m_steps.trimsAtOnce) || k % 20 == 6)
                trim();
        }
        if (!finished())
            trim();
    }
    /** Stores a relaxed path, whose cycles may make the memory grow. */
    void remember(const VisitOrder& path)
    {
        constexpr std::size_t kRecentSteps = 20;
        m_recent.push_back(path);
        if (m_recent.size() > kRecentSteps * m_result.plan.size())
            m_recent.erase(m_recent.begin());
    }
    /** Makes a step; returns false if the paths are a plan, so that no multipliers are better. */
    bool climb(const MultiplierAscent::Relaxed& relaxed)
    {
        const bool climbs = m_ascent.step(relaxed, m_cost);
        if (!climbs)
            acceptPlan(relaxed.paths);
        acceptBound(m_ascent.bound());
        return climbs;
    }

    /** Returns the cost from which plans are of no interest. */
    [[nodiscard]] double cutoff() const
    {
        return m_keepEqual ? cutoffAbove(m_cost) : cutoffBelow(m_cost, m_gap);
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
    /** Accepts a certified lower bound on all plans below the cutoff. */
    void acceptBound(double bound)
    {
        bound = std::max(bound, 0.0); // no cost is negative
        if (bound >= cutoff()) {
            m_result.bound = std::max(m_result.bound, cutoff());
            m_gapReached = m_mayEnd;
            m_result.reached = m_mayEnd && m_gap <= m_options.gap;
        } else {
            m_result.bound = std::max(m_result.bound, bound);
        }
    }
    /** Accepts a plan; returns whether it is better. */
    bool acceptPlan(const FleetPlan& plan)
    {
        const double cost = costOf(plan);
        if (m_keepEqual || !replaces(cost, m_cost))
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
        const Suggestion found =
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

    const BoundOptions& m_options;
    BoundSteps m_steps;
    BoundResult m_result;
    double m_cost; ///< cost of `m_result.plan`
    MultiplierAscent m_ascent;
    FleetPlan m_recent; ///< relaxed paths of the last steps
    StopCheck m_stopCheck{[this] { return isStopped(); }};
    double m_gap = 0;          ///< gap that is being certified
    bool m_gapReached = false; ///< whether it has been certified
    bool m_mayEnd = true;      ///< whether a proof ends the loop
    bool m_keepEqual = false;  ///< whether plans as good as the given one are of interest too
    int m_rounds = 0;          ///< number of graphs made so far
    int m_tops = 0;            ///< number of ascents that found no better multipliers
    bool m_stopped = false;
};

} // namespace berg
