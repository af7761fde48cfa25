#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/import_source.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/import_fixtures.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;

/** Tests of tables with a header: the fields of columns and the reading of cells. */
class TestImportTables : public QObject
{
    Q_OBJECT

private slots:
    /**
     * A table with semicolons, decimal commas, quotes over two lines, hemispheres, units in the
     * header.
     */
    void tableInLocalNotationIsRead()
    {
        const SightingTable table = readFixture("table.csv");
        const Sighting first = at(table, 2);
        QCOMPARE(first.id, std::string("t-1"));
        QCOMPARE(first.name, std::string("Big; \"tabular\" berg"));
        QCOMPARE(first.place.latitude_deg, 69.25);
        COMPARE_NEAR(*first.speed_mps, 0.5 * 1852 / 3600, 1e-12);
        QCOMPARE(*first.q_m2ps, 0.5);
        QCOMPARE(*first.radius_m, 150.0);
        QCOMPARE(at(table, 4).place.longitude_deg, -51.25);
        QCOMPARE(timeOf(at(table, 4)), std::string("2024-05-01T06:00:00Z"));
        QCOMPARE(timeOf(at(table, 11)), std::string("2024-05-01T04:30:00Z"));
        QCOMPARE(noteAt(table, 5),
                 std::string("taken without a number that is out of range: \"sigma: -4\""));
        QVERIFY(faultAt(table, 6).starts_with("latitude"));
        QCOMPARE(faultAt(table, 7), std::string("text follows a closing quote"));
        QVERIFY(faultAt(table, 8).starts_with("longitude"));
        QVERIFY(noteAt(table, 12).starts_with("its id is too long and is shortened"));
        QCOMPARE(faultAt(table, 13), std::string("a quote is opened and never closed"));
    }

    /** Notations of navigators; each row is the same place. */
    void placesInDegreesAndMinutesAreRead_data()
    {
        QTest::addColumn<QByteArray>("row");
        QTest::addColumn<bool>("isRead");
        const auto row = [](const char* text, bool isRead) {
            QTest::newRow(text) << QByteArray(text) << isRead;
        };
        row("47 01.5 N,48 30.0 W", true);
        row("47-01-30N,048-30-00W", true);
        row("N 47 01.5,W 48 30", true);
        row("47\xC2\xB0 01.5\xE2\x80\xB2 N,48.5W", true);
        row("47 01.5,-48 30", true);
        row("-47 01.5 N,48 30.0 W", false); // both sign and letter
        row("48 30.0 W,47 01.5 N", false);  // in the wrong columns
        row("47 61.5 N,48 30.0 W", false);
        row("47 01.5 N,", false);
    }
    void placesInDegreesAndMinutesAreRead()
    {
        QFETCH(QByteArray, row);
        QFETCH(bool, isRead);
        const SightingTable table = readText("lat,lon\n10,20\n" + row.toStdString() + "\n");
        QCOMPARE(table.sightings.size(), std::size_t{isRead ? 2U : 1U});
        QCOMPARE(table.rejected.count, std::size_t{isRead ? 0U : 1U});
        if (isRead) {
            COMPARE_NEAR(table.sightings[1].place.latitude_deg, 47.025, 1e-9);
            COMPARE_NEAR(table.sightings[1].place.longitude_deg, -48.5, 1e-9);
        }
    }

    void columnsAreGuessed_data()
    {
        QTest::addColumn<QByteArray>("field"); ///< empty if the column is unused
        QTest::addColumn<double>("factor");
        const auto row = [](const char* column, const char* field, double factor = 1) {
            QTest::newRow(column) << QByteArray(field) << factor;
        };
        row("Iceberg ID", "id");
        row("LATITUDE", "latitude");
        row("lat_deg", "latitude");
        row("Lon (dd)", "longitude");
        row("lng", "longitude");
        row("datetime_utc", "time");
        row("BaseDateTime", "time"); // as in AIS
        row("Date", "date");
        row("speed_kn", "speed", 1852.0 / 3600);
        row("Speed (km/h)", "speed", 1 / 3.6);
        row("speed", "speed");
        row("SOG", "speed", 1852.0 / 3600); // as in AIS
        row("sog_mps", "speed");
        row("COG", "direction");
        row("sigma_m2", "sigma");
        row("q_m2ps", "q");
        row("Length (NM)", "length", 1852);
        row("length_ft", "length", 0.3048);
        row("radius", "radius");
        row("area_km2", "area", 1e6);
        row("latency", "");
        row("datetime_transmit", "");
        row("heading", "");
        row("temperature", "");
        row("", "");
    }

