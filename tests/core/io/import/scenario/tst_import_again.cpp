#include "core/checks/validate.h"
#include "core/io/import/scenario/import_scenario.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/import_fixtures.h"
#include "tests/support/flight/scenario_builder.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;

/** Imports into a scenario that has icebergs already. */
class TestImportAgain : public QObject
{
    Q_OBJECT

private slots:
    /** The name, and all values that the file does not give, stay those of the user. */
    void reimportUpdatesIcebergs()
    {
        Scenario base = importSightings(openSea(), northward(3)).scenario;
        base.icebergs[0].name = "mine";
        base.icebergs[0].radius_m = 77;
        base.icebergs[0].sigma0_m2 = 3;
        base.icebergs[0].appears_s = 30;
        base.icebergs[0].extraJson = R"({"colour":"blue"})";
        const ImportResult again = importSightings(base, northward(3));
        QCOMPARE(again.unchanged, std::size_t{1});
        QVERIFY(again.scenario == base);

        const ImportResult newer = importSightings(base, northward(9));
        QCOMPARE(newer.updated, std::size_t{1});
        const Iceberg& iceberg = newer.scenario.icebergs.at(0);
        QCOMPARE(iceberg.name, std::string("mine"));
        QCOMPARE(iceberg.radius_m, 77.0);
        QVERIFY(iceberg.sigma0_m2 > 100 && iceberg.sigma0_m2 < 400); // of the new sightings
        QCOMPARE(iceberg.extraJson, std::string(R"({"colour":"blue"})"));
        QCOMPARE(newer.scenario.startUtc, std::string("2024-05-01T01:20:00Z"));
        QVERIFY(newer.scenario.origin == base.origin);
        COMPARE_NEAR(iceberg.position_m.y(), 6 * 111.4, 5);
    }

    void olderSightingsChangeNothing()
    {
        const Scenario base = importSightings(openSea(), northward(9)).scenario;
        const ImportResult result = importSightings(base, northward(3));
        QCOMPARE(result.unchanged, std::size_t{1});
        QVERIFY(has(result.icebergs[0], ImportNote::Older));
        QVERIFY(result.scenario == base);
    }

    /** An iceberg seen at the same time at another place gets the variance of that place. */
    void anotherPlaceHasItsOwnVariance()
    {
        const Scenario base =
            importSightings(openSea(), csv("a,2024-05-01T00:00:00Z,60,-50\n")).scenario;
        const ImportOptions rough{.positionSd_m = 1000};
        for (const char* text :
             {"id,time,lat,lon\na,2024-05-01T00:00:00Z,60.05,-50\n", "id,lat,lon\na,60.05,-50\n"}) {
            const ImportResult moved = importSightings(base, readSightings(text, "file"), rough);
            QCOMPARE(moved.updated, std::size_t{1});
            QCOMPARE(moved.scenario.icebergs[0].sigma0_m2, 1e6);
        }
    }

    /** Without times there is no track, so each place is an iceberg. */
    void oneNameAtSeveralPlacesIsSeveralIcebergs()
    {
        const ImportResult result = importSightings(
            openSea(), readSightings("id,lat,lon\nBerg,60,-50\nBerg,60,-50.1\nBerg,60,-50\n"
                                     "Berg 2,60,-50.2\n",
                                     "file"));
        QCOMPARE(result.added, std::size_t{3});
        QCOMPARE(result.scenario.icebergs[0].id, std::string("Berg"));
        QCOMPARE(result.scenario.icebergs[1].id, std::string("Berg 2"));
        QCOMPARE(result.scenario.icebergs[2].id, std::string("Berg 2 2"));
        QVERIFY(has(result.icebergs[0], ImportNote::Repeated));
    }

    /** A note says that a sighting without a time counts as seen now. */
    void sightingsWithoutATimeAreNoted()
    {
        const auto waypoints = [](const std::string& time) {
            return readSightings("<gpx xmlns=\"http://www.topografix.com/GPX/1/1\">"
                                 "<wpt lat=\"60\" lon=\"-50\">" +
                                     time +
                                     "<name>a</name></wpt><wpt lat=\"60.1\" lon=\"-50\">"
                                     "<name>b</name></wpt></gpx>",
                                 "file");
        };
        const ImportResult result =
            importSightings(openSea(), waypoints("<time>2024-05-01T01:00:00Z</time>"));
        QCOMPARE(result.icebergs.size(), std::size_t{2});
        QVERIFY(!has(result.icebergs[0], ImportNote::TimeUnknown));
        QVERIFY(has(result.icebergs[1], ImportNote::TimeUnknown));
        const ImportResult undated = importSightings(openSea(), waypoints({}));
        QVERIFY(!has(undated.icebergs[0], ImportNote::TimeUnknown)); // no sighting has a time
    }

