#include "core/plan/problem/tuning.h"
#include "tests/support/approx.h"

#include <QtTest>

using namespace berg;

namespace {

/** N = 4: sorted sigma 0, 2, 3, 5; the twelve distances sum to 258 m. */
TvpProblem handProblem()
{
    TvpProblem problem{
        .distance_m = Eigen::MatrixXd(4, 4), .sigma_m2 = {0, 2, 5, 3}, .mu = 0, .route = {}};
    problem.distance_m << 0, 10, 20, 30, //
        11, 0, 12, 13,                   //
        21, 22, 0, 23,                   //
        31, 32, 33, 0;
    return problem;
}

constexpr double kF1Max_m2 = 0 * 0 + 1 * 2 + 2 * 3 + 3 * 5; // Eq. (10): 23
constexpr double kDEst_m = 258.0 / 12 * 3;                  // Eq. (11), (12): 64.5

} // namespace

class TestTuning : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void followsTheRule_data()
    {
        QTest::addColumn<double>("tau");
        for (const double tau : {0.0, 0.5, 1.0, 3.0, 100.0})
            QTest::addRow("tau %g", tau) << tau;
    }

    void followsTheRule()
    {
        QFETCH(double, tau);
        for (const Route route : {Route::Open, Route::Closed}) {
            TvpProblem problem = handProblem();
            problem.route = route; // D_est is the same for both
            const TuningWeight weight = tuningWeight(problem, tau);
            QCOMPARE(weight.f1Max_m2, kF1Max_m2);
            QCOMPARE(weight.dEst_m, kDEst_m);
            COMPARE_NEAR(weight.mu, tau * 23 / 64.5, 1e-15 * (1 + tau)); // one rounding or two
            QVERIFY(!weight.distanceOnly);
        }
    }

    /** At tau = 1, Eq. (13) balances the two terms: mu D_est = F1max. */
    void balancesTheTermsAtTauOne()
    {
        const TuningWeight weight = tuningWeight(handProblem(), 1);
        COMPARE_NEAR(weight.mu * weight.dEst_m, weight.f1Max_m2, 1e-14);
    }

    void ignoresTheDiagonal()
    {
        TvpProblem problem = handProblem();
        problem.distance_m.diagonal().setConstant(1e6);
        QCOMPARE(tuningWeight(problem, 1).dEst_m, kDEst_m);
    }

    void allSigmaZeroPlansByDistance()
    {
        TvpProblem problem = handProblem();
        problem.sigma_m2 = {0, 0, 0, 0};
        for (const double tau : {0.0, 1.0}) {
            const TuningWeight weight = tuningWeight(problem, tau);
            QVERIFY(weight.distanceOnly);
            QCOMPARE(weight.mu, 1.0);
            QCOMPARE(weight.f1Max_m2, 0.0);
        }
    }

    void coincidentNodesHaveNoDistanceTerm()
    {
        TvpProblem problem = handProblem();
        problem.distance_m.setZero();
        const TuningWeight weight = tuningWeight(problem, 1);
        QCOMPARE(weight.dEst_m, 0.0);
        QCOMPARE(weight.mu, 0.0);
        QVERIFY(!weight.distanceOnly);
    }

    void uavAloneHasNothingToWeigh()
    {
        const TvpProblem problem{
            .distance_m = Eigen::MatrixXd::Zero(1, 1), .sigma_m2 = {0}, .mu = 0, .route = {}};
        const TuningWeight weight = tuningWeight(problem, 1);
        QCOMPARE(weight.mu, 0.0);
        QCOMPARE(weight.f1Max_m2, 0.0);
        QCOMPARE(weight.dEst_m, 0.0);
        QVERIFY(!weight.distanceOnly);
    }

    /** With one iceberg F1max = sigma and D_est = mean of both directions. */
    void oneIcebergByHand()
    {
        TvpProblem problem{
            .distance_m = Eigen::MatrixXd(2, 2), .sigma_m2 = {0, 4}, .mu = 0, .route = {}};
        problem.distance_m << 0, 100, 60, 0;
        const TuningWeight weight = tuningWeight(problem, 2);
        QCOMPARE(weight.f1Max_m2, 4.0);
        QCOMPARE(weight.dEst_m, 80.0);
        COMPARE_NEAR(weight.mu, 0.1, 1e-16);
    }
};

QTEST_APPLESS_MAIN(TestTuning)
#include "tst_tuning.moc"
