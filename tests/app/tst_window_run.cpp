#include "app/window/main_window.h"
#include "app/window/window_run.h"
#include "core/io/files/scenario_json.h"
#include "core/io/study/study_json.h"
#include "core/io/text/atomic_file.h"
#include "core/scenario/presets.h"
#include "tests/support/panel_test.h"
#include "tests/support/study_builder.h"
#include "widgets/model/workspace.h"

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QMessageBox>
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

/** Runs the window; `look` is asked again and again until it has seen what it waits for. */
int runUntil(const WindowOptions& options, const std::function<bool()>& look)
{
    QTimer hand;
    QObject::connect(&hand, &QTimer::timeout, [&] {
        if (look())
            QApplication::exit(0);
    });
    hand.start(20);
    constexpr int kPatience_ms = 60000;
    constexpr int kTooLate = 99;
    QTimer::singleShot(kPatience_ms, &hand, [] { QApplication::exit(kTooLate); });
    return runWindow(options);
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
        QString told;
        const auto closesTheMessage = [&] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                told = box->text();
                box->accept();
            }
            const MainWindow* window = mainWindow();
            return !told.isEmpty() && window != nullptr && window->isVisible() &&
                   QApplication::activeModalWidget() == nullptr;
        };
        QCOMPARE(
            runUntil({.scenario = path(name), .config = path(u"settings.ini"_s)}, closesTheMessage),
            0);
        QVERIFY(told.contains(name));
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
        saveScenario(randomScenario(3, {.icebergs = 2}), path(u"a.berg"_s).toStdString());
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
        saveScenario(randomScenario(3, {.icebergs = 2}), path(u"a.berg"_s).toStdString());
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
