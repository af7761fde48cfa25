#include "core/plan/fleet/fleet_problem.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/plan/fleet_rows.h"

#include <QtTest>

using namespace berg;

namespace {

/** 4 icebergs, of which the last is assigned to the second of 2 UAVs. */
FleetProblem withOwner()
{
    FleetProblem problem = test::randomFleet(1, 2, 4, 1);
    test::assign(problem, 4, 1);
    return problem;
}

} // namespace

class TestFleetProblem : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void objectiveByVisitingNumbers_data() { test::addFleetRows(); }
    void objectiveByVisitingNumbers()
    {
        FleetProblem problem = test::fetchedFleet(2, 3, 6);
        problem.allowed.clear();
        for (const FleetPlan& plan :
             {FleetPlan{{3, 1}, {2, 6, 4}, {5}}, FleetPlan{{}, {6, 5, 4, 3, 2, 1}, {}}})
            QVERIFY(test::sameObjective(problem, fleetObjective(problem, plan),
                                        test::fleetCostByNumbers(problem, plan)));
    }

    void oneUavIsTheProblemOfThePaper_data() { test::addFleetRows(); }
    void oneUavIsTheProblemOfThePaper()
    {
        const FleetProblem fleet = test::fetchedFleet(3, 1, 5);
        const TvpProblem alone = problemOfUav(fleet, 0);
        const VisitOrder order{4, 1, 5, 3, 2};
        QCOMPARE(fleetObjective(fleet, {order}), objective(alone, order));
        QCOMPARE(objectiveShift(fleet), objectiveShift(alone));
        QCOMPARE(fleetDistance(fleet, {order}), flownDistance(alone, order));
        QFETCH(double, tau);
        const TuningWeight weight = fleetTuningWeight(fleet, Eigen::MatrixXd::Zero(1, 1), tau);
        const TuningWeight expected = tuningWeight(alone, tau);
        constexpr double kRounding = 1e-12;
        QVERIFY(std::abs(weight.mu - expected.mu) <= kRounding * expected.mu);
        QVERIFY(std::abs(weight.dEst_m - expected.dEst_m) <= kRounding * expected.dEst_m);
        QCOMPARE(weight.f1Max_m2, expected.f1Max_m2);
    }

    /** Two starts 300 m apart, an iceberg 400 m from the first and 500 m from the second. */
    void tuningAveragesOverStartsAndIcebergs()
    {
        FleetProblem problem;
        for (const double away_m : {400.0, 500.0})
            problem.distance_m.push_back(
                (Eigen::MatrixXd(2, 2) << 0, away_m, away_m, 0).finished());
        problem.sigma_m2 = {0, 7};
        const Eigen::MatrixXd betweenStarts_m =
            (Eigen::MatrixXd(2, 2) << 0, 300, 300, 0).finished();
        const TuningWeight weight = fleetTuningWeight(problem, betweenStarts_m, 2);
        QCOMPARE(weight.f1Max_m2, 7.0); // weights 0 and 1
        QCOMPARE(weight.dEst_m, 400.0); // one leg of the mean of 300, 400, 500
        QCOMPARE(weight.mu, 2 * 7.0 / 400.0 / std::sqrt(2.0)); // of two UAVs
    }

    void recognisesFleetPlans_data()
    {
        QTest::addColumn<FleetPlan>("plan");
        QTest::addColumn<bool>("valid");
        QTest::addRow("both fly") << FleetPlan{{1, 3}, {4, 2}} << true;
        QTest::addRow("one stays") << FleetPlan{{}, {4, 2, 1, 3}} << true;
        QTest::addRow("one missing") << FleetPlan{{1}, {4, 2}} << false;
        QTest::addRow("one twice") << FleetPlan{{1, 3}, {4, 2, 1}} << false;
        QTest::addRow("one twice, one missing") << FleetPlan{{1, 1}, {4, 2}} << false;
        QTest::addRow("the start") << FleetPlan{{1, 0}, {4, 2}} << false;
        QTest::addRow("unknown iceberg") << FleetPlan{{1, 5}, {4, 2}} << false;
        QTest::addRow("no route for a UAV") << FleetPlan{{1, 3, 4, 2}} << false;
        QTest::addRow("too many routes") << FleetPlan{{1, 3}, {4, 2}, {}} << false;
        QTest::addRow("another UAV's iceberg") << FleetPlan{{1, 3, 4}, {2}} << false;
    }
    void recognisesFleetPlans()
    {
        QFETCH(FleetPlan, plan);
        QFETCH(bool, valid);
        QCOMPARE(berg::isFleetPlan(withOwner(), plan), valid);
        if (!valid)
            QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)fleetObjective(withOwner(), plan));
    }

    void validPartOfAPlan()
    {
        QCOMPARE(validPart(withOwner(), {{4, 1, 9, 1}, {3, 0, 1}}), (FleetPlan{{1}, {3}}));
        QCOMPARE(validPart(withOwner(), {{}, {4, 2}}), (FleetPlan{{}, {4, 2}}));
    }

    void faultsAreNamed()
    {
        QVERIFY(validate(withOwner()).empty());
        FleetProblem problem = withOwner();
        problem.distance_m[1](2, 3) = -1;
        problem.sigma_m2[2] = -5;
        problem.mu = std::numeric_limits<double>::quiet_NaN();
        problem.allowed[0][3] = problem.allowed[1][3] = false;
        const std::vector<Issue> issues = validate(problem);
        QCOMPARE(issues.size(), std::size_t{4});
        for (const char* field : {"uavs[1].distance_m[2][3]", "sigma[2]", "mu", "allowed[][3]"})
            QVERIFY2(test::names(issues, field), field);

        problem = withOwner();
        problem.distance_m[1] *= 1e90; // too large with mu alone
        problem.mu = 1e20;
        QCOMPARE(validate(problem).size(), std::size_t{1});
        QVERIFY(test::names(validate(problem), "mu"));

        problem = withOwner();
        problem.allowed[1].pop_back();
        QVERIFY(test::names(validate(problem), "allowed"));
        problem.allowed = {withOwner().allowed[0]};
        QVERIFY(test::names(validate(problem), "allowed"));
        problem.distance_m.clear();
        QVERIFY(test::names(validate(problem), "uavs"));
    }
};

QTEST_APPLESS_MAIN(TestFleetProblem)
#include "tst_fleet_problem.moc"
