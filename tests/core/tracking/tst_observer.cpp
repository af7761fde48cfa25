#include "core/base/angles.h"
#include "core/base/random.h"
#include "core/tracking/observer.h"
#include "tests/support/approx.h"

using namespace berg;

namespace {

const Point kCentre_m(1000, -500);

/** The view is 800 m along-track, 400 m cross-track. */
FieldOfView view(FovShape shape, double psi_rad)
{
    return {{.fov_m = {800, 400}, .shape = shape}, kCentre_m, psi_rad};
}

} // namespace

class TestObserver : public QObject
{
    Q_OBJECT

private slots:
    void defaultsOfThePaper()
    {
        const SensorSpec sensor;
        QVERIFY(sensor.fov_m == Point(600, 600)); // Table 3
        QCOMPARE(sensor.shape, FovShape::Body);
    }

    /** Offsets from the centre for a UAV flying east: x is along-track, y is cross-track. */
    void shapesFlyingEast_data()
    {
        QTest::addColumn<double>("x_m");
        QTest::addColumn<double>("y_m");
        QTest::addColumn<bool>("body");
        QTest::addColumn<bool>("north");
        QTest::addColumn<bool>("disk");
        QTest::newRow("centre") << 0.0 << 0.0 << true << true << true;
        QTest::newRow("ahead, on the edge") << 400.0 << 0.0 << true << false << true;
        QTest::newRow("astern, on the edge") << -400.0 << 0.0 << true << false << true;
        QTest::newRow("ahead, beyond") << 400.001 << 0.0 << false << false << false;
        QTest::newRow("left, on the edge") << 0.0 << 200.0 << true << true << true;
        QTest::newRow("right, on the edge") << 0.0 << -200.0 << true << true << true;
        QTest::newRow("left, beyond") << 0.0 << 200.001 << false << true << true;
        QTest::newRow("north, on the edge of the north one")
            << 0.0 << 400.0 << false << true << true;
        QTest::newRow("corner, inclusive") << 400.0 << 200.0 << true << false << false;
        QTest::newRow("corner of the north one") << -200.0 << -400.0 << false << true << false;
        QTest::newRow("on the circle: 240-320-400") << 240.0 << 320.0 << false << false << true;
        QTest::newRow("off the circle") << 240.1 << 320.0 << false << false << false;
    }

    void shapesFlyingEast()
    {
        QFETCH(double, x_m);
        QFETCH(double, y_m);
        QFETCH(bool, body);
        QFETCH(bool, north);
        QFETCH(bool, disk);
        const Point p_m = kCentre_m + Point(x_m, y_m);
        QCOMPARE(view(FovShape::Body, 0).contains(p_m), body);
        QCOMPARE(view(FovShape::North, 0).contains(p_m), north);
        QCOMPARE(view(FovShape::Disk, 0).contains(p_m), disk);
        // The other two do not turn with the UAV.
        QCOMPARE(view(FovShape::North, 1.1).contains(p_m), north);
        QCOMPARE(view(FovShape::Disk, 1.1).contains(p_m), disk);
    }

    void bodyTurnsWithTheHeading()
    {
        Random random(1);
        int inside = 0;
        for (int i = 0; i < 5000; ++i) {
            const double psi_rad = random.uniform(-kPi, kPi);
            const double along_m = random.uniform(-600, 600);
            const double across_m = random.uniform(-600, 600);
            const Point p_m = kCentre_m + along_m * Point(std::cos(psi_rad), std::sin(psi_rad)) +
                              across_m * Point(-std::sin(psi_rad), std::cos(psi_rad));
            const bool expected = std::abs(along_m) <= 400 && std::abs(across_m) <= 200;
            QCOMPARE(view(FovShape::Body, psi_rad).contains(p_m), expected);
            inside += expected ? 1 : 0;
        }
        QVERIFY(inside > 500 && inside < 4500);
    }

    /** Flying north, the body rectangle is the north-aligned one. */
    void bodyFlyingNorthIsNorthAligned()
    {
        Random random(2);
        for (int i = 0; i < 2000; ++i) {
            const Point p_m =
                kCentre_m + Point(random.uniform(-600, 600), random.uniform(-600, 600));
            QCOMPARE(view(FovShape::Body, kPi / 2).contains(p_m),
                     view(FovShape::North, 0).contains(p_m));
        }
    }

    /** Eq. (22): sigma grows by q dt outside the field of view; the estimate moves as (18). */
    void trackGrowsLinearly()
    {
        Track track{
            .anchor_m = {100, 200}, .velocity_mps = {0.2, -0.4}, .sigma_m2 = 3, .q_m2ps = 0.025};
        for (int i = 1; i <= 10000; ++i) {
            track.grow(0.1);
            if (i % 1000 == 0)
                COMPARE_NEAR(track.sigma_m2, 3 + 0.025 * 0.1 * i, 1e-10); // 10,000 roundings
        }
        COMPARE_NEAR((track.estimate_m(1000) - Point(300, -200)).norm(), 0, 1e-12);
        QVERIFY(track.estimate_m(0) == Point(100, 200));
    }

    /** Eq. (23): in view sigma is 0 and the estimate is the truth, from where it moves on. */
    void trackIsResetWhenSeen()
    {
        Track track{
            .anchor_m = {100, 200}, .velocity_mps = {0.2, -0.4}, .sigma_m2 = 3, .q_m2ps = 0.025};
        track.seen({111, 222}, 50);
        QCOMPARE(track.sigma_m2, 0.0);
        QVERIFY(track.inView);
        QVERIFY(track.estimate_m(50) == Point(111, 222));
        COMPARE_NEAR((track.estimate_m(60) - Point(113, 218)).norm(), 0, 1e-12);
        QVERIFY(track.velocity_mps == Point(0.2, -0.4));
        track.grow(2);
        COMPARE_NEAR(track.sigma_m2, 0.05, 1e-16);
    }

    /** Corners and the edge of the disk are in reach, and nothing beyond is in view. */
    void reachOfTheShapes()
    {
        for (const FovShape shape : {FovShape::Body, FovShape::North, FovShape::Disk}) {
            const SensorSpec sensor{.fov_m = {800, 600}, .shape = shape};
            const double reach_m = FieldOfView::reach_m(sensor);
            COMPARE_NEAR(reach_m, shape == FovShape::Disk ? 400.0 : 500.0, 1e-12);
            for (int i = 0; i < 360; ++i) {
                const Point towards(std::cos(radFromDeg(i)), std::sin(radFromDeg(i)));
                const FieldOfView turned(sensor, kCentre_m, radFromDeg(2.5 * i));
                QVERIFY(!turned.contains(kCentre_m + (reach_m + 1e-6) * towards));
            }
        }
    }
};

QTEST_APPLESS_MAIN(TestObserver)
#include "tst_observer.moc"
