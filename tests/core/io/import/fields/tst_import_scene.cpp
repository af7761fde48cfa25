#include "core/checks/validate.h"
#include "core/io/export/missions/plan_qgc.h"
#include "core/io/export/missions/plan_wpl.h"
#include "core/io/files/scenario_json.h"
#include "tests/support/approx.h"
#include "tests/support/files/export_fixtures.h"
#include "tests/support/files/export_text.h"
#include "tests/support/files/import_fixtures.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;

namespace {

// Places are exported to 1e-9 degrees and imported to a centimetre.
constexpr double kPlace_m = 0.011;

/** Parts of a scene that a format can hold. */
struct SceneFormat
{
    const char* name;
    std::string (*write)(const ExportContent&);
    bool mission = false; ///< one UAV: its home, altitude and speed
    bool area = true;
    bool asset = true;
};

constexpr std::array kFormats{
    SceneFormat{.name = "geojson", .write = geoJson},
    SceneFormat{.name = "kml", .write = kmlText},
    SceneFormat{.name = "gpx", .write = gpxText, .area = false},
    SceneFormat{.name = "plan", .write = qgcPlan, .mission = true, .asset = false},
    SceneFormat{.name = "wpl", .write = wplText, .mission = true, .area = false, .asset = false},
};

Scenario shipped(const char* file)
{
    return loadScenario(std::string(BERG_SOURCE_DIR "/resources/scenarios/") + file);
}

Scenario with(Scenario scenario, const LatLon& origin)
{
    scenario.origin = origin;
    return scenario;
}

/** Distance between places of two planes. */
double apart_m(const ExportContent& content, const Point& at_m, const Scenario& found,
               const Point& found_m)
{
    const LatLon place = LocalFrame(found.origin).toGeographic(found_m);
    return (content.frame.toPlane(place) - at_m).norm();
}

QString lossOfUav(const SceneFormat& format, const ExportContent& content, const ExportUav& sent,
                  const Scenario& scenario, const Uav& found)
{
    const Point home_m = found.home_m.value_or(found.position_m);
    if (apart_m(content, sent.home_m, scenario, home_m) > kPlace_m)
        return u"home"_s;
    if (sent.uav.spec.altitude_m != found.spec.altitude_m)
        return u"altitude"_s;
    if (sent.uav.spec.airspeed_mps != found.spec.airspeed_mps)
        return u"speed"_s;
    if (format.mission)
        return {};
    if (apart_m(content, sent.uav.position_m, scenario, found.position_m) > kPlace_m)
        return u"start"_s;
    const LatLon place = content.frame.toGeographic(sent.uav.position_m);
    const double north_rad = LocalFrame(scenario.origin).trueNorth_rad(place);
    const double turned_deg = found.heading_deg + north_rad * 180 / M_PI -
                              trueHeading_deg(content, sent.uav.heading_deg, sent.uav.position_m);
    if (std::abs(std::remainder(turned_deg, 360.0)) > 1e-5)
        return u"heading"_s;
    return sent.uav.id == found.id && sent.uav.name == found.name ? QString() : u"id or name"_s;
}

QString lossOfArea(const ExportContent& content, const Scenario& found)
{
    if (content.area_m.size() != found.area_m.size())
        return u"corners"_s;
    for (const Point& corner_m : content.area_m)
        if (std::none_of(found.area_m.begin(), found.area_m.end(), [&](const Point& found_m) {
                return apart_m(content, corner_m, found, found_m) <= kPlace_m;
            }))
            return u"a corner"_s;
    return found.geofence == content.geofence ? QString() : u"fence"_s;
}

QString lossOfAsset(const ExportContent& content, const Scenario& found)
{
    if (content.asset.has_value() != found.asset.has_value())
        return u"asset"_s;
    if (!content.asset)
        return {};
    const Point place_m = assetPlace_m(content);
    if (apart_m(content, place_m, found, found.asset->position_m) > kPlace_m)
        return u"place of the asset"_s;
    if (content.asset->name != found.asset->name)
        return u"name of the asset"_s;
    // The heading uses the file's place: near a pole the rounding of the place would turn it.
    const LatLon place = content.frame.toGeographic(place_m);
    const double north_rad = LocalFrame(found.origin).trueNorth_rad(place);
    const Point velocity_mps = turned(found.asset->velocity_mps, -north_rad);
    if ((velocity_mps - eastNorth_mps(content, content.asset->velocity_mps, place_m)).norm() > 1e-6)
        return u"velocity of the asset"_s;
    return content.asset->range_m == found.asset->range_m ? QString() : u"range"_s;
}

QString lossOf(const SceneFormat& format, const ExportContent& content, const Scenario& found)
{
    if (content.uavs.size() != found.uavs.size())
        return u"UAVs"_s;
    for (std::size_t i = 0; i < content.uavs.size(); ++i)
        if (const QString loss = lossOfUav(format, content, content.uavs[i], found, found.uavs[i]);
            !loss.isEmpty())
            return loss + u" of UAV %1"_s.arg(i);
    if (format.area)
        if (const QString loss = lossOfArea(content, found); !loss.isEmpty())
            return loss;
    return format.asset ? lossOfAsset(content, found) : QString();
}

} // namespace

