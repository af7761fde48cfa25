#include "widgets/document/file_lock.h"

#include <QCoreApplication>
#include <QFile>
#include <QSysInfo>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

using namespace berg;
using namespace Qt::StringLiterals;

class TestFileLock : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString m_path = m_folder.filePath(u"a.lock"_s);

private slots:
    void cleanup() { QFile::remove(m_path); }

    void excludesOthersAndNamesItself()
    {
        FileLock lock;
        QVERIFY(!lock.isHeld());
        QCOMPARE(lock.take(m_path), FileLock::Outcome::Taken);
        QVERIFY(lock.isHeld());
        FileLock other;
        QCOMPARE(other.take(m_path), FileLock::Outcome::Busy);
        QVERIFY(!other.isHeld());
        QCOMPARE(lockHolder(m_path).pid.value(), QCoreApplication::applicationPid());
        QCOMPARE(lockHolder(m_path).host, QSysInfo::machineHostName());
    }

    void releaseRemovesTheFile()
    {
        {
            FileLock lock;
            QCOMPARE(lock.take(m_path), FileLock::Outcome::Taken);
            FileLock moved(std::move(lock));
            QVERIFY(moved.isHeld());
            QVERIFY(!lock.isHeld()); // NOLINT(bugprone-use-after-move): the test checks this
            FileLock other;
            QCOMPARE(other.take(m_path), FileLock::Outcome::Busy);
        }
        QVERIFY(!QFile::exists(m_path));
        FileLock next;
        QCOMPARE(next.take(m_path), FileLock::Outcome::Taken);
    }

    /** A file left behind is not a lock, even if it names a running process. */
    void fileThatNobodyHolds()
    {
        QFile left(m_path);
        QVERIFY(left.open(QIODevice::WriteOnly));
        left.write(QByteArray::number(QCoreApplication::applicationPid()) + "\nhere\n");
        left.close();
        FileLock lock;
        QCOMPARE(lock.take(m_path), FileLock::Outcome::Taken);
    }

    void killedProcessLetsGo()
    {
        int ready[2];
        QCOMPARE(::pipe(ready), 0);
        const pid_t child = ::fork();
        QVERIFY(child >= 0);
        if (child == 0) {
            FileLock lock;
            const char taken = lock.take(m_path) == FileLock::Outcome::Taken ? 'y' : 'n';
            if (::write(ready[1], &taken, 1) != 1)
                ::_exit(1);
            for (;;)
                ::pause();
        }
        char taken = '?';
        QCOMPARE(::read(ready[0], &taken, 1), ssize_t{1});
        QCOMPARE(taken, 'y');
        FileLock lock;
        QCOMPARE(lock.take(m_path), FileLock::Outcome::Busy);
        QCOMPARE(::kill(child, SIGKILL), 0);
        QCOMPARE(::waitpid(child, nullptr, 0), child);
        QVERIFY(QFile::exists(m_path)); // it had no time to remove the file
        QCOMPARE(lock.take(m_path), FileLock::Outcome::Taken);
        ::close(ready[0]);
        ::close(ready[1]);
    }

    void folderThatIsMissing()
    {
        FileLock lock;
        QCOMPARE(lock.take(m_folder.filePath(u"no/such.lock"_s)), FileLock::Outcome::Impossible);
        QVERIFY(!lockHolder(m_folder.filePath(u"no/such.lock"_s)).pid);
    }
};

QTEST_GUILESS_MAIN(TestFileLock)
#include "tst_file_lock.moc"
