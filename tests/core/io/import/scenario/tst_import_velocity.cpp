#include "core/base/angles.h"
#include "core/base/random.h"
#include "core/io/import/scenario/import_scenario.h"
#include "core/tracking/position_error.h"
#include "tests/support/approx.h"
#include "tests/support/files/import_fixtures.h"

#include <QtTest>

#include <chrono>
#include <cmath>

using namespace berg;
using namespace berg::test;

namespace {

constexpr LatLon kOrigin{.latitude_deg = 60, .longitude_deg = -50};

/**
 * Sightings of an iceberg moved by the drift model, with errors, and its true drift at the last.
 */
struct Watched
{
    SightingTable table;
    Point last_mps = Point::Zero();
    ImportOptions options;
};

Watched watched(std::uint64_t seed)
{
    Random random(seed, 21);
    Watched made;
    const int count = 1 + static_cast<int>(random.uniform(0, 5.999));
    const double every_s = random.uniform(600, 30'000);
    const double sd_m = std::pow(10.0, random.uniform(1, 3.3));
    DriftModel truth({.velocity_mps = {0.15 * random.normal(), 0.15 * random.normal()},
                      .q_m2ps = 0.025,
                      .velocitySpread_mps = kFittedDrift.velocitySpread_mps,
                      .velocityTime_s = kFittedDrift.velocityTime_s},
                     seed, "watched", true);
    const LocalFrame frame(kOrigin);
    const UtcTime start = utc("2026-05-01T00:00:00Z");
    for (int i = 0; i < count; ++i) {
        Point place_m = truth.position_m(i * every_s);
        made.last_mps = truth.velocity_mps();
        for (double& axis : place_m)
            axis += sd_m * random.normal();
        Sighting sighting{.line = static_cast<std::size_t>(i) + 2, .id = "b"};
        sighting.place = frame.toGeographic(place_m);
        sighting.time = start + std::chrono::milliseconds(std::llround(i * every_s * 1000));
        made.table.sightings.push_back(sighting);
    }
    const double later_s = random.uniform(0, 40'000);
    made.options.at =
        *made.table.sightings.back().time + std::chrono::milliseconds(std::llround(later_s * 1000));
    made.options.positionSd_m = sd_m;
    made.options.moveOrigin = false;
    // q is estimated from four fixes on, so another fix may show that an iceberg is less steady.
    made.options.track.fewestForGrowth = 1000;
    return made;
}

void state(Sighting& sighting, const Point& drift_mps)
{
    sighting.speed_mps = drift_mps.norm();
    sighting.direction_deg = degFromRad(std::atan2(drift_mps.x(), drift_mps.y()));
}

ImportResult imported(const Watched& watched)
{
    Scenario sea = openSea();
    sea.origin = kOrigin;
    return importSightings(sea, watched.table, watched.options);
}

/** Variances of the result; velocities are stored to 1e-5 m/s, so sigmas to a thousandth. */
bool isNoWorse(const ImportResult& with, const ImportResult& without)
{
    constexpr double kRounding = 1e-3;
    const Iceberg& more = with.scenario.icebergs.at(0);
    const Iceberg& less = without.scenario.icebergs.at(0);
    return initialSigma_m2(more) <= initialSigma_m2(less) * (1 + kRounding) + 0.02 &&
           more.velocitySd_mps <= less.velocitySd_mps + 1e-5;
}

} // namespace

/** Tests of the sources of velocities and their uncertainty. */
class TestImportVelocity : public QObject
{
    Q_OBJECT

private slots:
    /**
     * Three sources of information are added in turn: a stated drift, an earlier fix, a position
     * source.
     */
    void knowledgeNeverWorsens()
    {
        int combined = 0;
        for (std::uint64_t seed = 0; seed < 500; ++seed) {
            Random random(seed, 22);
            const Watched plain = watched(seed);
            const ImportResult alone = imported(plain);
            Watched stating = plain;
            const auto row = static_cast<std::size_t>(
                random.uniform(0, static_cast<double>(plain.table.sightings.size()) - 1e-9));
            const Point error_mps(0.1 * random.normal(), 0.1 * random.normal());
            state(stating.table.sightings[row], plain.last_mps + error_mps);
            const ImportResult stated = imported(stating);
            QVERIFY2(isNoWorse(stated, alone), std::to_string(seed).c_str());
            combined += stated.icebergs[0].velocityFrom == VelocitySource::Both ? 1 : 0;
            if (row > 0) { // skips the first fix, which does not show a drift
                for (Watched more : {plain, stating}) {
                    Watched fewer = more;
                    fewer.table.sightings.pop_front();
                    const ImportResult all = imported(more);
                    if (has(all.icebergs[0], ImportNote::Contradicted))
                        continue; // the further fix contradicts the drift, which is dropped
                    QVERIFY2(isNoWorse(all, imported(fewer)), std::to_string(seed).c_str());
                }
            }
            Watched seen = stating;
            for (Sighting& sighting : seen.table.sightings)
                sighting.sigma_m2 = std::pow(*plain.options.positionSd_m * 0.5, 2);
            if (stated.icebergs[0].velocityFrom == imported(seen).icebergs[0].velocityFrom)
                QVERIFY2(isNoWorse(imported(seen), stated), std::to_string(seed).c_str());
        }
        QVERIFY(combined > 200);
    }

    /** A drift that contradicts the fixes changes nothing, because positions are measured. */
    void contradictedDriftIsDropped()
    {
        int refused = 0;
        for (std::uint64_t seed = 0; seed < 300; ++seed) {
            const Watched plain = watched(seed);
            Watched stating = plain;
            state(stating.table.sightings.back(), Point(1.2, -1.2));
            const ImportResult alone = imported(plain);
            const ImportResult stated = imported(stating);
            if (!has(stated.icebergs[0], ImportNote::Contradicted))
                continue;
            ++refused;
            QVERIFY(stated.scenario.icebergs == alone.scenario.icebergs);
            QVERIFY(stated.icebergs[0].velocityFrom == VelocitySource::Fixes);
        }
        QVERIFY(refused > 50);
    }

    /** Few drifts that are right within their error are taken for contradictions. */
    void fewTrueDriftsAreContradicted()
    {
        int refused = 0;
        for (std::uint64_t seed = 0; seed < 1000; ++seed) {
            Random random(seed, 23);
            Watched stating = watched(seed);
            state(stating.table.sightings.back(),
                  stating.last_mps + Point(0.1 * random.normal(), 0.1 * random.normal()));
            refused += has(imported(stating).icebergs[0], ImportNote::Contradicted) ? 1 : 0;
        }
        QVERIFY(refused <= 6); // 1 is expected; 6 or more of Poisson(1) happen once in 1700
    }

    /**
     * Two fixes an hour apart give 0.1857 m/s north and the file 0.18: the result is their weighted
     * mean.
     */
    void fixesAndFileAreCombined()
    {
        const auto withDrift = [](const char* drift) {
            return importSightings(openSea(),
                                   readText("id,time,lat,lon,speed,direction\n"
                                            "a,2024-05-01T00:00:00Z,60,-50,,\n"
                                            "a,2024-05-01T01:00:00Z,60.006,-50," +
                                            std::string(drift) + "\n"),
                                   {.at = utc("2024-05-01T02:50:00Z"), .positionSd_m = 20});
        };
        const ImportResult alone = withDrift(",");
        const ImportResult both = withDrift("0.10,0");
        const Iceberg& without = alone.scenario.icebergs.at(0);
        const Iceberg& with = both.scenario.icebergs.at(0);
        QVERIFY(with.velocitySd_mps < without.velocitySd_mps);
        QVERIFY(initialSigma_m2(with) < initialSigma_m2(without));
        const double file_m2ps2 = 0.1 * 0.1;
        const double fixes_m2ps2 = without.velocitySd_mps * without.velocitySd_mps;
        COMPARE_NEAR(with.velocitySd_mps, std::sqrt(1 / (1 / file_m2ps2 + 1 / fixes_m2ps2)), 2e-5);
        const double kept = std::exp(-6600 / 36'000.0);
        const double fixes_mps = without.velocity_mps.y() / kept;
        const double mean_mps =
            (0.10 / file_m2ps2 + fixes_mps / fixes_m2ps2) / (1 / file_m2ps2 + 1 / fixes_m2ps2);
        COMPARE_NEAR(with.velocity_mps.y(), mean_mps * kept, 5e-5);
        QVERIFY(alone.icebergs[0].velocityFrom == VelocitySource::Fixes);
        QVERIFY(both.icebergs[0].velocityFrom == VelocitySource::Both);
        QCOMPARE(both.icebergs[0].velocityAge_s, 6600.0);
        QVERIFY(importJson(readText("id,lat,lon\na,60,-50\n"), both)
                    .find(R"("velocity_from": "both", "velocity_age_s": 6600)") !=
                std::string::npos);
    }

    /** The last stated drift is used, with its own age. */
    void driftOfAnEarlierFixIsUsed()
    {
        const ImportResult result =
            importSightings(openSea(),
                            readText("id,time,lat,lon,speed,direction\n"
                                     "a,2024-05-01T00:00:00Z,60,-50,0.2,90\n"
                                     "b,2024-05-01T00:30:00Z,61,-50,,\n"),
                            {.at = utc("2024-05-01T01:00:00Z")});
        QVERIFY(result.icebergs[0].velocityFrom == VelocitySource::File);
        QCOMPARE(result.icebergs[0].velocityAge_s, 3600.0);
        QCOMPARE(result.scenario.icebergs[0].velocitySd_mps, 0.1);
        QVERIFY(result.icebergs[1].velocityFrom == VelocitySource::Nothing);
        QCOMPARE(result.scenario.icebergs[1].velocitySd_mps, 0.15);
    }

    void sourcesOfRowsSetTheirErrors_data()
    {
        QTest::addColumn<std::string>("column");
        QTest::addColumn<std::string>("word");
        QTest::addColumn<double>("sd_m");
        QTest::newRow("VIS") << std::string("method") << std::string("VIS") << 500.0;
        QTest::newRow("radar") << std::string("Source") << std::string("Radar") << 150.0;
        QTest::newRow("SAT") << std::string("sensor") << std::string("SAT") << 50.0;
        QTest::newRow("RADARSAT") << std::string("sensor") << std::string("RADARSAT-2") << 50.0;
        QTest::newRow("AIS") << std::string("source") << std::string("AIS") << 30.0;
        QTest::newRow("GPS") << std::string("source") << std::string("GPS") << 25.0;
        QTest::newRow("Argos") << std::string("source") << std::string("ARGOS") << 300.0;
        QTest::newRow("both eyes") << std::string("method") << std::string("RADAR/VIS") << 150.0;
        QTest::newRow("a name") << std::string("source") << std::string("Norden") << 77.0;
        QTest::newRow("nothing") << std::string("source") << std::string() << 77.0;
    }
    void sourcesOfRowsSetTheirErrors()
    {
        QFETCH(std::string, column);
        QFETCH(std::string, word);
        QFETCH(double, sd_m);
        const ImportResult result = importSightings(
            openSea(), readText("id,lat,lon," + column + "\na,60,-50," + word + "\n"),
            {.positionSd_m = 77});
        COMPARE_NEAR(std::sqrt(result.scenario.icebergs[0].sigma0_m2), sd_m, 0.01);
        const SightingTable exact =
            readText("id,lat,lon,sigma," + column + "\na,60,-50,9," + word + "\n");
        QCOMPARE(importSightings(openSea(), exact).scenario.icebergs[0].sigma0_m2, 9.0);
    }

    void doubtsNeedConsent_data()
    {
        QTest::addColumn<std::string>("rows");
        QTest::addColumn<bool>("fast");
        QTest::addColumn<bool>("land");
        QTest::newRow("at sea") << std::string("a,2024-05-01T01:00:00Z,60,-50,0.3,90\n") << false
                                << false;
        QTest::newRow("at the limit")
            << std::string("a,2024-05-01T01:00:00Z,60,-50,1.5,90\n") << false << false;
        QTest::newRow("stated fast")
            << std::string("a,2024-05-01T01:00:00Z,60,-50,1.6,90\n") << true << false;
        QTest::newRow("fixes of two icebergs") // 10 km in an hour, which is just possible
            << std::string("a,2024-05-01T00:00:00Z,60,-50,,\na,2024-05-01T01:00:00Z,60.09,-50,,\n")
            << true << false;
        QTest::newRow("inland") << std::string("a,2024-05-01T01:00:00Z,48.7,-56,0.3,90\n") << false
                                << true;
    }
    void doubtsNeedConsent()
    {
        QFETCH(std::string, rows);
        QFETCH(bool, fast);
        QFETCH(bool, land);
        const ImportResult result =
            importSightings(openSea(), readText("id,time,lat,lon,speed,direction\n" + rows));
        QCOMPARE(has(result.icebergs[0], ImportNote::TooFast), fast);
        QCOMPARE(has(result.icebergs[0], ImportNote::OnLand), land);
        QCOMPARE(needsConsent(result), fast || land);
        QVERIFY(importJson(readText("id,lat,lon\na,60,-50\n"), result)
                    .find(fast || land ? R"("needs_consent": true)"
                                       : R"("needs_consent": false)") != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(TestImportVelocity)
#include "tst_import_velocity.moc"
