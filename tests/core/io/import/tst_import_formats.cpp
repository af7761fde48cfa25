#include "core/base/angles.h"
#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/import_source.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/export_text.h"
#include "tests/support/files/import_fixtures.h"

#include <QtTest>

#include <cmath>

using namespace berg;
using namespace berg::test;

class TestImportFormats : public QObject
{
    Q_OBJECT

private slots:
    void everyFormatIsRecognised_data()
    {
        QTest::addColumn<int>("row");
        for (std::size_t i = 0; i < kImportFixtures.size(); ++i)
            QTest::newRow(kImportFixtures[i].file) << static_cast<int>(i);
    }

    /** The format is detected by content, and the result is the same if the format is named. */
    void everyFormatIsRecognised()
    {
        QFETCH(int, row);
        const ImportFixture& fixture = kImportFixtures[static_cast<std::size_t>(row)];
        const std::string text = importFixture(fixture.file);
        for (const char* format : {"auto", fixture.format}) {
            const SightingTable table = readText(text, {.format = format, .mapping = {}});
            QCOMPARE(table.format, std::string(fixture.format));
            QCOMPARE(table.sightings.size(), fixture.sightings);
            QCOMPARE(table.rejected.count, fixture.rejected);
            QCOMPARE(table.rejected.first.size(), fixture.rejected);
        }
    }

    void iipIsRead()
    {
        const SightingTable table = readFixture("iip.csv");
        const Sighting first = at(table, 2);
        QCOMPARE(first.id, std::string("2021-301"));
        QCOMPARE(timeOf(first), std::string("2021-03-28T16:50:00Z"));
        QCOMPARE(first.place.latitude_deg, 48.91667);
        QCOMPARE(first.place.longitude_deg, -50.23333);
        QCOMPARE(*first.radius_m, 45.0); // medium: 60 to 120 m long
        QCOMPARE(timeOf(at(table, 5)), std::string("2021-04-01T00:05:00Z"));
        QVERIFY(!at(table, 5).radius_m); // size class "general" has no size
        QCOMPARE(at(table, 14).id, std::string("2020-301"));
        QCOMPARE(timeOf(at(table, 15)), std::string("2020-12-31T23:59:00Z"));
        QCOMPARE(faultAt(table, 7),
                 std::string("latitude must be between -90 and 90, minutes below 60: \"147.5\""));
        QCOMPARE(noteAt(table, 8), std::string("taken without a time, which it does not have"));
        QCOMPARE(at(table, 8).id, std::string("2021-304"));
        const std::string unreadable = "taken without its time, which cannot be read: ";
        QCOMPARE(noteAt(table, 9), unreadable + "\"04/31/2021 900\"");
        QCOMPARE(noteAt(table, 10), unreadable + "\"04/01/2021 2460\"");
        QCOMPARE(faultAt(table, 11), std::string("date is not in the season: \"04/01/2019 1000\""));
        QCOMPARE(faultAt(table, 12), std::string("has no position"));
        QCOMPARE(faultAt(table, 13),
                 std::string("has another number of columns than the first line"));
    }

    void iipWithoutHeaderAndDayFirstIsRead()
    {
        const SightingTable table = readText(
            "2021,1,02/04/2021,1200,48,-50,VIS,SM,PIN,A\n2021,2,28/04/2021,5,48,-50,VIS,SM,"
            "PIN,A\n");
        QCOMPARE(table.format, std::string("iip"));
        QCOMPARE(table.sightings.size(), std::size_t{2});
        QCOMPARE(timeOf(table.sightings[0]), std::string("2021-04-02T12:00:00Z"));
    }

