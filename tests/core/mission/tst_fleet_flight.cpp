#include "core/io/files/run_json.h"
#include "core/mission/mission_instant.h"
#include "core/mission/plan_requests.h"
#include "core/mission/policy_forecast.h"
#include "core/plan/policy/fleet_task.h"
#include "core/plan/policy/policy.h"
#include "core/presets/presets.h"
#include "core/scenario/limits.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/flight/flown_plans.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

#include <algorithm>
#include <map>
#include <set>

using namespace berg;
using namespace berg::test;

namespace {

/** A random field whose UAVs start 1.5 km apart, each in its own altitude layer. */
Scenario fleetScenario(std::int64_t seed, int uavs, int icebergs = 12)
{
    Scenario scenario = randomScenario(seed, {.icebergs = icebergs});
    scenario.duration_s = 400;
    const Uav first = scenario.uavs.front();
    for (int i = 1; i < uavs; ++i) {
        Uav uav = first;
        uav.id = "uav-" + std::to_string(i + 1);
        uav.position_m.y() += 1500.0 * i;
        uav.spec.altitude_m += kLayerHeight_m * i;
        scenario.uavs.push_back(uav);
    }
    return scenario;
}

Mission flownToEnd(const Scenario& scenario, const MissionOptions& options = {})
{
    Mission mission(scenario, options);
    mission.advance(scenario.duration_s);
    return mission;
}

std::vector<MissionEvent> eventsOf(const Mission& mission, EventKind kind)
{
    std::vector<MissionEvent> events;
    std::ranges::copy_if(mission.events(), std::back_inserter(events),
                         [kind](const MissionEvent& event) { return event.kind == kind; });
    return events;
}

} // namespace

class TestFleetFlight : public QObject
{
    Q_OBJECT

private slots:
    void everyPolicyFliesAFleet_data()
    {
        QTest::addColumn<PolicyKind>("policy");
        QTest::addColumn<int>("uavs");
        for (const Named<PolicyKind>& policy : kPolicyNames)
            for (const int uavs : {2, 3})
                QTest::addRow("%s, %d", std::string(policy.name).c_str(), uavs)
                    << policy.value << uavs;
    }

