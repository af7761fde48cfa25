#include "core/io/text/atomic_file.h"
#include "core/io/text/file_set.h"
#include "tests/support/expect_error.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <csignal>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace berg;
using berg::test::errorOf;
using namespace Qt::StringLiterals;

/** Tests of several files that belong together. */
class TestFileSet : public QObject
{
    Q_OBJECT

private slots:
    void allAreWritten()
    {
        const QTemporaryDir folder;
        const std::string first = folder.filePath(u"a.plan"_s).toStdString();
        const std::string second = folder.filePath(u"b.plan"_s).toStdString();
        writeFileAtomically(second, "old");
        writeFileSet(std::vector<NewFile>{{first, "1"}, {second, "2"}});
        QCOMPARE(readFile(first), std::string("1"));
        QCOMPARE(readFile(second), std::string("2"));
        writeFileSet(std::vector<NewFile>{{first, "3"}});
        QCOMPARE(readFile(first), std::string("3"));
    }

    /** Targets that cannot be restored are not opened for reading, which a socket refuses. */
    void setMayContainASocket()
    {
        const QTemporaryDir folder;
        const std::string first = folder.filePath(u"a.plan"_s).toStdString();
        std::array<int, 2> ends{};
        QCOMPARE(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
        const std::string socket = "/dev/fd/" + std::to_string(ends[0]);
        writeFileSet(std::vector<NewFile>{{first, "1"}, {socket, "2"}});
        char got = 0;
        QCOMPARE(::read(ends[1], &got, 1), ssize_t{1});
        QCOMPARE(got, '2');
        QCOMPARE(readFile(first), std::string("1"));
        ::close(ends[0]);
        ::close(ends[1]);
    }

    /** Two sets are written alternately; at each instant all files belong to one set. */
    void killedWriterLeavesOneSet()
    {
        constexpr int kFiles = 30;
        constexpr int kKills = 40;
        const QTemporaryDir folder;
        std::array<std::vector<NewFile>, 2> sets;
        for (int i = 0; i < kFiles; ++i)
            for (std::size_t set = 0; set < sets.size(); ++set)
                sets[set].push_back({folder.filePath(QString::number(i)).toStdString(),
                                     std::string(1, static_cast<char>('a' + set))});
        writeFileSet(sets[0]);
        const auto isWhole = [&] {
            const QStringList names = QDir(folder.path()).entryList(QDir::Files | QDir::Hidden);
            const std::string first = readFile(sets[0][0].path);
            return names.size() == kFiles && std::ranges::all_of(sets[0], [&](const NewFile& file) {
                       return readFile(file.path) == first;
                   });
        };
        for (int kill = 0; kill < kKills; ++kill) {
            const pid_t writer = ::fork();
            if (writer == 0)
                for (std::size_t i = 0;; ++i)
                    writeFileSet(sets[i % 2]);
            QTest::qSleep(5 + 7 * kill % 20);
            ::kill(writer, SIGKILL);
            ::waitpid(writer, nullptr, 0);
            // The process that renames them may need a little time, or may not have begun.
            bool whole = isWhole();
            for (int i = 0; i < 1000 && !whole; ++i) {
                QTest::qSleep(10);
                whole = isWhole();
            }
            QVERIFY2(whole, QByteArray::number(kill).constData());
        }
    }

    /** The last file cannot be written: existing files are restored, and new ones removed. */
    void failureRestoresEveryFile()
    {
        const QTemporaryDir folder;
        const std::string there = folder.filePath(u"a.plan"_s).toStdString();
        const std::string fresh = folder.filePath(u"b.plan"_s).toStdString();
        const std::string last = folder.filePath(u"c.plan"_s).toStdString();
        QVERIFY(QDir(folder.path()).mkdir(u"c.plan"_s));
        writeFileAtomically(there, "old");
        const std::vector<NewFile> files{{there, "1"}, {fresh, "2"}, {last, "3"}};
        const std::optional<Error> error = errorOf([&] { writeFileSet(files); });
        QVERIFY(error && error->code() == ErrorCode::FileUnwritable && error->subject() == last);
        QCOMPARE(readFile(there), std::string("old"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{u"a.plan"_s});
    }

    /** A file larger than readers accept is overwritten and restored all the same. */
    void largeFileIsRestored()
    {
        const QTemporaryDir folder;
        const std::string large = folder.filePath(u"a.csv"_s).toStdString();
        const std::string last = folder.filePath(u"b"_s).toStdString();
        writeFileAtomically(large, "old");
        constexpr off_t kSize = 80'000'000; // most of it takes no room on the disk
        QCOMPARE(::truncate(large.c_str(), kSize), 0);
        FileSet refused;
        refused.add(large, "new");
        StagedFile& other = refused.add(last);
        other.append("something");
        QVERIFY(QDir(folder.path()).mkdir(u"b"_s)); // now blocks the second file
        QVERIFY(errorOf([&] { refused.write(); }));
        QCOMPARE(QFileInfo(folder.filePath(u"a.csv"_s)).size(), qint64{kSize});
        writeFileSet(std::vector<NewFile>{{large, "new"}, {last + "2", "2"}});
        QCOMPARE(readFile(large), std::string("new"));
    }

    /** A file written in pieces is complete when the set is written. */
    void contentMayComeInPieces()
    {
        const QTemporaryDir folder;
        const std::string path = folder.filePath(u"a"_s).toStdString();
        std::string expected;
        {
            FileSet given;
            StagedFile& abandoned = given.add(path);
            abandoned.append("lost");
        }
        QVERIFY(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).empty());
        FileSet set;
        StagedFile& file = set.add(path);
        for (int i = 0; i < 50'000; ++i) {
            const std::string line = std::to_string(i) + '\n';
            file.append(line);
            expected += line;
        }
        QVERIFY(!QFileInfo::exists(folder.filePath(u"a"_s)));
        set.write();
        QVERIFY(readFile(path) == expected);
    }
};

QTEST_APPLESS_MAIN(TestFileSet)
#include "tst_file_set.moc"
