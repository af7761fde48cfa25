#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/import_quantity.h"
#include "tests/support/approx.h"
#include "tests/support/files/import_fixtures.h"

#include <QtTest>

#include <cmath>

using namespace berg;
using namespace berg::test;

namespace {

constexpr double kKnot_mps = 1852.0 / 3600;

} // namespace

class TestImportQuantity : public QObject
{
    Q_OBJECT

private slots:
    void quantitiesAreReadAsWritten_data()
    {
        QTest::addColumn<int>("dimension");
        QTest::addColumn<double>("value"); // NaN if it cannot be read
        QTest::addColumn<bool>("isExact");
        const auto row = [](const char* text, Dimension dimension, double value,
                            bool isExact = true) {
            QTest::newRow(text) << static_cast<int>(dimension) << value << isExact;
        };
        using enum Dimension;
        row("157.50 ° True", Angle, 157.5);
        row("157.5°T", Angle, 157.5);
        row("90 degrees", Angle, 90);
        row("SSE", Angle, 157.5);
        row("south-southeast", Angle, 157.5);
        row("NV", Angle, 315);
        row("nordøst", Angle, 45);
        row("350-10", Angle, 0, false);
        row("170 - 190", Angle, 180, false);
        row("157 magnetic", Angle, NAN);
        row("NNNE", Angle, NAN);
        row("0.9 km/h", Speed, 0.25);
        row("0.5 kn", Speed, 0.5 * kKnot_mps);
        row("0,5 Knots", Speed, 0.5 * kKnot_mps);
        row("0.3 m/s", Speed, 0.3);
        row("30cm s-1", Speed, 0.3);
        row("17.28 km/d", Speed, 0.2);
        row("3 m", Speed, NAN);
        row("fast", Speed, NAN);
        row("120-200", Length, 160, false);
        row("120–200 m", Length, 160, false);
        row("120 m - 200 m", Length, 160, false);
        row("120 to 200 ft", Length, 160 * 0.3048, false);
        row("120 m - 200 ft", Length, NAN);
        row("120 m", Length, 120);
        row("1 200 m", Length, 1200);
        row("400 ft", Length, 121.92);
        row("400'", Length, 121.92);
        row("2 NM", Length, 3704);
        row("<60", Length, 60, false);
        row("ca. 120 m", Length, 120, false);
        row("200+", Length, 200, false);
        row("80 x 120 m", Length, 120);
        row("120 m2", Length, NAN);
        row("120-", Length, NAN);
        row("2021-06-05", Length, NAN);
        row("25 m²", Area, 25);
        row("0.5 km^2", Area, 5e5);
        row("0.025 m²/s", Growth, 0.025);
        row("", Length, NAN);
        row("m", Length, NAN);
    }

    void quantitiesAreReadAsWritten()
    {
        QFETCH(int, dimension);
        QFETCH(double, value);
        QFETCH(bool, isExact);
        const std::optional<ReadQuantity> quantity =
            quantityOf(QTest::currentDataTag(), static_cast<Dimension>(dimension), decimalOf);
        QCOMPARE(quantity.has_value(), !std::isnan(value));
        if (!quantity)
            return;
        COMPARE_NEAR(quantity->value, value, 1e-9);
        QCOMPARE(quantity->isExact, isExact);
    }

    /** Faulty values do not reject their place, and changes are noted. */
    void rowsWithOddValuesAreImported_data()
    {
        QTest::addColumn<QByteArray>("header");
        QTest::addColumn<QByteArray>("cell");
        QTest::addColumn<double>("value"); // NaN if there is none
        QTest::addColumn<QByteArray>("note");
        const auto row = [](const char* header, const char* cell, double value,
                            const char* note = "not noted") {
            QTest::addRow("%s: %s", header, cell)
                << QByteArray(header) << QByteArray(cell) << value << QByteArray(note);
        };
        const char* const unreadable = "taken without a value that cannot be read: \"";
        const char* const range = "taken without a number that is out of range: \"";
        const char* const inexact = "a range, a limit or an estimate is read as one number: \"";
        row("speed", "0.9 km/h", 0.25);
        row("speed_kn", "0.9 km/h", 0.25);
        row("speed (km/h)", "0.9", 0.25);
        row("sog_kn", "1", kKnot_mps);
        row("sog", "1", kKnot_mps);
        row("Speed [m s-1]", "0.3", 0.3);
        row("sog", "102.3", NAN);
        row("speed", "-999", NAN);
        row("speed", "n/a", NAN);
        row("speed", "null", NAN);
        row("speed", "–", NAN);
        row("speed", "99", NAN, range);
        row("speed", "fast", NAN, unreadable);
        row("course", "360", NAN);
        row("cog (degrees_true)", "180", 180);
        row("direction", "360", 360);
        row("direction", "511", NAN);
        row("direction", "SSE", 157.5);
        row("direction", "inshore", NAN, unreadable);
        row("length", "120-200", 80, inexact);
        row("length_ft", "400", 60.96);
        row("length (feet)", "400", 60.96);
        row("length (NM)", "2", 1852);
        row("length", "wide", NAN, unreadable);
        row("radius", "60 m", 60);
        row("area (km²)", "0.01", std::sqrt(1e4 / M_PI));
        row("sigma (m²)", "25", 25);
        row("sigma", "-4", NAN, range);
    }

