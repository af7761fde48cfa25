#include "core/plan/solve/subset_solver.h"

#include "core/plan/proof/piece_list.h"
#include "core/plan/solve/names.h"
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
/** Functions that are compiled twice, with and without wide vectors, must be inlined into both. */
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
/** Subsets between two checks for a stop: under 1 ms at 20 icebergs. */
constexpr std::uint32_t kSubsetsPerCheck = 4096;

/**
 * Table of g(R, i), the least cost of flying from iceberg i over all icebergs of R (i not in R) to
 * the end. With n - |R| icebergs behind it, the next one is number n - |R| + 1 and has t one more:
 *
 *   g(R, i) = min over j in R of mu d(i,j) + h(R, j),   h(R, j) = sigma_j t + g(R \ j, j);
 *
 * for latency, with w = sum sigma over R, the sigma unseen,
 *
 *   g(R, i) = min over j in R of w mu d(i,j) + h(R, j),   h(R, j) = g(R \ j, j).
 *
 * h does not depend on i, so a row g(R, .) is |R| vector operations over i (those with i in R are
 * wasted). Counting the cost to go yields the order from the front, with ties to the smallest
 * number. Icebergs count from 0 here; `Rows` is n rounded up to whole vectors: the compiler must
 * know the length of a row to keep it in registers.
 *
 * Vectors of four numbers take half the time if the processor has them, which is detected at run
 * time. They add and compare the same numbers, so the result is the same everywhere.
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

    /**
     * Fills the rows of the sets `from` .. `to` - 1, multiples of four; those below must be filled.
     */
    void fill(std::uint32_t from, std::uint32_t to)
    {
        if (hasWideVectors())
            fillWide(from, to);
        else
            fillPlain(from, to);
    }

    /** Returns the optimal order, after all sets have been filled. */
    [[nodiscard]] VisitOrder order() const
    {
        VisitOrder result;
        result.reserve(static_cast<std::size_t>(m_icebergs));
        std::uint32_t set = subsets() - 1;
        for (NodeIndex from; set != 0; from = result.back()) {
            const double t = visitNumber(set);
            const double weight = legWeight(set);
            double least = std::numeric_limits<double>::infinity();
            // Any of the set, whatever the costs, because the set must shrink.
            int next = std::countr_zero(set);
            for (std::uint32_t rest = set; rest != 0; rest &= rest - 1) {
                const int j = std::countr_zero(rest);
                const double onwards = visit(j, t) + row(set & ~(std::uint32_t{1} << j))[j];
                const double cost =
                    weight * (m_problem.mu * m_problem.distance_m(from.number(), j + 1)) + onwards;
                if (cost < least) {
                    least = cost;
                    next = j;
                }
            }
            result.push_back(NodeIndex::of(next + 1));
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
    struct Vec4
    {
        static constexpr std::size_t kParts = sizeof(Row) / sizeof(typename Vector::Value);
        typename Vector::Value parts[kParts];
    };
    static constexpr std::uint32_t kGroup = 4;
    static constexpr bool kLatency = Kind == Criterion::Latency;

    /** The cost after a flight to iceberg `j`, from the row of the set without it. */
    struct Next
    {
        const double* rest; ///< g(upper \ j, j); the three sets after it are `Rows` further on
        int j;
    };

    /** Returns part `k` of a row. */
    template <class Vector>
    [[nodiscard]] BERG_INLINE static const typename Vector::InMemory& part(const double* values,
                                                                           std::size_t k)
    {
        return reinterpret_cast<const typename Vector::InMemory*>(values)[k];
    }

    BERG_WIDE void fillWide(std::uint32_t from, std::uint32_t to) { fillBy<Four>(from, to); }
    void fillPlain(std::uint32_t from, std::uint32_t to) { fillBy<Two>(from, to); }
    template <class Vector>
    BERG_INLINE void fillBy(std::uint32_t from, std::uint32_t to)
    {
        for (std::uint32_t set = from; set < to; set += kGroup)
            fillGroup<Vector>(set);
    }

    /** Returns the cost of visiting j as number `t`, without the leg. */
    [[nodiscard]] BERG_INLINE double visit(int j, double t) const
    {
        return kLatency ? 0 : m_sigma[static_cast<std::size_t>(j)] * t;
    }
    /** Returns the factor of the next leg when the icebergs of `set` are left. */
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
    /**
     * Fills the four sets that differ in icebergs 0 and 1 only: they share the loop over
     * the others.
     */
    template <class Vector>
    BERG_INLINE void fillGroup(std::uint32_t upper)
    {
        // The array is not zeroed: that would be costly here.
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
        std::array<Next, SubsetSolver::kMostIcebergs> nexts;
        std::size_t count = 0;
        for (std::uint32_t rest = upper; rest != 0; rest &= rest - 1) {
            const int j = std::countr_zero(rest);
            nexts[count++] = {row(upper & ~(std::uint32_t{1} << j)) + j, j};
        }
        const std::span<const Next> next(nexts.data(), count);
        const double t = visitNumber(upper);

        Vec4<Vector> low[2]; // sets with none of icebergs 0 and 1, and with 0
        minimumOverUpper(upper, 0, {t, t - 1}, next, low);
        if (upper == 0)
            for (std::size_t k = 0; k < Vec4<Vector>::kParts; ++k)
                low[0].parts[k] = part<Vector>(m_endLegs.values, k);
        store(upper, low[0]);
        includeLower(upper, 1, 0, t - 1, low[1]);
        store(upper + 1, low[1]);

        Vec4<Vector> high[2]; // sets with iceberg 1, and with both
        minimumOverUpper(upper, 2, {t - 1, t - 2}, next, high);
        includeLower(upper, 2, 1, t - 1, high[0]);
        store(upper + 2, high[0]);
        includeLower(upper, 3, 0, t - 2, high[1]);
        includeLower(upper, 3, 1, t - 2, high[1]);
        store(upper + 3, high[1]);
    }

    /**
     * Computes the minimum over j in `upper`, for the sets that hold `lower` and `lower` +
     * 1 of 0 and 1.
     */
    template <class Vector>
    BERG_INLINE void minimumOverUpper(std::uint32_t upper, std::uint32_t lower,
                                      std::array<double, 2> t, std::span<const Next> nexts,
                                      Vec4<Vector> (&least)[2]) const
    {
        const std::array<double, 2> weight{legWeight(upper + lower), legWeight(upper + lower + 1)};
        for (Vec4<Vector>& lanes : least)
            for (typename Vector::Value& part : lanes.parts)
                part = typename Vector::Value{} + std::numeric_limits<double>::infinity();
        for (const Next& next : nexts)
            for (std::size_t k = 0; k < 2; ++k)
                include(next.j, weight[k], visit(next.j, t[k]) + next.rest[(lower + k) * Rows],
                        least[k]);
    }

    /** Includes j = 0 or 1, which is in `lower`, in the minimum. */
    template <class Vector>
    BERG_INLINE void includeLower(std::uint32_t upper, std::uint32_t lower, int j, double t,
                                  Vec4<Vector>& least) const
    {
        const double* rest = row(upper + (lower & ~(std::uint32_t{1} << j)));
        include(j, legWeight(upper + lower), visit(j, t) + rest[j], least);
    }

    /** Includes a flight to j, and the cost from there, in the minimum. */
    template <class Vector>
    BERG_INLINE void include(int j, double weight, double onwards, Vec4<Vector>& least) const
    {
        const double* legs = m_legs[static_cast<std::size_t>(j)].values;
        for (std::size_t k = 0; k < Vec4<Vector>::kParts; ++k) {
            const typename Vector::Value leg = part<Vector>(legs, k);
            const typename Vector::Value cost = (kLatency ? weight * leg : leg) + onwards;
            least.parts[k] = cost < least.parts[k] ? cost : least.parts[k];
        }
    }

    template <class Vector>
    BERG_INLINE void store(std::uint32_t set, const Vec4<Vector>& values)
    {
        for (std::size_t k = 0; k < Vec4<Vector>::kParts; ++k)
            reinterpret_cast<typename Vector::InMemory*>(row(set))[k] = values.parts[k];
    }

    [[nodiscard]] BERG_INLINE double* row(std::uint32_t set) const
    {
        return m_values.get() + std::size_t{set} * Rows;
    }
    /** Returns t of the next iceberg when the icebergs of `set` are left. */
    [[nodiscard]] BERG_INLINE double visitNumber(std::uint32_t set) const
    {
        return m_icebergs - std::popcount(set) + 2;
    }

    const TvpProblem& m_problem;
    int m_icebergs;
    std::unique_ptr<double[]> m_values;        ///< not zeroed: every row is written once, then read
    std::array<Row, std::size_t{Rows}> m_legs; ///< mu d to the iceberg of that number
    Row m_endLegs;                             ///< return legs of a closed route
    std::array<double, std::size_t{Rows}> m_sigma;
};

/** Returns an answer without proof: the hint, or no plan. */
SolveOutcome unprovenOutcome(StopReason reason, const FleetPlan& hint, std::int64_t work)
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
        return unprovenOutcome(StopReason::WorkLimit, options.hint, 0);
    if (options.memoryLimit_bytes && *options.memoryLimit_bytes < SubsetSolver::bytesFor(n))
        return unprovenOutcome(StopReason::MemoryLimit, options.hint, 0);

    using Table = SubsetTable<Rows, Kind>;
    const std::unique_ptr<Table, DeferredDeleter> table(new Table(problem));
    const std::int64_t all = table->subsets();
    for (std::int64_t done = 0; done < all;) {
        if (const std::optional<StopReason> reason = watch.stopReason())
            return unprovenOutcome(*reason, options.hint, done * n);
        const std::int64_t next = std::min<std::int64_t>(all, done + kSubsetsPerCheck);
        table->fill(static_cast<std::uint32_t>(done), static_cast<std::uint32_t>(next));
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

std::optional<IssueReason> SubsetSolver::unsupportedReason(const TvpProblem& problem) const
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
