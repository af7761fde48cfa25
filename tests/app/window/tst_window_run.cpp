#include "app/dialogs/interaction.h"
#include "app/dialogs/screen_fit.h"
#include "app/window/main_window.h"
#include "app/window/window_run.h"
#include "core/io/files/scenario_json.h"
#include "core/io/study/study_json.h"
#include "core/io/text/atomic_file.h"
#include "core/presets/presets.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/study_builder.h"
#include "widgets/theme/language.h"
#include "widgets/workspace/workspace.h"

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QScopeGuard>
#include <QScreen>
#include <QSettings>
#include <QTemporaryDir>
#include <QTimer>

#include <sys/stat.h>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

MainWindow* mainWindow()
{
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (auto* window = qobject_cast<MainWindow*>(widget); window != nullptr)
            return window;
    return nullptr;
}

/** Runs the window; `check` is asked again and again until it has seen what it waits for. */
int runUntil(const WindowOptions& options, const std::function<bool()>& check)
{
    QTimer hand;
    QObject::connect(&hand, &QTimer::timeout, [&] {
        if (check())
            QApplication::exit(0);
    });
    hand.start(20);
    constexpr int kPatience_ms = 60000;
    constexpr int kTooLate = 99;
    QTimer::singleShot(kPatience_ms, &hand, [] { QApplication::exit(kTooLate); });
    return runWindow(options);
}

/** Pictures wait for the flights of all policies in drawn worlds: here they are short. */
void saveBrief(const QString& file)
{
    Scenario scenario = randomScenario(3, {.icebergs = 2});
    scenario.duration_s = 60;
    saveScenario(scenario, file.toStdString());
}

/** Answers a message box as soon as it is shown and stores the texts of its buttons. */
void closeNextDialog(QStringList& texts)
{
    texts.clear();
    QTimer::singleShot(0, qApp, [&texts] {
        QWidget* dialog = QApplication::activeModalWidget();
        for (const QAbstractButton* button : dialog->findChildren<QAbstractButton*>())
            texts << button->text();
        dialog->close();
    });
}

} // namespace

/** The program with a window, from its command line to its end. */
class TestWindowRun : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_dir;
    [[nodiscard]] QString path(const QString& name) const { return m_dir.filePath(name); }

