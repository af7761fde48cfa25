#include "core/io/import/import_forecast_file.h"
#include "core/io/text/atomic_file.h"
#include "core/scenario/utc_time.h"
#include "tests/fuzz/fuzz_mutator.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

const std::string kGrib = "made.grib";

/** Returns what a program prints, without its last line end. */
QString outputOf(const QString& program, const QStringList& arguments)
{
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForFinished() || process.exitCode() != 0)
        return {};
    return QString(process.readAllStandardOutput()).trimmed();
}

/** Returns the bytes that grib_filter makes of a sample of ecCodes; "" if it cannot. */
std::string gribOf(const QString& rules, const QString& sample)
{
    const QTemporaryDir folder;
    QFile file(folder.filePath("rules"));
    if (!file.open(QIODevice::WriteOnly) || file.write(rules.toUtf8()) < 0)
        return {};
    file.close();
    const QString samples = outputOf(BERG_CODES_INFO, {"-s"});
    const QString made = folder.filePath("made.grib");
    QProcess filter;
    filter.start(BERG_GRIB_FILTER, {"-o", made, file.fileName(), samples + '/' + sample + ".tmpl"});
    if (!filter.waitForFinished() || filter.exitCode() != 0 || !QFile::exists(made)) {
        qWarning("%s", filter.readAllStandardError().constData());
        return {};
    }
    return readFile(made.toStdString());
}

const QString kRegular = R"(
set Ni = 3; set Nj = 3;
set latitudeOfFirstGridPointInDegrees = 62; set latitudeOfLastGridPointInDegrees = 60;
set longitudeOfFirstGridPointInDegrees = 358; set longitudeOfLastGridPointInDegrees = 0;
set iDirectionIncrementInDegrees = 1; set jDirectionIncrementInDegrees = 1;
set dataDate = 20260501; set dataTime = 600; set forecastTime = 6;
set shortName = "10u"; set values = {1,2,3,4,5,6,7,8,9}; write;
set shortName = "10v"; set values = {-1,-2,-3,-4,-5,-6,-7,-8,-9}; write;
set shortName = "2t"; set values = {280,280,280,280,280,280,274.15,280,280}; write;
set shortName = "2d"; set values = {280,280,280,280,280,280,271.15,280,280}; write;
set shortName = "vis"; set values = {9000,9000,9000,9000,9000,9000,5000,9000,9000}; write;
set forecastTime = 9;
set shortName = "10u"; set values = {2,2,3,4,5,6,7,8,9}; write;
set shortName = "10v"; set values = {-2,-2,-3,-4,-5,-6,-7,-8,-9}; write;
)";

/** Winds along a rotated grid, whose pole is at 30 degrees from the true one. */
const QString kRotated = R"(
set Ni = 3; set Nj = 3;
set latitudeOfFirstGridPointInDegrees = 1; set latitudeOfLastGridPointInDegrees = -1;
set longitudeOfFirstGridPointInDegrees = 359; set longitudeOfLastGridPointInDegrees = 1;
set iDirectionIncrementInDegrees = 1; set jDirectionIncrementInDegrees = 1;
set latitudeOfSouthernPoleInDegrees = -30; set longitudeOfSouthernPoleInDegrees = 10;
set angleOfRotationInDegrees = 0; set uvRelativeToGrid = 1;
set dataDate = 20260501; set dataTime = 600; set forecastTime = 6;
set shortName = "10u"; set values = {10,10,10,10,10,10,10,10,10}; write;
set shortName = "10v"; set values = {5,5,5,5,5,5,5,5,5}; write;
)";

} // namespace

class TestImportGrib : public QObject
{
    Q_OBJECT

private slots:
    void regularGridsAreRead()
    {
        const std::string bytes = gribOf(kRegular, "regular_ll_sfc_grib2");
        QVERIFY(!bytes.empty());
        QVERIFY(looksLikeForecast(bytes));
        const ForecastReading reading = forecastFromBytes(bytes, kGrib);
        QCOMPARE(reading.format, std::string("GRIB"));
        QCOMPARE(reading.field.columns, 3U);
        QCOMPARE(reading.field.places.size(), 9U);
        const Forecast& southWest = reading.field.places[0];
        QCOMPARE(southWest.issued, parseUtc("2026-05-01T06:00:00Z"));
        COMPARE_NEAR(southWest.place.latitude_deg, 60, 1e-9);
        COMPARE_NEAR(southWest.place.longitude_deg, -2, 1e-9);
        QCOMPARE(southWest.series.size(), 2U);
        const ForecastEntry& entry = southWest.series[0];
        QCOMPARE(entry.time, *parseUtc("2026-05-01T12:00:00Z"));
        // The sample packs values in few bits.
        COMPARE_NEAR(entry.wind_mps->x(), 7, 0.01);
        COMPARE_NEAR(entry.wind_mps->y(), -7, 0.01);
        COMPARE_NEAR(*entry.airTemperature_degC, 1, 0.05);
        COMPARE_NEAR(*entry.dewPoint_degC, -2, 0.05);
        COMPARE_NEAR(*entry.visibility_m, 5000, 10);
        QVERIFY(!southWest.series[1].airTemperature_degC);
        COMPARE_NEAR(reading.field.places[6].series[1].wind_mps->x(), 2, 0.01);
    }

