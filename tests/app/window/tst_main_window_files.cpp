#include "app/start/start_items.h"
#include "core/io/files/run_json.h"
#include "core/presets/presets.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"

#include <QDir>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;
using Unsaved = Interaction::Unsaved;

Q_DECLARE_METATYPE(Interaction::Unsaved)

namespace {

/** All actions that replace the scenario on screen. */
enum class Exit
{
    New,
    Open,
    Run,
    Example,
    Recent,
    Drop,
    Close,
    Quit
};

Scenario three(std::int64_t seed = 31)
{
    return randomScenario(seed, {.icebergs = 3});
}

/** The menu of recent files, filled as opening it does. */
QList<QAction*> recentActions(WindowFixture& w)
{
    for (QMenu* menu : w.window().findChildren<QMenu*>())
        if (menu->title() == u"Open &recent"_s) {
            emit menu->aboutToShow();
            return menu->actions();
        }
    return {};
}

/** A file dragged over the window and let go; whether the window took it. It is opened later. */
bool drop(WindowFixture& w, const QList<QUrl>& urls)
{
    QMimeData data;
    data.setUrls(urls);
    const QPoint at = w.window().rect().center();
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    enter.ignore();
    QCoreApplication::sendEvent(&w.window(), &enter);
    if (!enter.isAccepted())
        return false;
    QDropEvent event(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&w.window(), &event);
    return true;
}

void leave(WindowFixture& w, Exit path, const QString& other)
{
    switch (path) {
    case Exit::New:
        w.trigger(u"newAction"_s);
        return;
    case Exit::Open:
        w.interaction.path = other;
        w.trigger(u"openAction"_s);
        return;
    case Exit::Run:
        w.interaction.path = w.file(u"other.bergrun"_s);
        w.trigger(u"openAction"_s);
        return;
    case Exit::Example:
        w.trigger(u"startPageAction"_s);
        w.window().findChild<ExampleCard*>()->click();
        return;
    case Exit::Recent:
        recentActions(w).front()->trigger();
        return;
    case Exit::Drop:
        QVERIFY(drop(w, {QUrl::fromLocalFile(other)}));
        QTest::qWait(0);
        return;
    case Exit::Close:
        w.window().close();
        return;
    case Exit::Quit:
        w.trigger(u"quitAction"_s);
        return;
    }
}

/** Files to be opened in place of the scenario, which is in one of its own. */
QString prepareFiles(WindowFixture& w, Exit path)
{
    const QString other = w.file(u"other.berg"_s);
    const QString own = w.file(u"own.berg"_s);
    saveScenario(three(33), other.toStdString());
    saveRun(test::elsewhere([] { return runOf(Mission(three(33))); }),
            w.file(u"other.bergrun"_s).toStdString());
    w.interaction.path = other;
    w.trigger(u"openAction"_s); // for the recent files
    w.trigger(u"newAction"_s);
    saveScenario(three(34), own.toStdString());
    w.interaction.path = own;
    w.trigger(u"openAction"_s);
    if (path == Exit::Recent) // the other one comes first
        w.settings.setValue("files/recent", QStringList{other, own});
    return other;
}

const std::vector<std::pair<Exit, const char*>> kExits = {
    {Exit::New, "new"},         {Exit::Open, "open"},     {Exit::Run, "run"},
    {Exit::Example, "example"}, {Exit::Recent, "recent"}, {Exit::Drop, "drop"},
    {Exit::Close, "close"},     {Exit::Quit, "quit"}};

/** Something that is in no file. */
void change(WindowFixture& w, double to = 0.8)
{
    w.workspace.selection().set({"berg-2"});
    w.dragTau(0.5, to);
    QVERIFY(!w.document().isClean());
}

} // namespace

