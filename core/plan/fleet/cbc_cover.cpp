#include "core/plan/fleet/cbc_cover.h"

#include "core/plan/solve/cbc_helper.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace berg {

namespace {

/** Makes one row for each UAV, then one for each iceberg. */
CbcPartition partitionOf(const FleetOrders& orders, double slack)
{
    CbcPartition partition{.rows = orders.uavs() + orders.icebergs(), .slack = slack};
    for (const FleetOrders::Order& order : orders.all()) {
        std::vector<int>& rows = partition.columns.emplace_back(1, order.uav);
        for (const NodeIndex i : icebergNodes(orders.icebergs()))
            if (order.visited.contains(i))
                rows.push_back(orders.uavs() + i.number() - 1);
        partition.costs.push_back(order.excess);
    }
    return partition;
}

/** Returns the plan of a choice, or nullopt if it is not one with less than the slack. */
std::optional<FleetPlan> planOf(const FleetOrders& orders, double slack,
                                const std::vector<int>& chosen)
{
    FleetPlan plan(static_cast<std::size_t>(orders.uavs()));
    std::vector<int> flown(plan.size(), 0);
    double excess = 0;
    int visits = 0;
    for (const int k : chosen) {
        const FleetOrders::Order& order = orders.all()[static_cast<std::size_t>(k)];
        const auto uav = static_cast<std::size_t>(order.uav);
        plan[uav] = orders.icebergsOf(order);
        visits += static_cast<int>(plan[uav].size());
        ++flown[uav];
        excess += order.excess;
    }
    const bool whole = std::ranges::all_of(flown, [](int times) { return times == 1; }) &&
                       visits == orders.icebergs();
    return whole && excess < slack ? std::optional(std::move(plan)) : std::nullopt;
}

} // namespace

FleetCover bestCoverByCbc(const FleetOrders& orders, double slack, std::int64_t workLimit,
                          const StopCheck& isStopped)
{
    const auto columns = static_cast<std::int64_t>(orders.all().size());
    if (orders.all().size() > kMostCoverColumns || columns > workLimit || slack <= 0)
        return {};
    FleetCover cover{.work = columns};
    const CbcStopCheck stopCheck = [&isStopped] { return isStopped && isStopped(); };
    try {
        const CbcPartition partition = partitionOf(orders, slack);
        CbcHelper helper;
        if (!helper.sendRequest(cbcFrame(partition), stopCheck))
            return cover;
        const std::optional<CbcFrame> answer = helper.answer(stopCheck);
        if (!answer)
            return cover;
        if (answer->kind == CbcFrameKind::Failure)
            throw Error(ErrorCode::SolverFailed, "cbc", cbcFailureOf(*answer).words);
        const CbcChoice choice = cbcChoiceOf(*answer, partition);
        cover.plan = planOf(orders, slack, choice.columns);
        // A choice that is not a plan would prove nothing.
        cover.complete = choice.complete && (cover.plan || choice.columns.empty());
    } catch (const CbcWireFault& fault) {
        throw Error(ErrorCode::SolverFailed, "cbc", std::string("bergwatch-cbc: ") + fault.what());
    }
    return cover;
}

} // namespace berg
