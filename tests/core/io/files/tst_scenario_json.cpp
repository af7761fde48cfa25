#include "core/checks/validate.h"
#include "core/io/files/scenario_json.h"
#include "core/io/text/atomic_file.h"
#include "core/presets/presets.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/flight/random_scenario.h"

#include <QTemporaryDir>
#include <QTest>

#include <bit>
#include <clocale>
#include <limits>
#include <locale>

using namespace berg;
using namespace berg::test;

namespace {

const std::string kData = BERG_TEST_DATA "/scenarios/";

/** Returns scenario text with the given members in place of the defaults. */
std::string textWith(const std::string& members)
{
    return R"({"format": "bergwatch-scenario", "version": 1, )" + members + "}";
}

const std::string kUav = R"("uavs": [{"position_m": [0, 0]}])";

Scenario read(const std::string& text)
{
    return scenarioFromJson(text, "text");
}

/**
 * Sets a locale with decimal commas for C++ streams and, where the system has one, for C functions.
 */
class CommaLocale
{
public:
    CommaLocale()
    {
        for (const char* name : {"de_DE.UTF-8", "nb_NO.UTF-8", "fr_FR.UTF-8", "da_DK.UTF-8"})
            if (std::setlocale(LC_ALL, name) != nullptr)
                break;
        std::locale::global(std::locale(std::locale(), new Comma));
    }
    CommaLocale(const CommaLocale&) = delete;
    CommaLocale& operator=(const CommaLocale&) = delete;
    ~CommaLocale()
    {
        std::locale::global(std::locale::classic());
        std::setlocale(LC_ALL, "C");
    }

private:
    class Comma final : public std::numpunct<char>
    {
    protected:
        [[nodiscard]] char do_decimal_point() const override { return ','; }
        [[nodiscard]] char do_thousands_sep() const override { return '.'; }
        [[nodiscard]] std::string do_grouping() const override { return "\3"; }
    };
};

} // namespace

class TestScenarioJson : public QObject
{
    Q_OBJECT

private slots:
    void defaultsOfAMinimalFile()
    {
        const Scenario s = loadScenario(kData + "minimal.berg");
        Scenario expected;
        Uav uav;
        uav.id = "uav-1";
        expected.uavs.push_back(uav);
        QVERIFY(s == expected);
        QCOMPARE(s.duration_s, 1000.0);
        QCOMPARE(s.uavs[0].spec.airspeed_mps, 22.0);
        QCOMPARE(s.uavs[0].spec.endurance_s, 0.0);
        QCOMPARE(s.uavs[0].turnaround_s, 600.0);
        QVERIFY(!s.uavs[0].home_m && !s.geofence);
        QCOMPARE(s.separation_m, 200.0);
        QVERIFY(s.planner.policy == PolicyKind::Visitation);
        QVERIFY(!s.asset && !s.reachRadius_m && s.area_m.empty() && s.noise);
    }

    void everyFieldIsRead()
    {
        const Scenario s = loadScenario(kData + "every-field.berg");
        QCOMPARE(s.name, std::string("Every field \xE2\x80\x93 alle Felder"));
        QCOMPARE(s.notes, std::string("A line\nand another."));
        QVERIFY(s.origin == (LatLon{.latitude_deg = -64.25, .longitude_deg = 179.5}));
        QCOMPARE(s.startUtc, std::string("2024-02-29T23:59:59.250Z"));
        QCOMPARE(s.duration_s, 3600.0);
        QCOMPARE(s.seed, std::int64_t{1} << 53);
        QCOMPARE(s.dt_s, 0.05);
        QVERIFY(!s.noise);
        QVERIFY(s.wind_mps == Point(3, -4));
        QVERIFY(s.current_mps == Point(0.25, 0.5));
        QCOMPARE(s.area_m.size(), std::size_t{5});
        QVERIFY(s.area_m[3] == Point(2000, 2000));
        QVERIFY(s.geofence);
        QCOMPARE(s.separation_m, 350.0);
        QVERIFY(s.planner == (PlannerSettings{.policy = PolicyKind::Tour,
                                              .tau = 0.75,
                                              .route = Route::Closed,
                                              .backend = Backend::Heuristic,
                                              .formulation = Formulation::Reduced}));
        QCOMPARE(s.reachRadius_m.value_or(0), 200.0);
        QVERIFY(s.fovShape == FovShape::Disk && s.forecast->places.size() == 2);
        QCOMPARE(s.originExtraJson, std::string(R"({"datum":"WGS 84"})"));
        QCOMPARE(s.plannerExtraJson, std::string(R"({"depth":3})"));
        QCOMPARE(s.extraJson, std::string(R"({"camera":{"tilt_deg":10}})"));
    }

