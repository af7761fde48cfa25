#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/presets/presets.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/charts/time_chart.h"

#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QSlider>
#include <QStatusBar>
#include <QTableView>
#include <QToolButton>
#include <QUndoStack>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

Scenario shipped(const QString& name)
{
    return loadScenario(
        (QStringLiteral(BERG_SOURCE_DIR "/resources/scenarios/") + name).toStdString());
}

/** From now on as fast as possible, by the keys of the window. */
void flyAtFullSpeed(WindowFixture& w)
{
    auto& rate = test::child<QComboBox>(w.window(), u"rateCombo"_s);
    for (int presses = 0; rate.currentData().toDouble() != 0 && presses < rate.count(); ++presses)
        QTest::keyClick(&w.map(), Qt::Key_BracketRight);
    QCOMPARE(rate.currentData().toDouble(), 0.0);
}

/** End of the first line; -1: nothing is drawn. */
double shownUntil_s(const TimeChart& chart)
{
    const std::vector<TimeLine>& lines = chart.content().lines;
    return lines.empty() || lines.front().points.empty() ? -1 : lines.front().points.back().x();
}

/** This build may lack it. */
bool hasCbc()
{
    try {
        return makeSolver(Backend::Cbc) != nullptr;
    } catch (const Error&) {
        return false;
    }
}

/** Runs the command line, which must succeed; its standard output. */
QByteArray commandLine(const QStringList& arguments)
{
    QProcess program;
    program.start(QStringLiteral(BERG_CLI), arguments);
    if (!program.waitForFinished(120000) || program.exitCode() != 0)
        qFatal("%s", program.readAllStandardError().constData());
    return program.readAllStandardOutput();
}

/** Returns the text of the first event in the list; empty if there is none. */
QString firstEvent(WindowFixture& w)
{
    const auto& table = test::child<QTableView>(w.window(), u"eventTable"_s);
    return table.model()->index(0, 1).data().toString();
}

double zetaOf(const QByteArray& json)
{
    return QJsonDocument::fromJson(json)[u"zeta_m2s"_s].toDouble(-1);
}

} // namespace

