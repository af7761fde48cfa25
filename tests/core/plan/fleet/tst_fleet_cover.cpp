#include "core/plan/fleet/fleet_cover.h"
#if BERG_EXPECT_CBC
#include "core/plan/fleet/cbc_cover.h"
#endif
#include "core/plan/fleet/fleet_subsets.h"
#include "core/plan/proof/ng_memory.h"
#include "tests/support/plan/fleet_rows.h"

#include <QtTest>

using namespace berg;

namespace {

/** Graphs of a problem of 8 icebergs, swept at odd multipliers, and the optimum. */
struct Relaxed
{
    explicit Relaxed(const FleetProblem& problem) : costs(problem)
    {
        plan = *bestFleetPlan(costs, {});
        optimum = costs.total(plan);
        Random random(31);
        lambda = Eigen::VectorXd::Zero(problem.nodeCount());
        for (Eigen::Index i = 1; i < lambda.size(); ++i)
            lambda(i) = random.uniform(0.5, 1.2) * optimum / problem.icebergCount();
        for (std::vector<int>& uavs : costs.alike())
            graphs.emplace_back(costs, std::move(uavs));
        sweep();
    }
    void sweep()
    {
        bound = lambda.sum();
        for (FleetGraph& graph : graphs) {
            done = graph.sweep(lambda, {}) && done;
            bound += graph.shortestSum();
        }
    }
    /** Plans up to a thousandth above the optimum are below it. */
    [[nodiscard]] double slack() const { return 1.001 * optimum - bound; }
    [[nodiscard]] double bestCost(double room, CoverFunction cover = bestCover) const
    {
        FleetOrders orders(costs.uavs(), costs.icebergs());
        for (const FleetGraph& graph : graphs)
            if (!orders.add(graph, lambda, room, 1'000'000, {}))
                return -1;
        const FleetCover result = cover(orders, room, 1'000'000'000, {});
        return result.complete && result.plan ? costs.total(*result.plan) : -1;
    }

    FleetCosts costs;
    FleetPlan plan;
    double optimum = 0;
    Eigen::VectorXd lambda;
    std::vector<FleetGraph> graphs;
    double bound = 0;
    bool done = true;
};

constexpr double kRounding = 1e-11; // relative

} // namespace

/** `FleetGraph`, `FleetOrders` and `bestCover` never lose a part of the optimum. */
class TestFleetCover : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void anyMultipliersGiveABound_data() { test::addFleetRows(false); }
    void anyMultipliersGiveABound()
    {
        const FleetProblem problem = test::fetchedFleet(32, 3, 8);
        const Relaxed relaxed(problem);
        QVERIFY(relaxed.done);
        QVERIFY(relaxed.bound <= relaxed.optimum * (1 + kRounding));
        for (const FleetGraph& graph : relaxed.graphs)
            for (int root = 0; root < graph.rootCount(); ++root) {
                double length = 0;
                const int uav = graph.uavs()[static_cast<std::size_t>(root)];
                const VisitOrder path = graph.shortestPath(root);
                for (const NodeIndex i : path) {
                    QVERIFY(problem.allows(uav, i));
                    length -= relaxed.lambda(i.number());
                }
                length += relaxed.costs.of(uav).total(path);
                QVERIFY(std::abs(length - graph.shortest(root)) <= kRounding * relaxed.optimum);
            }
    }

    void theOptimumIsFound_data() { test::addFleetRows(false); }
    void theOptimumIsFound()
    {
        const FleetProblem problem = test::fetchedFleet(33, 3, 8);
        Relaxed relaxed(problem);
        const double margin = kRounding * relaxed.optimum;
        QVERIFY(std::abs(relaxed.bestCost(relaxed.slack()) - relaxed.optimum) <= margin);

        const NgSets sets = nearestSets(relaxed.costs.of(0).shared(), 4);
        for (FleetGraph& graph : relaxed.graphs) {
            FleetRefinement refined = graph.refined(sets, relaxed.lambda, relaxed.slack(), {}, {});
            QVERIFY(refined.graph.has_value());
            graph = std::move(*refined.graph);
        }
        const double before = relaxed.bound;
        relaxed.sweep();
        QVERIFY(relaxed.bound >= before - margin);
        QVERIFY(relaxed.bound <= relaxed.optimum + margin);
        for (FleetGraph& graph : relaxed.graphs) {
            const std::int64_t arcs = graph.arcCount();
            QVERIFY(graph.trim(relaxed.lambda, relaxed.slack(), {}));
            QVERIFY(graph.arcCount() <= arcs);
        }
        relaxed.sweep();
        QVERIFY(std::abs(relaxed.bestCost(relaxed.slack()) - relaxed.optimum) <= margin);
    }

#if BERG_EXPECT_CBC
    /** CBC's partitioning equals ours. */
    void cbcAgrees_data()
    {
        test::addFleetRows(false);
    }
    void cbcAgrees()
    {
        const FleetProblem problem = test::fetchedFleet(33, 3, 8);
        Relaxed relaxed(problem);
        for (const double above : {1.001, 1.02}) {
            const double room = above * relaxed.optimum - relaxed.bound;
            QVERIFY(std::abs(relaxed.bestCost(room, bestCoverByCbc) - relaxed.optimum) <=
                    kRounding * relaxed.optimum);
        }
        const double none = relaxed.optimum * (1 - 1e-6) - relaxed.bound;
        QCOMPARE(relaxed.bestCost(none, bestCoverByCbc), -1.0);
    }

    void cbcEndsWhenStopped()
    {
        const FleetProblem problem = test::randomFleet(35, 2, 8, 1);
        const Relaxed relaxed(problem);
        FleetOrders orders(2, 8);
        QVERIFY(orders.add(relaxed.graphs[0], relaxed.lambda, relaxed.slack(), 100'000, {}));
        const StopCheck isStopped = [] { return true; };
        QVERIFY(!bestCoverByCbc(orders, relaxed.slack(), 1'000'000, isStopped).complete);
        QVERIFY(!bestCoverByCbc(orders, relaxed.slack(), 1, {}).complete);
    }
#endif

    void nothingBeatsTheOptimum()
    {
        const FleetProblem problem = test::randomFleet(34, 2, 8, 1);
        const Relaxed relaxed(problem);
        QCOMPARE(relaxed.bestCost(relaxed.optimum * (1 - 1e-9) - relaxed.bound), -1.0);
    }

    void limitsEndIt()
    {
        const FleetProblem problem = test::randomFleet(35, 2, 8, 1);
        const Relaxed relaxed(problem);
        FleetOrders orders(2, 8);
        QVERIFY(!orders.add(relaxed.graphs[0], relaxed.lambda, relaxed.slack(), 10, {}));
        FleetGraph graph = relaxed.graphs[0];
        const StopCheck isStopped = [] { return true; };
        QVERIFY(!graph.trim(relaxed.lambda, relaxed.slack(), isStopped));
        QVERIFY(!relaxed.graphs[0]
                     .refined(NgSets(8), relaxed.lambda, relaxed.slack(), {.arcs = 3}, {})
                     .graph);
        const FleetRefinement large =
            relaxed.graphs[0].refined(NgSets(8), relaxed.lambda, relaxed.slack(), {.bytes = 3}, {});
        QVERIFY(!large.graph && large.memoryOut);
    }
};

QTEST_APPLESS_MAIN(TestFleetCover)
#include "tst_fleet_cover.moc"
