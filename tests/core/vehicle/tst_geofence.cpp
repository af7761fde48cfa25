#include "core/base/angles.h"
#include "core/vehicle/geofence.h"

#include <QTest>

#include <cmath>

using namespace berg;

namespace {

/** Two arms of 3 km by 1 km that meet in the south-west; the corner that points inwards is
 * (1000, 1000). */
const std::vector<Point> kAngle_m{{0, 0},       {3000, 0},    {3000, 1000},
                                  {1000, 1000}, {1000, 3000}, {0, 3000}};

Geofence fenceIn(const Point& wind_mps)
{
    return {kAngle_m, Motion{.wind_mps = wind_mps}};
}

bool same(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double tolerance)
{
    return (a - b).cwiseAbs().maxCoeff() <= tolerance;
}

} // namespace

class TestGeofence : public QObject
{
    Q_OBJECT

private slots:
    void clearanceIsThatOfTheBetterCircle()
    {
        const Geofence fence = fenceIn(Point::Zero());
        // Along the southern edge, 100 m inside: only the circle to the left is inside.
        const DubinsState east{.position_m = {1500, 100}, .psi_rad = 0};
        const double radius_m = fence.radius_m();
        QVERIFY(std::abs(fence.turnClearance_m(east) - std::min(100.0, 900 - 2 * radius_m)) < 1e-9);
        // Flying straight at the edge, both circles extend outside.
        const DubinsState south{.position_m = {1500, 100}, .psi_rad = -kPi / 2};
        QVERIFY(std::abs(fence.turnClearance_m(south) - (100 - radius_m)) < 1e-9);
        QVERIFY(fence.contains({500, 2500}));
        QVERIFY(!fence.contains({2500, 2500}));
    }

    void placesAtTheFenceAreShutOff()
    {
        const Geofence fence = fenceIn(Point::Zero());
        QVERIFY(!fence.isShutOff({500, 500}));
        QVERIFY(!fence.isShutOff({1500, 100}));
        QVERIFY(fence.isShutOff({1500, 10}));
        QVERIFY(fence.isShutOff({1500, -10}));
        QVERIFY(fence.isShutOff({50, 50})); // in a corner
    }

    void directionOfTheCornersDoesNotMatter()
    {
        const Geofence one = fenceIn({3, 4});
        const Geofence other({kAngle_m.rbegin(), kAngle_m.rend()}, Motion{.wind_mps = {3, 4}});
        const std::vector<Point> places_m{{500, 2500}, {2500, 500}, {500, 500}};
        QVERIFY(same(one.distances_m(places_m), other.distances_m(places_m), 1e-9));
    }

    /** The whole guard relies on this: the UAV can stay on the circle over ground, in wind too. */
    void circleOverGroundIsKept_data()
    {
        QTest::addColumn<double>("wind_mps");
        QTest::newRow("calm") << 0.0;
        QTest::newRow("5 m/s") << 5.0;
        QTest::newRow("15 m/s") << 15.0;
        QTest::newRow("0.9 of the airspeed") << 19.8;
    }
    void circleOverGroundIsKept()
    {
        QFETCH(double, wind_mps);
        constexpr double kStep_s = 0.01;
        const Motion motion{.wind_mps = {wind_mps, 0}};
        const Geofence fence(kAngle_m, motion);
        for (const double side : {1.0, -1.0}) {
            DubinsState uav{.psi_rad = 1};
            const Point ahead =
                (motion.airspeed_mps * Point(std::cos(1), std::sin(1)) + motion.wind_mps)
                    .normalized();
            const Point centre_m = side * fence.radius_m() * Point(-ahead.y(), ahead.x());
            for (double t_s = 0; t_s < fence.circle_s(); t_s += kStep_s) {
                const double u_radps = fence.circlingRate_radps(uav, side);
                QVERIFY(std::abs(u_radps) < motion.limit_radps);
                uav = berg::step(uav, motion.airspeed_mps, u_radps, kStep_s, motion.wind_mps);
                // Steps of 10 ms leave the circle by centimetres a turn.
                QVERIFY(std::abs((uav.position_m - centre_m).norm() - fence.radius_m()) < 1);
            }
            QVERIFY(uav.position_m.norm() < 5); // one round takes the computed time
        }
    }

