#include "core/io/files/scenario_json.h"
#include "core/presets/presets.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "widgets/document/autosaver.h"
#include "widgets/document/scenario_document.h"

#include <QDir>
#include <QTemporaryDir>
#include <QUndoStack>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

constexpr AutosaveTimes kAtOnce{.pause_ms = 0, .longest_ms = 0};
constexpr AutosaveTimes kNever{.pause_ms = 1'000'000, .longest_ms = 1'000'000};

/** A document with an autosaver and the folder of its recoveries. */
struct Bench
{
    explicit Bench(const AutosaveTimes& times = kAtOnce)
    {
        document.reset(randomScenario(1, {.icebergs = 3}));
        autosaver = std::make_unique<Autosaver>(document);
        QObject::connect(autosaver.get(), &Autosaver::autosaved, &document, [this] { ++saved; });
        QObject::connect(autosaver.get(), &Autosaver::dropped, &document, [this] { ++dropped; });
        QObject::connect(autosaver.get(), &Autosaver::failed, &document,
                         [this](const QString& report) { reports << report; });
        autosaver->start(folder(), times);
    }
    [[nodiscard]] QString folder() const { return dir.filePath(u"recovery"_s); }
    void setTau(double tau)
    {
        document.edit(u"tau"_s, [tau](Scenario& s) { s.planner.tau = tau; });
    }
    [[nodiscard]] QStringList files() const
    {
        return QDir(folder()).entryList({u"*.berg"_s}, QDir::Files);
    }
    [[nodiscard]] Scenario written() const
    {
        return loadScenario(QDir(folder()).filePath(files().value(0)).toStdString());
    }

    QTemporaryDir dir;
    ScenarioDocument document;
    std::unique_ptr<Autosaver> autosaver;
    int saved = 0;
    int dropped = 0;
    QStringList reports;
};

} // namespace

