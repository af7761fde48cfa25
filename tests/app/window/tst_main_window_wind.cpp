#include "app/dialogs/wind_dialog.h"
#include "core/io/files/run_json.h"
#include "core/tracking/position_error.h"
#include "tests/support/approx.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/document/wind.h"
#include "widgets/map/paint/wind_panel.h"
#include "widgets/map/picture/mission_picture.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/flight/alarm_strip.h"

#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStatusBar>
#include <QUndoStack>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

const Point kWater_m(2500, 2000);
const Point kShip_m(2500, 2900);
const Point kShip_mps(2, -1);
constexpr double kPixel_m = 30; // more than a pixel of these maps is wide

/** A ship among four icebergs, in a wind. */
Scenario windyScenario()
{
    Scenario scenario = test::MapFixture::fourIcebergs();
    scenario.wind_mps = windOf(8, 250);
    scenario.asset = Asset{.name = "Ship", .position_m = kShip_m, .velocity_mps = kShip_mps};
    return scenario;
}

QPoint windTipOf(WindowFixture& w)
{
    QTest::qWait(0);
    const auto& alarms = test::child<AlarmStrip>(w.window(), u"alarmStrip"_s);
    MapScene scene;
    scene.setRect(QRectF(w.map().rect()));
    scene.setCover(alarms.height() - alarms.lineHeight()); // panels are below its lines
    MapPicture picture = missionPicture(w.record(), QLocale());
    if (!w.workspace.inFlight())
        picture = withScenario(std::move(picture), w.scenario());
    scene.setPicture(std::move(picture));
    scene.setView(w.map().view());
    return windTip(scene.layout().wind, scene.picture().air).toPoint();
}

Point windShown_mps(WindowFixture& w)
{
    return w.record().shown().motions.front().wind_mps;
}

/** Flies for some seconds and pauses. */
bool flyTo(WindowFixture& w, double time_s)
{
    w.workspace.stepTicks(qRound(time_s / w.scenario().dt_s));
    return w.until(
        [&] { return w.record().now.phase == RunPhase::Paused && w.record().now.time_s > 0; });
}

/** Drags the wind of the flight to another one. */
bool changeWind(WindowFixture& w)
{
    const Point before_mps = windShown_mps(w);
    const QPoint from = windTipOf(w);
    w.drag(from, from + QPoint(-22, 9));
    return w.until([&] { return windShown_mps(w) != before_mps; });
}

bool repeats(const RunFile& run)
{
    return test::elsewhere([&] { return compareRun(run, runOf(replay(run))).empty(); });
}

int countEvents(WindowFixture& w, const std::function<bool(const MissionEvent&)>& isCounted)
{
    const std::vector<MissionEvent>& events = w.record().history.events;
    return static_cast<int>(std::ranges::count_if(events, isCounted));
}

int changesOf(WindowFixture& w, ChangedPart part)
{
    return countEvents(w, [part](const MissionEvent& event) {
        return event.kind == EventKind::Intervention && event.changed == part;
    });
}

} // namespace

