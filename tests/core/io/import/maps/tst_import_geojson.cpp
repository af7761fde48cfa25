#include "core/io/import/fields/area_centroid.h"
#include "core/io/import/fields/import_source.h"
#include "core/io/import/fields/json_members.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/import_fixtures.h"

#include <QtTest>

#include <cmath>

using namespace berg;
using namespace berg::test;

namespace {

/** Returns a feature with this id (as JSON, or empty), properties and geometry. */
std::string feature(const std::string& id, const std::string& properties,
                    const std::string& geometry)
{
    return R"({"type": "Feature", )" + (id.empty() ? "" : "\"id\": " + id + ", ") +
           R"("properties": {)" + properties + R"(}, "geometry": )" + geometry + "}";
}

std::string point(double longitude_deg, double latitude_deg)
{
    return R"({"type": "Point", "coordinates": [)" + std::to_string(longitude_deg) + ", " +
           std::to_string(latitude_deg) + "]}";
}

std::string collection(const std::string& features, const std::string& members = {})
{
    return R"({"type": "FeatureCollection", )" + members + R"("features": [)" + features + "]}";
}

std::string crs(const std::string& name)
{
    return R"("crs": {"type": "name", "properties": {"name": ")" + name + R"("}}, )";
}

std::string idsOf(const SightingTable& table)
{
    std::string ids;
    for (const Sighting& sighting : table.sightings)
        ids += (ids.empty() ? "" : ",") + sighting.id;
    return ids;
}

std::string messageOf(const std::string& text)
{
    const std::optional<Error> error = errorOf([&] { (void)readText(text); });
    return error ? error->what() : "nothing";
}

} // namespace

