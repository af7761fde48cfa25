#include "core/io/study/study_json.h"
#include "tests/support/window/study_builder.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/charts/study_chart.h"
#include "widgets/panels/study/solve_time_panel.h"

#include <QAbstractButton>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QTableView>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;
using Unsaved = Interaction::Unsaved;

namespace {

/** A window in which whatever was computed is worth a question. */
struct ResultWindow : WindowFixture
{
    ResultWindow() : WindowFixture(test::quickScenario())
    {
        settings.setValue("study/worthSaving_s", 0);
    }

    void press(const QString& button) { test::child<QAbstractButton>(window(), button).click(); }
    [[nodiscard]] BenchmarkRunner& benchmark() { return workspace.benchmark(); }
    /** Measures for a moment, as from the panel. */
    [[nodiscard]] bool measure()
    {
        test::child<SolveTimePanel>(window(), {})
            .showSpec({.sizes = {2, 4},
                       .solvers = {{.backend = Backend::Exact}},
                       .repeat = 1,
                       .budget_s = 1000});
        press(u"startBenchmark"_s);
        return until([&] { return !benchmark().isRunning() && !benchmark().rows().empty(); });
    }
    /** Opens a flight of the study: of this row of cases, with this setting. */
    void openRun(std::size_t setting, int row)
    {
        trigger(u"studyAction"_s);
        auto& chart = test::child<StudyChart>(window(), u"studyChart"_s);
        const std::vector<DrawnItem> items = chart.drawing().items; // a click lays out others
        for (const DrawnItem& item : items)
            if (item.of.id == setting)
                QTest::mouseClick(&chart, Qt::LeftButton, {}, toQt(item.at).toPoint());
        test::child<QTableView>(window(), u"studyCases"_s).selectRow(row);
        press(u"openStudyRun"_s);
    }
    [[nodiscard]] bool flyStudy(const StudySpec& spec)
    {
        workspace.study().start(spec);
        return until(
            [&] { return workspace.study().isComplete() && !workspace.study().isRunning(); });
    }
    /** Flies for a while. */
    [[nodiscard]] bool takeOff()
    {
        if (!untilReady())
            return false;
        workspace.stepTicks(50);
        return until([&] { return workspace.isMidFlight(); });
    }
    [[nodiscard]] QString studies() const { return file(u"studies"_s); }
    /** The folder is as a program that ends unexpectedly leaves it. */
    [[nodiscard]] bool leaveStudy() const
    {
        StudyRunner runner;
        StudyAutosaver keeper(runner);
        keeper.start(studies());
        runner.start(test::quickStudy());
        const bool isFlown =
            QTest::qWaitFor([&] { return runner.isComplete() && !runner.isRunning(); }, 60000);
        keeper.keep();
        return isFlown;
    }
    [[nodiscard]] QStringList savedFiles() const
    {
        return QDir(studies()).entryList({u"*.bergstudy"_s}, QDir::Files | QDir::Hidden);
    }
};

} // namespace

