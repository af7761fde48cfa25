// The window's link against a vehicle by the npm package node-mavlink. Without the package the test
// is skipped.

#include "core/link/transport/transport_link.h"
#include "tests/support/flight/link_scene.h"
#include "tests/support/flight/node_vehicle.h"
#include "tests/support/window/patience.h"
#include "widgets/aircraft/link_monitor.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;

namespace {

constexpr LinkAddress kNodeVehicle{.system = 1, .component = 1};

/** A port that parallel tests do not share. */
int nodePort()
{
    return 40'000 + static_cast<int>(QCoreApplication::applicationPid() % 10'000);
}

} // namespace

class TestNodeWindow : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!NodeVehicle::isThere())
            QSKIP("node or its package node-mavlink is missing: no independent peer was tested");
    }

    void missionsAreUploaded_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<double>("loss");
        for (const char* kind : {"ardupilot", "px4"})
            for (const double loss : {0.0, 0.05})
                QTest::addRow("%s, %.0f %% lost", kind, 100 * loss)
                    << QString::fromLatin1(kind) << loss;
    }

    /** The vehicle counts what it receives: nothing before sending is on. */
    void missionsAreUploaded()
    {
        QFETCH(QString, kind);
        QFETCH(double, loss);
        LinkMonitor monitor;
        const int port = nodePort();
        monitor.listen(
            [port] { return openLink({.kind = LinkEndpoint::Kind::UdpListen, .port = port}); });
        NodeVehicle node(port, kind, loss, 5);
        const auto until = [](const std::function<bool()>& isDone) {
            return QTest::qWaitFor(isDone, kPatience_ms);
        };
        const auto vehicle = [&]() -> const LinkVehicle* {
            for (const LinkVehicle& each : monitor.status().vehicles)
                if (each.address == kNodeVehicle)
                    return &each;
            return nullptr;
        };
        QVERIFY(until([&] { return vehicle() != nullptr; }));
        const std::vector<MissionPart> parts{{.items = someMission(14)},
                                             {.type = MissionType::Fence, .items = someFence()},
                                             {.type = MissionType::Rally, .items = someRally()}};
        monitor.startSync(kNodeVehicle, parts, MissionSync::Task::UploadAndCompare);
        QSignalSpy updates(&monitor, &LinkMonitor::updated);
        QVERIFY(until([&] { return updates.count() > 10; }));
        QCOMPARE(node.datagrams(until), 0);
        QVERIFY(!vehicle()->sync);

        monitor.setSending(true);
        QVERIFY(until([&] { return monitor.status().isSending; }));
        monitor.startSync(kNodeVehicle, parts, MissionSync::Task::UploadAndCompare);
        QVERIFY(until([&] {
            return vehicle()->sync && vehicle()->sync->phase != SyncPhase::Uploading &&
                   vehicle()->sync->phase != SyncPhase::ReadingBack;
        }));
        QCOMPARE(vehicle()->sync->phase, SyncPhase::Equal);
        QVERIFY(until([&] { return monitor.status().onBoard.contains(kNodeVehicle); }));
        QCOMPARE(monitor.status().onBoard.at(kNodeVehicle).size(), std::size_t{3});
    }
};

QTEST_GUILESS_MAIN(TestNodeWindow)
#include "tst_node_window.moc"