    void cisBeaconIsRead()
    {
        const SightingTable table = readFixture("cis-beacon.csv");
        QCOMPARE(at(table, 2).id, std::string("2012_7001"));
        QCOMPARE(timeOf(at(table, 3)), std::string("2012-07-03T03:00:00Z"));
        QVERIFY(!at(table, 3).speed_mps); // the track is more accurate
        QCOMPARE(faultAt(table, 10), std::string("has no time"));
        QCOMPARE(faultAt(table, 11), std::string("has no position"));
        QVERIFY(faultAt(table, 12).starts_with("has another number of columns"));
        QVERIFY(!table.oneIceberg);
    }

    void usnicIsRead()
    {
        const SightingTable table = readFixture("usnic.csv");
        const Sighting grounded = at(table, 2);
        QCOMPARE(grounded.id, std::string("A97Z"));
        QVERIFY(grounded.grounded);
        QCOMPARE(*grounded.radius_m, 22 * 1852.0);
        QCOMPARE(timeOf(grounded), std::string("2014-11-07T00:00:00Z"));
        QVERIFY(!at(table, 4).grounded);
        QVERIFY(faultAt(table, 5).starts_with("latitude"));
        QCOMPARE(noteAt(table, 6),
                 std::string("taken without a value that cannot be read: \"length: wide\""));
        QCOMPARE(noteAt(table, 7), std::string("taken without a time, which it does not have"));
        QCOMPARE(at(table, 7).place.latitude_deg, -71.25);
    }

    void metnoIsRead()
    {
        const SightingTable table = readFixture("metno.geojson");
        QCOMPARE(*at(table, 1).radius_m, 120.0); // half the largest length
        COMPARE_NEAR(*at(table, 2).radius_m, std::sqrt(7854 / kPi), 1e-9);
        COMPARE_NEAR(at(table, 3).place.latitude_deg, 59.75, 1e-9);
        COMPARE_NEAR(at(table, 3).place.longitude_deg, -42.95, 1e-9);
        QVERIFY(!at(table, 1).time && at(table, 1).id.empty() && !table.oneIceberg);
        QCOMPARE(faultAt(table, 4), std::string("has no position"));
        QVERIFY(faultAt(table, 5).starts_with("latitude"));
        QCOMPARE(faultAt(table, 6), std::string("has no position"));
        QVERIFY(noteAt(table, 7).starts_with("taken without a number that is out of range"));
    }

    void czmlIsRead()
    {
        const SightingTable table = readFixture("packets.czml");
        QCOMPARE(at(table, 2).id, std::string("Berg one"));
        QCOMPARE(timeOf(at(table, 2)), std::string("2021-04-01T06:00:00Z"));
        QCOMPARE(*at(table, 2).sigma_m2, 12.5);
        QCOMPARE(at(table, 3).id, std::string("b-2"));
        QCOMPARE(timeOf(table.sightings[2]), std::string("2021-04-01T01:00:00Z"));
        QCOMPARE(table.sightings[2].place.latitude_deg, 47.31);
        QCOMPARE(timeOf(at(table, 4)), std::string("2021-04-01T05:00:00Z"));
        QCOMPARE(faultAt(table, 4), std::string("has no position")); // the rest of a sample
        QCOMPARE(faultAt(table, 5), std::string("is no point"));
        QCOMPARE(faultAt(table, 6), std::string("has no position"));
        QVERIFY(faultAt(table, 7).starts_with("latitude"));
        QCOMPARE(faultAt(table, 8), std::string("has no position"));
    }

