#include "core/io/import/fields/import_fields.h"
#include "core/io/import/import_identity.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/import_fixtures.h"

#include <QtTest>

#include <set>

using namespace berg;
using namespace berg::test;
using namespace std::string_literals;

namespace {

std::set<std::string> idsOf(const SightingTable& table)
{
    std::set<std::string> ids;
    for (const Sighting& sighting : table.sightings)
        ids.insert(sighting.id);
    return ids;
}

/**
 * Returns five icebergs, each seen twice an hour apart and 0.01 degrees (1.1 km) on. Column `call`
 * distinguishes them, `row` counts, `ship` is that of the observer.
 */
std::string fiveTwice(const std::string& header = "call,row,ship,time,lat,lon\n")
{
    std::string text = header;
    int row = 0;
    for (int hour = 0; hour < 2; ++hour)
        for (int i = 0; i < 5; ++i)
            text += "B" + std::to_string(i) + ',' + std::to_string(++row) + ",Norden,2026-05-01T" +
                    (hour == 0 ? "10:0" : "11:0") + std::to_string(i) + ":00Z," +
                    std::to_string(60 + 0.1 * i + 0.01 * hour) + ",-50\n";
    return text;
}

const IdentityChoice* byColumn(const std::vector<IdentityChoice>& choices, const char* column)
{
    const auto found = std::ranges::find(choices, column, &IdentityChoice::column);
    return found == choices.end() ? nullptr : &*found;
}

/** Feed of a satellite tracker: a message has the id, the tracker the IMEI. */
std::string trackerFeed()
{
    std::string text = R"(<?xml version="1.0"?><kml><Document>)";
    for (int i = 0; i < 3; ++i)
        text += "<Placemark><name>Berg Tracker</name><TimeStamp><when>2024-06-01T1" +
                std::to_string(2 + i) +
                ":00:00Z</when></TimeStamp><ExtendedData><Data name=\"Id\"><value>" +
                std::to_string(501 + i) +
                "</value></Data><Data name=\"IMEI\"><value>300000000000001</value></Data>"
                "</ExtendedData><Point><coordinates>-48," +
                std::to_string(47 - 0.01 * i) + ",3</coordinates></Point></Placemark>";
    return text + "</Document></kml>";
}

} // namespace

class TestImportIdentity : public QObject
{
    Q_OBJECT

private slots:
    void idColumnIsChosen_data()
    {
        QTest::addColumn<std::string>("name");
        for (const char* name : {"target",     "Target No.",
                                 "TRACK",      "track id",
                                 "contact",    "Contact number",
                                 "reference",  "Ref",
                                 "trajectory", "Trajectory_ID",
                                 "instrument", "MMSI",
                                 "device",     "Device ID",
                                 "IMEI",       "buoy",
                                 "BuoyID",     "no.",
                                 "No",         "number",
                                 "Nr",         "iceberg no",
                                 "Berg",       "ESN",
                                 "WMO",        "drifter",
                                 "id"})
            QTest::newRow(name) << std::string(name);
    }
    void idColumnIsChosen()
    {
        QFETCH(std::string, name);
        QVERIFY(readText(fiveTwice()).isIdentityUnclear); // "call" is not a known word
        const SightingTable named = readText(fiveTwice(name + ",row,ship,time,lat,lon\n"));
        QVERIFY(!named.isIdentityUnclear);
        QCOMPARE(idsOf(named), (std::set{"B0"s, "B1"s, "B2"s, "B3"s, "B4"s}));
        QVERIFY(std::ranges::find(named.mapping, FieldColumn{SightingField::Id, name}) !=
                named.mapping.end());
    }

    /** The order of precedence is: mapped by the user, columns, names, ids of features. */
    void precedenceFollowsTheRanks()
    {
        const auto rankOf = [](const char* name) { return fieldOfColumn(name)->rank; };
        QVERIFY(0 < rankOf("iceberg id"));
        QVERIFY(rankOf("iceberg id") < rankOf("id"));
        QVERIFY(rankOf("id") < rankOf("IMEI"));
        QVERIFY(rankOf("IMEI") < rankOf("device"));
        QVERIFY(rankOf("device") < rankOf("number"));
        QVERIFY(rankOf("number") < kNameRank);
        QVERIFY(kNameRank < kFeatureIdRank);
        QCOMPARE(idTrust(0), IdTrust::Iceberg);
        QCOMPARE(idTrust(rankOf("berg")), IdTrust::Iceberg);
        QCOMPARE(idTrust(rankOf("id")), IdTrust::Tracker);
        QCOMPARE(idTrust(rankOf("transponder")), IdTrust::Tracker);
        QCOMPARE(idTrust(rankOf("track")), IdTrust::Weak);
        QCOMPARE(idTrust(kNameRank), IdTrust::Weak);
    }