/** Tests that the scene of an export is restored in a new scenario. */
class TestImportScene : public QObject
{
    Q_OBJECT

private slots:
    void sceneIsReadBack_data()
    {
        QTest::addColumn<int>("format");
        QTest::addColumn<Scenario>("scenario");
        QTest::addColumn<ExportOptions>("options");
        Scenario timeless = twoUavsAndAsset();
        timeless.startUtc.clear();
        Scenario unnamed = twoUavsAndAsset();
        unnamed.asset->name.clear();
        const std::vector<std::pair<const char*, Scenario>> scenarios{
            {"two UAVs", twoUavsAndAsset()},
            {"no start", timeless},
            {"unnamed asset", unnamed},
            {"across 180", with(twoUavsAndAsset(), {.latitude_deg = 70, .longitude_deg = 179.95})},
            {"North Pole", with(twoUavsAndAsset(), {.latitude_deg = 90, .longitude_deg = 0})},
            {"South Pole", with(twoUavsAndAsset(), {.latitude_deg = -89.99, .longitude_deg = 180})},
            {"Fram Strait", shipped("fram-strait-endurance.berg")},
            {"Hibernia", shipped("hibernia-asset.berg")},
            {"Svalbard", shipped("svalbard-two-uavs.berg")},
            {"Melville Bay", shipped("melville-bay-three-uavs.berg")}};
        for (int i = 0; i < int(kFormats.size()); ++i)
            for (const auto& [name, scenario] : scenarios) {
                const auto row = [&, name = name, scenario = scenario](
                                     const char* what, const ExportOptions& options) {
                    QTest::addRow("%s, %s, %s", kFormats[std::size_t(i)].name, name, what)
                        << i << scenario << options;
                };
                row("order", {});
                row("path", {.what = ExportScope::Path, .altitude_m = 77, .airspeed_mps = 30});
            }
    }

    void sceneIsReadBack()
    {
        QFETCH(int, format);
        QFETCH(Scenario, scenario);
        QFETCH(ExportOptions, options);
        const SceneFormat& row = kFormats[std::size_t(format)];
        if (row.mission)
            options.uav = scenario.uavs.front().id;
        const ExportContent content = planContent(scenario, planFromStart(scenario), options);
        const ImportResult result = importedAsNew(row.write(content));
        const QString loss = lossOf(row, content, result.scenario);
        QVERIFY2(loss.isEmpty(), qPrintable(loss));
        std::vector<SceneNote> notes{SceneNote::UavsTaken};
        if (row.area && !content.area_m.empty())
            notes.push_back(content.geofence ? SceneNote::FenceTaken : SceneNote::AreaTaken);
        if (row.asset && content.asset)
            notes.push_back(SceneNote::AssetTaken);
        QVERIFY(notesOf(result) == notes);
        QCOMPARE(result.scene.front().count, content.uavs.size());
    }

    void noFlyAreasAreReadBack_data()
    {
        QTest::addColumn<int>("format");
        for (int i = 0; i < int(kFormats.size()); ++i)
            if (kFormats[std::size_t(i)].area)
                QTest::newRow(kFormats[std::size_t(i)].name) << i;
        QTest::newRow("czml") << -1;
    }

