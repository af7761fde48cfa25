#include "core/plan/solve/subset_solver.h"

#include "core/plan/solve/names.h"
#include "core/plan/solve/piece_list.h"
#include "core/plan/solve/solve_watch.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <memory>

namespace berg {

namespace {

#if defined(__x86_64__) && defined(__GNUC__)
#define BERG_WIDE [[gnu::target("avx2,popcnt")]]
bool hasWideVectors()
{
    static const bool has = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("popcnt");
    return has;
}
#else
#define BERG_WIDE
bool hasWideVectors()
{
    return false;
}
#endif
/** What is compiled twice, with wide vectors and without, has to be inlined for that. */
#define BERG_INLINE [[gnu::always_inline]] inline
/** Numbers that are added and compared at once. In memory they need no alignment of their own. */
struct Two
{
    using Value = double __attribute__((vector_size(16)));
    using InMemory = double __attribute__((vector_size(16), aligned(8), may_alias));
};
struct Four
{
    using Value = double __attribute__((vector_size(32)));
    using InMemory = double __attribute__((vector_size(32), aligned(8), may_alias));
};
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
 * smallest number. Icebergs count from 0 here; `Rows` is n rounded up to whole vectors: the
 * compiler must know the length of a row to keep it in registers.
 *
 * Vectors of four numbers take half the time where the processor has them, which is asked when the
 * program runs. They add and compare the same numbers, so the result is the same everywhere.
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
                m_legs[static_cast<std::size_t>(j)].values[i] =
                    real && i < m_icebergs && i != j ? problem.mu * problem.distance_m(i + 1, j + 1)
                                                     : 0.0;
        }
        m_endLegs = {};
        if (!kLatency && problem.route == Route::Closed)
            for (int i = 0; i < m_icebergs; ++i)
                m_endLegs.values[i] = problem.mu * problem.distance_m(i + 1, 0);
    }

    [[nodiscard]] std::int64_t bytes() const { return SubsetSolver::bytesFor(m_icebergs); }
    [[nodiscard]] std::uint32_t subsets() const { return std::uint32_t{1} << m_icebergs; }

    /** Treats the sets `from` .. `to` - 1, multiples of four; those below are done already. */
    void treat(std::uint32_t from, std::uint32_t to)
    {
        if (hasWideVectors())
            treatWide(from, to);
        else
            treatPlain(from, to);
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
            int next = std::countr_zero(set); // one of the set, whatever the costs: it must shrink
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
    struct alignas(32) Row
    {
        double values[std::size_t{Rows}];
    };
    /** A row in registers. */
    template <class Vector>
    struct Lanes
    {
        static constexpr std::size_t kParts = sizeof(Row) / sizeof(typename Vector::Value);
        typename Vector::Value parts[kParts];
    };
    static constexpr std::uint32_t kGroup = 4;
    static constexpr bool kLatency = Kind == Criterion::Latency;

    /** A set less one of its icebergs, and what follows a flight to that. */
    struct Next
    {
        const double* rest; ///< g(upper \ j, j), the three sets after it `Rows` on
        int j;
    };

    /** Part `k` of a row. */
    template <class Vector>
    [[nodiscard]] BERG_INLINE static const typename Vector::InMemory& part(const double* values,
                                                                           std::size_t k)
    {
        return reinterpret_cast<const typename Vector::InMemory*>(values)[k];
    }

    BERG_WIDE void treatWide(std::uint32_t from, std::uint32_t to) { treatBy<Four>(from, to); }
    void treatPlain(std::uint32_t from, std::uint32_t to) { treatBy<Two>(from, to); }
    template <class Vector>
    BERG_INLINE void treatBy(std::uint32_t from, std::uint32_t to)
    {
        for (std::uint32_t set = from; set < to; set += kGroup)
            treatGroup<Vector>(set);
    }

    /** Cost of visiting j as number `t`, beside the leg. */
    [[nodiscard]] BERG_INLINE double visit(int j, double t) const
    {
        return kLatency ? 0 : m_sigma[static_cast<std::size_t>(j)] * t;
    }
    /** How often the next leg counts when the icebergs of `set` are left. */
    [[nodiscard]] BERG_INLINE double legWeight(std::uint32_t set) const
    {
        double weight = 1;
        if constexpr (kLatency) {
            weight = 0;
            for (std::uint32_t rest = set; rest != 0; rest &= rest - 1)
                weight += m_sigma[static_cast<std::size_t>(std::countr_zero(rest))];
        }
        return weight;
    }
    /** The four sets that differ in icebergs 0 and 1 only: they share the loop over the others. */
    template <class Vector>
    BERG_INLINE void treatGroup(std::uint32_t upper)
    {
        // Not zeroed: that would be dear here.
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
        std::array<Next, SubsetSolver::kMostIcebergs> nexts;
        std::size_t count = 0;
        for (std::uint32_t rest = upper; rest != 0; rest &= rest - 1) {
            const int j = std::countr_zero(rest);
            nexts[count++] = {row(upper & ~(std::uint32_t{1} << j)) + j, j};
        }
        const std::span<const Next> next(nexts.data(), count);
        const double t = visitNumber(upper);

        Lanes<Vector> low[2]; // of icebergs 0 and 1: none, 0
        overUpper(upper, 0, {t, t - 1}, next, low);
        if (upper == 0)
            for (std::size_t k = 0; k < Lanes<Vector>::kParts; ++k)
                low[0].parts[k] = part<Vector>(m_endLegs.values, k);
        store(upper, low[0]);
        over(upper, 1, 0, t - 1, low[1]);
        store(upper + 1, low[1]);

        Lanes<Vector> high[2]; // of icebergs 0 and 1: 1, both
        overUpper(upper, 2, {t - 1, t - 2}, next, high);
        over(upper, 2, 1, t - 1, high[0]);
        store(upper + 2, high[0]);
        over(upper, 3, 0, t - 2, high[1]);
        over(upper, 3, 1, t - 2, high[1]);
        store(upper + 3, high[1]);
    }

    /** The minimum over j in `upper`, for the sets that hold `lower` and `lower` + 1 of 0 and 1. */
    template <class Vector>
    BERG_INLINE void overUpper(std::uint32_t upper, std::uint32_t lower, std::array<double, 2> t,
                               std::span<const Next> nexts, Lanes<Vector> (&least)[2]) const
    {
        const std::array<double, 2> weight{legWeight(upper + lower), legWeight(upper + lower + 1)};
        for (Lanes<Vector>& lanes : least)
            for (typename Vector::Value& part : lanes.parts)
                part = typename Vector::Value{} + std::numeric_limits<double>::infinity();
        for (const Next& next : nexts)
            for (std::size_t k = 0; k < 2; ++k)
                take(next.j, weight[k], visit(next.j, t[k]) + next.rest[(lower + k) * Rows],
                     least[k]);
    }

    /** The same for j = 0 or 1, which is in `lower`. */
    template <class Vector>
    BERG_INLINE void over(std::uint32_t upper, std::uint32_t lower, int j, double t,
                          Lanes<Vector>& least) const
    {
        const double* rest = row(upper + (lower & ~(std::uint32_t{1} << j)));
        take(j, legWeight(upper + lower), visit(j, t) + rest[j], least);
    }

    /** Flying to j next, and what it costs from there. */
    template <class Vector>
    BERG_INLINE void take(int j, double weight, double onwards, Lanes<Vector>& least) const
    {
        const double* legs = m_legs[static_cast<std::size_t>(j)].values;
        for (std::size_t k = 0; k < Lanes<Vector>::kParts; ++k) {
            const typename Vector::Value leg = part<Vector>(legs, k);
            const typename Vector::Value cost = (kLatency ? weight * leg : leg) + onwards;
            least.parts[k] = cost < least.parts[k] ? cost : least.parts[k];
        }
    }

    template <class Vector>
    BERG_INLINE void store(std::uint32_t set, const Lanes<Vector>& values)
    {
        for (std::size_t k = 0; k < Lanes<Vector>::kParts; ++k)
            reinterpret_cast<typename Vector::InMemory*>(row(set))[k] = values.parts[k];
    }

    [[nodiscard]] BERG_INLINE double* row(std::uint32_t set) const
    {
        return m_values.get() + std::size_t{set} * Rows;
    }
    /** t of the iceberg that is flown to next when the icebergs of `set` are left. */
    [[nodiscard]] BERG_INLINE double visitNumber(std::uint32_t set) const
    {
        return m_icebergs - std::popcount(set) + 2;
    }

    const TvpProblem& m_problem;
    int m_icebergs;
    std::unique_ptr<double[]> m_values;        ///< not zeroed: every row is written once, then read
    std::array<Row, std::size_t{Rows}> m_legs; ///< mu d to the iceberg of that number
    Row m_endLegs;                             ///< the way back of a closed route
    std::array<double, std::size_t{Rows}> m_sigma;
};

