#include "core/plan/fleet/cbc_cover.h"
#include "core/plan/fleet/fleet_solver.h"
#include "core/plan/solve/cbc_helper.h"
#include "core/plan/solve/cbc_solver.h"
#include "core/plan/solve/engine.h"
#include "tests/support/plan/brute_force.h"
#include "tests/support/plan/cbc_checks.h"
#include "tests/support/plan/fleet_problems.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <stop_token>
#include <thread>

using namespace berg;
using namespace berg::test;

namespace {

/** While it lives, `bergwatch-cbc` is this shell script; $HELPER is the true one. */
class FakeHelper
{
public:
    explicit FakeHelper(const QByteArray& script)
    {
        const QByteArray helper = QByteArray::fromStdString(cbcHelperPath().string());
        QFile file(m_folder.filePath(QStringLiteral("bergwatch-cbc")));
        if (!file.open(QFile::WriteOnly))
            qFatal("no script");
        file.write("#!/bin/sh\nHELPER='" + helper + "'\n" + script + "\n");
        file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        qputenv("BERGWATCH_CBC", file.fileName().toUtf8());
    }
    FakeHelper(const FakeHelper&) = delete;
    FakeHelper& operator=(const FakeHelper&) = delete;
    ~FakeHelper() { qunsetenv("BERGWATCH_CBC"); }

private:
    QTemporaryDir m_folder;
};

TvpProblem small()
{
    return randomProblem(5, 6, 1, Route::Open);
}

/** A problem that no test has time to prove. */
TvpProblem endless()
{
    return randomProblem(3, 12, 0.5, Route::Open);
}

SolveOptions withHint(const TvpProblem& problem)
{
    return {.hint = {inNodeOrder(problem)}};
}

QString wordsOf(const TvpProblem& problem, const SolveOptions& options = {})
{
    try {
        static_cast<void>(CbcSolver(Formulation::Printed).solve(problem, options));
    } catch (const Error& error) {
        return error.code() == ErrorCode::SolverFailed ? QString::fromUtf8(error.what())
                                                       : QStringLiteral("another error");
    }
    return QStringLiteral("no error");
}

/** Bytes of a frame for the shell's printf. */
QByteArray printed(const CbcFrame& frame)
{
    QByteArray text;
    for (const char byte : cbcBytes(frame))
        text +=
            '\\' + QByteArray::number(static_cast<unsigned char>(byte), 8).rightJustified(3, '0');
    return text;
}

} // namespace

/** Any failure of `bergwatch-cbc` is an outcome or an error here, and never ends this process. */
class TestCbcHelper : public QObject
{
    Q_OBJECT

private slots:
    void missingHelperIsReported()
    {
        qputenv("BERGWATCH_CBC", "/nowhere/bergwatch-cbc");
        try {
            static_cast<void>(makeSolver(Backend::Cbc));
            QFAIL("no error");
        } catch (const Error& error) {
            QCOMPARE(error.code(), ErrorCode::Unsupported);
            QCOMPARE(error.issues().front().reason.id, IssueId::CbcMissing);
        }
        qunsetenv("BERGWATCH_CBC");
        QVERIFY(makeSolver(Backend::Cbc) != nullptr);
    }

    void helperFaultsAreReported_data()
    {
        QTest::addColumn<QByteArray>("script");
        QTest::addColumn<QString>("words");
        const auto row = [](const char* name, const QByteArray& script, const char* words) {
            QTest::newRow(name) << script << QString::fromLatin1(words);
        };
        const QByteArray hello = "printf '" + printed(cbcHello()) + "' >&0\n";
        SolveOutcome none{.status = SolveStatus::Feasible, .plan = {{1, 2, 3}}};
        row("ends at once", "exit 3", "exit code 3");
        row("killed at once", "kill -9 $$", "signal 9 (Killed)");
        row("ends after the greeting", hello + "exit 0", "exit code 0");
        row("garbage", "echo 'no message of ours, but long enough' >&0; exec sleep 20",
            "not a message");
        row("other version",
            "printf '\\102\\103\\127\\102\\0\\0\\0\\0\\4\\0\\0\\0\\0\\0\\0\\0\\11\\0\\0\\0' >&0; "
            "exec sleep 20",
            "another version of Bergwatch");
        row("answers before the greeting",
            "printf '" + printed(cbcFrame(CbcFailure{"x"})) + "' >&0; exec sleep 20",
            "another kind");
        row("an order of another problem",
            hello + "printf '" + printed(cbcFrame(none)) + "' >&0; exec sleep 20",
            "does not fit the problem");
        row("too long a message",
            hello + "printf '\\107\\103\\127\\102\\0\\0\\0\\0\\0\\0\\0\\0\\0\\0\\0\\100' >&0; exec "
                    "sleep 20",
            "not a message");
        row("says why not",
            hello + "printf '" + printed(cbcFrame(CbcFailure{"no pivot"})) + "' >&0; exec sleep 20",
            "cbc: no pivot");
    }
    void helperFaultsAreReported()
    {
        QFETCH(QByteArray, script);
        QFETCH(QString, words);
        const FakeHelper fake(script);
        const QString said = wordsOf(small());
        QVERIFY2(said.contains(words), qPrintable(said));
        // With a known order the failure is an outcome.
        const SolveOutcome outcome =
            CbcSolver(Formulation::Printed).solve(small(), withHint(small()));
        QCOMPARE(outcome.status, SolveStatus::Feasible);
        QCOMPARE(outcome.reason, StopReason::Unable);
        QCOMPARE(outcome.plan, withHint(small()).hint);
        QVERIFY_THROWS_EXCEPTION(Error,
                                 static_cast<void>(bestCoverByCbc(FleetOrders(1, 1), 1, 10, {})));
    }

