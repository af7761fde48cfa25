#include "core/sim/steering.h"

#include <QtTest>

using namespace berg;

class TestSteering : public QObject
{
    Q_OBJECT

private slots:
    void missionIsSteeredInAutoOnly()
    {
        Steering steering;
        QVERIFY(steering.state() == SteeringState::Off);
        steering.begin(SteeringKind::Mission, AutopilotKind::ArduPilot, 12); // LOITER
        QVERIFY(steering.state() == SteeringState::Waiting);
        steering.setMode(12);
        QVERIFY(steering.state() == SteeringState::Waiting);
        steering.setMode(10); // AUTO
        QVERIFY(steering.state() == SteeringState::Active);
        steering.setMode(5); // the pilot flies by hand
        QVERIFY(steering.state() == SteeringState::PilotTookOver);
        steering.setMode(10); // the user must decide to go on
        QVERIFY(steering.state() == SteeringState::PilotTookOver);
        steering.begin(SteeringKind::Mission, AutopilotKind::ArduPilot, 10);
        QVERIFY(steering.state() == SteeringState::Active);
        steering.begin(SteeringKind::None, AutopilotKind::ArduPilot, 10);
        QVERIFY(steering.state() == SteeringState::Off);
    }

    /** A third mode while waiting is the pilot's choice, too. */
    void anotherModeWhileWaitingIsThePilots()
    {
        Steering steering;
        steering.begin(SteeringKind::Guided, AutopilotKind::Px4, 0x04040000);
        QVERIFY(steering.state() == SteeringState::Waiting);
        steering.setMode(0x00010000); // Manual
        QVERIFY(steering.state() == SteeringState::PilotTookOver);
    }

    /** PX4 is guided in its hold mode, in which it also stops for its pilot. */
    void holdWithoutATargetIsThePilots()
    {
        constexpr std::uint32_t kMission = 0x04040000;
        const std::uint32_t hold = steeringMode(SteeringKind::Guided, AutopilotKind::Px4);
        Steering steering;
        steering.begin(SteeringKind::Guided, AutopilotKind::Px4, kMission);
        steering.setMode(hold);
        QVERIFY(steering.state() == SteeringState::PilotTookOver);

        steering.begin(SteeringKind::Guided, AutopilotKind::Px4, hold);
        QVERIFY(steering.state() == SteeringState::Waiting);
        steering.setTargetSent(true);
        steering.setMode(hold);
        QVERIFY(steering.state() == SteeringState::Active);

        steering.begin(SteeringKind::Guided, AutopilotKind::Px4, kMission);
        steering.setTargetSent(true);
        steering.setTargetSent(false); // refused
        steering.setMode(hold);
        QVERIFY(steering.state() == SteeringState::PilotTookOver);
    }

    void modesHaveTheNamesOfTheirAutopilot()
    {
        QCOMPARE(modeName(AutopilotKind::ArduPilot, 11), std::string("RTL"));
        QCOMPARE(modeName(AutopilotKind::Px4, 0x04040000), std::string("Mission"));
        QCOMPARE(modeName(AutopilotKind::ArduPilot, 99), std::string("99"));
        QCOMPARE(modeName(AutopilotKind::Other, 10), std::string("10"));
    }

    void everyCommandIsPermitted()
    {
        for (const AutopilotKind kind : {AutopilotKind::ArduPilot, AutopilotKind::Px4}) {
            for (const SteeringKind way : {SteeringKind::Mission, SteeringKind::Guided})
                QVERIFY(isPermitted(modeCommand(kind, steeringMode(way, kind)), kind));
            QVERIFY(isPermitted(itemCommand(kind, 3), kind));
            QVERIFY(isPermitted(*guidedCommand(kind, {}, 5), kind));
        }
        QVERIFY(!isPermitted(modeCommand(AutopilotKind::ArduPilot, 13), AutopilotKind::ArduPilot));
    }

    void altitudesAreThoseTheAutopilotExpects()
    {
        const GuidedPoint point{.place = {.latitude_deg = 47.5, .longitude_deg = -48.25},
                                .aboveHome_m = 120};
        const auto plane = guidedCommand(AutopilotKind::ArduPilot, point, std::nullopt);
        QVERIFY(plane && plane->frame == ItemFrame::AboveHome);
        QCOMPARE(plane->params[4], 475'000'000.0);
        QCOMPARE(plane->params[5], -482'500'000.0);
        QCOMPARE(plane->params[6], 120.0);
        QVERIFY(!guidedCommand(AutopilotKind::Px4, point, std::nullopt));
        const auto px4 = guidedCommand(AutopilotKind::Px4, point, 30);
        QVERIFY(px4 && px4->frame == ItemFrame::Global);
        QCOMPARE(px4->params[6], 150.0);
        QCOMPARE(itemCommand(AutopilotKind::ArduPilot, 2).params[0], 3.0); // home is item 0
        QCOMPARE(itemCommand(AutopilotKind::Px4, 2).params[0], 2.0);
    }

    void pointsLieBeyondTheCircle() { QCOMPARE(beyond_m(200, 20, 1.5), 330.0); }
};

QTEST_APPLESS_MAIN(TestSteering)
#include "tst_steering.moc"
