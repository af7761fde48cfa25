#include "core/base/angles.h"
#include "core/base/outline.h"

#include <QTest>

#include <cmath>

using namespace berg;

namespace {

/** To the polygon, 0 inside. */
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

    /** A bay that closes when it is grown: round the hull. */
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
        QVERIFY(!polygonsMeet(square, beside)); // the boxes alone meet
    }
};

QTEST_APPLESS_MAIN(TestOutline)
#include "tst_outline.moc"
