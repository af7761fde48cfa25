#include "core/vehicle/dubins.h"
#include "core/vehicle/wind_series.h"
#include "tests/support/approx.h"

#include <QtTest>

#include <cmath>

using namespace berg;

namespace {

constexpr double kAirspeed_mps = 22;

/** Wind that grows by `perSecond` from 0 at time 0 on, in steps of `step_s` for an hour. */
std::shared_ptr<const WindSeries> ramp(const Point& perSecond_mps, double step_s)
{
    WindSeries series;
    for (double from_s = 0; from_s < 3600; from_s += step_s) {
        series.from_s.push_back(from_s);
        series.wind_mps.emplace_back(perSecond_mps * (from_s + step_s / 2));
    }
    return std::make_shared<const WindSeries>(std::move(series));
}

} // namespace

class TestWindSeries : public QObject
{
    Q_OBJECT

private slots:
    void constantWindIsThatOfFlightTime()
    {
        const Point leg_m(3000, -1200);
        const Point wind_mps(5, 7);
        const Point drift_mps(0.3, -0.2);
        QVERIFY(flightTime_s(leg_m, kAirspeed_mps, drift_mps, wind_mps, 17) ==
                flightTime_s(leg_m, kAirspeed_mps, wind_mps - drift_mps));
        QCOMPARE(flightTime_s(Point(0, 0), kAirspeed_mps, drift_mps, wind_mps, 0), 0.0);
    }

    /** Against a wind that grows as a t, a leg of length d takes t with U t - a t^2 / 2 = d. */
    void headwindThatGrowsIsIntegrated()
    {
        const double a = 12.0 / 3600;
        const WindAhead wind(ramp({-a, 0}, 30), 0);
        for (const double d_m : {500.0, 8000.0, 30000.0, 50000.0}) {
            const double exact_s =
                (kAirspeed_mps - std::sqrt(kAirspeed_mps * kAirspeed_mps - 2 * a * d_m)) / a;
            const double time_s = flightTime_s(Point(d_m, 0), kAirspeed_mps, Point(0, 0), wind, 0);
            COMPARE_NEAR(time_s, exact_s, 1e-3 * exact_s);
        }
    }

    /** Across it, the speed over ground is sqrt(U^2 - a^2 t^2). */
    void crosswindThatGrowsIsIntegrated()
    {
        const double a = 12.0 / 3600;
        const WindAhead wind(ramp({0, a}, 30), 0);
        const double end_s = 3000;
        const double x = a * end_s;
        const double u = kAirspeed_mps;
        const double length_m = (x * std::sqrt(u * u - x * x) + u * u * std::asin(x / u)) / (2 * a);
        COMPARE_NEAR(flightTime_s(Point(length_m, 0), u, Point(0, 0), wind, 0), end_s, 3);
    }

    void timesBeginLater()
    {
        const WindAhead wind(ramp({-12.0 / 3600, 0}, 30), 600);
        QCOMPARE(wind.at_mps(0), Point(-12.0 / 3600 * 615, 0));
        QCOMPARE(wind.nextChange_s(10), 30.0);
        QCOMPARE(wind.at_mps(1e6), Point(-12.0 / 3600 * 3585, 0));
        QVERIFY(std::isinf(wind.nextChange_s(1e6)));
        const WindRange range = wind.range(0, 60);
        QCOMPARE(range.high_mps.x(), -12.0 / 3600 * 615);
        QCOMPARE(range.low_mps.x(), -12.0 / 3600 * 675);
        COMPARE_NEAR(wind.mean_mps(60).x(), -12.0 / 3600 * 630, 1e-9);
        QCOMPARE(wind.mean_mps(20), wind.at_mps(0));
    }
};

QTEST_APPLESS_MAIN(TestWindSeries)
#include "tst_wind_series.moc"