    void precedenceOfMapsFollowsTheRanks_data()
    {
        QTest::addColumn<std::string>(
            "members"); ///< members of the first feature; the second differs
        QTest::addColumn<std::string>("id");
        QTest::newRow("property") << R"("id":"f1","properties":{"berg":"b1","name":"n1"})"s
                                  << "b1"s;
        QTest::newRow("name") << R"("id":"f1","properties":{"name":"n1"})"s
                              << "n1"s;
        QTest::newRow("feature") << R"("id":"f1","properties":{})"s
                                 << "f1"s;
    }
    void precedenceOfMapsFollowsTheRanks()
    {
        QFETCH(std::string, members);
        QFETCH(std::string, id);
        std::string other = members;
        std::ranges::replace(other, '1', '2');
        const auto feature = [](const std::string& properties, const char* place) {
            return R"({"type":"Feature",)" + properties +
                   R"(,"geometry":{"type":"Point","coordinates":)" + place + "}}";
        };
        const SightingTable table =
            readText(R"({"type":"FeatureCollection","features":[)" + feature(members, "[-48,47]") +
                     ',' + feature(other, "[-49,47]") + "]}");
        QCOMPARE(table.sightings[0].id, id);
        QCOMPARE(table.sightings.size(), std::size_t{2});
    }

    void messagesOfOneTrackerAreOneIceberg()
    {
        const SightingTable table = readText(trackerFeed());
        QVERIFY(!table.isIdentityUnclear);
        QCOMPARE(idsOf(table), std::set{"300000000000001"s});
        const ImportResult result = importSightings(openSea(), table);
        QCOMPARE(result.scenario.icebergs.size(), std::size_t{1});
        QCOMPARE(result.scenario.startUtc, std::string("2024-06-01T14:00:00Z"));
        // The true value is 0.309 m/s; the filter keeps it a little nearer to its mean of 0.
        COMPARE_NEAR(result.scenario.icebergs[0].velocity_mps.y(), -0.31, 0.02);
    }

    /** One id at two places at one time is not an id, and neither is null. */
    void impossibleIdsAreNotUsed()
    {
        const SightingTable table = readText(
            R"({"type":"FeatureCollection","features":[)"
            R"({"type":"Feature","id":0,"properties":{"id":0,"time":"2021-06-05T12:00:00Z"},)"
            R"("geometry":{"type":"Point","coordinates":[-48.0,47.0]}},)"
            R"({"type":"Feature","id":1,"properties":{"id":0,"time":"2021-06-05T12:00:00Z"},)"
            R"("geometry":{"type":"Point","coordinates":[-48.5,47.0]}},)"
            R"({"type":"Feature","id":2,"properties":{"id":null,"time":"2021-06-05T13:00:00Z"},)"
            R"("geometry":{"type":"Point","coordinates":[-48.6,47.0]}}]})");
        QCOMPARE(idsOf(table), (std::set{"0"s, "1"s, "2"s}));
    }

    /** IIP (season and number), CIS beacon, track: these files identify their icebergs. */
    void filesWithIdsAreClear()
    {
        for (const char* file : {"iip.csv", "cis-beacon.csv", "usnic.csv", "metno.geojson",
                                 "route.gpx", "places.kml", "packets.czml", "table.csv"})
            QVERIFY2(!readFixture(file).isIdentityUnclear, file);
        QCOMPARE(readFixture("iip.csv").sightings[0].id.substr(0, 5), std::string("2021-"));
    }

    void filesWithoutAmbiguityAreClear_data()
    {
        QTest::addColumn<std::string>("text");
        QTest::newRow("one row") << "time,lat,lon\n2026-05-01T10:00:00Z,60,-50\n"s;
        QTest::newRow("one time") << "time,lat,lon\n2026-05-01T10:00:00Z,60,-50\n"
                                     "2026-05-01T10:00:00Z,61,-50\n"s;
        QTest::newRow("no time") << "lat,lon\n60,-50\n61,-50\n"s;
        QTest::newRow("names") << "name,time,lat,lon\nA,2026-05-01T10:00:00Z,60,-50\n"
                                  "B,2026-05-01T11:00:00Z,61,-50\n"s;
        QTest::newRow("one name") << "name,time,lat,lon\nA,2026-05-01T10:00:00Z,60,-50\n"
                                     "A,2026-05-01T11:00:00Z,60.01,-50\n"s;
        QTest::newRow("track of a map")
            << R"({"type":"Feature","properties":{"times":["2026-05-01T10:00:00Z",)"
               R"("2026-05-01T11:00:00Z"]},"geometry":{"type":"LineString","coordinates":)"
               R"([[-50,60],[-50,60.01]]}})"s;
    }
    void filesWithoutAmbiguityAreClear()
    {
        QFETCH(std::string, text);
        QVERIFY(!readText(text).isIdentityUnclear);
    }

