#include "tests/support/approx.h"
#include "tests/support/window/comparison_builder.h"
#include "tests/support/window/panel_test.h"
#include "widgets/charts/comparison_chart.h"

#include <QContextMenuEvent>
#include <QMenu>
#include <QTableView>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

QPointF viewOf(const FigureView& chart, double time_s, double zeta_m2s)
{
    return toQt(chart.drawing().at({time_s, zeta_m2s}));
}

struct ComparisonChartFixture
{
    ComparisonChart chart{Theme::light()};

    explicit ComparisonChartFixture(const RunComparison& comparison)
    {
        chart.setLocale(QLocale::c());
        chart.resize(600, 300);
        chart.setComparison(comparison);
    }
    [[nodiscard]] QImage image() { return chart.grab().toImage(); }
    /** Pixels of a colour between two times, from the foot to the top of the plot. */
    [[nodiscard]] int count(const QColor& colour, double from_s, double to_s)
    {
        const QImage grabbed = image();
        int found = 0;
        for (int x = static_cast<int>(viewOf(chart, from_s, 0).x());
             x < static_cast<int>(viewOf(chart, to_s, 0).x()); ++x)
            for (int y = 0; y < grabbed.height(); ++y)
                found += grabbed.pixelColor(x, y).rgb() == colour.rgb() ? 1 : 0;
        return found;
    }
};

const QColor kPlainShade = mixed(Theme::light().chart, Theme::light().accumulated, 0.16);
const QColor kHatch = mixed(Theme::light().chart, Theme::light().comparison, 0.5);

} // namespace

