#include "core/plan/fleet/fleet_subsets.h"
#include "tests/support/plan/fleet_rows.h"

#include <QtTest>

using namespace berg;

class TestFleetSubsets : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void agreesWithBruteForce_data() { test::addFleetRows(); }
    void agreesWithBruteForce()
    {
        struct Size
        {
            int uavs;
            int icebergs;
        };
        for (const Size size : {Size{1, 6}, Size{2, 1}, Size{2, 5}, Size{2, 7}, Size{3, 6}}) {
            const FleetProblem problem = test::fetchedFleet(11, size.uavs, size.icebergs);
            const std::optional<FleetPlan> plan = bestFleetPlan(FleetCosts(problem), {});
            QVERIFY(plan && isFleetPlan(problem, *plan));
            QVERIFY(test::sameObjective(problem, fleetObjective(problem, *plan),
                                        test::bruteForceFleet(problem)));
        }
    }

    void endsWhenStopped()
    {
        const FleetProblem problem = test::randomFleet(12, 2, 10, 1);
        int asked = 0;
        QVERIFY(!bestFleetPlan(FleetCosts(problem), [&asked] { return ++asked == 5; }));
        QCOMPARE(asked, 5);
    }
};

QTEST_APPLESS_MAIN(TestFleetSubsets)
#include "tst_fleet_subsets.moc"
