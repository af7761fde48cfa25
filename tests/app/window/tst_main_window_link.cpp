// The window with aircraft of the test, over UDP on this computer.

#include "core/link/transport/link_clock.h"
#include "core/link/transport/transport_link.h"
#include "core/sim/rehearsal_vehicle.h"
#include "core/sim/steering.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/window_fixture.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>
#include <QTreeWidget>

using namespace berg;
using namespace Qt::StringLiterals;
using test::child;
using test::WindowFixture;

namespace {

/** Twelve icebergs and some UAVs of PX4, which sends telemetry by itself. */
Scenario fleetScenario(int uavs)
{
    Scenario scenario = test::emptySea(3600);
    scenario.uavs.front().aircraft.firmware = AutopilotFirmware::Px4;
    for (int i = 1; i < uavs; ++i) {
        Uav& uav = scenario.uavs.emplace_back(scenario.uavs.front());
        uav.id = "uav-" + std::to_string(i + 1);
        uav.position_m = Point(0, -800.0 * i);
    }
    for (int i = 0; i < 12; ++i)
        test::addIceberg(scenario, 3000 + 700 * (i % 4), 900 * (i / 4) - 900);
    return scenario;
}

int linkPort()
{
    return 30'000 + static_cast<int>(QCoreApplication::applicationPid() % 9'000);
}

/** An aircraft whose system id is that of a UAV's place in the scenario, from 1. */
class LinkedAircraft
{
public:
    LinkedAircraft(const Scenario& scenario, int system)
        : m_link(openLink({.kind = LinkEndpoint::Kind::UdpSend, .port = linkPort()}))
        , m_vehicle(*m_link, optionsOf(scenario, system))
    {
        m_timer.callOnTimeout([this] { m_vehicle.advance(linkTimeNow()); });
        m_timer.start(50);
    }

    [[nodiscard]] RehearsalVehicle& vehicle() { return m_vehicle; }
    [[nodiscard]] int missionRevision() const
    {
        return m_vehicle.side().missions().revision(MissionType::Mission);
    }
    [[nodiscard]] std::size_t missionSize() const
    {
        return m_vehicle.side().missions().items(MissionType::Mission).size();
    }
    void send(const LinkMessage& message, LinkAddress sender)
    {
        m_link->send(0, frameBytes(message, sender, 0));
    }

private:
    static RehearsalOptions optionsOf(const Scenario& scenario, int system)
    {
        const Uav& uav = scenario.uavs[static_cast<std::size_t>(system - 1)];
        RehearsalOptions options{.uav = uav.spec, .home = scenario.origin};
        options.side.self.system = static_cast<std::uint8_t>(system);
        options.side.autopilot = AutopilotKind::Px4;
        options.start = LocalFrame(scenario.origin).toGeographic(uav.position_m);
        return options;
    }

    std::unique_ptr<TransportLink> m_link;
    RehearsalVehicle m_vehicle;
    QTimer m_timer;
};

void listenTo(WindowFixture& w)
{
    child<QLineEdit>(w.window(), u"linkAddress"_s).setText(u"udp:127.0.0.1:%1"_s.arg(linkPort()));
    child<QPushButton>(w.window(), u"listenButton"_s).click();
}

QString labelText(WindowFixture& w, const QString& label)
{
    return child<QLabel>(w.window(), label).text();
}

int aircraftShown(WindowFixture& w)
{
    return child<QTreeWidget>(w.window(), u"aircraftList"_s).topLevelItemCount();
}

void chooseAircraft(WindowFixture& w, int row)
{
    auto& list = child<QTreeWidget>(w.window(), u"aircraftList"_s);
    list.setCurrentItem(list.topLevelItem(row));
}

void uploadToChosen(WindowFixture& w)
{
    auto& button = child<QPushButton>(w.window(), u"uploadButton"_s);
    QVERIFY(w.until([&] { return button.isEnabled(); }));
    button.click();
    QVERIFY(w.until(
        [&] { return labelText(w, u"onBoardState"_s).contains(u"same as the plan of"_s); }));
}

bool isSteering(WindowFixture& w, const QString& words)
{
    return labelText(w, u"steeringState"_s).startsWith(words);
}

} // namespace

