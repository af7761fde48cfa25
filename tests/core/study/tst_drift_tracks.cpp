#include "core/scenario/initial_truth.h"
#include "core/study/drift_tracks.h"
#include "tests/support/approx.h"

#include <QTest>

#include <cmath>

using namespace berg;
using namespace std::chrono_literals;

namespace {

constexpr double kHour_s = 3600;

ForecastTime noon()
{
    return ForecastTime(std::chrono::sys_days(std::chrono::year(2026) / 5 / 1) + 12h);
}

/** One iceberg of 100 m in a wind of 10 m/s to the east and a current of 0.3 m/s to the north. */
Scenario windAndCurrent()
{
    Scenario scenario;
    scenario.origin = {64, -58};
    scenario.wind_mps = {10, 0};
    scenario.current_mps = {0, 0.3};
    scenario.icebergs.push_back({.id = "berg-1", .length_m = 100});
    return scenario;
}

/** One wind and current for six hours from noon on, over water of that depth. */
Scenario sixHours(std::optional<double> depth_m)
{
    Scenario scenario = windAndCurrent();
    scenario.startUtc = "2026-05-01T12:00:00Z";
    Forecast forecast{.source = "test", .place = scenario.origin, .depth_m = depth_m};
    for (const auto hours : {0h, 6h})
        forecast.series.push_back({.time = noon() + hours,
                                   .wind_mps = scenario.wind_mps,
                                   .current_mps = scenario.current_mps});
    scenario.forecast = ForecastField{.places = {forecast}};
    scenario.wind_mps = scenario.current_mps = {9, 9}; // replaced by the forecast
    return scenario;
}

DriftTrack trackOf(const Scenario& scenario, const DriftTrackSpec& spec = {})
{
    return driftTracks(scenario, spec).at(0);
}

} // namespace

class TestDriftTracks : public QObject
{
    Q_OBJECT

private slots:
    /**
     * By hand (tst_wind_drift): 1.6932 % of the wind and 98.3068 % of the current, so 0.16932 m/s
     * to the east and 0.29492 m/s to the north.
     */
    void windAndCurrentCarryALength()
    {
        const DriftTrack track = trackOf(windAndCurrent());
        QCOMPARE(track.points.size(), 17U); // every 3 h to 48 h
        QCOMPARE(track.end, DriftTrackEnd::Complete);
        const DriftTrackPoint& point = track.points.at(1);
        QCOMPARE(point.time_s, 3 * kHour_s);
        COMPARE_NEAR(point.position_m.x(), 0.16932 * 10800, 0.2);
        COMPARE_NEAR(point.position_m.y(), 0.29492 * 10800, 0.2);
        COMPARE_NEAR(point.velocity_mps.x(), 0.16932, 1e-5);
        const Point back_m = LocalFrame({64, -58}).toPlane(point.place);
        COMPARE_NEAR((back_m - point.position_m).norm(), 0, 1e-6);
    }

    void coefficientsCanBeChosen()
    {
        const double cCore = trackOf(windAndCurrent()).points.at(1).position_m.x();
        const double openBerg =
            trackOf(windAndCurrent(), {.drag = kOpenBergDrag}).points.at(1).position_m.x();
        // 1.293 0.8 / (1027 0.25) against 1.225 1.1857 / (1023.6 0.7867) in the root.
        COMPARE_NEAR(openBerg / cCore, 1.482, 0.002);
    }

    /** sqrt(25 + 0.02 t + (0.1 t)^2) after 3 h = 10800 s: sqrt(25 + 216 + 1166400). */
    void spreadIsThatOfTheTrack()
    {
        Scenario scenario = windAndCurrent();
        Iceberg& iceberg = scenario.icebergs[0];
        iceberg.sigma0_m2 = 25;
        iceberg.q_m2ps = 0.02;
        iceberg.velocitySd_mps = 0.1;
        COMPARE_NEAR(trackOf(scenario).points.at(1).sd_m, 1080.1116, 1e-3);
        iceberg.observed_s = 7200;
        iceberg.velocitySpread_mps = 0.15;
        iceberg.velocityTime_s = 36000;
        Track track = initialTrack(iceberg, ObserverModel::Kalman);
        for (int step = 0; step < 3600; ++step)
            track.grow(3);
        COMPARE_NEAR(trackOf(scenario).points.at(1).sd_m, std::sqrt(track.sigma_m2), 1e-5);
    }

