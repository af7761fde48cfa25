// Flights to clusters in closed loop.

#include "core/mission/mission_instant.h"
#include "core/mission/plan_requests.h"
#include "core/sim/clusters.h"
#include "tests/support/approx.h"
#include "tests/support/flight/cluster_scenes.h"
#include "tests/support/flight/flown_plans.h"

#include <QTest>

#include <algorithm>
#include <set>

using namespace berg;
using namespace berg::test;

namespace {

/** A scenario with known motion, without noise. */
Scenario calmCrowd(std::int64_t seed, FovShape shape)
{
    Scenario scenario = crowd(seed);
    scenario.noise = false;
    scenario.fovShape = shape;
    return scenario;
}

/** The UAVs have altitudes of their own, since separation is not tested here. */
Scenario calmFleet(std::int64_t seed, int uavs)
{
    Scenario scenario = calmCrowd(seed, FovShape::Body);
    scenario.planner.policy = seed % 3 == 0 ? PolicyKind::Latency : PolicyKind::Visitation;
    for (int uav = 1; uav < uavs; ++uav) {
        scenario.uavs.push_back(scenario.uavs[0]);
        scenario.uavs.back().id = "uav-" + std::to_string(uav + 1);
        scenario.uavs.back().position_m += Point(400 * uav, 0);
        scenario.uavs.back().spec.altitude_m += 60 * uav;
    }
    return scenario;
}

void addShapes()
{
    QTest::addColumn<FovShape>("shape");
    QTest::addColumn<double>("wind_mps");
    QTest::newRow("body") << FovShape::Body << 0.0;
    QTest::newRow("north") << FovShape::North << 0.0;
    QTest::newRow("disk") << FovShape::Disk << 0.0;
    QTest::newRow("body in wind") << FovShape::Body << 10.0;
}

/** Sets the true position of the iceberg, whatever its estimate. */
void putElsewhere(Iceberg& iceberg, const Point& place_m)
{
    iceberg.track = {.time_s = {0, 1e5}, .position_m = {place_m, place_m}};
}

} // namespace

class TestClusterFlights : public QObject
{
    Q_OBJECT

private slots:
    void inAReachRadiusAllMustBe()
    {
        Scenario scenario = pairAhead();
        scenario.reachRadius_m = 190;
        QVERIFY(clusteredRequest(Simulation(scenario)).clusters.empty());
        scenario.reachRadius_m = 250;
        Mission mission(scenario);
        mission.advance(200);
        const std::vector<MissionEvent>& events = mission.events();
        const auto reached = std::ranges::find(events, EventKind::Reached, &MissionEvent::kind);
        QVERIFY(reached != events.end());
        QCOMPARE(reached->iceberg, IcebergIndex(0));
        QCOMPARE(reached->together, IcebergList{2});
        const Simulation then = instantAt(mission, reached->time_s).simulation;
        for (const IcebergIndex member : IcebergList{0, 2})
            QVERIFY((then.truth_m(member) - then.uav(0).pose.position_m).norm() <= 250);
    }

    void reachedWhenAllAreInView_data() { addShapes(); }

    /** With known motion every cluster is reached, from any place and heading. */
    void reachedWhenAllAreInView()
    {
        QFETCH(FovShape, shape);
        QFETCH(double, wind_mps);
        Random random(31);
        int flown = 0;
        for (int seed = 1; seed <= 100; ++seed) {
            Scenario scenario = calmCrowd(seed, shape);
            scenario.uavs[0].position_m = {random.uniform(0, 2500), random.uniform(0, 2000)};
            scenario.uavs[0].heading_deg = random.uniform(0, 360);
            scenario.wind_mps = {wind_mps, 0};
            const Clusters clusters = clusteredRequest(Simulation(scenario)).clusters;
            for (const IcebergList& members : clusters) {
                Simulation simulation(scenario);
                simulation.setTarget(0, members.front(), {}, members);
                while (simulation.planReason() == PlanReason::None)
                    simulation.advanceStep();
                QVERIFY2(simulation.planReason() == PlanReason::TargetReached,
                         qPrintable(QString("seed %1").arg(seed)));
                for (const IcebergIndex member : members)
                    QVERIFY(simulation.track(member).inView);
                ++flown;
            }
        }
        QVERIFY2(flown > 150, QByteArray::number(flown));
    }

    void missionsMissNoIceberg_data() { addShapes(); }

