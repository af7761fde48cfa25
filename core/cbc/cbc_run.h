#pragma once

#include "core/plan/solve/formulation.h"
#include "core/plan/solve/solve_watch.h"

#include <exception>

class CbcModel;

namespace berg {

/**
 * Memory of one solve by CBC, shared by its callbacks (COIN copies those as it likes): incumbent,
 * bound, why to stop. Costs are handed to CBC as `scale` x (F + N sum sigma), never negative, so
 * that CBC's relative gap is `relativeGap`; here they are called scaled. Borrows its arguments.
 */
class CbcRun
{
public:
    /** Takes the hint of the options, if any, as incumbent. */
    CbcRun(const TvpProblem& problem, const SolveOptions& options, const MilpModel& milp);

    [[nodiscard]] const TvpProblem& problem() const { return m_problem; }
    [[nodiscard]] const MilpModel& milp() const { return m_milp; }
    [[nodiscard]] const SolveOptions& options() const { return m_options; }
    [[nodiscard]] double scale() const { return m_scale; }
    /** Relative gap for CBC, a little less than asked for because `raiseBound` gives some away. */
    [[nodiscard]] double searchGap() const;
    [[nodiscard]] double elapsed_s() const { return m_stopwatch.elapsed_s(); }
    [[nodiscard]] double scaledObjective(const VisitOrder& order) const;

    /** Best order so far; empty when there is none. */
    [[nodiscard]] const VisitOrder& best() const { return m_best; }
    /** Lower bound on F. */
    [[nodiscard]] std::optional<double> bound() const { return m_bound; }
    [[nodiscard]] std::optional<StopReason> stopped() const { return m_stopped; }

    /** CBC's heuristics search models of their own; only the main one has our columns. */
    [[nodiscard]] bool isMain(const CbcModel* model) const { return model == m_main; }
    void setMain(const CbcModel* model) { m_main = model; }

    /**
     * Called at every simplex iteration. Once true it stays so: an interrupted relaxation looks
     * infeasible to CBC, which then prunes it, so from there on neither bound nor proof counts.
     */
    [[nodiscard]] bool mustStop();

    /** Takes a bound on the scaled objective. */
    void raiseBound(double scaledBound);

    /** Takes CBC's incumbent, one value per column, when it is new, and reports it. */
    void harvest(std::span<const double> solution);

    /** Reports incumbent and bound to the caller. */
    void report() const;
    /** The same at most ten times a second: who asked knows the bound whenever it ends. */
    void reportNowAndThen();

    /** Runs the body of a callback. What it throws may not pass through COIN: it ends the solve. */
    template <typename Body>
    void guard(const Body& body)
    {
        try {
            body();
        } catch (...) {
            if (!m_failure)
                m_failure = std::current_exception();
        }
    }
    /** Throws what the callbacks threw, if anything. */
    void rethrow() const;

private:
    const TvpProblem& m_problem;
    const SolveOptions& m_options;
    const MilpModel& m_milp;
    double m_scale;
    SolveWatch m_watch;
    Stopwatch m_stopwatch;
    double m_reported_s = 0;
    const CbcModel* m_main = nullptr;
    VisitOrder m_best;
    double m_bestObjective = 0;
    std::optional<double> m_bound;
    std::optional<StopReason> m_stopped;
    std::exception_ptr m_failure;
};

} // namespace berg
