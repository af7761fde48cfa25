#include "core/io/study/study_json.h"
#include "core/io/text/atomic_file.h"
#include "tests/support/window/study_builder.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/charts/study_chart.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/study/solve_time_panel.h"
#include "widgets/panels/study/study_panel.h"
#include "widgets/words/policy_words.h"

#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QScreen>
#include <QSignalSpy>
#include <QTableView>
#include <QToolButton>
#include <QUndoStack>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

/** The window with its study dock open. */
struct StudyWindow : WindowFixture
{
    explicit StudyWindow(const Scenario& scenario = test::quickScenario()) : WindowFixture(scenario)
    {
        trigger(u"studyAction"_s);
    }

    template <class Widget>
    [[nodiscard]] Widget& get(const QString& name)
    {
        return test::child<Widget>(window(), name);
    }
    [[nodiscard]] StudyRunner& study() { return workspace.study(); }
    void click(const QString& button) { get<QAbstractButton>(button).click(); }
    /** Shown as if it had been opened. */
    [[nodiscard]] bool flyStudy(const StudySpec& spec)
    {
        study().start(spec);
        return until([&] { return study().isComplete() && !study().isRunning(); });
    }
    /** Clicks the point of a setting and opens the case in that row. */
    void openRun(std::size_t setting, int row)
    {
        auto& chart = get<StudyChart>(u"studyChart"_s);
        const std::vector<DrawnItem> items = chart.drawing().items; // a click lays out others
        for (const DrawnItem& item : items)
            if (item.of.id == setting)
                QTest::mouseClick(&chart, Qt::LeftButton, {}, toQt(item.at).toPoint());
        get<QTableView>(u"studyCases"_s).selectRow(row);
        click(u"openStudyRun"_s);
    }
    [[nodiscard]] double zetaOf(std::size_t kase, std::size_t setting)
    {
        const StudyResult& result = *study().result();
        return result.study.outcomes[kase * result.summary.settings.size() + setting]
            ->metrics.zeta_m2s;
    }
    [[nodiscard]] QString note() { return get<QLabel>(u"studyState"_s).text(); }
    [[nodiscard]] QByteArray content(const QString& name)
    {
        QFile opened(file(name));
        return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray();
    }
};

} // namespace

