#include "core/base/random.h"
#include "core/io/files/scenario_json.h"
#include "core/presets/presets.h"
#include "widgets/document/scenario_document.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QUndoStack>
#include <QtTest>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

void moveFirst(ScenarioDocument& document, double east_m, const QString& gesture = {})
{
    document.edit(
        u"Move"_s, [east_m](Scenario& s) { s.icebergs[0].position_m.x() = east_m; }, gesture);
}

/** Makes one of many edits, chosen by the stream. */
void randomEdit(ScenarioDocument& document, Random& random)
{
    document.edit(u"Edit"_s, [&random](Scenario& s) {
        switch (random.below(5)) {
        case 0:
            s.planner.tau = random.uniform(0, 5);
            break;
        case 1:
            s.icebergs.push_back({.id = "berg-" + std::to_string(random.bits())});
            break;
        case 2:
            if (!s.icebergs.empty())
                s.icebergs.erase(s.icebergs.begin() +
                                 static_cast<std::ptrdiff_t>(random.below(s.icebergs.size())));
            break;
        case 3:
            s.uavs[0].heading_deg = random.uniform(0, 360);
            break;
        default:
            s.wind_mps = {random.uniform(-5, 5), 0};
        }
    });
}

} // namespace

class TestScenarioDocument : public QObject
{
    Q_OBJECT

private slots:
    void editIsOneUndoStep()
    {
        ScenarioDocument document;
        document.reset(randomScenario(1));
        const Scenario before = document.scenario();
        QSignalSpy changed(&document, &ScenarioDocument::scenarioChanged);
        moveFirst(document, 10);
        QCOMPARE(document.undoStack()->count(), 1);
        QCOMPARE(changed.count(), 1);
        QVERIFY(!document.isClean());
        document.undoStack()->undo();
        QVERIFY(document.scenario() == before);
        QVERIFY(document.isClean());
    }

    void changingNothingLeavesRedoAlone()
    {
        ScenarioDocument document;
        document.reset(randomScenario(1));
        moveFirst(document, 10);
        document.undoStack()->undo();
        QVERIFY(!document.edit(u"Nothing"_s, [](Scenario&) {}));
        QVERIFY(document.undoStack()->canRedo());
        document.undoStack()->redo();
        QCOMPARE(document.scenario().icebergs[0].position_m.x(), 10.0);
    }

    /** The place of a ship is no change of the user's: undo keeps it, and redo stays possible. */
    void followedChangesAreNoUndoSteps()
    {
        ScenarioDocument document;
        document.reset(randomScenario(1));
        const auto moveUav = [&](double east_m) {
            document.follow(u"ship"_s,
                            [east_m](Scenario& s) { s.uavs[0].position_m.x() = east_m; });
        };
        const auto uavEast_m = [&] { return document.scenario().uavs[0].position_m.x(); };
        const double start_m = uavEast_m();
        moveFirst(document, 10);
        moveUav(100);
        QVERIFY(!document.isClean());
        QCOMPARE(uavEast_m(), 100.0);
        QCOMPARE(document.undoStack()->count(), 1);
        document.undoStack()->undo();
        QVERIFY(document.scenario().icebergs[0].position_m.x() != 10);
        QCOMPARE(uavEast_m(), 100.0);
        QVERIFY(!document.isClean()); // the file has another place
        moveUav(200);
        QVERIFY(document.undoStack()->canRedo());
        document.undoStack()->redo();
        QCOMPARE(document.scenario().icebergs[0].position_m.x(), 10.0);
        QCOMPARE(uavEast_m(), 200.0);
        document.stopFollowing(u"ship"_s);
        document.undoStack()->undo();
        QCOMPARE(uavEast_m(), start_m);
        moveUav(300);
        document.reset(randomScenario(1));
        moveFirst(document, 20);
        document.undoStack()->undo();
        QCOMPARE(uavEast_m(), start_m);
    }

    void gestureMergesUntilItEnds()
    {
        ScenarioDocument document;
        document.reset(randomScenario(1));
        const Scenario before = document.scenario();
        for (int i = 1; i <= 20; ++i)
            moveFirst(document, i, u"drag"_s);
        QCOMPARE(document.undoStack()->count(), 1);
        document.endGesture();
        moveFirst(document, 99, u"drag"_s);
        QCOMPARE(document.undoStack()->count(), 2);
        document.undoStack()->undo();
        QCOMPARE(document.scenario().icebergs[0].position_m.x(), 20.0);
        document.undoStack()->undo();
        QVERIFY(document.scenario() == before);
    }

