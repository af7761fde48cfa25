#include "core/io/text/atomic_file.h"
#include "tests/support/expect_error.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <fcntl.h>
#include <string>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace berg;
using namespace berg::test;

namespace {

/** All names in a folder, hidden ones and broken links included. */
QStringList namesIn(const QTemporaryDir& dir)
{
    return QDir(dir.path())
        .entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot,
                   QDir::Name);
}

unsigned modeOf(const std::string& path)
{
    struct stat status
    {
    };
    return ::stat(path.c_str(), &status) == 0 ? status.st_mode & 07777U : 0U;
}

/** While it exists, no file of this process may grow beyond `bytes`, as on a full disk. */
class FileSizeLimit
{
public:
    explicit FileSizeLimit(rlim_t bytes)
    {
        ::getrlimit(RLIMIT_FSIZE, &m_before);
        m_handler = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{bytes, m_before.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit()
    {
        ::setrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, m_handler);
    }

private:
    rlimit m_before{};
    void (*m_handler)(int) = SIG_DFL;
};

/** While it exists, a test run by root is subject to permissions like other users. */
class OrdinaryUser
{
public:
    OrdinaryUser() : m_isRoot(::geteuid() == 0)
    {
        if (m_isRoot && ::seteuid(kNobody) != 0)
            qFatal("root cannot become another user");
    }
    OrdinaryUser(const OrdinaryUser&) = delete;
    OrdinaryUser& operator=(const OrdinaryUser&) = delete;
    ~OrdinaryUser()
    {
        if (m_isRoot && ::seteuid(0) != 0)
            qFatal("the test stays without its rights");
    }

private:
    static constexpr uid_t kNobody = 65534;
    bool m_isRoot;
};

/** While it exists, the folder has these permissions, set by its owner. */
class FolderMode
{
public:
    FolderMode(const QTemporaryDir& dir, mode_t mode) : m_path(dir.path().toStdString())
    {
        set(mode);
    }
    FolderMode(const FolderMode&) = delete;
    FolderMode& operator=(const FolderMode&) = delete;
    ~FolderMode() { set(0700); }

private:
    void set(mode_t mode)
    {
        const uid_t user = ::geteuid();
        if (::getuid() == 0 && ::seteuid(0) != 0)
            qFatal("root is not root");
        if (::chmod(m_path.c_str(), mode) != 0 || (::getuid() == 0 && ::seteuid(user) != 0))
            qFatal("the folder's permissions cannot be set");
    }

    std::string m_path;
};

} // namespace

class TestAtomicFile : public QObject
{
    Q_OBJECT

private:
    std::string path(const char* name) const { return m_dir->filePath(name).toStdString(); }

    /** Writing to `target` must fail and leave the folder's names unchanged. */
    void refusesToWrite(const std::string& target)
    {
        const QStringList before = namesIn(*m_dir);
        const std::optional<Error> error = errorOf([&] { writeFileAtomically(target, "new"); });
        QVERIFY(error);
        QCOMPARE(codeName(error->code()), std::string("FileUnwritable"));
        QCOMPARE(error->subject(), target);
        QVERIFY(std::string(error->what()).starts_with(target + ": cannot be written: "));
        QCOMPARE(namesIn(*m_dir), before);
    }

    std::unique_ptr<QTemporaryDir> m_dir;

private slots:
    void init()
    {
        m_dir = std::make_unique<QTemporaryDir>();
        QVERIFY(m_dir->isValid());
    }

