#include "core/base/angles.h"
#include "tests/support/approx.h"
#include "tests/support/files/import_fixtures.h"

#include <QtTest>

#include <cmath>

using namespace berg;
using namespace berg::test;

namespace {

ImportResult imported(const SightingTable& table)
{
    return importSightings(openSea(), table);
}

/** Returns the parts of an iceberg's place, in degrees. */
LatLon placeOf(const ImportResult& result, const std::string& id)
{
    for (const Iceberg& iceberg : result.scenario.icebergs)
        if (iceberg.id == id)
            return LocalFrame(result.scenario.origin).toGeographic(iceberg.position_m);
    return {.latitude_deg = NAN, .longitude_deg = NAN};
}

double km(const LatLon& origin, const LatLon& place)
{
    return LocalFrame(origin).toPlane(place).norm() / 1000;
}

std::vector<std::size_t> farLines(const ImportResult& result)
{
    std::vector<std::size_t> lines;
    for (const RejectedRow& row : result.rejected.first)
        if (row.fault == IssueId::TooFar)
            lines.push_back(row.line);
    return lines;
}

/** Returns rows of icebergs in a square of one degree. */
std::string fieldAt(double latitude_deg, double longitude_deg, int count, const std::string& name)
{
    std::string rows;
    for (int i = 0; i < count; ++i)
        rows += name + std::to_string(i) + ",2021-06-05T12:00:00Z," +
                std::to_string(latitude_deg + i % 10 * 0.1) + ',' +
                std::to_string(longitude_deg + i / 10 % 10 * 0.1) + '\n';
    return rows;
}

} // namespace

class TestImportOrigin : public QObject
{
    Q_OBJECT

private slots:
    /** A user who enters a place and then imports sightings near it starts at that place. */
    void placedScenarioStaysWhereItIs()
    {
        Scenario base = openSea();
        base.origin = {.latitude_deg = 48.65, .longitude_deg = -53.11};
        const auto originFor = [&](double latitude_deg, double longitude_deg) {
            return importSightings(base, csv(fieldAt(latitude_deg, longitude_deg, 3, "b")))
                .scenario.origin;
        };
        QVERIFY(originFor(48.8, -52.7) == base.origin);
        QVERIFY(km(originFor(72, -60), {.latitude_deg = 72.1, .longitude_deg = -60}) < 100);
        base.origin = Scenario().origin; // the default origin of a new scenario
        QVERIFY(km(originFor(48.8, -52.7), {.latitude_deg = 48.9, .longitude_deg = -52.7}) < 100);
    }

    void widelySpreadIcebergsGiveADenseGroup()
    {
        const ImportResult result = imported(readFixture("antarctica.csv"));
        QCOMPARE(result.added, std::size_t{2}); // of three such pairs, the first in the file
        QVERIFY(std::abs(placeOf(result, "A23A").latitude_deg + 64.5) < 1e-3);
        QVERIFY(std::abs(placeOf(result, "A76C").longitude_deg + 46.9) < 1e-3);
        QCOMPARE(farLines(result), (std::vector<std::size_t>{4, 5, 6, 7, 8}));
        QCOMPARE(result.tooFar, std::size_t{5});
        QCOMPARE(result.rejected.count, std::size_t{5});
    }

    void onePointFarAwayIsRejected()
    {
        const ImportResult result = imported(readFixture("far-point.geojson"));
        QCOMPARE(result.added, std::size_t{3});
        QCOMPARE(farLines(result), std::vector<std::size_t>{3});
        QVERIFY(km(result.scenario.origin, {.latitude_deg = 48.1, .longitude_deg = -51.1}) < 100);
    }

    void placesAtNullIslandMoveNothing()
    {
        const ImportResult result = imported(readFixture("null-island.kml"));
        QCOMPARE(result.added, std::size_t{1});
        QCOMPARE(result.scenario.startUtc, std::string("2021-07-01T08:00:00Z"));
        COMPARE_NEAR(placeOf(result, "Tabular").latitude_deg, 48.98, 2e-4);
        COMPARE_NEAR(placeOf(result, "Tabular").longitude_deg, -52.0, 1e-4);
        QCOMPARE(result.tooFar, std::size_t{1});
    }