    void kmzIsRead()
    {
        const std::string kmz = importFixture("places.kmz");
        QCOMPARE(readText(kmz, {.format = "kml"}).format, std::string("kml"));
        const auto messageOf = [](const std::string& bytes) {
            const std::optional<Error> error = errorOf([&] { (void)readText(bytes); });
            return error ? std::string(error->what()) : std::string("nothing");
        };
        QCOMPARE(messageOf(kmz.substr(0, kmz.size() / 2)),
                 std::string("file: is an archive that cannot be read: it is cut off or damaged"));
        QCOMPARE(messageOf(zipFile("sheet.xml", "<x/>")),
                 std::string("file: is a compressed archive (such as XLSX) without a file *.kml"));
        QCOMPARE(messageOf(zipFile("doc.kml", kmz)),
                 std::string("file: is an archive in an archive"));
        QCOMPARE(messageOf(zipFile("doc.kml", "")), std::string("file: is empty"));
        const std::string bomb = messageOf(zipFile("doc.kml", std::string(80'000'000, ' ')));
        QVERIFY2(bomb.starts_with("file: would take more than 50 MB of memory"), bomb.c_str());
        std::string broken = kmz;
        broken[broken.size() / 3] = static_cast<char>(~broken[broken.size() / 3]);
        QVERIFY(messageOf(broken) != "nothing");
    }

    void geoJsonIsRead()
    {
        const SightingTable table = readFixture("points.geojson");
        const Sighting first = at(table, 1);
        QCOMPARE(first.id, std::string("g-1"));
        QCOMPARE(first.name, std::string("Ilulissat nord"));
        QCOMPARE(*first.speed_mps, 0.2);
        QCOMPARE(*first.direction_deg, 270.0);
        QCOMPARE(*first.sigma_m2, 900.0);
        QCOMPARE(*first.radius_m, 120.0);
        QCOMPARE(at(table, 2).id, std::string("g-2")); // the property comes first
        QCOMPARE(*at(table, 2).q_m2ps, 0.5);
        QCOMPARE(table.sightings[2].id, std::string("g-3"));
        QCOMPARE(timeOf(table.sightings[4]), std::string("2024-06-01T08:00:00Z"));
        QCOMPARE(faultAt(table, 4), std::string("is no point: \"LineString\""));
        QCOMPARE(faultAt(table, 5), std::string("has no position"));
        QCOMPARE(noteAt(table, 6),
                 std::string("taken without its time, which cannot be read: \"yesterday\""));
    }

    void geoJsonOfOneGeometryIsRead()
    {
        const SightingTable table = readText(R"({"type": "Point", "coordinates": [10, 80]})");
        QCOMPARE(table.sightings.size(), std::size_t{1});
        QCOMPARE(table.sightings[0].place.latitude_deg, 80.0);
    }

    void kmlIsRead()
    {
        const SightingTable table = readFixture("places.kml");
        QCOMPARE(at(table, 5).id, std::string("S\xC3\xB8ndre & nordre"));
        QCOMPARE(timeOf(at(table, 5)), std::string("2023-05-04T06:00:00Z"));
        QCOMPARE(at(table, 5).place.latitude_deg, 48.25);
        QCOMPARE(at(table, 11).id, std::string("k-2"));
        QCOMPARE(*at(table, 11).radius_m, 40.0);
        QCOMPARE(timeOf(at(table, 11)), std::string("2023-05-04T05:00:00Z"));
        QCOMPARE(table.sightings[2].id, std::string("beacon"));
        QCOMPARE(table.sightings[4].place.longitude_deg, -50.01);
        QCOMPARE(faultAt(table, 28), std::string("has no time")); // one more coord than when
        QCOMPARE(faultAt(table, 31), std::string("has no position"));
        QVERIFY(faultAt(table, 32).starts_with("longitude"));
        QCOMPARE(faultAt(table, 33), std::string("has no position"));
    }

    void gpxIsRead()
    {
        const SightingTable table = readFixture("waypoints.gpx");
        QCOMPARE(table.format, std::string("gpx"));
        QCOMPARE(table.sightings.size(), std::size_t{4});
        QCOMPARE(table.rejected.count, std::size_t{2});
        QCOMPARE(table.sightings[0].id, std::string("w-1"));
        QCOMPARE(table.sightings[3].id, std::string("t-1"));
        QCOMPARE(timeOf(table.sightings[3]), std::string("2022-08-01T11:00:00Z"));
    }

