#include "core/plan/fleet/fleet_search.h"
#include "core/plan/fleet/fleet_subsets.h"
#include "tests/support/plan/fleet_rows.h"

#include <QtTest>

using namespace berg;

namespace {

/** Assigns each iceberg to its UAV, else to the UAVs in rotation. */
FleetPlan anyPlan(const FleetProblem& problem)
{
    FleetPlan plan(problem.distance_m.size());
    for (const NodeIndex i : icebergNodes(problem.icebergCount()))
        for (int k = 0;; ++k)
            if (const int uav = (i.number() + k) % problem.uavCount(); problem.allows(uav, i)) {
                plan[static_cast<std::size_t>(uav)].push_back(i);
                break;
            }
    return plan;
}

/** No iceberg may be moved to any other place at a gain. */
bool isRelocationOptimum(const FleetProblem& problem, const FleetPlan& plan)
{
    const double best = fleetObjective(problem, plan);
    for (std::size_t a = 0; a < plan.size(); ++a)
        for (std::size_t k = 0; k < plan[a].size(); ++k)
            for (std::size_t b = 0; b < plan.size(); ++b) {
                FleetPlan other = plan;
                const NodeIndex iceberg = plan[a][k];
                other[a].erase(other[a].begin() + static_cast<std::ptrdiff_t>(k));
                if (!problem.allows(static_cast<int>(b), iceberg))
                    continue;
                for (std::size_t place = 0; place <= other[b].size(); ++place) {
                    FleetPlan moved = other;
                    moved[b].insert(moved[b].begin() + static_cast<std::ptrdiff_t>(place), iceberg);
                    const double value = fleetObjective(problem, moved);
                    if (value < best && !test::sameObjective(problem, value, best))
                        return false;
                }
            }
    return true;
}

} // namespace

class TestFleetSearch : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void piecesAreValuedAsTheOrderTheyMake_data() { test::addFleetRows(); }
    void piecesAreValuedAsTheOrderTheyMake()
    {
        const FleetProblem problem = test::fetchedFleet(21, 2, 12);
        const FleetCosts costs(problem);
        const FleetRoutes routes(costs, anyPlan(problem));
        Random random(22);
        for (int k = 0; k < 200; ++k) {
            std::vector<RoutePiece> pieces;
            for (int uav = 0; uav < 2; ++uav) {
                const auto length = static_cast<std::uint64_t>(routes.length(uav));
                const int a = static_cast<int>(random.below(length + 1));
                const int b = static_cast<int>(random.below(length + 1));
                pieces.push_back({uav, std::min(a, b), std::max(a, b), random.below(2) == 0});
            }
            const int uav = static_cast<int>(random.below(2));
            const VisitOrder order = routes.joined(pieces);
            const bool allowed = std::all_of(order.begin(), order.end(),
                                             [&](NodeIndex i) { return problem.allows(uav, i); });
            const double cost = routes.cost(uav, pieces);
            QCOMPARE(std::isfinite(cost), allowed);
            constexpr double kRounding = 1e-12;
            const double scale = costs.total(routes.plan());
            QVERIFY(!allowed || std::abs(cost - costs.total(uav, order)) < kRounding * scale);
        }
    }

    void movesGainWhatTheySay_data() { test::addFleetRows(); }
    void movesGainWhatTheySay()
    {
        const FleetProblem problem = test::fetchedFleet(23, 3, 15);
        const FleetCosts costs(problem);
        FleetRoutes routes(costs, anyPlan(problem));
        SearchEffort effort;
        int moves = 0;
        for (int k = 0; k < 60; ++k) {
            const int a = k % 3;
            const int b = k / 3 % 3;
            const FleetMove move =
                a == b ? bestMoveWithin(routes, a, effort) : bestMoveBetween(routes, a, b, effort);
            if (move.partCount == 0)
                continue;
            ++moves;
            const double before = fleetObjective(problem, routes.plan());
            QVERIFY(apply(routes, move));
            QVERIFY(isFleetPlan(problem, routes.plan()));
            QVERIFY(test::sameObjective(problem, fleetObjective(problem, routes.plan()),
                                        before - move.gain));
        }
        QVERIFY(moves > 3);
        QVERIFY(effort.work > 0);
    }

    void descentsEndInLocalOptima_data() { test::addFleetRows(); }
    void descentsEndInLocalOptima()
    {
        const FleetProblem problem = test::fetchedFleet(24, 3, 20);
        const FleetCosts costs(problem);
        SearchEffort effort;
        FleetSearch search(costs, effort);
        search.accept(anyPlan(problem));
        search.descend();
        QVERIFY(isFleetPlan(problem, search.best()));
        QVERIFY(isRelocationOptimum(problem, search.best()));
    }

    void annealingFindsTheOptimumOfSmallProblems_data() { test::addFleetRows(); }
    void annealingFindsTheOptimumOfSmallProblems()
    {
        const FleetProblem problem = test::fetchedFleet(25, 2, 9);
        const FleetCosts costs(problem);
        SearchEffort effort;
        FleetSearch search(costs, effort);
        search.startGreedily();
        search.disturb(5000);
        const std::optional<FleetPlan> best = bestFleetPlan(costs, {});
        QVERIFY(test::sameObjective(problem, fleetObjective(problem, search.best()),
                                    fleetObjective(problem, *best)));
    }

    void effortIsALimit()
    {
        const FleetProblem problem = test::randomFleet(26, 3, 40, 1);
        const FleetCosts costs(problem);
        SearchEffort effort{.isStopped = {}, .limit = 200'000};
        FleetSearch search(costs, effort);
        search.startGreedily();
        search.descend();
        search.disturb(1'000'000'000);
        QVERIFY(isFleetPlan(problem, search.best()));
        QVERIFY(effort.work < 2 * effort.limit);
    }
};

QTEST_APPLESS_MAIN(TestFleetSearch)
#include "tst_fleet_search.moc"
