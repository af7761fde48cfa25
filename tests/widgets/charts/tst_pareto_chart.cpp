#include "tests/support/approx.h"
#include "tests/support/plan/curve_builder.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "widgets/charts/pareto_chart.h"

#include <QSignalSpy>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** Places of the plans, in the order of the curve's intervals. */
std::vector<QPointF> pointsOf(const FigureView& chart)
{
    std::vector<QPointF> points;
    for (const DrawnItem& item : chart.drawing().items)
        points.push_back(toQt(item.at));
    return points;
}

struct ParetoChartFixture
{
    explicit ParetoChartFixture(const Theme& theme = Theme::light(), const QSize& size = {420, 250})
        : chart(theme)
    {
        chart.resize(size);
        chart.setCurve(test::curveThrough({0.5, 0.6, 2, 5}));
        chart.setTau(1);
        chart.show();
    }
    [[nodiscard]] QColor colourAt(const QPointF& point)
    {
        return chart.grab().toImage().pixelColor(point.toPoint());
    }
    ParetoChart chart;
};

/** Pixels of the theme's plan colour within `reach_px` of a place. */
int planPixels(const QImage& image, const QPointF& at, const Theme& theme, int reach_px)
{
    int count = 0;
    for (int y = -reach_px; y <= reach_px; ++y)
        for (int x = -reach_px; x <= reach_px; ++x) {
            const QPoint p = at.toPoint() + QPoint(x, y);
            if (image.rect().contains(p) && image.pixelColor(p).rgb() == theme.plan.rgb())
                ++count;
        }
    return count;
}

} // namespace

