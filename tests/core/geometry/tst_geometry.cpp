#include "core/base/angles.h"
#include "core/base/random.h"
#include "core/geometry/geometry.h"
#include "tests/support/approx.h"

#include <algorithm>
#include <vector>

using namespace berg;

using Polygon = std::vector<Point>;

namespace {

const Polygon kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const Polygon kU{{0, 0}, {6, 0}, {6, 5}, {4, 5}, {4, 2}, {2, 2}, {2, 5}, {0, 5}};

Polygon reversed(Polygon polygon)
{
    std::reverse(polygon.begin(), polygon.end());
    return polygon;
}

Polygon movedBy(Polygon polygon, const Point& offset_m)
{
    for (Point& p : polygon)
        p += offset_m;
    return polygon;
}

/**
 * Winding number of the polygon around a point by summing angles, an independent test of inside.
 */
int windingNumber(const Polygon& polygon, const Point& p)
{
    double sum_rad = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point a = polygon[i] - p;
        const Point b = polygon[(i + 1) % polygon.size()] - p;
        sum_rad += std::atan2(cross(a, b), a.dot(b));
    }
    return static_cast<int>(std::lround(sum_rad / (2 * kPi)));
}

/** Corners at random distances round a centre: simple, rarely convex. */
Polygon star(Random& random, int corners)
{
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle_rad = 2 * kPi * i / corners;
        const double r_m = random.uniform(500, 3000);
        polygon.push_back(Point(r_m * std::cos(angle_rad), r_m * std::sin(angle_rad)));
    }
    return polygon;
}

} // namespace

class TestGeometry : public QObject
{
    Q_OBJECT

private slots:
    void crossIsPositiveToTheLeft()
    {
        QCOMPARE(cross({1, 0}, {0, 1}), 1.0);
        QCOMPARE(cross({0, 1}, {1, 0}), -1.0);
        QCOMPARE(cross({2, 3}, {4, 6}), 0.0);
        QCOMPARE(cross({2, 3}, {-5, 7}), 29.0); // 2 x 7 + 3 x 5
    }

    void insideByHand_data()
    {
        QTest::addColumn<Polygon>("polygon");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<bool>("inside");
        QTest::newRow("square, middle") << kSquare << 2.0 << 2.0 << true;
        QTest::newRow("square, left of") << kSquare << -0.1 << 2.0 << false;
        QTest::newRow("square, right of") << kSquare << 4.1 << 2.0 << false;
        QTest::newRow("square, above") << kSquare << 2.0 << 4.1 << false;
        QTest::newRow("square, below") << kSquare << 2.0 << -0.1 << false;
        QTest::newRow("U, left arm") << kU << 1.0 << 4.0 << true;
        QTest::newRow("U, right arm") << kU << 5.0 << 4.0 << true;
        QTest::newRow("U, foot") << kU << 3.0 << 1.0 << true;
        QTest::newRow("U, between the arms") << kU << 3.0 << 4.0 << false;
        // The ray from this point passes through a corner, which must count exactly once.
        QTest::newRow("U, level with a corner inside") << kU << 1.0 << 2.0 << true;
        QTest::newRow("U, level with a corner outside") << kU << -1.0 << 2.0 << false;
    }

    void insideByHand()
    {
        QFETCH(Polygon, polygon);
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(bool, inside);
        QCOMPARE(insidePolygon(polygon, Point(x, y)), inside);
        QCOMPARE(insidePolygon(reversed(polygon), Point(x, y)), inside);
        std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
        QCOMPARE(insidePolygon(polygon, Point(x, y)), inside);
    }

    void insideAgreesWithTheWindingNumber()
    {
        Random random(1);
        int inside = 0;
        for (int k = 0; k < 200; ++k) {
            const Polygon polygon = star(random, 3 + k % 12);
            for (int i = 0; i < 50; ++i) {
                const Point p(random.uniform(-3000, 3000), random.uniform(-3000, 3000));
                const bool expected = windingNumber(polygon, p) != 0;
                QCOMPARE(insidePolygon(polygon, p), expected);
                QCOMPARE(insidePolygon(reversed(polygon), p), expected);
                inside += expected ? 1 : 0;
            }
        }
        QVERIFY(inside > 1000 && inside < 9000); // both answers occur
    }

