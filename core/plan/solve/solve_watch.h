#pragma once

#include "core/plan/solve/solver.h"

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

} // namespace berg
