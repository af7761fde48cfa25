#include "core/base/random.h"
#include "core/io/import/scenario/import_scenario.h"
#include "core/link/nmea/nmea_reader.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/import_fixtures.h"

#include <QTest>

#include <map>
#include <set>

using namespace berg;
using namespace berg::test;

namespace {

constexpr std::string_view kFirstPart =
    "!AIVDM,2,1,7,A,57lof8`2F5HeT<eC:204e86373:222222222221@8HQC16Ch0:RA7kAD,0*28\r\n";
constexpr std::string_view kSecondPart = "!AIVDM,2,2,7,A,PBp888888888880,2*79\r\n";
constexpr std::string_view kIceberg =
    "!AIVDM,1,1,,A,E>jUbT@TQRQ2a3hKP0000000000>@wPP=Q;6000000N0,5*12\r\n";

std::string clockText(int second)
{
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "12%02d%02d", second / 60, second % 60);
    return text.data();
}

/** A log with known contents. */
struct NmeaLog
{
    std::string text;
    std::size_t lines = 0;
    std::size_t sightings = 0;
    std::map<std::size_t, IssueId> broken; ///< by line

    void add(std::string_view line, std::optional<IssueId> fault = {})
    {
        ++lines;
        text += line;
        if (fault)
            broken[lines] = *fault;
    }
};

/** Returns 1,000 lines of which each tenth is broken, with five kinds of damage. */
NmeaLog thousandLines()
{
    NmeaLog log;
    Random random(54);
    while (log.lines < 1000) {
        const int second = static_cast<int>(log.lines);
        const std::string time = clockText(second);
        const std::string radar = "RATLL,0" + std::to_string(1 + log.lines % 3) + ",4705." +
                                  std::to_string(100 + log.lines % 3 * 300) + ",N,04810.000,W,," +
                                  time + ",T,";
        if (log.lines % 10 == 9) {
            std::string line = nmeaSentence(radar);
            switch (log.broken.size() % 5) {
            case 0: // wrong checksum
                line[10] = line[10] == '4' ? '5' : '4';
                log.add(line, IssueId::NmeaChecksum);
                break;
            case 1: // cut
                log.add(line.substr(0, 9 + random.below(line.size() - 12)) + "\r\n",
                        IssueId::NmeaChecksum);
                break;
            case 2: // wrong fields
                log.add(nmeaSentence("RATLL,01,9905.0,N,04810.000,W,," + time + ",T,"),
                        IssueId::NmeaFields);
                break;
            case 3: // wrong order of parts
                log.add(random.below(2) == 0 ? kSecondPart : kFirstPart, IssueId::NmeaAisPart);
                break;
            case 4: // no AIS message
                log.add("!AIVDM,1,1,,B,15M67FC0,0*5C\r\n", IssueId::NmeaChecksum);
                break;
            }
            continue;
        }
        switch (log.lines % 10) {
        case 0:
            log.add(
                nmeaSentence("GPRMC," + time + ",A,4700.000,N,04800.000,W,005.0,090.0,020526,,,A"));
            break;
        case 1:
            log.add(nmeaSentence("HEHDT,090.0,T"));
            break;
        case 2:
            log.add(nmeaSentence("RATTM,07,2.0,000.0,R,0.3,180.0,T,,,N,,T,," + time + ",A"));
            ++log.sightings;
            break;
        case 3:
            log.add(kIceberg);
            ++log.sightings;
            break;
        case 4:
            log.add(kFirstPart);
            break;
        case 5:
            log.add(kSecondPart);
            break;
        case 6:
            log.add("!AIVDM,1,1,,B,15M67FC000G?ufbE`FepT@3n00Sa,0*5C\r\n");
            break;
        default:
            log.add(nmeaSentence(radar));
            ++log.sightings;
        }
    }
    return log;
}

} // namespace

class TestImportNmea : public QObject
{
    Q_OBJECT

private slots:
    void targetsAreSightings()
    {
        const SightingTable table = readFixture("radar.nmea");
        QCOMPARE(table.format, std::string("nmea"));
        QCOMPARE(table.positionSd_m, errorOf(SightingSource::Radar).sd_m);
        const Sighting first = at(table, 2); // its date follows in the next line
        QCOMPARE(first.id, std::string("radar 1"));
        QCOMPARE(timeOf(first), std::string("2026-05-02T11:59:58Z"));
        COMPARE_NEAR(first.place.latitude_deg, 47 + 5.0 / 60, 1e-9);
        const Sighting bearing = at(table, 5); // two miles ahead, eastward
        QCOMPARE(bearing.id, std::string("radar 2"));
        COMPARE_NEAR(bearing.place.latitude_deg, 47, 2e-5);
        COMPARE_NEAR(bearing.place.longitude_deg, -48 + 0.0487, 1e-5);
        const Sighting aid = at(table, 7);
        QCOMPARE(aid.id, std::string("992570001"));
        QCOMPARE(aid.name, std::string("ICEBERG 7"));
        QCOMPARE(*aid.sigma_m2, errorOf(SightingSource::Ais).sigma_m2());
        QCOMPARE(table.sightings.size(), std::size_t{4}); // neither the ship nor what is acquired
        QVERIFY(!table.isIdentityUnclear);
        QCOMPARE(faultAt(table, 10), std::string("its checksum is wrong or missing"));
        QCOMPARE(faultAt(table, 11), std::string("its checksum is wrong or missing"));
        QVERIFY(faultAt(table, 12).starts_with("another part of the AIS message"));
        QVERIFY(faultAt(table, 13).starts_with("a radar bearing needs"));
    }