    void columnsAreGuessed()
    {
        QFETCH(QByteArray, field);
        QFETCH(double, factor);
        const std::optional<FieldUse> use = fieldOfColumn(QTest::currentDataTag());
        QCOMPARE(use.has_value(), !field.isEmpty());
        if (!use)
            return;
        QCOMPARE(QByteArray::fromStdString(nameOf(kSightingFieldNames, use->field)), field);
        COMPARE_NEAR(use->factor, factor, 1e-12);
    }

    void columnsCanBeMapped()
    {
        const std::string text = "A,B,C_kn,lat,D\n60,-50,2,1,90\n";
        const ReadOptions options{.mapping = {{SightingField::Latitude, "A"},
                                              {SightingField::Longitude, "B"},
                                              {SightingField::Speed, "C_kn"},
                                              {SightingField::Direction, "D"}}};
        const SightingTable table = readText(text, options);
        QCOMPARE(table.format, std::string("csv"));
        QCOMPARE(table.sightings[0].place.latitude_deg, 60.0); // not the column called lat
        COMPARE_NEAR(*table.sightings[0].speed_mps, 2 * 1852.0 / 3600, 1e-12);
        QCOMPARE(table.columns.size(), std::size_t{5});
        QCOMPARE(table.mapping.size(), std::size_t{4});
        QVERIFY(table.mapping[0] == (FieldColumn{SightingField::Latitude, "A"}));
    }

    /** A unit must follow a blank or another separator: a draft is not in feet. */
    void unitsOfMappedColumnsAreUsed_data()
    {
        QTest::addColumn<double>("radius_m");
        QTest::newRow("Draft") << 100.0;
        QTest::newRow("Draft_ft") << 30.48;
        QTest::newRow("Draft (km)") << 100'000.0;
    }
    void unitsOfMappedColumnsAreUsed()
    {
        QFETCH(const double, radius_m);
        const std::string column = QTest::currentDataTag();
        const SightingTable table = readText("lat,lon," + column + "\n60.5,-50.5,100\n",
                                             {.mapping = {{SightingField::Radius, column}}});
        COMPARE_NEAR(*table.sightings[0].radius_m, radius_m, 1e-9);
    }

