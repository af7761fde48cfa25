#pragma once

#include "core/plan/problem/formulation.h"
#include "core/plan/solve/solve_watch.h"

#include <exception>

class CbcModel;

namespace berg {

/**
 * State of one solve by CBC, shared by its callbacks (COIN copies those freely): incumbent, bound,
 * reason to stop. CBC gets costs as `scale` x (F + N sum sigma), never negative, so that its
 * relative gap equals `relativeGap`; these costs are called scaled here. Borrows its arguments.
 */
class CbcRun
{
public:
    /** Starts with the hint of the options, if any, as incumbent. */
    CbcRun(const TvpProblem& problem, const SolveOptions& options, const MilpModel& milp);

    [[nodiscard]] const TvpProblem& problem() const { return m_problem; }
    [[nodiscard]] const MilpModel& milp() const { return m_milp; }
    [[nodiscard]] const SolveOptions& options() const { return m_options; }
    [[nodiscard]] double scale() const { return m_scale; }
    /**
     * Returns the relative gap for CBC, slightly below the requested one because `raiseBound`
     * lowers bounds.
     */
    [[nodiscard]] double searchGap() const;
    [[nodiscard]] double elapsed_s() const { return m_stopwatch.elapsed_s(); }
    /** Returns the scaled cost of an order. */
    [[nodiscard]] double scaledObjective(const VisitOrder& order) const;

    /** Best order so far; empty before the first. */
    [[nodiscard]] const VisitOrder& best() const { return m_best; }
    /** Lower bound on F, or nullopt before the first. */
    [[nodiscard]] std::optional<double> bound() const { return m_bound; }
    /** Reason to stop, or nullopt while the solve continues. */
    [[nodiscard]] std::optional<StopReason> stopped() const { return m_stopped; }

    /**
     * Returns true for the main model. CBC's heuristics search models of their own, without our
     * columns.
     */
    [[nodiscard]] bool isMain(const CbcModel* model) const { return model == m_main; }
    void setMain(const CbcModel* model) { m_main = model; }

    /**
     * Returns true once the solve must stop, and from then on. Called at every simplex iteration.
     * An interrupted relaxation looks infeasible to CBC, which prunes it, so bounds and proofs no
     * longer count afterwards.
     */
    [[nodiscard]] bool mustStop();

    /** Takes a lower bound on the scaled objective. */
    void raiseBound(double scaledBound);

    /** Takes CBC's incumbent, one value per column, if it is better, and reports it. */
    void harvest(std::span<const double> solution);

    /** Reports incumbent and bound to the caller. */
    void report() const;
    /**
     * Reports at most ten times a second, so that the caller knows the bound whenever the solve
     * ends.
     */
    void reportAtIntervals();

    /**
     * Runs the body of a callback. An exception must not pass through COIN, so it is stored and
     * ends the solve.
     */
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
    /** Throws the stored exception, if any. */
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