    /** All good lines are read, and each broken one is counted and named. */
    void tenthOfTheLinesIsBroken()
    {
        const NmeaLog log = thousandLines();
        QCOMPARE(log.lines, std::size_t{1000});
        QCOMPARE(log.broken.size(), std::size_t{100});
        const SightingTable table = readText(log.text);
        QCOMPARE(table.format, std::string("nmea"));
        QCOMPARE(table.sightings.size(), log.sightings);
        QCOMPARE(table.rejected.count, log.broken.size());
        for (const RejectedRow& row : table.rejected.first) {
            const auto expected = log.broken.find(row.line);
            QVERIFY2(expected != log.broken.end(), std::to_string(row.line).c_str());
            QVERIFY2(row.fault == expected->second || (expected->second == IssueId::NmeaChecksum &&
                                                       row.fault == IssueId::NmeaNoSentence),
                     englishText(reasonOf(row)).c_str());
        }
        std::set<std::string> ids;
        for (const Sighting& sighting : table.sightings)
            ids.insert(sighting.id);
        QCOMPARE(ids.size(), std::size_t{5}); // three by place, one by bearing, one aid
    }

    void icebergsAreMadeOfThem()
    {
        const ImportResult result = importedAsNew(importFixture("radar.nmea"));
        QCOMPARE(result.added, std::size_t{3});
        QCOMPARE(result.rejected.count, std::size_t{4});
    }

    void numbersAreUsedAgain()
    {
        std::string text;
        for (const char* time : {"120000", "121000", "125000", "125100"})
            text += nmeaSentence(std::string("GPRMC,") + time +
                                 ",A,4700.000,N,04800.000,W,0,0,020526,,,A") +
                    nmeaSentence(std::string("RATLL,01,4705.000,N,04810.000,W,,") + time + ",T,");
        const SightingTable table = readText(text);
        QCOMPARE(table.sightings.size(), std::size_t{4});
        QCOMPARE(table.sightings[1].id, std::string("radar 1"));
        QCOMPARE(table.sightings[2].id, std::string("radar 1 (2)"));
        QCOMPARE(table.sightings[3].id, std::string("radar 1 (2)"));
    }

    /** A ship with AIS that the radar tracks as well is no iceberg. */
    void shipsAreNoIcebergs()
    {
        const SightingTable table = readSightingRows(
            nmeaSentence("RATLL,01,3747.900,N,12220.500,W,,120000,T,") + // before its AIS message
                "!AIVDM,1,1,,B,15M67FC000G?ufbE`FepT@3n00Sa,0*5C\r\n" +
                nmeaSentence("RATLL,01,3748.127,N,12220.497,W,,120003,T,") +
                nmeaSentence("RATLL,02,3758.127,N,12220.497,W,,120003,T,"),
            "log");
        QCOMPARE(table.sightings.size(), std::size_t{1});
        QCOMPARE(table.sightings[0].id, std::string("radar 2"));
        QCOMPARE(table.rejected.count, std::size_t{2});
        QVERIFY(faultAt(table, 1).starts_with("the radar target is a ship"));
        QCOMPARE(noteAt(table, 4), std::string("taken without a time, which it does not have"));
    }

    void logWithoutTargets()
    {
        const auto error = errorOf([] {
            (void)readText(nmeaSentence("GPGGA,120000,4700.0,N,04800.0,W,1,08,0.9,9,M,0,M,,"));
        });
        QVERIFY(error && error->code() == ErrorCode::InvalidInput);
        QVERIFY(error->issues().front().reason.id == IssueId::NoSightings);
    }

    /** Damage of any kind is rejected line by line. */
    void damageNeverThrows()
    {
        const std::string text = thousandLines().text;
        Random random(3);
        for (int i = 0; i < 30; ++i) {
            std::string damaged = text;
            for (int k = 0; k < 300; ++k)
                damaged[random.below(damaged.size())] = static_cast<char>(1 + random.below(126));
            const SightingTable table =
                readSightingRows(damaged, "log", {.format = "nmea", .mapping = {}});
            QVERIFY(table.sightings.size() > 100 && table.rejected.count > 100);
        }
    }
};

QTEST_APPLESS_MAIN(TestImportNmea)
#include "tst_import_nmea.moc"
