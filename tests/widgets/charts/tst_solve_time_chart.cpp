#include "tests/support/approx.h"
#include "tests/support/benchmark_rows.h"
#include "tests/support/panel_test.h"
#include "widgets/charts/solve_time_chart.h"

#include <set>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

constexpr BenchmarkSolver kExact{.backend = Backend::Exact};

bool hasColour(const QImage& image, const QColor& colour)
{
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (image.pixelColor(x, y).rgb() == colour.rgb())
                return true;
    return false;
}

} // namespace

class TestSolveTimeChart : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void linesHoldThePaperAndTheRows()
    {
        const std::vector<SolveTimeLine> lines = solveTimeLines(test::benchmarkTable());
        QCOMPARE(lines.size(), std::size_t{6});
        QVERIFY(!lines[0].solver.has_value());
        QCOMPARE(lines[0].points.size(), paperTable2().size());
        QCOMPARE(lines[0].points.back().worst_s, 17269.17);
        QVERIFY(lines[1].solver == kExact);
        QCOMPARE(lines[1].points.size(), std::size_t{10});
        QCOMPARE(lines[1].points[4].icebergs, 16);
        QCOMPARE(lines[1].points[4].middle_s, 1.2e-3);
        COMPARE_NEAR(lines[1].points[4].worst_s, 3.6e-3, 1e-12);
        QVERIFY(lines[1].points[4].complete);
        QCOMPARE(lines[5].points.size(), std::size_t{2}); // what was not tried has no time
        QVERIFY(!lines[5].points[1].complete);
    }

    void aPowerOfTenIsAFixedHeight()
    {
        SolveTimeChart chart(Theme::light());
        chart.resize(800, 420);
        chart.setRows(test::benchmarkTable());
        const double second = chart.toView(0, 1).y();
        const double decade_px = second - chart.toView(0, 10).y();
        QVERIFY(decade_px > 10);
        COMPARE_NEAR(chart.toView(0, 1e-3).y(), second + 3 * decade_px, 1e-6);
        COMPARE_NEAR(chart.toView(0, 1e4).y(), second - 4 * decade_px, 1e-6);
        COMPARE_NEAR(chart.toView(40, 1).x(),
                     (chart.toView(0, 1).x() + chart.toView(80, 1).x()) / 2, 1e-6);
        // Zero has no logarithm: drawn at the foot of the axis, not outside.
        COMPARE_NEAR(chart.toView(0, 0).y(), chart.toView(0, 1e-6).y(), 1e-9);
    }

    void everythingIsInsideThePlot()
    {
        SolveTimeChart chart(Theme::light());
        chart.resize(700, 400);
        chart.setRows(test::benchmarkTable());
        const double top = chart.toView(0, 17269.17).y();
        const double foot = chart.toView(0, 1e-6).y();
        QVERIFY(top >= kChartTop_px && foot <= 400 - kChartBottom_px);
        QVERIFY(chart.toView(80, 1).x() < 700);
    }

    void ticksArePowersOfTenWithUnits()
    {
        SolveTimeChart chart(Theme::light());
        chart.setLocale(QLocale::c());
        chart.resize(800, 600);
        chart.setRows(test::benchmarkTable());
        QStringList texts;
        for (const ChartTick& tick : chart.timeTicks())
            texts << tick.text;
        for (const QString& text : {u"1 µs"_s, u"100 µs"_s, u"10 ms"_s, u"1 s"_s, u"100 s"_s})
            QVERIFY2(texts.contains(text), qPrintable(texts.join(u", "_s)));
        chart.resize(400, 200);
        chart.setRows(test::benchmarkTable());
        QVERIFY(chart.timeTicks().size() >= 3);
        QVERIFY(chart.timeTicks().size() < static_cast<std::size_t>(texts.size()));
    }

    void linesAreLabelled_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("design size") << QSize(760, 420);
        QTest::newRow("small") << QSize(480, 300);
        QTest::newRow("large") << QSize(1600, 900);
    }

    void linesAreLabelled()
    {
        QFETCH(QSize, size);
        SolveTimeChart chart(Theme::dark());
        chart.resize(size);
        chart.setRows(test::benchmarkTable());
        QCOMPARE(chart.labels().size(), std::size_t{7}); // the paper has two
        std::set<QString> texts;
        for (std::size_t i = 0; i < chart.labels().size(); ++i) {
            const ChartLabel& label = chart.labels()[i];
            texts.insert(label.text);
            QVERIFY(QRectF(QPointF(), QSizeF(size)).contains(label.rect));
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!label.rect.intersects(chart.labels()[j].rect));
        }
        QCOMPARE(texts.size(), std::size_t{7});
    }

    void withoutRowsThePaperIsShown()
    {
        SolveTimeChart chart(Theme::light());
        chart.resize(760, 420);
        QCOMPARE(chart.labels().size(), std::size_t{2});
        chart.setRows(test::benchmarkTable());
        chart.setRows({});
        QCOMPARE(chart.labels().size(), std::size_t{2});
        QVERIFY(!chart.grab().isNull());
    }

    void coloursAreTheThemes_data()
    {
        QTest::addColumn<bool>("isDark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }

    void coloursAreTheThemes()
    {
        QFETCH(bool, isDark);
        const Theme theme = isDark ? Theme::dark() : Theme::light();
        SolveTimeChart chart(isDark ? Theme::light() : Theme::dark());
        chart.resize(760, 420);
        chart.setRows(test::benchmarkTable());
        chart.setTheme(theme);
        const QImage image = chart.grab().toImage();
        QCOMPARE(image.pixelColor(0, 0).rgb(), theme.chart.rgb());
        std::set<QRgb> colours;
        for (const SolveTimeLine& line : solveTimeLines(test::benchmarkTable())) {
            const QColor colour = benchmarkSolverColour(line.solver, theme);
            QVERIFY(contrastRatio(colour, theme.chart) >= 3);
            QVERIFY(hasColour(image, colour));
            colours.insert(colour.rgb());
        }
        QCOMPARE(colours.size(), std::size_t{6});
    }

    void markersTellTheirNumbers()
    {
        SolveTimeChart chart(Theme::light());
        chart.setLocale(QLocale::c());
        chart.resize(760, 420);
        chart.setRows({test::benchmarkRow(kExact, 40, 0.08)});
        const QPointF at = chart.toView(40, 0.08);
        for (const QString& part : {u"40"_s, u"80.0 ms"_s, u"240 ms"_s, u"10 of 10"_s})
            QVERIFY2(chart.pointText(at + QPointF(3, -3)).contains(part),
                     qPrintable(chart.pointText(at)));
        QVERIFY(chart.pointText(chart.toView(20, 2969.69)).contains(u"CPLEX"_s));
        QVERIFY(chart.pointText(at + QPointF(0, 40)).isEmpty());
    }

    void everySolverHasAName()
    {
        std::set<QString> names;
        for (const Named<BenchmarkSolver>& solver : kBenchmarkSolverNames)
            names.insert(benchmarkSolverName(solver.value));
        QCOMPARE(names.size(), kBenchmarkSolverNames.size());
        QVERIFY(!names.contains(QString()));
    }
};

QTEST_MAIN(TestSolveTimeChart)
#include "tst_solve_time_chart.moc"
