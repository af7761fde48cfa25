#pragma once

#include "core/plan/solve/certified.h"
#include "core/plan/solve/solver.h"

#include <utility>

namespace berg {

/**
 * Stop token, time limit and progress reports of one solve. Borrows the options. Work is counted
 * by the back end itself.
 */
class SolveWatch
{
public:
    explicit SolveWatch(const SolveOptions& options) : m_options(options) {}

    /** Why the solve must end now, if it must. About 50 ns: ask at least every 10 ms. */
    [[nodiscard]] std::optional<StopReason> cut() const
    {
        if (m_options.stop.stop_requested())
            return StopReason::Cancelled;
        if (m_options.timeLimit_s && m_watch.elapsed_s() >= *m_options.timeLimit_s)
            return StopReason::TimeLimit;
        return std::nullopt;
    }

    /** Hands a progress report to the caller, if he wants any. `bound` in terms of Eq. (1). */
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

/** What an engine that proves its plans knows and tells while it works. Borrows the options. */
class SolveAccount
{
public:
    /** Cost = objective + `shift`. */
    SolveAccount(const SolveOptions& options, double shift, int icebergs)
        : m_watch(options), m_shift(shift), m_icebergs(icebergs)
    {
    }

    /** Asks the watch, and remembers the reason. */
    bool cut()
    {
        if (!m_cut)
            m_cut = m_watch.cut();
        return m_cut.has_value();
    }
    [[nodiscard]] const std::optional<StopReason>& reason() const { return m_cut; }

    void acceptPlan(FleetPlan plan, double objective)
    {
        m_plan = std::move(plan);
        m_objective = objective;
        report();
    }
    /** On the cost. 0 says nothing: that every cost is positive goes without saying. */
    void acceptBound(double bound)
    {
        if (bound <= 0 || bound <= m_bound)
            return;
        m_bound = bound;
        report();
    }
    /** On the objective, if there is any. Rounded down: the shift may be far larger than it. */
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
    std::optional<StopReason> m_cut;
    FleetPlan m_plan; ///< the best one
    double m_objective = 0;
    double m_bound = 0;
};

} // namespace berg
