#include "core/tracking/drift.h"
#include "tests/support/approx.h"

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

using namespace berg;

namespace {

constexpr int kEnsemble = 2000;
constexpr double kQ_m2ps = 0.025; // Table 3

const DriftSpec kSpec{.position_m = {1000, -2000}, .velocity_mps = {0.3, -0.1}};

/** Error of dead reckoning of one iceberg: truth minus known motion. */
Point wander_m(const DriftSpec& spec, std::uint64_t seed, const std::string& id, double time_s)
{
    DriftModel drift(spec, seed, id, true);
    return drift.position_m(time_s) - spec.position_m - spec.velocity_mps * (time_s - spec.start_s);
}

/** Sums over an ensemble of pairs (x, y). */
struct Spread
{
    double n = 0;
    Point mean = Point::Zero();
    Point variance = Point::Zero(); ///< about 0, the known mean
    double covariance = 0;
};

Spread spreadOf(const std::vector<Point>& errors_m)
{
    Spread spread;
    spread.n = static_cast<double>(errors_m.size());
    for (const Point& e_m : errors_m) {
        spread.mean += e_m / spread.n;
        spread.variance += e_m.cwiseProduct(e_m) / spread.n;
        spread.covariance += e_m.x() * e_m.y() / spread.n;
    }
    return spread;
}

} // namespace

class TestDrift : public QObject
{
    Q_OBJECT

private slots:
    /** Eq. (17), (20): E[e e^T] = q t I. */
    void varianceGrowsLinearly_data()
    {
        QTest::addColumn<double>("time_s");
        QTest::addColumn<bool>("overSeeds");
        for (const double time_s : {1.0, 10.0, 100.0, 1000.0}) {
            QTest::addRow("seeds, %g s", time_s) << time_s << true;
            QTest::addRow("ids, %g s", time_s) << time_s << false;
        }
    }

    void varianceGrowsLinearly()
    {
        QFETCH(double, time_s);
        QFETCH(bool, overSeeds);
        std::vector<Point> errors_m;
        for (std::uint64_t i = 1; i <= kEnsemble; ++i)
            errors_m.push_back(overSeeds ? wander_m(kSpec, i, "berg-1", time_s)
                                         : wander_m(kSpec, 1, "berg-" + std::to_string(i), time_s));
        const Spread spread = spreadOf(errors_m);
        const double expected_m2 = kQ_m2ps * time_s;
        // The limits are 5 sigma: of a mean sqrt(v/n), of a variance v sqrt(2/n), of a covariance
        // v/sqrt(n).
        const double root = std::sqrt(spread.n);
        for (const int axis : {0, 1}) {
            COMPARE_NEAR(spread.mean(axis), 0, 5 * std::sqrt(expected_m2) / root);
            COMPARE_NEAR(spread.variance(axis), expected_m2,
                         5 * expected_m2 * std::numbers::sqrt2 / root);
        }
        COMPARE_NEAR(spread.covariance, 0, 5 * expected_m2 / root);
    }

    /** White noise: the increments from 50 s to 100 s are independent of those before. */
    void incrementsAreIndependent()
    {
        std::vector<Point> products;
        std::vector<Point> later_m;
        for (std::uint64_t seed = 1; seed <= kEnsemble; ++seed) {
            const Point before_m = wander_m(kSpec, seed, "berg-1", 50);
            const Point step_m = wander_m(kSpec, seed, "berg-1", 100) - before_m;
            products.push_back(before_m.cwiseProduct(step_m));
            later_m.push_back(step_m);
        }
        const double expected_m2 = kQ_m2ps * 50;
        const double root = std::sqrt(static_cast<double>(kEnsemble));
        for (const int axis : {0, 1}) { // 5 sigma
            COMPARE_NEAR(spreadOf(products).mean(axis), 0, 5 * expected_m2 / root);
            COMPARE_NEAR(spreadOf(later_m).variance(axis), expected_m2,
                         5 * expected_m2 * std::numbers::sqrt2 / root);
        }
    }

