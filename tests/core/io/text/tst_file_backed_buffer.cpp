#include "core/base/random.h"
#include "core/io/export/content/track_points.h"
#include "core/io/text/file_backed_buffer.h"
#include "core/io/text/zip_file.h"
#include "tests/support/expect_error.h"

#include <QScopeGuard>
#include <QTest>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <sys/resource.h>

using namespace berg;
using namespace berg::test;

namespace {

std::string allOf(const FileBackedBuffer& buffer)
{
    std::string bytes;
    buffer.putAll([&bytes](std::string_view piece) { bytes += piece; });
    return bytes;
}

std::string someBytes(Random& random, std::size_t most)
{
    std::string bytes(random.below(most + 1), '\0');
    std::ranges::generate(bytes, [&random] { return static_cast<char>(random.below(256)); });
    return bytes;
}

} // namespace

class TestSpool : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    /** Compares the buffer with a string as long as several pieces. */
    void bufferEqualsAString()
    {
        Random random(7);
        FileBackedBuffer buffer;
        std::string expected;
        for (int i = 0; i < 400; ++i) {
            const std::string bytes = someBytes(random, i % 7 == 0 ? 90'000 : 1'000);
            const std::size_t at = std::size_t{random.below(expected.size() + 1)};
            if (i == 250) {
                buffer.clear();
                expected.clear();
            } else if (i % 3 == 0) {
                buffer.write(at, bytes);
                expected.replace(at, std::min(bytes.size(), expected.size() - at), bytes);
            } else {
                buffer.append(bytes);
                expected += bytes;
            }
            QCOMPARE(buffer.size(), expected.size());
            std::string part(1 + random.below(70'000), '?');
            const std::size_t from = std::size_t{random.below(expected.size() + 1)};
            part.resize(buffer.read(from, part));
            QVERIFY(part == expected.substr(from, part.size()));
            QVERIFY(part.size() > 0 || from == expected.size());
        }
        QVERIFY(expected.size() > 300'000);
        QVERIFY(allOf(buffer) == expected);
    }

    void fullDiskIsReported()
    {
        struct rlimit before = {};
        QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
        const auto handler = std::signal(SIGXFSZ, SIG_IGN);
        const auto restore = qScopeGuard([&before, handler] {
            ::setrlimit(RLIMIT_FSIZE, &before);
            std::signal(SIGXFSZ, handler);
        });
        const struct rlimit small = {.rlim_cur = 50'000, .rlim_max = before.rlim_max};
        QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
        FileBackedBuffer buffer;
        buffer.append(std::string(1000, 'x')); // in memory
        const auto error = errorOf([&buffer] { buffer.append(std::string(100'000, 'x')); });
        QVERIFY(error && error->code() == ErrorCode::FileUnwritable);
        QVERIFY(std::filesystem::is_directory(error->subject()));
    }

    void pointsOfAnyNumberAreStored()
    {
        TrackPoints track;
        QVERIFY(track.empty() && track.all().empty());
        std::vector<TrackPoint> expected;
        for (int i = 0; i < 5'000; ++i) {
            expected.push_back({.time_s = 0.1 * i,
                                .state = {.position_m = {1.0 / (i + 1), -i}, .psi_rad = 1e-3 * i},
                                .u_radps = -2.0 * i,
                                .crossTrack_m = 7e10 * i});
            track.append(expected.back());
        }
        const TrackPoints copy = track;
        QCOMPARE(copy.size(), expected.size());
        const std::vector<TrackPoint> read = copy.all();
        QVERIFY(std::ranges::equal(read, expected, [](const TrackPoint& a, const TrackPoint& b) {
            return a.time_s == b.time_s && a.state == b.state && a.u_radps == b.u_radps &&
                   a.crossTrack_m == b.crossTrack_m;
        }));
        QCOMPARE(copy.front().time_s, expected.front().time_s);
        QCOMPARE(copy.back().crossTrack_m, expected.back().crossTrack_m);
    }

    /** An entry that libzip rejects leaves no memory behind, which sanitizers would detect. */
    void refusedEntriesAreFreed()
    {
        const auto write = [](const TextSink& put) { put("text"); };
        std::string zip;
        const auto keep = [&zip](std::string_view piece) { zip += piece; };
        QVERIFY_THROWS_EXCEPTION(std::logic_error, writeZip("\xff.kml", write, keep));
        QVERIFY(zip.empty());
        writeZip("\xc3\xb8.kml", write, keep);
        QVERIFY(isZip(zip));
    }
};

QTEST_GUILESS_MAIN(TestSpool)
#include "tst_file_backed_buffer.moc"
