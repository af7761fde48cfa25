#include "core/checks/validate.h"
#include "core/io/files/scenario_json.h"
#include "tests/support/expect_error.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/flight/weather_builder.h"

#include <QtTest>

#include <algorithm>

using namespace berg;
using namespace berg::test;

namespace {

/** A scenario file with this forecast. */
std::string fileWith(const std::string& forecast, const std::string& start = kWeatherStart)
{
    return R"({"format": "bergwatch-scenario", "version": 1, "start_utc": ")" + start +
           R"(", "uavs": [{"position_m": [0, 0]}], "icebergs": [], "forecast": )" + forecast + "}";
}

/** A forecast for one place with this series. */
std::string placeWith(const std::string& series)
{
    return R"({"places": [{"latitude_deg": 47, "longitude_deg": -48, "series": )" + series + "}]}";
}

std::vector<std::string> faultsOf(const std::string& text)
{
    std::vector<std::string> fields;
    try {
        (void)scenarioFromJson(text, "text");
    } catch (const Error& error) {
        for (const Issue& issue : error.issues())
            fields.push_back(issue.field);
    }
    return fields;
}

/** Returns the ids of warnings about the scenario. */
std::vector<IssueId> warningsOf(const Scenario& scenario)
{
    std::vector<IssueId> ids;
    for (const Issue& issue : validate(scenario)) {
        if (issue.severity == Severity::Warning)
            ids.push_back(issue.reason.id);
    }
    return ids;
}

bool holds(const std::vector<IssueId>& ids, IssueId id)
{
    return std::ranges::find(ids, id) != ids.end();
}

} // namespace

