#include "core/io/export/missions/plan_qgc.h"
#include "core/io/export/missions/plan_wpl.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/export_fixtures.h"
#include "tests/support/files/export_text.h"
#include "tests/support/files/import_fixtures.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;

namespace {

// Places are exported to 1e-9 degrees and imported to a centimetre, drift to 1e-7 m/s.
constexpr double kPlace_m = 0.011;
constexpr double kDrift_mps = 1e-6;

/** A format that contains icebergs. */
struct IcebergFormat
{
    const char* name;
    std::string (*write)(const ExportContent&);
};

constexpr std::array kIcebergFormats{
    IcebergFormat{"geojson", geoJson}, IcebergFormat{"kml", kmlText},
    IcebergFormat{"gpx", gpxText},     IcebergFormat{"kmz", kmzFile},
    IcebergFormat{"czml", czmlText},
};

/**
 * Returns an empty scenario with the same place and current, which files of icebergs do not
 * contain.
 */
ImportResult back(const std::string& text, const Scenario& scenario)
{
    Scenario base = openSea();
    base.origin = scenario.origin;
    base.current_mps = scenario.current_mps;
    return importSightings(base, readSightings(text, "export"), {.moveOrigin = false});
}

/** Line ends and control characters are read back as blanks. */
QString cleaned(const std::string& text)
{
    return QString::fromStdString(text).simplified();
}

bool isNear(const Point& a, const Point& b, double tolerance)
{
    return (a - b).cwiseAbs().maxCoeff() <= tolerance;
}

/** Describes what was lost of an iceberg; empty if nothing was. */
QString lossOf(const ExportIceberg& now, const Iceberg& found, const Point& current_mps)
{
    if (cleaned(now.iceberg.id) != cleaned(found.id))
        return u"id "_s + cleaned(found.id);
    if (cleaned(now.iceberg.name) != cleaned(found.name))
        return u"name "_s + cleaned(found.name);
    if (!isNear(now.position_m, found.position_m, kPlace_m))
        return u"position"_s;
    if (!isNear(now.drift_mps, found.velocity_mps + current_mps, kDrift_mps))
        return u"drift"_s;
    if (now.sigma_m2 != found.sigma0_m2 || now.iceberg.radius_m != found.radius_m)
        return u"sigma or radius"_s;
    if (now.iceberg.q_m2ps != found.q_m2ps)
        return u"q"_s;
    if (now.iceberg.velocitySd_mps != found.velocitySd_mps ||
        now.iceberg.velocitySpread_mps != found.velocitySpread_mps ||
        now.iceberg.velocityTime_s != found.velocityTime_s)
        return u"how the drift changes"_s;
    if (now.iceberg.appears_s != found.appears_s)
        return u"appearance"_s;
    return {};
}

/**
 * Scenario with names that `cleanText` leaves readable, an asset, a separate home and a late
 * iceberg.
 */
Scenario full()
{
    Scenario scenario = hostile();
    scenario.icebergs[2].name.clear();
    scenario.icebergs[2].appears_s = 150;
    scenario.icebergs[2].radius_m = 120.5;
    scenario.icebergs[1].q_m2ps = 0.125;
    scenario.icebergs[1].velocitySd_mps = 0.0625;
    scenario.icebergs[1].velocitySpread_mps = 0.15;
    scenario.icebergs[1].velocityTime_s = 36'000;
    scenario.uavs[0].home_m = Point(-700, -300);
    return scenario;
}

Scenario with(Scenario scenario, const LatLon& origin)
{
    scenario.origin = origin;
    return scenario;
}

} // namespace

/**
 * Reads exports back: nothing that the format can hold is lost, nothing becomes a false iceberg.
 */
class TestImportBack : public QObject
{
    Q_OBJECT

private slots:
    void icebergsAreReadBack_data()
    {
        QTest::addColumn<int>("format");
        QTest::addColumn<Scenario>("scenario");
        Scenario timeless = full();
        timeless.startUtc.clear();
        Scenario fleet = full();
        fleet.uavs.push_back(fleet.uavs[0]);
        fleet.uavs[1].id = "uav-2";
        fleet.uavs[1].position_m = Point(3000, 0);
        const std::vector<std::pair<const char*, Scenario>> scenarios{
            {"hostile names", full()},
            {"across 180", with(full(), {.latitude_deg = 70, .longitude_deg = 179.95})},
            {"North Pole", with(full(), {.latitude_deg = 90, .longitude_deg = 0})},
            {"South Pole", with(full(), {.latitude_deg = -89.99, .longitude_deg = 180})},
            {"no start", timeless},
            {"fleet", fleet},
            {"500 icebergs", fiveHundred()}};
        for (int i = 0; i < int(kIcebergFormats.size()); ++i)
            for (const auto& [name, scenario] : scenarios)
                QTest::addRow("%s, %s", kIcebergFormats[std::size_t(i)].name, name)
                    << i << scenario;
    }

