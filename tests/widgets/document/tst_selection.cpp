#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/ids.h"
#include "widgets/document/scenario_edits.h"
#include "widgets/document/selection.h"

#include <QSignalSpy>
#include <QtTest>

using namespace berg;
using test::Ids;
class TestSelection : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void keepsTheOrderOfSelecting()
    {
        Selection selection;
        QVERIFY(selection.isEmpty());
        selection.toggle("berg-2");
        selection.toggle("uav-1");
        selection.toggle("berg-1");
        QCOMPARE(selection.ids(), (Ids{"berg-2", "uav-1", "berg-1"}));
        selection.toggle("uav-1");
        QCOMPARE(selection.ids(), (Ids{"berg-2", "berg-1"}));
        QVERIFY(selection.contains("berg-1"));
        QVERIFY(!selection.contains("uav-1"));
    }

    void anIdCountsOnce()
    {
        Selection selection;
        selection.set({"a", "b", "a"});
        QCOMPARE(selection.ids(), (Ids{"a", "b"}));
    }

    void emitsRealChangesOnly()
    {
        Selection selection;
        const QSignalSpy changed(&selection, &Selection::changed);
        selection.clear();
        selection.set({});
        QCOMPARE(changed.count(), 0);
        selection.set({"a", "b"});
        QCOMPARE(changed.count(), 1);
        selection.set({"a", "b"});
        selection.set({"a", "b", "b"});
        QCOMPARE(changed.count(), 1);
        selection.set({"b", "a"});
        QCOMPARE(changed.count(), 2);
        selection.toggle("a");
        QCOMPARE(changed.count(), 3);
        selection.clear();
        QCOMPARE(changed.count(), 4);
    }

    void dropsWhatIsGone()
    {
        Scenario scenario = test::emptySea();
        test::addIceberg(scenario, 100, 0);
        test::addIceberg(scenario, 200, 0);
        Selection selection;
        selection.set({"berg-2", "berg-7", "uav-1", "uav-9"});
        const QSignalSpy changed(&selection, &Selection::changed);
        selection.keepExisting(scenario);
        QCOMPARE(selection.ids(), (Ids{"berg-2", "uav-1"}));
        selection.keepExisting(scenario);
        QCOMPARE(changed.count(), 1);
    }

    void noFlyAreasAreDroppedWhenOneComesOrGoes_data()
    {
        QTest::addColumn<int>("removed");
        QTest::newRow("first") << 0;
        QTest::newRow("last") << 2;
    }
    /** An area that moved to another index was not selected. */
    void noFlyAreasAreDroppedWhenOneComesOrGoes()
    {
        QFETCH(int, removed);
        Scenario all = test::emptySea();
        for (const char* name : {"A", "B", "C"})
            all.noFly.emplace_back().name = name;
        Scenario fewer = all;
        fewer.noFly.erase(fewer.noFly.begin() + removed);
        Selection selection;
        selection.keepExisting(all);
        for (const Scenario* next : {&fewer, &all, &fewer}) { // removed, undone, redone
            selection.set({noFlyKey(0)});
            selection.keepExisting(*next);
            QVERIFY(selection.isEmpty());
        }
        selection.set({noFlyKey(1)}); // as if just drawn
        fewer.noFly[1].name = "Changed";
        selection.keepExisting(fewer);
        QCOMPARE(selection.ids(), (Ids{noFlyKey(1)}));
    }

    void freshIdsClashWithNothing()
    {
        Scenario scenario = test::emptySea();
        QCOMPARE(freshIcebergId(scenario), std::string("berg-1"));
        test::addIceberg(scenario, 0, 0).id = "berg-2";
        // One iceberg: the search begins at 2, which is taken.
        QCOMPARE(freshIcebergId(scenario), std::string("berg-3"));
        scenario.uavs[0].id = "berg-3";
        QCOMPARE(freshIcebergId(scenario), std::string("berg-4"));
        test::addIceberg(scenario, 0, 0).id = "uav-1";
        QCOMPARE(freshUavId(scenario), std::string("uav-2"));
    }

    void aGroupKeepsItsFormAtTheLimit()
    {
        Scenario scenario = test::emptySea();
        test::addIceberg(scenario, kLargestCoordinate_m - 100, 0);
        test::addIceberg(scenario, 0, -kLargestCoordinate_m + 300);
        moveObjects(scenario, Ids{"berg-1", "berg-2", "gone"}, {500, -1000});
        QVERIFY(scenario.icebergs[0].position_m == Point(kLargestCoordinate_m, -300));
        QVERIFY(scenario.icebergs[1].position_m == Point(100, -kLargestCoordinate_m));
        moveObjects(scenario, Ids{"uav-1"}, {5e6, -5e6});
        QVERIFY(scenario.uavs[0].position_m == Point(kLargestCoordinate_m, -kLargestCoordinate_m));
    }

    void removesIcebergsOnly()
    {
        Scenario scenario = test::emptySea();
        test::addIceberg(scenario, 0, 0);
        test::addIceberg(scenario, 1, 0);
        removeIcebergs(scenario, Ids{"berg-1", "uav-1"});
        QCOMPARE(scenario.icebergs.size(), std::size_t{1});
        QCOMPARE(scenario.icebergs[0].id, std::string("berg-2"));
        QCOMPARE(scenario.uavs.size(), std::size_t{1});
    }

    void assetAndAreaAreKeptWhileTheyAreThere()
    {
        Scenario scenario = test::emptySea();
        scenario.asset.emplace();
        scenario.area_m = {{0, 0}, {100, 0}, {0, 100}};
        Selection selection;
        selection.set({kAssetKey, kAreaKey, "uav-1"});
        selection.keepExisting(scenario);
        QCOMPARE(selection.ids(), (Ids{kAssetKey, kAreaKey, "uav-1"}));
        moveObjects(scenario, selection.ids(), {10, -5});
        QVERIFY(scenario.asset->position_m == Point(10, -5));
        QVERIFY(scenario.area_m == (std::vector<Point>{{10, -5}, {110, -5}, {10, 95}}));
        removeObjects(scenario, selection.ids());
        selection.keepExisting(scenario);
        QCOMPARE(selection.ids(), (Ids{"uav-1"}));
    }

    void copiesGetNamesAndIdsOfTheirOwn()
    {
        Scenario scenario = test::emptySea();
        for (const char* name : {"Big", "Big", "B 7", "7", ""})
            test::addIceberg(scenario, 0, 0).name = name;
        scenario.icebergs[1].id = "berg-7";
        const std::vector<Iceberg> originals = scenario.icebergs;
        const Ids ids = addCopies(scenario, originals, {1, 2});
        QCOMPARE(ids, (Ids{"berg-6", "berg-8", "berg-9", "berg-10", "berg-11"}));
        Ids names;
        for (std::size_t i = 5; i < 10; ++i)
            names.push_back(scenario.icebergs[i].name);
        QCOMPARE(names, (Ids{"Big 2", "Big 3", "B 2", "7 2", ""}));
        QVERIFY(scenario.icebergs[9].position_m == Point(1, 2));
    }

    void velocitiesKeepTheirDirectionAtTheLimit()
    {
        QVERIFY(clampedVelocity({3, -4}) == Point(3, -4));
        QVERIFY(clampedVelocity({10, -5}) == Point(5, -2.5));
    }
};

QTEST_APPLESS_MAIN(TestSelection)
#include "tst_selection.moc"
