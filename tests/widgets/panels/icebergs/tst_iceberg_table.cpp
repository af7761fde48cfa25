#include "core/earth/geodesy.h"
#include "core/presets/presets.h"
#include "tests/support/flight/mission_builder.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/ids.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/icebergs/iceberg_table.h"
#include "widgets/panels/icebergs/iceberg_table_columns.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QUndoStack>

#include <algorithm>

using namespace berg;
using namespace Qt::StringLiterals;
using test::Ids;

namespace {

Scenario manyIcebergs(int count)
{
    Scenario scenario = randomScenario(3, {.icebergs = count});
    scenario.planner.policy = PolicyKind::Nearest; // needs no solver
    return scenario;
}

FlightRecord flying(const Mission& mission)
{
    FlightRecord record = recordOf(mission);
    record.now.phase = RunPhase::Flying;
    return record;
}

struct IcebergTableFixture
{
    ScenarioDocument document;
    Selection selection;
    IcebergTable panel{document, selection};
    QTableView& table = test::child<QTableView>(panel, u"icebergTable"_s);
    QAbstractItemModel& model = *table.model();
    QSignalSpy hovered{&panel, &IcebergTable::hovered};
    QSignalSpy chosen{&panel, &IcebergTable::chosen};

    explicit IcebergTableFixture(const Scenario& scenario = test::fourIcebergs())
    {
        document.reset(scenario);
        panel.resize(900, 260);
        panel.show();
        panel.activateWindow();
        if (!QTest::qWaitForWindowActive(&panel))
            qFatal("the panel does not come up");
    }
    [[nodiscard]] QModelIndex at(int row, IcebergColumn column) const
    {
        return model.index(row, static_cast<int>(column));
    }
    [[nodiscard]] QString name(int row) const
    {
        return at(row, IcebergColumn::Name).data().toString();
    }
    [[nodiscard]] QPoint pixelOf(int row, IcebergColumn column = IcebergColumn::Name) const
    {
        return table.visualRect(at(row, column)).center();
    }
    void click(int row, IcebergColumn column, Qt::KeyboardModifiers keys = {})
    {
        QTest::mouseClick(table.viewport(), Qt::LeftButton, keys, pixelOf(row, column));
    }
    [[nodiscard]] std::vector<int> selectedRows() const
    {
        std::vector<int> rows;
        for (const QModelIndex& index : table.selectionModel()->selectedRows())
            rows.push_back(index.row());
        std::sort(rows.begin(), rows.end());
        return rows;
    }
    [[nodiscard]] QWidget& editor() const { return test::child<QWidget>(table, u"icebergCell"_s); }
    [[nodiscard]] QString fault() const
    {
        const auto& label = test::child<QLabel>(panel, u"icebergFault"_s);
        return label.isVisible() ? label.text() : QString();
    }
    [[nodiscard]] const std::vector<Iceberg>& icebergs() const
    {
        return document.scenario().icebergs;
    }
    [[nodiscard]] int steps() const { return document.undoStack()->count(); }
};

} // namespace