    void noFlyAreasAreReadBack()
    {
        QFETCH(int, format);
        Scenario scenario = twoUavsAndAsset();
        scenario.asset->standoff_m = 450;
        scenario.asset->standoffCeiling_m = 90;
        scenario.asset->position_m += Point(0, 20000); // away from the UAVs
        scenario.noFly = {{.name = "Mine field",
                           .corners_m = {{9000, 0}, {9900, 0}, {9900, 800}, {9000, 800}},
                           .floor_m = 20,
                           .ceiling_m = 5000},
                          {.corners_m = {{9000, 2000}, {9900, 2000}, {9900, 2800}}}};
        const bool isMission = format >= 0 && kFormats[std::size_t(format)].mission;
        const ExportContent content = planContent(
            scenario, planFromStart(scenario),
            {.uav = isMission ? std::optional(scenario.uavs.front().id) : std::nullopt});
        const ImportResult result = importedAsNew(
            format < 0 ? czmlText(content) : kFormats[std::size_t(format)].write(content));
        const Scenario& found = result.scenario;
        QCOMPARE(found.noFly.size(), std::size_t{2}); // the ring is below the UAVs
        for (std::size_t k = 0; k < 2; ++k) {
            const NoFlyArea& sent = scenario.noFly[k];
            QCOMPARE(found.noFly[k].corners_m.size(), sent.corners_m.size());
            for (const Point& corner_m : sent.corners_m)
                QVERIFY(std::any_of(found.noFly[k].corners_m.begin(),
                                    found.noFly[k].corners_m.end(), [&](const Point& found_m) {
                                        return apart_m(content, corner_m, found, found_m) <=
                                               kPlace_m;
                                    }));
            QCOMPARE(found.noFly[k].name, isMission ? std::string() : sent.name);
            QCOMPARE(found.noFly[k].floor_m, isMission ? 0 : sent.floor_m);
            QVERIFY(found.noFly[k].ceiling_m == (isMission ? std::nullopt : sent.ceiling_m));
        }
        if (isMission)
            return;
        QVERIFY(found.asset->standoff_m == 450.0 && found.asset->standoffCeiling_m == 90.0);
    }

    /** During a run: from the present place of the UAV, with the asset at its present place. */
    void sceneOfARunIsReadBack()
    {
        const Mission mission = flown(twoUavsAndAsset(), 100);
        for (const SceneFormat& row : kFormats)
            for (const ExportScope what : {ExportScope::Order, ExportScope::Track}) {
                ExportOptions options{.what = what};
                if (row.mission)
                    options.uav = "ravn";
                if (row.mission && what == ExportScope::Track)
                    continue; // its places are not only icebergs
                const ExportContent content = runContent(mission, options);
                const QString loss =
                    lossOf(row, content, importedAsNew(row.write(content)).scenario);
                QVERIFY2(loss.isEmpty(), qPrintable(QLatin1StringView(row.name) + u": "_s + loss));
            }
    }

    /** Nothing of an export but its icebergs becomes an iceberg, whatever its kind. */
    void everyKindIsRecognised()
    {
        Scenario scenario = twoUavsAndAsset();
        scenario.asset->standoff_m = 450;
        scenario.asset->position_m += Point(0, 20000); // away from the UAVs
        const std::vector<Point> corners_m{{9000, 0}, {9900, 0}, {9900, 800}};
        scenario.noFly = {{.corners_m = corners_m}};
        scenario.airspace = {{.name = "R", .corners_m = corners_m}};
        scenario.operation = Operation{};
        const Plan plan = planFromStart(scenario);
        const Mission mission = flown(scenario, 100);
        for (const ExportContent& content :
             {planContent(scenario, plan), planContent(scenario, plan, {.what = ExportScope::Path}),
              runContent(mission, {.what = ExportScope::Track})})
            for (const std::string& text :
                 {geoJson(content), kmlText(content), czmlText(content), gpxText(content)}) {
                const SightingTable table = readSightings(text, "export");
                QCOMPARE(static_cast<std::ptrdiff_t>(table.sightings.size()),
                         std::ranges::count_if(content.icebergs, &ExportIceberg::isListed));
                QCOMPARE(table.rejected.count, std::size_t{0});
            }
    }

    /** The asset moves on to the chosen start. */
    void assetMovesToTheStart()
    {
        const std::string text = geoJson(planContent(twoUavsAndAsset()));
        const ImportResult result =
            importSightings(newScenarioForImport("new"), readSightings(text, "export"),
                            {.at = utc("2026-05-02T00:09:30Z")});
        const Point moved_m = Point(2500, 900) + 600 * Point(1.25, -0.5);
        QVERIFY(apart_m(planContent(twoUavsAndAsset()), moved_m, result.scenario,
                        result.scenario.asset->position_m) < 0.1); // the planes differ
    }
};

QTEST_APPLESS_MAIN(TestImportScene)
#include "tst_import_scene.moc"
