#include "core/base/angles.h"
#include "core/vehicle/return_path.h"
#include "core/vehicle/uav_spec.h"

#include <QTest>

using namespace berg;

namespace {

/** Two arms of 3 km by 1 km that meet in the south-west. */
const std::vector<Point> kAngle_m{{0, 0},       {3000, 0},    {3000, 1000},
                                  {1000, 1000}, {1000, 3000}, {0, 3000}};
constexpr CommandClock kClock{.dt_s = 0.1};

/**
 * Flies the path command by command, and records how near it comes to `home_m` and whether it stays
 * inside.
 */
struct Flown
{
    double nearest_m = 1e9;
    bool isInside = true;
};

Flown fly(const Geofence& fence, const CommandClock& clock, DubinsState at, ReturnPath path,
          const Point& home_m)
{
    Flown flown;
    const Motion& motion = fence.motion();
    const std::int64_t commands = path.commands();
    for (std::int64_t i = 0; i < commands; ++i) {
        const double rate_radps = path.takeNext_radps();
        for (std::int64_t k = 0; k < clock.steps && flown.nearest_m > 25; ++k) {
            const Point from_m = at.position_m;
            at = step(at, motion.airspeed_mps, rate_radps, clock.dt_s, motion.wind_mps);
            flown.isInside = flown.isInside && fence.contains(at.position_m);
            flown.nearest_m =
                std::min(flown.nearest_m, distanceToSegment(from_m, at.position_m, home_m));
        }
    }
    return flown;
}

} // namespace

class TestReturnPath : public QObject
{
    Q_OBJECT

private slots:
    void leadsHomeInsideAsFlown_data()
    {
        QTest::addColumn<double>("wind_mps");
        QTest::addColumn<int>("steps");
        QTest::newRow("calm") << 0.0 << 1;
        QTest::newRow("wind") << 9.0 << 1;
        QTest::newRow("slow autopilot") << 0.0 << 20;
        QTest::newRow("slow autopilot in wind") << 9.0 << 20;
    }
    void leadsHomeInsideAsFlown()
    {
        QFETCH(double, wind_mps);
        QFETCH(int, steps);
        const Geofence fence(kAngle_m, {.wind_mps = {0.8 * wind_mps, -0.6 * wind_mps}});
        const CommandClock clock{.dt_s = 0.1, .steps = steps};
        const Point home_m(500, 2500);
        const ReturnSearch search(fence, clock, home_m);
        int found = 0;
        for (int heading = 0; heading < 12; ++heading)
            for (const double x_m : {400.0, 1200.0, 2500.0}) {
                const DubinsState from{.position_m = {x_m, 500},
                                       .psi_rad = wrapPi(heading * kPi / 6)};
                const std::optional<ReturnPath> path = search.anyPath(from);
                if (!path)
                    continue;
                ++found;
                const Flown flown = fly(fence, clock, from, *path, home_m);
                QVERIFY(flown.isInside);
                QVERIFY(flown.nearest_m <= 25);
            }
        QVERIFY2(found >= 30, qPrintable(QString::number(found)));
    }

    /** A turn is checked wherever it comes near the fence, not at fixed angles. */
    void turnsThatTouchASpikeAreRejected()
    {
        const double radius_m = turnRadius_m({});
        // On the circle to the left, 100 degrees round it, a spike 2 m wide points inwards.
        const double at_rad = -kPi / 2 + radFromDeg(100);
        const Point centre_m(0, radius_m);
        const auto off_m = [&](double away_m, double turn_rad) {
            return Point(centre_m +
                         away_m * Point(std::cos(at_rad + turn_rad), std::sin(at_rad + turn_rad)));
        };
        const std::vector<Point> spiked_m{
            {-900, -900},      {900, -900}, off_m(920, -0.001), off_m(radius_m - 5, 0),
            off_m(920, 0.001), {900, 900},  {-900, 900}};
        const Motion motion{.limit_radps = maxTurnRate_radps({})};
        const Geofence fence(spiked_m, motion);
        const ReturnSearch search(fence, kClock, {-500, 0});
        const auto commands = static_cast<std::int64_t>(kPi / motion.limit_radps / 0.1);
        QVERIFY(!search.isInside({}, motion.limit_radps, commands));
        QVERIFY(search.isInside({}, -motion.limit_radps, commands));
    }

    void noPathIsKnownWhereNoTurnFits()
    {
        const std::vector<Point> corridor_m{{0, 0}, {3000, 0}, {3000, 150}, {0, 150}};
        const Geofence fence(corridor_m, {});
        const ReturnSearch search(fence, kClock, {500, 75});
        QVERIFY(!search.anyPath({.position_m = {1500, 75}, .psi_rad = 0}));
        QVERIFY(search.anyPath({.position_m = {1500, 75}, .psi_rad = kPi}));
    }

    void commandsComeOneByOne()
    {
        ReturnPath path{.parts = {{.rate_radps = 0.2, .commands = 2}, {.commands = 1}}};
        QCOMPARE(path.commands(), std::int64_t{3});
        QCOMPARE(path.takeNext_radps(), 0.2);
        QCOMPARE(path.takeNext_radps(), 0.2);
        QCOMPARE(path.takeNext_radps(), 0.0);
        QVERIFY(path.parts.empty());
        QCOMPARE(path.takeNext_radps(), 0.0);
    }
};

QTEST_APPLESS_MAIN(TestReturnPath)
#include "tst_return_path.moc"
