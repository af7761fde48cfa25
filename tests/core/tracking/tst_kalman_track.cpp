#include "core/base/random.h"
#include "core/tracking/drift.h"
#include "core/tracking/observer.h"
#include "tests/support/approx.h"

#include <QTest>

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <string>

using namespace berg;

namespace {

constexpr double kQ_m2ps = 0.025;
constexpr double kSigma0_m2 = 25;
constexpr double kVelocity_m2ps2 = 0.04;

Track unknown(const Point& velocity_mps, double q_m2ps = kQ_m2ps)
{
    return {.velocity_mps = velocity_mps,
            .sigma_m2 = kSigma0_m2,
            .q_m2ps = q_m2ps,
            .velocity_m2ps2 = kVelocity_m2ps2};
}

Point noise(Random& random, double deviation)
{
    const double x = random.normal();
    return {deviation * x, deviation * random.normal()};
}

/**
 * Normalised estimation error squared of position and velocity, both axes: chi-square with four
 * degrees of freedom for a consistent filter (Bar-Shalom, Li and Kirubarajan 2001, section 5.4).
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

class TestKalmanTrack : public QObject
{
    Q_OBJECT

private slots:
    /** With known velocity and perfect measurements it is the paper's model, step by step. */
    void exactMeasurementsGiveTheSimpleModel()
    {
        const Point velocity_mps(0.2, -0.1);
        Track track{
            .anchor_m = {100, 50}, .velocity_mps = velocity_mps, .sigma_m2 = 4, .q_m2ps = kQ_m2ps};
        Track filter = track;
        DriftModel truth({.position_m = {100, 50}, .velocity_mps = velocity_mps}, 3, "b", true);
        for (int step = 1; step <= 3000; ++step) {
            const double time_s = 0.1 * step;
            filter.grow(0.1);
            const bool inView = step % 700 < 60;
            const Point true_m = truth.position_m(time_s);
            if (inView) {
                track.seen(true_m, time_s);
                filter.measured(true_m, 0, time_s);
            } else {
                track.grow(0.1);
            }
            COMPARE_NEAR(filter.sigma_m2, track.sigma_m2, 1e-9);
            COMPARE_NEAR((filter.estimate_m(time_s) - track.estimate_m(time_s)).norm(), 0, 1e-9);
        }
    }

    /** Without process noise the filter is least squares: the normal equations, solved at once. */
    void withoutProcessNoiseItIsLeastSquares()
    {
        Random random(11, 0);
        Track filter{.sigma_m2 = 1e9, .velocity_m2ps2 = 1e6};
        Eigen::Matrix2d normal = Eigen::Vector2d(1e-9, 1e-6).asDiagonal();
        Eigen::Vector2d east = Eigen::Vector2d::Zero();
        constexpr double kVariance_m2 = 9;
        for (int k = 1; k <= 40; ++k) {
            const double time_s = 5 * k;
            const Point measured_m = Point(100 + 0.3 * time_s, 20) + noise(random, 3);
            filter.grow(5);
            filter.measured(measured_m, kVariance_m2, time_s);
            const Eigen::Vector2d row(1, time_s);
            normal += row * row.transpose() / kVariance_m2;
            east += row * measured_m.x() / kVariance_m2;
        }
        const Eigen::Vector2d fitted = normal.ldlt().solve(east);
        COMPARE_NEAR(filter.estimate_m(0).x(), fitted.x(), 1e-4);
        COMPARE_NEAR(filter.velocity_mps.x(), fitted.y(), 1e-6);
        COMPARE_NEAR(filter.velocity_m2ps2, normal.inverse()(1, 1), 1e-9);
    }

