#include "core/presets/presets.h"
#include "tests/support/window/ids.h"
#include "tests/support/window/patience.h"
#include "widgets/workspace/workspace.h"

#include <QSignalSpy>
#include <QUndoStack>
#include <QtTest>

using namespace berg;
using namespace Qt::StringLiterals;
using test::Ids;
using test::kPatience_ms;

namespace {

Scenario small(std::int64_t seed = 41)
{
    return randomScenario(seed, {.icebergs = 4});
}

bool until(const std::function<bool()>& condition)
{
    return QTest::qWaitFor(condition, kPatience_ms);
}

/** Waits for the phase of the present scenario's mission, not of an earlier one. */
bool untilPhase(Workspace& workspace, RunPhase phase)
{
    return until([&] {
        return workspace.record().now.phase == phase &&
               workspace.record().now.generation == workspace.runner().generation();
    });
}

/** Flies the first second. */
bool takeOff(Workspace& workspace)
{
    workspace.step();
    return until([&] { return workspace.inFlight(); });
}

} // namespace

class TestWorkspace : public QObject
{
    Q_OBJECT

private slots:
    /** Before take-off a change of the planner is an edit: undoable, and planned at once. */
    void beforeTakeOffChangesAreEdits()
    {
        Workspace workspace;
        workspace.document().reset(small());
        workspace.setTau(2.5);
        workspace.setPolicy(PolicyKind::Tour);
        workspace.setBackend(Backend::Heuristic);
        workspace.setRoute(Route::Closed);
        QCOMPARE(workspace.document().undoStack()->count(), 4);
        const PlannerSettings wanted{.policy = PolicyKind::Tour,
                                     .tau = 2.5,
                                     .route = Route::Closed,
                                     .backend = Backend::Heuristic};
        QVERIFY(workspace.document().scenario().planner == wanted);
        QVERIFY(workspace.planner() == wanted);
        QVERIFY(untilPhase(workspace, RunPhase::Ready));
        QVERIFY(workspace.record().now.planner == wanted);
        while (workspace.document().undoStack()->canUndo())
            workspace.document().undoStack()->undo();
        QVERIFY(workspace.document().scenario() == small());
        QVERIFY(untilPhase(workspace, RunPhase::Ready));
        QVERIFY(workspace.record().now.planner == small().planner);
    }

    void rowOfTausIsOneEdit()
    {
        Workspace workspace;
        workspace.document().reset(small());
        for (int i = 0; i < 10; ++i)
            workspace.setTau(0.1 * i);
        QCOMPARE(workspace.document().undoStack()->count(), 1);
        workspace.document().endGesture();
        workspace.setTau(3);
        QCOMPARE(workspace.document().undoStack()->count(), 2);
    }

    /** In flight the scenario does not change; the mission does, at least with the last value. */
    void inFlightChangesAreInterventions()
    {
        Workspace workspace;
        workspace.document().reset(small());
        QVERIFY(takeOff(workspace));
        for (int i = 1; i <= 30; ++i)
            workspace.setTau(0.1 * i);
        QVERIFY(until([&] { return workspace.planner().tau == 0.1 * 30; }));
        workspace.setPolicy(PolicyKind::Nearest);
        QVERIFY(until([&] { return workspace.planner().policy == PolicyKind::Nearest; }));
        QCOMPARE(workspace.planner().tau, 0.1 * 30);
        QVERIFY(workspace.document().scenario() == small());
        QCOMPARE(workspace.document().undoStack()->count(), 0);
        workspace.reset();
        QVERIFY(workspace.planner() == small().planner);
        QVERIFY(untilPhase(workspace, RunPhase::Ready));
        QVERIFY(workspace.record().now.planner == small().planner);
    }

    /** A tau requested before the flight continues is in force when it does. */
    void tauComesBeforeTheNextStep()
    {
        Workspace workspace;
        workspace.document().reset(small());
        QVERIFY(takeOff(workspace));
        workspace.setTau(0.5);
        workspace.setTau(4.5);
        workspace.fly(kFastestRate);
        QVERIFY(untilPhase(workspace, RunPhase::Finished));
        QCOMPARE(workspace.planner().tau, 4.5);
    }

    /** The newest of each kind of waiting change takes effect. */
    void changesOfEveryKindAreJoined()
    {
        Workspace workspace;
        Scenario scenario = small();
        scenario.asset = Asset{.name = "Ship", .position_m = {1000, 0}, .velocity_mps = {3, 4}};
        workspace.document().reset(scenario);
        QVERIFY(takeOff(workspace));
        const double time_s = workspace.record().now.time_s;
        workspace.setWind({1, 1});
        workspace.setWind({-4, 2});
        workspace.moveAsset({500, 600});
        workspace.setTau(2.5);
        QVERIFY(until([&] { return workspace.planner().tau == 2.5; }));
        QVERIFY(workspace.wind_mps() == Point(-4, 2));
        const std::optional<Asset>& asset = workspace.record().now.asset;
        QVERIFY((asset->position_m - (Point(500, 600) - Point(3, 4) * time_s)).norm() < 1e-9);
        QVERIFY(asset->velocity_mps == Point(3, 4));
        QVERIFY(workspace.document().scenario() == scenario);
        for (const Intervention& change : workspace.record().now.worldChanges)
            QVERIFY(!change.tau);
    }