    /** They are written by the present name, which takes precedence if both are given. */
    void formerNamesAreRead()
    {
        const auto planned = [](const std::string& planner) {
            return read(textWith(kUav + R"(, "icebergs": [], "planner": )" + planner));
        };
        const Scenario former = planned(R"({"latency_s": 7.5})");
        QCOMPARE(former.planningTime_s, 7.5);
        QVERIFY(former.plannerExtraJson.empty());
        const std::string text = scenarioToJson(former);
        QVERIFY(text.find("latency_s") == std::string::npos);
        QVERIFY(text.find(R"("planning_delay_s": 7.5)") != std::string::npos);
        QCOMPARE(planned(R"({"latency_s": 7.5, "planning_delay_s": 3})").planningTime_s, 3.0);
    }

    void everyFieldOfObjectsIsRead()
    {
        const Scenario s = loadScenario(kData + "every-field.berg");
        Uav uav;
        uav.id = "alpha";
        uav.name = "First";
        uav.position_m = {-500, 500};
        uav.heading_deg = -30;
        uav.spec = {.airspeed_mps = 25,
                    .maxBank_deg = 30,
                    .altitude_m = 150,
                    .endurance_s = 5400,
                    .reservePercent = 25,
                    .reserve_s = 1200,
                    .climb_s = 90,
                    .landing_s = 60};
        uav.weather = s.uavs[0].weather;   // tst_weather_gate reads it
        uav.aircraft = s.uavs[0].aircraft; // tst_aircraft_json checks it
        uav.fov_m = {400, 700};
        uav.home_m = Point(-400, 450);
        uav.turnaround_s = 900;
        uav.extraJson = R"({"colour":"orange"})";
        QVERIFY(s.uavs.size() == 2 && s.uavs[0] == uav);

        Iceberg iceberg;
        iceberg.id = "berg-1";
        iceberg.name = "Tabular";
        iceberg.position_m = {1200, 3400};
        iceberg.velocity_mps = {0.1, -0.05};
        iceberg.q_m2ps = 0.05;
        iceberg.sigma0_m2 = 4.2;
        iceberg.observed_s = 600;
        iceberg.appears_s = 30;
        iceberg.radius_m = 90;
        iceberg.length_m = 180;
        iceberg.uav = "alpha";
        iceberg.track = {.time_s = {-60, 0, 90.5},
                         .position_m = {{1190, 3400}, {1200, 3390}, {1210.25, 3380}}};
        iceberg.trackExtraJson = R"({"beacon":"7001"})";
        iceberg.extraJson = R"({"source":{"sensor":"SAR","ages":[1,2.5]}})";
        QVERIFY(s.icebergs.size() == 2 && s.icebergs[1] == iceberg);

        Asset asset;
        asset.name = "Platform";
        asset.position_m = {5000, -700};
        asset.velocity_mps = {0, 0.5};
        asset.range_m = 8000;
        asset.gain = 2;
        asset.standoff_m = 500;
        asset.standoffCeiling_m = 450;
        asset.extraJson = R"({"flag":"CA"})";
        QVERIFY(s.asset == asset);
    }

