#include "core/io/import/scenario/import_scenario.h"
#include "tests/support/approx.h"
#include "tests/support/files/import_fixtures.h"
#include "tests/support/finding_message.h"

#include <QtTest>

#include <cmath>

using namespace berg;
using namespace berg::test;

namespace {

/** A beacon moved by the drift model: fixes over a day, each with an error. */
std::vector<Fix> beacon(std::uint64_t seed, double sd_m, double every_s, DriftModel& truth)
{
    Random random(seed, 9);
    std::vector<Fix> fixes;
    for (double time_s = 0; time_s <= 86'400; time_s += every_s) {
        Point place_m = truth.position_m(time_s);
        for (double& axis : place_m)
            axis += sd_m * random.normal();
        fixes.push_back({.time_s = time_s, .position_m = place_m, .variance_m2 = sd_m * sd_m});
    }
    return fixes;
}

DriftModel drifting(std::uint64_t seed, double q_m2ps)
{
    Random random(seed, 10);
    const double x_mps = kFittedDrift.velocitySpread_mps * random.normal();
    return {DriftSpec{.velocity_mps = {x_mps, kFittedDrift.velocitySpread_mps * random.normal()},
                      .q_m2ps = q_m2ps,
                      .velocitySpread_mps = kFittedDrift.velocitySpread_mps,
                      .velocityTime_s = kFittedDrift.velocityTime_s},
            seed, "beacon", true};
}

} // namespace

/** Tests of the stated uncertainty of imported places and velocities. */
class TestImportDrift : public QObject
{
    Q_OBJECT

private slots:
    /** An iceberg seen once, 24 hours ago, may be 9 km away and not 46 m. */
    void oneOldSightingIsUncertain()
    {
        const ImportResult result = importSightings(
            openSea(), csv("a,2024-05-01T00:00:00Z,60,-50\n"), {.at = utc("2024-05-02T00:00:00Z")});
        const Iceberg& iceberg = result.scenario.icebergs.at(0);
        QVERIFY(iceberg.velocity_mps.isZero(0));
        QCOMPARE(iceberg.velocitySd_mps, 0.15);
        QCOMPARE(iceberg.velocitySpread_mps, 0.15);
        QCOMPARE(iceberg.velocityTime_s, 36'000.0);
        QCOMPARE(iceberg.sigma0_m2, 400.0);
        COMPARE_NEAR(std::sqrt(initialSigma_m2(iceberg)), 9324, 1);
        QVERIFY(result.observerSet);
        QVERIFY(result.scenario.observer.model == ObserverModel::Kalman);
        QCOMPARE(messageOf(result.scenario, IssueId::SeenLongAgo),
                 std::string("24:00 h before the start; the iceberg may be 23000 m from this "
                             "position, 38 times the field of view"));
    }

    /**
     * For the real beacon of `tst_import_scenario`, the errors of forecasts twelve hours apart,
     * including that of the fix they are compared with, are at most the stated ones and more than
     * half of them.
     */
    void realBeaconIsWithinItsUncertainty_data()
    {
        QTest::addColumn<double>("lead_s");
        for (const int hours : {1, 6, 24})
            QTest::addRow("%d h", hours) << hours * 3600.0;
    }
    void realBeaconIsWithinItsUncertainty()
    {
        const std::string path = qgetenv("BERGWATCH_BEACON_FILE").toStdString();
        if (path.empty())
            QSKIP("BERGWATCH_BEACON_FILE does not name the file");
        QFETCH(double, lead_s);
        const SightingTable table = readSightings(readFile(path), path);
        double error = 0;
        int count = 0;
        UtcTime next = *table.sightings[40].time;
        for (const Sighting& fix : table.sightings) {
            if (!fix.time || *fix.time < next)
                continue;
            next = *fix.time + std::chrono::hours(12);
            const auto lead = std::chrono::milliseconds(std::llround(lead_s * 1000));
            const ImportResult result =
                importSightings(openSea(), table, {.at = *fix.time, .until = *fix.time - lead});
            const Iceberg& iceberg = result.scenario.icebergs.at(0);
            const Point fix_m = LocalFrame(result.scenario.origin).toPlane(fix.place);
            error +=
                (iceberg.position_m - fix_m).squaredNorm() /
                (2 * (initialSigma_m2(iceberg) + errorOf(SightingSource::ArgosBeacon).sigma_m2()));
            ++count;
        }
        qInfo("%d forecasts, squared error %.2f of what is said", count, error / count);
        QVERIFY(count > 30);
        QVERIFY(error / count > 0.25 && error / count < 1.3);
    }

    void withoutVariationVelocitiesAreExact()
    {
        const ImportResult result =
            importSightings(openSea(), csv("a,2024-05-01T00:00:00Z,60,-50\n"),
                            {.at = utc("2024-05-02T00:00:00Z"), .track = {}, .positionSd_m = 5});
        QVERIFY(!result.observerSet);
        QVERIFY(result.scenario.observer.model == ObserverModel::Simple);
        COMPARE_NEAR(initialSigma_m2(result.scenario.icebergs.at(0)), 25 + 2160, 1e-6);
    }

    void sourcesHaveTheirErrors_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<double>("sd_m");
        QTest::newRow("Ice Patrol") << "iip.csv" << 1852.0;
        QTest::newRow("waypoints") << "waypoints.gpx" << 20.0;
        QTest::newRow("satellite") << "metno.geojson" << 50.0;
    }
    void sourcesHaveTheirErrors()
    {
        QFETCH(QString, file);
        QFETCH(double, sd_m);
        const SightingTable table = readFixture(file.toStdString().c_str());
        QCOMPARE(table.positionSd_m, sd_m);
        for (const double chosen_m : {0.0, 77.0}) {
            const ImportResult result = importSightings(
                openSea(), table,
                {.positionSd_m = chosen_m > 0 ? std::optional(chosen_m) : std::nullopt});
            const double expected_m = chosen_m > 0 ? chosen_m : sd_m;
            QVERIFY(std::ranges::any_of(result.scenario.icebergs, [&](const Iceberg& iceberg) {
                return std::abs(std::sqrt(iceberg.sigma0_m2) / expected_m - 1) < 1e-3;
            }));
        }
    }

