#include "core/tracking/drift.h"
#include "core/tracking/observer.h"
#include "tests/support/approx.h"

#include <QTest>

#include <array>
#include <cmath>
#include <string>

using namespace berg;

namespace {

/** Process fitted to a beacon of the Canadian Ice Service. */
constexpr DriftProcess kFitted{
    .q_m2ps = 0.025, .velocitySpread_mps = 0.15, .velocityTime_s = 36'000};
/** Process that changes within the minutes of a test. */
constexpr DriftProcess kQuick{.q_m2ps = 0.01, .velocitySpread_mps = 0.2, .velocityTime_s = 300};

DriftSpec specOf(const DriftProcess& process, const Point& velocity_mps, const Point& mean_mps)
{
    return {.velocity_mps = velocity_mps,
            .q_m2ps = process.q_m2ps,
            .mean_mps = mean_mps,
            .velocitySpread_mps = process.velocitySpread_mps,
            .velocityTime_s = process.velocityTime_s};
}

Point noise(Random& random, double deviation)
{
    const double x = random.normal();
    return {deviation * x, deviation * random.normal()};
}

/** Solves the differential equations of the variances, and the integral of P, by Runge-Kutta. */
struct Integrated
{
    DriftVariances at;
    double integral_m2s = 0;

    void step(const DriftProcess& process, double h_s)
    {
        const double rate = 1 / process.velocityTime_s;
        const double spread_m2ps2 = process.velocitySpread_mps * process.velocitySpread_mps;
        const auto slope = [&](const std::array<double, 4>& y) {
            return std::array{2 * y[1] + process.q_m2ps, y[2] - rate * y[1],
                              2 * rate * (spread_m2ps2 - y[2]), y[0]};
        };
        const auto plus = [](std::array<double, 4> y, const std::array<double, 4>& d, double h) {
            for (std::size_t i = 0; i < y.size(); ++i)
                y[i] += h * d[i];
            return y;
        };
        const std::array y{at.position_m2, at.mixed_m2ps, at.velocity_m2ps2, integral_m2s};
        const auto a = slope(y);
        const auto b = slope(plus(y, a, h_s / 2));
        const auto c = slope(plus(y, b, h_s / 2));
        const auto d = slope(plus(y, c, h_s));
        std::array<double, 4> next{};
        for (std::size_t i = 0; i < next.size(); ++i)
            next[i] = y[i] + h_s / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
        at = {.position_m2 = next[0], .mixed_m2ps = next[1], .velocity_m2ps2 = next[2]};
        integral_m2s = next[3];
    }
};

/**
 * Is chi-square distributed with four degrees of freedom for a consistent filter; see
 * `tst_kalman_track`.
 */
double estimationError(const Track& track, const Point& position_m, const Point& velocity_mps,
                       double time_s)
{
    const double determinant =
        track.sigma_m2 * track.velocity_m2ps2 - track.mixed_m2ps * track.mixed_m2ps;
    const Point place_m = position_m - track.estimate_m(time_s);
    const Point speed_mps = velocity_mps - track.velocity_mps;
    return (track.velocity_m2ps2 * place_m.squaredNorm() -
            2 * track.mixed_m2ps * place_m.dot(speed_mps) +
            track.sigma_m2 * speed_mps.squaredNorm()) /
           determinant;
}

} // namespace

/** Tests variable velocities: an Ornstein-Uhlenbeck process along each axis. */
class TestChangingVelocity : public QObject
{
    Q_OBJECT

private slots:
    void closedFormIsTheIntegral_data()
    {
        QTest::addColumn<double>("time_s");
        QTest::addColumn<double>("span_s");
        QTest::newRow("a hundredth of the time") << 36'000.0 << 360.0;
        QTest::newRow("just below the series' end") << 36'000.0 << 1799.0;
        QTest::newRow("just above") << 36'000.0 << 1801.0;
        QTest::newRow("a day") << 36'000.0 << 86'400.0;
        QTest::newRow("ten times the time") << 300.0 << 3000.0;
    }
    void closedFormIsTheIntegral()
    {
        QFETCH(double, time_s);
        QFETCH(double, span_s);
        const DriftProcess process{
            .q_m2ps = 0.025, .velocitySpread_mps = 0.15, .velocityTime_s = time_s};
        const DriftVariances start{.position_m2 = 30, .mixed_m2ps = 0.4, .velocity_m2ps2 = 0.01};
        Integrated numeric{.at = start};
        constexpr int kSteps = 4000;
        for (int i = 0; i < kSteps; ++i)
            numeric.step(process, span_s / kSteps);
        const DriftVariances closed = grown(start, process, span_s);
        COMPARE_NEAR(closed.position_m2 / numeric.at.position_m2, 1, 1e-9);
        COMPARE_NEAR(closed.mixed_m2ps / numeric.at.mixed_m2ps, 1, 1e-9);
        COMPARE_NEAR(closed.velocity_m2ps2 / numeric.at.velocity_m2ps2, 1, 1e-9);
        COMPARE_NEAR(positionIntegral_m2s(start, process, span_s) / numeric.integral_m2s, 1, 1e-9);
    }

