#include "core/base/error.h"
#include "core/mission/mission.h"
#include "core/presets/presets.h"
#include "core/study/start_scan.h"
#include "tests/support/approx.h"

#include <QTest>

#include <cmath>

using namespace berg;
using namespace std::chrono_literals;

namespace {

constexpr double kHour_s = 3600;

/** A short flight from noon on; the wind is 4 m/s until 14:00, 9 m/s at 15:00, 12 m/s at 16:00. */
Scenario windyAfternoon()
{
    Scenario scenario = randomScenario(2, {.icebergs = 3});
    scenario.duration_s = 120;
    scenario.planner.policy = PolicyKind::Nearest;
    scenario.startUtc = "2026-05-01T12:00:00Z";
    const ForecastTime noon(std::chrono::sys_days(std::chrono::year(2026) / 5 / 1) + 12h);
    Forecast forecast{.source = "test", .place = scenario.origin};
    for (const auto& [hours, wind_mps] : {std::pair{0h, 4.0}, {2h, 4.0}, {3h, 9.0}, {4h, 12.0}})
        forecast.series.push_back({.time = noon + hours, .wind_mps = Point(wind_mps, 0)});
    scenario.forecast = ForecastField{.places = {forecast}};
    scenario.uavs[0].weather.wind_mps = 10;
    return scenario;
}

StartOutcome outcome(WeatherState state, std::optional<double> zeta_m2s)
{
    return {.zeta_m2s = zeta_m2s, .weather = {.uavs = {{.state = state}}}};
}

} // namespace

class TestStartScan : public QObject
{
    Q_OBJECT

private slots:
    void laterIcebergsHaveDriftedAndAged()
    {
        Scenario scenario;
        scenario.startUtc = "2026-05-01T23:00:00Z";
        scenario.current_mps = {0, 0.3};
        scenario.observer.model = ObserverModel::Kalman;
        scenario.asset = Asset{.position_m = {5000, 0}, .velocity_mps = {-1, 0}};
        scenario.icebergs.push_back(
            {.id = "fades",
             .velocity_mps = {0.2, 0},
             .velocitySd_mps = 0.1,
             .velocityTime_s = 7200,
             .observed_s = 600,
             .appears_s = 4000,
             .track = {.time_s = {0, 9000}, .position_m = {{1, 1}, {2, 2}}}});
        const Scenario later = startingLater(scenario, 7200);
        QCOMPARE(later.startUtc, std::string("2026-05-02T01:00:00Z"));
        const Iceberg& iceberg = later.icebergs[0];
        // Own velocity: 0.2 m/s x 7200 s (1 - 1/e) to the east.
        COMPARE_NEAR(iceberg.position_m.x(), 0.2 * 7200 * (1 - std::exp(-1.0)), 1e-6);
        COMPARE_NEAR(iceberg.position_m.y(), 0.3 * 7200, 1e-6);
        COMPARE_NEAR(iceberg.velocity_mps.x(), 0.2 * std::exp(-1.0), 1e-12);
        QCOMPARE(iceberg.observed_s, 7800.0);
        QCOMPARE(iceberg.appears_s, 0.0);
        QCOMPARE(iceberg.track.time_s, (std::vector<double>{-7200, 1800}));
        QCOMPARE(later.asset->position_m, Point(-2200, 0));
        COMPARE_NEAR(initialSigma_m2(iceberg),
                     initialTrack(scenario.icebergs[0], ObserverModel::Kalman).sigmaAfter_m2(7200),
                     1e-6);
        QVERIFY(startingLater(scenario, 0) == scenario);
        scenario.observer.model = ObserverModel::Simple; // the velocity is constant
        COMPARE_NEAR(startingLater(scenario, 7200).icebergs[0].position_m.x(), 1440, 1e-6);
    }

    void bestStartIsGoOrMarginal()
    {
        using enum WeatherState;
        QVERIFY(!bestStart({}));
        QVERIFY(!bestStart({outcome(NoGo, 1), outcome(Unknown, 1)}));
        QCOMPARE(bestStart({outcome(NoGo, 1), outcome(Marginal, 3), outcome(Marginal, 2)}), 2U);
        QCOMPARE(bestStart({outcome(Marginal, 1), outcome(Go, 3), outcome(Go, 3)}), 1U);
        QCOMPARE(bestStart({outcome(Go, std::nullopt), outcome(Go, 3)}), 1U);
    }

    void startsAreFlownInTheirWeather()
    {
        const Scenario scenario = windyAfternoon();
        const std::optional<StartScan> scan = scanStarts(scenario, {.span_s = 5 * kHour_s});
        QVERIFY(scan);
        std::vector<WeatherState> states;
        for (const StartOutcome& start : scan->starts)
            states.push_back(start.weather.state());
        using enum WeatherState;
        QCOMPARE(states, (std::vector{Go, Go, Go, Marginal, NoGo, Unknown}));
        QCOMPARE(scan->starts[3].startUtc, std::string("2026-05-01T15:00:00Z"));
        QVERIFY(scan->best && *scan->best < 3);
        Mission mission(scenario, {.record = false});
        mission.advance(scenario.duration_s);
        QCOMPARE(*scan->starts[0].zeta_m2s, mission.metrics().zeta_m2s);
        QCOMPARE(scan->starts[0].visits, mission.metrics().visits);
        // Later estimates are older, so more uncertain.
        QVERIFY(*scan->starts[2].zeta_m2s > *scan->starts[0].zeta_m2s);
    }

    void threadsDoNotMatter()
    {
        const StartScanSpec spec{.span_s = 4 * kHour_s};
        const std::optional<StartScan> one = scanStarts(windyAfternoon(), spec, {.threads = 1});
        QVERIFY(one == scanStarts(windyAfternoon(), spec, {.threads = 3}));
    }

    void canBeStopped()
    {
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!scanStarts(windyAfternoon(), {}, {.stop = stop.get_token()}));
    }

    void needsAStart()
    {
        Scenario scenario = windyAfternoon();
        scenario.startUtc.clear();
        QVERIFY_EXCEPTION_THROWN((void)scanStarts(scenario), Error);
    }

    /** The iceberg is outside the coordinates of a scenario after 3 h at 5 m/s. */
    void laterStartsThatCannotBeFlownHaveNoZeta()
    {
        Scenario scenario = windyAfternoon();
        scenario.icebergs[0].position_m = {990'000, 0};
        scenario.icebergs[0].velocity_mps = {1, 0};
        const std::optional<StartScan> scan = scanStarts(scenario, {.span_s = 3 * kHour_s});
        QVERIFY(scan);
        QVERIFY(scan->starts[0].zeta_m2s);
        QVERIFY(!scan->starts[3].zeta_m2s);
        QCOMPARE(scan->starts[3].weather.state(), WeatherState::Marginal);
    }
};

QTEST_APPLESS_MAIN(TestStartScan)
#include "tst_start_scan.moc"
