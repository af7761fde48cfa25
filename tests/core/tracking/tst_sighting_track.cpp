#include "core/base/random.h"
#include "core/tracking/sighting_track.h"
#include "tests/support/approx.h"

#include <QtTest>

#include <cmath>
#include <limits>
#include <vector>

using namespace berg;

namespace {

constexpr double kHour_s = 3600;

struct Truth
{
    Point velocity_mps = Point(0.12, -0.2);
    double q_m2ps = 30;
    double error_m = 0; ///< standard deviation of a position along an axis
};

/** Random walk with drift, Eq. (17), seen at uneven times over about two days. */
std::vector<Fix> walk(const Truth& truth, std::uint64_t seed, int count = 24)
{
    Random random(seed, 99);
    std::vector<Fix> fixes;
    Point position_m(5000, -3000);
    double time_s = 0;
    for (int i = 0; i < count; ++i) {
        const Point error_m(truth.error_m * random.normal(), truth.error_m * random.normal());
        fixes.push_back({.time_s = time_s,
                         .position_m = position_m + error_m,
                         .variance_m2 = truth.error_m * truth.error_m});
        const double dt_s = random.uniform(0.2, 4) * kHour_s;
        const double step_m = std::sqrt(truth.q_m2ps * dt_s);
        position_m +=
            truth.velocity_mps * dt_s + Point(step_m * random.normal(), step_m * random.normal());
        time_s += dt_s;
    }
    return fixes;
}

/** Fixes on a line at constant speed, one an hour. */
std::vector<Fix> steady(int count, const Point& velocity_mps = Point(0.2, 0.1))
{
    std::vector<Fix> fixes;
    for (int i = 0; i < count; ++i)
        fixes.push_back({.time_s = i * kHour_s, .position_m = velocity_mps * (i * kHour_s)});
    return fixes;
}

/** Mean of a sample and the standard error of it. */
struct Mean
{
    double value = 0;
    double error = 0;
};

Mean meanOf(const std::vector<double>& sample)
{
    const auto n = static_cast<double>(sample.size());
    Mean mean;
    for (const double x : sample)
        mean.value += x / n;
    for (const double x : sample)
        mean.error += (x - mean.value) * (x - mean.value) / (n * (n - 1));
    mean.error = std::sqrt(mean.error);
    return mean;
}

} // namespace

class TestSightingTrack : public QObject
{
    Q_OBJECT

private slots:
    void estimatesAreUnbiased_data()
    {
        QTest::addColumn<double>("q_m2ps");
        QTest::addColumn<double>("error_m");
        QTest::addColumn<int>("count");
        QTest::newRow("drift alone") << 30.0 << 0.0 << 24;
        QTest::newRow("little noise") << 0.025 << 0.0 << 24;
        QTest::newRow("few fixes") << 30.0 << 0.0 << 4;
        QTest::newRow("errors of position, given") << 30.0 << 150.0 << 24;
    }

