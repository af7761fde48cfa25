#include "core/io/figure/figure_svg.h"
#include "core/io/study/start_figure.h"
#include "tests/support/approx.h"

#include <QTest>

#include <algorithm>

using namespace berg;

namespace {

StartOutcome outcome(double delay_h, std::optional<double> zeta_m2s, WeatherState state)
{
    StartOutcome start{.delay_s = delay_h * 3600,
                       .startUtc = "2026-05-01T" + std::to_string(static_cast<int>(12 + delay_h)) +
                                   ":00:00Z",
                       .zeta_m2s = zeta_m2s,
                       .weather = {.uavs = {{.state = state}}}};
    if (state != WeatherState::Go)
        start.weather.uavs[0].reason =
            WeatherReason{.state = state, .value = 12.34, .limit = 10, .time_s = 600};
    return start;
}

StartScan threeStarts()
{
    return {.starts = {outcome(0, 2e6, WeatherState::Marginal), outcome(1, 3e6, WeatherState::Go),
                       outcome(2, 1e6, WeatherState::NoGo),
                       outcome(3, std::nullopt, WeatherState::NoGo)},
            .uavs = {"uav-1"},
            .best = 1};
}

} // namespace

class TestStartFigure : public QObject
{
    Q_OBJECT

private slots:
    void barsShowZetaAndWeather()
    {
        const Figure figure = startFigure(threeStarts());
        QCOMPARE(figure.areas.size(), 3U);
        QCOMPARE(figure.areas[0].outline[1].y, 2e6);
        QVERIFY(figure.areas[0].opacity < 1);
        QVERIFY(!figure.areas[1].isHatched);
        QCOMPARE(figure.areas[1].opacity, 1.0);
        QVERIFY(figure.areas[2].isHatched);
        QCOMPARE(figure.marks.size(), 2U); // the best start, and the one without a flight
        QCOMPARE(figure.marks[0].at.x, 3600.0);
        QCOMPARE(figure.items.size(), 4U);
        QCOMPARE(figure.items[3].readout.at(1), std::string("cannot be flown"));
        QCOMPARE(figure.items[2].readout.back(), std::string("uav-1: wind 12.3 m/s, limit 10 m/s"));
        QCOMPARE(figure.x.text(7200, 0), std::string("14:00"));
        QCOMPARE(figure.x.midnight, -12.0 * 3600);
        QVERIFY(figure.description.find("2026-05-01 13:00") != std::string::npos);
    }

    void withoutStartsThereIsNothing()
    {
        QVERIFY(startFigure({}).areas.empty());
        StartScan scan = threeStarts();
        scan.best.reset();
        QVERIFY(startFigure(scan).description.find("No start") != std::string::npos);
        scan.starts = {outcome(0, 0.0, WeatherState::Go)};
        QCOMPARE(startFigure(scan).areas.size(), 1U);
    }

    void fileHasItsOwnStyle()
    {
        const std::string svg = figureSvgFile(startFigure(threeStarts()), 760, 320);
        QVERIFY(svg.starts_with("<svg xmlns="));
        for (const char* part :
             {"width=\"760\"", "<style>", "id=\"hatch\"", "class=\"no-go danger\"",
              "class=\"marginal caution\"", "prefers-color-scheme: dark"})
            QVERIFY2(svg.find(part) != std::string::npos, part);
        QVERIFY(svg.find("nan") == std::string::npos && svg.find("inf") == std::string::npos);
    }
};

QTEST_APPLESS_MAIN(TestStartFigure)
#include "tst_start_figure.moc"
