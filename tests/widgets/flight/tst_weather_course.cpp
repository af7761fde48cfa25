#include "tests/support/approx.h"
#include "tests/support/flight/forecast_builder.h"
#include "tests/support/flight/scenario_builder.h"
#include "widgets/flight/weather_course.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;

namespace {

constexpr double kHour_s = 3600;

Scenario forecastSea(int hours = 12)
{
    Scenario scenario = emptySea(8 * kHour_s);
    addForecast(scenario, hours);
    return scenario;
}

} // namespace

/** Weather over a run, at the place of the flight. */
class TestWeatherCourse : public QObject
{
    Q_OBJECT

private slots:
    void constantWeatherIsThatOfTheScenario()
    {
        Scenario scenario = emptySea();
        scenario.wind_mps = {3, 4};
        scenario.weather.gust_mps = 9;
        const WeatherCourse course = courseOf(scenario);
        QVERIFY(!course.isForecast());
        QCOMPARE(course.points.size(), std::size_t{2});
        for (const double time_s : {0.0, 500.0, 1000.0}) {
            QCOMPARE(*course.at(time_s).wind_mps, Point(3, 4));
            QCOMPARE(*course.at(time_s).gust_mps, 9.0);
            QVERIFY(!course.at(time_s).current_mps); // still water
        }
    }

    void forecastReplacesIt()
    {
        Scenario scenario = forecastSea();
        scenario.wind_mps = {1, 1};
        const WeatherCourse course = courseOf(scenario);
        QCOMPARE(course.source, std::string("MET Norway"));
        COMPARE_NEAR(*course.issued_s, -6 * kHour_s, 1e-9);
        for (const int hour : {0, 1, 5, 8}) {
            const CoursePoint point = course.at(hour * kHour_s);
            QVERIFY((*point.wind_mps - forecastWind_mps(hour)).norm() < 1e-6);
            COMPARE_NEAR(*point.gust_mps, 14.0 + hour, 1e-6);
            QVERIFY((*point.current_mps - Point(0.3, 0.4)).norm() < 1e-9);
        }
        // The place in the grid is known to 50 m, and the wind changes by 8 m/s a degree.
        QVERIFY((*weatherAtStart(scenario).wind_mps - Point(10, 0)).norm() < 0.01);
        // Between two hours the components are linear.
        const Point half_mps = 0.5 * (forecastWind_mps(1) + forecastWind_mps(2));
        QVERIFY((*course.at(1.5 * kHour_s).wind_mps - half_mps).norm() < 1e-2);
    }

    /** In steps and gaps alike, it is what the grid gives at the middle of the UAVs' starts. */
    void courseIsThatOfTheGrid_data()
    {
        QTest::addColumn<bool>("hasGap");
        QTest::newRow("whole") << false;
        QTest::newRow("gap") << true;
    }
    void courseIsThatOfTheGrid()
    {
        QFETCH(const bool, hasGap);
        Scenario scenario = forecastSea();
        scenario.uavs.front().position_m = {4000, -7000};
        if (hasGap)
            cutForecast(*scenario.forecast, 0, 7);
        const LatLon place = LocalFrame(scenario.origin).toGeographic(flightPlace_m(scenario));
        const WeatherCourse course = courseOf(scenario);
        QVERIFY(course.points.size() > 100);
        for (const CoursePoint& point : course.points) {
            const auto time_ms = std::chrono::milliseconds(std::llround(1000 * point.time_s));
            const ForecastEntry entry =
                entryAt(*scenario.forecast, place, kForecastStartTime + time_ms);
            QCOMPARE(point.wind_mps.has_value(), entry.wind_mps.has_value());
            QCOMPARE(point.gust_mps.has_value(), entry.gust_mps.has_value());
            QCOMPARE(point.current_mps.has_value(), entry.current_mps.has_value());
            constexpr double kFiftyMetres_mps =
                0.01; // in the gradient of this wind, 8 m/s a degree
            if (point.wind_mps)
                QVERIFY((*point.wind_mps - *entry.wind_mps).norm() < kFiftyMetres_mps);
            if (point.gust_mps)
                COMPARE_NEAR(*point.gust_mps, *entry.gust_mps, kFiftyMetres_mps);
            if (point.current_mps)
                QVERIFY((*point.current_mps - *entry.current_mps).norm() < 1e-9);
        }
    }

    void startAndGridAreNeeded()
    {
        Scenario scenario = forecastSea();
        scenario.startUtc.clear();
        QVERIFY(usableForecast(scenario) == nullptr);
        QVERIFY(!courseOf(scenario).isForecast());
        scenario = forecastSea();
        scenario.forecast->places.pop_back();
        QVERIFY(usableForecast(scenario) == nullptr);
        scenario.forecast->places.clear();
        QVERIFY(!courseOf(scenario).isForecast());
    }

    void gapsAreUnknown()
    {
        Scenario scenario = forecastSea();
        cutForecast(*scenario.forecast, 0, 7); // longer than values are interpolated
        const WeatherCourse course = courseOf(scenario);
        QVERIFY(course.at(0).wind_mps && course.at(7 * kHour_s).wind_mps);
        QVERIFY(!course.at(3 * kHour_s).wind_mps && !course.at(3 * kHour_s).current_mps);
        // The flight uses the constant wind at the start of a forecast that begins later.
        scenario.wind_mps = {2, 0};
        for (Forecast& place : scenario.forecast->places)
            place.series.erase(place.series.begin());
        QCOMPARE(*weatherAtStart(scenario).wind_mps, Point(2, 0));
    }

    void quantitiesOfTheScenarioFillThoseThatAreNeverGiven()
    {
        Scenario scenario = forecastSea();
        scenario.weather.gust_mps = 20;
        for (Forecast& place : scenario.forecast->places)
            for (ForecastEntry& entry : place.series)
                entry.gust_mps.reset();
        QCOMPARE(*courseOf(scenario).at(kHour_s).gust_mps, 20.0);
    }

    void reportedWindAppliesFromThenOn()
    {
        const std::vector<Intervention> changes{{.time_s = 2 * kHour_s, .wind_mps = Point(0, -5)},
                                                {.time_s = 3 * kHour_s, .tau = 2},
                                                {.time_s = 4 * kHour_s, .wind_mps = Point(0, -7)}};
        const WeatherCourse course = courseOf(forecastSea(), changes);
        QCOMPARE(*course.reported_s, 2 * kHour_s);
        QVERIFY((*course.at(2 * kHour_s).wind_mps - forecastWind_mps(2)).norm() < 1e-6);
        QCOMPARE(*course.at(2 * kHour_s + 1).wind_mps, Point(0, -5));
        QCOMPARE(*course.at(4 * kHour_s).wind_mps, Point(0, -5));
        QCOMPARE(*course.at(5 * kHour_s).wind_mps, Point(0, -7));
        QCOMPARE(*course.at(8 * kHour_s).wind_mps, Point(0, -7));
        QVERIFY(course.at(5 * kHour_s).current_mps.has_value()); // icebergs drift in the forecast
        QVERIFY(std::ranges::is_sorted(course.points, {}, &CoursePoint::time_s));
        const WeatherCourse atStart =
            courseOf(emptySea(), std::vector<Intervention>{{.wind_mps = Point(1, 0)}});
        QCOMPARE(*atStart.at(0).wind_mps, Point(1, 0));
        QCOMPARE(*atStart.at(1000).wind_mps, Point(1, 0));
    }
};

QTEST_MAIN(TestWeatherCourse)
#include "tst_weather_course.moc"