    void ambiguousFilesAreUnclear_data()
    {
        QTest::addColumn<std::string>("text");
        QTest::newRow("no id") << "time,lat,lon\n2026-05-01T10:00:00Z,60,-50\n"
                                  "2026-05-01T11:00:00Z,60.01,-50\n"s;
        QTest::newRow("counted rows") << "no.,time,lat,lon\n1,2026-05-01T10:00:00Z,60,-50\n"
                                         "2,2026-05-01T11:00:00Z,60.01,-50\n"s;
        QTest::newRow("numbers as names") << "name,time,lat,lon\n1,2026-05-01T10:00:00Z,60,-50\n"
                                             "2,2026-05-01T11:00:00Z,60.01,-50\n"s;
        QTest::newRow("one name for all") // 111 km in an hour
            << "name,time,lat,lon\nIceberg,2026-05-01T10:00:00Z,60,-50\n"
               "Iceberg,2026-05-01T11:00:00Z,61,-50\n"s;
        QTest::newRow("message ids") << "id,name,time,lat,lon\n7,Tracker,2026-05-01T10:00:00Z,60,"
                                        "-50\n8,Tracker,2026-05-01T11:00:00Z,60.01,-50\n"s;
        QTest::newRow("a course") << "track,time,lat,lon\n157.5,2026-05-01T10:00:00Z,60,-50\n"
                                     "180.0,2026-05-01T11:00:00Z,60.01,-50\n"s;
        QTest::newRow("points of a map")
            << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"time":)"
               R"("2026-05-01T10:00:00Z"},"geometry":{"type":"Point","coordinates":[-50,60]}},)"
               R"({"type":"Feature","properties":{"time":"2026-05-01T11:00:00Z"},)"
               R"("geometry":{"type":"Point","coordinates":[-50,60.01]}}]})"s;
    }
    void ambiguousFilesAreUnclear()
    {
        QFETCH(std::string, text);
        const SightingTable table = readText(text);
        QVERIFY(table.isIdentityUnclear);
        const SightingTable one = readText(text, {.rows = RowIdentity::OneIceberg});
        QVERIFY(!one.isIdentityUnclear);
        QCOMPARE(importSightings(openSea(), one).icebergs.size(), std::size_t{1});
        const SightingTable each = readText(text, {.rows = RowIdentity::EachRow});
        QVERIFY(!each.isIdentityUnclear);
        QCOMPARE(importSightings(openSea(), each).icebergs.size(), std::size_t{2});
    }

    void choicesStateTheirResults()
    {
        const std::string text = fiveTwice();
        const std::vector<IdentityChoice> choices =
            identityChoices(text, "file", {}, readText(text));
        const IdentityChoice* const call = byColumn(choices, "call");
        QVERIFY(call != nullptr);
        QCOMPARE(call->outcome.icebergs, std::size_t{5});
        COMPARE_NEAR(call->outcome.fastest_mps, 1114.0 / 3600, 2e-3); // 0.01 degrees at 60 N
        QVERIFY(byColumn(choices, "row") == nullptr);                 // equals each row
        QVERIFY(byColumn(choices, "ship") == nullptr);                // equals all rows
        QCOMPARE(choices.size(), std::size_t{3});
        QVERIFY(choices[1].rows == RowIdentity::OneIceberg);
        QCOMPARE(choices[1].outcome.icebergs, std::size_t{1});
        COMPARE_NEAR(choices[1].outcome.fastest_mps, 11'140.0 / 60, 0.5); // 0.1 degrees in a minute
        QVERIFY(choices[2].rows == RowIdentity::EachRow);
        QCOMPARE(choices[2].outcome, (IdentityOutcome{.icebergs = 10, .fastest_mps = 0}));
        const ReadOptions chosen = withIdentity({}, *call);
        QCOMPARE(idsOf(readText(text, chosen)).size(), std::size_t{5});
        QVERIFY(!readText(text, chosen).isIdentityUnclear);
    }

    void rejectionNamesTheOptions()
    {
        const std::string text = fiveTwice();
        const auto error =
            errorOf([&] { requireIdentity(readText(text), text, "file", ReadOptions{}); });
        QVERIFY(error.has_value());
        std::set<std::string> fields;
        for (const Issue& issue : error->issues())
            fields.insert(issue.field);
        QCOMPARE(fields, (std::set{"id"s, "--map id=call"s, "--one-iceberg"s, "--each-row"s}));
        QVERIFY(!errorOf([&] {
            requireIdentity(readText(text, {.rows = RowIdentity::EachRow}), text, "file", {});
        }));
    }
};

QTEST_APPLESS_MAIN(TestImportIdentity)
#include "tst_import_identity.moc"