    void pathsLeadRoundTheCorner()
    {
        const Geofence fence = fenceIn(Point::Zero());
        QVERIFY(fence.cornersBetween({500, 500}, {2500, 500}).empty());
        const std::vector<Point> corners_m = fence.cornersBetween({2500, 500}, {500, 2500});
        QCOMPARE(corners_m.size(), std::size_t{1});
        const Point off_m = corners_m.front() - Point(1000, 1000);
        // The corner is passed on the inward bisector, a radius away.
        QVERIFY(std::abs(off_m.norm() - fence.radius_m()) < 1e-9);
        QVERIFY(std::abs(off_m.x() - off_m.y()) < 1e-9 && off_m.x() < 0);
    }

    void distancesAreThoseOfThePaths()
    {
        const Geofence fence = fenceIn(Point::Zero());
        const std::vector<Point> places_m{{2500, 500}, {500, 2500}, {500, 500}};
        const Point corner_m = fence.cornersBetween(places_m[0], places_m[1]).at(0);
        const double round_m = (places_m[0] - corner_m).norm() + (corner_m - places_m[1]).norm();
        Eigen::MatrixXd expected_m(3, 3);
        expected_m << 0, round_m, 2000, round_m, 0, 2000, 2000, 2000, 0;
        QVERIFY(same(fence.distances_m(places_m), expected_m, 1e-6));
    }

    void windMakesOneDirectionLonger()
    {
        const std::vector<Point> places_m{{2500, 500}, {500, 2500}};
        const Eigen::MatrixXd there_m = fenceIn({-8, 8}).distances_m(places_m);
        QVERIFY(there_m(0, 1) < there_m(1, 0));
        QVERIFY(there_m(0, 1) < fenceIn(Point::Zero()).distances_m(places_m)(0, 1));
    }

    /** Between the corners of a comb the path passes all teeth. */
    void pathsMayHaveManyCorners()
    {
        const std::vector<Point> comb_m{{0, 0},      {5000, 0},   {5000, 2000}, {3500, 2000},
                                        {3500, 600}, {3300, 600}, {3300, 2000}, {1700, 2000},
                                        {1700, 600}, {1500, 600}, {1500, 2000}, {0, 2000}};
        const Geofence fence(comb_m, {});
        const Point from_m(200, 1800);
        const Point to_m(4800, 1800);
        const std::vector<Point> corners_m = fence.cornersBetween(from_m, to_m);
        QVERIFY(corners_m.size() >= 2);
        Point last_m = from_m;
        double length_m = 0;
        for (const Point& corner_m : corners_m) {
            QVERIFY(fence.contains(corner_m));
            length_m += (corner_m - last_m).norm();
            last_m = corner_m;
        }
        length_m += (to_m - last_m).norm();
        QVERIFY(std::abs(fence.distances_m(std::vector<Point>{from_m, to_m})(0, 1) - length_m) <
                1e-6);
    }

    void homeIsReachedRoundTheCornerInThePredictedTime()
    {
        const Geofence fence = fenceIn({-4, 3});
        const DubinsState start{.position_m = {2500, 500}, .psi_rad = 0};
        const MovingPlace home{.place_m = {500, 2500}};
        const std::optional<Path> path = fence.pathTo(start, home, 0.1);
        QVERIFY(path);
        QVERIFY((path->end.position_m - home.place_m).norm() < 1);
        QVERIFY(path->time_s <= fence.longestPath_s(start, home.place_m, 0.1));
        const double air_m =
            fence.distances_m(std::vector<Point>{start.position_m, home.place_m})(0, 1);
        QVERIFY(path->time_s > air_m / 22);
    }

    /** The hole is 200 m by 1000 m, between the places west and east of it. */
    void holesAreKeptOutOfAndFlownRound()
    {
        const std::vector<Point> wall_m{{0, -500}, {200, -500}, {200, 500}, {0, 500}};
        const Geofence fence({}, {}, {wall_m});
        QVERIFY(fence.hasHoles() && !fenceIn(Point::Zero()).hasHoles());
        QVERIFY(fence.contains({-9e5, 0}) && !fence.contains({100, 0}));
        QCOMPARE(fence.clearance_m({-300, 0}), 300.0);
        QCOMPARE(fence.clearance_m({-300, 0}, {300, 0}), 0.0);
        const double radius_m = fence.radius_m();
        // Flying straight at the wall both circles are beside it; along it, one of them.
        const DubinsState east{.position_m = {-radius_m / 2, 0}, .psi_rad = 0};
        QVERIFY(std::abs(fence.turnClearance_m(east) + radius_m / 2) < 1e-9);
        const DubinsState north{.position_m = {-10, 0}, .psi_rad = kPi / 2};
        QVERIFY(std::abs(fence.turnClearance_m(north) - 10) < 1e-9);
        const std::vector<Point> corners_m = fence.cornersBetween({-800, 200}, {1000, 200});
        QCOMPARE(corners_m.size(), std::size_t{2});
        for (const Point& corner_m : corners_m)
            QVERIFY(corner_m.y() > 500);
        QVERIFY(fence.cornersBetween({-800, 800}, {1000, 800}).empty());
    }

