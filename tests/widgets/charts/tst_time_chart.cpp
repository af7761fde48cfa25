#include "tests/support/approx.h"
#include "widgets/charts/chart_image.h"
#include "widgets/charts/figure_painter.h"
#include "widgets/charts/time_chart.h"
#include "widgets/theme/typed_quantity.h"

#include <QChart>
#include <QLineSeries>
#include <QMouseEvent>
#include <QWheelEvent>
#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** Saw teeth of `lines` icebergs over 1000 s. */
TimeChartContent sawTeeth(int lines)
{
    TimeChartContent content;
    content.title = u"Uncertainty of each iceberg"_s;
    content.leftTitle = u"σ, m²"_s;
    content.sigmaFull_m2 = 30;
    for (int i = 0; i < lines; ++i) {
        TimeLine line{.label = u"B%1"_s.arg(i + 1), .points = {}, .role = LineRole::Sigma};
        for (int t = 0; t <= 1000; ++t)
            line.points.emplace_back(t, 0.025 * ((t + 83 * i) % 1000));
        content.lines.push_back(line);
    }
    return content;
}

TimeChartContent zetaAndSum()
{
    TimeChartContent content;
    content.title = u"Uncertainty now and accumulated"_s;
    content.leftTitle = u"Sum of σ, m²"_s;
    content.rightTitle = u"Zeta, %1"_s;
    TimeLine zeta{
        .label = u"Zeta"_s, .points = {}, .role = LineRole::Accumulated, .onRightAxis = true};
    TimeLine sum{.label = u"Sum of σ"_s, .points = {}, .role = LineRole::Momentary};
    for (int t = 0; t <= 1000; ++t) {
        sum.points.emplace_back(t, 80 + 20 * std::sin(0.03 * t));
        zeta.points.emplace_back(t, 82.0 * t);
    }
    content.lines = {zeta, sum};
    content.marks_s = {100, 300, 650};
    content.marksTitle = u"iceberg reached"_s;
    return content;
}

bool hasColour(const QImage& image, const QColor& colour)
{
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (image.pixelColor(x, y).rgb() == colour.rgb())
                return true;
    return false;
}

void moveMouse(const TimeChart& chart, const QPoint& to, Qt::MouseButton held)
{
    QMouseEvent event(QEvent::MouseMove, QPointF(to), QPointF(chart.mapToGlobal(to)), Qt::NoButton,
                      held == Qt::NoButton ? Qt::MouseButtons() : Qt::MouseButtons(held),
                      Qt::NoModifier);
    QCoreApplication::sendEvent(chart.viewport(), &event);
}

void turnWheel(const TimeChart& chart, const QPointF& at, int notches)
{
    QWheelEvent event(at, chart.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(chart.viewport(), &event);
}

} // namespace

class TestTimeChart : public QObject
{
    Q_OBJECT

private slots:
    void linesAreDecimatedToThePixels()
    {
        TimeChartContent content = zetaAndSum();
        for (TimeLine& line : content.lines) {
            line.points.clear();
            for (int i = 0; i < 100000; ++i)
                line.points.emplace_back(0.01 * i, std::abs(std::sin(i)));
        }
        TimeChart chart(Theme::light());
        chart.resize(900, 400);
        chart.show();
        chart.setContent(content);
        for (const QList<QPointF>& points : chart.drawnPoints()) {
            QVERIFY(points.size() <= 2 * 900);
            QVERIFY(points.size() >= 900); // and no coarser than the pixels
            QCOMPARE(points.front(), content.lines[0].points.front());
            QCOMPARE(points.back(), content.lines[0].points.back());
        }
    }

    void contentCanBeReplaced()
    {
        TimeChart chart(Theme::dark());
        chart.resize(900, 400);
        chart.show();
        chart.setContent(sawTeeth(12));
        QCOMPARE(chart.drawnPoints().size(), std::size_t{12});
        chart.setContent(zetaAndSum());
        QCOMPARE(chart.drawnPoints().size(), std::size_t{2});
        QCOMPARE(chart.drawing().labels.size(), std::size_t{2});
        QCOMPARE(chart.accessibleName(), u"Uncertainty now and accumulated"_s);
    }

