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
    CoveragePlan plan;    ///< Plan up to the horizon.
    double total_m2s = 0; ///< Predicted cost, see `CoverageModel::total_m2s`.
};

/** Places to which plans may have legs; an empty list allows all. */
struct CoverageLimits
{
    std::vector<bool> any;   ///< Places to which any leg may go.
    std::vector<bool> first; ///< Places to which the first leg other than a hold may go.
};

/** Temperature schedule of an annealing over its work, from `begin` to `end`. */
struct CoverageCooling
{
    std::int64_t begin = 0;
    std::int64_t end = 0;
    double hottest_m2s = 0; ///< Temperature at the beginning.
};

/**
 * Improves plans by simulated annealing over the legs and their offsets. Effort is counted in work,
 * so that the same work gives the same plan on every machine. The prediction of a leg takes 20
 * units and one for each iceberg; a unit takes about 10 to 20 ns. The model is borrowed and must
 * have at least one iceberg.
 */
class CoverageSearch
{
public:
    /** Fixed work of a leg, to which each iceberg adds one unit. */
    static constexpr std::int64_t kWorkOfLeg = 20;

    /** Starts with no work done; `random` sets all random decisions. */
    CoverageSearch(const CoverageModel& model, const Random& random, CoverageLimits limits = {});

    /**
     * Returns the plan flown to the horizon: legs without use are left out, and greedy legs are
     * added at its end unless a patrol follows.
     */
    [[nodiscard]] CoverageResult completed(const CoveragePlan& plan);

    /**
     * Returns the best plan found from `start` on until `work()` reaches `untilWork` or the watch
     * stops the search; it is never worse than `start`. `heat` is the temperature at the beginning,
     * as a share of the cost of `start`.
     */
    [[nodiscard]] CoverageResult improved(const CoverageResult& start, std::int64_t untilWork,
                                          double heat, const SolveWatch& watch);

    /**
     * Runs a part of an annealing, from the plan `now` until `work()` reaches `untilWork` or the
     * watch stops it. Replaces `best` by each plan that costs less. Returns the plan at which the
     * annealing has arrived.
     */
    [[nodiscard]] CoverageResult annealed(const CoveragePlan& now, const CoverageCooling& cooling,
                                          std::int64_t untilWork, const SolveWatch& watch,
                                          CoverageResult& best);

    /** Sets the places to which the first leg may go from now on; an empty list allows all. */
    void setFirst(std::vector<bool> first) { m_limits.first = std::move(first); }

    /** Returns the work done so far. */
    [[nodiscard]] std::int64_t work() const { return m_work; }

    /**
     * Sets the function that is called with each plan that is better than all those before, from
     * any start. It does not influence the search.
     */
    void setListener(std::function<void(const CoverageResult&)> listener)
    {
        m_listener = std::move(listener);
    }

private:
    /** Legs and the states after each of them, with the cost up to then. */
    struct Flown
    {
        CoveragePlan legs;
        /** At least one state per leg; further entries are spare room. */
        std::vector<CoverageState> states;
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
    void report(const CoverageResult& better);
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
    /** Cost of the best plan reported to the listener. */
    double m_reported_m2s = std::numeric_limits<double>::infinity();
    CoverageState m_start;
    Flown m_now;
    CoveragePlan m_candidate; ///< The present legs with a change.
    Flown m_tail;             ///< Flight of the candidate from the change on.
};

} // namespace berg
