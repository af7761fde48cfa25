#include "core/plan/subset_solver.h"

#include "core/plan/solve_watch.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <memory>

namespace berg {

namespace {

constexpr int kMostIcebergs = SubsetSolver::kMostIcebergs;
/** Subsets between two looks at the clock: under 1 ms at 20 icebergs. */
constexpr std::uint32_t kSubsetsPerCheck = 4096;

/**
 * g(R, i): least cost of flying from iceberg i over all icebergs of R (i not in R) to the end.
 * With n - |R| icebergs behind it, the next one is number n - |R| + 1 and has t one more:
 *   g(R, i) = min over j in R of mu d(i,j) + h(R, j),   h(R, j) = sigma_j t + g(R \ j, j);
 * for latency with the sigma of R unseen
 *   g(R, i) = min over j in R of w mu d(i,j) + h(R, j), w = sum sigma over R, h(R, j) = g(R \ j,
 * j). h does not depend on i, so a row g(R, .) is |R| vector operations over i (those with i in R
 * are wasted). Counting the cost to go makes the order come out from the front, ties to the
 * smallest number. Icebergs count from 0 here; `Rows` is n rounded up to even: the compiler must
 * know the length of a row to keep it in registers.
 */
template <int Rows, Criterion Kind>
class SubsetTable
{
public:
    explicit SubsetTable(const TvpProblem& problem)
        : m_problem(problem)
        , m_icebergs(problem.icebergCount())
        , m_values(new double[std::max<std::size_t>(subsets(), kGroup) * Rows])
    {
        for (int j = 0; j < Rows; ++j) {
            const bool real = j < m_icebergs;
            m_sigma[static_cast<std::size_t>(j)] =
                real ? problem.sigma_m2[static_cast<std::size_t>(j) + 1] : 0.0;
            for (int i = 0; i < Rows; ++i)
                m_legs(i, j) = real && i < m_icebergs && i != j
                                   ? problem.mu * problem.distance_m(i + 1, j + 1)
                                   : 0.0;
        }
    }

    [[nodiscard]] std::uint32_t subsets() const { return std::uint32_t{1} << m_icebergs; }

    /** Treats the sets `from` .. `to` - 1, multiples of four; those below are done already. */
    void treat(std::uint32_t from, std::uint32_t to)
    {
        for (std::uint32_t set = from; set < to; set += kGroup)
            treatGroup(set);
    }

    /** The optimal order, after all sets have been treated. */
    [[nodiscard]] VisitOrder order() const
    {
        VisitOrder result;
        result.reserve(static_cast<std::size_t>(m_icebergs));
        std::uint32_t set = subsets() - 1;
        for (int from = 0; set != 0; from = result.back()) {
            const double t = visitNumber(set);
            const double weight = legWeight(set);
            double least = std::numeric_limits<double>::infinity();
            int next = 0;
            for (std::uint32_t rest = set; rest != 0; rest &= rest - 1) {
                const int j = std::countr_zero(rest);
                const double onwards = visit(j, t) + row(set & ~(std::uint32_t{1} << j))[j];
                const double cost =
                    weight * (m_problem.mu * m_problem.distance_m(from, j + 1)) + onwards;
                if (cost < least) {
                    least = cost;
                    next = j;
                }
            }
            result.push_back(next + 1);
            set &= ~(std::uint32_t{1} << next);
        }
        return result;
    }

private:
    using Row = Eigen::Array<double, Rows, 1>;
    static constexpr std::uint32_t kGroup = 4;
    static constexpr bool kLatency = Kind == Criterion::Latency;

    /** Cost of visiting j as number `t`, beside the leg. */
    [[nodiscard]] double visit(int j, double t) const
    {
        return kLatency ? 0 : m_sigma[static_cast<std::size_t>(j)] * t;
    }
    /** How often the next leg counts when the icebergs of `set` are left. */
    [[nodiscard]] double legWeight(std::uint32_t set) const
    {
        double weight = 1;
        if constexpr (kLatency) {
            weight = 0;
            for (std::uint32_t rest = set; rest != 0; rest &= rest - 1)
                weight += m_sigma[static_cast<std::size_t>(std::countr_zero(rest))];
        }
        return weight;
    }
    /** Legs to j from all icebergs, as often as they count. */
    [[nodiscard]] auto legsTo(int j, double weight) const
    {
        if constexpr (kLatency)
            return weight * m_legs.col(j);
        else
            return m_legs.col(j);
    }

