#include "core/base/stopped.h"
#include "core/checks/validate.h"
#include "core/io/files/scenario_json.h"
#include "core/io/import/import_file.h"
#include "core/io/import/maps/import_ice_chart.h"
#include "core/io/text/ogr2ogr.h"
#include "core/presets/move_origin.h"
#include "tests/support/expect_error.h"
#include "tests/support/flight/scenario_builder.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace berg;
using namespace berg::test;

namespace {

std::string json(std::string text)
{
    std::ranges::replace(text, '\'', '"');
    return text;
}

/** A square of degrees with the origin (47 N, 48 W) at a corner. */
std::string square(double west_deg, double south_deg, double size_deg)
{
    const auto corner = [&](double east, double north) {
        return "[" + std::to_string(west_deg + east * size_deg) + "," +
               std::to_string(south_deg + north * size_deg) + "]";
    };
    return "[" + corner(0, 0) + "," + corner(1, 0) + "," + corner(1, 1) + "," + corner(0, 1) + "," +
           corner(0, 0) + "]";
}

std::string feature(const std::string& properties, const std::string& rings,
                    const std::string& type = "Polygon")
{
    return json("{'type':'Feature','properties':{" + properties + "},'geometry':{'type':'" + type +
                "','coordinates':[" + rings + "]}}");
}

std::string chart(const std::string& features)
{
    return json("{'type':'FeatureCollection','features':[" + features + "]}");
}

/** A chart of one area near the origin. */
std::string oneArea(const std::string& properties)
{
    return chart(feature(properties, square(-48, 47, 0.5)));
}

IceChart read(const std::string& text, const std::string& name = "chart")
{
    return importIceChart(emptySea(), text, name).scenario.iceChart.value();
}

} // namespace

/** Tests of ice charts with codes of SIGRID-3. */
class TestImportIceChart : public QObject
{
    Q_OBJECT

private slots:
    void codesBecomeConcentrations_data()
    {
        QTest::addColumn<QString>("properties");
        QTest::addColumn<double>("tenths"); // −1 means no value
        QTest::addColumn<bool>("isFast");
        QTest::addColumn<QString>("label");
        const auto row = [](const char* properties, double tenths, bool isFast, const char* label) {
            QTest::newRow(properties) << properties << tenths << isFast << label;
        };
        row("'CT':'46','SA':'87','FA':'05','POLY_TYPE':'I'", 5, false, "4-6/10, SA 87 FA 05");
        row("'CT':81,'CA':60,'SA':87,'FA':5,'CB':30,'SB':85", 9, false,
            "8-10/10, CA 60 SA 87 FA 05, CB 30 SB 85");
        row("'CT':'92','FA':'08','POLY_TYPE':'I'", 10, true, "10/10, FA 08");
        row("'CT':'91','POLY_TYPE':'I','CB':'-9','SC':'99'", 9.5, false, "9+/10");
        row("'CT':'01','POLY_TYPE':'W'", 0.5, false, "<1/10");
        row("'CT':'55','POLY_TYPE':'W'", 0, false, "0/10");
        row("'CT':null,'POLY_TYPE':'W'", 0, false, "");
        row("'CT':'99','POLY_TYPE':'I'", -1, false, "");
        row("'ct':'20','poly_type':'I'", 2, false, "2/10");
        row("'CT':'','POLY_TYPE':'N'", -1, false, "");
    }

    void codesBecomeConcentrations()
    {
        QFETCH(QString, properties);
        QFETCH(double, tenths);
        QFETCH(bool, isFast);
        QFETCH(QString, label);
        const IceChart ice = read(oneArea(properties.toStdString()));
        QCOMPARE(ice.areas.size(), 1U);
        const IceArea& area = ice.areas.front();
        QCOMPARE(area.concentration_tenths.value_or(-1), tenths);
        QCOMPARE(area.isFast, isFast);
        QCOMPARE(QString::fromStdString(area.label), label);
    }

    void datesAreFound_data()
    {
        QTest::addColumn<QString>("properties");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("date");
        const auto row = [](const char* properties, const char* name, const char* date) {
            QTest::addRow("%s %s", properties, name) << properties << name << date;
        };
        row("'RECDAT':'20210118'", "x", "2021-01-18T00:00:00Z");
        row("'RECDAT':'2021/01/18 18:00:00+00'", "x", "2021-01-18T18:00:00Z");
        row("'ICEDATE':'2021-01-18T18:00:00Z'", "x_20200101.shp", "2021-01-18T18:00:00Z");
        row("'date_carte':'2021-01-18 18:00'", "x", "2021-01-18T18:00:00Z");
        row("'RECDAT':''", "cis_SGRDREA_20210118T1800Z_pl_a.shp", "2021-01-18T18:00:00Z");
        row("'a':1", "nic_20210118.zip", "2021-01-18T00:00:00Z");
        row("'a':1", "20210118180000_CIS.shp", "2021-01-18T18:00:00Z");
        row("'a':1", "chart 12345678.shp", "");
        row("'a':1", "chart.shp", "");
    }

