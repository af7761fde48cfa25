#include "core/io/files/certificate_json.h"
#include "core/plan/fleet/fleet_solver.h"
#include "core/plan/proof/layered_graph.h"
#include "core/plan/solve/order_moves.h"
#include "tests/support/plan/fleet_problems.h"
#include "tests/support/plan/hard_problems.h"
#include "tests/support/plan/nasty_problems.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

using namespace berg;

namespace {

/** Ways to make a false proof of a sound one. */
enum class Forgery
{
    BoundTooHigh,
    OrderNotOptimal,
    MultipliersLost,
    IcebergTwice
};

TvpProblem nearlyEqual(TvpProblem problem, std::uint64_t seed)
{
    Random random(seed, 5);
    for (std::size_t i = 1; i < problem.sigma_m2.size(); ++i)
        problem.sigma_m2[i] = 5 * (1 + 1e-13 * random.uniform());
    return problem;
}

VisitOrder solved(const TvpProblem& problem)
{
    return makeSolver(Backend::Exact)->solve(problem, {}).order();
}

Certificate certificateOf(const TvpProblem& problem, const VisitOrder& order)
{
    Certificate certificate = {.problem = problemOf(problem)};
    certificate.proofs.push_back(certify(problem, order));
    return certificate;
}

Certificate certificateOf(const FleetProblem& problem)
{
    const SolveOutcome outcome =
        solveFleet(problem, Backend::Auto, {.workLimit = std::int64_t{100'000'000}});
    return {.problem = problem, .proofs = {certify(problem, outcome.plan)}};
}

/** Relative. */
double gapOf(const Certificate& certificate)
{
    const Proof& proof = certificate.proofs.back();
    return proof.cost > 0 ? (proof.cost - proof.bound) / proof.cost : 0.0;
}

} // namespace

/** Certificates, checked by a program that shares no code with the planner (tests/checker). */
class TestCertificate : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    /** 200 problems of many kinds. */
    void certificatesAreConfirmed_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<int>("count");
        QTest::newRow("visitation, enumerated") << "small" << 40;
        QTest::newRow("visitation, relaxed") << "large" << 45;
        QTest::newRow("of poor orders, which all of the bound must rule out") << "poor" << 15;
        QTest::newRow("latency, enumerated") << "small latency" << 20;
        QTest::newRow("latency, relaxed") << "large latency" << 25;
        QTest::newRow("sigmas that nearly agree") << "nearly equal" << 15;
        QTest::newRow("several UAVs, enumerated") << "small fleet" << 25;
        QTest::newRow("several UAVs, relaxed") << "large fleet" << 7;
        QTest::newRow("several UAVs that may visit few") << "nasty fleet" << 5;
        QTest::newRow("more than 40 icebergs") << "beyond" << 3;
    }
    void certificatesAreConfirmed()
    {
        QFETCH(QString, kind);
        QFETCH(int, count);
        for (int k = 0; k < count; ++k) {
            const Certificate certificate = made(kind, k);
            // Up to 40 icebergs the order is proven; multipliers of several UAVs leave a gap.
            const double most = kind == "poor"          ? 1
                                : kind == "nasty fleet" ? 1
                                : kind == "large fleet" ? 0.02
                                : kind == "beyond"      ? 0.0010001
                                                        : 1e-8;
            QVERIFY2(gapOf(certificate) <= most,
                     qPrintable(QStringLiteral("%1: %2").arg(k).arg(gapOf(certificate))));
            write(k, certificate);
        }
        const auto [code, output] = check(count);
        QVERIFY2(code == 0, output.constData());
        QCOMPARE(output.count(" <= optimum <= "), count);
    }

    void forgeriesAreRefused_data()
    {
        QTest::addColumn<int>("forgery");
        QTest::addColumn<int>("icebergs");
        QTest::addColumn<QString>("reason");
        for (const int n : {9, 20}) {
            const auto row = [n](const char* name, Forgery forgery, const char* reason) {
                QTest::addRow("%s, %d icebergs", name, n)
                    << static_cast<int>(forgery) << n << QString::fromLatin1(reason);
            };
            row("bound", Forgery::BoundTooHigh,
                n < 14 ? "a plan costs no more than" : "inside the graph");
            row("order", Forgery::OrderNotOptimal,
                n < 14 ? "a plan costs no more than" : "inside the graph");
            row("iceberg twice", Forgery::IcebergTwice, "is not visited once");
        }
        QTest::newRow("multipliers") << static_cast<int>(Forgery::MultipliersLost) << 40 << "WRONG";
    }
    void forgeriesAreRefused()
    {
        QFETCH(int, forgery);
        QFETCH(int, icebergs);
        QFETCH(QString, reason);
        const TvpProblem problem = test::randomProblem(7, icebergs, 1, Route::Open);
        Certificate certificate = certificateOf(problem, solved(problem));
        Proof& proof = certificate.proofs.back();
        switch (static_cast<Forgery>(forgery)) {
        case Forgery::BoundTooHigh: // for an order that is good, but not the best
            std::swap(proof.orders[0][0], proof.orders[0][1]);
            proof.cost = objective(problem, proof.orders[0]) + objectiveShift(problem);
            proof.bound = proof.bound * (1 + 1e-6);
            break;
        case Forgery::OrderNotOptimal:
            std::swap(proof.orders[0][0], proof.orders[0][1]);
            proof.cost = objective(problem, proof.orders[0]) + objectiveShift(problem);
            proof.bound = proof.cost * (1 - 1e-9);
            break;
        case Forgery::MultipliersLost:
            for (ProofStep& step : proof.steps)
                step.lambda.setZero();
            break;
        case Forgery::IcebergTwice:
            proof.orders[0][0] = proof.orders[0][1];
            break;
        }
        write(0, certificate);
        const auto [code, output] = check(1);
        QVERIFY2(code == 1 && output.contains(reason.toLatin1()), output.constData());
    }

    /** Changes in the text of a valid certificate. */
    void changedTextsAreRefused_data()
    {
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("by");
        QTest::addColumn<QString>("reason");
        const auto row = [](const char* name, const char* what, const char* by,
                            const char* reason) { QTest::newRow(name) << what << by << reason; };
        row("version", R"("version": 1)", R"("version": 2)", "an unknown version");
        row("criterion", R"("visitation")", R"("visits")", "an unknown criterion");
        row("route", R"("open")", R"("round")", "an unknown route");
        row("order", R"("orders": [[)", R"("orders": [[0.5,)", "a number that is not whole");
        row("order below 0", R"("orders": [[)", R"("orders": [[-1,)", "a number that is not whole");
        row("claim", " % of optimal", " % of optimal, or optimal", "a claim in unknown words");
        row("set", R"("sets": [)", R"("sets": [["x"],)", "a set that is no hexadecimal number");
    }
    void changedTextsAreRefused()
    {
        QFETCH(const QString, what);
        QFETCH(const QString, by);
        QFETCH(const QString, reason);
        const TvpProblem problem = test::randomProblem(7, 20, 1, Route::Open);
        Certificate certificate = certificateOf(problem, solved(problem));
        Proof& proof = certificate.proofs.back();
        proof.bound = 0.99 * proof.cost;
        proof.steps.back().sets = std::make_shared<const NgSets>(20);
        write(0, certificate);
        const auto [code, output] = check(1);
        QVERIFY2(code == 0, output.constData());
        QFile file(fileName(0));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(file.readAll());
        QVERIFY(text.contains(what));
        write(0, QString(text).replace(what, by).toStdString());
        const auto [changedCode, changedOutput] = check(1);
        QVERIFY2(changedCode == 1 && changedOutput.contains(reason.toLatin1()),
                 changedOutput.constData());
    }

