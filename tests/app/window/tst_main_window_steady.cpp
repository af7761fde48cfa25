#include "app/dialogs/generate_dialog.h"
#include "core/io/files/scenario_json.h"
#include "core/presets/presets.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"

#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>

#include <cmath>
#include <map>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;
using Unsaved = Interaction::Unsaved;

namespace {

const QStringList kStripButtons{u"flyOnButton"_s, u"newestButton"_s, u"showChecksButton"_s,
                                u"bringBackButton"_s};

QPushButton& button(WindowFixture& w, const QString& name)
{
    return test::child<QPushButton>(w.window(), name);
}

QRect placeOf(const QPushButton& button)
{
    return {button.mapTo(button.window(), QPoint()), button.size()};
}

bool takeOff(WindowFixture& w)
{
    w.workspace.fly(1);
    return w.until(RunPhase::Flying);
}

/** Flies so far and pauses. */
bool flyTo(WindowFixture& w, double time_s)
{
    w.workspace.stepTicks(static_cast<int>(std::lround(time_s / w.scenario().dt_s)));
    return w.until([&] { return w.record().now.time_s >= time_s - 1e-6; });
}

bool lookBack(WindowFixture& w, double time_s)
{
    w.workspace.seek(time_s);
    return w.until([&] { return w.record().instant.has_value(); });
}

/** A press where `at` is in the window, on whatever is there. */
void clickAt(WindowFixture& w, const QPoint& at)
{
    QWidget* there = w.window().childAt(at);
    QTest::mouseClick(there, Qt::LeftButton, {}, there->mapFrom(&w.window(), at));
}

} // namespace

