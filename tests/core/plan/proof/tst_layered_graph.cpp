#include "core/plan/proof/graph_search.h"
#include "core/plan/proof/layered_graph.h"
#include "tests/support/approx.h"
#include "tests/support/plan/brute_force.h"

#include <QtTest>

using namespace berg;

namespace {

/**
 * Costs are some hundreds, so this is far above rounding and far below a difference between orders.
 */
constexpr double kRounding = 1e-9;

/** Returns multipliers like those of an ascent: of the size of the costs, in no order. */
Multipliers roughMultipliers(const VisitCosts& costs, double cutoff, std::uint64_t seed)
{
    Random random(seed);
    Eigen::VectorXd lambda = Eigen::VectorXd::Zero(costs.icebergs + 1);
    for (int i = 1; i <= costs.icebergs; ++i)
        lambda(i) = random.uniform(0, 2 * cutoff / costs.icebergs);
    return {lambda, lambda.sum(), cutoff};
}

std::vector<VisitOrder> allOrders(int icebergs)
{
    VisitOrder order = ascendingOrder(icebergs);
    std::vector<VisitOrder> all;
    do
        all.push_back(order);
    while (std::next_permutation(order.begin(), order.end()));
    return all;
}

/** Returns whether the order is a path of the graph. */
bool holds(const LayeredGraph<VisitCosts>& graph, const VisitOrder& order)
{
    int node = 0;
    for (const NodeIndex iceberg : order) {
        const std::span<const int> next = graph.successors(node);
        const auto found = std::find_if(next.begin(), next.end(),
                                        [&](int to) { return graph.iceberg(to) == iceberg; });
        if (found == next.end())
            return false;
        node = *found;
    }
    return true;
}

/** Every iceberg remembers all others, so no cycles are left. */
NgSets fullMemory(int icebergs)
{
    NgSets sets(icebergs);
    for (int p = 1; p <= icebergs; ++p)
        for (const NodeIndex i : icebergNodes(icebergs))
            for (const NodeIndex j : icebergNodes(icebergs))
                sets.at(p, i).insert(j);
    return sets;
}

/** Even icebergs remember the next two numbers, in even positions only. */
NgSets someMemory(int icebergs)
{
    NgSets sets(icebergs);
    for (int p = 2; p <= icebergs; p += 2)
        for (int i = 2; i <= icebergs; i += 2)
            for (int j = i + 1; j <= std::min(i + 2, icebergs); ++j)
                sets.at(p, NodeIndex::of(i)).insert(NodeIndex::of(j));
    return sets;
}

bool isElementary(const VisitOrder& path)
{
    NodeSet visited;
    for (const NodeIndex i : path)
        visited.insert(i);
    return visited.size() == static_cast<int>(path.size());
}

} // namespace

