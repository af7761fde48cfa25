#include "core/io/files/run_json.h"
#include "core/presets/presets.h"
#include "tests/support/window/window_fixture.h"

#include <QDir>

#include <cmath>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

/** Copies the folder as a killed program leaves it: no process holds a lock on the copy. */
void copyFiles(const QDir& from, const QString& to)
{
    QVERIFY(QDir().mkpath(to));
    for (const QString& name : from.entryList({u"*.berg"_s, u"*.bergrun"_s, u"*.json"_s}))
        QVERIFY(QFile::copy(from.filePath(name), QDir(to).filePath(name)));
}

/** Flies for some seconds and pauses. */
bool flyTo(WindowFixture& w, double time_s)
{
    w.workspace.stepTicks(qRound((time_s - w.record().now.time_s) / w.scenario().dt_s));
    return w.until([&] {
        return w.record().now.phase == RunPhase::Paused &&
               std::abs(w.record().now.time_s - time_s) < 1e-6;
    });
}

QStringList runsIn(const QString& folder)
{
    return QDir(folder).entryList({u"*.bergrun"_s}, QDir::Files);
}

} // namespace

/** A flight under way is not lost with the program. */
class TestFlightRecovery : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void flightIsTakenUpWhereItWasNoted()
    {
        const QTemporaryDir folder;
        const QString recoveries = folder.filePath(u"recoveries"_s);
        const QString left = folder.filePath(u"left"_s);
        std::shared_ptr<const RunFile> flown;
        {
            WindowFixture w(randomScenario(31, {.icebergs = 3}));
            w.workspace.autosaver().start(recoveries, {.pause_ms = 0, .longest_ms = 0});
            QVERIFY(flyTo(w, 20));
            w.workspace.setWind({3, -1});
            QVERIFY(flyTo(w, 40));
            flown = test::flownRun(w);
            QVERIFY(w.document().isClean()); // the flight alone is what would be lost
            const auto isNoted = [&] {
                const QStringList runs = runsIn(recoveries);
                return runs.size() == 1 &&
                       loadRun(QDir(recoveries).filePath(runs[0]).toStdString()) == *flown;
            };
            QVERIFY(w.until(isNoted));
            copyFiles(QDir(recoveries), left);
            w.interaction.unsavedRun = Interaction::Unsaved::Discard;
            QVERIFY(w.window().close());
        }
        QVERIFY(QDir(recoveries).isEmpty(QDir::Files | QDir::Hidden)); // ended in order

        WindowFixture w(randomScenario(32, {.icebergs = 3}));
        w.workspace.autosaver().start(left, {.pause_ms = 0, .longest_ms = 0});
        w.interaction.recoveryAnswers = {{RecoveryAnswer::Action::Restore, 0}};
        QVERIFY(w.window().parts().safety.offerRecoveries());
        QVERIFY(w.interaction.recoveryOffers[0].at(0).name.endsWith(u", in flight"_s));
        QVERIFY(w.workspace.hasUnsavedRun()); // although it is not flown again yet
        QVERIFY(w.until(RunPhase::Paused));
        QVERIFY(w.workspace.inFlight());
        QVERIFY(*test::flownRun(w) == *flown);
        w.workspace.reset();
        QVERIFY(w.until([&] { return runsIn(left).isEmpty(); })); // given up by the user
    }

    /** Restored but edited before it flies again: an old flight must not come back over the edit.
     */
    void flightOfAnEditedScenarioIsForgotten()
    {
        const QTemporaryDir folder;
        WindowFixture w(randomScenario(33, {.icebergs = 3}));
        w.workspace.autosaver().start(folder.path(), {.pause_ms = 0, .longest_ms = 0});
        w.workspace.autosaver().setRun(test::flownRun(w));
        QVERIFY(w.until([&] { return runsIn(folder.path()).size() == 1; }));
        w.document().edit(u"Edit"_s, [](Scenario& s) { s.icebergs.pop_back(); });
        const auto isEditAlone = [&] {
            return runsIn(folder.path()).isEmpty() &&
                   !QDir(folder.path()).entryList({u"*.berg"_s}).isEmpty();
        };
        QVERIFY(w.until(isEditAlone));
    }
};

QTEST_MAIN(TestFlightRecovery)
#include "tst_flight_recovery.moc"
