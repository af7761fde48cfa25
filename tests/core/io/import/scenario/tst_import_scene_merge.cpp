#include "core/checks/validate.h"
#include "core/io/export/missions/plan_qgc.h"
#include "tests/support/files/export_text.h"
#include "tests/support/files/import_fixtures.h"
#include "tests/support/flight/mission_builder.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;

namespace {

/** Returns GeoJSON of a Bergwatch export: a UAV, an iceberg and this text. */
std::string
own(const std::string& features,
    const std::string& numbers = R"("heading_deg": 90, "airspeed_mps": 20, "altitude_m": 120)")
{
    return R"({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"kind": "uav", "id": "u", )" +
           numbers + R"(}, "geometry": {"type": "Point", "coordinates": [-48, 47]}},
        {"type": "Feature", "properties": {"kind": "iceberg", "id": "b"},
         "geometry": {"type": "Point", "coordinates": [-48, 47]}})" +
           features + "]}";
}

std::string area(const std::string& geometry)
{
    return R"(, {"type": "Feature", "properties": {"kind": "area", "geofence": true}, "geometry": )" +
           geometry + "}";
}

std::string polygon(const std::string& rings)
{
    return area(R"({"type": "Polygon", "coordinates": )" + rings + "}");
}

} // namespace

/**
 * Tests which UAVs, area and asset of a file are applied, and what is reported about the others.
 */
class TestImportSetting : public QObject
{
    Q_OBJECT

private slots:
    /** A scenario in use gets icebergs only, and the result says so. */
    void scenarioInUseKeepsItsScene()
    {
        Scenario used = fourIcebergs();
        used.area_m.clear();
        const Scenario sent = twoUavsAndAsset();
        const Plan plan = planFromStart(sent);
        for (const std::string& text :
             {geoJson(planContent(sent, plan)), gpxText(planContent(sent, plan)),
              qgcPlan(planContent(sent, plan, {.uav = "ravn"}))}) {
            const ImportResult result = importSightings(used, readSightings(text, "export"));
            QVERIFY(notesOf(result) == std::vector{SceneNote::InUse});
            QVERIFY(result.scenario.uavs == used.uavs);
            QVERIFY(result.scenario.area_m.empty() && !result.scenario.asset);
        }
        const ImportResult plain = importSightings(used, readFixture("points.geojson"));
        QVERIFY(plain.scene.empty());
    }

    /** UAVs are matched by id, then in turn; values that the file does not give stay. */
    void existingUavsAreMatched()
    {
        Scenario base = openSea();
        base.uavs[0].id = "mine";
        base.uavs[0].turnaround_s = 42;
        base.uavs.push_back(base.uavs[0]);
        base.uavs[1].id = "ravn";
        base.uavs[1].spec.maxBank_deg = 33;
        base.uavs.push_back(base.uavs[0]);
        base.uavs[2].id = "third";
        const ImportResult result =
            importSightings(base, readSightings(geoJson(planContent(twoUavsAndAsset())), "export"));
        const std::vector<Uav>& uavs = result.scenario.uavs;
        QCOMPARE(uavs.size(), std::size_t{3});
        QCOMPARE(uavs[0].id, std::string("uav-1"));
        QCOMPARE(uavs[0].turnaround_s, 42.0);
        QCOMPARE(uavs[1].id, std::string("ravn"));
        QCOMPARE(uavs[1].spec.maxBank_deg, 33.0);
        QCOMPARE(uavs[1].spec.airspeed_mps, 24.25);
        QVERIFY(uavs[2] == base.uavs[2]);
    }

