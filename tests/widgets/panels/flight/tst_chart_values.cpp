#include "tests/support/window/chart_panel_fixture.h"
#include "tests/support/window/patience.h"
#include "widgets/charts/figure_painter.h"

#include <QTableView>
#include <QtTest>

using namespace berg;
using namespace Qt::StringLiterals;
using test::child;
using test::Shown;

/** The table of values beside a chart over time. */
class TestChartValues : public QObject
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

    /** The table shows every line with and without a pointer, in a row each, beside the plot. */
    void valuesStandBesideThePlot()
    {
        QFETCH(ChartKind, kind);
        QFETCH(QSize, size);
        Shown shown(kind, size);
        const std::vector<TimeLine>& lines = shown.chart.content().lines;
        auto& table = child<QTableView>(shown.panel, u"lineValues"_s);
        const auto valueIn = [&table](int row) {
            return table.model()->index(row, 1).data().toString();
        };
        QTRY_COMPARE(shown.chart.width() + table.width(), size.width());
        QVERIFY(shown.chart.geometry().right() < table.geometry().left());
        QVERIFY(shown.panel.rect().contains(table.geometry()));
        QCOMPARE(table.model()->rowCount(), static_cast<int>(lines.size()));
        QStringList newest;
        for (int row = 0; row < table.model()->rowCount(); ++row) {
            QCOMPARE(table.model()->index(row, 0).data().toString(),
                     lines[static_cast<std::size_t>(row)].shownName());
            QVERIFY(!valueIn(row).isEmpty());
            newest << valueIn(row);
        }
        QVERIFY(shown.chart.readout().time.isEmpty());
        const QPointF at = shown.chart.plot().center();
        QMouseEvent move(QEvent::MouseMove, at, shown.chart.mapToGlobal(at), Qt::NoButton, {}, {});
        QCoreApplication::sendEvent(shown.chart.viewport(), &move);
        QCOMPARE(shown.chart.readout().time, u"08:20"_s);
        for (int row = 0; row < table.model()->rowCount(); ++row)
            QVERIFY(!valueIn(row).isEmpty());
        QVERIFY(valueIn(0) != newest[0]);
        QVERIFY(shown.chart.plot().width() > 0.4 * size.width());
    }

    void narrowPanelHasNoTable()
    {
        Shown shown(ChartKind::Sigma, {400, 260});
        QVERIFY(!child<QTableView>(shown.panel, u"lineValues"_s).isVisible());
        QVERIFY(!shown.chart.drawing().labels.empty()); // names are at the lines
        shown.panel.resize(600, 260);
        QVERIFY(child<QTableView>(shown.panel, u"lineValues"_s).isVisible());
        QVERIFY(shown.chart.drawing().labels.empty());
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

QTEST_MAIN(TestChartValues)
#include "tst_chart_values.moc"
