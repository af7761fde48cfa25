#include "core/base/stopped.h"
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

#include <cmath>
#include <numbers>

using namespace berg;
using namespace berg::test;

namespace {

const std::string kNetcdf = "made.nc";

/** Returns the bytes of the NetCDF file that ncgen makes of a description; "" if it cannot. */
std::string netcdfOf(const QString& description, const char* kind = "classic")
{
    const QTemporaryDir folder;
    QFile file(folder.filePath("made.cdl"));
    if (!file.open(QIODevice::WriteOnly) || file.write(description.toUtf8()) < 0)
        return {};
    file.close();
    const QString made = folder.filePath("made.nc");
    QProcess ncgen;
    ncgen.start(BERG_NCGEN, {"-k", kind, "-o", made, file.fileName()});
    if (!ncgen.waitForFinished() || ncgen.exitCode() != 0) {
        qWarning("%s", ncgen.readAllStandardError().constData());
        return {};
    }
    return readFile(made.toStdString());
}

ForecastReading readNetcdf(const std::string& bytes, const ForecastReadOptions& options = {})
{
    return forecastFromBytes(bytes, kNetcdf, options);
}

/** Packed winds on two heights, temperatures, and depths; latitudes fall. */
const QString kPacked = R"(netcdf packed {
dimensions: time = UNLIMITED ; height = 2 ; lat = 3 ; lon = 2 ;
variables:
  double time(time) ; time:units = "hours since 2026-05-01 00:00:00" ; time:calendar = "standard" ;
  float height(height) ; height:units = "m" ; height:standard_name = "height" ;
  float lat(lat) ; lat:units = "degrees_north" ;
  float lon(lon) ; lon:units = "degrees_east" ;
  short u(time, height, lat, lon) ; u:standard_name = "eastward_wind" ; u:units = "m s-1" ;
    u:scale_factor = 0.5 ; u:add_offset = 10. ; u:_FillValue = -32767s ;
  short v(time, height, lat, lon) ; v:standard_name = "northward_wind" ; v:units = "m s-1" ;
    v:scale_factor = 0.5 ; v:_FillValue = -32767s ;
  float t2m(time, lat, lon) ; t2m:units = "K" ;
  float dew(time, lat, lon) ; dew:units = "degC" ; dew:standard_name = "dew_point_temperature" ;
  float vis(time, lat, lon) ; vis:units = "km" ; vis:standard_name = "visibility_in_air" ;
  float cbh(time, lat, lon) ; cbh:units = "m" ;
  float fog(time, lat, lon) ; fog:units = "1" ; fog:standard_name = "fog_area_fraction" ;
  float deptho(lat, lon) ; deptho:standard_name = "sea_floor_depth_below_geoid" ; deptho:units = "m" ;
  double forecast_reference_time ; forecast_reference_time:units = "seconds since 1970-01-01" ;
  :title = "Test model" ;
data:
  time = 0, 6 ; height = 100, 10 ; lat = 62, 61, 60 ; lon = 358, 359 ;
  u = 99,99,99,99,99,99, 0,1,2,3,4,_, 99,99,99,99,99,99, 6,7,8,9,10,11 ;
  v = 99,99,99,99,99,99, 0,2,4,6,8,_, 99,99,99,99,99,99, 6,7,8,9,10,11 ;
  t2m = 273.15,274.15,275.15,276.15,277.15,278.15, 273.15,274.15,275.15,276.15,277.15,278.15 ;
  dew = -1,-1,-1,-1,-2,-1, -1,-1,-1,-1,-1,-1 ;
  vis = 10,10,10,10,5,10, 10,10,10,10,10,10 ;
  cbh = 300,300,300,300,200,300, 300,300,300,300,300,300 ;
  fog = 0,0,0,0,0.25,0, 0,0,0,0,0,0 ;
  deptho = 100, 200, 300, 400, 500, _ ;
  forecast_reference_time = 1777572000 ;
})";

/** Wind at two times, one of them at two heights, and temperature, as gdal_translate writes GRIB.
 */
