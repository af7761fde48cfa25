#include "app/window/window_run.h"
#include "core/base/random.h"
#include "core/io/files/scenario_json.h"
#include "core/io/study/study_json.h"
#include "core/presets/presets.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/study_builder.h"
#include "widgets/document/document_file.h"
#include "widgets/document/scenario_document.h"
#include "widgets/study/study_autosaver.h"
#include "widgets/theme/language.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QMainWindow>
#include <QProcess>
#include <QSlider>
#include <QTemporaryDir>
#include <QTimer>

#include <fcntl.h>
#include <unistd.h>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

constexpr int kSteps = 100;             ///< of the slider for each unit of tau
constexpr qint64 kMostLost_ms = 10'000; ///< of work

/** Notes of the program to be killed, one per line, for the process that kills it. */
class Journal
{
public:
    explicit Journal(const char* path) : m_fd(::open(path, O_WRONLY | O_CREAT | O_APPEND, 0600)) {}

    void add(const char* what, qint64 value) const
    {
        const QByteArray line = QByteArray::number(QDateTime::currentMSecsSinceEpoch()) + ' ' +
                                what + ' ' + QByteArray::number(value) + '\n';
        if (::write(m_fd, line.constData(), static_cast<std::size_t>(line.size())) != line.size())
            std::abort();
    }

private:
    int m_fd;
};

struct JournalEntry
{
    qint64 at_ms = 0;
    QByteArray what;
    qint64 value = 0;
};

std::vector<JournalEntry> entriesOf(const QString& path)
{
    std::vector<JournalEntry> entries;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return entries;
    for (const QByteArray& line : file.readAll().split('\n'))
        if (const QList<QByteArray> words = line.split(' '); words.size() == 3)
            entries.push_back({words[0].toLongLong(), words[1], words[2].toLongLong()});
    return entries;
}

/** Returns the last value noted under `what` at `until_ms` or before, or -1 if there is none. */
qint64 lastOf(const std::vector<JournalEntry>& entries, const QByteArray& what, qint64 until_ms)
{
    qint64 value = -1;
    for (const JournalEntry& entry : entries)
        if (entry.what == what && entry.at_ms <= until_ms)
            value = entry.value;
    return value;
}

/** Somebody at the window who raises tau step by step, saves now and then, and rests at times. */
class Editor
{
public:
    Editor(const char* journal, std::uint64_t seed) : m_journal(journal), m_random(seed, 3) {}

    void act()
    {
        QMainWindow* window = nullptr;
        for (QWidget* widget : QApplication::topLevelWidgets())
            if (auto* main = qobject_cast<QMainWindow*>(widget))
                window = main;
        if (window == nullptr || !window->isVisible() || --m_rest > 0)
            return;
        auto& slider = test::child<QSlider>(*window, u"tauSlider"_s);
        if (m_random.below(15) == 0) {
            m_journal.add("saving", slider.value());
            test::child<QAction>(*window, u"saveAction"_s).trigger();
            m_journal.add("saved", slider.value());
        } else {
            QTest::keyClick(&slider, Qt::Key_Right);
            m_journal.add("edit", slider.value());
        }
        if (m_random.below(60) == 0)
            m_rest = 60;
    }

private:
    Journal m_journal;
    Random m_random;
    int m_rest = 0; ///< turns
};

int edit(int argc, char** argv)
{
    QApplication app(argc, argv);
    QApplication::setApplicationName(u"bergwatch"_s);
    installLanguage(u"en"_s);
    Editor editor(argv[4], QByteArray(argv[5]).toULongLong());
    QTimer turn;
    QObject::connect(&turn, &QTimer::timeout, [&] { editor.act(); });
    turn.start(50);
    return runWindow(
        {.scenario = QString::fromLocal8Bit(argv[3]), .config = QString::fromLocal8Bit(argv[2])});
}

/** Flies a study without an end. */
int study(int argc, char** argv)
{
    QCoreApplication app(argc, argv);
    const Journal journal(argv[4]);
    StudyRunner runner;
    StudyAutosaver keeper(runner);
    keeper.start(QString::fromLocal8Bit(argv[2]));
    QObject::connect(&runner, &StudyRunner::updated,
                     [&] { journal.add("edit", static_cast<qint64>(runner.flown())); });
    runner.start(test::quickStudy(1'000'000));
    return QCoreApplication::exec();
}

int rounds()
{
    bool isNumber = false;
    const int number = qEnvironmentVariableIntValue("BERGWATCH_KILLS", &isNumber);
    return isNumber ? number : 2;
}

} // namespace

/**
 * The program is killed at any instant; what is there then is looked at as the next start does.
 * BERGWATCH_KILLS says how often, BERGWATCH_MONKEY_SEED from which seed on.
 */
