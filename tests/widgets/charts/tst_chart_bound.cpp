#include "core/io/text/atomic_file.h"
#include "tests/support/approx.h"
#include "tests/support/window/chart_panel_fixture.h"
#include "widgets/charts/mission_series.h"

#include <QtTest>

using namespace berg;
using namespace Qt::StringLiterals;
using namespace berg::test;

namespace {

/** A bound over twice the time of the flight, in blocks of half a second. */
KnownBound boundOf2000s()
{
    ZetaBound bound{.zeta_m2s = 12000, .curve = {}};
    for (int k = 0; k <= 4000; ++k)
        bound.curve.push_back({.time_s = 0.5 * k, .sigma_m2 = 6, .zeta_m2s = 3.0 * k});
    return {.zeta_m2s = 12000, .share = 1, .whole = std::make_shared<const ZetaBound>(bound)};
}

} // namespace

/** The lower bound in the chart of zeta. */
class TestChartBound : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void knownBoundIsShown()
    {
        Shown shown(ChartKind::Zeta);
        shown.record.bound = boundOf2000s(); // comes while nothing else changes
        shown.panel.showRecord(shown.record);
        const std::vector<TimeLine>& lines = shown.chart.content().lines;
        QCOMPARE(lines.size(), std::size_t{3});
        QCOMPARE(lines[2].label, u"Lower bound on ζ"_s);
        QCOMPARE(lines[2].key, u"zeta_bound_m2s"_s);
        const QList<QPointF>& drawn = shown.chart.drawnPoints()[2];
        COMPARE_NEAR(drawn.front().y(), 0, 1e-9);
        COMPARE_NEAR(drawn.back().x(), 1000, 1e-9); // as far as was flown
        COMPARE_NEAR(drawn.back().y(), 6000, 1e-6);
        QVERIFY(child<QMenu>(shown.panel, u"chartLinesMenu"_s)
                    .findChild<QAction*>(u"zeta_bound_m2s"_s) != nullptr);
        QVERIFY(missionChart(ChartKind::MeanSigma, shown.record, QLocale::c()).lines.size() == 2);
    }

    void boundIsReadOutAtTheCursor()
    {
        Shown shown(ChartKind::Zeta);
        shown.record.bound = boundOf2000s();
        shown.record.instant = shown.record.now;
        shown.record.instant->time_s = 500.25; // between two points
        shown.panel.showRecord(shown.record);
        QStringList read;
        for (const ReadoutFlag& flag : shown.chart.readout().flags)
            read << flag.text;
        QVERIFY2(read.contains(u"Lower bound on ζ 3\u202f002 m² s"_s),
                 qPrintable(read.join(u'\n')));
    }

    /** The unit is that of the rest of the window. */
    void largeZetaIsInSquareKilometres()
    {
        TimeChartContent content;
        content.rightTitle = u"Zeta, %1"_s;
        content.lines = {{.label = u"Zeta"_s,
                          .points = {{0, 0}, {1000, 4e6}},
                          .role = LineRole::Accumulated,
                          .onRightAxis = true,
                          .unit = u"m² s"_s}};
        content.cursor_s = 500;
        TimeChart chart(Theme::light());
        chart.setLocale(QLocale::c());
        chart.resize(600, 300);
        chart.show();
        chart.setContent(content);
        QCOMPARE(chart.drawing().rightTitle, std::string("Zeta, km² s"));
        for (const DrawnTick& tick : chart.drawing().rightTicks)
            QVERIFY2(tick.text.size() <= 3, tick.text.c_str()); // "4", not "4 000 000"
        QCOMPARE(chart.readout().flags.front().text, u"Zeta 2.000 km² s"_s);
        content.lines[0].points.back().setY(4e5);
        chart.setContent(content);
        QCOMPARE(chart.drawing().rightTitle, std::string("Zeta, m² s"));
    }

    void boundIsInTheTable()
    {
        Shown shown(ChartKind::Zeta);
        shown.record.bound = boundOf2000s();
        shown.panel.showRecord(shown.record);
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"zeta.csv"_s);
        shown.panel.exportChart(path);
        const std::vector<std::string> lines = linesOf(readFile(path.toStdString()));
        QCOMPARE(lines[0], std::string("time_s,zeta_m2s,sigma_sum_m2,zeta_bound_m2s"));
        QVERIFY(lines[1].ends_with(",0"));
        QVERIFY(lines[501].ends_with(",3000"));
        QVERIFY(lines[1001].ends_with(",6000"));
    }

    /** A bound with few blocks has values between them, too. */
    void boundIsInTheValuesOfEachRow()
    {
        Shown shown(ChartKind::Zeta);
        KnownBound bound = boundOf2000s();
        ZetaBound coarse = *bound.whole;
        coarse.curve = {coarse.curve.front(), coarse.curve[2000], coarse.curve.back()};
        bound.whole = std::make_shared<const ZetaBound>(coarse);
        shown.record.bound = bound;
        MissionSeries series(ChartKind::Zeta);
        const TimeChartContent content = emptyChart(ChartKind::Zeta, shown.record, QLocale::c());
        series.update(shown.record, content.lines.size());
        const CellSheet values = series.values(content, QLocale::c());
        QVERIFY(values.rows > 10);
        for (int row = 0; row < values.rows; ++row)
            QVERIFY(!values.columns[3].text(row).isEmpty());
    }

    void boundOfAnotherFlightIsNotShown_data()
    {
        QTest::addColumn<MissionEvent>("event");
        QTest::addColumn<int>("lines");
        const auto row = [](const char* name, const MissionEvent& event, int lines) {
            QTest::newRow(name) << event << lines;
        };
        row("reported seen",
            {.kind = EventKind::Sighted, .iceberg = IcebergIndex(0), .reported = true}, 2);
        row("wind changed", {.kind = EventKind::Intervention, .changed = ChangedPart::Wind}, 2);
        row("seen by the UAV", {.kind = EventKind::Sighted, .iceberg = IcebergIndex(0)}, 3);
        row("asset changed", {.kind = EventKind::Intervention, .changed = ChangedPart::Asset}, 3);
        row("iceberg added", {.kind = EventKind::Appeared, .iceberg = IcebergIndex(0)}, 3);
    }

    void boundOfAnotherFlightIsNotShown()
    {
        QFETCH(MissionEvent, event);
        QFETCH(int, lines);
        Shown shown(ChartKind::Zeta);
        shown.record.bound = boundOf2000s();
        shown.panel.showRecord(shown.record);
        QCOMPARE(shown.chart.content().lines.size(), std::size_t{3});
        event.time_s = 1000;
        shown.record.history.events.push_back(event);
        shown.panel.showRecord(shown.record);
        QCOMPARE(static_cast<int>(shown.chart.content().lines.size()), lines);
    }
};

QTEST_MAIN(TestChartBound)
#include "tst_chart_bound.moc"
