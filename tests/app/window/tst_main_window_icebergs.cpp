#include "core/presets/presets.h"
#include "tests/support/window/ids.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/panels/icebergs/iceberg_table.h"
#include "widgets/panels/icebergs/iceberg_table_columns.h"
#include "widgets/panels/plan/plan_model.h"

#include <QDockWidget>
#include <QTableView>
#include <QUndoStack>

#include <set>

using namespace berg;
using namespace Qt::StringLiterals;
using test::Ids;
using test::WindowFixture;

namespace {

/** The table in front of the docks it shares a place with. */
QTableView& raisedTable(WindowFixture& w)
{
    test::child<QDockWidget>(w.window(), u"icebergsDock"_s).raise();
    auto& table = test::child<QTableView>(w.window(), u"icebergTable"_s);
    if (!w.until([&] { return !table.visibleRegion().isEmpty(); }))
        qFatal("the table does not come to the front");
    return table;
}

QModelIndex cell(const QTableView& table, int row, IcebergColumn column)
{
    return table.model()->index(row, static_cast<int>(column));
}

void click(QTableView& table, int row, IcebergColumn column, Qt::KeyboardModifiers keys = {})
{
    QTest::mouseClick(table.viewport(), Qt::LeftButton, keys,
                      table.visualRect(cell(table, row, column)).center());
}

} // namespace

