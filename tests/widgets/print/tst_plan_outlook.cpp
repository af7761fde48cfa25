#include "core/io/export/content/export_content.h"
#include "core/io/export/content/export_flight.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/panel_test.h"
#include "widgets/panels/plan/plan_rows.h"
#include "widgets/print/brief_table.h"
#include "widgets/words/plan_text.h"

#include <QtTest>

using namespace berg;

namespace {

/** Ten icebergs that drift, in wind and current. */
Scenario driftingField(int uavs)
{
    Scenario scenario = randomScenario(7, {.icebergs = 10, .speedMax_mps = 0.8});
    scenario.wind_mps = {4, -3};
    scenario.current_mps = {0.3, 0.2};
    const Uav first = scenario.uavs.front();
    for (int k = 1; k < uavs; ++k) {
        Uav& uav = scenario.uavs.emplace_back(first);
        uav.id = "uav-" + std::to_string(k + 1);
        uav.position_m += Point(2000 * k, 0);
        uav.spec.altitude_m += 50 * k;
    }
    return scenario;
}

Scenario with(Scenario scenario, void (*change)(Scenario&))
{
    change(scenario);
    return scenario;
}

} // namespace

/** All outputs of a plan's length and times agree. */
class TestPlanOutlook : public QObject
{
    Q_OBJECT

private slots:
    void panelsAndExportsAgree_data()
    {
        QTest::addColumn<Scenario>("scenario");
        QTest::addColumn<double>("time_s");
        QTest::newRow("one UAV") << driftingField(1) << 0.0;
        QTest::newRow("under way") << driftingField(1) << 200.0;
        QTest::newRow("two UAVs") << driftingField(2) << 0.0;
        QTest::newRow("round trip")
            << with(driftingField(1), [](Scenario& s) { s.planner.route = Route::Closed; }) << 0.0;
        QTest::newRow("clusters") << with(driftingField(1), [](Scenario& s) {
            s.clusters = true;
            s.uavs[0].fov_m = {2500, 2500};
        }) << 0.0;
        QTest::newRow("sortie") << with(driftingField(1), [](Scenario& s) {
            s.uavs[0].spec.endurance_s = 400;
            s.uavs[0].home_m = Point(-300, 100);
        }) << 0.0;
        QTest::newRow("shortest path") << with(driftingField(1), [](Scenario& s) {
            s.planner.policy = PolicyKind::Path;
            s.planner.route = Route::Closed; // not read
        }) << 0.0;
    }

    void panelsAndExportsAgree()
    {
        QFETCH(Scenario, scenario);
        QFETCH(double, time_s);
        scenario.duration_s = 10'000; // an export goes on after the end, the panel does not
        Mission mission(scenario);
        mission.advance(time_s);
        const FlightRecord record = recordOf(mission);
        const std::vector<PlanSection> sections = planSections(record.shown(), record.scenario);
        const Plan& plan = *mission.plans().front();
        const ExportContent content =
            exportContent({.scenario = scenario, .plan = plan, .mission = &mission},
                          {.what = ExportScope::Order});
        QCOMPARE(sections.size(), content.uavs.size());
        double length_m = 0;
        for (std::size_t u = 0; u < sections.size(); ++u) {
            const PathTotals path = pathTotals(content.uavs[u]);
            length_m += path.length_m;
            COMPARE_NEAR(sections[u].length_m(), path.length_m, 1e-6);
            COMPARE_NEAR(sections[u].lastArrival_s(), path.time_s, 1e-6);
            compareArrivals(sections[u], content.uavs[u].visits, time_s);
        }
        QVERIFY(length_m > 1000);
        COMPARE_NEAR(planLength_m(sections), length_m, 1e-6);
    }

    /** Nobody flies it any more. */
    void nothingIsLeftOfThePlanBefore_data()
    {
        QTest::addColumn<bool>("changes");
        QTest::newRow("velocities that stay") << false;
        QTest::newRow("velocities that change") << true;
    }
    void nothingIsLeftOfThePlanBefore()
    {
        QFETCH(bool, changes);
        bool isBefore = false;
        for (int uavs = 1; uavs <= 2; ++uavs) {
            Scenario scenario = driftingField(uavs);
            if (changes)
                test::letVelocitiesChange(scenario);
            Mission mission(scenario);
            const double end_s = mission.scenario().duration_s;
            for (double time_s = 50; time_s < end_s; time_s += 50) {
                mission.advance(time_s);
                isBefore = isBefore || recordOf(mission).changeShown();
            }
            mission.advance(end_s);
            FlightRecord over = recordOf(mission);
            over.now.phase = RunPhase::Finished;
            QVERIFY(over.isOver());
            QVERIFY(!over.changeShown());
        }
        QVERIFY(isBefore);
    }

private:
    /** Visits of the export against the rows that are seen, members of a cluster in one visit. */
    static void compareArrivals(const PlanSection& section, const std::vector<Visit>& visits,
                                double now_s)
    {
        std::size_t row = 0;
        for (const Visit& visit : visits) {
            if (!visit.iceberg)
                continue;
            for (std::size_t k = 0; k < icebergsOf(visit).size(); ++k, ++row)
                COMPARE_NEAR(section.rows.at(row).arrival_s, visit.time_s - now_s, 1e-6);
        }
        QVERIFY(row == section.rows.size() || !section.rows.at(row).isSeen);
    }
};

QTEST_MAIN(TestPlanOutlook)
#include "tst_plan_outlook.moc"
