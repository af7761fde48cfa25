#include "core/sim/ghost_aircraft.h"

#include <QtTest>

using namespace berg;

namespace {

constexpr LatLon kStart{.latitude_deg = 47, .longitude_deg = -48};
constexpr double kDegreeNorth_m = 111'190; ///< of a meridian here, within 0.1 %

/** Lost at 100 s while flying north at 20 m/s, with a mission of two waypoints, north and back. */
LastContact lastContact(std::uint32_t mode)
{
    const auto at = [](double north_m) {
        return LinkMissionItem{
            .params = {0, 50, 0, 0},
            .x = static_cast<std::int32_t>(std::lround(1e7 * (47 + north_m / kDegreeNorth_m))),
            .y = -480'000'000,
            .z = 120};
    };
    LastContact last;
    last.vehicle = {.autopilot = AutopilotKind::ArduPilot, .mode = mode};
    last.vehicle.state.position = AircraftPosition{.place = kStart,
                                                   .altitude_m = 120,
                                                   .aboveHome_m = 120,
                                                   .heading_rad = 0,
                                                   .received_s = 100};
    last.vehicle.state.airspeed_mps = 20;
    last.vehicle.state.mission = AircraftMission{.item = 1};
    last.onBoard = {at(10'000), at(-20'000)};
    return last;
}

} // namespace

class TestGhostAircraft : public QObject
{
    Q_OBJECT

private slots:
    void missionOnBoardIsFlownOn()
    {
        GhostAircraft ghost(lastContact(10));
        ghost.advance(160);
        QVERIFY(std::abs(greatCircle_m(ghost.readings().place, kStart) - 1200) < 20);
        QVERIFY(ghost.readings().place.latitude_deg > 47);
        QCOMPARE(ghost.readings().item, 0);
        ghost.advance(700); // the first waypoint is 500 s away
        QCOMPARE(ghost.readings().item, 1);
    }

    /** A link that only listens does not know the mission, but the aircraft flies it. */
    void unknownMissionIsFlownStraightOn_data()
    {
        QTest::addColumn<AutopilotKind>("kind");
        QTest::addColumn<std::uint32_t>("mode");
        QTest::newRow("ArduPilot") << AutopilotKind::ArduPilot << 10U;
        QTest::newRow("PX4") << AutopilotKind::Px4 << 0x04040000U;
        QTest::newRow("other") << AutopilotKind::Other << 10U;
    }

    void unknownMissionIsFlownStraightOn()
    {
        QFETCH(AutopilotKind, kind);
        QFETCH(std::uint32_t, mode);
        LastContact last = lastContact(mode);
        last.vehicle.autopilot = kind;
        last.onBoard.clear();
        GhostAircraft ghost(last);
        ghost.advance(400);
        QCOMPARE(ghost.readings().mode, mode);
        QVERIFY(std::abs(greatCircle_m(ghost.readings().place, kStart) - 6000) < 30);
    }

    /** Only ArduPilot counts its home as item 0. */
    void presentItemIsThatOfTheAutopilot_data()
    {
        QTest::addColumn<AutopilotKind>("kind");
        QTest::addColumn<std::uint32_t>("mode");
        QTest::addColumn<int>("item");
        QTest::newRow("ArduPilot") << AutopilotKind::ArduPilot << 10U << 0;
        QTest::newRow("PX4") << AutopilotKind::Px4 << 0x04040000U << 1;
        QTest::newRow("other") << AutopilotKind::Other << 10U << 1;
    }

    void presentItemIsThatOfTheAutopilot()
    {
        QFETCH(AutopilotKind, kind);
        QFETCH(std::uint32_t, mode);
        QFETCH(int, item);
        LastContact last = lastContact(mode); // MISSION_CURRENT says 1
        last.vehicle.autopilot = kind;
        GhostAircraft ghost(last);
        ghost.advance(160);
        QCOMPARE(ghost.readings().item, item);
        QCOMPARE(ghost.readings().place.latitude_deg > 47, item == 0); // the second is south
    }

    /** Items of other ground stations have NaN where the vehicle decides. */
    void itemsWithMissingValuesAreFlown()
    {
        LastContact last = lastContact(10);
        last.onBoard[0].command = LinkCommandId::kLoiterUnlimited;
        last.onBoard[0].params.fill(std::numeric_limits<float>::quiet_NaN());
        GhostAircraft ghost(last);
        ghost.advance(1000);
        QVERIFY(std::abs(greatCircle_m(ghost.readings().place, kStart) - 10'000) < 300);
        QCOMPARE(ghost.readings().altitude_m, 120.0);
    }

    /** In a mode of the pilot it flies straight on. */
    void otherModesFlyOnAsTheyWould()
    {
        GhostAircraft pilot(lastContact(5));
        pilot.advance(200);
        QVERIFY(std::abs(greatCircle_m(pilot.readings().place, kStart) - 2000) < 5);
        GhostAircraft home(lastContact(11));
        home.advance(1000);
        QVERIFY(greatCircle_m(home.readings().place, kStart) < 500);
    }

    /** The station is 15 km south with a range of 10 km: out of range until the way back. */
    void contactIsExpectedOnTheWayBack()
    {
        GhostAircraft ghost(lastContact(10));
        const LatLon station{.latitude_deg = 47 - 15'000 / kDegreeNorth_m, .longitude_deg = -48};
        const auto back = ghost.expectedContact(station, 10'000, 7200);
        QVERIFY(back.has_value());
        // 10 km north, a turn, 15 km south at 20 m/s; the turn takes less than a minute.
        QVERIFY(back->at_s > 100 + 1240 && back->at_s < 100 + 1320);
        QVERIFY(std::abs(greatCircle_m(back->place, station) - 10'000) < 50);
        QVERIFY(!ghost.expectedContact(station, 10'000, 600));
        const auto here = ghost.expectedContact(kStart, 1000, 600);
        QVERIFY(here.has_value());
        QCOMPARE(here->at_s, 100.0);
        QVERIFY(std::abs(greatCircle_m(ghost.readings().place, kStart)) < 1); // not moved by it
    }
};

QTEST_APPLESS_MAIN(TestGhostAircraft)
#include "tst_ghost_aircraft.moc"
