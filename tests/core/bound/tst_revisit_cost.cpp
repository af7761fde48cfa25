#include "core/base/random.h"
#include "core/bound/revisit_cost.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace berg;

namespace {

/** Costs of visits and stays in cells of 10 s. */
struct Prices
{
    std::vector<double> edges_s{0};
    std::vector<double> visit_m2s;
    std::vector<double> stay_m2ps;

    [[nodiscard]] ViewPrices view() const
    {
        return {.edges_s = edges_s, .visit_m2s = visit_m2s, .stay_m2ps = stay_m2ps};
    }
    [[nodiscard]] std::size_t cellAt(double time_s) const
    {
        return std::min(visit_m2s.size() - 1, static_cast<std::size_t>(time_s / 10));
    }
};

Prices drawnPrices(Random& random, int cells, double visit_m2s, double stay_m2ps)
{
    Prices prices;
    for (int cell = 0; cell < cells; ++cell) {
        prices.edges_s.push_back(10.0 * (cell + 1));
        prices.visit_m2s.push_back(random.uniform(0.2, 1.8) * visit_m2s);
        prices.stay_m2ps.push_back(random.uniform(0, 2) * stay_m2ps);
    }
    return prices;
}

/** Returns the least cost by the end with stays that begin and end at multiples of `tick_s`. */
double bestOfTicks_m2s(const Prices& prices, const SigmaGrowth& growth, double tick_s)
{
    const double start_s = prices.edges_s[static_cast<std::size_t>(growth.startCell)];
    const double end_s = prices.edges_s.back();
    const auto ticks = static_cast<std::size_t>(std::llround((end_s - start_s) / tick_s));
    const auto time_s = [&](std::size_t k) { return start_s + static_cast<double>(k) * tick_s; };
    const auto gap_m2s = [&](double gap_s) { return growth.q_m2ps * gap_s * gap_s / 2; };
    std::vector<double> inView(ticks + 1, std::numeric_limits<double>::infinity());
    double best_m2s = gap_m2s(end_s - start_s) + growth.atStart_m2 * (end_s - start_s);
    for (std::size_t k = 0; k <= ticks; ++k) {
        const std::size_t cell = prices.cellAt(time_s(k));
        const double first_s = time_s(k) - start_s;
        double arrived_m2s = gap_m2s(first_s) + growth.atStart_m2 * first_s;
        for (std::size_t before = 0; before < k; ++before)
            arrived_m2s =
                std::min(arrived_m2s, inView[before] + gap_m2s(time_s(k) - time_s(before)));
        inView[k] = arrived_m2s + prices.visit_m2s[cell];
        if (k == 0 && growth.mayBeInView)
            inView[k] = 0;
        if (k > 0)
            inView[k] = std::min(
                inView[k],
                inView[k - 1] + tick_s * prices.stay_m2ps[prices.cellAt(time_s(k) - tick_s / 2)]);
        best_m2s = std::min(best_m2s, inView[k] + gap_m2s(end_s - time_s(k)));
    }
    return best_m2s;
}

} // namespace

class TestRevisitCost : public QObject
{
    Q_OBJECT
private slots:
    void belowTheBestOfTicks();
    void equalGaps();
    void neverVisited();
    void cheapStay();
    void countsFromItsStart();
};