    /** Hemisphere, minutes and seconds have columns of their own. */
    void placesInPartsAreJoined_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("letters") << QByteArray("lat,N/S,lon,E/W\n60.75,N,50.5,W\n");
        QTest::newRow("words") << QByteArray("E/W,lon,lat,lat_dir\nWest,50.5,60.75,North\n");
        QTest::newRow("minutes") << QByteArray("lat_deg,lat_min,lon_deg,lon_min\n60,45.0,-50,30\n");
        QTest::newRow("floats") << QByteArray(
            "lat_deg,lat_min,lon_deg,lon_min\n60.0,45,-50.0,30\n");
        QTest::newRow("commas") << QByteArray("lat;lat_min;lon;lon_min\n60;45,0;-50;30,0\n");
        QTest::newRow("seconds") << QByteArray("lat,lat_min,lat_sec,NS,lon,lon_min,lon_sec,EW\n"
                                               "60,44,60,N,50,30,0,W\n60,45,0,N,50,30,0,W\n");
    }
    void placesInPartsAreJoined()
    {
        QFETCH(const QByteArray, text);
        const SightingTable table = readText(text.toStdString());
        QCOMPARE(table.sightings.size(), std::size_t{1});
        COMPARE_NEAR(table.sightings[0].place.latitude_deg, 60.75, 1e-9);
        COMPARE_NEAR(table.sightings[0].place.longitude_deg, -50.5, 1e-9);
        QVERIFY(table.unused.empty());
    }

    void unusedColumnsAreListed()
    {
        const SightingTable table = readText("lat,lon,lat_min,lat_max,depth\n60,-50,59,61,9\n");
        QCOMPARE(table.unused, (std::vector<std::string>{"lat_min", "lat_max", "depth"}));
        QCOMPARE(table.sightings[0].place.latitude_deg, 60.0);
    }

    void unknownZoneIsRejected()
    {
        const auto messageOf = [](const std::string& text) {
            const std::optional<Error> error = errorOf([&] { (void)readText(text); });
            return error ? std::string(error->what()) : std::string("nothing");
        };
        const std::string row = "\n60,-50,2021-06-02 07:30,2021-06-02 12:30\n";
        QVERIFY(messageOf("lat,lon,time (EST),sent" + row).find("\"time (EST)\"") !=
                std::string::npos);
        QCOMPARE(messageOf("lat,lon,time (EST),time (UTC)" + row), std::string("nothing"));
        QVERIFY(messageOf("lat,lon,hemisphere\n60,50,W\n").find("hemisphere") != std::string::npos);
    }

    /** Lines above the header are skipped; a comment may be the header itself. */
    void linesAboveTheHeaderAreSkipped_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("line");
        QTest::newRow("separator") << QByteArray("sep=;\r\nid;lat;lon\r\na;60,1;-50,5\r\n") << 3;
        QTest::newRow("comments") << QByteArray("# by X\n# lat, lon\n\nid,lat,lon\na,60.1,-50.5\n")
                                  << 5;
        QTest::newRow("header") << QByteArray("#id,lat,lon\na,60.1,-50.5\n") << 2;
    }
    void linesAboveTheHeaderAreSkipped()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const int, line);
        const SightingTable table = readText(text.toStdString());
        QCOMPARE(table.sightings.size(), std::size_t{1});
        QCOMPARE(table.sightings[0].id, std::string("a"));
        QCOMPARE(table.sightings[0].place.longitude_deg, -50.5);
        QCOMPARE(table.sightings[0].line, static_cast<std::size_t>(line));
    }

    void wordsAreNoNumbers()
    {
        const SightingTable table =
            readText("lat,lon,speed,direction\n60,-50,1,inshore\n60,-50,1,45\n");
        QCOMPARE(noteAt(table, 2),
                 std::string("taken without a value that cannot be read: \"direction: inshore\""));
        QVERIFY(!table.sightings[0].direction_deg);
        QCOMPARE(table.sightings[1].direction_deg, std::optional(45.0));
    }

    void mappingOfAMissingColumnIsRejected()
    {
        const std::optional<Error> error = errorOf([] {
            (void)readText("lat,lon\n1,2\n", {.mapping = {{SightingField::Time, "when"}}});
        });
        QVERIFY(error && error->code() == ErrorCode::InvalidInput);
        QVERIFY(names(error->issues(), "time"));
        const std::string point = R"({"type": "Feature", "properties": {"berg": "a"},)"
                                  R"("geometry": {"type": "Point", "coordinates": [1, 2]}})";
        const auto code = [&](SightingField field, const char* column) {
            return codeOf([&] { (void)readText(point, {.mapping = {{field, column}}}); });
        };
        QCOMPARE(code(SightingField::Id, "iceberg"), std::string("InvalidInput"));
        QCOMPARE(code(SightingField::Latitude, "berg"), std::string("InvalidInput"));
        QCOMPARE(readText(point, {.mapping = {{SightingField::Id, "berg"}}}).sightings[0].id,
                 std::string("a"));
    }

    void dateAndTimeMayHaveTheirOwnColumns()
    {
        const SightingTable table = readText("id,date,time,lat,lon\na,5/1/2024,605,60,-50\n"
                                             "b,5/1/2024,,60,-50\nc,5/13/2024,06:07,60,-50\n"
                                             "d,,6:07,60,-50\n");
        QCOMPARE(timeOf(at(table, 2)), std::string("2024-05-01T06:05:00Z"));
        QCOMPARE(noteAt(table, 3), std::string("taken without a time, which it does not have"));
        QCOMPARE(timeOf(at(table, 4)), std::string("2024-05-13T06:07:00Z"));
        QVERIFY(!at(table, 5).time);
        const SightingTable both =
            readText("date,time,datetime,lat,lon\n2024-05-01,06:00,2024-05-02T07:00:00Z,60,-50\n");
        QCOMPARE(timeOf(both.sightings[0]), std::string("2024-05-02T07:00:00Z"));
        const SightingTable feature =
            readText(R"({"type": "Feature", "geometry": {"type": "Point", "coordinates": [1, 2]},)"
                     R"("properties": {"date": "2024-05-01", "time": "06:00"}})");
        QCOMPARE(timeOf(feature.sightings.at(0)), std::string("2024-05-01T06:00:00Z"));
    }

    void rowsWithoutIdsAreOneTrack()
    {
        QVERIFY(readText("time,lat,lon\n2024-01-01T00:00:00Z,1,2\n2024-01-01T01:00:00Z,1,2\n")
                    .oneIceberg);
        QVERIFY(!readText("time,lat,lon\n2024-01-01T00:00:00Z,1,2\n2024-01-01T00:00:00Z,1,3\n")
                     .oneIceberg);
        QVERIFY(!readText("lat,lon\n1,2\n1,3\n").oneIceberg);
        // A column of names distinguishes the rows like a column of ids.
        const SightingTable named =
            readText("name;lat;lon;time\nA;1;2;2024-05-01T00:00:00Z\nB;1;3;2024-05-01T01:00:00Z\n"
                     "A;1;2;2024-05-01T02:00:00Z\n");
        QVERIFY(!named.oneIceberg);
        QCOMPARE(named.sightings[0].id, named.sightings[2].id);
        QCOMPARE(named.sightings[1].id, std::string("B"));
        QVERIFY(readText("name,lat,lon,time\nA,1,2,2024-05-01T00:00:00Z\n"
                         "A,1,3,2024-05-01T01:00:00Z\n")
                    .oneIceberg);
    }

    void commasAmongDigitsFollowThePlace_data()
    {
        QTest::addColumn<QByteArray>("row");
        QTest::addColumn<double>("radius_m"); // below 0 if the number is left out
        QTest::newRow("points elsewhere") << QByteArray("60.5;-50.5;1,200") << 1200.0;
        QTest::newRow("millions") << QByteArray("60.5;-50.5;1,200,000") << -1.0;
        QTest::newRow("commas elsewhere") << QByteArray("60,5;-50,5;1,200") << 1.2;
        QTest::newRow("nothing elsewhere") << QByteArray("60;-50;1,200") << -1.0;
        QTest::newRow("no group") << QByteArray("60.5;-50.5;1,25") << 1.25;
        QTest::newRow("no group of three") << QByteArray("60.5;-50.5;1234,567") << 1234.567;
        QTest::newRow("thousands") << QByteArray("60.5;-50.5;12,000") << 12000.0;
    }
    void commasAmongDigitsFollowThePlace()
    {
        QFETCH(const QByteArray, row);
        QFETCH(const double, radius_m);
        const SightingTable table =
            readText("lat;lon;radius_m\n" + row.toStdString() + "\n1.5;1.5;1\n");
        QCOMPARE(table.noted.count, std::size_t{radius_m < 0 ? 1U : 0U});
        QCOMPARE(table.sightings[0].radius_m,
                 radius_m < 0 ? std::nullopt : std::optional(radius_m));
    }

    void ambiguousCommasAreNoted()
    {
        const SightingTable table = readText("lat;lon;radius_m\n60;-50;1,200\n1.5;1.5;1\n");
        QCOMPARE(noteAt(table, 2),
                 std::string("taken without a value that cannot be read: \"radius: 1,200\""));
    }

    /** 05/02/2021 is 5 February or 2 May. */
    void ambiguousDatesAreDecidedOrGuessed()
    {
        const std::string open = "lat,lon,time\n60,-50,05/02/2021\n";
        const SightingTable guessed = readText(open);
        QCOMPARE(guessed.guessedDate, std::string("05/02/2021"));
        QCOMPARE(guessed.guessedLine, std::size_t{2});
        QCOMPARE(timeOf(guessed.sightings[0]), std::string("2021-05-02T00:00:00Z"));
        const SightingTable asked = readText(open, {.mapping = {}, .dates = DateOrder::DayFirst});
        QCOMPARE(asked.guessedDate, std::string());
        QCOMPARE(timeOf(asked.sightings[0]), std::string("2021-02-05T00:00:00Z"));
        QCOMPARE(readText(open + "60,-50,13/02/2021\n").guessedDate, std::string());
        QCOMPARE(readText("lat,lon,time\n60,-50,05/05/2021\n").guessedDate, std::string());
    }

    /** Dates of maps, as in tables, are decided by a later date, by the user, or by a guess. */
    void ambiguousDatesOfMapsAreDecidedOrGuessed_data()
    {
        QTest::addColumn<QByteArray>("head");
        QTest::addColumn<QByteArray>("before"); ///< the date
        QTest::addColumn<QByteArray>("behind");
        QTest::addColumn<QByteArray>("tail");
        QTest::newRow("geojson")
            << QByteArray(R"({"type": "FeatureCollection", "features": [{"type": "Feature"})")
            << QByteArray(R"(,{"type": "Feature", "properties": {"time": ")")
            << QByteArray(R"("}, "geometry": {"type": "Point", "coordinates": [-50, 60]}})")
            << QByteArray("]}");
        QTest::newRow("kml") << QByteArray("<kml>")
                             << QByteArray("<Placemark><ExtendedData><Data name=\"time\"><value>")
                             << QByteArray("</value></Data></ExtendedData><Point><coordinates>"
                                           "-50,60</coordinates></Point></Placemark>")
                             << QByteArray("</kml>");
        QTest::newRow("czml") << QByteArray(R"([{"id": "document"})")
                              << QByteArray(R"(,{"properties": {"time": ")")
                              << QByteArray(
                                     R"("}, "position": {"cartographicDegrees": [-50, 60]}})")
                              << QByteArray("]");
    }
    void ambiguousDatesOfMapsAreDecidedOrGuessed()
    {
        QFETCH(const QByteArray, head);
        QFETCH(const QByteArray, before);
        QFETCH(const QByteArray, behind);
        QFETCH(const QByteArray, tail);
        const std::string open = (head + before + "05/02/2021" + behind).toStdString();
        const SightingTable guessed = readText(open + tail.toStdString());
        QCOMPARE(guessed.guessedDate, std::string("05/02/2021"));
        QCOMPARE(timeOf(guessed.sightings[0]), std::string("2021-05-02T00:00:00Z"));
        const SightingTable asked =
            readText(open + tail.toStdString(), {.mapping = {}, .dates = DateOrder::DayFirst});
        QCOMPARE(asked.guessedDate, std::string());
        QCOMPARE(timeOf(asked.sightings[0]), std::string("2021-02-05T00:00:00Z"));
        const SightingTable decided =
            readText(open + (before + "13/02/2021" + behind + tail).toStdString());
        QCOMPARE(decided.guessedDate, std::string());
        QCOMPARE(decided.sightings.size(), std::size_t{2});
        QCOMPARE(timeOf(decided.sightings[0]), std::string("2021-02-05T00:00:00Z"));
    }
};

QTEST_APPLESS_MAIN(TestImportTables)
#include "tst_import_tables.moc"
