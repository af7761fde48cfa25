#include "core/link/transport/link_clock.h"
#include "core/sim/steering.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/free_port.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/aircraft/rehearsal_fleet.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QUndoStack>

using namespace berg;
using namespace Qt::StringLiterals;
using test::child;
using test::WindowFixture;

namespace {

Scenario px4Scenario()
{
    Scenario scenario = test::emptySea(3600);
    scenario.uavs.front().aircraft.firmware = AutopilotFirmware::Px4;
    test::addIceberg(scenario, 2000, 500);
    test::addIceberg(scenario, -1500, 2500);
    test::addIceberg(scenario, 3000, -2000);
    return scenario;
}

void setAddress(WindowFixture& w, int port)
{
    child<QLineEdit>(w.window(), u"linkAddress"_s).setText(u"udp:127.0.0.1:%1"_s.arg(port));
}

QString textOf(WindowFixture& w, const QString& label)
{
    return child<QLabel>(w.window(), label).text();
}

void clickButton(WindowFixture& w, const QString& name)
{
    child<QPushButton>(w.window(), name).click();
}

bool hasPosition(WindowFixture& w)
{
    const std::vector<LinkVehicle>& vehicles = w.workspace.link().status().vehicles;
    return !vehicles.empty() && vehicles.front().state.position.has_value();
}

void choose(WindowFixture& w, const QString& combo, SteeringKind kind)
{
    auto& box = child<QComboBox>(w.window(), combo);
    box.setCurrentIndex(box.findData(static_cast<int>(kind)));
    emit box.activated(box.currentIndex());
}

} // namespace

class TestMainWindowAircraft : public QObject
{
    Q_OBJECT

private slots:
    void faultyAddressIsExplained()
    {
        WindowFixture w(px4Scenario());
        auto& address = child<QLineEdit>(w.window(), u"linkAddress"_s);
        QCOMPARE(address.text(), u"udp:127.0.0.1:14550"_s);
        address.setText(u"pigeon"_s);
        clickButton(w, u"listenButton"_s);
        QVERIFY(textOf(w, u"linkState"_s).contains(u"pigeon"_s));
        QVERIFY(!w.workspace.link().isListening());
        QVERIFY(!child<QPushButton>(w.window(), u"listenButton"_s).isChecked());
        QVERIFY(!child<QCheckBox>(w.window(), u"sendSwitch"_s).isEnabled());
    }

    /** The whole chain on one computer, from the plan to the real flight in the record. */
    void rehearsalFliesThePlan()
    {
        WindowFixture w(px4Scenario());
        setAddress(w, test::freeUdpPort());
        clickButton(w, u"rehearseButton"_s);
        QVERIFY(w.workspace.link().isListening());
        QVERIFY(w.until([&] { return hasPosition(w); }));
        const auto& list = child<QTreeWidget>(w.window(), u"aircraftList"_s);
        QCOMPARE(list.topLevelItemCount(), 1);
        QCOMPARE(list.topLevelItem(0)->text(1), u"Hold"_s);
        QVERIFY(list.topLevelItem(0)->text(2).endsWith(u"ago"_s));
        QCOMPARE(child<QComboBox>(w.window(), u"aircraftUav"_s).currentText(), u"uav-1"_s);
        QVERIFY(w.until([&] { return textOf(w, u"aircraftDetails"_s).contains(u"Wind: from"_s); }));
        QCOMPARE(w.map().live().aircraft.size(), std::size_t{1});
        QVERIFY(!child<QPushButton>(w.window(), u"uploadButton"_s).isEnabled()); // not sending

        child<QCheckBox>(w.window(), u"sendSwitch"_s).click();
        QVERIFY(
            w.until([&] { return child<QPushButton>(w.window(), u"uploadButton"_s).isEnabled(); }));
        QCOMPARE(textOf(w, u"linkMark"_s), u"Link: sending"_s);
        clickButton(w, u"uploadButton"_s);
        QVERIFY(w.until(
            [&] { return textOf(w, u"onBoardState"_s).contains(u"same as the plan of"_s); }));

        w.document().edit(u"Move iceberg"_s, [](Scenario& scenario) {
            scenario.icebergs.front().position_m = {2100, 500};
        });
        QVERIFY(w.until([&] {
            return textOf(w, u"onBoardState"_s).contains(u"the plan has changed since"_s);
        }));
        w.document().undoStack()->undo();
        QVERIFY(w.until(
            [&] { return textOf(w, u"onBoardState"_s).contains(u"same as the plan of"_s); }));

        clickButton(w, u"flyLiveButton"_s);
        QVERIFY(w.until([&] { return w.record().now.isLive && w.record().now.time_s > 1; }));
        const DubinsState& flown = w.record().now.world.uavs.front().pose;
        const LocalFrame frame(w.scenario().origin);
        const auto& position = w.workspace.link().status().vehicles.front().state.position;
        QVERIFY((frame.toPlane(position->place) - flown.position_m).norm() < 200);
        QVERIFY(w.map().live().aircraft.front().isFlown);
        w.workspace.pause();
        QVERIFY(w.until(RunPhase::Paused));
        clickButton(w, u"rehearseButton"_s);
        clickButton(w, u"listenButton"_s);
        QVERIFY(!w.workspace.link().isListening());
        QVERIFY(w.map().live().aircraft.empty());
    }

    void pilotTakesOver()
    {
        const int port = test::freeUdpPort();
        WindowFixture w(px4Scenario());
        setAddress(w, port);
        clickButton(w, u"listenButton"_s);
        std::vector<RehearsalOptions> one(1);
        one.front().side.autopilot = AutopilotKind::Px4;
        one.front().home = w.scenario().origin;
        RehearsalFleet aircraft(one, port);
        QVERIFY(w.until([&] { return hasPosition(w); }));
        child<QCheckBox>(w.window(), u"sendSwitch"_s).click();
        QVERIFY(
            w.until([&] { return child<QPushButton>(w.window(), u"uploadButton"_s).isEnabled(); }));
        clickButton(w, u"uploadButton"_s);
        QVERIFY(w.until(
            [&] { return textOf(w, u"onBoardState"_s).contains(u"same as the plan of"_s); }));
        choose(w, u"steeringChoice"_s, SteeringKind::Mission);
        QVERIFY(textOf(w, u"steeringState"_s).startsWith(u"Waiting"_s));
        clickButton(w, u"flyMissionButton"_s);
        QVERIFY(w.until([&] { return textOf(w, u"steeringState"_s).startsWith(u"Replacing"_s); }));
        aircraft.setMode(0, 0x00010000); // Manual
        QVERIFY(w.until([&] {
            return textOf(w, u"steeringState"_s).startsWith(u"The pilot has taken over"_s);
        }));
        QVERIFY(child<QPlainTextEdit>(w.window(), u"linkEvents"_s)
                    .toPlainText()
                    .contains(u"mode Manual"_s));
        choose(w, u"steeringChoice"_s, SteeringKind::None);
        QVERIFY(textOf(w, u"steeringState"_s).isEmpty());
    }
};

QTEST_MAIN(TestMainWindowAircraft)
#include "tst_main_window_aircraft.moc"
