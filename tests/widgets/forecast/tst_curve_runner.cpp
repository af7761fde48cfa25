#include "core/base/solving_guard.h"
#include "core/mission/plan_requests.h"
#include "core/presets/presets.h"
#include "core/sim/simulation.h"
#include "tests/support/flight/fleet_flight.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "widgets/forecast/curve_runner.h"

#include <QPointer>
#include <QSignalSpy>

using namespace berg;
using test::kPatience_ms;

namespace {

TauCurve expectedCurve(const Scenario& scenario)
{
    const FleetTask task =
        visitationTask(planRequest(Simulation(scenario)), scenario.planner.route);
    return tauCurve(task.problem, task.betweenStarts_m, {});
}

bool completes(const CurveRunner& runner)
{
    return QTest::qWaitFor([&] { return runner.curve().complete; }, kPatience_ms);
}

} // namespace

class TestCurveRunner : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void computesTheCurve()
    {
        const Scenario scenario = randomScenario(3);
        const TauCurve expected = expectedCurve(scenario);
        const NoBlockingScope onThisThread; // a solve here would throw
        CurveRunner runner;
        QVERIFY(runner.curve().complete); // nothing was requested
        QSignalSpy updated(&runner, &CurveRunner::updated);
        runner.setScenario(scenario);
        QVERIFY(!runner.curve().complete);
        QCOMPARE(updated.count(), 1); // the old curve is dropped at once
        QVERIFY(completes(runner));
        QVERIFY(updated.count() >= 2);
        QVERIFY(runner.curve() == expected);
        QCOMPARE(runner.problem().ids.size(), runner.curve().intervals.front().order().size());
    }

    /** Changes that do not affect the curve neither restart nor drop it. */
    void otherEditsDoNotRestart_data()
    {
        QTest::addColumn<int>("edit");
        QTest::newRow("tau") << 0;
        QTest::newRow("policy") << 1;
        QTest::newRow("name") << 2;
        QTest::newRow("duration") << 3;
    }

    void otherEditsDoNotRestart()
    {
        QFETCH(int, edit);
        Scenario scenario = randomScenario(4);
        CurveRunner runner;
        runner.setScenario(scenario);
        QVERIFY(completes(runner));
        QSignalSpy updated(&runner, &CurveRunner::updated);
        if (edit == 0)
            scenario.planner.tau = 2.5;
        else if (edit == 1)
            scenario.planner.policy = PolicyKind::Nearest;
        else if (edit == 2)
            scenario.name = "another";
        else
            scenario.duration_s *= 2;
        const TauCurve before = runner.curve();
        runner.setScenario(scenario);
        QVERIFY(runner.curve() == before);
        QCOMPARE(updated.count(), 0);
    }

    void editsThatMatterRestart_data()
    {
        QTest::addColumn<int>("edit");
        QTest::newRow("position") << 0;
        QTest::newRow("sigma") << 1;
        QTest::newRow("route") << 2;
        QTest::newRow("wind") << 3;
        QTest::newRow("one less") << 4;
    }

    void editsThatMatterRestart()
    {
        QFETCH(int, edit);
        Scenario scenario = randomScenario(5);
        CurveRunner runner;
        runner.setScenario(scenario);
        QVERIFY(completes(runner));
        if (edit == 0)
            scenario.icebergs[1].position_m += Point(500, 0);
        else if (edit == 1)
            scenario.icebergs[1].sigma0_m2 += 1;
        else if (edit == 2)
            scenario.planner.route = Route::Closed;
        else if (edit == 3)
            scenario.wind_mps = {4, 4};
        else
            scenario.icebergs.pop_back();
        runner.setScenario(scenario);
        QVERIFY(!runner.curve().complete);
        QVERIFY(runner.curve().intervals.empty());
        QVERIFY(completes(runner));
        QVERIFY(runner.curve() == expectedCurve(scenario));
    }

    void newestRequestWins()
    {
        CurveRunner runner;
        Scenario scenario = randomScenario(6);
        for (int i = 0; i < 50; ++i) {
            scenario.icebergs[0].position_m.x() += 10;
            runner.setScenario(scenario);
        }
        QVERIFY(completes(runner));
        QVERIFY(runner.curve() == expectedCurve(scenario));
    }

    /** A large problem is in progress: none of its results is shown afterwards. */
    void oldCurvesAreNotReturned()
    {
        CurveRunner runner;
        runner.setScenario(randomScenario(7, {.icebergs = 60, .size_m = {40000, 40000}}));
        QVERIFY(QTest::qWaitFor([&] { return !runner.curve().intervals.empty(); }, kPatience_ms));
        QVERIFY(!runner.curve().complete); // partial curves come first
        const Scenario small = randomScenario(8);
        runner.setScenario(small);
        bool stale = false;
        connect(&runner, &CurveRunner::updated, this, [&] {
            for (const CurveInterval& interval : runner.curve().intervals)
                stale = stale || interval.order().size() != runner.problem().ids.size();
        });
        QVERIFY(completes(runner));
        QVERIFY(!stale);
        QVERIFY(runner.curve() == expectedCurve(small));
    }

    void brokenScenariosHaveNone()
    {
        CurveRunner runner;
        Scenario scenario = randomScenario(9);
        runner.setScenario(scenario);
        QVERIFY(completes(runner));
        scenario.icebergs[0].q_m2ps = -1;
        runner.setScenario(scenario);
        QVERIFY(runner.curve().complete);
        QVERIFY(runner.curve().intervals.empty());
        runner.setScenario(randomScenario(9)); // corrected
        QVERIFY(completes(runner));
        QVERIFY(!runner.curve().intervals.empty());
        runner.clear();
        QVERIFY(runner.curve().intervals.empty());
    }

    /** A mission in flight requests the curve of its own state. */
    void takesAnyProblem()
    {
        CurveRunner runner;
        PlanRequest request = planRequest(Simulation(randomScenario(10)));
        request.sigma_m2[2] = 99;
        runner.setRequest(std::make_shared<const PlanRequest>(request), Route::Open);
        QVERIFY(completes(runner));
        QVERIFY(runner.curve() == tauCurve(visitationTask(request, Route::Open).problem, {}, {}));
    }

    /** Fleets have a curve at the start and in flight. */
    void severalUavsHaveOne()
    {
        const Scenario two = test::withUavs(randomScenario(10, {.icebergs = 6}), 2);
        CurveRunner runner;
        runner.setScenario(two);
        QVERIFY(completes(runner));
        QVERIFY(runner.curve() == expectedCurve(two));
        QCOMPARE(runner.curve().intervals.front().plan.size(), std::size_t{2});
        PlanRequest request = planRequest(Simulation(two));
        request.sigma_m2[2] = 99;
        runner.setRequest(std::make_shared<const PlanRequest>(request), Route::Open);
        QVERIFY(!runner.curve().complete);
        QVERIFY(completes(runner));
        QVERIFY(runner.curve() != expectedCurve(two));
    }

    /** Closing does not wait for proofs: the stop token ends them. */
    void closesDuringAComputation()
    {
        auto runner = std::make_unique<CurveRunner>();
        runner->setScenario(randomScenario(11, {.icebergs = 60, .size_m = {40000, 40000}}));
        QVERIFY(QTest::qWaitFor([&] { return !runner->curve().intervals.empty(); }, kPatience_ms));
        const QPointer<CurveRunner> watched = runner.get();
        runner.reset(); // waits for the thread
        QVERIFY(watched.isNull());
    }

    void closesBeforeItBegins()
    {
        CurveRunner runner;
        runner.setScenario(randomScenario(12));
    }
};

QTEST_MAIN(TestCurveRunner)
#include "tst_curve_runner.moc"