const QString kBands = R"(netcdf bands {
dimensions: lat = 2 ; lon = 2 ;
variables:
  double lat(lat) ; lat:units = "degrees_north" ;
  double lon(lon) ; lon:units = "degrees_east" ;
  double Band1(lat, lon) ; Band1:long_name = "GDAL Band Number 1" ; Band1:GRIB_ELEMENT = "UGRD" ;
    Band1:GRIB_SHORT_NAME = "10-HTGL" ; Band1:GRIB_UNIT = "[m/s]" ;
    Band1:GRIB_REF_TIME = 1777615200 ; Band1:GRIB_VALID_TIME = 1777618800 ;
  double Band2(lat, lon) ; Band2:long_name = "GDAL Band Number 2" ; Band2:GRIB_ELEMENT = "VGRD" ;
    Band2:GRIB_SHORT_NAME = "10-HTGL" ; Band2:GRIB_UNIT = "[m/s]" ;
    Band2:GRIB_REF_TIME = "  1777615200 sec UTC" ; Band2:GRIB_VALID_TIME = "  1777618800 sec UTC" ;
  double Band3(lat, lon) ; Band3:long_name = "GDAL Band Number 3" ; Band3:GRIB_ELEMENT = "UGRD" ;
    Band3:GRIB_SHORT_NAME = "10-HTGL" ; Band3:GRIB_UNIT = "[m/s]" ;
    Band3:GRIB_REF_TIME = 1777615200 ; Band3:GRIB_VALID_TIME = 1777615200 ;
  double Band4(lat, lon) ; Band4:long_name = "GDAL Band Number 4" ; Band4:GRIB_ELEMENT = "VGRD" ;
    Band4:GRIB_SHORT_NAME = "10-HTGL" ; Band4:GRIB_UNIT = "[m/s]" ;
    Band4:GRIB_REF_TIME = 1777615200 ; Band4:GRIB_VALID_TIME = 1777615200 ;
  double Band5(lat, lon) ; Band5:long_name = "GDAL Band Number 5" ; Band5:GRIB_ELEMENT = "UGRD" ;
    Band5:GRIB_SHORT_NAME = "85000-ISBL" ; Band5:GRIB_UNIT = "[m/s]" ;
    Band5:GRIB_REF_TIME = 1777615200 ; Band5:GRIB_VALID_TIME = 1777615200 ;
  double Band6(lat, lon) ; Band6:long_name = "GDAL Band Number 6" ; Band6:GRIB_ELEMENT = "TMP" ;
    Band6:GRIB_SHORT_NAME = "2-HTGL" ; Band6:GRIB_UNIT = "[C]" ;
    Band6:GRIB_REF_TIME = 1777615200 ; Band6:GRIB_VALID_TIME = 1777615200 ;
data:
  lat = 60, 61 ; lon = -2, -1 ;
  Band1 = 5, 6, 7, 8 ; Band2 = -5, -6, -7, -8 ; Band3 = 1, 2, 3, 4 ; Band4 = -1, -2, -3, -4 ;
  Band5 = 50, 50, 50, 50 ; Band6 = -2, -2, -2, -2 ;
})";

/** A grid whose x axis points to `turn` (degrees from east), with along-grid winds and currents. */
QString turnedModel(const QString& extra = {}, const QString& data = {})
{
    // Around the equator a degree is a degree: the corners are those of a square turned by 30.
    return QString(R"(netcdf turned {
dimensions: time = 1 ; depth = 2 ; y = 2 ; x = 2 ;
variables:
  int time(time) ; time:units = "seconds since 1970-01-01 00:00:00 +00:00" ;
  double depth(depth) ; depth:units = "m" ; depth:positive = "down" ; depth:standard_name = "depth" ;
  double x(x) ; double y(y) ;
  double latitude(y, x) ; latitude:units = "degrees_north" ;
  double longitude(y, x) ; longitude:units = "degrees_east" ;
  float x_wind_10m(time, y, x) ; x_wind_10m:standard_name = "x_wind" ; x_wind_10m:units = "m/s" ;
    x_wind_10m:coordinates = "longitude latitude" ;
  float y_wind_10m(time, y, x) ; y_wind_10m:standard_name = "y_wind" ; y_wind_10m:units = "m/s" ;
    y_wind_10m:coordinates = "longitude latitude" ;
  float u(time, depth, y, x) ; u:standard_name = "x_sea_water_velocity" ; u:units = "m s-1" ;
    u:coordinates = "longitude latitude" ;
  float v(time, depth, y, x) ; v:standard_name = "y_sea_water_velocity" ; v:units = "m s-1" ;
    v:coordinates = "longitude latitude" ;
  %1
data:
  time = 1777593600 ; depth = 100, 3 ; x = 0, 1 ; y = 0, 1 ;
  latitude = 0, 0.05, 0.08660254, 0.13660254 ;
  longitude = 10, 10.08660254, 9.95, 10.03660254 ;
  x_wind_10m = 10, 10, 10, 10 ; y_wind_10m = 5, 5, 5, 5 ;
  u = 9, 9, 9, 9, 0.4, 0.4, 0.4, 0.4 ; v = 9, 9, 9, 9, 0, 0, 0, 0 ;
  %2
})")
        .arg(extra, data);
}