    void gestureBackToItsStartLeavesNoTrace()
    {
        ScenarioDocument document;
        document.reset(randomScenario(1));
        const double start_m = document.scenario().icebergs[0].position_m.x();
        moveFirst(document, 5, u"drag"_s);
        moveFirst(document, start_m, u"drag"_s);
        QCOMPARE(document.undoStack()->count(), 0);
        QVERIFY(document.isClean());
    }

    /** Undoing all edits gives the start, and redoing all of them the end. */
    void everythingCanBeUndone()
    {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            ScenarioDocument document;
            document.reset(randomScenario(3));
            const Scenario start = document.scenario();
            Random random(seed);
            for (int i = 0; i < 60; ++i)
                randomEdit(document, random);
            const Scenario end = document.scenario();
            document.undoStack()->setIndex(0);
            QVERIFY(document.scenario() == start);
            document.undoStack()->setIndex(document.undoStack()->count());
            QVERIFY(document.scenario() == end);
        }
    }

    void issuesFollowTheScenario()
    {
        ScenarioDocument document;
        document.reset(randomScenario(1));
        QVERIFY(!hasErrors(document.issues()));
        document.edit(u"Break"_s, [](Scenario& s) { s.wind_mps = {50, 0}; });
        QVERIFY(hasErrors(document.issues()));
        document.undo();
        QVERIFY(!hasErrors(document.issues()));
    }

    void refusesWhatCouldNotBeOpenedAgain()
    {
        ScenarioDocument document;
        document.reset(randomScenario(1));
        const Scenario start = document.scenario();
        QSignalSpy rejected(&document, &ScenarioDocument::editRejected);
        QVERIFY(!document.edit(u"Id"_s, [](Scenario& s) { s.icebergs[1].id = s.icebergs[0].id; }));
        QVERIFY(
            !document.edit(u"Far"_s, [](Scenario& s) { s.icebergs[1].position_m.x() = 1e300; }));
        QCOMPARE(rejected.count(), 2);
        QVERIFY(document.scenario() == start);
        QVERIFY(document.isClean());
    }

    void lockedDocumentIsNotEdited()
    {
        ScenarioDocument document;
        document.reset(randomScenario(1));
        document.edit(u"Name"_s, [](Scenario& s) { s.name = "edited"; });
        const Scenario locked = document.scenario();
        QSignalSpy refused(&document, &ScenarioDocument::refused);
        document.setLocked(true);
        QVERIFY(!document.edit(u"Name"_s, [](Scenario& s) { s.name = "again"; }));
        document.undo();
        QCOMPARE(refused.count(), 2);
        QVERIFY(!document.edit(u"Nothing"_s, [](Scenario&) {}));
        QCOMPARE(refused.count(), 2);
        QVERIFY(document.scenario() == locked);
        document.setLocked(false);
        document.undo();
        document.redo();
        QVERIFY(document.scenario() == locked);
        document.setLocked(true);
        document.reset(randomScenario(2)); // another scenario altogether
        QVERIFY(!document.isLocked());
    }

    void savesAndOpens()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"a.berg"_s);
        ScenarioDocument document;
        document.reset(randomScenario(1));
        moveFirst(document, 7);
        document.save(path);
        QVERIFY(document.isClean());
        QCOMPARE(document.filePath(), path);
        moveFirst(document, 8);
        QVERIFY(!document.isClean());

        ScenarioDocument other;
        QSignalSpy replaced(&other, &ScenarioDocument::replaced);
        other.open(path);
        QCOMPARE(replaced.count(), 1);
        QCOMPARE(other.scenario().icebergs[0].position_m.x(), 7.0);
        QVERIFY(!other.undoStack()->canUndo());
    }

    void failuresChangeNothing()
    {
        const QTemporaryDir folder;
        ScenarioDocument document;
        document.reset(randomScenario(1));
        moveFirst(document, 7);
        const Scenario before = document.scenario();
        QVERIFY_THROWS_EXCEPTION(Error, document.open(folder.filePath(u"missing.berg"_s)));
        QVERIFY_THROWS_EXCEPTION(Error, document.save(folder.filePath(u"no/such/folder.berg"_s)));
        QVERIFY(document.scenario() == before);
        QVERIFY(!document.isClean());
        QVERIFY(document.undoStack()->canUndo());
        QVERIFY(document.filePath().isEmpty());
    }
};

QTEST_MAIN(TestScenarioDocument)
#include "tst_scenario_document.moc"