class TestLayeredGraph : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void nodeSetsHoldAll127Icebergs()
    {
        NodeSet set;
        QCOMPARE(set.size(), 0);
        for (const NodeIndex node : VisitOrder{0, 1, 63, 64, 127}) {
            QVERIFY(!set.contains(node));
            set.insert(node);
            QVERIFY(set.contains(node));
        }
        QCOMPARE(set.size(), 5);
        QVERIFY(!set.contains(65));
        const NodeSet other = NodeSet{}.with(64).with(2);
        QVERIFY((set & other) == NodeSet{}.with(64));
        QCOMPARE((set & other).hash(), NodeSet{}.with(64).hash());
    }

    void problems_data()
    {
        QTest::addColumn<bool>("closed");
        QTest::addColumn<bool>("asymmetric");
        QTest::addColumn<double>("tau");
        for (const bool closed : {false, true})
            for (const bool asymmetric : {false, true})
                for (const double tau : {0.5, 3.0})
                    QTest::addRow("%s, %s, tau %g", closed ? "closed" : "open",
                                  asymmetric ? "asymmetric" : "symmetric", tau)
                        << closed << asymmetric << tau;
    }

    /** A bound is valid at any multipliers; both methods to compute it agree. */
    void boundsAreBelowEveryOrder_data() { problems_data(); }
    void boundsAreBelowEveryOrder()
    {
        const VisitCosts costs(fetched(7));
        double optimum = std::numeric_limits<double>::infinity();
        for (const VisitOrder& order : allOrders(7))
            optimum = std::min(optimum, costs.total(order));
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            const Multipliers multipliers = roughMultipliers(costs, 10 * optimum, seed);
            LayeredPaths paths(costs);
            const double plain = paths.sweep(multipliers, {});
            QVERIFY(plain <= optimum + kRounding);

            LayeredGraph graph(costs, paths, multipliers);
            QCOMPARE(graph.nodeCount(), 1 + 7 * 7);
            QCOMPARE(graph.arcCount(), std::int64_t{7 + 6 * 7 * 6});
            COMPARE_NEAR(graph.sweep(multipliers), plain, kRounding);
            QVERIFY(graph.shortestPath() == paths.shortestPath());

            std::optional<LayeredGraph<VisitCosts>> some =
                graph.refined(someMemory(7), multipliers, {}, {}).graph;
            QVERIFY(some.has_value());
            const double better = some->sweep(multipliers);
            QVERIFY(better >= plain - kRounding);
            QVERIFY(better <= optimum + kRounding);
        }
    }

    /** With all memory only orders are left, so the bound is the optimum at any multipliers. */
    void fullMemoryIsExact_data() { problems_data(); }
    void fullMemoryIsExact()
    {
        const TvpProblem problem = fetched(6);
        const VisitCosts costs(problem);
        const double optimum = test::bruteForce(problem).objective + objectiveShift(problem);
        const Multipliers multipliers = roughMultipliers(costs, 10 * optimum, 3);
        LayeredPaths paths(costs);
        (void)paths.sweep(multipliers, {});
        LayeredGraph graph(costs, paths, multipliers);
        (void)graph.sweep(multipliers);
        std::optional<LayeredGraph<VisitCosts>> full =
            graph.refined(fullMemory(6), multipliers, {}, {}).graph;
        QVERIFY(full.has_value());
        COMPARE_NEAR(full->sweep(multipliers), optimum, kRounding);
        QVERIFY(isElementary(full->shortestPath()));
        COMPARE_NEAR(costs.total(full->shortestPath()), optimum, kRounding);
    }

    /** No deletion loses an order below the cutoff, whatever the multipliers. */
    void keepsAllOrdersBelowTheCutoff_data() { problems_data(); }
    void keepsAllOrdersBelowTheCutoff()
    {
        const VisitCosts costs(fetched(6));
        std::vector<VisitOrder> orders = allOrders(6);
        std::sort(orders.begin(), orders.end(), [&](const VisitOrder& a, const VisitOrder& b) {
            return costs.total(a) < costs.total(b);
        });
        for (const std::size_t wanted : {1U, 5U, 40U, 300U}) {
            const double cutoff =
                (costs.total(orders[wanted - 1]) + costs.total(orders[wanted])) / 2;
            Multipliers multipliers = roughMultipliers(costs, cutoff, wanted);
            LayeredPaths paths(costs);
            (void)paths.sweep(multipliers, {});
            LayeredGraph graph(costs, paths, multipliers);
            const auto allHeld = [&](const LayeredGraph<VisitCosts>& where) {
                return std::all_of(orders.begin(),
                                   orders.begin() + static_cast<std::ptrdiff_t>(wanted),
                                   [&](const VisitOrder& order) { return holds(where, order); });
            };
            QVERIFY(allHeld(graph));
            for (std::uint64_t seed = 1; seed <= 5; ++seed) {
                multipliers = roughMultipliers(costs, cutoff, 100 * seed);
                (void)graph.sweep(multipliers);
                const std::int64_t before = graph.arcCount();
                QVERIFY(graph.trim(multipliers, {}));
                QVERIFY(graph.arcCount() <= before);
                QVERIFY(allHeld(graph));
            }
            (void)graph.sweep(multipliers);
            std::optional<LayeredGraph<VisitCosts>> refined =
                graph.refined(someMemory(6), multipliers, {}, {}).graph;
            QVERIFY(refined.has_value());
            QVERIFY(allHeld(*refined));
            (void)refined->sweep(multipliers);
            QVERIFY(refined->trim(multipliers, {}));
            QVERIFY(allHeld(*refined));
        }
    }

    /** The purpose of deletion: at good multipliers little is left. */
    void deletesWhatIsTooCostly()
    {
        const TvpProblem problem = test::randomProblem(5, 8, 1, Route::Open);
        const VisitCosts costs(problem);
        const double optimum = test::bruteForce(problem).objective + objectiveShift(problem);
        Multipliers multipliers = roughMultipliers(costs, 10 * optimum, 1);
        LayeredPaths paths(costs);
        (void)paths.sweep(multipliers, {});
        LayeredGraph graph(costs, paths, multipliers);
        (void)graph.sweep(multipliers);
        graph = graph.refined(fullMemory(8), multipliers, {}, {}).graph.value();

        // With full memory the shortest path is the optimum at any multipliers, so a cutoff just
        // above it leaves that path alone, and one below it nothing.
        multipliers.cutoff = optimum * (1 + 1e-6);
        (void)graph.sweep(multipliers);
        QVERIFY(graph.trim(multipliers, {}));
        QCOMPARE(graph.nodeCount(), 1 + 8);
        QCOMPARE(graph.arcCount(), std::int64_t{8});
        multipliers.cutoff = optimum * (1 - 1e-6);
        (void)graph.sweep(multipliers);
        QVERIFY(graph.trim(multipliers, {}));
        QCOMPARE(graph.arcCount(), std::int64_t{0});
        QCOMPARE(graph.sweep(multipliers), std::numeric_limits<double>::infinity());
        QVERIFY(graph.shortestPath().empty());
    }

    void searchWithoutTruncationIsExact_data() { problems_data(); }
    void searchWithoutTruncationIsExact()
    {
        const TvpProblem problem = fetched(7);
        const VisitCosts costs(problem);
        const double optimum = test::bruteForce(problem).objective + objectiveShift(problem);
        Multipliers multipliers = roughMultipliers(costs, 1.2 * optimum, 2);
        LayeredPaths paths(costs);
        (void)paths.sweep(multipliers, {});
        LayeredGraph graph(costs, paths, multipliers);
        (void)graph.sweep(multipliers);
        const GraphSearchResult found = searchGraph(graph, multipliers, {.mostStates = 100'000});
        COMPARE_NEAR(found.bound, optimum, kRounding);
        COMPARE_NEAR(costs.total(found.order), optimum, kRounding);

        // No order is cheaper than the cutoff.
        multipliers.cutoff = 0.99 * optimum;
        const GraphSearchResult nothing = searchGraph(graph, multipliers, {.mostStates = 100'000});
        QCOMPARE(nothing.bound, std::numeric_limits<double>::infinity());
        QVERIFY(nothing.order.empty());
    }

    void truncatedSearchStaysABound_data() { problems_data(); }
    void truncatedSearchStaysABound()
    {
        const TvpProblem problem = fetched(8);
        const VisitCosts costs(problem);
        const double optimum = test::bruteForce(problem).objective + objectiveShift(problem);
        const Multipliers multipliers = roughMultipliers(costs, 2 * optimum, 4);
        LayeredPaths paths(costs);
        (void)paths.sweep(multipliers, {});
        LayeredGraph graph(costs, paths, multipliers);
        const double relaxed = graph.sweep(multipliers);
        for (const int states : {1, 3, 10, 30}) {
            const GraphSearchResult found = searchGraph(graph, multipliers, {.mostStates = states});
            QVERIFY(found.bound >= relaxed - kRounding);
            QVERIFY(found.bound <= optimum + kRounding);
            QVERIFY(found.order.empty() || isVisitOrder(problem, found.order));
        }
    }

    void stopsWhenAsked()
    {
        const VisitCosts costs(test::randomProblem(5, 8, 1, Route::Open));
        const Multipliers multipliers = roughMultipliers(costs, 1e6, 1);
        const StopCheck isStopped = [] { return true; };
        LayeredPaths paths(costs);
        QCOMPARE(paths.sweep(multipliers, isStopped), -std::numeric_limits<double>::infinity());
        (void)paths.sweep(multipliers, {});
        LayeredGraph graph(costs, paths, multipliers);
        (void)graph.sweep(multipliers);
        QCOMPARE(graph.sweep(multipliers, isStopped), -std::numeric_limits<double>::infinity());
        (void)graph.sweep(multipliers);
        const Refinement<VisitCosts> whenCut =
            graph.refined(fullMemory(8), multipliers, {}, isStopped);
        QVERIFY(!whenCut.graph && !whenCut.memoryOut);
        const Refinement<VisitCosts> manyArcs =
            graph.refined(fullMemory(8), multipliers, {.arcs = 100}, {});
        QVERIFY(!manyArcs.graph && !manyArcs.memoryOut);
        const Refinement<VisitCosts> large =
            graph.refined(fullMemory(8), multipliers, {.bytes = 1000}, {});
        QVERIFY(!large.graph && large.memoryOut);
        const GraphSearchResult found =
            searchGraph(graph, multipliers, {.mostStates = 10, .isStopped = isStopped});
        QCOMPARE(found.bound, -std::numeric_limits<double>::infinity());
        QVERIFY(found.order.empty());
        QVERIFY(!graph.trim(multipliers, isStopped));
    }

private:
    static TvpProblem fetched(int icebergs)
    {
        QFETCH(bool, closed);
        QFETCH(bool, asymmetric);
        QFETCH(double, tau);
        return test::randomProblem(21, icebergs, tau, closed ? Route::Closed : Route::Open,
                                   asymmetric);
    }
};

QTEST_APPLESS_MAIN(TestLayeredGraph)
#include "tst_layered_graph.moc"
