#include "core/io/import/import_forecast_file.h"
#include "core/io/text/atomic_file.h"
#include "core/scenario/utc_time.h"
#include "tests/support/approx.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

using namespace berg;

namespace {

/** Winds at 10 m on a grid of three by three places at three hours, for ncgen. */
const char* const kToolWinds = R"(netcdf winds {
dimensions: time = 3 ; height = 1 ; lat = 3 ; lon = 3 ;
variables:
  double time(time) ; time:standard_name = "time" ;
    time:units = "hours since 2026-05-01 06:00:00" ; time:calendar = "standard" ;
  float height(height) ; height:units = "m" ; height:standard_name = "height" ;
    height:positive = "up" ; height:axis = "Z" ;
  double lat(lat) ; lat:units = "degrees_north" ; lat:standard_name = "latitude" ;
  double lon(lon) ; lon:units = "degrees_east" ; lon:standard_name = "longitude" ;
  float u(time, height, lat, lon) ; u:standard_name = "eastward_wind" ; u:units = "m s-1" ;
    u:param = "2.2.0" ;
  float v(time, height, lat, lon) ; v:standard_name = "northward_wind" ; v:units = "m s-1" ;
    v:param = "3.2.0" ;
data:
  time = 0, 1, 2 ; height = 10 ; lat = 60, 61, 62 ; lon = -2, -1, 0 ;
  u = 1,2,3,4,5,6,7,8,9, 2,3,4,5,6,7,8,9,10, 3,4,5,6,7,8,9,10,11 ;
  v = -1,-2,-3,-4,-5,-6,-7,-8,-9, -2,-3,-4,-5,-6,-7,-8,-9,-10, -3,-4,-5,-6,-7,-8,-9,-10,-11 ;
})";

} // namespace

/** Forecasts as they leave the programs of others: gdal_translate, gdalmdimtranslate and cdo. */
class TestImportForecastTools : public QObject
{
    Q_OBJECT

private slots:
    void convertedFilesAreRead_data()
    {
        QTest::addColumn<QStringList>("steps");
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("format");
        const QString gdalParts = "gdal_translate -q -of netCDF NETCDF:winds.nc:%1 %1.nc";
        const QString grib = "cdo -O -s -f grb2 copy winds.nc winds.grib";
        QTest::newRow("cdo, netCDF 4")
            << QStringList{"cdo -O -s -f nc4 copy winds.nc out.nc"} << "out.nc"
            << "NetCDF";
        QTest::newRow("cdo mergetime") << QStringList{"cdo -O -s seltimestep,1 winds.nc first.nc",
                                                      "cdo -O -s seltimestep,2/3 winds.nc rest.nc",
                                                      "cdo -O -s mergetime rest.nc first.nc out.nc"}
                                       << "out.nc"
                                       << "NetCDF";
        QTest::newRow("gdal_translate, one file for each variable")
            << QStringList{gdalParts.arg("u"), gdalParts.arg("v"),
                           "cdo -O -s merge u.nc v.nc out.nc"}
            << "out.nc"
            << "NetCDF";
        QTest::newRow("gdalmdimtranslate")
            << QStringList{"gdalmdimtranslate -q -of netCDF winds.nc out.nc"} << "out.nc"
            << "NetCDF";
#ifdef BERG_GRIB_FILTER
        QTest::newRow("cdo, GRIB 2") << QStringList{grib} << "winds.grib"
                                     << "GRIB";
        QTest::newRow("gdal_translate, GRIB 2")
            << QStringList{grib, "gdal_translate -q -of GRIB winds.grib out.grib"} << "out.grib"
            << "GRIB";
        QTest::newRow("gdal_translate, GRIB 2 to netCDF")
            << QStringList{grib, "gdal_translate -q -of netCDF winds.grib out.nc"} << "out.nc"
            << "NetCDF";
#endif
    }

    void convertedFilesAreRead()
    {
        QFETCH(QStringList, steps);
        QFETCH(QString, file);
        QFETCH(QString, format);
        const QTemporaryDir folder;
        QFile description(folder.filePath("winds.cdl"));
        QVERIFY(description.open(QIODevice::WriteOnly));
        description.write(kToolWinds);
        description.close();
        steps.prepend(QString(BERG_NCGEN) + " -k classic -o winds.nc winds.cdl");
        for (const QString& step : std::as_const(steps)) {
            QStringList words = step.split(' ');
            QProcess process;
            process.setWorkingDirectory(folder.path());
            process.start(words.takeFirst(), words);
            QVERIFY2(process.waitForFinished() && process.exitCode() == 0,
                     process.readAllStandardError().constData());
        }
        const ForecastReading reading = loadForecastFile(folder.filePath(file).toStdString());
        QCOMPARE(QString::fromStdString(reading.format), format);
        QCOMPARE(reading.field.columns, std::size_t{3});
        QCOMPARE(reading.field.places.size(), std::size_t{9});
        for (std::size_t i = 0; i < 9; ++i) {
            const Forecast& place = reading.field.places[i];
            COMPARE_NEAR(place.place.latitude_deg, 60.0 + double(i / 3), 1e-6);
            COMPARE_NEAR(place.place.longitude_deg, -2.0 + double(i % 3), 1e-6);
            QCOMPARE(place.series.size(), std::size_t{3});
            for (std::size_t hour = 0; hour < 3; ++hour) {
                const ForecastEntry& entry = place.series[hour];
                QCOMPARE(entry.time, *parseUtc("2026-05-01T06:00:00Z") + std::chrono::hours(hour));
                QVERIFY(entry.wind_mps);
                // GRIB packs values in 16 bits.
                COMPARE_NEAR(entry.wind_mps->x(), double(i + hour + 1), 1e-3);
                COMPARE_NEAR(entry.wind_mps->y(), -double(i + hour + 1), 1e-3);
            }
        }
    }
};

QTEST_APPLESS_MAIN(TestImportForecastTools)
#include "tst_import_forecast_tools.moc"
