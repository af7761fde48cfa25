#include "core/base/angles.h"
#include "core/base/random.h"
#include "core/geometry/outline.h"

#include <QTest>

#include <cmath>

using namespace berg;

namespace {

/** Distance to the polygon, 0 inside. */
double distanceTo(const std::vector<Point>& polygon, const Point& p)
{
    if (polygon.size() == 1)
        return (p - polygon.front()).norm();
    if (polygon.size() > 2 && insidePolygon(polygon, p))
        return 0;
    return distanceToEdges(polygon, p);
}

} // namespace

class TestOutline : public QObject
{
    Q_OBJECT

private slots:
    void hullHoldsAllPoints()
    {
        const std::vector<Point> hull =
            convexHull({{0, 0}, {10, 0}, {5, 0}, {10, 10}, {0, 10}, {5, 5}, {0, 0}});
        QVERIFY(hull == (std::vector<Point>{{0, 0}, {10, 0}, {10, 10}, {0, 10}}));
        QVERIFY(convexHull({{3, 4}, {3, 4}}) == (std::vector<Point>{{3, 4}}));
        QCOMPARE(convexHull({{0, 0}, {1, 1}, {2, 2}}).size(), std::size_t{2});
        QVERIFY(convexHull({}).empty());
    }

    void growsByNoLessAndHardlyMore_data()
    {
        QTest::addColumn<std::vector<Point>>("polygon");
        QTest::addColumn<double>("by");
        const auto row = [](const char* name, const std::vector<Point>& polygon, double by) {
            QTest::newRow(name) << polygon << by;
        };
        row("point", {{5, -7}}, 100);
        row("line", {{0, 0}, {3000, 4000}}, 100);
        row("square", {{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}}, 100);
        row("clockwise", {{0, 1000}, {1000, 1000}, {1000, 0}, {0, 0}}, 250);
        row("sharp", {{0, 0}, {5000, 0}, {0, 50}}, 120);
        row("corner that points inwards", {{0, 0}, {4000, 0}, {4000, 3000}, {2000, 900}, {0, 3000}},
            300);
        row("grown beyond its notch", {{0, 0}, {4000, 0}, {4000, 3000}, {2000, 900}, {0, 3000}},
            5000);
    }
    void growsByNoLessAndHardlyMore()
    {
        QFETCH(std::vector<Point>, polygon);
        QFETCH(double, by);
        const std::vector<Point> outline = grownOutline(polygon, by);
        QVERIFY(outline.size() >= 3);
        QVERIFY(isSimplePolygon(outline));
        QVERIFY(signedArea(outline) > 0);
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Point& corner = outline[i];
            const Point middle = (corner + outline[(i + 1) % outline.size()]) / 2;
            QVERIFY(distanceTo(polygon, corner) <= 1.01 * by);
            QVERIFY(distanceTo(polygon, corner) >= (1 - 1e-6) * by);
            QVERIFY(distanceTo(polygon, middle) >= (1 - 1e-6) * by);
        }
        for (const Point& corner : polygon)
            QVERIFY(insidePolygon(outline, corner));
    }

    /** A bay that closes when grown gets the outline of the hull. */
    void partsThatGrowTogetherAreOne()
    {
        const std::vector<Point> bay{{0, 0},       {4000, 0},    {4000, 4000}, {2100, 4000},
                                     {2100, 3900}, {3900, 3900}, {3900, 100},  {100, 100},
                                     {100, 3900},  {1900, 3900}, {1900, 4000}, {0, 4000}};
        QVERIFY(isSimplePolygon(bay));
        const std::vector<Point> outline = grownOutline(bay, 300);
        QVERIFY(isSimplePolygon(outline));
        QVERIFY(insidePolygon(outline, {2000, 2000}));
        for (const Point& corner : bay)
            QVERIFY(insidePolygon(outline, corner) && distanceToEdges(outline, corner) > 299.9);
    }

    /**
     * Compares with every pair of edges for rough outlines that are apart, touch, cross or contain
     * each other.
     */
    void sweepFindsWhatAllPairsTell()
    {
        Random random(11);
        const auto rough = [&random](const Point& centre, std::size_t corners) {
            std::vector<Point> polygon;
            for (std::size_t i = 0; i < corners; ++i) {
                const double at_rad =
                    2 * kPi * (double(i) + 1.4 * random.uniform(0, 1)) / double(corners);
                // Corners on a grid make many outlines only touch.
                const Point place =
                    centre + random.uniform(4, 12) * Point(std::cos(at_rad), std::sin(at_rad));
                polygon.emplace_back(place.array().round());
            }
            return polygon;
        };
        const auto edgesMeet = [](const auto& a, std::size_t i, const auto& b, std::size_t k) {
            return segmentsMeet(a[i], a[(i + 1) % a.size()], b[k], b[(k + 1) % b.size()]);
        };
        std::array<int, 4> counts{};
        for (int trial = 0; trial < 3000; ++trial) {
            const std::vector<Point> a = rough({0, 0}, 3 + random.below(20));
            const std::vector<Point> b =
                rough({random.uniform(-25, 25), random.uniform(-25, 25)}, 3 + random.below(20));
            bool meet = insidePolygon(a, b[0]) || insidePolygon(b, a[0]);
            for (std::size_t i = 0; i < a.size(); ++i)
                for (std::size_t k = 0; k < b.size(); ++k)
                    meet = meet || edgesMeet(a, i, b, k);
            QCOMPARE(polygonsMeet(a, b), meet);
            bool crosses = false;
            const std::size_t n = a.size();
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t k = i + 2; k < n; ++k)
                    crosses = crosses || (k + 1 - i != n && edgesMeet(a, i, a, k));
            if (crosses)
                QVERIFY(!isSimplePolygon(a));
            else if (isSimplePolygon(a))
                ++counts[2];
            counts[3] += crosses ? 1 : 0;
            ++counts[meet ? 1 : 0];
        }
        QVERIFY2(std::ranges::min(counts) > 200, "each case often");
    }

    void polygonsMeetWhereverTheyTouch()
    {
        const std::vector<Point> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
        const auto moved = [&](double east, double north, double scale) {
            std::vector<Point> other;
            for (const Point& corner : square)
                other.emplace_back(corner * scale + Point(east, north));
            return other;
        };
        QVERIFY(polygonsMeet(square, moved(5, 5, 1)));
        QVERIFY(polygonsMeet(square, moved(2, 2, 0.1)));
        QVERIFY(polygonsMeet(moved(2, 2, 0.1), square));
        const std::vector<Point> across{{-5, 4}, {15, 4}, {15, 6}, {-5, 6}};
        QVERIFY(polygonsMeet(square, across)); // no corner inside
        QVERIFY(!polygonsMeet(square, moved(11, 0, 1)));
        const std::vector<Point> beside{{9, 20}, {20, 9}, {20, 20}};
        QVERIFY(!polygonsMeet(square, beside)); // only the boxes meet
    }
};

QTEST_APPLESS_MAIN(TestOutline)
#include "tst_outline.moc"