    /** The start is known exactly; one step and many give the same result, so nothing cancels. */
    void smallStepsLoseNothing()
    {
        DriftProcess process = kFitted;
        process.q_m2ps = 0;
        DriftVariances stepped;
        for (int i = 0; i < 10'000; ++i)
            stepped = grown(stepped, process, 0.1);
        const DriftVariances once = grown({}, process, 1000);
        COMPARE_NEAR(stepped.position_m2 / once.position_m2, 1, 1e-9);
        COMPARE_NEAR(stepped.mixed_m2ps / once.mixed_m2ps, 1, 1e-9);
        COMPARE_NEAR(stepped.velocity_m2ps2 / once.velocity_m2ps2, 1, 1e-9);
        // The leading terms are 2 S^2 t^3 / (3 T), S^2 t^2 / T, 2 S^2 t / T.
        const DriftVariances soon = grown({}, process, 0.1);
        COMPARE_NEAR(soon.position_m2 / (0.0225 * 2e-3 / 3 / 36'000), 1, 1e-5);
        COMPARE_NEAR(soon.mixed_m2ps / (0.0225 * 1e-2 / 36'000), 1, 1e-5);
        COMPARE_NEAR(soon.velocity_m2ps2 / (0.0225 * 0.2 / 36'000), 1, 1e-5);
    }

    void aConstantVelocityIsTheLimit()
    {
        const DriftVariances start{.position_m2 = 30, .mixed_m2ps = 0.4, .velocity_m2ps2 = 0.01};
        const DriftProcess constant{.q_m2ps = 0.025, .velocitySpread_mps = 0.15};
        DriftProcess slow = constant;
        slow.velocityTime_s = 1e9;
        Track track{.sigma_m2 = 30, .q_m2ps = 0.025, .mixed_m2ps = 0.4, .velocity_m2ps2 = 0.01};
        track.grow(1000);
        QVERIFY(grown(start, constant, 1000) == track.variances());
        COMPARE_NEAR(grown(start, slow, 1000).position_m2 / track.sigma_m2, 1, 1e-5);
        COMPARE_NEAR(positionIntegral_m2s(start, slow, 1000) /
                         positionIntegral_m2s(start, constant, 1000),
                     1, 1e-5);
    }

    /** A velocity known to 0.02 m/s is worth no more a day later than no measurement at all. */
    void aLearnedVelocityIsForgotten()
    {
        Track track{.velocity_mps = {0.3, 0},
                    .sigma_m2 = 25,
                    .velocity_m2ps2 = 0.0004,
                    .mean_mps = {0, 0.1},
                    .velocitySpread_mps = kFitted.velocitySpread_mps,
                    .velocityTime_s = kFitted.velocityTime_s};
        const Point later_m = track.estimate_m(86'400);
        for (int second = 0; second < 86'400; ++second)
            track.grow(1);
        COMPARE_NEAR((track.estimate_m(86'400) - later_m).norm(), 0, 1e-6);
        COMPARE_NEAR((track.velocity_mps - Point(0, 0.1)).norm(), std::sqrt(0.1) * std::exp(-2.4),
                     1e-9);
        COMPARE_NEAR(std::sqrt(track.velocity_m2ps2), 0.15, 0.001);
        // The beacon moved by 8 km in a day.
        COMPARE_NEAR(std::sqrt(track.sigma_m2), 7950, 50);
    }

    /** Spread and covariance of the true motion are those of the closed form. */
    void theTruthSpreadsAsPredicted()
    {
        constexpr int kRuns = 4000;
        constexpr double kSpan_s = 900;
        DriftVariances sum;
        for (std::uint64_t run = 0; run < kRuns; ++run) {
            DriftModel truth(specOf(kQuick, {0.5, 0}, {0.1, 0}), run, "berg", true);
            const Point place_m = truth.position_m(kSpan_s) -
                                  Point(0.1 * kSpan_s + 0.4 * carriedFor_s(300, kSpan_s), 0);
            const Point speed_mps =
                truth.velocity_mps() - Point(0.1 + 0.4 * std::exp(-kSpan_s / 300), 0);
            sum.position_m2 += place_m.squaredNorm() / (2 * kRuns);
            sum.mixed_m2ps += place_m.dot(speed_mps) / (2 * kRuns);
            sum.velocity_m2ps2 += speed_mps.squaredNorm() / (2 * kRuns);
        }
        // The standard deviation over 8000 squares is sqrt(2 / 8000) = 0.016; three of them are
        // allowed.
        const DriftVariances expected = grown({}, kQuick, kSpan_s);
        COMPARE_NEAR(sum.position_m2 / expected.position_m2, 1, 0.048);
        COMPARE_NEAR(sum.mixed_m2ps / expected.mixed_m2ps, 1, 0.06);
        COMPARE_NEAR(sum.velocity_m2ps2 / expected.velocity_m2ps2, 1, 0.048);
    }

    /**
     * The truth is the same for every time step, and the white noise is that of a constant
     * velocity.
     */
    void theTruthIsTheSameForAllSteps()
    {
        const DriftSpec spec = specOf(kQuick, {0.5, 0}, {0.1, 0});
        DriftModel fine(spec, 3, "berg", true);
        DriftModel coarse(spec, 3, "berg", true);
        for (int step = 1; step <= 10'000; ++step) {
            const Point place_m = fine.position_m(0.1 * step);
            if (step % 70 == 0)
                QVERIFY(coarse.position_m(0.1 * step) == place_m);
        }
        DriftSpec white = specOf(kQuick, {0.1, 0}, {0.1, 0});
        white.velocitySpread_mps = 0;
        DriftModel walking(white, 3, "berg", true);
        DriftModel plain({.velocity_mps = {0.1, 0}, .q_m2ps = kQuick.q_m2ps}, 3, "berg", true);
        COMPARE_NEAR((walking.position_m(500) - plain.position_m(500)).norm(), 0, 1e-9);
    }

    void withoutNoiseItFadesToTheMean()
    {
        DriftModel drift(specOf(kQuick, {0.5, 0}, {0.1, 0}), 3, "berg", false);
        const Point end_m = drift.position_m(600);
        COMPARE_NEAR(end_m.x(), 60 + 0.4 * 300 * (1 - std::exp(-2)), 1e-9);
        COMPARE_NEAR(end_m.y(), 0, 1e-12);
    }

    /**
     * Tests consistency over 100 runs, with samples during 15 s every 200 s and noisy measurements:
     * the mean NEES lies in its 95 % chi-square band (400 degrees of freedom) at four of five
     * instants at least and in the 99.9 % band at all.
     */
    void estimatesAreConsistent_data()
    {
        QTest::addColumn<double>("spread_mps");
        QTest::addColumn<double>("time_s");
        QTest::newRow("as fitted") << 0.15 << 36'000.0;
        QTest::newRow("quick") << 0.2 << 300.0;
    }
    void estimatesAreConsistent()
    {
        QFETCH(double, spread_mps);
        QFETCH(double, time_s);
        const DriftProcess process{
            .q_m2ps = 0.025, .velocitySpread_mps = spread_mps, .velocityTime_s = time_s};
        constexpr int kRuns = 100;
        constexpr std::array kInstants_s{5.0, 190.0, 410.0, 790.0, 990.0};
        std::array<double, kInstants_s.size()> sum{};
        for (std::uint64_t run = 0; run < kRuns; ++run) {
            Random random(run, 7);
            const Point start_m = noise(random, 5);
            const Point velocity_mps = Point(0.1, 0) + noise(random, spread_mps);
            DriftSpec spec = specOf(process, velocity_mps, {0.1, 0});
            spec.position_m = start_m;
            DriftModel truth(spec, run, "berg", true);
            Track filter{.velocity_mps = {0.1, 0},
                         .sigma_m2 = 25,
                         .q_m2ps = process.q_m2ps,
                         .velocity_m2ps2 = spread_mps * spread_mps,
                         .mean_mps = {0.1, 0},
                         .velocitySpread_mps = spread_mps,
                         .velocityTime_s = time_s};
            std::size_t next = 0;
            for (int second = 1; second <= 1000; ++second) {
                const Point true_m = truth.position_m(second);
                filter.grow(1);
                if (second % 200 < 15)
                    filter.measured(true_m + noise(random, 10), 100, second);
                if (next < kInstants_s.size() && second == static_cast<int>(kInstants_s[next]))
                    sum[next++] += estimationError(filter, true_m, truth.velocity_mps(), second);
            }
        }
        int inBand = 0;
        for (const double error : sum) {
            QVERIFY2(error > 313.4 && error < 499.7, std::to_string(error).c_str());
            inBand += error > 346.5 && error < 457.3 ? 1 : 0; // quantiles 0.025 and 0.975
        }
        QVERIFY2(inBand >= 4, std::to_string(inBand).c_str());
    }
};

QTEST_APPLESS_MAIN(TestChangingVelocity)
#include "tst_changing_velocity.moc"