/** The table of icebergs in the real window. */
class TestMainWindowIcebergs : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void oneSelectionForMapAndTable()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QTableView& table = raisedTable(w);
        w.click(w.pixelOf("berg-3"));
        QCOMPARE(table.selectionModel()->selectedRows().size(), 1);
        QCOMPARE(table.selectionModel()->selectedRows().front().row(), 2);
        click(table, 1, IcebergColumn::Name);
        QCOMPARE(w.workspace.selection().ids(), Ids{"berg-2"});
    }

    /** Also to what was selected while another tab was in front, or beside others. */
    void tableScrollsToWhatIsSelected()
    {
        WindowFixture w(randomScenario(3, {.icebergs = 60}));
        QTableView& table = test::child<QTableView>(w.window(), u"icebergTable"_s);
        const auto isSeen = [&](int row) {
            return table.viewport()->rect().intersects(
                table.visualRect(cell(table, row, IcebergColumn::Name)));
        };
        w.workspace.selection().set({"berg-50"});
        raisedTable(w);
        QTRY_VERIFY(isSeen(49));
        w.workspace.selection().set({"berg-50", "berg-2"});
        QTRY_VERIFY(isSeen(1));
    }

    /** By mouse and keys, from whichever of the three it is made. */
    void planListShowsTheSelection()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QTableView& table = raisedTable(w);
        auto& plan = test::child<QTableView>(w.window(), u"planTable"_s);
        QCOMPARE(plan.model()->rowCount(), 4);
        const auto inPlan = [&plan] {
            std::set<QString> names;
            for (const QModelIndex& row : plan.selectionModel()->selectedRows(PlanModel::Name))
                names.insert(row.data().toString());
            return names;
        };
        using Names = std::set<QString>;
        QCOMPARE(inPlan(), Names{});
        w.click(w.pixelOf("berg-3"));
        QCOMPARE(inPlan(), Names{u"berg-3"_s});
        click(table, 0, IcebergColumn::Name);
        click(table, 1, IcebergColumn::Name, Qt::ControlModifier);
        QCOMPARE(inPlan(), (Names{u"berg-1"_s, u"berg-2"_s}));
        plan.setFocus();
        plan.setCurrentIndex(plan.model()->index(0, 0));
        for (int row = 1; row < 4; ++row) {
            QTest::keyClick(&plan, Qt::Key_Down);
            const QString name = plan.model()->index(row, PlanModel::Name).data().toString();
            QCOMPARE(inPlan(), Names{name});
            QCOMPARE(w.workspace.selection().ids(), Ids{name.toStdString()});
            QCOMPARE(table.selectionModel()->selectedRows().size(), 1);
        }
        w.workspace.selection().clear();
        QCOMPARE(inPlan(), Names{});
        QVERIFY(table.selectionModel()->selectedRows().isEmpty());
    }

    void deleteRemovesTheRowsSelected()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QTableView& table = raisedTable(w);
        click(table, 1, IcebergColumn::East);
        click(table, 2, IcebergColumn::East, Qt::ControlModifier);
        QTest::keyClick(&table, Qt::Key_Delete);
        QCOMPARE(w.scenario().icebergs.size(), std::size_t{2});
        QCOMPARE(w.scenario().icebergs[1].id, "berg-4");
        QCOMPARE(table.model()->rowCount(), 2);
        w.trigger(u"undoAction"_s);
        QCOMPARE(w.scenario().icebergs.size(), std::size_t{4});
        QCOMPARE(table.model()->rowCount(), 4);
    }

    /** Icebergs cut on the map or in the table can be pasted into both. */
    void pastesWhatTheMapHasCut()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QTableView& table = raisedTable(w);
        click(table, 2, IcebergColumn::East);
        QTest::keyClick(&table, Qt::Key_X, Qt::ControlModifier);
        QCOMPARE(w.scenario().icebergs.size(), std::size_t{3});
        QTest::keyClick(&table, Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(w.scenario().icebergs.size(), std::size_t{4});
        QCOMPARE(w.scenario().icebergs[3].velocity_mps, Point(0.2, 0.1));
        QVERIFY(test::child<QWidget>(w.window(), u"icebergFault"_s).isHidden());
    }

    /** Digits, point and Ctrl+A are the table's; letters take tools, Space flies. */
    void keysOfWindowAndTable()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QTableView& table = raisedTable(w);
        click(table, 0, IcebergColumn::East);
        QTest::keyClick(&table, Qt::Key_I);
        QCOMPARE(w.map().tools().kind(), MapToolKind::Iceberg);
        QTest::keyClick(&table, Qt::Key_S);
        QTest::keyClick(&table, Qt::Key_Period); // else a step of the flight
        auto& editor = test::child<QWidget>(table, u"icebergCell"_s);
        QTest::keyClick(&editor, Qt::Key_5);
        QTest::keyClick(&editor, Qt::Key_Return);
        QVERIFY(w.until([&] { return w.scenario().icebergs[0].position_m.x() == 0.5; }));
        QVERIFY(!w.workspace.inFlight());
        table.setFocus();
        QTest::keyClick(&table, Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(w.workspace.selection().ids().size(), std::size_t{4});
        QVERIFY(w.untilReady());
        QTest::keyClick(&table, Qt::Key_Space);
        QVERIFY(w.until([&] { return w.workspace.inFlight(); }));
    }

    void flightIsShownAndLocked()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QTableView& table = raisedTable(w);
        w.workspace.step();
        QVERIFY(w.until([&] { return w.workspace.inFlight(); }));
        QVERIFY(!cell(table, 0, IcebergColumn::East).flags().testFlag(Qt::ItemIsEditable));
        w.workspace.stepTicks(25);
        QVERIFY(w.until([&] { return w.record().shown().time_s > 3.4; }));
        const auto shows = [&] {
            for (int i = 0; i < 4; ++i)
                if (cell(table, i, IcebergColumn::Sigma).data(Qt::EditRole).toDouble() !=
                    w.record().shown().world.tracks[static_cast<std::size_t>(i)].sigma_m2)
                    return false;
            return true;
        };
        QVERIFY(w.until(shows));
        w.workspace.seek(1);
        QVERIFY(w.until([&] { return w.record().instant && shows(); }));
        w.trigger(u"resetAction"_s);
        QVERIFY(w.untilReady());
        QVERIFY(cell(table, 0, IcebergColumn::East).flags().testFlag(Qt::ItemIsEditable));
    }

    void choosingCentresTheMap()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QTableView& table = raisedTable(w);
        w.workspace.step();
        QVERIFY(w.until([&] { return w.workspace.inFlight(); }));
        w.map().camera().setFollowUav(true);
        click(table, 3, IcebergColumn::Name);
        QTest::mouseDClick(table.viewport(), Qt::LeftButton, {},
                           table.visualRect(cell(table, 3, IcebergColumn::Name)).center());
        QCOMPARE(w.workspace.selection().ids(), Ids{"berg-4"});
        QVERIFY(!w.map().camera().followsUav());
        const QPointF off = w.map().toScreen(w.record().estimate_m(3)) -
                            QPointF(w.map().width(), w.map().height()) / 2;
        QVERIFY(off.manhattanLength() < 1);
    }

    void hiddenColumnsAreRemembered()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto& panel = *w.window().findChild<IcebergTable*>();
        emit panel.hiddenColumnsChanged({u"growth"_s});
        w.trigger(u"view/language-nb"_s);
        QTest::qWait(0); // another window
        QCOMPARE(w.window().findChild<IcebergTable*>()->hiddenColumns(), QStringList{u"growth"_s});
        w.trigger(u"view/language-en"_s);
        QTest::qWait(0);
    }

    void typingCountsWhenSaving()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QTableView& table = raisedTable(w);
        w.interaction.path = w.file(u"typed.berg"_s);
        click(table, 0, IcebergColumn::Sigma0);
        QTest::keyClick(&table, Qt::Key_7);
        w.trigger(u"saveAction"_s);
        QCOMPARE(w.scenario().icebergs[0].sigma0_m2, 7.0);
        QVERIFY(w.document().isClean());
    }
};

QTEST_MAIN(TestMainWindowIcebergs)
#include "tst_main_window_icebergs.moc"
