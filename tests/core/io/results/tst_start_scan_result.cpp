#include "core/io/results/start_scan_result.h"
#include "core/io/results/weather_result.h"

#include <QTest>

using namespace berg;

namespace {

StartScan twoStarts()
{
    StartScan scan{.uavs = {"uav,1"}};
    scan.starts.push_back({.startUtc = "2026-05-01T12:00:00Z",
                           .zeta_m2s = 1500,
                           .visits = 3,
                           .weather = {.uavs = {{}}}});
    scan.starts.push_back(
        {.delay_s = 5400,
         .startUtc = "2026-05-01T13:30:00Z",
         .weather = {.uavs = {{.state = WeatherState::NoGo,
                               .reason = WeatherReason{.of = WeatherLimit::Visibility,
                                                       .value = 400.04,
                                                       .limit = 500,
                                                       .time_s = 600}}}}});
    scan.best = 0;
    return scan;
}

} // namespace

class TestStartScanResult : public QObject
{
    Q_OBJECT

private slots:
    void tableHasARowForEachStart()
    {
        QCOMPARE(startScanCsv(twoStarts()),
                 std::string("start_utc,delay_h,zeta_m2s,visits,weather,uav,limit,value,"
                             "limit_value,time,best\n"
                             "2026-05-01T12:00:00Z,0,1500,3,go,,,,,,1\n"
                             "2026-05-01T13:30:00Z,1.5,,0,no-go,\"uav,1\",visibility,400.04,500,"
                             "2026-05-01T13:40:00Z,0\n"));
    }

    void documentNamesTheBestStart()
    {
        const std::string text = startScanJson(twoStarts());
        for (const char* part : {"\"best\": \"2026-05-01T12:00:00Z\"", "\"zeta_m2s\": null",
                                 "\"limit\": \"visibility\"", "\"weather\": \"no-go\""})
            QVERIFY2(text.find(part) != std::string::npos, part);
        QVERIFY(startScanJson({}).find("\"best\": null") != std::string::npos);
    }

    void reasonsInWords()
    {
        const StartScan scan = twoStarts();
        QCOMPARE(startReasonText(scan, scan.starts[0]), std::string());
        QCOMPARE(startReasonText(scan, scan.starts[1]),
                 std::string("uav,1: visibility 400 m, limit 500 m, from 13:40 UTC"));
        Scenario scenario;
        scenario.uavs.push_back({.id = "uav-1"});
        const WeatherVerdict& weather = scan.starts[1].weather;
        QCOMPARE(weatherLine(scenario, weather),
                 std::string("no-go  uav-1: visibility 400 m at 600 s, limit 500 m"));
        scenario.startUtc = "2026-05-01T12:00:00Z";
        QCOMPARE(weatherLine(scenario, weather),
                 std::string("no-go  uav-1: visibility 400 m at 2026-05-01 12:10 UTC, "
                             "limit 500 m"));
        QCOMPARE(weatherLine(scenario, {.uavs = {{}}}), std::string("go"));
        QCOMPARE(reasonText({.of = WeatherLimit::Gust, .state = WeatherState::Unknown, .limit = 9}),
                 std::string("gust unknown, limit 9 m/s"));
        QCOMPARE(reasonText({.of = WeatherLimit::Icing}), std::string("icing"));
    }
};

QTEST_APPLESS_MAIN(TestStartScanResult)
#include "tst_start_scan_result.moc"
