#include "core/base/random.h"
#include "core/geometry/enclosing_circle.h"
#include "tests/support/approx.h"

#include <QTest>

#include <Eigen/LU>

#include <algorithm>
#include <vector>

using namespace berg;

namespace {

bool holds(const Circle& circle, const std::vector<Point>& points)
{
    return std::ranges::all_of(points, [&](const Point& p) {
        return (p - circle.centre_m).norm() <= circle.radius_m * (1 + 1e-9) + 1e-9;
    });
}

/** Circle through three points by the perpendicular bisectors, as a linear system. */
Circle roundTriangle(const Point& a, const Point& b, const Point& c)
{
    Eigen::Matrix2d sides;
    sides << (b - a).transpose(), (c - a).transpose();
    const Point right = Point((b - a).squaredNorm(), (c - a).squaredNorm()) / 2;
    const Point toCentre = sides.inverse() * right;
    return {.centre_m = a + toCentre, .radius_m = toCentre.norm()};
}

/** Smallest of all circles over two or through three of the points that contain all of them. */
double triedAll(const std::vector<Point>& points)
{
    double best_m = points.size() == 1 ? 0 : 1e300;
    const auto offer = [&](const Circle& circle) {
        if (circle.radius_m < best_m && holds(circle, points))
            best_m = circle.radius_m;
    };
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            offer({.centre_m = (points[i] + points[j]) / 2,
                   .radius_m = (points[i] - points[j]).norm() / 2});
            for (std::size_t k = 0; k < j; ++k)
                offer(roundTriangle(points[i], points[j], points[k]));
        }
    return best_m;
}

} // namespace

class TestEnclosingCircle : public QObject
{
    Q_OBJECT

private slots:
    void ofOneIsThatPoint()
    {
        const Circle circle = enclosingCircle(std::vector{Point(3.7, -1.1)});
        QCOMPARE(circle.centre_m, Point(3.7, -1.1));
        QCOMPARE(circle.radius_m, 0.0);
        QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)enclosingCircle({}));
    }

    void isTheSmallest_data()
    {
        QTest::addColumn<double>("grid_m"); // 0 means no grid
        QTest::newRow("anywhere") << 0.0;
        QTest::newRow("many on one circle or in line") << 1.0;
        QTest::newRow("many at one place") << 5.0;
    }

    void isTheSmallest()
    {
        QFETCH(double, grid_m);
        Random random(11, static_cast<std::uint64_t>(grid_m));
        for (int round = 0; round < 300; ++round) {
            std::vector<Point> points;
            const auto count = 1 + random.below(9);
            for (std::uint64_t i = 0; i < count; ++i) {
                Point p(random.uniform(-10, 10), random.uniform(-10, 10));
                if (grid_m > 0)
                    p = (p / grid_m).array().round().matrix() * grid_m;
                points.push_back(p);
            }
            const Circle circle = enclosingCircle(points);
            QVERIFY(holds(circle, points));
            COMPARE_NEAR(circle.radius_m, triedAll(points), 1e-9);
        }
    }

    void theOrderOfThePointsDoesNotMatter()
    {
        Random random(12);
        std::vector<Point> points;
        for (int i = 0; i < 8; ++i)
            points.emplace_back(random.uniform(0, 1000), random.uniform(0, 1000));
        const Circle first = enclosingCircle(points);
        for (int turn = 0; turn < 8; ++turn) {
            std::rotate(points.begin(), points.begin() + 3, points.end());
            std::swap(points[1], points[5]);
            const Circle again = enclosingCircle(points);
            COMPARE_NEAR((again.centre_m - first.centre_m).norm(), 0, 1e-9);
            COMPARE_NEAR(again.radius_m, first.radius_m, 1e-9);
        }
    }

    /**
     * Each point is outside the circle of the previous ones: in this order the search would take
     * hours.
     */
    void alongAPathOutwards()
    {
        std::vector<Point> points;
        for (int i = 0; i < 40'000; ++i) {
            const double turn_rad = 1e-3 * i;
            points.emplace_back(turn_rad * std::cos(turn_rad), turn_rad * std::sin(turn_rad));
        }
        const Circle circle = enclosingCircle(points);
        QVERIFY(holds(circle, points));
        std::ranges::reverse(points); // this order is fast
        points.resize(10'000);        // the last turns decide
        COMPARE_NEAR(circle.radius_m, enclosingCircle(points).radius_m, 1e-9);
    }

    /** Far from the origin, points of a line deviate from it by rounding. */
    void inALineFarAway()
    {
        std::vector<Point> points;
        for (int i = 0; i <= 10; ++i)
            points.emplace_back(1e6 + 0.1 * i, -1e6 + 0.3 * i);
        const Circle circle = enclosingCircle(points);
        COMPARE_NEAR(circle.radius_m, std::sqrt(1 + 9) / 2, 1e-6);
    }
};

QTEST_APPLESS_MAIN(TestEnclosingCircle)
#include "tst_enclosing_circle.moc"