    void simplePolygons_data()
    {
        QTest::addColumn<Polygon>("polygon");
        QTest::addColumn<bool>("simple");
        QTest::newRow("nothing") << Polygon{} << false;
        QTest::newRow("two corners") << Polygon{{0, 0}, {1, 0}} << false;
        QTest::newRow("triangle") << Polygon{{0, 0}, {4, 0}, {1, 3}} << true;
        QTest::newRow("square") << kSquare << true;
        QTest::newRow("U") << kU << true;
        QTest::newRow("corner on a straight side")
            << Polygon{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}} << true;
        QTest::newRow("bow-tie") << Polygon{{0, 0}, {4, 4}, {4, 0}, {0, 4}} << false;
        QTest::newRow("flat triangle") << Polygon{{0, 0}, {2, 0}, {4, 0}} << false;
        QTest::newRow("three corners in one place") << Polygon{{1, 1}, {1, 1}, {1, 1}} << false;
        QTest::newRow("spike") << Polygon{{0, 0}, {4, 0}, {6, 0}, {4, 0}, {4, 4}} << false;
        QTest::newRow("same corner twice in a row")
            << Polygon{{0, 0}, {4, 0}, {4, 0}, {4, 4}, {0, 4}} << false;
        QTest::newRow("first corner repeated at the end")
            << Polygon{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}} << false;
        QTest::newRow("corner touches a far side")
            << Polygon{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}} << false;
        QTest::newRow("two squares joined at a corner")
            << Polygon{{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}} << false;
        QTest::newRow("sides lie on each other")
            << Polygon{{0, 0}, {6, 0}, {6, 2}, {4, 2}, {4, 0}, {2, 0}, {2, 2}, {0, 2}} << false;
        QTest::newRow("pentagram") << Polygon{{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}} << false;
    }

    void simplePolygons()
    {
        QFETCH(Polygon, polygon);
        QFETCH(bool, simple);
        // Neither the direction nor the first corner may matter.
        for (std::size_t turn = 0; turn < std::max<std::size_t>(1, polygon.size()); ++turn) {
            QCOMPARE(isSimplePolygon(polygon), simple);
            QCOMPARE(isSimplePolygon(reversed(polygon)), simple);
            if (!polygon.empty())
                std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
        }
    }

    /** A star is simple; exchanging two neighbouring corners makes two of its sides cross. */
    void starsAndCrossedStars()
    {
        Random random(2);
        for (int corners = 5; corners < 40; ++corners) {
            Polygon polygon = star(random, corners);
            QVERIFY(isSimplePolygon(polygon));
            for (Point& p : polygon)
                p = p.normalized() * 1000; // convex, so an exchange certainly crosses
            QVERIFY(isSimplePolygon(polygon));
            std::swap(polygon[1], polygon[2]);
            QVERIFY(!isSimplePolygon(polygon));
        }
    }

    void areaHasTheSignOfTheDirection()
    {
        QCOMPARE(signedArea(kSquare), 16.0);
        QCOMPARE(signedArea(reversed(kSquare)), -16.0);
        QCOMPARE(signedArea(kU), 24.0); // 6 x 5 less 2 x 3 between the arms
        QCOMPARE(signedArea(Polygon{{0, 0}, {4, 0}, {1, 3}}), 6.0);
        // Corners 1000 km away: 1e12 m^2 in the products leave 1e-4 m^2.
        COMPARE_NEAR(signedArea(movedBy(kU, {1e6, -1e6})), 24, 1e-3);
    }

    /** Regular n-gon: n/2 r^2 sin(2 pi/n). */
    void areaOfRegularPolygons()
    {
        for (int n = 3; n < 60; ++n) {
            Polygon polygon;
            for (int i = 0; i < n; ++i)
                polygon.push_back(1000 *
                                  Point(std::cos(2 * kPi * i / n), std::sin(2 * kPi * i / n)));
            COMPARE_NEAR(signedArea(polygon), n / 2.0 * 1e6 * std::sin(2 * kPi / n), 1e-6);
        }
    }

    void edgesThatMeetThePathAreNotClear_data()
    {
        QTest::addColumn<Polygon>("path");
        QTest::addColumn<Point>("next");
        QTest::addColumn<bool>("isClear");
        const Polygon hook{{0, 0}, {4, 0}, {4, 4}, {2, 4}};
        QTest::newRow("from a point") << Polygon{{1, 1}} << Point(2, 2) << true;
        QTest::newRow("nowhere") << Polygon{{1, 1}} << Point(1, 1) << false;
        QTest::newRow("on") << hook << Point(0, 4) << true;
        QTest::newRow("inside") << hook << Point(2, 1) << true;
        QTest::newRow("across the first edge") << hook << Point(2, -1) << false;
        QTest::newRow("onto the first edge") << hook << Point(2, 0) << false;
        QTest::newRow("onto the first corner") << hook << Point(0, 0) << false;
        QTest::newRow("straight on") << hook << Point(-1, 4) << true;
        QTest::newRow("back along the last edge") << hook << Point(3, 4) << false;
        QTest::newRow("beyond the corner before") << hook << Point(6, 4) << false;
    }

    void edgesThatMeetThePathAreNotClear()
    {
        QFETCH(Polygon, path);
        QFETCH(Point, next);
        QFETCH(bool, isClear);
        QCOMPARE(isClearEdge(path, next), isClear);
    }
};

QTEST_APPLESS_MAIN(TestGeometry)
#include "tst_geometry.moc"