    void rowsWithOddValuesAreImported()
    {
        QFETCH(const QByteArray, header);
        QFETCH(const QByteArray, cell);
        QFETCH(const double, value);
        QFETCH(const QByteArray, note);
        const SightingTable table = readText("id;lat;lon;" + header.toStdString() + "\na;47;-48;" +
                                             cell.toStdString() + "\nb;47.5;-48.5;\n");
        QCOMPARE(table.sightings.size(), std::size_t{2});
        QCOMPARE(table.rejected.count, std::size_t{0});
        const Sighting& first = table.sightings[0];
        std::vector<double> values;
        for (const auto& read :
             {first.speed_mps, first.direction_deg, first.radius_m, first.sigma_m2})
            if (read)
                values.push_back(*read);
        QCOMPARE(values.size(), std::size_t{std::isnan(value) ? 0U : 1U});
        if (!values.empty())
            COMPARE_NEAR(values[0], value, 1e-9);
        QVERIFY2(QByteArray::fromStdString(noteAt(table, 2)).startsWith(note),
                 noteAt(table, 2).c_str());
        QCOMPARE(noteAt(table, 3), std::string("not noted"));
    }

    /** Two ids that are equal up to the length limit remain two icebergs. */
    void longIdsStayApart_data()
    {
        QTest::addColumn<int>("length");
        QTest::newRow("a little") << 65;
        QTest::newRow("more than is kept of any text") << 600;
    }
    void longIdsStayApart()
    {
        QFETCH(int, length);
        const std::string common(static_cast<std::size_t>(length), 'x');
        const SightingTable table = readText("id,lat,lon\n" + common + "1,47,-48\n" + common +
                                             "2,47.5,-48\n" + common + "1,47.1,-48\n");
        QCOMPARE(table.sightings.size(), std::size_t{3});
        QVERIFY(table.sightings[0].id != table.sightings[1].id);
        QCOMPARE(table.sightings[0].id, table.sightings[2].id);
        QVERIFY(table.sightings[0].id.size() <= kLongestId);
        QVERIFY(table.sightings[0].id.starts_with("xxxxxxxx"));
        QCOMPARE(table.noted.count, std::size_t{3});
    }

    void valuesThatSayThereIsNoPlace()
    {
        const SightingTable table = readText("id,lat,lon\na,91,181\nb,-999,-999\nc,NA,NA\n"
                                             "d,47,181\ne,NaN,5\n");
        for (const std::size_t line : {2U, 3U, 4U, 6U})
            QCOMPARE(faultAt(table, line), std::string("has no position"));
        QCOMPARE(at(table, 5).place.longitude_deg, -179.0);
    }

    /** A time that cannot be read keeps the place, unless its iceberg is placed by other times. */
    void unreadableTimesKeepThePlace()
    {
        const SightingTable table =
            readText("id,time,lat,lon\na,2021-06-05T12:00:00Z,47,-48\na,soon,47.1,-48\n"
                     "b,0000-00-00T00:00:00Z,47.2,-48\nc,,47.3,-48\n");
        QCOMPARE(table.sightings.size(), std::size_t{4});
        QVERIFY(!at(table, 4).time);
        QCOMPARE(noteAt(table, 4), std::string("taken without its time, which cannot be read: "
                                               "\"0000-00-00T00:00:00Z\""));
        const ImportResult result = importSightings(openSea(), table);
        QCOMPARE(result.added, std::size_t{3});
        QCOMPARE(result.rejected.count, std::size_t{1});
        QCOMPARE(result.rejected.first[0].line, std::size_t{3});
        QVERIFY(result.rejected.first[0].fault == IssueId::TimeBesideTimes);
        QCOMPARE(result.noted.count, std::size_t{3});
        const Iceberg& first = result.scenario.icebergs.at(0);
        const LatLon place = LocalFrame(result.scenario.origin).toGeographic(first.position_m);
        COMPARE_NEAR(place.latitude_deg, 47.0, 1e-6);
    }

    /** Sightings outside the area or the time are listed with their lines. */
    void outsideIsListed()
    {
        const SightingTable table =
            readText("id,time,lat,lon\na,2021-06-05T12:00:00Z,47,-48\n"
                     "b,2021-06-05T12:00:00Z,60,-48\nc,2021-06-01T12:00:00Z,47.1,-48\n"
                     "d,2021-06-06T12:00:00Z,47.1,-48\n");
        const ImportResult result =
            importSightings(openSea(), table,
                            {.at = utc("2021-06-05T18:00:00Z"),
                             .since = utc("2021-06-02T00:00:00Z"),
                             .area = GeoBox{.south_deg = 40, .north_deg = 50}});
        const std::vector<RejectedRow> expected{
            {.line = 3, .fault = IssueId::SightedOutsideArea, .detail = "60 -48"},
            {.line = 4, .fault = IssueId::SightedOutsideTime, .detail = "2021-06-01T12:00:00Z"},
            {.line = 5, .fault = IssueId::SightedOutsideTime, .detail = "2021-06-06T12:00:00Z"}};
        QVERIFY(result.outside.first == expected);
        const std::string json = importJson(table, result);
        for (const RejectedRow& row : expected)
            QVERIFY(json.find(englishText(reasonOf(row)).substr(0, 20)) != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(TestImportQuantity)
#include "tst_import_quantity.moc"