private slots:
    void init() { test::failOnWarnings(); }

    /** The window opens all the same and says what is wrong. */
    void fileThatCannotBeOpened_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("broken") << u"broken.berg"_s;
        QTest::newRow("missing") << u"missing.berg"_s;
        QTest::newRow("broken study") << u"broken.bergstudy"_s;
    }
    void fileThatCannotBeOpened()
    {
        QFETCH(QString, name);
        for (const QString& broken : {u"broken.berg"_s, u"broken.bergstudy"_s})
            writeFileAtomically(path(broken).toStdString(), "{");
        QString message;
        const auto closesTheMessage = [&] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                message = box->text();
                box->accept();
            }
            const MainWindow* window = mainWindow();
            return !message.isEmpty() && window != nullptr && window->isVisible() &&
                   QApplication::activeModalWidget() == nullptr;
        };
        QCOMPARE(
            runUntil({.scenario = path(name), .config = path(u"settings.ini"_s)}, closesTheMessage),
            0);
        QVERIFY(message.contains(name));
    }

    /** A window opens as large as it was left; the options go before that. */
    void windowKeepsItsSize()
    {
        const QString config = path(u"size.ini"_s);
        const QSize left_px(1111, 766);
        const auto open = [&](const std::optional<QSize>& asked_px, const auto& check) {
            QSize seen_px;
            runUntil({.config = config, .size_px = asked_px}, [&] {
                MainWindow* window = mainWindow();
                if (window == nullptr || !window->isVisible())
                    return false;
                seen_px = window->size();
                check(*window);
                return true;
            });
            return seen_px;
        };
        open(QSize(1000, 760), [&](MainWindow& window) {
            window.resize(left_px);
            window.close(); // saves it
        });
        const auto nothing = [](MainWindow&) {};
        QCOMPARE(open(std::nullopt, nothing), left_px);
        QCOMPARE(open(QSize(1300, 760), nothing), QSize(1300, 760));
    }

    /** Whatever was left, e.g. of another screen or with smaller text. */
    void windowFitsTheScreen()
    {
        const QSize screen_px = QApplication::primaryScreen()->availableSize();
        const auto stateOfNext = [&](const QByteArray& geometry) {
            const QString config = path(u"fit.ini"_s);
            {
                QSettings settings(config, QSettings::IniFormat);
                settings.setValue("window/geometry", geometry);
            }
            Qt::WindowStates state;
            runUntil({.config = config}, [&] {
                const MainWindow* window = mainWindow();
                if (window == nullptr || !window->isVisible())
                    return false;
                state = window->windowState();
                return true;
            });
            return state;
        };
        QWidget left;
        left.resize(screen_px + QSize(400, 400));
        QVERIFY(stateOfNext(left.saveGeometry()).testFlag(Qt::WindowMaximized));
        QVERIFY(!stateOfNext("no geometry").testFlag(Qt::WindowMaximized));
        QVERIFY(fitsScreen(QSize(1280, 800), QSize(1366, 840)));
        QVERIFY(!fitsScreen(QSize(1280, 800), QSize(1366, 768)));
        QVERIFY(!fitsScreen(QSize(1280, 800), QSize(910, 512))); // of text at 150 %
    }

    /** Its buttons are on the screen: it is no larger than that, not even for its parts. */
    void dialogsFitTheScreen()
    {
        const QSize large_px(1366, 768);
        const QSize small_px(910, 512); // of text at 150 %
        QCOMPARE(boundedDialog({1120, 700}, {600, 400}, large_px), QSize(1120, 700));
        QCOMPARE(boundedDialog({1120, 700}, {600, 400}, small_px), QSize(910, 472));
        QCOMPARE(boundedDialog({1120, 700}, {950, 500}, small_px), QSize(910, 472));
        QCOMPARE(boundedDialog({300, 200}, {600, 400}, small_px), QSize(600, 400));
        QDialog dialog;
        auto* tall = new QWidget;
        tall->setMinimumSize(dialog.screen()->availableSize() * 2);
        (new QVBoxLayout(&dialog))->addWidget(tall);
        dialog.resize(dialog.screen()->availableSize() * 3);
        boundToScreen(dialog);
        dialog.show();
        QVERIFY(fitsScreen(dialog.size(), dialog.screen()->availableSize()));
    }

    /** All that Qt itself writes: buttons, the dialog for files. */
    void ownTextsOfQtAreTranslated()
    {
        const auto language = qScopeGuard([] { installLanguage(u"en"_s); });
        installLanguage(u"nb"_s);
        const QMessageBox box(QMessageBox::NoIcon, {}, {}, QMessageBox::Cancel | QMessageBox::Yes);
        QCOMPARE(box.button(QMessageBox::Cancel)->text(), u"Avbryt"_s);
        QCOMPARE(box.button(QMessageBox::Yes)->text(), u"&Ja"_s);
        const QFileDialog files;
        QCOMPARE(files.labelText(QFileDialog::FileName), u"Fil&navn:"_s);
    }

    void everyAnswerOnUnsavedWorkHasAKey()
    {
        QStringList texts;
        closeNextDialog(texts);
        QCOMPARE(DialogInteraction().askUnsaved(nullptr, {.name = u"Name"_s}),
                 Interaction::Unsaved::Cancel);
        QVERIFY(texts.contains(u"&Discard"_s));
        closeNextDialog(texts);
        QCOMPARE(DialogInteraction().askUnsavedRun(nullptr, true), Interaction::Unsaved::Cancel);
        QVERIFY(texts.contains(u"&Save run..."_s) && texts.contains(u"&Discard"_s));
    }

    /** Without a dialog where the answer is quick; else one that can be called off. */
    void waitingEndsWithTheAnswerOrTheUser()
    {
        bool isDone = false;
        QTimer::singleShot(20, this, [&] { isDone = true; });
        DialogInteraction().waitUntil(
            nullptr, u"Waiting"_s,
            [&] { return isDone || QApplication::activeModalWidget() != nullptr; }, true);
        QVERIFY(isDone);

        QTimer poll;
        connect(&poll, &QTimer::timeout, this, [] {
            if (auto* dialog = qobject_cast<QProgressDialog*>(QApplication::activeModalWidget()))
                dialog->cancel();
        });
        poll.start(10);
        DialogInteraction().waitUntil(
            nullptr, u"Waiting"_s, [] { return false; }, true);
        QVERIFY(QApplication::activeModalWidget() == nullptr);
    }

    /** Nor does the window take input meanwhile. */
    void waitingThatCannotBeCancelledIsNotClosed()
    {
        bool isDone = false;
        bool isStillShown = false;
        QTimer poll;
        connect(&poll, &QTimer::timeout, this, [&] {
            QWidget* dialog = QApplication::activeModalWidget();
            if (dialog == nullptr)
                return;
            poll.stop();
            QTest::keyClick(dialog, Qt::Key_Escape);
            dialog->close();
            isStillShown = dialog->isVisible() && QApplication::activeModalWidget() == dialog;
            isDone = true;
        });
        poll.start(10);
        DialogInteraction().waitUntil(
            nullptr, u"Waiting"_s, [&] { return isDone; }, false);
        QVERIFY(isStillShown);
        QVERIFY(QApplication::activeModalWidget() == nullptr);
    }

    void longMessagesFitTheScreen()
    {
        const QString rows = u"<tr><td>%1</td></tr>"_s.arg(QString(2000, u'x')).repeated(300);
        QSize seen_px;
        QTimer::singleShot(0, this, [&] {
            seen_px = QApplication::activeModalWidget()->size();
            QApplication::activeModalWidget()->close();
        });
        DialogInteraction().showInformation(nullptr, u"Title"_s, u"<table>%1</table>"_s.arg(rows));
        const QSize screen_px = QApplication::primaryScreen()->availableSize();
        QVERIFY(seen_px.height() > screen_px.height() / 2);
        QVERIFY(seen_px.height() <= screen_px.height() && seen_px.width() <= screen_px.width());
    }

    /** It is saved to, and after a crash offered, from other folders as well. */
    void fileNamedFromItsFolder()
    {
        saveScenario(randomScenario(3, {.icebergs = 2}), path(u"own.berg"_s).toStdString());
        const QString before = QDir::currentPath();
        QVERIFY(QDir::setCurrent(m_dir.path()));
        QString shown;
        const int code =
            runUntil({.scenario = u"own.berg"_s, .config = path(u"settings.ini"_s)}, [&] {
                const MainWindow* window = mainWindow();
                shown = window != nullptr ? window->windowFilePath() : QString();
                return window != nullptr && window->isVisible();
            });
        QVERIFY(QDir::setCurrent(before));
        QCOMPARE(code, 0);
        QCOMPARE(shown, path(u"own.berg"_s));
    }

    void studyOpensBesideTheScenario()
    {
        saveStudy(test::fourCases()->study, path(u"a.bergstudy"_s).toStdString());
        const auto seesTheStudy = [] {
            const MainWindow* window = mainWindow();
            return window != nullptr &&
                   test::child<QDockWidget>(*window, u"studyDock"_s).isVisible();
        };
        QCOMPARE(runUntil({.scenario = path(u"a.bergstudy"_s), .config = path(u"settings.ini"_s)},
                          seesTheStudy),
                 0);
    }

    /** Nothing of the user's is changed by a picture. */
    void pictureLeavesTheSettingsAlone()
    {
        saveBrief(path(u"a.berg"_s));
        const std::string text = "[view]\nappearance=2\n";
        writeFileAtomically(path(u"given.ini"_s).toStdString(), text);
        QStringList expected = QDir(m_dir.path()).entryList() << u"picture.png"_s;
        expected.sort();
        QCOMPARE(runUntil({.scenario = path(u"a.berg"_s),
                           .config = path(u"given.ini"_s),
                           .screenshot = path(u"picture.png"_s)},
                          [] { return false; }),
                 0);
        QVERIFY(readFile(path(u"given.ini"_s).toStdString()) == text);
        QStringList present = QDir(m_dir.path()).entryList();
        present.sort();
        QCOMPARE(present, expected);
    }

    void pictureLeavesADeviceADevice()
    {
        saveBrief(path(u"a.berg"_s));
        const QString pipe = path(u"pipe"_s); // a device needs more rights to be made
        QCOMPARE(mkfifo(qPrintable(pipe), 0600), 0);
        QCOMPARE(runUntil({.scenario = path(u"a.berg"_s),
                           .config = pipe,
                           .screenshot = path(u"picture.png"_s)},
                          [] { return false; }),
                 0);
        struct stat status
        {
        };
        QCOMPARE(stat(qPrintable(pipe), &status), 0);
        QVERIFY(S_ISFIFO(status.st_mode));
    }

    void brokenFileIsNoPicture()
    {
        writeFileAtomically(path(u"broken.berg"_s).toStdString(), "{");
        QCOMPARE(runWindow({.scenario = path(u"broken.berg"_s), .screenshot = path(u"none.png"_s)}),
                 3);
        QVERIFY(!QFile::exists(path(u"none.png"_s)));
    }
};

QTEST_MAIN(TestWindowRun)
#include "tst_window_run.moc"
