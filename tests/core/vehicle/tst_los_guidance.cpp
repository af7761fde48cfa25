#include "core/base/angles.h"
#include "core/vehicle/los_guidance.h"
#include "tests/support/approx.h"

#include <algorithm>

using namespace berg;

namespace {

constexpr double kStep_s = 0.1;

/** One flight along a leg; the air may move by more than the wind known to the guidance. */
struct Flight
{
    LosGuidance guidance;
    DubinsState uav;
    Point end_m = Point::Zero();
    Motion motion;                         ///< known to the guidance
    Point disturbance_mps = Point::Zero(); ///< unknown to the guidance
    LosGuidance::Command command;

    void fly(double time_s)
    {
        const auto steps = static_cast<int>(std::lround(time_s / kStep_s));
        for (int i = 0; i < steps; ++i) {
            command = guidance.steer(uav, end_m, motion, kStep_s);
            uav = step(uav, motion.airspeed_mps, command.u_radps, kStep_s,
                       motion.wind_mps + disturbance_mps);
        }
    }
};

Point direction(double angle_rad)
{
    return {std::cos(angle_rad), std::sin(angle_rad)};
}

/** Starts along a leg of 80 km in direction chi, `e_m` to the left of it, on the leg's course. */
Flight besideLeg(double chi_rad, double e_m, double integral_mps)
{
    Flight flight;
    flight.guidance.gains.integral_mps = integral_mps;
    flight.guidance.startLeg({200, -300});
    flight.end_m = Point(200, -300) + 80000 * direction(chi_rad);
    flight.uav = {.position_m = Point(200, -300) + e_m * direction(chi_rad + kPi / 2),
                  .psi_rad = chi_rad};
    return flight;
}

} // namespace

class TestLosGuidance : public QObject
{
    Q_OBJECT

private slots:
    /** Fossen's e is positive left of the leg, whatever the leg's direction. */
    void crossTrackSign_data()
    {
        QTest::addColumn<double>("chi_rad");
        for (const int chi_deg : {0, 45, 90, 170, -170, -90, -30})
            QTest::addRow("course %d degrees", chi_deg) << radFromDeg(chi_deg);
    }

    void crossTrackSign()
    {
        QFETCH(double, chi_rad);
        for (const double e_m : {50.0, -50.0, 0.0}) {
            Flight flight = besideLeg(chi_rad, e_m, 0.5);
            flight.command = flight.guidance.steer(flight.uav, flight.end_m, flight.motion, 0.1);
            COMPARE_NEAR(flight.command.crossTrack_m, e_m, 1e-10);
            // Left of the leg it must turn right (u < 0).
            if (e_m != 0)
                QVERIFY(flight.command.u_radps * e_m < 0);
        }
    }

    /** psi_d = chi - atan((e + k y)/Delta), u = psi_d - psi below the limit. */
    void lawByHand_data()
    {
        QTest::addColumn<double>("e_m");
        QTest::addColumn<double>("integral_s");
        QTest::addColumn<double>("course_deg");
        QTest::newRow("on the leg") << 0.0 << 0.0 << 0.0;
        QTest::newRow("Delta to the left") << 150.0 << 0.0 << -45.0;
        QTest::newRow("Delta to the right") << -150.0 << 0.0 << 45.0;
        QTest::newRow("e and integral add up") << 100.0 << 100.0 << -45.0;
        QTest::newRow("integral alone") << 0.0 << -300.0 << 45.0;
        QTest::newRow("far off: straight at the leg") << 1e9 << 0.0 << -90.0;
    }

    void lawByHand()
    {
        QFETCH(double, e_m);
        QFETCH(double, integral_s);
        QFETCH(double, course_deg);
        LosGuidance guidance;
        guidance.integral_s = integral_s;
        const double psi_rad = radFromDeg(course_deg) + 0.1;
        const LosGuidance::Command command =
            guidance.steer({.position_m = {1000, e_m}, .psi_rad = psi_rad}, {9000, 0}, {}, 0.1);
        COMPARE_NEAR(command.course_rad, radFromDeg(course_deg), 2e-7); // atan(1e9/150)
        COMPARE_NEAR(command.u_radps, -0.1, 2e-7);
        COMPARE_NEAR(command.crossTrack_m, e_m, 1e-10);
    }