    void everyFieldOfTheSurroundingsIsRead()
    {
        const Scenario s = loadScenario(kData + "every-field.berg");
        QVERIFY(s.noFly ==
                (std::vector<NoFlyArea>{{.name = "Rig helideck",
                                         .corners_m = {{4000, -500}, {5000, -500}, {4500, 300}},
                                         .floor_m = 50,
                                         .ceiling_m = 600,
                                         .extraJson = R"({"class":"R"})"}}));
        QVERIFY(s.airspace ==
                (std::vector<AirspaceArea>{{.name = "Barents West",
                                            .kind = "TRA",
                                            .corners_m = {{2000, 7000}, {5000, 7000}, {3500, 9000}},
                                            .floor_m = 300,
                                            .ceiling_m = 2000,
                                            .fromUtc = "2024-02-29T00:00Z",
                                            .untilUtc = "2024-03-02T12:00:00Z",
                                            .extraJson = R"({"frequency":"126.7"})"}}));
        QVERIFY(s.operation == (Operation{.margin_m = 700,
                                          .span_m = 2.1,
                                          .positionError_m = 4,
                                          .pathError_m = 5,
                                          .mapError_m = 2,
                                          .reaction_s = 2,
                                          .turnBank_deg = 25,
                                          .heightError_m = 6,
                                          .climbPart = 0.5,
                                          .pullUpPart = 0.25,
                                          .bufferRatio = 1.5,
                                          .adjacent_s = 120,
                                          .adjacentLeast_m = 4000,
                                          .adjacentMost_m = 20000,
                                          .crew = "A. Pilot, B. Observer",
                                          .callSign = "BERG 1",
                                          .contacts = "Bridge, channel 16",
                                          .link = "C-band, returns without it",
                                          .checklist = "Fuel\nLink\nFence",
                                          .extraJson = R"({"insurer":"none"})"}));
        QVERIFY(s.weather == (Weather{.gust_mps = 12.5,
                                      .temperature_degC = -3,
                                      .dewPoint_degC = -3.5,
                                      .extraJson = R"({"visibility_m":8000})"}));
        QVERIFY(s.groundStation == (GroundStation{.position_m = {-450, 400},
                                                  .antenna_m = 12,
                                                  .range_m = 25000,
                                                  .extraJson = R"({"operator":"coast"})"}));
    }

    void missingIdsAreNamedByRow()
    {
        // Row 1 would be berg-1, which row 2 has already, so it gets the first number after the
        // last row.
        const Scenario s = loadScenario(kData + "every-field.berg");
        QCOMPARE(s.uavs[1].id, std::string("uav-2"));
        QCOMPARE(s.icebergs[0].id, std::string("berg-3"));

        const std::string place = R"("position_m": [1, 2]})";
        const Scenario clash = read(textWith(
            R"("uavs": [{"id": "berg-2", )" + place + R"(, {)" + place + R"(], "icebergs": [{)" +
            place + ", {" + place + ", {" + place + ", {" + R"("id": "berg-4", )" + place + "]"));
        QCOMPARE(clash.uavs[1].id, std::string("uav-2"));
        QCOMPARE(clash.icebergs[0].id, std::string("berg-1"));
        QCOMPARE(clash.icebergs[1].id, std::string("berg-5"));
        QCOMPARE(clash.icebergs[2].id, std::string("berg-3"));
    }

    void roundTripOfAnyScenario()
    {
        AnyScenario any(2);
        for (int i = 0; i < 500; ++i) {
            const Scenario scenario = any.draw();
            const std::string text = scenarioToJson(scenario);
            Scenario again;
            try {
                again = read(text);
            } catch (const Error& error) {
                QFAIL((text + error.what()).c_str());
            }
            QVERIFY2(again == scenario, text.c_str());
            QCOMPARE(scenarioToJson(again), text);
        }
    }

    void numbersAreExact_data()
    {
        QTest::addColumn<double>("number");
        const double third = 1.0 / 3;
        QTest::newRow("0.1") << 0.1;
        QTest::newRow("17 digits") << third;
        QTest::newRow("next double") << std::nextafter(third, 1);
        QTest::newRow("smallest") << std::numeric_limits<double>::denorm_min();
        QTest::newRow("smallest normal") << std::numeric_limits<double>::min();
        QTest::newRow("minus zero") << -0.0;
        QTest::newRow("whole") << 123456.0;
        QTest::newRow("just below a million") << std::nextafter(1e6, 0);
        QTest::newRow("small") << 1.2345678901234567e-5;
        QTest::newRow("smaller") << -9.87654321e-6;
    }
    void numbersAreExact()
    {
        QFETCH(const double, number);
        Scenario s = defaultScenario();
        s.icebergs[0].position_m.x() = number;
        const double again = read(scenarioToJson(s)).icebergs[0].position_m.x();
        QCOMPARE(std::bit_cast<std::uint64_t>(again), std::bit_cast<std::uint64_t>(number));
    }