    void icebergsAreReadBack()
    {
        QFETCH(int, format);
        QFETCH(Scenario, scenario);
        compare(kIcebergFormats[std::size_t(format)], scenario, planContent(scenario));
    }

    void driftIsReadBackInAnotherPlane_data()
    {
        QTest::addColumn<int>("format");
        QTest::addColumn<double>("latitude_deg");
        QTest::addColumn<double>("longitude_deg");
        QTest::addColumn<double>("northward_deg");
        QTest::addColumn<double>("eastward_deg");
        for (int i = 0; i < int(kIcebergFormats.size()); ++i) {
            const char* const format = kIcebergFormats[std::size_t(i)].name;
            QTest::addRow("%s, 500 km", format) << i << 47.0 << -48.0 << 4.0 << 3.0;
            QTest::addRow("%s, across 180", format) << i << 70.0 << 179.95 << 2.0 << 10.0;
            QTest::addRow("%s, equator", format) << i << 0.0 << 0.0 << -3.0 << 5.0;
            QTest::addRow("%s, over the North Pole", format) << i << 89.9 << 0.0 << -4.9 << 90.0;
            QTest::addRow("%s, South Pole", format) << i << -89.99 << 180.0 << 6.0 << -170.0;
        }
    }

    /** Read into a plane with another north, icebergs drift over the same water. */
    void driftIsReadBackInAnotherPlane()
    {
        QFETCH(int, format);
        QFETCH(double, latitude_deg);
        QFETCH(double, longitude_deg);
        QFETCH(double, northward_deg);
        QFETCH(double, eastward_deg);
        const Scenario scenario =
            with(full(), {.latitude_deg = latitude_deg, .longitude_deg = longitude_deg});
        const LocalFrame from(scenario.origin);
        const ExportContent content = planContent(scenario);
        Scenario other = full();
        other.origin = {.latitude_deg = latitude_deg + northward_deg,
                        .longitude_deg = std::remainder(longitude_deg + eastward_deg, 360.0)};
        const LocalFrame to(other.origin);
        const std::string text = kIcebergFormats[std::size_t(format)].write(content);
        const ImportResult result = back(text, other);
        QCOMPARE(result.scenario.icebergs.size(), content.icebergs.size());
        for (std::size_t i = 0; i < content.icebergs.size(); ++i) {
            const ExportIceberg& sent = content.icebergs[i];
            const Iceberg& found = result.scenario.icebergs[i];
            const LatLon place = from.toGeographic(sent.position_m);
            QVERIFY(isNear(to.toPlane(place), found.position_m, kPlace_m));
            const Point was_mps = turned(sent.drift_mps, -from.trueNorth_rad(place));
            const Point is_mps =
                turned(found.velocity_mps + other.current_mps, -to.trueNorth_rad(place));
            QVERIFY2((was_mps - is_mps).norm() <= 1e-6,
                     qPrintable(QString::number((was_mps - is_mps).norm())));
        }
    }

    void icebergsOfARunAreReadBack_data()
    {
        QTest::addColumn<int>("format");
        QTest::addColumn<int>("what");
        for (int i = 0; i < int(kIcebergFormats.size()); ++i)
            for (const ExportScope what : {ExportScope::Track, ExportScope::Order})
                QTest::addRow("%s, %s", kIcebergFormats[std::size_t(i)].name,
                              std::string(nameOf(kExportScopeNames, what)).c_str())
                    << i << int(what);
    }

    /** The run is past its start, with a track and with icebergs that are not there yet. */
    void icebergsOfARunAreReadBack()
    {
        QFETCH(int, format);
        QFETCH(int, what);
        const Mission mission = flown(full(), 100);
        compare(kIcebergFormats[std::size_t(format)], full(),
                runContent(mission, {.what = ExportScope(what)}));
    }

    void missionsAreReadBack_data()
    {
        QTest::addColumn<bool>("isPlan");
        QTest::addColumn<Scenario>("scenario");
        QTest::addColumn<ExportOptions>("options");
        const std::vector<std::pair<const char*, ExportOptions>> choices{
            {"order", {}},
            {"first leg", {.what = ExportScope::FirstLeg}},
            {"circles", {.loiterTurns = 3}},
            {"return home", {.returnHome = true}}};
        for (const bool isPlan : {true, false})
            for (const auto& [name, options] : choices) {
                const char* const format = isPlan ? "plan" : "wpl";
                QTest::addRow("%s, %s", format, name) << isPlan << full() << options;
                QTest::addRow("%s, %s, across 180", format, name)
                    << isPlan << with(full(), {.latitude_deg = 70, .longitude_deg = 179.95})
                    << options;
            }
    }