/** Flying in the whole window. */
class TestMainWindowFlight : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void fliesAsCoreAndCommandLine_data()
    {
        QTest::addColumn<Scenario>("scenario");
        QTest::newRow("grand-banks-12") << shipped(u"grand-banks-12.berg"_s);
        QTest::newRow("barents-wind") << shipped(u"barents-wind.berg"_s);
        Scenario closed = randomScenario(21, {.icebergs = 9});
        closed.planner.route = Route::Closed;
        closed.duration_s = 600;
        QTest::newRow("random, closed route") << closed;
        Scenario tour = randomScenario(22);
        tour.planner.policy = PolicyKind::Tour;
        QTest::newRow("random, tour") << tour;
    }

    /** One number of all three, to the last digit. */
    void fliesAsCoreAndCommandLine()
    {
        QFETCH(Scenario, scenario);
        WindowFixture w(scenario);
        const QString path = w.file(u"flown.berg"_s);
        w.interaction.path = path;
        w.trigger(u"saveAsAction"_s);
        flyAtFullSpeed(w);
        w.trigger(u"playAction"_s);
        QVERIFY(w.until(RunPhase::Finished));

        const Metrics metrics = test::elsewhere([&] {
            Mission mission(scenario);
            mission.advance(scenario.duration_s);
            return mission.metrics();
        });
        QVERIFY(w.record().now.metrics == metrics);
        const QByteArray json = commandLine({u"simulate"_s, path, u"--json"_s});
        QVERIFY(zetaOf(json) == metrics.zeta_m2s);
    }

    /** A drag of tau in flight, saved and flown again by core and command line: bit for bit. */
    void interventionsReplay()
    {
        WindowFixture w(randomScenario(23));
        QTest::keyClick(&w.map(), Qt::Key_Space);
        QVERIFY(w.until([&] { return w.record().now.time_s > 2; }));
        const Scenario before = w.scenario();
        w.dragTau(0.2, 0.7);
        QVERIFY(w.until([&] { return w.record().now.time_s > 6; }));
        w.dragTau(0.7, 0.4);
        const double tau = test::child<QSlider>(w.window(), u"tauSlider"_s).value() / 100.0;
        QVERIFY(w.scenario() == before);
        flyAtFullSpeed(w);
        QVERIFY(w.until(RunPhase::Finished));
        QCOMPARE(w.record().now.planner.tau, tau);

        const QString path = w.file(u"flight.bergrun"_s);
        w.interaction.path = path;
        w.trigger(u"saveRunAction"_s);
        QVERIFY(w.until([&] { return QFile::exists(path); }));
        const RunFile run = loadRun(path.toStdString());
        QVERIFY(run.interventions.size() >= 2);
        QCOMPARE(run.interventions.back().tau.value_or(-1), tau);
        const auto [differences, metrics] = test::elsewhere([&] {
            const Mission again = replay(run);
            return std::pair(compareRun(run, runOf(again)), again.metrics());
        });
        QVERIFY(differences.empty());
        QVERIFY(metrics == w.record().now.metrics);
        const QByteArray json = commandLine({u"simulate"_s, path, u"--json"_s});
        QVERIFY(zetaOf(json) == metrics.zeta_m2s);
        QVERIFY(commandLine({u"simulate"_s, path}).contains("equal to the recorded run"));
    }

    void policyInFlightIsAnIntervention()
    {
        WindowFixture w(randomScenario(24));
        w.trigger(u"stepAction"_s);
        QVERIFY(w.until(RunPhase::Paused));
        auto& policy = test::child<QComboBox>(w.window(), u"policyCombo"_s);
        policy.setFocus();
        QTest::keyClick(&policy, Qt::Key_Down);
        QVERIFY(w.until([&] { return w.record().now.planner.policy == PolicyKind::Latency; }));
        QCOMPARE(w.scenario().planner.policy, PolicyKind::Visitation);
        QCOMPARE(w.document().undoStack()->count(), 0);
        QVERIFY(!test::child<QSlider>(w.window(), u"tauSlider"_s).isEnabled());
        w.trigger(u"resetAction"_s);
        QVERIFY(w.untilReady());
        QCOMPARE(w.record().now.planner.policy, PolicyKind::Visitation);
        QCOMPARE(policy.currentIndex(), 0);
    }

    void buttonsAndKeysFly()
    {
        WindowFixture w(randomScenario(25));
        const auto button = [&](const QString& name) -> QToolButton& {
            return test::child<QToolButton>(w.window(), name);
        };
        QTest::mouseClick(&button(u"playButton"_s), Qt::LeftButton);
        QVERIFY(w.until(RunPhase::Flying));
        QTest::mouseClick(&button(u"playButton"_s), Qt::LeftButton);
        QVERIFY(w.until(RunPhase::Paused));
        const double paused_s = w.record().now.time_s;
        QTest::keyClick(&w.map(), Qt::Key_Period);
        QVERIFY(w.until([&] { return w.record().now.time_s > paused_s + 0.9; }));
        QTest::mouseClick(&button(u"stepButton"_s), Qt::LeftButton);
        QVERIFY(w.until([&] { return w.record().now.time_s > paused_s + 1.9; }));
        QTest::keyClick(&w.map(), Qt::Key_Space);
        QVERIFY(w.until(RunPhase::Flying));
        QTest::mouseClick(&button(u"resetButton"_s), Qt::LeftButton);
        QVERIFY(!w.workspace.inFlight());
        QVERIFY(w.untilReady());
        QCOMPARE(w.record().now.time_s, 0.0);
    }

    /** Space at the end flies the whole mission again. */
    void spaceInADragTakesItBackAndFlies()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const Scenario start = w.scenario();
        const QPoint from = w.pixelOf("berg-1");
        QTest::mousePress(&w.map(), Qt::LeftButton, {}, from);
        for (int i = 1; i <= 4; ++i)
            QTest::mouseMove(&w.map(), from + QPoint(10 * i, 5 * i));
        QVERIFY(!(w.scenario() == start));
        QVERIFY(w.untilReady());
        QTest::keyClick(&w.map(), Qt::Key_Space);
        QVERIFY(w.until(RunPhase::Flying));
        QVERIFY(w.scenario() == start);
        QVERIFY(w.document().isLocked());
        QTest::mouseMove(&w.map(), from + QPoint(60, 60));
        QTest::mouseRelease(&w.map(), Qt::LeftButton, {}, from + QPoint(60, 60));
        QVERIFY(w.scenario() == start);
        QVERIFY(w.workspace.inFlight());

        QTest::mouseClick(&test::child<QToolButton>(w.window(), u"resetButton"_s), Qt::LeftButton);
        QVERIFY(!w.workspace.inFlight());
        QVERIFY(!w.document().isLocked());
        w.drag(w.pixelOf("berg-1"), w.pixelOf("berg-1") + QPoint(40, 20));
        QVERIFY(!(w.scenario() == start));
    }

    void nothingIsEditedInFlight()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QVERIFY(w.document().edit(u"Rename"_s, [](Scenario& s) { s.name = "edited"; }));
        QVERIFY(w.untilReady());
        const Scenario flown = w.scenario();
        w.workspace.fly(1);
        QVERIFY(w.until(RunPhase::Flying));
        QSignalSpy refused(&w.workspace, &Workspace::refused);
        QVERIFY(!w.document().edit(u"Rename"_s, [](Scenario& s) { s.name = "again"; }));
        w.document().undo();
        QCOMPARE(refused.count(), 2);
        QVERIFY(w.scenario() == flown);
        QVERIFY(w.workspace.inFlight());
        w.workspace.reset();
        w.document().undo();
        QVERIFY(!(w.scenario() == flown));
    }

    /** An iceberg removed in flight stays in the scenario. */
    void deleteInFlightRemovesAnIceberg()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QVERIFY(w.untilReady());
        const Scenario before = w.scenario();
        w.trigger(u"stepAction"_s);
        QVERIFY(w.until(RunPhase::Paused));
        QVERIFY(!w.action(u"deleteAction"_s).isEnabled());
        w.workspace.selection().set({"berg-2"});
        QTest::keyClick(&w.map(), Qt::Key_Delete);
        QVERIFY(w.window().statusBar()->currentMessage().startsWith(u"1 iceberg removed"_s));
        QVERIFY(w.until([&] { return !w.record().now.active.at(1); }));
        QCOMPARE(w.record().now.active, (std::vector<bool>{true, false, true, true}));
        QVERIFY(w.scenario() == before);
        QVERIFY(w.until([&] {
            return std::ranges::none_of(ordersOf(w.record().now), [](const IcebergList& order) {
                return std::ranges::find(order, IcebergIndex(1)) != order.end();
            });
        }));
        const MissionEvent& last = *std::ranges::find_if(
            w.record().history.events, [](auto& e) { return e.kind == EventKind::Intervention; });
        QCOMPARE(last.iceberg, std::optional(IcebergIndex(1)));
        w.trigger(u"resetAction"_s);
        QVERIFY(w.untilReady());
        QVERIFY(w.record().now.active.at(1));
    }

    /** The command to fly is of the scenario it was given for. */
    void anotherScenarioIsNotFlown()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        Scenario other = test::MapFixture::fourIcebergs();
        for (int round = 0; round < 20; ++round) {
            w.document().edit(u"Seed"_s, [](Scenario& s) { ++s.seed; });
            w.workspace.fly(1);
            other.seed = 1000 + round;
            w.document().reset(other);
            QVERIFY(w.untilReady());
            QVERIFY(!w.workspace.inFlight());
        }
    }

    void fliesAgainFromTheEnd()
    {
        WindowFixture w(randomScenario(26, {.icebergs = 5}));
        flyAtFullSpeed(w);
        w.trigger(u"playAction"_s);
        QVERIFY(w.until(RunPhase::Finished));
        const double zeta_m2s = w.record().now.metrics.zeta_m2s;
        const std::uint64_t flight = w.record().now.generation;
        QTest::keyClick(&w.map(), Qt::Key_Space);
        QVERIFY(w.until(
            [&] { return w.until(RunPhase::Finished) && w.record().now.generation > flight; }));
        QVERIFY(w.record().now.metrics.zeta_m2s == zeta_m2s);
    }

    /** They are drawn in turns; the last turn of each shows the end. */
    void everyChartShowsTheNewest()
    {
        WindowFixture w(randomScenario(26, {.icebergs = 5}));
        flyAtFullSpeed(w);
        w.trigger(u"playAction"_s);
        QVERIFY(w.until(RunPhase::Finished));
        const QList<TimeChart*> charts = w.window().findChildren<TimeChart*>();
        QCOMPARE(charts.size(), 2);
        const Sample& last = w.record().history.samples.back();
        for (TimeChart* chart : charts)
            QTRY_COMPARE(shownUntil_s(*chart), last.time_s);
    }

    /** The list shows the events of the present mission, not of an earlier one. */
    void eventsAreThoseOfTheMission()
    {
        Scenario scenario = test::emptySea();
        test::addIceberg(scenario, 1500, 0, 5); // only at first
        test::addIceberg(scenario, -6000, 0, 50);
        test::addIceberg(scenario, 2500, 0, 5);
        scenario.planner.tau = 5;
        WindowFixture w(scenario);
        QTRY_VERIFY(firstEvent(w).endsWith(u"berg-1"_s));
        w.dragTau(0.9, 0.0);
        QVERIFY(w.untilReady());
        QCOMPARE(w.record().now.plan->uavs[0].target(), std::optional(IcebergIndex(1)));
        QTRY_VERIFY(firstEvent(w).endsWith(u"berg-2"_s));
    }

    /** An equal event of another scenario is shown with that scenario's names. */
    void eventsFollowTheNames()
    {
        WindowFixture w(randomScenario(27, {.icebergs = 1}));
        QTRY_VERIFY(firstEvent(w).endsWith(u"berg-1"_s));
        w.document().edit(u"Name"_s, [](Scenario& s) { s.icebergs[0].name = "Storberget"; });
        QVERIFY(w.untilReady());
        const auto isNew = [&] { return firstEvent(w).endsWith(u"Storberget"_s); };
        QVERIFY(QTest::qWaitFor(isNew, 500));
    }

    /** Found while nothing happens, drawn with the flight, gone when somebody else helps. */
    void boundOfZetaIsShown()
    {
        Scenario scenario = randomScenario(4, {.icebergs = 4});
        scenario.duration_s = 200;
        WindowFixture w(scenario);
        QVERIFY(w.until([&] { return w.workspace.bound().isComplete(); }));
        const auto& summary = test::child<QLabel>(w.window(), u"planSummary"_s);
        QVERIFY(w.until([&] { return summary.toolTip().contains(u"Lower bound on ζ"_s); }));
        w.trigger(u"stepAction"_s);
        QVERIFY(w.until(RunPhase::Paused));
        const auto& chart = test::child<TimeChart>(
            test::child<QDockWidget>(w.window(), u"zetaDock"_s), u"timeChart"_s);
        const auto isDrawn = [&] {
            const std::vector<TimeLine>& lines = chart.content().lines;
            return !lines.empty() && lines.back().key == u"zeta_bound_m2s"_s;
        };
        QVERIFY(w.until(isDrawn));
        const double end_m2s = chart.drawnPoints().back().back().y();
        QVERIFY(end_m2s <= w.record().now.metrics.zeta_m2s);
        w.workspace.reportSeen({scenario.icebergs[0].id});
        QVERIFY(w.until([&] { return !isDrawn() && !chart.content().lines.empty(); }));
        QVERIFY(w.until([&] { return !summary.toolTip().contains(u"Lower bound on ζ"_s); }));
        QVERIFY(w.record().bound.whole != nullptr); // for the next flight
    }

    void closesDuringALongSolve_data()
    {
        QTest::addColumn<Backend>("backend");
        QTest::addColumn<int>("icebergs");
        QTest::newRow("search with bound, 100 icebergs") << Backend::Auto << 100;
        QTest::newRow("search with bound, 300 icebergs") << Backend::Auto << 300;
        if (hasCbc())
            QTest::newRow("printed MILP in CBC, 14 icebergs") << Backend::Cbc << 14;
    }

    /** The window, and what it works on, go at once whatever is being solved. */
    void closesDuringALongSolve()
    {
        QFETCH(Backend, backend);
        QFETCH(int, icebergs);
        auto w = std::make_unique<WindowFixture>(randomScenario(28, {.icebergs = 3}));
        Scenario hard = randomScenario(28, {.icebergs = icebergs});
        hard.planner.backend = backend;
        hard.planner.formulation = Formulation::Printed;
        w->document().reset(hard);
        QTest::qWait(300); // the solve is under way
        QVERIFY(w->record().now.phase == RunPhase::Planning ||
                w->record().now.generation != w->workspace.runner().generation());
        constexpr qint64 kLongest_ms = 60'000; // on any machine; CBC would need far longer
        QElapsedTimer clock;
        clock.start();
        w->window().close();
        w.reset();
        QVERIFY2(clock.elapsed() < kLongest_ms, QByteArray::number(clock.elapsed()).constData());
    }
};

QTEST_MAIN(TestMainWindowFlight)
#include "tst_main_window_flight.moc"