    /** Wrong places anywhere and at any time have no effect. */
    void outliersMoveNothing_data()
    {
        QTest::addColumn<QByteArray>("outliers");
        const auto row = [](const char* name, const std::string& outliers) {
            QTest::newRow(name) << QByteArray::fromStdString(outliers);
        };
        row("null island", "x,2021-06-05T12:00:00Z,0,0\n");
        row("two at null island", "x,2021-06-05T12:00:00Z,0,0\ny,,0,0\n");
        row("latitude without sign", fieldAt(-47, -48, 2, "x"));
        row("longitude without sign", fieldAt(47, 48, 2, "x"));
        row("exchanged", fieldAt(-48, 47, 2, "x"));
        row("a thousand kilometres", fieldAt(60, -48, 3, "x"));
        row("twelve hundred kilometres", fieldAt(57.8, -48, 2, "x"));
        row("another coast", fieldAt(-65, 60, 19, "x"));
        row("all over the earth", fieldAt(80, 0, 3, "x") + fieldAt(-70, 170, 3, "y") +
                                      fieldAt(10, 100, 3, "z") + fieldAt(-30, -30, 3, "w"));
        row("the pole", "x,2021-06-05T12:00:00Z,90,0\n");
        row("last fix of one", "b0,2021-06-05T13:00:00Z,0,0\n");
        row("none", "");
    }
    void outliersMoveNothing()
    {
        QFETCH(const QByteArray, outliers);
        const std::string field = fieldAt(47, -48, 20, "b");
        for (const std::string& rows :
             {outliers.toStdString() + field, field + outliers.toStdString()}) {
            const ImportResult result = imported(csv(rows));
            QVERIFY(km(result.scenario.origin, {.latitude_deg = 47.5, .longitude_deg = -47.95}) <
                    100);
            for (const Iceberg& iceberg : result.scenario.icebergs)
                QVERIFY(std::abs(iceberg.position_m.x()) <= kLargestCoordinate_m);
            for (int i = 1; i < 20; ++i)
                QVERIFY(!std::isnan(placeOf(result, "b" + std::to_string(i)).latitude_deg));
            QCOMPARE(result.tooFar, farLines(result).size());
        }
    }

    /** A last fix that the beacon cannot have reached is not used for the origin. */
    void unreachableLastFixIsIgnored()
    {
        std::string rows;
        for (int i = 0; i < 5; ++i)
            rows += "b,2021-06-05T1" + std::to_string(i) + ":00:00Z," +
                    std::to_string(47 - 0.01 * i) + ",-48\n";
        const ImportResult result = imported(csv(rows + "b,2021-06-05T15:00:00Z,60.4,5.3\n"));
        QCOMPARE(result.added, std::size_t{1});
        QCOMPARE(farLines(result), std::vector<std::size_t>{7});
        QVERIFY(km(result.scenario.origin, {.latitude_deg = 46.96, .longitude_deg = -48}) < 1);
    }

    /** A beacon that drifts far determines the origin by its present place. */
    void longDriftCountsAtItsEnd()
    {
        std::string rows;
        for (int day = 0; day < 60; ++day)
            rows += "b," + utcText(utc("2021-06-01T00:00:00Z"), day * 86400.0) + ',' +
                    std::to_string(75 - 0.35 * day) + ",-60\n";
        const ImportResult result = imported(csv(rows));
        QCOMPARE(result.scenario.origin.latitude_deg, 54.35);
        QCOMPARE(result.added, std::size_t{1});
    }

    /** The import keeps as many icebergs as possible, even if most are at one end. */
    void wideFieldsAreKeptWhole()
    {
        const ImportResult result =
            imported(csv(fieldAt(40, -48, 30, "a") + fieldAt(51, -48, 20, "b")));
        QCOMPARE(result.added, std::size_t{50});
        const ImportResult two = imported(csv(fieldAt(40, -48, 1, "a") + fieldAt(53, -48, 1, "b")));
        QCOMPARE(two.added, std::size_t{2});
    }

    void originIsFoundAtTheAntimeridianAndTheEquator()
    {
        const ImportResult result =
            imported(csv(fieldAt(70, 179.5, 10, "a") + fieldAt(70, -179.9, 10, "b") + "x,,0,0\n"));
        QCOMPARE(result.added, std::size_t{20});
        const ImportResult equator = imported(csv("a,2021-06-05T12:00:00Z,0,0\n"));
        QCOMPARE(equator.added, std::size_t{1});
        QCOMPARE(equator.scenario.origin.latitude_deg, 0.0);
    }

    /** A fixed origin stays, and sightings too far from it are counted. */
    void heldOriginStays()
    {
        const Scenario base = imported(csv(fieldAt(47, -48, 2, "b"))).scenario;
        const ImportResult result =
            importSightings(base, csv(fieldAt(47.5, -48, 2, "c") + fieldAt(-65, 60, 9, "x")));
        QVERIFY(result.scenario.origin == base.origin);
        QCOMPARE(result.added, std::size_t{2});
        QCOMPARE(result.tooFar, std::size_t{9});
    }