    /** Each line takes Qt Charts a moment: of hundreds a part at a time, and all of them soon. */
    void manyLinesCome()
    {
        TimeChart chart(Theme::dark());
        chart.resize(900, 400);
        chart.show();
        const auto withPoints = [&chart] {
            const QList<QAbstractSeries*> all = chart.chart()->series();
            return std::ranges::count_if(all, [](QAbstractSeries* series) {
                const auto* line = qobject_cast<QLineSeries*>(series);
                return line != nullptr && line->count() > 0;
            });
        };
        chart.setContent(sawTeeth(450));
        QVERIFY(withPoints() > 0);
        QVERIFY(withPoints() <= 150);
        QVERIFY(QTest::qWaitFor([&] { return withPoints() == 450; }));
        QCOMPARE(chart.chart()->series().size(), 450);
        chart.setContent(sawTeeth(430)); // existing series are reused
        QCOMPARE(withPoints(), 430);
        chart.setContent(zetaAndSum());
        QCOMPARE(chart.chart()->series().size(), 3); // with an area
        chart.setContent(sawTeeth(450));
        chart.setContent(zetaAndSum()); // before all have come
        QTest::qWait(50);
        QCOMPARE(chart.chart()->series().size(), 3);
    }

    void labelsAreInsideWithoutOverlap_data()
    {
        QTest::addColumn<int>("lines");
        QTest::addColumn<QSize>("size");
        for (const int lines : {0, 1, 4, 12, 20, 40})
            for (const QSize& size : {QSize(900, 400), QSize(1280, 800), QSize(300, 160)})
                QTest::addRow("%d lines, %dx%d", lines, size.width(), size.height())
                    << lines << size;
    }

