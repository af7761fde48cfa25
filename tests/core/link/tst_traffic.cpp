#include "core/link/traffic.h"

#include <QtTest>

using namespace berg;

namespace {

LinkMessage aircraft(std::int64_t id)
{
    return LinkMessage(MessageId::AdsbVehicle)
        .with("ICAO_address", id)
        .with("lat", 471'000'000)
        .with("lon", -482'000'000)
        .with("altitude", 1'200'000)
        .with("heading", 9000)
        .with("hor_velocity", 8000)
        .with("flags", 1 | 2 | 4 | 8)
        .withText("callsign", "SAR1");
}

LinkMessage ship()
{
    return LinkMessage(MessageId::AisVessel)
        .with("MMSI", 257'000'001)
        .with("lat", 472'000'000)
        .with("lon", -483'000'000)
        .with("COG", 27000)
        .with("velocity", 550)
        .with("flags", 2 | 4)
        .withText("name", "POLAR");
}

} // namespace

class TestTraffic : public QObject
{
    Q_OBJECT

private slots:
    void aircraftAndShipsAreListed()
    {
        TrafficList list;
        list.receive(ship(), 10);
        list.receive(aircraft(7), 10);
        list.receive(LinkMessage(MessageId::Heartbeat), 10);
        const std::vector<TrafficTarget> targets = list.targets();
        QCOMPARE(targets.size(), std::size_t{2});
        QCOMPARE(targets[0].name, std::string("SAR1"));
        QCOMPARE(targets[0].altitude_m.value(), 1200.0);
        QCOMPARE(targets[0].speed_mps, 80.0);
        QCOMPARE(targets[0].place.latitude_deg, 47.1);
        QVERIFY(targets[1].kind == TrafficTarget::Kind::Ship);
        QCOMPARE(targets[1].name, std::string("POLAR"));
        QCOMPARE(targets[1].course_rad.value(), 1.5 * 3.14159265358979312);
        QCOMPARE(targets[1].speed_mps, 5.5);
    }

    void unknownPositionsAreIgnored()
    {
        TrafficList list;
        list.receive(aircraft(1).with("flags", 2), 0);
        list.receive(ship().with("lat", 910'000'000), 0);
        QVERIFY(list.targets().empty());
        list.receive(ship().with("flags", 0), 0);
        QVERIFY(!list.targets().at(0).course_rad);
        QCOMPARE(list.targets().at(0).speed_mps, 0.0);
    }

    void silentTargetsDisappear()
    {
        TrafficList list;
        list.receive(aircraft(1), 0);
        list.receive(ship(), 0);
        list.advance(59);
        QCOMPARE(list.targets().size(), std::size_t{2});
        list.advance(61);
        QCOMPARE(list.targets().size(), std::size_t{1});
        list.advance(601);
        QVERIFY(list.targets().empty());
    }

    void targetsOfNmeaAreListed()
    {
        const auto at = [](NmeaTarget::Kind kind, std::uint32_t id, double latitude_deg,
                           const char* name = "") {
            return NmeaTarget{.kind = kind,
                              .id = id,
                              .name = name,
                              .place = {.latitude_deg = latitude_deg, .longitude_deg = -48},
                              .speed_mps = 0.3,
                              .course_deg = 90};
        };
        TrafficList list;
        list.receive(at(NmeaTarget::Kind::Ship, 257'000'001, 47), 0);
        list.receive(at(NmeaTarget::Kind::Radar, 3, 47.1), 0);
        list.receive(at(NmeaTarget::Kind::Radar, 4, 47.002), 0); // the ship, 222 m away
        list.receive(at(NmeaTarget::Kind::Aid, 992'570'001, 47.2, "ICEBERG 7"), 0);
        list.receive(at(NmeaTarget::Kind::Aid, 992'570'002, 47.3, "OFFICE BUOY"), 0);
        std::vector<TrafficTarget> targets = list.targets();
        QCOMPARE(targets.size(), std::size_t{3});
        QVERIFY(targets[0].kind == TrafficTarget::Kind::Ship);
        QVERIFY(targets[1].kind == TrafficTarget::Kind::Ice && targets[1].id == 3);
        QCOMPARE(targets[1].course_rad.value(), 0.5 * 3.14159265358979312);
        QCOMPARE(targets[2].name, std::string("ICEBERG 7"));
        list.advance(121);
        targets = list.targets();
        QCOMPARE(targets.size(), std::size_t{1});                  // the radar has lost its target
        list.receive(at(NmeaTarget::Kind::Radar, 4, 47.002), 200); // the ship is silent
        QCOMPARE(list.targets().size(), std::size_t{2});
    }

    void memoryIsBounded()
    {
        TrafficList list;
        for (int id = 0; id < 2000; ++id)
            list.receive(aircraft(id), 0);
        QCOMPARE(list.targets().size(), std::size_t{250});
        list.receive(aircraft(3).withText("callsign", "NEW"), 1);
        QCOMPARE(list.targets()[3].name, std::string("NEW"));
        list.receive(ship(), 1); // many aircraft do not hide it
        QCOMPARE(list.targets().size(), std::size_t{251});
    }
};

QTEST_APPLESS_MAIN(TestTraffic)
#include "tst_traffic.moc"
