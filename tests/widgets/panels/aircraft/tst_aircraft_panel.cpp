#include "tests/support/window/panel_test.h"
#include "widgets/panels/aircraft/aircraft_panel.h"

#include <QComboBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTreeWidget>
#include <QWheelEvent>

using namespace berg;
using namespace Qt::StringLiterals;
using test::child;

namespace {

TrafficTarget heardShip(const std::string& name)
{
    return {.kind = TrafficTarget::Kind::Ship, .id = 257'000'001, .name = name};
}

LinkStatus steerable()
{
    LinkStatus status{
        .isListening = true, .condition = {.state = LinkCondition::State::Open}, .isSending = true};
    for (std::uint8_t system = 1; system <= 2; ++system)
        status.vehicles.push_back({.address = {.system = system, .component = 1}});
    return status;
}

} // namespace

class TestAircraftPanel : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** Scrolling over the panel must not begin to steer. */
    void wheelChangesNoChoice_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"steeringChoice", "aircraftUav", "assetShip", "homeShip"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }

    void wheelChangesNoChoice()
    {
        QFETCH(QString, name);
        AircraftPanel panel;
        panel.setUavs({"uav-1", "uav-2"});
        LinkStatus status = steerable();
        status.traffic = {heardShip("POLAR")};
        std::map<LinkAddress, AircraftNotes> notes;
        notes[{.system = 1, .component = 1}].uav = "uav-1";
        panel.showStatus(status, notes);
        panel.show();
        auto& box = child<QComboBox>(panel, name);
        box.clearFocus();
        const int before = box.currentIndex();
        QWheelEvent wheel(box.rect().center(), box.mapToGlobal(box.rect().center()), {0, -120},
                          {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&box, &wheel);
        QVERIFY(box.isEnabled());
        QCOMPARE(box.currentIndex(), before);
    }

    /** AIS sends the name of a ship apart from its place. */
    void shipGetsItsNameLater()
    {
        AircraftPanel panel;
        LinkStatus status = steerable();
        status.traffic = {heardShip({})};
        panel.showStatus(status, {});
        const auto& box = child<QComboBox>(panel, u"assetShip"_s);
        QCOMPARE(box.itemText(1), u"The asset follows 257000001"_s);
        status.traffic = {heardShip("POLAR")};
        panel.showStatus(status, {});
        QCOMPARE(box.count(), 2);
        QCOMPARE(box.itemText(1), u"The asset follows POLAR"_s);
    }

    /** Ice that a radar tracks can be reported in flight. */
    void iceIsReported()
    {
        AircraftPanel panel;
        LinkStatus status = steerable();
        panel.showStatus(status, {});
        auto& box = child<QComboBox>(panel, u"iceTarget"_s);
        auto& button = child<QPushButton>(panel, u"reportIce"_s);
        QVERIFY(!box.isVisibleTo(&panel));
        status.traffic = {{.kind = TrafficTarget::Kind::Ice, .id = 7},
                          {.kind = TrafficTarget::Kind::Ice, .id = 9, .name = "BERG"}};
        panel.showStatus(status, {});
        QVERIFY(box.isVisibleTo(&panel));
        QCOMPARE(box.itemText(0), u"Radar target 7"_s);
        QCOMPARE(box.itemText(1), u"BERG"_s);
        QVERIFY(!button.isEnabled());
        panel.showFlight({.mayReport = true});
        QSignalSpy reported(&panel, &AircraftPanel::iceReported);
        box.setCurrentIndex(1);
        status.traffic.erase(status.traffic.begin());
        panel.showStatus(status, {}); // the choice stays
        button.click();
        QCOMPARE(reported.size(), 1);
        QCOMPARE(reported[0][0].toUInt(), 9U);
    }

    /** A change of language makes a new panel. */
    void anotherPanelTakesOver()
    {
        AircraftPanel former;
        LinkStatus status = steerable();
        status.traffic = {heardShip("POLAR")};
        former.showStatus(status, {});
        former.addEvent(u"12:00:00"_s, u"heard"_s, false);
        child<QComboBox>(former, u"assetShip"_s).setCurrentIndex(1);
        auto& list = child<QTreeWidget>(former, u"aircraftList"_s);
        list.setCurrentItem(list.topLevelItem(1));
        AircraftPanel next;
        status.traffic.clear(); // it is not heard any more
        next.showStatus(status, {});
        next.takeOver(former);
        QCOMPARE(child<QPlainTextEdit>(next, u"linkEvents"_s).toPlainText(), u"12:00:00  heard"_s);
        QCOMPARE(child<QComboBox>(next, u"assetShip"_s).currentText(),
                 u"The asset follows POLAR"_s);
        QVERIFY(next.chosen() == former.chosen());
        QVERIFY(next.chosen()->system == 2);
        next.chooseNoShip();
        QCOMPARE(child<QComboBox>(next, u"assetShip"_s).currentIndex(), 0);
    }

    void rehearsalNeedsALinkOfItsOwn()
    {
        AircraftPanel panel;
        panel.showFlight({.mayRehearse = false});
        QVERIFY(!child<QPushButton>(panel, u"rehearseButton"_s).isEnabled());
        panel.showStatus(steerable(), {}); // a new status keeps that
        QVERIFY(!child<QPushButton>(panel, u"rehearseButton"_s).isEnabled());
    }
};

QTEST_MAIN(TestAircraftPanel)
#include "tst_aircraft_panel.moc"
