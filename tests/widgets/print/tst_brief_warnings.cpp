#include "tests/support/files/brief_fixtures.h"
#include "widgets/print/brief_warnings.h"
#include "widgets/print/printable_text.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

/** Warnings of the flight brief, and names as printed. */
class TestBriefWarnings : public QObject
{
    Q_OBJECT

private slots:
    void worstWarningsComeFirst()
    {
        const ExportContent content = planContent(changed([](Scenario& s) {
                                                      s.geofence = true;
                                                      s.wind_mps = Point(25, 0);
                                                      s.icebergs[2].name = "\xE2\x80\xAE"
                                                                           "odd\n";
                                                  }),
                                                  planOf({0, 3}));
        const QStringList warnings = briefWarnings(content, kEnglish);
        QVERIFY(warnings.size() >= 3);
        QVERIFY2(warnings[0].startsWith(u"Error: "_s), qPrintable(warnings[0]));
        const qsizetype left =
            warnings.indexOf(u"Not in the order (2): Tabular \"B\", grounded since May, odd"_s);
        const qsizetype fence = warnings.indexOf(u"Geofence in force: stay inside the area."_s);
        QVERIFY(0 < fence && fence < left); // a rule does not get lost behind a list
    }

    /** Icebergs that may have drifted out of view until the UAV is there. */
    void chanceOfBeingInView()
    {
        const auto linesWith = [](double sigma_m2) {
            const ExportContent content = planContent(
                changed([&](Scenario& s) { s.icebergs[3].sigma0_m2 = sigma_m2; }), planOf({0, 3}));
            return briefWarnings(content, kEnglish).filter(u"in view on arrival"_s);
        };
        QVERIFY(linesWith(10).isEmpty());
        const QStringList lines = linesWith(300 * 300);
        QCOMPARE(lines.size(), 1);
        QVERIFY2(lines.front().endsWith(u"berg-4 47 %"_s), qPrintable(lines.front()));
    }

    void sameOfSeveralIsOneLine()
    {
        const ExportContent content = planContent(changed([](Scenario& s) {
            s.icebergs[0].position_m = Point(300'000, 0);
            s.icebergs[2].position_m = Point(0, 300'000);
        }));
        const QStringList far = briefWarnings(content, kEnglish).filter(u"too far away"_s);
        QCOMPARE(far.size(), 1);
        QVERIFY2(far[0].contains(u" (2): "_s), qPrintable(far[0]));
        for (const std::size_t i : {0U, 2U})
            QVERIFY(far[0].contains(printable(titleOf(content.icebergs[i].iceberg))));
    }

    /** Legs and arrivals are without the turns over icebergs, so that is said first. */
    void loiterTurnsAreReckoned()
    {
        const Scenario scenario = changed([](Scenario& s) { s.uavs[0].spec.endurance_s = 2000; });
        const ExportContent content = planContent(scenario, fourIcebergPlan(), {.loiterTurns = 20});
        const QStringList warnings = briefWarnings(content, kEnglish);
        // 20 turns of a radius of 106 m at 22 m/s are 10 min.
        QVERIFY2(
            warnings[0].startsWith(u"Times do not include the loiter turns, which add 10 min"_s),
            qPrintable(warnings[0]));
        QVERIFY2(warnings[1].contains(u"endurance is too short"_s), qPrintable(warnings[1]));
    }

    void nothingToWarnOf()
    {
        const ExportContent content = planContent(byDay(fourIcebergs()));
        QCOMPARE(briefWarnings(content, kEnglish), QStringList());
    }

    void planIsJudged_data()
    {
        QTest::addColumn<Plan>("plan");
        QTest::addColumn<QString>("words");
        QTest::addColumn<bool>("isWarned");
        QTest::newRow("proven") << Plan{.outcome = {.status = SolveStatus::Optimal}, .gap = 0}
                                << u"Proven optimal"_s << false;
        QTest::newRow("gap") << Plan{.outcome = {.status = SolveStatus::Feasible}, .gap = 0.0079}
                             << u"Within 0.8 % of optimal"_s << true;
        QTest::newRow("no bound") << Plan{.outcome = {.status = SolveStatus::Feasible}}
                                  << u"Best order found"_s << true;
        QTest::newRow("fell back")
            << Plan{.fellBack = true} << u"Solver limit reached; previous plan kept"_s << true;
    }

    void planIsJudged()
    {
        QFETCH(const Plan, plan);
        QFETCH(const QString, words);
        QFETCH(const bool, isWarned);
        ExportContent content = planContent(
            byDay(changed([](Scenario& s) { s.planner.policy = PolicyKind::Visitation; })));
        content.plan = plan;
        QCOMPARE(planWords(content, kEnglish), words);
        QCOMPARE(briefWarnings(content, kEnglish).size(), isWarned ? 1 : 0);
    }

    void oneLayerIsWarnedOf()
    {
        Scenario scenario = fleetScenario(2, 8);
        ExportOptions options;
        const auto warns = [&] {
            const QStringList warnings =
                briefWarnings(planContent(scenario, fleetPlan(2, 8), options), kEnglish);
            return warnings.join(u' ').contains(u"keep them 200 m apart"_s);
        };
        QVERIFY(!warns());
        options.altitude_m = 100; // altitude of both UAVs
        QVERIFY(warns());
        scenario.separation_m = 0;
        QVERIFY(!warns());
    }

    void idleUavsAreNamed()
    {
        const ExportContent content = planContent(fleetScenario(3, 4), [] {
            return Plan{.uavs = {{.uav = 0}, {.uav = 1, .order = {0, 1, 2, 3}}, {.uav = 2}}};
        }());
        QVERIFY(briefWarnings(content, kEnglish).contains(u"Nothing to visit for uav-1, uav-3"_s));
    }

    void icebergsNearTheAssetAreWarnedOf()
    {
        const ExportContent content = planContent(changed([](Scenario& s) {
            s.asset = Asset{
                .name = "Platform", .position_m = Point(2000, 0), .range_m = 2500, .extraJson = {}};
        }));
        // Inside half the range is berg-1 alone; berg-4 drifts towards the asset.
        const QStringList warnings = briefWarnings(content, kEnglish);
        QVERIFY2(!warnings.isEmpty(), "no warning");
        QVERIFY2(warnings[0].startsWith(u"berg-1 is inside the inner ring"_s),
                 qPrintable(warnings[0]));
    }

    void namesAreMadePrintable_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("printed");
        QTest::newRow("plain") << u"B 07"_s << u"B 07"_s;
        QTest::newRow("lines") << u" a\r\n\tb\u2028c\u0085 "_s << u"a b c"_s;
        QTest::newRow("turned") << u"\u202edesrever"_s << u"desrever"_s;
        QTest::newRow("marks") << u"a\u0301\u0302\u0303\u0304b"_s << u"a\u0301\u0302b"_s;
        QTest::newRow("Hebrew") << u"קרח"_s << u"\u2068קרח\u2069"_s;
        QTest::newRow("beyond the first plane") << u"\U0001F9CA"_s << u"\U0001F9CA"_s;
    }

    void namesAreMadePrintable()
    {
        QFETCH(const QString, name);
        QFETCH(const QString, printed);
        QCOMPARE(printable(name), printed);
        QCOMPARE(printable(printed), printed);
    }
};

QTEST_MAIN(TestBriefWarnings)
#include "tst_brief_warnings.moc"
