#include "core/tracking/wind_drift.h"
#include "tests/support/approx.h"

#include <QTest>

using namespace berg;

namespace {

constexpr double kRounding = 1e-12;

} // namespace

class TestWindDrift : public QObject
{
    Q_OBJECT

private slots:
    void directions()
    {
        // A wind from the west blows to the east; a current to the south-east flows there.
        COMPARE_NEAR((windFrom_mps(10, 270) - Point(10, 0)).norm(), 0, kRounding);
        COMPARE_NEAR((windFrom_mps(3, 0) - Point(0, -3)).norm(), 0, kRounding);
        COMPARE_NEAR((currentTo_mps(std::sqrt(2), 135) - Point(1, -1)).norm(), 0, kRounding);
        COMPARE_NEAR(directionTo_deg({-1, -1}), 225, kRounding);
        QCOMPARE(directionTo_deg({0, 2}), 0.0);
        QCOMPARE(directionTo_deg(Point::Zero()), 0.0);
    }

    void shareOfTheWindByHand()
    {
        // OpenBerg's usual iceberg, 100 m long with a sail of 10 m and a draft of 90 m:
        // k = 1.293 x 0.8 x 1000 / (1027 x 0.25 x 9000) = 1034.4 / 2310750 = 4.4765e-4,
        // f = 0.021158 / 1.021158.
        const IcebergDimensions usual{
            .length_m = 100, .draft_m = 90, .sail_m2 = 1000, .keel_m2 = 9000};
        COMPARE_NEAR(windShare(usual, kOpenBergDrag), 0.020719, 1e-6);
        // C-CORE: k = 1.225 x 1.1857 x 770 / (1023.6 x 0.7867 x 4681.9) = 1118.41 / 3770170.
        COMPARE_NEAR(windShare(dimensionsOfLength(100), kCCoreDrag), 0.016932, 1e-6);
    }

    void balanceOfForces()
    {
        // The law is the velocity at which the drags of air and water balance.
        for (const IcebergSize& size : kIcebergSizes) {
            if (size.length_m < kShortestIceberg_m)
                continue;
            const IcebergDimensions d = dimensionsOfLength(size.length_m);
            const Forcing forcing{.wind_mps = {-7, 12}, .current_mps = {0.3, 0.1}};
            const Point v_mps = driftVelocity_mps(driftLaw(size.length_m), forcing, 64);
            const Point air_mps = forcing.wind_mps - v_mps;
            const Point water_mps = forcing.current_mps - v_mps;
            const Point sum =
                kCCoreDrag.air_kgpm3 * kCCoreDrag.air * d.sail_m2 * air_mps.norm() * air_mps +
                kCCoreDrag.water_kgpm3 * kCCoreDrag.water * d.keel_m2 * water_mps.norm() *
                    water_mps;
            COMPARE_NEAR(sum.norm(), 0, 1e-6); // of about 1e6
        }
    }

    void velocityByHand()
    {
        // 10 m/s from the west, 0.3 m/s to the north: f 10 east, (1 - f) 0.3 north.
        const Forcing forcing{.wind_mps = windFrom_mps(10, 270),
                              .current_mps = currentTo_mps(0.3, 0)};
        const Point v_mps = driftVelocity_mps(driftLaw(100), forcing, 64);
        COMPARE_NEAR(v_mps.x(), 0.16932, 1e-5);
        COMPARE_NEAR(v_mps.y(), 0.29492, 1e-5);
        QCOMPARE(driftVelocity_mps(driftLaw(100), forcing, -64), v_mps); // it has no turn
    }

    void smallIceTurns()
    {
        // 2 % of 10 m/s towards 90 + 20 degrees: 0.2 (sin 110, cos 110) = (0.187939, -0.068404).
        const Forcing forcing{.wind_mps = windFrom_mps(10, 270),
                              .current_mps = currentTo_mps(0.3, 0)};
        for (const double length_m : {2.5, 10.0, 14.9}) {
            QCOMPARE(driftLaw(length_m), kSmallIceDrift);
            const Point north_mps = driftVelocity_mps(driftLaw(length_m), forcing, 64);
            COMPARE_NEAR((north_mps - Point(0.187939, 0.3 - 0.068404)).norm(), 0, 1e-6);
            const Point south_mps = driftVelocity_mps(driftLaw(length_m), forcing, -64);
            COMPARE_NEAR((south_mps - Point(0.187939, 0.3 + 0.068404)).norm(), 0, 1e-6);
        }
        QCOMPARE(driftVelocity_mps(kSmallIceDrift, forcing, 0),
                 driftVelocity_mps(kSmallIceDrift, forcing, 64));
        QVERIFY(driftLaw(kShortestIceberg_m) != kSmallIceDrift);
    }
};

QTEST_APPLESS_MAIN(TestWindDrift)
#include "tst_wind_drift.moc"
