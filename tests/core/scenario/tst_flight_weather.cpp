#include "core/base/angles.h"
#include "core/scenario/flight_weather.h"
#include "core/scenario/initial_truth.h"
#include "core/tracking/drift.h"
#include "tests/support/approx.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/flight/weather_builder.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;

namespace {

constexpr double kHour_s = 3600;

} // namespace

/** Wind and current of a run, and the drift that follows from them. */
class TestFlightWeather : public QObject
{
    Q_OBJECT

private slots:
    void windIsTheForecastInTheMiddleOfEachStep()
    {
        Scenario scenario = emptySea(2 * kHour_s);
        letWeatherChange(scenario, 1, 3, growingWind({0, 12}));
        const auto weather = weatherOf(scenario);
        QVERIFY(weather != nullptr);
        const WindAhead wind(weather->wind(), 0);
        COMPARE_NEAR(wind.at_mps(0).y(), 12 * 15 / kHour_s, 1e-12);
        COMPARE_NEAR(wind.at_mps(kHour_s).y(), 12 + 12 * 15 / kHour_s, 1e-12);
        COMPARE_NEAR(weather->strongestWind_mps(), 24 - 12 * 15 / kHour_s, 1e-12);
    }

    void constantsApplyWhereTheForecastGivesNothing()
    {
        Scenario scenario = emptySea(10 * kHour_s);
        scenario.wind_mps = {3, 0};
        scenario.current_mps = {0.2, 0.1};
        letWeatherChange(scenario, 1, 1, growingWind({0, 12}));
        const auto weather = weatherOf(scenario);
        const WindAhead wind(weather->wind(), 0);
        QCOMPARE(wind.at_mps(2 * kHour_s), scenario.wind_mps);
        QCOMPARE(weather->forcingAt({0, 0}, 0).current_mps, scenario.current_mps);
        QVERIFY(!weather->depth_m({0, 0}));
        // A gap of more than six hours is not bridged.
        scenario.forecast->places[0].series.push_back(
            {.time = kWeatherStartTime + std::chrono::hours(9), .wind_mps = Point(9, 9)});
        const WindAhead gap(weatherOf(scenario)->wind(), 0);
        QCOMPARE(gap.at_mps(5 * kHour_s), scenario.wind_mps);
    }

    void noForecastIsNoWeather()
    {
        Scenario scenario = emptySea();
        scenario.wind_mps = {1, 2};
        QVERIFY(weatherOf(scenario) == nullptr);
        QCOMPARE(windAtStart_mps(scenario), scenario.wind_mps);
        letWeatherChange(scenario, 1, 1, growingWind({0, 12}));
        scenario.startUtc.clear();
        QVERIFY(weatherOf(scenario) == nullptr);
    }

    /** Icebergs in different places drift in different currents. */
    void currentIsThatOfThePlace()
    {
        Scenario scenario = emptySea(2 * kHour_s);
        letWeatherChange(scenario, 3, 3, [&](const LatLon& place, double) {
            return ForecastEntry{.time = {},
                                 .current_mps =
                                     Point(place.latitude_deg - scenario.origin.latitude_deg, 0.1)};
        });
        const auto weather = weatherOf(scenario);
        const LocalFrame frame(scenario.origin);
        const Point north_m =
            frame.toPlane({scenario.origin.latitude_deg + 0.25, scenario.origin.longitude_deg});
        constexpr double kTenMetres_deg = 1e-4;
        COMPARE_NEAR(weather->forcingAt(north_m, 0).current_mps.x(), 0.25, kTenMetres_deg);
        for (double x_m = -12'000; x_m < 13'000; x_m += 2700)
            for (double y_m = -41'000; y_m < 42'000; y_m += 5300) {
                const Point place_m(x_m, y_m);
                const double expected_mps =
                    frame.toGeographic(place_m).latitude_deg - scenario.origin.latitude_deg;
                COMPARE_NEAR(weather->currentAt_mps(place_m, 0).x(), expected_mps, kTenMetres_deg);
                QCOMPARE(weather->currentAt_mps(place_m, 0),
                         weather->forcingAt(place_m, 0).current_mps);
            }
        COMPARE_NEAR(weather->forcingAt(Point(0, 1e6), 0).current_mps.x(), 0.5, 1e-12);
        COMPARE_NEAR(weather->forcingAt(north_m, 0).current_mps.y(), 0.1, 1e-12);
    }