    /** The stream is named by seed and id; each second takes one normal for x, then one for y. */
    void noiseComesFromTheNamedStream()
    {
        DriftModel drift(kSpec, 42, "berg-7", true);
        Random random(42, stableHash("berg-7"));
        Point expected_m = kSpec.position_m;
        for (int second = 1; second <= 100; ++second) {
            const double x = random.normal();
            const double y = random.normal();
            expected_m += kSpec.velocity_mps + std::sqrt(kQ_m2ps) * Point(x, y);
            COMPARE_NEAR((drift.position_m(second) - expected_m).norm(), 0, 1e-9); // rounding
        }
    }

    void sameNoiseForEveryTimeStep_data()
    {
        QTest::addColumn<int>("stepsPerSecond");
        QTest::newRow("0.01 s") << 100;
        QTest::newRow("0.1 s") << 10;
        QTest::newRow("1/3 s, not a decimal") << 3;
        QTest::newRow("1 s") << 1;
    }

    void sameNoiseForEveryTimeStep()
    {
        QFETCH(int, stepsPerSecond);
        DriftModel fine(kSpec, 3, "berg-1", true);
        DriftModel once(kSpec, 3, "berg-1", true);
        const double dt_s = 1.0 / stepsPerSecond;
        Point last_m = Point::Zero();
        for (int i = 0; i <= 1000 * stepsPerSecond; ++i) {
            last_m = fine.position_m(i * dt_s);
            if (i % (100 * stepsPerSecond) != 0)
                continue;
            const Point direct_m = once.position_m(1.0 * i / stepsPerSecond);
            COMPARE_NEAR((last_m - direct_m).norm(), 0, 1e-9); // sums in another order
        }
        DriftModel jump(kSpec, 3, "berg-1", true);
        COMPARE_NEAR((jump.position_m(1000) - last_m).norm(), 0, 1e-9);
    }

    void linearBetweenGridPoints()
    {
        DriftModel drift(kSpec, 5, "berg-1", true);
        std::vector<Point> at_m;
        for (int quarter = 0; quarter <= 80; ++quarter)
            at_m.push_back(drift.position_m(0.25 * quarter));
        double bend_m = 0;
        for (std::size_t second = 0; second < 20; ++second) {
            const Point a_m = at_m[4 * second];
            const Point b_m = at_m[4 * second + 4];
            for (std::size_t quarter = 1; quarter < 4; ++quarter) {
                const double share = 0.25 * static_cast<double>(quarter);
                const Point expected_m = (1 - share) * a_m + share * b_m;
                COMPARE_NEAR((at_m[4 * second + quarter] - expected_m).norm(), 0, 1e-12);
            }
            if (second > 0)
                bend_m = std::max(bend_m, (b_m - 2 * a_m + at_m[4 * second - 4]).norm());
        }
        QVERIFY(bend_m > 0.1); // the path bends at the grid points
    }

    void withoutNoiseItIsDeadReckoning()
    {
        DriftModel drift(kSpec, 9, "berg-1", false);
        for (int i = 0; i <= 10000; ++i) {
            const Point expected_m(1000 + 0.3 * (0.1 * i), -2000 - 0.1 * (0.1 * i));
            COMPARE_NEAR((drift.position_m(0.1 * i) - expected_m).norm(), 0, 1e-12);
        }
    }

    void noIntensityNoNoise()
    {
        DriftSpec spec = kSpec;
        spec.q_m2ps = 0;
        QCOMPARE(wander_m(spec, 1, "berg-1", 500).norm(), 0.0);
    }

    void noiseScalesWithTheRootOfQ()
    {
        DriftSpec spec = kSpec;
        spec.q_m2ps = 4 * kQ_m2ps;
        const Point once_m = wander_m(kSpec, 1, "berg-1", 123.4);
        QVERIFY(once_m.norm() > 0.01);
        COMPARE_NEAR((wander_m(spec, 1, "berg-1", 123.4) - 2 * once_m).norm(), 0, 1e-9);
    }

