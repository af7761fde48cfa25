#include "core/checks/validate.h"
#include "core/checks/weather_gate.h"
#include "tests/support/approx.h"

#include <QTest>

#include <algorithm>

using namespace berg;
using namespace std::chrono_literals;

namespace {

constexpr double kMinute_s = 60;

ForecastTime noon()
{
    return ForecastTime(std::chrono::sys_days(std::chrono::year(2026) / 5 / 1) + 12h);
}

/** One UAV; the wind rises from 4 m/s at noon to 12 m/s an hour later. */
Scenario risingWind()
{
    Scenario scenario;
    scenario.startUtc = "2026-05-01T12:00:00Z";
    scenario.duration_s = 3600;
    scenario.uavs.push_back({.id = "uav-1"});
    scenario.icebergs.push_back({.id = "berg-1", .position_m = {2000, 0}});
    scenario.forecast =
        ForecastField{.places = {{.source = "test",
                                  .place = scenario.origin,
                                  .series = {{.time = noon(), .wind_mps = Point(4, 0)},
                                             {.time = noon() + 1h, .wind_mps = Point(12, 0)}}}}};
    return scenario;
}

ForecastEntry& entry(Scenario& scenario, std::size_t index)
{
    return scenario.forecast->places.front().series.at(index);
}

/** Stays at the origin until that time. */
std::vector<std::vector<FlightPlace>> aloftUntil(double time_s)
{
    return {{{.time_s = 0}, {.time_s = time_s}}};
}

UavWeather weatherUntil(const Scenario& scenario, double time_s)
{
    return weatherAlong(scenario, aloftUntil(time_s)).uavs.front();
}

const Issue* finding(const std::vector<Issue>& issues, IssueId id)
{
    const auto at =
        std::ranges::find_if(issues, [id](const Issue& issue) { return issue.reason.id == id; });
    return at == issues.end() ? nullptr : &*at;
}

} // namespace

class TestWeatherGate : public QObject
{
    Q_OBJECT

private slots:
    /** The wind is 4 + 8 t m/s after t hours: 8 after 30 min, the limit of 10 after 45 min. */
    void windRisesToItsLimit()
    {
        Scenario scenario = risingWind();
        scenario.uavs[0].weather.wind_mps = 10;
        QCOMPARE(weatherUntil(scenario, 30 * kMinute_s), UavWeather{});
        const UavWeather near = weatherUntil(scenario, 45 * kMinute_s);
        QCOMPARE(near.state, WeatherState::Marginal);
        COMPARE_NEAR(near.reason->time_s, 31 * kMinute_s, 1e-9);
        const UavWeather beyond = weatherUntil(scenario, 50 * kMinute_s);
        QCOMPARE(beyond.state, WeatherState::NoGo);
        QCOMPARE(beyond.reason->of, WeatherLimit::Wind);
        COMPARE_NEAR(beyond.reason->time_s, 46 * kMinute_s, 1e-9);
        COMPARE_NEAR(*beyond.reason->value, 4 + 8 * 46.0 / 60, 1e-9);
        QCOMPARE(beyond.reason->limit, 10.0);
    }

    void weatherBeyondTheForecastIsUnknown()
    {
        Scenario scenario = risingWind();
        scenario.uavs[0].weather.wind_mps = 20;
        scenario.wind_mps = {99, 0}; // not used: the forecast gives the wind, if not for long
        const UavWeather end = weatherUntil(scenario, 65 * kMinute_s);
        QCOMPARE(end.state, WeatherState::Unknown);
        COMPARE_NEAR(end.reason->time_s, 61 * kMinute_s, 1e-9);
        QVERIFY(!end.reason->value);
        scenario.uavs[0].weather.gust_mps = 15; // never given
        QCOMPARE(weatherUntil(scenario, kMinute_s).state, WeatherState::Unknown);
        QCOMPARE(weatherUntil(scenario, kMinute_s).reason->of, WeatherLimit::Gust);
        scenario.weather.gust_mps = 5; // constant
        QCOMPARE(weatherUntil(scenario, kMinute_s).state, WeatherState::Go);
    }

    void lowerLimits_data()
    {
        QTest::addColumn<double>("limit_m");
        QTest::addColumn<WeatherState>("state");
        QTest::newRow("beyond") << 4001.0 << WeatherState::NoGo;
        QTest::newRow("at the limit") << 4000.0 << WeatherState::Marginal;
        QTest::newRow("80 % of the value") << 3200.0 << WeatherState::Go; // 4000 x 0.8
        QTest::newRow("a little more") << 3201.0 << WeatherState::Marginal;
    }

    void lowerLimits()
    {
        QFETCH(double, limit_m);
        QFETCH(WeatherState, state);
        Scenario scenario = risingWind();
        entry(scenario, 0).visibility_m = entry(scenario, 1).visibility_m = 4000;
        entry(scenario, 0).ceiling_m = entry(scenario, 1).ceiling_m = 4000;
        scenario.uavs[0].weather = {.visibility_m = limit_m};
        QCOMPARE(weatherUntil(scenario, kMinute_s).state, state);
        scenario.uavs[0].weather = {.ceiling_m = limit_m};
        QCOMPARE(weatherUntil(scenario, kMinute_s).state, state);
    }