    void labelsAreInsideWithoutOverlap()
    {
        QFETCH(int, lines);
        QFETCH(QSize, size);
        TimeChart chart(Theme::light());
        chart.resize(size);
        chart.show();
        chart.setContent(lines == 0 ? zetaAndSum() : sawTeeth(lines));
        std::vector<QRectF> rects;
        for (const DrawnLabel& label : chart.drawing().labels)
            rects.push_back(toQt(label.rect));
        const QRectF view(QPointF(0, 0), QSizeF(size));
        for (std::size_t i = 0; i < rects.size(); ++i) {
            QVERIFY(view.contains(rects[i]));
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!rects[i].adjusted(0, 0.5, 0, -0.5).intersects(rects[j]));
        }
        if (lines > 0 && lines <= 12 && size.height() >= 400)
            QCOMPARE(rects.size(), static_cast<std::size_t>(lines));
    }

    void imagesHaveTheColoursOfTheTheme_data()
    {
        QTest::addColumn<bool>("isDark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }

    void imagesHaveTheColoursOfTheTheme()
    {
        QFETCH(bool, isDark);
        const Theme theme = isDark ? Theme::dark() : Theme::light();
        const QImage image = chartImage(zetaAndSum(), theme, {1000, 440}, 1);
        QCOMPARE(image.size(), QSize(1000, 440));
        QCOMPARE(image.pixelColor(0, 0).rgb(), theme.chart.rgb()); // no frame
        QCOMPARE(image.pixelColor(999, 439).rgb(), theme.chart.rgb());
        QVERIFY(hasColour(image, theme.accumulated));
        QVERIFY(hasColour(image, theme.momentary));
    }

    void changingTheThemeChangesEverything()
    {
        TimeChart chart(Theme::light());
        chart.resize(600, 300);
        chart.show();
        chart.setContent(zetaAndSum());
        const Theme dark = Theme::dark();
        chart.setTheme(dark);
        const QImage image = chart.grab().toImage();
        QCOMPARE(image.pixelColor(0, 0).rgb(), dark.chart.rgb());
        QVERIFY(!hasColour(image, Qt::white));
    }

    /** The grid has to reach the far end of the plot, also after a change of size. */
    void gridSpansThePlot()
    {
        const Theme theme = Theme::light();
        TimeChartContent content = zetaAndSum();
        content.lines[1].points = {{0, 0}, {1000, 80}}; // leaves the upper right free
        content.lines[0].points = {{0, 0}, {1000, 8000}};
        const QImage image = chartImage(content, theme, {1400, 600}, 1);
        int gridPixels = 0;
        for (int y = 60; y < 300; ++y)
            gridPixels += image.pixelColor(1200, y).rgb() == theme.chart.rgb() ? 0 : 1;
        QVERIFY2(gridPixels >= 4, QByteArray::number(gridPixels).constData());
    }

    /** Many lines are made in turns of the event loop, which a picture has none of. */
    void pictureHasEveryLine()
    {
        TimeChartContent content = zetaAndSum();
        content.lines.resize(1);
        content.lines.front().points = {{0, 0}, {1000, 1}};
        content.lines.resize(150, content.lines.front());
        content.lines.back().points = {{0, 0}, {1000, 100}};
        const QImage with = chartImage(content, Theme::light(), {800, 400}, 1);
        content.lines.back().points = {{1000, 100}}; // the axis stays
        QVERIFY(chartImage(content, Theme::light(), {800, 400}, 1) != with);
    }

    void emptyChartSaysSo()
    {
        TimeChartContent content = zetaAndSum();
        const Theme theme = Theme::light();
        for (TimeLine& line : content.lines)
            line.points.clear();
        const QImage without = chartImage(content, theme, {800, 400}, 1);
        content.emptyText = u"Nothing flown yet"_s;
        const QImage with = chartImage(content, theme, {800, 400}, 1);
        QVERIFY(with != without);
    }

    void negativeValuesAreShown()
    {
        TimeChartContent content;
        TimeLine line{.label = u"Turn rate"_s, .points = {}, .role = LineRole::Signed};
        for (int t = 0; t <= 1000; ++t)
            line.points.emplace_back(t, 12 * std::sin(0.02 * t));
        content.lines = {line};
        content.references = {{.value = 12, .label = u"Limit"_s}, {.value = -12, .label = {}}};
        TimeChart chart(Theme::light());
        chart.resize(600, 300);
        chart.show();
        chart.setContent(content);
        const Drawing& drawing = chart.drawing();
        const std::vector<DrawnTick>& ticks = drawing.yTicks;
        QVERIFY(QString::fromStdString(ticks.front().text).startsWith(QLocale().negativeSign()));
        QVERIFY(std::any_of(ticks.begin(), ticks.end(),
                            [](const DrawnTick& tick) { return tick.text == "0"; }));
        QVERIFY(drawing.over[0].points[0].y < drawing.over[1].points[0].y); // the limits
        for (const DrawnLine& limit : drawing.over)
            QVERIFY(drawing.plot.top <= limit.points[0].y &&
                    limit.points[0].y <= drawing.plot.bottom);
        QVERIFY(hasColour(chart.grab().toImage(), Theme::light().momentary));
    }

    void wheelZoomsAtThePointer()
    {
        TimeChart chart(Theme::light());
        chart.resize(600, 300);
        chart.show();
        chart.setContent(zetaAndSum());
        const QSignalSpy changed(&chart, &TimeChart::windowChanged);
        const QRectF plot = chart.plot();
        const QPointF pointer(plot.left() + 0.25 * plot.width(), plot.center().y());
        turnWheel(chart, pointer, 3);
        QCOMPARE(changed.count(), 1);
        QVERIFY(chart.isZoomed());
        COMPARE_NEAR(chart.window().length_s(), 1000 / std::pow(1.25, 3), 1e-6);
        // 250 s is still at the pointer; the plot may have moved as numbers got narrower.
        COMPARE_NEAR((250 - chart.window().from_s) / chart.window().length_s(), 0.25, 1e-6);
        // Only what is in view is drawn, up to its edges.
        for (const QList<QPointF>& points : chart.drawnPoints()) {
            COMPARE_NEAR(points.front().x(), chart.window().from_s, 1e-9);
            COMPARE_NEAR(points.back().x(), chart.window().to_s, 1e-9);
        }
        turnWheel(chart, pointer, -9);
        QVERIFY(!chart.isZoomed());
    }

    void dragWithTheRightButtonPans_data()
    {
        QTest::addColumn<int>("button");
        QTest::addColumn<int>("modifier");
        QTest::newRow("right") << int(Qt::RightButton) << int(Qt::NoModifier);
        QTest::newRow("middle") << int(Qt::MiddleButton) << int(Qt::NoModifier);
        QTest::newRow("left with Shift") << int(Qt::LeftButton) << int(Qt::ShiftModifier);
    }

    void dragWithTheRightButtonPans()
    {
        QFETCH(int, button);
        QFETCH(int, modifier);
        TimeChart chart(Theme::light());
        chart.resize(600, 300);
        chart.show();
        chart.setContent(zetaAndSum());
        chart.setWindow({.from_s = 400, .to_s = 600});
        const QSignalSpy picked(&chart, &TimeChart::timePicked);
        const QPoint from = chart.plot().center().toPoint();
        const QPoint to = from - QPoint(static_cast<int>(chart.plot().width() / 4), 0);
        const auto which = static_cast<Qt::MouseButton>(button);
        const auto keys = Qt::KeyboardModifiers(modifier);
        QTest::mousePress(chart.viewport(), which, keys, from);
        moveMouse(chart, to, which);
        QTest::mouseRelease(chart.viewport(), which, keys, to);
        COMPARE_NEAR(chart.window().from_s, 450, 1); // a pixel is 0.4 s
        COMPARE_NEAR(chart.window().length_s(), 200, 1e-9);
        moveMouse(chart, from, Qt::NoButton); // let go
        COMPARE_NEAR(chart.window().from_s, 450, 1);
        QCOMPARE(picked.count(), 0);
        QTest::mouseDClick(chart.viewport(), Qt::LeftButton, {}, from);
        QVERIFY(!chart.isZoomed());
    }

    void keysZoomAndPan()
    {
        TimeChart chart(Theme::light());
        chart.resize(600, 300);
        chart.show();
        chart.setContent(zetaAndSum());
        QTest::keyClick(&chart, Qt::Key_Plus);
        COMPARE_NEAR(chart.window().length_s(), 800, 1e-9);
        QTest::keyClick(&chart, Qt::Key_Left);
        COMPARE_NEAR(chart.window().from_s, 20, 1e-9); // 100 less a tenth of 800
        QTest::keyClick(&chart, Qt::Key_End);
        QVERIFY(chart.isFollowing());
        COMPARE_NEAR(chart.window().from_s, 200, 1e-9);
        QTest::keyClick(&chart, Qt::Key_Home);
        QVERIFY(!chart.isZoomed() && !chart.isFollowing());
    }

    void pressedPlotPicksTheTimeInView()
    {
        TimeChart chart(Theme::light());
        chart.resize(600, 300);
        chart.show();
        chart.setContent(zetaAndSum());
        chart.setWindow({.from_s = 400, .to_s = 600});
        const QSignalSpy picked(&chart, &TimeChart::timePicked);
        QTest::mouseClick(chart.viewport(), Qt::LeftButton, {}, chart.plot().center().toPoint());
        QCOMPARE(picked.count(), 1);
        COMPARE_NEAR(picked[0][0].toDouble(), 500, 1);
    }

    void shorterMissionIsShownWhole()
    {
        TimeChart chart(Theme::light());
        chart.resize(600, 300);
        chart.show();
        TimeChartContent content = zetaAndSum();
        chart.setContent(content);
        chart.setWindow({.from_s = 400, .to_s = 600});
        content.duration_s = 100; // another one, from its start
        chart.setContent(content);
        QVERIFY(!chart.isZoomed());
    }

    void valuesAreReadAtThePointer()
    {
        TimeChart chart(Theme::light());
        chart.resize(600, 300);
        chart.show();
        TimeChartContent content = zetaAndSum();
        content.lines[0].name = u"Zeta"_s;
        content.lines[0].unit = u"m² s"_s;
        chart.setContent(content);
        QVERIFY(chart.readout().flags.empty());
        const QRectF plot = chart.plot();
        const auto at = [&plot](double time_s) {
            return QPointF(plot.left() + plot.width() * time_s / 1000, plot.center().y()).toPoint();
        };
        const QImage before = chart.grab().toImage();
        for (const double time_s : {20.0, 500.0, 980.0}) {
            moveMouse(chart, at(time_s), Qt::NoButton);
            const ChartReadout readout = chart.readout();
            QCOMPARE(readout.flags.size(), std::size_t{2});
            QVERIFY(readout.hover_px.has_value());
            for (const ReadoutFlag& flag : readout.flags) {
                QVERIFY(QRectF(chart.rect()).contains(flag.rect));
                COMPARE_NEAR(flag.at.x(), *readout.hover_px, 1e-6);
            }
            QVERIFY(!readout.flags[0].rect.intersects(readout.flags[1].rect));
            QCOMPARE(readout.flags[0].rect.left(), readout.flags[1].rect.left()); // a column
            // At the right, but where the pointer is there.
            QCOMPARE(readout.flags[0].rect.left() > plot.center().x(), time_s < 900);
        }
        moveMouse(chart, at(500), Qt::NoButton);
        const ChartReadout middle = chart.readout();
        COMPARE_NEAR(clockValue(middle.time).value_or(0), 500, 2); // a pixel is 2 s
        const auto zeta =
            std::find_if(middle.flags.begin(), middle.flags.end(),
                         [](const ReadoutFlag& flag) { return flag.text.startsWith(u"Zeta"_s); });
        QVERIFY(zeta != middle.flags.end());
        QString digits = zeta->text; // thousands are parted by narrow spaces
        digits.remove(QChar(0x202f));
        const double value = digits.section(u' ', 1, 1).toDouble();
        COMPARE_NEAR(value, 41000, 200); // a pixel is 2 s, 164 m^2 s
        QVERIFY(zeta->text.endsWith(u"m² s"_s));
        QVERIFY(chart.grab().toImage() != before);
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(chart.viewport(), &leave);
        QVERIFY(chart.readout().flags.empty());
        QCOMPARE(chart.grab().toImage(), before);
    }

    void valuesAreReadAtTheCursor()
    {
        TimeChart chart(Theme::light());
        chart.resize(600, 300);
        chart.show();
        TimeChartContent content = sawTeeth(12);
        content.cursor_s = 400;
        chart.setContent(content);
        const ChartReadout readout = chart.readout();
        QVERIFY(!readout.hover_px.has_value());
        QCOMPARE(readout.time, u"06:40"_s);
        QVERIFY(!readout.flags.empty());
        QVERIFY(readout.flags[0].rect.left() > chart.drawing().x.at(400));
        chart.setWindow({.from_s = 500, .to_s = 700}); // no longer in view
        QVERIFY(chart.readout().flags.empty());
    }

    void emphasisedLineIsNamedFirst()
    {
        TimeChart chart(Theme::light());
        chart.resize(500, 130); // room for few names
        chart.show();
        TimeChartContent content = sawTeeth(30);
        for (TimeLine& line : content.lines)
            line.emphasis = LineEmphasis::Faint;
        content.lines[17].emphasis = LineEmphasis::Strong;
        chart.setContent(content);
        const std::vector<DrawnLabel>& labels = chart.drawing().labels;
        QVERIFY(labels.size() < 30);
        QVERIFY(std::any_of(labels.begin(), labels.end(), [](const DrawnLabel& label) {
            return label.of.isStrong && label.text == "B18";
        }));
    }

    /** If there is room for one name only, it is that of zeta. */
    void zetaIsNamedFirst_data()
    {
        QTest::addColumn<QSize>("size");
        for (const int width : {240, 300, 420, 700})
            for (const int height : {110, 130, 160, 220})
                QTest::addRow("%dx%d", width, height) << QSize(width, height);
    }

    void zetaIsNamedFirst()
    {
        QFETCH(QSize, size);
        TimeChart chart(Theme::light());
        chart.setTitleShown(false);
        chart.resize(size);
        chart.show();
        TimeChartContent content = zetaAndSum();
        content.lines[0].label = u"Zeta 82 000 m² s, accumulated since take-off"_s;
        content.lines[0].name = u"Zeta"_s;
        chart.setContent(content);
        const std::vector<DrawnLabel>& labels = chart.drawing().labels;
        QVERIFY(!labels.empty());
        QVERIFY(labels.front().text.starts_with("Zeta"));
    }

    void hiddenLinesLeaveNothingBehind()
    {
        TimeChart chart(Theme::light());
        chart.resize(600, 300);
        chart.show();
        TimeChartContent content = zetaAndSum();
        content.lines[0].hidden = true;
        chart.setContent(content);
        QVERIFY(chart.drawnPoints()[0].isEmpty());
        QVERIFY(chart.drawing().rightTitle.empty());
        QCOMPARE(chart.drawing().labels.size(), std::size_t{1});
    }
};

QTEST_MAIN(TestTimeChart)
#include "tst_time_chart.moc"
