#include "core/plan/policy/tau_curve.h"

#include "core/base/solving_guard.h"
#include "core/plan/fleet/fleet_solver.h"
#include "core/plan/problem/tuning.h"
#include "core/plan/proof/certified.h"
#include "core/plan/proof/layered_bound.h"
#include "core/plan/solve/order_search.h"
#include "core/plan/solve/subset_solver.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

namespace berg {

namespace {

/** With more icebergs the layered bound is faster than dynamic programming. */
constexpr int kLargestByTable = 13;
/** With more icebergs `improveBound` proves nothing. */
constexpr int kLargestProven = 127;
/** Work limit of one proof, so that a single hard one does not use up everything. */
constexpr std::int64_t kMostWorkOfProof = 900'000'000;

/** Low, because a curve is made alongside other work. */
constexpr std::int64_t kMostMemory_bytes = 500'000'000;

/**
 * Work limit of one solve for several UAVs, about as long as a proof: dynamic programming, or a
 * search that proves little.
 */
constexpr std::int64_t kWorkOfFleet = 60'000'000;

/**
 * Returns the restarts of the local search at one crossing: fewer than usual, because a neighbour
 * is a good start.
 */
std::int64_t restartsFor(std::int64_t icebergs)
{
    return std::min<std::int64_t>(icebergs * icebergs / 50, 150);
}

/**
 * Returns the work of one move of a search: far more if the distances do not fit into the cache.
 */
std::int64_t workOfMove(std::int64_t icebergs)
{
    return 1 + icebergs * icebergs / 500'000;
}

/** State of knowledge of the optimum at a crossing of two lines. */
enum class Knowledge
{
    Searched, ///< the local search found nothing better, or used up its work
    Proven,
    GivenUp ///< not proven within the limits
};

/** A known plan as a line in tau: F = tau k D - R. */
struct Line
{
    FleetPlan plan;
    double distance_m = 0;
    double reward_m2 = 0;
};

/** A point at which the curve is examined: lines `left` and `right` meet at `tau`. */
struct Crossing
{
    int left = 0;
    std::optional<int> right = {}; ///< nullopt at the end of the curve
    double tau = 0;
};

class CurveSearch
{
public:
    CurveSearch(const FleetProblem& problem, const TauCurveOptions& options, double muPerTau)
        : m_problem(problem), m_options(options), m_muPerTau(muPerTau)
    {
        m_problem.mu = 0;
        // No plan costs less than 2 sum(sigma), so this is at most a tenth of the tolerance.
        m_same_m2 = 0.1 * kProofTolerance * 2 * objectiveShift(problem) / problem.nodeCount();
        // The plan with the largest reward is optimal at tau = 0.
        if (m_isAlone) {
            addLine({sigmaOrder(problemOfUav(m_problem, 0))});
        } else if (SolveOutcome first = solveFleet(m_problem, Backend::Auto, limits());
                   first.status != SolveStatus::None) {
            m_isFirstProven = first.status == SolveStatus::Optimal;
            addLine(first.plan);
        }
    }

    TauCurve run()
    {
        if (m_lines.empty())
            return curve(StopReason::Cancelled);
        while (const std::optional<Crossing> crossing = nextToExamine()) {
            if (m_options.stop.stop_requested())
                return curve(StopReason::Cancelled);
            examine(*crossing);
            if (m_options.onProgress)
                m_options.onProgress(curve(StopReason::Finished));
        }
        TauCurve result = curve(StopReason::Finished);
        result.complete = true;
        if (std::any_of(result.intervals.begin(), result.intervals.end(),
                        [](const CurveInterval& interval) { return !interval.proven; }))
            result.reason = StopReason::WorkLimit;
        return result;
    }

private:
    /** Returns the tau at which two lines meet; the first has the larger reward and distance. */
    [[nodiscard]] double crossing(int a, int b) const
    {
        const Line& first = line(a);
        const Line& second = line(b);
        return (first.reward_m2 - second.reward_m2) /
               (m_muPerTau * (first.distance_m - second.distance_m));
    }
    [[nodiscard]] const Line& line(int number) const
    {
        return m_lines[static_cast<std::size_t>(number)];
    }

    void addLine(const FleetPlan& plan)
    {
        m_lines.push_back({.plan = plan,
                           .distance_m = fleetDistance(m_problem, plan),
                           .reward_m2 = fleetReward(m_problem, plan)});
        refreshEnvelope();
    }

