#include "core/link/message/memory_link.h"
#include "core/link/tracker_list.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace berg;

namespace {

NmeaFix fixOf(std::string_view content)
{
    NmeaReader reader;
    const std::string text = nmeaSentence(content);
    const std::vector<NmeaFix> fixes =
        reader.feed({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    return fixes.empty() ? NmeaFix{} : fixes.front();
}

std::string gga(const char* minutesNorth)
{
    return std::string("GPGGA,120000,47") + minutesNorth + ",N,04800.000,W,1,08,1.0,12.5,M,0,M,,";
}

int countOf(const std::vector<LinkEvent>& events, LinkEvent::Kind kind)
{
    return static_cast<int>(std::ranges::count(events, kind, &LinkEvent::kind));
}

} // namespace

class TestTrackerList : public QObject
{
    Q_OBJECT

private slots:
    void sentencesOfOneTrackerAreJoined()
    {
        TrackerList trackers;
        trackers.receive({.peer = 3, .fix = fixOf(gga("30.000"))}, 1);
        trackers.receive({.peer = 3, .fix = fixOf("GPVTG,90.0,T,,M,20.0,N,37.0,K,A")}, 1);
        const std::vector<LinkVehicle> all = trackers.vehicles();
        QCOMPARE(all.size(), std::size_t{1});
        QVERIFY(isTracker(all[0].address));
        QVERIFY(!isTracker({.system = 1, .component = 1}));
        const AircraftPosition& position = all[0].state.position.value();
        QCOMPARE(position.place.latitude_deg, 47.5);
        QCOMPARE(position.place.longitude_deg, -48.0);
        QCOMPARE(position.altitude_m, 12.5);
        QVERIFY(std::abs(position.east_mps - 20 * 1852.0 / 3600) < 1e-9);
        QVERIFY(std::abs(position.north_mps) < 1e-9);
        QCOMPARE(position.received_s, 1.0);
    }

    /** Trackers that send GGA alone move from place to place. */
    void speedIsDerived()
    {
        TrackerList trackers;
        trackers.receive({.peer = 0, .fix = fixOf(gga("30.000"))}, 10);
        QVERIFY(!trackers.vehicles()[0].state.groundSpeed_mps);
        trackers.receive({.peer = 0, .fix = fixOf(gga("30.010"))}, 12); // 18.5 m in 2 s
        const LinkVehicle tracker = trackers.vehicles()[0];
        QVERIFY(std::abs(tracker.state.groundSpeed_mps.value() - 9.26) < 0.05);
        QVERIFY(std::abs(tracker.state.position->north_mps - 9.26) < 0.05);
        trackers.receive({.peer = 0, .fix = fixOf(gga("40.000"))}, 14); // a jump
        QVERIFY(trackers.vehicles()[0].state.groundSpeed_mps.value() < 10);
    }

    void silenceIsReported()
    {
        TrackerList trackers;
        trackers.receive({.peer = 0, .fix = fixOf(gga("30.000"))}, 10);
        QCOMPARE(countOf(trackers.advance(10), LinkEvent::Kind::VehicleAppeared), 1);
        QVERIFY(trackers.advance(14.9).empty());
        QCOMPARE(countOf(trackers.advance(15.1), LinkEvent::Kind::VehicleLost), 1);
        QVERIFY(trackers.vehicles()[0].isLost);
        QVERIFY(trackers.advance(60).empty());
        trackers.receive({.peer = 0, .fix = fixOf(gga("30.000"))}, 61);
        QCOMPARE(countOf(trackers.advance(61), LinkEvent::Kind::VehicleReturned), 1);
        QVERIFY(!trackers.vehicles()[0].isLost);
    }

    /** A flood of senders neither grows the list nor pushes out those that are alive. */
    void numberIsLimited()
    {
        TrackerList trackers;
        for (int peer = 0; peer < 100; ++peer)
            trackers.receive({.peer = peer, .fix = fixOf(gga("30.000"))}, 10);
        QCOMPARE(trackers.vehicles().size(), std::size_t{32});
        QCOMPARE(trackers.vehicles().back().peer, 31);
        for (int peer = 1; peer < 32; ++peer)
            trackers.receive({.peer = peer, .fix = fixOf(gga("30.000"))}, 16);
        static_cast<void>(trackers.advance(16)); // peer 0 is lost
        trackers.receive({.peer = 99, .fix = fixOf(gga("30.000"))}, 16);
        QCOMPARE(trackers.vehicles().size(), std::size_t{32});
        QCOMPARE(trackers.vehicles().front().peer, 99);
        QCOMPARE(trackers.vehicles().front().address.component, std::uint8_t{1});
    }

    void linkPassesAllOn()
    {
        auto [near, far] = MemoryLink::pair();
        TrackerLink link(near);
        const std::string text = nmeaSentence(gga("30.000"));
        const std::span<const std::uint8_t> bytes(
            reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
        far.send(0, bytes.first(20)); // a stream may cut sentences anywhere
        far.send(0, bytes.subspan(20));
        std::size_t passed = 0;
        while (const std::optional<LinkPacket> packet = link.receive())
            passed += packet->bytes.size();
        QCOMPARE(passed, text.size());
        const std::vector<TrackerFix> fixes = link.takeFixes();
        QCOMPARE(fixes.size(), std::size_t{1});
        QCOMPARE(fixes[0].fix.place->latitude_deg, 47.5);
        QVERIFY(link.takeFixes().empty());
        link.send(0, bytes);
        QVERIFY(far.receive());
    }
};

QTEST_APPLESS_MAIN(TestTrackerList)
#include "tst_tracker_list.moc"