    /** One sighting does not show a velocity, so the previous one moves it on. */
    void oneSightingKeepsTheVelocity()
    {
        const Scenario base = importSightings(openSea(), northward(9)).scenario;
        const ImportResult result =
            importSightings(base, csv("b,2024-05-01T04:00:00Z,60.03,-50.01\n"));
        QCOMPARE(result.updated, std::size_t{1});
        QVERIFY(has(result.icebergs[0], ImportNote::VelocityUnknown));
        const Iceberg& now = result.scenario.icebergs[0];
        const Point faded_mps = base.icebergs[0].velocity_mps * std::exp(-9600 / 36'000.0);
        COMPARE_NEAR((now.velocity_mps - faded_mps).norm(), 0, 1e-6);
        QVERIFY(now.velocitySd_mps > base.icebergs[0].velocitySd_mps + 0.03);
        QVERIFY(now.velocitySd_mps < 0.15);
    }

    /** Existing icebergs drift on to the new start. */
    void otherIcebergsDriftToTheNewStart()
    {
        Scenario base = emptySea();
        base.startUtc = "2024-05-01T00:00:00Z";
        base.current_mps = {0, 0.1};
        Iceberg& other = addIceberg(base, 1000, 2000);
        other.velocity_mps = {0.2, 0};
        other.appears_s = 1800;
        other.track = {.time_s = {0, 9000}, .position_m = {{0, 0}, {1, 1}}};
        base.asset = Asset{.name = "rig", .velocity_mps = {1, 0}};
        const ImportResult result =
            importSightings(base, csv("x,2024-05-01T01:00:00Z,47.01,-48.01\n"));
        const Iceberg& moved = result.scenario.icebergs.at(0);
        COMPARE_NEAR((moved.position_m - Point(1720, 2360)).norm(), 0, 1e-9);
        QCOMPARE(moved.observed_s, 3600.0);
        QCOMPARE(moved.appears_s, 0.0);
        QVERIFY(moved.track.time_s == (std::vector<double>{-3600, 5400}));
        QVERIFY(result.scenario.asset->position_m == Point(3600, 0));
        QCOMPARE(result.scenario.icebergs.at(1).id, std::string("x"));
        QVERIFY(result.scenario.origin == base.origin);
        QVERIFY(!hasErrors(validate(result.scenario)));

        const ImportOptions late{.at = utc("2044-05-01T00:00:00Z")};
        QCOMPARE(codeOf([&] { (void)importSightings(base, csv("x,2024-05-01,47,-48\n"), late); }),
                 std::string("InvalidInput"));
    }

    void withoutTimesTheStartStays()
    {
        Scenario base = openSea();
        const ImportResult result = importSightings(base, readFixture("metno.geojson"));
        QVERIFY(!result.at && result.scenario.startUtc.empty());
        QCOMPARE(result.added, std::size_t{4});
        QCOMPARE(result.scenario.icebergs[1].id, std::string("59.61N 42.87W"));
        base.startUtc = "2024-05-01T00:00:00Z";
        QCOMPARE(importSightings(base, readFixture("metno.geojson")).scenario.startUtc,
                 base.startUtc);
    }

    /** Without ids, the same file again changes nothing, and another file means other icebergs. */
    void unnamedIcebergsAreNamedByPlaceOrTime()
    {
        const Scenario base = importSightings(openSea(), readFixture("metno.geojson")).scenario;
        const ImportResult again = importSightings(base, readFixture("metno.geojson"));
        QCOMPARE(again.unchanged, std::size_t{4});
        const ImportResult other = importSightings(
            base, readSightings("lat,lon\n59.53,-42.6\n59.54,-42.6\n", "other.csv"));
        QCOMPARE(other.added, std::size_t{2});
        const ImportResult track = importSightings(
            openSea(),
            readSightings("time,lat,lon\n2024-05-01,60,-50\n2024-05-02,60.1,-50\n", "track.csv"));
        QCOMPARE(track.scenario.icebergs.at(0).id, std::string("track 2024-05-01T00:00:00Z"));
        QCOMPARE(track.icebergs.at(0).sightings, std::size_t{2});
    }

    void idOfAUavIsLeftOut()
    {
        const ImportResult result =
            importSightings(openSea(), csv("uav-1,2024-05-01,60,-50\nb,2024-05-01,60,-50\n"));
        QCOMPARE(result.leftOut, std::size_t{1});
        QVERIFY(has(result.icebergs[0], ImportNote::IdTaken));
        QCOMPARE(result.added, std::size_t{1});
    }
};

QTEST_APPLESS_MAIN(TestImportAgain)
#include "tst_import_again.moc"
