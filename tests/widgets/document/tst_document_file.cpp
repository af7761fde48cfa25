#include "core/io/files/scenario_json.h"
#include "core/io/text/atomic_file.h"
#include "core/presets/presets.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/window/panel_test.h"
#include "widgets/document/document_file.h"
#include "widgets/document/scenario_document.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <unistd.h>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

Scenario three(std::int64_t seed = 1)
{
    return randomScenario(seed, {.icebergs = 3});
}

/** A document and its file, as in one window; several may share the folder. */
struct Window
{
    explicit Window(const QTemporaryDir& dir) { file.setLockFolder(dir.filePath(u"locks"_s)); }
    void setTau(double tau)
    {
        document.edit(u"tau"_s, [tau](Scenario& s) { s.planner.tau = tau; });
    }

    ScenarioDocument document;
    DocumentFile file{document};
};

} // namespace

class TestDocumentFile : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_dir;
    [[nodiscard]] QString path(const QString& name) const { return m_dir->filePath(name); }
    /** Writes a scenario as another program would. */
    void writeOutside(const QString& name, const Scenario& scenario) const
    {
        saveScenario(scenario, path(name).toStdString());
    }
    [[nodiscard]] std::string content(const QString& name) const
    {
        return readFile(path(name).toStdString());
    }

