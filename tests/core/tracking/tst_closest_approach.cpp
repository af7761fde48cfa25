#include "core/base/random.h"
#include "core/tracking/closest_approach.h"
#include "tests/support/approx.h"

#include <QTest>

using namespace berg;

namespace {

constexpr double kHorizon_s = 3600;

RelativeMotion randomMotion(Random& random)
{
    return {.offset_m = {random.uniform(-9000, 9000), random.uniform(-9000, 9000)},
            .velocity_mps = {random.uniform(-4, 4), random.uniform(-4, 4)}};
}

double distanceAt(const RelativeMotion& motion, double time_s)
{
    return (motion.offset_m + motion.velocity_mps * time_s).norm();
}

} // namespace

class TestClosestApproach : public QObject
{
    Q_OBJECT

private slots:
    void approachAndEntryByHand()
    {
        const RelativeMotion crossing{.offset_m = {-1000, 300}, .velocity_mps = {2, 0}};
        COMPARE_NEAR(closestApproach(crossing, kHorizon_s).time_s, 500, 1e-12);
        COMPARE_NEAR(closestApproach(crossing, kHorizon_s).distance_m, 300, 1e-12);
        // The entry is 400 m before abeam on a circle of 500 m, 300 m off the course.
        COMPARE_NEAR(entryTime_s(crossing, 500, kHorizon_s).value(), 300, 1e-9);
        QVERIFY(!entryTime_s(crossing, 299, kHorizon_s));
    }

    void onlyWithinTheHorizon()
    {
        const RelativeMotion slow{.offset_m = {-1000, 0}, .velocity_mps = {0.1, 0}};
        COMPARE_NEAR(closestApproach(slow, kHorizon_s).time_s, kHorizon_s, 0);
        COMPARE_NEAR(closestApproach(slow, kHorizon_s).distance_m, 640, 1e-9);
        QVERIFY(!entryTime_s(slow, 600, kHorizon_s));
        QVERIFY(entryTime_s(slow, 700, kHorizon_s).has_value());
    }

    void goingAwayAndStandingStill()
    {
        const RelativeMotion away{.offset_m = {1000, 0}, .velocity_mps = {2, 0}};
        QCOMPARE(closestApproach(away, kHorizon_s).time_s, 0.0);
        QCOMPARE(closestApproach(away, kHorizon_s).distance_m, 1000.0);
        QVERIFY(!entryTime_s(away, 500, kHorizon_s));
        const RelativeMotion still{.offset_m = {0, 700}, .velocity_mps = {0, 0}};
        QCOMPARE(closestApproach(still, kHorizon_s).distance_m, 700.0);
        QVERIFY(!entryTime_s(still, 500, kHorizon_s));
        QCOMPARE(entryTime_s(still, 700, kHorizon_s).value(), 0.0);
    }

    /** Compares with sampling at every second. */
    void agreesWithSampling()
    {
        Random random(5, 0);
        int entered = 0;
        for (int k = 0; k < 300; ++k) {
            const RelativeMotion motion = randomMotion(random);
            const double radius_m = random.uniform(100, 4000);
            const ClosestApproach found = closestApproach(motion, kHorizon_s);
            COMPARE_NEAR(distanceAt(motion, found.time_s), found.distance_m, 1e-9);
            const std::optional<double> entry_s = entryTime_s(motion, radius_m, kHorizon_s);
            std::optional<double> sampled_s;
            for (int t = 0; t <= static_cast<int>(kHorizon_s); ++t) {
                QVERIFY(distanceAt(motion, t) >= found.distance_m - 1e-9);
                if (!sampled_s && distanceAt(motion, t) <= radius_m)
                    sampled_s = t;
            }
            if (sampled_s) {
                QVERIFY(entry_s && *entry_s <= *sampled_s && *entry_s > *sampled_s - 1);
                ++entered;
            } else if (entry_s) { // between two seconds
                QVERIFY(found.distance_m <= radius_m);
            }
        }
        QVERIFY(entered > 30);
    }
};

QTEST_APPLESS_MAIN(TestClosestApproach)
#include "tst_closest_approach.moc"
