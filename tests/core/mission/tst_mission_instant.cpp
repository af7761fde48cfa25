#include "core/mission/mission_instant.h"
#include "core/presets/presets.h"
#include "tests/support/flight/flown_plans.h"
#include "tests/support/flight/random_fleet.h"
#include "tests/support/flight/scenario_builder.h"

#include <QtTest>

using namespace berg;

namespace {

struct Change
{
    double time_s;
    Intervention intervention;
};

/** Interventions of every kind, two at one instant and one where a plan is due anyway. */
std::vector<Change> changes()
{
    Iceberg added;
    added.id = "added";
    added.position_m = Point(1500, 1500);
    added.velocity_mps = Point(0.1, 0.2);
    return {{.time_s = 0, .intervention = {.tau = 2.0}},
            {.time_s = 123.4, .intervention = {.appears = added}},
            {.time_s = 123.4, .intervention = {.tau = 0.25}},
            {.time_s = 210, .intervention = {.seen = "added"}},
            {.time_s = 300, .intervention = {.policy = PolicyKind::Nearest}}};
}

/** Flies to `until_s` with all changes up to then. */
Mission flown(const Scenario& scenario, const std::vector<Change>& changes, double until_s,
              const MissionOptions& options = {})
{
    Mission mission(scenario, options);
    for (const Change& change : changes) {
        if (change.time_s > until_s)
            break;
        mission.advance(change.time_s);
        mission.intervene(change.intervention);
    }
    mission.advance(until_s);
    return mission;
}

void compareWithFlight(const MissionInstant& instant, const Mission& then)
{
    QCOMPARE(instant.simulation.step(), then.simulation().step());
    QVERIFY(instant.simulation.state() == then.simulation().state());
    QVERIFY(instant.metrics == then.metrics());
    QVERIFY(instant.planner == then.plannerSettings());
    QCOMPARE(instant.plans, then.plans().size());
    QCOMPARE(instant.events, then.events().size());
    QCOMPARE(instant.interventions, then.interventions().size());
    for (const IcebergIndex i : then.simulation().icebergs()) {
        QVERIFY(instant.simulation.truth_m(i) == then.simulation().truth_m(i));
        QCOMPARE(instant.simulation.active(i), then.simulation().active(i));
    }
}

} // namespace

/** A restored instant equals the flight bit for bit. */
class TestMissionInstant : public QObject
{
    Q_OBJECT

private slots:
    /**
     * With a planning delay, a plan with unavailable targets requested another one for all UAVs,
     * which the restored instant omitted.
     */
    void overtakenPlansAreTheSame()
    {
        const test::RandomFleet fleet(88);
        Mission mission(fleet.scenario(), {.workLimit = 5'000});
        std::vector<WorldState> flown;
        for (double time_s = 20; time_s < fleet.scenario().duration_s; time_s += 20) {
            mission.advance(time_s);
            flown.push_back(mission.simulation().state());
        }
        for (std::size_t k = 0; k < flown.size(); ++k)
            QVERIFY2(instantAt(mission, 20.0 * static_cast<double>(k + 1)).simulation.state() ==
                         flown[k],
                     qPrintable(QString::number(20 * (k + 1))));
    }

    /**
     * The restored instant planned a UAV separately that the new tau had planned with all others.
     */
    void changesAreTheSameForAUavThatIsPlannedAlone()
    {
        Scenario scenario = test::emptySea(900);
        scenario.planner.policy = PolicyKind::Latency;
        scenario.uavs = {{.id = "u1", .heading_deg = 90},
                         {.id = "u2", .position_m = {0, -3000}, .heading_deg = 90}};
        scenario.uavs[1].spec.altitude_m = 200;
        test::addIceberg(scenario, 45'000, 0).uav = "u1";
        test::addIceberg(scenario, 2000, -3000);
        test::addIceberg(scenario, 2600, -3300);
        Mission mission(scenario, {.workLimit = 20'000, .keyframeInterval_s = 300});
        while (!mission.simulation().uav(1).isAlone) {
            QVERIFY(!mission.simulation().finished());
            mission.advance(mission.simulation().time_s() + 1);
        }
        const double changed_s = mission.simulation().time_s();
        QVERIFY(changed_s < 600);
        mission.intervene({.tau = 3.0});
        std::vector<WorldState> flown;
        for (int s = 0; s <= 200; ++s) {
            mission.advance(changed_s + s);
            flown.push_back(mission.simulation().state());
        }
        for (int s = 0; s <= 200; s += 10)
            QVERIFY2(instantAt(mission, changed_s + s).simulation.state() ==
                         flown[static_cast<std::size_t>(s)],
                     qPrintable(QString::number(s)));
    }

    void equalsTheFlight_data()
    {
        QTest::addColumn<int>("seed");
        QTest::addColumn<bool>("changed");
        QTest::addColumn<double>("keyframe_s");
        QTest::newRow("undisturbed") << 1 << false << 60.0;
        QTest::newRow("with interventions") << 2 << true << 60.0;
        QTest::newRow("keyframe where an intervention comes") << 3 << true << 12.34;
        QTest::newRow("keyframe at each step") << 4 << true << 0.1;
        QTest::newRow("one keyframe") << 5 << true << 10000.0;
        QTest::newRow("with aim points") << 6 << true << 60.0;
    }

    void equalsTheFlight()
    {
        QFETCH(int, seed);
        QFETCH(bool, changed);
        QFETCH(double, keyframe_s);
        Scenario scenario = randomScenario(seed, {.icebergs = 8});
        scenario.duration_s = 500;
        scenario.icebergs[5].appears_s = 200.05; // between steps
        if (seed == 6)
            scenario.planner.policy = PolicyKind::Coverage;
        const std::vector<Change> list = changed ? changes() : std::vector<Change>();
        const MissionOptions options{.workLimit = seed == 6 ? std::optional(20'000) : std::nullopt,
                                     .keyframeInterval_s = keyframe_s};
        const Mission mission = flown(scenario, list, 500, options);
        for (const double time_s : {0.0, 0.1, 59.9, 60.0, 60.1, 123.3, 123.4, 123.5, 200.0, 200.1,
                                    299.9, 300.0, 417.7, 499.9, 500.0})
            compareWithFlight(instantAt(mission, time_s), flown(scenario, list, time_s, options));
        for (const test::FlownPlan& plan : test::flownPlans(mission))
            compareWithFlight(instantAt(mission, plan.time_s),
                              flown(scenario, list, plan.time_s, options));
    }

    void timesOutsideAreTheEnds()
    {
        const Scenario scenario = randomScenario(9, {.icebergs = 4});
        const Mission mission = flown(scenario, {}, 100);
        QCOMPARE(instantAt(mission, -5).simulation.step(), std::int64_t{0});
        QVERIFY(instantAt(mission, 1e9).simulation.state() == mission.simulation().state());
    }

    void backwardsAndForwards()
    {
        const Scenario scenario = randomScenario(10, {.icebergs = 6});
        const Mission mission = flown(scenario, {}, 400);
        const WorldState late = instantAt(mission, 390).simulation.state();
        QVERIFY(instantAt(mission, 10).simulation.state() !=
                late); // another instant in between changes nothing
        QVERIFY(instantAt(mission, 390).simulation.state() == late);
    }

    void withoutRecordItIsRefused()
    {
        const Mission mission =
            flown(randomScenario(1, {.icebergs = 3}), {}, 10, {.record = false});
        QVERIFY_THROWS_EXCEPTION(std::logic_error, static_cast<void>(instantAt(mission, 5)));
    }
};

QTEST_APPLESS_MAIN(TestMissionInstant)
#include "tst_mission_instant.moc"