/** Long computations and flights are not lost without a question, nor by a crash. */
class TestMainWindowResults : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** Runs that come to be compared raise nothing, unless somebody is comparing. */
    void comparisonChartStaysBehind()
    {
        WindowFixture w(test::quickScenario());
        test::child<QDockWidget>(w.window(), u"comparisonDock"_s).raise();
        test::child<QDockWidget>(w.window(), u"zetaDock"_s).raise();
        w.map().setFocus();
        for (const double tau : {1.0, 2.0}) {
            w.workspace.setTau(tau);
            QVERIFY(w.untilReady());
            w.workspace.stepTicks(200);
            QVERIFY(w.until([&] { return w.record().now.time_s >= 19; }));
            w.workspace.reset();
            QVERIFY(w.untilReady());
        }
        QVERIFY(w.workspace.runs().comparison());
        w.window().grab(); // laid out
        QVERIFY(!test::child<QWidget>(w.window(), u"zetaDock"_s).visibleRegion().isEmpty());
    }

    /** Also when the second of two runs of the world before is still in flight. */
    void openedScenarioIsNotComparedWithTheOneBefore()
    {
        ResultWindow w;
        for (const double tau : {1.0, 2.0}) {
            w.workspace.reset();
            w.workspace.setTau(tau);
            QVERIFY(w.takeOff());
        }
        Scenario other = w.scenario();
        other.seed += 1;
        w.document().reset(other);
        QVERIFY(w.untilReady());
        QCOMPARE(w.workspace.runs().runs().size(), 2U);
        QVERIFY(!w.workspace.runs().comparison());
    }

    void solveTimesAreAskedAbout_data()
    {
        QTest::addColumn<QString>("path");
        for (const char* path : {"measured again", "closed", "logged out"})
            QTest::newRow(path) << QString::fromLatin1(path);
    }
    void solveTimesAreAskedAbout()
    {
        QFETCH(QString, path);
        ResultWindow w;
        QVERIFY(w.measure());
        const std::size_t rows = w.benchmark().rows().size();
        const auto leave = [&] {
            if (path == u"measured again"_s)
                w.press(u"startBenchmark"_s);
            else if (path == u"closed"_s)
                w.window().close();
            else if (w.window().parts().safety.mayEndSession(true))
                w.window().hide();
        };
        const auto stays = [&] {
            return w.window().isVisible() && !w.benchmark().isRunning() &&
                   w.benchmark().rows().size() == rows;
        };
        leave();
        QCOMPARE(w.interaction.unsavedNames, QStringList{u"Solve time"_s});
        QVERIFY(stays());

        w.interaction.unsaved = Unsaved::Save;
        w.interaction.path = w.file(u"nowhere/times.csv"_s);
        leave();
        QCOMPARE(w.interaction.errors.size(), 1);
        QVERIFY(stays());

        w.interaction.path = w.file(u"times.csv"_s);
        leave();
        QVERIFY(!stays());
        QFile saved(w.file(u"times.csv"_s));
        QVERIFY(saved.open(QIODevice::ReadOnly));
        const QByteArray csv = saved.readAll();
        QVERIFY(csv.startsWith("icebergs,backend,"));
        QCOMPARE(csv.count('\n'), static_cast<qsizetype>(rows) + 1);
    }

    void savedSolveTimesAreNotAskedAbout()
    {
        ResultWindow w;
        QVERIFY(w.measure());
        w.interaction.path = w.file(u"times.csv"_s);
        w.press(u"saveBenchmark"_s);
        QVERIFY(w.measure());
        w.press(u"saveBenchmark"_s);
        QVERIFY(w.window().close());
        QVERIFY(w.interaction.unsavedNames.isEmpty());
    }

    void quickSolveTimesAreNotAskedAbout()
    {
        ResultWindow w;
        w.settings.setValue("study/worthSaving_s", 60);
        QVERIFY(w.measure());
        QVERIFY(w.window().close());
        QVERIFY(w.interaction.unsavedNames.isEmpty());
    }

    void flightFromAStudyAsksAboutTheOneUnderWay_data()
    {
        QTest::addColumn<bool>("variant");
        QTest::newRow("of the scenario on screen") << true;
        QTest::newRow("of another scenario") << false;
    }
    void flightFromAStudyAsksAboutTheOneUnderWay()
    {
        QFETCH(bool, variant);
        ResultWindow w;
        QVERIFY(w.flyStudy(variant ? test::quickStudy()
                                   : StudySpec{.random = 2,
                                               .field = {.icebergs = 4},
                                               .taus = {1},
                                               .policies = {PolicyKind::Visitation}}));
        QVERIFY(w.takeOff());
        const Scenario flown = w.scenario();
        w.openRun(0, 1);
        QCOMPARE(w.interaction.endFlightQuestions, 1);
        QVERIFY(w.workspace.isMidFlight() && w.scenario() == flown);

        w.interaction.endsFlight = true;
        w.openRun(0, 1);
        QCOMPARE(w.interaction.endFlightQuestions, 2);
        QVERIFY(w.until(RunPhase::Finished));
        QVERIFY(!(w.scenario() == flown));
    }

    /** The question about unsaved changes was open when the UAV took off at last. */
    void flightThatBeganMeanwhileIsNotEndedByAStudy()
    {
        ResultWindow w;
        QVERIFY(w.flyStudy({.random = 1,
                            .field = {.icebergs = 4},
                            .taus = {1},
                            .policies = {PolicyKind::Visitation}}));
        w.document().edit(u"change"_s, [](Scenario& scenario) { scenario.notes = "mine"; });
        w.interaction.unsaved = Unsaved::Discard;
        w.interaction.meanwhile = [&] {
            w.interaction.meanwhile = nullptr;
            QVERIFY(w.takeOff());
        };
        w.openRun(0, 0);
        QCOMPARE(w.interaction.endFlightQuestions, 1);
        QVERIFY(w.interaction.flightEnd == Interaction::FlightEnd::Answer);
        QVERIFY(w.workspace.isMidFlight());
        QCOMPARE(w.scenario().notes, std::string("mine"));
    }

    void studyOfAProgramThatWasKilledIsShown()
    {
        ResultWindow w;
        QVERIFY(w.leaveStudy());
        QCOMPARE(w.savedFiles().size(), 1);
        w.workspace.studyAutosaver().start(w.studies());
        QVERIFY(!w.window().parts().safety.offerRecoveries()); // no question: it is simply there
        QVERIFY(w.until([&] { return w.workspace.study().result() != nullptr; }));
        QVERIFY(test::child<QDockWidget>(w.window(), u"studyDock"_s).isVisible());
        QVERIFY(test::child<QLabel>(w.window(), u"studyState"_s)
                    .text()
                    .startsWith(u"Bergwatch ended unexpectedly"_s));
        const Study found = w.workspace.study().result()->study;
        QCOMPARE(flownCount(found), found.outcomes.size());

        QVERIFY(!w.window().close()); // it is in no file yet
        QCOMPARE(w.interaction.unsavedNames, QStringList{u"Study: Quick study"_s});
        w.interaction.path = w.file(u"savedFiles.bergstudy"_s);
        w.press(u"saveStudy"_s);
        QVERIFY(w.until([&] { return w.savedFiles().isEmpty(); }));
        QVERIFY(loadStudy(w.interaction.path.toStdString()) == found);
        QVERIFY(w.window().close());
    }

    void damagedStudyIsReportedAndKept()
    {
        ResultWindow w;
        QVERIFY(w.leaveStudy());
        const QString name = w.savedFiles().value(0);
        QFile left(QDir(w.studies()).filePath(name));
        QVERIFY(left.open(QIODevice::WriteOnly));
        left.write("{");
        left.close();
        w.workspace.studyAutosaver().start(w.studies());
        w.window().parts().safety.offerRecoveries();
        QVERIFY(w.until([&] { return w.interaction.errors.size() == 1; }));
        QVERIFY(w.interaction.errors[0].contains(name + u".damaged"_s));
        QVERIFY(QFile::exists(left.fileName() + u".damaged"_s));
        QVERIFY(w.workspace.study().result() == nullptr);
    }
};

QTEST_MAIN(TestMainWindowResults)
#include "tst_main_window_results.moc"
