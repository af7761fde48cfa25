#include "core/plan/fleet/cbc_cover.h"

#include "core/plan/solve/cbc_coin.h"

#include <CbcEventHandler.hpp>
#include <CbcModel.hpp>
#include <CoinError.hpp>
#include <CoinPackedMatrix.hpp>

#include <bit>
#include <utility>
#include <vector>

namespace berg {

namespace {

/** What the slack is scaled to, so that Clp's absolute tolerances fit. */
constexpr double kScaledSlack = 1000;

/** Ends the search tree. */
class TreeStopper final : public CbcEventHandler
{
public:
    using CbcEventHandler::event;
    explicit TreeStopper(CoinStop asked) : m_stop(std::move(asked)) {}
    [[nodiscard]] CbcEventHandler* clone() const override { return new TreeStopper(*this); }
    CbcAction event(CbcEvent) override { return m_stop() ? stop : noAction; }

private:
    CoinStop m_stop;
};

/** Rows: UAVs, then icebergs. */
void load(const FleetOrders& orders, double slack, OsiClpSolverInterface& solver)
{
    std::vector<int> rows;
    std::vector<int> columns;
    std::vector<double> costs;
    for (const FleetOrders::Order& order : orders.all()) {
        const int column = static_cast<int>(costs.size());
        costs.push_back(kScaledSlack * order.excess / slack);
        rows.push_back(order.uav);
        columns.push_back(column);
        for (int i = 1; i <= orders.icebergs(); ++i)
            if (order.visited.contains(i)) {
                rows.push_back(orders.uavs() + i - 1);
                columns.push_back(column);
            }
    }
    const std::vector<double> ones(rows.size(), 1.0);
    CoinPackedMatrix matrix(true, rows.data(), columns.data(), ones.data(),
                            static_cast<CoinBigIndex>(rows.size()));
    const int rowCount = orders.uavs() + orders.icebergs();
    matrix.setDimensions(rowCount, static_cast<int>(costs.size()));
    const std::vector<double> lower(costs.size(), 0.0);
    const std::vector<double> upper(costs.size(), 1.0);
    const std::vector<double> one(static_cast<std::size_t>(rowCount), 1.0);
    solver.loadProblem(matrix, lower.data(), upper.data(), costs.data(), one.data(), one.data());
    for (std::size_t column = 0; column < costs.size(); ++column)
        solver.setInteger(static_cast<int>(column));
}

/** The plan of a solution, when it is one of less than the slack. */
std::optional<FleetPlan> planOf(const FleetOrders& orders, double slack, const double* solution)
{
    FleetPlan plan(static_cast<std::size_t>(orders.uavs()));
    std::vector<int> flown(plan.size(), 0);
    double excess = 0;
    int visits = 0;
    for (std::size_t k = 0; k < orders.all().size(); ++k)
        if (const FleetOrders::Order& order = orders.all()[k]; solution[k] > 0.5) {
            const auto uav = static_cast<std::size_t>(order.uav);
            plan[uav] = orders.icebergsOf(order);
            visits += static_cast<int>(plan[uav].size());
            ++flown[uav];
            excess += order.excess;
        }
    const bool whole = flown == std::vector<int>(flown.size(), 1) && visits == orders.icebergs();
    return whole && excess < slack ? std::optional(std::move(plan)) : std::nullopt;
}

FleetCover search(const FleetOrders& orders, double slack, const CoinStop& stop)
{
    FleetCover cover{.work = static_cast<std::int64_t>(orders.all().size())};
    SilentHandler silent;
    StoppableClp solver(stop);
    solver.passInMessageHandler(&silent);
    solver.setHintParam(OsiDoReducePrint, true, OsiHintTry);
    SimplexStopper stopper(stop);
    solver.getModelPtr()->passInEventHandler(&stopper);
    load(orders, slack, solver);
    solver.resolve(); // the dual simplex: the crash of initialSolve does not ask the stopper
    if (stop())
        return cover;
    if (solver.isProvenPrimalInfeasible() ||
        (solver.isProvenOptimal() && solver.getObjValue() >= kScaledSlack)) {
        cover.complete = true;
        return cover;
    }
    CbcModel model(solver);
    model.passInMessageHandler(&silent);
    model.setLogLevel(0);
    TreeStopper tree(stop);
    model.passInEventHandler(&tree);
    model.setIntegerTolerance(1e-6);
    model.setAllowableGap(0);
    model.setAllowableFractionGap(0);
    model.setCutoff(kScaledSlack);
    model.branchAndBound();
    if (model.bestSolution() != nullptr)
        cover.plan = planOf(orders, slack, model.bestSolution());
    const bool searched = model.isProvenOptimal() || model.isProvenInfeasible();
    // A solution that is none of a plan would prove nothing.
    cover.complete = !stop() && searched && (cover.plan || model.bestSolution() == nullptr);
    return cover;
}

} // namespace

FleetCover bestCoverByCbc(const FleetOrders& orders, double slack, std::int64_t workLimit,
                          const CutQuestion& cut)
{
    const auto columns = static_cast<std::int64_t>(orders.all().size());
    if (orders.all().size() > kMostCoverColumns || columns > workLimit || slack <= 0)
        return {};
    bool stopped = false;
    const CoinStop stop = [&] {
        stopped = stopped || (cut && cut());
        return stopped;
    };
    try {
        return search(orders, slack, stop);
    } catch (const CoinError&) {
        return {.work = columns};
    }
}

} // namespace berg
