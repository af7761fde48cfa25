#include "core/tracking/drift_path.h"
#include "tests/support/approx.h"

#include <QTest>

using namespace berg;

namespace {

constexpr double kHour_s = 3600;
constexpr DriftLaw kWithCurrent{};

/** Current that rises linearly, known for a day. */
std::optional<Forcing> risingCurrent(double time_s)
{
    if (time_s < 0 || time_s > 24 * kHour_s)
        return std::nullopt;
    return Forcing{.current_mps = {1e-5 * time_s, 0}};
}

} // namespace

class TestDriftPath : public QObject
{
    Q_OBJECT

private slots:
    void constantCurrentGoesStraight()
    {
        // 0.5 m/s to the north for 12 h is 21.6 km; a degree of latitude has 111.5 km there.
        const ForcingAt forcing = [](double) { return Forcing{.current_mps = {0, 0.5}}; };
        const DriftSpan span{
            .place = {64, -59}, .start_s = 100, .duration_s = 12 * kHour_s, .every_s = kHour_s};
        const std::vector<DriftPoint> path = driftPath(span, kWithCurrent, forcing);
        QCOMPARE(path.size(), 13U);
        QCOMPARE(path.front().place, span.place);
        QCOMPARE(path.back().time_s, 100 + 12 * kHour_s);
        COMPARE_NEAR(path.back().place.longitude_deg, -59, 1e-9);
        COMPARE_NEAR(LocalFrame(span.place).toPlane(path.back().place).y(), 21600, 1e-3);
        QCOMPARE(path.back().velocity_mps, Point(0, 0.5));
    }

    void eastIsThatOfEachPlace()
    {
        // To the east all the time, it stays on its parallel, 43.8 km per degree at 66.8 N.
        const ForcingAt forcing = [](double) { return Forcing{.current_mps = {1, 0}}; };
        const DriftSpan span{
            .place = {66.8, 10}, .duration_s = 48 * kHour_s, .every_s = 48 * kHour_s};
        const std::vector<DriftPoint> path = driftPath(span, kWithCurrent, forcing);
        QCOMPARE(path.size(), 2U);
        COMPARE_NEAR(path.back().place.latitude_deg, 66.8, 1e-3); // steps are straight

        COMPARE_NEAR(path.back().place.longitude_deg, 10 + 172.8 / 43.98, 2e-2);
    }

    void linearForcingIsExact()
    {
        // Distance c t^2 / 2 after t: 18.66 km after 17 h.
        const DriftSpan span{.place = {0, 0}, .duration_s = 17 * kHour_s, .every_s = 17 * kHour_s};
        const std::vector<DriftPoint> path = driftPath(span, kWithCurrent, risingCurrent);
        const double t_s = 17 * kHour_s;
        COMPARE_NEAR(LocalFrame(span.place).toPlane(path.back().place).x(), 0.5 * 1e-5 * t_s * t_s,
                     0.01);
    }

    void forecastForces()
    {
        using namespace std::chrono_literals;
        const ForecastTime start{1h};
        const Forecast wind{.series = {{.time = start, .wind_mps = Point(2, 0)},
                                       {.time = start + 1h, .wind_mps = Point(4, 0)}}};
        const ForcingAt forcing = forcingOf(wind, {.wind_mps = {9, 9}, .current_mps = {0, 1}});
        QCOMPARE(forcing(1.5 * kHour_s),
                 (Forcing{.wind_mps = {3, 0}, .current_mps = {0, 1}})); // the current is constant
        QVERIFY(!forcing(0.9 * kHour_s) && !forcing(2.1 * kHour_s));
        QCOMPARE(forcingOf({}, {.wind_mps = {9, 9}})(0), (Forcing{.wind_mps = {9, 9}}));
    }

    void endsWithTheForcing()
    {
        DriftSpan span{.place = {60, 0}, .duration_s = 48 * kHour_s, .every_s = 5 * kHour_s};
        QCOMPARE(driftPath(span, kWithCurrent, risingCurrent).size(), 5U); // 0, 5, ... 20 h
        span.start_s = -1;
        QVERIFY(driftPath(span, kWithCurrent, risingCurrent).empty());
        span.start_s = 0;
        span.duration_s = 0;
        QCOMPARE(driftPath(span, kWithCurrent, risingCurrent).size(), 1U);
    }
};

QTEST_APPLESS_MAIN(TestDriftPath)
#include "tst_drift_path.moc"
