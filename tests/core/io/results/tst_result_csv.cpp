#include "core/base/angles.h"
#include "core/io/export/missions/plan_csv.h"
#include "core/io/results/result_csv.h"
#include "core/mission/visits.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/flight_tables.h"
#include "tests/support/files/german_numbers.h"
#include "tests/support/files/golden.h"
#include "tests/support/flight/mission_builder.h"

#include <QTest>

#include <cmath>

using namespace berg;
using namespace berg::test;

namespace {

using Record = QList<QByteArray>;

/**
 * An independent reader of RFC 4180: quoted fields may hold separators, line ends and doubled
 * quotes.
 */
QList<Record> csvRecords(const QByteArray& text)
{
    QList<Record> records;
    Record record;
    QByteArray field;
    bool quoted = false;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
            field += text[++i];
        } else if (c == '"') {
            quoted = !quoted;
        } else if (!quoted && (c == ',' || c == '\n')) {
            record << field;
            field.clear();
            if (c == '\n') {
                records << record;
                record.clear();
            }
        } else {
            field += c;
        }
    }
    return records;
}

QList<Record> csvRecords(const std::string& text)
{
    return csvRecords(bytes(text));
}

} // namespace

class TestResultCsv : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    /** A spreadsheet would run these texts; an import removes the apostrophe. */
    void formulasBecomeTexts()
    {
        QCOMPARE(csvField("=1+1"), std::string("'=1+1"));
        QCOMPARE(csvField("@a,b"), std::string("\"'@a,b\""));
        QCOMPARE(csvField("-x"), std::string("'-x"));
        QCOMPARE(csvField("a=1"), std::string("a=1"));
        QCOMPARE(csvField("a\x1b[31m\x7F\u009b\u00e5"),
                 std::string("a\uFFFD[31m\uFFFD\uFFFD\u00e5"));
    }

    void fieldsAreQuotedIfNecessary_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("field");
        QTest::newRow("plain") << QByteArray("berg-1") << QByteArray("berg-1");
        QTest::newRow("empty") << QByteArray() << QByteArray();
        QTest::newRow("spaces and UTF-8") << QByteArray(" \xC3\x85 ") << QByteArray(" \xC3\x85 ");
        QTest::newRow("comma") << QByteArray("a,b") << QByteArray("\"a,b\"");
        QTest::newRow("quote") << QByteArray("a\"b") << QByteArray("\"a\"\"b\"");
        QTest::newRow("line feed") << QByteArray("a\nb") << QByteArray("\"a\nb\"");
        QTest::newRow("carriage return") << QByteArray("a\rb") << QByteArray("\"a\rb\"");
    }

    void fieldsAreQuotedIfNecessary()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, field);
        QCOMPARE(bytes(csvField(text.toStdString())), field);
        QCOMPARE(csvRecords(field + '\n'), (QList<Record>{{text}}));
    }

    void trajectoryHoldsTheSamples()
    {
        const Mission mission = flown(fourIcebergs());
        const QList<Record> records = csvRecords(trajectoryCsv(mission));
        const std::vector<Sample>& samples = mission.recorder().samples();
        QCOMPARE(records[0].join(','),
                 QByteArray("time_s,uav,east_m,north_m,latitude_deg,longitude_deg,heading_deg,"
                            "turn_rate_radps,cross_track_m"));
        QCOMPARE(records.size(), static_cast<qsizetype>(samples.size()) + 1);
        const LocalFrame frame(mission.scenario().origin);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const Record& record = records[static_cast<qsizetype>(i) + 1];
            QCOMPARE(record.size(), 9);
            QCOMPARE(record[0].toDouble(), samples[i].time_s);
            QCOMPARE(record[1], QByteArray("uav-1"));
            QCOMPARE(record[2].toDouble(), samples[i].uavs[0].pose.position_m.x());
            QCOMPARE(record[3].toDouble(), samples[i].uavs[0].pose.position_m.y());
            const Point back_m = frame.toPlane(
                {.latitude_deg = record[4].toDouble(), .longitude_deg = record[5].toDouble()});
            // Rounding of degrees in a double, 1e-14 x 6.4e6 m, some times over.
            QVERIFY((back_m - samples[i].uavs[0].pose.position_m).norm() < 1e-6);
            QVERIFY(std::abs(wrapPi(psiFromHeading(record[6].toDouble()) -
                                    samples[i].uavs[0].pose.psi_rad)) < 1e-12);
            QCOMPARE(record[7].toDouble(), samples[i].uavs[0].u_radps);
            QCOMPARE(record[8].toDouble(), samples[i].uavs[0].crossTrack_m);
        }
        // Heading 45 degrees at the start.
        QVERIFY(std::abs(records[1][6].toDouble() - 45) < 1e-12);
    }

    void sigmaHoldsEveryIcebergThatHasAppeared()
    {
        Scenario scenario = fourIcebergs();
        scenario.icebergs[2].appears_s = 50;
        scenario.duration_s = 100;
        const Mission mission = flown(scenario);
        const Recorder& recorder = mission.recorder();
        const QList<Record> records = csvRecords(written(writeSigma, mission));
        QCOMPARE(records[0].join(','),
                 QByteArray("time_s,iceberg,sigma_m2,east_m,north_m,in_view"));
        qsizetype next = 1;
        for (std::size_t row = 0; row < recorder.samples().size(); ++row) {
            const double time_s = recorder.samples()[row].time_s;
            for (std::size_t i = 0; i < 4; ++i) {
                if (i == 2 && time_s < 50)
                    continue;
                const IcebergSample iceberg = recorder.icebergs(row)[i];
                const Record& record = records[next++];
                QCOMPARE(record.size(), 6);
                QCOMPARE(record[0].toDouble(), time_s);
                QCOMPARE(record[1], bytes(scenario.icebergs[i].id));
                QCOMPARE(record[2].toDouble(), iceberg.sigma_m2);
                QCOMPARE(record[3].toDouble(), iceberg.truth_m.x());
                QCOMPARE(record[4].toDouble(), iceberg.truth_m.y());
                QCOMPARE(record[5], QByteArray(iceberg.inView ? "1" : "0"));
                // In view and sigma 0 are equivalent here.
                QCOMPARE(record[5] == "1", record[2] == "0");
            }
        }
        QCOMPARE(records.size(), next);
        QCOMPARE(next, 1 + 4 * 101 - 50);
    }

    void eventsAreWrittenInOrder()
    {
        Scenario scenario = fourIcebergs();
        scenario.icebergs[3].id = "odd, \"id\"";
        Mission mission(scenario);
        mission.advance(50);
        Iceberg added;
        added.id = "added";
        added.position_m = Point(0, 3000);
        mission.intervene({.tau = 2, .appears = added});
        mission.advance(1e9);
        const QList<Record> records = csvRecords(written(writeEvents, mission));
        QCOMPARE(records[0].join(','), QByteArray("time_s,event,uav,iceberg,detail"));
        QCOMPARE(records.size(), static_cast<qsizetype>(mission.events().size()) + 1);
        QMap<QByteArray, int> count;
        double last_s = 0;
        for (qsizetype i = 1; i < records.size(); ++i) {
            const Record& record = records[i];
            const MissionEvent& event = mission.events()[static_cast<std::size_t>(i) - 1];
            QCOMPARE(record.size(), 5);
            QVERIFY(record[0].toDouble() >= last_s);
            last_s = record[0].toDouble();
            ++count[record[1]];
            QCOMPARE(record[2], QByteArray("uav-1"));
            const QByteArray id = event.iceberg
                                      ? bytes(mission.icebergs()[toIndex(*event.iceberg)].id)
                                      : QByteArray();
            QCOMPARE(record[3], id);
            QCOMPARE(record[4], bytes(eventDetail(event, mission)));
        }
        QCOMPARE(count["reached"], mission.metrics().visits);
        QCOMPARE(count["planned"], mission.metrics().replans);
        QCOMPARE(count["appeared"], 1);
        QCOMPARE(count["intervention"], 1);
        QVERIFY(count["sighted"] >= count["reached"]);
    }

    /** These texts are in files, so they must not change. */
    void detailsOfEventsAreStable_data()
    {
        QTest::addColumn<MissionEvent>("event");
        QTest::addColumn<QByteArray>("detail");
        const auto row = [](const MissionEvent& event, const char* detail) {
            QTest::addRow("%s", *detail == 0 ? "none" : detail) << event << QByteArray(detail);
        };
        row({.kind = EventKind::Planned, .source = AnswerSource::Exact}, "exact");
        row({.kind = EventKind::Planned, .source = AnswerSource::Exact, .fellBack = true},
            "last plan kept");
        row({.kind = EventKind::Reached, .iceberg = IcebergIndex(1), .together = {0, 2}},
            "with a, c");
        row({.kind = EventKind::Sighted, .iceberg = IcebergIndex(0)}, "");
        row({.kind = EventKind::Sighted, .iceberg = IcebergIndex(0), .reported = true}, "reported");
        row({.kind = EventKind::PlannerFailed, .failure = "no memory"}, "no memory");
        row({.kind = EventKind::Alarm, .iceberg = IcebergIndex(0), .entry_s = 1234.5}, "in 1235 s");
        row({.kind = EventKind::Intervention, .policy = PolicyKind::Nearest}, "nearest");
        row({.kind = EventKind::Intervention, .changed = ChangedPart::Wind}, "wind");
        row({.kind = EventKind::Intervention, .changed = ChangedPart::Asset}, "asset");
        row({.kind = EventKind::Intervention, .changed = ChangedPart::Assignment}, "assigned");
        row({.kind = EventKind::LeftFence, .uav = 0}, "");
        row({.kind = EventKind::Close, .uav = 0, .otherUav = 1, .distance_m = 142.6},
            "uav-2, 143 m");
    }

    void detailsOfEventsAreStable()
    {
        QFETCH(MissionEvent, event);
        Scenario scenario = fourIcebergs();
        scenario.uavs = {{.id = "uav-1"}, {.id = "uav-2"}};
        for (std::size_t i = 0; i < scenario.icebergs.size(); ++i)
            scenario.icebergs[i].id = std::string(1, static_cast<char>('a' + i));
        QTEST(bytes(eventDetail(event, Mission(scenario))), "detail");
    }

    void zetaEndsAtTheMetric()
    {
        const Mission mission = flown(fourIcebergs());
        const QList<Record> records = csvRecords(written(writeZeta, mission));
        QCOMPARE(records[0].join(','), QByteArray("time_s,sigma_sum_m2,zeta_m2s"));
        QCOMPARE(records.size(), 402); // 0 .. 400 s and the header
        QCOMPARE(records[1][2], QByteArray("0"));
        QCOMPARE(records.last()[0], QByteArray("400"));
        QCOMPARE(records.last()[2].toDouble(), mission.metrics().zeta_m2s);
    }

    void missionWithoutRecordGivesHeadersOnly()
    {
        Mission mission(fourIcebergs(), {.record = false});
        mission.advance(1e9);
        for (const std::string& text : {trajectoryCsv(mission), written(writeSigma, mission),
                                        written(writeEvents, mission), written(writeZeta, mission)})
            QCOMPARE(csvRecords(text).size(), 1);
    }

    void planTableHasTheOrder()
    {
        const Scenario scenario = fourIcebergs();
        const Plan plan = fourIcebergPlan();
        const QList<Record> records = csvRecords(planCsv(planContent(scenario, plan)));
        QCOMPARE(records[0].join(','),
                 QByteArray("sequence,iceberg,name,leg_m,arrival_s,latitude_deg,longitude_deg,"
                            "east_m,north_m,sigma_now_m2,sigma_at_arrival_m2,uav,chance_in_view"));
        QCOMPARE(records.size(), 5);
        const std::vector<Visit> visits = plannedVisits(scenario, plan);
        Point from_m = scenario.uavs[0].position_m;
        for (std::size_t i = 0; i < visits.size(); ++i) {
            const Record& record = records[static_cast<qsizetype>(i) + 1];
            const Iceberg& iceberg = scenario.icebergs[toIndex(visits[i].iceberg.value())];
            QCOMPARE(record.size(), 13);
            QCOMPARE(record[11], QByteArray("uav-1"));
            QCOMPARE(record[12].toDouble(), 1.0); // 300 m to each side, 5 m of deviation
            QCOMPARE(record[0].toInt(), static_cast<int>(i) + 1);
            QCOMPARE(record[1], bytes(iceberg.id));
            QCOMPARE(record[2], bytes(iceberg.name));
            QCOMPARE(record[3].toDouble(), (visits[i].position_m - from_m).norm());
            QCOMPARE(record[4].toDouble(), visits[i].time_s);
            QCOMPARE(record[7].toDouble(), visits[i].position_m.x());
            QCOMPARE(record[8].toDouble(), visits[i].position_m.y());
            from_m = visits[i].position_m;
        }
        // berg-4: 5.5 m^2 and 100 s old at 0.025 m^2/s, second of the order.
        QCOMPARE(records[2][9].toDouble(), 8.0);
        QCOMPARE(records[2][10].toDouble(), 8.0 + 0.025 * records[2][4].toDouble());
    }

    void formatTableChoosesPlanOrTrack()
    {
        const Scenario scenario = fourIcebergs();
        const Mission mission = flown(scenario);
        const Plan plan = fourIcebergPlan();
        const ExportFormat* csv = findExportFormat("csv");
        QVERIFY(csv != nullptr);
        QCOMPARE(csv->write({.scenario = scenario, .plan = plan}),
                 planCsv(planContent(scenario, plan)));
        QCOMPARE(csv->write({.scenario = scenario, .plan = plan, .mission = &mission}),
                 trajectoryCsv(mission));
        const ExportFormat* zeta = findExportFormat("zeta-csv");
        QVERIFY(zeta != nullptr);
        QCOMPARE(zeta->write({.scenario = scenario, .plan = plan, .mission = &mission}),
                 written(writeZeta, mission));
        const std::optional<Error> error =
            errorOf([&] { (void)zeta->write({.scenario = scenario, .plan = plan}); });
        QVERIFY(error && error->code() == ErrorCode::InvalidInput);
    }

    void localeDoesNotMatter()
    {
        const Mission mission = flown(fourIcebergs(), 20);
        const std::string expected = trajectoryCsv(mission);
        const GermanNumbers german;
        QVERIFY(trajectoryCsv(mission) == expected);
    }

    void tableMatchesTheGoldenFile()
    {
        const QByteArray actual = bytes(planCsv(planContent(fourIcebergs())));
        const QByteArray expected = berg::test::golden(QStringLiteral("four_icebergs.csv"), actual);
        // Tolerates the rounding of another processor.
        const QString found = tableDifference(actual, expected, ',', 1e-9);
        QVERIFY2(found.isEmpty(), qPrintable(found));
    }
};

QTEST_APPLESS_MAIN(TestResultCsv)
#include "tst_result_csv.moc"
