#include "core/plan/solve/latency_problem.h"
#include "tests/support/plan/brute_force.h"

#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

/** Rounding of a sum of a few products, relative. */
constexpr double kRounding = 1e-12;

/** Sums over the arrivals: sigma times the time of each visit, and the time of the return. */
double costWithReturn(const TvpProblem& problem, const VisitOrder& order)
{
    double now = 0;
    double cost = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        now += legBetween(problem.distance_m, k == 0 ? NodeIndex() : order[k - 1], order[k]);
        cost += problem.sigma_m2[toIndex(order[k])] * now;
    }
    return order.empty() ? 0 : cost + now + legBetween(problem.distance_m, order.back(), 0);
}

double leastWithReturn(const TvpProblem& problem)
{
    VisitOrder order = ascendingOrder(problem.icebergCount());
    double least = costWithReturn(problem, order);
    while (std::next_permutation(order.begin(), order.end()))
        least = std::min(least, costWithReturn(problem, order));
    return least;
}

} // namespace

class TestLatencyProblem : public QObject
{
    Q_OBJECT

private slots:
    void placesWithoutSigmaCountOnce()
    {
        TvpProblem problem = randomProblem(1, 4, 1, Route::Closed);
        std::fill(problem.sigma_m2.begin(), problem.sigma_m2.end(), 0.0);
        const TvpProblem latency = latencyProblem(problem);
        QVERIFY(latency.sigma_m2 == std::vector<double>({0, 1, 1, 1, 1}));
        QVERIFY(latency.criterion == Criterion::Latency && latency.route == Route::Open);
        QCOMPARE(latency.mu, 1.0);
        QVERIFY(latency.distance_m == problem.distance_m);
    }

    void sigmasAreKept()
    {
        TvpProblem problem = randomProblem(2, 4, 1, Route::Open);
        problem.sigma_m2[2] = 0;
        QVERIFY(latencyProblem(problem).sigma_m2 == problem.sigma_m2);
        problem.sigma_m2.clear();
        problem.distance_m.resize(0, 0);
        QVERIFY(latencyProblem(problem).sigma_m2.empty()); // `validate` reports it
    }

    void solversCountTheReturn_data()
    {
        QTest::addColumn<int>("icebergs");
        QTest::addColumn<bool>("asymmetric");
        QTest::addColumn<double>("leastSigma"); // 0 means all are 1
        for (const int icebergs : {1, 2, 3, 6, 7})
            for (const bool asymmetric : {false, true})
                for (const double least : {0.0, 1.0, 0.01})
                    QTest::addRow("%d, %s, %g", icebergs, asymmetric ? "asymmetric" : "symmetric",
                                  least)
                        << icebergs << asymmetric << least;
    }
    void solversCountTheReturn()
    {
        QFETCH(const int, icebergs);
        QFETCH(const bool, asymmetric);
        QFETCH(const double, leastSigma);
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            TvpProblem problem = randomProblem(seed, icebergs, 1, Route::Open, asymmetric);
            for (double& sigma_m2 : problem.sigma_m2)
                sigma_m2 *= leastSigma;
            problem.distance_m.diagonal().setConstant(-7); // the diagonal may hold anything
            problem = latencyProblem(problem);
            const double least = leastWithReturn(problem);
            const TvpProblem extended = withReturn(problem);
            QCOMPARE(extended.icebergCount(), icebergs + 1);
            for (const Backend backend : {Backend::Exact, Backend::Auto, Backend::Heuristic}) {
                SolveOutcome outcome = makeSolver(backend)->solve(extended, {});
                QVERIFY(outcome.status == SolveStatus::Optimal);
                QVERIFY(std::abs(outcome.objective - least) <= 2e-9 * least);
                putReturnLast(extended, outcome);
                VisitOrder order = outcome.order();
                QCOMPARE(order.back(), NodeIndex::of(icebergs + 1));
                order.pop_back();
                QVERIFY(isVisitOrder(problem, order));
                QVERIFY(std::abs(costWithReturn(problem, order) - outcome.objective) <=
                        kRounding * least);
            }
        }
    }

    /** Every order that returns too early is beaten by the same one that returns last. */
    void returnBelongsLast()
    {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            TvpProblem problem = randomProblem(seed, 4, 1, Route::Open, true);
            for (double& sigma_m2 : problem.sigma_m2)
                sigma_m2 *= seed % 2 == 0 ? 1 : 1e-3;
            const TvpProblem extended = withReturn(latencyProblem(problem));
            VisitOrder order{1, 2, 3, 4, 5};
            do {
                SolveOutcome outcome{.status = SolveStatus::Feasible, .plan = {order}};
                outcome.objective = objective(extended, order);
                outcome.bound = outcome.objective;
                const double before = outcome.objective;
                putReturnLast(extended, outcome);
                QVERIFY(outcome.order().back() == 5);
                QVERIFY(order.back() == 5 ? outcome.objective == before
                                          : outcome.objective < before);
                QCOMPARE(outcome.objective, objective(extended, outcome.order()));
                QVERIFY(*outcome.bound <= outcome.objective);
            } while (std::next_permutation(order.begin(), order.end()));
        }
    }

    void nothingToVisit()
    {
        const TvpProblem alone{.distance_m = Eigen::MatrixXd::Constant(1, 1, 5),
                               .sigma_m2 = {0},
                               .mu = 1,
                               .criterion = Criterion::Latency};
        SolveOutcome outcome = makeSolver(Backend::Auto)->solve(withReturn(alone), {});
        putReturnLast(withReturn(alone), outcome);
        QVERIFY(outcome.order() == VisitOrder({1}));
        QCOMPARE(outcome.objective, 0.0);
    }

    void nothingFarApart()
    {
        TvpProblem problem = randomProblem(3, 18, 1, Route::Open);
        problem.distance_m.setZero();
        const TvpProblem extended = withReturn(latencyProblem(problem));
        SolveOutcome outcome = makeSolver(Backend::Auto)->solve(extended, {});
        putReturnLast(extended, outcome);
        QCOMPARE(outcome.order().back(), NodeIndex(19));
        QCOMPARE(outcome.objective, 0.0);
    }

    void noPlanIsLeftAlone()
    {
        SolveOutcome outcome;
        putReturnLast(withReturn(latencyProblem(randomProblem(1, 3, 1, Route::Open))), outcome);
        QVERIFY(outcome.plan.empty());
    }

    void icebergWithoutSigmaIsNoPlace()
    {
        TvpProblem problem = latencyProblem(randomProblem(1, 3, 1, Route::Open));
        problem.sigma_m2[2] = 0;
        QVERIFY_THROWS_EXCEPTION(std::logic_error, static_cast<void>(withReturn(problem)));
    }
};

QTEST_APPLESS_MAIN(TestLatencyProblem)
#include "tst_latency_problem.moc"