    void turnRateIsLimitedAndTakesTheShortWay()
    {
        const Motion motion{.airspeed_mps = 22, .limit_radps = 0.2079};
        QCOMPARE(turnRateForCourse(0, 1.5, motion, 1), 0.2079);
        QCOMPARE(turnRateForCourse(0, -1.5, motion, 1), -0.2079);
        COMPARE_NEAR(turnRateForCourse(1, 1.1, motion, 1), 0.1, 1e-15);
        COMPARE_NEAR(turnRateForCourse(1, 1.1, motion, 0.5), 0.05, 1e-15);
        // From 175 to -175 degrees is 10 degrees to the left, not 350 to the right.
        COMPARE_NEAR(turnRateForCourse(radFromDeg(175), radFromDeg(-175), motion, 1),
                     radFromDeg(10), 1e-14);
    }

    /** Heading = course + crab with sin(crab) = -w_n/U: the ground track is the course. */
    void crabAngleHoldsTheCourse()
    {
        const Motion motion{.airspeed_mps = 20, .limit_radps = 0.2, .wind_mps = {3, 12}};
        for (int course_deg = -180; course_deg <= 180; course_deg += 15) {
            const double course_rad = radFromDeg(course_deg);
            double psi_rad = course_rad;
            for (int i = 0; i < 1000; ++i) // turn until the course is reached
                psi_rad += turnRateForCourse(psi_rad, course_rad, motion, 1) * 0.1;
            const Point ground_mps = 20 * direction(psi_rad) + motion.wind_mps;
            COMPARE_NEAR(cross(direction(course_rad), ground_mps), 0, 1e-9);
            QVERIFY(direction(course_rad).dot(ground_mps) > 0);
        }
    }

    /** |w_n| > U cannot be held; the answer must still be a number: into the wind. */
    void crossWindAboveTheAirspeed()
    {
        const Motion motion{.airspeed_mps = 20, .limit_radps = 0.2, .wind_mps = {0, 25}};
        COMPARE_NEAR(turnRateForCourse(-kPi / 2, 0, motion, 1), 0, 1e-12);
    }

    void convergesToTheLeg_data()
    {
        QTest::addColumn<double>("chi_rad");
        QTest::addColumn<double>("e_m");
        QTest::addColumn<double>("psiOff_rad");
        QTest::newRow("from the left") << 0.5 << 300.0 << 0.0;
        QTest::newRow("from the right") << 0.5 << -300.0 << 0.0;
        QTest::newRow("course across the cut at 180 degrees") << 3.13 << 100.0 << 0.1;
        QTest::newRow("flying away from the leg") << -2.0 << 50.0 << kPi / 2;
        QTest::newRow("flying backwards") << -2.0 << -50.0 << 3.0;
    }

    void convergesToTheLeg()
    {
        QFETCH(double, chi_rad);
        QFETCH(double, e_m);
        QFETCH(double, psiOff_rad);
        Flight flight = besideLeg(chi_rad, e_m, 0.5);
        flight.uav.psi_rad += psiOff_rad;
        flight.fly(60);
        // The proportional part has Delta/U = 7 s; the part k y integrated meanwhile stays.
        QVERIFY2(std::abs(flight.command.crossTrack_m) < 0.1 * std::abs(e_m),
                 qPrintable(QString::number(flight.command.crossTrack_m)));
        flight.fly(2400); // eight times Delta/k = 300 s
        COMPARE_NEAR(flight.command.crossTrack_m, 0, 0.02);
        COMPARE_NEAR(wrapPi(flight.uav.psi_rad - chi_rad), 0, 1e-3);
    }