    /**
     * Updates the lower envelope of the lines over (0, tauMax): the best line and where it ends.
     */
    void refreshEnvelope()
    {
        std::vector<int> numbers(m_lines.size());
        for (std::size_t i = 0; i < numbers.size(); ++i)
            numbers[i] = static_cast<int>(i);
        std::sort(numbers.begin(), numbers.end(), [this](int a, int b) {
            return std::tuple(-line(a).reward_m2, line(a).distance_m, a) <
                   std::tuple(-line(b).reward_m2, line(b).distance_m, b);
        });
        m_envelope.clear();
        for (const int number : numbers) {
            if (!m_envelope.empty() &&
                line(number).distance_m >= line(m_envelope.back().left).distance_m)
                continue; // it has less reward for no less distance
            while (!m_envelope.empty()) {
                Crossing& last = m_envelope.back();
                last.right = number;
                last.tau = crossing(last.left, number);
                const bool same = line(last.left).reward_m2 - line(number).reward_m2 <= m_same_m2;
                const bool hidden =
                    m_envelope.size() > 1 && last.tau <= m_envelope[m_envelope.size() - 2].tau;
                if (!same && !hidden)
                    break;
                m_envelope.pop_back();
            }
            m_envelope.push_back({.left = number});
        }
        const auto beyond =
            std::find_if(m_envelope.begin(), m_envelope.end(), [this](const Crossing& c) {
                return !c.right || c.tau >= m_options.tauMax;
            });
        beyond->right.reset();
        beyond->tau = m_options.tauMax;
        m_envelope.erase(beyond + 1, m_envelope.end());
    }

    [[nodiscard]] std::optional<Knowledge> knowledge(const Crossing& crossing) const
    {
        const auto it = m_known.find({crossing.left, crossing.right});
        return it == m_known.end() ? std::nullopt : std::optional(it->second);
    }

    /**
     * Returns the next crossing to examine. Searches come before proofs: they give the proofs good
     * incumbents, and fewer crossings to prove.
     */
    [[nodiscard]] std::optional<Crossing> nextToExamine() const
    {
        std::optional<Crossing> toProve;
        for (const Crossing& crossing : m_envelope) {
            const std::optional<Knowledge> known = knowledge(crossing);
            if (!known)
                return crossing;
            if (known == Knowledge::Searched && !toProve)
                toProve = crossing;
        }
        return toProve;
    }

    /** Examines a crossing; if cancelled, leaves its state unchanged. */
    void examine(const Crossing& crossing)
    {
        m_problem.mu = m_muPerTau * crossing.tau;
        std::optional<Knowledge> known;
        if (!m_isAlone)
            known = solveTogether(crossing);
        else if (m_problem.icebergCount() <= kLargestByTable)
            known = solve(crossing);
        else if (!knowledge(crossing))
            known = search(crossing);
        else
            known = prove(crossing);
        if (known)
            m_known[{crossing.left, crossing.right}] = *known;
    }

    [[nodiscard]] SolveOptions limits() const
    {
        return {.workLimit = kWorkOfFleet, .stop = m_options.stop};
    }

    std::optional<Knowledge> solveTogether(const Crossing& crossing)
    {
        if (m_work >= m_options.workLimit)
            return Knowledge::GivenUp;
        SolveOptions options = limits();
        options.hint = line(crossing.left).plan;
        const SolveOutcome outcome = solveFleet(m_problem, Backend::Auto, options);
        if (m_options.stop.stop_requested())
            return std::nullopt;
        m_work += outcome.work;
        offer(outcome.plan, crossing);
        return outcome.status == SolveStatus::Optimal ? Knowledge::Proven : Knowledge::GivenUp;
    }

    std::optional<Knowledge> solve(const Crossing& crossing)
    {
        const SolveOutcome outcome =
            SubsetSolver().solve(problemOfUav(m_problem, 0), {.stop = m_options.stop});
        if (outcome.status != SolveStatus::Optimal)
            return std::nullopt;
        offer(outcome.plan, crossing);
        return Knowledge::Proven;
    }

    std::optional<Knowledge> search(const Crossing& crossing)
    {
        if (m_searched >= m_options.workLimit)
            return Knowledge::Searched;
        const VisitCosts costs(problemOfUav(m_problem, 0));
        const std::int64_t moveWork = workOfMove(costs.icebergs);
        SearchEffort effort{.isStopped = [this] { return m_options.stop.stop_requested(); },
                            .limit = (m_options.workLimit - m_searched) / moveWork + 1};
        OrderSearch search(costs, effort);
        search.accept(line(crossing.left).plan.front());
        search.disturb(restartsFor(costs.icebergs));
        if (m_options.stop.stop_requested())
            return std::nullopt;
        m_searched += effort.work * moveWork;
        offer({search.best()}, crossing);
        return Knowledge::Searched;
    }

    std::optional<Knowledge> prove(const Crossing& crossing)
    {
        BoundOptions options;
        options.memoryLimit_bytes = kMostMemory_bytes;
        options.workLimit = std::min(kMostWorkOfProof, m_options.workLimit - m_work);
        if (options.workLimit <= 0 || m_problem.icebergCount() > kLargestProven)
            return Knowledge::GivenUp;
        options.isStopped = [this] { return m_options.stop.stop_requested(); };
        const BoundResult result =
            improveBound(VisitCosts(problemOfUav(m_problem, 0)), line(crossing.left).plan.front(),
                         options, {.lambda = multipliersNear(crossing.tau)});
        m_work += result.work;
        if (m_options.stop.stop_requested())
            return std::nullopt;
        m_multipliers[crossing.tau] = result.step.lambda;
        offer(result.plan, crossing);
        return result.reached ? Knowledge::Proven : Knowledge::GivenUp;
    }

