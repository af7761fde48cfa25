#include "core/io/file_descriptor.h"
#include "core/io/temporary_file.h"
#include "core/io/text/atomic_file.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace berg;

namespace {

QStringList namesIn(const QTemporaryDir& dir)
{
    return QDir(dir.path()).entryList(QDir::Files | QDir::Hidden, QDir::Name);
}

} // namespace

/** Tests which leftovers of killed writers are removed. */
class TestTemporaryFile : public QObject
{
    Q_OBJECT

private:
    std::string path(const char* name) const { return m_dir->filePath(name).toStdString(); }

    std::unique_ptr<QTemporaryDir> m_dir;

private slots:
    void init()
    {
        m_dir = std::make_unique<QTemporaryDir>();
        QVERIFY(m_dir->isValid());
    }

    void leftoversOfKilledWritersAreRemoved_data()
    {
        QTest::addColumn<bool>("writes");
        QTest::newRow("when it is written") << true;
        QTest::newRow("when it is opened") << false;
    }
    void leftoversOfKilledWritersAreRemoved()
    {
        QFETCH(bool, writes);
        writeFileAtomically(path("plan.berg"), "old");
        const QStringList others{".plan.berg.bak", ".plan.berg.tmp",    ".plan.berg.x1-0.tmp",
                                 ".1-0.tmp",       "plan.berg.1-0.tmp", ".plan.berg.1.tmp"};
        for (const QString& name :
             others + QStringList{".plan.berg.1-0.tmp", ".plan.berg.77-12.tmp",
                                  ".of another file.7-0.tmp"})
            writeFileAtomically(m_dir->filePath(name).toStdString(), "half");
        const std::string held = path(".plan.berg.2-0.tmp"); // being written by another program
        writeFileAtomically(held, "half");
        const int fd = ::open(held.c_str(), O_WRONLY | O_CLOEXEC);
        QCOMPARE(::flock(fd, LOCK_EX | LOCK_NB), 0);
        if (writes)
            writeFileAtomically(path("plan.berg"), "new");
        else
            removeLeftovers(path("plan.berg"));
        QStringList left = others + QStringList{".plan.berg.2-0.tmp", "plan.berg"};
        left.sort();
        QCOMPARE(namesIn(*m_dir), left);
        ::close(fd);
        QCOMPARE(readFile(path("plan.berg")), std::string(writes ? "new" : "old"));
    }

    void killedWriterLeavesAWholeFile()
    {
        const std::string target = path("plan.berg");
        writeFileAtomically(target, "old");
        const std::string content(32U << 20U, 'x');
        const pid_t writer = ::fork();
        if (writer == 0)
            for (;;)
                writeFileAtomically(target, content);
        while (namesIn(*m_dir).size() < 2) // it writes
            QTest::qSleep(1);
        ::kill(writer, SIGKILL);
        ::waitpid(writer, nullptr, 0);
        const std::size_t size = readFile(target).size();
        QVERIFY(size == 3 || size == content.size());
        writeFileAtomically(target, "new");
        QCOMPARE(namesIn(*m_dir), QStringList{"plan.berg"});
    }

    /**
     * The first refused rename ends the series; renamed files are reported, and no temporary name
     * is left.
     */
    void childProcessRenamesUpToTheFirstFailure()
    {
        QVERIFY(QDir(m_dir->path()).mkdir("c"));
        TemporaryFile first(path("a"));
        TemporaryFile second(path("b"));
        TemporaryFile third(path("c"));
        for (const TemporaryFile* file : {&first, &second, &third})
            QVERIFY(file->isOpen() && writeAll(file->descriptor(), "new") && file->flush());
        const std::vector<Placing> placings{first.placing(), second.placing(), third.placing()};
        QCOMPARE(placeInChildProcess(placings), std::size_t{2});
        first.notePlaced();
        second.notePlaced();
        QCOMPARE(readFile(path("a")), std::string("new"));
        QCOMPARE(readFile(path("b")), std::string("new"));
        if (!third.isNamed())
            QCOMPARE(namesIn(*m_dir), (QStringList{"a", "b"}));
    }
};

QTEST_APPLESS_MAIN(TestTemporaryFile)
#include "tst_temporary_file.moc"