    void datesAreFound()
    {
        QFETCH(QString, properties);
        QFETCH(QString, name);
        QFETCH(QString, date);
        const IceChart ice = read(oneArea("'CT':'92','POLY_TYPE':'I'," + properties.toStdString()),
                                  name.toStdString());
        QCOMPARE(QString::fromStdString(ice.dateUtc), date);
        QCOMPARE(QString::fromStdString(ice.source), name);
    }

    void holesAndPartsAreKept()
    {
        const std::string hole = square(-47.9, 47.1, 0.1);
        const IceChart ice = read(
            chart(feature("'CT':'92','POLY_TYPE':'I'", square(-48, 47, 0.5) + "," + hole) + "," +
                  feature("'CT':'10','POLY_TYPE':'I'",
                          "[" + square(-47, 47, 0.2) + "],[" + square(-46.5, 47, 0.2) + "]",
                          "MultiPolygon") +
                  "," + feature("'CT':'','POLY_TYPE':'L'", square(-48, 46, 0.5))));
        QCOMPARE(ice.areas.size(), 3U);
        QCOMPARE(ice.areas[0].outlines_m.size(), 2U);
        QCOMPARE(ice.areas[0].outlines_m[0].size(), 4U);
        QCOMPARE(ice.areas[1].outlines_m.size(), 1U);
        QCOMPARE(ice.areas[0].outlines_m[0][0], Point(0, 0));
        Scenario scenario = emptySea();
        scenario.iceChart = ice;
        QVERIFY(validate(scenario).empty());
    }

    void chartsAreCutToTheSurroundings()
    {
        const IceChart ice = read(chart(feature("'CT':'92','POLY_TYPE':'I'", square(-60, 40, 20))));
        QCOMPARE(ice.areas.size(), 1U);
        for (const Point& corner_m : ice.areas[0].outlines_m[0])
            QVERIFY(corner_m.cwiseAbs().maxCoeff() <= kNearIceChart_m);
        QCOMPARE(std::abs(signedArea(ice.areas[0].outlines_m[0])), 6e5 * 6e5);
        const auto error = errorOf(
            [] { (void)read(chart(feature("'CT':'92','POLY_TYPE':'I'", square(10, 70, 1)))); });
        QVERIFY(error && error->issues().front().reason.id == IssueId::NoIceNear);
    }

    void largeChartsAreThinned()
    {
        std::string ring = "[";
        constexpr int kCorners = 60'000;
        for (int i = 0; i <= kCorners; ++i) {
            const double angle_rad = 2 * 3.14159265358979 * (i % kCorners) / kCorners;
            const double radius_deg = 1 + 0.05 * (i % 2);
            ring += (i > 0 ? ",[" : "[") + std::to_string(-48 + radius_deg * std::cos(angle_rad)) +
                    "," + std::to_string(47 + radius_deg * std::sin(angle_rad)) + "]";
        }
        const IceChartResult result = importIceChart(
            emptySea(), chart(feature("'CT':'92','POLY_TYPE':'I'", ring + "]")), "chart");
        QVERIFY(result.thinned_m > 50);
        QVERIFY(validate(result.scenario).empty());
    }

    void smallAreasAreLeftOutOfMany()
    {
        std::string features = feature("'CT':'92','POLY_TYPE':'I'", square(-49, 47, 0.5));
        for (int i = 0; i < 600; ++i)
            features += "," + feature("'CT':'10','POLY_TYPE':'I'",
                                      square(-48 + 0.03 * (i % 30), 47 + 0.03 * (i / 30), 0.02));
        const IceChartResult result = importIceChart(emptySea(), chart(features), "chart");
        QCOMPARE(result.taken, kMostIceAreas);
        QCOMPARE(result.leftOut, 101U);
        QCOMPARE(result.scenario.iceChart->areas.front().concentration_tenths, std::optional(10.0));
    }

    void brokenAreasAreReported()
    {
        const IceChartResult result = importIceChart(
            emptySea(),
            chart(feature("'CT':'92','POLY_TYPE':'I'", square(-48, 47, 0.5)) + "," +
                  feature("'CT':'92','POLY_TYPE':'I'", "[[0,0],[1,1]]") + "," +
                  feature("'CT':'92','POLY_TYPE':'I'", "[[0,'x'],[1,1],[1,2]]") + "," +
                  json("{'type':'Feature','properties':{'CT':'92'},'geometry':null}")),
            "chart");
        QCOMPARE(result.taken, 1U);
        QCOMPARE(result.rejected.count, 2U);
        QCOMPARE(result.rejected.first.front().line, 2U);
    }

    void otherFilesAreNoCharts()
    {
        QVERIFY(!isIceChart(json("{'type':'Point','coordinates':[1,2]}")));
        QVERIFY(!isIceChart(chart(feature("'name':'a'", square(-48, 47, 1)))));
        QCOMPARE(codeOf([] { (void)importIceChart(emptySea(), "a,b\n1,2\n", "x"); }),
                 std::string("WrongFormat"));
        const std::string land = oneArea("'CT':'','POLY_TYPE':'L'");
        QCOMPARE(codeOf([&] { (void)importIceChart(emptySea(), land, "x"); }),
                 std::string("WrongFormat"));
        const std::string whole = oneArea("'CT':'92','POLY_TYPE':'I'");
        QCOMPARE(codeOf([&] {
                     (void)importIceChart(emptySea(), whole.substr(0, whole.size() - 4), "x");
                 }),
                 std::string("SyntaxError"));
        std::stop_source stop;
        stop.request_stop();
        QVERIFY_THROWS_EXCEPTION(Stopped,
                                 (void)importIceChart(emptySea(), whole, "x", stop.get_token()));
    }