class TestComparisonChart : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void emptyChartHasAHint()
    {
        ComparisonChart chart(Theme::dark());
        chart.resize(480, 210);
        QVERIFY(chart.drawing().labels.empty());
        QVERIFY(chart.drawing().rightTitle.empty());
        QVERIFY(!chart.accessibleDescription().isEmpty());
        QCOMPARE(chart.grab().toImage().pixelColor(1, 1).rgb(), Theme::dark().chart.rgb());
    }

    /** With the arrow keys, and as a table. */
    void valuesAreRead()
    {
        ComparisonChartFixture f(test::comparisonOf({0, 40, 80, 100}, {0, 50, 100, 120}));
        f.chart.setFocus();
        QTest::keyClick(&f.chart, Qt::Key_End);
        QCOMPARE(f.chart.accessibleDescription(),
                 u"00:03, τ 1.00: 100.0 m² s, Round tour: 120.0 m² s"_s);
        QTest::keyClick(&f.chart, Qt::Key_Home);
        QCOMPARE(f.chart.accessibleDescription(), u"00:00, τ 1.00: 0 m² s, Round tour: 0 m² s"_s);
        const QPoint at = f.chart.rect().center();
        QContextMenuEvent event(QContextMenuEvent::Keyboard, at, f.chart.mapToGlobal(at));
        QCoreApplication::sendEvent(&f.chart, &event);
        test::child<QMenu>(f.chart, u"figureMenu"_s).actions().front()->trigger();
        const QAbstractItemModel& values = *test::child<QTableView>(f.chart, u"values"_s).model();
        QCOMPARE(values.rowCount(), static_cast<int>(f.chart.drawing().items.size()));
        QCOMPARE(values.index(0, 0).data().toString(), u"00:00"_s);
        QCOMPARE(values.index(values.rowCount() - 1, 1).data().toString(),
                 u"τ 1.00: 100.0 m² s, Round tour: 120.0 m² s"_s);
        f.chart.setComparison(std::nullopt);
        QTest::keyClick(&f.chart, Qt::Key_End); // there is nothing to read any more
        QVERIFY(!f.chart.accessibleDescription().contains(u"Round tour"_s));
    }

    void linesEndWithTheirNames()
    {
        ComparisonChartFixture f(test::comparisonOf({0, 40, 80, 100}, {0, 50, 100, 120}));
        QCOMPARE(f.chart.drawing().labels.size(), std::size_t{2});
        const DrawnLabel& reference = f.chart.drawing().labels[0];
        const DrawnLabel& other = f.chart.drawing().labels[1];
        QCOMPARE(QString::fromStdString(reference.text), u"τ 1.00"_s);
        QCOMPARE(QString::fromStdString(other.text), u"Round tour"_s);
        QCOMPARE(reference.of.ink.of, InkOf::Accumulated);
        QCOMPARE(other.of.ink.of, InkOf::Comparison);
        QVERIFY(other.rect.top < reference.rect.top); // more is higher
        COMPARE_NEAR(reference.end.y, viewOf(f.chart, 3, 100).y(), 1e-9);
        QVERIFY(QRectF(f.chart.rect()).contains(toQt(reference.rect)));
        QVERIFY(!reference.rect.intersects(other.rect));
    }

    /** Beside its end, on the side where no line is. */
    void aShorterRunIsNamedInThePlot_data()
    {
        QTest::addColumn<double>("zeta_m2s");
        QTest::newRow("upper line") << 90.0;
        QTest::newRow("lower line") << 20.0;
    }

    void aShorterRunIsNamedInThePlot()
    {
        QFETCH(double, zeta_m2s);
        ComparisonChartFixture f(
            test::comparisonOf({0, 20, 40, 60, 80, 100}, {0, zeta_m2s / 2, zeta_m2s}));
        QVERIFY(f.chart.drawing().labels[0].of.place == LabelPlace::Margin);
        const DrawnLabel& label = f.chart.drawing().labels[1];
        QVERIFY(label.of.place == LabelPlace::Free);
        // Right of its end, where the reference goes on above or below.
        QVERIFY(label.rect.left > viewOf(f.chart, 2, zeta_m2s).x());
        const double rightmost_s = (label.rect.right - f.chart.drawing().x.from_px) /
                                   (f.chart.drawing().x.at(1) - f.chart.drawing().x.from_px);
        const double height_px = viewOf(f.chart, 0, 20 * rightmost_s).y();
        QVERIFY(zeta_m2s > 40 ? label.rect.bottom < height_px
                              : label.rect.top > viewOf(f.chart, 0, 40).y());
    }

    void verdictNamesTheBetterRun_data()
    {
        QTest::addColumn<QList<double>>("reference");
        QTest::addColumn<QList<double>>("other");
        QTest::addColumn<QString>("text");
        QTest::newRow("reference ahead") << QList<double>{0, 50, 100} << QList<double>{0, 60, 120}
                                         << u"τ 1.00 is ahead: Round tour has 20.0 % more ζ"_s;
        QTest::newRow("other ahead") << QList<double>{0, 50, 100} << QList<double>{0, 60, 96}
                                     << u"Round tour is ahead: it has 4.0 % less ζ than τ 1.00"_s;
        QTest::newRow("equal") << QList<double>{0, 50, 100} << QList<double>{0, 60, 100}
                               << u"τ 1.00 and Round tour: the same ζ"_s;
        QTest::newRow("at the common time")
            << QList<double>{0, 50, 100, 300} << QList<double>{0, 40, 80}
            << u"Round tour is ahead: it has 20.0 % less ζ than τ 1.00"_s;
        QTest::newRow("nothing accumulated")
            << QList<double>{0, 0} << QList<double>{0, 0} << u"τ 1.00 and Round tour: the same ζ"_s;
    }

    void verdictNamesTheBetterRun()
    {
        QFETCH(QList<double>, reference);
        QFETCH(QList<double>, other);
        QFETCH(QString, text);
        const RunComparison comparison =
            test::comparisonOf({reference.begin(), reference.end()}, {other.begin(), other.end()});
        QCOMPARE(verdictText(comparison, QLocale::c()), text);
        ComparisonChartFixture f(comparison);
        QCOMPARE(QString::fromStdString(f.chart.drawing().rightTitle), text);
        QCOMPARE(f.chart.accessibleDescription(), text);
    }

    /** Plain where the reference has less, hatched where the other one has, nothing beyond. */
    void differenceIsShaded()
    {
        ComparisonChartFixture f(
            test::comparisonOf({0, 20, 100, 180, 200, 220}, {0, 80, 100, 120, 140}));
        // The lines cross at 2 s and part until 4 s, the end of the shorter run.
        QVERIFY(f.count(kPlainShade, 0.3, 1.8) > 500);
        QCOMPARE(f.count(kHatch, 0.3, 1.8), 0);
        QVERIFY(f.count(kHatch, 2.2, 3.9) > 100);
        QCOMPARE(f.count(kPlainShade, 2.2, 3.9), 0);
        QCOMPARE(f.count(kHatch, 4.1, 5), 0);
        QCOMPARE(f.count(kPlainShade, 4.1, 5), 0);
        QVERIFY(f.count(Theme::light().accumulated, 4.1, 4.9) > 0); // its line goes on
    }

    void equalRunsHaveNoShade()
    {
        ComparisonChartFixture f(test::comparisonOf({0, 50, 100}, {0, 50, 100}));
        QCOMPARE(f.count(kPlainShade, 0.1, 2), 0);
        QCOMPARE(f.count(kHatch, 0.1, 2), 0);
    }

    void cursorIsAtItsTime()
    {
        ComparisonChartFixture f(test::comparisonOf({0, 50, 100, 150}, {0, 60, 120, 170}));
        const auto atCursor = [&] {
            return f.image().pixelColor(viewOf(f.chart, 1, 140).toPoint()).rgb();
        };
        const QRgb before = atCursor();
        f.chart.setCursor_s(1);
        QVERIFY(atCursor() != before);
        f.chart.setCursor_s({});
        QCOMPARE(atCursor(), before);
    }

    void everySizeIsDrawn_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("titled");
        for (const QSize& size : {QSize(200, 130), QSize(480, 210), QSize(1400, 500)})
            for (const bool titled : {true, false})
                QTest::addRow("%dx%d %d", size.width(), size.height(), int(titled))
                    << size << titled;
    }

    void everySizeIsDrawn()
    {
        QFETCH(QSize, size);
        QFETCH(bool, titled);
        const test::LongerTexts longer;
        ComparisonChartFixture f(test::comparisonOf({0, 50, 100, 150}, {0, 60, 120, 170}));
        f.chart.setTitleShown(titled);
        f.chart.resize(size);
        f.chart.setTheme(Theme::dark());
        QCOMPARE(f.image().pixelColor(0, 0).rgb(), Theme::dark().chart.rgb());
        for (const DrawnLabel& label : f.chart.drawing().labels)
            QVERIFY(label.rect.right <= size.width());
        // Higher is more, whatever the size.
        QVERIFY(viewOf(f.chart, 0, 170).y() < viewOf(f.chart, 0, 0).y());
    }

    void aLongRunIsQuicklyMadeSmall()
    {
        std::vector<double> reference;
        std::vector<double> other;
        for (int k = 0; k < 100000; ++k) {
            reference.push_back(k);
            other.push_back(1.1 * k);
        }
        ComparisonChartFixture f(test::comparisonOf(reference, other));
        QVERIFY(f.count(kPlainShade, 50000, 99000) > 500);
    }

    void longVerdictsAreShortened()
    {
        ComparisonChartFixture f(test::comparisonOf({0, 50, 100}, {0, 60, 120}));
        f.chart.resize(260, 200);
        QVERIFY(!f.image().isNull()); // a hidden widget is laid out when it is drawn
        QCOMPARE(QString::fromStdString(f.chart.drawing().rightTitle), u"τ 1.00 ahead by 20.0 %"_s);
        QVERIFY(f.chart.accessibleDescription().contains(u"has 20.0 % more"_s));
    }
};

QTEST_MAIN(TestComparisonChart)
#include "tst_comparison_chart.moc"
