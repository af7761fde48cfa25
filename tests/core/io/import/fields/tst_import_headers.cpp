#include "core/io/import/fields/import_fields.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/import_fixtures.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;

namespace {

/** Codes and reasons of a rejected file. */
std::string refusal(const std::string& text, const ReadOptions& options = {})
{
    const std::optional<Error> error = errorOf([&] { (void)readText(text, options); });
    std::string all = error ? "" : "taken";
    if (error)
        for (const Issue& issue : error->issues())
            all += englishText(issue.reason) + '\n';
    return all;
}

/** Returns text of characters below U+10000 as UTF-16 with a mark. */
std::string utf16(const std::u16string& text, bool bigEndian)
{
    std::string bytes;
    for (const char16_t unit : u"\uFEFF" + text) {
        const auto high = static_cast<char>(unit >> 8U);
        const auto low = static_cast<char>(unit & 0xFFU);
        bytes += bigEndian ? high : low;
        bytes += bigEndian ? low : high;
    }
    return bytes;
}

} // namespace

class TestImportHeaders : public QObject
{
    Q_OBJECT

private slots:
    void headerIsFound_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("line"); // line of the header, above the sighting
        const auto row = [](const char* name, const char* text, int line) {
            QTest::newRow(name) << QByteArray(text) << line;
        };
        row("first line", "id;lat;lon\na;47,5;-48,25\n", 1);
        row("title", "Icebergs, June 2021\nid;lat;lon\na;47,5;-48,25\n", 2);
        row("title with many commas", "A, B, C, D, E, F\n\nid;lat;lon\na;47,5;-48,25\n", 3);
        row("several lines", "Ice report\nFrom;the ship\n\nid;lat;lon\na;47,5;-48,25\n", 4);
        row("title and comment", "# made by hand\nIce report\nid;lat;lon\na;47,5;-48,25\n", 3);
        row("title in a row of cells", "Report;;\nid;lat;lon\na;47,5;-48,25\n", 2);
        row("windows ends", "Report\r\n\r\nid;lat;lon\r\na;47,5;-48,25\r\n", 3);
        row("separator and title", "sep=;\nReport\nid;lat;lon\na;47,5;-48,25\n", 3);
        row("tabs", "Report; of ice\nid\tlat\tlon\na\t47,5\t-48,25\n", 2);
        row("prose", "The latitude, and longitude, are in degrees\nid;lat;lon\na;47,5;-48,25\n", 2);
    }
    void headerIsFound()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const int, line);
        const SightingTable table = readText(text.toStdString());
        QCOMPARE(table.headerLine.value_or(0), static_cast<std::size_t>(line));
        QCOMPARE(table.sightings.size(), std::size_t{1});
        QCOMPARE(table.rejected.count, std::size_t{0});
        QCOMPARE(table.sightings[0].line, static_cast<std::size_t>(line) + 1);
        QCOMPARE(table.sightings[0].id, std::string("a"));
        QCOMPARE(table.sightings[0].place.latitude_deg, 47.5);
        QCOMPARE(table.sightings[0].place.longitude_deg, -48.25);
    }

    /** A header with other words is found by a mapping or by its line number. */
    void headerIsChosen()
    {
        const std::string text = "Report\nwho;up;right\na;47,5;-48,25\n";
        const ColumnMapping mapping{{SightingField::Latitude, "up"},
                                    {SightingField::Longitude, "right"}};
        QCOMPARE(readText(text, {.mapping = mapping}).headerLine, std::optional(std::size_t{2}));
        const std::string two = "id;lat;lon\na;1;1\n\nid;lat;lon\nb;47,5;-48,25\n";
        const SightingTable chosen = readText(two, {.headerLine = 4});
        QCOMPARE(chosen.headerLine, std::optional(std::size_t{4}));
        QCOMPARE(chosen.sightings.size(), std::size_t{1});
        QCOMPARE(chosen.sightings[0].line, std::size_t{5});
        QCOMPARE(readText(text, {.mapping = mapping, .headerLine = 2}).sightings[0].line,
                 std::size_t{3});
        QVERIFY(refusal(two, {.headerLine = 9}).starts_with("there is nothing on line 9"));
        QVERIFY(refusal(two, {.headerLine = 2}).starts_with("no column holds it"));
    }

    void unitsBelowTheHeaderAreUsed()
    {
        const SightingTable table = readFixture("erddap.csv");
        QCOMPARE(table.sightings.size(), std::size_t{2});
        QCOMPARE(table.rejected.count, std::size_t{0});
        QCOMPARE(table.sightings[1].place.latitude_deg, 47.99);
        QCOMPARE(timeOf(table.sightings[0]), std::string("2020-07-01T12:00:00Z"));
        QCOMPARE(table.sightings[0].speed_mps, std::optional(0.25)); // not knots, as in AIS
        QCOMPARE(table.sightings[0].line, std::size_t{3});
        const SightingTable knots = readText("lat,lon,speed,length\ndegrees_north,degrees_east,"
                                             "knots,furlongs\n47,-48,1,5\n");
        COMPARE_NEAR(*knots.sightings[0].speed_mps, 1852.0 / 3600, 1e-12);
        QVERIFY(!knots.sightings[0].radius_m);
        QCOMPARE(knots.unused, std::vector<std::string>{"length"});
    }

    void unitsInNamesAreUsed_data()
    {
        QTest::addColumn<int>("unused");
        QTest::newRow("latitude (degrees_north),longitude (degrees_east)") << 0;
        QTest::newRow("latitude_degrees_north,longitude_degrees_east") << 0;
        QTest::newRow("Lat (deg N),Lon (deg E)") << 0;
        QTest::newRow("Latitude (decimal degrees),Longitude (decimal degrees)") << 0;
        QTest::newRow("Latitude (°),Longitude (°)") << 0;
        QTest::newRow("LAT[degree_north],LON[degree_east]") << 0;
        QTest::newRow("Latitude_WGS84,Longitude_WGS84") << 0;
    }
    void unitsInNamesAreUsed()
    {
        const SightingTable table =
            readText(std::string(QTest::currentDataTag()) + "\n47.5,-48.25\n");
        QCOMPARE(table.sightings.at(0).place.longitude_deg, -48.25);
    }

    void hemispheresMayHaveTheirOwnColumns()
    {
        const SightingTable logger = readFixture("logger.csv");
        QCOMPARE(logger.sightings.size(), std::size_t{2});
        QVERIFY(logger.oneIceberg);
        QCOMPARE(logger.sightings[1].place.longitude_deg, -49.0);
        COMPARE_NEAR(*logger.sightings[0].speed_mps, 0.25, 1e-9);
        QCOMPARE(timeOf(logger.sightings[1]), std::string("2020-07-01T07:00:00Z"));
        const SightingTable nmea = readText("lat,NS_indicator,lon,EW_indicator\n62.5,S,58.25,W\n");
        QCOMPARE(nmea.sightings.at(0).place.longitude_deg, -58.25);
        const SightingTable south = readText("lat,lat_hem,lon,lon_hem\n62.5,S,58.25,W\n");
        QCOMPARE(south.sightings.at(0).place.latitude_deg, -62.5);
        QCOMPARE(south.sightings.at(0).place.longitude_deg, -58.25);
    }

    void timesInPartsAreJoined_data()
    {
        QTest::addColumn<QByteArray>("cells");
        QTest::addColumn<QByteArray>("time"); // "none" if it is left out
        const auto row = [](const char* header, const char* cells, const char* time) {
            QTest::addRow("%s: %s", header, cells) << QByteArray(cells) << QByteArray(time);
        };
        row("year,month,day,hour,minute,second", "2021,6,5,7,8,9", "2021-06-05T07:08:09Z");
        row("Year,Mon,Day,Hr,Min", "21,06,05,07,08", "2021-06-05T07:08:00Z");
        row("year,month,day", "2021,June,5", "2021-06-05T00:00:00Z");
        row("YEAR,MONTH,DAY,HOUR", "2021,6.0,5.0,24", "2021-06-06T00:00:00Z");
        row("year,month,day,hour (UTC)", "2021,6,5,7.5", "2021-06-05T07:30:00Z");
        row("year,doy", "2021,156.5", "2021-06-05T12:00:00Z");
        row("year,doy,hour,min", "2021,156,13,30", "2021-06-05T13:30:00Z");
        row("Year,Hour,Min,DOY", "2021,13,0,156.542", "2021-06-05T13:00:00Z");
        row("Year,Hour,DOY", "2021,3,156.5", "2021-06-05T12:00:00Z"); // the columns disagree
        row("year,day_of_year", "2020,366", "2020-12-31T00:00:00Z");
        row("year,month,day,hour", "2021,6,31,7", "none");
        row("year,doy", "2021,366", "none");
        row("year,month,day,hour,minute", "2021,6,5,7,75", "none");
        row("date,hour,minute", "2021-06-05,7,8", "2021-06-05T07:08:00Z");
        row("year,month,day,time", "2021,6,5,07:08", "2021-06-05T07:08:00Z");
        row("year,month,day,time", "2021,6,5,2020-01-02T03:04:05Z", "2020-01-02T03:04:05Z");
        row("time (UTC-3)", "2021-06-05 12:00", "2021-06-05T15:00:00Z");
        row("time [UTC+05:30]", "2021-06-05 12:00", "2021-06-05T06:30:00Z");
        row("time (UTC+2)", "2021-06-05 12:00Z", "2021-06-05T12:00:00Z");
        row("time,timezone", "2021-06-05 12:00,UTC", "2021-06-05T12:00:00Z");
        row("time,timezone", "2021-06-05 12:00,+02:00", "2021-06-05T10:00:00Z");
        row("time,tz", "2021-06-05 12:00,GMT-3", "2021-06-05T15:00:00Z");
        row("time,utc_offset", "2021-06-05 12:00,-3.5", "2021-06-05T15:30:00Z");
        row("date,time,timezone", "2021-06-05,12:00,+0200", "2021-06-05T10:00:00Z");
        row("year,month,day,hour,tz", "2021,6,5,1,+02", "2021-06-04T23:00:00Z");
        row("time,timezone", "2021-06-05T12:00:00-03:00,EST", "2021-06-05T15:00:00Z");
        row("time,timezone", "2021-06-05 12:00,", "2021-06-05T12:00:00Z");
    }
    void timesInPartsAreJoined()
    {
        QFETCH(const QByteArray, cells);
        QFETCH(const QByteArray, time);
        const QByteArray header = QByteArray(QTest::currentDataTag()).split(':').first();
        const std::string name = QByteArray(QTest::currentDataTag()).startsWith("time [UTC+05:30]")
                                     ? "time [UTC+05:30]"
                                     : header.toStdString();
        const SightingTable table =
            readText(name + ",lat,lon\n" + cells.toStdString() + ",47.5,-48.25\n");
        QCOMPARE(table.sightings.size(), std::size_t{1});
        QCOMPARE(QByteArray::fromStdString(timeOf(table.sightings[0])), time);
        QCOMPARE(table.noted.count, std::size_t{time == "none" ? 1U : 0U});
        QCOMPARE(table.unused.size(), std::size_t{0});
    }

    void dayOfYearIsRead()
    {
        const SightingTable table = readFixture("day-of-year.csv");
        QCOMPARE(table.sightings.size(), std::size_t{3});
        QCOMPARE(timeOf(table.sightings[2]), std::string("2020-07-19T08:00:00Z"));
        const ImportResult result = importSightings(openSea(), table);
        QCOMPARE(result.added, std::size_t{1});
        const Iceberg& buoy = result.scenario.icebergs.at(0);
        COMPARE_NEAR(LocalFrame(result.scenario.origin).toGeographic(buoy.position_m).latitude_deg,
                     76.02, 1e-3);
        COMPARE_NEAR(buoy.velocity_mps.norm(), 0.31, 0.02);
    }

    void zoneColumnIsApplied()
    {
        const SightingTable table = readFixture("time-zone.csv");
        QCOMPARE(timeOf(table.sightings.at(1)), std::string("2020-07-01T11:30:00Z"));
    }

    void unclearTimesAreRejected_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("reason");
        QTest::newRow("zone by name")
            << QByteArray("time,timezone,lat,lon\n2021-06-05 08:00,America/St_Johns,47,-48\n")
            << QByteArray("the time zone \"America/St_Johns\" is a name");
        QTest::newRow("zone by letters")
            << QByteArray("time,timezone,lat,lon\n2021-06-05 08:00,EST,47,-48\n")
            << QByteArray("the time zone \"EST\" is a name");
        QTest::newRow("no year") << QByteArray("month,day,hour,lat,lon\n6,5,1,47,-48\n")
                                 << QByteArray("the column \"month\" is not understood");
        QTest::newRow("day of the year alone")
            << QByteArray("doy,lat,lon\n156,47,-48\n") << QByteArray("the column \"doy\"");
        QTest::newRow("local time") << QByteArray("Time (local),lat,lon\n2021-06-05 08:00,47,-48\n")
                                    << QByteArray("the column \"Time (local)\"");
        QTest::newRow("local time before")
            << QByteArray("Local time,lat,lon\n2021-06-05 08:00,47,-48\n")
            << QByteArray("the column \"Local time\"");
    }
    void unclearTimesAreRejected()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const QByteArray, reason);
        const std::string message = refusal(text.toStdString());
        QVERIFY2(QByteArray::fromStdString(message).startsWith(reason), message.c_str());
    }

    void encodingsAreRecognised()
    {
        const SightingTable windows = readFixture("windows.csv");
        QCOMPARE(windows.sightings.at(0).id, std::string("Isfjell Ø – 2 “stor”"));
        QCOMPARE(windows.sightings.at(0).place.longitude_deg, -49.25);
        for (const bool bigEndian : {false, true}) {
            const SightingTable table =
                readText(utf16(u"id\tlat\tlon\r\nBerg Å – €\t47,5\t-48,25\r\n", bigEndian));
            QCOMPARE(table.sightings.at(0).id, std::string("Berg Å – €"));
            QCOMPARE(table.sightings.at(0).place.latitude_deg, 47.5);
        }
        QVERIFY(refusal(utf16(u"lat,lon\n\xDC00,1\n", false)).starts_with("is UTF-16 text"));
        QVERIFY(refusal(utf16(u"lat,lon\n1,1\n", false) + "x").starts_with("is UTF-16 text"));
    }

    /** Decimal commas in columns separated by commas are ambiguous. */
    void ambiguousDecimalCommasAreRejected()
    {
        const SightingTable table =
            readText("id,lat,lon\nA,47,5,-48,47\nB,46.5,-48.25\nC,\"47,5\",\"-48,25\"\n");
        QCOMPARE(table.sightings.size(), std::size_t{2});
        QVERIFY(faultAt(table, 2).starts_with("has another number of columns"));
        QCOMPARE(at(table, 4).place.longitude_deg, -48.25);
    }
};

QTEST_APPLESS_MAIN(TestImportHeaders)
#include "tst_import_headers.moc"
