#pragma once

#include "core/base/random.h"
#include "core/plan/fleet/fleet_moves.h"
#include "core/plan/solve/search_effort.h"

#include <cstdint>
#include <functional>

namespace berg {

/**
 * Local search over fleet plans: descents by the moves of `fleet_moves.h`, and between them
 * simulated annealing that removes neighbouring strings of icebergs from the orders and inserts
 * each iceberg where it costs least (Christiaens and Vanden Berghe 2020, slack induction by string
 * removals). Deterministic; the best plan is available whenever the effort is spent.
 */
class FleetSearch
{
public:
    /** Keeps references to `costs` and `effort`, which must outlive the search. */
    FleetSearch(const FleetCosts& costs, SearchEffort& effort);

    /** Called with each new best plan; may be empty. */
    std::function<void(const FleetPlan&)> onImproved;

    /** Best plan so far; empty before the first one. */
    [[nodiscard]] const FleetPlan& best() const { return m_best; }

    /** Accepts a plan from another search if it is better than the best one. */
    void accept(const FleetPlan& plan);
    /**
     * Inserts each iceberg that the plan lacks where it costs least, the most uncertain first, and
     * accepts the result, even if the effort is spent. The plan must be a `validPart`.
     */
    void complete(FleetPlan plan);
    /** Makes a greedy plan: `complete` of empty orders. */
    void startGreedily() { complete(FleetPlan(static_cast<std::size_t>(m_costs.uavs()))); }
    /**
     * Descends from the best plan, which must exist, until a local optimum or until the effort is
     * spent.
     */
    void descend();
    /**
     * Anneals from the best plan, with `times` removals and insertions or until the effort is
     * spent, and descends if that found a better plan. There must be a best plan and an iceberg.
     */
    void disturb(std::int64_t times);

private:
    static constexpr int kNoUav = -1; ///< faster than an optional in the innermost loop

    struct Place
    {
        double cost = 0;
        int uav = kNoUav;
        std::ptrdiff_t index = 0;
    };

    [[nodiscard]] std::int64_t random(std::int64_t count);
    void storeIfBetter(const FleetPlan& plan, double cost);
    /** Removes strings of icebergs near a random one from the plan and returns them. */
    [[nodiscard]] VisitOrder removeStrings(FleetPlan& plan);
    void removeString(VisitOrder& order, NodeIndex iceberg, VisitOrder& out);
    void shuffleForInsertion(VisitOrder& icebergs);
    void insert(FleetPlan& plan, NodeIndex iceberg, bool blink);
    template <bool kWeighted>
    void offerPlaces(const VisitOrder& order, int uav, NodeIndex iceberg, bool blink, Place& best);

    const FleetCosts& m_costs;
    SearchEffort& m_effort;
    Random m_random;
    /** By iceberg: all icebergs, the nearest first, itself included. */
    std::vector<VisitOrder> m_near;
    FleetPlan m_best;
    double m_bestCost = 0;
};

} // namespace berg