/** The forecast of a scenario file. */
class TestForecastMembers : public QObject
{
    Q_OBJECT

private slots:
    void everyValueIsReadAndWritten()
    {
        const std::string text = fileWith(
            R"({"source": "MET", "issued": "2026-11-30T06:00:00Z", "columns": 2, "model": "x",
                "places": [
                 {"latitude_deg": 46, "longitude_deg": -49, "depth_m": 80.5, "name": "a",
                  "series": [{"time": "2026-11-30T12:00:00.250Z", "wind_mps": [1, -2],
                              "gust_mps": 5, "air_temperature_degc": -3, "dew_point_degc": -4,
                              "fog_percent": 20, "visibility_m": 9000, "ceiling_m": 300,
                              "current_mps": [0.25, 0.5], "waves_m": 2},
                             {"time": "2026-11-30T13:00:00Z"}]},
                 {"latitude_deg": 46, "longitude_deg": -48,
                  "series": [{"time": "2026-11-30T12:00:00Z"}]}]})");
        const Scenario scenario = scenarioFromJson(text, "text");
        QVERIFY(scenario.forecast.has_value());
        const ForecastField& field = *scenario.forecast;
        QCOMPARE(field.columns, 2U);
        QCOMPARE(field.places.size(), 2U);
        QCOMPARE(field.places[1].source, std::string("MET"));
        QVERIFY(field.places[1].issued == kWeatherStartTime - std::chrono::hours(6));
        QCOMPARE(field.places[0].depth_m, std::optional(80.5));
        const ForecastEntry& entry = field.places[0].series[0];
        QVERIFY(entry.time == kWeatherStartTime + std::chrono::milliseconds(250));
        QCOMPARE(*entry.wind_mps, Point(1, -2));
        QCOMPARE(*entry.current_mps, Point(0.25, 0.5));
        QCOMPARE(entry.visibility_m, std::optional(9000.0));
        QVERIFY(!field.places[0].series[1].gust_mps);
        const std::string written = scenarioToJson(scenario);
        std::string dense = written;
        std::erase(dense, ' ');
        for (const char* unknown : {"\"model\":", "\"name\":\"a\"", "\"waves_m\":2"})
            QVERIFY2(dense.find(unknown) != std::string::npos, unknown);
        QVERIFY(scenarioFromJson(written, "written") == scenario);
        QCOMPARE(scenarioToJson(scenarioFromJson(written, "written")), written);
    }

    void lengthOfAnIcebergIsReadAndWritten()
    {
        Scenario scenario = emptySea();
        addIceberg(scenario, 100, 0).length_m = 120;
        const std::string text = scenarioToJson(scenario);
        QVERIFY(text.find("\"length_m\": 120") != std::string::npos);
        QVERIFY(scenarioFromJson(text, "text") == scenario);
        scenario.icebergs[0].length_m = -5;
        QVERIFY(hasErrors(validate(scenario)));
    }

    void faultsNameTheirField()
    {
        const auto isOnly = [](const std::string& text, const std::string& field) {
            const std::vector<std::string> faults = faultsOf(text);
            return faults.size() == 1 && faults.front() == field;
        };
        const std::string one = R"([{"time": "2026-11-30T12:00:00Z"}])";
        QVERIFY(isOnly(fileWith(placeWith(one), ""), "forecast"));
        QVERIFY(isOnly(fileWith(R"({"source": "x"})"), "forecast.places"));
        QVERIFY(isOnly(fileWith(R"({"places": []})"), "forecast.places"));
        QVERIFY(isOnly(fileWith(placeWith("[]")), "forecast.places[0].series"));
        QVERIFY(isOnly(fileWith(placeWith(R"([{"time": "noon"}])")),
                       "forecast.places[0].series[0].time"));
        QVERIFY(isOnly(fileWith(placeWith(R"([{"wind_mps": [1, 1]}])")),
                       "forecast.places[0].series[0].time"));
        QVERIFY(isOnly(fileWith(placeWith(R"([{"time": "2026-11-30T12:00:00Z"},
                                              {"time": "2026-11-30T12:00:00Z"}])")),
                       "forecast.places[0].series[1].time"));
        QVERIFY(
            isOnly(fileWith(placeWith(R"([{"time": "2026-11-30T12:00:00Z", "fog_percent": 101}])")),
                   "forecast.places[0].series[0].fog_percent"));
        const std::string place =
            R"({"latitude_deg": 47, "longitude_deg": -48, "series": )" + one + "}";
        QVERIFY(
            isOnly(fileWith(R"({"columns": 2, "places": [)" + place + "]}"), "forecast.places"));
        QVERIFY(
            isOnly(fileWith(R"({"places": [)" + place + ", " + place + "]}"), "forecast.places"));
        QCOMPARE(faultsOf(fileWith(R"([1, 2])")).front(), std::string("forecast"));
    }

    void windMustBeSlowerThanTheUavAtAllTimes()
    {
        Scenario scenario = emptySea(7200);
        letWeatherChange(scenario, 1, 3, growingWind({10, 0}));
        QVERIFY(!hasErrors(validate(scenario)));
        letWeatherChange(scenario, 1, 3, growingWind({12, 0}));
        QVERIFY(hasErrors(validate(scenario)));
    }

    void warningsNameWhatIsMissing()
    {
        Scenario scenario = emptySea(7200);
        letWeatherChange(scenario, 1, 3, growingWind({2, 0}));
        QVERIFY(warningsOf(scenario).empty());
        scenario.forecast->places[0].issued = kWeatherStartTime - std::chrono::hours(25);
        QVERIFY(holds(warningsOf(scenario), IssueId::ForecastOld));
        scenario.duration_s = 5 * 3600;
        QVERIFY(holds(warningsOf(scenario), IssueId::ForecastOutside));
        scenario.forecast->places[0].series.push_back(
            {.time = kWeatherStartTime + std::chrono::hours(12), .wind_mps = Point(1, 1)});
        QVERIFY(holds(warningsOf(scenario), IssueId::ForecastGap));
        QVERIFY(!holds(warningsOf(scenario), IssueId::ForecastOutside));
        scenario.uavs[0].weather.wind_mps = 5;
        QVERIFY(holds(warningsOf(scenario), IssueId::ForecastWind));
    }
};

QTEST_APPLESS_MAIN(TestForecastMembers)
#include "tst_forecast_members.moc"