    /** Any hole inside the circle blocks it, however small. */
    void smallHolesBlockTheCircle()
    {
        const Point at_m(0, 100);
        const std::vector<Point> mast_m{at_m, at_m + Point(1, 0), at_m + Point(0, 1)};
        const Geofence fence({}, {}, {mast_m, {{0, -100}, {1, -100}, {0, -101}}});
        QVERIFY(fence.turnClearance_m({}) < 0);
    }

    /**
     * Two squares overlap across the edge of the polygon: only corners that a UAV can pass are
     * used.
     */
    void holesMayOverlap()
    {
        const auto square_m = [](const Point& low_m) {
            return std::vector<Point>{low_m, low_m + Point(1000, 0), low_m + Point(1000, 1000),
                                      low_m + Point(0, 1000)};
        };
        const std::vector<Point> outer_m{{0, 0}, {6000, 0}, {6000, 3000}, {0, 3000}};
        const Geofence fence(outer_m, {}, {square_m({2000, -300}), square_m({2500, 400})});
        const std::vector<Point> corners_m = fence.cornersBetween({500, 500}, {5500, 300});
        QVERIFY(corners_m.size() >= 2);
        for (const Point& corner_m : corners_m)
            QVERIFY(fence.contains(corner_m));
        QVERIFY(!fence.contains({2700, 500}) && !fence.contains({2100, -100}));
        QVERIFY(fence.distances_m(std::vector<Point>{{500, 500}, {5500, 300}})(0, 1) > 5300);
    }

    void placesInAHoleAreViewedFromBeside()
    {
        const std::vector<Point> wall_m{{0, -500}, {200, -500}, {200, 500}, {0, 500}};
        const Geofence fence({}, {}, {wall_m});
        QCOMPARE(fence.beside_m({-50, 3}), Point(-50, 3));
        const Point beside_m = fence.beside_m({60, 3});
        QVERIFY(fence.contains(beside_m));
        QVERIFY((beside_m - Point(-5, 3)).norm() < 1e-9);
        QVERIFY(!fence.isOutOfReach({60, 3}, 150));
        QVERIFY(fence.isOutOfReach({60, 3}, 100));
        QVERIFY(!fence.isOutOfReach({-60, 3}, 1));
        const std::vector<Point> places_m{{-1000, 3}, {60, 3}};
        QVERIFY(std::abs(fence.distances_m(places_m)(0, 1) - 995) < 1e-6);
    }

    void anotherWindKeepsThePolygons()
    {
        const std::vector<Point> hole_m{{200, 200}, {400, 200}, {400, 300}};
        const Motion calm{};
        const Motion windy{.wind_mps = {3, 4}};
        const std::vector<Point> places_m{{500, 2500}, {2500, 500}, {100, 100}, {500, 500}};
        for (const bool isBounded : {true, false}) {
            const std::vector<Point> outer_m = isBounded ? kAngle_m : std::vector<Point>();
            const Geofence turned = Geofence(outer_m, calm, {hole_m}).inWind(windy.wind_mps);
            const Geofence made(outer_m, windy, {hole_m});
            QCOMPARE(turned.radius_m(), made.radius_m());
            QVERIFY(same(turned.distances_m(places_m), made.distances_m(places_m), 0));
        }
    }

    void countOfCornersIsLimited()
    {
        QVERIFY_THROWS_EXCEPTION(std::logic_error, Geofence({{0, 0}, {1, 0}}, {}));
        QVERIFY_THROWS_EXCEPTION(std::logic_error, Geofence({}, {}));
        std::vector<Point> many_m;
        for (std::size_t i = 0; i <= kMostFenceCorners; ++i) {
            const double angle_rad = 2 * kPi * static_cast<double>(i) / (kMostFenceCorners + 1);
            many_m.emplace_back(5000 * std::cos(angle_rad), 5000 * std::sin(angle_rad));
        }
        QVERIFY_THROWS_EXCEPTION(std::logic_error, Geofence(many_m, {}));
        many_m.pop_back();
        QVERIFY(Geofence(many_m, {}).contains({0, 0}));
    }
};

QTEST_APPLESS_MAIN(TestGeofence)
#include "tst_geofence.moc"
