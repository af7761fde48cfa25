#include "core/checks/validate.h"
#include "core/geometry/geometry.h"
#include "tests/support/files/airspace_test.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <cstdio>

using namespace berg;
using namespace berg::test;

/** Tests of OpenAir as people write it. */
class TestImportOpenair : public QObject
{
    Q_OBJECT

private slots:
    /** An area begins even if its class is missing. */
    void missingClassBeginsAnArea()
    {
        const std::string alpha =
            "AC R\nAN Alpha\nAL GND\nAH 1000 ft\nDP 47:03:00 N 047:58:00 W\n"
            "DP 47:00:00 N 047:58:00 W\nDP 47:00:00 N 048:02:00 W\nDP 47:03:00 N 048:02:00 W\n";
        const std::string bravo =
            "AN Bravo\nAL 2000 ft\nAH 4000 ft\nDP 47:05:00 N 048:02:00 W\n"
            "DP 47:08:00 N 048:02:00 W\nDP 47:08:00 N 047:58:00 W\nDP 47:05:00 N 047:58:00 W\n";
        const std::string charlie =
            "AC C\nAN Charlie\nAL GND\nAH 500 ft\nV X=47:10:00 N 048:00:00 W\nDC 0.5\n";
        for (const char* begin : {"AC\n", "ac \t\n", "AC * none\n", ""}) {
            const AirspaceResult result =
                readAirspace(alpha + '\n' + begin + bravo + '\n' + charlie);
            QCOMPARE(result.added, std::size_t{3});
            QCOMPARE(result.rejected.count, std::size_t{0});
            QCOMPARE(rowsSaid(result.noted), std::string("10 airspace taken without a class: "
                                                         "\"Bravo\"\n"));
            const AirspaceArea& first = airspaceNamed(result.scenario, "Alpha");
            QVERIFY(first.floor_m == 0 && std::abs(first.ceiling_m.value_or(0) - 304.8) < 1e-9);
            QVERIFY(std::abs(std::abs(signedArea(first.corners_m)) - 28.17e6) < 0.05e6);
            const AirspaceArea& second = airspaceNamed(result.scenario, "Bravo");
            QVERIFY(second.kind.empty() && std::abs(second.floor_m - 609.6) < 1e-9);
            QVERIFY(std::abs(second.ceiling_m.value_or(0) - 1219.2) < 1e-9);
            QVERIFY(std::abs(std::abs(signedArea(second.corners_m)) - 28.17e6) < 0.1e6);
            QCOMPARE(airspaceNamed(result.scenario, "Charlie").kind, std::string("C"));
        }
    }

    /** Whatever an area lacks, it does not take records of another one. */
    void areasEndWhereOthersBegin()
    {
        const std::string box = "DP 47:00N 48:02W\nDP 47:03N 48:02W\nDP 47:03N 47:58W\n";
        const std::string heights = "AL GND\nAH 500 ft\n";
        const auto names = [](const AirspaceResult& result) {
            std::string text;
            for (const AirspaceArea& area : result.scenario.airspace)
                text +=
                    area.kind + '/' + area.name + '/' + std::to_string(area.corners_m.size()) + ' ';
            return text;
        };
        QCOMPARE(names(readAirspace("AN one\n" + heights + box + "AN two\n" + heights + box + box)),
                 std::string("/one/3 /two/3 "));
        QCOMPARE(names(readAirspace("AN one\nAC D\n" + heights + box + "AN two\nAC R\n" + heights +
                                    "DP 47:00N 48:12W\nDP 47:03N 48:12W\nDP 47:03N 48:08W\n")),
                 std::string("D/one/3 R/two/3 "));
        QCOMPARE(names(readAirspace("AC D\n" + heights + box + "AN one\nAC R\nAN two\n" + heights +
                                    "DP 47:00N 48:12W\nDP 47:03N 48:12W\nDP 47:03N 48:08W\n")),
                 std::string("D/one/3 R/two/3 "));
        const AirspaceResult terrain = readAirspace("AC D\nAN one\n" + heights + box +
                                                    "TO lake\nDP 46:00N 47W\nAC R\nAN two\n");
        QCOMPARE(names(terrain), std::string("D/one/3 "));
        QCOMPARE(rowsSaid(terrain.rejected),
                 std::string("10 airspace left out: it has no outline: \"two\"\n"));
        const AirspaceResult stray =
            readAirspace("SP 0,1,0,0,255\nAL GND\n" + box + "AC D\nAN one\n" + heights + box);
        QCOMPARE(names(stray), std::string("D/one/3 "));
        QCOMPARE(rowsSaid(stray.rejected),
                 std::string("3 outline left out: no airspace begins above "
                             "it: \"DP 47:00N 48:02W\"\n"));
    }

