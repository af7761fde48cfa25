#include "tests/support/approx.h"
#include "tests/support/mission_builder.h"
#include "widgets/charts/mission_charts.h"
#include "widgets/print/document_chart.h"

#include <QtTest>

#include <array>
#include <cmath>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

constexpr QSizeF kSize_px(1120, 460);

/** Saw teeth of so many icebergs over 1000 s, the later ones the higher at the end. */
TimeChartContent sawTeeth(int lines, int nameLength = 0)
{
    TimeChartContent content;
    content.title = u"Uncertainty of each iceberg"_s;
    content.leftTitle = u"σ, m²"_s;
    content.sigmaFull_m2 = 30;
    for (int i = 0; i < lines; ++i) {
        TimeLine line{.label = u"B%1"_s.arg(i + 1).leftJustified(nameLength, u'x'),
                      .points = {},
                      .role = LineRole::Sigma,
                      .key = QString::number(i)};
        const int seen = 500 + 400 * i / lines;
        for (int t = 0; t <= 1000; ++t)
            line.points.emplace_back(t, 0.025 * (t < seen ? t + i : (t - seen) + i));
        content.lines.push_back(line);
    }
    return content;
}

DocumentChart charted(const TimeChartContent& content, const QSizeF& size_px = kSize_px,
                      const QLocale& locale = QLocale::c())
{
    return documentCharts({&content, 1}, Theme::light(), size_px, locale).front();
}

const ChartStroke& strokeOf(const DocumentChart& chart, const QString& key)
{
    return *std::ranges::find(chart.strokes, key, &ChartStroke::key);
}

/** What the axis says at that height. */
double valueAt(const DocumentChart& chart, const NiceTicks& axis, double y_px)
{
    const QRectF& plot = chart.figure.frame.plot;
    return axis.start() + (axis.end() - axis.start()) * (plot.bottom() - y_px) / plot.height();
}

} // namespace