    /**
     * Tests consistency over 100 runs with velocities drawn from their variance, samples during 15
     * s every 200 s and noisy measurements: the mean NEES lies in its 99.9 % chi-square band (400
     * degrees of freedom) at each instant examined, in view and out of view.
     */
    void estimatesAreConsistent()
    {
        constexpr int kRuns = 100;
        constexpr double kLow = 313.4 / kRuns; // chi-square quantiles 0.0005 and 0.9995
        constexpr double kHigh = 499.7 / kRuns;
        constexpr std::array kInstants_s{5.0, 190.0, 410.0, 790.0, 990.0};
        std::array<double, kInstants_s.size()> sum{};
        for (int run = 0; run < kRuns; ++run) {
            Random random(static_cast<std::uint64_t>(run), 7);
            const Point start_m = noise(random, 5);
            const Point velocity_mps = Point(0.2, 0) + noise(random, 0.2);
            DriftModel truth(
                {.position_m = start_m, .velocity_mps = velocity_mps, .q_m2ps = kQ_m2ps},
                static_cast<std::uint64_t>(run), "berg", true);
            Track filter = unknown({0.2, 0});
            std::size_t next = 0;
            for (int second = 1; second <= 1000; ++second) {
                const Point true_m = truth.position_m(second);
                filter.grow(1);
                if (second % 200 < 15)
                    filter.measured(true_m + noise(random, 10), 100, second);
                if (next < kInstants_s.size() && second == static_cast<int>(kInstants_s[next]))
                    sum[next++] += estimationError(filter, true_m, velocity_mps, second);
            }
        }
        for (std::size_t i = 0; i < sum.size(); ++i)
            QVERIFY2(sum[i] / kRuns > kLow && sum[i] / kRuns < kHigh,
                     std::to_string(sum[i] / kRuns).c_str());
    }

    /** The test above can fail: a filter that overrates its measurements is not consistent. */
    void overconfidenceShows()
    {
        double sum = 0;
        for (int run = 0; run < 100; ++run) {
            Random random(static_cast<std::uint64_t>(run), 8);
            Track filter = unknown({0, 0});
            DriftModel truth({.position_m = {0, 0}, .velocity_mps = {0.1, 0.1}},
                             static_cast<std::uint64_t>(run), "berg", true);
            for (int second = 1; second <= 15; ++second) {
                filter.grow(1);
                filter.measured(truth.position_m(second) + noise(random, 10), 4, second);
            }
            sum += estimationError(filter, truth.position_m(15), {0.1, 0.1}, 15);
        }
        QVERIFY(sum / 100 > 499.7 / 100);
    }

    void sigmaGrowsWithTheUnknownVelocity()
    {
        Track filter = unknown({0, 0});
        const double expected_m2 = kSigma0_m2 + kVelocity_m2ps2 * 100 * 100 + kQ_m2ps * 100;
        COMPARE_NEAR(filter.sigmaAfter_m2(100), expected_m2, 1e-9);
        for (int second = 0; second < 100; ++second)
            filter.grow(1);
        COMPARE_NEAR(filter.sigma_m2, expected_m2, 1e-9);
    }

    void exactMeasurementOfAnExactEstimate()
    {
        Track filter{.velocity_mps = {1, 0}};
        filter.measured({10, 0}, 0, 10);
        QCOMPARE(filter.estimate_m(10), Point(10, 0));
        QCOMPARE(filter.sigma_m2, 0.0);
    }

    /** Samples of one iceberg, of two icebergs and of two seeds are independent. */
    void sampleDrawsAreIndependent()
    {
        const auto mixed = [](auto first, auto second) {
            double sum = 0;
            for (std::int64_t sample = 0; sample < 4000; ++sample)
                sum += first(sample).noise.x() * second(sample).noise.x();
            return sum / 4000; // sd 1 / sqrt(4000) = 0.016
        };
        const auto draw = [](std::uint64_t seed, std::uint64_t stream) {
            return [=](std::int64_t sample) { return sampleDraw(seed, stream, sample); };
        };
        const auto later = [](std::int64_t sample) { return sampleDraw(1, 77, sample + 1); };
        QVERIFY(std::abs(mixed(draw(1, 77), later)) < 0.08);
        QVERIFY(std::abs(mixed(draw(1, 77), draw(1, 78))) < 0.08);
        QVERIFY(std::abs(mixed(draw(1, 77), draw(2, 77))) < 0.08);
        QVERIFY(std::abs(mixed(draw(1, 77), draw(1, 77)) - 1) < 0.12);
    }
};

QTEST_APPLESS_MAIN(TestKalmanTrack)
#include "tst_kalman_track.moc"
