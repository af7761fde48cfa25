#include "core/presets/presets.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/panels/map/find_box.h"

#include <QDockWidget>
#include <QLineEdit>
#include <QTableView>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

QDockWidget& dock(WindowFixture& w, const QString& name)
{
    return test::child<QDockWidget>(w.window(), name);
}

bool isSeen(const QWidget& widget)
{
    return widget.isVisible() && !widget.visibleRegion().isEmpty();
}

/** Chooses the command of this name in the box that finds everything. */
void choose(WindowFixture& w, const QString& name)
{
    emit test::child<FindBox>(w.window(), u"findBox"_s).commandChosen(name);
    QTest::qWait(0);
}

} // namespace

/** A key is of what has the focus. */
class TestMainWindowFocus : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void deleteIsOfWhatHasTheFocus_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("removes");
        QTest::newRow("chart") << u"zetaChart"_s << false;
        QTest::newRow("events") << u"eventTable"_s << false;
        QTest::newRow("slider") << u"tauSlider"_s << false;
        QTest::newRow("plan") << u"planTable"_s << true;
        QTest::newRow("map") << QString() << true;
    }

    /** In flight, too. */
    void deleteIsOfWhatHasTheFocus()
    {
        QFETCH(QString, name);
        QFETCH(bool, removes);
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.trigger(u"analyseLayoutAction"_s);
        dock(w, u"eventsDock"_s).raise();
        w.workspace.selection().set({"berg-2"});
        QWidget* focused = &w.map();
        if (name == u"zetaChart"_s)
            focused = &test::child<QWidget>(dock(w, u"zetaDock"_s), u"timeChart"_s);
        else if (!name.isEmpty())
            focused = &test::child<QWidget>(w.window(), name);
        QVERIFY(focused != nullptr);
        w.workspace.step();
        QVERIFY(w.until(RunPhase::Paused));
        focused->setFocusPolicy(Qt::StrongFocus);
        focused->setFocus();
        QTest::keyClick(focused, Qt::Key_Delete);
        QCOMPARE(w.interaction.removals, removes ? QStringList{u"berg-2"_s} : QStringList());
    }

    void removalInFlightIsAskedAbout_data()
    {
        QTest::addColumn<bool>("agreed");
        QTest::newRow("agreed") << true;
        QTest::newRow("cancelled") << false;
    }

    void removalInFlightIsAskedAbout()
    {
        QFETCH(bool, agreed);
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.interaction.removes = agreed;
        w.workspace.selection().set({"berg-2"});
        w.workspace.step();
        QVERIFY(w.until(RunPhase::Paused));
        w.map().setFocus();
        QTest::keyClick(&w.map(), Qt::Key_Delete);
        QCOMPARE(w.interaction.removals, QStringList{u"berg-2"_s});
        w.workspace.step();
        QVERIFY(w.until([&] { return w.record().now.time_s > 1.5; }));
        QCOMPARE(std::ranges::count(w.record().now.active, false), agreed ? 1 : 0);
    }

    void escapeLeavesTheToolFromEverywhere_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name :
             {"planTable", "eventTable", "tauSlider", "policyCombo", "rateCombo"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }

    void escapeLeavesTheToolFromEverywhere()
    {
        QFETCH(QString, name);
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.trigger(u"analyseLayoutAction"_s);
        auto& focused = test::child<QWidget>(w.window(), name);
        w.map().tools().setKind(MapToolKind::Iceberg);
        focused.setFocus();
        QTest::keyClick(&focused, Qt::Key_Escape);
        QCOMPARE(w.map().tools().kind(), MapToolKind::Select);
        QCOMPARE(QApplication::focusWidget(), &w.map());
    }

    /** A panel behind another tab is shown by its command, and closed in front. */
    void commandsShowWhatIsBehind()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QDockWidget& inspector = dock(w, u"inspectorDock"_s);
        dock(w, u"planDock"_s).raise();
        QTest::qWait(0);
        QVERIFY(inspector.isVisible() && !isSeen(inspector));
        choose(w, u"inspectorDockAction"_s);
        QTRY_VERIFY(isSeen(inspector));
        QVERIFY(inspector.isAncestorOf(QApplication::focusWidget())); // one goes on by typing
        QVERIFY(w.action(u"inspectorDockAction"_s).isChecked());
        choose(w, u"inspectorDockAction"_s);
        QVERIFY(!inspector.isVisible());
        choose(w, u"inspectorDockAction"_s);
        QTRY_VERIFY(isSeen(inspector));
    }

    void checksOpenAndClose()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QDockWidget& checks = dock(w, u"checksDock"_s);
        w.trigger(u"analyseLayoutAction"_s);
        dock(w, u"zetaDock"_s).raise();
        QTest::qWait(0);
        QTest::keyClick(&w.map(), Qt::Key_F7);
        QTRY_VERIFY(isSeen(checks));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F7);
        QVERIFY(!isSeen(checks));
        QCOMPARE(QApplication::focusWidget(), &w.map());
    }
};

QTEST_MAIN(TestMainWindowFocus)
#include "tst_main_window_focus.moc"