/** The value of the middle of the turned grid. */
ForecastEntry middleEntry(const ForecastReading& reading)
{
    return entryAt(reading.field, {0.0683, 10.018}, reading.field.places[0].series[0].time);
}

} // namespace

class TestImportNetcdf : public QObject
{
    Q_OBJECT

private slots:
    void packedValuesAreRead_data()
    {
        QTest::addColumn<QString>("kind");
        for (const char* const kind : {"classic", "64-bit offset", "64-bit data", "nc4", "nc7"})
            QTest::addRow("%s", kind) << QString(kind);
    }
    void packedValuesAreRead()
    {
        QFETCH(QString, kind);
        const std::string bytes = netcdfOf(kPacked, kind.toUtf8().constData());
        QVERIFY(!bytes.empty());
        QVERIFY(looksLikeForecast(bytes));
        const ForecastReading reading = readNetcdf(bytes);
        QCOMPARE(reading.format, std::string("NetCDF"));
        QCOMPARE(reading.thinning, 1U);
        const ForecastField& field = reading.field;
        QCOMPARE(field.columns, 2U);
        QCOMPARE(field.places.size(), 6U);
        const Forecast& southWest = field.places[0];
        QCOMPARE(southWest.source, std::string("Test model"));
        QCOMPARE(southWest.issued, parseUtc("2026-04-30T18:00:00Z"));
        QCOMPARE(southWest.place, (LatLon{60, -2}));
        QCOMPARE(southWest.depth_m, std::optional(500.0));
        QCOMPARE(southWest.series.size(), 2U);
        const ForecastEntry& entry = southWest.series[0];
        QCOMPARE(entry.time, *parseUtc("2026-05-01T00:00:00Z"));
        QCOMPARE(entry.wind_mps, std::optional(Point(4 * 0.5 + 10, 8 * 0.5)));
        COMPARE_NEAR(*entry.airTemperature_degC, 4, 1e-4); // of a float
        QCOMPARE(entry.dewPoint_degC, std::optional(-2.0));
        QCOMPARE(entry.visibility_m, std::optional(5000.0));
        QCOMPARE(entry.ceiling_m, std::optional(200.0));
        QCOMPARE(entry.fog_percent, std::optional(25.0));
        QVERIFY(!entry.gust_mps && !entry.current_mps);
        // Fill values are missing, as wind and as depth.
        QVERIFY(!field.places[1].series[0].wind_mps && !field.places[1].depth_m);
        QVERIFY(field.places[1].series[1].wind_mps);
        QCOMPARE(field.places[5].place, (LatLon{62, -1}));
    }

    void componentsAlongTheGridAreTurned()
    {
        const std::string bytes = netcdfOf(turnedModel());
        QVERIFY(!bytes.empty());
        const ForecastReading reading = readNetcdf(bytes);
        const ForecastEntry entry = middleEntry(reading);
        // x points 30 degrees left of east: 10 along x and 5 along y, turned.
        const double c = std::cos(std::numbers::pi / 6);
        const double s = 0.5;
        COMPARE_NEAR(entry.wind_mps->x(), 10 * c - 5 * s, 1e-3);
        COMPARE_NEAR(entry.wind_mps->y(), 10 * s + 5 * c, 1e-3);
        // The current is that at 3 m, not at 100 m.
        COMPARE_NEAR(entry.current_mps->x(), 0.4 * c, 1e-4);
        COMPARE_NEAR(entry.current_mps->y(), 0.4 * s, 1e-4);
    }

    void aFallingXTurnsTheAxisRound()
    {
        QString text = turnedModel();
        text.replace("x = 0, 1 ;", "x = 1, 0 ;");
        const ForecastEntry entry = middleEntry(readNetcdf(netcdfOf(text)));
        COMPARE_NEAR(entry.current_mps->x(), -0.4 * std::cos(std::numbers::pi / 6), 1e-4);
        COMPARE_NEAR(entry.current_mps->y(), -0.4 * 0.5, 1e-4);
    }