    /** A velocity given as speed and direction applies to its time, and fades. */
    void aGivenVelocityFades()
    {
        const ImportResult result = importSightings(
            openSea(),
            readSightings("id,time,lat,lon,speed,direction\na,2024-05-01T00:00:00Z,60,-50,0.3,90\n",
                          "file"),
            {.at = utc("2024-05-01T10:00:00Z")});
        const Iceberg& iceberg = result.scenario.icebergs.at(0);
        COMPARE_NEAR(iceberg.velocity_mps.x(), 0.3 * std::exp(-1), 1e-4);
        COMPARE_NEAR(iceberg.position_m.x(), 0.3 * 36'000 * (1 - std::exp(-1)), 10);
        QCOMPARE(iceberg.velocitySd_mps, 0.1); // the rounding error of such drifts
    }

    /**
     * Position and velocity of 600 synthetic beacons at the last fix are compared with the truth:
     * the mean NEES is within its 95 % band, 4 ± 1.96 sqrt(8 / 600).
     */
    void fitsHaveTheStatedUncertainty_data()
    {
        QTest::addColumn<double>("sd_m");
        QTest::addColumn<double>("every_s");
        QTest::newRow("Argos") << 300.0 << 1200.0;
        QTest::newRow("satellite navigation") << 20.0 << 3600.0;
    }
    void fitsHaveTheStatedUncertainty()
    {
        QFETCH(double, sd_m);
        QFETCH(double, every_s);
        double error = 0;
        constexpr int kRuns = 600;
        for (std::uint64_t seed = 1000; seed < 1000 + kRuns; ++seed) {
            DriftModel truth = drifting(seed, 0);
            const std::vector<Fix> fixes = beacon(seed, sd_m, every_s, truth);
            const DriftFit fit = fitDrift(fixes, kFittedDrift, Point::Zero());
            const Point off_m = fit.position_m - truth.position_m(86'400);
            const Point off_mps = fit.velocity_mps - truth.velocity_mps();
            const DriftVariances& v = fit.variances;
            error +=
                (v.velocity_m2ps2 * off_m.squaredNorm() - 2 * v.mixed_m2ps * off_m.dot(off_mps) +
                 v.position_m2 * off_mps.squaredNorm()) /
                (v.position_m2 * v.velocity_m2ps2 - v.mixed_m2ps * v.mixed_m2ps) / kRuns;
        }
        COMPARE_NEAR(error, 4, 0.23);
    }

    /** The estimate recovers q: the median over 60 beacons is within a third of the true value. */
    void growthIsRecovered()
    {
        for (const double q_m2ps : {0.0, 5.0}) {
            std::vector<double> found;
            for (std::uint64_t seed = 0; seed < 60; ++seed) {
                DriftModel truth = drifting(seed, q_m2ps);
                const std::vector<Fix> fixes = beacon(seed, 20, 600, truth);
                found.push_back(fitDrift(fixes, kFittedDrift, Point::Zero(), 1e6).q_m2ps);
            }
            std::ranges::nth_element(found, found.begin() + 30);
            COMPARE_NEAR(found[30], q_m2ps, q_m2ps > 0 ? q_m2ps / 3 : 0.1);
        }
    }
};

QTEST_APPLESS_MAIN(TestImportDrift)
#include "tst_import_drift.moc"
