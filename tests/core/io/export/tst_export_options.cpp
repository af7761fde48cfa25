// Tests of user options: options without effect on a file are noted, and only those.

#include "core/io/export/export_notes.h"
#include "core/io/text/ogr2ogr.h"
#include "tests/support/files/export_fixtures.h"

#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

QStringList notUsed(const ExportFormat& row, const ExportContent& content)
{
    QStringList options;
    for (const ExportNote& note : exportNotes(row, content))
        if (note.kind == ExportNoteKind::OptionNotUsed)
            options << QString::fromLatin1(note.tool.data(), qsizetype(note.tool.size()));
    return options;
}

/** Options, one at a time, each different from the value in `fourIcebergs`. */
std::vector<ExportOptions> eachOption()
{
    return {{.altitude_m = 333},
            {.airspeed_mps = 31},
            {.acceptance_m = 77},
            {.loiterTurns = 3},
            {.returnHome = true}};
}

} // namespace

class TestExportOptions : public QObject
{
    Q_OBJECT

private slots:
    /** The note appears if and only if the file is the same without the option. */
    void notesAreTrue_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<int>("what");
        for (const ExportFormat& row : exportFormats())
            for (const auto& [what, name] : kExportScopeNames)
                if (!row.holds.painted && !(row.holds.gis && ogr2ogrPath().empty()))
                    QTest::addRow("%s, %s", row.id.data(), name.data())
                        << QString::fromLatin1(row.id.data(), qsizetype(row.id.size()))
                        << static_cast<int>(what);
    }

    void notesAreTrue()
    {
        QFETCH(QString, id);
        QFETCH(int, what);
        const ExportFormat& row = *findExportFormat(id.toStdString());
        const Mission mission = flown(fourIcebergs(), 1500);
        QVERIFY(mission.visits(0) > 0); // otherwise there is nothing to circle over
        const Plan plan;
        const auto contentOf = [&](ExportOptions options) {
            options.what = static_cast<ExportScope>(what);
            return row.content({.scenario = mission.scenario(), .plan = plan, .mission = &mission},
                               options);
        };
        const std::string plain = row.text(contentOf({}));
        QVERIFY(notUsed(row, contentOf({})).isEmpty());
        for (const ExportOptions& options : eachOption()) {
            const ExportContent content = contentOf(options);
            const QStringList unused = notUsed(row, content);
            QCOMPARE(unused.size(), row.text(content) == plain ? 1 : 0);
        }
    }

    /** A path avoids areas that are closed at its altitude, and volumes have heights. */
    void altitudeMatters()
    {
        const ExportOptions options{.what = ExportScope::Path, .altitude_m = 333};
        const ExportFormat& csv = *findExportFormat("csv");
        const ExportFormat& map = *findExportFormat("map-svg");
        const auto unused = [&](const ExportFormat& row, const Scenario& scenario) {
            return notUsed(row, planContent(scenario, fourIcebergPlan(), options)).join(u' ');
        };
        const QString altitude = QStringLiteral("altitude");
        QCOMPARE(unused(csv, fourIcebergs()), altitude);
        QCOMPARE(unused(map, fourIcebergs()), altitude);
        const Scenario low = changed([](Scenario& s) {
            s.noFly = {{.corners_m = {{9000, 0}, {9500, 0}, {9500, 500}}, .ceiling_m = 200}};
        });
        QCOMPARE(unused(csv, low), QString());
        QCOMPARE(unused(map, low), QString());
        const Scenario volume = changed([](Scenario& s) { s.operation = Operation{}; });
        QCOMPARE(unused(csv, volume), altitude);
        QCOMPARE(unused(map, volume), QString());
    }

    /**
     * With turns over icebergs the acceptance radius is unused; a file about the flight uses no
     * option.
     */
    void severalUnusedOptionsAreNoted()
    {
        const ExportOptions options{
            .altitude_m = 333, .acceptance_m = 77, .loiterTurns = 3, .returnHome = false};
        const ExportContent content = planContent(fourIcebergs(), fourIcebergPlan(), options);
        const auto unused = [&](const char* id) {
            return notUsed(*findExportFormat(id), content).join(u' ');
        };
        QCOMPARE(unused("plan"), QStringLiteral("acceptance"));
        QCOMPARE(unused("brief"), QString());
        QCOMPARE(unused("gpx"), QStringLiteral("acceptance loiter"));
        QCOMPARE(unused("csv"), QStringLiteral("altitude acceptance loiter no-return-home"));
        QCOMPARE(unused("log"), QStringLiteral("altitude acceptance loiter no-return-home"));
        const ExportContent one =
            planContent(fourIcebergs(), fourIcebergPlan(), {.uav = fourIcebergs().uavs[0].id});
        QCOMPARE(notUsed(*findExportFormat("zeta-csv"), one).join(u' '), QStringLiteral("uav"));
        QVERIFY(notUsed(*findExportFormat("csv"), one).isEmpty());
    }

    /** The log concerns the whole flight, so its map always shows the flown track. */
    void formatsOfAWholeFlightIgnoreOptions()
    {
        const Mission mission = flown(fourIcebergs(), 60);
        const Plan plan;
        const ExportSource source{
            .scenario = mission.scenario(), .plan = plan, .mission = &mission};
        const ExportContent content = findExportFormat("log")->content(
            source, {.what = ExportScope::Path, .altitude_m = 333});
        QVERIFY(content.what == ExportScope::Track);
        QVERIFY(content.uavs[0].uav.spec.altitude_m != 333);
        QVERIFY_THROWS_EXCEPTION(Error,
                                 (void)findExportFormat("log")->content(source, {.uav = "nobody"}));
    }
};

QTEST_APPLESS_MAIN(TestExportOptions)

#include "tst_export_options.moc"
