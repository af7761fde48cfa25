#include "tests/support/approx.h"
#include "widgets/charts/time_series.h"
#include "widgets/charts/time_window.h"

#include <QtTest>

#include <cmath>

using namespace berg;

namespace {

TimeSeries wave(int count)
{
    TimeSeries series;
    for (int i = 0; i < count; ++i)
        series.append({0.5 * i, std::sin(0.05 * i) + 0.3 * std::sin(1.7 * i)});
    return series;
}

} // namespace

class TestTimeSeries : public QObject
{
    Q_OBJECT

private slots:
    void thinnedKeepsTheRangeOfEveryColumn_data()
    {
        QTest::addColumn<int>("points");
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        QTest::addColumn<int>("columns");
        QTest::newRow("none") << 0 << 0.0 << 10.0 << 100;
        QTest::newRow("one") << 1 << 0.0 << 10.0 << 100;
        QTest::newRow("fewer than columns") << 50 << 0.0 << 25.0 << 100;
        QTest::newRow("runs of 8") << 2003 << 0.0 << 1001.0 << 100;
        QTest::newRow("runs of 64") << 20000 << 0.0 << 10000.0 << 100;
        QTest::newRow("runs of 512") << 100001 << 0.0 << 50000.0 << 64;
        QTest::newRow("a part") << 20000 << 1234.5 << 6789.1 << 100;
        QTest::newRow("the end") << 20000 << 9000.0 << 10000.0 << 300;
        QTest::newRow("beyond") << 2000 << 5000.0 << 6000.0 << 100;
    }

    /** Over columns, as runs may straddle two of them. */
    void thinnedKeepsTheRangeOfEveryColumn()
    {
        QFETCH(int, points);
        QFETCH(double, from);
        QFETCH(double, to);
        QFETCH(int, columns);
        const TimeSeries series = wave(points);
        const DecimationWindow window{.from = from, .to = to, .columns = columns};
        const QList<QPointF> thin = series.thinned(window);
        const QList<QPointF> plain = decimate(series.points(), window);
        QVERIFY(thin.size() <= 2 * columns + 4);
        QCOMPARE(thin.isEmpty(), plain.isEmpty());
        if (plain.isEmpty())
            return;
        QCOMPARE(thin.front(), plain.front());
        QCOMPARE(thin.back(), plain.back());
        const double width = (to - from) / columns;
        for (int k = 1; k + 1 < columns; ++k) {
            const auto range = [&](const QList<QPointF>& list, double margin) {
                double low = 1e9;
                double high = -1e9;
                for (const QPointF& p : list)
                    if (p.x() >= from + width * (k - margin) &&
                        p.x() < from + width * (k + 1 + margin)) {
                        low = std::min(low, p.y());
                        high = std::max(high, p.y());
                    }
                return std::pair(low, high);
            };
            const auto [low, high] = range(plain, 0);
            if (low > high)
                continue;
            const auto [thinLow, thinHigh] = range(thin, 1);
            QVERIFY(thinLow <= low && thinHigh >= high); // no peak is lost
        }
    }

    void dipOfOneSampleSurvives()
    {
        TimeSeries series;
        for (int i = 0; i < 17280; ++i)
            series.append({5.0 * i, i == 12345 ? 0.0 : 30 + 0.001 * (i % 100)});
        const QList<QPointF> thin = series.thinned({.from = 0, .to = 86400, .columns = 600});
        QVERIFY(thin.contains(QPointF(5.0 * 12345, 0)));
        QVERIFY(thin.size() <= 1204);
    }

    void zoomingKeepsTheTimeUnderThePointer_data()
    {
        QTest::addColumn<double>("factor");
        QTest::addColumn<double>("anchor_s");
        QTest::addColumn<double>("from_s");
        QTest::addColumn<double>("to_s");
        QTest::newRow("in") << 0.5 << 300.0 << 250.0 << 350.0;
        QTest::newRow("in, at the left end") << 0.5 << 200.0 << 200.0 << 300.0;
        QTest::newRow("out") << 2.0 << 300.0 << 100.0 << 500.0;
        QTest::newRow("out, stopped at the start") << 3.0 << 300.0 << 0.0 << 600.0;
        QTest::newRow("no shorter than the least") << 0.001 << 300.0 << 297.5 << 302.5;
        QTest::newRow("no longer than all") << 99.0 << 300.0 << 0.0 << 1000.0;
    }

    void zoomingKeepsTheTimeUnderThePointer()
    {
        QFETCH(double, factor);
        QFETCH(double, anchor_s);
        QFETCH(double, from_s);
        QFETCH(double, to_s);
        const TimeWindow window = zoomed({.from_s = 200, .to_s = 400}, factor, anchor_s, 1000);
        COMPARE_NEAR(window.from_s, from_s, 1e-9);
        COMPARE_NEAR(window.to_s, to_s, 1e-9);
    }

    void shiftingStopsAtTheEnds()
    {
        const TimeWindow window{.from_s = 200, .to_s = 400};
        QCOMPARE(shifted(window, 100, 1000), (TimeWindow{.from_s = 300, .to_s = 500}));
        QCOMPARE(shifted(window, -900, 1000), (TimeWindow{.from_s = 0, .to_s = 200}));
        QCOMPARE(shifted(window, 900, 1000), (TimeWindow{.from_s = 800, .to_s = 1000}));
    }
};

QTEST_APPLESS_MAIN(TestTimeSeries)
#include "tst_time_series.moc"