class TestDocumentChart : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(u".*"_s)); }

    void linesEndAtTheValuesOfTheFlight()
    {
        const Mission mission = flown(fourIcebergs());
        const FlightRecord record = recordOf(mission);
        const DocumentChart chart = charted(zetaContent(record, QLocale::c()));
        QCOMPARE(chart.strokes.size(), std::size_t{2});
        const QPointF zeta = strokeOf(chart, u"zeta_m2s"_s).points.back();
        COMPARE_NEAR(zeta.x(), chart.figure.frame.plot.right(), 1e-6);
        const double zeta_m2s = mission.metrics().zeta_m2s;
        COMPARE_NEAR(valueAt(chart, chart.figure.right, zeta.y()), zeta_m2s, 1e-9 * zeta_m2s);
        const QPointF sum = strokeOf(chart, u"sigma_sum_m2"_s).points.back();
        COMPARE_NEAR(valueAt(chart, chart.figure.left, sum.y()),
                     record.history.samples.back().sigmaSum_m2, 1e-6);
        const TimeChartContent sigma = sigmaContent(record, QLocale::c());
        const DocumentChart each = charted(sigma);
        QCOMPARE(each.strokes.size(), std::size_t{4});
        for (std::size_t i = 0; i < each.strokes.size(); ++i)
            COMPARE_NEAR(valueAt(each, each.figure.left, each.strokes[i].points.back().y()),
                         record.history.rows.back()[i].sigma_m2, 1e-6);
    }

    void linesAreStyledAsInTheWindow()
    {
        const Theme theme = Theme::light();
        TimeChartContent content;
        content.rightTitle = u"Zeta"_s;
        content.lines = {
            {.label = u"Zeta"_s, .points = {}, .role = LineRole::Accumulated, .onRightAxis = true},
            {.label = u"Sum"_s, .points = {}, .role = LineRole::Momentary},
            {.label = u"Weighted"_s, .points = {}, .role = LineRole::Weighted},
            {.label = u"Bound"_s, .points = {}, .role = LineRole::Bound, .onRightAxis = true},
        };
        for (TimeLine& line : content.lines)
            line.points = {{0, 1}, {1000, 20}};
        const std::vector<ChartStroke> strokes = charted(content).strokes;
        QCOMPARE(strokes.size(), std::size_t{4});
        QCOMPARE(strokes[0].pen.color(), theme.accumulated);
        QCOMPARE(strokes[1].pen.color(), theme.momentary);
        QCOMPARE(strokes[2].pen.style(), Qt::DashLine);
        QCOMPARE(strokes[3].pen.color(), theme.mutedText);
        QVERIFY(strokes[0].pen.widthF() > strokes[3].pen.widthF());
        for (std::size_t i = 0; i < strokes.size(); ++i)
            QCOMPARE(strokes[i].area.isValid(), i == 1);
        const TimeChartContent sigmas = sawTeeth(5);
        const std::vector<ChartStroke> lines = charted(sigmas).strokes;
        for (std::size_t i = 0; i < lines.size(); ++i)
            QCOMPARE(lines[i].pen.color(),
                     theme.sigma.colour(sigmas.lines[i].points.back().y(), 30));
    }

    /** The window's chart of this size has the same numbers and names in the same places. */
    void isTheChartOfTheWindow()
    {
        const Mission mission = flown(fourIcebergs());
        const FlightRecord record = recordOf(mission);
        for (const TimeChartContent& content :
             {zetaContent(record, QLocale()), sigmaContent(record, QLocale())}) {
            TimeChart window(Theme::light());
            window.resize(kSize_px.toSize());
            window.show();
            window.setContent(content);
            const DocumentChart chart = charted(content, kSize_px, QLocale());
            QCOMPARE(chart.figure.frame.plot, window.frame().plot);
            QCOMPARE(chart.figure.drawn, window.drawnPoints());
            const std::vector<ChartLabel>& labels = chart.figure.frame.labels;
            QCOMPARE(labels.size(), window.labelRects().size());
            for (std::size_t i = 0; i < labels.size(); ++i)
                QCOMPARE(labels[i].rect, window.labelRects()[i]);
        }
    }

    void labelsAreApartAndOnThePage_data()
    {
        QTest::addColumn<int>("lines");
        QTest::addColumn<int>("nameLength");
        QTest::addColumn<std::size_t>("least"); // named at least
        QTest::newRow("one") << 1 << 0 << std::size_t{1};
        QTest::newRow("12") << 12 << 0 << std::size_t{12};
        QTest::newRow("40") << 40 << 0 << std::size_t{8};
        QTest::newRow("500") << 500 << 0 << std::size_t{4};
        QTest::newRow("long names") << 12 << 200 << std::size_t{12};
    }

    void labelsAreApartAndOnThePage()
    {
        QFETCH(int, lines);
        QFETCH(int, nameLength);
        QFETCH(std::size_t, least);
        const DocumentChart chart = charted(sawTeeth(lines, nameLength));
        const std::vector<ChartLabel>& labels = chart.figure.frame.labels;
        QVERIFY2(labels.size() >= least, QByteArray::number(qsizetype(labels.size())).constData());
        const QRectF page(QPointF(0, 0), kSize_px);
        for (std::size_t i = 0; i < labels.size(); ++i) {
            QVERIFY(page.contains(labels[i].rect));
            QVERIFY(labels[i].rect.left() > chart.figure.frame.plot.right());
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!labels[i].rect.adjusted(0, 0.5, 0, -0.5).intersects(labels[j].rect));
        }
        QVERIFY(chart.figure.frame.plot.width() > 0.6 * kSize_px.width());
    }

    void ticksCoverTheValues()
    {
        const DocumentChart chart = charted(sawTeeth(12));
        const ChartFrame& frame = chart.figure.frame;
        QCOMPARE(frame.left.front().text, u"0"_s);
        QVERIFY(frame.left.back().text.toDouble() >= 0.025 * 900);
        QCOMPARE(frame.left.front().at_px, frame.plot.bottom());
        QCOMPARE(frame.left.back().at_px, frame.plot.top());
        QCOMPARE(frame.times.front().text, u"00:00"_s);
        QCOMPARE(frame.times.back().text, u"16:00"_s);
        for (const ChartStroke& stroke : chart.strokes)
            QVERIFY(frame.plot.adjusted(-1e-6, -1e-6, 1e-6, 1e-6)
                        .contains(stroke.points.boundingRect()));
    }

    void numbersAreOfTheLocale()
    {
        TimeChartContent content = sawTeeth(1);
        for (QPointF& point : content.lines[0].points)
            point.ry() /= 20;
        const std::vector<ChartTick> ticks =
            charted(content, kSize_px, QLocale(QLocale::German)).figure.frame.left;
        QVERIFY(std::ranges::any_of(
            ticks, [](const ChartTick& tick) { return tick.text.contains(u','); }));
    }

    void chartsHaveOneTimeAxis()
    {
        const Mission mission = flown(fourIcebergs());
        const FlightRecord record = recordOf(mission);
        const std::array contents{zetaContent(record, QLocale()), sigmaContent(record, QLocale())};
        const std::vector<DocumentChart> charts =
            documentCharts(contents, Theme::light(), kSize_px, QLocale());
        QCOMPARE(charts.size(), std::size_t{2});
        QCOMPARE(charts[0].figure.frame.plot, charts[1].figure.frame.plot);
        // As wide as the one that needs most beside its plot.
        double narrowest_px = kSize_px.width();
        for (const TimeChartContent& content : contents)
            narrowest_px = std::min(narrowest_px, charted(content).figure.frame.plot.width());
        QVERIFY(charts[0].figure.frame.plot.width() <= narrowest_px);
        QVERIFY(charts[0].figure.frame.plot.width() > 0.9 * narrowest_px);
    }

    void longFlightsAreThinned()
    {
        TimeChartContent content = sawTeeth(1);
        content.duration_s = 1e5;
        content.lines[0].points.clear();
        for (int t = 0; t <= 100000; ++t)
            content.lines[0].points.emplace_back(t, std::abs(std::sin(t)));
        const DocumentChart chart = charted(content);
        QVERIFY(chart.strokes[0].points.size() <= 2 * 1120);
        QVERIFY(chart.strokes[0].points.size() >= 1120 / 2);
        QCOMPARE(chart.figure.frame.timeTitle, u"Time, h:mm:ss"_s);
    }

    void manyLinesAreThinAndFaint()
    {
        TimeChartContent content = sawTeeth(500);
        for (TimeLine& line : content.lines) // many visits
            for (QPointF& point : line.points)
                point.setY(std::fmod(point.y() * 37, 20.0));
        const DocumentChart chart = charted(content);
        for (const ChartStroke& stroke : chart.strokes) {
            QCOMPARE(stroke.pen.widthF(), 1.0);
            QVERIFY(stroke.pen.color().alphaF() < 0.5F);
        }
        QVERIFY(charted(sawTeeth(12)).strokes[0].pen.widthF() > 1);
    }

    void emptyChartSaysSo()
    {
        TimeChartContent content;
        content.emptyText = u"Nothing was flown"_s;
        content.duration_s = 0;
        const DocumentChart chart = charted(content);
        QVERIFY(chart.strokes.empty());
        QCOMPARE(chart.figure.frame.emptyText, u"Nothing was flown"_s);
    }

    void painterIsLeftAsItWas()
    {
        QImage image(kSize_px.toSize(), QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        const QTransform before = painter.transform();
        const QPen pen = painter.pen();
        paintDocumentChart(painter, {0, 0}, charted(sawTeeth(4)), Theme::light());
        QCOMPARE(painter.transform(), before);
        QCOMPARE(painter.pen(), pen);
        QVERIFY(!image.allGray());
    }
};

QTEST_MAIN(TestDocumentChart)
#include "tst_document_chart.moc"