class TestIcebergTable : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        qRegisterMetaType<std::string>("std::string");
        QLocale::setDefault(QLocale::c());
    }
    void init() { test::failOnWarnings(); }

    void clickSelectsEverywhere()
    {
        IcebergTableFixture f;
        f.click(1, IcebergColumn::East);
        QCOMPARE(f.selection.ids(), Ids{"berg-2"});
        f.click(3, IcebergColumn::East, Qt::ControlModifier);
        f.click(0, IcebergColumn::East, Qt::ControlModifier);
        QCOMPARE(f.selection.ids().front(), "berg-2"); // in the order selected
        QCOMPARE(f.selection.ids().size(), std::size_t{3});
        f.click(1, IcebergColumn::East, Qt::ControlModifier);
        QVERIFY(!f.selection.contains("berg-2"));
    }

    void selectionElsewhereSelectsRows()
    {
        IcebergTableFixture f;
        f.selection.set({"berg-4", "berg-1"});
        QCOMPARE(f.selectedRows(), (std::vector<int>{0, 3}));
        QCOMPARE(f.selection.ids(), (Ids{"berg-4", "berg-1"})); // not turned round
        f.selection.set({"uav-1"});
        QVERIFY(f.selectedRows().empty());
        QCOMPARE(f.selection.ids(), Ids{"uav-1"});
    }

    void rowSelectedElsewhereIsScrolledTo()
    {
        IcebergTableFixture f(manyIcebergs(200));
        QVERIFY(!f.table.viewport()->rect().contains(f.pixelOf(150)));
        f.selection.set({f.icebergs()[150].id});
        QVERIFY(f.table.viewport()->rect().contains(f.pixelOf(150)));
    }

    void pointingAtARowIsReported()
    {
        IcebergTableFixture f;
        QTest::mouseMove(f.table.viewport(), f.pixelOf(2));
        QCOMPARE(f.hovered.size(), 1);
        QCOMPARE(f.hovered.back().front().value<std::string>(), "berg-3");
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&f.table, &leave);
        QCOMPARE(f.hovered.back().front().value<std::string>(), "");
    }

    void typingEditsACell()
    {
        IcebergTableFixture f;
        f.click(1, IcebergColumn::Sigma0);
        QTest::keyClicks(&f.table, u"7"_s);
        QTest::keyClicks(&f.editor(), u".25"_s);
        QTest::keyClick(&f.editor(), Qt::Key_Return);
        QTRY_COMPARE(f.icebergs()[1].sigma0_m2, 7.25);
        QCOMPARE(f.steps(), 1);
        QCOMPARE(f.document.undoStack()->undoText(), u"Change uncertainty σ₀"_s);
    }

    void returnEditsTheName()
    {
        IcebergTableFixture f;
        f.click(0, IcebergColumn::Name);
        QTest::keyClick(&f.table, Qt::Key_Return);
        QTest::keyClicks(&f.editor(), u"Storis"_s);
        QTest::keyClick(&f.editor(), Qt::Key_Return);
        QTRY_COMPARE(f.icebergs()[0].name, "Storis");
        QCOMPARE(f.name(0), u"Storis"_s);
    }

    /** The field shows fewer digits than the number has. */
    void openingACellChangesNothing()
    {
        IcebergTableFixture f(
            test::changed([](Scenario& s) { s.icebergs[0].position_m.x() = 1.0 / 3; }));
        f.click(0, IcebergColumn::East);
        QTest::keyClick(&f.table, Qt::Key_Return);
        QTest::keyClick(&f.editor(), Qt::Key_Return);
        QTRY_VERIFY(f.table.findChild<QWidget*>(u"icebergCell"_s) == nullptr);
        QCOMPARE(f.steps(), 0);
        QCOMPARE(f.icebergs()[0].position_m.x(), 1.0 / 3);
    }

    void escapeLeavesTheCellAsItWas()
    {
        IcebergTableFixture f;
        f.click(0, IcebergColumn::North);
        QTest::keyClicks(&f.table, u"9"_s);
        QTest::keyClick(&f.editor(), Qt::Key_Escape);
        QTRY_VERIFY(f.table.findChild<QWidget*>(u"icebergCell"_s) == nullptr);
        QCOMPARE(f.steps(), 0);
    }

    void pointIsADecimalSignEverywhere()
    {
        QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
        IcebergTableFixture f;
        f.click(0, IcebergColumn::Sigma0);
        QTest::keyClicks(&f.table, u"1"_s);
        QTest::keyClicks(&f.editor(), u".5"_s);
        QTest::keyClick(&f.editor(), Qt::Key_Return);
        QLocale::setDefault(QLocale::c());
        QTRY_COMPARE(f.icebergs()[0].sigma0_m2, 1.5);
    }

    void controlReturnSetsAllRowsSelected()
    {
        IcebergTableFixture f;
        f.click(0, IcebergColumn::Growth);
        f.click(2, IcebergColumn::Growth, Qt::ControlModifier);
        QTest::keyClicks(&f.table, u"2"_s);
        QTest::keyClick(&f.editor(), Qt::Key_Return, Qt::ControlModifier);
        QCOMPARE(f.icebergs()[0].q_m2ps, 2.0);
        QCOMPARE(f.icebergs()[1].q_m2ps, 0.025);
        QCOMPARE(f.icebergs()[2].q_m2ps, 2.0);
        QCOMPARE(f.steps(), 1);
        QCOMPARE(f.selectedRows(), (std::vector<int>{0, 2}));
    }

    /** Without typing, the value of the current cell is copied with all its digits. */
    void controlReturnCopiesTheCurrentCell()
    {
        IcebergTableFixture f(test::changed([](Scenario& s) { s.icebergs[2].q_m2ps = 1e-8 / 3; }));
        f.click(0, IcebergColumn::Growth);
        f.click(2, IcebergColumn::Growth, Qt::ControlModifier);
        QTest::keyClick(&f.table, Qt::Key_Return);
        QTest::keyClick(&f.editor(), Qt::Key_Return, Qt::ControlModifier);
        QCOMPARE(f.icebergs()[0].q_m2ps, 1e-8 / 3);
    }

    void finishTypingTakesWhatIsTyped()
    {
        IcebergTableFixture f;
        f.click(0, IcebergColumn::Appears);
        QTest::keyClicks(&f.table, u"4"_s);
        f.panel.finishTyping();
        QCOMPARE(f.icebergs()[0].appears_s, 4.0);
    }

    void latitudeIsTypedInAnyForm()
    {
        IcebergTableFixture f;
        const LocalFrame frame(f.document.scenario().origin);
        const double before_deg = frame.toGeographic(f.icebergs()[1].position_m).longitude_deg;
        f.click(1, IcebergColumn::Latitude);
        QTest::keyClicks(&f.table, u"4"_s);
        QTest::keyClicks(&f.editor(), u"7 06.3 N"_s);
        QTest::keyClick(&f.editor(), Qt::Key_Return);
        QTRY_COMPARE(f.at(1, IcebergColumn::Latitude).data().toString(), u"47° 06.300′ N"_s);
        QVERIFY(std::abs(frame.toGeographic(f.icebergs()[1].position_m).longitude_deg -
                         before_deg) < 1e-9);
        QCOMPARE(f.steps(), 1);
        QCOMPARE(f.fault(), QString());
        f.click(1, IcebergColumn::Latitude);
        QTest::keyClicks(&f.table, u"9"_s);
        QTest::keyClicks(&f.editor(), u"5"_s);
        QTest::keyClick(&f.editor(), Qt::Key_Return);
        QTRY_COMPARE(f.fault(), u"Latitude must be between 90° S and 90° N."_s);
        QCOMPARE(f.steps(), 1);
    }

    void pastesAtTheCurrentCell()
    {
        IcebergTableFixture f;
        f.click(3, IcebergColumn::East);
        QApplication::clipboard()->setText(u"10\t20\n30\t40\n"_s);
        QTest::keyClick(&f.table, Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(f.fault(), QString());
        QCOMPARE(f.icebergs().size(), std::size_t{5});
        QCOMPARE(f.icebergs()[3].position_m, Point(10, 20));
        QCOMPARE(f.icebergs()[4].position_m, Point(30, 40));
        QCOMPARE(f.selection.ids(), (Ids{"berg-4", "berg-5"}));
        QCOMPARE(f.selectedRows(), (std::vector<int>{3, 4}));
        f.document.undoStack()->undo();
        QCOMPARE(f.document.scenario(), test::fourIcebergs());
    }

    void refusedPasteShowsTheReason()
    {
        IcebergTableFixture f;
        f.click(0, IcebergColumn::East);
        QApplication::clipboard()->setText(u"10\t20\n30\tfar"_s);
        QTest::keyClick(&f.table, Qt::Key_V, Qt::ControlModifier);
        QVERIFY(f.fault().contains(u"far"_s));
        QCOMPARE(f.document.scenario(), test::fourIcebergs());
        QApplication::clipboard()->setText(u"10\t20"_s);
        QTest::keyClick(&f.table, Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(f.fault(), QString());
    }

    void pastesNothingFromAnEmptyClipboard()
    {
        IcebergTableFixture f;
        QApplication::clipboard()->clear();
        f.click(0, IcebergColumn::East);
        QTest::keyClick(&f.table, Qt::Key_V, Qt::ControlModifier);
        QVERIFY(!f.fault().isEmpty());
        QCOMPARE(f.steps(), 0);
    }

    void pastesIntoAnEmptyScenario()
    {
        IcebergTableFixture f(test::emptySea());
        auto& empty = test::child<QLabel>(f.panel, u"icebergsEmpty"_s);
        QVERIFY(empty.isVisible());
        QVERIFY(empty.text().contains(u"Ctrl+V"_s));
        f.table.setFocus();
        QApplication::clipboard()->setText(u"B01;100;200\nB02;300;400"_s);
        QTest::keyClick(&f.table, Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(f.icebergs().size(), std::size_t{2});
        QCOMPARE(f.icebergs()[1].id, "B02");
        QVERIFY(!empty.isVisible());
    }

    /** Only visible columns are copied. */
    void copiesTheRowsSelected()
    {
        IcebergTableFixture f;
        f.panel.setHiddenColumns({u"speed"_s, u"direction"_s, u"growth"_s, u"observed"_s,
                                  u"latitude"_s, u"longitude"_s});
        f.selection.set({"berg-1"});
        QTest::keyClick(&f.table, Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text(),
                 u"Iceberg\tEast, m\tNorth, m\tσ₀, m²\tAppears at, s\n"
                 "berg-1\t2000\t1000\t2.5\t0\n"_s);
    }

    void flightIsForReading()
    {
        IcebergTableFixture f;
        const Scenario before = f.document.scenario();
        f.panel.showRecord(flying(test::flown(before, 30)));
        f.click(1, IcebergColumn::East);
        QTest::keyClicks(&f.table, u"7"_s);
        QVERIFY(f.table.findChild<QWidget*>(u"icebergCell"_s) == nullptr);
        QApplication::clipboard()->setText(u"10\t20"_s);
        QTest::keyClick(&f.table, Qt::Key_V, Qt::ControlModifier);
        QVERIFY(!f.fault().isEmpty());
        QCOMPARE(f.document.scenario(), before);
        QVERIFY(f.table.isColumnHidden(static_cast<int>(IcebergColumn::Sigma0)));
        QVERIFY(!f.table.isColumnHidden(static_cast<int>(IcebergColumn::State)));
        FlightRecord reset;
        reset.begin(before);
        f.panel.showRecord(reset);
        QVERIFY(!f.table.isColumnHidden(static_cast<int>(IcebergColumn::Sigma0)));
        QCOMPARE(f.fault(), QString());
    }

    void choosingInFlightIsEmitted()
    {
        IcebergTableFixture f;
        f.panel.showRecord(flying(test::flown(test::fourIcebergs(), 30)));
        f.click(2, IcebergColumn::Name);
        QTest::mouseDClick(f.table.viewport(), Qt::LeftButton, {}, f.pixelOf(2));
        QCOMPARE(f.chosen.size(), 1);
        QCOMPARE(f.chosen.back().front().value<std::string>(), "berg-3");
        f.click(1, IcebergColumn::Name);
        QTest::keyClick(&f.table, Qt::Key_Return);
        QCOMPARE(f.chosen.size(), 2);
        QCOMPARE(f.chosen.back().front().value<std::string>(), "berg-2");
    }

    /** Sorting by sigma moves rows, but selection and scroll position stay. */
    void refreshKeepsWhatTheUserDoes()
    {
        Mission mission(manyIcebergs(500));
        mission.advance(20);
        IcebergTableFixture f(mission.scenario());
        f.panel.showRecord(flying(mission));
        f.table.sortByColumn(static_cast<int>(IcebergColumn::Sigma), Qt::DescendingOrder);
        const Ids chosen{f.icebergs()[7].id, f.icebergs()[300].id};
        f.selection.set(chosen);
        f.table.verticalScrollBar()->setValue(1000);
        QSignalSpy resets(&f.model, &QAbstractItemModel::modelReset);
        QSignalSpy moves(&f.model, &QAbstractItemModel::layoutChanged);
        for (int i = 1; i <= 20; ++i) {
            mission.advance(20 + 5 * i);
            f.panel.showRecord(flying(mission));
            double before_m2 = 1e9;
            for (int row = 0; row < 500; ++row) {
                const double sigma_m2 =
                    f.at(row, IcebergColumn::Sigma).data(Qt::EditRole).toDouble();
                QVERIFY(sigma_m2 <= before_m2);
                before_m2 = sigma_m2;
            }
        }
        QCOMPARE(resets.size(), 0);
        QVERIFY(moves.size() > 0);
        QCOMPARE(f.selection.ids(), chosen);
        QCOMPARE(f.selectedRows().size(), std::size_t{2});
        for (const int row : f.selectedRows())
            QVERIFY(f.selection.contains(f.name(row).toStdString()));
        QCOMPARE(f.table.verticalScrollBar()->value(), 1000);
    }

    void filterIsThereForMany()
    {
        IcebergTableFixture few;
        QVERIFY(!test::child<QLineEdit>(few.panel, u"icebergFilter"_s).isVisible());
        IcebergTableFixture f(manyIcebergs(40));
        auto& filter = test::child<QLineEdit>(f.panel, u"icebergFilter"_s);
        QVERIFY(filter.isVisible());
        const std::string id = f.icebergs()[17].id;
        f.selection.set({id});
        test::enter(filter, QString::fromStdString(id));
        QVERIFY(f.model.rowCount() < 40);
        QCOMPARE(f.selectedRows().size(), std::size_t{1});
        QCOMPARE(f.selection.ids(), Ids{id});
        test::enter(filter, u"no such one"_s);
        QVERIFY(test::child<QLabel>(f.panel, u"icebergsEmpty"_s).isVisible());
        QCOMPARE(f.selection.ids(), Ids{id});
        filter.clear();
        QCOMPARE(f.selectedRows(), std::vector<int>{17});
    }

    void columnsAreChosenInTheHeader()
    {
        IcebergTableFixture f;
        QSignalSpy changed(&f.panel, &IcebergTable::hiddenColumnsChanged);
        emit f.table.horizontalHeader()->customContextMenuRequested({5, 5});
        auto& menu = test::child<QMenu>(f.panel, u"icebergColumnMenu"_s);
        QCOMPARE(menu.actions().size(), 10); // the name stays
        menu.actions().back()->trigger();
        QVERIFY(f.table.isColumnHidden(static_cast<int>(IcebergColumn::Longitude)));
        QCOMPARE(changed.size(), 1);
        QCOMPARE(changed.back().front().toStringList(), QStringList{u"longitude"_s});
        menu.close();
    }

    void cellsHaveAMenu()
    {
        IcebergTableFixture f;
        emit f.table.customContextMenuRequested(f.pixelOf(2, IcebergColumn::Latitude));
        auto& menu = test::child<QMenu>(f.panel, u"icebergCellMenu"_s);
        const QString shown = f.at(2, IcebergColumn::Latitude).data().toString();
        for (QAction* action : menu.actions()) {
            if (action->text().contains(shown))
                action->trigger();
            if (action->text() == u"Show on the map"_s)
                action->trigger();
        }
        QCOMPARE(QApplication::clipboard()->text(), shown);
        QCOMPARE(f.chosen.back().front().value<std::string>(), "berg-3");
        menu.close();
    }

    void tableHasAccessibleTexts()
    {
        const IcebergTableFixture f;
        QVERIFY(!f.table.accessibleName().isEmpty());
        QVERIFY(!f.table.accessibleDescription().isEmpty());
    }
};

QTEST_MAIN(TestIcebergTable)
#include "tst_iceberg_table.moc"
