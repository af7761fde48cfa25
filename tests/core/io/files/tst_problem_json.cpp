#include "core/io/files/problem_json.h"
#include "core/io/text/json_writer.h"
#include "core/plan/problem/tuning.h"
#include "core/plan/solve/names.h"
#include "tests/support/expect_error.h"
#include "tests/support/plan/brute_force.h"

#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

ProblemFile read(const std::string& members)
{
    return problemFromJson(R"({"format": "bergwatch-problem", "version": 1, )" + members + "}",
                           "text");
}

const std::string kSigma = R"("sigma": [0, 3, 7.5])";
const std::string kDistance = R"("distance_m": [[0, 900, 1500], [901, 0, 700], [1500, 702, 0]])";

std::string textOf(const ProblemFile& file)
{
    const TvpProblem& problem = file.problem;
    std::vector<std::string> rows;
    for (Eigen::Index i = 0; i < problem.distance_m.rows(); ++i) {
        std::vector<std::string> row;
        for (Eigen::Index j = 0; j < problem.distance_m.cols(); ++j)
            row.push_back(jsonText(i == j ? 0.0 : problem.distance_m(i, j)));
        rows.push_back(jsonArray(row));
    }
    JsonObject object;
    object.add("format", "bergwatch-problem");
    object.add("version", 1);
    object.addText("sigma", jsonArrayOf(problem.sigma_m2));
    object.addText("distance_m", jsonLines(rows, 1));
    if (file.tau)
        object.add("tau", *file.tau);
    else
        object.add("mu", problem.mu);
    object.add("route", nameOf(kRouteNames, problem.route));
    return object.inLines(0) + '\n';
}

} // namespace

class TestProblemJson : public QObject
{
    Q_OBJECT

private slots:
    void distancesMayBeAsymmetric()
    {
        const ProblemFile file = read(kSigma + ", " + kDistance);
        const Eigen::MatrixXd& d_m = file.problem.distance_m;
        QCOMPARE(d_m.rows(), Eigen::Index{3});
        QCOMPARE(d_m(0, 1), 900.0); // row = from
        QCOMPARE(d_m(1, 0), 901.0);
        QCOMPARE(d_m(1, 2), 700.0);
        QCOMPARE(d_m(2, 1), 702.0);
        QVERIFY(file.problem.sigma_m2 == std::vector<double>({0, 3, 7.5}));
        QVERIFY(file.problem.route == Route::Open);
    }

    void diagonalIsIgnored()
    {
        const ProblemFile file = read(
            kSigma + R"(, "distance_m": [[-1, 900, 1500], [900, null, 700], [1500, 700, "x"]])");
        QVERIFY(file.problem.distance_m.diagonal().isZero(0));
    }

    void positionsGiveEuclideanDistances()
    {
        const ProblemFile file = read(kSigma + R"(, "position_m": [[0, 0], [300, 400], [0, -12]])");
        const Eigen::MatrixXd& d_m = file.problem.distance_m;
        QCOMPARE(d_m(0, 1), 500.0);
        QCOMPARE(d_m(2, 0), 12.0);
        QCOMPARE(d_m(1, 2), std::hypot(300.0, 412.0));
        QCOMPARE(d_m(2, 1), d_m(1, 2));
    }

    void muFollowsFromTau_data()
    {
        QTest::addColumn<QByteArray>("members");
        QTest::addColumn<double>("tau"); // −1 means no tau
        QTest::addColumn<double>("mu");
        // Eq. (10)-(14): F1max = 0*0 + 1*3 + 2*7.5 = 18, D_est = 2 * mean distance.
        const double mean_m = (900 + 1500 + 901 + 700 + 1500 + 702) / 6.0;
        const double muAt1 = 18 / (2 * mean_m);
        QTest::newRow("nothing: tau is 1") << QByteArray() << 1.0 << muAt1;
        QTest::newRow("tau") << QByteArray(R"(, "tau": 0.5)") << 0.5 << 0.5 * muAt1;
        QTest::newRow("tau 0") << QByteArray(R"(, "tau": 0)") << 0.0 << 0.0;
        QTest::newRow("mu") << QByteArray(R"(, "mu": 0.25)") << -1.0 << 0.25;
        QTest::newRow("mu 0") << QByteArray(R"(, "mu": 0)") << -1.0 << 0.0;
    }
    void muFollowsFromTau()
    {
        QFETCH(const QByteArray, members);
        QFETCH(const double, tau);
        QFETCH(const double, mu);
        const ProblemFile file = read(kSigma + ", " + kDistance + members.toStdString());
        QCOMPARE(file.tau.value_or(-1), tau);
        // A few roundings of sums of six numbers.
        QVERIFY(std::abs(file.problem.mu - mu) <= 1e-14);
    }

