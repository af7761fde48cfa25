#include "tests/support/approx.h"
#include "tests/support/flight/mission_builder.h"
#include "widgets/charts/figure_painter.h"
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

TimeFigure charted(const TimeChartContent& content, const QSizeF& size_px = kSize_px,
                   const QLocale& locale = QLocale::c())
{
    return documentCharts({&content, 1}, Theme::light(), size_px, locale).front();
}

/** The lines of the content that have points. */
std::vector<DrawnLine> strokesOf(const TimeFigure& chart)
{
    std::vector<DrawnLine> strokes;
    for (const DrawnLine& line : chart.drawing.lines)
        if (!line.points.empty())
            strokes.push_back(line);
    return strokes;
}

DrawnLine strokeOf(const TimeFigure& chart, const std::string& key)
{
    return *std::ranges::find(chart.drawing.lines, key, &DrawnLine::key);
}

/** Value of the axis at that height. */
double valueAt(const TimeFigure& chart, const PlotScale& axis, double y_px)
{
    const PixelRect& plot = chart.drawing.plot;
    return axis.from + (axis.to - axis.from) * (plot.bottom - y_px) / plot.height();
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
        const TimeFigure chart = charted(missionChart(ChartKind::Zeta, record, QLocale::c()));
        QCOMPARE(strokesOf(chart).size(), std::size_t{2});
        const Pixel zeta = strokeOf(chart, "zeta_m2s").points.back();
        COMPARE_NEAR(zeta.x, chart.drawing.plot.right, 1e-6);
        const double zeta_m2s = mission.metrics().zeta_m2s;
        COMPARE_NEAR(valueAt(chart, chart.drawing.right, zeta.y), zeta_m2s, 1e-9 * zeta_m2s);
        const Pixel sum = strokeOf(chart, "sigma_sum_m2").points.back();
        COMPARE_NEAR(valueAt(chart, chart.drawing.y, sum.y),
                     record.history.samples.back().sigmaSum_m2, 1e-6);
        const TimeChartContent sigma = missionChart(ChartKind::Sigma, record, QLocale::c());
        const TimeFigure each = charted(sigma);
        QCOMPARE(strokesOf(each).size(), std::size_t{4});
        for (std::size_t i = 0; i < strokesOf(each).size(); ++i)
            COMPARE_NEAR(valueAt(each, each.drawing.y, strokesOf(each)[i].points.back().y),
                         record.history.rows.back()[i].sigma_m2, 1e-6);
    }

    void linesAreStyledAsInTheWindow()
    {
        const Theme theme = Theme::light();
        TimeChartContent content;
        content.rightTitle = u"Zeta, %1"_s;
        content.lines = {
            {.label = u"Zeta"_s, .points = {}, .role = LineRole::Accumulated, .onRightAxis = true},
            {.label = u"Sum"_s, .points = {}, .role = LineRole::Momentary},
            {.label = u"Weighted"_s, .points = {}, .role = LineRole::Weighted},
            {.label = u"Bound"_s, .points = {}, .role = LineRole::Bound, .onRightAxis = true},
        };
        for (TimeLine& line : content.lines)
            line.points = {{0, 1}, {1000, 20}};
        const TimeFigure chart = charted(content);
        const std::vector<DrawnLine>& strokes = chart.drawing.lines;
        const auto colourOf = [&theme](const DrawnLine& line) {
            return inkColour(line.ink, theme);
        };
        QCOMPARE(strokes.size(), std::size_t{4});
        QCOMPARE(colourOf(strokes[0]), theme.accumulated);
        QCOMPARE(colourOf(strokes[1]), theme.momentary);
        QVERIFY(!strokes[2].dash_px.empty());
        QCOMPARE(colourOf(strokes[3]), theme.mutedText);
        QVERIFY(strokes[0].width_px > strokes[3].width_px);
        QCOMPARE(chart.drawing.areas.size(), std::size_t{1}); // below the sum
        const TimeChartContent sigmas = sawTeeth(5);
        const std::vector<DrawnLine> lines = strokesOf(charted(sigmas));
        for (std::size_t i = 0; i < lines.size(); ++i)
            QCOMPARE(colourOf(lines[i]), theme.sigma.colour(sigmas.lines[i].points.back().y(), 30));
    }

    /** The window's chart of this size has the same numbers and names in the same places. */
    void isTheChartOfTheWindow()
    {
        const Mission mission = flown(fourIcebergs());
        const FlightRecord record = recordOf(mission);
        for (const TimeChartContent& content :
             {missionChart(ChartKind::Zeta, record, QLocale()),
              missionChart(ChartKind::Sigma, record, QLocale())}) {
            TimeChart window(Theme::light());
            window.resize(kSize_px.toSize());
            window.show();
            window.setContent(content);
            const TimeFigure chart = charted(content, kSize_px, QLocale());
            QCOMPARE(toQt(chart.drawing.plot), window.plot());
            QCOMPARE(chart.drawn, window.drawnPoints());
            const std::vector<DrawnLabel>& labels = chart.drawing.labels;
            QCOMPARE(labels.size(), window.drawing().labels.size());
            for (std::size_t i = 0; i < labels.size(); ++i)
                QCOMPARE(toQt(labels[i].rect), toQt(window.drawing().labels[i].rect));
        }
    }

    void labelsAreOnThePageWithoutOverlap_data()
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

    void labelsAreOnThePageWithoutOverlap()
    {
        QFETCH(int, lines);
        QFETCH(int, nameLength);
        QFETCH(std::size_t, least);
        const TimeFigure chart = charted(sawTeeth(lines, nameLength));
        const std::vector<DrawnLabel>& labels = chart.drawing.labels;
        QVERIFY2(labels.size() >= least, QByteArray::number(qsizetype(labels.size())).constData());
        const QRectF page(QPointF(0, 0), kSize_px);
        for (std::size_t i = 0; i < labels.size(); ++i) {
            QVERIFY(page.contains(toQt(labels[i].rect)));
            QVERIFY(labels[i].rect.left > chart.drawing.plot.right);
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!toQt(labels[i].rect)
                             .adjusted(0, 0.5, 0, -0.5)
                             .intersects(toQt(labels[j].rect)));
        }
        QVERIFY(chart.drawing.plot.width() > 0.6 * kSize_px.width());
    }

    void ticksCoverTheValues()
    {
        const TimeFigure chart = charted(sawTeeth(12));
        const Drawing& drawing = chart.drawing;
        const auto textOf = [](const DrawnTick& tick) { return QString::fromStdString(tick.text); };
        QCOMPARE(textOf(drawing.yTicks.front()), u"0"_s);
        QVERIFY(textOf(drawing.yTicks.back()).toDouble() >= 0.025 * 900);
        QCOMPARE(drawing.yTicks.front().at_px, drawing.plot.bottom);
        QCOMPARE(drawing.yTicks.back().at_px, drawing.plot.top);
        QCOMPARE(textOf(drawing.xTicks.front()), u"00:00"_s);
        QCOMPARE(textOf(drawing.xTicks.back()), u"16:00"_s);
        const QRectF plot = toQt(drawing.plot).adjusted(-1e-6, -1e-6, 1e-6, 1e-6);
        for (const DrawnLine& stroke : drawing.lines)
            for (const Pixel& point : stroke.points)
                QVERIFY(plot.contains(toQt(point)));
    }

    void numbersAreOfTheLocale()
    {
        TimeChartContent content = sawTeeth(1);
        for (QPointF& point : content.lines[0].points)
            point.ry() /= 20;
        const std::vector<DrawnTick> ticks =
            charted(content, kSize_px, QLocale(QLocale::German)).drawing.yTicks;
        QVERIFY(std::ranges::any_of(
            ticks, [](const DrawnTick& tick) { return tick.text.find(',') != std::string::npos; }));
    }

    void chartsHaveOneTimeAxis()
    {
        const Mission mission = flown(fourIcebergs());
        const FlightRecord record = recordOf(mission);
        const std::array contents{missionChart(ChartKind::Zeta, record, QLocale()),
                                  missionChart(ChartKind::Sigma, record, QLocale())};
        const std::vector<TimeFigure> charts =
            documentCharts(contents, Theme::light(), kSize_px, QLocale());
        QCOMPARE(charts.size(), std::size_t{2});
        QCOMPARE(toQt(charts[0].drawing.plot), toQt(charts[1].drawing.plot));
        // All plots leave the width that the widest axis needs.
        double narrowest_px = kSize_px.width();
        for (const TimeChartContent& content : contents)
            narrowest_px = std::min(narrowest_px, charted(content).drawing.plot.width());
        QVERIFY(charts[0].drawing.plot.width() <= narrowest_px);
        QVERIFY(charts[0].drawing.plot.width() > 0.9 * narrowest_px);
    }

    void longFlightsAreThinned()
    {
        TimeChartContent content = sawTeeth(1);
        content.duration_s = 1e5;
        content.lines[0].points.clear();
        for (int t = 0; t <= 100000; ++t)
            content.lines[0].points.emplace_back(t, std::abs(std::sin(t)));
        const TimeFigure chart = charted(content);
        QVERIFY(chart.drawing.lines[0].points.size() <= 2 * 1120);
        QVERIFY(chart.drawing.lines[0].points.size() >= 1120 / 2);
        QCOMPARE(QString::fromStdString(chart.figure.x.title), u"Time, h:mm:ss"_s);
    }

    void manyLinesAreThinAndFaint()
    {
        TimeChartContent content = sawTeeth(500);
        for (TimeLine& line : content.lines) // many visits
            for (QPointF& point : line.points)
                point.setY(std::fmod(point.y() * 37, 20.0));
        const TimeFigure chart = charted(content);
        for (const DrawnLine& stroke : chart.drawing.lines) {
            QCOMPARE(stroke.width_px, 1.0);
            QVERIFY(stroke.ink.strength < 0.5);
        }
        QVERIFY(charted(sawTeeth(12)).drawing.lines[0].width_px > 1);
    }

    void emptyChartSaysSo()
    {
        TimeChartContent content;
        content.emptyText = u"Nothing was flown"_s;
        content.duration_s = 0;
        const TimeFigure chart = charted(content);
        QVERIFY(strokesOf(chart).empty());
        QCOMPARE(QString::fromStdString(chart.drawing.texts.back().text), u"Nothing was flown"_s);
    }

    void painterIsLeftAsItWas()
    {
        QImage image(kSize_px.toSize(), QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        const QTransform before = painter.transform();
        const QPen pen = painter.pen();
        paintDrawing(painter, charted(sawTeeth(4)).drawing, Theme::light());
        QCOMPARE(painter.transform(), before);
        QCOMPARE(painter.pen(), pen);
        QVERIFY(!image.allGray());
    }
};

QTEST_MAIN(TestDocumentChart)
#include "tst_document_chart.moc"
