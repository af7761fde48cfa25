#include "core/io/export/missions/plan_wpl.h"
#include "core/mission/visits.h"
#include "tests/support/files/german_numbers.h"
#include "tests/support/files/golden.h"
#include "tests/support/files/wpl_readers.h"
#include "tests/support/flight/mission_builder.h"

#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

QByteArray planText(const Scenario& scenario, const Plan& plan = fourIcebergPlan())
{
    return bytes(wplText(planContent(scenario, plan)));
}

QByteArray runText(const Scenario& scenario)
{
    const Mission mission = flown(scenario);
    return bytes(wplText(runContent(mission)));
}

} // namespace

class TestPlanWpl : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void everyReaderReadsTheSame_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("items");
        Scenario scenario = fourIcebergs();
        QTest::newRow("plan") << planText(scenario) << 7;
        QTest::newRow("run") << runText(scenario)
                             << static_cast<int>(flownVisits(flown(scenario)).size()) + 3;
        scenario.uavs[0].spec.airspeed_mps = 22.5;
        scenario.uavs[0].spec.altitude_m = 99.9;
        QTest::newRow("fractions") << planText(scenario) << 7;
        QTest::newRow("loiter, and home at the end")
            << bytes(wplText(planContent(scenario, fourIcebergPlan(),
                                         {.loiterTurns = 2, .returnHome = true})))
            << 7;
        QTest::newRow("first leg") << bytes(wplText(planContent(scenario, fourIcebergPlan(),
                                                                {.what = ExportScope::FirstLeg})))
                                   << 4;
        scenario.icebergs.clear();
        QTest::newRow("no icebergs") << planText(scenario, planOf({})) << 3;
    }

    void everyReaderReadsTheSame()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, items);
        const WplMission first = readers().front().read(text);
        for (const WplReader& reader : readers()) {
            const WplMission mission = reader.read(text);
            QVERIFY2(mission.fault.isEmpty(), qPrintable(reader.name + mission.fault));
            QCOMPARE(static_cast<int>(mission.rows.size()), items + 1);
            QVERIFY2(mission.rows == first.rows, qPrintable(reader.name));
        }
        QCOMPARE(first.rows[0], (WplRow{.index = 0,
                                        .current = 1,
                                        .frame = 0,
                                        .command = 16,
                                        .numbers = {0, 0, 0, 0, first.rows[0].numbers[4],
                                                    first.rows[0].numbers[5], 0},
                                        .autocontinue = 1}));
        QCOMPARE(first.rows[1].command, 22);
        QCOMPARE(first.rows[2].command, 178);
        const bool waits = first.rows.back().command == 17; // after the first leg
        QVERIFY(waits || first.rows.back().command == 20);
        for (std::size_t row = 1; row < first.rows.size(); ++row) {
            const WplRow& item = first.rows[row];
            QCOMPARE(item.index, static_cast<int>(row));
            QCOMPARE(item.current, 0);
            QCOMPARE(item.autocontinue, 1);
            QCOMPARE(item.frame, item.command == 178 || item.command == 20 ? 2 : 3);
        }
    }

    void bytesSatisfyTheStrictestReader()
    {
        const QByteArray text = planText(fourIcebergs());
        QVERIFY(text.startsWith("QGC WPL 110\n"));
        QVERIFY(text.endsWith('\n'));
        QVERIFY(!text.endsWith("\n\n"));
        QVERIFY(!text.contains('\r'));
        const QRegularExpression row(QStringLiteral(
            "^\\d+\\t[01]\\t[023]\\t\\d+(\\t-?\\d+(\\.\\d+)?){4}(\\t-?\\d+\\.\\d{8,}){2}"
            "\\t\\d+(\\.\\d+)?\\t1$"));
        const QList<QByteArray> lines = text.split('\n');
        for (qsizetype i = 1; i + 1 < lines.size(); ++i)
            QVERIFY2(row.match(QString::fromLatin1(lines[i])).hasMatch(), lines[i].constData());
    }

    void readersReject_data()
    {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<QStringList>("readersThatFail");
        const QString qgc = QStringLiteral("QGroundControl");
        const QString pymavlink = QStringLiteral("pymavlink");
        const QString planner = QStringLiteral("Mission Planner");
        const QString mavsdk = QStringLiteral("MAVSDK");
        QTest::newRow("version 120") << QByteArray("QGC WPL 110") << QByteArray("QGC WPL 120")
                                     << QStringList{qgc, pymavlink, mavsdk};
        QTest::newRow("other header") << QByteArray("QGC WPL 110") << QByteArray("waypoints")
                                      << QStringList{qgc, pymavlink, planner, mavsdk};
        QTest::newRow("comment") << QByteArray("\n1\t") << QByteArray("\n# by hand\n1\t")
                                 << QStringList{qgc};
        QTest::newRow("blank line")
            << QByteArray("\n1\t") << QByteArray("\n\n1\t") << QStringList{qgc};
        QTest::newRow("spaces for tabs")
            << QByteArray("\t") << QByteArray(" ") << QStringList{qgc, mavsdk};
        QTest::newRow("eleven columns")
            << QByteArray("\t1\n2\t") << QByteArray("\n2\t") << QStringList{qgc, pymavlink, mavsdk};
        QTest::newRow("comma decimals")
            << QByteArray(".") << QByteArray(",") << QStringList{qgc, pymavlink, planner, mavsdk};
        QTest::newRow("no home row")
            << QByteArray("\n0\t1\t0\t16") << QByteArray("\n7\t1\t0\t16") << QStringList{planner};
    }

    void readersReject()
    {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QFETCH(QStringList, readersThatFail);
        const QByteArray good = planText(fourIcebergs());
        QVERIFY(good.contains(from));
        QByteArray text = good;
        text.replace(from, to);
        // A reader rejects the text if it reports an error or reads a mission other than the
        // original.
        QStringList failed;
        for (const WplReader& reader : readers()) {
            const WplMission mission = reader.read(text);
            if (!mission.fault.isEmpty() || mission.rows != reader.read(good).rows)
                failed << reader.name;
        }
        QCOMPARE(failed, readersThatFail);
    }

    void localeDoesNotMatter()
    {
        const QByteArray expected = planText(fourIcebergs());
        const GermanNumbers german;
        QVERIFY(planText(fourIcebergs()) == expected);
    }

    void textMatchesTheGoldenFile()
    {
        const QByteArray actual = planText(fourIcebergs());
        const QByteArray expected =
            berg::test::golden(QStringLiteral("four_icebergs.waypoints"), actual);
        // 1e-9 of 47 degrees is 5 mm: rounding of another processor, not another place.
        const QString found = tableDifference(actual, expected, '\t', 1e-9);
        QVERIFY2(found.isEmpty(), qPrintable(found));
    }
};

QTEST_APPLESS_MAIN(TestPlanWpl)
#include "tst_plan_wpl.moc"
