#pragma once

#include "core/plan/proof/bound_loop.h"
#include "core/plan/solve/engine.h"
#include "core/plan/solve/search_effort.h"
#include "core/plan/solve/solve_watch.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace berg {

/**
 * A solve, for one UAV or for several, in which a local search and a bound alternate: the best
 * plan, its bound, reports of both, and limits. Borrows the options.
 */
class EngineLoop
{
public:
    virtual ~EngineLoop() = default;

protected:
    /**
     * `shift` is the cost minus the objective. `effort` is a work limit of the back end itself.
     * 1 / `searchShare` of all work goes into more local search while the proof is in progress.
     */
    EngineLoop(const SolveOptions& options, int icebergs, double shift,
               std::optional<std::int64_t> effort, std::int64_t searchShare)
        : m_options(options)
        , m_icebergs(icebergs)
        , m_shift(shift)
        , m_backendLimit(effort.value_or(kNoLimit))
        , m_limit(std::min(m_backendLimit, options.workLimit.value_or(kNoLimit)))
        , m_searchShare(searchShare)
        , m_watch(options)
    {
        m_effort.isStopped = [this] {
            if (!m_reason)
                m_reason = m_watch.stopReason();
            return m_reason.has_value();
        };
        m_effort.limit = m_limit;
    }

    /** Makes a first plan and a local optimum near it. */
    virtual void start() = 0;
    /** Searches for better plans the first time. */
    virtual void searchFirst() = 0;
    /** Continues the search if the `work` due is worthwhile. */
    virtual void searchMore(std::int64_t work) = 0;
    /** Accepts a plan of the bound if it is better. */
    virtual void accept(const FleetPlan& plan) = 0;
    [[nodiscard]] virtual double costOf(const FleetPlan& plan) const = 0;
    [[nodiscard]] virtual BoundResult improve(const BoundOptions& options) = 0;

    SolveOutcome run()
    {
        start();
        const std::int64_t before = m_effort.work;
        const BoundResult result =
            improve({.gap = m_options.gap,
                     .workLimit = m_limit - before,
                     .memoryLimit_bytes = m_options.memoryLimit_bytes.value_or(kNoLimit),
                     .isStopped = m_effort.isStopped,
                     .onImproved =
                         [this](const FleetPlan& plan, double bound) {
                             accept(plan);
                             acceptBound(bound);
                         },
                     .suggest = [this](auto work, auto most) { return suggest(work, most); }});
        accept(result.plan);
        acceptBound(result.bound);
        return outcome(result, before + result.work);
    }

    /** Stores and reports a plan that the search found to be better. */
    void storePlan(FleetPlan plan, double objective)
    {
        m_plan = std::move(plan);
        m_objective = objective;
        report();
    }

    static constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max() / 4;

    const SolveOptions& m_options;
    const std::int64_t m_icebergs;
    const double m_shift;
    const std::int64_t m_backendLimit;
    const std::int64_t m_limit; ///< the smaller of that and the caller's limit
    const std::int64_t m_searchShare;
    SolveWatch m_watch;
    SearchEffort m_effort;
    std::optional<StopReason> m_reason;     ///< once the solve must stop
    std::optional<std::int64_t> m_searched; ///< work of the first search, once it is done
    FleetPlan m_plan;                       ///< the best plan
    double m_objective = 0;
    double m_bound = 0;    ///< bound on the cost; 0 if there is none
    std::string m_failure; ///< message of a program that failed

private:
    Suggestion suggest(std::int64_t work, std::int64_t most)
    {
        const std::int64_t before = m_effort.work;
        m_effort.limit = before + most;
        if (m_searched) {
            searchMore(work / m_searchShare - (before - *m_searched));
        } else {
            searchFirst();
            m_searched = m_effort.work;
        }
        return {.plan = m_plan, .work = m_effort.work - before};
    }

    void acceptBound(double bound)
    {
        if (bound <= m_bound)
            return;
        m_bound = bound;
        report();
    }
    /**
     * Returns the bound on the objective. It is rounded down, because the shift may be far larger
     * than the objective.
     */
    [[nodiscard]] std::optional<double> bound() const
    {
        return m_bound > 0 ? std::optional(m_bound - m_shift - roundingMargin(m_icebergs, m_shift))
                           : std::nullopt;
    }
    void report() const
    {
        const std::optional<double> known = bound();
        m_watch.report(m_plan, m_objective,
                       known ? std::optional(std::min(*known, m_objective)) : std::nullopt);
    }

    [[nodiscard]] SolveOutcome outcome(const BoundResult& result, std::int64_t work) const
    {
        SolveOutcome outcome{.status = SolveStatus::Feasible,
                             .plan = m_plan,
                             .bound = bound(),
                             .work = work,
                             .hintUsed = !m_options.hint.empty(),
                             .detail = m_failure};
        if (result.reached && isProven(costOf(m_plan), result.bound))
            outcome.status = SolveStatus::Optimal;
        else if (result.reached)
            outcome.reason = StopReason::GapReached;
        else if (m_reason)
            outcome.reason = *m_reason;
        else if (!m_failure.empty())
            outcome.reason = StopReason::Unable;
        else if (result.memoryOut)
            outcome.reason = StopReason::MemoryLimit;
        else if (m_options.workLimit && *m_options.workLimit <= m_backendLimit &&
                 (m_icebergs <= kMostProvenByEngine || work >= *m_options.workLimit))
            outcome.reason = StopReason::WorkLimit;
        return outcome;
    }
};

} // namespace berg