    void icingIsThatOfTheAltitude()
    {
        Scenario scenario = risingWind();
        QVERIFY(!hasWeatherLimits(scenario)); // the air is not known
        for (ForecastEntry& at : scenario.forecast->places.front().series) {
            at.airTemperature_degC = 3;
            at.dewPoint_degC = 2.5;
        }
        QVERIFY(hasWeatherLimits(scenario));
        scenario.uavs[0].spec.altitude_m = 1;
        QCOMPARE(weatherUntil(scenario, kMinute_s).state, WeatherState::Go);
        scenario.uavs[0].spec.altitude_m = 1000; // -3.5 degC, dew point 0.7 degC
        QCOMPARE(weatherUntil(scenario, kMinute_s).reason->of, WeatherLimit::Icing);
        scenario.uavs[0].weather.icing = true;
        QCOMPARE(weatherUntil(scenario, kMinute_s).state, WeatherState::Go);
        QVERIFY(!hasWeatherLimits(scenario));
    }

    /** Calm in the west and 20 m/s one degree farther east make 10 m/s in between. */
    void placesAlongTheFlightCount()
    {
        Scenario scenario = risingWind();
        scenario.origin = {60, 10};
        Forecast west = scenario.forecast->places.front();
        west.place = scenario.origin;
        for (ForecastEntry& at : west.series)
            at.wind_mps = Point(0, 0);
        Forecast east = west;
        east.place = {60, 11};
        for (ForecastEntry& at : east.series)
            at.wind_mps = Point(0, 20);
        scenario.forecast = ForecastField{.columns = 2, .places = {west, east}};
        scenario.uavs[0].weather.wind_mps = 12.5;
        const double degree_m = LocalFrame(scenario.origin).toPlane({60, 11}).x();
        const auto flownTo = [&](double part) {
            const std::vector<std::vector<FlightPlace>> flights{
                {{.time_s = 0}, {.time_s = 3000, .position_m = {part * degree_m, 0}}}};
            return weatherAlong(scenario, flights).uavs.front();
        };
        QCOMPARE(flownTo(0.45).state, WeatherState::Go);
        QCOMPARE(flownTo(0.6).state, WeatherState::Marginal);
        QCOMPARE(flownTo(0.7).state, WeatherState::NoGo);
        COMPARE_NEAR(*flownTo(0.7).reason->value, 12.6, 0.05); // 0.7 x 20 after 45 of 50 minutes
    }

    void timeOnTheGroundDoesNotCount()
    {
        Scenario scenario = risingWind();
        scenario.uavs[0].weather.wind_mps = 20;
        entry(scenario, 0).wind_mps = entry(scenario, 1).wind_mps = Point(1, 0);
        scenario.forecast->places.front().series.insert(
            scenario.forecast->places.front().series.begin() + 1,
            {.time = noon() + 30min, .wind_mps = Point(30, 0)});
        const std::vector<std::vector<FlightPlace>> aloft{{{.time_s = 0}, {.time_s = 3600}}};
        QCOMPARE(weatherAlong(scenario, aloft).state(), WeatherState::NoGo);
        const std::vector<std::vector<FlightPlace>> landed{
            {{.time_s = 0, .isLanding = true}, {.time_s = 3600}}};
        QCOMPARE(weatherAlong(scenario, landed).state(), WeatherState::Go);
    }

    void worstUavComesFirst()
    {
        Scenario scenario = risingWind();
        scenario.uavs.push_back({.id = "uav-2"});
        scenario.uavs[0].weather.wind_mps = 11;
        scenario.uavs[1].weather.wind_mps = 6;
        const WeatherVerdict weather = weatherOfArea(scenario);
        QCOMPARE(weather.state(), WeatherState::NoGo);
        QCOMPARE(weather.worstUav(), 1U); // both are no-go, the second one from earlier on
        QCOMPARE(WeatherVerdict{}.state(), WeatherState::Go);
        QVERIFY(!WeatherVerdict{}.worstUav());
    }

    void forecastNeedsAStart()
    {
        Scenario scenario = risingWind();
        scenario.startUtc.clear();
        scenario.wind_mps = {0, 3};
        scenario.uavs[0].weather.wind_mps = 5;
        QCOMPARE(weatherUntil(scenario, 7200).state, WeatherState::Go);
        QCOMPARE(*ScenarioWeather(scenario).at(0, {}).wind_mps, Point(0, 3));
    }

    void checksReportTheForecast()
    {
        Scenario scenario = risingWind();
        scenario.uavs[0].weather = {.wind_mps = 10};
        const std::vector<Issue> issues = validate(scenario);
        const Issue* wind = finding(issues, IssueId::ForecastWind);
        QVERIFY(wind);
        QCOMPARE(wind->field, std::string("uavs[0].max_wind_mps"));
        // Every ten minutes: 10.7 m/s at 12:50.
        QCOMPARE(englishText(wind->reason),
                 std::string("must not be exceeded: wind of 10.7 m/s is forecast for 2026-05-01 "
                             "12:50 UTC, limit 10 m/s"));
        scenario.uavs[0].weather = {.wind_mps = 13};
        QVERIFY(finding(validate(scenario), IssueId::ForecastNearLimit));
        scenario.uavs[0].weather = {.visibility_m = 1000};
        QVERIFY(finding(validate(scenario), IssueId::ForecastLacksLimit));
        scenario.forecast.reset();
        QVERIFY(finding(validate(scenario), IssueId::LimitUnchecked));
    }
};

QTEST_APPLESS_MAIN(TestWeatherGate)
#include "tst_weather_gate.moc"
