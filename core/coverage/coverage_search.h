#pragma once

#include "core/coverage/coverage_moves.h"
#include "core/plan/solve/solve_watch.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace berg {

/** A plan and what it costs. */
struct CoverageResult
{
    CoveragePlan plan;    ///< as far as the horizon
    double total_m2s = 0; ///< predicted, see `CoverageModel::total_m2s`
};

/** To which icebergs plans may have legs; each empty: to all. */
struct CoverageLimits
{
    std::vector<bool> any;   ///< at all
    std::vector<bool> first; ///< first of all, but for holds
};

/** How an annealing cools down, in work. */
struct CoverageCooling
{
    std::int64_t begin = 0;
    std::int64_t end = 0;
    double hottest_m2s = 0; ///< at the beginning
};

/**
 * Improves plans by simulated annealing over the legs and their offsets. Effort is counted in work,
 * so that the same work gives the same plan on every machine: a leg predicted is 20 units and one
 * for each iceberg, a unit about 10 to 20 ns. Borrows the model, which has an iceberg at least.
 */
class CoverageSearch
{
public:
    /** A leg costs as much as so many icebergs before it looks at any. */
    static constexpr std::int64_t kWorkOfLeg = 20;

    CoverageSearch(const CoverageModel& model, const Random& random, CoverageLimits limits = {});

    /** The plan flown to the horizon: legs without use left out, greedy ones added at its end. */
    [[nodiscard]] CoverageResult completed(const CoveragePlan& plan);

    /**
     * The best plan found from `start` on until `work()` comes to `untilWork` or the watch says
     * stop; never worse than `start`. `heat`: temperature at the beginning, of the start's cost.
     */
    [[nodiscard]] CoverageResult improved(const CoverageResult& start, std::int64_t untilWork,
                                          double heat, const SolveWatch& watch);

    /**
     * Part of an annealing: goes on from `now` until `work()` comes to `untilWork`. `best` is
     * replaced by what costs less. Returns where it has come to.
     */
    [[nodiscard]] CoverageResult annealed(const CoveragePlan& now, const CoverageCooling& cooling,
                                          std::int64_t untilWork, const SolveWatch& watch,
                                          CoverageResult& best);

    /** To which icebergs the first leg may go from now on; empty: to all. */
    void setFirst(std::vector<bool> first) { m_limits.first = std::move(first); }

    [[nodiscard]] std::int64_t work() const { return m_work; }

    /** Is told each plan better than all those before, of any start; changes nothing. */
    void setListener(std::function<void(const CoverageResult&)> listener)
    {
        m_listener = std::move(listener);
    }

private:
    /** Legs and the states after each of them, with the cost up to then. */
    struct Flown
    {
        CoveragePlan legs;
        std::vector<CoverageState> states; ///< at least one per leg, the rest is room
        std::vector<double> soFar_m2s;
        double total_m2s = 0;
    };

    void load(const CoveragePlan& plan);
    void anneal(const CoverageCooling& cooling, std::int64_t untilWork, const SolveWatch& watch,
                CoverageResult& best);
    [[nodiscard]] const CoverageState& stateBefore(std::size_t leg) const
    {
        return leg == 0 ? m_start : m_now.states[leg - 1];
    }
    [[nodiscard]] std::int64_t workOfLeg() const { return kWorkOfLeg + m_model.placeCount(); }
    bool flyTail(std::size_t from, double limit_m2s);
    bool addToTail(const CoverageState& before, const CoverageLeg& leg);
    void tell(const CoverageResult& better);
    [[nodiscard]] bool hopeless(double limit_m2s, std::size_t& place) const;
    [[nodiscard]] bool mayFly(const CoverageLeg& leg, bool isFirst) const;
    [[nodiscard]] std::optional<CoverageLeg> greedyLeg(const CoverageState& state,
                                                       bool isFirst) const;
    void accept(std::size_t from);

    const CoverageModel& m_model;
    CoverageLimits m_limits;
    CoverageMoves m_moves;
    std::int64_t m_work = 0;
    std::function<void(const CoverageResult&)> m_listener;
    double m_told_m2s = std::numeric_limits<double>::infinity(); ///< the best told of
    CoverageState m_start;
    Flown m_now;
    CoveragePlan m_candidate; ///< the present legs with a change
    Flown m_tail;             ///< its flight from the change on
};

} // namespace berg