/** An answer without proof: the hint, or nothing. */
SolveOutcome cutShort(StopReason reason, const FleetPlan& hint, std::int64_t work)
{
    return {.status = hint.empty() ? SolveStatus::None : SolveStatus::Feasible,
            .reason = reason,
            .plan = hint,
            .work = work,
            .hintUsed = !hint.empty()};
}

SolveOutcome proven(VisitOrder order, std::int64_t work, const TvpProblem& problem,
                    const SolveOptions& options, const SolveWatch& watch)
{
    SolveOutcome outcome{.status = SolveStatus::Optimal, .plan = {std::move(order)}, .work = work};
    if (options.onProgress) {
        const double value = objective(problem, outcome.order());
        watch.report(outcome.plan, value, value);
    }
    return outcome;
}

template <int Rows, Criterion Kind>
SolveOutcome solveWithRows(const TvpProblem& problem, const SolveOptions& options)
{
    const SolveWatch watch(options);
    if (!options.hint.empty() && options.onProgress)
        watch.report(options.hint, objective(problem, options.hint.front()), std::nullopt);

    const int n = problem.icebergCount();
    if (options.workLimit && *options.workLimit < SubsetSolver::workFor(n))
        return cutShort(StopReason::WorkLimit, options.hint, 0);
    if (options.memoryLimit_bytes && *options.memoryLimit_bytes < SubsetSolver::bytesFor(n))
        return cutShort(StopReason::MemoryLimit, options.hint, 0);

    using Table = SubsetTable<Rows, Kind>;
    const std::unique_ptr<Table, FreeElsewhere> table(new Table(problem));
    const std::int64_t all = table->subsets();
    for (std::int64_t done = 0; done < all;) {
        if (const std::optional<StopReason> reason = watch.cut())
            return cutShort(*reason, options.hint, done * n);
        const std::int64_t next = std::min<std::int64_t>(all, done + kSubsetsPerCheck);
        table->treat(static_cast<std::uint32_t>(done), static_cast<std::uint32_t>(next));
        done = next;
    }
    return proven(table->order(), all * n, problem, options, watch);
}

template <int Rows>
SolveOutcome solveWithAtLeast(const TvpProblem& problem, const SolveOptions& options)
{
    if constexpr (Rows < SubsetSolver::kMostIcebergs)
        if (problem.icebergCount() > Rows)
            return solveWithAtLeast<Rows + 4>(problem, options);
    return problem.criterion == Criterion::Latency
               ? solveWithRows<Rows, Criterion::Latency>(problem, options)
               : solveWithRows<Rows, Criterion::Visitation>(problem, options);
}

} // namespace

std::optional<IssueReason> SubsetSolver::whyNot(const TvpProblem& problem) const
{
    if (problem.icebergCount() <= SubsetSolver::kMostIcebergs)
        return std::nullopt;
    return IssueReason{
        IssueId::ProofTooLarge,
        {nameOf(kBackendNames, Backend::Exact), std::int64_t{SubsetSolver::kMostIcebergs}}};
}

SolveOutcome SubsetSolver::doSolve(const TvpProblem& problem, const SolveOptions& options) const
{
    return solveWithAtLeast<4>(problem, options);
}

} // namespace berg
