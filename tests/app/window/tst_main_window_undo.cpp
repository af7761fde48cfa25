#include "core/presets/presets.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

/** Four icebergs, two UAVs and an asset, under way and paused after five steps. */
std::unique_ptr<WindowFixture> pausedFlight()
{
    Scenario scenario = test::MapFixture::fourIcebergs();
    Uav second = scenario.uavs.front();
    second.id = "u2";
    scenario.uavs.push_back(second);
    scenario.asset = Asset{.position_m = {3000, 3000}};
    auto w = std::make_unique<WindowFixture>(scenario);
    w->workspace.step();
    if (!w->until(RunPhase::Paused))
        qFatal("no flight");
    return w;
}

void flyOneStep(WindowFixture& w)
{
    const double before_s = w.record().now.time_s;
    w.workspace.step();
    QVERIFY(w.until([&] { return w.record().now.time_s > before_s; }));
}

bool canUndo(WindowFixture& w)
{
    return w.action(u"undoAction"_s).isEnabled();
}

} // namespace

/** Undo in flight takes back the last change of the flight. */
class TestMainWindowUndo : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void takesEveryChangeBack_data()
    {
        QTest::addColumn<std::function<void(Workspace&)>>("change");
        QTest::addColumn<QString>("name");
        using Change = std::function<void(Workspace&)>;
        QTest::newRow("trade-off")
            << Change([](Workspace& w) { w.setTau(0.9); }) << u"&Undo Change trade-off"_s;
        QTest::newRow("policy") << Change([](Workspace& w) { w.setPolicy(PolicyKind::Nearest); })
                                << u"&Undo Change policy"_s;
        QTest::newRow("wind") << Change([](Workspace& w) {
            w.setWind({3, 4});
        }) << u"&Undo Change wind"_s;
        QTest::newRow("asset") << Change([](Workspace& w) {
            w.moveAsset({0, 500});
        }) << u"&Undo Move asset"_s;
        QTest::newRow("added") << Change([](Workspace& w) {
            w.addIceberg({.position_m = {100, 900}});
        }) << u"&Undo Add iceberg"_s;
        QTest::newRow("seen") << Change([](Workspace& w) {
            w.reportSeen({"berg-2", "berg-3"});
        }) << u"&Undo Report sighting"_s;
        QTest::newRow("removed") << Change([](Workspace& w) {
            w.remove({"berg-2", "berg-3"});
        }) << u"&Undo Remove icebergs"_s;
        QTest::newRow("assigned") << Change([](Workspace& w) {
            w.assign({"berg-2", "berg-3"}, "u2");
        }) << u"&Undo Assign iceberg"_s;
        QTest::newRow("ordered") << Change([](Workspace& w) {
            w.order({"u2"}, FlightOrder::ReturnNow);
        }) << u"&Undo Order UAV"_s;
    }

    /** Nothing was flown since: the flight is at once as if the change had never been made. */
    void takesEveryChangeBack()
    {
        QFETCH(std::function<void(Workspace&)>, change);
        QFETCH(QString, name);
        const auto w = pausedFlight();
        const std::shared_ptr<const RunFile> before = flownRun(*w);
        QVERIFY(!canUndo(*w));

        change(w->workspace);
        QVERIFY(w->until([&] { return canUndo(*w); }));
        QCOMPARE(w->action(u"undoAction"_s).text(), name);
        QVERIFY(!flownRun(*w)->interventions.empty());
        w->trigger(u"undoAction"_s);
        QVERIFY(w->until([&] { return !canUndo(*w); }));
        QVERIFY(w->interaction.undoQuestions.isEmpty());
        QVERIFY(*flownRun(*w) == *before);
    }

    void takesOneAfterTheOtherBack()
    {
        const auto w = pausedFlight();
        w->workspace.setWind({3, 4});
        QVERIFY(w->until([&] { return canUndo(*w); })); // what waits together is one change
        w->workspace.setPolicy(PolicyKind::Nearest);
        QVERIFY(w->until([&] { return w->record().now.planner.policy == PolicyKind::Nearest; }));
        w->trigger(u"undoAction"_s);
        QVERIFY(w->until([&] { return w->record().now.planner.policy != PolicyKind::Nearest; }));
        QCOMPARE(w->action(u"undoAction"_s).text(), u"&Undo Change wind"_s);
        QVERIFY(w->workspace.wind_mps() == Point({3, 4}));
    }

    void asksWhereTimeWasFlownSince_data()
    {
        QTest::addColumn<bool>("agreed");
        QTest::newRow("agreed") << true;
        QTest::newRow("cancelled") << false;
    }

    /** The time since is given up only when the user agrees, and can be brought back. */
    void asksWhereTimeWasFlownSince()
    {
        QFETCH(bool, agreed);
        const auto w = pausedFlight();
        w->interaction.undoes = agreed;
        const double changed_s = w->record().now.time_s;
        w->workspace.setWind({3, 4});
        flyOneStep(*w);
        const std::shared_ptr<const RunFile> flown = flownRun(*w);

        w->trigger(u"undoAction"_s);
        QCOMPARE(w->interaction.undoQuestions, QStringList{u"Change wind | 00:01"_s});
        if (!agreed) {
            QVERIFY(*flownRun(*w) == *flown);
            return;
        }
        QVERIFY(w->until([&] { return w->record().now.time_s == changed_s; }));
        QVERIFY(flownRun(*w)->interventions.empty());
        w->trigger(u"bringBackAction"_s);
        QVERIFY(w->until([&] { return w->record().now.time_s > changed_s; }));
        QVERIFY(*flownRun(*w) == *flown);
    }

    /** Looking back changes nothing, and neither does a flight that has ended. */
    void isOffWhereNothingCanChange()
    {
        const auto w = pausedFlight();
        w->workspace.setWind({3, 4});
        flyOneStep(*w);
        QVERIFY(canUndo(*w));
        w->workspace.stepBack();
        QVERIFY(w->until([&] { return w->record().instant.has_value(); }));
        QVERIFY(!canUndo(*w));
    }
};

QTEST_MAIN(TestMainWindowUndo)
#include "tst_main_window_undo.moc"
