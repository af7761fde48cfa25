#include "core/base/label_column.h"
#include "core/base/nice_ticks.h"
#include "core/io/figure/figure_layout.h"
#include "tests/support/approx.h"

#include <QtTest>

#include <cmath>
#include <set>

using namespace berg;
using namespace Qt::StringLiterals;

/** Ticks of the axes and places of the labels, without a chart. */
class TestChartAxes : public QObject
{
    Q_OBJECT

private slots:
    void ticksAroundZero_data()
    {
        QTest::addColumn<double>("lowest");
        QTest::addColumn<double>("highest");
        QTest::addColumn<int>("most");
        QTest::newRow("turn rate") << -11.9 << 11.9 << 4;
        QTest::newRow("little room") << -11.9 << 11.9 << 1;
        QTest::newRow("mostly above") << -3.0 << 950.0 << 5;
        QTest::newRow("below only") << -72.0 << 0.0 << 3;
        QTest::newRow("above only") << 0.0 << 72.0 << 3;
    }

    void ticksAroundZero()
    {
        QFETCH(double, lowest);
        QFETCH(double, highest);
        QFETCH(int, most);
        const NiceTicks ticks = niceTicksAround(lowest, highest, most);
        QVERIFY(ticks.start() <= lowest + 1e-9 && ticks.end() >= highest - 1e-9);
        QVERIFY(ticks.below + ticks.count >= 1);
        QVERIFY(ticks.below + ticks.count <= std::max(2, most));
        QVERIFY(ticks.step <= 2.5 * std::max(-lowest, highest)); // no empty axis
    }

    void ticksAreRoundAndCover_data()
    {
        QTest::addColumn<double>("largest");
        QTest::addColumn<int>("most");
        QTest::newRow("sum of sigma") << 134.2 << 8;
        QTest::newRow("zeta") << 90620.0 << 7;
        QTest::newRow("small") << 0.0037 << 5;
        QTest::newRow("exactly a tick") << 20.0 << 4;
        QTest::newRow("one step") << 7.0 << 1;
    }

    void ticksAreRoundAndCover()
    {
        QFETCH(double, largest);
        QFETCH(int, most);
        for (const NiceTicks& ticks : {niceTicks(largest, most), niceTicksExactly(largest, most)}) {
            QVERIFY(ticks.count >= 1 && ticks.count <= most);
            QVERIFY(ticks.end() >= largest * (1 - 1e-9));
            QVERIFY(ticks.step <= 2.5 * largest); // no empty axis
            const double leading =
                ticks.step / std::pow(10.0, std::floor(std::log10(ticks.step) + 1e-9));
            const std::set<int> round = {10, 20, 25, 50};
            QVERIFY(round.count(static_cast<int>(std::lround(10 * leading))) == 1);
        }
    }

    void ticksOfNothing()
    {
        QCOMPARE(niceTicks(0, 5).count, 1);
        COMPARE_NEAR(niceTicks(0, 5).end(), 1, 1e-12);
        COMPARE_NEAR(niceTicksExactly(0, 3).end(), 3, 1e-12);
        QCOMPARE((NiceTicks{.step = 2.5}).decimals(), 1);
        QCOMPARE((NiceTicks{.step = 20}).decimals(), 0);
        QCOMPARE((NiceTicks{.step = 0.025}).decimals(), 3);
    }

    void timeSteps_data()
    {
        QTest::addColumn<double>("duration_s");
        QTest::addColumn<int>("most");
        QTest::addColumn<double>("step_s");
        QTest::newRow("run of the paper") << 1000.0 << 10 << 120.0;
        QTest::newRow("short") << 9.0 << 10 << 1.0;
        QTest::newRow("a day") << 86400.0 << 12 << 7200.0;
        QTest::newRow("a week") << 604800.0 << 10 << 86400.0;
        QTest::newRow("narrow") << 604800.0 << 2 << 345600.0;
    }

    void timeSteps()
    {
        QFETCH(double, duration_s);
        QFETCH(int, most);
        QFETCH(double, step_s);
        COMPARE_NEAR(timeStep_s(duration_s, most), step_s, 1e-9);
    }

    void spreadingMovesAsLittleAsPossible()
    {
        const LabelColumn column{.top = 0, .bottom = 200, .spacing = 10};
        const std::vector<double> free = {20, 60, 100};
        QCOMPARE(spreadLabels(free, column), free);
        // Two that coincide share the move; least squares puts their mean where it was.
        const std::vector<double> pair = spreadLabels(std::vector<double>{50, 50}, column);
        COMPARE_NEAR(pair[0], 45, 1e-9);
        COMPARE_NEAR(pair[1], 55, 1e-9);
        // At the end of the column the block slides inside.
        const std::vector<double> low = spreadLabels(std::vector<double>{198, 199, 200}, column);
        COMPARE_NEAR(low[2], 195, 1e-9);
        COMPARE_NEAR(low[0], 175, 1e-9);
    }

    void onlyNearLabelsAreNamed()
    {
        const LabelColumn column{.top = 0, .bottom = 400, .spacing = 10};
        const std::vector<double> wanted(30, 200.0);
        const auto middles = nameableLabels(wanted, column, 25);
        // Symmetric about 200 with neighbours 10 apart: six reach at most 25 away.
        QCOMPARE(std::count_if(middles.begin(), middles.end(),
                               [](const auto& m) { return m.has_value(); }),
                 6);
        QVERIFY(middles[0].has_value()); // the first are the most important
        QVERIFY(!middles[29].has_value());
    }

    /** Two lines that rise near each other; the first one has room below it. */
    static Drawing withNames(double letter_px)
    {
        Figure figure;
        const auto number = [](double value, int decimals) {
            return QByteArray::number(value, 'f', decimals).toStdString();
        };
        figure.x = {.ends = AxisEnds::Exact, .largest = 300, .text = number};
        figure.y = {.ends = AxisEnds::Around0, .largest = 200, .text = number};
        figure.lines = {{.points = {{0, 100}, {300, 150}}}, {.points = {{0, 140}, {300, 160}}}};
        for (const std::size_t line : {0UL, 1UL})
            figure.labels.push_back({.text = "own name",
                                     .shortText = "own",
                                     .place = LabelPlace::Inside,
                                     .needsMargin = false,
                                     .line = line});
        return layOut(figure, {400, 260},
                      {.width_px =
                           [letter_px](const std::string& text, FigureFont /*font*/) {
                               return letter_px * static_cast<double>(text.size());
                           },
                       .elided = [](const std::string& text, FigureFont /*font*/,
                                    double /*room_px*/) { return text; }});
    }

    void labelBesideALineTouchesNone()
    {
        const Drawing drawing = withNames(8);
        QCOMPARE(drawing.labels.size(), std::size_t{2});
        for (const DrawnLabel& label : drawing.labels)
            QVERIFY(drawing.plot.contains(label.rect));
        QVERIFY(drawing.labels[0].rect.top > drawing.y.at(150));    // below its own line
        QVERIFY(drawing.labels[1].rect.bottom < drawing.y.at(140)); // above it
        QVERIFY(!drawing.labels[0].rect.intersects(drawing.labels[1].rect));
    }

    void theFirstNameIsRatherShortThanLeftOut()
    {
        const Drawing drawing = withNames(50);
        QCOMPARE(drawing.labels.size(), std::size_t{1});
        QCOMPARE(drawing.labels[0].text, std::string("own"));
        QVERIFY(withNames(300).labels.empty()); // wider than the plot
    }
};

QTEST_APPLESS_MAIN(TestChartAxes)
#include "tst_chart_axes.moc"
