#include "tests/support/window/chart_panel_fixture.h"
#include "widgets/charts/figure_painter.h"

#include <QtTest>

using namespace berg;
using namespace Qt::StringLiterals;
using test::child;
using test::Shown;

/** The column of values beside the plot of a chart over time, and flags without one. */
class TestTimeChartColumn : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void valuesStandBesideThePlot_data()
    {
        QTest::addColumn<ChartKind>("kind");
        QTest::addColumn<QSize>("size");
        for (const QSize& size : {QSize(468, 200), QSize(490, 200), QSize(900, 260)}) {
            QTest::addRow("zeta, %d", size.width()) << ChartKind::Zeta << size;
            QTest::addRow("sigma, %d", size.width()) << ChartKind::Sigma << size;
        }
    }

    /** The column shows every line with and without a pointer, and covers no curve. */
    void valuesStandBesideThePlot()
    {
        QFETCH(ChartKind, kind);
        QFETCH(QSize, size);
        Shown shown(kind, size);
        const std::size_t lines = shown.chart.content().lines.size();
        const auto check = [&](const char* state) {
            const ChartReadout readout = shown.chart.readout();
            QVERIFY2(readout.flags.size() == lines && readout.more == 0, state);
            for (const ReadoutFlag& row : readout.flags) {
                QVERIFY2(row.rect.left() > shown.chart.plot().right(), state);
                QVERIFY2(QRectF(shown.chart.rect()).contains(row.rect), state);
                QVERIFY2(!row.value.isEmpty() && !row.name.isEmpty(), state);
            }
        };
        check("newest");
        QVERIFY(shown.chart.readout().time.isEmpty());
        const QPointF at = shown.chart.plot().center();
        QMouseEvent move(QEvent::MouseMove, at, shown.chart.mapToGlobal(at), Qt::NoButton, {}, {});
        QCoreApplication::sendEvent(shown.chart.viewport(), &move);
        check("at the pointer");
        QCOMPARE(shown.chart.readout().time, u"08:20"_s);
        QVERIFY(shown.chart.plot().width() > 0.4 * size.width());
    }

    /** If there are too many lines, the last row shows the number of hidden ones. */
    void columnIsNotTooLong()
    {
        const FlightRecord record =
            test::syntheticRecord({.icebergs = 60, .duration_s = 1000, .interval_s = 10}, 1000);
        ChartPanel panel(ChartKind::Sigma, Theme::light());
        panel.resize(480, 200);
        panel.show();
        panel.showRecord(record);
        const ChartReadout readout = child<TimeChart>(panel, u"timeChart"_s).readout();
        QVERIFY(readout.more > 0);
        QCOMPARE(readout.flags.size() + readout.more, std::size_t{60});
    }

    void emptyTextHasTheWholeChart_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("smallest") << QSize(120, 80);
        QTest::newRow("usual") << QSize(600, 300);
    }

    /** The plot of a low chart is too low for it, and axes of nothing say nothing. */
    void emptyTextHasTheWholeChart()
    {
        QFETCH(QSize, size);
        TimeChartContent content;
        content.leftTitle = u"ζ, m² s"_s;
        content.lines = {{.label = u"ζ"_s, .points = {}}};
        content.emptyText = u"Nothing flown yet"_s;
        TimeChart chart(Theme::light());
        chart.resize(size);
        chart.show();
        chart.setContent(content);
        const Drawing& drawing = chart.drawing();
        QCOMPARE(drawing.texts.size(), std::size_t{1});
        QCOMPARE(drawing.texts[0].text, std::string("Nothing flown yet"));
        QCOMPARE(toQt(drawing.texts[0].rect), QRectF(QPointF(0, 0), chart.viewport()->size()));
        const QImage image = chart.grab().toImage();
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                QVERIFY(image.pixel(x, y) != Theme::light().chartGrid.rgb());
        content.lines[0].points = {{0, 0}, {1000, 80}};
        chart.setContent(content);
        QVERIFY(!chart.drawing().grid.empty());
    }
};

QTEST_MAIN(TestTimeChartColumn)
#include "tst_time_chart_column.moc"
