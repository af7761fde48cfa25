#pragma once

#include "core/base/issue.h"
#include "core/plan/problem/aimed_leg.h"
#include "core/plan/problem/tvp.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

namespace berg {

/** Quality of the plan of an outcome. */
enum class SolveStatus
{
    Optimal,  ///< proven optimal
    Feasible, ///< a plan without proof; the bound may be missing
    None      ///< no plan: a limit, a cancellation or an unable back end came first
};

/** Reason for the end of a solve. */
enum class StopReason
{
    Finished,
    GapReached,
    TimeLimit,
    WorkLimit,
    MemoryLimit,
    Cancelled,
    Unable
};

/** Source of an answer. Names: `kSourceNames`. */
enum class AnswerSource
{
    None,
    Auto, ///< nothing was solved
    Exact,
    Heuristic,
    Cbc,
    Subsets,
    Assignment, ///< assignment of icebergs to several UAVs by uncertainty alone
    OneByOne,   ///< no solver: repeated choice of the best next iceberg
    KeptRoute,  ///< no solver: the rest of a route made before
    Coverage    ///< search by predicted zeta, not by order
};

/** Progress report of a long solve; each one is at least as good as the one before. */
struct SolveProgress
{
    FleetPlan plan = {}; ///< incumbent, an order for each UAV; empty if there is none yet
    double objective = 0;
    std::optional<double> bound; ///< valid lower bound on the optimum
    double elapsed_s = 0;
    std::vector<std::vector<AimedLeg>> legs = {}; ///< legs of the flight, for plans with aim points
    std::vector<IcebergList> orders = {};         ///< `plan` as orders of icebergs; set by policies
};

/** Limits, inputs and callbacks of a solve. */
struct SolveOptions
{
    std::optional<double> timeLimit_s; ///< limit of elapsed time; a run that it ends may not repeat
    /** Limit of work in the unit of the back end (nodes, arcs); repeats. */
    std::optional<std::int64_t> workLimit;
    /** Approximate limit of peak memory; nullopt means no limit. CBC ends if it far exceeds it. */
    std::optional<std::int64_t> memoryLimit_bytes = 1'500'000'000;
    double gap = 0; ///< stop when the relative gap is at most this
    /**
     * Whether this is one of thousands of re-plans: `auto` and `heuristic` then end after a small
     * part of their usual work, with the gap they have by then.
     */
    bool inFlight = false;
    /**
     * Warm start. For one UAV it is ignored unless it is a valid order; for several its valid part
     * (`validPart`) is used, and the missing icebergs are inserted where they cost least.
     */
    FleetPlan hint = {};
    /**
     * `SolveOutcome::multipliers` of a similar problem, one per node of this one, 0 for new nodes;
     * any values give a valid bound. Ignored if empty or of another size, and for several UAVs.
     */
    std::vector<double> multipliers = {};
    std::stop_token stop;                                      ///< checked at least every 10 ms
    std::function<void(const SolveProgress&)> onProgress = {}; ///< called on the solving thread
};

/** Result of a solve. */
struct SolveOutcome
{
    SolveStatus status = SolveStatus::None;
    StopReason reason = StopReason::Finished;
    FleetPlan plan = {};         ///< an order for each UAV; empty if the status is None
    double objective = 0;        ///< `objective` of `plan`; 0 if the status is None
    std::optional<double> bound; ///< valid lower bound, never above `objective`
    double elapsed_s = 0;
    std::int64_t work = 0; ///< work done, in the unit of `workLimit`
    bool hintUsed = false; ///< whether the hint was accepted as starting incumbent
    /**
     * For one UAV: multipliers of "each iceberg once" minus the first guess (`firstMultipliers`),
     * one per node. Empty if the answer needed none.
     */
    std::vector<double> multipliers = {};
    AnswerSource source = AnswerSource::None;
    std::string detail = {};                   ///< message of the back end
    std::optional<IssueReason> whyUnable = {}; ///< set if the back end does not support the problem

    /**
     * Returns the order of the first UAV, the only one of a `TvpProblem`; empty if there is none.
     */
    [[nodiscard]] const VisitOrder& order() const;
};

/** Returns the outcome of a problem that the back end does not support, with the reason. */
[[nodiscard]] SolveOutcome unable(IssueReason reason);

/**
 * A solver of the target visitation problem of one UAV. Stateless: one object may solve on several
 * threads at once. `solve` checks the problem, the hint and the answer; a back end implements
 * `doSolve`.
 */
class TvpSolver
{
public:
    TvpSolver() = default;
    TvpSolver(const TvpSolver&) = delete;
    TvpSolver& operator=(const TvpSolver&) = delete;
    virtual ~TvpSolver() = default;

    /** Returns the source of answers that name no other. */
    [[nodiscard]] virtual AnswerSource source() const = 0;

    /** Returns the reason why the back end cannot solve the problem, or nullopt if it can. */
    [[nodiscard]] virtual std::optional<IssueReason>
    unsupportedReason(const TvpProblem& /*problem*/) const
    {
        return std::nullopt;
    }

    /**
     * Solves the problem within the options' limits. Limits and cancellation are outcomes, not
     * errors. Throws `Error{InvalidInput}` for a problem in which `validate` finds faults,
     * `std::logic_error` inside a `NoBlockingScope` and if the back end returns an invalid order,
     * and for CBC the errors of `CbcSolver`.
     */
    [[nodiscard]] SolveOutcome solve(const TvpProblem& problem, const SolveOptions& options) const;

protected:
    /**
     * Solves a valid problem with at least one iceberg; `options.hint` is empty or one valid order.
     */
    [[nodiscard]] virtual SolveOutcome doSolve(const TvpProblem& problem,
                                               const SolveOptions& options) const = 0;
};

/** Solver back end; see `makeSolver`. */
enum class Backend
{
    Auto,
    Exact,
    Cbc,
    Heuristic
};

/** Returns the source that names a back end. */
[[nodiscard]] constexpr AnswerSource sourceOf(Backend backend)
{
    constexpr AnswerSource kSources[]{AnswerSource::Auto, AnswerSource::Exact, AnswerSource::Cbc,
                                      AnswerSource::Heuristic};
    return kSources[static_cast<std::size_t>(backend)];
}

/** MILP used by `Backend::Cbc`: position-indexed, as printed in the paper, or reduced. */
enum class Formulation
{
    Position,
    Printed,
    Reduced
};

/**
 * Returns the solver of that back end. `Exact`, `Auto` and `Heuristic` share one engine: `Exact`
 * runs until the proof, the other two end after about a second's work, the same for every run;
 * `Auto` proves small problems by dynamic programming. Only `Cbc` uses the formulation. Throws
 * `Error{Unsupported}` if this build lacks the back end or the program `bergwatch-cbc` is missing.
 */
[[nodiscard]] std::unique_ptr<TvpSolver>
makeSolver(Backend backend, Formulation formulation = Formulation::Position);

/** Measures monotonic seconds since construction: the only clock of the solvers. */
class Stopwatch
{
public:
    Stopwatch();
    [[nodiscard]] double elapsed_s() const;

private:
    std::int64_t m_start_ns;
};

} // namespace berg
