#include "core/checks/validate.h"
#include "core/io/import/scenario/import_scenario.h"
#include "core/mission/mission.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/import_fixtures.h"
#include "tests/support/flight/scenario_builder.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace berg;
using namespace berg::test;

class TestImportScenario : public QObject
{
    Q_OBJECT

private slots:
    /** Waypoints within 11 m share an id except for a number, whose search was quadratic. */
    void manyWaypointsAtOnePlaceAreFast()
    {
        std::string text = "lat,lon\n";
        for (int i = 0; i < 50'000; ++i)
            text += "47.0000" + std::to_string(100'000 + i) + ",-48\n";
        const SightingTable table = readSightings(text, "file");
        QCOMPARE(table.sightings.size(), std::size_t{50'000});
        const ImportResult result = importSightings(newScenarioForImport("x"), table);
        QCOMPARE(result.added, std::size_t{1000});
        QCOMPARE(result.leftOut + result.added, std::size_t{50'000});
    }

    void lastSightingIsTheStart()
    {
        const ImportResult result = importSightings(openSea(), northward(13));
        QCOMPARE(result.scenario.startUtc, std::string("2024-05-01T02:00:00Z"));
        QCOMPARE(result.added, std::size_t{1});
        const Iceberg& iceberg = result.scenario.icebergs.at(0);
        QCOMPARE(iceberg.id, std::string("b"));
        QVERIFY(iceberg.position_m.norm() < 5); // the origin is at its last place
        COMPARE_NEAR(iceberg.velocity_mps.y(), kNorthward_mps, 0.01);
        QCOMPARE(iceberg.observed_s, 0.0);
        COMPARE_NEAR(result.scenario.origin.latitude_deg, 60.012, 1e-9);
        COMPARE_NEAR(result.scenario.origin.longitude_deg, -50, 1e-9);
        QVERIFY(!hasErrors(validate(result.scenario)));
    }

    /** Existing errors of the scenario do not prevent an import. */
    void existingErrorsDoNotPreventAnImport()
    {
        Scenario base = openSea();
        base.wind_mps = {100, 0};
        QVERIFY(hasErrors(validate(base)));
        const ImportResult result = importSightings(base, northward(13));
        QCOMPARE(result.added, std::size_t{1});
        QVERIFY(hasErrors(validate(result.scenario)));
    }

    /** Drift and uncertainty are advanced from the last sighting to the chosen start. */
    void sightingsAreAdvancedToTheStart()
    {
        const ImportOptions options{.at = utc("2024-05-01T03:00:00Z"),
                                    .track = {},
                                    .positionSd_m = std::sqrt(5),
                                    .q_m2ps = 0.5};
        const ImportResult result = importSightings(openSea(), northward(3), options);
        const Iceberg& iceberg = result.scenario.icebergs.at(0);
        const double age_s = 3 * 3600 - 1200;
        QCOMPARE(iceberg.observed_s, age_s);
        QCOMPARE(iceberg.q_m2ps, 0.5); // three sightings are too few for an estimate
        COMPARE_NEAR(iceberg.position_m.y(), kNorthward_mps * age_s, 3);
        QCOMPARE(initialSigma_m2(iceberg), 5 + 0.5 * age_s);
    }

    void currentIsNotCountedTwice()
    {
        Scenario base = openSea();
        base.current_mps = {0.05, 0.1};
        const ImportOptions options{.at = utc("2024-05-01T03:00:00Z"), .track = {}};
        const ImportResult result = importSightings(base, northward(3), options);
        const Iceberg& iceberg = result.scenario.icebergs.at(0);
        COMPARE_NEAR(iceberg.velocity_mps.x(), -0.05, 1e-4);
        COMPARE_NEAR(iceberg.velocity_mps.y(), kNorthward_mps - 0.1, 2e-4);
        COMPARE_NEAR(iceberg.position_m.y(), kNorthward_mps * 9600, 3);
    }

    void velocityOfTheFileIsUsed_data()
    {
        QTest::addColumn<double>("latitude_deg");
        QTest::newRow("middle latitude") << 60.0;
        QTest::newRow("southern") << -60.0;
        QTest::newRow("near the pole") << 89.9995;
        QTest::newRow("south pole") << -90.0;
    }

    void velocityOfTheFileIsUsed()
    {
        QFETCH(double, latitude_deg);
        const std::string row = std::to_string(latitude_deg) + ",20,0.3,90\n";
        const ImportResult result =
            importSightings(openSea(), readSightings("lat,lon,speed,direction\n" + row, "file"));
        const Iceberg& iceberg = result.scenario.icebergs.at(0);
        COMPARE_NEAR(iceberg.velocity_mps.norm(), 0.3, 2e-5);
        QVERIFY(has(result.icebergs[0], ImportNote::VelocityGiven));
        if (std::abs(latitude_deg) < 80)
            COMPARE_NEAR(iceberg.velocity_mps.x(), 0.3, 1e-4); // the origin is here, so x is east
    }

    void fastOnesAreClamped()
    {
        const ImportResult result = importSightings(
            openSea(), readSightings("lat,lon,speed_kn,direction\n60,20,60,90\n", "file"));
        QCOMPARE(result.scenario.icebergs.at(0).velocity_mps.x(), 5.0);
        QVERIFY(has(result.icebergs[0], ImportNote::VelocityClamped));
    }

    void groundedStandsStill()
    {
        const ImportResult result = importSightings(openSea(), readFixture("usnic.csv"));
        const Iceberg& iceberg = result.scenario.icebergs.at(0);
        QCOMPARE(iceberg.id, std::string("A97Z"));
        QVERIFY(has(result.icebergs[0], ImportNote::Stationary));
        QCOMPARE(iceberg.q_m2ps, 0.0);
        QVERIFY(iceberg.velocity_mps.isZero(0));
        QCOMPARE(iceberg.radius_m, 22 * 1852.0);
        QCOMPARE(iceberg.observed_s, 7 * 86400.0);
    }

    void timesAndAreasSelect()
    {
        const SightingTable table = csv("a,2024-05-01T00:00:00Z,60,-50\n"
                                        "b,2024-05-02T00:00:00Z,60.1,-50\n"
                                        "c,2024-05-03T00:00:00Z,60.2,-50\n"
                                        "d,2024-05-02T00:00:00Z,65,-50\n");
        const ImportResult result = importSightings(
            openSea(), table,
            {.since = utc("2024-05-01T12:00:00Z"),
             .until = utc("2024-05-02T12:00:00Z"),
             .area = GeoBox{.south_deg = 59, .west_deg = -51, .north_deg = 61, .east_deg = -49}});
        QCOMPARE(result.outsideTime, std::size_t{2});
        QCOMPARE(result.outsideArea, std::size_t{1});
        QCOMPARE(result.scenario.icebergs.size(), std::size_t{1});
        QCOMPARE(result.scenario.icebergs[0].id, std::string("b"));
    }

    void boxContainsItsEdges_data()
    {
        QTest::addColumn<double>("west_deg");
        QTest::addColumn<double>("east_deg");
        QTest::addColumn<double>("longitude_deg");
        QTest::addColumn<bool>("inside");
        QTest::newRow("plain") << -60.0 << -40.0 << -50.0 << true;
        QTest::newRow("edge") << -60.0 << -40.0 << -40.0 << true;
        QTest::newRow("outside") << -60.0 << -40.0 << -39.9 << false;
        QTest::newRow("antimeridian, west") << 170.0 << -170.0 << 175.0 << true;
        QTest::newRow("antimeridian, east") << 170.0 << -170.0 << -175.0 << true;
        QTest::newRow("antimeridian, outside") << 170.0 << -170.0 << 0.0 << false;
        QTest::newRow("beyond 180") << 170.0 << 190.0 << -175.0 << true;
        QTest::newRow("all") << -180.0 << 180.0 << 12.0 << true;
    }

    void boxContainsItsEdges()
    {
        QFETCH(double, west_deg);
        QFETCH(double, east_deg);
        QFETCH(double, longitude_deg);
        QFETCH(bool, inside);
        const GeoBox box{.west_deg = west_deg, .east_deg = east_deg};
        QCOMPARE(box.contains({.latitude_deg = 10, .longitude_deg = longitude_deg}), inside);
    }

    void importWorksAcrossTheAntimeridian()
    {
        const ImportResult result = importSightings(openSea(),
                                                    csv("a,2024-05-01T00:00:00Z,70,179.9\n"
                                                        "a,2024-05-01T10:00:00Z,70,-179.9\n"
                                                        "b,2024-05-01T10:00:00Z,70,179.7\n"),
                                                    {.track = {}});
        COMPARE_NEAR(std::abs(result.scenario.origin.longitude_deg), 179.9, 1e-9);
        COMPARE_NEAR(result.scenario.icebergs[0].velocity_mps.x(), 7633.0 / 36000, 1e-3);
        COMPARE_NEAR(result.scenario.icebergs[0].position_m.x(), 7633, 20);
        COMPARE_NEAR(result.scenario.icebergs[1].position_m.x(), -7633, 20);
    }

    void farAwayIsRejected()
    {
        Scenario base = openSea();
        base.origin = {.latitude_deg = 60, .longitude_deg = -50};
        const ImportResult result = importSightings(
            base, csv("a,2024-05-01T00:00:00Z,60,-50\nb,2024-05-01T00:00:00Z,45,-50\n"),
            {.moveOrigin = false});
        QCOMPARE(result.rejected.count, std::size_t{1});
        QCOMPARE(result.rejected.first[0].line, std::size_t{3});
        QVERIFY(result.rejected.first[0].fault == IssueId::TooFar);
        QCOMPARE(result.scenario.icebergs.size(), std::size_t{1});
        QVERIFY(result.scenario.origin == base.origin);
    }

    void driftingOffThePlaneIsLeftOut()
    {
        const ImportResult result =
            importSightings(openSea(), northward(4),
                            {.at = utc("2024-12-01T00:00:00Z"), .track = {}}); // 3400 km away
        QCOMPARE(result.leftOut, std::size_t{1});
        QVERIFY(has(result.icebergs[0], ImportNote::DriftedAway));
        QVERIFY(result.scenario.icebergs.empty());
    }

    /** A chosen start is kept if no sighting is later, also without icebergs. */
    void chosenStartIsKept()
    {
        Scenario base = openSea();
        base.startUtc = "2024-05-01T03:00:00Z";
        const ImportResult result = importSightings(base, northward(13));
        QCOMPARE(result.scenario.startUtc, base.startUtc);
        QCOMPARE(result.scenario.icebergs.at(0).observed_s, 3600.0);

        base.startUtc = "2024-05-01T01:00:00Z";
        QCOMPARE(importSightings(base, northward(13)).scenario.startUtc,
                 std::string("2024-05-01T02:00:00Z"));
    }

    /** A fading drift is moved back as far as it is moved on. */
    void earlierStartMovesBackwards()
    {
        Scenario base = openSea();
        base.startUtc = "2024-05-03T00:00:00Z";
        base.icebergs = {{.id = "there", .velocity_mps = {0.15, 0}, .velocityTime_s = 36'000}};
        const ImportResult result =
            importSightings(base, northward(13), {.at = utc("2024-05-01T03:00:00Z")});
        const auto there = std::ranges::find(result.scenario.icebergs, "there", &Iceberg::id);
        QVERIFY(there != result.scenario.icebergs.end());
        const double back_m = 0.15 * 36'000 * (1 - std::exp(-45 * 3600 / 36'000.0));
        COMPARE_NEAR((there->position_m - Point(-back_m, 0)).norm(), 0, 1);
    }

    void newestThousandAreTaken()
    {
        std::string rows;
        for (int i = 0; i < 1200; ++i) {
            rows += 'b';
            rows += std::to_string(i);
            rows += ',';
            rows += utcText(utc("2024-05-01T00:00:00Z"), i * 60.0);
            rows += ",60,-50\n";
        }
        const ImportResult result = importSightings(openSea(), csv(rows));
        QCOMPARE(result.added, kMostIcebergs);
        QCOMPARE(result.leftOut, std::size_t{200});
        QVERIFY(has(result.icebergs[0], ImportNote::TooMany));
        QCOMPARE(result.scenario.icebergs.front().id, std::string("b200"));
    }

    void tracksHoldLaterSightings()
    {
        const ImportOptions options{
            .at = utc("2024-05-01T01:05:00Z"), .withTracks = true, .tolerance_m = 1};
        const ImportResult result = importSightings(openSea(), northward(13), options);
        const Iceberg& iceberg = result.scenario.icebergs.at(0);
        QVERIFY(has(result.icebergs[0], ImportNote::TrackAttached));
        QCOMPARE(iceberg.track.time_s.front(), 0.0);
        QCOMPARE(iceberg.track.time_s.back(), 3300.0);
        QCOMPARE(iceberg.track.time_s.size(), std::size_t{2}); // a straight line
        const LocalFrame frame(result.scenario.origin);
        const Point at_m = frame.toPlane({.latitude_deg = 60.009, .longitude_deg = -50});
        QVERIFY((iceberg.track.at(1500) - at_m).norm() < 1); // 01:30, within the tolerance
        QVERIFY(result.outsideTime == 0);
        Mission mission(result.scenario);
        mission.advance(600);
        QVERIFY((mission.simulation().truth_m(0) - iceberg.track.at(600)).norm() < 1e-9);

        const ImportResult none = importSightings(
            openSea(), northward(13), {.at = utc("2024-05-01T03:00:00Z"), .withTracks = true});
        QVERIFY(has(none.icebergs[0], ImportNote::NoTrack));
        QVERIFY(none.scenario.icebergs[0].track.empty());
    }

    void icebergsSeenOnlyLaterAreLeftOut()
    {
        const ImportOptions options{.at = utc("2024-04-01T00:00:00Z"), .withTracks = true};
        const ImportResult result = importSightings(openSea(), northward(3), options);
        QCOMPARE(result.leftOut, std::size_t{1});
        QVERIFY(has(result.icebergs[0], ImportNote::SeenLater));
    }

    void optionsAreChecked_data()
    {
        QTest::addColumn<int>("row");
        for (int i = 0; i < 6; ++i)
            QTest::addRow("%d", i) << i;
    }

    void optionsAreChecked()
    {
        QFETCH(int, row);
        const std::vector<ImportOptions> bad{
            {.positionSd_m = -1},
            {.q_m2ps = std::nan("")},
            {.tolerance_m = -1},
            {.area = GeoBox{.south_deg = 60, .north_deg = 50}},
            {.since = utc("2024-05-02T00:00:00Z"), .until = utc("2024-05-01T00:00:00Z")},
            {.moveOrigin = true}};
        Scenario base = openSea();
        addIceberg(base, 0, 0);
        QCOMPARE(codeOf([&] {
                     (void)importSightings(base, northward(2), bad[static_cast<std::size_t>(row)]);
                 }),
                 std::string("InvalidInput"));
    }

    /** Writes a scenario as a table and reads it: places, velocities and the rest agree. */
    void writtenTableIsImportedUnchanged()
    {
        Scenario scenario = openSea();
        scenario.origin = {.latitude_deg = 61.5, .longitude_deg = -55.25};
        scenario.startUtc = "2024-05-01T00:00:00Z";
        const LocalFrame frame(scenario.origin);
        std::string text = "id;name;time;latitude;longitude;speed_mps;direction_deg;sigma_m2;"
                           "q_m2ps;radius_m\n";
        for (int i = 0; i < 40; ++i) {
            Iceberg& iceberg = addIceberg(scenario, 500.0 * i, -300.0 * (i % 7), 1 + 0.25 * i);
            const double direction_deg = 9.0 * i;
            iceberg.name = "No. \"" + std::to_string(i) + '"';
            iceberg.q_m2ps = 0.125 * i;
            iceberg.radius_m = 10 + i;
            const double direction_rad = direction_deg * 3.14159265358979 / 180;
            iceberg.velocity_mps = {0.25 * std::sin(direction_rad), 0.25 * std::cos(direction_rad)};
            const LatLon place = frame.toGeographic(iceberg.position_m);
            char row[400];
            std::snprintf(row, sizeof row,
                          "%s;\"No. \"\"%d\"\"\";%s;%.9f;%.9f;0.25;%.1f;%.17g;%.17g;%.17g\r\n",
                          iceberg.id.c_str(), i, scenario.startUtc.c_str(), place.latitude_deg,
                          place.longitude_deg, direction_deg, iceberg.sigma0_m2, iceberg.q_m2ps,
                          iceberg.radius_m);
            text += row;
        }
        Scenario base = openSea();
        base.origin = scenario.origin;
        const ImportResult result = importSightings(base, readSightings(text, "table.csv"),
                                                    {.moveOrigin = false, .track = {}});
        QCOMPARE(result.added, std::size_t{40});
        for (std::size_t i = 0; i < 40; ++i) {
            Iceberg got = result.scenario.icebergs[i];
            const Iceberg& expected = scenario.icebergs[i];
            QVERIFY((got.position_m - expected.position_m).norm() < 0.02);
            // At 20 km from the origin, north differs from the plane's y axis by 0.3 degrees.
            QVERIFY((got.velocity_mps - expected.velocity_mps).norm() < 0.25 * 0.007);
            got.position_m = expected.position_m;
            got.velocity_mps = expected.velocity_mps;
            QVERIFY(got == expected);
        }
    }

    /**
     * A real beacon, 1997_12995 of the Canadian Ice Service (its file may not be distributed),
     * gives a plausible drift and a track.
     */
    void realBeaconIsImported()
    {
        const std::string path = qgetenv("BERGWATCH_BEACON_FILE").toStdString();
        if (path.empty())
            QSKIP("BERGWATCH_BEACON_FILE does not name the file");
        const SightingTable table = readSightings(readFile(path), path);
        QCOMPARE(table.sightings.size(), std::size_t{639});
        QCOMPARE(table.rejected.count, std::size_t{1});
        const ImportResult result = importSightings(
            openSea(), table, {.at = utc("1997-09-01T00:00:00Z"), .withTracks = true});
        const Iceberg& iceberg = result.scenario.icebergs.at(0);
        QVERIFY(iceberg.velocity_mps.norm() > 0.01 && iceberg.velocity_mps.norm() < 0.6);
        qInfo("velocity %.3f %.3f give or take %.3f m/s, q %.3f m2/s, position %.0f m",
              iceberg.velocity_mps.x(), iceberg.velocity_mps.y(), iceberg.velocitySd_mps,
              iceberg.q_m2ps, std::sqrt(initialSigma_m2(iceberg)));
        QVERIFY(iceberg.velocitySd_mps > 0.01 && iceberg.velocitySd_mps < 0.15);
        QVERIFY(iceberg.q_m2ps < 100);
        QVERIFY(iceberg.track.time_s.size() > 100);
        QVERIFY(!hasErrors(validate(result.scenario)));
    }

    void reportIsValidJson()
    {
        const SightingTable table = readFixture("iip.csv");
        const ImportResult result = importSightings(openSea(), table);
        const QJsonDocument document =
            QJsonDocument::fromJson(QByteArray::fromStdString(importJson(table, result)));
        const QJsonObject report = document.object();
        QCOMPARE(report["format"].toString(), QString("iip"));
        QCOMPARE(report["sightings"].toInt(), 10);
        QCOMPARE(report["rejected"].toInt(), 4);
        QCOMPARE(report["added"].toInt(), 7);
        QCOMPARE(report["icebergs"].toArray().size(), 7);
        QCOMPARE(report["rejected_rows"].toArray()[0].toObject()["line"].toInt(), 7);
        QCOMPARE(report["noted"].toInt(), 3);
        QCOMPARE(report["noted_rows"].toArray()[0].toObject()["line"].toInt(), 8);
    }
};

QTEST_APPLESS_MAIN(TestImportScenario)
#include "tst_import_scenario.moc"
