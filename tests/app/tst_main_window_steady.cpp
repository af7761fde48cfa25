#include "core/io/scenario_json.h"
#include "core/scenario/presets.h"
#include "tests/support/map_fixture.h"
#include "tests/support/window_fixture.h"
#include "widgets/panels/generate_dialog.h"

#include <QPushButton>
#include <QSpinBox>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

bool takeOff(WindowFixture& w)
{
    w.workspace.fly(1);
    return w.until(RunPhase::Flying);
}

} // namespace

/** A flight is neither ended nor lost by surprise. */
class TestMainWindowSteady : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

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
        w.interaction.unsaved = Interaction::Unsaved::Discard;
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
};

QTEST_MAIN(TestMainWindowSteady)
#include "tst_main_window_steady.moc"
