#include "core/io/results/plan_result.h"
#include "core/mission/mission.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/flight/fleet_flight.h"

#include <QTest>

using namespace berg;

namespace {

/** Returns the distance from the start along the order, and back on a closed route. */
double lengthOf_m(const Scenario& scenario, const UavPlan& uav)
{
    const Point start_m = scenario.uavs[toIndex(uav.uav)].position_m;
    Point from_m = start_m;
    double length_m = 0;
    for (const IcebergIndex iceberg : uav.order) {
        const Point& to_m = scenario.icebergs[toIndex(iceberg)].position_m;
        length_m += (to_m - from_m).norm();
        from_m = to_m;
    }
    const bool isClosed = scenario.planner.route == Route::Closed;
    return length_m + (isClosed ? (start_m - from_m).norm() : 0);
}

} // namespace

class TestPlanResult : public QObject
{
    Q_OBJECT

private slots:
    /** One UAV and several UAVs used to count the leg home differently. */
    void distancesIncludeTheLegHomeOfAClosedRoute_data()
    {
        QTest::addColumn<PolicyKind>("policy");
        for (const Named<PolicyKind>& policy : kPolicyNames)
            if (policy.value != PolicyKind::Tour && policy.value != PolicyKind::Coverage)
                QTest::newRow(policy.name.data()) << policy.value;
    }
    void distancesIncludeTheLegHomeOfAClosedRoute()
    {
        QFETCH(PolicyKind, policy);
        for (int k = 0; k < 24; ++k) {
            Scenario scenario =
                test::withUavs(randomScenario(k, {.icebergs = 3 + k % 6}), 1 + k % 3);
            scenario.planner.policy = policy;
            scenario.planner.route = k % 2 == 0 ? Route::Closed : Route::Open;
            const PlanReport report = planReport(scenario, planFromStart(scenario, {}));
            double sum_m = 0;
            for (std::size_t u = 0; u < report.lengths.size(); ++u) {
                const double length_m = lengthOf_m(scenario, report.plan.uavs[u]);
                COMPARE_NEAR(report.lengths[u].distance_m, length_m, 1e-6);
                sum_m += length_m;
            }
            QVERIFY(sum_m > 0);
            COMPARE_NEAR(report.distance_m, sum_m, 1e-6);
        }
    }

    /** Two icebergs are in line and one is beside the path: 5000 m, and 3606 m home. */
    void latencyCountsTheLegHome()
    {
        Scenario scenario;
        scenario.planner = {.policy = PolicyKind::Latency, .route = Route::Closed};
        scenario.uavs = {{.id = "u0", .position_m = {0, 0}}};
        scenario.icebergs = {{.id = "b1", .position_m = {3000, 0}},
                             {.id = "b2", .position_m = {3000, 2000}}};
        const PlanReport report = planReport(scenario, planFromStart(scenario, {}));
        COMPARE_NEAR(report.distance_m, 5000 + std::sqrt(13e6), 1e-6);
    }
};

QTEST_APPLESS_MAIN(TestPlanResult)
#include "tst_plan_result.moc"