    /** The import gives the visited places and the home, and nothing else. */
    void missionsAreReadBack()
    {
        QFETCH(bool, isPlan);
        QFETCH(Scenario, scenario);
        QFETCH(ExportOptions, options);
        const ExportContent content = planContent(scenario, fourIcebergPlan(), options);
        const ImportResult result = back(isPlan ? qgcPlan(content) : wplText(content), scenario);
        std::vector<Visit> visits = content.uavs.front().visits;
        std::erase_if(visits, [](const Visit& visit) { return !visit.iceberg; });
        QCOMPARE(result.rejected.count, std::size_t{0});
        QCOMPARE(result.scenario.icebergs.size(), visits.size());
        for (std::size_t i = 0; i < visits.size(); ++i)
            QVERIFY(isNear(result.scenario.icebergs[i].position_m, visits[i].position_m, kPlace_m));
        QVERIFY(
            isNear(result.scenario.uavs.front().position_m, content.uavs.front().home_m, kPlace_m));
    }

    /** A waypoint that a user adds to an export is another iceberg. */
    void addedWaypointsAreImported()
    {
        std::string gpx = gpxText(planContent(full()));
        gpx.insert(gpx.find("<rte>"), "<wpt lat=\"47.01\" lon=\"-48.01\"><name>new</name></wpt>\n");
        std::string kml = kmlText(planContent(full()));
        kml.insert(kml.find("</Document>"), "<Placemark><name>new</name><Point><coordinates>"
                                            "-48.01,47.01</coordinates></Point></Placemark>");
        std::string json = geoJson(planContent(full()));
        json.insert(json.rfind("\n]}"), R"(,{"type": "Feature", "id": "new", "properties": {},
            "geometry": {"type": "Point", "coordinates": [-48.01, 47.01]}})");
        for (const std::string& text : {gpx, kml, json}) {
            const ImportResult result = back(text, full());
            QCOMPARE(result.added, std::size_t{5});
            QVERIFY(std::any_of(result.scenario.icebergs.begin(), result.scenario.icebergs.end(),
                                [](const Iceberg& iceberg) { return iceberg.id == "new"; }));
        }
    }

    void driftOutOfRangeIsLeftOut()
    {
        const auto json = [](const char* drift) {
            return R"({"type": "Feature", "properties": {"drift_mps": )" + std::string(drift) +
                   R"(}, "geometry": {"type": "Point", "coordinates": [-48, 47]}})";
        };
        const SightingTable table = readSightings(json("[0.25, -0.5]"), "export");
        QVERIFY(table.sightings.at(0).drift_mps == Point(0.25, -0.5));
        for (const char* drift : {"[51, 0]", "[0, -51]", R"(["fast", 0])"}) {
            const SightingTable read = readSightings(json(drift), "export");
            QVERIFY(!read.sightings.at(0).drift_mps);
            QCOMPARE(read.noted.count, std::size_t{1});
        }
    }

private:
    static void compare(const IcebergFormat& format, const Scenario& scenario,
                        const ExportContent& content)
    {
        const ImportResult result = back(format.write(content), scenario);
        QCOMPARE(result.rejected.count, std::size_t{0});
        std::vector<ExportIceberg> listed = content.icebergs;
        std::erase_if(listed, [&](const ExportIceberg& iceberg) { return !iceberg.isListed; });
        QCOMPARE(result.scenario.icebergs.size(), listed.size());
        for (std::size_t i = 0; i < listed.size(); ++i) {
            const QString loss =
                lossOf(listed[i], result.scenario.icebergs[i], scenario.current_mps);
            QVERIFY2(loss.isEmpty(), qPrintable(QString::number(i) + u": "_s + loss));
        }
        QCOMPARE(result.at.has_value(), content.start.has_value());
        if (result.at)
            QCOMPARE(utcText(*result.at, 0), utcText(*content.start, content.now_s));
        const ExportUav& exported = content.uavs.front();
        const Uav& uav = result.scenario.uavs.front();
        QVERIFY(isNear(uav.home_m.value_or(uav.position_m), exported.home_m, kPlace_m));
        QVERIFY(isNear(uav.position_m, exported.uav.position_m, kPlace_m));
    }
};

QTEST_APPLESS_MAIN(TestImportBack)
#include "tst_import_back.moc"
