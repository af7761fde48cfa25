#pragma once

#include "core/base/issue.h"
#include "core/plan/solve/aimed_leg.h"
#include "core/plan/solve/tvp.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

namespace berg {

enum class SolveStatus
{
    Optimal,  ///< proven
    Feasible, ///< an order, not proven; the bound may be missing
    None      ///< a limit, a cancellation or an unable back end came before any order
};

/** Why a solve ended. */
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

/** What made an answer. Names: `kSourceNames`. */
enum class AnswerSource
{
    None,
    Auto, ///< nothing was solved
    Exact,
    Heuristic,
    Cbc,
    Subsets,
    Assignment, ///< of several UAVs by uncertainty alone
    OneByOne,   ///< no solver: again and again the best next iceberg
    KeptRoute,  ///< no solver: what is left of a route made before
    Coverage    ///< weighs predicted zeta, not an order
};

/** What a long solve tells while it runs; each one is at least as good as the one before. */
struct SolveProgress
{
    FleetPlan plan = {}; ///< incumbent, an order for each UAV; empty when there is none yet
    double objective = 0;
    std::optional<double> bound; ///< valid lower bound on the optimum
    double elapsed_s = 0;
    std::vector<std::vector<AimedLeg>> legs = {}; ///< how it is flown, of plans with aim points
};

struct SolveOptions
{
    std::optional<double> timeLimit_s;     ///< elapsed time; a run cut by it may not repeat
    std::optional<std::int64_t> workLimit; ///< back end's own unit (nodes, arcs); repeats
    /** About what a solve may use at its peak; none = no limit. CBC ends when it is far beyond. */
    std::optional<std::int64_t> memoryLimit_bytes = 1'500'000'000;
    double gap = 0; ///< stop when the relative gap is at most this
    /** A re-plan, of which there are thousands: `auto` and `heuristic` end after a small part of
     * their usual work, with what gap there is then. */
    bool inFlight = false;
    /** Warm start. Of one UAV ignored when not a valid order; of several what is valid of it
     * (`validPart`) is kept, the rest put where it costs least. */
    FleetPlan hint = {};
    /** `SolveOutcome::multipliers` of a similar problem, one per node of this one, 0 where it had
     * none; any values give a valid bound. Empty: none. */
    std::vector<double> multipliers = {};
    std::stop_token stop;                                      ///< checked at least every 10 ms
    std::function<void(const SolveProgress&)> onProgress = {}; ///< called on the solving thread
};

struct SolveOutcome
{
    SolveStatus status = SolveStatus::None;
    StopReason reason = StopReason::Finished;
    FleetPlan plan = {};         ///< an order for each UAV; empty when status is None
    double objective = 0;        ///< Eq. (1) of `plan`, re-scored outside the back end
    std::optional<double> bound; ///< valid lower bound, never above `objective`
    double elapsed_s = 0;
    std::int64_t work = 0; ///< what `workLimit` counts
    bool hintUsed = false; ///< the hint was accepted as starting incumbent
    /** Of one UAV: what was learnt of the multipliers of "each iceberg once" beyond the first guess
     * (`firstMultipliers`), one per node. Empty: the answer needed none. */
    std::vector<double> multipliers = {};
    AnswerSource source = AnswerSource::None;
    std::string detail = {};                   ///< the back end's own words
    std::optional<IssueReason> whyUnable = {}; ///< not even tried

    /** That of the only UAV; empty when there is none. */
    [[nodiscard]] const VisitOrder& order() const;
};

/** Not even tried, and why. */
[[nodiscard]] SolveOutcome unable(IssueReason reason);

/**
 * One way to solve the target visitation problem of one UAV. Stateless: one object may solve on
 * several threads at once. `solve` checks the problem, the hint and the answer; a back end writes
 * `doSolve`.
 */
class TvpSolver
{
public:
    TvpSolver() = default;
    TvpSolver(const TvpSolver&) = delete;
    TvpSolver& operator=(const TvpSolver&) = delete;
    virtual ~TvpSolver() = default;

    /** What signs the answers that name no other source. */
    [[nodiscard]] virtual AnswerSource source() const = 0;

    /** Why the back end is not able to solve the problem; none: it is. */
    [[nodiscard]] virtual std::optional<IssueReason> whyNot(const TvpProblem& /*problem*/) const
    {
        return std::nullopt;
    }

    /**
     * Solves the problem within the options' limits. Limits and cancellation are outcomes, not
     * errors; a problem that `validate` faults throws `Error{InvalidInput}`.
     */
    [[nodiscard]] SolveOutcome solve(const TvpProblem& problem, const SolveOptions& options) const;

protected:
    /** `problem` is valid and has at least one iceberg; `options.hint` is empty or one valid order.
     */
    [[nodiscard]] virtual SolveOutcome doSolve(const TvpProblem& problem,
                                               const SolveOptions& options) const = 0;
};

enum class Backend
{
    Auto,
    Exact,
    Cbc,
    Heuristic
};

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
 * The solver of that name. `Exact`, `Auto` and `Heuristic` share one engine: `Exact` goes on until
 * the proof, the other two end after about a second's work, the same for every run; `Auto` proves
 * small problems by dynamic programming. Throws `Error{Unsupported}` for what this build lacks.
 */
[[nodiscard]] std::unique_ptr<TvpSolver>
makeSolver(Backend backend, Formulation formulation = Formulation::Position);

/** Monotonic seconds since construction: the one clock of the solvers. */
class Stopwatch
{
public:
    Stopwatch();
    [[nodiscard]] double elapsed_s() const;

private:
    std::int64_t m_start_ns;
};

} // namespace berg
