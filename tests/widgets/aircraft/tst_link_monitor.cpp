#include "core/link/transport/link_clock.h"
#include "core/sim/steering.h"
#include "tests/support/window/free_port.h"
#include "tests/support/window/patience.h"
#include "widgets/aircraft/link_monitor.h"
#include "widgets/aircraft/rehearsal_fleet.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QtTest>

#include <algorithm>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

constexpr LinkAddress kFirst{.system = 1, .component = 1};

/** Returns whether a thread of this process has that name. */
bool hasThread(const QByteArray& name)
{
    const QDir tasks(u"/proc/self/task"_s);
    const QStringList ids = tasks.entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    return std::any_of(ids.begin(), ids.end(), [&](const QString& id) {
        QFile file(tasks.filePath(id + u"/comm"_s));
        return file.open(QIODevice::ReadOnly) && file.readAll().trimmed() == name;
    });
}

LinkOpener listening(int port)
{
    return [port] { return openLink({.kind = LinkEndpoint::Kind::UdpListen, .port = port}); };
}

/** Aircraft with ids from 1 that circle a place; PX4 sends its telemetry unasked. */
std::vector<RehearsalOptions> fleet(std::vector<AutopilotKind> kinds)
{
    std::vector<RehearsalOptions> all;
    for (const AutopilotKind kind : kinds) {
        RehearsalOptions& one = all.emplace_back();
        one.side.self.system = static_cast<std::uint8_t>(all.size());
        one.side.autopilot = kind;
        one.home = {.latitude_deg = 47, .longitude_deg = -48};
    }
    return all;
}

const LinkVehicle* vehicleOf(const LinkMonitor& monitor, LinkAddress address)
{
    for (const LinkVehicle& vehicle : monitor.status().vehicles)
        if (vehicle.address == address)
            return &vehicle;
    return nullptr;
}

bool hasPosition(const LinkMonitor& monitor, LinkAddress address = kFirst)
{
    const LinkVehicle* vehicle = vehicleOf(monitor, address);
    return vehicle != nullptr && vehicle->state.position.has_value();
}

std::vector<MissionPart> squareMission()
{
    MissionPart part;
    for (const auto& [x, y] : {std::pair(470'100'000, -480'000'000), {470'100'000, -479'850'000}})
        part.items.push_back({.params = {0, 30, 0, 0}, .x = x, .y = y, .z = 100});
    return {part};
}

} // namespace

class TestLinkMonitor : public QObject
{
    Q_OBJECT

private slots:
    void nothingRunsBeforeListening()
    {
        LinkMonitor monitor;
        QVERIFY(!monitor.isListening());
        monitor.stop();
        monitor.setSending(true);
        QVERIFY(!monitor.status().isListening);
        QVERIFY(!hasThread("link"));
        monitor.listen(listening(test::freeUdpPort()));
        QTRY_VERIFY_WITH_TIMEOUT(hasThread("link"), test::kPatience_ms);
    }

    void severalAircraftAreHeard()
    {
        const int port = test::freeUdpPort();
        LinkMonitor monitor;
        monitor.listen(listening(port));
        const RehearsalFleet aircraft(fleet({AutopilotKind::Px4, AutopilotKind::Px4}), port);
        const LinkAddress second{.system = 2, .component = 1};
        QTRY_VERIFY_WITH_TIMEOUT(hasPosition(monitor) && hasPosition(monitor, second),
                                 test::kPatience_ms);
        QVERIFY(vehicleOf(monitor, second)->autopilot == AutopilotKind::Px4);
        QTRY_VERIFY_WITH_TIMEOUT(monitor.trackOf(kFirst).size() > 2, test::kPatience_ms);
        monitor.stop();
        QVERIFY(monitor.status().vehicles.empty());
        QVERIFY(monitor.trackOf(kFirst).empty());
    }

