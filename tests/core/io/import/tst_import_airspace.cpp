#include "core/base/geometry.h"
#include "core/io/import/import_airspace.h"
#include "core/io/text/atomic_file.h"
#include "core/scenario/presets.h"
#include "core/scenario/validate.h"
#include "tests/support/expect_error.h"
#include "tests/support/export_text.h"
#include "tests/support/scenario_builder.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace berg;
using namespace berg::test;

namespace {

const std::string kFile = BERG_TEST_DATA "/import/airspace.openair";

AirspaceResult read(const std::string& text, const Scenario& base = emptySea())
{
    return importAirspace(base, text, "file");
}

const AirspaceArea& named(const Scenario& scenario, std::string_view name)
{
    for (const AirspaceArea& area : scenario.airspace)
        if (area.name == name)
            return area;
    throw std::logic_error("no airspace " + std::string(name));
}

} // namespace

class TestImportAirspace : public QObject
{
    Q_OBJECT

private slots:
    void heightsAreRead_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("height_m"); // -1: none
        const auto row = [](const char* text, double height_m) {
            QTest::newRow(text) << QString::fromLatin1(text) << height_m;
        };
        row("GND", 0);
        row("sfc", 0);
        row("1500", 457.2);
        row("1500 ft AMSL", 457.2);
        row("1500ft AGL", 457.2);
        row("1500FT", 457.2);
        row("FL 65", 1981.2);
        row("FL65", 1981.2);
        row("500 M AGL", 500);
        row("500m", 500);
        row("500 meters", 500);
        row("500 m/MSL", 500);
        row("1500 MSL", 457.2);
        row("3,500 ft", -1); // not 3
        row("1e15 M", -1);
        row("UNL", HUGE_VAL);
        row("UNLIM", HUGE_VAL);
        row("Ask on 122.8", -1);
        row("", -1);
        row("-100 ft", -1);
    }
    void heightsAreRead()
    {
        QFETCH(QString, text);
        QFETCH(double, height_m);
        const std::optional<double> read_m = airspaceHeight_m(text.toStdString());
        QCOMPARE(read_m.has_value(), height_m >= 0);
        QVERIFY(!read_m || *read_m == height_m || std::abs(*read_m - height_m) < 1e-9);
    }

    void openAirIsTakenOver()
    {
        const AirspaceResult result = read(readFile(kFile));
        QCOMPARE(result.added, std::size_t{4});
        QCOMPARE(result.far, std::size_t{1});
        QCOMPARE(result.rejected.count, std::size_t{2});
        QCOMPARE(result.rejected.first[0].line, std::size_t{41});
        QVERIFY(result.rejected.first[0].fault == IssueId::AirspaceUnreadable);
        QCOMPARE(result.rejected.first[1].detail, std::string("Crossing itself"));
        QVERIFY(result.rejected.first[1].fault == IssueId::AirspaceOutline);
        QVERIFY(!hasErrors(validate(result.scenario)));

        const AirspaceArea& square = named(result.scenario, "Grand Banks West");
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

    /** Of several times the whole span; always, where one is not understood. */
    void everyTimeCounts()
    {
        const auto area = [](const std::string& times) {
            return read("AC D\nAN zone\n" + times + "V X=47N 48W\nDC 2\n").scenario.airspace.at(0);
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

    void wholeCircles()
    {
        for (const char* const arc : {"DA 2,0,360", "V D=-\nDA 2,0,360", "DC 2"}) {
            const Scenario scenario =
                read("AC\tD\nAN zone\nV X=47N 48W\n" + std::string(arc) + '\n').scenario;
            const double circle_m2 = std::acos(-1.0) * 4 * 1852 * 1852;
            QVERIFY2(std::abs(std::abs(signedArea(scenario.airspace.at(0).corners_m)) / circle_m2 -
                              1) < 0.01,
                     arc);
        }
    }

    /** One that encloses the operation is not far, and is told of when it cannot be held. */
    void whatIsTooLargeIsTold()
    {
        const AirspaceResult oceanic =
            read("AC D\nAN oceanic\nDP 20N 90W\nDP 20N 10W\nDP 70N 10W\nDP 70N 90W\n");
        QCOMPARE(oceanic.far, std::size_t{0});
        QCOMPARE(oceanic.rejected.count, std::size_t{1});
        QVERIFY(oceanic.rejected.first[0].fault == IssueId::TooFar);
        QCOMPARE(oceanic.rejected.first[0].line, std::size_t{1});
        const AirspaceResult bare = read("AC D\nAN bare\nAC D\nAN zone\nV X=47N 48W\nDC 2\n");
        QCOMPARE(bare.rejected.first[0].line, std::size_t{1});
    }

    void arcsKeepTheirRadius()
    {
        const Scenario scenario = read(readFile(kFile)).scenario;
        const LocalFrame frame(scenario.origin);
        const auto spread = [&](const char* name, const LatLon& centre, double radius_m) {
            double worst_m = 0;
            for (const Point& corner_m : named(scenario, name).corners_m) {
                const double away_m = (corner_m - frame.toPlane(centre)).norm();
                if (away_m > 1) // not the centre itself
                    worst_m = std::max(worst_m, std::abs(away_m - radius_m));
            }
            return worst_m;
        };
        // The plane is a tenth of a per mille off at this distance.
        QVERIFY(spread("Circle, without a unit", {47 + 1.0 / 6, -48}, 2.5 * 1852) < 3);
        QVERIFY(spread("Arc by bearings", {47, -47.5}, 3 * 1852) < 3);
        QVERIFY(spread("Arc between places", {46 + 5.0 / 6, -48 - 1.0 / 6}, 5558) < 40);

        // Counter-clockwise from east to north: a quarter; clockwise from north to east likewise.
        const double circle_m2 = std::acos(-1.0) * 3 * 3 * 1852 * 1852;
        const double quarter =
            std::abs(signedArea(named(scenario, "Arc by bearings").corners_m) / circle_m2);
        QVERIFY(std::abs(quarter - 0.25) < 0.01);
        const AirspaceArea& other = named(scenario, "Arc between places");
        QVERIFY(
            insidePolygon(other.corners_m, frame.toPlane({46.85, -48.14}))); // in the north-east
        QVERIFY(!insidePolygon(other.corners_m, frame.toPlane({46.82, -48.19})));
        QCOMPARE(other.ceiling_m.value_or(0), 300.0);
    }

    void whatIsThereIsNotAddedAgain()
    {
        const Scenario once = read(readFile(kFile)).scenario;
        const AirspaceResult again = read(readFile(kFile), once);
        QCOMPARE(again.added, std::size_t{0});
        QCOMPARE(again.known, std::size_t{4});
        QVERIFY(again.scenario == once);
    }

    void geoJsonIsTakenOver()
    {
        const AirspaceResult result = read(R"({"type": "FeatureCollection", "features": [
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
        const AirspaceArea& numbers = named(result.scenario, "Numbers");
        QCOMPARE(numbers.kind, std::string("D"));
        QCOMPARE(numbers.floor_m, 100.0);
        QCOMPARE(numbers.ceiling_m.value_or(0), 900.0);
        QCOMPARE(numbers.fromUtc, std::string("2026-05-01T06:00:00Z"));
        QVERIFY(numbers.untilUtc.empty());
        const AirspaceArea& limited = named(result.scenario, "Limits");
        QVERIFY(std::abs(limited.floor_m - 304.8) < 1e-9);
        QVERIFY(std::abs(limited.ceiling_m.value_or(0) - 1981.2) < 1e-9);
    }

    /** A scenario refuses them, and which of the two is wrong nobody knows. */
    void timesTheWrongWayRoundAreLeftOut()
    {
        const AirspaceResult result = read(R"({"type": "Feature", "properties": {"name": "Late",
            "from_utc": "2026-05-02T00:00Z", "until_utc": "2026-05-01T00:00Z"},
            "geometry": {"type": "Polygon",
            "coordinates": [[[-48, 47], [-47.9, 47], [-47.9, 47.1], [-48, 47.1], [-48, 47]]]}})");
        QCOMPARE(result.added, std::size_t{1});
        const AirspaceArea& late = named(result.scenario, "Late");
        QVERIFY(late.fromUtc.empty() && late.untilUtc.empty());
    }

    /** 500 may be feet or metres. */
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
        std::ranges::replace(text, '\'', '"'); // moc loses its way in raw strings
        const AirspaceResult result = read(text);
        QCOMPARE(result.rejected.count, std::size_t{2});
        QVERIFY(result.rejected.first[1].fault == IssueId::AirspaceUnit);
        QCOMPARE(placeOf(result.rejected, result.rejected.first[1].line), std::string("feature 2"));
        QCOMPARE(result.added, std::size_t{1});
        QVERIFY(std::abs(named(result.scenario, "ground").ceiling_m.value_or(0) - 457.2) < 1e-9);
    }

    /** An export of our own gives back its airspace, and nothing else of it. */
    void ownExportComesBack()
    {
        Scenario scenario = read(readFile(kFile)).scenario;
        scenario.operation = Operation{};
        scenario.airspace[0].kind.clear();
        addIceberg(scenario, 1000, 500);
        const PlanAnswer plan = planFromStart(scenario);
        const std::string text = geoJson(exportContent({.scenario = scenario, .plan = plan}));
        Scenario bare = scenario;
        bare.airspace.clear();
        const AirspaceResult result = read(text, bare);
        QCOMPARE(result.added, scenario.airspace.size());
        for (const AirspaceArea& area : scenario.airspace) {
            const AirspaceArea& back = named(result.scenario, area.name);
            QCOMPARE(back.kind, area.kind);
            QVERIFY(std::abs(back.floor_m - area.floor_m) < 1e-6);
            QCOMPARE(back.ceiling_m.has_value(), area.ceiling_m.has_value());
            QCOMPARE(back.fromUtc, area.fromUtc);
            QVERIFY(std::abs(std::abs(signedArea(back.corners_m)) -
                             std::abs(signedArea(area.corners_m))) <
                    1e-4 * std::abs(signedArea(area.corners_m)));
        }
    }

    void otherFilesAreRefused()
    {
        const auto codeOf = [](const std::string& text) {
            const std::optional<Error> error = errorOf([&] { (void)read(text); });
            return error ? codeName(error->code()) : std::string("none");
        };
        QCOMPARE(codeOf("time,lat,lon\n1,2,3\n"), std::string("WrongFormat"));
        QCOMPARE(codeOf(R"({"type": "FeatureCollection", "features": []})"),
                 std::string("InvalidInput"));
        QCOMPARE(codeOf("{"), std::string("SyntaxError"));
        QCOMPARE(codeOf(""), std::string("WrongFormat"));
    }

    /** A scenario holds so many; the others are counted. */
    void tooManyAreToldOf()
    {
        std::string text;
        for (std::size_t i = 0; i < kMostAirspaceAreas + 5; ++i)
            text += "AC D\nAN " + std::to_string(i) +
                    "\nAL GND\nAH UNL\nDP 47:00:00N 048:00:00W\nDP 47:01:00N 048:00:00W\n"
                    "DP 47:00:00N 047:59:00W\n";
        const AirspaceResult result = read(text);
        QCOMPARE(result.added, kMostAirspaceAreas);
        QCOMPARE(result.tooMany, std::size_t{5});
    }
};

QTEST_APPLESS_MAIN(TestImportAirspace)
#include "tst_import_airspace.moc"