private slots:
    void init()
    {
        test::failOnWarnings();
        m_dir = std::make_unique<QTemporaryDir>();
        writeOutside(u"a.berg"_s, three(1));
        writeOutside(u"b.berg"_s, three(2));
    }

    void locksOfKilledProgramsAreRemoved()
    {
        QVERIFY(QDir(m_dir->path()).mkdir(u"locks"_s));
        for (const QString& name : {u"locks/0123.lock"_s, u".a.berg.4711-0.tmp"_s})
            writeFileAtomically(path(name).toStdString(), "4711\nfram\n");
        Window window(*m_dir);
        window.document.open(path(u"a.berg"_s));
        const auto names = [this](const QString& folder) {
            return QDir(path(folder)).entryList(QDir::Files | QDir::Hidden);
        };
        QCOMPARE(names(u"."_s), (QStringList{u"a.berg"_s, u"b.berg"_s}));
        QCOMPARE(names(u"locks"_s).size(), 1); // its own lock
        QVERIFY(!names(u"locks"_s).contains(u"0123.lock"_s));
    }

    void twoWindowsSeeEachOther()
    {
        Window first(*m_dir);
        Window second(*m_dir);
        first.document.open(path(u"a.berg"_s));
        QVERIFY(!first.file.otherHolder(path(u"a.berg"_s))); // not the window itself
        const std::optional<LockHolder> holder = second.file.otherHolder(path(u"a.berg"_s));
        QVERIFY(holder);
        QCOMPARE(holder->pid.value(), QCoreApplication::applicationPid());
        QVERIFY(!second.file.otherHolder(path(u"b.berg"_s)));
    }

    void linksMeanTheSameFile()
    {
        QVERIFY(QFile::link(path(u"a.berg"_s), path(u"link.berg"_s)));
        QVERIFY(QDir(m_dir->path()).mkdir(u"sub"_s));
        Window first(*m_dir);
        Window second(*m_dir);
        first.document.open(path(u"link.berg"_s));
        QVERIFY(second.file.otherHolder(path(u"a.berg"_s)));
        QVERIFY(second.file.otherHolder(path(u"sub/../a.berg"_s)));
    }

    void lockGoesWithTheDocument_data()
    {
        QTest::addColumn<QString>("how");
        for (const char* how : {"new", "another", "save as", "closed"})
            QTest::newRow(how) << QString::fromLatin1(how);
    }
    void lockGoesWithTheDocument()
    {
        QFETCH(QString, how);
        auto first = std::make_unique<Window>(*m_dir);
        const Window second(*m_dir);
        first->document.open(path(u"a.berg"_s));
        if (how == u"new"_s)
            first->document.reset(three());
        else if (how == u"another"_s)
            first->document.open(path(u"b.berg"_s));
        else if (how == u"save as"_s)
            first->file.save(path(u"c.berg"_s), false);
        else
            first.reset();
        QVERIFY(!second.file.otherHolder(path(u"a.berg"_s)));
        QCOMPARE(second.file.otherHolder(path(u"b.berg"_s)).has_value(), how == u"another"_s);
        QCOMPARE(second.file.otherHolder(path(u"c.berg"_s)).has_value(), how == u"save as"_s);
    }

    /** The first window keeps the lock, which passes on when that window closes. */
    void lockedFileCanBeOpenedAnyway()
    {
        auto first = std::make_unique<Window>(*m_dir);
        Window second(*m_dir);
        const Window third(*m_dir);
        first->document.open(path(u"a.berg"_s));
        second.document.open(path(u"a.berg"_s));
        QVERIFY(second.file.otherHolder(path(u"a.berg"_s)));
        first.reset();
        QVERIFY(!third.file.otherHolder(path(u"a.berg"_s)));
        second.file.save(path(u"a.berg"_s), false);
        QVERIFY(third.file.otherHolder(path(u"a.berg"_s)));
    }

    void nothingIsWrittenBesideTheFile()
    {
        const QStringList before = QDir(m_dir->path()).entryList(QDir::AllEntries | QDir::Hidden);
        ScenarioDocument document;
        DocumentFile file(document); // without a folder for locks
        document.open(path(u"a.berg"_s));
        QVERIFY(!file.otherHolder(path(u"a.berg"_s)));
        QCOMPARE(QDir(m_dir->path()).entryList(QDir::AllEntries | QDir::Hidden), before);
    }

    void changesOfOthersAreSeen()
    {
        Window w(*m_dir);
        QVERIFY(!w.file.isChangedOutside()); // no file yet
        w.document.open(path(u"a.berg"_s));
        QVERIFY(!w.file.isChangedOutside());
        writeOutside(u"a.berg"_s, three(7));
        QVERIFY(w.file.isChangedOutside());
        QVERIFY(w.file.isChangedOutside()); // the check changes nothing
        w.document.open(path(u"a.berg"_s));
        QVERIFY(!w.file.isChangedOutside());
    }

    /** The file changed while it was read: the window does not show its content. */
    void changeWhileItIsOpened()
    {
        Window w(*m_dir);
        connect(&w.document, &ScenarioDocument::replaced, this,
                [this] { writeOutside(u"a.berg"_s, three(7)); });
        w.document.open(path(u"a.berg"_s));
        QVERIFY(w.file.isChangedOutside());
    }

    void changeRightAfterSaving()
    {
        ScenarioDocument document;
        connect(&document, &ScenarioDocument::filePathChanged, this,
                [this] { writeOutside(u"a.berg"_s, three(7)); });
        DocumentFile file(document); // set up after the other one has written
        document.reset(three());
        file.save(path(u"a.berg"_s), false);
        QVERIFY(file.isChangedOutside());
    }

    void ownSavingIsNoChange()
    {
        Window w(*m_dir);
        w.document.open(path(u"a.berg"_s));
        for (int i = 1; i <= 3; ++i) {
            w.setTau(0.1 * i);
            w.file.save(path(u"a.berg"_s), true);
            QVERIFY(!w.file.isChangedOutside());
        }
    }

    /** `touch`, or a restored copy: another time, the same content. */
    void sameContentIsNoChange()
    {
        Window w(*m_dir);
        w.document.open(path(u"a.berg"_s));
        QFile file(path(u"a.berg"_s));
        QVERIFY(file.open(QIODevice::ReadWrite));
        QVERIFY(
            file.setFileTime(QDateTime({2030, 1, 1}, {0, 0}), QFileDevice::FileModificationTime));
        file.close();
        QVERIFY(!w.file.isChangedOutside());
    }

    void fileThatIsGoneIsNoChange()
    {
        Window w(*m_dir);
        w.document.open(path(u"a.berg"_s));
        QVERIFY(QFile::remove(path(u"a.berg"_s)));
        QVERIFY(!w.file.isChangedOutside());
        writeOutside(u"a.berg"_s, three(7)); // another file in its place
        QVERIFY(w.file.isChangedOutside());
    }

    void outdatedDocumentCountsAsChanged()
    {
        Window w(*m_dir);
        w.document.restore(three(5), path(u"a.berg"_s));
        QVERIFY(!w.file.isChangedOutside());
        w.file.setOutdated();
        QVERIFY(w.file.isChangedOutside());
        w.file.save(path(u"a.berg"_s), false);
        QVERIFY(!w.file.isChangedOutside());
    }

    /** The backup is the file as it was when the program started, however often it is saved. */
    void firstSaveKeepsTheOldFile()
    {
        const std::string old = content(u"a.berg"_s);
        QVERIFY(QFile::setPermissions(path(u"a.berg"_s), QFile::ReadOwner | QFile::WriteOwner));
        Window w(*m_dir);
        w.document.open(path(u"a.berg"_s));
        for (int i = 1; i <= 3; ++i) {
            w.setTau(0.1 * i);
            QVERIFY(w.file.save(path(u"a.berg"_s), true));
        }
        QVERIFY(content(u"a.berg~"_s) == old);
        QVERIFY(content(u"a.berg"_s) != old);
        QCOMPARE(QFile::permissions(path(u"a.berg~"_s)), QFile::permissions(path(u"a.berg"_s)));
    }

    void noCopyOfAFileOfOurOwn()
    {
        Window w(*m_dir);
        w.document.reset(three());
        QVERIFY(w.file.save(path(u"new.berg"_s), true));
        w.setTau(0.3);
        QVERIFY(w.file.save(path(u"new.berg"_s), true));
        QVERIFY(!QFile::exists(path(u"new.berg~"_s)));
    }

    void noCopyUnlessWanted()
    {
        Window w(*m_dir);
        w.document.open(path(u"a.berg"_s));
        w.setTau(0.3);
        QVERIFY(w.file.save(path(u"a.berg"_s), false));
        QVERIFY(!QFile::exists(path(u"a.berg~"_s)));
    }

    /** A backup copy that cannot be made does not prevent saving. */
    void copyThatIsRefused()
    {
        QVERIFY(QDir(m_dir->path()).mkdir(u"a.berg~"_s));
        Window w(*m_dir);
        w.document.open(path(u"a.berg"_s));
        w.setTau(0.3);
        QVERIFY(!w.file.save(path(u"a.berg"_s), true));
        QVERIFY(w.document.isClean());
        QVERIFY(loadScenario(path(u"a.berg"_s).toStdString()) == w.document.scenario());
    }

    void savingThatFailsLosesNothing()
    {
        Window w(*m_dir);
        w.document.open(path(u"a.berg"_s));
        w.setTau(0.3);
        QCOMPARE(test::codeOf([&] { w.file.save(path(u"no/such/folder.berg"_s), true); }),
                 std::string("FileUnwritable"));
        QVERIFY(!w.document.isClean());
        QCOMPARE(w.document.filePath(), path(u"a.berg"_s));
        QVERIFY(w.document.scenario().planner.tau == 0.3);
    }
};

QTEST_GUILESS_MAIN(TestDocumentFile)
#include "tst_document_file.moc"