    /** An assignment is an edit before take-off and an intervention in flight; plans obey it. */
    void icebergsAreAssigned()
    {
        Scenario scenario = small();
        scenario.uavs.push_back(scenario.uavs.front());
        scenario.uavs[1].id = "uav-2";
        scenario.uavs[1].position_m += Point(2000, 500);
        Workspace workspace;
        workspace.document().reset(scenario);
        const std::string first = scenario.icebergs[0].id;
        const std::string second = scenario.icebergs[1].id;
        workspace.assign({first}, "uav-2");
        workspace.assign({first, "no iceberg"}, "uav-2"); // as it is
        QCOMPARE(workspace.document().undoStack()->count(), 1);
        QCOMPARE(workspace.assignedUavOf(first), "uav-2");
        QVERIFY(untilPhase(workspace, RunPhase::Ready));
        QCOMPARE(workspace.record().now.assigned[0], std::optional(1));
        workspace.document().undoStack()->undo();
        QVERIFY(workspace.document().scenario() == scenario);
        QVERIFY(untilPhase(workspace, RunPhase::Ready));
        QVERIFY(takeOff(workspace));
        workspace.assign({first, second}, "uav-2");
        QVERIFY(until([&] { return workspace.assignedUavOf(second) == "uav-2"; }));
        QCOMPARE(workspace.assignedUavOf(first), "uav-2"); // the later one has not taken its place
        QVERIFY(workspace.document().scenario() == scenario);
        const OrdersByUav orders = ordersOf(workspace.record().now);
        for (const IcebergIndex iceberg : orders[0])
            QVERIFY(iceberg > 1);
        workspace.assign({first}, {});
        QVERIFY(until([&] { return workspace.assignedUavOf(first).empty(); }));
    }

    /** Before take-off there is no flight to change. */
    void onlyAFlightAcceptsInterventions()
    {
        Workspace workspace;
        Scenario scenario = small();
        scenario.asset = Asset{.position_m = {1000, 0}};
        workspace.document().reset(scenario);
        QVERIFY(untilPhase(workspace, RunPhase::Ready));
        QVERIFY(!workspace.mayIntervene());
        workspace.moveAsset({0, 0});
        workspace.addIceberg({});
        QVERIFY(workspace.document().scenario() == scenario);
        workspace.setWind({3, 0}); // an edit
        QCOMPARE(workspace.document().undoStack()->count(), 1);
        QVERIFY(workspace.wind_mps() == Point(3, 0));
        QVERIFY(takeOff(workspace));
        QVERIFY(workspace.mayIntervene());
        workspace.seek(0);
        QVERIFY(!workspace.mayIntervene());
    }

    void afterTheEndChangesAreRefused()
    {
        Workspace workspace;
        workspace.document().reset(small());
        workspace.fly(kFastestRate);
        QVERIFY(untilPhase(workspace, RunPhase::Finished));
        QSignalSpy refused(&workspace, &Workspace::refused);
        const double zeta_m2s = workspace.record().now.metrics.zeta_m2s;
        workspace.setTau(4);
        QVERIFY(until([&] { return refused.count() == 1; }));
        QCOMPARE(workspace.planner().tau, small().planner.tau);
        QCOMPARE(workspace.record().now.metrics.zeta_m2s, zeta_m2s);
    }

    void selectionStaysAfterUnrelatedEdits()
    {
        Workspace workspace;
        workspace.document().reset(small());
        workspace.selection().set({"berg-2", "berg-3"});
        workspace.setTau(2);
        QCOMPARE(workspace.selection().ids(), Ids({"berg-2", "berg-3"}));
        workspace.document().edit(u"Delete"_s,
                                  [](Scenario& s) { s.icebergs.erase(s.icebergs.begin() + 1); });
        QCOMPARE(workspace.selection().ids(), Ids{"berg-3"});
        QVERIFY(takeOff(workspace));
        workspace.reset();
        QCOMPARE(workspace.selection().ids(), Ids{"berg-3"});
        workspace.document().reset(small(42)); // its icebergs have the same ids
        QVERIFY(workspace.selection().isEmpty());
    }

