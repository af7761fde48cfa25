#include "tests/support/flight/fleet_flight.h"
#include "tests/support/window/comparison_builder.h"
#include "tests/support/window/panel_test.h"
#include "widgets/flight/compared_run.h"
#include "widgets/map/picture/mission_picture.h"
#include "widgets/panels/study/comparison_tables.h"

using namespace berg;
using namespace test;
using namespace Qt::StringLiterals;

class TestComparedRun : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void runsOfOneWorldAreComparable_data()
    {
        QTest::addColumn<int>("change");
        QTest::addColumn<bool>("expected");
        QTest::newRow("nothing") << 0 << true;
        QTest::newRow("name and notes") << 1 << true;
        QTest::newRow("planner") << 2 << true;
        QTest::newRow("seed") << 3 << false;
        QTest::newRow("duration") << 4 << false;
        QTest::newRow("an iceberg moved") << 5 << false;
        QTest::newRow("one iceberg less") << 6 << false;
        QTest::newRow("field of view") << 7 << false;
        QTest::newRow("reach") << 8 << false;
        QTest::newRow("name of an iceberg") << 9 << false;
        QTest::newRow("name of a UAV") << 10 << false;
        QTest::newRow("unknown members") << 11 << false;
        QTest::newRow("planning delay") << 12 << false;
        QTest::newRow("asset") << 13 << false;
        QTest::newRow("separation") << 14 << false;
        QTest::newRow("start time") << 15 << false;
    }

    void runsOfOneWorldAreComparable()
    {
        QFETCH(int, change);
        QFETCH(bool, expected);
        const Scenario scenario = shortScenario();
        Scenario other = scenario;
        if (change == 1)
            other.name = other.notes = "other";
        else if (change == 2)
            other.planner = policy(PolicyKind::Tour, 3);
        else if (change == 3)
            ++other.seed;
        else if (change == 4)
            other.duration_s += 1;
        else if (change == 5)
            other.icebergs[0].position_m.x() += 1;
        else if (change == 6)
            other.icebergs.pop_back();
        else if (change == 7)
            other.uavs[0].fov_m = Point(500, 500);
        else if (change == 8)
            other.reachRadius_m = 200;
        else if (change == 9)
            other.icebergs[0].name = "other";
        else if (change == 10)
            other.uavs[0].name = "other";
        else if (change == 11)
            other.extraJson = R"({"later":1})";
        else if (change == 12)
            other.planningTime_s = 3;
        else if (change == 13)
            other.asset = Asset{.name = "Platform"};
        else if (change == 14)
            other.separation_m = 0;
        else if (change == 15)
            other.startUtc = "2026-06-01T00:00:00Z";
        QCOMPARE(isSameWorld(scenario, other), expected);
        const ComparedRun a{.scenario = scenario, .icebergs = scenario.icebergs};
        const ComparedRun b{.scenario = other, .icebergs = other.icebergs};
        QCOMPARE(isComparable(a, b), expected);
    }

    void changesOfTheWorldCount_data()
    {
        QTest::addColumn<int>("change");
        QTest::addColumn<bool>("expected");
        QTest::newRow("the same changes") << 0 << true;
        QTest::newRow("another wind") << 1 << false;
        QTest::newRow("at another time") << 2 << false;
        QTest::newRow("no change of the wind") << 3 << false;
        QTest::newRow("the asset moved elsewhere") << 4 << false;
        QTest::newRow("another iceberg") << 5 << false;
        QTest::newRow("tau as well") << 6 << true;
    }

    /** Wind, asset and icebergs belong to the world; changes of the planner do not. */
    void changesOfTheWorldCount()
    {
        QFETCH(int, change);
        QFETCH(bool, expected);
        const auto flown = [](const std::function<void(std::vector<Intervention>&)>& vary) {
            std::vector<Intervention> changes{
                {.time_s = 20, .wind_mps = Point(5, -3)},
                {.time_s = 30, .asset = Asset{.position_m = {900, 100}}},
                {.time_s = 30, .appears = newIceberg()}};
            vary(changes);
            Scenario scenario = shortScenario();
            scenario.duration_s = 60;
            Mission mission(scenario);
            for (const Intervention& next : changes) {
                mission.advance(next.time_s);
                mission.intervene(next);
            }
            mission.advance(60);
            return comparedRun(recordOf(mission));
        };
        const ComparedRun a = flown([](auto&) {});
        const ComparedRun b = flown([change](std::vector<Intervention>& changes) {
            if (change == 1)
                changes[0].wind_mps = Point(5, -4);
            else if (change == 2)
                changes[0].time_s = 21;
            else if (change == 3)
                changes.erase(changes.begin());
            else if (change == 4)
                changes[1].asset->position_m = {900, 200};
            else if (change == 5)
                changes[2].appears->position_m.x() += 100;
            else if (change == 6)
                changes[0].tau = 3;
        });
        QCOMPARE(a.worldChanges.size(), std::size_t{3});
        QCOMPARE(isComparable(a, b), expected);
        QVERIFY(!a.wasChanged); // the planner was not changed
        QCOMPARE(b.wasChanged, change == 6);
    }

    /** The figures of a run at an earlier time equal those of a run that ended there. */
    void figuresOfAnEarlierTime_data()
    {
        QTest::addColumn<double>("until_s");
        QTest::newRow("start") << 0.0;
        QTest::newRow("a sample") << 120.0;
        QTest::newRow("between samples") << 210.5;
        QTest::newRow("end") << 300.0;
    }

    void figuresOfAnEarlierTime()
    {
        QFETCH(double, until_s);
        const ComparedRun whole =
            comparedRun(recordOf(flownWith(shortScenario(), policy(PolicyKind::Nearest))));
        const Mission there = flownWith(shortScenario(), policy(PolicyKind::Nearest), until_s);
        const RunFigures figures = figuresAt(whole, until_s);
        const RunFigures expected = figuresAt(comparedRun(recordOf(there)), until_s);
        QCOMPARE(expected.zeta_m2s, there.metrics().zeta_m2s); // also if stopped between samples
        QCOMPARE(figures.visits, there.metrics().visits);
        QCOMPARE(figures.plans, there.metrics().replans);
        // Between samples zeta is nearly linear, because sigma changes by far less than itself.
        const double exact = until_s == 210.5 ? 1e-3 : 1e-12;
        QVERIFY(std::abs(figures.zeta_m2s - there.metrics().zeta_m2s) <=
                exact * there.metrics().zeta_m2s);
        QVERIFY(std::abs(figures.flown_m - there.metrics().flown_m) <= 1e-6);
        QCOMPARE(figures.longestUnseen, expected.longestUnseen);
    }
    void runNamesStateWhatDiffers_data()
    {
        QTest::addColumn<PolicyKind>("kind");
        QTest::addColumn<double>("tau");
        QTest::addColumn<bool>("changed");
        QTest::addColumn<double>("flown_s");
        QTest::addColumn<QString>("name");
        QTest::newRow("tau") << PolicyKind::Visitation << 1.0 << false << 1000.0 << u"τ 1.00"_s;
        QTest::newRow("fine") << PolicyKind::Visitation << 0.0125 << false << 1000.0
                              << u"τ 0.0125"_s;
        QTest::newRow("tour") << PolicyKind::Tour << 1.0 << false << 1000.0 << u"Round tour"_s;
        QTest::newRow("changed") << PolicyKind::Visitation << 2.0 << true << 1000.0
                                 << u"τ 2.00, changed in flight"_s;
        QTest::newRow("stopped") << PolicyKind::Nearest << 2.0 << false << 300.0
                                 << u"Nearest first, to 05:00"_s;
        QTest::newRow("both") << PolicyKind::Nearest << 2.0 << true << 300.0
                              << u"Nearest first, changed in flight, to 05:00"_s;
    }

    void runNamesStateWhatDiffers()
    {
        QFETCH(PolicyKind, kind);
        QFETCH(double, tau);
        QFETCH(bool, changed);
        QFETCH(double, flown_s);
        QFETCH(QString, name);
        const ComparedRun run{
            .planner = policy(kind, tau), .wasChanged = changed, .flown_s = flown_s};
        QCOMPARE(runName(run, QLocale::c()), name);
    }

    /** The totals of the UAVs add up to those of the fleet, also between samples. */
    void figuresOfAFleet_data()
    {
        QTest::addColumn<double>("until_s");
        QTest::newRow("start") << 0.0;
        QTest::newRow("between samples") << 210.5;
        QTest::newRow("end") << 300.0;
    }

    void figuresOfAFleet()
    {
        QFETCH(double, until_s);
        const Mission mission =
            flownWith(withUavs(shortScenario(), 3), policy(PolicyKind::Visitation));
        const ComparedRun run = comparedRun(recordOf(mission));
        const RunFigures figures = figuresAt(run, until_s);
        QCOMPARE(figures.uavs.size(), std::size_t{3});
        UavTotals all;
        for (const UavTotals& uav : figures.uavs) {
            all.visits += uav.visits;
            all.flown_m += uav.flown_m;
            QVERIFY(std::abs(uav.flown_m - 22 * until_s) < 1e-6);
        }
        QCOMPARE(all.visits, figures.visits);
        QVERIFY(std::abs(all.flown_m - figures.flown_m) < 1e-6);
        if (until_s == 300) {
            QCOMPARE(figures.visits, mission.metrics().visits);
            QCOMPARE(figures.plans, mission.metrics().replans); // one solve for all
            QCOMPARE(static_cast<int>(mission.plans().size()), figures.plans);
        }
    }

    void rowsOfAFleet()
    {
        Scenario two = withUavs(shortScenario(), 2);
        two.uavs[0].name = "Fulmar";
        const ComparedRun a = comparedRun(flownRecord(two, policy(PolicyKind::Visitation), 60));
        const ComparedRun b = comparedRun(flownRecord(two, policy(PolicyKind::Nearest), 60));
        const auto rows = figureRows(a, &b, QLocale::c());
        const ComparedRun one =
            comparedRun(flownRecord(shortScenario(), policy(PolicyKind::Tour), 60));
        const auto alone = figureRows(one, nullptr, QLocale::c());
        QCOMPARE(rows.size(), alone.size() + 4);
        const auto row = std::ranges::find(rows, u"Fulmar, km"_s, &ComparisonRow::label);
        QVERIFY(row != rows.end());
        QCOMPARE(row->reference, u"1.32"_s); // 60 s at 22 m/s
        QCOMPARE(row->other, u"1.32"_s);
        QVERIFY(std::ranges::find(rows, u"uav-1-2, visits"_s, &ComparisonRow::label) != rows.end());
    }

    void trackForTheMap()
    {
        const ComparedRun run =
            comparedRun(recordOf(flownWith(shortScenario(), policy(PolicyKind::Nearest), 90)));
        MapPicture picture;
        addComparison(picture, run, 1e9, QLocale::c());
        QCOMPARE(picture.comparisonTracks[0].size(), run.samples.size());
        QCOMPARE(picture.comparisonName, u"Nearest first, to 01:30"_s);
        addComparison(picture, run, 30, QLocale::c());
        QCOMPARE(picture.comparisonTracks[0].size(), std::size_t{31});
        QVERIFY(picture.comparisonTracks[0].back().position_m ==
                run.samples[30].uavs[0].pose.position_m);
    }
};

QTEST_MAIN(TestComparedRun)
#include "tst_compared_run.moc"
