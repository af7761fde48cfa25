#include "tests/support/approx.h"
#include "widgets/charts/decimate.h"

#include <QtTest>

#include <cmath>
#include <limits>
#include <vector>

using namespace berg;

namespace {

std::vector<QPointF> wave(int count)
{
    std::vector<QPointF> points;
    for (int i = 0; i < count; ++i)
        points.emplace_back(i, std::sin(0.05 * i) + 0.3 * std::sin(1.7 * i));
    return points;
}

} // namespace

class TestDecimate : public QObject
{
    Q_OBJECT

private slots:
    void fewPointsStayAsTheyAre()
    {
        const std::vector<QPointF> points = {{0, 1}, {1, 3}, {2, 2}};
        const QList<QPointF> out = decimate(points, {.from = 0, .to = 2, .columns = 100});
        QCOMPARE(out, QList<QPointF>(points.begin(), points.end()));
    }

    void nothingIn_nothingOut()
    {
        QVERIFY(decimate({}, {.from = 0, .to = 1, .columns = 10}).isEmpty());
    }

    void atMostTwoPointsForEachColumn_data()
    {
        QTest::addColumn<int>("points");
        QTest::addColumn<int>("columns");
        QTest::newRow("dense") << 100000 << 900;
        QTest::newRow("one column") << 5000 << 1;
        QTest::newRow("sparse") << 50 << 900;
    }

    void atMostTwoPointsForEachColumn()
    {
        QFETCH(int, points);
        QFETCH(int, columns);
        const std::vector<QPointF> all = wave(points);
        const double to = points - 1.0;
        const QList<QPointF> out = decimate(all, {.from = 0, .to = to, .columns = columns});
        QVERIFY(out.size() <= 2 * columns + 2); // and the first and the last one
        QVERIFY(std::is_sorted(out.begin(), out.end(),
                               [](const QPointF& a, const QPointF& b) { return a.x() < b.x(); }));
        QCOMPARE(out.front(), all.front());
        QCOMPARE(out.back(), all.back());
    }

    /** Every column keeps exactly the range of its points: no peak is lost or invented. */
    void decimationKeepsTheRangeOfEachColumn()
    {
        constexpr int kColumns = 64;
        const std::vector<QPointF> all = wave(6400);
        const double to = 6400; // 100 points in each column
        const QList<QPointF> out = decimate(all, {.from = 0, .to = to, .columns = kColumns});
        for (int column = 0; column < kColumns; ++column) {
            const auto rangeOf = [column](const auto& points) {
                double low = std::numeric_limits<double>::infinity();
                double high = -low;
                for (const QPointF& p : points) {
                    if (static_cast<int>(p.x() / 100) != column)
                        continue;
                    low = std::min(low, p.y());
                    high = std::max(high, p.y());
                }
                return std::pair(low, high);
            };
            QCOMPARE(rangeOf(out), rangeOf(all));
        }
    }

    void singlePeakSurvives()
    {
        std::vector<QPointF> points = wave(10000);
        points[5432].setY(100);
        const QList<QPointF> out = decimate(points, {.from = 0, .to = 9999, .columns = 100});
        QVERIFY(out.contains(QPointF(5432, 100)));
    }

    void gapsOfNumbersAreDropped()
    {
        const double nan = std::nan("");
        const double infinity = std::numeric_limits<double>::infinity();
        const std::vector<QPointF> points = {{0, 1}, {1, nan}, {2, infinity}, {nan, 4}, {4, 5}};
        const QList<QPointF> out = decimate(points, {.from = 0, .to = 4, .columns = 10});
        QCOMPARE(out, (QList<QPointF>{{0, 1}, {4, 5}}));
    }

    void neighboursOfTheViewAreKept()
    {
        const std::vector<QPointF> points = {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}};
        const QList<QPointF> out = decimate(points, {.from = 1.5, .to = 3.5, .columns = 10});
        QCOMPARE(out, (QList<QPointF>{{1, 1}, {2, 2}, {3, 3}, {4, 4}}));
    }

    void viewBetweenTwoPointsShowsTheLineBetween()
    {
        const std::vector<QPointF> points = {{0, 0}, {10, 10}};
        const QList<QPointF> out = decimate(points, {.from = 4, .to = 5, .columns = 10});
        QCOMPARE(out, (QList<QPointF>{{0, 0}, {10, 10}}));
    }

    void emptyWindowIsABug()
    {
        QVERIFY_THROWS_EXCEPTION(std::logic_error,
                                 (void)decimate(wave(3), {.from = 1, .to = 1, .columns = 10}));
        QVERIFY_THROWS_EXCEPTION(std::logic_error,
                                 (void)decimate(wave(3), {.from = 0, .to = 1, .columns = 0}));
    }

    void rampsBecomeOneSegment()
    {
        QList<QPointF> teeth;
        for (int i = 0; i <= 1000; ++i)
            teeth.emplace_back(i, 0.025 * (i % 250));
        const QList<QPointF> out = simplified(teeth, 1e-9);
        // Start, top and bottom of three jumps, and the last jump's bottom, the end.
        QCOMPARE(out, (QList<QPointF>{{0, 0},
                                      {249, 0.025 * 249},
                                      {250, 0},
                                      {499, 0.025 * 249},
                                      {500, 0},
                                      {749, 0.025 * 249},
                                      {750, 0},
                                      {999, 0.025 * 249},
                                      {1000, 0}}));
    }

    void simplifyingStaysWithinTheTolerance()
    {
        const std::vector<QPointF> all = wave(5000);
        const QList<QPointF> points(all.begin(), all.end());
        constexpr double kTolerance = 0.05;
        const QList<QPointF> out = simplified(points, kTolerance);
        QVERIFY(out.size() < points.size());
        qsizetype k = 0;
        for (const QPointF& p : points) {
            while (out[k + 1].x() < p.x())
                ++k;
            const double t = (p.x() - out[k].x()) / (out[k + 1].x() - out[k].x());
            COMPARE_NEAR(out[k].y() + t * (out[k + 1].y() - out[k].y()), p.y(),
                         kTolerance * (1 + 1e-9));
        }
        QCOMPARE(simplified({}, 1), QList<QPointF>());
        QCOMPARE(simplified({{0, 1}, {1, 5}}, 1), (QList<QPointF>{{0, 1}, {1, 5}}));
    }
};

QTEST_APPLESS_MAIN(TestDecimate)
#include "tst_decimate.moc"