class TestAutosaver : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void unchangedDocumentIsNotWritten()
    {
        Bench b;
        QTest::qWait(0);
        b.autosaver.reset();
        QVERIFY(!QDir(b.folder()).exists());
    }

    void changesAreWritten()
    {
        Bench b;
        b.setTau(0.25);
        QTRY_COMPARE(b.saved, 1);
        QVERIFY(b.written() == b.document.scenario());
        b.setTau(0.5);
        QTRY_COMPARE(b.saved, 2);
        QVERIFY(b.written() == b.document.scenario());
        QCOMPARE(b.files().size(), 1);
        QVERIFY(b.autosaver->abandoned().usable.empty()); // its own is locked
    }

    /** Many changes in a row make one file, written a moment after the last. */
    void waitsForAPause()
    {
        Bench b({.pause_ms = 50, .longest_ms = 1'000'000});
        for (int i = 1; i <= 20; ++i)
            b.setTau(0.01 * i);
        QTRY_VERIFY(b.saved > 0);
        QVERIFY(b.written() == b.document.scenario());
        QCOMPARE(b.saved, 1);
    }

    /** Changes are written even if the user never pauses. */
    void isWrittenWithoutAPauseAsWell()
    {
        Bench b({.pause_ms = 1'000'000, .longest_ms = 20});
        int step = 0;
        const auto busy = [&] {
            b.setTau(0.001 * ++step);
            return b.saved >= 2;
        };
        QTRY_VERIFY(busy());
    }

    void goneWhenNothingIsUnsaved_data()
    {
        QTest::addColumn<QString>("how");
        for (const char* how : {"save", "undo", "new", "end"})
            QTest::newRow(how) << QString::fromLatin1(how);
    }
    void goneWhenNothingIsUnsaved()
    {
        QFETCH(QString, how);
        Bench b;
        b.setTau(0.25);
        QTRY_COMPARE(b.saved, 1);
        if (how == u"save"_s)
            b.document.save(b.dir.filePath(u"a.berg"_s));
        else if (how == u"undo"_s)
            b.document.undoStack()->undo();
        else if (how == u"new"_s)
            b.document.reset(randomScenario(2, {.icebergs = 2}));
        else
            b.autosaver.reset();
        QTRY_VERIFY(b.files().isEmpty());
        QCOMPARE(b.dropped > 0, how != u"end"_s);
        b.autosaver.reset();
        QVERIFY(QDir(b.folder()).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
    }

    /** Saving does not end the history: an undo after it makes unsaved changes again. */
    void undoAfterSavingIsAChange()
    {
        Bench b;
        const Scenario before = b.document.scenario();
        b.setTau(0.25);
        b.document.save(b.dir.filePath(u"a.berg"_s));
        QVERIFY(b.document.isClean());
        b.document.undoStack()->undo();
        QVERIFY(!b.document.isClean());
        QVERIFY(b.document.scenario() == before);
        QTRY_VERIFY(b.saved > 0);
        QVERIFY(b.written() == before);
        b.document.undoStack()->redo();
        QVERIFY(b.document.isClean());
        QTRY_VERIFY(b.files().isEmpty());
    }

    /** A scenario that cannot be flown can still be opened again. */
    void whatCannotBeFlownIsWritten()
    {
        Bench b;
        b.setTau(0.25);
        QTRY_COMPARE(b.saved, 1);
        b.document.edit(u"dt"_s, [](Scenario& s) { s.duration_s = s.dt_s / 2; });
        QVERIFY(hasErrors(b.document.issues()));
        QTRY_COMPARE(b.saved, 2);
        b.autosaver->keep();
        b.autosaver.reset();
        const FoundRecoveries found = RecoveryStore(b.folder()).abandoned();
        QCOMPARE(found.usable.size(), 1U);
        QVERIFY(found.usable[0].scenario == b.document.scenario());
    }

    void recoveryStaysAfterAnUnaskedEnd()
    {
        Bench b(kNever);
        b.setTau(0.25);
        b.autosaver->keep();
        b.autosaver.reset();
        FoundRecoveries found = RecoveryStore(b.folder()).abandoned();
        QCOMPARE(found.usable.size(), 1U);
        QVERIFY(found.usable[0].scenario == b.document.scenario());
    }

    void keepsNothingOfAnUnchangedDocument()
    {
        Bench b(kNever);
        b.autosaver->keep();
        b.autosaver.reset();
        QVERIFY(RecoveryStore(b.folder()).abandoned().usable.empty());
    }

    /** Restored work stays on disk until it is saved. */
    void adoptedRecoveryIsCarriedOn()
    {
        Bench b;
        {
            const HeldRecovery left = RecoveryStore(b.folder()).add();
            writeRecovery(left.files, randomScenario(9, {.icebergs = 2}), {});
        }
        FoundRecoveries found = b.autosaver->abandoned();
        QCOMPARE(found.usable.size(), 1U);
        b.document.restore(found.usable[0].scenario, {});
        b.autosaver->adopt(std::move(found.usable[0].held));
        found.usable.clear();
        QVERIFY(!b.document.isClean());
        QTRY_VERIFY(b.saved > 0);
        QCOMPARE(b.files().size(), 1);
        QVERIFY(b.written() == randomScenario(9, {.icebergs = 2}));
        QVERIFY(b.autosaver->abandoned().usable.empty());
        b.document.save(b.dir.filePath(u"a.berg"_s));
        QTRY_VERIFY(b.files().isEmpty());
    }

    void failureIsReported()
    {
        Bench b(kNever);
        QFile obstacle(b.folder());
        QVERIFY(obstacle.open(QIODevice::WriteOnly));
        b.setTau(0.25);
        b.autosaver->keep();
        QCOMPARE(b.reports.size(), 1);
        QVERIFY(b.reports.front().contains(b.folder()));
    }
};

QTEST_GUILESS_MAIN(TestAutosaver)
#include "tst_autosaver.moc"
