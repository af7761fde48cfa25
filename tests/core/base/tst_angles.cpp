#include "core/base/angles.h"
#include "tests/support/approx.h"

#include <limits>

using namespace berg;

class TestAngles : public QObject
{
    Q_OBJECT

private slots:
    void degreesAndRadians()
    {
        COMPARE_NEAR(radFromDeg(180), 3.14159265358979324, 1e-15);
        COMPARE_NEAR(radFromDeg(25), 0.43633231299858238, 1e-16);
        COMPARE_NEAR(degFromRad(1), 57.2957795130823209, 1e-13);
        COMPARE_NEAR(degFromRad(radFromDeg(-123.25)), -123.25, 1e-13);
    }

    void wrapGoesToTheSameDirection()
    {
        for (int i = -2000; i <= 2000; ++i) {
            const double angle_rad = 0.0173 * i;
            const double wrapped_rad = wrapPi(angle_rad);
            QVERIFY(std::abs(wrapped_rad) <= kPi);
            // atan2 of sine and cosine is an independent formula; at 34 rad it loses 3 bits.
            COMPARE_NEAR(wrapped_rad, std::atan2(std::sin(angle_rad), std::cos(angle_rad)), 1e-13);
        }
    }

    void wrapAtTheEnds()
    {
        COMPARE_NEAR(std::abs(wrapPi(kPi)), kPi, 0);
        COMPARE_NEAR(std::abs(wrapPi(-kPi)), kPi, 0);
        COMPARE_NEAR(wrapPi(kPi + 0.25), -kPi + 0.25, 1e-15);
        COMPARE_NEAR(wrapPi(-kPi - 0.25), kPi - 0.25, 1e-15);
        COMPARE_NEAR(wrapPi(0), 0, 0);
        QVERIFY(std::isnan(wrapPi(std::numeric_limits<double>::infinity())));
    }

    /**
     * Angles already in range are returned unchanged, including the sign of 0, like the remainder.
     */
    void wrapIsTheRemainder()
    {
        for (const double angle_rad :
             {0.0, -0.0, 1e-300, 3.0, kPi, -kPi, std::nextafter(kPi, 4), -3.2, 100.0}) {
            const double expected_rad = std::remainder(angle_rad, 2 * kPi);
            QVERIFY(wrapPi(angle_rad) == expected_rad);
            QCOMPARE(std::signbit(wrapPi(angle_rad)), std::signbit(expected_rad));
        }
    }

    /** Navigators count clockwise from north, the paper counter-clockwise from east. */
    void headingAndPsi_data()
    {
        QTest::addColumn<double>("heading_deg");
        QTest::addColumn<double>("psi_deg");
        QTest::newRow("north") << 0.0 << 90.0;
        QTest::newRow("north-east, the paper's start") << 45.0 << 45.0;
        QTest::newRow("east") << 90.0 << 0.0;
        QTest::newRow("south-east") << 135.0 << -45.0;
        QTest::newRow("south") << 180.0 << -90.0;
        QTest::newRow("south-west") << 225.0 << -135.0;
        QTest::newRow("west of north") << 300.0 << 150.0;
        QTest::newRow("just west of north") << 359.0 << 91.0;
    }

    void headingAndPsi()
    {
        QFETCH(double, heading_deg);
        QFETCH(double, psi_deg);
        COMPARE_NEAR(psiFromHeading(heading_deg), psi_deg * std::acos(-1.0) / 180, 1e-14);
        COMPARE_NEAR(headingFromPsi(psi_deg * std::acos(-1.0) / 180), heading_deg, 1e-12);
        // A heading typed as -60 or 660 is the same as 300.
        COMPARE_NEAR(psiFromHeading(heading_deg - 360), psi_deg * std::acos(-1.0) / 180, 1e-13);
        COMPARE_NEAR(psiFromHeading(heading_deg + 720), psi_deg * std::acos(-1.0) / 180, 1e-13);
    }

    void headingStaysBelow360()
    {
        const double north_rad = radFromDeg(90.0);
        const double infinity = std::numeric_limits<double>::infinity();
        double psi_rad = north_rad;
        for (int i = 0; i < 20; ++i) { // a hair west of north: -1e-14 degrees must not become 360
            const double heading_deg = headingFromPsi(psi_rad);
            QVERIFY(heading_deg >= 0 && heading_deg < 360);
            psi_rad = std::nextafter(psi_rad, infinity);
        }
        for (int i = -1000; i <= 1000; ++i) {
            const double heading_deg = headingFromPsi(0.05 * i);
            QVERIFY(heading_deg >= 0 && heading_deg < 360);
            const double back_rad = psiFromHeading(heading_deg);
            COMPARE_NEAR(std::remainder(back_rad - 0.05 * i, 2 * std::acos(-1.0)), 0, 1e-12);
        }
    }
};

QTEST_APPLESS_MAIN(TestAngles)
#include "tst_angles.moc"