    void contentIsReadBack_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("text") << QByteArray("line\nline\n");
        QTest::newRow("binary") << QByteArray("\0\xFF\r\n\x1A", 5);
        QTest::newRow("a chunk") << QByteArray(1 << 20, 'x');
        QTest::newRow("above a chunk") << QByteArray((1 << 20) + 1, 'x');
        QTest::newRow("5 MB") << QByteArray(5'000'000, 'y');
    }
    void contentIsReadBack()
    {
        QFETCH(const QByteArray, content);
        const std::string file = path("file");
        writeFileAtomically(file, {content.data(), static_cast<std::size_t>(content.size())});
        QVERIFY(QByteArray::fromStdString(readFile(file)) == content);
        std::string pieces;
        const std::size_t size =
            readPieces(file, 5'000'000, [&](std::string_view piece) { pieces += piece; });
        QCOMPARE(size, static_cast<std::size_t>(content.size()));
        QVERIFY(QByteArray::fromStdString(pieces) == content);
        QCOMPARE(namesIn(*m_dir), QStringList{"file"});
    }

    void piecesAreLimited()
    {
        writeFileAtomically(path("file"), std::string(70'000, 'a'));
        const auto read = [&](const std::string& name, std::size_t most) {
            return codeOf([&] { (void)readPieces(path(name.c_str()), most, [](auto) {}); });
        };
        QCOMPARE(read("file", 69'999), std::string("FileTooLarge"));
        QCOMPARE(read("file", 70'000), std::string("nothing"));
        QCOMPARE(read("missing", 1), std::string("FileNotFound"));
    }

    void existingContentIsReplaced()
    {
        const std::string file = path("file");
        writeFileAtomically(file, std::string(1000, 'a'));
        writeFileAtomically(file, "short");
        QCOMPARE(readFile(file), std::string("short"));
        QCOMPARE(namesIn(*m_dir), QStringList{"file"});
    }

    void newFileObeysTheMask()
    {
        const mode_t before = ::umask(027);
        writeFileAtomically(path("file"), "x");
        ::umask(before);
        QCOMPARE(modeOf(path("file")), 0640U);
    }

    void permissionsAreKept_data()
    {
        QTest::addColumn<uint>("mode");
        QTest::newRow("private") << 0600U;
        QTest::newRow("group") << 0664U;
        QTest::newRow("executable") << 0755U;
    }
    void permissionsAreKept()
    {
        QFETCH(const uint, mode);
        const std::string file = path("file");
        writeFileAtomically(file, "old");
        QCOMPARE(::chmod(file.c_str(), mode), 0);
        writeFileAtomically(file, "new");
        QCOMPARE(readFile(file), std::string("new"));
        QCOMPARE(modeOf(file), mode);
    }

    void linkKeepsPointing()
    {
        QVERIFY(QDir(m_dir->path()).mkdir("folder"));
        const std::string target = path("folder/target");
        writeFileAtomically(target, "old");
        QCOMPARE(::symlink("folder/target", path("link").c_str()), 0);
        QCOMPARE(::symlink(path("link").c_str(), path("link of link").c_str()), 0);
        writeFileAtomically(path("link of link"), "new");
        QCOMPARE(readFile(target), std::string("new"));
        QVERIFY(QFileInfo(m_dir->filePath("link")).isSymLink());
        QVERIFY(QFileInfo(m_dir->filePath("link of link")).isSymLink());
        QCOMPARE(QDir(m_dir->filePath("folder")).entryList(QDir::Files | QDir::Hidden),
                 QStringList{"target"});
    }

    void linkToNothingGetsItsFile()
    {
        QCOMPARE(::symlink("later", path("link").c_str()), 0);
        writeFileAtomically(path("link"), "new");
        QCOMPARE(readFile(path("later")), std::string("new"));
        QVERIFY(QFileInfo(m_dir->filePath("link")).isSymLink());
    }

    void relativePathIsWritten()
    {
        const QString before = QDir::currentPath();
        QVERIFY(QDir::setCurrent(m_dir->path()));
        writeFileAtomically("here", "x");
        const std::string read = readFile("here");
        QVERIFY(QDir::setCurrent(before));
        QCOMPARE(read, std::string("x"));
        QCOMPARE(namesIn(*m_dir), QStringList{"here"});
    }

    void longestNameIsWritten()
    {
        const std::string file = path(std::string(255, 'n').c_str());
        writeFileAtomically(file, "x");
        QCOMPARE(readFile(file), std::string("x"));
    }

    void fileOfAnotherWriterIsLeftAlone()
    {
        // This process would use this name first; here it belongs to a writer with the same id
        // elsewhere.
        const std::string leftover = path(".file.") + std::to_string(::getpid()) + "-0.tmp";
        writeFileAtomically(leftover, "kept");
        const int fd = ::open(leftover.c_str(), O_WRONLY | O_CLOEXEC);
        QCOMPARE(::flock(fd, LOCK_EX | LOCK_NB), 0);
        writeFileAtomically(path("file"), "new");
        ::close(fd);
        QCOMPARE(readFile(path("file")), std::string("new"));
        QCOMPARE(readFile(leftover), std::string("kept"));
        QCOMPARE(namesIn(*m_dir).size(), qsizetype{2});
    }

    void unwritableTargetsAreReported_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("folder is missing") << "missing/file";
        QTest::newRow("folder is a file") << "plain/file";
        QTest::newRow("target is a folder") << "folder";
        QTest::newRow("target is a folder, with slash") << "folder/";
        QTest::newRow("link to a folder") << "link to folder";
        QTest::newRow("links in a circle") << "circle";
        QTest::newRow("name too long") << QString(256, 'n');
        QTest::newRow("no name") << "folder/.";
    }
    void unwritableTargetsAreReported()
    {
        QFETCH(const QString, name);
        writeFileAtomically(path("plain"), "plain");
        QVERIFY(QDir(m_dir->path()).mkdir("folder"));
        QCOMPARE(::symlink("folder", path("link to folder").c_str()), 0);
        QCOMPARE(::symlink("circle", path("circle").c_str()), 0);
        refusesToWrite(m_dir->filePath(name).toStdString());
        QVERIFY(QDir(m_dir->filePath("folder")).isEmpty());
        QCOMPARE(readFile(path("plain")), std::string("plain"));
    }

    void emptyPathIsRejected()
    {
        QCOMPARE(codeOf([] { writeFileAtomically("", "x"); }), std::string("FileUnwritable"));
    }

    void newFileInAFolderWithoutWritePermission()
    {
        writeFileAtomically(path("file"), "old");
        const OrdinaryUser user;
        FolderMode mode(*m_dir, 0555);
        refusesToWrite(path("new file"));
    }

    void fileInAClosedFolderIsOverwritten_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("file") << "file";
        QTest::newRow("link") << "link";
    }
    /** The folder refuses a second file, but the file itself may be written. */
    void fileInAClosedFolderIsOverwritten()
    {
        QFETCH(const QString, name);
        writeFileAtomically(path("file"), std::string(1000, 'o'));
        QCOMPARE(::chmod(path("file").c_str(), 0666), 0);
        QCOMPARE(::symlink("file", path("link").c_str()), 0);
        const QStringList before = namesIn(*m_dir);
        {
            const OrdinaryUser user;
            FolderMode mode(*m_dir, 0555);
            writeFileAtomically(m_dir->filePath(name).toStdString(), "new");
        }
        QCOMPARE(readFile(path("file")), std::string("new"));
        QCOMPARE(modeOf(path("file")), 0666U);
        QVERIFY(QFileInfo(m_dir->filePath("link")).isSymLink());
        QCOMPARE(namesIn(*m_dir), before);
    }

    /** In a sticky folder nobody may replace the file of another user, however writable it is. */
    void fileInAStickyFolderIsOverwritten()
    {
        if (::geteuid() != 0)
            QSKIP("needs a file of somebody else");
        writeFileAtomically(path("file"), "old");
        QCOMPARE(::chmod(path("file").c_str(), 0666), 0);
        {
            const OrdinaryUser user;
            FolderMode mode(*m_dir, 01777);
            writeFileAtomically(path("file"), "new");
        }
        QCOMPARE(readFile(path("file")), std::string("new"));
        QCOMPARE(namesIn(*m_dir), QStringList{"file"});
    }

    void fullDiskKeepsTheFileWrittenInPlace()
    {
        writeFileAtomically(path("file"), "old");
        QCOMPARE(::chmod(path("file").c_str(), 0666), 0);
        {
            const OrdinaryUser user;
            FolderMode mode(*m_dir, 0555);
            const FileSizeLimit limit(4096);
            const std::string large(100'000, 'x');
            QCOMPARE(codeOf([&] { writeFileAtomically(path("file"), large); }),
                     std::string("FileUnwritable"));
        }
        QCOMPARE(readFile(path("file")), std::string("old"));
    }

    void fullDiskKeepsTheOldFile()
    {
        const std::string file = path("file");
        writeFileAtomically(file, "old");
        {
            const FileSizeLimit limit(4096);
            const std::string large(100'000, 'x');
            QCOMPARE(codeOf([&] { writeFileAtomically(file, large); }),
                     std::string("FileUnwritable"));
        }
        QCOMPARE(readFile(file), std::string("old"));
        QCOMPARE(namesIn(*m_dir), QStringList{"file"});
    }

    void deviceIsWrittenInPlace()
    {
        writeFileAtomically("/dev/null", "x");
        QVERIFY(QFileInfo::exists("/dev/null"));
        QCOMPARE(codeOf([] { writeFileAtomically("/dev/full", "x"); }),
                 std::string("FileUnwritable"));
    }

    void pipeIsWrittenInPlace()
    {
        const std::string pipe = path("pipe");
        QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
        std::string received(3, '?');
        std::thread reader([&] {
            const int fd = ::open(pipe.c_str(), O_RDONLY);
            std::size_t size = 0;
            while (fd >= 0 && size < received.size()) {
                const ssize_t got = ::read(fd, received.data() + size, received.size() - size);
                if (got <= 0)
                    break;
                size += static_cast<std::size_t>(got);
            }
            ::close(fd);
        });
        writeFileAtomically(pipe, "abc");
        reader.join();
        QCOMPARE(received, std::string("abc"));
        QCOMPARE(namesIn(*m_dir), QStringList{"pipe"});
    }

    void readerSeesOldOrNew()
    {
        // Writers of two contents compete with a reader that must never see a mixture or a part.
        const std::string file = path("file");
        const std::string a(200'000, 'a');
        const std::string b(300'000, 'b');
        writeFileAtomically(file, a);
        std::thread writer([&] {
            for (int i = 0; i < 20; ++i)
                writeFileAtomically(file, i % 2 == 0 ? b : a);
        });
        bool whole = true;
        for (int i = 0; i < 100; ++i) {
            const std::string seen = readFile(file);
            whole = whole && (seen == a || seen == b);
        }
        writer.join();
        QVERIFY(whole);
        QCOMPARE(namesIn(*m_dir), QStringList{"file"});
    }

    void unreadableFilesAreReported_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("code");
        QTest::newRow("missing") << "missing"
                                 << "FileNotFound";
        QTest::newRow("below a file") << "plain/file"
                                      << "FileNotFound";
        QTest::newRow("link to nothing") << "dangling"
                                         << "FileNotFound";
        QTest::newRow("folder") << "folder"
                                << "FileUnreadable";
        QTest::newRow("links in a circle") << "circle"
                                           << "FileUnreadable";
        QTest::newRow("pipe nobody writes to") << "pipe"
                                               << "FileUnreadable";
    }
    void unreadableFilesAreReported()
    {
        QFETCH(const QString, name);
        QFETCH(const QString, code);
        writeFileAtomically(path("plain"), "plain");
        QVERIFY(QDir(m_dir->path()).mkdir("folder"));
        QCOMPARE(::symlink("nothing", path("dangling").c_str()), 0);
        QCOMPARE(::symlink("circle", path("circle").c_str()), 0);
        QCOMPARE(::mkfifo(path("pipe").c_str(), 0600), 0);
        const std::string file = m_dir->filePath(name).toStdString();
        const std::optional<Error> error = errorOf([&] { (void)readFile(file); });
        QVERIFY(error);
        QCOMPARE(QString::fromStdString(codeName(error->code())), code);
        QCOMPARE(error->subject(), file);
    }

    void largestFileIsReadButNoLarger()
    {
        const std::string file = path("large");
        writeFileAtomically(file, "");
        QCOMPARE(::truncate(file.c_str(), static_cast<off_t>(kLargestFile)), 0);
        QCOMPARE(readFile(file).size(), kLargestFile);
        QCOMPARE(::truncate(file.c_str(), static_cast<off_t>(kLargestFile) + 1), 0);
        QCOMPARE(codeOf([&] { (void)readFile(file); }), std::string("FileTooLarge"));
    }
};

QTEST_APPLESS_MAIN(TestAtomicFile)
#include "tst_atomic_file.moc"