void TestRevisitCost::belowTheBestOfTicks()
{
    Random random(5);
    double closest = 0;
    for (int draw = 0; draw < 150; ++draw) {
        const Prices prices = drawnPrices(random, 4 + static_cast<int>(random.below(20)),
                                          random.uniform(1, 300), random.uniform(0, 10));
        const bool isLate = draw % 3 == 0;
        const SigmaGrowth growth{.q_m2ps = random.uniform(0.01, 0.3),
                                 .atStart_m2 = isLate ? 0 : random.uniform(0, 5),
                                 .startCell = isLate ? 2 : 0,
                                 .mayBeInView = isLate};
        const std::vector<double> bound_m2s = revisitCosts_m2s(prices.view(), growth);
        const double best_m2s = bestOfTicks_m2s(prices, growth, 1);
        QVERIFY2(
            bound_m2s.back() <= best_m2s * (1 + 1e-12),
            qPrintable(QString("draw %1: %2 > %3").arg(draw).arg(bound_m2s.back()).arg(best_m2s)));
        closest = std::max(closest, bound_m2s.back() / best_m2s);
        Prices shorter = prices;
        shorter.edges_s.pop_back();
        shorter.visit_m2s.pop_back();
        shorter.stay_m2ps.pop_back();
        if (shorter.visit_m2s.size() > 2)
            QVERIFY(bound_m2s[bound_m2s.size() - 2] <=
                    bestOfTicks_m2s(shorter, growth, 1) * (1 + 1e-12));
    }
    QVERIFY(closest > 0.9);
}

void TestRevisitCost::equalGaps()
{
    // A visit costs as much as a gap of 200 s: n visits in 2000 s cost 500 n + q 2000^2 / 2 (n +
    // 1).
    Prices prices;
    for (int cell = 0; cell < 200; ++cell) {
        prices.edges_s.push_back(10.0 * (cell + 1));
        prices.visit_m2s.push_back(500);
        prices.stay_m2ps.push_back(1e3);
    }
    const double exact_m2s = 500 * 9 + 0.025 * 2000 * 2000 / (2 * 10.0);
    const double bound_m2s = revisitCosts_m2s(prices.view(), {.q_m2ps = 0.025}).back();
    QVERIFY(bound_m2s <= exact_m2s);
    QVERIFY2(bound_m2s > 0.98 * exact_m2s, qPrintable(QString::number(bound_m2s / exact_m2s)));
}

void TestRevisitCost::neverVisited()
{
    Prices prices;
    for (int cell = 0; cell < 30; ++cell) {
        prices.edges_s.push_back(10.0 * (cell + 1));
        prices.visit_m2s.push_back(1e9);
        prices.stay_m2ps.push_back(1e9);
    }
    const std::vector<double> cost_m2s =
        revisitCosts_m2s(prices.view(), {.q_m2ps = 0.1, .atStart_m2 = 4});
    for (std::size_t k = 0; k < cost_m2s.size(); ++k) {
        const double time_s = prices.edges_s[k];
        QVERIFY(std::abs(cost_m2s[k] - (4 * time_s + 0.05 * time_s * time_s)) < 1e-6);
    }
}

/** If a stay costs nothing, only one visit is paid. */
void TestRevisitCost::cheapStay()
{
    Prices prices;
    for (int cell = 0; cell < 50; ++cell) {
        prices.edges_s.push_back(10.0 * (cell + 1));
        prices.visit_m2s.push_back(100);
        prices.stay_m2ps.push_back(0);
    }
    const double cost_m2s = revisitCosts_m2s(prices.view(), {.q_m2ps = 1, .atStart_m2 = 5}).back();
    QVERIFY(cost_m2s <= 100);
}

void TestRevisitCost::countsFromItsStart()
{
    Prices prices;
    for (int cell = 0; cell < 10; ++cell) {
        prices.edges_s.push_back(10.0 * (cell + 1));
        prices.visit_m2s.push_back(1e9);
        prices.stay_m2ps.push_back(1e9);
    }
    const std::vector<double> cost_m2s =
        revisitCosts_m2s(prices.view(), {.q_m2ps = 2, .startCell = 6});
    QCOMPARE(cost_m2s[6], 0.0);
    QVERIFY(std::abs(cost_m2s[10] - 40.0 * 40) < 1e-6);
    QCOMPARE(revisitCosts_m2s(prices.view(), {.q_m2ps = 2, .startCell = 10}).back(), 0.0);
}

QTEST_APPLESS_MAIN(TestRevisitCost)

#include "tst_revisit_cost.moc"
