#include "core/presets/presets.h"
#include "tests/support/files/file_texts.h"
#include "widgets/workspace/workspace.h"

#include <QSignalSpy>
#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** A workspace that has flown 300 s of a scenario of 8 icebergs and is paused. */
struct Flight
{
    Workspace workspace;

    Flight()
    {
        Scenario scenario = randomScenario(3, {.icebergs = 8});
        scenario.duration_s = 600;
        workspace.document().reset(scenario);
        static_cast<void>(until([this] { return record().now.phase == RunPhase::Ready; }));
        workspace.runner().stepBy(150);
        workspace.runner().intervene({.tau = 0.2});
        workspace.runner().stepBy(150);
        if (!until([this] { return std::abs(record().now.time_s - 300) < 1e-6; }))
            qFatal("the flight does not get there");
    }

    [[nodiscard]] const FlightRecord& record() const { return workspace.record(); }

    template <class Condition>
    [[nodiscard]] bool until(const Condition& condition)
    {
        return QTest::qWaitFor(condition, 10'000);
    }
    [[nodiscard]] bool untilShown(double time_s)
    {
        return until([&] { return std::abs(record().shown().time_s - time_s) < 1e-6; });
    }
};

/** Returns the same flight without a window, until `time_s`. */
Mission flownAlone(const Scenario& scenario, double time_s)
{
    Mission mission(scenario);
    mission.advance(std::min(time_s, 150.0));
    if (time_s >= 150)
        mission.intervene({.tau = 0.2});
    mission.advance(time_s);
    return mission;
}

} // namespace

/** Moving through the flown part, and continuing from there. */
class TestLookBack : public QObject
{
    Q_OBJECT

private slots:
    void instantsEqualTheFlight()
    {
        Flight f;
        const Scenario scenario = f.workspace.document().scenario();
        for (const double time_s : {10.0, 123.4, 0.0, 299.9, 150.0, 149.9}) {
            f.workspace.seek(time_s);
            QVERIFY(f.untilShown(time_s));
            const Mission then = flownAlone(scenario, time_s);
            const MissionSnapshot& shown = f.record().shown();
            QVERIFY(shown.world == then.simulation().state());
            QVERIFY(shown.metrics == then.metrics());
            QCOMPARE(shown.planner.tau, then.plannerSettings().tau);
            QCOMPARE(f.workspace.planner().tau, then.plannerSettings().tau);
            QCOMPARE(shown.plan->uavs[0].order, then.plans().back()->uavs[0].order);
            QCOMPARE(f.record().eventsShown(), then.events().size());
        }
        QCOMPARE(f.record().now.time_s, 300.0); // the flight itself stays where it was
        f.workspace.seekLatest();
        QVERIFY(!f.record().instant.has_value());
    }

    /** The curve belongs to the plan shown, whose order it contains. */
    void curveIsOfThePlanShown()
    {
        Flight f;
        CurveRunner& curve = f.workspace.curve();
        const auto holdsThePlan = [&] {
            const std::optional<int> at = intervalAt(curve.curve(), f.record().shown().planner.tau);
            if (!curve.curve().complete || !at)
                return false;
            IcebergList order;
            for (const NodeIndex node :
                 curve.curve().intervals[static_cast<std::size_t>(*at)].order())
                order.push_back(icebergOf(curve.problem().ids, node));
            return order == f.record().shown().plan->uavs[0].order;
        };
        for (const double time_s : {5.0, 120.0, 250.0}) {
            f.workspace.seek(time_s);
            QVERIFY(f.untilShown(time_s));
            QVERIFY(f.until(holdsThePlan));
        }
        f.workspace.seekLatest();
        QVERIFY(f.until(holdsThePlan));
    }

    void atItsEndTheNewestIsShown()
    {
        Flight f;
        f.workspace.seek(100);
        QVERIFY(f.untilShown(100));
        f.workspace.seek(300);
        QVERIFY(!f.record().instant.has_value());
        QVERIFY(!f.workspace.lookedAt_s().has_value());
    }

    void flyingIsPausedToLookBack()
    {
        Flight f;
        f.workspace.fly(50);
        QVERIFY(f.until([&] { return f.record().now.phase == RunPhase::Flying; }));
        f.workspace.seek(20);
        QVERIFY(f.untilShown(20));
        QVERIFY(f.until([&] { return f.record().now.phase == RunPhase::Paused; }));
        QVERIFY(!f.workspace.isPlaying());
    }

