#include "core/base/stopped.h"
#include "core/io/text/child_process.h"

#include <QtTest>

#include <csignal>
#include <fstream>
#include <thread>

using namespace berg;
using End = ChildResult::End;

namespace {

ChildResult shell(const std::string& script, const ChildLimits& limits = {},
                  const std::stop_token& stop = {})
{
    return runChild({.program = "/bin/sh",
                     .arguments = {"-c", script},
                     .environment = {"PATH=/usr/bin:/bin", "GIVEN=yes"},
                     .folder = "/"},
                    limits, stop);
}

/** Waits until the process whose id is in the file has ended. */
bool endsSoon(const QString& file)
{
    return QTest::qWaitFor([&] {
        QFile text(file);
        const pid_t process = text.open(QIODevice::ReadOnly) ? text.readAll().trimmed().toInt() : 0;
        QFile status(QString("/proc/%1/stat").arg(process));
        return process > 0 &&
               (!status.open(QIODevice::ReadOnly) || status.readAll().contains(") Z "));
    });
}

} // namespace

/** Tests of programs that run with limits. */
class TestChildProcess : public QObject
{
    Q_OBJECT

private slots:
    void outputAndStatusAreReturned()
    {
        const ChildResult result = shell("echo out; echo err >&2; exit 3");
        QCOMPARE(result.end, End::Exited);
        QCOMPARE(result.code, 3);
        QCOMPARE(result.output, std::string("out\n"));
        QCOMPARE(result.errors, std::string("err\n"));
    }

    void longOutputIsWhole()
    {
        const ChildResult result = shell("head -c 9000000 /dev/zero");
        QCOMPARE(result.output.size(), 9'000'000U);
    }

    void errorsAreTheLastOnes()
    {
        const ChildResult result = shell("seq 1 100000 >&2; echo last >&2");
        QVERIFY(result.errors.size() <= 4096U);
        QVERIFY(result.errors.ends_with("100000\nlast\n"));
    }

    void environmentIsGivenAlone()
    {
        qputenv("BERG_SECRET", "1");
        const ChildResult result = shell("echo $GIVEN$BERG_SECRET; pwd; cat");
        qunsetenv("BERG_SECRET");
        QCOMPARE(result.output, std::string("yes\n/\n"));
    }

    void signalsAreReported()
    {
        const ChildResult result = shell("kill -SEGV $$");
        QCOMPARE(result.end, End::Signalled);
        QCOMPARE(result.code, SIGSEGV);
    }

    void missingProgramExits()
    {
        QCOMPARE(runChild({.program = "/nowhere/program", .folder = "/"}).code, 127);
    }

    void endlessOutputIsKilled()
    {
        const ChildResult result = shell("yes", {.output = 1U << 20U});
        QCOMPARE(result.end, End::TooMuchOutput);
        QVERIFY(result.output.empty());
    }

    void slowProgramsAreKilledWithTheirChildren()
    {
        const QTemporaryDir dir;
        const QString file = dir.filePath("process");
        const ChildResult result = shell("sleep 1000 & echo $! >'" + file.toStdString() + "'; wait",
                                         {.wall = std::chrono::milliseconds(300)});
        QCOMPARE(result.end, End::TooSlow);
        QVERIFY(endsSoon(file));
    }

    /** A process that outlives the program does not keep the pipe open for ever. */
    void leftChildrenAreKilled()
    {
        const QTemporaryDir dir;
        const QString file = dir.filePath("process");
        const ChildResult result =
            shell("sleep 1000 & echo $! >'" + file.toStdString() + "'; echo done");
        QCOMPARE(result.end, End::Exited);
        QCOMPARE(result.output, std::string("done\n"));
        QVERIFY(endsSoon(file));
    }

    void memoryIsLimited()
    {
        const ChildResult result = shell("head -c 300000000 /dev/zero | tail -c 300000000 | wc -c",
                                         {.memory = 100U << 20U});
        QVERIFY(result.output != "300000000\n");
    }

    void stopKills()
    {
        std::stop_source stop;
        std::jthread later([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            stop.request_stop();
        });
        QVERIFY_THROWS_EXCEPTION(Stopped, (void)shell("sleep 1000", {}, stop.get_token()));
    }
};

QTEST_GUILESS_MAIN(TestChildProcess)
#include "tst_child_process.moc"