    /** Targets differ at each instant, and a replan covers every UAV, or a UAV without a target. */
    void everyPolicyFliesAFleet()
    {
        QFETCH(PolicyKind, policy);
        QFETCH(int, uavs);
        Scenario scenario = fleetScenario(3, uavs);
        scenario.planner.policy = policy;
        Mission mission(scenario, {.workLimit = 300'000});
        for (double until_s = 0; until_s <= scenario.duration_s; until_s += 0.5) {
            mission.advance(until_s);
            std::set<IcebergIndex> targets;
            for (int uav = 0; uav < uavs; ++uav)
                if (const std::optional<IcebergIndex> target =
                        mission.simulation().fleet().autopilot(uav).target())
                    QVERIFY2(targets.insert(*target).second, qPrintable(QString::number(until_s)));
        }
        QVERIFY(mission.metrics().visits > 5);
        // Each UAV has a plan, or only UAVs without a target have one.
        std::map<double, std::vector<int>> reported;
        for (const test::FlownPlan& plan : test::flownPlans(mission))
            reported[plan.time_s].push_back(plan.uav);
        for (const auto& [time_s, uavsReported] : reported) {
            QVERIFY(std::ranges::is_sorted(uavsReported));
            const bool isForAll = static_cast<int>(uavsReported.size()) == uavs;
            QVERIFY(isForAll || time_s > 0);
        }
        QCOMPARE(static_cast<int>(mission.plans().size()), mission.metrics().replans);
        for (int uav = 0; uav < uavs; ++uav)
            COMPARE_NEAR(mission.simulation().uav(uav).flown_m, 22 * scenario.duration_s, 1e-6);
    }

    void aVisitByOneIsAPlanForAll()
    {
        const Mission mission = flownToEnd(fleetScenario(1, 2));
        int byOther = 0;
        const std::vector<test::FlownPlan> plans = test::flownPlans(mission);
        for (const MissionEvent& reached : eventsOf(mission, EventKind::Reached))
            for (int uav = 0; uav < 2; ++uav) {
                const auto plan = std::ranges::find_if(plans, [&](const test::FlownPlan& p) {
                    return p.uav == uav && p.time_s == reached.time_s;
                });
                QVERIFY(plan != plans.end());
                if (uav != reached.uav && plan->reason == PlanReason::Fleet)
                    ++byOther;
            }
        QVERIFY(byOther > 5);
    }

    /** Legs that a plan does not change continue without a restart of the guidance. */
    void anUnchangedLegGoesOn()
    {
        const Mission mission = flownToEnd(fleetScenario(1, 2));
        int unchanged = 0;
        std::map<int, std::optional<IcebergIndex>> targets;
        for (const test::FlownPlan& plan : test::flownPlans(mission)) {
            const auto last = targets.find(plan.uav);
            const bool isSame = last != targets.end() && last->second == plan.target();
            targets[plan.uav] = plan.target();
            if (plan.reason != PlanReason::Fleet || !isSame)
                continue;
            const Simulation then = instantAt(mission, plan.time_s).simulation;
            const UavState& uav = then.uav(plan.uav);
            QVERIFY(uav.guidance.start_m != uav.pose.position_m);
            ++unchanged;
        }
        QVERIFY(unchanged > 0);
    }

    void twoSeeMoreThanOne()
    {
        double one_m2s = 0;
        double two_m2s = 0;
        for (const int seed : {1, 2, 3}) {
            one_m2s += flownToEnd(fleetScenario(seed, 1)).metrics().zeta_m2s;
            two_m2s += flownToEnd(fleetScenario(seed, 2)).metrics().zeta_m2s;
        }
        QVERIFY(two_m2s < 0.85 * one_m2s);
    }

    /** A distant UAV that may visit nothing does not affect the other. */
    void aBystanderChangesNothing()
    {
        Scenario scenario = fleetScenario(5, 2);
        scenario.uavs[1].position_m = {90000, 90000};
        for (Iceberg& iceberg : scenario.icebergs)
            iceberg.uav = scenario.uavs[0].id;
        Scenario alone = scenario;
        alone.uavs.pop_back();
        const Mission two = flownToEnd(scenario);
        const Mission one = flownToEnd(alone);
        QCOMPARE(two.metrics().zeta_m2s, one.metrics().zeta_m2s);
        QCOMPARE(two.metrics().visits, one.metrics().visits);
        QVERIFY(two.simulation().uav(0).pose == one.simulation().uav(0).pose);
        QVERIFY(!two.simulation().uav(1).target);
    }

    void keptIcebergsAreVisitedByTheirUavAlone()
    {
        for (const PolicyKind policy :
             {PolicyKind::Visitation, PolicyKind::Latency, PolicyKind::Coverage, PolicyKind::Tour,
              PolicyKind::Nearest}) {
            Scenario scenario = fleetScenario(2, 2);
            scenario.planner.policy = policy;
            for (std::size_t i = 0; i < scenario.icebergs.size(); ++i)
                scenario.icebergs[i].uav = scenario.uavs[i % 2].id;
            const Mission mission = flownToEnd(scenario, {.workLimit = 300'000});
            QVERIFY2(mission.metrics().visits > 3,
                     std::string(nameOf(kPolicyNames, policy)).c_str());
            for (const test::FlownPlan& plan : test::flownPlans(mission))
                if (plan.target())
                    QCOMPARE(plan.target()->number() % 2, plan.uav);
        }
    }

    void anIcebergIsHandedOverInFlight()
    {
        const Scenario scenario = fleetScenario(4, 2);
        Mission mission(scenario);
        mission.advance(60);
        const PlanPointer first = lastPlanOf(mission.plans(), 0);
        QVERIFY(first->uavs[0].order.size() > 2);
        const IcebergIndex handed = first->uavs[0].order[1];
        const std::string& id = scenario.icebergs[toIndex(handed)].id;
        mission.intervene({.assigned = Assignment{.iceberg = id, .uav = "uav-2"}});
        QCOMPARE(mission.simulation().world().parameters(handed).assignedUav, 1);
        mission.advance(scenario.duration_s);
        bool isPlanned = false;
        for (const test::FlownPlan& plan : test::flownPlans(mission)) {
            const bool isIn = std::ranges::find(plan.order, handed) != plan.order.end();
            if (plan.time_s >= 60 && plan.uav == 0 && plan.reason != PlanReason::Start)
                QVERIFY(!isIn || plan.time_s == first->time_s);
            isPlanned = isPlanned || (isIn && plan.uav == 1 && plan.time_s >= 60);
        }
        QVERIFY(isPlanned);
        // Reading the run file and replaying it gives the same flight.
        const RunFile run = runFromJson(runToJson(runOf(mission)), "run");
        QVERIFY(run == runOf(mission));
        QVERIFY(runOf(replay(run)) == run);
        QVERIFY(!instantAt(mission, 50).simulation.world().parameters(handed).assignedUav);
        QCOMPARE(instantAt(mission, 70).simulation.world().parameters(handed).assignedUav, 1);
    }

    void handingOverToNobodyIsRefused()
    {
        Mission mission(fleetScenario(4, 2));
        mission.advance(10);
        const RunFile before = runOf(mission);
        QVERIFY_THROWS_EXCEPTION(
            Error,
            mission.intervene({.assigned = Assignment{.iceberg = "berg-1", .uav = "uav-9"}}));
        QVERIFY_THROWS_EXCEPTION(
            Error, mission.intervene({.assigned = Assignment{.iceberg = "no", .uav = "uav-1"}}));
        QVERIFY(runOf(mission) == before);
    }

    void lookingBackAndFlyingAgainAreBitForBit_data()
    {
        QTest::addColumn<PolicyKind>("policy");
        QTest::addColumn<bool>("filtered");
        QTest::newRow("visitation") << PolicyKind::Visitation << false;
        QTest::newRow("coverage") << PolicyKind::Coverage << false;
        QTest::newRow("tour, lost icebergs") << PolicyKind::Tour << true;
        QTest::newRow("latency") << PolicyKind::Latency << false;
    }

    /** Combines endurance, wind, measurements, an area and late plans. */
    void lookingBackAndFlyingAgainAreBitForBit()
    {
        QFETCH(PolicyKind, policy);
        QFETCH(bool, filtered);
        Scenario scenario = fleetScenario(6, 3);
        scenario.planner.policy = policy;
        scenario.planningTime_s = 3;
        scenario.wind_mps = {5, -3};
        scenario.duration_s = 900;
        scenario.uavs[1].spec.endurance_s = 400;
        scenario.uavs[1].turnaround_s = 60;
        scenario.uavs[2].spec.airspeed_mps = 30;
        scenario.uavs[2].fov_m = {400, 800};
        if (filtered) {
            scenario.observer.model = ObserverModel::Kalman;
            scenario.observer.detection = 0.7;
            for (Iceberg& iceberg : scenario.icebergs)
                iceberg.velocitySd_mps = 0.8;
        }
        const Mission mission = flownToEnd(scenario, {.workLimit = 200'000});
        QVERIFY(!eventsOf(mission, EventKind::Landed).empty());
        QCOMPARE(!eventsOf(mission, EventKind::Lost).empty(), filtered);
        const RunFile run = runFromJson(runToJson(runOf(mission)), "run");
        const RunFile again = runOf(replay(run));
        QVERIFY2(again == run, compareRun(run, again).empty()
                                   ? "elsewhere"
                                   : compareRun(run, again)[0].field.c_str());
        for (const double time_s : {0.0, 123.4, 456.7, 900.0}) {
            Mission until(scenario, {.workLimit = 200'000});
            until.advance(time_s);
            QVERIFY(instantAt(mission, time_s).simulation.state() == until.simulation().state());
        }
    }

    /** Every UAV is home in time, whatever the others do. */
    void everyUavIsHomeInTime()
    {
        for (const int seed : {1, 2, 3}) {
            Scenario scenario = fleetScenario(seed, 3);
            scenario.duration_s = 1500;
            for (std::size_t k = 0; k < 3; ++k) {
                scenario.uavs[k].spec.endurance_s = 350 + 70.0 * static_cast<double>(k);
                scenario.uavs[k].turnaround_s = 120;
            }
            const Mission mission = flownToEnd(scenario, {.workLimit = 20'000});
            QVERIFY(eventsOf(mission, EventKind::LateHome).empty());
            std::array<double, 3> tookOff_s{};
            int landings = 0;
            for (const MissionEvent& event : mission.events()) {
                if (event.kind == EventKind::TookOff)
                    tookOff_s[toIndex(event.uav.value())] = event.time_s;
                if (event.kind != EventKind::Landed)
                    continue;
                const auto uav = toIndex(event.uav.value());
                QVERIFY(event.time_s - tookOff_s[uav] <= scenario.uavs[uav].spec.endurance_s);
                ++landings;
            }
            QVERIFY(landings >= 6);
        }
    }

    /** An iceberg seen by another UAV by chance is no longer a target. */
    void aTargetSeenByAnotherIsGivenUp()
    {
        Scenario scenario = emptySea(200);
        addIceberg(scenario, 3000, 0);
        addIceberg(scenario, 3000, 3000);
        Uav passer = scenario.uavs.front();
        passer.id = "uav-b";
        passer.position_m = {3000, -800}; // northwards, over the first iceberg to the second
        passer.heading_deg = 0;
        scenario.uavs.push_back(passer);
        scenario.icebergs[0].uav = scenario.uavs[0].id;
        scenario.icebergs[1].uav = "uav-b";
        const Mission mission = flownToEnd(scenario);
        const std::vector<test::FlownPlan> plans = test::flownPlans(mission);
        const auto given = std::ranges::find_if(plans, [](const test::FlownPlan& plan) {
            return plan.uav == 0 && plan.reason == PlanReason::SeenByOther;
        });
        QVERIFY(given != plans.end());
        QVERIFY(!given->target());
        // This does not count as a visit of the first UAV, which was far away.
        const std::vector<MissionEvent> reached = eventsOf(mission, EventKind::Reached);
        QVERIFY(std::ranges::none_of(reached, [&](const MissionEvent& event) {
            return event.iceberg == IcebergIndex(0) && event.time_s <= given->time_s;
        }));
        const std::vector<MissionEvent> sighted = eventsOf(mission, EventKind::Sighted);
        QVERIFY(!sighted.empty() && sighted[0].iceberg == IcebergIndex(0) && sighted[0].uav == 1);
    }

    void drawnFlightsFlyTheFleet()
    {
        const Scenario scenario = fleetScenario(7, 2);
        Scenario alone = scenario;
        alone.uavs.resize(1);
        QVERIFY(drawnZeta_m2s(scenario, PolicyKind::Visitation, 0).value() <
                drawnZeta_m2s(alone, PolicyKind::Visitation, 0).value());
    }

    /** Gap, mu and distance of an event describe the solve of the whole fleet. */
    void plansTellWhatTheSolverSaid()
    {
        const Scenario scenario = fleetScenario(1, 3, 40);
        Mission mission(scenario, {.workLimit = 4'000'000});
        mission.advance(0);
        double sum_m2 = 0;
        for (const Iceberg& iceberg : scenario.icebergs)
            sum_m2 += initialSigma_m2(iceberg);
        const PlanRequest request = planRequest(Simulation(scenario));
        double distance_m = 0;
        double reward_m2 = 0;
        const Plan& plan = *mission.plans().front();
        const SolveOutcome& outcome = plan.outcome;
        QVERIFY(outcome.bound && plan.gap && plan.problem.mu > 0);
        QCOMPARE(outcome.status, SolveStatus::Feasible); // so there is a gap to report
        COMPARE_NEAR(*plan.gap,
                     (outcome.objective - *outcome.bound) / (outcome.objective + 41 * sum_m2),
                     1e-9);
        for (const UavPlan& own : plan.uavs) {
            const auto k = static_cast<std::size_t>(own.uav);
            NodeIndex from;
            double t = 2;
            for (const IcebergIndex iceberg : own.order) {
                const NodeIndex to = nodeOf(request.ids, iceberg);
                distance_m += legBetween(request.uavs[k].distance_m, from, to);
                reward_m2 += initialSigma_m2(scenario.icebergs[toIndex(iceberg)]) * (41 - t++);
                from = to;
            }
        }
        COMPARE_NEAR(plan.distance_m, distance_m, 1e-6);
        COMPARE_NEAR(plan.problem.mu * plan.distance_m - outcome.objective, reward_m2, 1e-6);
    }

    /**
     * A UAV waits for its assigned iceberg that is too far away, and requests no plan meanwhile.
     */
    void whatIsOutOfReachIsNotAskedFor()
    {
        Scenario scenario = emptySea(300);
        addIceberg(scenario, 3000, 0);
        addIceberg(scenario, 0, 9000);
        scenario.icebergs[1].uav = "uav-b";
        Uav waiting = scenario.uavs.front();
        waiting.id = "uav-b";
        waiting.position_m = {-2000, 0};
        waiting.spec.endurance_s = 700; // enough for the near one, not for its own
        scenario.uavs.push_back(waiting);
        const Mission mission = flownToEnd(scenario);
        QVERIFY(!mission.simulation().available(1, 1));
        QVERIFY(mission.metrics().replans < 40);
    }

    void moreUavsThanIcebergs()
    {
        for (const int icebergs : {0, 1, 2}) {
            const Mission mission = flownToEnd(fleetScenario(8, 4, icebergs));
            QVERIFY(mission.simulation().finished());
            QVERIFY(mission.metrics().replans < 400);
        }
    }

    /** The change of a fleet's plan compares equal visits, and zeta over all UAVs. */
    void changesAreOfTheFleet()
    {
        const Mission mission = flownToEnd(fleetScenario(9, 2));
        int changes = 0;
        for (const PlanPointer& plan : mission.plans()) {
            if (plan->uavs.size() < 2)
                continue;
            const auto& a = plan->uavs[0].change;
            const auto& b = plan->uavs[1].change;
            changes += a || b ? 1 : 0;
            if (a && b)
                QCOMPARE(a->zeta_m2s, b->zeta_m2s);
        }
        QVERIFY(changes > 0);
    }
};

QTEST_APPLESS_MAIN(TestFleetFlight)
#include "tst_fleet_flight.moc"