    void problemWithoutIcebergsIsValid()
    {
        const ProblemFile file = read(R"("sigma": [0], "distance_m": [[0]])");
        QCOMPARE(file.problem.icebergCount(), 0);
        QCOMPARE(file.problem.mu, 0.0);
    }

    void closedRouteIsRead()
    {
        QVERIFY(read(kSigma + ", " + kDistance + R"(, "route": "closed")").problem.route ==
                Route::Closed);
    }

    void unknownMembersAreIgnored()
    {
        QVERIFY(read(kSigma + ", " + kDistance + R"(, "comment": {"by": [1]})")
                    .problem.distance_m.allFinite());
    }

    void tooManyNodesAreRejected()
    {
        const auto text = [](int nodes) {
            std::string sigma = "0";
            std::string position = "[0, 0]";
            for (int i = 1; i < nodes; ++i) {
                sigma += ", 1";
                position += ", [" + std::to_string(i) + ", 0]";
            }
            return R"("sigma": [)" + sigma + R"(], "position_m": [)" + position + "]";
        };
        QCOMPARE(read(text(1000)).problem.nodeCount(), 1000);
        const std::optional<Error> error = errorOf([&] { (void)read(text(1001)); });
        QVERIFY(error);
        QCOMPARE(error->issues().size(), std::size_t{1});
        QVERIFY(names(error->issues(), "sigma"));
    }

    void everyFaultIsNamed()
    {
        const std::optional<Error> error = errorOf([] {
            (void)read(R"("sigma": [1, -3, 7.5], "tau": 200, "route": 1,
                          "distance_m": [[0, 900, 1500], [900, 0], [1500, "x", 0]])");
        });
        QVERIFY(error);
        QCOMPARE(codeName(error->code()), std::string("InvalidInput"));
        QCOMPARE(error->issues().size(), std::size_t{6});
        for (const char* field :
             {"sigma[0]", "sigma[1]", "distance_m[1]", "distance_m[2][1]", "tau", "route"})
            QVERIFY2(names(error->issues(), field), field);
    }

    void writtenProblemIsReadBack_data()
    {
        QTest::addColumn<int>("icebergs");
        QTest::addColumn<bool>("closed");
        QTest::addColumn<bool>("withTau");
        QTest::newRow("open, tau") << 6 << false << true;
        QTest::newRow("closed, mu") << 5 << true << false;
        QTest::newRow("UAV alone") << 0 << false << true;
        QTest::newRow("many") << 60 << false << false;
    }
    void writtenProblemIsReadBack()
    {
        QFETCH(const int, icebergs);
        QFETCH(const bool, closed);
        QFETCH(const bool, withTau);
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            ProblemFile file;
            file.problem =
                randomProblem(seed, icebergs, 0.7, closed ? Route::Closed : Route::Open, true);
            file.problem.distance_m.diagonal().setZero();
            if (withTau)
                file.tau = 0.7;
            file.problem.mu = tuningWeight(file.problem, 0.7).mu;
            const std::string text = textOf(file);
            const ProblemFile again = problemFromJson(text, "text");
            QVERIFY(again.problem.distance_m == file.problem.distance_m);
            QVERIFY(again.problem.sigma_m2 == file.problem.sigma_m2);
            QVERIFY(again.problem.route == file.problem.route);
            QCOMPARE(again.problem.mu, file.problem.mu);
            QCOMPARE(again.tau.has_value(), withTau);
            QCOMPARE(textOf(again), text);
        }
    }

    void fileIsLoaded()
    {
        const ProblemFile file = loadProblem(BERG_TEST_DATA "/scenarios/small-problem.json");
        QCOMPARE(file.tau.value_or(-1), 0.5);
        QCOMPARE(file.problem.distance_m(0, 2), 1500.0);
    }
};

QTEST_APPLESS_MAIN(TestProblemJson)
#include "tst_problem_json.moc"
