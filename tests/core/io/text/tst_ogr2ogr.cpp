#include "core/base/stopped.h"
#include "core/io/import/import_file.h"
#include "core/io/import/import_formats.h"
#include "core/io/import/maps/import_ice_chart.h"
#include "core/io/text/ogr2ogr.h"
#include "core/io/text/stop_scope.h"
#include "core/io/text/zip_file.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/export_fixtures.h"

#include <QtTest>

#include <thread>

using namespace berg;
using namespace berg::test;

namespace {

const std::string kPlaces = R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"id":"a","time":"2021-01-18T18:00:00Z"},"geometry":{"type":"Point","coordinates":[-48.25,47.5]}},
{"type":"Feature","properties":{"id":"b","time":"2021-01-18T19:00:00Z"},"geometry":{"type":"Point","coordinates":[-48.5,47.25]}}]})";

bool hasOgr2ogr()
{
    return !ogr2ogrPath().empty();
}

/** A folder with files, and with a program ogr2ogr that the path names first. */
class GisFolder
{
public:
    GisFolder() : m_path(qgetenv("PATH")) {}
    GisFolder(const GisFolder&) = delete;
    GisFolder& operator=(const GisFolder&) = delete;
    ~GisFolder() { qputenv("PATH", m_path); }

    [[nodiscard]] std::string file(const std::string& name) const
    {
        return m_dir.filePath(QString::fromStdString(name)).toStdString();
    }
    std::string write(const std::string& name, const std::string& content) const
    {
        QFile out(QString::fromStdString(file(name)));
        if (!out.open(QIODevice::WriteOnly))
            qFatal("cannot write");
        out.write(content.data(), qint64(content.size()));
        return file(name);
    }
    /** Makes a file of the places with ogr2ogr. */
    std::string make(const std::string& name, const QStringList& options,
                     const std::string& geoJson = kPlaces) const
    {
        const std::string input = write("given.geojson", geoJson);
        QProcess process;
        process.start("ogr2ogr", options + QStringList{QString::fromStdString(file(name)),
                                                       QString::fromStdString(input)});
        process.waitForFinished();
        if (process.exitCode() != 0)
            qWarning() << process.readAllStandardError();
        return file(name);
    }
    /** Replaces ogr2ogr by a script. */
    void fake(const std::string& script) const
    {
        QDir(m_dir.path()).mkpath("bin");
        const std::string program = write("bin/ogr2ogr", "#!/bin/sh\n" + script + "\n");
        QFile::setPermissions(QString::fromStdString(program),
                              QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        qputenv("PATH", m_dir.filePath("bin").toUtf8() + ":/usr/bin:/bin");
    }
    void forget() const { qputenv("PATH", m_dir.path().toUtf8()); }

private:
    QByteArray m_path;
    QTemporaryDir m_dir;
};

SightingTable sightingsIn(const std::string& path)
{
    return readSightings(readImportFile(path, path), path);
}

std::string messageOf(const std::string& path, const ChildLimits& limits = {})
{
    const auto error = errorOf([&] { (void)geoJsonOfGisFile(path, "file", {}, limits); });
    return error ? codeName(error->code()) + ": " + englishText(error->issues().front().reason)
                 : "";
}

/** Names of files that were left in the folder for temporary files. */
QStringList leftovers()
{
    return QDir::temp().entryList({"bergwatch-gis-*"}, QDir::Dirs);
}

} // namespace

/** Tests of GIS files, read and written through ogr2ogr, and of what it may do to us. */
class TestOgr2ogr : public QObject
{
    Q_OBJECT

private slots:
    /** Other tests that run ogr2ogr at the same time have other folders. */
    void initTestCase()
    {
        QVERIFY(m_temporary.isValid());
        QVERIFY(qputenv("TMPDIR", QFile::encodeName(m_temporary.path())));
    }
    void cleanup() { QCOMPARE(leftovers(), QStringList()); }