    /** The peer counts what it gets: nothing until sending is on, and then a heartbeat. */
    void nothingIsSentWhileSendingIsOff()
    {
        const int port = test::freeUdpPort();
        LinkMonitor monitor;
        monitor.listen(listening(port));
        const auto peer = openLink({.kind = LinkEndpoint::Kind::UdpSend, .port = port});
        VehicleSide side(*peer, {.autopilot = AutopilotKind::ArduPilot});
        int received = 0;
        int steps = 0;
        const auto step = [&] {
            while (peer->receive()) // before the vehicle's side can take it
                ++received;
            static_cast<void>(side.advance(linkTimeNow(), {}));
            return ++steps;
        };
        QSignalSpy updates(&monitor, &LinkMonitor::updated);
        QTRY_VERIFY_WITH_TIMEOUT(step() > 0 && vehicleOf(monitor, kFirst) != nullptr,
                                 test::kPatience_ms);
        monitor.startSync(kFirst, squareMission(), MissionSync::Task::UploadAndCompare);
        monitor.sendCommand(kFirst, modeCommand(AutopilotKind::ArduPilot, 10));
        updates.clear();
        QTRY_VERIFY_WITH_TIMEOUT(step() > 0 && updates.count() > 15, test::kPatience_ms);
        QCOMPARE(received, 0);
        monitor.setSending(true);
        QTRY_VERIFY_WITH_TIMEOUT(step() > 0 && received > 0, test::kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(monitor.status().isSending, test::kPatience_ms);
        QVERIFY(!vehicleOf(monitor, kFirst)->sync); // requested while sending was off
    }

    void uploadIsReadBackAndEqual_data()
    {
        QTest::addColumn<AutopilotKind>("kind");
        QTest::newRow("ArduPilot") << AutopilotKind::ArduPilot;
        QTest::newRow("PX4") << AutopilotKind::Px4;
    }

    void uploadIsReadBackAndEqual()
    {
        QFETCH(AutopilotKind, kind);
        const int port = test::freeUdpPort();
        LinkMonitor monitor;
        monitor.listen(listening(port));
        const RehearsalFleet aircraft(fleet({kind}), port);
        QTRY_VERIFY_WITH_TIMEOUT(vehicleOf(monitor, kFirst) != nullptr, test::kPatience_ms);
        monitor.setSending(true);
        QTRY_VERIFY_WITH_TIMEOUT(hasPosition(monitor), test::kPatience_ms);
        monitor.startSync(kFirst, squareMission(), MissionSync::Task::UploadAndCompare);
        const auto isEqual = [&] {
            const LinkVehicle* vehicle = vehicleOf(monitor, kFirst);
            return vehicle != nullptr && vehicle->sync && vehicle->sync->phase == SyncPhase::Equal;
        };
        QTRY_VERIFY_WITH_TIMEOUT(isEqual(), test::kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(monitor.status().onBoard.contains(kFirst), test::kPatience_ms);
        QCOMPARE(monitor.status().onBoard.at(kFirst).front().items.size(), std::size_t{2});
    }

    void silentAircraftBecomesAGhost()
    {
        const int port = test::freeUdpPort();
        LinkMonitor monitor;
        monitor.listen(listening(port));
        RehearsalFleet aircraft(fleet({AutopilotKind::Px4}), port);
        QTRY_VERIFY_WITH_TIMEOUT(hasPosition(monitor), test::kPatience_ms);
        const LatLon here{.latitude_deg = 47, .longitude_deg = -48}; // it circles there
        monitor.setData({{kFirst, {.station = here, .range_m = 5000}}});
        QVERIFY(monitor.status().ghosts.empty());
        aircraft.setSilent(true);
        QTRY_VERIFY_WITH_TIMEOUT(!monitor.status().ghosts.empty(), test::kPatience_ms);
        const GhostReport ghost = monitor.status().ghosts.front();
        QVERIFY(ghost.address == kFirst);
        QVERIFY(ghost.silentFor_s > 2);
        QTRY_VERIFY_WITH_TIMEOUT(!monitor.status().ghosts.empty() &&
                                     monitor.status().ghosts.front().expected,
                                 test::kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(vehicleOf(monitor, kFirst)->isLost, test::kPatience_ms);
        aircraft.setSilent(false);
        QTRY_VERIFY_WITH_TIMEOUT(monitor.status().ghosts.empty(), test::kPatience_ms);
    }
};

QTEST_GUILESS_MAIN(TestLinkMonitor)
#include "tst_link_monitor.moc"
