#include "core/io/export/formats.h"
#include "core/io/export/sightings_csv.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/import_fixtures.h"
#include "tests/support/flight/mission_builder.h"

#include <QTest>

#include <set>

using namespace berg;
using namespace berg::test;

namespace {

std::string sightingsOf(const Mission& mission)
{
    return findExportFormat("sightings")->text(runContent(mission));
}

Iceberg sized(std::optional<double> length_m, double radius_m = 50)
{
    Iceberg iceberg;
    iceberg.length_m = length_m;
    iceberg.radius_m = radius_m;
    return iceberg;
}

} // namespace

class TestSightingsCsv : public QObject
{
    Q_OBJECT

private slots:
    void sizeCodes()
    {
        QCOMPARE(sizeCodeOf(sized({})), std::string("GEN")); // the radius of every new iceberg
        QCOMPARE(sizeCodeOf(sized(100)), std::string("MED"));
        QCOMPARE(sizeCodeOf(sized(3, 400)), std::string("GR"));
        QCOMPARE(sizeCodeOf(sized({}, 5)), std::string("BB"));
        QCOMPARE(sizeCodeOf(sized({}, 100)), std::string("VLG"));
    }

    /** Sightings come back through our own importer: id, minute, place to 5 decimals, size. */
    void comesBack()
    {
        const Mission mission = flown(changed([](Scenario& s) {
                                          s.icebergs[0].id = "2026-301";
                                          s.icebergs[1].id = "77";
                                          s.icebergs[0].length_m = 30;
                                          s.icebergs[2].radius_m = 80;
                                      }),
                                      400);
        const std::string text = sightingsOf(mission);
        const SightingTable table = readSightings(text, "sightings.csv");
        QCOMPARE(table.format, std::string("iip"));
        QCOMPARE(table.rejected.count + table.noted.count, std::size_t{0});
        std::size_t rows = 0;
        const LocalFrame frame(mission.scenario().origin);
        const std::vector<Sample>& samples = mission.recorder().samples();
        const std::vector<std::string> ids{"2026-301", "2026-77", "2026-1", "2026-2"};
        for (std::size_t k = 0; k < samples.size(); ++k) {
            const std::vector<IcebergSample> now = mission.recorder().icebergs(k);
            for (std::size_t i = 0; i < now.size(); ++i) {
                if (!now[i].inView || (k > 0 && mission.recorder().icebergs(k - 1)[i].inView))
                    continue;
                const Sighting& read = table.sightings.at(rows++);
                QCOMPARE(read.id, ids[i]);
                const UtcTime seen =
                    *parseUtc(mission.scenario().startUtc) +
                    std::chrono::milliseconds(std::llround(1000 * samples[k].time_s));
                QVERIFY(*read.time == std::chrono::round<std::chrono::minutes>(seen));
                const LatLon place = frame.toGeographic(now[i].truth_m);
                QCOMPARE(read.place.latitude_deg, std::round(place.latitude_deg * 1e5) / 1e5);
                QCOMPARE(read.place.longitude_deg, std::round(place.longitude_deg * 1e5) / 1e5);
                const std::vector<std::optional<double>> radii{18.75, {}, 80, {}};
                QCOMPARE(read.radius_m, radii[i]);
            }
        }
        QCOMPARE(table.sightings.size(), rows);
        QVERIFY(rows >= 3);
    }

    void reportsOfOthersAreLeftOut()
    {
        Mission mission(changed([](Scenario& s) { s.icebergs[3].position_m = Point(-900, 4000); }));
        mission.advance(10);
        const std::string before = sightingsOf(mission);
        mission.intervene({.seen = "berg-4", .seenAge_s = 5});
        QCOMPARE(sightingsOf(mission), before);
    }

    void needsAFlightWithAStart()
    {
        const ExportFormat& format = *findExportFormat("sightings");
        const auto unflown = errorOf([&] { (void)format.text(planContent(fourIcebergs())); });
        QVERIFY(unflown && unflown->issues().front().reason.id == IssueId::NothingFlown);
        const Mission timeless = flown(changed([](Scenario& s) { s.startUtc.clear(); }), 10);
        const auto error = errorOf([&] { (void)sightingsOf(timeless); });
        QVERIFY(error && error->issues().front().reason.id == IssueId::SightingsNoStart);
    }

    /** The season of the Ice Patrol begins in October. */
    void season()
    {
        const Mission mission =
            flown(changed([](Scenario& s) { s.startUtc = "2026-11-30T12:00:00Z"; }), 400);
        const SightingTable table = readSightings(sightingsOf(mission), "sightings.csv");
        QVERIFY(!table.sightings.empty());
        for (const Sighting& sighting : table.sightings)
            QVERIFY(sighting.id.starts_with("2027-"));
    }
};

QTEST_APPLESS_MAIN(TestSightingsCsv)
#include "tst_sightings_csv.moc"
