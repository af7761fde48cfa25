#include "core/base/error.h"
#include "core/io/import/import_scenario_forecast.h"
#include "core/scenario/utc_time.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"

#include <QTest>

using namespace berg;
using namespace berg::test;
using namespace std::chrono_literals;

namespace {

Scenario scenarioAt(const std::string& startUtc)
{
    Scenario scenario;
    scenario.origin = {64, 179.9};
    scenario.startUtc = startUtc;
    scenario.duration_s = 7200;
    scenario.icebergs.resize(2);
    scenario.icebergs[0].position_m = Point(-10'000, 0);
    scenario.icebergs[1].position_m = Point(0, 20'000);
    return scenario;
}

/** Hourly winds of four days at one place. */
ForecastReading daysOfWind()
{
    Forecast forecast{
        .source = "test", .issued = parseUtc("2026-05-01T00:00:00Z"), .place = {64, 179}};
    for (int hour = 0; hour < 96; ++hour)
        forecast.series.push_back(
            {.time = *parseUtc("2026-05-01T00:00:00Z") + std::chrono::hours(hour),
             .wind_mps = Point(hour, 0)});
    return {.format = "test", .field = {.places = {forecast}}};
}

} // namespace

class TestImportScenarioForecast : public QObject
{
    Q_OBJECT

private slots:
    void areaAndTimeAreThoseOfTheRunAndTwoDaysMore()
    {
        const ForecastReadOptions options = forecastOptions(scenarioAt("2026-05-01T06:30:00Z"));
        QCOMPARE(options.since, parseUtc("2026-05-01T06:30:00Z"));
        QCOMPARE(options.until, parseUtc("2026-05-03T08:30:00Z"));
        // 30 km are 0.27 degrees of latitude, and 0.61 of longitude at 64 N, over the date line.
        COMPARE_NEAR(options.area->south_deg, 64 - 30 / 111.5, 0.02);
        COMPARE_NEAR(options.area->north_deg, 64 + 50 / 111.5, 0.02);
        COMPARE_NEAR(options.area->west_deg, 179.9 - 40 / 48.9, 0.03);
        COMPARE_NEAR(options.area->east_deg, 179.9 + 30 / 48.9 - 360, 0.03);
        QVERIFY(options.area->west_deg > options.area->east_deg);
    }

    void theForecastIsCutToTheRunAndTwoDaysMore()
    {
        const Scenario scenario = scenarioAt("2026-05-01T06:30:00Z");
        const ForecastImport made = withForecast(scenario, daysOfWind(), "f", false);
        const std::vector<ForecastEntry>& series = made.scenario.forecast->places[0].series;
        QCOMPARE(series.size(), 52U); // 6 o'clock to 9 o'clock two days later
        QCOMPARE(series.front().wind_mps->x(), 6.0);
        QCOMPARE(series.back().wind_mps->x(), 57.0);
        QCOMPARE(made.quantities, (std::vector{ForecastQuantity::Wind}));
        QCOMPARE(made.age_h, std::optional(6.5));
        QVERIFY(made.gaps.empty());
        Scenario without = made.scenario;
        without.forecast.reset();
        QCOMPARE(without, scenario);
    }

    void aSecondForecastIsAdded()
    {
        ForecastReading sea = daysOfWind();
        for (ForecastEntry& entry : sea.field.places[0].series) {
            entry.current_mps = Point(0.1, 0);
            entry.wind_mps.reset();
        }
        const Scenario scenario = scenarioAt("2026-05-01T06:00:00Z");
        const Scenario first = withForecast(scenario, daysOfWind(), "f", false).scenario;
        const ForecastImport both = withForecast(first, sea, "f", false);
        QCOMPARE(both.quantities.size(), 2U);
        const ForecastImport replaced = withForecast(first, sea, "f", true);
        QCOMPARE(replaced.quantities, (std::vector{ForecastQuantity::Current}));
    }

    void theStartMustBeKnownAndMatch()
    {
        const std::optional<Error> none = errorOf([] { (void)forecastOptions(scenarioAt("")); });
        QVERIFY(none);
        QCOMPARE(std::string(none->what()), std::string("scenario: start_utc: is missing"));
        const auto at = parseUtc("2026-05-01T06:00:00Z");
        const ForecastImport made = withForecast(scenarioAt(""), daysOfWind(), "f", false, at);
        QCOMPARE(made.scenario.startUtc, std::string("2026-05-01T06:00:00Z"));
        const std::optional<Error> late = errorOf([] {
            (void)withForecast(scenarioAt("2027-05-01T06:00:00Z"), daysOfWind(), "f", false);
        });
        QVERIFY(late);
        QCOMPARE(late->issues()[0].reason.id, IssueId::ForecastNotThen);
    }
};

QTEST_APPLESS_MAIN(TestImportScenarioForecast)
#include "tst_import_scenario_forecast.moc"
