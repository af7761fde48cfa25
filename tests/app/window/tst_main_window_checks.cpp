#include "app/dialogs/generate_dialog.h"
#include "tests/support/window/ids.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/panels/inspector/check_panel.h"

#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <QUndoStack>

using namespace berg;
using namespace Qt::StringLiterals;
using test::Ids;
using test::WindowFixture;

namespace {

/** Not behind another tab; a list is covered by its viewport. */
bool isInFront(const QListWidget& list)
{
    return !list.viewport()->visibleRegion().isEmpty();
}

QListWidget& openList(WindowFixture& w)
{
    w.trigger(u"checksAction"_s);
    auto& list = test::child<QListWidget>(w.window(), u"checkList"_s);
    if (!w.until([&] { return isInFront(list); }))
        qFatal("the checks do not come to the front");
    return list;
}

void blow(WindowFixture& w, double wind_mps)
{
    w.document().edit(u"Wind"_s, [&](Scenario& s) { s.wind_mps = {wind_mps, 0}; });
}

GenerateDialog& openDialog(WindowFixture& w)
{
    w.trigger(u"generateAction"_s);
    return test::child<GenerateDialog>(w.window(), u"generateDialog"_s);
}

} // namespace

/** Findings about a scenario, and fields of icebergs, in the real window. */
class TestMainWindowChecks : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** Off Bonavista civil twilight ends at 20:16 UTC on that day. */
    void flightsByNightAreFound()
    {
        Scenario scenario = test::MapFixture::fourIcebergs();
        scenario.origin = {.latitude_deg = 48.65, .longitude_deg = -53.1};
        WindowFixture w(scenario);
        const auto& list = test::child<QListWidget>(w.window(), u"checkList"_s);
        const auto found = [&](const QString& words) {
            for (int i = 0; i < list.count(); ++i)
                if (list.item(i)->text().contains(words))
                    return true;
            return false;
        };
        const auto startAt = [&w](const char* utc) {
            w.document().edit(u"Start"_s, [utc](Scenario& s) { s.startUtc = utc; });
        };
        startAt("2026-11-28T15:00:00Z");
        QVERIFY(w.untilReady());
        QVERIFY(!found(u"in the dark"_s));
        startAt("2026-11-28T20:15:00Z");
        QTRY_VERIFY(found(u"civil twilight ends at 20:16 UTC"_s));
        QVERIFY(!found(u"takes off"_s));
        startAt("2026-11-29T02:00:00Z");
        QTRY_VERIFY(found(u"takes off in the dark, at 02:00 UTC"_s));
        startAt("");
        QTRY_VERIFY(!found(u"in the dark"_s));
    }

    void aFindingLeadsToItsIceberg()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto& button = test::child<QToolButton>(w.window(), u"checksButton"_s);
        QVERIFY(!button.isVisible());
        w.document().edit(u"Far"_s, [](Scenario& s) { s.icebergs[2].position_m = {90000, 0}; });
        QVERIFY(button.isVisible());
        QCOMPARE(button.text(), u"1 warning"_s);

        QListWidget& list = openList(w);
        QCOMPARE(list.count(), 1);
        QVERIFY(list.hasFocus());
        QTest::keyClick(&list, Qt::Key_Down);
        QTest::keyClick(&list, Qt::Key_Return);
        QCOMPARE(w.workspace.selection().ids(), Ids{"berg-3"});
        const QPoint off = w.pixelOf("berg-3") - w.map().rect().center();
        QVERIFY(off.manhattanLength() <= 3);
        const auto& words = test::child<QLabel>(w.window(), u"inspectorIssues"_s);
        QTRY_VERIFY(!words.visibleRegion().isEmpty());

        w.trigger(u"undoAction"_s);
        QVERIFY(!button.isVisible());
        QVERIFY(test::child<QWidget>(w.window(), u"checksEmpty"_s).isVisibleTo(&w.window()));
    }

    /** The list may be older than the scenario. */
    void aFindingOfWhatIsGoneSelectsNothing()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto* panel = w.window().findChild<CheckPanel*>();
        for (const char* field : {"icebergs[99].sigma0_m2", "uavs[99].position_m", "no_fly[99]"}) {
            w.workspace.selection().set({"berg-1"});
            emit panel->chosen(Issue{Severity::Error, field, {IssueId::NotFinite}});
            QVERIFY(w.workspace.selection().ids().empty());
        }
    }

    void whyNothingIsPlanned()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto& strip = test::child<QWidget>(w.window(), u"alarmStrip"_s);
        auto& state = test::child<QLabel>(w.window(), u"planState"_s);
        auto& checks = test::child<QPushButton>(strip, u"showChecksButton"_s);
        QVERIFY(!checks.isVisible());
        blow(w, 25);
        QVERIFY(w.until(RunPhase::Failed));
        QTRY_VERIFY(checks.isVisible());
        QVERIFY(state.text().startsWith(u"The wind must be slower than the UAV flies: "));
        QCOMPARE(test::child<QToolButton>(w.window(), u"checksButton"_s).text(), u"1 error"_s);
        QVERIFY(!strip.geometry().intersects(w.map().geometry()));

        auto& list = test::child<QListWidget>(w.window(), u"checkList"_s);
        QVERIFY(!isInFront(list));
        checks.click();
        QTRY_VERIFY(isInFront(list));
        test::child<QDockWidget>(w.window(), u"zetaDock"_s).raise();
        QTRY_VERIFY(!isInFront(list));
        emit state.linkActivated(u"checks"_s);
        QTRY_VERIFY(isInFront(list));

        blow(w, 0);
        QVERIFY(w.untilReady());
        QTRY_VERIFY(!checks.isVisible());
        QVERIFY(state.text().startsWith(u"Proven optimal"));
    }

    void generatesInOneStep()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const Scenario before = w.scenario();
        GenerateDialog& dialog = openDialog(w);
        test::child<QSpinBox>(dialog, u"generateNumber"_s).setValue(30);
        QVERIFY(w.scenario() == before); // only shown
        test::child<QPushButton>(dialog, u"generateOk"_s).click();
        QCOMPARE(w.scenario().icebergs.size(), std::size_t{34});
        QCOMPARE(w.document().undoStack()->undoText(), u"Generate 30 icebergs"_s);
        const QRect view = w.map().rect().adjusted(-1, -1, 1, 1); // pixels are rounded
        for (const Iceberg& iceberg : w.scenario().icebergs)
            QVERIFY(view.contains(w.pixelOf(iceberg.id)));
        w.trigger(u"undoAction"_s);
        QVERIFY(w.scenario() == before);
        QVERIFY(!w.document().undoStack()->canUndo());
    }

    void cancelLeavesNothing()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const Scenario before = w.scenario();
        const QImage picture = w.map().grab().toImage();
        GenerateDialog& dialog = openDialog(w);
        QTRY_VERIFY(w.map().grab().toImage() != picture); // the preview
        QTest::keyClick(&dialog, Qt::Key_Escape);
        QVERIFY(w.scenario() == before);
        QVERIFY(!w.document().undoStack()->canUndo());
        QTRY_COMPARE(w.map().grab().toImage(), picture);
    }

    void notInFlight()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QVERIFY(w.action(u"generateAction"_s).isEnabled());
        w.trigger(u"stepAction"_s);
        QVERIFY(w.until([&] { return w.workspace.inFlight(); }));
        QVERIFY(!w.action(u"generateAction"_s).isEnabled());
    }
};

QTEST_MAIN(TestMainWindowChecks)
#include "tst_main_window_checks.moc"
