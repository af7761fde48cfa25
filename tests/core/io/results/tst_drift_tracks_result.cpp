#include "core/io/results/drift_tracks_result.h"

#include <QTest>

#include <algorithm>

using namespace berg;

namespace {

Scenario twoIcebergs()
{
    Scenario scenario;
    scenario.origin = {64, -58};
    scenario.startUtc = "2026-05-01T12:00:00Z";
    scenario.current_mps = {0, 0.5};
    scenario.icebergs = {{.id = "a,b", .sigma0_m2 = 25, .length_m = 100},
                         {.id = "tracked",
                          .position_m = {1000, 0},
                          .track = {.time_s = {0, 7200}, .position_m = {{1000, 0}, {1000, 0}}}}};
    return scenario;
}

DriftTracksReport reportOf(const Scenario& scenario)
{
    return {.scenario = scenario,
            .tracks = driftTracks(scenario, {.every_s = 3600, .duration_s = 7200}),
            .errors = {{}, recordedDriftErrors(scenario, scenario.icebergs[1], kCCoreDrag)}};
}

} // namespace

class TestDriftTracksResult : public QObject
{
    Q_OBJECT

private slots:
    void tableHasARowForEachPoint()
    {
        const Scenario scenario = twoIcebergs();
        const std::string text = driftTracksCsv(reportOf(scenario));
        QCOMPARE(std::ranges::count(text, '\n'), 7);
        QVERIFY(text.starts_with("iceberg,time,hours,latitude_deg,longitude_deg,speed_mps,"
                                 "direction_deg,sd_m,aground,error_m\n"
                                 "\"a,b\",2026-05-01T12:00:00Z,0,64.00000,-58.00000,0.4915,0.0,5.0,"
                                 "0,\n"));
        // 0.5 m/s for 2 h beside a track that stands still
        QVERIFY(text.ends_with(",0,3600.0\n"));
    }

    void documentHasTracksAndErrors()
    {
        const Scenario scenario = twoIcebergs();
        const std::string text = driftTracksJson(reportOf(scenario));
        for (const char* part : {"\"id\": \"a,b\"", "\"draft_m\": 46.8", "\"end\": \"complete\"",
                                 "\"error_m\": 3600.0", "\"errors\": ["})
            QVERIFY2(text.find(part) != std::string::npos, part);
    }

    void geoJsonHasLinesAndPoints()
    {
        Scenario scenario = twoIcebergs();
        const std::string text = driftTracksGeoJson(reportOf(scenario));
        const auto count = [&](const std::string& part) {
            std::size_t found = 0;
            for (std::size_t at = text.find(part); at != std::string::npos;
                 at = text.find(part, at + 1))
                ++found;
            return found;
        };
        QCOMPARE(count("\"LineString\""), 2U);
        QCOMPARE(count("\"Point\""), 6U);
        scenario.startUtc.clear();
        QVERIFY(driftTracksGeoJson(reportOf(scenario)).find("\"time\"") == std::string::npos);
    }
};

QTEST_APPLESS_MAIN(TestDriftTracksResult)
#include "tst_drift_tracks_result.moc"