    /** Classes with only colours are not areas. */
    void coloursOfClassesAreNoAreas()
    {
        const AirspaceResult result = readAirspace(
            "AC A\nSP 0,1,0,0,255\nSB -1,-1,-1\nAC B\nSP 0,2,255,0,0\nAC D\nAN one\nAL "
            "GND\nAH UNL\nSP 0,1,2,3,4\nSB 1,2,3\nV Z=100\nAF 122.8\nAX 7000\nV X=47N "
            "48W\nDC 2\n");
        QCOMPARE(result.added, std::size_t{1});
        QCOMPARE(result.rejected.count + result.noted.count, std::size_t{0});
    }

    void valuesAreReadCompletely_data()
    {
        QTest::addColumn<QString>("shape");
        QTest::addColumn<double>("area_km2"); // 0 if the area is left out
        const auto row = [](const char* shape, double area_km2) {
            QTest::newRow(shape) << QString::fromUtf8(shape) << area_km2;
        };
        const double disc_km2 = std::acos(-1.0) * 2.5 * 2.5 * 1.852 * 1.852;
        const char* const square = "DP 46:59:60 N 048:01:60 W\nDP 47:02:60 N 048:02:00 W\n"
                                   "DP 47:03:00 N 047:58:00 W\nDP 47:00:00 N 047:58:00 W";
        row(square, 28.17);
        row("DP 46:60 N 048:02 W\nDP 47:03 N 048:02 W\nDP 47:03 N 047:58 W\nDP 47:00 N 047:58 W",
            28.17);
        row("DP47:00N 048:02W\nDP 47:03N,048:02W\nDP 47:3.0N 47:58W\nDPN47:00 W47:58.000", 28.17);
        row("DP 47\u00b000'00\"N 048\u00b002'00\"W\nDP 47 03 00 N 48 2 0 W\nDP 47,05 N 47:58 W\n"
            "dp 47n 47:58:00.00w",
            28.17);
        row("DP 048:02 W 47:00 N\nDP 48:02W 47:03N\nDP 47:03 N 047:58 W\nDP 47:00 N 047:58 W",
            28.17);
        for (const char* radius : {"2.5", "2,5", "2.5 NM", "2.5NM", "4.63 km", "4630 m"})
            row(("V X=47N 48W\nDC " + std::string(radius)).c_str(), disc_km2);
        row("V X=47N 48W\nDA 2,5, 0, 180\nDA 2,5, 180, 360", disc_km2);
        row("V X=47N 48W\nDA 2.5;0;180\nDA 2,5;180;360", disc_km2);
        row("V D = -\nVX=47N 48W\nDA2.5,180,0\nDA 2.5,360,180", disc_km2);
        row("V X=47N 48W\nDC 47:00:00 N 047:58:00 W", 0);
        for (const char* wrong : {"DP 47:00:61 N 48W",
                                  "DP 47:61 N 48W",
                                  "DP 47.5:30 N 48W",
                                  "DP 47 48",
                                  "DP -47 N 48W",
                                  "DP 91N 48W",
                                  "DP 47N 181W",
                                  "DP 47N 48N",
                                  "DP 47N 48W 12",
                                  "DP 47N 48W and so on",
                                  "DC",
                                  "DC 0",
                                  "DC -2",
                                  "DC 2.5.1",
                                  "DC 2 3",
                                  "DC 2 furlongs",
                                  "DC 1e3",
                                  "DC 5000",
                                  "DA 2,5,90,180",
                                  "DA 2.5,0,400",
                                  "DA 2.5,90",
                                  "V D=left",
                                  "V X=47N",
                                  "DB 47N 48W",
                                  "DB 47N 48W, 47N",
                                  "DX 47N 48W",
                                  "D 2"})
            row(("DP 47N 47:50W\nDP 47N 47:51W\nDP 47:01N 47:51W\nV X=47N 48W\n" +
                 std::string(wrong))
                    .c_str(),
                0);
    }
    void valuesAreReadCompletely()
    {
        QFETCH(QString, shape);
        QFETCH(double, area_km2);
        const AirspaceResult result =
            readAirspace("AC D\nAN it\nAL GND\nAH 1000 ft\n" + shape.toStdString() + '\n');
        QCOMPARE(result.added, std::size_t{area_km2 > 0});
        QCOMPARE(result.rejected.count, std::size_t{area_km2 == 0});
        if (area_km2 > 0) {
            const double read_m2 = std::abs(signedArea(result.scenario.airspace[0].corners_m));
            QVERIFY2(read_m2 > area_km2 * 0.9999e6 && read_m2 < area_km2 * 1.003e6,
                     qPrintable(QString::number(read_m2)));
        } else {
            QVERIFY(result.rejected.first[0].fault == IssueId::AirspaceUnreadable);
            QVERIFY(result.rejected.first[0].detail.starts_with("it: "));
        }
    }