class TestKill : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_dir;
    QString m_journal;
    qint64 m_worst_ms = 0;

    [[nodiscard]] QString path(const QString& name) const { return m_dir->filePath(name); }
    [[nodiscard]] QStringList names(const QString& folder) const
    {
        return QDir(path(folder)).entryList(QDir::Files | QDir::Hidden);
    }

    /** Lets it work for a random time from its first entry on; the instant of its end. */
    qint64 killedAt_ms(const QString& mode, const QString& first, const QString& second,
                       std::uint64_t seed)
    {
        QProcess victim;
        victim.setProcessChannelMode(QProcess::ForwardedChannels);
        victim.start(QCoreApplication::applicationFilePath(),
                     {mode, first, second, m_journal, QString::number(seed)});
        if (!victim.waitForStarted() ||
            !QTest::qWaitFor([&] { return !entriesOf(m_journal).empty(); }, 60000))
            qFatal("nothing to kill");
        Random random(seed, 8);
        QTest::qWait(static_cast<int>(random.uniform(0, 13'000)));
        const qint64 now_ms = QDateTime::currentMSecsSinceEpoch();
        victim.kill();
        victim.waitForFinished();
        return now_ms;
    }

    /** Nothing done longer ago than what may be lost is missing. */
    void checkLoss(const std::vector<JournalEntry>& entries, qint64 recovered, qint64 killed_ms)
    {
        for (const JournalEntry& entry : entries)
            if (entry.what == "edit" && entry.value > recovered) {
                m_worst_ms = std::max(m_worst_ms, killed_ms - entry.at_ms);
                break;
            }
        const qint64 due = lastOf(entries, "edit", killed_ms - kMostLost_ms);
        QVERIFY2(recovered >= due, qPrintable(u"%1 of %2"_s.arg(recovered).arg(due)));
    }

    static void addSeeds()
    {
        QTest::addColumn<int>("seed");
        bool isNumber = false;
        const int given = qEnvironmentVariableIntValue("BERGWATCH_MONKEY_SEED", &isNumber);
        const int first = isNumber ? given : 1;
        for (int seed = first; seed < first + rounds(); ++seed)
            QTest::addRow("seed %d", seed) << seed;
    }

private slots:
    void init()
    {
        m_dir = std::make_unique<QTemporaryDir>();
        m_journal = path(u"journal"_s);
    }
    void cleanupTestCase() { qInfo("at most %lld ms of work were lost", m_worst_ms); }

    void editsAreRecovered_data() { addSeeds(); }
    void editsAreRecovered()
    {
        QFETCH(int, seed);
        QVERIFY(QDir(m_dir->path()).mkdir(u"work"_s));
        const QString file = path(u"work/watch.berg"_s);
        Scenario original = randomScenario(seed, {.icebergs = 5});
        original.planner.tau = 0;
        saveScenario(original, file.toStdString());
        const qint64 killed_ms = killedAt_ms(u"--edit"_s, path(u"settings.ini"_s), file,
                                             static_cast<std::uint64_t>(seed));
        const std::vector<JournalEntry> entries = entriesOf(m_journal);

        // The file is whole, the one that was saved last or the one being saved.
        Scenario saved = loadScenario(file.toStdString());
        const qint64 inFile = std::llround(saved.planner.tau * kSteps);
        QVERIFY(inFile >= std::max<qint64>(0, lastOf(entries, "saved", killed_ms)));
        QVERIFY(inFile <= std::max<qint64>(0, lastOf(entries, "saving", killed_ms)));
        saved.planner.tau = 0;
        QVERIFY(saved == original);

        // The next start.
        const FoundRecoveries found =
            RecoveryStore(path(u"settings.ini.data/recovery"_s)).abandoned();
        QVERIFY(found.damaged.isEmpty());
        QVERIFY(found.usable.size() <= 1);
        qint64 recovered = inFile;
        for (const FoundRecovery& recovery : found.usable) {
            recovered =
                std::max<qint64>(recovered, std::llround(recovery.scenario.planner.tau * kSteps));
            QCOMPARE(recovery.info.originalPath, file);
            removeRecovery(recovery.held.files);
        }
        checkLoss(entries, recovered, killed_ms);
        ScenarioDocument document;
        DocumentFile opened(document);
        opened.setLockFolder(path(u"settings.ini.data/locks"_s));
        document.open(file);
        QStringList left = names(u"work"_s);
        left.removeAll(u"watch.berg"_s);
        left.removeAll(u"watch.berg~"_s);
        QVERIFY2(left.isEmpty(), qPrintable(left.join(u' ')));
        QCOMPARE(names(u"settings.ini.data/locks"_s).size(), 1); // that of `opened`
        QCOMPARE(names(u"settings.ini.data/recovery"_s).size(), std::ssize(found.usable));
    }

    void studiesAreRecovered_data() { addSeeds(); }
    void studiesAreRecovered()
    {
        QFETCH(int, seed);
        const QString folder = path(u"studies"_s);
        const qint64 killed_ms =
            killedAt_ms(u"--study"_s, folder, {}, static_cast<std::uint64_t>(seed));
        StudyRunner runner;
        std::shared_ptr<const Study> found;
        {
            StudyAutosaver keeper(runner);
            connect(&keeper, &StudyAutosaver::found, this,
                    [&](const std::shared_ptr<const Study>& study) { found = study; });
            keeper.start(folder);
            const bool isThere = !names(u"studies"_s).filter(u".bergstudy"_s).isEmpty();
            keeper.findAbandoned();
            QVERIFY(!isThere || QTest::qWaitFor([&] { return found != nullptr; }, 60000));
        }
        checkLoss(entriesOf(m_journal), found ? static_cast<qint64>(flownCount(*found)) : 0,
                  killed_ms);
        QVERIFY2(names(u"studies"_s).isEmpty(), qPrintable(names(u"studies"_s).join(u' ')));
    }
};

int main(int argc, char** argv)
{
    const QByteArray mode = argc == 6 ? QByteArray(argv[1]) : QByteArray();
    if (mode == "--edit")
        return edit(argc, argv);
    if (mode == "--study")
        return study(argc, argv);
    QCoreApplication app(argc, argv);
    TestKill test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_kill.moc"
