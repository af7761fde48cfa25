#include "core/mission/mission.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

#include <algorithm>

using namespace berg;

namespace {

Scenario calm()
{
    Scenario s;
    s.noise = false;
    s.planner.policy = PolicyKind::Latency;
    return s;
}

} // namespace

/** Behaviour of one UAV of a fleet without the others. */
class TestFleetAlone : public QObject
{
    Q_OBJECT

private slots:
    /** Every approach of two UAVs in the air below the separation is an event, from take-off on. */
    void takingOffTogetherIsClose()
    {
        Scenario s = calm();
        s.duration_s = 3000;
        for (const char* id : {"u1", "u2"}) {
            Uav uav{.id = id};
            uav.heading_deg = 90;
            uav.spec.endurance_s = 600;
            uav.turnaround_s = 200;
            s.uavs.push_back(uav);
        }
        s.icebergs = {{.id = "a", .position_m = {3000, 200}, .velocity_mps = {0, 0}},
                      {.id = "b", .position_m = {3000, -200}, .velocity_mps = {0, 0}}};
        Mission mission(s, {.workLimit = 20'000});
        mission.advance(s.duration_s);
        std::vector<double> close_s;
        std::vector<double> tookOff_s{0};
        for (const MissionEvent& event : mission.events()) {
            if (event.kind == EventKind::Close)
                close_s.push_back(event.time_s);
            if (event.kind == EventKind::TookOff)
                tookOff_s.push_back(event.time_s);
        }
        QVERIFY(tookOff_s.size() >= 5);
        for (const double time_s : tookOff_s) {
            const bool isTogether = time_s == 0 || std::ranges::count(tookOff_s, time_s) == 2;
            const bool isNoted = std::ranges::any_of(
                close_s, [&](double at_s) { return at_s >= time_s && at_s <= time_s + 0.2; });
            QVERIFY2(!isTogether || isNoted, qPrintable(QString::number(time_s)));
        }
    }

    /** While the other UAV is on a long leg, the idle one visits icebergs near it. */
    void theIdleOneHasWhatNobodyFliesTo()
    {
        Scenario s = calm();
        s.duration_s = 2000;
        s.uavs = {{.id = "u1"}, {.id = "u2", .position_m = {0, -3000}}};
        s.uavs[0].heading_deg = 90;
        s.uavs[1].heading_deg = 90;
        s.uavs[1].spec.altitude_m = 200;
        s.icebergs = {{.id = "far", .position_m = {45'000, 0}, .velocity_mps = {0, 0}},
                      {.id = "b", .position_m = {2000, -3000}, .velocity_mps = {0, 0}},
                      {.id = "c", .position_m = {2600, -3300}, .velocity_mps = {0, 0}}};
        s.icebergs[0].uav = "u1";
        Mission mission(s, {.workLimit = 20'000});
        const Simulation& world = mission.simulation();
        int longest_s = 0;
        int idle_s = 0;
        for (double t_s = 1; t_s <= s.duration_s; ++t_s) {
            mission.advance(t_s);
            bool isBeside = false;
            for (const IcebergIndex i : world.icebergs())
                isBeside = isBeside || (world.available(1, i) && world.uav(0).target != i);
            idle_s = !world.uav(1).target && isBeside ? idle_s + 1 : 0;
            longest_s = std::max(longest_s, idle_s);
        }
        QVERIFY2(longest_s <= 60, qPrintable(QString::number(longest_s))); // was 1900
        // The other UAV's leg continues.
        const auto plansOfOther = std::ranges::count_if(
            mission.plans(), [](const PlanPointer& plan) { return plan->of(0) != nullptr; });
        QVERIFY2(plansOfOther <= 10, qPrintable(QString::number(plansOfOther)));
    }

    /**
     * Changing velocities move the anchor of an estimate at each step, which once counted as a
     * sighting: the idle UAV then circled for ever beside two icebergs without a visitor.
     */
    void changingVelocitiesLeaveNobodyIdle()
    {
        Scenario s;
        s.seed = 1;
        s.duration_s = 600;
        s.planner.tau = 20;
        s.uavs = {{.id = "u1"}, {.id = "u2", .position_m = {0, -100}}};
        s.uavs[0].heading_deg = s.uavs[1].heading_deg = 90;
        s.uavs[1].spec.altitude_m = 180;
        for (const char* id : {"a", "b", "c"})
            s.icebergs.push_back({.id = id,
                                  .position_m = {8000, 1500.0 * (*id - 'a')},
                                  .velocity_mps = {0, 0},
                                  .velocitySd_mps = 0.05});
        s.observer.model = ObserverModel::Kalman;
        Mission stay(s);
        stay.advance(s.duration_s);
        test::letVelocitiesChange(s);
        for (Iceberg& iceberg : s.icebergs)
            iceberg.velocityTime_s = 36'000;
        Mission change(s);
        change.advance(s.duration_s);
        const auto visits = std::ranges::count_if(change.events(), [](const MissionEvent& event) {
            return event.kind == EventKind::Reached && event.uav == 1;
        });
        QCOMPARE(visits, 4); // was 0
        // It was 33 % more. Unknown values grow a little differently.
        QVERIFY(std::abs(change.metrics().zeta_m2s / stay.metrics().zeta_m2s - 1) < 0.1);
    }

    /** With one command in ten seconds held turn rates made it oscillate: 5 visits in an hour. */
    void slowAutopilotsFollowTheLeg()
    {
        Scenario s = calm();
        s.duration_s = 3600;
        s.uavs = {{.id = "u"}};
        s.uavs[0].heading_deg = 80;
        s.uavs[0].spec.autopilot_s = 10;
        s.icebergs = {{.id = "a", .position_m = {20'000, 0}, .velocity_mps = {0, 0}}};
        Mission mission(s, {.workLimit = 20'000, .record = false});
        mission.advance(s.duration_s);
        QVERIFY2(mission.metrics().visits >= 40,
                 qPrintable(QString::number(mission.metrics().visits)));
        QCOMPARE(mission.simulation().uav(0).guidance.gains.turn_1ps, 0.1);
        s.uavs[0].spec.autopilot_s = 1;
        QCOMPARE(Simulation(s).uav(0).guidance.gains.turn_1ps, 1.0);
    }
};

QTEST_APPLESS_MAIN(TestFleetAlone)
#include "tst_fleet_alone.moc"