class TestMainWindowLink : public QObject
{
    Q_OBJECT

private slots:
    /** Aircraft appear in any order; each flies as the UAV of its id, and gets its mission. */
    void everyAircraftIsItsUav()
    {
        WindowFixture w(fleetScenario(3));
        listenTo(w);
        std::vector<std::unique_ptr<LinkedAircraft>> aircraft(3);
        int shown = 0;
        for (const int system : {3, 1, 2}) {
            aircraft[static_cast<std::size_t>(system - 1)] =
                std::make_unique<LinkedAircraft>(w.scenario(), system);
            ++shown;
            QVERIFY(w.until([&] { return aircraftShown(w) == shown; }));
        }
        child<QCheckBox>(w.window(), u"sendSwitch"_s).click();
        for (int row = 0; row < 3; ++row) {
            chooseAircraft(w, row);
            QCOMPARE(child<QComboBox>(w.window(), u"aircraftUav"_s).currentText(),
                     u"uav-%1"_s.arg(row + 1));
            uploadToChosen(w);
            if (QTest::currentTestFailed())
                return;
        }
        // Every iceberg is on the way of one of them; take-off, way home and speeds differ.
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY(aircraft[i]->missionSize() > 0);
            const UavPlan* own = planOf(w.record().now, static_cast<int>(i));
            QVERIFY(own != nullptr && aircraft[i]->missionSize() >= own->order.size());
        }
        QVERIFY(
            aircraft[0]->vehicle().side().missions().items(MissionType::Mission).front().y !=
                aircraft[2]->vehicle().side().missions().items(MissionType::Mission).front().y ||
            aircraft[0]->missionSize() != aircraft[2]->missionSize());
    }

    /** The window says so, and the switch is off. */
    void anotherStationWithOurIdIsNoticed()
    {
        WindowFixture w(fleetScenario(1));
        listenTo(w);
        LinkedAircraft aircraft(w.scenario(), 1);
        QVERIFY(w.until([&] { return aircraftShown(w) == 1; }));
        auto& sending = child<QCheckBox>(w.window(), u"sendSwitch"_s);
        sending.click();
        QVERIFY(w.until([&] { return labelText(w, u"linkMark"_s) == u"Link: sending"_s; }));
        aircraft.send(LinkMessage(MessageId::Heartbeat).with("type", 6).with("autopilot", 8),
                      {.system = 255, .component = 190});
        QVERIFY(w.until([&] { return labelText(w, u"linkMark"_s) == u"Link: listening"_s; }));
        QVERIFY(w.until([&] { return !sending.isChecked(); }));
        QVERIFY(!child<QPushButton>(w.window(), u"uploadButton"_s).isEnabled());
    }

    /** A changed plan replaces the mission on board, but not after the pilot has taken over. */
    void nothingIsUploadedAfterThePilotTookOver()
    {
        WindowFixture w(fleetScenario(1));
        listenTo(w);
        LinkedAircraft aircraft(w.scenario(), 1);
        QVERIFY(w.until([&] { return aircraftShown(w) == 1; }));
        child<QCheckBox>(w.window(), u"sendSwitch"_s).click();
        uploadToChosen(w);
        child<QPushButton>(w.window(), u"flyLiveButton"_s).click();
        QVERIFY(w.until([&] { return w.record().now.isLive && w.record().now.time_s > 1; }));
        auto& steering = child<QComboBox>(w.window(), u"steeringChoice"_s);
        steering.setCurrentIndex(steering.findData(static_cast<int>(SteeringKind::Mission)));
        emit steering.activated(steering.currentIndex());
        child<QPushButton>(w.window(), u"flyMissionButton"_s).click();
        QVERIFY(w.until([&] { return isSteering(w, u"Replacing"_s); }));

        // Without the iceberg after the next one the order ahead is another.
        const auto removeSecond = [&] {
            const IcebergList& order = planOf(w.record().now, 0)->order;
            const std::string id = w.record().now.icebergs[toIndex(order.at(1))].id;
            QCOMPARE(w.workspace.remove({id}), 1);
        };
        int revision = aircraft.missionRevision();
        removeSecond();
        QVERIFY(w.until([&] { return aircraft.missionRevision() > revision; }));
        QVERIFY(w.until(
            [&] { return labelText(w, u"onBoardState"_s).contains(u"same as the plan of"_s); }));

        aircraft.vehicle().setMode(0x00010000); // Manual
        QVERIFY(w.until([&] { return isSteering(w, u"The pilot has taken over"_s); }));
        revision = aircraft.missionRevision();
        removeSecond();
        QVERIFY(w.until([&] {
            return labelText(w, u"onBoardState"_s).contains(u"the plan has changed since"_s);
        }));
        QSignalSpy updates(&w.workspace.link(), &LinkMonitor::updated);
        QVERIFY(w.until([&] { return updates.count() > 30; }));
        QCOMPARE(aircraft.missionRevision(), revision);
        QCOMPARE(aircraft.vehicle().readings().mode, 0x00010000U);
        w.workspace.pause();
        QVERIFY(w.until(RunPhase::Paused));
    }
};

QTEST_MAIN(TestMainWindowLink)
#include "tst_main_window_link.moc"