    /** Without a length the estimate is that of the Kalman track in the current. */
    void ownVelocityFades()
    {
        Scenario scenario = windAndCurrent();
        Iceberg& iceberg = scenario.icebergs[0];
        iceberg.length_m.reset();
        iceberg.velocity_mps = {-0.2, 0.1};
        iceberg.velocityTime_s = 36000;
        const Track track = initialTrack(iceberg, ObserverModel::Kalman, scenario.current_mps);
        for (const DriftTrackPoint& point : trackOf(scenario).points)
            COMPARE_NEAR((point.position_m - track.estimate_m(point.time_s)).norm(), 0, 1e-6);
        iceberg.velocityTime_s = 0;
        const DriftTrackPoint last = trackOf(scenario).points.back();
        COMPARE_NEAR(last.position_m.x(), -0.2 * last.time_s, 1e-6);
    }

    void endsWithTheForecast()
    {
        const DriftTrack track = trackOf(sixHours(std::nullopt));
        QCOMPARE(track.points.size(), 3U); // 0, 3 and 6 h
        QCOMPARE(track.end, DriftTrackEnd::ForecastEnds);
        COMPARE_NEAR(track.points.back().position_m.x(), 0.16932 * 6 * kHour_s, 0.4);
        QVERIFY(!track.grounded_s);
        Scenario later = sixHours(std::nullopt);
        later.startUtc = "2026-06-01T12:00:00Z";
        QVERIFY(trackOf(later).points.empty());
        // Without a length the wind does not matter.
        Scenario noWind = sixHours(std::nullopt);
        noWind.forecast->places[0].series[1].wind_mps.reset();
        QCOMPARE(trackOf(noWind).points.size(), 1U);
        noWind.icebergs[0].length_m.reset();
        QCOMPARE(trackOf(noWind).points.size(), 3U);
    }

    /** The draft is 1.78 L^0.71: 46.8 m for 100 m and 76.6 m for 200 m. */
    void deepIcebergsGround()
    {
        QVERIFY(!trackOf(sixHours(50)).grounded_s);
        Scenario scenario = sixHours(50);
        scenario.icebergs[0].length_m = 200;
        const DriftTrack track = trackOf(scenario);
        QCOMPARE(track.grounded_s, 0.0);
        QCOMPARE(track.points.back().position_m, Point(0, 0));
        QVERIFY(track.points.back().isAground);
        QCOMPARE(track.points.back().velocity_mps, Point(0, 0));
    }

    /** 60 m at the start, 40 m one degree farther north: aground after a third of 111.5 km. */
    void groundsOnTheWay()
    {
        Scenario scenario = sixHours(60);
        Forecast north = scenario.forecast->places[0];
        north.place.latitude_deg += 0.05;
        north.depth_m = 40;
        scenario.forecast->places.push_back(north);
        const DriftTrack track = trackOf(scenario, {.every_s = kHour_s, .duration_s = 6 * kHour_s});
        QVERIFY(track.grounded_s);
        // (60 - 46.8) / 20 of 5575 m at 0.295 m/s, to a step of 15 min
        COMPARE_NEAR(*track.grounded_s, 0.66 * 5575 / 0.29492, 900);
    }

