#include "core/io/study/study_json.h"
#include "core/io/text/atomic_file.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "tests/support/window/study_builder.h"
#include "widgets/study/study_autosaver.h"

#include <QDir>
#include <QTemporaryDir>

#include <functional>

using namespace berg;
using namespace Qt::StringLiterals;
using test::kPatience_ms;

namespace {

/** A runner and the autosaver of its study, as in one window. */
struct Window
{
    explicit Window(const QString& folder, int interval_ms = 10)
    {
        keeper.start(folder, interval_ms);
        QObject::connect(&keeper, &StudyAutosaver::found, &context,
                         [this](const std::shared_ptr<const Study>& study) { found = study; });
        QObject::connect(&keeper, &StudyAutosaver::damaged, &context,
                         [this](const QString& path) { damaged << path; });
        QObject::connect(&keeper, &StudyAutosaver::failed, &context,
                         [this](const QString& report) { failures << report; });
    }

    StudyRunner runner;
    StudyAutosaver keeper{runner};
    QObject context;
    std::shared_ptr<const Study> found;
    QStringList failures;
    QStringList damaged;
};

} // namespace

class TestStudyKeeper : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_dir;
    [[nodiscard]] QString folder() const { return m_dir->filePath(u"studies"_s); }
    [[nodiscard]] QStringList savedFiles() const
    {
        return QDir(folder()).entryList({u"*.bergstudy"_s}, QDir::Files);
    }
    /** Leaves a study as a killed program does. */
    Study leave()
    {
        Window window(folder());
        window.runner.start(test::quickStudy());
        if (!QTest::qWaitFor([&] { return window.runner.isComplete(); }, kPatience_ms))
            qFatal("not flown");
        window.keeper.keep();
        return window.runner.result()->study;
    }

private slots:
    void init()
    {
        test::failOnWarnings();
        m_dir = std::make_unique<QTemporaryDir>();
    }

    void studyIsSavedWhileItIsFlown()
    {
        Window window(folder());
        window.runner.start(test::endlessStudy());
        QTRY_COMPARE_WITH_TIMEOUT(savedFiles().size(), 1, kPatience_ms);
        const QString path = QDir(folder()).filePath(savedFiles().front());
        QTRY_VERIFY_WITH_TIMEOUT(flownCount(loadStudy(path.toStdString())) > 0, kPatience_ms);
        QVERIFY(window.failures.isEmpty());
    }

    void recoveryIsRemovedAtANormalEnd()
    {
        {
            Window window(folder());
            window.runner.start(test::quickStudy());
            QTRY_COMPARE_WITH_TIMEOUT(savedFiles().size(), 1, kPatience_ms);
        }
        QVERIFY(QDir(folder()).entryList(QDir::Files | QDir::Hidden).isEmpty());
    }

    void abandonedStudyIsFoundAgain()
    {
        const Study left = leave();
        QCOMPARE(savedFiles().size(), 1);
        Window next(folder());
        next.keeper.findAbandoned();
        QTRY_VERIFY_WITH_TIMEOUT(next.found != nullptr, kPatience_ms);
        QCOMPARE(flownCount(*next.found), flownCount(left));
        next.runner.restore(*next.found);
        QTRY_VERIFY_WITH_TIMEOUT(next.runner.result() != nullptr, kPatience_ms);
        QVERIFY(next.runner.unsaved_s() > 0);
        QCOMPARE(savedFiles().size(), 1); // until it is saved

        next.runner.noteSaved(next.runner.savePoint());
        next.keeper.follow();
        QTRY_VERIFY_WITH_TIMEOUT(savedFiles().isEmpty(), kPatience_ms);
    }

    void whatIsStillBeingReadStays_data()
    {
        QTest::addColumn<std::function<void(StudyAutosaver&)>>("end");
        const auto row = [](const char* name, std::function<void(StudyAutosaver&)> end) {
            QTest::newRow(name) << std::move(end);
        };
        row("closed", [](StudyAutosaver&) {});
        row("ended by the desktop", [](StudyAutosaver& keeper) { keeper.keep(); });
        row("nothing to save", [](StudyAutosaver& keeper) { keeper.discard(); });
        row("another study", [](StudyAutosaver& keeper) { keeper.follow(); });
    }

    void whatIsStillBeingReadStays()
    {
        QFETCH(std::function<void(StudyAutosaver&)>, end);
        leave();
        {
            Window window(folder());
            window.keeper.findAbandoned();
            end(window.keeper);
        }
        QCOMPARE(savedFiles().size(), 1);
    }

    void oneInUseIsLeftAlone()
    {
        leave();
        Window first(folder());
        first.keeper.findAbandoned();
        Window second(folder());
        second.keeper.findAbandoned();
        QTRY_VERIFY_WITH_TIMEOUT(first.found != nullptr, kPatience_ms);
        QVERIFY(second.found == nullptr);
    }

    void damagedIsSetAside()
    {
        leave();
        const QString path = QDir(folder()).filePath(savedFiles().front());
        writeFileAtomically(path.toStdString(), "{");
        Window next(folder());
        next.keeper.findAbandoned();
        QTRY_COMPARE_WITH_TIMEOUT(next.damaged, QStringList{path + u".damaged"_s}, kPatience_ms);
        QVERIFY(next.found == nullptr);
        QCOMPARE(readFile(path.toStdString() + ".damaged"), std::string("{"));
    }
};

QTEST_GUILESS_MAIN(TestStudyKeeper)
#include "tst_study_autosaver.moc"
