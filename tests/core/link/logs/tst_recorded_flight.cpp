#include "core/link/logs/recorded_flight.h"

#include <QtTest>

using namespace berg;

namespace {

LoggedFrame logged(std::int64_t unix_us, LinkAddress sender, const LinkMessage& message)
{
    return {.unix_us = unix_us, .frame = {.sender = sender, .message = message}};
}

LinkMessage position(std::int64_t latitude_e7, std::int64_t altitude_mm)
{
    return LinkMessage(MessageId::GlobalPositionInt)
        .with("lat", latitude_e7)
        .with("lon", -480'000'000)
        .with("alt", altitude_mm)
        .with("relative_alt", 100'000);
}

} // namespace

class TestRecordedFlight : public QObject
{
    Q_OBJECT

private slots:
    void positionsOfEachVehicleAreFollowed()
    {
        const LinkAddress first{.system = 1, .component = 1};
        const LinkAddress second{.system = 2, .component = 1};
        FlightRecorder recorder;
        QVERIFY(recorder.add(logged(1'000'000, first, position(470'000'000, 120'500))));
        recorder.add(logged(1'100'000, second, position(471'000'000, 90'000)));
        QVERIFY(!recorder.add(logged(1'200'000, first, LinkMessage(MessageId::Heartbeat))));
        recorder.add(logged(1'300'000, first, position(990'000'000, 0))); // beyond the pole
        recorder.add(logged(1'400'000, first, position(470'001'000, 121'000)));
        recorder.add({.unix_us = 1, .frame = {.sender = first}}); // unknown message
        QCOMPARE(recorder.flights().size(), std::size_t{2});
        const std::vector<RecordedPosition>& flight = recorder.flights().at(first);
        QCOMPARE(flight.size(), std::size_t{2});
        QCOMPARE(flight[0].unix_us, std::int64_t{1'000'000});
        QCOMPARE(flight[0].altitude_m, 120.5);
        QCOMPARE(flight[1].place.latitude_deg, 47.0001);
        QCOMPARE(flight[1].place.longitude_deg, -48.0);
    }

    void vehiclesAreLimited()
    {
        FlightRecorder recorder;
        for (std::uint8_t system = 1; system <= 40; ++system)
            recorder.add(logged(1, {.system = system, .component = 1}, position(470'000'000, 0)));
        QCOMPARE(recorder.flights().size(), std::size_t{32});
    }
};

QTEST_APPLESS_MAIN(TestRecordedFlight)
#include "tst_recorded_flight.moc"