    /**
     * Through many replans orders are complete, reached icebergs are in view and none is missed.
     */
    void missionsMissNoIceberg()
    {
        QFETCH(FovShape, shape);
        QFETCH(double, wind_mps);
        int reached = 0;
        for (int seed = 1; seed <= 10; ++seed) {
            Scenario scenario = calmCrowd(seed, shape);
            scenario.wind_mps = {0, wind_mps};
            scenario.planner.policy = seed % 2 == 0 ? PolicyKind::Visitation : PolicyKind::Latency;
            Mission mission(scenario);
            mission.advance(scenario.duration_s);
            const std::vector<test::FlownPlan> plans = test::flownPlans(mission);
            for (std::size_t k = 0; k < plans.size(); ++k) {
                QVERIFY(plans[k].reason != PlanReason::Overdue);
                for (const IcebergList& members : plans[k].clusters) {
                    const auto first = std::ranges::find(plans[k].order, members.front());
                    QVERIFY(std::ranges::equal(
                        members, std::span(first, plans[k].order.end()).first(members.size())));
                }
                const auto members = clusterOfTarget(plans[k]);
                if (members.empty() || k + 1 == plans.size() ||
                    plans[k + 1].reason != PlanReason::TargetReached)
                    continue;
                const Simulation then = instantAt(mission, plans[k + 1].time_s).simulation;
                for (const IcebergIndex member : members)
                    QVERIFY(then.track(member).inView);
                ++reached;
            }
        }
        QVERIFY2(reached > 30, QByteArray::number(reached));
    }

    void requestsOfSeveralUavs()
    {
        Scenario scenario = pairAhead();
        scenario.uavs.push_back(scenario.uavs[0]);
        scenario.uavs[1].id = "uav-2";
        scenario.uavs[1].position_m = {-2000, 3000};
        scenario.uavs[1].spec.airspeed_mps *= 2;
        const PlanRequest single = planRequest(Simulation(scenario));
        const PlanRequest both = clusteredRequest(Simulation(scenario));
        QCOMPARE(both.clusters, (std::vector<IcebergList>{{0, 2}}));
        QCOMPARE(both.ids, (IcebergList{0, 1}));
        QCOMPARE(both.sigma_m2[1], single.sigma_m2[1] + single.sigma_m2[3]);
        for (const UavRequest& uav : both.uavs) {
            QCOMPARE(uav.available, std::vector<bool>(2, true));
            QCOMPARE(uav.distance_m(0, 2), single.uavs[toIndex(uav.uav)].distance_m(0, 2));
        }
        COMPARE_NEAR(both.uavs[0].distance_m(0, 1), 2000, 1e-9);
        COMPARE_NEAR(both.uavs[1].distance_m(0, 1), 2500, 1e-9); // half the time
        // An iceberg that only the other UAV may visit assigns the cluster to that UAV.
        scenario.icebergs[2].uav = "uav-2";
        QCOMPARE(clusteredRequest(Simulation(scenario)).uavs[0].available,
                 (std::vector{false, true}));
        QCOMPARE(clusteredRequest(Simulation(scenario)).uavs[1].available,
                 (std::vector{true, true}));
        scenario.icebergs[0].uav = scenario.uavs[0].id;
        QVERIFY(clusteredRequest(Simulation(scenario)).clusters.empty());
    }

    /**
     * With two and three UAVs no iceberg is in two orders, reached ones are in view and none is
     * missed.
     */
    void missionsOfFleetsMissNoIceberg()
    {
        int reached = 0;
        for (int seed = 1; seed <= 10; ++seed) {
            Mission mission(calmFleet(seed, 2 + seed % 2));
            mission.advance(mission.scenario().duration_s);
            std::set<IcebergIndex> planned;
            PlanPointer last;
            for (const test::FlownPlan& plan : test::flownPlans(mission)) {
                QVERIFY(plan.reason != PlanReason::Overdue);
                if (std::exchange(last, plan.plan) != plan.plan)
                    planned.clear();
                for (const IcebergIndex iceberg : plan.order)
                    QVERIFY(planned.insert(iceberg).second);
                for (const IcebergList& members : plan.clusters) {
                    const auto first = std::ranges::find(plan.order, members.front());
                    QVERIFY(std::ranges::equal(
                        members, std::span(first, plan.order.end()).first(members.size())));
                }
            }
            for (const MissionEvent& event : mission.events()) {
                if (event.kind != EventKind::Reached || event.together.empty())
                    continue;
                const Simulation then = instantAt(mission, event.time_s).simulation;
                for (const IcebergIndex member : event.together)
                    QVERIFY(isInOwnView(then.observer(), event.uav.value(), member));
                ++reached;
            }
        }
        QVERIFY2(reached > 30, QByteArray::number(reached));
    }

