#pragma once

#include "core/base/random.h"
#include "core/plan/fleet/fleet_moves.h"
#include "core/plan/solve/search_effort.h"

#include <cstdint>
#include <functional>

namespace berg {

/**
 * Local search over fleet plans. Descents by the moves of `fleet_moves.h`, and between them
 * simulated annealing by taking neighbouring strings of icebergs out of the orders and putting each
 * back where it costs least (Christiaens and Vanden Berghe 2020, slack induction by string
 * removals). Deterministic; the best plan is kept throughout, whenever the effort is spent.
 */
class FleetSearch
{
public:
    /** Keeps references to `costs` and `effort`. */
    FleetSearch(const FleetCosts& costs, SearchEffort& effort);

    /** Called with each new best plan; may be empty. */
    std::function<void(const FleetPlan&)> onImproved;

    /** Best plan so far; empty before the first one. */
    [[nodiscard]] const FleetPlan& best() const { return m_best; }

    /** Takes a plan from elsewhere, if it is a better one. */
    void take(const FleetPlan& plan);
    /** Takes the part of a plan (`validPart`) after each iceberg that it lacks was put where it
     * costs least, the most uncertain first: at once, whatever the effort. */
    void complete(FleetPlan plan);
    /** `complete` from nothing. */
    void startGreedily() { complete(FleetPlan(static_cast<std::size_t>(m_costs.uavs()))); }
    /** Goes down from the best plan to a local optimum. */
    void descend();
    /** Annealing from the best plan, so many times out and back, and a descent from what it finds.
     */
    void disturb(std::int64_t times);

private:
    struct Place
    {
        double cost = 0;
        int uav = -1;
        std::ptrdiff_t index = 0;
    };

    [[nodiscard]] std::int64_t random(std::int64_t count);
    void keep(const FleetPlan& plan, double cost);
    /** Takes strings out of the plan, near a random iceberg. */
    [[nodiscard]] std::vector<int> takeOut(FleetPlan& plan);
    void takeString(VisitOrder& order, int iceberg, std::vector<int>& out);
    void sortForPuttingBack(std::vector<int>& icebergs);
    void put(FleetPlan& plan, int iceberg, bool blink);
    template <bool kWeighted>
    void offerPlaces(const VisitOrder& order, int uav, int iceberg, bool blink, Place& best);

    const FleetCosts& m_costs;
    SearchEffort& m_effort;
    Random m_random;
    std::vector<std::vector<int>> m_near; ///< by iceberg: all, the nearest first, itself included
    FleetPlan m_best;
    double m_bestCost = 0;
};

} // namespace berg
