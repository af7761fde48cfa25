#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/theme/unit_settings.h"

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>

#include <cmath>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

/** One iceberg drifts into the inner ring of a platform, and one stands still. */
Scenario threatened()
{
    Scenario scenario = test::emptySea(40);
    scenario.uavs.front().position_m = {-6000, -4000};
    test::addIceberg(scenario, 2000, 0).velocity_mps = {-0.5, 0};
    test::addIceberg(scenario, -9000, 6000);
    scenario.asset = Asset{.name = "Rig", .range_m = 4000, .alarm_m = 1000};
    return scenario;
}

bool flyTo(WindowFixture& w, double time_s)
{
    w.workspace.stepTicks(static_cast<int>(std::lround(time_s / w.scenario().dt_s)));
    return w.until([&] { return w.record().now.time_s >= time_s - 1e-6; });
}

QWidget& strip(WindowFixture& w)
{
    return test::child<QWidget>(w.window(), u"alarmStrip"_s);
}

QAbstractButton& line(WindowFixture& w, int number)
{
    return test::child<QAbstractButton>(w.window(), u"flightNotice%1"_s.arg(number));
}

} // namespace

/** Alarms are shown above the map, not on it. */
class TestMainWindowAlarms : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void alarmLeavesTheMapFree()
    {
        WindowFixture w(threatened());
        const QRect map = w.map().geometry();
        QVERIFY(flyTo(w, 5));
        QTRY_VERIFY(line(w, 1).isVisible());
        QVERIFY(line(w, 1).text().startsWith(u"berg-1 enters the inner ring"_s));
        QTRY_COMPARE(w.map().geometry(), map);
        QVERIFY(strip(w).geometry().bottom() < map.top());
        for (const Point& place_m : {w.scenario().asset->position_m, Point(2000, 0)}) {
            QVERIFY(w.map().rect().contains(w.pixelOf(place_m)));
            QVERIFY(w.map().childAt(w.pixelOf(place_m)) == nullptr);
        }
    }

    /** An alarm is announced, and stays in the list of messages after it has ended. */
    void alarmsAreKept()
    {
        WindowFixture w(threatened());
        const auto& list = test::child<QListWidget>(w.window(), u"messageList"_s);
        const auto& announcer = test::child<QWidget>(w.window(), u"announcer"_s);
        QVERIFY(flyTo(w, 5));
        QTRY_COMPARE(list.count(), 1);
        QVERIFY(list.item(0)->text().contains(u"berg-1 enters the inner ring"_s));
        QTRY_VERIFY(announcer.accessibleName().contains(u"berg-1 enters the inner ring"_s));
        QVERIFY(flyTo(w, 10)); // the alarm continues and is reported once
        QCOMPARE(list.count(), 1);
    }

    /** Once as it is raised, again until it is acknowledged; never where sounds are off. */
    void alarmsAreHeard()
    {
        WindowFixture w(threatened());
        QVERIFY(w.action(u"alarmSoundAction"_s).isChecked());
        auto& again = test::child<QTimer>(w.window(), u"alarmSoundTimer"_s);
        QVERIFY(!again.isActive());
        QVERIFY(flyTo(w, 5));
        QTRY_COMPARE(w.interaction.sounds, 1);
        QVERIFY(flyTo(w, 10)); // the same alarm
        QCOMPARE(w.interaction.sounds, 1);
        QVERIFY(again.isActive());
        again.setInterval(1);
        QTRY_VERIFY(w.interaction.sounds >= 3);
        QTRY_VERIFY(line(w, 1).isVisible());
        QTest::mouseClick(&test::child<QPushButton>(w.window(), u"acknowledge1"_s), Qt::LeftButton);
        QVERIFY(!again.isActive());
    }

    void alarmsAreSilenced()
    {
        WindowFixture w(threatened());
        w.trigger(u"alarmSoundAction"_s);
        QVERIFY(flyTo(w, 5));
        QTRY_VERIFY(line(w, 1).isVisible());
        QCOMPARE(w.interaction.sounds, 0);
        const auto& again = test::child<QTimer>(w.window(), u"alarmSoundTimer"_s);
        QVERIFY(!again.isActive());
        w.trigger(u"alarmSoundAction"_s); // what is open is heard from now on
        QVERIFY(again.isActive());
        w.trigger(u"alarmSoundAction"_s);
        const MainWindow next(w.workspace, w.interaction, w.settings);
        QVERIFY(!next.findChild<QAction*>(u"alarmSoundAction"_s)->isChecked());
    }

    /** Looking back or changing the language does not report old alarms again. */
    void nothingIsReportedTwice()
    {
        WindowFixture w(threatened());
        const auto messages = [&w] {
            return test::child<QListWidget>(w.window(), u"messageList"_s).count();
        };
        QVERIFY(flyTo(w, 20));
        QTRY_COMPARE(messages(), 1);
        QTest::mouseClick(&test::child<QPushButton>(w.window(), u"acknowledge1"_s), Qt::LeftButton);
        w.workspace.seek(0);
        QVERIFY(w.until([&] { return w.record().instant.has_value(); }));
        QTRY_VERIFY(
            test::child<QLabel>(w.window(), u"flightState"_s).text().startsWith(u"Looking"_s));
        w.workspace.seekLatest();
        QVERIFY(w.until([&] { return !w.record().instant.has_value(); }));
        QTRY_VERIFY(!line(w, 1).isVisible()); // it is acknowledged still
        w.trigger(u"units/speed-knots"_s);
        QTRY_VERIFY(!line(w, 1).isVisible());
        QCOMPARE(messages(), 1);
        w.trigger(u"units/speed-mps"_s);
        QTRY_COMPARE(messages(), 1);
    }

    /** Made anew for other units or another language it has no focus of its own. */
    void spaceFliesInAWindowMadeAnew()
    {
        WindowFixture w(threatened());
        QVERIFY(flyTo(w, 5));
        QTRY_VERIFY(line(w, 1).isVisible());
        const MainWindow* before = &w.window();
        w.trigger(u"units/speed-knots"_s);
        QTRY_VERIFY(&w.window() != before);
        w.window().activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&w.window()));
        QVERIFY(line(w, 1).isVisible());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
        QVERIFY(w.until(RunPhase::Flying));
        QVERIFY(!w.workspace.selection().contains("berg-1"));
        w.trigger(u"units/speed-mps"_s);
        QTRY_COMPARE(shownUnits(), Units());
    }

    void clickBringsItOntoTheMap()
    {
        WindowFixture w(threatened());
        QVERIFY(flyTo(w, 5));
        const double fitted_pxpm = w.map().view().scale_pxpm();
        w.map().camera().panBy({5000, 5000});
        QTRY_VERIFY(line(w, 1).isVisible());
        QTest::mouseClick(&line(w, 1), Qt::LeftButton);
        QVERIFY(w.workspace.selection().contains("berg-1"));
        QVERIFY(w.map().rect().contains(w.pixelOf(w.scenario().asset->position_m)));
        QVERIFY(w.map().rect().contains(w.pixelOf(Point(2000, 0))));
        QVERIFY(w.map().view().scale_pxpm() > 1.5 * fitted_pxpm); // near
    }

    void quietFlightSaysSo()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const auto& state = test::child<QLabel>(w.window(), u"flightState"_s);
        QCOMPARE(state.text(), u"Not in flight"_s);
        QVERIFY(flyTo(w, 5));
        QTRY_COMPARE(state.text(), u"No alarms"_s);
    }

    void acknowledgedAlarmIsGoneUntilItHappensAgain()
    {
        WindowFixture w(threatened());
        const int map_px = w.map().height();
        QVERIFY(flyTo(w, 5));
        QTRY_VERIFY(line(w, 1).isVisible());
        QTest::mouseClick(&test::child<QPushButton>(w.window(), u"acknowledge1"_s), Qt::LeftButton);
        QVERIFY(!line(w, 1).isVisible());
        const auto& state = test::child<QLabel>(w.window(), u"flightState"_s);
        QVERIFY(state.text().startsWith(u"Acknowledged: berg-1 enters the inner ring"_s));
        QVERIFY(flyTo(w, 20));
        QVERIFY(!line(w, 1).isVisible());
        QTRY_COMPARE(w.map().height(), map_px);
        w.workspace.reset();
        QVERIFY(w.untilReady());
        QTRY_COMPARE(state.text(), u"Not in flight"_s);
        QVERIFY(flyTo(w, 5));
        QTRY_VERIFY(line(w, 1).isVisible());
    }

    /** In the strip, on the map and beside the time line. */
    void oneTimeIsShownWhileLookingBack()
    {
        WindowFixture w(threatened());
        QVERIFY(flyTo(w, 30));
        w.workspace.seek(12.96);
        QVERIFY(w.until([&] { return w.record().instant.has_value(); }));
        const QString time = clockText(w.record().shown().time_s);
        QTRY_COMPARE(test::child<QLabel>(w.window(), u"flightState"_s).text(),
                     u"Looking back at "_s + time);
        QCOMPARE(test::child<QLineEdit>(w.window(), u"timeField"_s).text(), time);
    }

    /** In place of words over the icebergs; the flight that has ended is locked, too. */
    void padlockShowsTheLock()
    {
        WindowFixture w(threatened());
        auto& lock = test::child<QToolButton>(w.window(), u"lockButton"_s);
        auto& timeLine = test::child<QWidget>(w.window(), u"timeLine"_s);
        const QRect place = timeLine.geometry();
        QVERIFY(!lock.isVisible());
        QVERIFY(flyTo(w, 5));
        QTRY_VERIFY(lock.isVisible());
        QCOMPARE(timeLine.geometry(), place);
        QVERIFY(flyTo(w, 40));
        QVERIFY(w.until(RunPhase::Finished));
        QTRY_VERIFY(lock.toolTip().startsWith(u"The run is complete"_s));
        w.workspace.reset();
        QTRY_VERIFY(!lock.isVisible());
    }
};

QTEST_MAIN(TestMainWindowAlarms)
#include "tst_main_window_alarms.moc"