    void killedInMidSolve()
    {
        const FakeHelper fake("( sleep 0.5; kill -9 $$ ) &\nexec \"$HELPER\"");
        const SolveOutcome outcome =
            CbcSolver(Formulation::Printed).solve(endless(), withHint(endless()));
        QCOMPARE(outcome.status, SolveStatus::Feasible);
        QCOMPARE(outcome.reason, StopReason::Unable);
        QVERIFY2(outcome.detail.find("signal 9") != std::string::npos, outcome.detail.c_str());
        QVERIFY(outcome.objective <= objective(endless(), withHint(endless()).hint.front()));
    }

    void silentOnesAreStopped()
    {
        const FakeHelper fake("exec sleep 1000");
        std::stop_source stop;
        std::jthread stopper([&stop] {
            QTest::qSleep(100);
            stop.request_stop();
        });
        SolveOptions options = withHint(small());
        options.stop = stop.get_token();
        const SolveOutcome outcome = CbcSolver(Formulation::Printed).solve(small(), options);
        QCOMPARE(outcome.reason, StopReason::Cancelled);
        QCOMPARE(outcome.plan, options.hint);
    }

    void stuckOnesEndAfterTheTimeLimit()
    {
        const FakeHelper fake("exec sleep 1000");
        SolveOptions options = withHint(small());
        options.timeLimit_s = 0.1;
        const SolveOutcome outcome = CbcSolver(Formulation::Printed).solve(small(), options);
        QCOMPARE(outcome.reason, StopReason::TimeLimit);
        QCOMPARE(outcome.plan, options.hint);
    }

    void outOfMemoryIsALimit()
    {
        const FakeHelper fake("printf '" + printed(cbcHello()) +
                              printed(cbcFrame(CbcFailure{"full", true})) + "' >&0; exec sleep 20");
        const SolveOutcome outcome = CbcSolver(Formulation::Printed).solve(small(), {});
        QCOMPARE(outcome.status, SolveStatus::None);
        QCOMPARE(outcome.reason, StopReason::MemoryLimit);
    }

    /**
     * Branching continues for seconds after the best order is found; the bound is reported
     * meanwhile.
     */
    void theBoundOfAStoppedSolveIsKept()
    {
        const TvpProblem problem = endless();
        SolveOptions options;
        options.hint = ExactSolver().solve(problem, {}).plan;
        std::stop_source stop;
        options.stop = stop.get_token();
        int reports = 0;
        std::optional<double> first;
        options.onProgress = [&](const SolveProgress& progress) {
            first = first ? first : progress.bound;
            if (++reports == 5)
                stop.request_stop();
        };
        const SolveOutcome outcome = CbcSolver(Formulation::Printed).solve(problem, options);
        QCOMPARE(outcome.reason, StopReason::Cancelled);
        QVERIFY(first && outcome.bound && *outcome.bound >= *first);
        QVERIFY(reports >= 5);
    }