    void commentsBehindValuesAreIgnored()
    {
        const AirspaceResult result = readAirspace(
            "* a comment\n# another\nAC R * class\nAN Name * with comment\nAL GND * floor\n"
            "AH FL65 * top\nDP 47:00:00 N 048:02:00 W * corner\nDP 47:03:00 N 048:02:00 W *\n"
            "DP 47:03:00 N 047:58:00 W *corner\n");
        const AirspaceArea& area = airspaceNamed(result.scenario, "Name");
        QCOMPARE(area.kind, std::string("R"));
        QVERIFY(area.floor_m == 0 && std::abs(area.ceiling_m.value_or(0) - 1981.2) < 1e-9);
        QCOMPARE(result.noted.count, std::size_t{0});
    }

    /** No part of a border with a loop is lost. */
    void outlineThatCrossesItselfIsCovered()
    {
        const AirspaceResult result = readAirspace(
            "AC D\nAN Spike at the border\nAL GND\nAH 2500 ft\nDP 47:00:00 N 048:06:00 W\n"
            "DP 47:06:00 N 048:06:00 W\nDP 47:06:00 N 048:00:20 W\nDP 47:06:00 N 047:54:00 W\n"
            "DP 47:03:00 N 047:54:00 W\nDP 47:02:50 N 047:53:40 W\nDP 47:03:10 N 047:54:10 W\n"
            "DP 47:00:00 N 047:54:00 W\n");
        QCOMPARE(result.added, std::size_t{1});
        const AirspaceArea& area = result.scenario.airspace[0];
        QVERIFY(isSimplePolygon(area.corners_m));
        const double area_m2 = std::abs(signedArea(area.corners_m));
        QVERIFY2(area_m2 > 168.2e6 && area_m2 < 169.5e6, qPrintable(QString::number(area_m2)));
        QVERIFY(std::abs(area.ceiling_m.value_or(0) - 762) < 1e-9);
        QCOMPARE(rowsSaid(result.noted),
                 std::string("1 airspace taken with an outline round its own, which touches or "
                             "crosses itself: \"Spike at the border\"\n"));
    }

    /** An outline with more corners than a scenario holds is enclosed by one with fewer. */
    void manyCornersAreReduced()
    {
        std::string text = "AC D\nAN coast\nAL GND\nAH 1000 ft\n";
        const LocalFrame frame(emptySea().origin);
        std::vector<Point> true_m;
        for (int i = 0; i < 3000; ++i) {
            const double bearing_rad = 2 * std::acos(-1.0) * i / 3000;
            const double radius_m = i % 2 == 0 ? 20000 : 19900;
            const LatLon place =
                frame.toGeographic(radius_m * Point(std::sin(bearing_rad), std::cos(bearing_rad)));
            true_m.push_back(frame.toPlane(place));
            std::array<char, 80> line{};
            std::snprintf(line.data(), line.size(), "DP %.8f N %.8f W\n", place.latitude_deg,
                          -place.longitude_deg);
            text += line.data();
        }
        const AirspaceResult result = readAirspace(text);
        const AirspaceArea& area = airspaceNamed(result.scenario, "coast");
        QVERIFY(!hasErrors(validate(result.scenario)));
        for (const Point& corner_m : true_m)
            QVERIFY(insidePolygon(area.corners_m, 0.9999 * corner_m));
        QVERIFY(std::abs(signedArea(area.corners_m)) < 1.01 * std::abs(signedArea(true_m)));
        QVERIFY(result.noted.first.at(0).fault == IssueId::AirspaceCorners);
    }

