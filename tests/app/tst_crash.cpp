#include "app/window/window_run.h"
#include "core/io/files/scenario_json.h"
#include "core/io/text/atomic_file.h"
#include "core/presets/presets.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "widgets/theme/language.h"
#include "widgets/workspace/workspace.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QMainWindow>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSlider>
#include <QTemporaryDir>
#include <QTimer>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** The window on screen, none yet: null. */
QMainWindow* mainWindow()
{
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (auto* window = qobject_cast<QMainWindow*>(widget); window != nullptr)
            return window;
    return nullptr;
}

/** Pulls at the slider as a hand does and then leaves the window alone. */
bool edit()
{
    QMainWindow* window = mainWindow();
    if (window == nullptr || !window->isVisible())
        return false;
    auto& slider = test::child<QSlider>(*window, u"tauSlider"_s);
    const QPoint middle = slider.rect().center();
    QTest::mousePress(&slider, Qt::LeftButton, {}, middle);
    for (int i = 1; i <= 10; ++i)
        QTest::mouseMove(&slider, middle + QPoint(4 * i, 0));
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, middle + QPoint(40, 0));
    return window->isWindowModified();
}

/** Restores what is offered; then saves and closes. */
bool restore()
{
    if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
        dialog->findChild<QPushButton*>(u"restoreButton"_s)->click();
        return false;
    }
    QMainWindow* window = mainWindow();
    if (window == nullptr || !window->isWindowModified())
        return false;
    window->findChild<QAction*>(u"saveAction"_s)->trigger();
    window->close();
    return true;
}

/** Takes a copy of the file that is in use; fails when nobody asks. */
bool takeCopy()
{
    static bool asked = false;
    if (auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
        for (QAbstractButton* button : question->buttons())
            if (button->text() == u"Open a copy"_s) {
                asked = true;
                button->click();
                break;
            }
        return false;
    }
    QMainWindow* window = mainWindow();
    if (window == nullptr || !window->windowTitle().contains(u" - Random field 3"_s))
        return false;
    const bool isCopy = asked && window->windowFilePath().isEmpty();
    QApplication::exit(isCopy ? 0 : 1);
    return true;
}

/** The whole program, used by `act`, which is asked again and again until it has done its work. */
int runProgram(int argc, char** argv, bool (*act)())
{
    QApplication app(argc, argv);
    QApplication::setApplicationName(u"bergwatch"_s);
    installLanguage(u"en"_s);
    QTimer hand;
    QObject::connect(&hand, &QTimer::timeout, [&] {
        if (act())
            hand.stop();
    });
    hand.start(20);
    return runWindow(
        {.scenario = QString::fromLocal8Bit(argv[3]), .config = QString::fromLocal8Bit(argv[2])});
}

} // namespace

/** The program is killed in the middle of work, and started again. */
class TestCrash : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_dir;
    QString m_file = m_dir.filePath(u"watch.berg"_s);

    void start(QProcess& program, const QString& mode, const QString& file) const
    {
        program.setProcessChannelMode(QProcess::ForwardedChannels);
        program.start(QCoreApplication::applicationFilePath(),
                      {mode, m_dir.filePath(u"settings.ini"_s), file});
        QVERIFY(program.waitForStarted());
    }
    [[nodiscard]] QStringList recoveries(const QString& pattern = u"*.berg"_s) const
    {
        const QDir folder(m_dir.filePath(u"settings.ini.data/recovery"_s));
        QStringList paths;
        for (const QString& name : folder.entryList({pattern}, QDir::Files))
            paths << folder.filePath(name);
        return paths;
    }

private slots:
    void killedAndRestored()
    {
        const Scenario original = randomScenario(3, {.icebergs = 5});
        saveScenario(original, m_file.toStdString());
        QProcess victim;
        start(victim, u"--edit"_s, m_file);
        QTRY_VERIFY_WITH_TIMEOUT(recoveries(u"*.json"_s).size() == 1, 60000);
        QVERIFY(loadScenario(m_file.toStdString()) == original);
        victim.kill(); // SIGKILL: no chance to tidy up
        QVERIFY(victim.waitForFinished());
        QCOMPARE(victim.exitStatus(), QProcess::CrashExit);
        QCOMPARE(recoveries().size(), 1);
        const std::string unsaved = readFile(recoveries().front().toStdString());
        QVERIFY(scenarioFromJson(unsaved, "recovery") != original);

        QProcess next;
        start(next, u"--restore"_s, {});
        QVERIFY(next.waitForFinished(60000));
        QCOMPARE(next.exitStatus(), QProcess::NormalExit);
        QCOMPARE(next.exitCode(), 0);
        QVERIFY(readFile(m_file.toStdString()) == unsaved); // bit for bit
        QVERIFY(recoveries(u"*"_s).isEmpty());
    }

    void fileNamedAtTheStartIsInUse()
    {
        saveScenario(randomScenario(3, {.icebergs = 5}), m_file.toStdString());
        Workspace holder;
        holder.file().setLockFolder(m_dir.filePath(u"settings.ini.data/locks"_s));
        holder.openFile(m_file);
        QProcess program;
        start(program, u"--copy"_s, m_file);
        QVERIFY(program.waitForFinished(60000));
        QCOMPARE(program.exitStatus(), QProcess::NormalExit);
        QCOMPARE(program.exitCode(), 0);
    }
};

int main(int argc, char** argv)
{
    const QByteArray mode = argc == 4 ? QByteArray(argv[1]) : QByteArray();
    if (mode == "--edit")
        return runProgram(argc, argv, edit);
    if (mode == "--restore")
        return runProgram(argc, argv, restore);
    if (mode == "--copy")
        return runProgram(argc, argv, takeCopy);
    QCoreApplication app(argc, argv);
    TestCrash test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_crash.moc"
