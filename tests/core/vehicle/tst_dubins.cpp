#include "core/base/angles.h"
#include "core/base/random.h"
#include "core/vehicle/dubins.h"
#include "tests/support/approx.h"

using namespace berg;

namespace {

DubinsState flown(DubinsState state, double u_radps, double dt_s, int steps,
                  const Point& wind_mps = Point::Zero())
{
    for (int i = 0; i < steps; ++i)
        state = step(state, 22, u_radps, dt_s, wind_mps);
    return state;
}

/** Exact solution of Eq. (15) for a constant turn rate, no wind. */
Point arc_m(const DubinsState& start, double airspeed_mps, double u_radps, double time_s)
{
    const double r_m = airspeed_mps / u_radps;
    const double end_rad = start.psi_rad + u_radps * time_s;
    return start.position_m + r_m * Point(std::sin(end_rad) - std::sin(start.psi_rad),
                                          std::cos(start.psi_rad) - std::cos(end_rad));
}

/** Root of |d - W t| = U t: the air distance left to the displaced air equals the one flown. */
double flightTimeByBisection_s(const Point& d_m, double airspeed_mps, const Point& wind_mps)
{
    const auto left = [&](double t_s) {
        return (d_m - wind_mps * t_s).norm() - airspeed_mps * t_s;
    };
    double low_s = 0;
    double high_s = d_m.norm() / (airspeed_mps - wind_mps.norm()) + 1;
    for (int i = 0; i < 200; ++i) {
        const double middle_s = (low_s + high_s) / 2;
        (left(middle_s) > 0 ? low_s : high_s) = middle_s;
    }
    return low_s;
}

} // namespace

class TestDubins : public QObject
{
    Q_OBJECT

private slots:
    void straightLine()
    {
        const DubinsState start{.position_m = {-500, 500}, .psi_rad = kPi / 6};
        const DubinsState end = flown(start, 0, 0.1, 1000);
        const Point expected_m = Point(-500, 500) + 2200 * Point(std::sqrt(3.0) / 2, 0.5);
        COMPARE_NEAR((end.position_m - expected_m).norm(), 0, 1e-9); // 1000 roundings
        QCOMPARE(end.psi_rad, start.psi_rad);
    }

    void circleCloses_data()
    {
        QTest::addColumn<double>("u_radps");
        QTest::newRow("left, at the limit") << 0.2079;
        QTest::newRow("right, at the limit") << -0.2079;
        QTest::newRow("left, wide") << 0.01;
    }

    void circleCloses()
    {
        QFETCH(double, u_radps);
        constexpr int kSteps = 400;
        const double dt_s = 2 * kPi / std::abs(u_radps) / kSteps;
        const DubinsState start{.position_m = {100, -40}, .psi_rad = 0.7};
        const DubinsState end = flown(start, u_radps, dt_s, kSteps);
        COMPARE_NEAR((end.position_m - start.position_m).norm(), 0, 1e-7); // rounding only
        COMPARE_NEAR(wrapPi(end.psi_rad - start.psi_rad), 0, 1e-12);
        // Half-way the UAV is a diameter away, abeam on the side of the turn. The chords of equal
        // steps close to a regular polygon of side U dt.
        const DubinsState half = flown(start, u_radps, dt_s, kSteps / 2);
        const double diameter_m = 22 * dt_s / std::sin(std::abs(u_radps) * dt_s / 2);
        COMPARE_NEAR((half.position_m - start.position_m).norm(), diameter_m, 1e-8);
        const Point ahead(std::cos(0.7), std::sin(0.7));
        QVERIFY(cross(ahead, half.position_m - start.position_m) * u_radps > 0);
    }

    /** Compared with the exact arc, the mid-point course makes the error shrink with dt squared. */
    void arcIsOfSecondOrder()
    {
        const DubinsState start{.position_m = {0, 0}, .psi_rad = -1};
        const Point exact_m = arc_m(start, 22, 0.2, 10);
        const double coarse_m = (flown(start, 0.2, 0.1, 100).position_m - exact_m).norm();
        const double fine_m = (flown(start, 0.2, 0.05, 200).position_m - exact_m).norm();
        QVERIFY2(coarse_m < 0.01, qPrintable(QString::number(coarse_m))); // (u dt)^2/24 of 185 m
        COMPARE_NEAR(coarse_m / fine_m, 4, 0.01);
    }

