#include "core/link/tracker_list.h"
#include "tests/support/window/panel_test.h"
#include "widgets/panels/aircraft/aircraft_panel.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTreeWidget>

using namespace berg;
using namespace Qt::StringLiterals;
using test::child;

namespace {

LinkVehicle heard(LinkAddress address)
{
    LinkVehicle vehicle{.address = address};
    vehicle.state.position =
        AircraftPosition{.place = {.latitude_deg = 47, .longitude_deg = -48}, .received_s = 10};
    return vehicle;
}

LinkStatus statusOf(const std::vector<LinkAddress>& addresses)
{
    LinkStatus status{.isListening = true,
                      .condition = {.state = LinkCondition::State::Open},
                      .isSending = true,
                      .now_s = 10.5};
    for (const LinkAddress& address : addresses)
        status.vehicles.push_back(heard(address));
    return status;
}

} // namespace

class TestAircraftChoice : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** An upload must go to the aircraft that was chosen, also when another one comes before it. */
    void choiceStaysWithTheAircraft()
    {
        AircraftPanel panel;
        const LinkAddress first{.system = 1, .component = 1};
        const LinkAddress second{.system = 2, .component = 1};
        const LinkAddress third{.system = 3, .component = 1};
        panel.showStatus(statusOf({second}), {});
        QVERIFY(panel.chosen() == second);
        panel.showStatus(statusOf({first, second, third}), {});
        QVERIFY(panel.chosen() == second);
        auto& list = child<QTreeWidget>(panel, u"aircraftList"_s);
        list.setCurrentItem(list.topLevelItem(2));
        QVERIFY(panel.chosen() == third);
        panel.showStatus(statusOf({first, second, third}), {});
        QVERIFY(panel.chosen() == third);
        panel.showStatus({}, {});
        QVERIFY(!panel.chosen());
    }

    /** A tracker cannot be sent anything. */
    void trackersAreOnlyHeard()
    {
        AircraftPanel panel;
        const LinkAddress tracker{.system = kTrackerSystem, .component = 1};
        panel.setUavs({"uav-1"});
        panel.showStatus(statusOf({tracker}), {{tracker, {.uav = "uav-1"}}});
        QVERIFY(!child<QPushButton>(panel, u"uploadButton"_s).isEnabled());
        QVERIFY(!child<QComboBox>(panel, u"steeringChoice"_s).isEnabled());
        QVERIFY(child<QComboBox>(panel, u"aircraftUav"_s).isEnabled());
        QVERIFY(child<QPushButton>(panel, u"flyLiveButton"_s).isEnabled());
        QSignalSpy ships(&panel, &AircraftPanel::homeShipEdited);
        auto& home = child<QComboBox>(panel, u"homeShip"_s);
        home.setCurrentIndex(1);
        emit home.activated(1);
        QCOMPARE(ships.size(), 1);
        QVERIFY(ships.front().front().toULongLong() != 0);
    }

    void logIsShown()
    {
        AircraftPanel panel;
        LinkStatus status = statusOf({});
        status.log = {.path = "/logs/a.tlog", .bytes = 1500};
        panel.showStatus(status, {});
        const auto& text = child<QLabel>(panel, u"logState"_s);
        QVERIFY(text.text().contains(u"/logs/a.tlog"_s));
        status.log.fault = "No space left on device";
        panel.showStatus(status, {});
        QVERIFY(text.text().contains(u"No space left on device"_s));
        status.log = {};
        panel.showStatus(status, {});
        QVERIFY(text.isHidden());
        status.replay = ReplayReport{.path = "/logs/b.tlog", .played_s = 125, .part = 0.5};
        panel.showStatus(status, {});
        QVERIFY(text.text().contains(u"b.tlog: 02:05"_s));
        QVERIFY(!child<QPushButton>(panel, u"rehearseButton"_s).isEnabled());
    }
};

QTEST_MAIN(TestAircraftChoice)
#include "tst_aircraft_choice.moc"
