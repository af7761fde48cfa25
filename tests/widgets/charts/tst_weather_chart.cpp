#include "core/io/text/atomic_file.h"
#include "tests/support/approx.h"
#include "tests/support/flight/forecast_builder.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/chart_panel_fixture.h"
#include "widgets/charts/weather_chart.h"
#include "widgets/print/document_chart.h"
#include "widgets/theme/unit_settings.h"

#include <QMenu>
#include <QTableView>
#include <QTemporaryDir>
#include <QtTest>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

constexpr double kHour_s = 3600;

/** A record before take-off, of a run of eight hours with a forecast. */
FlightRecord forecastRecord()
{
    FlightRecord record;
    record.scenario = emptySea(8 * kHour_s);
    addForecast(record.scenario);
    record.now.phase = RunPhase::Ready;
    record.noteWeather();
    return record;
}

/** A panel with the chart of the weather. */
struct WeatherPanel
{
    explicit WeatherPanel(FlightRecord shown, const QSize& size = {600, 260})
        : record(std::move(shown))
        , panel(ChartKind::Weather, Theme::light())
        , chart(child<TimeChart>(panel, u"timeChart"_s))
    {
        panel.setLocale(QLocale::c());
        panel.resize(size);
        panel.show();
        panel.showRecord(record);
    }
    [[nodiscard]] const std::vector<TimeLine>& lines() const { return chart.content().lines; }
    [[nodiscard]] QStringList read() const
    {
        QStringList texts;
        for (const ReadoutFlag& flag : chart.readout().flags)
            texts << flag.text;
        return texts;
    }

    FlightRecord record;
    ChartPanel panel;
    TimeChart& chart;
};

/** Number of lines above the content of one ink. */
std::ptrdiff_t strokes(const Drawing& drawing, InkOf ink)
{
    return std::ranges::count_if(drawing.over,
                                 [ink](const DrawnLine& line) { return line.ink.of == ink; });
}

} // namespace

