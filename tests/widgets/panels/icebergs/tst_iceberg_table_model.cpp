#include "core/io/files/scenario_json.h"
#include "core/tracking/position_error.h"
#include "tests/support/approx.h"
#include "tests/support/flight/mission_builder.h"
#include "tests/support/window/table_fixture.h"
#include "widgets/panels/plan/plan_rows.h"

#include <QSignalSpy>

#include <algorithm>

using namespace berg;
using namespace Qt::StringLiterals;
using berg::test::col;
using berg::test::Ids;
using berg::test::kEditorColumns;
using test::TableFixture;

namespace {

/** Returns four icebergs, one of which appears at 150 s. */
Scenario fourOneLater()
{
    return test::changed([](Scenario& scenario) { scenario.icebergs[2].appears_s = 150; });
}

/** Returns the record of the mission, looking back at `time_s`. */
FlightRecord recordAt(const Mission& mission, double time_s)
{
    FlightRecord record = recordOf(mission);
    record.now.phase = RunPhase::Paused;
    record.instant = snapshotAt(mission, time_s);
    return record;
}

} // namespace

class TestIcebergTableModel : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void editorShowsTheScenario()
    {
        const TableFixture f;
        QCOMPARE(f.model.rowCount(), 4);
        QCOMPARE(f.cell(0, IcebergColumn::Name), u"berg-1"_s);
        QCOMPARE(f.cell(2, IcebergColumn::Name), u"Isbjerg Å"_s);
        QCOMPARE(f.cell(0, IcebergColumn::East), u"2"_s + QChar(0x202f) + u"000.0"_s);
        QCOMPARE(f.cell(0, IcebergColumn::Speed), u"0.36"_s);
        QCOMPARE(f.cell(0, IcebergColumn::Direction), u"124"_s); // (0.3, -0.2): 90 + 33.7
        QCOMPARE(f.cell(2, IcebergColumn::Speed), u"0.00"_s);
        QCOMPARE(f.cell(2, IcebergColumn::Direction), u"–"_s);
        QCOMPARE(f.cell(1, IcebergColumn::Sigma0), u"3.50"_s);
        QCOMPARE(f.cell(3, IcebergColumn::Observed), u"100"_s);
        const QString toolTip =
            f.model.index(1, col(IcebergColumn::Sigma0)).data(Qt::ToolTipRole).toString();
        QVERIFY2(toolTip.contains(u"1.87 m"_s), qPrintable(toolTip)); // sqrt(3.5)
    }

    void columnsOfEditorAndFlight()
    {
        TableFixture f;
        for (int column = 0; column < f.model.columnCount(); ++column)
            QCOMPARE(f.model.hasColumn(column),
                     std::count(kEditorColumns.begin(), kEditorColumns.end(), column) == 1);
        f.model.showRecord(recordAt(test::flown(test::fourIcebergs(), 10), 10));
        QVERIFY(f.model.hasColumn(col(IcebergColumn::Sigma)));
        QVERIFY(f.model.hasColumn(col(IcebergColumn::East)));
        QVERIFY(!f.model.hasColumn(col(IcebergColumn::Sigma0)));
        for (int column = 0; column < f.model.columnCount(); ++column)
            for (const int role :
                 {static_cast<int>(Qt::DisplayRole), static_cast<int>(Qt::ToolTipRole)})
                QVERIFY(!f.model.headerData(column, Qt::Horizontal, role).toString().isEmpty());
    }

    void flightShowsTheInstant_data()
    {
        QTest::addColumn<double>("time_s");
        for (const double time_s : {0.0, 57.3, 149.9, 150.0, 260.0, 400.0})
            QTest::addRow("%g s", time_s) << time_s;
    }

    void flightShowsTheInstant()
    {
        QFETCH(double, time_s);
        const Mission mission = test::flown(fourOneLater());
        const FlightRecord record = recordAt(mission, time_s);
        const MissionSnapshot& shown = record.shown();
        TableFixture f(fourOneLater());
        f.model.showRecord(record);
        QCOMPARE(f.model.rowCount(), 4);
        int planned = 0;
        for (int i = 0; i < 4; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const IcebergTableRow& row = f.model.rowAt(i);
            if (!shown.active[at]) {
                QVERIFY(time_s < 150);
                QCOMPARE(i, 2);
                QCOMPARE(f.cell(i, IcebergColumn::State), u"not appeared yet"_s);
                QCOMPARE(f.cell(i, IcebergColumn::Sigma), u"–"_s);
                continue;
            }
            const Track& track = shown.world.tracks[at];
            QCOMPARE(*row.value(IcebergColumn::Sigma), track.sigma_m2);
            QCOMPARE(*row.value(IcebergColumn::Radius95), radius95_m(track.sigma_m2));
            QCOMPARE(*row.value(IcebergColumn::East), track.estimate_m(time_s).x());
            QCOMPARE(*row.value(IcebergColumn::North), track.estimate_m(time_s).y());
            QCOMPARE(*row.value(IcebergColumn::Speed), track.velocity_mps.norm());
            QCOMPARE(row.state == IcebergStanding::InView, track.inView);
            if (row.state == IcebergStanding::Planned)
                ++planned;
        }
        const std::vector<PlanSection> sections = planSections(shown, record.scenario);
        for (const PlanRow& plan : sections.front().rows) {
            const std::optional<double> arrival_s =
                f.model.rowAt(*f.model.rowOf(plan.id)).value(IcebergColumn::Arrival);
            QCOMPARE(arrival_s.has_value(), plan.isSeen);
            QCOMPARE(arrival_s.value_or(0), plan.arrival_s);
        }
        const std::optional<IcebergIndex> target = shown.world.uavs.front().target;
        if (target && !shown.world.tracks[toIndex(*target)].inView)
            QCOMPARE(f.cell(target->number(), IcebergColumn::State), u"target"_s);
        if (time_s == 0)
            QCOMPARE(planned, 2); // of three that are there one is flown to
        double visits = 0;
        for (int i = 0; i < 4; ++i)
            visits += f.model.rowAt(i).value(IcebergColumn::Visits).value_or(0);
        QCOMPARE(visits, static_cast<double>(shown.metrics.visits));
    }

    /** The state names the UAV that flies to it, the place in its order, and the arrival. */
    void severalUavsAreNamed()
    {
        Scenario scenario = test::fourIcebergs();
        scenario.planner.policy = PolicyKind::Visitation;
        scenario.uavs.push_back({.id = "uav-2", .name = "East", .position_m = Point(5000, 3000)});
        const FlightRecord record = recordAt(test::flown(scenario, 5), 5);
        const std::vector<IcebergTableRow> rows = flightRows(record);
        TableFixture f(scenario);
        const auto hasUavs = [&f] { return f.model.hasColumn(test::col(IcebergColumn::Uav)); };
        QVERIFY(!hasUavs()); // there is no plan before take-off
        f.model.showRecord(record);
        QVERIFY(hasUavs());
        f.model.sort(test::col(IcebergColumn::Uav), Qt::DescendingOrder);
        QCOMPARE(f.cell(0, IcebergColumn::Uav), u"East"_s);
        f.model.sort(-1, Qt::AscendingOrder);
        f.model.showRecord(recordAt(test::flown(test::fourIcebergs(), 5), 5));
        QVERIFY(!hasUavs());
        f.model.showRecord(record);
        const OrdersByUav orders = ordersOf(record.shown());
        for (const IcebergList& order : orders)
            for (std::size_t k = 0; k < order.size(); ++k) {
                const IcebergTableRow& row = rows[toIndex(order[k])];
                const QString uav = &order == &orders.front() ? u"uav-1"_s : u"East"_s;
                QCOMPARE(stateText(row), k == 0 ? u"target of %1"_s.arg(uav)
                                                : u"number %1 of %2"_s.arg(k + 1).arg(uav));
                QCOMPARE(f.cell(order[k].number(), IcebergColumn::Uav), uav);
                QVERIFY(*row.value(IcebergColumn::Arrival) > 0);
            }
        QCOMPARE(orders.size(), std::size_t{2});
        QVERIFY(!orders[1].empty());
    }

    /** Compared with the recorded rows: since the last sample in view, or since it became known. */
    void unseenSinceTheLastSight_data()
    {
        QTest::addColumn<bool>("changes");
        QTest::newRow("velocities that stay") << false;
        QTest::newRow("velocities that change") << true;
    }
    void unseenSinceTheLastSight()
    {
        QFETCH(bool, changes);
        Scenario scenario = fourOneLater();
        if (changes)
            test::letVelocitiesChange(scenario);
        const Mission mission = test::flown(scenario);
        const FlightRecord whole = recordOf(mission);
        TableFixture f(scenario);
        int seenBefore = 0;
        for (std::size_t sample = 40; sample < 390; sample += 20) {
            const double time_s = whole.history.samples[sample].time_s;
            f.model.showRecord(recordAt(mission, time_s));
            for (std::size_t i = 0; i < 4; ++i) {
                if (!whole.history.rows[sample][i].active)
                    continue;
                std::size_t last = sample;
                while (last > 0 && !whole.history.rows[last][i].inView &&
                       whole.history.rows[last][i].active)
                    --last;
                seenBefore += whole.history.rows[last][i].inView && last < sample ? 1 : 0;
                const double unseen_s =
                    *f.model.rowAt(static_cast<int>(i)).value(IcebergColumn::Unseen);
                // Samples are 1 s apart.
                COMPARE_NEAR(unseen_s, time_s - whole.history.samples[last].time_s, 1.001);
            }
        }
        QVERIFY(seenBefore >= 2);
    }

    void statesAreWords()
    {
        const FlightRecord record = recordAt(test::flown(test::fourIcebergs(), 20), 20);
        TableFixture f;
        f.model.showRecord(record);
        const IcebergList& order = record.shown().plan->uavs[0].order;
        QVERIFY(order.size() >= 3);
        QCOMPARE(f.cell(order[0].number(), IcebergColumn::State), u"target"_s);
        QCOMPARE(f.cell(order[2].number(), IcebergColumn::State), u"number 3 in the order"_s);
        QVERIFY(clockOf(record.scenario).isUtc());
        QVERIFY(f.cell(order[0].number(), IcebergColumn::Arrival).contains(u'Z'));
        FlightRecord relative = record;
        relative.scenario.startUtc.clear();
        f.model.showRecord(relative);
        QVERIFY(f.cell(order[0].number(), IcebergColumn::Arrival).startsWith(u"in "_s));
    }

    void nothingIsPlannedAfterTheEnd()
    {
        TableFixture f;
        Scenario scenario = test::fourIcebergs();
        scenario.duration_s = 60;
        f.model.showRecord(recordAt(test::flown(scenario, 60), 60));
        for (int row = 0; row < f.model.rowCount(); ++row)
            QVERIFY(!f.cell(row, IcebergColumn::State).contains(u"in the order"_s) ||
                    f.cell(row, IcebergColumn::State) == u"not in the order"_s);
    }

    void flightIsForReading()
    {
        TableFixture f;
        f.model.showRecord(recordAt(test::flown(test::fourIcebergs(), 20), 20));
        for (int column = 0; column < f.model.columnCount(); ++column)
            QVERIFY(!f.model.index(0, column).flags().testFlag(Qt::ItemIsEditable));
        QVERIFY(!f.put(0, IcebergColumn::East, 7));
        QCOMPARE(f.document.scenario(), test::fourIcebergs());
        f.model.showScenario();
        QVERIFY(f.model.index(0, col(IcebergColumn::East)).flags().testFlag(Qt::ItemIsEditable));
        QVERIFY(!f.model.index(0, col(IcebergColumn::Sigma)).flags().testFlag(Qt::ItemIsEditable));
    }

    void sortsByColumn_data()
    {
        QTest::addColumn<IcebergColumn>("column");
        QTest::addColumn<Qt::SortOrder>("order");
        QTest::addColumn<Ids>("ids");
        const auto add = [](const char* name, IcebergColumn column, const Ids& up,
                            const Ids& down) {
            QTest::addRow("%s up", name) << column << Qt::AscendingOrder << up;
            QTest::addRow("%s down", name) << column << Qt::DescendingOrder << down;
        };
        add("east", IcebergColumn::East, {"berg-3", "berg-1", "berg-2", "berg-4"},
            {"berg-4", "berg-2", "berg-1", "berg-3"});
        add("sigma0", IcebergColumn::Sigma0, {"berg-1", "berg-2", "berg-3", "berg-4"},
            {"berg-4", "berg-3", "berg-2", "berg-1"});
        // 124, 338, empty, 225 degrees: empty cells come last in both directions.
        add("direction", IcebergColumn::Direction, {"berg-1", "berg-4", "berg-2", "berg-3"},
            {"berg-2", "berg-4", "berg-1", "berg-3"});
        // berg-1, "Tabular ...", "Isbjerg Å", berg-4
        add("name", IcebergColumn::Name, {"berg-1", "berg-4", "berg-3", "berg-2"},
            {"berg-2", "berg-3", "berg-4", "berg-1"});
        // 0, 0, 0, 100 s: equal ones as in the scenario.
        add("observed", IcebergColumn::Observed, {"berg-1", "berg-2", "berg-3", "berg-4"},
            {"berg-4", "berg-1", "berg-2", "berg-3"});
    }

    void sortsByColumn()
    {
        QFETCH(IcebergColumn, column);
        QFETCH(Qt::SortOrder, order);
        QFETCH(Ids, ids);
        TableFixture f;
        f.model.sort(col(column), order);
        QCOMPARE(f.shown(), ids);
        f.model.sort(-1, order);
        QCOMPARE(f.shown(), (Ids{"berg-1", "berg-2", "berg-3", "berg-4"}));
    }

    void namesSortByTheirNumbers()
    {
        Scenario scenario = test::emptySea();
        for (int i = 1; i <= 12; ++i)
            test::addIceberg(scenario, 0, 0);
        TableFixture f(scenario);
        f.model.sort(col(IcebergColumn::Name), Qt::DescendingOrder);
        QCOMPARE(f.shown().front(), "berg-12");
        QCOMPARE(f.shown().back(), "berg-1");
    }

    void rowsKeepTheirIcebergsWhenSortedAnew()
    {
        TableFixture f;
        f.model.sort(col(IcebergColumn::East), Qt::AscendingOrder);
        const QPersistentModelIndex third = f.model.index(2, 0);
        QCOMPARE(f.model.rowAt(third.row()).id, "berg-2");
        QSignalSpy resets(&f.model, &QAbstractItemModel::modelReset);
        QVERIFY(f.put(2, IcebergColumn::East, -50));
        QCOMPARE(f.shown(), (Ids{"berg-2", "berg-3", "berg-1", "berg-4"}));
        QCOMPARE(third.row(), 0);
        QCOMPARE(resets.size(), 0);
    }

    void filtersByNameAndId()
    {
        TableFixture f;
        f.model.setFilter(u"isb"_s);
        QCOMPARE(f.shown(), Ids{"berg-3"});
        f.model.setFilter(u"BERG-"_s);
        QCOMPARE(f.model.rowCount(), 4);
        f.model.setFilter(u"nothing like it"_s);
        QCOMPARE(f.model.rowCount(), 0);
        QCOMPARE(f.model.total(), 4);
        QVERIFY(!f.model.rowOf("berg-1"));
        f.model.setFilter({});
        QCOMPARE(f.model.rowOf("berg-4").value(), 3);
    }

    void copiesTheFlightInSeconds()
    {
        TableFixture f;
        const FlightRecord record = recordAt(test::flown(test::fourIcebergs(), 90.3), 90.3);
        f.model.showRecord(record);
        const QString text = f.model.copied(
            {0}, {col(IcebergColumn::Name), col(IcebergColumn::State), col(IcebergColumn::Sigma)});
        const QStringList lines = text.split(u'\n');
        QCOMPARE(lines[0], u"Iceberg\tState\tσ, m²"_s);
        const QStringList cells = lines[1].split(u'\t');
        QCOMPARE(cells[0], u"berg-1"_s);
        QCOMPARE(cells[1], f.cell(0, IcebergColumn::State));
        QCOMPARE(cells[2].toDouble(), record.shown().world.tracks[0].sigma_m2);
    }

    /** A continuing flight neither resets the table nor reports unchanged rows. */
    void reportsChangedRowsOnly()
    {
        TableFixture f;
        Mission mission(test::fourIcebergs());
        mission.advance(50);
        f.model.showRecord(recordAt(mission, 50));
        QSignalSpy resets(&f.model, &QAbstractItemModel::modelReset);
        QSignalSpy changes(&f.model, &QAbstractItemModel::dataChanged);
        f.model.showRecord(recordAt(mission, 50));
        QCOMPARE(changes.size(), 0);
        mission.advance(51);
        f.model.showRecord(recordAt(mission, 51));
        QCOMPARE(changes.size(), 1);
        QCOMPARE(resets.size(), 0);
    }

    void icebergsAddedInFlightAreThere()
    {
        Mission mission(test::fourIcebergs());
        mission.advance(30);
        Iceberg added;
        added.id = "new";
        added.position_m = Point(100, 200);
        mission.intervene({.appears = added});
        mission.advance(40);
        TableFixture f;
        f.model.showRecord(recordAt(mission, 40));
        QCOMPARE(f.model.rowCount(), 5);
        QCOMPARE(*f.model.rowAt(*f.model.rowOf("new")).value(IcebergColumn::Unseen) <= 10.0, true);
        f.model.showRecord(recordAt(mission, 20));
        QCOMPARE(f.model.rowCount(), 4);
    }
};

QTEST_MAIN(TestIcebergTableModel)
#include "tst_iceberg_table_model.moc"