    /** One of two members is not at its estimate: the other is seen, and it stays single. */
    void membersThatAreNotThereAreFlownToAlone()
    {
        Scenario scenario = pairAhead();
        putElsewhere(scenario.icebergs[2], {2000, -700});
        Simulation simulation(scenario);
        simulation.setTarget(0, IcebergIndex(0), {}, IcebergList{0, 2});
        while (simulation.planReason() == PlanReason::None)
            simulation.advanceStep();
        QCOMPARE(simulation.planReason(), PlanReason::Overdue);
        COMPARE_NEAR(simulation.uav(0).pose.position_m.x(), 2000, kFlownOver_m);
        QVERIFY(simulation.track(0).inView);
        QCOMPARE(simulation.state().unclustered, IcebergList{2});
        QVERIFY(simulation.available(0, 2) && !simulation.fleet().clusterable(0, 2));

        simulation.setTarget(0, IcebergIndex(1));
        while (simulation.planReason() == PlanReason::None)
            simulation.advanceStep();
        QVERIFY(simulation.available(0, 0) && simulation.available(0, 2));
        QVERIFY(clusteredRequest(simulation).clusters.empty());
        simulation.reportSighting(2);
        simulation.setTarget(0, IcebergIndex(2));
        while (simulation.planReason() == PlanReason::None)
            simulation.advanceStep();
        QVERIFY(simulation.track(2).inView);
        QVERIFY(simulation.state().unclustered.empty());
    }

    /** The path round the inner corner of a fence is longer than the straight line. */
    void clusterBehindAFenceCornerIsReached()
    {
        Scenario scenario = emptySea();
        scenario.clusters = true;
        scenario.geofence = true;
        scenario.planner.policy = PolicyKind::Nearest;
        scenario.area_m = {Point(-500, -500), Point(4000, -500), Point(4000, 4000),
                           Point(3000, 4000), Point(3000, 500),  Point(500, 500),
                           Point(500, 4000),  Point(-500, 4000)};
        scenario.uavs[0].position_m = {0, 3000};
        addIceberg(scenario, 3500, 2800);
        addIceberg(scenario, 3500, 3200);
        Simulation simulation(scenario);
        QCOMPARE(clusteredRequest(simulation).clusters, (std::vector<IcebergList>{{0, 1}}));
        QVERIFY(clusteredRequest(simulation).uavs[0].distance_m(0, 1) > 7500);
        simulation.setTarget(0, IcebergIndex(0), {}, IcebergList{0, 1});
        while (simulation.planReason() == PlanReason::None) {
            simulation.advanceStep();
            QVERIFY(insidePolygon(scenario.area_m, simulation.uav(0).pose.position_m));
        }
        QCOMPARE(simulation.planReason(), PlanReason::TargetReached);
    }

    /** An autopilot that steers once a minute misses the cluster, which ends as overdue. */
    void overdueWithoutBeingFlownOver()
    {
        Scenario scenario = pairAhead();
        scenario.uavs[0].spec.autopilot_s = 60;
        scenario.uavs[0].heading_deg = 180;
        putElsewhere(scenario.icebergs[2], {2000, -7000});
        Simulation simulation(scenario);
        simulation.setTarget(0, IcebergIndex(0), {}, IcebergList{0, 2});
        while (simulation.planReason() == PlanReason::None && !simulation.finished())
            simulation.advanceStep();
        QCOMPARE(simulation.planReason(), PlanReason::Overdue);
        QVERIFY(simulation.time_s() < 200);
    }

    void anyInstantIsTheOneFlown()
    {
        Scenario scenario = crowd(3);
        scenario.noise = true;
        scenario.duration_s = 400;
        scenario.planningTime_s = 2.5;
        putElsewhere(scenario.icebergs[5], {-3000, 0});
        Mission whole(scenario);
        whole.advance(400);
        for (const double time_s : {0.0, 37.7, 60.0, 151.3, 222.2, 333.3, 399.9}) {
            Mission part(scenario);
            part.advance(time_s);
            QVERIFY(instantAt(whole, time_s).simulation.state() == part.simulation().state());
        }
        QVERIFY(std::ranges::any_of(test::flownPlans(whole), [](const test::FlownPlan& plan) {
            return plan.interim && !plan.clusters.empty();
        }));
    }

    /** Icebergs that came into view while the plan was made are no longer members. */
    void plansThatComeLateHoldWhatIsLeft()
    {
        for (int seed = 1; seed <= 10; ++seed) {
            Scenario scenario = crowd(seed);
            scenario.planningTime_s = 8;
            Mission mission(scenario);
            mission.advance(500);
            for (const test::FlownPlan& plan : test::flownPlans(mission)) {
                const Simulation then = instantAt(mission, plan.time_s).simulation;
                for (const IcebergList& members : plan.clusters) {
                    QVERIFY(members.size() >= 2);
                    for (const IcebergIndex member : members)
                        QVERIFY(then.available(0, member));
                }
            }
        }
    }

    void progressNamesAllMembers()
    {
        Scenario scenario = crowd(1);
        scenario.planner.policy = PolicyKind::Visitation;
        Mission mission(scenario);
        int reported = 0;
        mission.setIncumbentListener([&](const PlanPointer& plan) {
            QCOMPARE(plan->uavs[0].order.size(), std::size_t{14});
            QVERIFY(!plan->uavs[0].clusters.empty());
            ++reported;
        });
        mission.advance(0);
        QVERIFY(reported > 0);
    }
};

QTEST_APPLESS_MAIN(TestClusterFlights)
#include "tst_cluster_flights.moc"
