#include "core/io/files/scenario_json.h"
#include "core/presets/presets.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/window/window_fixture.h"

#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QStatusBar>
#include <QUndoStack>
#include <QUndoView>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;
using Action = RecoveryAnswer::Action;
using InUse = Interaction::InUse;
using Overwrite = Interaction::Overwrite;
using Unsaved = Interaction::Unsaved;

namespace {

Scenario three(std::int64_t seed = 31)
{
    return randomScenario(seed, {.icebergs = 3});
}

/** Closes the window as logging out does after all programs have agreed. */
void endProgram()
{
    QEvent end(QEvent::Quit);
    QCoreApplication::sendEvent(qApp, &end);
}

/** A window whose work is kept, as that of the program. */
struct SafeWindow : WindowFixture
{
    SafeWindow() : WindowFixture(three())
    {
        workspace.file().setLockFolder(file(u"locks"_s));
        workspace.autosaver().start(recovery(), {.pause_ms = 0, .longest_ms = 0});
    }
    [[nodiscard]] QString recovery() const { return file(u"recovery"_s); }

    /** The folder is as a killed program leaves it. */
    void leave(std::int64_t seed, const QString& path, const QDateTime& edited) const
    {
        const HeldRecovery held = RecoveryStore(recovery()).add();
        writeRecovery(held.files, three(seed), {.originalPath = path, .edited = edited});
    }
    [[nodiscard]] std::size_t leftOver() const
    {
        return RecoveryStore(recovery()).abandoned().usable.size();
    }
    void change() { dragTau(0.5, 0.8); }
    /** Comes back to the window from another one. */
    void comeBack()
    {
        QWidget other;
        other.show();
        other.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&other));
        other.hide();
        window().activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window()));
        QTest::qWait(0);
    }
    [[nodiscard]] QString openFile(std::int64_t seed = 34)
    {
        const QString own = file(u"own.berg"_s);
        saveScenario(three(seed), own.toStdString());
        interaction.path = own;
        trigger(u"openAction"_s);
        return own;
    }
};

} // namespace