/** A flight is neither ended nor lost by surprise. */
class TestMainWindowSteady : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** Abandoned work taken up again in mid flight. */
    void restoringAsksAboutTheFlight()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.workspace.autosaver().start(w.file(u"recovery"_s), {.pause_ms = 0, .longest_ms = 0});
        const Scenario left = randomScenario(77, {.icebergs = 3});
        {
            const HeldRecovery held = RecoveryStore(w.file(u"recovery"_s)).add();
            writeRecovery(held.files, left, {.edited = QDateTime::currentDateTime()});
        }
        QVERIFY(flyTo(w, 20));
        const Scenario flown = w.scenario();
        w.interaction.recoveryAnswers = {{RecoveryAnswer::Action::Restore, 0}};
        w.trigger(u"recoverAction"_s);
        QCOMPARE(w.interaction.endFlightQuestions, 1);
        QVERIFY(w.workspace.isMidFlight() && w.scenario() == flown);
        w.interaction.endsFlight = true;
        w.interaction.recoveryAnswers.push_back({RecoveryAnswer::Action::Restore, 0});
        w.trigger(u"recoverAction"_s);
        QCOMPARE(w.interaction.endFlightQuestions, 2);
        QVERIFY(!w.workspace.inFlight() && w.scenario() == left);
    }

    void loggingOutAsksAboutTheFlight()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QVERIFY(flyTo(w, 80));
        QVERIFY(!w.window().parts().safety.mayEndSession(true));
        QCOMPARE(w.interaction.runQuestions, std::vector<bool>{true});
        QVERIFY(w.workspace.isMidFlight());
        w.interaction.unsavedRun = Unsaved::Save;
        w.interaction.path = w.file(u"kept.bergrun"_s);
        QVERIFY(w.window().parts().safety.mayEndSession(true));
        QVERIFY(QFile::exists(w.interaction.path)); // there may be no time later on
    }

    void closingAsksAboutTheRun_data()
    {
        QTest::addColumn<bool>("finished");
        QTest::addColumn<bool>("changed");
        QTest::newRow("in flight") << false << false;
        QTest::newRow("in flight, changed") << false << true;
        QTest::newRow("after it") << true << false;
        QTest::newRow("after it, changed") << true << true;
    }

    /** It goes with the window, in the list of runs or not. */
    void closingAsksAboutTheRun()
    {
        QFETCH(bool, finished);
        QFETCH(bool, changed);
        WindowFixture w(test::MapFixture::fourIcebergs());
        if (changed)
            w.document().edit(u"Name"_s, [](Scenario& s) { s.name = "mine"; });
        QVERIFY(w.untilReady());
        w.interaction.unsaved = Unsaved::Discard;
        QVERIFY(flyTo(w, 80));
        w.workspace.fly(finished ? kFastestRate : FlightRate(1));
        QVERIFY(w.until(finished ? RunPhase::Finished : RunPhase::Flying));
        QVERIFY(!w.window().close());
        QCOMPARE(w.interaction.runQuestions, std::vector<bool>{!finished});
        QCOMPARE(w.interaction.unsavedNames.size(), changed ? 1 : 0);
        QVERIFY(!w.interaction.mentionedFlight);

        w.interaction.unsavedRun = Unsaved::Save; // but in no file, after all
        QVERIFY(!w.window().close());

        w.interaction.path = w.file(u"kept"_s);
        QVERIFY(w.window().close());
        QCOMPARE(w.interaction.runQuestions.size(), 3U);
        QVERIFY(loadRun(w.file(u"kept.bergrun"_s).toStdString()) == *test::flownRun(w));
    }

    void onlyARunThatIsLostIsAskedAbout_data()
    {
        QTest::addColumn<double>("flown_s");
        QTest::addColumn<QString>("then");
        QTest::addColumn<int>("questions");
        QTest::newRow("of a moment") << 5. << QString() << 0;
        QTest::newRow("of a moment, changed") << 5. << u"changed"_s << 1;
        QTest::newRow("of a moment, an iceberg added") << 5. << u"added"_s << 1;
        QTest::newRow("of a moment, one reported") << 5. << u"reported"_s << 1;
        QTest::newRow("longer") << 80. << QString() << 1;
        QTest::newRow("saved") << 80. << u"saved"_s << 0;
        QTest::newRow("saved, flown on") << 80. << u"saved, flown on"_s << 1;
        QTest::newRow("opened") << 80. << u"saved, opened"_s << 0;
        QTest::newRow("opened, flown on") << 80. << u"saved, opened, flown on"_s << 1;
    }

    void onlyARunThatIsLostIsAskedAbout()
    {
        QFETCH(double, flown_s);
        QFETCH(QString, then);
        QFETCH(int, questions);
        WindowFixture w(test::MapFixture::fourIcebergs());
        QVERIFY(flyTo(w, flown_s));
        if (then == u"changed"_s) {
            w.workspace.setWind({3, -1});
            QVERIFY(flyTo(w, flown_s + 1));
        }
        if (then == u"added"_s)
            w.workspace.addIceberg({.position_m = {2500, 2000}});
        if (then == u"reported"_s)
            w.workspace.reportSeen({w.scenario().icebergs[0].id});
        if (then == u"added"_s || then == u"reported"_s)
            QVERIFY(flyTo(w, flown_s + 1));
        w.interaction.path = w.file(u"some.bergrun"_s);
        if (then.startsWith(u"saved"_s)) {
            w.trigger(u"saveRunAction"_s);
            QVERIFY(w.until([&] { return QFile::exists(w.interaction.path); }));
        }
        if (then.contains(u"opened"_s)) {
            w.document().reset(randomScenario(77, {.icebergs = 3}));
            QVERIFY(w.untilReady());
            w.trigger(u"openAction"_s);
            QVERIFY(w.until(RunPhase::Paused));
        }
        if (then.endsWith(u"flown on"_s))
            QVERIFY(flyTo(w, flown_s + 1));
        w.interaction.unsavedRun = Unsaved::Discard;
        QVERIFY(w.window().close());
        QCOMPARE(w.interaction.runQuestions.size(), static_cast<std::size_t>(questions));
    }

    void answerAfterTakeOff_data()
    {
        QTest::addColumn<QString>("action");
        for (const char* action :
             {"importAction", "openAction", "newAction", "moveScenarioAction", "windAction"})
            QTest::newRow(action) << QString::fromLatin1(action);
    }

    /** Its question was open before. */
    void answerAfterTakeOff()
    {
        QFETCH(QString, action);
        WindowFixture w(test::MapFixture::fourIcebergs());
        if (action == u"newAction"_s)
            w.document().edit(u"Name"_s, [](Scenario& s) { s.name = "mine"; });
        QVERIFY(w.untilReady());
        const Scenario flown = w.scenario();
        const QString other = w.file(u"other.berg"_s);
        saveScenario(randomScenario(7), other.toStdString());
        w.interaction.path = other;
        w.interaction.unsaved = Unsaved::Discard;
        w.interaction.wind_mps = Point(3, 0);
        w.interaction.originChoice = OriginChoice{.origin = {60, -50}};
        w.interaction.importAnswer = [](ImportRunner&, const ImportOffer&) {
            return ImportChoice{.scenario = randomScenario(8), .icebergs = 3};
        };
        w.interaction.meanwhile = [&] {
            w.interaction.meanwhile = nullptr;
            if (!w.workspace.inFlight())
                QVERIFY(takeOff(w));
        };
        if (action == u"importAction"_s) { // the file is chosen, its dialog is open
            const auto begin = std::exchange(w.interaction.meanwhile, nullptr);
            const auto answer = w.interaction.importAnswer;
            w.interaction.importAnswer = [=](ImportRunner& runner, const ImportOffer& offer) {
                begin();
                return answer(runner, offer);
            };
        }
        w.trigger(action);
        QCOMPARE(w.interaction.endFlightQuestions, 1);
        QVERIFY(w.workspace.inFlight());
        QVERIFY(w.scenario() == flown);

        w.workspace.reset();
        QVERIFY(w.untilReady());
        w.interaction.endsFlight = true;
        if (action == u"importAction"_s)
            QVERIFY(w.until([&] { return !w.workspace.inFlight(); }));
        else
            w.interaction.meanwhile = [&] {
                w.interaction.meanwhile = nullptr;
                QVERIFY(takeOff(w));
            };
        w.trigger(action);
        QCOMPARE(w.interaction.endFlightQuestions, 2);
        QVERIFY(!w.workspace.inFlight());
        QVERIFY(!(w.scenario() == flown));
    }

    void generatedAfterTakeOff()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const Scenario flown = w.scenario();
        for (const bool endsFlight : {false, true}) {
            w.interaction.endsFlight = endsFlight;
            w.trigger(u"generateAction"_s);
            auto* dialog = w.window().findChild<GenerateDialog*>();
            test::child<QSpinBox>(*dialog, u"generateNumber"_s).setValue(5);
            if (!w.workspace.inFlight())
                QVERIFY(takeOff(w));
            test::child<QPushButton>(*dialog, u"generateOk"_s).click();
            QCOMPARE(w.workspace.inFlight(), !endsFlight);
            QCOMPARE(w.scenario() == flown, !endsFlight);
            QVERIFY(w.until([&] { return w.window().findChild<GenerateDialog*>() == nullptr; }));
            w.workspace.reset();
            QVERIFY(w.untilReady());
        }
        QCOMPARE(w.interaction.endFlightQuestions, 2);
    }

    void buttonsOfTheStripKeepTheirPlaces()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        std::vector<std::map<QString, QRect>> states;
        const auto note = [&] {
            QTest::qWait(20); // laid out
            states.emplace_back();
            for (const QString& name : kStripButtons)
                if (button(w, name).isVisible())
                    states.back()[name] = placeOf(button(w, name));
        };
        QVERIFY(flyTo(w, 200));
        note();
        QVERIFY(lookBack(w, 100));
        note();
        button(w, u"flyOnButton"_s).click();
        QVERIFY(w.until([&] { return w.record().now.time_s < 150; }));
        note();
        test::child<QToolButton>(w.window(), u"resetButton"_s).click();
        note();
        for (std::size_t i = 0; i + 1 < states.size(); ++i)
            for (const auto& [name, place] : states[i])
                for (const auto& [other, next] : states[i + 1])
                    QVERIFY2(name == other || !place.intersects(next),
                             qPrintable(name + u" and "_s + other));
        QCOMPARE(states.back().size(), 1U); // brings the flight back
    }

    void secondClickOnFlyOnDoesNoHarm()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QVERIFY(flyTo(w, 200));
        QVERIFY(lookBack(w, 100));
        QTest::qWait(20); // laid out
        const QPoint at = placeOf(button(w, u"flyOnButton"_s)).center();
        clickAt(w, at);
        QVERIFY(w.until([&] { return w.record().now.time_s < 150; }));
        QTest::qWait(20);
        clickAt(w, at);
        QTest::qWait(20);
        QVERIFY(w.workspace.inFlight());
        QVERIFY(w.record().now.time_s > 50);
    }

    void givenUpFlightComesBack_data()
    {
        QTest::addColumn<QString>("how");
        for (const char* how : {"stopped", "stopped and edited", "stopped, stepped and stopped",
                                "flown on from before"})
            QTest::newRow(how) << QString::fromLatin1(how);
    }

    void givenUpFlightComesBack()
    {
        QFETCH(QString, how);
        WindowFixture w(test::MapFixture::fourIcebergs());
        const Scenario start = w.scenario();
        QVERIFY(!w.action(u"bringBackAction"_s).isEnabled());
        QVERIFY(flyTo(w, 200));
        const double time_s = w.record().now.time_s;
        const double zeta_m2s = w.record().now.metrics.zeta_m2s;
        const std::size_t samples = w.record().history.samples.size();
        if (how == u"flown on from before"_s) {
            QVERIFY(lookBack(w, 100));
            button(w, u"flyOnButton"_s).click();
            QVERIFY(w.until([&] { return w.record().now.time_s < 150; }));
        } else {
            test::child<QToolButton>(w.window(), u"resetButton"_s).click();
            QVERIFY(!w.workspace.inFlight());
        }
        if (how == u"stopped, stepped and stopped"_s) {
            QVERIFY(w.untilReady());
            w.workspace.step();
            QVERIFY(w.until([&] { return w.record().now.time_s > 0; }));
            w.workspace.reset();
        }
        if (how == u"stopped and edited"_s)
            w.document().edit(u"Name"_s, [](Scenario& s) { s.icebergs.pop_back(); });
        QVERIFY(button(w, u"bringBackButton"_s).isVisible());
        button(w, u"bringBackButton"_s).click();
        QVERIFY(w.until([&] { return w.record().now.time_s == time_s; }));
        QVERIFY(w.workspace.inFlight());
        QVERIFY(w.document().isLocked());
        QVERIFY(w.scenario() == start);
        QCOMPARE(w.record().now.phase, RunPhase::Paused);
        QCOMPARE(w.record().now.metrics.zeta_m2s, zeta_m2s);
        QCOMPARE(w.record().history.samples.size(), samples);
        w.workspace.step();
        QVERIFY(w.until([&] { return w.record().now.time_s > time_s; }));
        w.workspace.reset();
        w.document().reset(randomScenario(9)); // another one: nothing to bring back
        QVERIFY(!w.action(u"bringBackAction"_s).isEnabled());
        QVERIFY(!button(w, u"bringBackButton"_s).isVisible());
    }
};

QTEST_MAIN(TestMainWindowSteady)
#include "tst_main_window_steady.moc"
