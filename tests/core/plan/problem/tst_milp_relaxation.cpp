#include "core/plan/problem/milp_relaxation.h"
#include "tests/support/approx.h"
#include "tests/support/plan/brute_force.h"

#include <QRegularExpression>

#include <algorithm>
#include <numeric>

using namespace berg;
using namespace berg::test;

namespace {

int columnOf(const MilpModel& model, const MilpArc& arc)
{
    const auto found = std::find(model.arcs.begin(), model.arcs.end(), arc);
    require(found != model.arcs.end(), "arc of the model");
    return static_cast<int>(found - model.arcs.begin());
}

} // namespace

class TestMilpRelaxation : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void noOrderViolatesAdmissibleFlow()
    {
        const MilpModel model = positionModel(randomProblem(1, 5, 1, Route::Open));
        const AdmissibleFlow flow(model);
        VisitOrder order{1, 2, 3, 4, 5};
        do {
            QVERIFY(flow.violated(encode(model, order), 1e-9).empty());
        } while (std::next_permutation(order.begin(), order.end()));
    }

    /** 0 -> 1 -> 2 -> 1 is a path of the layered network; the cut excludes going straight back. */
    void goingStraightBackIsCut()
    {
        const MilpModel model = positionModel(randomProblem(1, 3, 1, Route::Open));
        std::vector<double> back(model.columns.size(), 0.0);
        const int there = columnOf(model, {.from = 1, .to = 2, .position = 2});
        back[static_cast<std::size_t>(columnOf(model, {.from = 0, .to = 1, .position = 1}))] = 1;
        back[static_cast<std::size_t>(there)] = 1;
        back[static_cast<std::size_t>(columnOf(model, {.from = 2, .to = 1, .position = 3}))] = 1;

        const std::vector<MilpRow> rows = AdmissibleFlow(model).violated(back, 0.5);
        QCOMPARE(rows.size(), std::size_t{1});
        QCOMPARE(rows[0].upper, 0.0);
        QCOMPARE(rows[0].lower, -kMilpInfinity);
        const int onward = columnOf(model, {.from = 2, .to = 3, .position = 3});
        const std::vector<MilpTerm> expected{{there, 1}, {onward, -1}};
        QVERIFY(rows[0].terms == expected);
        QVERIFY(AdmissibleFlow(model).violated(back, 1.0).empty());
    }

    void roundingIsNeverWorseThanTheOrderItStartsFrom_data()
    {
        QTest::addColumn<bool>("printed");
        QTest::newRow("printed") << true;
        QTest::newRow("position") << false;
    }

    void roundingIsNeverWorseThanTheOrderItStartsFrom()
    {
        QFETCH(bool, printed);
        Random random(8);
        for (int repeat = 0; repeat < 30; ++repeat) {
            const Route route = repeat % 2 == 0 ? Route::Open : Route::Closed;
            const TvpProblem problem = randomProblem(random.bits(), 7, 1, route, true);
            const MilpModel model = printed ? printedModel(problem) : positionModel(problem);
            VisitOrder order{1, 2, 3, 4, 5, 6, 7};
            for (std::size_t i = order.size(); i > 1; --i)
                std::swap(order[i - 1], order[random.below(i)]);
            const VisitOrder rounded = roundRelaxation(problem, model, encode(model, order));
            QVERIFY(isVisitOrder(problem, rounded));
            QVERIFY(objective(problem, rounded) <= objective(problem, order));
            const BruteForce best = bruteForce(problem);
            QVERIFY(roundRelaxation(problem, model, encode(model, best.order)) == best.order);
        }
    }

    /** No move gains anything: the order stays, ties in the mean by node number. */
    void tiesKeepTheOrder()
    {
        TvpProblem problem = randomProblem(2, 5, 1, Route::Open);
        problem.mu = 0;
        std::fill(problem.sigma_m2.begin(), problem.sigma_m2.end(), 0.0);
        const MilpModel model = positionModel(problem);
        const VisitOrder order{4, 1, 5, 3, 2};
        QVERIFY(roundRelaxation(problem, model, encode(model, order)) == order);
        const std::vector<double> nothing(model.columns.size(), 0.0);
        QVERIFY((roundRelaxation(problem, model, nothing) == VisitOrder{1, 2, 3, 4, 5}));
    }
};

QTEST_APPLESS_MAIN(TestMilpRelaxation)
#include "tst_milp_relaxation.moc"