/** Studies in the real window. */
class TestMainWindowStudy : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** The map is planned with it, in one step. */
    void settingOfTheStudyIsTakenOver()
    {
        StudyWindow w;
        QVERIFY(w.flyStudy(test::quickStudy(2)));
        auto& settings = w.get<QTableView>(u"studySettings"_s);
        QVERIFY(settings.model()->rowCount() > 2);
        int used = 0;
        for (int row = 0; row < settings.model()->rowCount(); ++row) {
            settings.selectRow(row);
            if (!w.get<QPushButton>(u"useStudySetting"_s).isEnabled())
                continue; // the best of each case is no setting
            ++used;
            const int edits = w.document().undoStack()->index();
            const PlannerSettings before = w.scenario().planner;
            w.click(u"useStudySetting"_s);
            QCOMPARE(w.get<QPushButton>(u"useStudySetting"_s).text(),
                     u"Use "_s + shortPolicyText(w.scenario().planner, QLocale()));
            QCOMPARE(w.document().undoStack()->index() - edits,
                     w.scenario().planner == before ? 0 : 1);
        }
        QVERIFY(used > 2);
    }

    void dockOpensWithRoom()
    {
        StudyWindow w;
        auto& dock = w.get<QDockWidget>(u"studyDock"_s);
        QVERIFY(dock.isVisible() && dock.isFloating());
        QCOMPARE(dock.windowType(), Qt::Window); // not a tool in front of the map
        const QSize best = w.get<StudyPanel>({}).sizeHint();
        const QSize screen = w.window().screen()->availableSize();
        QVERIFY(dock.width() >= std::min(best.width(), screen.width()));
        QVERIFY(dock.height() >= std::min(best.height(), screen.height()) - 1);
        QVERIFY(dock.width() <= 1280 && dock.height() <= 800);
    }

    /** From the form to the flight on the time line, the same number in every bit. */
    void runOfAPointOpensOnTheTimeLine()
    {
        StudyWindow w;
        QVERIFY(w.flyStudy(test::quickStudy()));
        const double expected_m2s = w.zetaOf(0, 2);
        w.openRun(2, 0); // this scenario, tau 2
        QVERIFY(w.until(RunPhase::Finished));
        QCOMPARE(w.record().now.metrics.zeta_m2s, expected_m2s);
        QCOMPARE(w.scenario().planner.tau, 2.0);
        QCOMPARE(w.document().undoStack()->count(), 1); // an edit, no other document
        QVERIFY(w.interaction.unsavedNames.isEmpty());
        QVERIFY(!w.get<QDockWidget>(u"studyDock"_s).isVisible()); // it was over the map

        w.trigger(u"studyAction"_s);
        const double path_m2s = w.zetaOf(2, 3);
        w.openRun(3, 2); // other noise, the shortest path; over the flight there is
        QVERIFY(w.until([&] {
            return w.record().now.phase == RunPhase::Finished &&
                   w.scenario().planner.policy == PolicyKind::Path;
        }));
        QCOMPARE(w.record().now.metrics.zeta_m2s, path_m2s);
        QVERIFY(w.interaction.unsavedNames.isEmpty());
    }

    void anotherScenarioTakesThePlaceAfterTheQuestion()
    {
        StudyWindow w;
        QVERIFY(w.flyStudy({.random = 2,
                            .firstSeed = 8,
                            .field = {.icebergs = 4},
                            .taus = {1},
                            .policies = {PolicyKind::Visitation}}));
        w.document().edit(u"change"_s, [](Scenario& scenario) { scenario.notes = "mine"; });
        w.interaction.unsaved = Interaction::Unsaved::Cancel;
        w.openRun(0, 1);
        QCOMPARE(w.interaction.unsavedNames.size(), 1);
        QCOMPARE(w.scenario().notes, std::string("mine"));
        QVERIFY(!w.workspace.inFlight());

        w.interaction.unsaved = Interaction::Unsaved::Discard;
        w.click(u"openStudyRun"_s);
        QVERIFY(w.until(RunPhase::Finished));
        QCOMPARE(w.scenario().icebergs.size(), std::size_t{4});
        QCOMPARE(w.scenario().seed, std::int64_t{9});
        QCOMPARE(w.record().now.metrics.zeta_m2s, w.zetaOf(1, 0));
    }

    void smallStudyFromTheForm()
    {
        StudyWindow w;
        test::enter(w.get<NumberField>(u"studyTauStep"_s), u"1"_s);
        w.click(u"startStudy"_s);
        QVERIFY(w.until([&] { return w.study().isComplete(); }));
        QCOMPARE(w.study().count(), std::size_t{6}); // tau 0 .. 4 and the shortest path
        QCOMPARE(w.get<StudyChart>(u"studyChart"_s).drawing().items.size(), std::size_t{6});
    }

    void reportTableAndPictureAreWritten()
    {
        StudyWindow w;
        QVERIFY(w.flyStudy(test::quickStudy()));
        const auto saves = [&](const QString& button, const QString& name) {
            w.interaction.path = w.file(name);
            w.click(button);
            return w.until([&] { return w.note().contains(name); });
        };
        QVERIFY(saves(u"reportStudy"_s, u"report.html"_s));
        QCOMPARE(w.interaction.suggested.back(), u"Quick study.html"_s);
        QVERIFY(w.content(u"report.html"_s).contains("<svg"));
        QVERIFY(saves(u"tableStudy"_s, u"table.csv"_s));
        QCOMPARE(w.content(u"table.csv"_s).count('\n'), 5);
        QVERIFY(saves(u"pictureStudy"_s, u"picture.svg"_s));
        QVERIFY(w.content(u"picture.svg"_s).contains("<svg"));
        QVERIFY(w.interaction.errors.isEmpty());

        w.interaction.path = w.file(u"nowhere/table.csv"_s);
        w.click(u"tableStudy"_s);
        QVERIFY(w.until([&] { return w.interaction.errors.size() == 1; }));
    }

    void studyIsSavedOpenedAndCarriedOn()
    {
        StudyWindow w;
        QVERIFY(w.flyStudy(test::quickStudy()));
        Study half = w.study().result()->study;
        const Study whole = half;
        w.interaction.path = w.file(u"whole.bergstudy"_s);
        w.click(u"saveStudy"_s);
        QVERIFY(w.until([&] { return w.note().contains(u"whole"_s); }));
        QVERIFY(loadStudy(w.file(u"whole.bergstudy"_s).toStdString()) == whole);

        std::fill(half.outcomes.begin() + 6, half.outcomes.end(), std::nullopt);
        saveStudy(half, w.file(u"half.bergstudy"_s).toStdString());
        w.interaction.path = w.file(u"half.bergstudy"_s);
        w.click(u"openStudy"_s);
        QVERIFY(w.until([&] { return w.study().flown() == 6; }));
        QVERIFY(w.until([&] { return w.study().result()->study == half; }));
        QVERIFY(w.get<QPushButton>(u"carryOnStudy"_s).isVisible());
        w.click(u"carryOnStudy"_s);
        QVERIFY(w.until([&] { return w.study().isComplete(); }));
        QVERIFY(w.study().result()->study == whole);
    }

    /** A study opens like any other file: dropped, on the command line, from the menu. */
    void studyFileOpensItsDock()
    {
        WindowFixture w(test::quickScenario());
        saveStudy(test::fourCases()->study, w.file(u"a.bergstudy"_s).toStdString());
        QVERIFY(w.window().parts().files.openFile(w.file(u"a.bergstudy"_s)));
        QVERIFY(w.until([&] { return w.workspace.study().result() != nullptr; }));
        QVERIFY(test::child<QDockWidget>(w.window(), u"studyDock"_s).isVisible());
        w.window().parts().files.openFile(w.file(u"none.bergstudy"_s));
        QVERIFY(w.until([&] { return w.interaction.errors.size() == 1; }));
    }

    /** Two tracks over the map, the best tau beside the shortest path. */
    void figure5ComparesTwoFlights()
    {
        StudyWindow w;
        w.click(u"figure5"_s);
        RunList& runs = w.workspace.runs();
        QVERIFY(w.until([&] { return runs.other() && runs.reference(); }));
        QVERIFY(w.until([&] {
            return runs.other()->planner.policy == PolicyKind::Path &&
                   runs.reference()->planner.policy == PolicyKind::Visitation;
        }));
        QVERIFY(w.until(RunPhase::Finished));
        QVERIFY(runs.otherIn(w.record().scenario) != nullptr); // drawn over the map
        QCOMPARE(runs.reference()->metrics.zeta_m2s, w.record().now.metrics.zeta_m2s);
        QVERIFY(test::child<QDockWidget>(w.window(), u"comparisonDock"_s).isVisible());
    }

    void figure3OpensTheSolveTimes()
    {
        StudyWindow w;
        w.click(u"figure3"_s);
        QVERIFY(w.get<QDockWidget>(u"solveTimeDock"_s).isVisible());
        const BenchmarkSpec spec = w.get<SolveTimePanel>({}).spec();
        QCOMPARE(spec.sizes.back(), paperTable2().back().icebergs);
        QCOMPARE(spec.repeat, 50);
    }

    void otherLanguageKeepsTheStudy()
    {
        StudyWindow w;
        QVERIFY(w.flyStudy(test::quickStudy()));
        const MainWindow* before = &w.window();
        w.trigger(u"view/language-nb"_s);
        QVERIFY(w.until([&] { return &w.window() != before; }));
        QCOMPARE(w.get<StudyChart>(u"studyChart"_s).drawing().items.size(), std::size_t{4});
        before = &w.window();
        w.trigger(u"view/language-en"_s);
        QVERIFY(w.until([&] { return &w.window() != before; }));
    }

    /** Closing the window does not lose a long study. */
    void unsavedStudyIsAskedAbout()
    {
        StudyWindow w;
        QVERIFY(w.flyStudy(test::quickStudy()));
        w.settings.setValue("study/worthSaving_s", 0);
        w.interaction.unsaved = Interaction::Unsaved::Cancel;
        QVERIFY(!w.window().close());
        QCOMPARE(w.interaction.unsavedNames, QStringList{u"Study: Quick study"_s});
        w.interaction.unsaved = Interaction::Unsaved::Save;
        w.interaction.path = w.file(u"nowhere/a.bergstudy"_s);
        QVERIFY(!w.window().close());
        QVERIFY(w.until([&] { return w.interaction.errors.size() == 1; })); // it stays open
        QVERIFY(w.window().isVisible());

        w.interaction.path = w.file(u"a.bergstudy"_s);
        QVERIFY(!w.window().close()); // not before it is on disk
        QVERIFY(w.until([&] { return !w.window().isVisible(); }));
        QVERIFY(loadStudy(w.file(u"a.bergstudy"_s).toStdString()) == w.study().result()->study);
    }

    /** Another study does not replace a long one without a question. */
    void anotherStudyIsAskedAbout_data()
    {
        QTest::addColumn<QString>("path");
        for (const char* path : {"startStudy", "figure4", "figure5", "file"})
            QTest::newRow(path) << QString::fromLatin1(path);
    }
    void anotherStudyIsAskedAbout()
    {
        QFETCH(QString, path);
        StudyWindow w;
        QVERIFY(w.flyStudy(test::quickStudy()));
        const Study flown = w.study().result()->study;
        w.settings.setValue("study/worthSaving_s", 0);
        const QString other = w.file(u"other.bergstudy"_s);
        saveStudy(test::fourCases()->study, other.toStdString());
        const auto replace = [&] {
            if (path == u"file"_s)
                QVERIFY(w.window().parts().files.openFile(other));
            else
                w.click(path);
        };
        replace();
        QVERIFY(w.until([&] { return w.interaction.unsavedNames.size() == 1; }));
        QVERIFY(!w.study().isRunning());
        QVERIFY(w.study().result()->study == flown);

        w.interaction.unsaved = Interaction::Unsaved::Save;
        w.interaction.path = w.file(u"nowhere/a.bergstudy"_s);
        replace();
        QVERIFY(w.until([&] { return w.interaction.errors.size() == 1; })); // nothing replaced
        QVERIFY(w.study().result()->study == flown);

        w.interaction.path = w.file(u"a.bergstudy"_s);
        replace();
        QVERIFY(w.until([&] { return !(w.study().result()->study == flown); }));
        QVERIFY(loadStudy(w.file(u"a.bergstudy"_s).toStdString()) == flown);
        QCOMPARE(w.interaction.unsavedNames.size(), 3);
    }

    /** Saved while it was being flown: what is flown after that is unsaved all the same. */
    void savedStudyIsNotTheNextOne()
    {
        StudyWindow w;
        QVERIFY(w.flyStudy(test::quickStudy()));
        const StudySavePoint point = w.study().savePoint();
        QVERIFY(w.flyStudy(test::quickStudy(2)));
        const double unsaved_s = w.study().unsaved_s();
        w.study().noteSaved(point); // it took so long to write
        QCOMPARE(w.study().unsaved_s(), unsaved_s);
        w.study().noteSaved(w.study().savePoint());
        QCOMPARE(w.study().unsaved_s(), 0.0);
    }

    /** Each is asked about once. */
    void scenarioIsGivenUpAndTheStudySaved()
    {
        StudyWindow w;
        QVERIFY(w.flyStudy(test::quickStudy()));
        w.settings.setValue("study/worthSaving_s", 0);
        w.document().edit(u"change"_s, [](Scenario& scenario) { scenario.notes = "mine"; });
        w.interaction.path = w.file(u"a.bergstudy"_s);
        w.interaction.unsavedAnswers = {Interaction::Unsaved::Save, Interaction::Unsaved::Discard};
        QVERIFY(!w.window().close());
        QVERIFY(w.until([&] { return !w.window().isVisible(); }));
        QCOMPARE(w.interaction.unsavedNames.size(), 2);
    }

    /** There is no later: it is in its file when the question has been answered. */
    void endOfTheSessionAsksAboutTheStudy_data()
    {
        QTest::addColumn<Interaction::Unsaved>("answer");
        QTest::newRow("save") << Interaction::Unsaved::Save;
        QTest::newRow("discard") << Interaction::Unsaved::Discard;
        QTest::newRow("cancel") << Interaction::Unsaved::Cancel;
    }
    void endOfTheSessionAsksAboutTheStudy()
    {
        QFETCH(Interaction::Unsaved, answer);
        StudyWindow w;
        QVERIFY(w.flyStudy(test::quickStudy()));
        w.settings.setValue("study/worthSaving_s", 0);
        w.interaction.unsaved = answer;
        w.interaction.path = w.file(u"a.bergstudy"_s);
        QCOMPARE(w.window().parts().safety.mayEndSession(true),
                 answer != Interaction::Unsaved::Cancel);
        QCOMPARE(w.interaction.unsavedNames.size(), 1);
        QCOMPARE(QFile::exists(w.interaction.path), answer == Interaction::Unsaved::Save);
    }

    /** The window made anew finishes what the one before was asked for. */
    void otherLanguageKeepsWhatIsAwaited()
    {
        StudyWindow w;
        w.click(u"figure5"_s);
        w.trigger(u"view/language-nb"_s);
        RunList& runs = w.workspace.runs();
        QVERIFY(w.until([&] { return runs.other() && runs.reference(); }));
        QVERIFY(w.until([&] {
            return runs.other()->planner.policy == PolicyKind::Path &&
                   runs.reference()->planner.policy == PolicyKind::Visitation;
        }));

        w.settings.setValue("study/worthSaving_s", 0);
        w.interaction.unsaved = Interaction::Unsaved::Save;
        w.interaction.path = w.file(u"a.bergstudy"_s);
        QVERIFY(!w.window().close());
        const MainWindow* before = &w.window();
        w.trigger(u"view/language-en"_s);
        QVERIFY(w.until([&] { return &w.window() != before; }));
        QVERIFY(w.until([&] { return !w.window().isVisible(); }));
        QVERIFY(QFile::exists(w.interaction.path));
    }

    /** The change comes a moment after it was chosen. */
    void closedBeforeTheLanguageChanges()
    {
        StudyWindow w;
        const MainWindow* before = &w.window();
        w.trigger(u"view/language-nb"_s);
        QVERIFY(w.window().close());
        QVERIFY(w.until([&] { return &w.window() != before; }));
        QVERIFY(!w.window().isVisible());
    }

    /** Neither the window nor the program waits for a study. */
    void closesWhileAStudyIsFlown()
    {
        auto w = std::make_unique<StudyWindow>();
        w->study().start(test::endlessStudy());
        QVERIFY(w->until([&] { return w->study().flown() > 0; }));
        QVERIFY(w->window().close());
        w.reset(); // waits for the thread
    }
};

QTEST_MAIN(TestMainWindowStudy)
#include "tst_main_window_study.moc"