    /** Each track is an iceberg of its own, and points are not a track. */
    void tracksWithoutNamesAreSeveralIcebergs_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("gpx") << QByteArray(
            "<gpx><trk><trkseg><trkpt lat='60' lon='-50'><time>2021-06-02T00:00:00Z</time></trkpt>"
            "<trkpt lat='60.01' lon='-50'><time>2021-06-02T02:00:00Z</time></trkpt></trkseg></trk>"
            "<trk><trkseg><trkpt lat='61' lon='-50'><time>2021-06-02T00:00:00Z</time></trkpt>"
            "<trkpt lat='61.01' lon='-50'><time>2021-06-02T02:00:00Z</time></trkpt></trkseg></trk>"
            "</gpx>");
        const std::string line =
            R"({"type": "Feature", "properties": {"times":)"
            R"(["2021-06-02T00:00:00Z", "2021-06-02T02:00:00Z"]}, "geometry":)"
            R"({"type": "LineString", "coordinates": [[-50, 60], [-50, 61]]}})";
        QTest::newRow("geojson") << QByteArray::fromStdString(
            R"({"type": "FeatureCollection", "features": [)" + line + ',' + line + "]}");
        const std::string track = "<Placemark><Track><when>2021-06-02T00:00:00Z</when>"
                                  "<when>2021-06-02T02:00:00Z</when><coord>-50 60 0</coord>"
                                  "<coord>-50 60.01 0</coord></Track></Placemark>";
        QTest::newRow("kml") << QByteArray::fromStdString("<kml>" + track + track + "</kml>");
    }
    void tracksWithoutNamesAreSeveralIcebergs()
    {
        QFETCH(const QByteArray, text);
        const SightingTable table = readText(text.toStdString());
        QCOMPARE(table.sightings.size(), std::size_t{4});
        QCOMPARE(table.sightings[1].id, std::string("track 2021-06-02T00:00:00Z"));
        QCOMPARE(table.sightings[2].id, std::string("track 2021-06-02T00:00:00Z 2"));
        QVERIFY(table.sightings[0].id == table.sightings[1].id);
        QVERIFY(table.sightings[2].id == table.sightings[3].id);
        QVERIFY(!table.oneIceberg);
    }

    void waypointsWithTimesAreNoTrack()
    {
        const SightingTable table =
            readText("<gpx><wpt lat='60' lon='-50'><time>2021-06-02T00:00:00Z</time></wpt>"
                     "<wpt lat='61' lon='-50'><time>2021-06-02T00:10:00Z</time></wpt></gpx>");
        QVERIFY(!table.oneIceberg);
        QVERIFY(table.sightings[0].id.empty() && table.sightings[1].id.empty());
    }

    /** The time of a view is not that of the place. */
    void timesOfViewsInKmlAreIgnored()
    {
        const SightingTable table =
            readText("<kml><Placemark><LookAt><TimeSpan><begin>1999-01-01</begin></TimeSpan>"
                     "</LookAt><TimeStamp><when>2021-06-02</when></TimeStamp><Point><coordinates>"
                     "-50,60</coordinates></Point></Placemark></kml>");
        QCOMPARE(timeOf(table.sightings[0]), std::string("2021-06-02T00:00:00Z"));
    }

    void longitudesMayExceed180_data()
    {
        QTest::addColumn<double>("expected_deg");
        QTest::newRow("181.5") << -178.5;
        QTest::newRow("360") << 0.0;
        QTest::newRow("180") << -180.0;
        QTest::newRow("-180") << -180.0;
        QTest::newRow("62.4W") << -62.4;
        QTest::newRow("E 12") << 12.0;
    }

    void longitudesMayExceed180()
    {
        QFETCH(double, expected_deg);
        const SightingTable table =
            readText("lat,lon\n1," + std::string(QTest::currentDataTag()) + "\n");
        QCOMPARE(table.sightings[0].place.longitude_deg, expected_deg);
    }

    /** Either sign or letter may be meant. */
    void signAndLetterAreNoPlace()
    {
        const SightingTable table =
            readText("lat,lon\n-62.4S,54.2W\n62.4S,-54.2W\n62.4N,+54E\n62.4S,54.2W\n");
        QCOMPARE(table.sightings.size(), std::size_t{1});
        QCOMPARE(table.sightings[0].place.latitude_deg, -62.4);
        QCOMPARE(table.rejected.count, std::size_t{3});
        QCOMPARE(englishText(reasonOf(table.rejected.first[0])),
                 std::string("latitude must be between -90 and 90, minutes below 60: \"-62.4S\""));
    }

    void polygonsMayCrossTheAntimeridian()
    {
        const std::string ring = "[[[179.9, -70], [-179.9, -70], [-179.9, -69.9], [179.9, -69.9], "
                                 "[179.9, -70]]]";
        const SightingTable table = readText(
            R"({"type": "Feature", "geometry": {"type": "Polygon", "coordinates": )" + ring + "}}");
        QCOMPARE(table.sightings.size(), std::size_t{1});
        QVERIFY(std::abs(std::abs(table.sightings[0].place.longitude_deg) - 180) < 1e-9);
        QVERIFY(std::abs(table.sightings[0].place.latitude_deg + 69.95) < 1e-9);
    }

    /** A text that applies to a whole track is not copied for each of its points. */
    void longTextsOfLongTracksAreNotCopied()
    {
        const std::string longText(1'000'000, 'n');
        std::string kml =
            "<kml xmlns:gx='http://www.google.com/kml/ext/2.2'><Placemark><ExtendedData><Data "
            "name=\"remarks\"><value>" +
            longText + "</value></Data></ExtendedData><gx:Track>";
        std::string gpx = "<gpx><trk><name>" + longText + "</name><trkseg>";
        for (int i = 0; i < 20'000; ++i) {
            kml += "<when>2021-01-01T00:00:00Z</when><gx:coord>-50 60 0</gx:coord>\n";
            gpx += "<trkpt lat='60' lon='-50'><time>2021-01-01T00:00:00Z</time></trkpt>\n";
        }
        QCOMPARE(readText(kml + "</gx:Track></Placemark></kml>").sightings.size(),
                 std::size_t{20'000});
        const SightingTable track = readText(gpx + "</trkseg></trk></gpx>");
        QCOMPARE(track.sightings.size(), std::size_t{20'000});
        QVERIFY(track.sightings[0].id.size() <= kLongestId);
        QCOMPARE(track.noted.count, std::size_t{20'000});
    }

    /** A file in an old encoding is read with any line end. */
    void oldEncodingsAndLineEndsAreRead()
    {
        for (const char* end : {"\n", "\r\n", "\r"}) {
            const std::string text = std::string("name,lat,lon") + end + "\xD8rn,70,20" + end;
            const SightingTable table = readText(text);
            QCOMPARE(table.sightings.size(), std::size_t{1});
            QCOMPARE(table.sightings[0].name, std::string("\xC3\x98rn"));
            QCOMPARE(table.sightings[0].line, std::size_t{2});
        }
    }

    void textIsCleaned()
    {
        const SightingTable table = readText("id,lat,lon\n\" a\x07"
                                             "b\n\",1,2\n");
        QCOMPARE(table.sightings[0].id, std::string("a b"));
        QCOMPARE(cleanText("\xC3\xB8\xC3\xB8", 3), std::string("\xC3\xB8"));
        QCOMPARE(cleanText("a\xFF", 9), std::string("a?"));
    }

    void unusableFilesAreRejected_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("format");
        QTest::addColumn<QByteArray>("code");
        QTest::addColumn<QByteArray>("says");
        const auto row = [](const char* name, const QByteArray& text, const char* format,
                            const char* code, const char* says) {
            QTest::newRow(name) << text << QByteArray(format) << QByteArray(code)
                                << QByteArray(says);
        };
        row("empty", "", "auto", "WrongFormat", "is empty");
        row("blank", " \r\n\n", "csv", "WrongFormat", "is empty");
        row("binary",
            QByteArray("\x7F"
                       "ELF\x02\x01\0\0\0",
                       9),
            "auto", "WrongFormat", "no text");
        row("UTF-16", QByteArray("\xFF\xFEl\0a", 5), "auto", "WrongFormat", "UTF-16");
        row("archive", "PK\x03\x04 and more", "auto", "WrongFormat", "archive");
        row("header only", "id,lat,lon\n", "auto", "InvalidInput", "no sightings");
        row("no latitude", "id,place\n1,2\n", "auto", "WrongFormat", "known formats");
        row("no latitude, asked", "id,lon\n1,2\n", "csv", "InvalidInput", "latitude");
        row("no feature in order", R"({"type": "Point", "coordinates": [1, 99]})", "auto",
            "InvalidInput", "feature 1: ");
        row("no row in order", "id,lat,lon\n1,99,2\n2,98,2\n", "auto", "InvalidInput", "line 3: ");
        row("nine columns", "2021,1,04/01/2021,5,48,-50,VIS,SM,PIN\n", "iip", "WrongFormat", "10");
        row("no beacon", "id,lat,lon\n1,2,3\n", "cis-beacon", "InvalidInput", "time");
        row("broken JSON", R"({"coordinates": )", "geojson", "SyntaxError", "line 1");
        row("cut JSON", R"({"type": "FeatureCollection", )", "auto", "SyntaxError", "line 1");
        row("JSON without features", R"({"a": "coordinates"})", "geojson", "InvalidInput",
            "feature 1");
        row("broken XML", "<kml><Placemark></kml>", "auto", "SyntaxError", "line 1");
        row("entities", "<!DOCTYPE kml [<!ENTITY a \"b\">]><kml>&a;</kml>", "auto", "SyntaxError",
            "DOCTYPE");
        row("unknown format", "lat,lon\n1,2\n", "shp", "Unsupported", "cis-beacon");
        row("two columns of one name", "id,lat,lon,LAT\n1,2,3,4\n", "csv", "InvalidInput",
            "latitude: columns 2 and 4 are both called \"LAT\"");
        row("quote in the header", "\"id,lat,lon\n1,2,3\n", "csv", "WrongFormat", "first line");
    }

    void unusableFilesAreRejected()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, format);
        QFETCH(QByteArray, code);
        QFETCH(QByteArray, says);
        const std::optional<Error> error = errorOf([&] {
            (void)readText(text.toStdString(), {.format = format.toStdString(), .mapping = {}});
        });
        QVERIFY(error);
        QCOMPARE(QByteArray::fromStdString(codeName(error->code())), code);
        QVERIFY2(QByteArray(error->what()).contains(says), error->what());
    }

    void tooManyRowsAreRejected()
    {
        std::string text = "lat,lon\n";
        for (std::size_t i = 0; i <= 1'000'000; ++i)
            text += "1,2\n";
        QCOMPARE(codeOf([&] { (void)readText(text); }), std::string("FileTooLarge"));
        QCOMPARE(codeOf([&] { (void)readText(std::string((64U << 20U) + 1, 'x')); }),
                 std::string("FileTooLarge"));
    }

    void rejectedRowsAreCountedBeyondThoseStored()
    {
        std::string text = "lat,lon\n1,2\n";
        for (int i = 0; i < 1500; ++i)
            text += "91,2\n";
        const SightingTable table = readText(text);
        QCOMPARE(table.rejected.count, std::size_t{1500});
        QCOMPARE(table.rejected.first.size(), std::size_t{1000});
    }
};

QTEST_APPLESS_MAIN(TestImportFormats)
#include "tst_import_formats.moc"