    void anAngleComesBeforeTheGeometry()
    {
        const std::string bytes = netcdfOf(turnedModel(
            "double angle(y, x) ; angle:units = \"radians\" ; angle:coordinates = \"longitude "
            "latitude\" ;",
            "angle = 1.5707963267948966, 1.5707963267948966, 1.5707963267948966, "
            "1.5707963267948966 ;"));
        const ForecastEntry entry = middleEntry(readNetcdf(bytes));
        COMPARE_NEAR(entry.wind_mps->x(), -5, 1e-5);
        COMPARE_NEAR(entry.wind_mps->y(), 10, 1e-5);
    }

    void areaAndTimeAreCut()
    {
        const std::string bytes = netcdfOf(kPacked);
        const ForecastReading part = readNetcdf(
            bytes,
            {.area = GeoBox{.south_deg = 60.2, .west_deg = -2, .north_deg = 60.4, .east_deg = -2},
             .since = parseUtc("2026-05-01T06:00:00Z")});
        QCOMPARE(part.field.places.size(), 2U);
        QCOMPARE(part.field.places[0].series.size(), 1U);
        const std::optional<Error> late =
            errorOf([&] { (void)readNetcdf(bytes, {.since = parseUtc("2026-05-02T00:00:00Z")}); });
        QVERIFY(late);
        QCOMPARE(std::string(late->what()),
                 kNetcdf + ": time: the forecast is for another time, from 2026-05-01T00:00:00Z to "
                           "2026-05-01T06:00:00Z");
        const std::optional<Error> far = errorOf([&] {
            (void)readNetcdf(
                bytes,
                {.area = GeoBox{.south_deg = 0, .west_deg = 0, .north_deg = 1, .east_deg = 1}});
        });
        QVERIFY(far);
        QCOMPARE(std::string(far->what()),
                 kNetcdf + ": latitude: the forecast has no values in the area");
        QCOMPARE(readNetcdf(bytes, {.mostEntries = 8}).thinning, 2U);
    }

    void faultsNameTheVariable_data()
    {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("message");
        QTest::addRow("unit") << "u:units = \"m s-1\""
                              << "u:units = \"furlongs\""
                              << "u: the unit \"furlongs\" is not understood";
        QTest::addRow("range") << "scale_factor = 0.5 ; u:add"
                               << "scale_factor = 500. ; u:add"
                               << "u: must be from -150 to 150, not";
        QTest::addRow("scale") << "scale_factor = 0.5 ; u:add"
                               << "scale_factor = NaN ; u:add"
                               << "u:scale_factor: must be a finite number";
        QTest::addRow("calendar") << "\"standard\""
                                  << "\"360_day\""
                                  << "time: the unit of time";
        QTest::addRow("unit of time") << "hours since 2026"
                                      << "fortnights since 2026"
                                      << "time: the unit of time";
        QTest::addRow("times") << "time = 0, 6"
                               << "time = 6, 0"
                               << "time: must rise from entry to entry";
        QTest::addRow("time") << "time = 0, 6"
                              << "time = 0, NaN"
                              << "time: must be a UTC date";
        QTest::addRow("places") << "lat = 62, 61, 60"
                                << "lat = NaN, NaN, NaN"
                                << "the forecast has no values in the area";
    }
    void faultsNameTheVariable()
    {
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(QString, message);
        QString text = kPacked;
        QVERIFY(text.contains(from));
        const std::string bytes = netcdfOf(text.replace(from, to));
        QVERIFY(!bytes.empty());
        const std::optional<Error> error = errorOf([&] { (void)readNetcdf(bytes); });
        QVERIFY(error);
        QVERIFY2(QString(error->what()).startsWith(QString::fromStdString(kNetcdf) + ": ") &&
                     QString(error->what()).contains(message),
                 error->what());
    }

    void bandsOfGribAreRead()
    {
        const ForecastReading reading = readNetcdf(netcdfOf(kBands));
        QCOMPARE(reading.field.places.size(), std::size_t{4});
        const Forecast& last = reading.field.places[3];
        QCOMPARE(last.issued, parseUtc("2026-05-01T06:00:00Z"));
        QCOMPARE(last.series.size(), std::size_t{2});
        QCOMPARE(last.series[0].time, *parseUtc("2026-05-01T06:00:00Z"));
        QCOMPARE(*last.series[0].wind_mps, Point(4, -4));
        QCOMPARE(*last.series[0].airTemperature_degC, -2.0);
        QCOMPARE(last.series[1].time, *parseUtc("2026-05-01T07:00:00Z"));
        QCOMPARE(*last.series[1].wind_mps, Point(8, -8));
        QVERIFY(!last.series[1].airTemperature_degC);
    }