    /** Without a sighting, a prediction made later continues the first one. */
    void laterPredictionContinuesTheFirst()
    {
        Scenario scenario = sixHours(std::nullopt);
        scenario.observer.model = ObserverModel::Kalman;
        Iceberg& iceberg = scenario.icebergs[0];
        iceberg.velocity_mps = {0.1, -0.2};
        iceberg.velocitySd_mps = 0.05;
        iceberg.velocitySpread_mps = 0.1;
        iceberg.velocityTime_s = 36'000;
        const DriftTrackSpec spec{.every_s = kHour_s, .duration_s = 2 * kHour_s};
        const DriftTrack whole = trackOf(scenario, {.every_s = kHour_s, .duration_s = 4 * kHour_s});
        const auto weather = weatherOf(scenario);
        Track track = trackAtStart(scenario, iceberg, weather);
        const double now_s = 2 * kHour_s;
        growUnseen(track, forcingOf(weather, iceberg).get(), 0, now_s);
        DriftInstant instant{
            .time_s = now_s, .icebergs = {iceberg, iceberg}, .tracks = {track, std::nullopt}};
        const std::vector<DriftTrack> later = driftTracks(scenario, instant, spec);
        QCOMPARE(later.size(), std::size_t{2});
        QVERIFY(later[1].points.empty());
        QCOMPARE(later[0].points.size(), std::size_t{3});
        for (std::size_t i = 0; i < 3; ++i) {
            const DriftTrackPoint& point = later[0].points[i];
            const DriftTrackPoint& same = whole.points[i + 2];
            COMPARE_NEAR(point.time_s, same.time_s, 1e-9);
            QVERIFY((point.position_m - same.position_m).norm() < 0.1); // steps of 60 s and 15 min
            QVERIFY((point.velocity_mps - same.velocity_mps).norm() < 1e-6);
            COMPARE_NEAR(point.sd_m, same.sd_m, 1e-6 * same.sd_m);
        }
        // The simple observer takes the velocity as known; the spread on the map does not.
        scenario.observer.model = ObserverModel::Simple;
        COMPARE_NEAR(driftTracks(scenario, instant, spec)[0].points[1].sd_m, whole.points[3].sd_m,
                     1e-6 * whole.points[3].sd_m);
        instant.tracks[0]->seen(Point(500, 600), now_s);
        const DriftTrack seen = driftTracks(scenario, instant, spec)[0];
        QCOMPARE(seen.points[0].position_m, Point(500, 600));
        QCOMPARE(seen.points[0].sd_m, 0.0);
        QVERIFY(seen.points[1].sd_m > 0 && seen.points[1].sd_m < whole.points[3].sd_m);
    }

    void recordedTracksAreCompared()
    {
        Scenario scenario = windAndCurrent();
        scenario.icebergs[0].track = {.time_s = {0, 6 * kHour_s},
                                      .position_m = {{100, 0}, {100, 0}}};
        const DriftTrack track = trackOf(scenario);
        COMPARE_NEAR(*track.points.at(0).error_m, 100, 1e-9);
        COMPARE_NEAR(*track.points.at(1).error_m,
                     std::hypot(0.16932 * 10800 - 100, 0.29492 * 10800), 0.5);
        QVERIFY(!track.points.at(3).error_m);
    }

    /** A day at 0.3 m/s to the north, one position an hour, in a current of the same velocity. */
    void leadErrorsOfARecordedTrack()
    {
        Scenario scenario = windAndCurrent();
        scenario.icebergs[0].length_m.reset();
        for (int hour = 0; hour <= 24; ++hour) {
            scenario.icebergs[0].track.time_s.push_back(hour * kHour_s);
            scenario.icebergs[0].track.position_m.emplace_back(0, 0.3 * hour * kHour_s);
        }
        const std::vector<DriftLeadError> errors =
            recordedDriftErrors(scenario, scenario.icebergs[0], kCCoreDrag);
        QCOMPARE(errors.at(0).lead_s, 6 * kHour_s);
        QCOMPARE(errors.at(0).starts, 16U); // from 3 h to 18 h
        COMPARE_NEAR(errors.at(0).moved_m, 6480, 10);
        COMPARE_NEAR(errors.at(0).drift_m, 0, 1);
        QCOMPARE(recordedDriftErrors(scenario, {}, kCCoreDrag).at(0).starts, 0U);
    }
};

QTEST_APPLESS_MAIN(TestDriftTracks)
#include "tst_drift_tracks.moc"
