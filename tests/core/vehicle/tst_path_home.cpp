#include "core/base/angles.h"
#include "core/base/random.h"
#include "core/vehicle/path_home.h"

#include <QTest>

#include <cmath>

using namespace berg;

namespace {

constexpr double kStep_s = 0.1;

Motion inWind(double wind_mps, double towards_rad)
{
    return {.wind_mps = wind_mps * Point(std::cos(towards_rad), std::sin(towards_rad))};
}

/** Flies the command of each interval until the place is passed; at most ten hours. */
double flown_s(DubinsState uav, MovingPlace place, const Motion& motion, double command_s)
{
    const auto held = std::llround(command_s / kStep_s);
    double u_radps = 0;
    for (int step = 1; step < 360'000; ++step) {
        if ((step - 1) % held == 0)
            if (const std::optional<Path> path = pathTo(uav, place, motion, command_s))
                u_radps = turnRateOf(*path, motion, command_s);
        // Computes in the frame of the place.
        const Point from_m = uav.position_m - place.place_m;
        uav = berg::step(uav, motion.airspeed_mps, u_radps, kStep_s, motion.wind_mps);
        place.place_m += place.drift_mps * kStep_s;
        if (distanceToSegment(from_m, uav.position_m - place.place_m, Point::Zero()) <=
            kLandingRadius_m)
            return step * kStep_s;
    }
    return 1e9;
}

/** Returns a random state up to `farthest_m` from the origin, with any heading. */
DubinsState anywhere(Random& random, double farthest_m)
{
    const double away_m = random.uniform(0, farthest_m);
    const double bearing_rad = random.uniform(-kPi, kPi);
    return {.position_m = away_m * Point(std::cos(bearing_rad), std::sin(bearing_rad)),
            .psi_rad = random.uniform(-kPi, kPi)};
}

} // namespace

/** Endurance and return rely on this: no flight home takes longer than predicted. */
class TestPathHome : public QObject
{
    Q_OBJECT

private slots:
    void flightsTakeNoLongerThanPredicted_data()
    {
        QTest::addColumn<double>("farthest_m");
        QTest::addColumn<double>("wind_mps");
        QTest::addColumn<double>("command_s");
        QTest::newRow("far, calm") << 5000.0 << 0.0 << 0.1;
        QTest::newRow("far, up to 0.7 U") << 5000.0 << 15.4 << 0.1;
        QTest::newRow("near, calm") << 400.0 << 0.0 << 0.1;
        QTest::newRow("near, up to 0.7 U") << 400.0 << 15.4 << 0.1;
        QTest::newRow("far, slow autopilot") << 5000.0 << 15.4 << 1.0;
    }
    void flightsTakeNoLongerThanPredicted()
    {
        QFETCH(double, farthest_m);
        QFETCH(double, wind_mps);
        QFETCH(double, command_s);
        Random random(11);
        for (int i = 0; i < 300; ++i) {
            const Motion motion = inWind(random.uniform(0, wind_mps), random.uniform(-kPi, kPi));
            const DubinsState start = anywhere(random, farthest_m);
            const std::optional<Path> path = pathTo(start, {}, motion, command_s);
            QVERIFY(path);
            QVERIFY(path->time_s <= longestPath_s(start, Point::Zero(), motion, command_s));
            // The last step ends up to one step late; much more than a circle is never flown.
            QVERIFY(flown_s(start, {}, motion, command_s) <= path->time_s + kStep_s);
        }
    }

    void pathsAreReachedWithinTheirTime()
    {
        Random random(12);
        for (int i = 0; i < 20000; ++i) {
            const Motion motion = inWind(random.uniform(0, 21), random.uniform(-kPi, kPi));
            const double command_s = random.uniform(0.1, 2);
            const DubinsState start = anywhere(random, 4000);
            const std::optional<Path> path = pathTo(start, {}, motion, command_s);
            QVERIFY(path);
            const Point home_m = Point::Zero();
            QVERIFY(path->time_s <= longestPath_s(start, home_m, motion, command_s));
            QVERIFY(reachesWithin(path->time_s + 1e-9, start, home_m, motion, command_s));
            QVERIFY(!reachesWithin(path->time_s - 1e-6, start, home_m, motion, command_s));
        }
    }

    void aheadIsFlownStraight()
    {
        const DubinsState start{.position_m = {-2200, 0}, .psi_rad = 0};
        const std::optional<Path> path = pathTo(start, {}, {}, kStep_s);
        QVERIFY(path);
        QCOMPARE(path->turn_rad, 0.0);
        QCOMPARE(path->time_s, 100.0);
        QVERIFY(path->end.position_m.norm() < 1e-9);
    }

    void turnsToTheQuickerSide()
    {
        const DubinsState start{.position_m = {-2200, 0}, .psi_rad = kPi / 2};
        const std::optional<Path> path = pathTo(start, {}, {}, kStep_s);
        QVERIFY(path);
        // The turn is to the right by about a quarter, less the sideways shift of the turn itself.
        QVERIFY(path->turn_rad < -kPi / 2);
        QVERIFY(path->turn_rad > -kPi / 2 - 0.1);
    }

    /** A place inside one turning circle has no path with a turn to that side. */
    void leavesTheCircleItIsIn()
    {
        const Motion calm;
        const double radius_m = calm.airspeed_mps / calm.limit_radps;
        // A left turn circles round home.
        const DubinsState start{.position_m = {0, -radius_m}, .psi_rad = 0};
        const std::optional<Path> path = pathTo(start, {}, calm, kStep_s);
        QVERIFY(path);
        QVERIFY(path->turn_rad < 0);
        QVERIFY(flown_s(start, {}, calm, kStep_s) <= path->time_s + kStep_s);
    }

    void reachesADriftingPlace()
    {
        Random random(5);
        for (int i = 0; i < 100; ++i) {
            const Motion motion = inWind(random.uniform(0, 12), random.uniform(-kPi, kPi));
            const DubinsState start = anywhere(random, 4000);
            const MovingPlace iceberg{.drift_mps = {random.uniform(-2, 2), random.uniform(-2, 2)}};
            const std::optional<Path> path = pathTo(start, iceberg, motion, kStep_s);
            QVERIFY(path);
            const Point met_m = iceberg.drift_mps * path->time_s;
            QVERIFY((path->end.position_m - met_m).norm() < 0.02 * path->time_s);
            QVERIFY(flown_s(start, iceberg, motion, kStep_s) <= path->time_s + kStep_s);
        }
    }

    void placesThatOutrunTheUavAreOutOfReach()
    {
        const MovingPlace away{.place_m = {1000, 0}, .drift_mps = {5, 0}};
        QVERIFY(!pathTo({}, away, inWind(17.1, kPi), kStep_s));
        QVERIFY(pathTo({}, away, inWind(16.9, kPi), kStep_s));
    }
};

QTEST_APPLESS_MAIN(TestPathHome)
#include "tst_path_home.moc"