    void manyRowsGiveTheDensestGroup()
    {
        std::string rows;
        for (int i = 0; i < 20'000; ++i) // a fixed pattern over the whole earth
            rows += "i" + std::to_string(i) + ",2021-06-05T12:00:00Z," +
                    std::to_string(std::fmod(i * 37.77, 170.0) - 85) + ',' +
                    std::to_string(std::fmod(i * 91.13, 360.0) - 180) + '\n';
        const ImportResult result = imported(csv(rows + fieldAt(47, -48, 900, "b")));
        QVERIFY(km(result.scenario.origin, {.latitude_deg = 47.5, .longitude_deg = -47.5}) < 100);
        QCOMPARE(result.scenario.icebergs.size(), kMostIcebergs);
    }

    void clockRolloverIsCorrected()
    {
        const SightingTable table = readFixture("clock-rollover.gpx");
        QCOMPARE(timeOf(at(table, 5)), std::string("2023-05-10T08:00:00Z"));
        QCOMPARE(noteAt(table, 5), std::string("its time is moved by 1024 weeks, as a GPS clock "
                                               "has lost count of them: \"2042-12-24T08:00:00Z\""));
        const ImportResult result = imported(table);
        QCOMPARE(result.scenario.startUtc, std::string("2023-05-10T09:00:00Z"));
        QCOMPARE(result.noted.count, std::size_t{1});
        COMPARE_NEAR(result.scenario.icebergs.at(0).velocity_mps.y(), -0.309, 0.01);
        COMPARE_NEAR(placeOf(result, "Floe").latitude_deg, 47.97, 1e-3);
    }

    void timesOfAWrongClockAreCorrectedOrDropped_data()
    {
        QTest::addColumn<QByteArray>("time");
        QTest::addColumn<QByteArray>("read"); // "none" if it is left out
        QTest::addColumn<bool>("isNoted");
        const auto row = [](const char* time, const char* read, bool isNoted) {
            QTest::newRow(time) << QByteArray(time) << QByteArray(read) << isNoted;
        };
        row("2043-10-14T16:00:00Z", "2024-02-28T16:00:00Z", true);
        row("2043-10-14T20:00:00Z", "2024-02-28T20:00:00Z", true); // beyond the others
        row("2004-07-14T12:30:00Z", "2024-02-28T12:30:00Z", true);
        row("2063-05-30T14:00:00Z", "2024-02-28T14:00:00Z", true);
        row("2099-12-31T23:59:59Z", "none", true);
        row("1970-01-01T00:00:00Z", "none", true);
        row("1980-01-06T00:00:00Z", "none", true);
        row("2019-02-28T00:00:00Z", "2019-02-28T00:00:00Z", false);
        row("2025-02-28T00:00:00Z", "2025-02-28T00:00:00Z", false);
    }
    void timesOfAWrongClockAreCorrectedOrDropped()
    {
        QFETCH(const QByteArray, time);
        QFETCH(const QByteArray, read);
        QFETCH(const bool, isNoted);
        const SightingTable table =
            csv("a,2024-02-28T12:00:00Z,47,-48\nb," + time.toStdString() +
                ",47.1,-48\nc,2024-02-28T13:00:00Z,47.2,-48\nd,2024-02-28T15:00:00Z,47.3,-48\n");
        QCOMPARE(QByteArray::fromStdString(timeOf(at(table, 3))), read);
        QCOMPARE(table.noted.count, std::size_t{isNoted ? 1U : 0U});
        QCOMPARE(imported(table).added, std::size_t{4});
    }

    /** If half of the times disagree with the others, neither half can be called wrong. */
    void clocksThatDisagreeStay()
    {
        const SightingTable table = csv("a,2024-02-28T12:00:00Z,47,-48\n"
                                        "b,2043-10-14T12:00:00Z,47.1,-48\n");
        QCOMPARE(table.noted.count, std::size_t{0});
        QCOMPARE(timeOf(at(table, 3)), std::string("2043-10-14T12:00:00Z"));
    }

    void unusualTimesAreRead()
    {
        const SightingTable table = readFixture("unusual-times.gpx");
        const std::array<const char*, 8> expected = {"2011-03-02T10:11:12Z",
                                                     "2011-03-02T07:41:12.123Z",
                                                     "none",
                                                     "none",
                                                     "none",
                                                     "2011-03-03T00:00:00Z",
                                                     "2011-03-02T10:11:12Z",
                                                     "2011-03-02T10:12:00Z"};
        QCOMPARE(table.sightings.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i)
            QCOMPARE(timeOf(table.sightings[i]), std::string(expected[i]));
        QCOMPARE(table.noted.count, std::size_t{1});
        QCOMPARE(noteAt(table, 5), std::string("taken without its time, which cannot be read: "
                                               "\"0000-00-00T00:00:00Z\""));
        QCOMPARE(imported(table).added, std::size_t{8});
    }
};

QTEST_APPLESS_MAIN(TestImportOrigin)
#include "tst_import_origin.moc"