private:
    static Certificate made(const QString& kind, int k)
    {
        const auto seed = static_cast<std::uint64_t>(k);
        if (kind == "small fleet" || kind == "large fleet") {
            const bool small = kind == "small fleet";
            const auto fleetKind = static_cast<test::FleetKind>(k % (small ? 5 : 4));
            return certificateOf(
                test::randomFleet(seed, 2 + k % 3, small ? 5 + k % 4 : 16 + k % 5, 1, fleetKind));
        }
        if (kind == "nasty fleet")
            return certificateOf(test::nastyFleet(10 * seed + 9, 3, 16, Criterion::Visitation));
        TvpProblem problem;
        if (kind.endsWith("latency"))
            problem =
                test::variedLatencyProblem(kind.startsWith("small") ? 4 + k % 7 : 15 + k % 8, k);
        else if (kind == "beyond")
            problem = test::randomProblem(seed, 45, 1, Route::Open);
        else
            problem = test::variedProblem(kind == "small" ? 4 + k % 8 : 15 + k % 12, 5 * k);
        if (kind == "nearly equal")
            problem = nearlyEqual(std::move(problem), seed);
        return certificateOf(problem, kind == "poor" ? sigmaOrder(problem) : solved(problem));
    }

    [[nodiscard]] QString fileName(int k) const
    {
        return m_dir.filePath(QStringLiteral("%1.json").arg(k));
    }
    void write(int k, const Certificate& certificate) const
    {
        write(k, certificateJson(certificate));
    }
    void write(int k, const std::string& text) const
    {
        QFile file(fileName(k));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QVERIFY(file.write(text.c_str()) > 0);
    }
    /** Exit code and output of the checker. */
    [[nodiscard]] std::pair<int, QByteArray> check(int count) const
    {
        QStringList files;
        for (int k = 0; k < count; ++k)
            files.append(fileName(k));
        QProcess process;
        process.start(QStringLiteral(BERG_CHECKER), files);
        process.waitForFinished(600'000);
        return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
                process.readAllStandardOutput()};
    }

    QTemporaryDir m_dir;
};

QTEST_GUILESS_MAIN(TestCertificate)
#include "tst_certificate.moc"