    void windCarriesTheAircraft()
    {
        const DubinsState start{.position_m = {10, 20}, .psi_rad = 0.3};
        const Point wind_mps(-3, 7);
        for (const double u_radps : {0.0, 0.1, -0.2}) {
            const DubinsState calm = flown(start, u_radps, 0.1, 600);
            const DubinsState windy = flown(start, u_radps, 0.1, 600, wind_mps);
            // 60 s of wind on top of the same flight through the air.
            COMPARE_NEAR((windy.position_m - calm.position_m - 60 * wind_mps).norm(), 0, 1e-9);
            QCOMPARE(windy.psi_rad, calm.psi_rad);
        }
    }

    void psiStaysWrapped()
    {
        DubinsState state{.position_m = Point::Zero(), .psi_rad = 3.1};
        for (int i = 1; i <= 1000; ++i) {
            state = step(state, 22, 0.2, 0.1, Point::Zero());
            QVERIFY(std::abs(state.psi_rad) <= kPi);
            COMPARE_NEAR(std::remainder(state.psi_rad - 3.1 - 0.02 * i, 2 * kPi), 0, 1e-11);
        }
    }

    void flightTimeByHand_data()
    {
        QTest::addColumn<double>("east_mps");
        QTest::addColumn<double>("north_mps");
        QTest::addColumn<double>("time_s");
        QTest::newRow("calm") << 0.0 << 0.0 << 50.0;
        QTest::newRow("tail wind") << 5.0 << 0.0 << 40.0;
        QTest::newRow("head wind") << -10.0 << 0.0 << 100.0;
        QTest::newRow("from the right: 12-16-20 triangle") << 0.0 << 12.0 << 62.5;
        QTest::newRow("from the left") << 0.0 << -12.0 << 62.5;
        QTest::newRow("from behind and aside") << 4.0 << 12.0 << 50.0;
    }

    /** 1000 m to the east at 20 m/s. */
    void flightTimeByHand()
    {
        QFETCH(double, east_mps);
        QFETCH(double, north_mps);
        QFETCH(double, time_s);
        COMPARE_NEAR(flightTime_s({1000, 0}, 20, {east_mps, north_mps}), time_s, 1e-11);
    }

    void flightTimeSolvesTheWindTriangle()
    {
        Random random(1);
        for (int i = 0; i < 2000; ++i) {
            const Point d_m(random.uniform(-5000, 5000), random.uniform(-5000, 5000));
            const double airspeed_mps = random.uniform(5, 40);
            const double angle_rad = random.uniform(0, 2 * kPi);
            const Point wind_mps = random.uniform(0, 0.95) * airspeed_mps *
                                   Point(std::cos(angle_rad), std::sin(angle_rad));
            const double time_s = flightTime_s(d_m, airspeed_mps, wind_mps);
            const double expected_s = flightTimeByBisection_s(d_m, airspeed_mps, wind_mps);
            // At 0.95 U the triangle is flat: rounding is magnified some hundred times.
            COMPARE_NEAR(time_s, expected_s, 1e-10 * expected_s);
        }
    }

    void noDistanceNoTime()
    {
        QCOMPARE(flightTime_s(Point::Zero(), 22, Point::Zero()), 0.0);
        QCOMPARE(flightTime_s(Point::Zero(), 22, {15, -10}), 0.0);
    }

    /**
     * A flight on the heading with the crab angle arrives at the time that flightTime_s returns.
     */
    void flightTimeIsFlown()
    {
        const Point d_m(3000, -1500);
        const Point wind_mps(6, 9);
        const double time_s = flightTime_s(d_m, 22, wind_mps);
        const Point air_m = d_m - wind_mps * time_s; // the course through the air
        DubinsState state{.position_m = Point::Zero(), .psi_rad = std::atan2(air_m.y(), air_m.x())};
        state = flown(state, 0, time_s / 1000, 1000, wind_mps);
        COMPARE_NEAR((state.position_m - d_m).norm(), 0, 1e-8);
    }
};

QTEST_APPLESS_MAIN(TestDubins)
#include "tst_dubins.moc"