    void idsAndSeedsAreIndependent()
    {
        std::vector<Point> ids;
        std::vector<Point> seeds;
        for (std::uint64_t i = 1; i <= kEnsemble; ++i) {
            const Point a_m = wander_m(kSpec, i, "berg-1", 100);
            ids.push_back(a_m.cwiseProduct(wander_m(kSpec, i, "berg-2", 100)));
            seeds.push_back(a_m.cwiseProduct(wander_m(kSpec, i + 1, "berg-1", 100)));
        }
        const double limit_m2 = 5 * kQ_m2ps * 100 / std::sqrt(static_cast<double>(kEnsemble));
        for (const int axis : {0, 1}) { // 5 sigma of a mean of products
            COMPARE_NEAR(spreadOf(ids).mean(axis), 0, limit_m2);
            COMPARE_NEAR(spreadOf(seeds).mean(axis), 0, limit_m2);
        }
    }

    /** An iceberg that starts later uses its noise from its own start, shifted and unchanged. */
    void startsLater()
    {
        DriftSpec later = kSpec;
        later.start_s = 123.4;
        DriftModel a(kSpec, 6, "berg-1", true);
        DriftModel b(later, 6, "berg-1", true);
        for (int i = 0; i <= 500; ++i)
            COMPARE_NEAR((a.position_m(0.3 * i) - b.position_m(123.4 + 0.3 * i)).norm(), 0, 1e-9);
        DriftModel c(later, 6, "berg-1", true);
        QVERIFY(c.position_m(123.4) == kSpec.position_m);
    }

    /** Numbers drawn in advance, on demand, and beyond those in advance are equal bit for bit. */
    void noiseDrawnAtOnceIsTheSame()
    {
        const DriftNoise drawn(7, "berg-1", 100);
        QVERIFY(drawn.isOf(7, "berg-1"));
        QVERIFY(!drawn.isOf(8, "berg-1"));
        QVERIFY(!drawn.isOf(7, "berg-2"));
        DriftModel fresh(kSpec, 7, "berg-1", true);
        DriftModel first(kSpec, drawn, true);
        DriftModel second(kSpec, drawn, true); // copies do not consume each other's numbers
        for (int i = 0; i <= 600; ++i) {
            const Point expected_m = fresh.position_m(0.5 * i);
            QVERIFY(first.position_m(0.5 * i) == expected_m);
            QVERIFY(second.position_m(0.5 * i) == expected_m);
        }
    }

    void lookingAheadUsesNoNoise()
    {
        DriftModel asked(kSpec, 7, "berg-1", true);
        DriftModel other(kSpec, 7, "berg-1", true);
        asked.advanceTo(20.5);
        const Point ahead_m = asked.at(33.25);
        QVERIFY(asked.position_m(21) == other.position_m(21));
        QVERIFY(other.position_m(33.25) == ahead_m);
    }

    void neverFasterThanItsLimit()
    {
        DriftModel drift(kSpec, 7, "berg-1", true);
        const double limit_mps = drift.speedLimit_mps();
        QVERIFY(limit_mps < 4); // a larger limit would be useless
        Point last_m = drift.position_m(0);
        for (int second = 1; second <= 10000; ++second) {
            const Point now_m = drift.position_m(second);
            QVERIFY((now_m - last_m).norm() <= limit_mps);
            last_m = now_m;
        }
        COMPARE_NEAR(DriftModel(kSpec, 7, "berg-1", false).speedLimit_mps(), std::hypot(0.3, 0.1),
                     1e-15);
        DriftSpec recorded = kSpec;
        recorded.track = std::make_shared<const RecordedTrack>(RecordedTrack{{0}, {{1, 2}}});
        QVERIFY(std::isinf(DriftModel(recorded, 7, "berg-1", true).speedLimit_mps()));
    }
};

QTEST_APPLESS_MAIN(TestDrift)
#include "tst_drift.moc"
