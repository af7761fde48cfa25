#include "tests/support/approx.h"
#include "tests/support/window/benchmark_rows.h"
#include "tests/support/window/panel_test.h"
#include "widgets/charts/solve_time_chart.h"

#include <QMouseEvent>

#include <set>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

constexpr BenchmarkSolver kExact{.backend = Backend::Exact};

QPointF viewOf(const FigureView& chart, double icebergs, double time_s)
{
    return toQt(chart.drawing().at({icebergs, time_s}));
}

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
        QCOMPARE(lines[5].points.size(), std::size_t{2}); // sizes that were not run have no time
        QVERIFY(!lines[5].points[1].complete);
    }

    void aPowerOfTenIsAFixedHeight()
    {
        SolveTimeChart chart(Theme::light());
        chart.resize(800, 420);
        chart.setRows(test::benchmarkTable());
        const double second = viewOf(chart, 0, 1).y();
        const double decade_px = second - viewOf(chart, 0, 10).y();
        QVERIFY(decade_px > 10);
        COMPARE_NEAR(viewOf(chart, 0, 1e-3).y(), second + 3 * decade_px, 1e-6);
        COMPARE_NEAR(viewOf(chart, 0, 1e4).y(), second - 4 * decade_px, 1e-6);
        COMPARE_NEAR(viewOf(chart, 40, 1).x(),
                     (viewOf(chart, 0, 1).x() + viewOf(chart, 80, 1).x()) / 2, 1e-6);
        // Zero has no logarithm: drawn at the foot of the axis, not outside.
        COMPARE_NEAR(viewOf(chart, 0, 0).y(), viewOf(chart, 0, 1e-6).y(), 1e-9);
    }

    void everythingIsInsideThePlot()
    {
        SolveTimeChart chart(Theme::light());
        chart.resize(700, 400);
        chart.setRows(test::benchmarkTable());
        const double top = viewOf(chart, 0, 17269.17).y();
        const double foot = viewOf(chart, 0, 1e-6).y();
        QVERIFY(top >= kFigureTop_px && foot <= 400 - kFigureBottom_px);
        QVERIFY(viewOf(chart, 80, 1).x() < 700);
    }

    void ticksArePowersOfTenWithUnits()
    {
        SolveTimeChart chart(Theme::light());
        chart.setLocale(QLocale::c());
        chart.resize(800, 600);
        chart.setRows(test::benchmarkTable());
        QStringList texts;
        for (const DrawnTick& tick : chart.drawing().yTicks)
            texts << QString::fromStdString(tick.text);
        for (const QString& text : {u"1 µs"_s, u"100 µs"_s, u"10 ms"_s, u"1 s"_s, u"100 s"_s})
            QVERIFY2(texts.contains(text), qPrintable(texts.join(u", "_s)));
        chart.resize(400, 200);
        chart.setRows(test::benchmarkTable());
        QVERIFY(chart.drawing().yTicks.size() >= 3);
        QVERIFY(chart.drawing().yTicks.size() < static_cast<std::size_t>(texts.size()));
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
        QCOMPARE(chart.drawing().labels.size(), std::size_t{7}); // the paper has two
        std::set<QString> texts;
        for (std::size_t i = 0; i < chart.drawing().labels.size(); ++i) {
            const DrawnLabel& label = chart.drawing().labels[i];
            texts.insert(QString::fromStdString(label.text));
            QVERIFY(QRectF(QPointF(), QSizeF(size)).contains(toQt(label.rect)));
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!label.rect.intersects(chart.drawing().labels[j].rect));
        }
        QCOMPARE(texts.size(), std::size_t{7});
    }

    void withoutRowsThePaperIsShown()
    {
        SolveTimeChart chart(Theme::light());
        chart.resize(760, 420);
        QCOMPARE(chart.drawing().labels.size(), std::size_t{2});
        chart.setRows(test::benchmarkTable());
        chart.setRows({});
        QCOMPARE(chart.drawing().labels.size(), std::size_t{2});
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

    void markersShowTheirNumbers()
    {
        SolveTimeChart chart(Theme::light());
        chart.setLocale(QLocale::c());
        chart.resize(760, 420);
        chart.setRows({test::benchmarkRow(kExact, 40, 0.08)});
        const QPointF at = viewOf(chart, 40, 0.08);
        const auto textAt = [&chart](const QPointF& place) {
            QMouseEvent event(QEvent::MouseMove, place, place, Qt::NoButton, {}, {});
            QCoreApplication::sendEvent(&chart, &event);
            return chart.accessibleDescription();
        };
        for (const QString& part : {u"40"_s, u"80.0 ms"_s, u"240 ms"_s, u"10 of 10"_s})
            QVERIFY2(textAt(at + QPointF(3, -3)).contains(part), qPrintable(textAt(at)));
        QVERIFY(textAt(viewOf(chart, 20, 2969.69)).contains(u"CPLEX"_s));
        QVERIFY(textAt(at + QPointF(0, 40)).isEmpty());
    }

    /** V of its menu, and its points, are for the keyboard too. */
    void keysReachIt()
    {
        SolveTimeChart chart(Theme::light());
        QVERIFY(chart.focusPolicy() & Qt::TabFocus);
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