    void everyFieldIsStored()
    {
        const Scenario s = loadScenario(BERG_TEST_DATA "/scenarios/every-field.berg");
        QVERIFY(s.iceChart ==
                (IceChart{.source = "cis_SGRDREA_20240226T1800Z",
                          .dateUtc = "2024-02-26T18:00:00Z",
                          .areas = {{.label = "4-6/10",
                                     .concentration_tenths = 5,
                                     .isFast = true,
                                     .outlines_m = {{{-9000, -9000}, {9000, -9000}, {0, 9000}},
                                                    {{-10, -10}, {10, -10}, {0, 10}}},
                                     .extraJson = R"({"stage":"87"})"}},
                          .extraJson = R"({"agency":"CIS"})"}));
        QVERIFY(scenarioFromJson(scenarioToJson(s), "again") == s);
        Scenario without = s;
        without.iceChart.reset();
        QVERIFY(scenarioToJson(without).find("ice_chart") == std::string::npos);
    }

    void tooManyAreasAreNotRead()
    {
        std::string text =
            R"({"format": "bergwatch-scenario", "version": 1, "uavs": [], "icebergs": [], "ice_chart": {"areas": [)";
        for (std::size_t i = 0; i <= kMostIceAreas; ++i)
            text += i > 0 ? ",{}" : "{}";
        const auto error = errorOf([&] { (void)scenarioFromJson(text + "]}}", "file"); });
        QVERIFY(error && names(error->issues(), "ice_chart.areas"));
        for (const char* wrong : {"1", "[1]", "[[1]]", "[[[1, 2], 3]]", R"([[["a", 1]]])"}) {
            const auto fault = errorOf([&] {
                (void)scenarioFromJson(
                    R"({"format": "bergwatch-scenario", "version": 1, "uavs": [{"position_m": [0, 0]}], "icebergs": [], "ice_chart": {"areas": [{"outlines_m": )" +
                        std::string(wrong) + "}]}}",
                    "file");
            });
            QVERIFY2(fault &&
                         fault->issues().front().field.starts_with("ice_chart.areas[0].outlines_m"),
                     wrong);
        }
    }

    void chartMovesWithTheOrigin()
    {
        Scenario scenario = emptySea();
        scenario.iceChart = read(oneArea("'CT':'92','POLY_TYPE':'I'"));
        const Scenario moved =
            movedTo(scenario, {.latitude_deg = 47.5, .longitude_deg = -48}, MoveMode::KeepPlaces);
        const Point corner_m = moved.iceChart->areas[0].outlines_m[0][0];
        QVERIFY(std::abs(corner_m.y() + 55'590) < 50);
    }

    /** A chart in a polar projection, as ice services publish it. */
    void shapefilesAreRead()
    {
        if (ogr2ogrPath().empty())
            QSKIP("ogr2ogr is not installed");
        const QTemporaryDir dir;
        QFile given(dir.filePath("given.geojson"));
        QVERIFY(given.open(QIODevice::WriteOnly));
        std::string features;
        int count = 0;
        for (const char* code : {"00", "01", "02", "13", "46", "79", "81", "91", "92"}) {
            features +=
                (count > 0 ? "," : "") +
                feature("'CT':'" + std::string(code) + "','POLY_TYPE':'I','RECDAT':'20210118'",
                        square(-48 + 0.2 * count, 47, 0.1));
            ++count;
        }
        given.write(QByteArray::fromStdString(chart(features)));
        given.close();
        for (const QString name : {"chart.shp", "chart.shp.zip", "chart.gpkg", "chart.fgb"}) {
            QProcess process;
            process.start("ogr2ogr", {"-t_srs", "EPSG:3413", dir.filePath(name),
                                      dir.filePath("given.geojson")});
            QVERIFY(process.waitForFinished());
            const std::string path = dir.filePath(name).toStdString();
            const std::string text = readImportFile(path, "chart");
            QVERIFY2(isIceChart(text), text.c_str());
            const IceChart ice = read(text);
            QCOMPARE(ice.areas.size(), 9U);
            QCOMPARE(ice.dateUtc, std::string("2021-01-18T00:00:00Z"));
            QVERIFY(std::ranges::any_of(ice.areas, [](const IceArea& area) {
                return area.concentration_tenths == 5.0 && area.label == "4-6/10";
            }));
            QVERIFY(std::ranges::all_of(ice.areas, [](const IceArea& area) {
                return area.outlines_m[0].size() == 4 && area.outlines_m[0][0].norm() < 200'000;
            }));
        }
    }
};

QTEST_GUILESS_MAIN(TestImportIceChart)
#include "tst_import_ice_chart.moc"
