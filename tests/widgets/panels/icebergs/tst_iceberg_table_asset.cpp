#include "core/mission/mission_instant.h"
#include "tests/support/approx.h"
#include "tests/support/flight/mission_builder.h"
#include "tests/support/window/table_fixture.h"

#include <QSignalSpy>

#include <algorithm>

using namespace berg;
using namespace Qt::StringLiterals;
using berg::test::col;
using berg::test::Ids;
using test::TableFixture;

namespace {

constexpr std::array kAssetColumns{IcebergColumn::AssetDistance, IcebergColumn::AssetTime};

/**
 * A platform at the origin. berg-1 passes it 1000 m to the north after 2000 s, berg-2 drifts away,
 * berg-3 stands still at 2500 m, berg-4 comes straight on and is 3200 m away in an hour.
 */
Scenario withAsset()
{
    return test::changed([](Scenario& scenario) {
        scenario.area_m.clear();
        scenario.current_mps = Point::Zero();
        scenario.duration_s = 3000;
        scenario.noise = false;
        std::vector<Iceberg>& icebergs = scenario.icebergs;
        icebergs[0].position_m = {1000, 1000};
        icebergs[0].velocity_mps = {-0.5, 0};
        icebergs[1].position_m = {3000, 0};
        icebergs[1].velocity_mps = {0.5, 0};
        icebergs[2].position_m = {0, 2500};
        icebergs[2].velocity_mps = {0, 0};
        icebergs[3].position_m = {-5000, 0};
        icebergs[3].velocity_mps = {0.5, 0};
        scenario.asset = Asset{.name = "Rig", .range_m = 4000, .alarm_m = 1200};
    });
}

FlightRecord recordAt(const Mission& mission, double time_s)
{
    FlightRecord record = recordOf(mission);
    record.now.phase = RunPhase::Paused;
    record.instant = snapshotAt(mission, time_s);
    return record;
}

bool hasAssetColumns(const TableFixture& f)
{
    const auto isThere = [&](IcebergColumn column) { return f.model.hasColumn(col(column)); };
    return std::all_of(kAssetColumns.begin(), kAssetColumns.end(), isThere);
}

} // namespace