    void airwaysBecomeALegEach()
    {
        const AirspaceResult result =
            readAirspace("AC D\nAN airway\nAL GND\nAH FL 95\nV W=2\nDY 47N "
                         "48:10W\nDY 47N 48W\nDY 47:10N 48W\n");
        QCOMPARE(result.added, std::size_t{2});
        const LocalFrame frame(result.scenario.origin);
        const Point beside_m = frame.toPlane({47.0, -48.1}) + Point(0, 1800);
        QVERIFY(insidePolygon(result.scenario.airspace[0].corners_m, beside_m));
        QCOMPARE(readAirspace("AC D\nAN airway\nDY 47N 48:10W\nDY 47N 48W\n").rejected.count,
                 std::size_t{1});
    }

    /**
     * If there are two floors or ceilings, the one that makes the area larger counts, in either
     * order.
     */
    void heightsGivenTwiceGiveTheLargerArea()
    {
        const auto area = [](const std::string& heights) {
            return readAirspace("AC D\nAN it\n" + heights + "V X=47N 48W\nDC 2\n")
                .scenario.airspace.at(0);
        };
        for (const char* heights : {"AL 5200ft\nAH 5700ft\nAL 1000 ft\nAH 2000 ft\n",
                                    "AL 1000 ft\nAH 2000 ft\nAL 5200ft\nAH 5700ft\n"}) {
            QVERIFY(std::abs(area(heights).floor_m - 304.8) < 1e-9);
            QVERIFY(std::abs(area(heights).ceiling_m.value_or(0) - 1737.36) < 1e-9);
        }
        QVERIFY(!area("AL GND\nAH UNL\nAH 500 ft\n").ceiling_m);
        QVERIFY(!area("AL GND\nAH 500 ft\nAH UNL\n").ceiling_m);
    }

    /** The forms are those of Naviter's description, 2.1. */
    void formsOfTheDescriptionAreRead()
    {
        const AirspaceResult result =
            readAirspace("*VERSION: 2.0\nAC UNC\nAY GSEC\nAN it\nAF 123.300\nAG Radar\nAX 7000\n"
                         "AA 2023-12-16T12:00Z/2023-12-16T13:00Z   ; Active from 12:00\nAH FL145\n"
                         "AL 1000ft AMSL\nV X=47:00N 048:00W\n"
                         "DB 47:05:00N 048:00:00W, 47:00:00N, 047:52:40W\nDP 47:00N 048:00W\n");
        QCOMPARE(result.added, std::size_t{1});
        QCOMPARE(result.noted.count, std::size_t{0});
        const AirspaceArea& area = result.scenario.airspace[0];
        QCOMPARE(area.kind, std::string("GSEC"));
        QCOMPARE(area.untilUtc, std::string("2023-12-16T13:00Z"));
        const double quarter_km2 = std::acos(-1.0) * 9.27 * 9.27 / 4;
        const double area_km2 = std::abs(signedArea(area.corners_m)) / 1e6;
        QVERIFY2(std::abs(area_km2 / quarter_km2 - 1) < 0.01,
                 qPrintable(QString::number(area_km2)));
    }

    void heightsThatAreMissingAreNoted()
    {
        const AirspaceResult result =
            readAirspace("AC D\nAN it\nV X=47N 48W\nDC 2\nAG Radio\nHello\n");
        QCOMPARE(result.added, std::size_t{1});
        QCOMPARE(rowsSaid(result.noted),
                 std::string("6 line not understood and not used: \"Hello\"\n"
                             "1 airspace taken down to the sea: its floor is missing or cannot be "
                             "read: \"it: AL\"\n"
                             "1 airspace taken without end above: its ceiling is missing or cannot "
                             "be read: \"it: AH\"\n"));
        const AirspaceResult thin =
            readAirspace("AC D\nAN it\nAL 500 ft\nAH 500 ft\nV X=47N 48W\nDC 2\n");
        QVERIFY(thin.rejected.first.at(0).fault == IssueId::AirspaceThin);
    }

    void otherTextsAreNoOpenAir()
    {
        for (const char* text : {"", "AC;AN;DP\n1;2;3\n", "AC D\nlat,lon\n1,2\n",
                                 "name,lat\nAC D\nDP 47N 48W\n", "AN\nx\n"})
            QVERIFY2(!isOpenAir(text), text);
        for (const char* text : {"AN x\nDP 47N 48W\n", "* c\nac d\r\nal gnd\r\n",
                                 "AC\rAN x\rAH FL 65\r", "SP 0,1,2\nAC D\nDP 47N 48W"})
            QVERIFY2(isOpenAir(text), text);
    }
};

QTEST_APPLESS_MAIN(TestImportOpenair)
#include "tst_import_openair.moc"
