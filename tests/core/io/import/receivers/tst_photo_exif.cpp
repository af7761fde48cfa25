// The photographs of tests/data/import were made by ImageMagick, their EXIF data by exiftool.

#include "core/base/random.h"
#include "core/io/import/receivers/photo_exif.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/import_fixtures.h"

#include <QTest>

using namespace berg;
using namespace berg::test;

class TestPhotoExif : public QObject
{
    Q_OBJECT

private slots:
    /** Without the library every photograph is refused, with the reason. */
    void initTestCase()
    {
        if (readsPhotos())
            return;
        const auto error = errorOf([] { (void)readFixture("photo-gps.jpg"); });
        QVERIFY(error && error->code() == ErrorCode::Unsupported);
        QVERIFY(error->issues().front().reason.id == IssueId::PhotoNoReader);
        QSKIP("this build has no libexiv2: reading photographs was not tested");
    }

    void positionAndDirection()
    {
        const PhotoData photo = photoData(importFixture("photo-gps.jpg"), "photo");
        COMPARE_NEAR(photo.place->latitude_deg, 47.0125, 1e-7);
        COMPARE_NEAR(photo.place->longitude_deg, -47.98, 1e-7);
        COMPARE_NEAR(*photo.altitude_m, 121.5, 1e-6);
        COMPARE_NEAR(*photo.direction_deg, 271.5, 1e-6);
        QCOMPARE(utcText(*photo.time, 0), std::string("2026-05-02T00:01:30Z")); // not the clock's
    }

    void cameraClockWithItsOffset()
    {
        const PhotoData photo = photoData(importFixture("photo-time.jpg"), "photo");
        QVERIFY(!photo.place && !photo.direction_deg && !photo.altitude_m);
        QCOMPARE(utcText(*photo.time, 0), std::string("2026-05-02T00:01:30Z"));
    }

    void photographWithoutData()
    {
        const PhotoData photo = photoData(importFixture("photo-plain.jpg"), "photo");
        QVERIFY(!photo.place && !photo.time);
    }

    void oneIsASighting()
    {
        const SightingTable table = readFixture("photo-gps.jpg");
        QCOMPARE(table.format, std::string("photo"));
        QCOMPARE(table.sightings.size(), std::size_t{1});
        QCOMPARE(timeOf(table.sightings[0]), std::string("2026-05-02T00:01:30Z"));
        QCOMPARE(table.positionSd_m, errorOf(SightingSource::Camera).sd_m);
        QCOMPARE(importedAsNew(importFixture("photo-gps.jpg")).added, std::size_t{1});
        const auto error = errorOf([] { (void)readFixture("photo-plain.jpg"); });
        QVERIFY(error && error->code() == ErrorCode::InvalidInput);
        QVERIFY(error->issues().front().reason.id == IssueId::PhotoNoPlace);
        const auto other = errorOf([] {
            (void)readText(importFixture("photo-gps.jpg"), {.format = "kml", .mapping = {}});
        });
        QVERIFY(other && other->code() == ErrorCode::WrongFormat);
    }

    /** A damaged file is read or refused; places are on Earth. */
    void damagedFiles()
    {
        const std::string whole = importFixture("photo-gps.jpg");
        Random random(5);
        int refused = 0;
        for (int i = 0; i < 3000; ++i) {
            std::string bytes =
                whole.substr(0, i % 3 == 0 ? random.below(whole.size()) + 1 : whole.size());
            for (int k = 0; k < i % 40; ++k)
                bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
            try {
                const PhotoData photo = photoData(bytes, "photo");
                if (photo.place)
                    QVERIFY(std::abs(photo.place->latitude_deg) <= 90 &&
                            std::abs(photo.place->longitude_deg) <= 180);
            } catch (const Error& error) {
                QVERIFY(error.code() == ErrorCode::InvalidInput);
                ++refused;
            }
        }
        QVERIFY(refused > 100);
    }
};

QTEST_APPLESS_MAIN(TestPhotoExif)
#include "tst_photo_exif.moc"
