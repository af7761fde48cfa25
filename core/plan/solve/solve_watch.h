#pragma once

#include "core/plan/proof/certified.h"
#include "core/plan/solve/solver.h"

#include <utility>

namespace berg {

/**
 * Stop token, time limit and progress reports of one solve. Borrows the options. The back end
 * itself counts the work.
 */
class SolveWatch
{
public:
    explicit SolveWatch(const SolveOptions& options) : m_options(options) {}

    /**
     * Returns the reason why the solve must end now, or nullopt. Takes about 50 ns: call it at
     * least every 10 ms.
     */
    [[nodiscard]] std::optional<StopReason> stopReason() const
    {
        if (m_options.stop.stop_requested())
            return StopReason::Cancelled;
        if (m_options.timeLimit_s && m_watch.elapsed_s() >= *m_options.timeLimit_s)
            return StopReason::TimeLimit;
        return std::nullopt;
    }

    /** Calls `onProgress`, if set. `bound` is in terms of Eq. (1). */
    void report(const FleetPlan& plan, double objective, std::optional<double> bound) const
    {
        if (m_options.onProgress)
            m_options.onProgress({.plan = plan,
                                  .objective = objective,
                                  .bound = bound,
                                  .elapsed_s = m_watch.elapsed_s()});
    }

private:
    const SolveOptions& m_options;
    Stopwatch m_watch;
};

/**
 * Best plan, bound and progress reports of an engine that proves its plans. Borrows the options.
 */
class SolveAccount
{
public:
    /** `shift` is the cost minus the objective. */
    SolveAccount(const SolveOptions& options, double shift, int icebergs)
        : m_watch(options), m_shift(shift), m_icebergs(icebergs)
    {
    }

    /** Returns whether the solve must stop, and stores the reason. */
    bool isStopped()
    {
        if (!m_reason)
            m_reason = m_watch.stopReason();
        return m_reason.has_value();
    }
    /** Returns the reason stored by `isStopped`; nullopt if it has not stopped. */
    [[nodiscard]] const std::optional<StopReason>& reason() const { return m_reason; }

    /** Stores and reports a plan that the caller found to be better; it is not compared. */
    void acceptPlan(FleetPlan plan, double objective)
    {
        m_plan = std::move(plan);
        m_objective = objective;
        report();
    }
    /**
     * Stores and reports a bound on the cost if it is above 0 and above the stored one; ignores it
     * otherwise.
     */
    void acceptBound(double bound)
    {
        if (bound <= 0 || bound <= m_bound)
            return;
        m_bound = bound;
        report();
    }
    /**
     * Returns the bound on the objective, or nullopt if there is none. It is rounded down, because
     * the shift may be far larger than the objective.
     */
    [[nodiscard]] std::optional<double> bound() const
    {
        return m_bound > 0 ? std::optional(m_bound - m_shift - roundingMargin(m_icebergs, m_shift))
                           : std::nullopt;
    }

private:
    void report() const
    {
        const std::optional<double> known = bound();
        m_watch.report(m_plan, m_objective,
                       known ? std::optional(std::min(*known, m_objective)) : std::nullopt);
    }

    SolveWatch m_watch;
    double m_shift;
    int m_icebergs;
    std::optional<StopReason> m_reason;
    FleetPlan m_plan; ///< the best plan
    double m_objective = 0;
    double m_bound = 0;
};

} // namespace berg