    void aFleetKeepsItsPlanWhenTheHelperDies()
    {
        const FakeHelper fake("kill -9 $$");
        int asked = 0;
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            const FleetProblem problem = randomFleet(seed, 3, 14, 1);
            const SolveOutcome outcome = solveFleet(problem, Backend::Cbc, {});
            QVERIFY(isFleetPlan(problem, outcome.plan));
            if (outcome.status == SolveStatus::Optimal)
                continue; // proven before any orders were combined
            ++asked;
            QCOMPARE(outcome.status, SolveStatus::Feasible);
            QCOMPARE(outcome.reason, StopReason::Unable);
            QVERIFY2(outcome.detail.find("signal 9") != std::string::npos, outcome.detail.c_str());
        }
        QVERIFY(asked > 0);
    }

    void startedByHandItPrintsItsPurpose()
    {
        QProcess process;
        process.start(QString::fromStdString(cbcHelperPath().string()), {QStringLiteral("--help")});
        QVERIFY(process.waitForFinished());
        QCOMPARE(process.exitCode(), 2);
        QVERIFY(process.readAllStandardError().contains("works for Bergwatch alone"));
    }

    void framesComeInPieces()
    {
        const TvpProblem problem = small();
        const SolveProgress progress{.plan = {{3, 1, 2, 6, 5, 4}}, .objective = -2.5, .bound = -3};
        const std::string bytes = cbcBytes(cbcHello()) + cbcBytes(cbcFrame(progress));
        CbcFrameBuffer buffer;
        std::vector<CbcFrame> frames;
        for (const char byte : bytes) {
            buffer.add({&byte, 1});
            while (const std::optional<CbcFrame> frame = buffer.nextFrame())
                frames.push_back(*frame);
        }
        QCOMPARE(frames.size(), std::size_t{2});
        requireCbcHello(frames.front());
        const SolveProgress read = cbcProgressOf(frames.back(), problem);
        QCOMPARE(read.plan, progress.plan);
        QCOMPARE(read.objective, progress.objective);
        QCOMPARE(read.bound, progress.bound);
    }

    void otherAnswersReadBack()
    {
        const CbcPartition asked{
            .rows = 2, .columns = {{0}, {1}, {0, 1}}, .costs = {1, 2, 2.5}, .slack = 9};
        const CbcPartition read = cbcPartitionOf(cbcFrame(asked));
        QCOMPARE(read.rows, asked.rows);
        QCOMPARE(read.columns, asked.columns);
        QCOMPARE(read.costs, asked.costs);
        QCOMPARE(read.slack, asked.slack);
        const CbcChoice choice =
            cbcChoiceOf(cbcFrame(CbcChoice{.complete = true, .columns = {2}}), asked);
        QVERIFY(choice.complete);
        QCOMPARE(choice.columns, std::vector{2});
        QVERIFY_THROWS_EXCEPTION(CbcWireFault, static_cast<void>(cbcChoiceOf(
                                                   cbcFrame(CbcChoice{.columns = {3}}), asked)));
        const SolveOutcome outcome{.status = SolveStatus::Feasible,
                                   .reason = StopReason::WorkLimit,
                                   .plan = {{3, 1, 2, 6, 5, 4}},
                                   .bound = -7.5,
                                   .work = 12,
                                   .hintUsed = true,
                                   .detail = "CBC"};
        const SolveOutcome told = cbcOutcomeOf(cbcFrame(outcome), small());
        QCOMPARE(told.status, outcome.status);
        QCOMPARE(told.reason, outcome.reason);
        QCOMPARE(told.plan, outcome.plan);
        QCOMPARE(told.bound, outcome.bound);
        QCOMPARE(told.work, outcome.work);
        QCOMPARE(told.hintUsed, outcome.hintUsed);
        QCOMPARE(told.detail, outcome.detail);
    }

    void problemsReadBack()
    {
        const CbcProblem asked{
            .formulation = Formulation::Reduced,
            .problem = small(),
            .options = {
                .timeLimit_s = 2.5, .workLimit = 7, .gap = 0.01, .hint = withHint(small()).hint}};
        const CbcProblem read = cbcProblemOf(cbcFrame(asked));
        QCOMPARE(read.formulation, asked.formulation);
        QVERIFY(read.problem.distance_m == asked.problem.distance_m);
        QCOMPARE(read.problem.sigma_m2, asked.problem.sigma_m2);
        QCOMPARE(read.problem.mu, asked.problem.mu);
        QCOMPARE(read.options.timeLimit_s, asked.options.timeLimit_s);
        QCOMPARE(read.options.workLimit, asked.options.workLimit);
        QCOMPARE(read.options.memoryLimit_bytes, asked.options.memoryLimit_bytes);
        QCOMPARE(read.options.gap, asked.options.gap);
        QCOMPARE(read.options.hint, asked.options.hint);
    }

    /** Any prefix and any changed byte of a request fails, or is another request. */
    void brokenRequestsAreFaults()
    {
        const CbcFrame whole = cbcFrame(CbcProblem{.problem = small(), .options = {}});
        for (std::size_t length = 0; length < whole.payload.size(); ++length) {
            const CbcFrame truncated{.kind = whole.kind,
                                     .payload = whole.payload.substr(0, length)};
            QVERIFY_THROWS_EXCEPTION(CbcWireFault, static_cast<void>(cbcProblemOf(truncated)));
        }
        int refused = 0;
        for (std::size_t place = 0; place < whole.payload.size(); ++place) {
            CbcFrame changed = whole;
            changed.payload[place] = static_cast<char>(changed.payload[place] ^ 0xff);
            try {
                QVERIFY(validate(cbcProblemOf(changed).problem).empty());
            } catch (const CbcWireFault&) {
                ++refused;
            }
        }
        QVERIFY(refused > 0);
    }
};

QTEST_APPLESS_MAIN(TestCbcHelper)
#include "tst_cbc_helper.moc"