    /** A wind the guidance knows needs no integral. */
    void knownWindLeavesNoError()
    {
        Flight flight = besideLeg(1.0, 80, 0);
        flight.motion.wind_mps = 9 * direction(1.0 + kPi / 2) + 2 * direction(1.0);
        flight.fly(300);
        COMPARE_NEAR(flight.command.crossTrack_m, 0, 1e-6); // 40 time constants
    }

    /**
     * A cross current c the guidance does not know. Steady state without integral:
     * U sin(atan(e/Delta)) = c, so e = Delta tan(asin(c/U)) stays for ever.
     */
    void disturbanceWithoutIntegral_data()
    {
        QTest::addColumn<double>("current_mps");
        QTest::newRow("4 m/s to the left") << 4.0;
        QTest::newRow("4 m/s to the right") << -4.0;
        QTest::newRow("1 m/s to the left") << 1.0;
    }

    void disturbanceWithoutIntegral()
    {
        QFETCH(double, current_mps);
        Flight flight = besideLeg(0.8, 0, 0);
        flight.disturbance_mps = current_mps * direction(0.8 + kPi / 2);
        const double steady_m = 150 * std::tan(std::asin(current_mps / 22));
        flight.fly(200);
        COMPARE_NEAR(flight.command.crossTrack_m, steady_m, 1e-3);
        flight.fly(1600);
        COMPARE_NEAR(flight.command.crossTrack_m, steady_m, 1e-6);
    }

    void disturbanceWithIntegral_data() { disturbanceWithoutIntegral_data(); }

    /**
     * With k = 0.5 m/s the same error first builds up within Delta/U and is then removed slowly. On
     * the slow manifold e + k y = E0 (the error above) and dy/dt = Delta e/(E0^2 + Delta^2), so e =
     * E0 exp(-t/T), T = (E0^2 + Delta^2)/(k Delta), 300 s for a small current.
     */
    void disturbanceWithIntegral()
    {
        QFETCH(double, current_mps);
        Flight flight = besideLeg(0.8, 0, 0.5);
        flight.disturbance_mps = current_mps * direction(0.8 + kPi / 2);
        const double start_m = 150 * std::tan(std::asin(current_mps / 22));
        const double slow_s = (start_m * start_m + 150 * 150) / (0.5 * 150);

        flight.fly(60);
        const double after60_m = flight.command.crossTrack_m;
        QVERIFY(after60_m / start_m > 0.7); // it acts slowly
        flight.fly(300);
        const double after360_m = flight.command.crossTrack_m;
        // 0.01: the manifold moves too, which shortens T by k/U = 2 %.
        COMPARE_NEAR(after360_m / after60_m, std::exp(-300 / slow_s), 0.01);
        flight.fly(1800); // 40 km and more from the start
        QVERIFY((flight.uav.position_m - flight.guidance.start_m).norm() > 40000);
        COMPARE_NEAR(flight.command.crossTrack_m / start_m, 0, 0.002); // exp(-2160/310) = 0.001
        COMPARE_NEAR(flight.guidance.gains.integral_mps * flight.guidance.integral_s, start_m,
                     0.002 * std::abs(start_m));
    }

    /** dy/dt = Delta e/((e + k y)^2 + Delta^2) over one step. */
    void integralGrowsByTheLaw()
    {
        LosGuidance guidance;
        guidance.integral_s = 12;
        const DubinsState state{.position_m = {1000, 30}, .psi_rad = -0.2};
        (void)guidance.steer(state, {9000, 0}, {}, 0.25);
        // e + k y = 36: 12 + 0.25 x 150 x 30/(36^2 + 150^2)
        COMPARE_NEAR(guidance.integral_s, 12 + 0.25 * 4500 / 23796, 1e-14);
    }

    void saturationFreezesTheIntegral()
    {
        LosGuidance guidance;
        guidance.integral_s = 12;
        const DubinsState backwards{.position_m = {1000, 30}, .psi_rad = 3};
        const LosGuidance::Command command = guidance.steer(backwards, {9000, 0}, {}, 0.25);
        COMPARE_NEAR(std::abs(command.u_radps), 0.2079, 1e-15);
        QCOMPARE(guidance.integral_s, 12.0);
    }