/** Files, and that nothing is lost on the way out. */
class TestMainWindowFiles : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void savesAndOpensAgain()
    {
        WindowFixture w(three());
        change(w);
        w.interaction.path = w.file(u"saved"_s); // the extension is added
        w.trigger(u"saveAction"_s);
        const QString path = w.file(u"saved.berg"_s);
        QCOMPARE(w.document().filePath(), path);
        QVERIFY(!w.window().isWindowModified());
        const Scenario saved = w.scenario();
        QVERIFY(loadScenario(path.toStdString()) == saved);

        change(w, 0.3);
        w.trigger(u"saveAction"_s); // now without a question
        QCOMPARE(w.interaction.suggested.size(), 1);
        QVERIFY(loadScenario(path.toStdString()) == w.scenario());
        const Scenario again = w.scenario();

        w.interaction.path = w.file(u"copy.berg"_s);
        w.trigger(u"saveAsAction"_s);
        QCOMPARE(w.interaction.suggested.size(), 2);
        QCOMPARE(w.document().filePath(), w.file(u"copy.berg"_s));

        w.trigger(u"newAction"_s);
        QVERIFY(w.scenario().icebergs.empty());
        w.interaction.path = path;
        w.trigger(u"openAction"_s);
        QVERIFY(w.scenario() == again);
        QVERIFY(w.workspace.selection().isEmpty());
        QVERIFY(w.untilReady());
        QVERIFY(w.interaction.errors.isEmpty());
        QVERIFY(w.interaction.unsavedNames.isEmpty());
    }

    void recentFilesNewestFirst()
    {
        WindowFixture w(three());
        QCOMPARE(recentActions(w).size(), 1);
        QVERIFY(!recentActions(w).front()->isEnabled()); // says that there are none
        for (int i = 0; i < 10; ++i) {
            w.interaction.path = w.file(u"%1.berg"_s.arg(i));
            w.trigger(u"saveAsAction"_s);
        }
        w.interaction.path = w.file(u"5.berg"_s);
        w.trigger(u"openAction"_s);
        QStringList names;
        for (const QAction* action : recentActions(w))
            names << action->text();
        QCOMPARE(names, QStringList({u"5.berg"_s, u"9.berg"_s, u"8.berg"_s, u"7.berg"_s,
                                     u"6.berg"_s, u"4.berg"_s, u"3.berg"_s, u"2.berg"_s}));
        recentActions(w)[2]->trigger();
        QCOMPARE(w.document().filePath(), w.file(u"8.berg"_s));
    }

    void brokenFilesChangeNothing_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name :
             {"text/truncated.berg", "settings/many-faults.berg", "text/binary.berg",
              "text/wrong-format.berg", "text/version-2.berg", "not-there.berg"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }

    void brokenFilesChangeNothing()
    {
        QFETCH(QString, name);
        WindowFixture w(three());
        w.workspace.selection().set({"berg-2"});
        const Scenario before = w.scenario();
        w.interaction.path = QStringLiteral(BERG_TEST_DATA "/broken/") + name;
        w.trigger(u"openAction"_s);
        QCOMPARE(w.interaction.errors.size(), 1);
        QVERIFY(w.interaction.errors.front().contains(name));
        QVERIFY(w.scenario() == before);
        QCOMPARE(w.workspace.selection().ids(), std::vector<std::string>{"berg-2"});
        QVERIFY(w.document().filePath().isEmpty());
        QVERIFY(!recentActions(w).front()->isEnabled());
    }

    void unwritableFileIsReported()
    {
        WindowFixture w(three());
        change(w);
        w.interaction.path = w.file(u"no/such/folder/x.berg"_s);
        w.trigger(u"saveAction"_s);
        QCOMPARE(w.interaction.errors.size(), 1);
        QVERIFY(!w.document().isClean());
        QVERIFY(w.document().filePath().isEmpty());
        w.trigger(u"saveRunAction"_s);
        QVERIFY(w.until([&] { return w.interaction.errors.size() == 2; }));
    }

    void takesOneDroppedFile()
    {
        WindowFixture w(three());
        const QString path = w.file(u"dropped.berg"_s);
        saveScenario(three(32), path.toStdString());
        QVERIFY(drop(w, {QUrl::fromLocalFile(path)}));
        QVERIFY(w.until([&] { return w.scenario() == three(32); }));
        QVERIFY(!drop(w, {QUrl(u"https://example.org/x.berg"_s)}));
        QVERIFY(!drop(w, {QUrl::fromLocalFile(path), QUrl::fromLocalFile(path)}));
        QVERIFY(!drop(w, {}));
    }

    /** The program it comes from waits until the drop has ended: no question is asked before. */
    void dropEndsBeforeItIsOpened()
    {
        WindowFixture w(three());
        const QString path = w.file(u"dropped.berg"_s);
        saveScenario(three(32), path.toStdString());
        change(w);
        QVERIFY(drop(w, {QUrl::fromLocalFile(path)}));
        QVERIFY(w.interaction.unsavedNames.isEmpty());
        QVERIFY(w.until([&] { return w.interaction.unsavedNames.size() == 1; }));
    }

    void everyExitAsks_data()
    {
        QTest::addColumn<Exit>("path");
        QTest::addColumn<Unsaved>("answer");
        for (const auto& [path, name] : kExits) {
            QTest::addRow("%s, cancel", name) << path << Unsaved::Cancel;
            QTest::addRow("%s, discard", name) << path << Unsaved::Discard;
            QTest::addRow("%s, save", name) << path << Unsaved::Save;
        }
    }

    void everyExitAsks()
    {
        QFETCH(Exit, path);
        QFETCH(Unsaved, answer);
        WindowFixture w(three());
        const QString other = prepareFiles(w, path);
        const QString own = w.document().filePath();
        change(w);
        const Scenario changed = w.scenario();

        w.interaction.unsaved = answer;
        leave(w, path, other);
        QCOMPARE(w.interaction.unsavedNames.size(), 1);
        const bool stays = answer == Unsaved::Cancel;
        const bool closes = path == Exit::Close || path == Exit::Quit;
        QCOMPARE(w.window().isVisible(), stays || !closes);
        QVERIFY((loadScenario(own.toStdString()) == changed) == (answer == Unsaved::Save));
        if (stays) {
            QVERIFY(w.scenario() == changed);
            QCOMPARE(w.document().filePath(), own);
            QCOMPARE(w.document().undoStack()->count(), 1);
            QCOMPARE(w.workspace.selection().ids(), std::vector<std::string>{"berg-2"});
            QVERIFY(w.window().isWindowModified());
        } else if (path == Exit::New) {
            QVERIFY(w.scenario().icebergs.empty());
            QVERIFY(w.document().filePath().isEmpty());
        } else if (path == Exit::Example) {
            QVERIFY(w.scenario() == loadExample(examplePaths().front()));
        } else if (!closes) {
            QVERIFY(w.scenario() == three(33));
        }
    }

    void everyExitAsksAboutTheFlight_data()
    {
        QTest::addColumn<Exit>("path");
        QTest::addColumn<bool>("changed");
        for (const auto& [path, name] : kExits) {
            if (path == Exit::Close || path == Exit::Quit)
                continue;
            QTest::addRow("%s", name) << path << false;
            QTest::addRow("%s, changed", name) << path << true;
        }
    }

    /** One question for the flight and what is unsaved. */
    void everyExitAsksAboutTheFlight()
    {
        QFETCH(Exit, path);
        QFETCH(bool, changed);
        WindowFixture w(three());
        const QString other = prepareFiles(w, path);
        if (changed)
            change(w);
        QVERIFY(w.untilReady());
        w.workspace.stepTicks(50);
        QVERIFY(w.until([&] { return w.workspace.isMidFlight(); }));
        const Scenario flown = w.scenario();
        leave(w, path, other);
        QCOMPARE(w.interaction.unsavedNames.size(), changed ? 1 : 0);
        QCOMPARE(w.interaction.mentionedFlight, changed);
        QCOMPARE(w.interaction.endFlightQuestions, changed ? 0 : 1);
        QVERIFY(w.window().isVisible() && w.workspace.isMidFlight());
        QVERIFY(w.scenario() == flown);

        w.interaction.unsaved = Unsaved::Discard;
        w.interaction.endsFlight = true;
        leave(w, path, other);
        QCOMPARE(w.interaction.unsavedNames.size() + w.interaction.endFlightQuestions, 2);
        QVERIFY(w.window().isVisible() && !w.workspace.inFlight());
        QVERIFY(!(w.scenario() == flown));
        if (!changed)
            QVERIFY(w.interaction.flightEnd == Interaction::FlightEnd::Other);
        QVERIFY(w.interaction.runQuestions.empty());
    }

    /** It is in the list of runs. */
    void flightThatHasEndedIsLeftWithoutAQuestion()
    {
        WindowFixture w(three());
        w.workspace.fly(kFastestRate);
        QVERIFY(w.until(RunPhase::Finished));
        w.trigger(u"newAction"_s);
        QVERIFY(w.scenario().icebergs.empty());
        QCOMPARE(w.interaction.endFlightQuestions, 0);
        QCOMPARE(w.workspace.runs().runs().size(), std::size_t{1});
    }

    /** Saving as a way out that fails or is cancelled is no way out. */
    void failedSaveStays_data()
    {
        QTest::addColumn<QString>("path");
        QTest::newRow("cancelled") << QString();
        QTest::newRow("unwritable") << u"/nowhere/x.berg"_s;
    }

    void failedSaveStays()
    {
        QFETCH(QString, path);
        WindowFixture w(three());
        change(w);
        w.interaction.unsaved = Unsaved::Save;
        w.interaction.path = path;
        QVERIFY(!w.window().close());
        QVERIFY(w.window().isVisible());
        QVERIFY(!w.document().isClean());
        w.trigger(u"newAction"_s);
        QCOMPARE(w.scenario().icebergs.size(), 3U);
    }

    void unchangedScenarioIsLeftWithoutAQuestion()
    {
        WindowFixture w(three());
        change(w);
        w.trigger(u"undoAction"_s);
        w.trigger(u"newAction"_s);
        QVERIFY(w.window().close());
        QVERIFY(w.interaction.unsavedNames.isEmpty());
    }

    void typingIsAChange_data()
    {
        QTest::addColumn<Exit>("path");
        QTest::addColumn<QString>("field");
        const std::pair<Exit, const char*> paths[] = {
            {Exit::New, "new"}, {Exit::Drop, "drop"}, {Exit::Close, "close"}};
        for (const auto& [path, name] : paths)
            for (const char* field : {"icebergs.name", "icebergs.q_m2ps", "tauField"})
                QTest::addRow("%s, %s", name, field) << path << QString::fromLatin1(field);
    }

    /** Text that is typed but not yet confirmed counts as a change. */
    void typingIsAChange()
    {
        QFETCH(Exit, path);
        QFETCH(QString, field);
        WindowFixture w(three());
        const QString other = w.file(u"other.berg"_s);
        saveScenario(three(33), other.toStdString());
        w.workspace.selection().set({"berg-2"});
        w.window().findChild<QDockWidget*>(u"inspectorDock"_s)->raise();
        auto& input = test::child<QWidget>(w.window(), field);
        QVERIFY(w.until([&] { return input.isVisible(); }));
        input.setFocus();
        QTest::keyClick(&input, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(&input, u"3"_s);
        leave(w, path, other);
        QCOMPARE(w.interaction.unsavedNames.size(), 1);
        QVERIFY(w.window().isVisible());
        const Iceberg& iceberg = w.scenario().icebergs[1];
        QVERIFY(iceberg.name == "3" || iceberg.q_m2ps == 3 || w.scenario().planner.tau == 3);
    }

    /** Ctrl+S from the field that is being typed in saves what one sees. */
    void typingIsSaved_data()
    {
        QTest::addColumn<QString>("field");
        for (const char* field : {"icebergs.q_m2ps", "tauField"})
            QTest::newRow(field) << QString::fromLatin1(field);
    }

    void typingIsSaved()
    {
        QFETCH(QString, field);
        WindowFixture w(three());
        w.workspace.selection().set({"berg-2"});
        w.window().findChild<QDockWidget*>(u"inspectorDock"_s)->raise();
        auto& input = test::child<QWidget>(w.window(), field);
        QVERIFY(w.until([&] { return input.isVisible(); }));
        input.setFocus();
        QTest::keyClick(&input, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(&input, u"3"_s);
        w.interaction.path = w.file(u"typed.berg"_s);
        QTest::keyClick(&input, Qt::Key_S, Qt::ControlModifier);
        const Scenario saved = loadScenario(w.interaction.path.toStdString());
        QVERIFY(saved.icebergs[1].q_m2ps == 3 || saved.planner.tau == 3);
        QVERIFY(saved == w.scenario());
        QVERIFY(w.document().isClean());
    }

    /** It was opened before there was a window. */
    void fileOfTheCommandLineIsRecent()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const QString path = w.file(u"named.berg"_s);
        saveScenario(randomScenario(7), path.toStdString());
        Workspace workspace;
        workspace.openFile(path);
        const MainWindowHost holder(workspace, w.interaction, w.settings);
        QCOMPARE(w.settings.value(u"files/recent"_s).toStringList().value(0), path);
    }

    void dialogsBeginInTheLastFolder()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QVERIFY(QDir(w.folder.path()).mkdir(u"sub"_s));
        const QString path = w.file(u"sub/one.berg"_s);
        saveScenario(randomScenario(7), path.toStdString());
        QString begun;
        const auto answer = [&](const QString& file) {
            auto* poll = new QTimer(&w.window());
            poll->start();
            QObject::connect(poll, &QTimer::timeout, &w.window(), [&begun, file, poll] {
                auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
                if (dialog == nullptr)
                    return;
                poll->stop();
                begun = dialog->directory().absolutePath();
                test::child<QLineEdit>(*dialog, u"fileNameEdit"_s).setText(file);
                if (file.isEmpty())
                    dialog->reject();
                else
                    static_cast<QDialog*>(dialog)->accept();
            });
        };
        const QString filter = u"Scenarios (*.berg)"_s;
        answer(path);
        QCOMPARE(DialogInteraction(&w.settings).openPath(&w.window(), filter), path);
        answer({});
        QCOMPARE(DialogInteraction(&w.settings).savePath(&w.window(), u"two"_s, filter), QString());
        QCOMPARE(begun, QFileInfo(path).absolutePath());
    }
};

QTEST_MAIN(TestMainWindowFiles)
#include "tst_main_window_files.moc"
