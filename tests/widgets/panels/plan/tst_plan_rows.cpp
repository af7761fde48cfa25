#include "core/base/angles.h"
#include "core/mission/mission.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/window/plan_panel_fixture.h"
#include "widgets/flight/mission_snapshot.h"
#include "widgets/theme/declination.h"
#include "widgets/theme/unit_settings.h"

#include <algorithm>
#include <cmath>

using namespace berg;
using namespace berg::test;

/** Rows of the plan panel for flights that end before the plan does. */
class TestPlanRows : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** Legs that are not flown are not shown, nor the visits at their ends. */
    void planEndsWithTheRun()
    {
        Scenario scenario = twoIcebergScenario();
        const MissionSnapshot now = standing(twoIcebergs(scenario));
        scenario.duration_s = now.time_s + 40; // the first is met after 25 s, the second after 55 s
        const PlanSection section = planSections(now, scenario).front();
        QCOMPARE(section.rows.size(), std::size_t{2});
        QVERIFY(section.rows[0].isSeen && !section.rows[1].isSeen);
        QCOMPARE(section.rows[1].arrival_s, 0.0);
        QVERIFY(!section.rows[1].chance);
        COMPARE_NEAR(section.length_m(), 40 * 20.0, 1e-9);
        COMPARE_NEAR(section.lastArrival_s(), 40.0, 1e-9);

        scenario.duration_s = now.time_s + 10;
        const PlanSection brief = planSections(now, scenario).front();
        QVERIFY(!brief.rows[0].isSeen && !brief.rows[1].isSeen);
        COMPARE_NEAR(brief.length_m(), 10 * 20.0, 1e-9);
    }

    /** Time and drift amplify each other: 500 icebergs took 213 h on paper. */
    void manyDriftingIcebergs()
    {
        Scenario scenario = test::emptySea();
        scenario.uavs.front().spec.airspeed_mps = 20;
        MissionSnapshot now = twoIcebergs(scenario);
        now.world.tracks.clear();
        now.active.assign(500, true);
        now.assigned.assign(500, std::nullopt);
        IcebergList order;
        for (int i = 0; i < 500; ++i) {
            const double side = i % 2 == 0 ? 1 : -1;
            test::addIceberg(scenario, 0, 0);
            now.world.tracks.push_back({.anchor_m = Point(side * 1000, 10.0 * i),
                                        .anchor_s = now.time_s,
                                        .velocity_mps = Point(side * 0.5, 0)});
            order.push_back(IcebergIndex::of(i));
        }
        now.icebergs = scenario.icebergs;
        setPlan(now, {.uavs = {{.order = order}}});
        const std::vector<PlanSection> sections = planSections(now, scenario);
        const double left_s = scenario.duration_s - now.time_s;
        COMPARE_NEAR(planLength_m(sections), 20 * left_s, 1e-6);
        COMPARE_NEAR(sections.front().lastArrival_s(), left_s, 1e-9);
    }

    /** A leg downwind is faster, and courses are magnetic if the units say so. */
    void coursesAndGroundSpeeds()
    {
        Scenario scenario = twoIcebergScenario();
        const MissionSnapshot now = standing(twoIcebergs(scenario));
        std::vector<PlanRow> rows = planSections(now, scenario).front().rows;
        QVERIFY(rows[0].course && rows[1].course);
        COMPARE_NEAR(rows[0].course->groundSpeed_mps, 20, 1e-9); // no wind: its airspeed
        QVERIFY(!rows[0].course->declination_deg);
        MissionSnapshot windy = now;
        const double course_rad = psiFromHeading(rows[0].course->true_deg);
        for (Motion& motion : windy.motions)
            motion.wind_mps = 5 * Point(std::cos(course_rad), std::sin(course_rad));
        windy.wind = WindAhead(windy.motions.front().wind_mps);
        rows = planSections(windy, scenario).front().rows;
        COMPARE_NEAR(rows[0].course->groundSpeed_mps, 25, 0.01); // wind from behind
        COMPARE_NEAR(rows[0].leg_m / rows[0].arrival_s, rows[0].course->groundSpeed_mps, 1e-9);
        setShownUnits({.north = NorthForm::Typed});
        setTypedDeclination(-18);
        rows = planSections(now, scenario).front().rows;
        COMPARE_NEAR(rows[0].course->declination_deg.value(), -18, 1e-9);
        setShownUnits({});
    }

    /** Flights by night are reported before take-off if the time is known. */
    void flightsInTheDark()
    {
        Scenario scenario = twoIcebergScenario();
        scenario.origin = {.latitude_deg = 48.65, .longitude_deg = -53.1};
        MissionSnapshot now = standing(twoIcebergs(scenario));
        now.time_s = 0;
        const auto found = [&](const char* startUtc) {
            scenario.startUtc = startUtc;
            std::vector<IssueId> ids;
            for (const Issue& issue : darkFlights(now, scenario, planSections(now, scenario)))
                ids.push_back(issue.reason.id);
            return ids;
        };
        using Ids = std::vector<IssueId>;
        QCOMPARE(found(""), Ids());
        QCOMPARE(found("2026-11-28T15:00:00Z"), Ids());
        QCOMPARE(found("2026-11-28T20:16:00Z"), Ids{IssueId::DarkLanding}); // it takes a minute
        QCOMPARE(found("2026-11-28T22:00:00Z"), (Ids{IssueId::DarkTakeOff, IssueId::DarkLanding}));
        now.time_s = 1;
        QCOMPARE(found("2026-11-28T22:00:00Z"), Ids{IssueId::DarkLanding}); // aloft already
    }

    /** A patrol's later visits follow the aimed legs: a row has its next one, and rows beyond the
     * legs their first. */
    void patrolRowsHaveTheNextVisit()
    {
        Scenario scenario = twoIcebergScenario();
        MissionSnapshot now = standing(twoIcebergs(scenario));
        Plan next = *now.plan;
        UavPlan& plan = next.uavs.front();
        const IcebergIndex first = plan.order.at(0);
        const IcebergIndex second = plan.order.at(1);
        plan.outlook = AimedOutlook{.sightings_s = {now.time_s + 50}};
        plan.laterVisits = {{second, now.time_s + 120}, {first, now.time_s + 300}};
        setPlan(now, next);
        const std::vector<PlanRow> rows = planSections(now, scenario).front().rows;
        QCOMPARE(rows.size(), std::size_t{2});
        QVERIFY(rows[0].isSeen);
        COMPARE_NEAR(rows[0].again_s.value(), 300, 1e-9);
        QVERIFY(!rows[1].isSeen);
        COMPARE_NEAR(rows[1].again_s.value(), 120, 1e-9);
        COMPARE_NEAR(lastTime_s(planSections(now, scenario)), 300, 1e-9);
    }

    /** Rows of a flown patrol: those beyond the aimed legs come last and have no leg yet. */
    void visitsBeyondThePathAreLater()
    {
        Scenario scenario = randomScenario(5, {.icebergs = 14});
        for (Iceberg& iceberg : scenario.icebergs)
            iceberg.position_m *= 4;
        scenario.duration_s = 4 * 3600;
        scenario.planner.policy = PolicyKind::Coverage;
        Mission mission(scenario, {.record = false});
        mission.advance(1);
        const std::vector<PlanRow> rows = planSections(snapshotOf(mission), scenario).front().rows;
        const auto firstLater = std::ranges::find_if(rows, &PlanRow::isLater);
        QVERIFY(firstLater != rows.begin());
        QVERIFY(firstLater != rows.end());
        for (auto row = firstLater; row != rows.end(); ++row) {
            QVERIFY(row->isLater);
            COMPARE_NEAR(row->leg_m, 0, 1e-6);
        }
    }

    /** The run ends before home is reached. */
    void returnEndsWithTheRun()
    {
        Scenario scenario = twoIcebergScenario();
        scenario.planner.route = Route::Closed;
        MissionSnapshot now = standing(twoIcebergs(scenario));
        now.planner = scenario.planner;
        scenario.duration_s = 1000;
        const double whole_m = planSections(now, scenario).front().length_m();
        COMPARE_NEAR(whole_m, 500 + 600 + std::hypot(300.0, 1000.0), 1e-9);
        scenario.duration_s = now.time_s + 60; // the second is met after 55 s
        const PlanSection section = planSections(now, scenario).front();
        QVERIFY(section.rows[1].isSeen && !section.returns);
        COMPARE_NEAR(section.length_m(), 60 * 20.0, 1e-9);
    }
};

QTEST_MAIN(TestPlanRows)
#include "tst_plan_rows.moc"