/** Nothing is lost: recovery, files used by others, logging out, the history. */
class TestMainWindowSafety : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void saysWhenItWasAutosaved()
    {
        SafeWindow w;
        auto& label = test::child<QLabel>(w.window(), u"autosaveLabel"_s);
        QVERIFY(label.text().isEmpty());
        w.change();
        QVERIFY(w.until([&] { return label.text().startsWith(u"Autosaved "_s); }));
        w.interaction.path = w.file(u"a.berg"_s);
        w.trigger(u"saveAction"_s);
        QVERIFY(label.text().isEmpty());
    }

    void nothingLeftIsNoQuestion()
    {
        SafeWindow w;
        QVERIFY(!w.window().parts().safety.offerRecoveries());
        w.trigger(u"recoverAction"_s);
        QVERIFY(w.interaction.recoveryOffers.empty());
        QVERIFY(!w.window().statusBar()->currentMessage().isEmpty());
    }

    void restoredWorkIsUnsaved()
    {
        SafeWindow w;
        const QString own = w.file(u"own.berg"_s);
        saveScenario(three(1), own.toStdString());
        w.leave(77, own, QDateTime::currentDateTime().addSecs(60));
        w.interaction.recoveryAnswers = {{Action::Restore, 0}};
        QVERIFY(w.window().parts().safety.offerRecoveries());
        QCOMPARE(w.interaction.recoveryOffers.size(), 1U);
        const RecoveryOffer& offer = w.interaction.recoveryOffers[0].at(0);
        QCOMPARE(offer.name.toStdString(), three(77).name);
        QCOMPARE(offer.path, own);
        QVERIFY(!offer.edited.isEmpty());
        QVERIFY(w.scenario() == three(77));
        QVERIFY(w.window().isWindowModified());
        QCOMPARE(w.document().filePath(), own);
        QVERIFY(loadScenario(own.toStdString()) == three(1)); // not before the user says so

        w.trigger(u"saveAction"_s);
        QVERIFY(w.interaction.suggested.isEmpty());
        QVERIFY(w.interaction.overwriteReasons.isEmpty());
        QVERIFY(loadScenario(own.toStdString()) == three(77));
        QVERIFY(!w.window().isWindowModified());
        QVERIFY(
            w.until([&] { return QDir(w.recovery()).isEmpty(QDir::Files) || w.leftOver() == 0; }));
    }

    void restoredWorkWithoutAFileIsSavedAs()
    {
        SafeWindow w;
        w.leave(77, {}, QDateTime::currentDateTime());
        w.interaction.recoveryAnswers = {{Action::Restore, 0}};
        w.window().parts().safety.offerRecoveries();
        w.interaction.path = w.file(u"new.berg"_s);
        w.trigger(u"saveAction"_s);
        QCOMPARE(w.interaction.suggested.size(), 1);
        QVERIFY(loadScenario(w.interaction.path.toStdString()) == three(77));
    }

    /** The file was changed after the program had ended: saving over it is asked about. */
    void restoredWorkThatIsOlderThanItsFile()
    {
        SafeWindow w;
        const QString own = w.file(u"own.berg"_s);
        saveScenario(three(1), own.toStdString());
        w.leave(77, own, QDateTime::currentDateTime().addSecs(-3600));
        w.interaction.recoveryAnswers = {{Action::Restore, 0}};
        w.window().parts().safety.offerRecoveries();
        w.trigger(u"saveAction"_s);
        QCOMPARE(w.interaction.overwriteReasons.size(), 1);
        QVERIFY(loadScenario(own.toStdString()) == three(1));
        QVERIFY(w.window().isWindowModified());
    }

    void severalAreDealtWithOneByOne()
    {
        SafeWindow w;
        const QDateTime now = QDateTime::currentDateTime();
        for (int i = 0; i < 3; ++i)
            w.leave(70 + i, {}, now.addSecs(-i));
        w.interaction.recoveryAnswers = {{Action::Discard, 1}, {Action::Later, 0}};
        w.window().parts().safety.offerRecoveries();
        QCOMPARE(w.interaction.recoveryOffers.size(), 2U);
        QCOMPARE(w.interaction.recoveryOffers[0].size(), 3U);
        QCOMPARE(w.interaction.recoveryOffers[1].size(), 2U);
        QVERIFY(w.scenario() == three());
        QCOMPARE(w.leftOver(), 2U);

        w.interaction.recoveryAnswers.push_back({Action::Restore, 1});
        w.trigger(u"recoverAction"_s);
        QVERIFY(w.scenario() == three(72)); // the second of the two
        QCOMPARE(w.leftOver(), 1U);
    }

    void restoringOverUnsavedWorkAsks()
    {
        SafeWindow w;
        w.leave(77, {}, QDateTime::currentDateTime());
        w.change();
        const Scenario changed = w.scenario();
        w.interaction.recoveryAnswers = {{Action::Restore, 0}};
        w.trigger(u"recoverAction"_s);
        QCOMPARE(w.interaction.unsavedNames.size(), 1);
        QVERIFY(w.scenario() == changed);
        QCOMPARE(w.leftOver(), 1U);
    }

    void damagedWorkIsReportedAndKept()
    {
        SafeWindow w;
        w.leave(1, {}, QDateTime::currentDateTime());
        const QString name = QDir(w.recovery()).entryList({u"*.berg"_s}).value(0);
        QFile file(QDir(w.recovery()).filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{");
        file.close();
        QVERIFY(w.window().parts().safety.offerRecoveries());
        QCOMPARE(w.interaction.errors.size(), 1);
        QVERIFY(w.interaction.errors[0].contains(name + u".damaged"_s));
        QVERIFY(w.interaction.recoveryOffers.empty());
        QVERIFY(QFile::exists(file.fileName() + u".damaged"_s));
    }

    void fileInUseElsewhere_data()
    {
        QTest::addColumn<InUse>("answer");
        QTest::newRow("copy") << InUse::OpenCopy;
        QTest::newRow("anyway") << InUse::OpenAnyway;
        QTest::newRow("cancel") << InUse::Cancel;
    }
    void fileInUseElsewhere()
    {
        QFETCH(InUse, answer);
        SafeWindow w;
        const QString path = w.file(u"shared.berg"_s);
        saveScenario(three(50), path.toStdString());
        Workspace other;
        other.file().setLockFolder(w.file(u"locks"_s));
        other.openFile(path);

        w.interaction.path = path;
        w.interaction.inUse = answer;
        w.trigger(u"openAction"_s);
        QCOMPARE(w.interaction.holders.size(), 1);
        QVERIFY(
            w.interaction.holders[0].contains(QString::number(QCoreApplication::applicationPid())));
        QVERIFY(w.scenario() == (answer == InUse::Cancel ? three() : three(50)));
        QCOMPARE(w.document().filePath(), answer == InUse::OpenAnyway ? path : QString());
        QVERIFY(w.document().isClean());
    }

    void savingOverAFileInUseElsewhereAsks()
    {
        SafeWindow w;
        const QString path = w.file(u"shared.berg"_s);
        saveScenario(three(50), path.toStdString());
        Workspace other;
        other.file().setLockFolder(w.file(u"locks"_s));
        other.openFile(path);
        w.interaction.path = path;
        w.trigger(u"saveAsAction"_s);
        QCOMPARE(w.interaction.overwriteReasons.size(), 1);
        QVERIFY(loadScenario(path.toStdString()) == three(50));
        w.interaction.overwrite = Overwrite::Overwrite;
        w.trigger(u"saveAsAction"_s);
        QVERIFY(loadScenario(path.toStdString()) == three());
    }

    void savingOverAForeignChangeAsks_data()
    {
        QTest::addColumn<Overwrite>("answer");
        QTest::newRow("write") << Overwrite::Overwrite;
        QTest::newRow("save as") << Overwrite::SaveAs;
        QTest::newRow("cancel") << Overwrite::Cancel;
    }
    void savingOverAForeignChangeAsks()
    {
        QFETCH(Overwrite, answer);
        SafeWindow w;
        const QString own = w.openFile();
        w.change();
        const Scenario changed = w.scenario();
        saveScenario(three(60), own.toStdString());
        w.interaction.overwrite = answer;
        w.interaction.path = w.file(u"elsewhere.berg"_s);
        w.trigger(u"saveAction"_s);
        QCOMPARE(w.interaction.overwriteReasons.size(), 1);
        QVERIFY(w.scenario() == changed);
        QVERIFY(loadScenario(own.toStdString()) ==
                (answer == Overwrite::Overwrite ? changed : three(60)));
        QCOMPARE(QFile::exists(w.interaction.path), answer == Overwrite::SaveAs);
        QCOMPARE(w.window().isWindowModified(), answer == Overwrite::Cancel);
        w.trigger(u"saveAction"_s); // what was answered is answered
        QCOMPARE(w.interaction.overwriteReasons.size(), answer == Overwrite::Cancel ? 2 : 1);
    }

    void foreignChangeIsOfferedWhenTheWindowComesBack_data()
    {
        QTest::addColumn<bool>("reload");
        QTest::newRow("reload") << true;
        QTest::newRow("keep") << false;
    }
    void foreignChangeIsOfferedWhenTheWindowComesBack()
    {
        QFETCH(bool, reload);
        SafeWindow w;
        const QString own = w.openFile();
        w.comeBack();
        QVERIFY(w.interaction.reloadQuestions.isEmpty());
        saveScenario(three(60), own.toStdString());
        w.interaction.reload = reload;
        w.comeBack();
        QCOMPARE(w.interaction.reloadQuestions, QStringList{u"own.berg"_s});
        QVERIFY(w.scenario() == (reload ? three(60) : three(34)));
        w.comeBack(); // answered once for all
        QCOMPARE(w.interaction.reloadQuestions.size(), 1);
    }

    void unsavedWorkIsNotOfferedAForeignChange()
    {
        SafeWindow w;
        const QString own = w.openFile();
        w.change();
        saveScenario(three(60), own.toStdString());
        w.comeBack();
        QVERIFY(w.interaction.reloadQuestions.isEmpty());
    }

    void backupCopyIsAChoice()
    {
        SafeWindow w;
        QVERIFY(w.action(u"keepOldAction"_s).isChecked());
        const QString own = w.openFile();
        w.change();
        w.trigger(u"saveAction"_s);
        QVERIFY(loadScenario((own + u'~').toStdString()) == three(34));

        w.trigger(u"keepOldAction"_s);
        const QString second = w.file(u"second.berg"_s);
        saveScenario(three(35), second.toStdString());
        w.interaction.path = second;
        w.trigger(u"openAction"_s);
        w.change();
        w.trigger(u"saveAction"_s);
        QVERIFY(!QFile::exists(second + u'~'));
        const MainWindow next(w.workspace, w.interaction, w.settings);
        QVERIFY(!next.findChild<QAction*>(u"keepOldAction"_s)->isChecked());
    }

    void endOfTheSessionAsks_data()
    {
        QTest::addColumn<Unsaved>("answer");
        QTest::newRow("save") << Unsaved::Save;
        QTest::newRow("discard") << Unsaved::Discard;
        QTest::newRow("cancel") << Unsaved::Cancel;
    }
    void endOfTheSessionAsks()
    {
        QFETCH(Unsaved, answer);
        SafeWindow w;
        const QString own = w.openFile();
        w.change();
        const auto isSaved = [&] {
            return !QDir(w.recovery()).entryList({u"*.berg"_s}, QDir::Files).isEmpty();
        };
        QVERIFY(w.until(isSaved));
        w.interaction.unsaved = answer;
        QCOMPARE(w.window().parts().safety.mayEndSession(true), answer != Unsaved::Cancel);
        QCOMPARE(w.interaction.unsavedNames.size(), 1);
        QCOMPARE(loadScenario(own.toStdString()) == w.scenario(), answer == Unsaved::Save);
        QCOMPARE(isSaved(), answer == Unsaved::Cancel); // it may be killed from now on
        endProgram();
        QCOMPARE(w.window().isVisible(), answer == Unsaved::Cancel);
        // Asked once for both, unless the answer was to stay.
        QCOMPARE(w.interaction.unsavedNames.size(), answer == Unsaved::Cancel ? 2 : 1);
    }

    /** Another program has called it off: who closes the window later is asked as ever. */
    void endThatWasCalledOff_data()
    {
        QTest::addColumn<bool>("mayAsk");
        QTest::addColumn<bool>("comesBack");
        QTest::newRow("asked, window closed") << true << false;
        QTest::newRow("not asked, window closed") << false << false;
        QTest::newRow("asked, used, then ended") << true << true;
        QTest::newRow("not asked, used, then ended") << false << true;
    }
    void endThatWasCalledOff()
    {
        QFETCH(bool, mayAsk);
        QFETCH(bool, comesBack);
        SafeWindow w;
        w.change();
        w.interaction.unsaved = Unsaved::Discard;
        QVERIFY(w.window().parts().safety.mayEndSession(mayAsk));
        const auto asked = w.interaction.unsavedNames.size();
        w.interaction.unsaved = Unsaved::Cancel;
        if (comesBack) {
            QTest::keyClick(&w.map(), Qt::Key_Shift);
            endProgram();
        } else {
            w.window().close();
        }
        QVERIFY(w.window().isVisible());
        QCOMPARE(w.interaction.unsavedNames.size(), asked + 1);
    }

    /** It was kept because there was no time to ask; then it was called off, and given up. */
    void workGivenUpAfterAnEndThatWasCalledOff()
    {
        const QTemporaryDir folder;
        {
            WindowFixture w(three());
            w.workspace.autosaver().start(folder.path(), {.pause_ms = 0, .longest_ms = 0});
            w.dragTau(0.5, 0.8);
            QVERIFY(w.window().parts().safety.mayEndSession(false));
            QVERIFY(!QDir(folder.path()).isEmpty(QDir::Files));
            w.interaction.unsaved = Unsaved::Discard;
            QVERIFY(w.window().close());
        }
        QVERIFY(RecoveryStore(folder.path()).abandoned().usable.empty());
    }

    void changeAfterTheEndWasCalledOffIsAskedAbout()
    {
        SafeWindow w;
        w.change();
        w.interaction.unsaved = Unsaved::Discard;
        QVERIFY(w.window().parts().safety.mayEndSession(true)); // but another program calls it off
        w.dragTau(0.8, 0.2);
        w.interaction.unsaved = Unsaved::Cancel;
        QVERIFY(!w.window().close());
    }

    /** No time for questions: what is unsaved is there at the next start. */
    void endOfTheSessionWithoutAQuestion()
    {
        const QTemporaryDir folder;
        Scenario changed;
        {
            WindowFixture w(three());
            w.workspace.autosaver().start(folder.path());
            w.dragTau(0.5, 0.8);
            changed = w.scenario();
            QVERIFY(w.window().parts().safety.mayEndSession(false));
            endProgram();
            QVERIFY(w.interaction.unsavedNames.isEmpty());
            QVERIFY(!w.window().isVisible());
        }
        const FoundRecoveries found = RecoveryStore(folder.path()).abandoned();
        QCOMPARE(found.usable.size(), 1U);
        QVERIFY(found.usable[0].scenario == changed);
    }

    void discardedWorkIsNotOfferedAgain()
    {
        const QTemporaryDir folder;
        {
            WindowFixture w(three());
            w.workspace.autosaver().start(folder.path(), {.pause_ms = 0, .longest_ms = 0});
            w.dragTau(0.5, 0.8);
            QVERIFY(w.until([&] { return !QDir(folder.path()).isEmpty(QDir::Files); }));
            w.interaction.unsaved = Unsaved::Discard;
            QVERIFY(w.window().close());
        }
        QVERIFY(QDir(folder.path()).isEmpty(QDir::Files | QDir::Hidden));
    }

    void historyIsAPanel()
    {
        SafeWindow w;
        auto& dock = test::child<QDockWidget>(w.window(), u"historyDock"_s);
        QVERIFY(!dock.isVisible());
        dock.toggleViewAction()->trigger();
        QVERIFY(w.until([&] { return !dock.visibleRegion().isEmpty(); })); // before its tabs
        auto& list = test::child<QUndoView>(w.window(), {});
        const Scenario before = w.scenario();
        w.change();
        const Scenario after = w.scenario();
        QCOMPARE(list.model()->rowCount(), 2);
        list.setCurrentIndex(list.model()->index(0, 0));
        QVERIFY(w.scenario() == before);
        list.setCurrentIndex(list.model()->index(1, 0));
        QVERIFY(w.scenario() == after);
        QVERIFY(!list.cleanIcon().isNull());

        QVERIFY(w.untilReady());
        w.trigger(u"stepAction"_s);
        QVERIFY(w.until(RunPhase::Paused));
        QVERIFY(!list.isEnabled());
        w.trigger(u"resetAction"_s);
        QVERIFY(list.isEnabled());
    }

    /** The history goes on over a save: undone after it, the file no longer is what one sees. */
    void undoGoesBackBeyondASave()
    {
        SafeWindow w;
        const QString own = w.openFile();
        w.change();
        w.trigger(u"saveAction"_s);
        QVERIFY(!w.window().isWindowModified());
        w.trigger(u"undoAction"_s);
        QVERIFY(w.scenario() == three(34));
        QVERIFY(w.window().isWindowModified());
        w.trigger(u"redoAction"_s);
        QVERIFY(!w.window().isWindowModified());
    }
};

QTEST_MAIN(TestMainWindowSafety)
#include "tst_main_window_safety.moc"
