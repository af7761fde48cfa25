#include "core/io/import/fields/import_source.h"
#include "core/io/import/import_tracks.h"
#include "core/io/text/atomic_file.h"
#include "tests/support/expect_error.h"

#include <QTemporaryDir>
#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

/** Writes the text to a file and returns its tracks. */
std::vector<PlacedTrack> tracksIn(const std::string& text)
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("sightings.csv").toStdString();
    writeFileAtomically(path, text);
    return loadTracks(path);
}

} // namespace

class TestImportTracks : public QObject
{
    Q_OBJECT

private slots:
    void eachIcebergHasItsTrack()
    {
        const std::vector<PlacedTrack> tracks =
            tracksIn("iceberg id,time,latitude,longitude\n"
                     "a,2026-05-01T12:00:00Z,64,-59\nb,2026-05-01T12:00:00Z,66,-59\n"
                     "a,2026-05-01T11:00:00Z,64.01,-59\nb,2026-05-01T13:00:00Z,66.01,-59\n");
        QCOMPARE(tracks.size(), 2U);
        QCOMPARE(tracks[0].size(), 2U);
        QCOMPARE(tracks[0][0].place, (LatLon{64.01, -59})); // times rise
        QCOMPARE(tracks[0][1].time_s - tracks[0][0].time_s, 3600.0);
        QCOMPARE(tracks[0][1].time_s, 1777636800.0); // 2026-05-01T12:00:00Z
        QCOMPARE(tracks[1][1].place, (LatLon{66.01, -59}));
    }

    void rowsWithoutIdsAreOneIceberg()
    {
        const std::vector<PlacedTrack> tracks = tracksIn(
            "time,latitude,longitude\n2026-05-01T12:00:00Z,64,-59\n2026-05-01T13:00:00Z,64.01,-59\n"
            "2026-05-01T14:00:00Z,64.02,-59\n");
        QCOMPARE(tracks.size(), 1U);
        QCOMPARE(tracks[0].size(), 3U);
    }

    void impossiblePositionsAreLeftOut()
    {
        const std::vector<PlacedTrack> tracks = tracksIn(
            "time,latitude,longitude\n2026-05-01T12:00:00Z,64,-59\n2026-05-01T13:00:00Z,65,-59\n"
            "2026-05-01T14:00:00Z,64.02,-59\n2026-05-01T15:00:00Z,64.03,-59\n");
        QCOMPARE(tracks.size(), 1U);
        QCOMPARE(tracks[0].size(), 3U); // a degree in an hour is 31 m/s
    }

    void timesAreNeeded()
    {
        const std::optional<Error> error =
            errorOf([] { (void)tracksIn("latitude,longitude\n64,-59\n"); });
        QVERIFY(error && error->code() == ErrorCode::InvalidInput);
        QVERIFY(std::string(error->what()).ends_with("sightings.csv: time: is missing"));
        QCOMPARE(codeOf([] { (void)loadTracks("missing.csv"); }), std::string("FileNotFound"));
    }
};

QTEST_APPLESS_MAIN(TestImportTracks)
#include "tst_import_tracks.moc"
