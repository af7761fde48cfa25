#include "core/checks/validate.h"
#include "core/geometry/geometry.h"
#include "core/io/text/atomic_file.h"
#include "core/presets/presets.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/airspace_test.h"
#include "tests/support/files/export_text.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

const std::string kFile = BERG_TEST_DATA "/import/airspace.openair";

} // namespace

class TestImportAirspace : public QObject
{
    Q_OBJECT

private slots:
    void heightsAreRead_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("floor_m"); // −1 means no height
        QTest::addColumn<double>("ceiling_m");
        const auto pair = [](const char* text, double floor_m, double ceiling_m) {
            QTest::newRow(text) << QString::fromUtf8(text) << floor_m << ceiling_m;
        };
        const auto row = [&](const char* text, double height_m) { pair(text, height_m, height_m); };
        row("GND", 0);
        row("sfc", 0);
        row("MSL", 0);
        row("0", 0);
        row("1500", 457.2);
        row("1500 ft AMSL", 457.2);
        row("1500ft AGL", 457.2);
        row("1500FT", 457.2);
        row("1500' MSL", 457.2);
        row("AMSL 1500 ft", 457.2);
        row("1500 ft above mean sea level", 457.2);
        row("FL 65", 1981.2);
        row("FL65", 1981.2);
        row("FL065 STD", 1981.2);
        row("65 FL", 1981.2);
        row("fl 65", 1981.2);
        row("500 M AGL", 500);
        row("500m", 500);
        row("500 meters", 500);
        row("500 m/MSL", 500);
        row("1500 MSL", 457.2);
        row("3 500 ft MSL", 1066.8);
        row("3\u00a0500 ft", 1066.8);
        row("3,500 ft", 1066.8);
        row("3.500 ft", 1066.8);
        row("3'500ft", 1066.8);
        row("3\u2019500ft", 1066.8);
        row("12 500", 3810);
        row("1500.5 ft", 457.3524);
        row("1500,5 ft", 457.3524);
        row("1 500 m", 1500);
        row("UNL", HUGE_VAL);
        row("UNLIM", HUGE_VAL);
        row("Unlimited", HUGE_VAL);
        pair("2000 MSL / 1000 AGL", 304.8, 609.6);
        pair("1000 AGL/2000 MSL", 304.8, 609.6);
        pair("FL 65 / 1000 ft AGL", 304.8, 1981.2);
        pair("2500 ft MSL or 1000 ft AGL whichever is higher", 304.8, 762);
        pair("3500 ft (1067 m)", 1066.8, 1067);
        pair("500/100 ft", 30.48, 152.4);
        pair("2000 / 600 m", 600, 2000); // the first may be in metres too
        pair("500 ft GND", 0, 152.4);
        row("1e15 M", -1);
        row("FL 6500", -1);
        row("FL 6.5", -1);
        row("65 000 FL", -1);
        row("Ask on 122.8", -1);
        row("", -1);
        row("-100 ft", -1);
        row("1500 fathoms", -1);
        row("GND + 500 ft", -1);
    }
    void heightsAreRead()
    {
        QFETCH(QString, text);
        QFETCH(double, floor_m);
        QFETCH(double, ceiling_m);
        for (const auto& [limit, height_m] :
             {std::pair(HeightLimit::Floor, floor_m), std::pair(HeightLimit::Ceiling, ceiling_m)}) {
            const std::optional<double> read_m = airspaceHeight_m(text.toStdString(), limit);
            QCOMPARE(read_m.has_value(), height_m >= 0);
            QVERIFY(!read_m || *read_m == height_m || std::abs(*read_m - height_m) < 1e-9);
        }
    }

    void openAirIsImported()
    {
        const AirspaceResult result = readAirspace(readFile(kFile));
        QCOMPARE(result.added, std::size_t{5});
        QCOMPARE(result.far, std::size_t{1});
        QCOMPARE(result.notNeeded.first.at(0).detail, std::string("Far away"));
        QCOMPARE(result.rejected.count, std::size_t{1});
        QCOMPARE(result.rejected.first[0].line, std::size_t{41});
        QCOMPARE(englishText(reasonOf(result.rejected.first[0])),
                 std::string("airspace left out: a place or an arc cannot be read: "
                             "\"Broken place: DP 47:00:00 N 148:75:00 W\""));
        QCOMPARE(rowsSaid(result.noted),
                 std::string("54 airspace taken without end above: its ceiling is missing or "
                             "cannot be read: \"Far away: AH Ask on 122.8\"\n"
                             "43 airspace taken with an outline round its own, which touches or "
                             "crosses itself: \"Crossing itself\"\n"));
        QVERIFY(!hasErrors(validate(result.scenario)));

        const AirspaceArea& square = airspaceNamed(result.scenario, "Grand Banks West");
        QCOMPARE(square.kind, std::string("TRA"));
        QCOMPARE(square.corners_m.size(), std::size_t{4});
        QVERIFY(std::ranges::any_of(square.corners_m, [](const Point& corner_m) {
            return (corner_m - Point(0, 11118)).norm() < 10; // 6 minutes of latitude
        }));
        QVERIFY(std::abs(square.floor_m - 304.8) < 1e-9);
        QVERIFY(std::abs(square.ceiling_m.value_or(0) - 1981.2) < 1e-9);
        QCOMPARE(square.fromUtc, std::string("2026-05-01T06:00Z"));
        QCOMPARE(square.untilUtc, std::string("2026-05-01T18:00Z"));
    }

    /** Several times give their whole span; one that is not understood means always. */
    void severalTimesGiveTheirSpan()
    {
        const auto area = [](const std::string& times) {
            return readAirspace("AC D\nAN zone\n" + times + "V X=47N 48W\nDC 2\n")
                .scenario.airspace.at(0);
        };
        const std::string first = "AA 2026-05-01T06:00Z/2026-05-01T08:00Z\n";
        const std::string second = "AA 2026-05-02T06:00Z/2026-05-02T08:00Z\n";
        for (const std::string& both : {first + second, second + first}) {
            QCOMPARE(area(both).fromUtc, std::string("2026-05-01T06:00Z"));
            QCOMPARE(area(both).untilUtc, std::string("2026-05-02T08:00Z"));
        }
        const auto finer = area(first + "AA 2026-05-01T06:00:30Z/2026-05-01T08:00:45Z\n");
        QCOMPARE(finer.fromUtc, std::string("2026-05-01T06:00Z"));
        QCOMPARE(finer.untilUtc, std::string("2026-05-01T08:00:45Z"));
        for (const std::string& odd : {first + "AA NONE\n", "AA NONE\n" + first}) {
            QVERIFY(area(odd).fromUtc.empty());
            QVERIFY(area(odd).untilUtc.empty());
        }
    }

    void circlesAreCovered()
    {
        for (const char* const arc : {"DA 2,0,360", "V D=-\nDA 2,0,360", "DC 2"}) {
            const Scenario scenario =
                readAirspace("AC\tD\nAN zone\nV X=47N 48W\n" + std::string(arc) + '\n').scenario;
            const double circle_m2 = std::acos(-1.0) * 4 * 1852 * 1852;
            QVERIFY2(std::abs(std::abs(signedArea(scenario.airspace.at(0).corners_m)) / circle_m2 -
                              1) < 0.01,
                     arc);
        }
    }

    /** An area that encloses the operation is not far, and is listed if it cannot be held. */
    void tooLargeAreasAreReported()
    {
        const AirspaceResult oceanic =
            readAirspace("AC D\nAN oceanic\nDP 20N 90W\nDP 20N 10W\nDP 70N 10W\nDP 70N 90W\n");
        QCOMPARE(oceanic.far, std::size_t{0});
        QCOMPARE(oceanic.rejected.count, std::size_t{1});
        QVERIFY(oceanic.rejected.first[0].fault == IssueId::TooFar);
        QCOMPARE(oceanic.rejected.first[0].line, std::size_t{1});
        const AirspaceResult bare =
            readAirspace("AC D\nAN bare\nAC D\nAN zone\nV X=47N 48W\nDC 2\n");
        QCOMPARE(bare.rejected.first[0].line, std::size_t{1});
    }

    void arcsKeepTheirRadius()
    {
        const Scenario scenario = readAirspace(readFile(kFile)).scenario;
        const LocalFrame frame(scenario.origin);
        const auto spread = [&](const char* name, const LatLon& centre, double radius_m) {
            double worst_m = 0;
            for (const Point& corner_m : airspaceNamed(scenario, name).corners_m) {
                const double away_m = (corner_m - frame.toPlane(centre)).norm();
                if (away_m > 1) // excludes the centre itself
                    worst_m = std::max(worst_m, std::abs(away_m - radius_m));
            }
            return worst_m;
        };
        // The plane is distorted by 1e-4 at this distance.
        QVERIFY(spread("Circle, without a unit", {47 + 1.0 / 6, -48}, 2.5 * 1852) < 3);
        QVERIFY(spread("Arc by bearings", {47, -47.5}, 3 * 1852) < 3);
        QVERIFY(spread("Arc between places", {46 + 5.0 / 6, -48 - 1.0 / 6}, 5558) < 40);

        // Counter-clockwise from east to north is a quarter, and so is clockwise from north to
        // east.
        const double circle_m2 = std::acos(-1.0) * 3 * 3 * 1852 * 1852;
        const double quarter =
            std::abs(signedArea(airspaceNamed(scenario, "Arc by bearings").corners_m) / circle_m2);
        QVERIFY(std::abs(quarter - 0.25) < 0.01);
        const AirspaceArea& other = airspaceNamed(scenario, "Arc between places");
        QVERIFY(
            insidePolygon(other.corners_m, frame.toPlane({46.85, -48.14}))); // in the north-east
        QVERIFY(!insidePolygon(other.corners_m, frame.toPlane({46.82, -48.19})));
        QCOMPARE(other.ceiling_m.value_or(0), 300.0);
    }

    void existingAreasAreNotAddedAgain()
    {
        const Scenario once = readAirspace(readFile(kFile)).scenario;
        const AirspaceResult again = readAirspace(readFile(kFile), once);
        QCOMPARE(again.added, std::size_t{0});
        QCOMPARE(again.known, std::size_t{5});
        QVERIFY(again.scenario == once);
    }

    void geoJsonIsImported()
    {
        const AirspaceResult result = readAirspace(R"({"type": "FeatureCollection", "features": [
            {"type": "Feature", "properties": {"name": "Numbers", "class": "D", "floor_m": 100,
             "ceiling_m": 900, "from_utc": "2026-05-01T06:00:00Z", "until_utc": "soon"},
             "geometry": {"type": "Polygon",
             "coordinates": [[[-48, 47], [-47.9, 47], [-47.9, 47.1], [-48, 47.1], [-48, 47]]]}},
            {"type": "Feature", "properties": {"name": "Limits", "type": "R",
             "lowerLimit": {"value": 1000, "unit": 1}, "upperLimit": {"value": 65, "unit": 6}},
             "geometry": {"type": "MultiPolygon", "coordinates":
             [[[[-48, 46], [-47.9, 46], [-47.9, 46.9]]], [[[-49, 47], [-48.9, 47], [-48.9, 47.1]]]]}},
            {"type": "Feature", "properties": {"name": "Place"},
             "geometry": {"type": "Point", "coordinates": [-48, 47]}},
            {"type": "Feature", "properties": {"name": "Broken"},
             "geometry": {"type": "Polygon", "coordinates": [[[-48, 97], [1, 2], [3, 4]]]}}]})");
        QCOMPARE(result.added, std::size_t{3});
        QCOMPARE(result.rejected.count, std::size_t{1});
        QCOMPARE(result.rejected.first[0].line, std::size_t{4});
        const AirspaceArea& numbers = airspaceNamed(result.scenario, "Numbers");
        QCOMPARE(numbers.kind, std::string("D"));
        QCOMPARE(numbers.floor_m, 100.0);
        QCOMPARE(numbers.ceiling_m.value_or(0), 900.0);
        QCOMPARE(numbers.fromUtc, std::string("2026-05-01T06:00:00Z"));
        QVERIFY(numbers.untilUtc.empty());
        const AirspaceArea& limited = airspaceNamed(result.scenario, "Limits");
        QVERIFY(std::abs(limited.floor_m - 304.8) < 1e-9);
        QVERIFY(std::abs(limited.ceiling_m.value_or(0) - 1981.2) < 1e-9);
    }

    /** A scenario rejects such times, and which of the two is wrong cannot be known. */
    void timesTheWrongWayRoundAreLeftOut()
    {
        const AirspaceResult result =
            readAirspace(R"({"type": "Feature", "properties": {"name": "Late",
            "from_utc": "2026-05-02T00:00Z", "until_utc": "2026-05-01T00:00Z"},
            "geometry": {"type": "Polygon",
            "coordinates": [[[-48, 47], [-47.9, 47], [-47.9, 47.1], [-48, 47.1], [-48, 47]]]}})");
        QCOMPARE(result.added, std::size_t{1});
        const AirspaceArea& late = airspaceNamed(result.scenario, "Late");
        QVERIFY(late.fromUtc.empty() && late.untilUtc.empty());
    }

    /** A bare 500 may be feet or metres. */
    void heightsWithoutUnitAreRejected()
    {
        const auto feature = [](const std::string& name, const std::string& limits) {
            return "{'type': 'Feature', 'properties': {'name': '" + name + "', " + limits +
                   "}, 'geometry': {'type': 'GeometryCollection', 'geometries': [{'type': "
                   "'Polygon', 'coordinates': [[[-48, 47], [-47.9, 47], [-47.9, 47.1], "
                   "[-48, 47.1], [-48, 47]]]}]}}";
        };
        std::string text = "{'type': 'FeatureCollection', 'features': [" +
                           feature("bare", "'floor': 500, 'ceiling': 1500") + ", " +
                           feature("value", "'lower': {'value': 500}") + ", " +
                           feature("ground", "'floor': 0, 'ceiling': '1500 ft'") + "]}";
        std::ranges::replace(text, '\'', '"'); // moc misparses raw strings with quotes
        const AirspaceResult result = readAirspace(text);
        QCOMPARE(result.rejected.count, std::size_t{2});
        QVERIFY(result.rejected.first[1].fault == IssueId::AirspaceUnit);
        QCOMPARE(placeOf(result.rejected, result.rejected.first[1].line), std::string("feature 2"));
        QCOMPARE(result.added, std::size_t{1});
        QVERIFY(std::abs(airspaceNamed(result.scenario, "ground").ceiling_m.value_or(0) - 457.2) <
                1e-9);
    }

    void polygonsWithoutCoordinatesAreRejected()
    {
        std::string text = "{'type': 'Feature', 'properties': {'name': 'R'}, 'geometry': "
                           "{'type': 'GeometryCollection', 'geometries': [{'type': 'Polygon'}, "
                           "{'type': 'Point'}, {'type': 'Polygon', 'coordinates': [[[-48, 47], "
                           "[-47.9, 47], [-47.9, 47.1], [-48, 47.1], [-48, 47]]]}]}}";
        std::ranges::replace(text, '\'', '"'); // moc misparses raw strings with quotes
        const AirspaceResult result = readAirspace(text);
        QCOMPARE(result.added, std::size_t{1});
        QCOMPARE(result.rejected.count, std::size_t{1});
        QVERIFY(result.rejected.first[0].fault == IssueId::AirspaceUnreadable);
    }

    void airspaceOfAnExportIsReadBack_data()
    {
        QTest::addColumn<QString>("format");
        for (const char* format : {"geojson", "kml", "kmz", "czml"})
            QTest::newRow(format) << format;
    }

    /** A Bergwatch export gives back its airspace and nothing else. */
    void airspaceOfAnExportIsReadBack()
    {
        QFETCH(QString, format);
        Scenario scenario = readAirspace(readFile(kFile)).scenario;
        scenario.operation = Operation{};
        scenario.airspace[0].kind.clear();
        scenario.airspace[1].untilUtc = "2026-05-01T12:00:00Z";
        addIceberg(scenario, 1000, 500);
        const Plan plan = planFromStart(scenario);
        const std::string text = findExportFormat(format.toStdString())
                                     ->text(exportContent({.scenario = scenario, .plan = plan}));
        Scenario bare = scenario;
        bare.airspace.clear();
        const AirspaceResult result = readAirspace(text, bare);
        QCOMPARE(rowsSaid(result.rejected), std::string());
        QCOMPARE(result.added, scenario.airspace.size());
        for (const AirspaceArea& area : scenario.airspace) {
            const AirspaceArea& back = airspaceNamed(result.scenario, area.name);
            QCOMPARE(back.kind, area.kind);
            QVERIFY(std::abs(back.floor_m - area.floor_m) < 1e-6);
            QCOMPARE(back.ceiling_m.has_value(), area.ceiling_m.has_value());
            QVERIFY(std::abs(back.ceiling_m.value_or(0) - area.ceiling_m.value_or(0)) < 1e-6);
            QCOMPARE(back.fromUtc, area.fromUtc);
            QCOMPARE(back.untilUtc, area.untilUtc);
            QCOMPARE(back.corners_m.size(), area.corners_m.size());
            for (const Point& corner_m : area.corners_m) // vertices for the map move it by less
                QVERIFY(std::ranges::any_of(back.corners_m, [&](const Point& back_m) {
                    return (back_m - corner_m).norm() < 1;
                }));
        }
    }

    void filesOfOtherProgramsAreRead_data()
    {
        QTest::addColumn<QString>("text");
        // Written by ogr2ogr -f KML, with apostrophes, as moc misparses raw strings with quotes.
        QTest::newRow("kml")
            << u"<?xml version='1.0' encoding='utf-8' ?>\n"
               "<kml xmlns='http://www.opengis.net/kml/2.2'>\n<Document id='root_doc'>\n"
               "<Schema name='a' id='a'>\n<SimpleField name='class' type='string'></SimpleField>\n"
               "<SimpleField name='floor' type='string'></SimpleField>\n"
               "<SimpleField name='ceiling' type='string'></SimpleField>\n</Schema>\n"
               "<Folder><name>a</name>\n<Placemark>\n<name>TRA 1</name>\n"
               "<Style><LineStyle><color>ff0000ff</color></LineStyle><PolyStyle><fill>0</fill>"
               "</PolyStyle></Style>\n<ExtendedData><SchemaData schemaUrl='#a'>\n"
               "<SimpleData name='class'>R</SimpleData>\n<SimpleData "
               "name='floor'>GND</SimpleData>\n"
               "<SimpleData name='ceiling'>FL 65</SimpleData>\n</SchemaData></ExtendedData>\n"
               "<Polygon><outerBoundaryIs><LinearRing><coordinates>-48,47 -47.9,47.0 -47.9,47.1 "
               "-48,47.1 -48,47</coordinates></LinearRing></outerBoundaryIs></Polygon>\n"
               "</Placemark>\n</Folder>\n</Document></kml>"_s;
        QTest::newRow("czml")
            << QString(u"[{'id': 'document', 'version': '1.0'}, {'id': '1', 'name': 'TRA 1', "
                       "'properties': {'class': 'R', 'floor': 'GND', 'ceiling': 'FL 65'}, "
                       "'polygon': {'positions': {'cartographicDegrees': [-48, 47, 0, -47.9, 47, "
                       "0, -47.9, 47.1, 0, -48, 47.1, 0]}}}]"_s)
                   .replace(u'\'', u'"');
    }

    void filesOfOtherProgramsAreRead()
    {
        QFETCH(QString, text);
        const AirspaceResult result = readAirspace(text.toStdString());
        QCOMPARE(rowsSaid(result.rejected), std::string());
        QCOMPARE(result.added, std::size_t{1});
        const AirspaceArea& area = airspaceNamed(result.scenario, "TRA 1");
        QCOMPARE(area.kind, std::string("R"));
        QCOMPARE(area.floor_m, 0.0);
        QVERIFY(std::abs(area.ceiling_m.value_or(0) - 1981.2) < 1e-9);
        QCOMPARE(area.corners_m.size(), std::size_t{4});
        QVERIFY(insidePolygon(area.corners_m,
                              LocalFrame(result.scenario.origin).toPlane({47.05, -47.95})));
    }

    void brokenAreasNameTheirPlaceAndReason_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("place");
        QTest::addColumn<int>("fault");
        const auto row = [](const char* name, const QString& text, const char* place,
                            IssueId fault) {
            QTest::newRow(name) << text << QString(place) << int(fault);
        };
        const auto kml = [](const QString& data, const QString& ring) {
            return u"<kml><Document>\n<Placemark><name>A</name>"_s + data +
                   u"<Polygon><outerBoundaryIs><LinearRing><coordinates>"_s + ring +
                   u"</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark>"_s +
                   u"</Document></kml>"_s;
        };
        const auto czml = [](const QString& degrees) {
            return QString(u"[{'id': 'document'}, {'name': 'A', 'polygon': {'positions': "_s +
                           u"{'cartographicDegrees': ["_s + degrees + u"]}}}]"_s)
                .replace(u'\'', u'"');
        };
        row("kml, place", kml({}, u"-48,47 -47.9,97 -47.9,47.1"_s), "line 2",
            IssueId::AirspaceUnreadable);
        row("kml, no unit",
            kml(u"<ExtendedData><Data name='ceiling'><value>500</value></Data></ExtendedData>"_s,
                u"-48,47 -47.9,47 -47.9,47.1"_s),
            "line 2", IssueId::AirspaceUnit);
        row("czml, place", czml(u"-48, 47, 0, -47.9, 97, 0, -47.9, 47.1, 0"_s), "packet 2",
            IssueId::AirspaceUnreadable);
        row("czml, count", czml(u"-48, 47, 0, -47.9, 47, 0, -47.9, 47.1"_s), "packet 2",
            IssueId::AirspaceUnreadable);
        row("sequence", QString(u"{'type': 'Feature'}\n{'coordinates' 1}\n"_s).replace(u'\'', u'"'),
            "feature 2", IssueId::FeatureBroken);
    }

    void brokenAreasNameTheirPlaceAndReason()
    {
        QFETCH(QString, text);
        QFETCH(QString, place);
        QFETCH(int, fault);
        const AirspaceResult result = readAirspace(text.toStdString());
        QCOMPARE(result.added, std::size_t{0});
        QCOMPARE(result.rejected.count, std::size_t{1});
        const RejectedRow& row = result.rejected.first.front();
        QCOMPARE(placeOf(result.rejected, row.line), place.toStdString());
        QCOMPARE(int(row.fault), fault);
    }

    void otherFilesAreRejected()
    {
        const auto codeOf = [](const std::string& text) {
            const std::optional<Error> error = errorOf([&] { (void)readAirspace(text); });
            return error ? codeName(error->code()) : std::string("none");
        };
        QCOMPARE(codeOf("time,lat,lon\n1,2,3\n"), std::string("WrongFormat"));
        QCOMPARE(codeOf(R"({"type": "FeatureCollection", "features": []})"),
                 std::string("InvalidInput"));
        QCOMPARE(codeOf("{"), std::string("SyntaxError"));
        QCOMPARE(codeOf(""), std::string("WrongFormat"));
    }

    /** A scenario holds a limited number; the others are counted. */
    void areasBeyondTheLimitAreCounted()
    {
        std::string text;
        for (std::size_t i = 0; i < kMostAirspaceAreas + 5; ++i)
            text += "AC D\nAN " + std::to_string(i) +
                    "\nAL GND\nAH UNL\nDP 47:00:00N 048:00:00W\nDP 47:01:00N 048:00:00W\n"
                    "DP 47:00:00N 047:59:00W\n";
        const AirspaceResult result = readAirspace(text);
        QCOMPARE(result.added, kMostAirspaceAreas);
        QCOMPARE(result.tooMany, std::size_t{5});
    }
};

QTEST_APPLESS_MAIN(TestImportAirspace)
#include "tst_import_airspace.moc"
