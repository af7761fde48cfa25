#include "core/base/random.h"
#include "core/geometry/covering_outline.h"
#include "core/geometry/outline.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace berg;

namespace {

constexpr std::size_t kLimit = 2000;

double areaOf(const std::vector<Point>& corners_m)
{
    return std::abs(signedArea(corners_m));
}

/** Returns the winding number of a closed line around a place; 0 means outside. */
int windingOf(const std::vector<Point>& ring_m, const Point& place_m)
{
    double turn_rad = 0;
    for (std::size_t i = 0; i < ring_m.size(); ++i) {
        const Point a = ring_m[i] - place_m;
        const Point b = ring_m[(i + 1) % ring_m.size()] - place_m;
        turn_rad += std::atan2(cross(a, b), a.dot(b));
    }
    return static_cast<int>(std::lround(turn_rad / (2 * std::acos(-1.0))));
}

} // namespace

/** Outlines that cover others never have a smaller area. */
class TestCoveringOutline : public QObject
{
    Q_OBJECT

private slots:
    void simpleOutlinesStay()
    {
        const std::vector<Point> bay{{0, 0}, {9, 0}, {9, 9}, {5, 2}, {0, 9}};
        const auto outline = coveringOutline(bay, kLimit).value();
        QVERIFY(outline.corners_m == bay && !outline.wasCrossing && !outline.wasThinned);
        std::vector<Point> turned(bay.rbegin(), bay.rend());
        turned.push_back(turned.front());
        QVERIFY(areaOf(coveringOutline(turned, kLimit)->corners_m) == areaOf(bay));
    }

    void lineThatEnclosesNothingHasNoOutline()
    {
        QVERIFY(!coveringOutline({}, kLimit));
        QVERIFY(!coveringOutline(std::vector<Point>{{0, 0}, {9, 9}, {0, 0}}, kLimit));
        QVERIFY(!coveringOutline(std::vector<Point>{{0, 0}, {0.1, 0}, {0, 0.1}}, kLimit));
    }

    /** The areas enclosed were computed by hand. */
    void crossingLinesAreRepaired_data()
    {
        QTest::addColumn<std::vector<Point>>("ring_m");
        QTest::addColumn<double>("area_m2");
        using Ring = std::vector<Point>;
        QTest::newRow("spike") << Ring{{0, 0},    {100, 0},   {100, 50}, {150, 50},
                                       {100, 50}, {100, 100}, {0, 100}}
                               << 10000.0;
        QTest::newRow("bow tie") << Ring{{0, 0}, {100, 100}, {100, 0}, {0, 100}} << 5000.0;
        QTest::newRow("touches a corner")
            << Ring{{0, 0}, {100, 0}, {100, 100}, {50, 0}, {0, 100}} << 10000.0 - 5000.0;
        QTest::newRow("loop across the edge") << Ring{{0, 0},   {100, 0},  {100, 40},  {110, 60},
                                                      {90, 60}, {100, 40}, {100, 100}, {0, 100}}
                                              << 10000.0 + 100.0;
        QTest::newRow("two squares that meet in a corner")
            << Ring{{0, 0}, {50, 0}, {50, 50}, {100, 50}, {100, 100}, {50, 100}, {50, 50}, {0, 50}}
            << 5000.0;
        QTest::newRow("pentagram")
            << Ring{{0, 100}, {59, -81}, {-95, 31}, {95, 31}, {-59, -81}} << 11225.0;
        QTest::newRow("run twice")
            << Ring{{0, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 0}, {100, 0}, {100, 100}, {0, 100}}
            << 10000.0;
    }
    void crossingLinesAreRepaired()
    {
        QFETCH(std::vector<Point>, ring_m);
        QFETCH(double, area_m2);
        for (int turn = 0; turn < 2; ++turn) {
            const auto outline = coveringOutline(ring_m, kLimit).value();
            QVERIFY(outline.wasCrossing && isSimplePolygon(outline.corners_m));
            QVERIFY2(areaOf(outline.corners_m) > area_m2 * 0.995 &&
                         areaOf(outline.corners_m) < area_m2 * 1.03,
                     qPrintable(QString::number(areaOf(outline.corners_m))));
            std::ranges::reverse(ring_m);
        }
    }