/** Wind, gusts and current over time. */
class TestWeatherChart : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init() { failOnWarnings(); }
    void cleanup() { setShownUnits({}); }

    /** Before take-off, over the whole run. */
    void forecastHasALineForEachQuantity()
    {
        const WeatherPanel shown(forecastRecord());
        QCOMPARE(shown.lines().size(), std::size_t{3});
        const std::array keys{u"wind_mps"_s, u"gust_mps"_s, u"current_mps"_s};
        const std::array last{18.0, 22.0, 0.5};
        for (std::size_t i = 0; i < keys.size(); ++i) {
            QCOMPARE(shown.lines()[i].key, keys[i]);
            COMPARE_NEAR(shown.lines()[i].points.back().x(), 8 * kHour_s, 1e-9);
            COMPARE_NEAR(shown.lines()[i].points.back().y(), last[i], 1e-6);
        }
        QVERIFY(!shown.chart.content().cursor_s);
        QCOMPARE(shown.chart.drawing().rightTitle, std::string("Current, m/s"));
        QVERIFY2(shown.chart.accessibleDescription().contains(
                     u"wind 10 m/s from 270°, gusts 14 m/s, current 0.50 m/s towards 037°"_s),
                 qPrintable(shown.chart.accessibleDescription()));
        QVERIFY(shown.chart.accessibleDescription().contains(u"MET Norway"_s));
    }

    /** Wind and gusts share a colour; no forecast has thousandths. */
    void valuesBesideTheChartAreMarkedAndShort()
    {
        const WeatherPanel shown(forecastRecord(), {900, 260});
        const std::vector<ReadoutFlag> flags = shown.chart.readout().flags;
        QCOMPARE(flags.size(), std::size_t{3});
        QVERIFY(!flags[0].isDashed && flags[1].isDashed && !flags[2].isDashed);
        for (const ReadoutFlag& flag : flags)
            QVERIFY2(flag.value.section(u'.', 1).size() <= 2, qPrintable(flag.value));
        QCOMPARE(flags[2].value, u"0.50"_s);
        const auto* table = shown.panel.findChild<QTableView*>();
        const auto mark = [&](int row) {
            return table->model()->index(row, 0).data(Qt::DecorationRole);
        };
        QVERIFY(mark(0).canConvert<QColor>() && mark(1).canConvert<QPixmap>());
        const QImage gusts = mark(1).value<QPixmap>().toImage();
        QCOMPARE(gusts.pixelColor(0, 4), mark(0).value<QColor>());
        QCOMPARE(gusts.pixelColor(gusts.width() / 2, 4).alpha(), 0);
    }

    void constantWindIsOneLine()
    {
        FlightRecord record = forecastRecord();
        record.scenario.forecast.reset();
        record.scenario.wind_mps = {0, -6};
        record.noteWeather();
        const WeatherPanel shown(record);
        QCOMPARE(shown.lines().size(), std::size_t{1});
        COMPARE_NEAR(shown.lines()[0].points.front().y(), 6, 1e-9);
        COMPARE_NEAR(shown.lines()[0].points.back().y(), 6, 1e-9);
        QVERIFY(shown.chart.content().rightTitle.isEmpty());
    }

    void gapsBreakTheLines()
    {
        FlightRecord record = forecastRecord();
        cutForecast(*record.scenario.forecast, 0, 7);
        record.noteWeather();
        const WeatherPanel shown(record, {400, 260});
        QCOMPARE(shown.lines().size(), std::size_t{6});
        QVERIFY(!shown.lines()[0].isContinued && shown.lines()[1].isContinued);
        COMPARE_NEAR(shown.lines()[0].points.back().x(), 0, 1e-9);
        COMPARE_NEAR(shown.lines()[1].points.front().x(), 7 * kHour_s, 1e-9);
        // A quantity has one name, one switch and one column.
        const auto labels =
            std::ranges::count_if(shown.chart.drawing().labels, [](const DrawnLabel& label) {
                return label.of.key == "wind_mps";
            });
        QVERIFY(labels <= 1);
        const QList<QAction*> actions = child<QMenu>(shown.panel, u"chartLinesMenu"_s).actions();
        QCOMPARE(std::ranges::count(actions, u"wind_mps"_s, &QAction::objectName), 1);
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"weather.csv"_s);
        shown.panel.exportChart(path);
        const std::vector<std::string> rows = test::linesOf(readFile(path.toStdString()));
        QCOMPARE(rows[0], std::string("time_s,wind_mps,wind_from_deg,gust_mps,current_mps,"
                                      "current_towards_deg"));
        // The place in the grid, and with it the wind, is as exact as in flight.
        const auto rowOf = [&rows](std::size_t row) {
            return QByteArray::fromStdString(rows[row]).split(',');
        };
        const std::array start{0.0, 10.0, 270.0, 14.0, 0.5, 36.9};
        for (std::size_t i = 0; i < start.size(); ++i)
            COMPARE_NEAR(rowOf(1).at(static_cast<qsizetype>(i)).toDouble(), start[i], 1e-6);
        QCOMPARE(rowOf(2).at(0), QByteArray("25200"));
        COMPARE_NEAR(rowOf(2).at(1).toDouble(), 17, 1e-6);
    }

    /** In a gap the flight uses the constants of the scenario, which the chart names. */
    void gapsShowWhatIsFlown()
    {
        FlightRecord record = forecastRecord();
        record.scenario.wind_mps = {0, -6};
        record.scenario.current_mps = {0.2, 0};
        QVERIFY(WeatherPanel(record).chart.content().references.empty());
        cutForecast(*record.scenario.forecast, -1, 7);
        record.noteWeather();
        const WeatherPanel shown(record);
        const TimeChartContent& content = shown.chart.content();
        QCOMPARE(content.references.size(), std::size_t{1});
        COMPARE_NEAR(content.references[0].value, 6, 1e-9);
        QCOMPARE(content.references[0].label, u"Flown in gaps: constant wind 6.00 m/s"_s);
        QCOMPARE(content.title,
                 u"Forecast of wind and current; in gaps the constant current of 0.200 m/s"_s);
        QVERIFY2(shown.chart.accessibleDescription().contains(
                     u"wind 6.0 m/s from 000°, current 0.20 m/s towards 090°"_s),
                 qPrintable(shown.chart.accessibleDescription()));
    }

    /** In knots the numbers and the columns are in knots. */
    void unitsAreThoseOfTheUser()
    {
        setShownUnits({.speed = SpeedUnit::Knots});
        const WeatherPanel shown(forecastRecord());
        QCOMPARE(shown.lines()[0].key, u"wind_kn"_s);
        COMPARE_NEAR(shown.lines()[0].points.front().y(), 10 * 3600 / 1852.0, 1e-6);
    }

    void limitsAreLines()
    {
        FlightRecord record = forecastRecord();
        record.scenario.uavs[0].weather = {.wind_mps = 12, .gust_mps = 16};
        const WeatherPanel shown(record);
        const std::vector<ReferenceLine>& references = shown.chart.content().references;
        QCOMPARE(references.size(), std::size_t{2});
        QCOMPARE(references[0].value, 12.0);
        QCOMPARE(references[0].label, u"Wind limit 12.0 m/s"_s);
        QCOMPARE(references[1].label, u"Gust limit 16.0 m/s"_s);
    }

    /** The cursor is at the time shown, live or looked back at, and the values are read there. */
    void timeShownIsMarked()
    {
        FlightRecord record = forecastRecord();
        record.now.phase = RunPhase::Paused;
        record.now.time_s = 2 * kHour_s;
        WeatherPanel shown(record, {400, 260});
        QCOMPARE(*shown.chart.content().cursor_s, 2 * kHour_s);
        QVERIFY2(shown.read().contains(u"Wind 12.00 m/s from 300°"_s) ||
                     shown.read().contains(u"Wind 12.0 m/s from 300°"_s),
                 qPrintable(shown.read().join(u'\n')));
        shown.record.instant = shown.record.now;
        shown.record.instant->time_s = kHour_s;
        shown.panel.showRecord(shown.record);
        QCOMPARE(*shown.chart.content().cursor_s, kHour_s);
        QVERIFY(shown.read().join(u' ').contains(u"from 285°"_s));
        QVERIFY(shown.read().join(u' ').contains(u"towards 037°"_s));
    }

    void reportedWindIsFollowed()
    {
        FlightRecord record = forecastRecord();
        record.now.phase = RunPhase::Paused;
        record.now.time_s = 2 * kHour_s;
        WeatherPanel shown(record);
        shown.record.now.worldChanges = {{.time_s = kHour_s, .wind_mps = Point(0, 3)}};
        shown.record.noteWeather();
        shown.panel.showRecord(shown.record);
        COMPARE_NEAR(shown.lines()[0].points.back().y(), 3, 1e-9);
    }

    /** Barbs and arrows are in the figure, so that paper and SVG show them, too. */
    void directionsAreDrawn()
    {
        const WeatherPanel shown(forecastRecord());
        const auto barbs = strokes(shown.chart.drawing(), InkOf::Text);
        QVERIFY2(barbs >= 3 * 5, qPrintable(QString::number(barbs)));
        QVERIFY(strokes(shown.chart.drawing(), InkOf::Plan) >= 2 * 5);
        const std::array contents{missionChart(ChartKind::Weather, shown.record, QLocale::c())};
        const std::vector<TimeFigure> page =
            documentCharts(contents, Theme::light(), {800, 300}, QLocale::c());
        QVERIFY(strokes(page[0].drawing, InkOf::Text) >= 3 * 5);
        const WeatherPanel low(forecastRecord(), {600, 120});
        QCOMPARE(strokes(low.chart.drawing(), InkOf::Text), 0);
    }

    void barbsStayClearOfTheLines()
    {
        const WeatherPanel shown(forecastRecord());
        const Drawing& drawing = shown.chart.drawing();
        double lowest_px = drawing.plot.top;
        for (const DrawnLine& line : drawing.over)
            if (line.ink.of == InkOf::Text)
                for (const Pixel& pixel : line.points)
                    lowest_px = std::max(lowest_px, pixel.y);
        double highest_px = drawing.plot.bottom;
        for (const QPointF& point : shown.chart.drawnPoints()[1])
            highest_px = std::min(highest_px, drawing.y.at(point.y()));
        QVERIFY2(lowest_px <= highest_px + 4,
                 qPrintable(u"%1 %2"_s.arg(lowest_px).arg(highest_px)));
    }

    void forecastOfAnotherDayLeavesAnEmptyChart()
    {
        FlightRecord record = forecastRecord();
        record.scenario.startUtc = "2026-06-01T12:00:00Z";
        record.noteWeather();
        const WeatherPanel shown(record);
        QVERIFY(shown.lines().empty());
        QCOMPARE(shown.chart.accessibleDescription(), u"The forecast does not cover this run"_s);
    }
};

QTEST_MAIN(TestWeatherChart)
#include "tst_weather_chart.moc"