    /**
     * An iceberg of 100 m has draft 1.78 100^0.71 = 46.8 m, keel 4682 m2 and sail 770 m2; so k =
     * 1.225 1.1857 770 / (1023.6 0.7867 4682) = 2.966e-4 and 1.69 % of the wind carry it.
     */
    void lengthMakesTheWindCarryAnIceberg()
    {
        Scenario scenario = emptySea(2 * kHour_s);
        Iceberg& iceberg = addIceberg(scenario, 0, 0);
        iceberg.length_m = 100;
        letWeatherChange(scenario, 1, 3, [](const LatLon&, double) {
            return ForecastEntry{
                .time = {}, .wind_mps = Point(10, 0), .current_mps = Point(0, 0.2)};
        });
        const auto forcing = forcingOf(weatherOf(scenario), iceberg);
        QVERIFY(forcing != nullptr);
        const Point mean_mps = forcing->mean_mps({0, 0}, 0).value();
        COMPARE_NEAR(mean_mps.x(), 0.169, 5e-4);
        COMPARE_NEAR(mean_mps.y(), 0.2 * (1 - 0.0169), 1e-4);
        QVERIFY(mean_mps.norm() <= forcing->fastest_mps());
        iceberg.length_m = 10; // the current and 2 % of the wind, 20 degrees to the right
        const Point small_mps =
            forcingOf(weatherOf(scenario), iceberg)->mean_mps({0, 0}, 0).value();
        COMPARE_NEAR(small_mps.x(), 0.2 * std::cos(radFromDeg(20)), 1e-6);
        COMPARE_NEAR(small_mps.y(), 0.2 - 0.2 * std::sin(radFromDeg(20)), 1e-6);
        // The truth drifts so.
        iceberg.length_m = 100;
        iceberg.q_m2ps = 0;
        DriftModel drift(trueDrift(scenario, iceberg, weatherOf(scenario)), 1, iceberg.id, false);
        COMPARE_NEAR(drift.position_m(1000).x(), 169, 0.5);
    }

    void icebergsGroundWhereTheirDraftExceedsTheDepth()
    {
        Scenario scenario = emptySea(5 * kHour_s);
        Iceberg& iceberg = addIceberg(scenario, 0, 0);
        iceberg.length_m = 100;
        iceberg.q_m2ps = 0;
        letWeatherChange(scenario, 3, 6, [](const LatLon&, double) {
            return ForecastEntry{.time = {}, .current_mps = Point(0.9, 0)};
        });
        for (std::size_t i = 0; i < 9; ++i) // 80 m in the west, 20 m in the east
            scenario.forecast->places[i].depth_m = 80 - 30.0 * static_cast<double>(i % 3);
        const auto weather = weatherOf(scenario);
        const double draft_m = dimensionsOfLength(100).draft_m;
        DriftModel drift(trueDrift(scenario, iceberg, weather), 1, iceberg.id, false);
        const Point end_m = drift.position_m(5 * kHour_s);
        COMPARE_NEAR(*weather->depth_m(end_m), draft_m, 0.1);
        QCOMPARE(drift.position_m(5.5 * kHour_s), end_m);
        // The estimate stands still as well.
        Track track = trackAtStart(scenario, iceberg, weather);
        const auto forcing = forcingOf(weather, iceberg);
        growUnseen(track, forcing.get(), 0, 5 * kHour_s);
        COMPARE_NEAR((track.estimate_m(5 * kHour_s) - end_m).norm(), 0, 1);
        QCOMPARE(track.velocity_mps, Point(0, 0));
    }

    /** A prediction in steps of the forcing is where the truth without noise drifts. */
    void predictionFollowsAChangingCurrent()
    {
        Scenario scenario = emptySea(4 * kHour_s);
        Iceberg& iceberg = addIceberg(scenario, 0, 0);
        iceberg.velocity_mps = {0.05, -0.1};
        letWeatherChange(scenario, 1, 5, [](const LatLon&, double hours) {
            return ForecastEntry{
                .time = {}, .current_mps = Point(0.3 * std::cos(hours), 0.3 * std::sin(hours))};
        });
        for (const double time_s : {0.0, 36000.0}) {
            iceberg.velocityTime_s = time_s;
            scenario.observer.model = ObserverModel::Kalman;
            const auto weather = weatherOf(scenario);
            DriftModel drift(trueDrift(scenario, iceberg, weather), 1, iceberg.id, false);
            Track track = trackAtStart(scenario, iceberg, weather);
            growUnseen(track, forcingOf(weather, iceberg).get(), 0, 4 * kHour_s);
            COMPARE_NEAR((track.estimate_m(4 * kHour_s) - drift.position_m(4 * kHour_s)).norm(), 0,
                         1e-6);
            QVERIFY(track.mean_mps != Point(0.3, 0));
        }
    }
};

QTEST_APPLESS_MAIN(TestFlightWeather)
#include "tst_flight_weather.moc"
