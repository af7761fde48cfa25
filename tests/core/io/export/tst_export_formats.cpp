// Tests of the table of formats: common requirements, and the notes of each format.

#include "core/io/export/content/thinned_path.h"
#include "core/io/export/export_files.h"
#include "core/io/export/export_notes.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/export_fixtures.h"
#include "tests/support/files/export_text.h"
#include "tests/support/files/geojson_view.h"
#include "tests/support/files/german_numbers.h"

#include <QTest>

#include <numeric>
#include <set>

using namespace berg;
using namespace berg::test;

namespace {

const ExportFormat& format(const char* id)
{
    const ExportFormat* found = findExportFormat(id);
    require(found != nullptr, id);
    return *found;
}

QStringList noteIds(const ExportFormat& row, const ExportContent& content)
{
    QStringList ids;
    for (const ExportNote& note : exportNotes(row, content)) {
        ids << QString::fromLatin1(note.id.data(), qsizetype(note.id.size()));
    }
    return ids;
}

std::string allTexts(const Mission& mission)
{
    std::string texts;
    for (const ExportFormat& row : exportFormats())
        if (!row.holds.painted && !row.holds.gis)
            texts += row.text(runContent(mission));
    return texts;
}

} // namespace

class TestExportFormats : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void tableListsEveryFormatOnce()
    {
        QStringList ids;
        for (const ExportFormat& row : exportFormats()) {
            ids << QString::fromLatin1(row.id.data(), qsizetype(row.id.size()));
            QCOMPARE(findExportFormat(row.id), &row);
            QVERIFY(!row.extension.empty() && !row.reader.empty());
            QCOMPARE(row.put == nullptr, row.holds.painted);
            QVERIFY(!row.holds.painted || row.holds.fleet); // a page shows all UAVs
        }
        QCOMPARE(ids.join(u' '),
                 QStringLiteral("plan wpl geojson csv sigma-csv decisions-csv "
                                "zeta-csv sightings gpx kml kmz czml shapefile gpkg gml dxf fgb brief map-pdf map-svg "
                                "map-png log log-html charts-pdf charts-svg charts-png"));
        QVERIFY(findExportFormat("mission") == nullptr);
    }

    /** Covers every format with various places, names and paths. */
    void isWellFormed_data() { exportRows(); }

    void isWellFormed()
    {
        QFETCH(QString, id);
        QFETCH(Scenario, scenario);
        QFETCH(ExportOptions, options);
        const ExportFormat& row = format(id.toLatin1().constData());
        IcebergList order(scenario.icebergs.size());
        std::iota(order.begin(), order.end(), IcebergIndex());
        const Plan plan = planOf(order);
        const std::string text =
            row.text(exportContent({.scenario = scenario, .plan = plan}, options));
        const QString fault = faultOf(id, text);
        QVERIFY2(fault.isEmpty(), qPrintable(fault));
    }

    void localeDoesNotMatter()
    {
        const Mission mission = flown(fourIcebergs(), 60);
        const std::string expected = allTexts(mission);
        const GermanNumbers german;
        QVERIFY(allTexts(mission) == expected);
    }

    void formatsOfOneUavGiveAFileForEach()
    {
        const ExportContent content = planContent(changed([](Scenario& s) {
            s.uavs.resize(3, s.uavs[0]);
            s.uavs[1].id = "../b c";
            s.uavs[2].id = "../b:c";
        }));
        const std::vector<ExportFile> files =
            exportFiles(format("plan"), content, "a.b/survey.plan");
        QCOMPARE(files.size(), std::size_t{3});
        QCOMPARE(files[0].path, std::string("a.b/survey-uav-1.plan"));
        QCOMPARE(files[1].path, std::string("a.b/survey-.._b_c.plan"));
        QCOMPARE(files[2].path, std::string("a.b/survey-.._b_c-3.plan"));
        QCOMPARE(exportFiles(format("wpl"), content, "a.b/survey")[0].path,
                 std::string("a.b/survey-uav-1"));
        QCOMPARE(exportFiles(format("gpx"), content, "x.gpx").size(), std::size_t{1});
        QVERIFY(noteIds(format("plan"), content).contains(QStringLiteral("one-file-each")));
        const Scenario scenario = changed([](Scenario& s) { s.uavs.resize(2, s.uavs[0]); });
        const Plan plan = fourIcebergPlan();
        const std::optional<Error> error =
            errorOf([&] { (void)format("wpl").write({.scenario = scenario, .plan = plan}); });
        QVERIFY(error && error->code() == ErrorCode::InvalidInput);
    }

    /** The painter gets both UAVs for one file, or the chosen one. */
    void painterGetsTheContentOfEachFile()
    {
        const ExportContent content =
            planContent(changed([](Scenario& s) { s.uavs.resize(2, s.uavs[0]); }),
                        fourIcebergPlan(), {.what = ExportScope::FirstLeg, .altitude_m = 90});
        std::vector<std::string_view> painted;
        const ExportPainter painter = [&](const ExportFormat& row, const ExportContent& given) {
            painted.push_back(row.id);
            return std::to_string(given.uavs.size()) + " UAVs at " +
                   std::to_string(int(given.uavs[0].uav.spec.altitude_m)) + " m";
        };
        for (const ExportFormat& row : exportFormats()) {
            if (!row.holds.painted)
                continue;
            const std::vector<ExportFile> files = exportFiles(row, content, "a/b.x", painter);
            QCOMPARE(files.size(), std::size_t{1});
            QCOMPARE(files[0].path, std::string("a/b.x"));
            QCOMPARE(files[0].content, std::string("2 UAVs at 90 m"));
            QVERIFY(painted == std::vector{row.id});
            painted.clear();
        }
        QVERIFY(exportFiles(format("kml"), content, "", painter)[0].content.starts_with("<?xml"));
        QVERIFY(painted.empty());
    }

    void withoutPainterNothingIsPainted()
    {
        const Scenario scenario = fourIcebergs();
        const Plan plan = fourIcebergPlan();
        const ExportContent content = planContent(scenario);
        for (const ExportFormat& row : exportFormats()) {
            if (!row.holds.painted)
                continue;
            const std::optional<Error> error =
                errorOf([&] { (void)exportFiles(row, content, "x"); });
            QVERIFY(error && error->code() == ErrorCode::Unsupported);
            QVERIFY(std::string_view(error->what()).find(row.id) != std::string_view::npos);
            QCOMPARE(codeOf([&] { (void)row.write({.scenario = scenario, .plan = plan}); }),
                     std::string("Unsupported"));
        }
    }

    void painterThatFailsEndsTheExport()
    {
        const ExportPainter painter = [](const ExportFormat&, const ExportContent&) -> std::string {
            throw Error(ErrorCode::InvalidInput, "format", "no room");
        };
        QCOMPARE(codeOf([&] {
                     (void)exportFiles(format("brief"), planContent(fourIcebergs()), "x", painter);
                 }),
                 std::string("InvalidInput"));
    }

    void notesOfPaintedFormats()
    {
        const ExportContent timeless = planContent(changed([](Scenario& s) {
            s.startUtc.clear();
            s.geofence = true;
            s.uavs[0].spec.airspeed_mps = 35.5;
        }));
        QCOMPARE(noteIds(format("brief"), timeless).join(u' '), QStringLiteral("no-times"));
        const Mission mission = flown(fourIcebergs(), 60);
        const ExportContent chosen = runContent(mission, {.what = ExportScope::Order});
        for (const char* ending : {"pdf", "svg", "png"}) {
            const ExportFormat& map = format((std::string("map-") + ending).c_str());
            const ExportFormat& charts = format((std::string("charts-") + ending).c_str());
            QVERIFY(noteIds(map, timeless).isEmpty()); // a map never has dates
            QCOMPARE(noteIds(map, planContent(fourIcebergs(), planOf({}))).join(u' '),
                     QStringLiteral("nothing-to-fly"));
            QCOMPARE(noteIds(charts, chosen).join(u' '), QStringLiteral("choice-not-used"));
            QVERIFY(noteIds(charts, runContent(mission)).isEmpty());
        }
    }

    void notesOfNoFlyAreas()
    {
        const ExportContent content = planContent(changed([](Scenario& s) {
            s.noFly = {{.corners_m = {{9000, 0}, {9500, 0}, {9500, 500}}}};
            s.uavs[0].spec.airspeed_mps = 22;
        }));
        const auto ids = [&](const char* name) { return noteIds(format(name), content); };
        QVERIFY(ids("gpx").contains(QStringLiteral("no-no-fly-areas")));
        QVERIFY(ids("wpl").contains(QStringLiteral("no-no-fly-areas")));
        for (const char* name : {"plan", "kml", "geojson", "czml"})
            QVERIFY(!ids(name).contains(QStringLiteral("no-no-fly-areas")));
        QVERIFY(!ids("plan").contains(QStringLiteral("no-heights")));
        const ExportContent high = planContent(changed([](Scenario& s) {
            s.asset = Asset{.position_m = {8000, 8000}, .standoff_m = 300, .standoffCeiling_m = 90};
        }));
        QVERIFY(noteIds(format("plan"), high).contains(QStringLiteral("no-heights")));
    }

    /** Straight legs do not avoid areas as a flight does; a note says so for all formats. */
    void legsThroughAreasAreNoted()
    {
        const auto walled = [](Scenario& s) {
            s.uavs[0].position_m = {0, 0};
            s.icebergs.resize(1);
            s.icebergs[0].position_m = {4000, 0};
            s.noFly = {{.corners_m = {{1900, -300}, {2100, -300}, {2100, 300}, {1900, 300}},
                        .floor_m = 100}};
        };
        Scenario scenario = changed(walled);
        const QString id = QStringLiteral("legs-cross");
        const auto isNoted = [&](const char* name, ExportScope what) {
            const ExportContent content =
                planContent(scenario, planFromStart(scenario), {.what = what});
            return noteIds(format(name), content).contains(id);
        };
        for (const char* name : {"plan", "kml", "gpx", "csv"})
            QVERIFY(isNoted(name, ExportScope::Order));
        QVERIFY(isNoted("plan", ExportScope::FirstLeg));
        QVERIFY(!isNoted("plan", ExportScope::Path));
        scenario.uavs[0].spec.altitude_m = 90; // the UAV is below the area
        QVERIFY(!isNoted("plan", ExportScope::Order));
    }

    void notesNameWhatIsLeftOut()
    {
        const Scenario scenario = changed([](Scenario& s) {
            s.startUtc.clear();
            s.geofence = true;
            s.uavs[0].spec.airspeed_mps = 35.5;
        });
        const ExportContent content = planContent(scenario);
        QCOMPARE(
            noteIds(format("plan"), content).join(u' '),
            QStringLiteral("acceptance-cut loiter-in-steps whole-speed return-added fence-off"));
        QCOMPARE(
            noteIds(format("wpl"), content).join(u' '),
            QStringLiteral("no-fence acceptance-cut loiter-in-steps whole-speed return-added"));
        QCOMPARE(noteIds(format("gpx"), content).join(u' '), QStringLiteral("no-times no-fence"));
        QCOMPARE(noteIds(format("kml"), content).join(u' '), QStringLiteral("no-times"));
        const std::vector<ExportNote> plan = exportNotes(format("plan"), content);
        for (const ExportNote& note : plan)
            QVERIFY(filledIn(notePattern(note.kind), noteArguments(note)).starts_with(note.tool));
        QCOMPARE(plan[0].value, 300.0);
        QCOMPARE(plan[0].limit, 255.0);
        QCOMPARE(plan[2].limit, 36.0);
        const ExportContent calm =
            planContent(fourIcebergs(), fourIcebergPlan(), {.acceptance_m = 90});
        QCOMPARE(noteIds(format("plan"), calm).join(u' '), QStringLiteral("return-added"));
        QCOMPARE(noteIds(format("gpx"), calm).join(u' '), QStringLiteral("option-not-used"));
        const Mission mission = flown(fourIcebergs(), 60);
        QCOMPARE(noteIds(format("wpl"), runContent(mission))[0], QStringLiteral("visits-only"));
        QCOMPARE(noteIds(format("zeta-csv"), runContent(mission, {.what = ExportScope::Path})),
                 QStringList(QStringLiteral("choice-not-used")));
        const ExportContent path =
            planContent(fourIcebergs(), fourIcebergPlan(), {.what = ExportScope::Path});
        QCOMPARE(noteIds(format("plan"), path).join(u' '),
                 QStringLiteral("path-as-waypoints return-added"));
        QCOMPARE(noteIds(format("plan"), planContent(fourIcebergs(), planOf({})))[0],
                 QStringLiteral("nothing-to-fly"));
        QVERIFY(noteIds(format("plan"), planContent(at180()))
                    .contains(QStringLiteral("fence-across-180")));
    }

    /** Ids that give two files the same name, and names that the disambiguation would produce. */
    void everyUavHasAFileOfItsOwn()
    {
        const ExportContent content = planContent(changed([](Scenario& s) {
            s.uavs.resize(3, s.uavs[0]);
            s.uavs[0].id = "a_b-3";
            s.uavs[1].id = "a b";
            s.uavs[2].id = "a_b";
        }));
        std::set<std::string> names;
        for (const ExportFile& file : exportFiles(format("plan"), content, "survey.plan"))
            names.insert(file.path);
        QCOMPARE(names.size(), std::size_t{3});
    }

    /** Only the first sortie of an order is exported; a note says so. */
    void laterSortiesAreNoted()
    {
        Scenario scenario = fourIcebergs();
        scenario.uavs[0].spec.endurance_s = 1e6;
        const ExportContent whole = planContent(scenario);
        QVERIFY(!noteIds(format("plan"), whole).contains(QStringLiteral("later-sorties")));
        scenario.uavs[0].spec.endurance_s = whole.uavs[0].visits.back().time_s;
        for (const ExportScope what : {ExportScope::Order, ExportScope::Path}) {
            const ExportContent content = planContent(scenario, fourIcebergPlan(), {.what = what});
            const std::size_t visits = content.uavs[0].visits.size();
            QVERIFY(visits > 1 && visits < 5);
            QCOMPARE(content.uavs[0].laterSorties, 5 - visits); // one of the visits is home
            for (const char* id : {"plan", "gpx", "brief"}) {
                const std::vector<ExportNote> notes = exportNotes(format(id), content);
                const auto note =
                    std::ranges::find(notes, ExportNoteKind::LaterSorties, &ExportNote::kind);
                QVERIFY(note != notes.end());
                QCOMPARE(note->value, double(content.uavs[0].laterSorties));
            }
        }
        const ExportContent first =
            planContent(scenario, fourIcebergPlan(), {.what = ExportScope::FirstLeg});
        QVERIFY(!noteIds(format("plan"), first).contains(QStringLiteral("later-sorties")));
    }

    void thinnedPathKeepsWithinTheTolerance()
    {
        std::vector<TimedPoint> circle;
        for (int i = 0; i <= 360; ++i)
            circle.push_back(
                {.position_m = 100 * Point(std::cos(i * M_PI / 180), std::sin(i * M_PI / 180)),
                 .time_s = double(i)});
        const std::vector<TimedPoint> corners = thinnedPath(circle, 5);
        // A chord of angle a deviates by r (1 - cos(a/2)): 5 m of 100 m at 36 degrees.
        QVERIFY(corners.size() >= 11 && corners.size() <= 20);
        for (const TimedPoint& point : circle) {
            double nearest_m = 1e9;
            for (std::size_t i = 1; i < corners.size(); ++i)
                nearest_m =
                    std::min(nearest_m, distanceToSegment(corners[i - 1].position_m,
                                                          corners[i].position_m, point.position_m));
            QVERIFY(nearest_m <= 5);
        }
        QCOMPARE(thinnedPath(std::span(circle).first(2), 5).size(), std::size_t{2});
        QVERIFY(thinnedPath({}, 5).empty());
    }

    void equalContentIsEqualBytes()
    {
        QVERIFY(zipFile("doc.kml", "<kml/>") == zipFile("doc.kml", "<kml/>"));
        QVERIFY(zipFile("doc.kml", "").starts_with("PK\x03\x04"));
    }

    /** Flies back and forth across the antimeridian, with more points than are held in memory. */
    void longTracksAreExportedCompletely()
    {
        Scenario scenario = at180();
        scenario.startUtc = "2026-03-01T06:00:00Z";
        const Mission mission = flown(scenario, 10);
        ExportContent content = runContent(mission);
        std::vector<TrackPoint> points;
        for (int i = 0; i < 4'000; ++i)
            points.push_back({.time_s = 1.0 * i,
                              .state = {.position_m = {5000 * std::sin(0.1 * i) + 2000, 0.1 * i}}});
        content.uavs.front().track = TrackPoints(points);
        const auto count = [&content](const char* id, const QString& what) {
            return QString::fromStdString(findExportFormat(id)->text(content)).count(what);
        };
        const qsizetype parts = count("kml", QStringLiteral("<gx:Track>"));
        QVERIFY(parts > 100);
        QCOMPARE(count("csv", QStringLiteral("\n")), 4'001);
        QCOMPARE(count("gpx", QStringLiteral("<trkpt ")), 4'000);
        QCOMPARE(count("gpx", QStringLiteral("<trkseg>")), parts);
        // There is a vertex on either side of the border at each crossing.
        const qsizetype vertices = 4'000 + 2 * (parts - 1);
        QCOMPARE(count("kml", QStringLiteral("<gx:coord>")), vertices);
        QCOMPARE(count("kml", QStringLiteral("</when>\n")), vertices);
        const QByteArray json = bytes(geoJson(content)); // as many times as places
        QCOMPARE(geojsonFault(json), QString());
        qsizetype places = 0;
        for (const QJsonArray& part : berg::test::parts(features(json, QStringLiteral("track"))[0]))
            places += part.size();
        QCOMPARE(places, vertices);
        const std::string kmz = kmzFile(content);
        ReadBudget budget("track.kmz", kmz.size());
        QVERIFY(unzipped(kmz, ".kml", budget) == kmlText(content));
    }

    /** Every format that has a place for areas holds every object, each with its kind. */
    void mapsHoldTheSameObjects_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<QString>("kind");
        QTest::newRow("geojson") << u"geojson"_s << u"\"kind\":\"%1\""_s;
        QTest::newRow("czml") << u"czml"_s << u"\"kind\":\"%1\""_s;
        QTest::newRow("kml") << u"kml"_s << u"\"kind\"><value>%1</value>"_s;
    }

    void mapsHoldTheSameObjects()
    {
        QFETCH(QString, id);
        QFETCH(QString, kind);
        const QString text = QString::fromStdString(
            format(id.toLatin1().constData()).text(planContent(hostile(), fourIcebergPlan())));
        const std::vector<std::pair<QString, int>> expected{{u"area"_s, 1},
                                                            {u"no-fly"_s, 1},
                                                            {u"stand-off"_s, 1},
                                                            {u"airspace"_s, 1},
                                                            {u"flight-geography"_s, 1},
                                                            {u"contingency-volume"_s, 1},
                                                            {u"asset"_s, 1},
                                                            {u"ground-risk-buffer"_s, 1},
                                                            {u"adjacent-area"_s, 1},
                                                            {u"iceberg"_s, 4},
                                                            {u"visit"_s, 4},
                                                            {u"plan"_s, 1}};
        for (const auto& [name, count] : expected)
            QVERIFY2(text.count(kind.arg(name)) == count, qPrintable(name));
        QVERIFY(text.contains(u"from_utc"_s) && text.contains(u"2026-01-01T00:00Z"_s));
    }

    /** Airspace of CZML extends from its floor upwards, and the volume up to its height. */
    void czmlHasHeightsOfAirspace()
    {
        const ExportContent content = planContent(hostile());
        const QJsonArray packets =
            QJsonDocument::fromJson(bytes(format("czml").text(content))).array();
        const auto polygon = [&packets](const char* id) {
            for (const QJsonValue& packet : packets)
                if (packet["id"_L1].toString() == QLatin1StringView(id))
                    return packet["polygon"_L1].toObject();
            return QJsonObject();
        };
        const QJsonObject airspace = polygon("airspace/0");
        QCOMPARE(airspace["height"_L1].toDouble(), 900.0);
        QCOMPARE(airspace["extrudedHeight"_L1].toDouble(), 1800.0); // twice the floor, for drawing
        QCOMPARE(airspace["positions"_L1]["cartographicDegrees"_L1].toArray().size(), 9);
        const QJsonObject volume = polygon("contingency-volume");
        QCOMPARE(volume["height"_L1].toDouble(), 0.0);
        QCOMPARE(volume["extrudedHeight"_L1].toDouble(),
                 *content.operation->top_m(VolumePart::Contingency));
    }

    void textMatchesTheGoldenFile_data()
    {
        QTest::addColumn<QString>("id");
        for (const char* id : {"gpx", "kml", "czml"})
            QTest::newRow(id) << QString::fromLatin1(id);
    }

    void textMatchesTheGoldenFile()
    {
        QFETCH(QString, id);
        const std::string text =
            format(id.toLatin1().constData())
                .text(planContent(changed([](Scenario& s) { s.geofence = true; }),
                                  fourIcebergPlan(), {.returnHome = true}));
        const QByteArray expected = berg::test::golden(u"four_icebergs."_s + id, bytes(text));
        // Numbers may differ by the rounding of another processor, 1e-9 of 48 degrees: 5 mm.
        const QString found = numbersDifference(bytes(text), expected, 1e-9);
        QVERIFY2(found.isEmpty(), qPrintable(found));
    }
};

QTEST_APPLESS_MAIN(TestExportFormats)
#include "tst_export_formats.moc"