    void numbersAreReadAsTheNearestDouble_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<double>("number");
        QTest::newRow("exponent") << QByteArray("1.5e3") << 1500.0;
        QTest::newRow("capital exponent") << QByteArray("-25E-1") << -2.5;
        QTest::newRow("many digits")
            << QByteArray("0.1000000000000000055511151231257827021181583404541015625") << 0.1;
        QTest::newRow("underflow") << QByteArray("1e-999") << 0.0;
    }
    void numbersAreReadAsTheNearestDouble()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const double, number);
        const Scenario s = read(textWith(R"("icebergs": [], "uavs": [{"position_m": [)" +
                                         text.toStdString() + ", 0]}]"));
        QCOMPARE(s.uavs[0].position_m.x(), number);
    }

    void wholeNumbersMayBeWrittenInAnyForm_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<qint64>("seed");
        QTest::newRow("plain") << QByteArray("42") << qint64{42};
        QTest::newRow("fraction 0") << QByteArray("42.0") << qint64{42};
        QTest::newRow("exponent") << QByteArray("1e3") << qint64{1000};
        QTest::newRow("largest") << QByteArray("9007199254740992") << qint64{9007199254740992};
        QTest::newRow("zero") << QByteArray("0") << qint64{0};
    }
    void wholeNumbersMayBeWrittenInAnyForm()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const qint64, seed);
        const Scenario s =
            read(textWith(kUav + R"(, "icebergs": [], "seed": )" + text.toStdString()));
        QCOMPARE(static_cast<qint64>(s.seed), seed);
    }

    void unknownMembersAreWrittenBack()
    {
        const std::string text = readFile(kData + "every-field.berg");
        const std::string again = scenarioToJson(read(text));
        for (const char* member :
             {R"("datum":"WGS 84")", R"("colour":"orange")", R"("flag":"CA")", R"("depth":3)",
              R"("source":{"sensor":"SAR","ages":[1,2.5]})", R"("camera":{"tilt_deg":10})"})
            QVERIFY2(again.find(member) != std::string::npos, member);
        QVERIFY(read(again) == read(text));
    }

    void layoutIsStable()
    {
        Scenario s = defaultScenario();
        s.icebergs.resize(1);
        s.icebergs[0].position_m = {1200, 3400.5};
        s.icebergs[0].velocity_mps = {0.1, -0.05};
        s.icebergs[0].sigma0_m2 = 4.2;
        const std::string expected = R"({
 "format": "bergwatch-scenario",
 "version": 1,
 "name": "Grand Banks, 12 icebergs",
 "origin": {"latitude_deg": 47, "longitude_deg": -48},
 "duration_s": 1000,
 "seed": 1,
 "dt_s": 0.1,
 "noise": true,
 "uavs": [
  {"id": "uav-1", "position_m": [-500, 500], "heading_deg": 45}
 ],
 "icebergs": [
  {"id": "berg-1", "position_m": [1200, 3400.5], "velocity_mps": [0.1, -0.05], "sigma0_m2": 4.2}
 ],
 "planner": {"policy": "visitation", "tau": 1}
}
)";
        QCOMPARE(QString::fromStdString(scenarioToJson(s)), QString::fromStdString(expected));
        s.icebergs.clear();
        QVERIFY(scenarioToJson(s).find(R"("icebergs": [],)") != std::string::npos);
    }

    void orderOfMembersDoesNotMatter()
    {
        const std::string text = R"({"icebergs": [], "version": 1, )" + kUav +
                                 R"(, "planner": {"tau": 2}, "format": "bergwatch-scenario"})";
        QCOMPARE(read(text).planner.tau, 2.0);
    }

    void byteOrderMarkIsSkipped()
    {
        const std::string text = scenarioToJson(defaultScenario());
        QVERIFY(read("\xEF\xBB\xBF" + text) == defaultScenario());
        const std::optional<Error> error = errorOf([] { (void)read("\xEF\xBB\xBF\n x"); });
        QVERIFY(error);
        QVERIFY(std::string(error->what()).find("line 2, column 2") != std::string::npos);
    }

    void columnsCountCharacters()
    {
        const std::optional<Error> error =
            errorOf([] { (void)read("{\"n\xC3\xB8\": \xE2\x82\xAC}"); });
        QVERIFY(error);
        QCOMPARE(codeName(error->code()), std::string("SyntaxError"));
        QVERIFY(std::string(error->what()).starts_with("text: line 1, column 8: "));
    }

    void invalidTextIsWrittenAsReplacement()
    {
        Scenario s = defaultScenario();
        s.name = std::string("Gr\xF8nland \xE2\x82");
        QCOMPARE(read(scenarioToJson(s)).name,
                 std::string("Gr\xEF\xBF\xBDnland \xEF\xBF\xBD\xEF\xBF\xBD"));
    }

    void numbersThatJsonLacksAreNotReadBack()
    {
        Scenario s = defaultScenario();
        s.icebergs[0].q_m2ps = std::numeric_limits<double>::infinity();
        const std::optional<Error> error = errorOf([&] { (void)read(scenarioToJson(s)); });
        QVERIFY(error);
        QVERIFY(names(error->issues(), "icebergs[0].q_m2ps"));
    }

    void faultsAreReportedTogether()
    {
        const std::optional<Error> error = errorOf([] {
            (void)read(textWith(R"("seed": "x", "uavs": [{"position_m": [0], "airspeed_mps": -1}],
                                   "planner": {"policy": 7}, "dt_s": 5, "dt_s": 6)"));
        });
        QVERIFY(error);
        QCOMPARE(codeName(error->code()), std::string("InvalidInput"));
        QCOMPARE(error->subject(), std::string("text"));
        for (const char* field : {"seed", "uavs[0].position_m", "uavs[0].airspeed_mps",
                                  "planner.policy", "dt_s", "icebergs"})
            QVERIFY2(names(error->issues(), field), field);
    }

    void aFaultyMemberIsNamedOnce()
    {
        const std::optional<Error> error =
            errorOf([] { (void)read(textWith(R"("uavs": 5, "icebergs": [{"id": 3}])")); });
        QVERIFY(error);
        QCOMPARE(error->issues().size(), std::size_t{3}); // uavs, id, position_m
        QVERIFY(names(error->issues(), "uavs"));
        QVERIFY(names(error->issues(), "icebergs[0].id"));
        QVERIFY(names(error->issues(), "icebergs[0].position_m"));
    }

    /** Each field is in range but the scenario cannot be flown, so it can be corrected. */
    void unflyableScenarioIsReadForEditing()
    {
        Scenario scenario = randomScenario(1);
        scenario.area_m = {{9000, 0}, {9900, 0}, {9900, 900}};
        scenario.geofence = true; // the UAV is outside
        scenario.wind_mps = {100, 0};
        const std::string text = scenarioToJson(scenario);
        QVERIFY(scenarioFromJson(text, "file", ScenarioUse::Editing) == scenario);
        QVERIFY_THROWS_EXCEPTION(Error, (void)scenarioFromJson(text, "file"));
        scenario.icebergs[0].q_m2ps = -1;
        QVERIFY_THROWS_EXCEPTION(
            Error, (void)scenarioFromJson(scenarioToJson(scenario), "file", ScenarioUse::Editing));
    }

    void depthOf64IsAllowed()
    {
        const auto nested = [](std::size_t depth) {
            return textWith(kUav + R"(, "icebergs": [], "x": )" + std::string(depth, '[') +
                            std::string(depth, ']'));
        };
        QVERIFY(!read(nested(63)).extraJson.empty());
        QCOMPARE(codeOf([&] { (void)read(nested(64)); }), std::string("SyntaxError"));
    }

    void localeDoesNotMatter()
    {
        const std::string text = scenarioToJson(defaultScenario());
        std::string inComma;
        Scenario again;
        {
            const CommaLocale comma;
            inComma = scenarioToJson(defaultScenario());
            again = read(text);
        }
        QCOMPARE(inComma, text);
        QVERIFY(again == defaultScenario());
    }

    void savedScenarioIsLoadedUnchanged()
    {
        const QTemporaryDir dir;
        const std::string path = dir.filePath("scenario.berg").toStdString();
        saveScenario(defaultScenario(), path);
        QVERIFY(loadScenario(path) == defaultScenario());
        const std::string missing = dir.filePath("missing.berg").toStdString();
        const std::optional<Error> error = errorOf([&] { (void)loadScenario(missing); });
        QVERIFY(error);
        QCOMPARE(codeName(error->code()), std::string("FileNotFound"));
        QCOMPARE(error->subject(), missing);
    }
};

QTEST_APPLESS_MAIN(TestScenarioJson)
#include "tst_scenario_json.moc"