/** Wind, asset and icebergs changed by hand in the window, before take-off and in flight. */
class TestMainWindowWind : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void beforeTakeOffTheWindIsAnEdit()
    {
        WindowFixture w(windyScenario());
        const QPoint from = windTipOf(w);
        w.drag(from, from + QPoint(-20, 10));
        QVERIFY(w.scenario().wind_mps != windyScenario().wind_mps);
        QCOMPARE(w.document().undoStack()->count(), 1);
        QVERIFY(w.untilReady());
        QVERIFY(windShown_mps(w) == w.scenario().wind_mps);
        w.trigger(u"undoAction"_s);
        QVERIFY(w.scenario() == windyScenario());
    }

    void windThatIsOnlyReadStays_data()
    {
        QTest::addColumn<Point>("wind_mps");
        for (const Point& wind_mps : {Point(3.3, 4.1), Point(5, 0), Point(2.345, -1.234)})
            QTest::addRow("%g, %g", wind_mps.x(), wind_mps.y()) << wind_mps;
    }

    void windThatIsOnlyReadStays()
    {
        QFETCH(Point, wind_mps);
        WindDialog dialog(wind_mps, 22);
        QVERIFY(dialog.wind_mps() == wind_mps);
        test::enter(test::child<NumberField>(dialog, u"windSpeed"_s), u"7"_s);
        COMPARE_NEAR(dialog.wind_mps().norm(), 7, 0.01); // windOf rounds
    }

    void sameWindIsNoIntervention()
    {
        WindowFixture w(windyScenario());
        w.interaction.wind_mps = w.workspace.wind_mps();
        w.trigger(u"windAction"_s);
        QCOMPARE(w.document().undoStack()->count(), 0);
        QVERIFY(flyTo(w, 20));
        w.trigger(u"windAction"_s);
        QVERIFY(flownRun(w)->interventions.empty());
    }

    void inFlightTheWindIsAnIntervention()
    {
        WindowFixture w(windyScenario());
        QVERIFY(flyTo(w, 20));
        const std::size_t plans = w.record().history.plans.size();
        QVERIFY(changeWind(w));
        QVERIFY(w.scenario() == windyScenario());
        QCOMPARE(w.document().undoStack()->count(), 0);
        QCOMPARE(changesOf(w, ChangedPart::Wind), 1);
        QVERIFY(w.record().history.plans.size() > plans); // planned anew
        const Point changed_mps = windShown_mps(w);
        QVERIFY(flyTo(w, 30));

        const std::shared_ptr<const RunFile> run = flownRun(w);
        QCOMPARE(run->interventions.size(), std::size_t{1});
        QVERIFY(run->interventions[0].wind_mps == changed_mps);
        COMPARE_NEAR(run->interventions[0].time_s, 20, 1e-9);
        QVERIFY(repeats(*run));
        w.trigger(u"resetAction"_s);
        QVERIFY(w.untilReady());
        QVERIFY(windShown_mps(w) == windyScenario().wind_mps);
    }

    void lookingBackShowsTheWindOfThen()
    {
        WindowFixture w(windyScenario());
        QVERIFY(flyTo(w, 20));
        QVERIFY(changeWind(w));
        QVERIFY(flyTo(w, 30));
        w.workspace.seek(10);
        QVERIFY(w.until([&] { return w.record().instant.has_value(); }));
        QVERIFY(windShown_mps(w) == windyScenario().wind_mps);
        const QPoint from = windTipOf(w);
        w.drag(from, from + QPoint(-22, 9)); // locked as everything else
        w.workspace.setWind({1, 1});
        QVERIFY(w.window().statusBar()->currentMessage().startsWith(
            u"You are viewing an earlier instant"_s));
        w.workspace.continueFromHere();
        QVERIFY(w.until([&] { return w.record().now.time_s < 11; }));
        QVERIFY(windShown_mps(w) == windyScenario().wind_mps);
        QCOMPARE(changesOf(w, ChangedPart::Wind), 0);
        QVERIFY(flownRun(w)->interventions.empty());
        QVERIFY(changeWind(w)); // and continue differently
    }

    void windIsAskedForByKey()
    {
        WindowFixture w(windyScenario());
        w.map().setFocus();
        QTest::keyClick(&w.map(), Qt::Key_W);
        QCOMPARE(w.interaction.askedWinds_mps.size(), std::size_t{1});
        QVERIFY(w.interaction.askedWinds_mps[0] == windyScenario().wind_mps);
        QVERIFY(w.scenario() == windyScenario()); // cancelled
        w.interaction.wind_mps = windOf(12, 90);
        QTest::keyClick(&w.map(), Qt::Key_W);
        QVERIFY(w.scenario().wind_mps == windOf(12, 90));
        QCOMPARE(w.document().undoStack()->undoText(), u"Change wind"_s);
        QVERIFY(w.untilReady());
        QVERIFY(flyTo(w, 5));
        w.interaction.wind_mps = windOf(5, 180);
        QTest::mouseClick(&w.map(), Qt::RightButton, {}, w.pixelOf(kWater_m));
        auto& menu = test::child<QMenu>(w.window(), u"mapMenu"_s);
        QVERIFY(menu.actions().contains(&w.action(u"windAction"_s)));
        menu.close();
        w.trigger(u"windAction"_s);
        QVERIFY(w.interaction.askedWinds_mps.back() == windOf(12, 90));
        QVERIFY(w.until([&] { return windShown_mps(w) == windOf(5, 180); }));
        QVERIFY(w.scenario().wind_mps == windOf(12, 90));
        const std::size_t asked = w.interaction.askedWinds_mps.size();
        w.workspace.seek(2); // nothing changes the past: no question, but why
        QVERIFY(w.until([&] { return w.record().instant.has_value(); }));
        w.trigger(u"windAction"_s);
        QCOMPARE(w.interaction.askedWinds_mps.size(), asked);
        QVERIFY(!w.window().statusBar()->currentMessage().isEmpty());
    }

    void dialogAsksAsForecastsAreWritten()
    {
        WindDialog dialog(windOf(8, 250), 22);
        auto& speed = test::child<NumberField>(dialog, u"windSpeed"_s);
        auto& from = test::child<NumberField>(dialog, u"windFrom"_s);
        const auto& note = test::child<QLabel>(dialog, u"windNote"_s);
        COMPARE_NEAR(speed.value(), 8, 0.005);
        COMPARE_NEAR(from.value(), 250, 0.05);
        QVERIFY(note.text().contains(u"22 m/\u2060s"_s));
        QVERIFY((dialog.wind_mps() - windOf(8, 250)).norm() < 0.01);
        QVERIFY(test::child<QPushButton>(dialog, u"setWindButton"_s).isDefault());
        test::enter(speed, u"15.5"_s);
        test::enter(from, u"90"_s);
        QVERIFY(dialog.wind_mps() == windOf(15.5, 90));
        QVERIFY(note.text().startsWith(u"The UAV will make little headway"_s));
        test::enter(speed, u"99"_s); // always slower than the UAV
        QVERIFY(dialog.wind_mps().norm() < 22);
        speed.selectAll();
        QTest::keyClicks(&speed, u"25"_s); // not 2, with the 5 refused
        QTest::keyClick(&speed, Qt::Key_Tab);
        QCOMPARE(speed.value(), speed.maximum());
        QVERIFY(dialog.wind_mps().norm() > 21);
    }

    /** It says where it was at time 0; on the map it is where it was dropped, and sails on. */
    void assetIsMovedInFlight()
    {
        WindowFixture w(windyScenario());
        QVERIFY(flyTo(w, 100));
        const Point there_m = kShip_m + 100 * kShip_mps;
        const Point to_m(1200, 2000);
        w.drag(w.pixelOf(there_m), w.pixelOf(to_m));
        QVERIFY(w.until([&] { return w.record().now.asset != windyScenario().asset; }));
        QVERIFY(w.scenario() == windyScenario());
        const Asset asset = *w.record().now.asset;
        QVERIFY(asset.velocity_mps == kShip_mps);
        QVERIFY((asset.position_m + 100 * kShip_mps - to_m).norm() < kPixel_m);
        QCOMPARE(changesOf(w, ChangedPart::Asset), 1);
        const MapPicture picture = missionPicture(w.record(), QLocale());
        QVERIFY((picture.asset->position_m - to_m).norm() < kPixel_m);
        QVERIFY(repeats(*flownRun(w)));
    }

    void icebergsAreClickedIn()
    {
        WindowFixture w(windyScenario());
        QVERIFY(flyTo(w, 15));
        QVERIFY(w.action(u"icebergTool"_s).isEnabled());
        w.trigger(u"icebergTool"_s);
        w.click(w.pixelOf(kWater_m));
        w.click(w.pixelOf(Point(2000, 1500))); // before the flight has reported the first
        QVERIFY(w.until([&] { return w.record().now.icebergs.size() == 6; }));
        QVERIFY(w.scenario() == windyScenario());
        const Iceberg& first = w.record().now.icebergs[4];
        const Iceberg& second = w.record().now.icebergs[5];
        QCOMPARE(first.id, std::string("berg-5"));
        QCOMPARE(second.id, std::string("berg-6"));
        QVERIFY((first.position_m - kWater_m).norm() < kPixel_m);
        QCOMPARE(w.record().now.world.tracks[4].sigma_m2,
                 berg::errorOf(SightingSource::Radar).sigma_m2());
        QCOMPARE(countEvents(w, [](const auto& e) { return e.kind == EventKind::Appeared; }), 2);
        QVERIFY(w.record().now.plan->uavs[0].order.size() >= 5);
        w.workspace.selection().set({first.id}); // and reported seen as the others are
        QVERIFY(w.action(u"seenAction"_s).isEnabled());
        QVERIFY(flyTo(w, 10));
        w.trigger(u"seenAction"_s);
        QVERIFY(w.until([&] {
            return countEvents(w, [](const auto& e) {
                       return e.kind == EventKind::Sighted && e.reported;
                   }) == 1;
        }));
        QVERIFY(repeats(*flownRun(w)));
    }

    /** To the only UAV there is, without a selection. */
    void ordersToAUav()
    {
        WindowFixture w(windyScenario());
        QVERIFY(!w.action(u"holdAction"_s).isEnabled());
        QVERIFY(flyTo(w, 10));
        w.trigger(u"holdAction"_s);
        const auto mode = [&] { return w.record().now.world.uavs.front().mode; };
        QVERIFY(w.until([&] { return mode() == FlightMode::Hold; }));
        QVERIFY(flyTo(w, 20));
        w.trigger(u"returnAction"_s);
        QVERIFY(w.until([&] { return mode() == FlightMode::Home; }));
        w.trigger(u"resumeAction"_s);
        QVERIFY(w.until([&] { return w.record().now.world.uavs.front().isPlanned(); }));
        QVERIFY(repeats(*flownRun(w)));
    }

    void icebergsOfTheContextMenu()
    {
        WindowFixture w(windyScenario());
        QVERIFY(flyTo(w, 15));
        w.map().edits().addIcebergAt(kWater_m);
        QVERIFY(w.until([&] { return w.record().now.icebergs.size() == 5; }));
        w.workspace.seek(5);
        w.map().edits().addIcebergAt(kWater_m);
        QVERIFY(w.window().statusBar()->currentMessage().startsWith(
            u"You are viewing an earlier instant"_s));
        w.workspace.seekLatest();
        QCOMPARE(w.record().now.icebergs.size(), std::size_t{5});
    }

    void afterTheEndNothingChanges()
    {
        Scenario brief = windyScenario();
        brief.duration_s = 30;
        WindowFixture w(brief);
        w.workspace.fly(kFastestRate);
        QVERIFY(w.until(RunPhase::Finished));
        const QPoint from = windTipOf(w);
        w.drag(from, from + QPoint(-22, 9));
        w.map().edits().addIcebergAt(kWater_m);
        QVERIFY(w.until([&] {
            return w.window().statusBar()->currentMessage().startsWith(u"The run has ended"_s);
        }));
        QVERIFY(windShown_mps(w) == brief.wind_mps);
    }

    /** A run in another wind is of another world; one flown in the same changes can be compared. */
    void onlyTheSameWorldIsCompared()
    {
        Scenario brief = windyScenario();
        brief.duration_s = 60;
        WindowFixture w(brief);
        w.workspace.fly(kFastestRate);
        QVERIFY(w.until(RunPhase::Finished));
        w.trigger(u"resetAction"_s);
        QVERIFY(w.untilReady());
        QVERIFY(flyTo(w, 20));
        QVERIFY(changeWind(w));
        w.workspace.fly(kFastestRate);
        QVERIFY(w.until(RunPhase::Finished));
        RunList& runs = w.workspace.runs();
        QCOMPARE(runs.runs().size(), std::size_t{2});
        QVERIFY(!runs.comparison());
        PlannerSettings tour;
        tour.policy = PolicyKind::Tour;
        runs.addVariant(*runs.reference(), tour);
        QVERIFY(w.until([&] { return runs.comparison().has_value(); }));
        QVERIFY(runs.other()->worldChanges == runs.reference()->worldChanges);
        QCOMPARE(runs.other()->worldChanges.size(), std::size_t{1});
        QVERIFY(!runs.other()->wasChanged);
    }
};

QTEST_MAIN(TestMainWindowWind)
#include "tst_main_window_wind.moc"