class TestParetoChart : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void plansAreInsideAndInOrder_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("smallest") << QSize(280, 150);
        QTest::newRow("usual") << QSize(420, 250);
        QTest::newRow("large") << QSize(1000, 600);
    }

    /** With growing tau paths get shorter (to the left) and the reward smaller (down). */
    void plansAreInsideAndInOrder()
    {
        QFETCH(QSize, size);
        const ParetoChartFixture f(Theme::light(), size);
        const std::vector<QPointF> points = pointsOf(f.chart);
        QCOMPARE(points.size(), 4U);
        for (std::size_t i = 0; i < points.size(); ++i) {
            QVERIFY(f.chart.rect().contains(points[i].toPoint()));
            if (i > 0)
                QVERIFY(points[i].x() < points[i - 1].x() && points[i].y() > points[i - 1].y());
        }
        // Distances fall in even steps, rewards as squares.
        COMPARE_NEAR(points[0].x() - points[1].x(), points[2].x() - points[3].x(), 1e-6);
        COMPARE_NEAR(points[3].y() - points[0].y(), 9 * (points[1].y() - points[0].y()), 1e-6);
    }

    void aSinglePlanIsInTheMiddle()
    {
        ParetoChartFixture f;
        f.chart.setCurve(test::curveThrough({5}));
        const std::vector<QPointF> points = pointsOf(f.chart);
        QCOMPARE(points.size(), 1U);
        QVERIFY(f.chart.rect().adjusted(60, 40, -30, -50).contains(points[0].toPoint()));
    }

    void thePresentPlanStandsOut_data()
    {
        QTest::addColumn<bool>("isDark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }

    void thePresentPlanStandsOut()
    {
        QFETCH(bool, isDark);
        const Theme theme = isDark ? Theme::dark() : Theme::light();
        ParetoChartFixture f(theme);
        QImage image = f.chart.grab().toImage();
        QCOMPARE(image.pixelColor(1, 1).rgb(), theme.chart.rgb());
        std::vector<QPointF> points = pointsOf(f.chart);
        QVERIFY(planPixels(image, points[2], theme, 8) >
                3 * planPixels(image, points[3], theme, 8));
        f.chart.setTau(4);
        image = f.chart.grab().toImage();
        QVERIFY(planPixels(image, points[3], theme, 8) >
                3 * planPixels(image, points[2], theme, 8));
    }

    void unprovenPlansAreHollow()
    {
        ParetoChartFixture f;
        TauCurve curve = test::curveThrough({0.5, 0.6, 2, 5});
        curve.intervals[3].proven = false;
        f.chart.setCurve(curve);
        QCOMPARE(f.colourAt(pointsOf(f.chart)[3]).rgb(), Theme::light().chart.rgb());
        QCOMPARE(f.colourAt(pointsOf(f.chart)[0]).rgb(), Theme::light().plan.rgb());
    }

    void clickChoosesAPlan()
    {
        ParetoChartFixture f;
        QSignalSpy spy(&f.chart, &ParetoChart::tauChosen);
        QTest::mouseClick(&f.chart, Qt::LeftButton, {}, pointsOf(f.chart)[3].toPoint());
        QCOMPARE(spy.count(), 1);
        COMPARE_NEAR(spy[0][0].toDouble(), 3.5, 1e-12);
        QTest::mouseClick(&f.chart, Qt::LeftButton, {}, QPoint(f.chart.width() - 40, 180));
        QCOMPARE(spy.count(), 1); // nothing there
    }

    void keysGoAlongTheFront()
    {
        ParetoChartFixture f;
        QSignalSpy spy(&f.chart, &ParetoChart::tauChosen);
        QTest::keyClick(&f.chart, Qt::Key_Left); // shorter
        COMPARE_NEAR(spy.last()[0].toDouble(), 3.5, 1e-12);
        QTest::keyClick(&f.chart, Qt::Key_Right); // longer
        COMPARE_NEAR(spy.last()[0].toDouble(), 0.55, 1e-12);
    }

    void readoutDescribesThePlanUnderThePointer()
    {
        ParetoChartFixture f;
        f.chart.setLocale(QLocale(QLocale::English));
        const QString present = f.chart.accessibleDescription();
        QTest::mouseMove(&f.chart, pointsOf(f.chart)[0].toPoint());
        QTRY_VERIFY(f.chart.accessibleDescription() != present);
        QVERIFY(f.chart.accessibleDescription().contains(u"whole order 30.0 km, proven optimal"_s));
        QTest::mouseMove(&f.chart, QPoint(f.chart.width() - 40, 180));
        QTRY_COMPARE(f.chart.accessibleDescription(), present);
    }

    /** An incomplete curve's plan for the present tau is not the one in use. */
    void incompleteCurveHasNoPresentPlan()
    {
        ParetoChartFixture f;
        const std::string figures = f.chart.drawing().rightTitle;
        const QString whole = f.chart.accessibleDescription();
        QVERIFY(!figures.empty());
        TauCurve curve = test::curveThrough({0.5, 0.6, 2, 5});
        curve.complete = false;
        f.chart.setCurve({});
        const QString computing = f.chart.accessibleDescription();
        f.chart.setCurve(curve);
        QCOMPARE(f.chart.accessibleDescription(), computing);
        QCOMPARE(QString::fromStdString(f.chart.drawing().rightTitle), computing);
        const double radius_px = f.chart.drawing().marks[0].of.radius_px;
        for (const DrawnMark& mark : f.chart.drawing().marks)
            QCOMPARE(mark.of.radius_px, radius_px);
        curve.complete = true;
        f.chart.setCurve(curve);
        QCOMPARE(f.chart.drawing().rightTitle, figures);
        QCOMPARE(f.chart.accessibleDescription(), whole);
    }

    void nameOfTheUpperEndIsClearOfTheFront_data()
    {
        QTest::addColumn<TauCurve>("curve");
        QTest::newRow("straight") << test::curveThrough({1, 5});
        QTest::newRow("bent") << test::curveThrough({0.5, 0.6, 2, 5});
        QTest::newRow("flat at first") << test::curveThrough({0.5, 0.6, 0.7, 0.8, 1, 2, 3, 4, 5});
    }

    void nameOfTheUpperEndIsClearOfTheFront()
    {
        QFETCH(TauCurve, curve);
        ParetoChartFixture f;
        f.chart.setCurve(curve);
        const Drawing& drawing = f.chart.drawing();
        QCOMPARE(drawing.labels.size(), std::size_t{2});
        QCOMPARE(drawing.labels[0].text, std::string("Most uncertain first"));
        const QRectF rect = toQt(drawing.labels[0].rect);
        QVERIFY(QRectF(f.chart.rect()).contains(rect));
        QVERIFY(rect.top() >= drawing.plot.top - 2); // below the titles
        const std::vector<Pixel>& front = drawing.lines[0].points;
        for (std::size_t i = 1; i < front.size(); ++i) {
            const QLineF part(toQt(front[i - 1]), toQt(front[i]));
            for (int k = 0; k <= 100; ++k)
                QVERIFY(!rect.contains(part.pointAt(k / 100.0)));
        }
    }

    void emptyChartsSayWhy()
    {
        ParetoChartFixture f;
        f.chart.setCurve({});
        const QString computing = f.chart.accessibleDescription();
        QVERIFY(!computing.isEmpty());
        f.chart.setCurve({.complete = true});
        QVERIFY(!f.chart.accessibleDescription().isEmpty());
        QVERIFY(f.chart.accessibleDescription() != computing);
        QVERIFY(pointsOf(f.chart).empty());
        QSignalSpy spy(&f.chart, &ParetoChart::tauChosen);
        QTest::mouseClick(&f.chart, Qt::LeftButton, {}, QPoint(200, 100));
        QTest::keyClick(&f.chart, Qt::Key_Left);
        QCOMPARE(spy.count(), 0);
    }

    void withoutTitleThePlotIsHigher()
    {
        ParetoChartFixture f;
        const std::vector<QPointF> before = pointsOf(f.chart);
        f.chart.setTitleShown(false);
        const std::vector<QPointF> after = pointsOf(f.chart);
        QVERIFY(after.front().y() < before.front().y());
    }
};

QTEST_MAIN(TestParetoChart)
#include "tst_pareto_chart.moc"