    void beforeTakeOffThereIsNothingToLookAt()
    {
        Workspace workspace;
        workspace.document().reset(randomScenario(4, {.icebergs = 3}));
        QVERIFY(QTest::qWaitFor([&] { return workspace.record().now.phase == RunPhase::Ready; },
                                10'000));
        workspace.seek(10);
        QVERIFY(!workspace.lookedAt_s().has_value());
    }

    void stepsThroughTheRecord()
    {
        Flight f;
        f.workspace.stepBack();
        QVERIFY(f.untilShown(299));
        f.workspace.stepTicks(-1);
        QVERIFY(f.untilShown(298.9));
        f.workspace.stepTicks(+1);
        QVERIFY(f.untilShown(299));
        f.workspace.step();
        QVERIFY(f.untilShown(300));
        QVERIFY(!f.record().instant.has_value());
        f.workspace.stepTicks(+1); // beyond the end it is flown
        QVERIFY(f.until([&] { return std::abs(f.record().now.time_s - 300.1) < 1e-6; }));
    }

    void eventsBothWays()
    {
        Flight f;
        f.workspace.seek(140);
        QVERIFY(f.untilShown(140));
        std::vector<double> times_s;
        for (const MissionEvent& event : f.record().history.events)
            if (times_s.empty() || event.time_s > times_s.back())
                times_s.push_back(event.time_s);
        const auto next = std::upper_bound(times_s.begin(), times_s.end(), 140.0);
        QVERIFY(next != times_s.end() && next != times_s.begin());
        f.workspace.stepToEvent(+1);
        QVERIFY(f.untilShown(*next));
        f.workspace.stepToEvent(-1);
        QVERIFY(f.untilShown(*std::prev(next)));
    }

    void playsWhatWasFlownAndFliesOn()
    {
        Flight f;
        f.workspace.seek(280);
        QVERIFY(f.untilShown(280));
        f.workspace.fly(100);
        QVERIFY(f.workspace.isPlaying());
        QVERIFY(f.until([&] { return f.record().now.time_s > 310; })); // caught up and continued
        QVERIFY(!f.record().instant.has_value());
        f.workspace.pause();
        QVERIFY(f.until([&] { return f.record().now.phase == RunPhase::Paused; }));
        Mission mission = flownAlone(f.workspace.document().scenario(), 150);
        mission.advance(f.record().now.time_s);
        QVERIFY(f.record().now.world == mission.simulation().state());
    }

    void tauIsRefusedWhileLookingBack()
    {
        Flight f;
        QSignalSpy refused(&f.workspace, &Workspace::refused);
        f.workspace.seek(100);
        f.workspace.setTau(4);
        f.workspace.setPolicy(PolicyKind::Nearest);
        QCOMPARE(refused.count(), 2);
        QVERIFY(f.untilShown(100));
        QCOMPARE(f.record().now.planner.tau, 0.2);
    }

    /** The later part is discarded; the new continuation is a run that replays. */
    void fliesOnFromThere()
    {
        Flight f;
        f.workspace.seek(100);
        QVERIFY(f.untilShown(100));
        f.workspace.continueFromHere();
        QVERIFY(f.until([&] { return std::abs(f.record().now.time_s - 100) < 1e-6; }));
        QVERIFY(!f.record().instant.has_value());
        QCOMPARE(f.record().history.samples.size(), std::size_t{101});
        QCOMPARE(f.record().history.rows.size(), std::size_t{101});
        QCOMPARE(f.record().now.planner.tau, 1.0); // the later change has not come yet
        f.workspace.setTau(3);
        QVERIFY(f.until([&] { return f.record().now.planner.tau == 3; }));
        f.workspace.fly(kFastestRate);
        QVERIFY(f.until([&] { return f.record().now.phase == RunPhase::Finished; }));
        QCOMPARE(f.record().history.samples.size(), std::size_t{601});

        Mission mission(f.workspace.document().scenario());
        mission.advance(100);
        mission.intervene({.tau = 3.0});
        mission.advance(600);
        QVERIFY(f.record().now.metrics == mission.metrics());
        QVERIFY(f.record().now.world == mission.simulation().state());
        QCOMPARE(f.record().history.events.size(), mission.events().size());
        QCOMPARE(f.record().history.plans.size(), mission.plans().size());
    }

    /** The thread may not have begun to continue when that flight is stopped. */
    void flightIsNotLostBeforeItContinues_data()
    {
        QTest::addColumn<bool>("isStopped");
        QTest::newRow("stopped") << true;
        QTest::newRow("brought back at once") << false;
    }
    void flightIsNotLostBeforeItContinues()
    {
        QFETCH(bool, isStopped);
        Flight f;
        f.workspace.seek(100);
        QVERIFY(f.untilShown(100));
        f.workspace.continueFromHere();
        if (isStopped) {
            f.workspace.reset();
            QVERIFY(f.until([&] { return f.record().now.phase == RunPhase::Ready; }));
        }
        QCOMPARE(f.workspace.discardedFlight_s(), std::optional(300.0));
        f.workspace.restoreFlight();
        QVERIFY(f.until([&] {
            return f.record().now.generation == f.workspace.runner().generation() &&
                   f.record().now.phase != RunPhase::Planning;
        }));
        QCOMPARE(f.record().now.time_s, 300.0);
        QCOMPARE(f.record().history.samples.size(), std::size_t{301});
    }

    /** The first request counts: the flight that it discarded can be restored. */
    void flownOnTwiceBeforeTheAnswer()
    {
        Flight f;
        f.workspace.seek(100);
        QVERIFY(f.untilShown(100));
        f.workspace.continueFromHere();
        f.workspace.seek(50);
        f.workspace.continueFromHere(); // the first request has no result yet
        QVERIFY(f.until([&] { return std::abs(f.record().now.time_s - 100) < 1e-6; }));
        QCOMPARE(f.workspace.discardedFlight_s(), std::optional(300.0));
        f.workspace.restoreFlight();
        QVERIFY(f.until([&] { return std::abs(f.record().now.time_s - 300) < 1e-6; }));
        QCOMPARE(f.record().history.samples.size(), std::size_t{301});
    }

    void resetForgetsTheInstant()
    {
        Flight f;
        f.workspace.seek(100);
        QVERIFY(f.untilShown(100));
        f.workspace.reset();
        QVERIFY(f.until([&] { return f.record().now.phase == RunPhase::Ready; }));
        QVERIFY(!f.workspace.lookedAt_s().has_value());
        QVERIFY(!f.record().instant.has_value());
        QCOMPARE(f.record().shown().time_s, 0.0);
    }

    /** A run that is saved, read and opened is the same flight and can be continued. */
    void openedRunIsTheFlight()
    {
        Flight f;
        std::shared_ptr<const RunFile> run;
        connect(&f.workspace.runner(), &MissionRunner::runReady, this,
                [&run](const QString&, const std::shared_ptr<const RunFile>& r) { run = r; });
        f.workspace.runner().requestRun();
        QVERIFY(f.until([&] { return run != nullptr; }));
        Workspace other;
        QSignalSpy refused(&other, &Workspace::refused);
        other.openRun(std::make_shared<const RunFile>(runFromJson(runToJson(*run), "run")));
        QVERIFY(f.until([&] { return other.record().now.phase == RunPhase::Paused; }));
        QVERIFY(other.document().scenario() == f.workspace.document().scenario());
        QVERIFY(other.record().now.world == f.record().now.world);
        QVERIFY(other.record().now.metrics == f.record().now.metrics);
        QCOMPARE(other.record().history.events.size(), f.record().history.events.size());
        QCOMPARE(refused.count(), 0);
        for (Workspace* workspace : {&other, &f.workspace})
            workspace->fly(kFastestRate);
        QVERIFY(f.until([&] {
            return other.record().now.phase == RunPhase::Finished &&
                   f.record().now.phase == RunPhase::Finished;
        }));
        QVERIFY(other.record().now.world == f.record().now.world);
    }

    void differingReplayIsReported()
    {
        Flight f;
        std::shared_ptr<const RunFile> run;
        connect(&f.workspace.runner(), &MissionRunner::runReady, this,
                [&run](const QString&, const std::shared_ptr<const RunFile>& r) { run = r; });
        f.workspace.runner().requestRun();
        QVERIFY(f.until([&] { return run != nullptr; }));
        RunFile changed = *run;
        changed.metrics.zeta_m2s += 1;
        Workspace other;
        QSignalSpy refused(&other, &Workspace::refused);
        other.openRun(std::make_shared<const RunFile>(changed));
        QVERIFY(f.until([&] { return refused.count() == 1; }));
        QVERIFY(refused.front().front().toString().contains(u"zeta"_s));
    }
};

QTEST_MAIN(TestLookBack)
#include "tst_look_back.moc"