    /** New UAVs get ids that no iceberg has, so that no iceberg is left out. */
    void newUavsGetFreeIds()
    {
        const std::string uav = R"(, {"type": "Feature", "properties": {"kind": "uav",
            "airspeed_mps": 20}, "geometry": {"type": "Point", "coordinates": [-48, 47]}})";
        const std::string iceberg = R"(, {"type": "Feature", "properties": {"id": "uav-2"},
            "geometry": {"type": "Point", "coordinates": [-48, 47.1]}})";
        const ImportResult result = importedAsNew(own(uav + iceberg + uav));
        QCOMPARE(result.added, std::size_t{2});
        QCOMPARE(result.scenario.uavs[0].id, std::string("u"));
        QCOMPARE(result.scenario.uavs[1].id, std::string("uav-1"));
        QCOMPARE(result.scenario.uavs[2].id, std::string("uav-3"));
    }

    void numbersOutOfRangeAreReported()
    {
        const ImportResult result = importedAsNew(
            own(R"(, {"type": "Feature", "properties": {"kind": "asset", "range_m": -1,
                    "velocity_mps": [60, 0]},
                    "geometry": {"type": "Point", "coordinates": [-48, 47.01]}})",
                R"("airspeed_mps": 1e9, "altitude_m": 0, "heading_deg": "north")"));
        QCOMPARE(result.scenario.uavs[0].spec, UavSpec{});
        QVERIFY(result.scenario.asset);
        QCOMPARE(result.scenario.asset->range_m, Asset{}.range_m);
        QVERIFY(result.scenario.asset->velocity_mps == Point(0, 0));
        const auto wrong =
            std::find_if(result.scene.begin(), result.scene.end(),
                         [](const SceneFinding& f) { return f.note == SceneNote::NumberWrong; });
        QVERIFY(wrong != result.scene.end());
        QCOMPARE(wrong->detail, std::string("airspeed_mps 1000000000"));
        QCOMPARE(wrong->count, std::size_t{4});
    }

    void brokenAreasAreReported_data()
    {
        QTest::addColumn<QByteArray>("feature");
        QTest::addColumn<int>("note");
        const auto row = [](const char* name, const std::string& feature, SceneNote note) {
            QTest::newRow(name) << QByteArray::fromStdString(feature) << int(note);
        };
        const std::string square = "[[-48.1,46.9],[-47.9,46.9],[-47.9,47.1],[-48.1,47.1]]";
        row("no geometry", area("null"), SceneNote::AreaUnreadable);
        row("a point", area(R"({"type": "Point", "coordinates": [-48, 47]})"),
            SceneNote::AreaUnreadable);
        row("no rings", polygon("[]"), SceneNote::AreaUnreadable);
        row("words", polygon(R"([[["a", "b"]]])"), SceneNote::AreaUnreadable);
        row("half a place", polygon("[[[-48]]]"), SceneNote::AreaUnreadable);
        row("off the Earth", polygon("[[[-48,46.9],[-47.9,1e300],[-48,47.1]]]"),
            SceneNote::AreaUnreadable);
        row("nested too deep", polygon("[" + ("[" + square + "]") + "]"),
            SceneNote::AreaUnreadable);
        row("two corners", polygon("[[[-48,46.9],[-47.9,46.9]]]"), SceneNote::AreaCorners);
        row("no corners", polygon("[[]]"), SceneNote::AreaInParts);
        row("on a line", polygon("[[[-48,46.9],[-48,46.95],[-48,47]]]"), SceneNote::AreaCorners);
        row("crossing", polygon("[[[-48.1,46.9],[-47.9,47.1],[-47.9,46.9],[-48.1,47.1]]]"),
            SceneNote::AreaCrossing);
        row("far", polygon("[[[100,46.9],[101,46.9],[101,48]]]"), SceneNote::AreaTooFar);
        row("in parts",
            area(R"({"type": "MultiPolygon", "coordinates": [[)" + square +
                 "], [[[-47,46.9],[-46.9,46.9],[-46.9,47.1]]]]}"),
            SceneNote::AreaInParts);
        row("twice", polygon("[" + square + "]") + polygon("[" + square + "]"),
            SceneNote::AreasMore);
        row("with a hole", polygon("[" + square + ", [[-48,47],[-47.99,47],[-47.99,47.01]]]"),
            SceneNote::AreaHoles);
        row("not round the UAV", polygon("[[[-47.1,46.9],[-46.9,46.9],[-46.9,47.1]]]"),
            SceneNote::FenceOutside);
        std::string many;
        for (int i = 0; i < 30000; ++i)
            many += (i > 0 ? ",[" : "[") + std::to_string(-48 + 1e-5 * i) + ",46.9]";
        row("huge", polygon("[[" + many + "]]"), SceneNote::AreaCorners);
        std::string teeth = "[-48.1,46.9]";
        for (int i = 0; i < 300; ++i)
            teeth += ",[" + std::to_string(-48.1 + 1e-3 * i) + (i % 2 == 0 ? ",47.1]" : ",47.2]");
        row("more corners than a fence has", polygon("[[" + teeth + ",[-47.8,46.9]]]"),
            SceneNote::FenceCorners);
        std::string saw = "[-48.1,46.9]";
        for (int i = 0; i < 3000; ++i)
            saw += ",[" + std::to_string(-48.1 + 1e-4 * i) + (i % 2 == 0 ? ",47.1]" : ",47.2]");
        row("too many corners", polygon("[[" + saw + ",[-47.8,46.9]]]"), SceneNote::AreaCorners);
    }

    /** A faulty area is reported and does not affect other objects. */
    void brokenAreasAreReported()
    {
        QFETCH(QByteArray, feature);
        QFETCH(int, note);
        const ImportResult result = importedAsNew(own(feature.toStdString()));
        QVERIFY(has(result, SceneNote(note)));
        QCOMPARE(result.added, std::size_t{1});
        QCOMPARE(result.scenario.uavs[0].id, std::string("u"));
        QVERIFY(!hasErrors(validate(result.scenario)));
    }

    void tooManyUavsAreReported()
    {
        const std::string uav = R"(, {"geometry": {"type": "Point", "coordinates": [-48, 47]},
            "type": "Feature", "properties": {"kind": "uav", "airspeed_mps": 20}})";
        std::string uavs;
        for (int i = 0; i < 150; ++i)
            uavs += uav;
        const ImportResult result = importedAsNew(own(uavs));
        QCOMPARE(result.scenario.uavs.size(), kMostUavs);
        QVERIFY(has(result, SceneNote::UavsTooMany));
    }

    /** These are Bergwatch files that a user has edited. */
    void editedExportsAreImported_data()
    {
        QTest::addColumn<QByteArray>("file");
        for (const char* file : {"scene.geojson", "scene.kml", "scene.gpx"})
            QTest::newRow(file) << QByteArray(file);
    }

    void editedExportsAreImported()
    {
        QFETCH(QByteArray, file);
        const ImportResult result =
            importSightings(newScenarioForImport("new"), readFixture(file.toStdString()));
        QCOMPARE(result.scenario.uavs.size(), std::size_t{2});
        QCOMPARE(result.scenario.uavs[1].name, std::string("Ravn"));
        QVERIFY(result.scenario.asset && result.scenario.asset->name == "Hibernia");
        QCOMPARE(result.scenario.area_m.size(), file == "scene.gpx" ? 0 : std::size_t{4});
        QCOMPARE(has(result, SceneNote::AreaHoles), file != "scene.gpx");
    }
};

QTEST_APPLESS_MAIN(TestImportSetting)
#include "tst_import_scene_merge.moc"