    void anotherScenarioEndsTheFlight()
    {
        Workspace workspace;
        workspace.document().reset(small());
        QVERIFY(takeOff(workspace));
        QSignalSpy inFlight(&workspace, &Workspace::inFlightChanged);
        workspace.document().reset(small(42));
        QCOMPARE(inFlight.count(), 1);
        QCOMPARE(inFlight.front().front().toBool(), false);
        QVERIFY(!workspace.inFlight());
        QVERIFY(workspace.record().history.samples.empty());
        QVERIFY(workspace.record().scenario == small(42));
        QVERIFY(untilPhase(workspace, RunPhase::Ready));
        QCOMPARE(workspace.record().now.time_s, 0.0);
        QCOMPARE(workspace.record().history.samples.size(), std::size_t{1});
    }

    /** Late snapshots of an ended flight do not restore it. */
    void resetInFullFlight()
    {
        Workspace workspace;
        workspace.document().reset(small());
        workspace.fly(1000);
        QVERIFY(until([&] { return workspace.record().now.time_s > 20; }));
        workspace.reset();
        QSignalSpy inFlight(&workspace, &Workspace::inFlightChanged);
        QVERIFY(untilPhase(workspace, RunPhase::Ready));
        QTest::qWait(100);
        QCOMPARE(inFlight.count(), 0);
        QCOMPARE(workspace.record().now.phase, RunPhase::Ready);
        QCOMPARE(workspace.record().now.time_s, 0.0);
    }

    void takeOffAndResetAreEmittedOnce()
    {
        Workspace workspace;
        workspace.document().reset(small());
        QSignalSpy inFlight(&workspace, &Workspace::inFlightChanged);
        QVERIFY(takeOff(workspace));
        workspace.step();
        workspace.fly(kFastestRate);
        QVERIFY(untilPhase(workspace, RunPhase::Finished));
        workspace.fly(kFastestRate); // at the end: nothing to fly
        workspace.reset();
        workspace.reset();
        QVERIFY(untilPhase(workspace, RunPhase::Ready));
        QCOMPARE(inFlight.count(), 2);
        QCOMPARE(inFlight[0].front().toBool(), true);
        QCOMPARE(inFlight[1].front().toBool(), false);
    }

    void faultyScenarioIsNeitherFlownNorLocked()
    {
        Workspace workspace;
        Scenario faulty = small();
        faulty.icebergs[0].q_m2ps = -1;
        workspace.document().reset(faulty);
        workspace.fly(kFastestRate);
        QVERIFY(untilPhase(workspace, RunPhase::Failed));
        QVERIFY(!workspace.inFlight());
        QSignalSpy refused(&workspace, &Workspace::refused);
        workspace.runner().requestRun();
        workspace.runner().requestExport({.formatId = "csv"});
        QVERIFY(until([&] { return refused.count() == 2; }));
        workspace.document().edit(u"Mend"_s, [](Scenario& s) { s.icebergs[0].q_m2ps = 0.1; });
        QVERIFY(untilPhase(workspace, RunPhase::Ready));
        QVERIFY(!workspace.record().now.error.has_value());
    }

    /** The rate changes the current flight and starts none. */
    void rateStartsNoFlight()
    {
        Workspace workspace;
        workspace.document().reset(small());
        QVERIFY(untilPhase(workspace, RunPhase::Ready));
        workspace.setRate(kFastestRate);
        QTest::qWait(100);
        QCOMPARE(workspace.record().now.phase, RunPhase::Ready);
        workspace.fly(1);
        QVERIFY(untilPhase(workspace, RunPhase::Flying));
        workspace.setRate(kFastestRate);
        QVERIFY(untilPhase(workspace, RunPhase::Finished));
    }

    void historyIsWhole()
    {
        Workspace workspace;
        workspace.document().reset(small());
        workspace.fly(300);
        QVERIFY(untilPhase(workspace, RunPhase::Finished));
        const FlightRecord& record = workspace.record();
        QCOMPARE(record.history.samples.size(), std::size_t{1001}); // each second, both ends
        QCOMPARE(record.history.rows.size(), record.history.samples.size());
        for (std::size_t i = 0; i < record.history.samples.size(); ++i)
            QCOMPARE(qRound(record.history.samples[i].time_s), static_cast<int>(i));
    }

    /** Nothing is delivered after destruction. */
    void destructionEndsAllWork()
    {
        auto workspace = std::make_unique<Workspace>();
        workspace->document().reset(small());
        workspace->fly(1000);
        QVERIFY(until([&] { return workspace->record().now.time_s > 5; }));
        workspace->setTau(3);
        workspace->setTau(4);
        workspace->runner().requestRun();
        workspace->runner().requestExport({.formatId = "csv"});
        QSignalSpy changed(workspace.get(), &Workspace::flightChanged);
        workspace.reset();
        const auto reported = changed.count();
        QTest::qWait(50);
        QCOMPARE(changed.count(), reported);
    }
};

QTEST_MAIN(TestWorkspace)
#include "tst_workspace.moc"