    void componentsAlongARotatedGridAreTurned()
    {
        const std::string bytes = gribOf(kRotated, "rotated_ll_sfc_grib2");
        QVERIFY(!bytes.empty());
        const ForecastReading reading = forecastFromBytes(
            bytes, kGrib,
            {.area =
                 GeoBox{.south_deg = 59.9925, .west_deg = 9, .north_deg = 59.9925, .east_deg = 9}});
        QCOMPARE(reading.field.places.size(), 1U);
        const Point wind_mps = *reading.field.places[0].series[0].wind_mps;
        // Between the nodes at 59.985 N 8.001 E and 60 N 10 E the x axis rises by 0.015 degrees in
        // 1.999 * cos 59.99 = 0.9997: 0.0150 rad.
        COMPARE_NEAR(wind_mps.x(), 10 - 5 * 0.0150, 0.01);
        COMPARE_NEAR(wind_mps.y(), 5 + 10 * 0.0150, 0.01);
    }

    void windsOfOtherHeightsAreSkipped()
    {
        QString rules = kRegular;
        rules.replace("\"10u\"", "\"100u\"").replace("\"10v\"", "\"100v\"");
        const ForecastReading reading =
            forecastFromBytes(gribOf(rules, "regular_ll_sfc_grib2"), kGrib);
        QVERIFY(!gives(reading.field.places[0], ForecastQuantity::Wind));
        QVERIFY(gives(reading.field.places[0], ForecastQuantity::Visibility));
    }

    void faultsNameTheMessage()
    {
        const std::string bytes = gribOf(kRegular, "regular_ll_sfc_grib2");
        const std::optional<Error> cutOff = errorOf([&] {
            (void)forecastFromBytes(std::string_view(bytes).substr(0, bytes.size() - 9), kGrib);
        });
        QVERIFY(cutOff);
        QCOMPARE(std::string(cutOff->what()), kGrib + ": message 7: is damaged");
        std::string older = bytes;
        older[7] = 1;
        const std::optional<Error> edition =
            errorOf([&] { (void)forecastFromBytes(older, kGrib); });
        QVERIFY(edition);
        QVERIFY2(QString(edition->what()).contains("message 1: is GRIB of edition 1"),
                 edition->what());
        const std::optional<Error> empty = errorOf([&] { (void)forecastFromBytes("GRIB", kGrib); });
        QVERIFY(empty);
    }

    void sectionsStayInTheirMessage()
    {
        const std::string bytes = gribOf(kRegular, "regular_ll_sfc_grib2");
        constexpr std::size_t kFirst = 16; // of section 1, with its length
        for (const auto& [offset, value] : {std::pair{0U, 1}, {1U, 0x80}, {3U, 4}, {3U, 0}}) {
            std::string broken = bytes;
            broken[kFirst + offset] = static_cast<char>(value);
            const std::optional<Error> error =
                errorOf([&] { (void)forecastFromBytes(broken, kGrib); });
            QVERIFY(error);
            QCOMPARE(std::string(error->what()), kGrib + ": message 1: is damaged");
        }
    }

    void mutantsAreRejectedOrSound()
    {
        const std::string bytes = gribOf(kRegular, "regular_ll_sfc_grib2");
        const std::vector<std::string> corpus{bytes};
        fuzz::Mutator mutator(1, corpus);
        for (int i = 0; i < 40; ++i) {
            const std::string mutant = mutator.mutated(bytes);
            try {
                QVERIFY(isGrid(forecastFromBytes(mutant, kGrib).field));
            } catch (const Error& error) {
                QVERIFY(!error.issues().empty());
            }
        }
    }
};

QTEST_APPLESS_MAIN(TestImportGrib)
#include "tst_import_grib.moc"
