#include "core/bound/zeta_bound.h"
#include "core/checks/validate.h"
#include "core/io/files/run_json.h"
#include "core/mission/mission_instant.h"
#include "core/mission/plan_requests.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/flight/fenced_scenario.h"
#include "tests/support/flight/flown_plans.h"
#include "tests/support/flight/random_scenario.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace berg;

namespace {

constexpr double kEndurance_s = 1200;

Scenario enduring(std::int64_t seed, double wind_mps = 0)
{
    Scenario s = randomScenario(seed);
    s.duration_s = 3600;
    s.wind_mps = {0.8 * wind_mps, -0.6 * wind_mps};
    s.uavs[0].spec.endurance_s = kEndurance_s;
    return s;
}

std::optional<double> homeMargin_s(const Simulation& simulation)
{
    return simulation.fleet().autopilot(0).homeMargin_s(simulation.observer());
}

Mission flownWithin(const Scenario& scenario)
{
    Mission mission(scenario, {.workLimit = 20'000});
    mission.advance(scenario.duration_s);
    return mission;
}

std::vector<double> timesOf(const Mission& mission, EventKind kind)
{
    std::vector<double> times_s;
    for (const MissionEvent& event : mission.events())
        if (event.kind == kind)
            times_s.push_back(event.time_s);
    return times_s;
}

/** Endurance left at each landing, reserve excluded. */
std::vector<double> margins_s(const Mission& mission)
{
    std::vector<double> margins_s;
    std::vector<double> starts_s = timesOf(mission, EventKind::TookOff);
    starts_s.insert(starts_s.begin(), 0);
    const std::vector<double> landings_s = timesOf(mission, EventKind::Landed);
    for (std::size_t i = 0; i < landings_s.size(); ++i)
        margins_s.push_back(usableEndurance_s(mission.scenario().uavs[0].spec) -
                            (landings_s[i] - starts_s.at(i)));
    return margins_s;
}

/** Number of legs that ended with the return although the target had not been reached. */
int brokenPromises(const Mission& mission)
{
    int broken = 0;
    const std::vector<test::FlownPlan> plans = test::flownPlans(mission);
    for (const double time_s : timesOf(mission, EventKind::HomeBound)) {
        const auto after = std::ranges::find_if(
            plans, [&](const test::FlownPlan& p) { return p.time_s > time_s; });
        const test::FlownPlan& last = *std::prev(after);
        broken += last.target() && last.thisSortie.value_or(0) > 0 ? 1 : 0;
    }
    return broken;
}

} // namespace

/** Endurance, return, turn-around and the next sortie. */
class TestSortie : public QObject
{
    Q_OBJECT

private slots:
    void itIsHomeInTime_data()
    {
        QTest::addColumn<double>("wind_mps");
        QTest::addColumn<int>("policy");
        QTest::addColumn<int>("scenarios");
        const int visitation = static_cast<int>(PolicyKind::Visitation);
        QTest::newRow("calm") << 0.0 << visitation << 15;
        QTest::newRow("10 m/s") << 10.0 << visitation << 15;
        QTest::newRow("15 m/s") << 15.0 << visitation << 5;
        QTest::newRow("coverage") << 10.0 << static_cast<int>(PolicyKind::Coverage) << 5;
        QTest::newRow("tour") << 5.0 << static_cast<int>(PolicyKind::Tour) << 5;
        QTest::newRow("uncertainty") << 5.0 << static_cast<int>(PolicyKind::Uncertainty) << 5;
    }
    void itIsHomeInTime()
    {
        QFETCH(double, wind_mps);
        QFETCH(int, policy);
        QFETCH(int, scenarios);
        for (int seed = 1; seed <= scenarios; ++seed) {
            Scenario s = enduring(seed, wind_mps);
            s.planner.policy = static_cast<PolicyKind>(policy);
            const Mission mission = flownWithin(s);
            QCOMPARE(margins_s(mission).size(), std::size_t{2});
            for (const double margin_s : margins_s(mission))
                QVERIFY2(margin_s >= 0,
                         qPrintable(QString("seed %1: %2 s").arg(seed).arg(margin_s)));
            QVERIFY(timesOf(mission, EventKind::LateHome).empty());
            QVERIFY(mission.metrics().visits >= 10);
        }
    }

    void reserveClimbAndLandingAreKept()
    {
        Scenario s = enduring(3);
        UavSpec& spec = s.uavs[0].spec;
        spec.reserve_s = 300;
        spec.climb_s = 60;
        spec.landing_s = 40;
        s.uavs[0].turnaround_s = 200;
        const Mission mission = flownWithin(s);
        const std::vector<double> landings_s = timesOf(mission, EventKind::Landed);
        QVERIFY(landings_s.size() >= 2);
        QVERIFY(landings_s[0] <= kEndurance_s - 300 - 60 - 40);
        // And no earlier than necessary.
        QVERIFY(landings_s[0] > kEndurance_s - 300 - 60 - 40 - 250);
        const std::vector<double> starts_s = timesOf(mission, EventKind::TookOff);
        QVERIFY(starts_s[0] - landings_s[0] >= 40 + 200 + 60);
        QVERIFY(starts_s[0] - landings_s[0] < 40 + 200 + 60 + 2);
    }

    void inTimeInsideAFenceToo()
    {
        for (int seed = 1; seed <= 8; ++seed) {
            Scenario s = test::fencedScenario(seed, {4, -3});
            s.duration_s = 2500;
            s.uavs[0].spec.endurance_s = kEndurance_s;
            const Mission mission = flownWithin(s);
            for (const double margin_s : margins_s(mission))
                QVERIFY(margin_s >= 0);
        }
    }

    void inTimeWithASlowAutopilot()
    {
        for (int seed = 1; seed <= 5; ++seed) {
            Scenario s = enduring(seed, 8);
            s.uavs[0].spec.autopilot_s = 1;
            for (const double margin_s : margins_s(flownWithin(s)))
                QVERIFY(margin_s >= 0);
        }
    }

    /**
     * Whatever the aircraft, time step and wind, the UAV is home in time or a warning was given.
     */
    void noLateReturnIsASurprise()
    {
        int landings = 0;
        for (std::uint64_t i = 0; i < 60; ++i) {
            Scenario s = test::AnyScenario(i).draw();
            Random random(i, 3);
            s.duration_s = 600;
            s.dt_s = std::max(s.dt_s, 0.05);
            s.observer = {};
            s.planner = {};
            s.uavs.resize(1);
            for (Iceberg& iceberg : s.icebergs)
                iceberg.uav.clear();
            Uav& uav = s.uavs[0];
            uav.position_m = {random.uniform(-100, 100), random.uniform(-100, 100)};
            uav.home_m.reset();
            uav.spec.endurance_s = random.uniform(1, 500);
            uav.turnaround_s = 30;
            for (Iceberg& iceberg : s.icebergs) {
                iceberg.position_m = {random.uniform(-3000, 3000), random.uniform(-3000, 3000)};
                iceberg.appears_s = 0;
            }
            const std::vector<Issue> issues = validate(s);
            const bool warned = std::any_of(issues.begin(), issues.end(), [](const Issue& issue) {
                return issue.reason.id == IssueId::NoPathHome ||
                       issue.reason.id == IssueId::NoSafeReturn;
            });
            for (const double margin_s : margins_s(flownWithin(s))) {
                QVERIFY2(margin_s >= 0 || warned, qPrintable(QString("scenario %1").arg(i)));
                ++landings;
            }
        }
        QVERIFY(landings > 30);
    }

    void itStandsForTheTurnAround()
    {
        Scenario s = enduring(3);
        s.uavs[0].turnaround_s = 250;
        s.uavs[0].home_m = Point(2500, 2000);
        const Mission mission = flownWithin(s);
        const std::vector<double> landed_s = timesOf(mission, EventKind::Landed);
        const std::vector<double> tookOff_s = timesOf(mission, EventKind::TookOff);
        QVERIFY(landed_s.size() >= 2 && tookOff_s.size() >= 2);
        QVERIFY(tookOff_s[0] - landed_s[0] >= 250 - 1e-6);
        QVERIFY(tookOff_s[0] - landed_s[0] <= 251 + 1e-6); // on the next whole second
        const MissionInstant ground = instantAt(mission, landed_s[0] + 100);
        const UavState& state = ground.simulation.uav(0);
        QCOMPARE(state.mode, FlightMode::Ground);
        QVERIFY((state.pose.position_m - *s.uavs[0].home_m).norm() <= kLandingRadius_m + 3);
        QVERIFY(std::abs(state.ground_s - 150) < 0.2);
        QVERIFY(!homeMargin_s(ground.simulation));
        // It does not move, and takes off with a plan made for that.
        const MissionInstant later = instantAt(mission, tookOff_s[0] - 1);
        QVERIFY(later.simulation.uav(0).pose == state.pose);
        QCOMPARE(later.simulation.uav(0).flown_m, state.flown_m);
        const std::vector<test::FlownPlan> plans = test::flownPlans(mission);
        const auto plan = std::ranges::find_if(
            plans, [&](const test::FlownPlan& p) { return p.time_s > landed_s[0]; });
        QCOMPARE(plan->reason, PlanReason::TakeOff);
        QVERIFY(std::abs(plan->time_s - tookOff_s[0]) < 1e-6);
    }

    /** With steps of a second it takes off later, never earlier. */
    void theTurnAroundIsNotCutShort()
    {
        for (const double turnaround_s : {0.3, 100.3, 100.7}) {
            Scenario s = enduring(3);
            s.dt_s = 1;
            s.uavs[0].turnaround_s = turnaround_s;
            const Mission mission = flownWithin(s);
            const std::vector<double> landed_s = timesOf(mission, EventKind::Landed);
            const std::vector<double> tookOff_s = timesOf(mission, EventKind::TookOff);
            QVERIFY(!landed_s.empty() && !tookOff_s.empty());
            QCOMPARE(tookOff_s[0] - landed_s[0], std::ceil(turnaround_s));
        }
    }

    /** Its camera is off: icebergs that drift over home stay unseen, and zeta increases. */
    void nothingIsSeenFromTheGround()
    {
        Scenario s = enduring(3);
        s.icebergs[0].position_m = s.uavs[0].position_m;
        s.icebergs[0].velocity_mps = Point::Zero();
        const Mission mission = flownWithin(s);
        const double landed_s = timesOf(mission, EventKind::Landed).at(0);
        QVERIFY(instantAt(mission, landed_s - 2).simulation.track(0).inView);
        const MissionInstant early = instantAt(mission, landed_s + 100);
        const MissionInstant late = instantAt(mission, landed_s + 200);
        double growth_m2 = 0;
        for (const IcebergIndex i : early.simulation.icebergs()) {
            QVERIFY(!late.simulation.track(i).inView);
            const double grown_m2 =
                late.simulation.track(i).sigma_m2 - early.simulation.track(i).sigma_m2;
            QVERIFY(std::abs(grown_m2 - 100 * s.icebergs[0].q_m2ps) < 1e-6);
            growth_m2 += grown_m2;
        }
        QVERIFY(late.metrics.zeta_m2s > early.metrics.zeta_m2s + 50 * growth_m2);
    }

    void promisesAreKept()
    {
        int trips = 0;
        for (const double wind_mps : {0.0, 10.0})
            for (int seed = 1; seed <= 10; ++seed) {
                Scenario s = enduring(seed, wind_mps);
                s.noise = false;
                const Mission mission = flownWithin(s);
                QCOMPARE(brokenPromises(mission), 0);
                trips += static_cast<int>(timesOf(mission, EventKind::HomeBound).size());
                for (const test::FlownPlan& plan : test::flownPlans(mission)) {
                    QVERIFY(plan.thisSortie.has_value());
                    QVERIFY(*plan.thisSortie <= static_cast<int>(plan.order.size()));
                    QVERIFY(plan.order.empty() || *plan.thisSortie >= 1);
                }
            }
        QVERIFY(trips >= 40);
    }

    /** A plan with many icebergs promises no more than one sortie can reach. */
    void notAllOfAPlanIsForThisSortie()
    {
        Scenario s = enduring(1);
        s.uavs[0].spec.endurance_s = 500;
        const Mission mission = flownWithin(s);
        const test::FlownPlan first = test::flownPlans(mission).front();
        QVERIFY(*first.thisSortie < static_cast<int>(first.order.size()));
        // The icebergs promised are reached before the UAV turns home.
        const double home_s = timesOf(mission, EventKind::HomeBound).at(0);
        const std::vector<double> reached_s = timesOf(mission, EventKind::Reached);
        const auto reached = std::count_if(reached_s.begin(), reached_s.end(),
                                           [&](double time_s) { return time_s < home_s; });
        QVERIFY(reached >= *first.thisSortie);
    }

    void whatIsTooFarIsNotFlownTo()
    {
        Scenario s = enduring(1);
        s.icebergs.resize(2);
        s.icebergs[0].position_m = {20000, 500}; // 1864 s there and back
        s.icebergs[1].position_m = {3000, 500};
        const Mission mission = flownWithin(s);
        for (const test::FlownPlan& plan : test::flownPlans(mission))
            QVERIFY(plan.target() != IcebergIndex(0));
        // With the near iceberg in view there is no target left: it waits on the ground.
        QVERIFY(!timesOf(mission, EventKind::HomeBound).empty());
        const PlanRequest request = planRequest(Simulation(s));
        QVERIFY(!request.uavs[0].available[0]);
        QVERIFY(request.uavs[0].available[1]);
    }

    void itStaysOnTheGroundWithNothingToFlyTo()
    {
        Scenario s = enduring(1);
        s.icebergs.resize(1);
        s.icebergs[0].position_m = {20000, 500};
        const Mission mission = flownWithin(s);
        QCOMPARE(timesOf(mission, EventKind::Landed).size(), std::size_t{1});
        QVERIFY(timesOf(mission, EventKind::TookOff).empty());
        QCOMPARE(mission.simulation().uav(0).mode, FlightMode::Ground);
    }

    /** A wind that prevents a timely return is reported at once; a weaker one is handled. */
    void windMayMakeItLate()
    {
        Scenario s = enduring(4);
        Mission late(s);
        late.advance(800);
        QVERIFY(*homeMargin_s(late.simulation()) > 0);
        late.intervene({.wind_mps = Point(20, 0)}); // home is to the west
        QCOMPARE(late.simulation().uav(0).mode, FlightMode::Home);
        QVERIFY(*homeMargin_s(late.simulation()) < 0);
        late.advance(801);
        QCOMPARE(timesOf(late, EventKind::LateHome).size(), std::size_t{1});
        QVERIFY(std::abs(timesOf(late, EventKind::HomeBound).at(0) - 800) < 0.2);

        Mission coped(s);
        coped.advance(600);
        coped.intervene({.wind_mps = Point(9, 0)});
        coped.advance(s.duration_s);
        QVERIFY(timesOf(coped, EventKind::LateHome).empty());
        for (const double margin_s : margins_s(coped))
            QVERIFY(margin_s >= 0);
    }

    void interventionsOnTheWayHomeChangeNothingOfIt()
    {
        Mission mission(enduring(5));
        mission.advance(3600);
        const double home_s = timesOf(mission, EventKind::HomeBound).at(0) + 1;
        Mission changed(enduring(5));
        changed.advance(home_s);
        changed.intervene({.tau = 3});
        Iceberg iceberg = enduring(5).icebergs[0];
        iceberg.id = "new";
        changed.intervene({.appears = iceberg});
        const double landed_s = timesOf(mission, EventKind::Landed).at(0);
        changed.advance(landed_s + 1);
        QVERIFY(std::abs(timesOf(changed, EventKind::Landed).at(0) - landed_s) < 1e-6);
        changed.advance(3600); // it is planned with them at take-off
        QVERIFY(timesOf(changed, EventKind::TookOff).size() >= 1);
    }

    void runsReplayAndLookBack()
    {
        for (const PolicyKind policy : {PolicyKind::Visitation, PolicyKind::Coverage}) {
            Scenario s = enduring(6, 6);
            s.planner.policy = policy;
            s.planningTime_s = 9;
            const auto fly = [&](double until_s) {
                Mission mission(s, {.workLimit = 20'000, .keyframeInterval_s = 50});
                mission.advance(400);
                mission.intervene({.wind_mps = Point(-3, 5)});
                mission.advance(until_s);
                return mission;
            };
            const Mission mission = fly(3300);
            QVERIFY(timesOf(mission, EventKind::Landed).size() >= 1);
            const RunFile read = runFromJson(runToJson(runOf(mission)), "run");
            QVERIFY(read == runOf(mission));
            QVERIFY(compareRun(read, runOf(replay(read))).empty());
            const double landed_s = timesOf(mission, EventKind::Landed).at(0);
            for (const double time_s : {401.0, landed_s - 30, landed_s + 77, landed_s + 700})
                QVERIFY(instantAt(mission, time_s).simulation.state() ==
                        fly(time_s).simulation().state());
        }
    }

    /** The plan at take-off has the same delay as others; until then the previous plan is flown. */
    void takeOffsWaitForTheirPlan()
    {
        Scenario s = enduring(6);
        s.planningTime_s = 9;
        const Mission mission = flownWithin(s);
        const std::vector<double> tookOff_s = timesOf(mission, EventKind::TookOff);
        QVERIFY(!tookOff_s.empty());
        const std::vector<test::FlownPlan> plans = test::flownPlans(mission);
        for (const double time_s : tookOff_s) {
            const auto plan = std::ranges::find_if(plans, [&](const test::FlownPlan& made) {
                return made.time_s > time_s - s.dt_s / 2;
            });
            QVERIFY(plan != plans.end() && plan->interim);
            const auto next =
                std::ranges::find(plan, plans.end(), false, &test::FlownPlan::interim);
            QVERIFY(next != plans.end());
            QCOMPARE(next->reason, PlanReason::TakeOff);
            QVERIFY(std::abs(next->time_s - time_s - 9) < s.dt_s / 2);
        }
    }

    void slicesDoNotMatter()
    {
        const Scenario s = enduring(7, 4);
        const Mission whole = flownWithin(s);
        Mission sliced(s, {.workLimit = 20'000});
        for (double t = 0.7; t < s.duration_s + 1; t += 0.7)
            sliced.advance(t);
        QVERIFY(sliced.metrics() == whole.metrics());
        QVERIFY(sliced.simulation().state() == whole.simulation().state());
    }

    /** The bound covers any flight, and a flight with landings sees no more than one without. */
    void boundOnZetaStaysBelow()
    {
        Scenario s = enduring(2);
        s.duration_s = 2400;
        s.icebergs.resize(6);
        const ZetaBound bound = zetaLowerBound(s, {.workLimit = 2'000'000});
        QVERIFY(bound.zeta_m2s > 0);
        QVERIFY(bound.zeta_m2s <= flownWithin(s).metrics().zeta_m2s);
    }
};

QTEST_APPLESS_MAIN(TestSortie)
#include "tst_sortie.moc"