    /** Adds a line for the plan if it is better at the crossing. */
    void offer(const FleetPlan& plan, const Crossing& crossing)
    {
        const double shift = objectiveShift(m_problem);
        const double known = fleetObjective(m_problem, line(crossing.left).plan) + shift;
        if (fleetObjective(m_problem, plan) + shift < cutoffBelow(known, 0))
            addLine(plan);
    }

    /**
     * Returns multipliers to start a proof with: interpolated between the nearest crossings
     * examined before. The bound is concave in multipliers and tau together, so it is as good as
     * there.
     */
    [[nodiscard]] std::optional<Eigen::VectorXd> multipliersNear(double tau) const
    {
        const auto above = m_multipliers.lower_bound(tau);
        if (above == m_multipliers.end())
            return m_multipliers.empty() ? std::nullopt : std::optional(std::prev(above)->second);
        if (above == m_multipliers.begin())
            return above->second;
        const auto below = std::prev(above);
        const double share = (tau - below->first) / (above->first - below->first);
        return (1 - share) * below->second + share * above->second;
    }

    [[nodiscard]] TauCurve curve(StopReason reason) const
    {
        TauCurve result{.intervals = {}, .reason = reason};
        bool fromProven = m_isFirstProven;
        for (const Crossing& end : m_envelope) {
            const bool toProven = knowledge(end) == Knowledge::Proven;
            const Line& best = line(end.left);
            // A plan optimal at both ends is optimal between: the optimum is concave and this line
            // is straight.
            result.intervals.push_back(
                {.tauFrom = result.intervals.empty() ? 0 : result.intervals.back().tauTo,
                 .tauTo = end.tau,
                 .plan = best.plan,
                 .distance_m = best.distance_m,
                 .reward_m2 = best.reward_m2,
                 .proven = fromProven && toProven});
            fromProven = toProven;
        }
        return result;
    }

    FleetProblem m_problem; ///< its mu is that of the crossing under examination
    bool m_isAlone = m_problem.uavCount() == 1;
    bool m_isFirstProven = true; ///< whether the plan at tau = 0 is proven
    const TauCurveOptions& m_options;
    double m_muPerTau;
    /** Rewards closer than this count as equal: sigmas that differ by rounding are ties. */
    double m_same_m2 = 0;
    std::vector<Line> m_lines;
    std::vector<Crossing> m_envelope; ///< left to right; the last one is the end
    std::map<std::pair<int, std::optional<int>>, Knowledge> m_known; ///< by lines of the crossing
    std::map<double, Eigen::VectorXd> m_multipliers;                 ///< by tau of the crossing
    std::int64_t m_work = 0;                                         ///< work of proofs
    std::int64_t m_searched = 0;                                     ///< work of searches
};

/**
 * Returns a curve with one plan, for problems whose mu does not depend on tau or that have nothing
 * to visit.
 */
TauCurve constantCurve(FleetProblem problem, const TauCurveOptions& options, double mu)
{
    problem.mu = mu;
    const SolveOutcome outcome =
        solve(problem, Backend::Auto, *makeSolver(Backend::Auto), {.stop = options.stop});
    TauCurve curve{.intervals = {}, .reason = outcome.reason};
    if (outcome.status != SolveStatus::None)
        curve.intervals.push_back({.tauFrom = 0,
                                   .tauTo = options.tauMax,
                                   .plan = outcome.plan,
                                   .distance_m = fleetDistance(problem, outcome.plan),
                                   .reward_m2 = fleetReward(problem, outcome.plan),
                                   .proven = outcome.status == SolveStatus::Optimal});
    curve.complete = outcome.reason != StopReason::Cancelled;
    return curve;
}

} // namespace

TauCurve tauCurve(const FleetProblem& problem, const Eigen::MatrixXd& betweenStarts_m,
                  const TauCurveOptions& options)
{
    requireSolvingAllowed();
    require(options.tauMax > 0, "tauCurve: tauMax must be positive");
    FleetProblem checked = problem;
    checked.mu = 0;
    if (std::vector<Issue> issues = validate(checked); !issues.empty())
        throw Error(ErrorCode::InvalidInput, "problem", std::move(issues));

    const TuningWeight weight = fleetTuningWeight(checked, betweenStarts_m, 1);
    checked.mu = weight.mu * options.tauMax;
    if (std::vector<Issue> issues = validate(checked); !issues.empty())
        throw Error(ErrorCode::InvalidInput, "problem", std::move(issues));
    if (weight.distanceOnly || weight.mu == 0)
        return constantCurve(std::move(checked), options, weight.mu);
    return CurveSearch(checked, options, weight.mu).run();
}

std::optional<int> intervalAt(const TauCurve& curve, double tau)
{
    if (curve.intervals.empty())
        return std::nullopt;
    const auto above = std::find_if(curve.intervals.begin(), curve.intervals.end(),
                                    [tau](const CurveInterval& i) { return tau < i.tauTo; });
    const auto count = static_cast<int>(curve.intervals.size());
    return std::min(static_cast<int>(above - curve.intervals.begin()), count - 1);
}

} // namespace berg