    void filesOfOthersAreRead_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QStringList>("options");
        const auto row = [](const char* name, const QStringList& options) {
            QTest::newRow(name) << name << options;
        };
        row("places.shp", {"-f", "ESRI Shapefile"});
        row("polar.shp", {"-f", "ESRI Shapefile", "-t_srs", "EPSG:3413"});
        row("places.gpkg", {"-f", "GPKG"});
        row("utm.gpkg", {"-f", "GPKG", "-t_srs", "EPSG:32622"});
        row("places.gml", {"-f", "GML"});
        row("places.fgb", {"-f", "FlatGeobuf"});
        row("places.tab", {"-f", "MapInfo File"});
        row("places.mif", {"-f", "MapInfo File"});
        row("places.shp.zip", {"-f", "ESRI Shapefile"});
        row("-a 'b\" $(c).shp", {"-f", "ESRI Shapefile"});
        row("PG:dbname=x.gpkg", {"-f", "GPKG"});
        row("without ending", {"-f", "GPKG"});
    }

    void filesOfOthersAreRead()
    {
        if (!hasOgr2ogr())
            QSKIP("ogr2ogr is not installed");
        QFETCH(QString, name);
        QFETCH(QStringList, options);
        const GisFolder folder;
        const SightingTable table = sightingsIn(folder.make(name.toStdString(), options));
        QCOMPARE(table.format, std::string("geojson"));
        QCOMPARE(table.sightings.size(), 2U);
        const Sighting& first = table.sightings.front();
        QCOMPARE(first.id, std::string("a"));
        QVERIFY(std::abs(first.place.latitude_deg - 47.5) < 1e-6);
        QVERIFY(std::abs(first.place.longitude_deg + 48.25) < 1e-6);
        QVERIFY(first.time.has_value());
    }

    void layersAreReadTogether()
    {
        if (!hasOgr2ogr())
            QSKIP("ogr2ogr is not installed");
        const GisFolder folder;
        folder.make("two.gpkg", {"-f", "GPKG"});
        folder.make("two.gpkg", {"-f", "GPKG", "-update", "-nln", "second"});
        QCOMPARE(sightingsIn(folder.file("two.gpkg")).sightings.size(), 4U);
    }

    void ownFormatsComeFirst()
    {
        const GisFolder folder;
        folder.fake("exit 1");
        QCOMPARE(sightingsIn(folder.write("table.dxf", "id,lat,lon\na,47,-48\nb,47.1,-48\n"))
                     .sightings.size(),
                 2U);
        const std::string kml = "<kml><Placemark><name>a</name><Point><coordinates>-48,47"
                                "</coordinates></Point></Placemark></kml>";
        QCOMPARE(sightingsIn(folder.write("places.zip", zipOf({{"a.kml", kml}}))).sightings.size(),
                 1U);
    }

    void missingProgramIsNamed()
    {
        const GisFolder folder;
        const std::string path = folder.write("a.gpkg", "x");
        folder.forget();
        QCOMPARE(messageOf(path),
                 std::string("Unsupported: is read with ogr2ogr: install gdal-bin"));
        const auto error =
            errorOf([] { (void)gisFileOfGeoJson(kPlaces, GisFormat::GeoPackage, 4326, "format"); });
        QVERIFY(error.has_value());
        QCOMPARE(englishText(error->issues().front().reason),
                 std::string("is written with ogr2ogr: install gdal-bin"));
    }

    void programsThatMisbehaveAreErrors_data()
    {
        QTest::addColumn<QString>("script");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* name, const char* script, const char* message) {
            QTest::newRow(name) << script << message;
        };
        row("hangs", "sleep 1000", "WrongFormat: ogr2ogr was stopped after 1 s");
        row("hangs after output", "echo '{}'; exec sleep 1000",
            "WrongFormat: ogr2ogr was stopped after 1 s");
        row("endless output", "yes '{\"type\": \"Feature\"}'",
            "FileTooLarge: is larger than 1 MiB; BERGWATCH_READ_LIMITS=2 in the environment "
            "doubles the "
            "limits of reading");
        row("crashes", "kill -SEGV $$", "WrongFormat: ogr2ogr failed without a reason (signal 11)");
        row("exits", "exit 5", "WrongFormat: ogr2ogr failed without a reason (exit 5)");
        row("says why", "echo 'Warning 1: no'; echo ERROR 1: broken >&2; echo FAILURE: >&2; exit 1",
            "WrongFormat: ogr2ogr reports: ERROR 1: broken");
        row("names our folder", "echo \"ERROR 4: $PWD/input.gpkg is bad\" >&2; exit 1",
            "WrongFormat: ogr2ogr reports: ERROR 4: input.gpkg is bad");
        row("errors but success", "echo '{}'; echo ERROR 1: half >&2",
            "WrongFormat: ogr2ogr reports: ERROR 1: half");
        row("garbage", "head -c 5000 /dev/urandom; echo; echo hello",
            "WrongFormat: ogr2ogr did not print GeoJSON");
        row("nothing", "true", "InvalidInput: holds no features");
        row("garbled reason", "printf 'ERROR \\377\\376' >&2; exit 1",
            "WrongFormat: ogr2ogr failed without a reason (exit 1)");
    }

    void programsThatMisbehaveAreErrors()
    {
        QFETCH(QString, script);
        QFETCH(QString, message);
        const GisFolder folder;
        folder.fake(script.toStdString());
        const ChildLimits limits{.wall = std::chrono::seconds(1), .output = 1U << 20U};
        QCOMPARE(QString::fromStdString(messageOf(folder.write("a.gpkg", "x"), limits)), message);
    }

    void programSeesNeitherNamesNorSecrets()
    {
        const GisFolder folder;
        folder.fake("echo \"ERROR $# $* $SECRET $OGR_SKIP\" >&2; exit 1");
        qputenv("SECRET", "secret");
        const QString text = QString::fromStdString(messageOf(folder.write("PG:a.gpkg", "x")));
        qunsetenv("SECRET");
        QVERIFY2(text.contains("input.gpkg") && text.contains("OGR_VRT") && !text.contains("PG:") &&
                     !text.contains("secret"),
                 qPrintable(text));
    }

    void stopCancels()
    {
        const GisFolder folder;
        folder.fake("sleep 1000");
        const std::string path = folder.write("a.gpkg", "x");
        std::stop_source stop;
        std::jthread later([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            stop.request_stop();
        });
        QVERIFY_THROWS_EXCEPTION(Stopped, (void)readImportFile(path, path, stop.get_token()));
    }

    /** Writers of exports take no token: the scope of the thread has it. */
    void stopCancelsExports_data()
    {
        QTest::addColumn<QString>("id");
        for (const char* const id : {"shapefile", "gpkg"})
            QTest::newRow(id) << id;
    }
    void stopCancelsExports()
    {
        QFETCH(QString, id);
        const ExportFormat* format = findExportFormat(id.toStdString());
        QVERIFY(format != nullptr && format->holds.gis);
        const Scenario scenario = fourIcebergs();
        const ExportSource source{.scenario = scenario, .plan = planFromStart(scenario)};
        const GisFolder folder;
        folder.fake("sleep 1000");
        std::stop_source stop;
        const StopScope scope(stop.get_token());
        std::jthread later([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            stop.request_stop();
        });
        QVERIFY_THROWS_EXCEPTION(Stopped, (void)format->write(source));
    }

    /** A scope within another has its own stop, and gives the other back. */
    void stopScopesNest()
    {
        std::stop_source outer;
        {
            const StopScope first(outer.get_token());
            outer.request_stop();
            QVERIFY(StopScope::current().stop_requested());
            {
                const StopScope second{std::stop_token()};
                QVERIFY(!StopScope::current().stop_requested());
            }
            QVERIFY(StopScope::current().stop_requested());
        }
        QVERIFY(!StopScope::current().stop_requested());
    }

    void damagedFilesAreErrors_data()
    {
        QTest::addColumn<int>("size");
        for (const int size : {0, 50, 100, 110, 150})
            QTest::addRow("%d", size) << size;
    }

    void damagedFilesAreErrors()
    {
        if (!hasOgr2ogr())
            QSKIP("ogr2ogr is not installed");
        QFETCH(int, size);
        const GisFolder folder;
        const std::string path = folder.make("broken.shp", {"-f", "ESRI Shapefile"});
        QVERIFY(QFile::resize(QString::fromStdString(path), size));
        QVERIFY(!messageOf(path).empty());
    }

    /** A file that names others is not followed, whatever its own name. */
    void namesInFilesAreNotFollowed()
    {
        if (!hasOgr2ogr())
            QSKIP("ogr2ogr is not installed");
        const GisFolder folder;
        const std::string other = folder.write("other.geojson", kPlaces);
        const std::string path =
            folder.write("a.gml", "<OGRVRTDataSource><OGRVRTLayer name=\"other\"><SrcDataSource>" +
                                      other + "</SrcDataSource></OGRVRTLayer></OGRVRTDataSource>");
        QVERIFY(messageOf(path).starts_with("WrongFormat: "));
    }

    void archivesWithSeveralFilesAreErrors()
    {
        const GisFolder folder;
        folder.fake("exit 1");
        const std::string path =
            folder.write("several.zip", zipOf({{"a.gpkg", "x"}, {"b/b.gml", "y"}}));
        QCOMPARE(messageOf(path),
                 std::string("InvalidInput: the archive holds several files that ogr2ogr can read: "
                             "a.gpkg, b/b.gml; unpack the one that you need"));
        QVERIFY(messageOf(folder.write("none.zip", zipOf({{"a.txt", "x"}})))
                    .starts_with("WrongFormat: "));
    }

    void nothingIsWrittenBesideTheFile()
    {
        if (!hasOgr2ogr())
            QSKIP("ogr2ogr is not installed");
        const GisFolder folder;
        const std::string path = folder.make("a.gml", {"-f", "GML", "-dsco", "XSISCHEMA=OFF"});
        const QDir dir(QString::fromStdString(folder.file("")));
        const QStringList before = dir.entryList();
        (void)sightingsIn(path);
        QCOMPARE(dir.entryList(), before);
    }

    /** Other programs read what we export, and so do we. */
    void exportsAreRead_data()
    {
        QTest::addColumn<QString>("id");
        for (const char* id : {"shapefile", "gpkg", "gml", "dxf", "fgb"})
            QTest::newRow(id) << id;
    }

    void exportsAreRead()
    {
        if (!hasOgr2ogr())
            QSKIP("ogr2ogr is not installed");
        QFETCH(QString, id);
        const GisFolder folder;
        const ExportFormat& row = *findExportFormat(id.toStdString());
        const std::string bytes = row.text(planContent(fourIcebergs()));
        QVERIFY(bytes == row.text(planContent(fourIcebergs()))); // no dates of today
        const std::string path = folder.write("export." + std::string(row.extension), bytes);
        QProcess info;
        info.start(
            "ogrinfo",
            {"-ro", "-al", (id == "shapefile" ? "/vsizip/" : "") + QString::fromStdString(path)});
        info.waitForFinished();
        const QString text = QString::fromUtf8(info.readAllStandardOutput());
        QVERIFY2(text.contains(id == "dxf" ? "iceberg" : "kind (String) = iceberg"),
                 qPrintable(text + info.readAllStandardError()));
        if (id == "dxf") // a drawing has no icebergs
            return;
        const SightingTable table = sightingsIn(path);
        QCOMPARE(table.sightings.size(), fourIcebergs().icebergs.size());
    }

    void failedExportsLeaveNothing()
    {
        const GisFolder folder;
        folder.fake("echo ERROR 1: disk full >&2; exit 1");
        const auto error =
            errorOf([] { (void)findExportFormat("gpkg")->text(planContent(fourIcebergs())); });
        QVERIFY(error.has_value());
        QCOMPARE(codeName(error->code()), std::string("FileUnwritable"));
        QCOMPARE(englishText(error->issues().front().reason),
                 std::string("ogr2ogr reports: ERROR 1: disk full"));
    }

private:
    QTemporaryDir m_temporary;
};

QTEST_GUILESS_MAIN(TestOgr2ogr)
#include "tst_ogr2ogr.moc"
