#include "core/base/error.h"
#include "core/io/text/atomic_file.h"
#include "tests/support/approx.h"
#include "tests/support/window/chart_panel_fixture.h"
#include "widgets/charts/figure_painter.h"
#include "widgets/theme/palette.h"
#include "widgets/theme/quantity_text.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QImage>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QSignalSpy>
#include <QSvgRenderer>
#include <QTableView>
#include <QTemporaryDir>
#include <QToolButton>

#include <algorithm>
#include <cmath>

using namespace berg;
using namespace Qt::StringLiterals;
using namespace berg::test;

class TestChartPanel : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void everyKindShowsItsLines_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("lines");
        QTest::addColumn<QString>("key");
        QTest::addColumn<double>("last"); // of the first line, from the made-up flight
        const FlightRecord record = test::syntheticRecord(kFlight, 1000);
        const Sample& last = record.history.samples.back();
        const auto row = [](ChartKind kind) {
            return &QTest::newRow(qPrintable(chartFileStem(kind)));
        };
        const double kDegrees = 180 / std::acos(-1.0);
        *row(ChartKind::Zeta) << 0 << 2 << u"zeta_m2s"_s << last.zeta_m2s;
        *row(ChartKind::MeanSigma) << 1 << 2 << u"mean_sigma_sum_m2"_s << last.zeta_m2s / 1000;
        *row(ChartKind::Sigma) << 2 << 5 << u"B1"_s << record.history.rows.back()[0].sigma_m2;
        *row(ChartKind::Distance) << 3 << 1 << u"flown_km"_s << 22.0;
        *row(ChartKind::TurnRate) << 4 << 1 << u"turn_rate_degps"_s
                                  << last.uavs[0].u_radps * kDegrees;
        *row(ChartKind::CrossTrack) << 5 << 1 << u"cross_track_m"_s << last.uavs[0].crossTrack_m;
    }

    void everyKindShowsItsLines()
    {
        QFETCH(int, kind);
        QFETCH(int, lines);
        QFETCH(QString, key);
        QFETCH(double, last);
        const Shown shown(kChartKinds.at(static_cast<std::size_t>(kind)));
        const TimeChartContent& content = shown.chart.content();
        QCOMPARE(static_cast<int>(content.lines.size()), lines);
        QCOMPARE(content.lines[0].key, key);
        COMPARE_NEAR(content.lines[0].points.back().y(), last, 1e-9 * std::abs(last) + 1e-12);
        COMPARE_NEAR(content.lines[0].points.back().x(), 1000, 1e-9);
        QVERIFY(content.summary.contains(u"16:40"_s)); // 1000 s
        QCOMPARE(shown.chart.accessibleDescription(), content.summary);
        // The panel shows what the pure function has.
        const TimeChartContent whole = missionChart(shown.panel.kind(), shown.record, QLocale::c());
        QCOMPARE(whole.lines.size(), content.lines.size());
        QCOMPARE(whole.lines[0].points.size(), 1001);
        QCOMPARE(whole.lines[0].points.back(), content.lines[0].points.back());
    }

    void severalUavsHaveALineEach_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QString>("column");
        QTest::addColumn<QList<double>>("last"); // of each line
        const std::vector<UavSample> last = test::syntheticUavs(kFleet, 1000);
        const double kDegrees = 180 / std::acos(-1.0);
        QTest::newRow("distance") << 3 << u"flown_km"_s << QList<double>{63, 22, 21, 20};
        QTest::newRow("turn rate")
            << 4 << u"turn_rate_degps"_s
            << QList<double>{last[0].u_radps * kDegrees, last[1].u_radps * kDegrees,
                             last[2].u_radps * kDegrees};
        QTest::newRow("cross-track error")
            << 5 << u"cross_track_m"_s
            << QList<double>{last[0].crossTrack_m, last[1].crossTrack_m, last[2].crossTrack_m};
    }

    /** Lines have the colours and names of the UAVs; the total distance has a line too. */
    void severalUavsHaveALineEach()
    {
        QFETCH(int, kind);
        QFETCH(QString, column);
        QFETCH(QList<double>, last);
        FlightRecord record = test::syntheticRecord(kFleet, 1000);
        record.scenario.uavs[1].name = "Gannet";
        ChartPanel panel(kChartKinds.at(static_cast<std::size_t>(kind)), Theme::dark());
        panel.resize(600, 300);
        panel.show();
        panel.showRecord(record);
        const auto& chart = child<TimeChart>(panel, u"timeChart"_s);
        const std::vector<TimeLine>& lines = chart.content().lines;
        QCOMPARE(static_cast<qsizetype>(lines.size()), last.size());
        const auto first = lines.size() - 3;
        for (std::size_t i = 0; i < lines.size(); ++i)
            COMPARE_NEAR(lines[i].points.back().y(), last[static_cast<qsizetype>(i)], 1e-9);
        QCOMPARE(lines[first].label, u"uav-1"_s);
        QCOMPARE(lines[first + 1].label, u"Gannet"_s);
        QVERIFY(chart.content().summary.contains(u"Gannet "_s));
        for (std::size_t i = 0; i < 3; ++i) {
            QCOMPARE(lines[first + i].key, u"uav-%1_"_s.arg(i + 1) + column);
            const std::vector<ReadoutFlag> rows = chart.readout().flags;
            const auto row = std::ranges::find(rows, lines[first + i].key, &ReadoutFlag::key);
            QVERIFY(row != rows.end());
            QCOMPARE(row->colour, uavColour(Theme::dark(), static_cast<int>(i)));
        }
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"chart.csv"_s);
        panel.exportChart(path);
        const std::vector<std::string> rows = linesOf(readFile(path.toStdString()));
        QCOMPARE(rows.size(), std::size_t{1002});
        const std::string header =
            (kind == 3 ? "time_s,flown_km," : "time_s,") + lines[first].key.toStdString() + ',' +
            lines[first + 1].key.toStdString() + ',' + lines[first + 2].key.toStdString();
        QCOMPARE(rows[0], header);
    }

    void turnRateHasItsLimits()
    {
        const Shown shown(ChartKind::TurnRate);
        const Drawing& drawing = shown.chart.drawing();
        std::vector<double> limits_px;
        for (const DrawnLine& line : drawing.over)
            if (!line.dash_px.empty())
                limits_px.push_back(line.points.front().y);
        QCOMPARE(limits_px.size(), std::size_t{2});
        QVERIFY(std::ranges::any_of(drawing.labels, [](const DrawnLabel& label) {
            return label.text.find("11.9") != std::string::npos; // 0.2079 rad/s in the paper
        }));
        for (const double limit_px : limits_px)
            QVERIFY(limit_px > drawing.plot.top && limit_px < drawing.plot.bottom);
        COMPARE_NEAR(limits_px[0] + limits_px[1], drawing.plot.top + drawing.plot.bottom,
                     1); // zero is in the middle
    }

    void emptyRunIsReported()
    {
        const ChartPanel panel(ChartKind::Sigma, Theme::dark());
        const auto& chart = child<TimeChart>(panel, u"timeChart"_s);
        QVERIFY(chart.accessibleDescription().contains(u"Nothing flown"_s));
        QVERIFY(!child<QToolButton>(panel, u"chartExport"_s).isEnabled());
    }

    void kindIsChosenWithTheKeyboard()
    {
        Shown shown(ChartKind::Zeta);
        const QSignalSpy changed(&shown.panel, &ChartPanel::kindChanged);
        QTest::keyClick(&child<QComboBox>(shown.panel, u"chartKind"_s), Qt::Key_Down);
        QCOMPARE(changed.count(), 1);
        QCOMPARE(shown.panel.kind(), ChartKind::MeanSigma);
        QVERIFY(shown.chart.content().lines.empty());
        shown.panel.showRecord(shown.record);
        QCOMPARE(shown.chart.content().lines.size(), std::size_t{2});
    }

    void linesCanBeHidden()
    {
        Shown shown(ChartKind::Zeta);
        auto& menu = child<QMenu>(shown.panel, u"chartLinesMenu"_s);
        auto* zeta = menu.findChild<QAction*>(u"zeta_m2s"_s);
        QVERIFY(zeta != nullptr && zeta->isChecked());
        QVERIFY(!shown.chart.drawing().rightTicks.empty());
        zeta->trigger();
        QVERIFY(shown.chart.drawnPoints()[0].empty());
        QVERIFY(!shown.chart.drawnPoints()[1].empty());
        QVERIFY(shown.chart.drawing().rightTicks.empty()); // its axis goes with it
        shown.panel.showRecord(test::syntheticRecord(kFlight, 900));
        QVERIFY(shown.chart.drawnPoints()[0].empty()); // and stays away
        menu.actions().front()->trigger();
        QVERIFY(zeta->isChecked());
        QVERIFY(!shown.chart.drawnPoints()[0].empty());
    }

    void selectedIcebergStandsOut()
    {
        Shown shown(ChartKind::Sigma, {700, 400});
        shown.panel.setHighlight("B3");
        const std::vector<TimeLine>& lines = shown.chart.content().lines;
        for (const TimeLine& line : lines)
            QCOMPARE(line.emphasis,
                     line.key == u"B3"_s ? LineEmphasis::Strong : LineEmphasis::Faint);
        QCOMPARE(std::ranges::count(shown.chart.readout().flags, true, &ReadoutFlag::isStrong), 1);
        shown.panel.setHighlight("not an iceberg");
        for (const TimeLine& line : lines)
            QCOMPARE(line.emphasis, LineEmphasis::None);
    }

    void selectedIcebergIsSeenThoughHidden()
    {
        Shown shown(ChartKind::Sigma);
        child<QMenu>(shown.panel, u"chartLinesMenu"_s).findChild<QAction*>(u"B3"_s)->trigger();
        QVERIFY(shown.chart.drawnPoints()[2].empty());
        shown.panel.setHighlight("B3");
        QVERIFY(!shown.chart.drawnPoints()[2].empty());
    }

    void labelPicksTheIceberg_data()
    {
        QTest::addColumn<int>("width");
        QTest::newRow("label at the end of its line") << 400;
        QTest::newRow("row of the table") << 700;
    }

    void labelPicksTheIceberg()
    {
        QFETCH(int, width);
        Shown shown(ChartKind::Sigma, {width, 400});
        const QSignalSpy picked(&shown.panel, &ChartPanel::icebergPicked);
        const QSignalSpy time(&shown.panel, &ChartPanel::timePicked);
        auto& table = child<QTableView>(shown.panel, u"lineValues"_s);
        QCOMPARE(table.isVisible(), width != 400);
        std::string key;
        if (table.isVisible()) {
            const QModelIndex row = table.model()->index(1, 0);
            key = row.data().toString().toStdString();
            QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(row).center());
        } else {
            const DrawnLabel label = shown.chart.drawing().labels.front();
            key = label.of.key;
            QTest::mouseClick(shown.chart.viewport(), Qt::LeftButton, {},
                              toQt(label.rect).center().toPoint());
        }
        QCOMPARE(picked.count(), 1);
        QCOMPARE(picked[0][0].value<std::string>(), key);
        QCOMPARE(time.count(), 0);
    }

    void followAndAllButtons()
    {
        Shown shown(ChartKind::Zeta);
        auto& follow = child<QToolButton>(shown.panel, u"chartFollow"_s);
        auto& all = child<QToolButton>(shown.panel, u"chartAll"_s);
        QVERIFY(!all.isEnabled());
        follow.click();
        QVERIFY(follow.isChecked() && all.isEnabled());
        COMPARE_NEAR(shown.chart.window().from_s, 700, 1e-9); // 5 min
        test::extend(shown.record, kFlight, 1100);
        shown.panel.showRecord(shown.record);
        COMPARE_NEAR(shown.chart.window().from_s, 800, 1e-9);
        COMPARE_NEAR(shown.chart.window().to_s, 1100, 1e-9);
        shown.chart.setWindow({.from_s = 100, .to_s = 200});
        QVERIFY(!follow.isChecked());
        test::extend(shown.record, kFlight, 1200);
        shown.panel.showRecord(shown.record);
        COMPARE_NEAR(shown.chart.window().from_s, 100, 1e-9); // stays
        all.click();
        QCOMPARE(shown.chart.window(), (TimeWindow{.from_s = 0, .to_s = 1200}));
        QVERIFY(!all.isEnabled());
    }

    void grownRecordIsWhatAWholeOneIs()
    {
        Shown grown(ChartKind::Sigma);
        for (double until_s = 1000; until_s <= 3000; until_s += 37) {
            test::extend(grown.record, kFlight, until_s);
            grown.panel.showRecord(grown.record);
        }
        test::extend(grown.record, kFlight, 3000);
        grown.record.now.phase = RunPhase::Finished;
        grown.panel.showRecord(grown.record);
        ChartPanel whole(ChartKind::Sigma, Theme::light());
        whole.resize(600, 260);
        whole.show();
        whole.showRecord(grown.record);
        QCOMPARE(grown.chart.drawnPoints(), child<TimeChart>(whole, u"timeChart"_s).drawnPoints());
    }

    void rewrittenRecordIsTakenAnew()
    {
        Shown shown(ChartKind::Distance);
        FlightRecord other = test::syntheticRecord(kFlight, 1000);
        for (Sample& sample : other.history.samples)
            sample.flown_m *= 2;
        other.history.rewrites = 1;
        shown.panel.showRecord(other);
        COMPARE_NEAR(shown.chart.content().lines[0].points.back().y(), 44, 1e-9);
    }

    void changesBelowAPixelWait()
    {
        Shown shown(ChartKind::Distance);
        test::extend(shown.record, kFlight, 10000);
        shown.panel.showRecord(shown.record);
        test::extend(shown.record, kFlight, 10005); // 10000 s / 600 px: 17 s each
        shown.panel.showRecord(shown.record);
        COMPARE_NEAR(shown.chart.content().duration_s, 10000, 1e-9);
        shown.record.now.phase = RunPhase::Paused;
        shown.panel.showRecord(shown.record);
        COMPARE_NEAR(shown.chart.content().duration_s, 10005, 1e-9);
    }

    void icebergNotYetThereHasNoPoints()
    {
        FlightRecord record = test::syntheticRecord(kFlight, 100);
        for (std::size_t row = 0; row < 50; ++row)
            record.history.rows[row][4].active = false;
        ChartPanel panel(ChartKind::Sigma, Theme::light());
        panel.showRecord(record);
        const auto& chart = child<TimeChart>(panel, u"timeChart"_s);
        COMPARE_NEAR(chart.content().lines[4].points.front().x(), 50, 1e-9);
        const QTemporaryDir folder;
        panel.exportChart(folder.filePath(u"a.csv"_s));
        const auto lines = linesOf(readFile(folder.filePath(u"a.csv"_s).toStdString()));
        QVERIFY(lines[1].ends_with(','));
        QVERIFY(!lines[51].ends_with(','));
    }

    void tableHasEverySample()
    {
        Shown shown(ChartKind::Zeta);
        shown.chart.setWindow({.from_s = 100, .to_s = 200}); // of the picture only
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"zeta.CSV"_s);
        QLocale::setDefault(QLocale(QLocale::NorwegianBokmal));
        shown.panel.exportChart(path);
        QLocale::setDefault(QLocale::c());
        const std::vector<std::string> lines = linesOf(readFile(path.toStdString()));
        QCOMPARE(lines.size(), std::size_t{1002});
        QCOMPARE(lines[0], std::string("time_s,zeta_m2s,sigma_sum_m2"));
        const Sample& sample = shown.record.history.samples[500];
        const QStringList fields = QString::fromStdString(lines[501]).split(u',');
        QCOMPARE(fields.size(), 3);
        QCOMPARE(fields[0].toDouble(), 500.0);
        QCOMPARE(fields[1].toDouble(), sample.zeta_m2s); // reads back exactly
        QCOMPARE(fields[2].toDouble(), sample.sigmaSum_m2);
    }

    void picturesCanBeRead_data()
    {
        QTest::addColumn<QString>("ending");
        for (const char* ending : {"png", "svg", "pdf"})
            QTest::newRow(ending) << QString::fromLatin1(ending);
    }

    void picturesCanBeRead()
    {
        QFETCH(QString, ending);
        const Shown shown(ChartKind::Sigma);
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"chart."_s + ending);
        shown.panel.exportChart(path);
        if (ending == u"pdf"_s) {
            const std::string bytes = readFile(path.toStdString());
            QVERIFY(bytes.starts_with("%PDF-"));
            QVERIFY(bytes.find("/MediaBox [0 0 840.0") != std::string::npos); // 1120 px at 96 dpi
            return;
        }
        QImage image(path);
        if (ending == u"svg"_s) {
            QSvgRenderer svg(path);
            QVERIFY(svg.isValid());
            image = QImage(svg.defaultSize(), QImage::Format_RGB32);
            QPainter painter(&image);
            svg.render(&painter);
        }
        QVERIFY(image.width() >= 1000); // an SVG is 296 mm wide, whatever that is in pixels
        // Lines of the sigmas are there, in a colour of the scale rather than black.
        int coloured = 0;
        for (int y = image.height() / 4; y < image.height() / 2; ++y)
            for (int x = image.width() / 4; x < image.width() / 2; ++x)
                coloured += image.pixelColor(x, y).saturation() > 60 ? 1 : 0;
        QVERIFY2(coloured > 100, QByteArray::number(coloured).constData());
    }

    void unknownEndingIsAnError()
    {
        const Shown shown(ChartKind::Zeta);
        const QTemporaryDir folder;
        QVERIFY_THROWS_EXCEPTION(Error, shown.panel.exportChart(folder.filePath(u"a.gif"_s)));
        QVERIFY_THROWS_EXCEPTION(Error, shown.panel.exportChart(u"/nowhere/at/all.png"_s));
        QVERIFY(ChartPanel::exportFilters().contains(u"*.svg"_s));
        QCOMPARE(shown.panel.exportName(), u"zeta.png"_s);
    }

    void fitsANarrowDockWithLongerTexts()
    {
        const test::LongerTexts longer;
        Shown shown(ChartKind::CrossTrack, {test::kDock_px, 170});
        QVERIFY(shown.panel.minimumSizeHint().width() <= test::kDock_px);
        QCOMPARE(shown.panel.width(), test::kDock_px);
        for (const DrawnLabel& label : shown.chart.drawing().labels)
            QVERIFY(QRectF(shown.chart.rect()).contains(toQt(label.rect)));
    }

    void everyControlIsNamedAndReachable()
    {
        const Shown shown(ChartKind::Sigma);
        for (const QString& name :
             {u"chartKind"_s, u"chartLines"_s, u"chartFollow"_s, u"chartAll"_s, u"chartExport"_s}) {
            const auto& control = child<QWidget>(shown.panel, name);
            QVERIFY2(!control.accessibleName().isEmpty(), qPrintable(name));
            QVERIFY2(!control.toolTip().isEmpty(), qPrintable(name));
            QVERIFY2(control.focusPolicy() & Qt::TabFocus, qPrintable(name));
        }
        QVERIFY(shown.chart.focusPolicy() & Qt::TabFocus);
    }

    /** Zooming or moving one chart also changes the other. */
    void linkedChartsShowTheSameTime()
    {
        test::Shown zeta(ChartKind::Zeta);
        test::Shown sigma(ChartKind::Sigma, {420, 200});
        ChartPanel::linkTimes(zeta.panel, sigma.panel);
        zeta.chart.setWindow({.from_s = 100, .to_s = 200});
        QCOMPARE(sigma.chart.window(), (TimeWindow{.from_s = 100, .to_s = 200}));
        sigma.chart.setFollowing(true);
        QVERIFY(zeta.chart.isFollowing());
        QCOMPARE(zeta.chart.window(), sigma.chart.window());
        zeta.chart.showAll();
        QVERIFY(!sigma.chart.isZoomed());
    }

    /** The right button without a drag and the menu key open the menu. */
    void chartHasAMenu()
    {
        test::Shown shown(ChartKind::Zeta);
        shown.chart.setWindow({.from_s = 100, .to_s = 200});
        const QPoint middle = shown.chart.viewport()->rect().center();
        QTest::mouseClick(shown.chart.viewport(), Qt::RightButton, {}, middle);
        const auto act = [&](const QString& text) {
            auto& menu = test::child<QMenu>(shown.panel, u"chartMenu"_s);
            for (QAction* action : menu.actions())
                if (action->text() == text)
                    action->trigger();
            delete &menu;
        };
        act(u"Reset zoom"_s);
        QVERIFY(!shown.chart.isZoomed());
        QContextMenuEvent key(QContextMenuEvent::Keyboard, middle, middle);
        QApplication::sendEvent(shown.chart.viewport(), &key);
        act(u"Copy numbers"_s);
        QVERIFY(QApplication::clipboard()->text().startsWith(u"time_s"_s));
        QTest::mousePress(shown.chart.viewport(), Qt::RightButton, {}, middle);
        QTest::mouseMove(shown.chart.viewport(), middle + QPoint(30, 0));
        QTest::mouseRelease(shown.chart.viewport(), Qt::RightButton, {}, middle + QPoint(30, 0));
        QVERIFY(shown.panel.findChild<QMenu*>(u"chartMenu"_s) == nullptr); // it was panned
    }

    /** The table has every sample. */
    void valuesAreATable()
    {
        test::Shown shown(ChartKind::Zeta);
        QContextMenuEvent key(QContextMenuEvent::Keyboard, {}, {});
        QApplication::sendEvent(shown.chart.viewport(), &key);
        test::child<QMenu>(shown.panel, u"chartMenu"_s).actions().front()->trigger();
        const QAbstractItemModel& values =
            *test::child<QTableView>(shown.panel, u"values"_s).model();
        const std::vector<Sample>& samples = shown.record.history.samples;
        QCOMPARE(values.rowCount(), static_cast<int>(samples.size()));
        QVERIFY(values.columnCount() >= 3);
        QCOMPARE(values.headerData(0, Qt::Horizontal).toString(), u"Time"_s);
        QVERIFY(values.headerData(1, Qt::Horizontal).toString().contains(u"m²"_s));
        constexpr int kRow = 500;
        QCOMPARE(values.index(kRow, 0).data().toString(), clockText(samples[kRow].time_s));
        QStringList cells;
        for (int column = 1; column < values.columnCount(); ++column)
            cells << values.index(kRow, column).data().toString();
        QVERIFY(cells.contains(significantText(samples[kRow].zeta_m2s, 4, shown.panel.locale())));
        test::child<QPushButton>(shown.panel, u"copyValues"_s).click();
        const QStringList lines = QApplication::clipboard()->text().trimmed().split(u'\n');
        QCOMPARE(lines.size(), values.rowCount() + 1);
        QCOMPARE(lines[kRow + 1].split(u'\t').front(), clockText(samples[kRow].time_s));
    }

    /** Small movements during a click are not a drag. */
    void aPixelIsNoDrag()
    {
        test::Shown shown(ChartKind::Zeta);
        shown.chart.setWindow({.from_s = 100, .to_s = 200});
        const QPoint middle = shown.chart.viewport()->rect().center();
        QTest::mousePress(shown.chart.viewport(), Qt::RightButton, {}, middle);
        QTest::mouseMove(shown.chart.viewport(), middle + QPoint(1, 0));
        QTest::mouseRelease(shown.chart.viewport(), Qt::RightButton, {}, middle + QPoint(1, 0));
        delete &test::child<QMenu>(shown.panel, u"chartMenu"_s);
        QCOMPARE(shown.chart.window(), (TimeWindow{.from_s = 100, .to_s = 200}));
    }
};

QTEST_MAIN(TestChartPanel)
#include "tst_chart_panel.moc"