class TestImportGeoJson : public QObject
{
    Q_OBJECT

private slots:
    void firstCharacterTellsObjectFromList_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<char>("first");
        QTest::newRow("object") << QByteArray(" {}") << '{';
        QTest::newRow("list of objects") << QByteArray("[{}]") << '[';
        QTest::newRow("mark") << QByteArray("\xEF\xBB\xBF\n{}") << '{';
        QTest::newRow("text sequence") << QByteArray("\x1E[{}]") << '[';
        QTest::newRow("mark and text sequence") << QByteArray("\xEF\xBB\xBF\x1E{}") << '{';
        QTest::newRow("XML") << QByteArray("<a b='{'>") << '<';
        QTest::newRow("only a mark") << QByteArray("\xEF\xBB\xBF \x1E ") << '\0';
    }

    void firstCharacterTellsObjectFromList()
    {
        QFETCH(QByteArray, text);
        QFETCH(char, first);
        QCOMPARE(firstOfJson(text.toStdString()), first);
    }

    /** A list may hold features, but a mission is one object. */
    void listsAreFeaturesAndNoMission()
    {
        const std::string one = feature("\"a\"", {}, point(-48, 47));
        QCOMPARE(readText('[' + one + ']').format, std::string("geojson"));
        QCOMPARE(readText("\xEF\xBB\xBF\x1E" + one + "\n\x1E" + one).format,
                 std::string("geojson"));
        const std::string mission = R"({"fileType": "Plan", "groundStation": "QGroundControl"})";
        const std::optional<Error> error = errorOf([&] { (void)readText('[' + mission + ']'); });
        QVERIFY(error.has_value());
        QCOMPARE(error->issues().at(0).reason.id, IssueId::UnknownFormat);
    }

    void everyGeometryHasItsPlaces()
    {
        const SightingTable table = readFixture("geometries.geojson");
        QCOMPARE(joinedLines(placesOf(table)),
                 std::string("m-1 47.000000 -48.000000\n"
                             "m-2 47.100000 -48.100000\n"
                             "m-2 2 47.200000 -48.200000\n"
                             "p-1 47.033929 -48.966071\n" // an L of two rectangles, 4 : 3
                             "p-2 47.341667 -48.541667\n" // a square without a quarter of it
                             "p-3 47.550000 -48.350000\n"
                             "p-3 2 47.550000 -48.150000\n"
                             "c-1 47.700000 -48.700000\n"
                             "l-1 48.000000 -48.000000\n"
                             "l-1 47.990000 -48.000000\n"
                             "l-1 47.980000 -48.000000\n"
                             "n-1 47.800000 -48.800000\n"));
        QCOMPARE(timeOf(table.sightings[10]), std::string("2024-06-01T08:00:00Z"));
        QCOMPARE(notesAt(table, 2), std::string("has several places: each is taken as an iceberg"));
        QCOMPARE(notesAt(table, 5), notesAt(table, 2));
        QCOMPARE(notesAt(table, 6), std::string("has points beside lines or areas: only the points "
                                                "are taken"));
        QCOMPARE(table.noted.count, std::size_t{3});
        QCOMPARE(faultAt(table, 9), std::string("has no position"));
        QCOMPARE(faultAt(table, 10),
                 std::string("coordinates are no degrees, and the file names no coordinate system: "
                             "save it in WGS 84 (EPSG:4326): \"512345.2 7598765.1\""));
    }

    /** Two places of one feature remain two at each of its times. */
    void placesOfOneFeatureAreIcebergs()
    {
        const auto two = [](const char* time, const char* coordinates) {
            return feature(R"("A")", "\"time\": \"" + std::string(time) + "\"",
                           std::string(R"({"type": "MultiPoint", "coordinates": )") + coordinates +
                               "}");
        };
        const SightingTable table =
            readText(collection(two("2024-06-01T10:00:00Z", "[[-48, 47], [-49, 47]]") + "," +
                                two("2024-06-01T11:00:00Z", "[[-48, 47.01], [-49, 47.01]]") + "," +
                                feature(R"("A 2")", "", point(-47, 46))));
        QCOMPARE(idsOf(table), std::string("A,A 3,A,A 3,A 2"));
    }

    void driftThatCannotBeReadCostsNoPlace_data()
    {
        QTest::addColumn<QByteArray>("drift");
        QTest::newRow("text") << QByteArray(R"(["east", 0.1])");
        QTest::newRow("too fast") << QByteArray("[0.1, 99]");
        QTest::newRow("half") << QByteArray("[0.1, null]");
    }

    void driftThatCannotBeReadCostsNoPlace()
    {
        QFETCH(QByteArray, drift);
        const SightingTable table =
            readText(feature(R"("A")", "\"drift_mps\": " + drift.toStdString(), point(-48, 47)));
        QCOMPARE(idsOf(table), std::string("A"));
        QVERIFY(!table.sightings.front().drift_mps);
        QCOMPARE(table.rejected.count, std::size_t{0});
        QCOMPARE(table.noted.count, std::size_t{1});
    }

    void pointsWithTimesAreATrack()
    {
        const SightingTable table = readText(
            feature(R"("A")", R"("times": ["2024-06-01T10:00:00Z", "2024-06-01T11:00:00Z"])",
                    R"({"type": "MultiPoint", "coordinates": [[-48, 47], [-48, 47.01]]})"));
        QCOMPARE(idsOf(table), std::string("A,A"));
        QCOMPARE(timeOf(table.sightings[1]), std::string("2024-06-01T11:00:00Z"));
        QCOMPARE(table.noted.count, std::size_t{0});
    }

    void cornersOfRoutesAreIcebergs()
    {
        const SightingTable table =
            readText(R"({"type": "MultiLineString", "coordinates": [[[1, 2], [3, 4]], [[5, 6]]]})");
        QCOMPARE(table.sightings.size(), std::size_t{3});
        QCOMPARE(table.sightings[2].place.latitude_deg, 6.0);
    }

    void centroidsAreThoseOfTheArea_data()
    {
        QTest::addColumn<QString>("coordinates");
        QTest::addColumn<double>("latitude_deg");
        QTest::addColumn<double>("longitude_deg");
        const auto row = [](const char* name, const char* coordinates, double latitude_deg,
                            double longitude_deg) {
            QTest::newRow(name) << QString::fromUtf8(coordinates) << latitude_deg << longitude_deg;
        };
        row("corners crowd one side", "[[0,0],[4,0],[4,1],[4,2],[4,3],[4,4],[0,4],[0,0]]", 2, 2);
        row("not closed", "[[0,0],[4,0],[4,4],[0,4]]", 2, 2);
        row("clockwise", "[[0,0],[0,4],[4,4],[4,0],[0,0]]", 2, 2);
        row("triangle", "[[0,0],[3,0],[0,3],[0,0]]", 1, 1);
        row("antimeridian", "[[179,-70],[-179,-70],[-179,-68],[179,-68],[179,-70]]", -69, -180);
        row("beyond 180", "[[179,-70],[183,-70],[183,-68],[179,-68],[179,-70]]", -69, -179);
        row("crosses itself", "[[0,0],[2,2],[2,0],[0,2],[0,0]]", 1, 1);
        row("without area", "[[0,0],[2,2],[4,4],[0,0]]", 2, 2);
    }

    void centroidsAreThoseOfTheArea()
    {
        QFETCH(QString, coordinates);
        QFETCH(double, latitude_deg);
        QFETCH(double, longitude_deg);
        const SightingTable table =
            readText(R"({"type": "Polygon", "coordinates": [)" + coordinates.toStdString() + "]}");
        const LatLon& place = table.sightings.at(0).place;
        QVERIFY(std::abs(place.latitude_deg - latitude_deg) < 1e-9);
        QVERIFY2(std::abs(std::remainder(place.longitude_deg - longitude_deg, 360)) < 1e-9,
                 qPrintable(QString::number(place.longitude_deg)));
    }

    /** Cuts an outline at the antimeridian by RFC 7946, section 3.1.9. */
    void halvesAtTheAntimeridianAreOne()
    {
        const SightingTable table =
            readText(R"({"type": "MultiPolygon", "coordinates": [)"
                     "[[[179,-70],[180,-70],[180,-68],[179,-68],[179,-70]]],"
                     "[[[-180,-70],[-177,-70],[-177,-68],[-180,-68],[-180,-70]]],"
                     "[[[10,-70],[12,-70],[12,-68],[10,-68],[10,-70]]]]}");
        QCOMPARE(joinedLines(placesOf(table)),
                 std::string(" -69.000000 -179.000000\n -69.000000 11.000000\n"));
    }

    void outlinesWithoutACentroidAreRejected()
    {
        // These are two corners, and a ring around the South Pole.
        for (const char* ring : {"[[0,0],[1,1],[0,0]]", "[[0,-80],[120,-80],[-120,-80],[0,-80]]",
                                 "[[0,0],[1,0],[\"x\",1],[0,0]]", "[]"}) {
            const SightingTable table = readText(collection(
                feature("", "", point(1, 2)) + "," +
                feature("", "",
                        std::string(R"({"type": "Polygon", "coordinates": [)") + ring + "]}")));
            QCOMPARE(table.sightings.size(), std::size_t{1});
            QCOMPARE(faultAt(table, 2), std::string("has no position"));
        }
    }

    void textSequencesAreRead_data()
    {
        QTest::addColumn<QByteArray>("text");
        const std::string a = feature(R"("A")", "", point(-48, 47));
        const std::string b = feature(R"("B")", "", point(-48.1, 47.1));
        std::string spread = b;
        spread.replace(spread.find(", \"geometry"), 2, ",\n  ");
        const auto row = [](const char* name, const std::string& text) {
            QTest::newRow(name) << QByteArray::fromStdString(text);
        };
        row("lines", a + '\n' + b + '\n');
        row("lines of DOS, and blank ones", a + "\r\n\r\n" + b);
        row("byte order mark", "\xEF\xBB\xBF" + a + '\n' + b);
        row("RFC 8142", "\x1E" + a + "\n\x1E" + b + '\n');
        row("RFC 8142 on several lines", "\x1E" + a + "\n\x1E" + spread + '\n');
        row("collections", collection(a) + '\n' + collection(b) + '\n');
        row("list", '[' + a + ',' + b + ']');
        row("nested", collection(collection(a) + ',' + collection(collection(b))));
    }

    void textSequencesAreRead()
    {
        QFETCH(QByteArray, text);
        const SightingTable table = readText(text.toStdString());
        QCOMPARE(table.format, std::string("geojson"));
        QCOMPARE(idsOf(table), std::string("A,B"));
        QCOMPARE(table.rejected.count, std::size_t{0});
        QCOMPARE(table.sightings[1].line, std::size_t{2});
    }

    void oneBrokenTextCostsNoOther()
    {
        const std::string a = feature(R"("A")", "", point(-48, 47));
        const SightingTable lines = readText(a + "\n{\"type\": \"Feature\", \n" + a);
        QCOMPARE(lines.sightings.size(), std::size_t{2});
        QVERIFY(faultAt(lines, 2).starts_with("is not well-formed JSON: "));
        const SightingTable records = readText("\x1E" + a + "\x1E" + a.substr(0, 40));
        QCOMPARE(records.sightings.size(), std::size_t{1});
        QCOMPARE(records.rejected.count, std::size_t{1});
    }

    void degreesOfWgs84AreAccepted_data()
    {
        QTest::addColumn<QString>("members");
        const auto row = [](const char* name, const std::string& members) {
            QTest::newRow(name) << QString::fromStdString(members);
        };
        row("none", "");
        row("null", "\"crs\": null, ");
        for (const char* name :
             {"urn:ogc:def:crs:OGC:1.3:CRS84", "urn:ogc:def:crs:OGC::CRS84", "EPSG:4326",
              "urn:ogc:def:crs:EPSG::4326", "http://www.opengis.net/def/crs/EPSG/0/4326"})
            row(name, crs(name));
        row("code", R"("crs": {"type": "EPSG", "properties": {"code": 4326}}, )");
    }

    void degreesOfWgs84AreAccepted()
    {
        QFETCH(QString, members);
        const SightingTable table =
            readText(collection(feature("", "", point(-48, 47)), members.toStdString()));
        QCOMPARE(table.sightings[0].place, (LatLon{.latitude_deg = 47, .longitude_deg = -48}));
    }

    void metresAreUnprojected()
    {
        const SightingTable table = readFixture("polar.geojson");
        // The first is from PROJ; the second is a square around (1231000, -769000).
        QCOMPARE(placesOf(table)[0], std::string("A 76.648955 13.201072"));
        const SightingTable middle =
            readText(collection(feature("", "", point(1231000, -769000)), crs("EPSG:3413")));
        QCOMPARE(placesOf(table)[1], "B" + placesOf(middle)[0]);
        QCOMPARE(faultAt(table, 3),
                 std::string("coordinates look like degrees, but the file says they are metres: "
                             "save it in WGS 84 (EPSG:4326): \"EPSG:3413\""));
    }

    void unknownSystemsAreRejected()
    {
        const std::string features = feature("", "", point(55, -42));
        QCOMPARE(messageOf(collection(features, crs("urn:ogc:def:crs:EPSG::27700"))),
                 std::string("file: crs: the coordinate system \"urn:ogc:def:crs:EPSG::27700\" is "
                             "not known: save the file in WGS 84 (EPSG:4326)"));
        QVERIFY(messageOf(collection(features, crs("local"))).find("\"local\"") !=
                std::string::npos);
        QVERIFY(
            messageOf(collection(features, crs("urn:ogc:def:crs:EPSG::3413"))).find("EPSG:3413") !=
            std::string::npos);
        QVERIFY(
            messageOf(
                collection(
                    features,
                    "\"crs\": {\"type\": \"link\", \"properties\": {\"href\": \"http://x/y\"}}, "))
                .find("http://x/y") != std::string::npos);
    }

    void idsOfFeaturesAreChosen_data()
    {
        QTest::addColumn<QStringList>("features");
        QTest::addColumn<QString>("ids");
        QTest::addColumn<bool>("isNoted");
        const auto one = [](const char* id, const char* property, const char* hour, double at) {
            std::string properties = std::string("\"id\": ") + property;
            if (*hour != '\0')
                properties += ", \"time\": \"2024-06-01T" + std::string(hour) + ":00:00Z\"";
            return QString::fromStdString(feature(id, properties, point(-48 - at, 47)));
        };
        QTest::newRow("the property names the iceberg at several times")
            << QStringList{one("1", "\"A\"", "10", 0), one("2", "\"A\"", "11", 0.01),
                           one("3", "\"B\"", "11", 1)}
            << "A,A,B" << false;
        QTest::newRow("the property is the same at one time")
            << QStringList{one("1", "0", "10", 0), one("2", "0", "10", 0.5)} << "1,2" << true;
        QTest::newRow("the property is the same without a time")
            << QStringList{one("1", "0", "", 0), one("2", "0", "", 0.5)} << "1,2" << true;
        QTest::newRow("one of them without a time")
            << QStringList{one("1", "0", "10", 0), one("2", "0", "", 0.5)} << "1,2" << true;
        QTest::newRow("the same place twice is one")
            << QStringList{one("1", "0", "10", 0), one("2", "0", "10", 0)} << "0,0" << false;
        QTest::newRow("without an id of the feature")
            << QStringList{one("", "0", "10", 0), one("", "0", "10", 0.5)} << "0,0" << false;
        QTest::newRow("no property")
            << QStringList{one("\"x\"", "null", "10", 0), one("\"y\"", "null", "11", 0.5)} << "x,y"
            << false;
        QTest::newRow("an id of a feature is another's property")
            << QStringList{one("5", "1", "10", 0), one("1", "null", "11", 0.5)} << "5,1" << true;
        QTest::newRow("properties number the messages")
            << QStringList{one("\"T\"", "501", "10", 0), one("\"T\"", "502", "11", 0.01),
                           one("\"U\"", "503", "11", 1)}
            << "T,T,U" << false;
    }

    void idsOfFeaturesAreChosen()
    {
        QFETCH(QStringList, features);
        QFETCH(QString, ids);
        QFETCH(bool, isNoted);
        const SightingTable table = readText(collection(features.join(u',').toStdString()));
        QCOMPARE(QString::fromStdString(idsOf(table)), ids);
        QCOMPARE(table.noted.count > 0, isNoted);
    }

    void idsOfTheFixtureAreChosen()
    {
        const SightingTable table = readFixture("ids.geojson");
        QCOMPARE(joinedLines(placesOf(table)), std::string("0 47.000000 -48.000000\n"
                                                           "1 47.000000 -48.500000\n"
                                                           "2 47.000000 -48.600000\n"));
        QVERIFY(notesAt(table, 2).starts_with("the property that names the iceberg is the same"));
    }

    void linesOfOneNameAreSeparated()
    {
        const auto line = [](const char* first, const char* last, double north_deg) {
            return feature(
                R"("A")", "\"times\": [\"" + std::string(first) + "\", \"" + last + "\"]",
                R"({"type": "LineString", "coordinates": [[-48, )" + std::to_string(north_deg) +
                    "], [-48, " + std::to_string(north_deg - 0.01) + "]]}");
        };
        const std::string first = line("2024-06-01T10:00:00Z", "2024-06-01T11:00:00Z", 47);
        QCOMPARE(idsOf(readText(collection(
                     first + "," + line("2024-06-01T12:00:00Z", "2024-06-01T13:00:00Z", 46.98)))),
                 std::string("A,A,A,A"));
        const SightingTable apart = readText(
            collection(first + "," + line("2024-06-01T12:00:00Z", "2024-06-01T13:00:00Z", 46.5)));
        QCOMPARE(idsOf(apart), std::string("A,A,A 2,A 2"));
        QVERIFY(notesAt(apart, 2).find("\"A 2\"") != std::string::npos);
    }

    void deepNestingIsRejected()
    {
        std::string geometry = point(1, 2);
        for (int i = 0; i < 100; ++i)
            geometry = R"({"type": "GeometryCollection", "geometries": [)" + geometry + "]}";
        QVERIFY(messageOf(feature("", "", geometry)).find("nested deeper than") !=
                std::string::npos);
    }

    /** Names and kinds of a Bergwatch export may occur in files of others. */
    void filesOfOthersKeepTheirIcebergs_data()
    {
        QTest::addColumn<QByteArray>("properties");
        QTest::newRow("word in a remark")
            << QByteArray(R"("remark": "seen from UAV, airspeed_mps 20")");
        QTest::newRow("airspeed") << QByteArray(R"("airspeed_mps": 20, "kind": "track")");
        QTest::newRow("all that a UAV has")
            << QByteArray(R"("heading_deg": 10, "airspeed_mps": 20, "altitude_m": 90)");
    }

    void filesOfOthersKeepTheirIcebergs()
    {
        QFETCH(QByteArray, properties);
        const std::string first = feature(R"("A")", properties.toStdString(), point(-50, 60));
        const SightingTable table = readText(
            collection(first + ',' + feature(R"("B")", R"("kind": "growler")", point(-50.1, 60))));
        QCOMPARE(idsOf(table), std::string("A,B"));
        QCOMPARE(table.rejected.count, std::size_t{0});
        QVERIFY(table.scene.uavs.empty());
    }

    /** Only the drift of a Bergwatch export has two components. */
    void componentsOfOthersCanBeMapped()
    {
        const std::string text =
            collection(feature(R"("A")", R"("speed_east_mps": 0.3)", point(-50, 60)));
        const SightingTable table =
            readText(text, {.mapping = {{SightingField::Speed, "speed_east_mps"}}});
        QCOMPARE(table.sightings.at(0).speed_mps, std::optional(0.3));
    }

    /** Comparing each part with each other one would take minutes. */
    void manyPartsAtTheAntimeridianAreFast()
    {
        std::string parts;
        for (int i = 0; i < 20'000; ++i) {
            const std::string south = std::to_string(-60 + i * 1e-3);
            const std::string north = std::to_string(-60 + i * 1e-3 + 5e-4);
            parts += (i > 0 ? ",[[[180," : "[[[180,") + south + "],[179," + south + "],[179," +
                     north + "],[180," + north + "]]]";
        }
        const SightingTable table =
            readText(R"({"type": "MultiPolygon", "coordinates": [)" + parts + "]}");
        QCOMPARE(table.sightings.size(), std::size_t{20'000});
    }
};

QTEST_APPLESS_MAIN(TestImportGeoJson)
#include "tst_import_geojson.moc"