    /** A long turn back to the leg leaves the integral unchanged. */
    void noWindUpInALongTurn()
    {
        Flight flight = besideLeg(0, 400, 0.5);
        flight.uav.psi_rad = kPi - 0.1; // nearly backwards: 10 s of turning at the limit
        bool saturated = true;
        int steps = 0;
        while (saturated) {
            QCOMPARE(flight.guidance.integral_s, 0.0);
            flight.fly(kStep_s);
            saturated = std::abs(flight.command.u_radps) >= flight.motion.limit_radps;
            ++steps;
        }
        QVERIFY(steps > 50);
        QVERIFY(flight.guidance.integral_s != 0);
    }

    void newLegForgetsTheIntegral()
    {
        LosGuidance guidance;
        guidance.integral_s = 99;
        guidance.startLeg({5, 6});
        QCOMPARE(guidance.integral_s, 0.0);
        QVERIFY(guidance.start_m == Point(5, 6));
        const LosGuidance::Command command =
            guidance.steer({.position_m = {5, 6}, .psi_rad = 0}, {105, 6}, {}, 0.1);
        QCOMPARE(command.crossTrack_m, 0.0);
        QCOMPARE(command.u_radps, 0.0);
    }

    void passedEndIsReported_data()
    {
        QTest::addColumn<double>("along_m");
        QTest::addColumn<double>("left_m");
        QTest::addColumn<bool>("passed");
        QTest::newRow("at the start") << 0.0 << 0.0 << false;
        QTest::newRow("behind the start") << -500.0 << 0.0 << false;
        QTest::newRow("just before the end") << 999.9 << 0.0 << false;
        QTest::newRow("just beyond the end") << 1000.1 << 0.0 << true;
        QTest::newRow("abeam of the end, not yet beyond") << 999.0 << 800.0 << false;
        QTest::newRow("beyond the end, far to the right") << 1001.0 << -800.0 << true;
    }

    void passedEndIsReported()
    {
        QFETCH(double, along_m);
        QFETCH(double, left_m);
        QFETCH(bool, passed);
        const double chi_rad = 2.2;
        LosGuidance guidance;
        guidance.startLeg({-70, 40});
        const Point end_m = Point(-70, 40) + 1000 * direction(chi_rad);
        const DubinsState state{.position_m = Point(-70, 40) + along_m * direction(chi_rad) +
                                              left_m * direction(chi_rad + kPi / 2),
                                .psi_rad = chi_rad};
        QCOMPARE(guidance.steer(state, end_m, {}, 0.1).passedEnd, passed);
    }

    /** The end is an iceberg's estimate and moves: the leg turns about its start. */
    void movingEndIsMet()
    {
        Flight flight = besideLeg(0, 0, 0.5);
        const Point drift_mps(0.3, 0.4);
        flight.end_m = {6000, -300};
        int steps = 0;
        while (!flight.command.passedEnd && steps < 4000) {
            flight.fly(kStep_s);
            flight.end_m += drift_mps * kStep_s;
            ++steps;
        }
        QVERIFY(flight.command.passedEnd);
        // It trails the turning leg by about Delta x (the end's sideways speed)/U = 3 m.
        COMPARE_NEAR((flight.uav.position_m - flight.end_m).norm(), 0, 8);
        COMPARE_NEAR(flight.uav.position_m.y(), -300 + 0.4 * kStep_s * steps, 8);
    }

    void legWithoutLengthHoldsTheCourse()
    {
        LosGuidance guidance;
        guidance.startLeg({10, 10});
        const LosGuidance::Command command =
            guidance.steer({.position_m = {10, 10}, .psi_rad = 1.2}, {10, 10}, {}, 0.1);
        COMPARE_NEAR(command.u_radps, 0, 1e-15);
        COMPARE_NEAR(command.course_rad, 1.2, 1e-15);
        QVERIFY(!command.passedEnd);
    }
};

QTEST_APPLESS_MAIN(TestLosGuidance)
#include "tst_los_guidance.moc"