    void estimatesAreUnbiased()
    {
        QFETCH(double, q_m2ps);
        QFETCH(double, error_m);
        QFETCH(int, count);
        const Truth truth{.q_m2ps = q_m2ps, .error_m = error_m};
        std::vector<double> east_mps;
        std::vector<double> north_mps;
        std::vector<double> growths_m2ps;
        for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
            const TrackEstimate estimate = estimateTrack(walk(truth, seed, count));
            QVERIFY(estimate.velocity_mps && estimate.q_m2ps && !estimate.stationary);
            east_mps.push_back(estimate.velocity_mps->x());
            north_mps.push_back(estimate.velocity_mps->y());
            growths_m2ps.push_back(*estimate.q_m2ps);
        }
        const Mean east = meanOf(east_mps);
        const Mean north = meanOf(north_mps);
        const Mean growth = meanOf(growths_m2ps);
        COMPARE_NEAR(east.value, truth.velocity_mps.x(), 5 * east.error);
        COMPARE_NEAR(north.value, truth.velocity_mps.y(), 5 * north.error);
        COMPARE_NEAR(growth.value, q_m2ps, 5 * growth.error);
        QVERIFY(growth.error < 0.05 * q_m2ps); // the test could detect a bias of a quarter
    }

    /** Var(v) = q / T, the least that any unbiased estimate of a random walk's drift can have. */
    void velocityIsAsGoodAsItCanBe()
    {
        const Truth truth;
        std::vector<double> squares;
        for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
            const std::vector<Fix> fixes = walk(truth, seed);
            const double error_mps =
                estimateTrack(fixes, {.window_s = 1e9}).velocity_mps->x() - truth.velocity_mps.x();
            squares.push_back(error_mps * error_mps * fixes.back().time_s);
        }
        const Mean mean = meanOf(squares);
        COMPARE_NEAR(mean.value, truth.q_m2ps, 5 * mean.error);
    }

    void oneSightingHasNoVelocity()
    {
        const TrackEstimate estimate = estimateTrack(steady(1));
        QCOMPARE(estimate.used, std::size_t{1});
        QVERIFY(!estimate.velocity_mps && !estimate.q_m2ps);
    }

    void twoSightingsHaveVelocityAlone()
    {
        const TrackEstimate estimate = estimateTrack(steady(2));
        QVERIFY(estimate.velocity_mps && !estimate.q_m2ps);
        COMPARE_NEAR((*estimate.velocity_mps - Point(0.2, 0.1)).norm(), 0, 1e-12);
    }

    void constantVelocityHasNoGrowth()
    {
        const TrackEstimate estimate = estimateTrack(steady(20));
        QCOMPARE(estimate.used, std::size_t{20});
        COMPARE_NEAR(*estimate.q_m2ps, 0, 1e-9); // rounding
    }

    void orderOfTheFileDoesNotMatter()
    {
        std::vector<Fix> fixes = steady(12);
        std::reverse(fixes.begin(), fixes.end());
        const TrackEstimate estimate = estimateTrack(fixes);
        QCOMPARE(estimate.last, std::size_t{0});
        COMPARE_NEAR((*estimate.velocity_mps - Point(0.2, 0.1)).norm(), 0, 1e-12);
    }

    void repeatedTimesCountOnce()
    {
        std::vector<Fix> fixes = steady(6);
        fixes.push_back(fixes[2]);
        fixes.push_back({.time_s = fixes[5].time_s, .position_m = fixes[5].position_m * 1.1});
        const TrackEstimate estimate = estimateTrack(fixes);
        QCOMPARE(estimate.repeated, std::size_t{2});
        QCOMPARE(estimate.used, std::size_t{6});
        QCOMPARE(estimate.last, std::size_t{7}); // the later fix counts
    }

    void equalTimesLeaveNoVelocity()
    {
        const std::vector<Fix> fixes(5, Fix{.time_s = 7, .position_m = {1, 2}});
        const TrackEstimate estimate = estimateTrack(fixes);
        QCOMPARE(estimate.used, std::size_t{1});
        QVERIFY(!estimate.velocity_mps);
    }

    void jumpsAreLeftOut_data()
    {
        QTest::addColumn<int>("at");
        QTest::newRow("first") << 0;
        QTest::newRow("middle") << 10;
        QTest::newRow("last") << 19;
    }

    void jumpsAreLeftOut()
    {
        QFETCH(int, at);
        std::vector<Fix> fixes = steady(20);
        fixes[static_cast<std::size_t>(at)].position_m += Point(400'000, -90'000);
        const TrackEstimate estimate = estimateTrack(fixes);
        QCOMPARE(estimate.jumped, std::size_t{1});
        QCOMPARE(estimate.used, std::size_t{19});
        COMPARE_NEAR((*estimate.velocity_mps - Point(0.2, 0.1)).norm(), 0, 1e-12);
        COMPARE_NEAR(*estimate.q_m2ps, 0, 1e-9);
    }

    /** Every second fix is elsewhere: two tracks in one; the one seen last wins. */
    void twoIcebergsUnderOneName()
    {
        std::vector<Fix> fixes = steady(20);
        for (std::size_t i = 0; i < fixes.size(); i += 2)
            fixes[i].position_m += Point(300'000, 0);
        const TrackEstimate estimate = estimateTrack(fixes);
        QCOMPARE(estimate.used, std::size_t{10});
        QCOMPARE(estimate.last, std::size_t{19});
    }

    void windowLimitsHowFarBack()
    {
        std::vector<Fix> fixes = steady(20, Point(-0.3, 0));
        const double turn_s = fixes.back().time_s;
        const Point corner_m = fixes.back().position_m;
        for (int i = 1; i <= 80; ++i)
            fixes.push_back({.time_s = turn_s + i * kHour_s,
                             .position_m = corner_m + Point(0, 0.2) * (i * kHour_s)});
        const TrackEstimate estimate = estimateTrack(fixes); // the window is 24 h
        QCOMPARE(estimate.used, std::size_t{25});
        COMPARE_NEAR((*estimate.velocity_mps - Point(0, 0.2)).norm(), 0, 1e-12);
    }

    void longGapsLeaveNoVelocity()
    {
        const auto two = [](double days) {
            return std::vector<Fix>{{.time_s = 0, .position_m = {0, 0}},
                                    {.time_s = days * 86400, .position_m = {days * 8640, 0}}};
        };
        COMPARE_NEAR(estimateTrack(two(10)).velocity_mps->x(), 0.1, 1e-12);
        QVERIFY(!estimateTrack(two(20)).velocity_mps); // the first fix is too old
        QCOMPARE(estimateTrack(two(20)).last, std::size_t{1});
    }

    void stationaryIsReported()
    {
        std::vector<Fix> fixes =
            walk({.velocity_mps = Point::Zero(), .q_m2ps = 0, .error_m = 60}, 3);
        const TrackEstimate estimate = estimateTrack(fixes);
        QVERIFY(estimate.stationary);
        QVERIFY(estimate.velocity_mps->isZero(0) && !estimate.q_m2ps);
        QVERIFY(!estimateTrack(fixes, {.stationaryFor_s = 0}).stationary);
        fixes.resize(5); // less than a day
        QVERIFY(!estimateTrack(fixes).stationary);
    }

    void clampsAreReported()
    {
        const TrackRules loose{.fastest_mps = 1e6, .stationaryFor_s = 0};
        const TrackEstimate fast = estimateTrack(steady(5, Point(40, -70)), loose);
        QVERIFY(fast.velocityClamped && *fast.velocity_mps == Point(5, -5));
        std::vector<Fix> wild = steady(8);
        for (std::size_t i = 0; i < wild.size(); i += 2)
            wild[i].position_m += Point(9e5, 0);
        const TrackEstimate spread = estimateTrack(wild, loose);
        QVERIFY(spread.growthClamped && *spread.q_m2ps == 1e6);
    }

    void numbersThatAreNotFiniteAreLeftOut()
    {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const double infinity = std::numeric_limits<double>::infinity();
        std::vector<Fix> fixes = steady(6);
        fixes.push_back({.time_s = nan, .position_m = {0, 0}});
        fixes.push_back({.time_s = 1e5, .position_m = {nan, 0}});
        fixes.push_back({.time_s = infinity, .position_m = {0, infinity}});
        const TrackEstimate estimate = estimateTrack(fixes);
        QCOMPARE(estimate.used, std::size_t{6});
        const TrackEstimate none = estimateTrack(std::vector<Fix>{fixes[6]});
        QCOMPARE(none.used, std::size_t{0});
        // Times so uneven that the denominators cancel.
        const std::vector<Fix> uneven{{.time_s = -1e9, .position_m = {0, 0}},
                                      {.time_s = 0, .position_m = {1, 0}},
                                      {.time_s = 1e-7, .position_m = {2000, 0}},
                                      {.time_s = 2e-7, .position_m = {-10, 5}}};
        const TrackEstimate odd = estimateTrack(uneven, {.window_s = 1e12});
        QVERIFY(odd.velocity_mps->allFinite());
        QVERIFY(*odd.q_m2ps >= 0 && *odd.q_m2ps <= 1e6);
    }

    void thinningKeepsTheTolerance_data()
    {
        QTest::addColumn<double>("tolerance_m");
        for (const double tolerance_m : {1.0, 50.0, 500.0, 5000.0})
            QTest::addRow("%g m", tolerance_m) << tolerance_m;
    }

    void thinningKeepsTheTolerance()
    {
        QFETCH(double, tolerance_m);
        std::size_t before = 0;
        std::size_t after = 0;
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            RecordedTrack track;
            for (const Fix& fix : walk({}, seed, 200)) {
                track.time_s.push_back(fix.time_s);
                track.position_m.push_back(fix.position_m);
            }
            const RecordedTrack thin = thinned(track, tolerance_m);
            QCOMPARE(thin.time_s.size(), thin.position_m.size());
            QCOMPARE(thin.time_s.front(), track.time_s.front());
            QCOMPARE(thin.time_s.back(), track.time_s.back());
            for (std::size_t i = 0; i < track.time_s.size(); ++i)
                QVERIFY((thin.at(track.time_s[i]) - track.position_m[i]).norm() <=
                        tolerance_m * (1 + 1e-9));
            before += track.time_s.size();
            after += thin.time_s.size();
        }
        QVERIFY(after <= before);
        QVERIFY(tolerance_m < 5000 || after < before / 5); // steps are about 500 m
    }

    void straightTrackThinsToItsEnds()
    {
        RecordedTrack track;
        for (const Fix& fix : steady(100)) {
            track.time_s.push_back(fix.time_s);
            track.position_m.push_back(fix.position_m);
        }
        QCOMPARE(thinned(track, 1).time_s.size(), std::size_t{2});
        QVERIFY(thinned(track, 0) == track);
    }
};

QTEST_APPLESS_MAIN(TestSightingTrack)
#include "tst_sighting_track.moc"