    /** The four sets that differ in icebergs 0 and 1 only: they share the loop over the others. */
    void treatGroup(std::uint32_t upper)
    {
        struct Next
        {
            const double* rest = nullptr; ///< g(upper \ j, j), the three sets after it `Rows` on
            int j = 0;
        };
        std::array<Next, kMostIcebergs> nexts;
        int count = 0;
        for (std::uint32_t rest = upper; rest != 0; rest &= rest - 1) {
            const int j = std::countr_zero(rest);
            nexts[static_cast<std::size_t>(count++)] = {row(upper & ~(std::uint32_t{1} << j)) + j,
                                                        j};
        }

        const auto overUpper = [&](std::uint32_t lower, double t) {
            const double weight = legWeight(upper + lower);
            Row least = Row::Constant(std::numeric_limits<double>::infinity());
            for (int k = 0; k < count; ++k) {
                const Next& next = nexts[static_cast<std::size_t>(k)];
                least = least.min(legsTo(next.j, weight) +
                                  (visit(next.j, t) + next.rest[lower * Rows]));
            }
            return least;
        };
        const auto over = [&](std::uint32_t lower, int j, double t) -> Row {
            const std::uint32_t rest = lower & ~(std::uint32_t{1} << j);
            return legsTo(j, legWeight(upper + lower)) +
                   (visit(j, t) + row(upper)[rest * Rows + static_cast<std::uint32_t>(j)]);
        };
        const auto store = [&](std::uint32_t lower, const Row& values) {
            Eigen::Map<Row, Eigen::Aligned16>(row(upper) + lower * Rows) = values;
        };
        const double t = visitNumber(upper);
        store(0, upper == 0 ? endLegs() : overUpper(0, t));
        store(1, overUpper(1, t - 1).min(over(1, 0, t - 1)));
        store(2, overUpper(2, t - 1).min(over(2, 1, t - 1)));
        store(3, overUpper(3, t - 2).min(over(3, 0, t - 2)).min(over(3, 1, t - 2)));
    }

    [[nodiscard]] Row endLegs() const
    {
        Row legs = Row::Zero();
        if (!kLatency && m_problem.route == Route::Closed)
            for (int i = 0; i < m_icebergs; ++i)
                legs(i) = m_problem.mu * m_problem.distance_m(i + 1, 0);
        return legs;
    }
    [[nodiscard]] double* row(std::uint32_t set) const
    {
        return m_values.get() + std::size_t{set} * Rows;
    }
    /** t of the iceberg that is flown to next when the icebergs of `set` are left. */
    [[nodiscard]] double visitNumber(std::uint32_t set) const
    {
        return m_icebergs - std::popcount(set) + 2;
    }

    const TvpProblem& m_problem;
    int m_icebergs;
    std::unique_ptr<double[]> m_values;      ///< not zeroed: every row is written once, then read
    Eigen::Array<double, Rows, Rows> m_legs; ///< mu d, column = to
    std::array<double, std::size_t{Rows}> m_sigma;
};

/** An answer without proof: the hint, or nothing. */
SolveOutcome cutShort(StopReason reason, const VisitOrder& hint, std::int64_t work)
{
    SolveOutcome outcome;
    outcome.status = hint.empty() ? SolveStatus::None : SolveStatus::Feasible;
    outcome.reason = reason;
    outcome.order = hint;
    outcome.work = work;
    outcome.hintUsed = !hint.empty();
    return outcome;
}

SolveOutcome proven(VisitOrder order, std::int64_t work, const TvpProblem& problem,
                    const SolveOptions& options, const SolveWatch& watch)
{
    SolveOutcome outcome;
    outcome.status = SolveStatus::Optimal;
    outcome.order = std::move(order);
    outcome.work = work;
    if (options.onProgress) {
        const double value = objective(problem, outcome.order);
        watch.report(outcome.order, value, value);
    }
    return outcome;
}

template <int Rows, Criterion Kind>
SolveOutcome solveWithRows(const TvpProblem& problem, const SolveOptions& options)
{
    const SolveWatch watch(options);
    if (!options.hint.empty() && options.onProgress)
        watch.report(options.hint, objective(problem, options.hint), std::nullopt);

    const int n = problem.icebergCount();
    if (options.workLimit && *options.workLimit < SubsetSolver::workFor(n))
        return cutShort(StopReason::WorkLimit, options.hint, 0);
    if (options.memoryLimit_bytes && *options.memoryLimit_bytes < SubsetSolver::bytesFor(n))
        return cutShort(StopReason::MemoryLimit, options.hint, 0);

    SubsetTable<Rows, Kind> table(problem);
    const std::int64_t all = table.subsets();
    for (std::int64_t done = 0; done < all;) {
        if (const std::optional<StopReason> reason = watch.cut())
            return cutShort(*reason, options.hint, done * n);
        const std::int64_t next = std::min<std::int64_t>(all, done + kSubsetsPerCheck);
        table.treat(static_cast<std::uint32_t>(done), static_cast<std::uint32_t>(next));
        done = next;
    }
    return proven(table.order(), all * n, problem, options, watch);
}

template <int Rows>
SolveOutcome solveWithAtLeast(const TvpProblem& problem, const SolveOptions& options)
{
    if constexpr (Rows < kMostIcebergs)
        if (problem.icebergCount() > Rows)
            return solveWithAtLeast<Rows + 2>(problem, options);
    return problem.criterion == Criterion::Latency
               ? solveWithRows<Rows, Criterion::Latency>(problem, options)
               : solveWithRows<Rows, Criterion::Visitation>(problem, options);
}

} // namespace

std::string SubsetSolver::whyNot(const TvpProblem& problem) const
{
    if (problem.icebergCount() <= kMostIcebergs)
        return {};
    return "Dynamic programming over subsets is limited to " + std::to_string(kMostIcebergs) +
           " icebergs.";
}

SolveOutcome SubsetSolver::doSolve(const TvpProblem& problem, const SolveOptions& options) const
{
    return solveWithAtLeast<2>(problem, options);
}

} // namespace berg