/** The table of icebergs about the asset, and about icebergs that are lost or have left. */
class TestIcebergTableAsset : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void columnsAreThereWithAnAsset()
    {
        TableFixture f(withAsset());
        QVERIFY(hasAssetColumns(f));
        const QSignalSpy changed(&f.model, &IcebergTableModel::columnsChanged);
        f.document.edit(u"Remove"_s, [](Scenario& scenario) { scenario.asset.reset(); });
        QVERIFY(!hasAssetColumns(f));
        QCOMPARE(changed.size(), 1);
        f.document.undoStack()->undo();
        QVERIFY(hasAssetColumns(f));
        QCOMPARE(changed.size(), 2);
        f.model.showRecord(recordAt(test::flown(withAsset(), 10), 10));
        QVERIFY(hasAssetColumns(f));
        f.model.showRecord(recordAt(test::flown(test::fourIcebergs(), 10), 10));
        QVERIFY(!hasAssetColumns(f));
        QCOMPARE(f.cell(0, IcebergColumn::AssetDistance), u"–"_s);
    }

    void editorShowsTheApproachFromTheStart()
    {
        const TableFixture f(withAsset());
        const auto row = [&](int i) {
            return QStringList{f.cell(i, IcebergColumn::AssetDistance),
                               f.cell(i, IcebergColumn::AssetTime)};
        };
        const QString thousand = u"\u202f"_s;
        QCOMPARE(row(0), (QStringList{u"1"_s + thousand + u"000"_s, u"33:20"_s}));
        QCOMPARE(row(1), (QStringList{u"3"_s + thousand + u"000"_s, u"now"_s}));
        QCOMPARE(row(2), (QStringList{u"2"_s + thousand + u"500"_s, u"now"_s}));
        QCOMPARE(row(3), (QStringList{u"3"_s + thousand + u"200"_s, u"> 1 h"_s}));
        const auto toolTip = [&](int i) {
            return f.model.index(i, col(IcebergColumn::AssetTime)).data(Qt::ToolTipRole).toString();
        };
        QVERIFY(toolTip(0).isEmpty());
        QVERIFY(toolTip(3).contains(u"still approaching"_s));
    }

    /** The current carries the icebergs, not the platform. */
    void currentMovesIcebergsButNotTheAsset()
    {
        TableFixture f(withAsset());
        f.document.edit(u"Current"_s, [](Scenario& s) { s.current_mps = {0, -0.5}; });
        QCOMPARE(f.cell(2, IcebergColumn::AssetDistance), u"700"_s); // 2500 m less 3600 s of it
    }

    void flightFollowsTheInstant_data()
    {
        QTest::addColumn<double>("time_s");
        for (const double time_s : {0.0, 500.0, 1999.0, 2600.0})
            QTest::addRow("%g s", time_s) << time_s;
    }

    void flightFollowsTheInstant()
    {
        QFETCH(double, time_s);
        const Mission mission = test::flown(withAsset());
        const Simulation then = instantAt(mission, time_s).simulation;
        TableFixture f(withAsset());
        f.model.showRecord(recordAt(mission, time_s));
        for (int i = 0; i < 4; ++i) {
            const ClosestApproach expected = closestApproach(
                *relativeToAsset(then.observer(), IcebergIndex::of(i)), kApproachHorizon_s);
            const IcebergTableRow& row = f.model.rowAt(i);
            COMPARE_NEAR(row.value(IcebergColumn::AssetDistance).value_or(-1), expected.distance_m,
                         1e-9);
            COMPARE_NEAR(row.value(IcebergColumn::AssetTime).value_or(-1), expected.time_s, 1e-9);
        }
    }

    void sortsByBoth()
    {
        TableFixture f(withAsset());
        f.model.sort(col(IcebergColumn::AssetDistance), Qt::AscendingOrder);
        QCOMPARE(f.shown(), (Ids{"berg-1", "berg-3", "berg-2", "berg-4"}));
        f.model.sort(col(IcebergColumn::AssetTime), Qt::DescendingOrder);
        QCOMPARE(f.shown(), (Ids{"berg-4", "berg-1", "berg-2", "berg-3"}));
    }

    /** A sign and a text: berg-1 crosses the ring of 1200 m after (1000 + sqrt(...)) / 0.5 s. */
    void alarmIsMarkedAndExplained()
    {
        const TableFixture f(withAsset());
        const QModelIndex coming = f.model.index(0, col(IcebergColumn::Name));
        const QModelIndex other = f.model.index(2, col(IcebergColumn::Name));
        QVERIFY(coming.data(IcebergTableModel::AlarmRole).toBool());
        QVERIFY(!other.data(IcebergTableModel::AlarmRole).toBool());
        // 663 m before abeam the distance is 1200 m: 337 m, 673 s from the start.
        const QString time = TimesAhead{clockOf(withAsset())}.minuteInBrackets(673);
        QVERIFY(!time.isEmpty());
        const QString words = u"berg-1 enters the inner ring in 11 min"_s + time;
        QVERIFY(coming.data(Qt::ToolTipRole).toString().endsWith(words));
        QCOMPARE(coming.data(Qt::AccessibleTextRole).toString(), words);
        QVERIFY(!other.data(Qt::AccessibleTextRole).isValid());
    }

    void columnsAreNotEdited()
    {
        TableFixture f(withAsset());
        const QModelIndex cell = f.model.index(0, col(IcebergColumn::AssetDistance));
        QVERIFY(!cell.flags().testFlag(Qt::ItemIsEditable));
        QVERIFY(!f.put(0, IcebergColumn::AssetDistance, 5));
        const std::vector<int> columns{col(IcebergColumn::Name), col(IcebergColumn::AssetDistance),
                                       col(IcebergColumn::AssetTime), col(IcebergColumn::East)};
        const PasteOutcome refused =
            f.model.paste(u"5"_s, 0, col(IcebergColumn::AssetDistance), columns);
        QVERIFY2(refused.fault.contains(u"CPA"_s), qPrintable(refused.fault));
        QCOMPARE(f.document.undoStack()->count(), 0);
        // Cells beside each other go past them.
        const PasteOutcome pasted =
            f.model.paste(u"Tabular\t1234"_s, 0, col(IcebergColumn::Name), columns);
        QVERIFY2(pasted.fault.isEmpty(), qPrintable(pasted.fault));
        QCOMPARE(f.icebergs()[0].name, std::string("Tabular"));
        QCOMPARE(f.icebergs()[0].position_m.x(), 1234.0);
    }

    /** Pasting them with their titles changes nothing. */
    void copiedColumnsArePassedOver()
    {
        TableFixture f(withAsset());
        const std::vector<int> columns{col(IcebergColumn::Name), col(IcebergColumn::AssetDistance),
                                       col(IcebergColumn::AssetTime), col(IcebergColumn::East)};
        const QString text = f.model.copied(f.allRows(), columns);
        QVERIFY(text.contains(u"\t2000\t"_s)); // seconds, as a number
        const PasteOutcome outcome = f.model.paste(text, 0, 0, columns);
        QVERIFY2(outcome.fault.isEmpty(), qPrintable(outcome.fault));
        QCOMPARE(f.document.scenario(), withAsset());
    }

    void statesOfLostIcebergs_data()
    {
        QTest::addColumn<int>("status");
        QTest::addColumn<bool>("isSearched");
        QTest::addColumn<bool>("hasLeft");
        QTest::addColumn<QString>("state");
        QTest::newRow("lost") << int(TrackStatus::Lost) << false << false << u"lost"_s;
        QTest::newRow("searched") << int(TrackStatus::Lost) << true << false
                                  << u"lost, being searched for"_s;
        QTest::newRow("search abandoned")
            << int(TrackStatus::GivenUp) << false << false << u"search abandoned"_s;
        QTest::newRow("left") << int(TrackStatus::Tracked) << false << true << u"left or removed"_s;
    }

    void statesOfLostIcebergs()
    {
        QFETCH(int, status);
        QFETCH(bool, isSearched);
        QFETCH(bool, hasLeft);
        QFETCH(QString, state);
        FlightRecord record = recordAt(test::flown(withAsset(), 10), 10);
        WorldState& world = record.instant->world;
        Track& track = world.tracks[1];
        track.status = static_cast<TrackStatus>(status);
        track.left = hasLeft;
        track.inView = false;
        if (isSearched) {
            world.uavs[0].search.emplace();
            world.uavs[0].search->iceberg = 1;
        }
        TableFixture f(withAsset());
        f.model.showRecord(record);
        QCOMPARE(f.cell(1, IcebergColumn::State), state);
        QCOMPARE(f.cell(1, IcebergColumn::Sigma) == u"–"_s, hasLeft);
        QCOMPARE(f.cell(1, IcebergColumn::AssetDistance) == u"–"_s, hasLeft);
        f.model.sort(col(IcebergColumn::State), Qt::AscendingOrder);
        QCOMPARE(f.shown().back(), std::string("berg-2")); // behind those in view or in the order
    }
};

QTEST_MAIN(TestIcebergTableAsset)
#include "tst_iceberg_table_asset.moc"