    /** A band that does not tell its quantity, level or time. */
    void incompleteBandsAreRejected()
    {
        for (const char* const attribute : {"GRIB_ELEMENT", "GRIB_SHORT_NAME", "GRIB_VALID_TIME"}) {
            QString text = kBands;
            const std::string bytes =
                netcdfOf(text.replace(QString("Band2:%1").arg(attribute), "Band2:OTHER"));
            const auto error = errorOf([&] { static_cast<void>(readNetcdf(bytes)); });
            QVERIFY(error);
            QVERIFY2(QString(error->what()).contains(QString("Band2:%1").arg(attribute)),
                     error->what());
        }
    }

    void filesWithoutAForecastAreRejected()
    {
        const std::string text =
            netcdfOf("netcdf x { dimensions: n = 2 ; variables: char t(n) ; data: t = \"ab\" ; }");
        const std::optional<Error> none = errorOf([&] { (void)readNetcdf(text); });
        QVERIFY(none);
        QCOMPARE(none->issues()[0].reason.id, IssueId::NoQuantity);
        // Text where numbers are wanted is no wind.
        const std::string words = netcdfOf(
            "netcdf x { dimensions: lat = 1 ; lon = 1 ; n = 2 ; variables: float lat(lat) ; float "
            "lon(lon) ; char u10(lat, lon, n) ; data: lat = 1 ; lon = 1 ; u10 = \"ab\" ; }");
        QVERIFY(errorOf([&] { (void)readNetcdf(words); }));
        // Dimensions that multiply beyond memory: nothing was ever written.
        const std::string huge = netcdfOf(
            "netcdf x { dimensions: time = 1 ; lat = 40000 ; lon = 40000 ; variables: double "
            "time(time) ; time:units = \"hours since 2026-05-01\" ; float lat(lat, lon) ; "
            "lat:units = \"degrees_north\" ; float lon(lat, lon) ; lon:units = \"degrees_east\" ; "
            "float u10(time, lat, lon) ; u10:coordinates = \"lon lat\" ; data: time = 0 ; }",
            "nc4");
        QVERIFY(!huge.empty());
        const std::optional<Error> large = errorOf([&] { (void)readNetcdf(huge); });
        QVERIFY(large);
        QCOMPARE(large->code(), ErrorCode::FileTooLarge);
        QVERIFY2(QString(large->what()).contains("made.nc: lat: "), large->what());
    }

    void truncatedFilesAreRejected()
    {
        for (const char* const kind : {"classic", "nc4"}) {
            const std::string bytes = netcdfOf(kPacked, kind);
            for (const std::size_t size : {bytes.size() / 2, bytes.size() / 4, std::size_t{20}}) {
                const std::string part = bytes.substr(0, size);
                const std::optional<Error> error = errorOf([&] { (void)readNetcdf(part); });
                QVERIFY2(error, qPrintable(QString("%1 %2").arg(kind).arg(size)));
            }
        }
    }

    void aStopEndsReading()
    {
        std::stop_source source;
        source.request_stop();
        const std::string bytes = netcdfOf(kPacked);
        QVERIFY_EXCEPTION_THROWN(
            (void)forecastFromBytes(bytes, kNetcdf, {}, {}, source.get_token()), Stopped);
        // While it is read, at the first progress.
        std::stop_source later;
        QVERIFY_EXCEPTION_THROWN(
            (void)forecastFromBytes(
                bytes, kNetcdf, {}, [&](double) { later.request_stop(); }, later.get_token()),
            Stopped);
    }

    void mutantsAreRejectedOrSound()
    {
        for (const char* const kind : {"classic", "nc4"}) {
            const std::string bytes = netcdfOf(kPacked, kind);
            const std::vector<std::string> corpus{bytes};
            fuzz::Mutator mutator(1, corpus);
            for (int i = 0; i < 60; ++i) {
                const std::string mutant = mutator.mutated(bytes);
                try {
                    QVERIFY(isGrid(readNetcdf(mutant).field));
                } catch (const Error& error) {
                    QVERIFY(!error.issues().empty());
                }
            }
        }
    }
};

QTEST_APPLESS_MAIN(TestImportNetcdf)
#include "tst_import_netcdf.moc"