    /** Places with a non-zero winding number are inside; few random lines need their hull. */
    void randomLinesAreCovered()
    {
        Random random(49);
        int hulls = 0;
        constexpr int kCases = 400;
        for (int run = 0; run < kCases; ++run) {
            std::vector<Point> ring_m;
            const int corners = 4 + static_cast<int>(random.uniform() * 12);
            for (int i = 0; i < corners; ++i)
                ring_m.emplace_back(std::round(random.uniform() * 20) * 500,
                                    std::round(random.uniform() * 20) * 500);
            const auto outline = coveringOutline(ring_m, kLimit);
            if (!outline)
                continue;
            QVERIFY(isSimplePolygon(outline->corners_m));
            for (int i = 0; i < 200; ++i) {
                const Point place_m(random.uniform() * 10000, random.uniform() * 10000);
                if (distanceToEdges(ring_m, place_m) > 0.02 && windingOf(ring_m, place_m) != 0)
                    QVERIFY(insidePolygon(outline->corners_m, place_m));
            }
            const double hull_m2 = areaOf(convexHull(ring_m));
            QVERIFY(areaOf(outline->corners_m) <= hull_m2 * 1.001);
            hulls += areaOf(outline->corners_m) > hull_m2 * 0.9999 ? 1 : 0;
        }
        QVERIFY2(hulls < kCases / 10, qPrintable(QString::number(hulls)));
    }

    /** Lines without order are covered by their hull. */
    void tangledLinesGetTheirHull()
    {
        Random random(51);
        std::vector<Point> ring_m;
        for (int i = 0; i < 1000; ++i)
            ring_m.emplace_back(random.uniform() * 9000, random.uniform() * 9000);
        const auto outline = coveringOutline(ring_m, kLimit).value();
        QVERIFY(outline.wasCrossing && outline.corners_m == convexHull(ring_m));
    }

    /** A rough coast of many corners is covered completely and nearly keeps its area. */
    void manyCornersAreThinned()
    {
        Random random(50);
        for (const int corners : {2001, 3000, 20000}) {
            std::vector<Point> coast_m;
            for (int i = 0; i < corners; ++i) {
                const double bearing_rad = 2 * std::acos(-1.0) * i / corners;
                const double radius_m = 20000 * (1 + 0.02 * random.uniform());
                coast_m.emplace_back(radius_m * std::cos(bearing_rad),
                                     radius_m * std::sin(bearing_rad));
            }
            const auto outline = coveringOutline(coast_m, kLimit).value();
            QVERIFY(outline.wasThinned && outline.corners_m.size() <= kLimit);
            QVERIFY(isSimplePolygon(outline.corners_m));
            for (const Point& corner_m : coast_m)
                QVERIFY(insidePolygon(outline.corners_m, corner_m * (1 - 1e-9)));
            // The outermost tenth of the corners is 2 % farther out than the mean one.
            QVERIFY2(areaOf(outline.corners_m) < (corners > 10000 ? 1.04 : 1.02) * areaOf(coast_m),
                     qPrintable(QString::number(areaOf(outline.corners_m) / areaOf(coast_m))));
        }
    }

    void circleOfManyCornersIsThinned()
    {
        std::vector<Point> circle_m;
        for (int i = 0; i < 3000; ++i)
            circle_m.push_back(5000 * Point(std::cos(i * std::acos(-1.0) / 1500),
                                            std::sin(i * std::acos(-1.0) / 1500)));
        const auto outline = coveringOutline(circle_m, 100).value();
        QCOMPARE(outline.corners_m.size(), std::size_t{100});
        for (const Point& corner_m : circle_m)
            QVERIFY(insidePolygon(outline.corners_m, corner_m * (1 - 1e-9)));
        QVERIFY(areaOf(outline.corners_m) < 1.01 * areaOf(circle_m));
    }
};

QTEST_APPLESS_MAIN(TestCoveringOutline)
#include "tst_covering_outline.moc"
