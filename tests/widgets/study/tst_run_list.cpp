#include "core/base/solving_guard.h"
#include "tests/support/window/comparison_builder.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "widgets/map/picture/mission_picture.h"
#include "widgets/study/run_list.h"

#include <QSignalSpy>
#include <QTemporaryDir>

using namespace berg;
using namespace test;
using namespace Qt::StringLiterals;

namespace {

/** Many icebergs, small steps and many hours, which no test can wait for. */
Scenario endlessScenario()
{
    Scenario scenario = randomScenario(4, {.icebergs = 60, .size_m = {40000, 40000}});
    scenario.duration_s = 500000;
    return scenario;
}

void compareRuns(const ComparedRun& run, const Mission& mission)
{
    QVERIFY(run.metrics == mission.metrics());
    QCOMPARE(run.flown_s, mission.simulation().time_s());
    const std::vector<Sample>& samples = mission.recorder().samples();
    QCOMPARE(run.samples.size(), samples.size());
    for (std::size_t k = 0; k < samples.size(); ++k) {
        QCOMPARE(run.samples[k].zeta_m2s, samples[k].zeta_m2s);
        QVERIFY(run.samples[k].uavs[0].pose.position_m == samples[k].uavs[0].pose.position_m);
    }
    const RunFigures figures = figuresAt(run, run.flown_s);
    QCOMPARE(figures.zeta_m2s, mission.metrics().zeta_m2s);
    QCOMPARE(figures.visits, mission.metrics().visits);
    QCOMPARE(figures.plans, mission.metrics().replans);
    QCOMPARE(figures.flown_m, mission.metrics().flown_m);
    QCOMPARE(figures.unseen.size(), mission.icebergs().size());
}

bool ends(QSignalSpy& finished)
{
    return !finished.isEmpty() || finished.wait(kPatience_ms);
}

} // namespace

class TestRunList : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void backgroundFlightEqualsAMission_data()
    {
        QTest::addColumn<PolicyKind>("kind");
        QTest::addColumn<double>("tau");
        QTest::newRow("tour") << PolicyKind::Tour << 1.0;
        QTest::newRow("tau 0.5") << PolicyKind::Visitation << 0.5;
        QTest::newRow("nearest") << PolicyKind::Nearest << 1.0;
    }

    void backgroundFlightEqualsAMission()
    {
        QFETCH(PolicyKind, kind);
        QFETCH(double, tau);
        const Mission expected = flownWith(shortScenario(), policy(kind, tau));
        const NoBlockingScope onThisThread; // a solve here would throw
        RunList list;
        QSignalSpy finished(&list, &RunList::finished);
        list.addFlown(shortScenario(), policy(kind, tau));
        QVERIFY(list.isFlying());
        QVERIFY(!list.flying(QLocale::c()).isEmpty());
        QVERIFY(ends(finished));
        QCOMPARE(finished[0][0].toString(), QString());
        QVERIFY(!list.isFlying());
        QCOMPARE(list.runs().size(), std::size_t{1});
        compareRuns(*list.reference(), expected);
        QVERIFY(list.other() == nullptr);
        QVERIFY(!list.comparison());
    }

    /** A run is added when it is complete, and again when it is stopped. */
    void nameSurvivesTheSameRun()
    {
        const Mission mission = flownWith(shortScenario(), policy(PolicyKind::Nearest));
        RunList list;
        list.add(recordOf(mission));
        list.rename(0, u"first try"_s);
        list.add(recordOf(mission));
        QCOMPARE(list.runs().size(), std::size_t{1});
        QCOMPARE(list.runs()[0]->name, u"first try"_s);
        QVERIFY(list.reference() == list.runs()[0]);
        QVERIFY(!list.comparison()); // not with itself
    }

    void aVariantIsSetBesideTheReference()
    {
        const Mission first = flownWith(shortScenario(), policy(PolicyKind::Nearest));
        const Mission tour = flownWith(shortScenario(), policy(PolicyKind::Tour));
        const NoBlockingScope onThisThread;
        RunList list;
        QSignalSpy finished(&list, &RunList::finished);
        QSignalSpy comparisonChanged(&list, &RunList::comparisonChanged);
        list.add(recordOf(first));
        QCOMPARE(comparisonChanged.count(), 1);
        compareRuns(*list.reference(), first);
        list.addVariant(*list.reference(), policy(PolicyKind::Tour));
        QVERIFY(ends(finished));
        QCOMPARE(comparisonChanged.count(), 2);
        compareRuns(*list.reference(), first);
        compareRuns(*list.other(), tour);
        QCOMPARE(list.comparison()->until_s, 300.0);
        // An equal run is not flown again.
        list.setReference(1);
        QVERIFY(list.reference() == list.runs()[1] && list.other() == list.runs()[0]);
        list.setReference(0);
        list.remove(1);
        QVERIFY(!list.comparison());
        list.addVariant(*list.reference(), policy(PolicyKind::Nearest));
        QVERIFY(!list.isFlying());
    }

    /** Icebergs added in flight belong to the world, not to the settings. */
    void variantsMeetTheSameIcebergs()
    {
        const auto flown = [](const PlannerSettings& planner, bool changed) {
            Mission mission = flownWith(shortScenario(), planner, 100);
            mission.intervene({.appears = newIceberg()});
            mission.advance(200);
            if (changed)
                mission.intervene({.tau = 2.5});
            mission.advance(300);
            return mission;
        };
        const Mission first = flown(policy(PolicyKind::Visitation), true);
        const Mission expected = flown(policy(PolicyKind::Tour), false);
        const Mission without = flownWith(shortScenario(), policy(PolicyKind::Tour));
        RunList list;
        QSignalSpy finished(&list, &RunList::finished);
        list.add(recordOf(without));
        list.add(recordOf(first));
        QVERIFY(list.other() == nullptr); // another world
        QVERIFY(list.reference()->wasChanged);
        QCOMPARE(list.reference()->planner.tau, 2.5);
        list.addVariant(*list.reference(), policy(PolicyKind::Tour));
        QVERIFY(ends(finished));
        QVERIFY(list.other() != nullptr);
        QVERIFY(!list.other()->wasChanged);
        compareRuns(*list.other(), expected);
    }

    /** A tour does not depend on tau, so the present one is used. */
    void equalFlightsAreNotFlownAgain_data()
    {
        QTest::addColumn<PolicyKind>("kind");
        QTest::addColumn<bool>("flies");
        QTest::newRow("tour") << PolicyKind::Tour << false;
        QTest::newRow("visitation") << PolicyKind::Visitation << true;
    }

    void equalFlightsAreNotFlownAgain()
    {
        QFETCH(PolicyKind, kind);
        QFETCH(bool, flies);
        RunList list;
        list.add(recordOf(flownWith(shortScenario(), policy(kind, 1))));
        list.add(recordOf(flownWith(shortScenario(), policy(PolicyKind::Nearest))));
        list.setReference(1);
        list.addVariant(*list.reference(), policy(kind, 2));
        QCOMPARE(list.isFlying(), flies);
        QCOMPARE(list.other()->planner.tau, 1.0);
    }

    void flightsWaitForEachOther()
    {
        RunList list;
        QSignalSpy finished(&list, &RunList::finished);
        list.addFlown(shortScenario(), policy(PolicyKind::Nearest));
        list.addFlown(shortScenario(), policy(PolicyKind::Tour));
        QVERIFY(ends(finished));
        QCOMPARE(list.runs().size(), std::size_t{2});
        QCOMPARE(list.reference()->planner.policy, PolicyKind::Nearest);
        QCOMPARE(list.other()->planner.policy, PolicyKind::Tour);
    }

    void nothingFlownIsNoRun()
    {
        RunList list;
        QSignalSpy changed(&list, &RunList::changed);
        list.add(FlightRecord{.scenario = shortScenario()});
        list.add(recordOf(flownWith(shortScenario(), policy(PolicyKind::Nearest), 0)));
        QVERIFY(list.runs().empty());
        QCOMPARE(changed.count(), 0);
    }

    void anEqualRunTakesThePlace()
    {
        const FlightRecord record =
            recordOf(flownWith(shortScenario(), policy(PolicyKind::Nearest), 120));
        RunList list;
        list.add(record);
        list.add(recordOf(flownWith(shortScenario(), policy(PolicyKind::Uncertainty))));
        list.add(record);
        QCOMPARE(list.runs().size(), std::size_t{2});
        QVERIFY(list.reference() == list.runs()[0]);
        QVERIFY(list.other() == list.runs()[1]);
        QCOMPARE(list.comparison()->until_s, 120.0);
        list.add(recordOf(flownWith(shortScenario(), policy(PolicyKind::Nearest), 121)));
        QCOMPARE(list.runs().size(), std::size_t{3}); // flown further, so it is another run
    }

    /** Runs of the previous scenario stay in the list, but are not compared. */
    void anotherScenarioHasOtherRuns()
    {
        RunList list;
        list.add(flownRecord(shortScenario(), policy(PolicyKind::Visitation), 50));
        list.add(flownRecord(shortScenario(), policy(PolicyKind::Tour), 50));
        QVERIFY(list.comparison());
        Scenario other = shortScenario();
        other.seed += 1;
        list.showWorld(other);
        QVERIFY(!list.reference() && !list.other());
        QCOMPARE(list.runs().size(), std::size_t{2});
        list.add(flownRecord(other, policy(PolicyKind::Visitation), 50));
        QVERIFY(list.reference() == list.runs().back());
        QVERIFY(!list.other());
        list.showWorld(shortScenario());
        QVERIFY(list.reference() == list.runs()[1]);
        QVERIFY(list.other() == list.runs()[0]);
    }

    void theOldestMakesRoom()
    {
        RunList list;
        const Scenario scenario = shortScenario();
        for (int k = 0; k <= static_cast<int>(RunList::kMost); ++k) {
            list.add(recordOf(flownWith(scenario, policy(PolicyKind::Nearest), 10 + k)));
            if (k == 1)
                list.setOther(0);
        }
        QCOMPARE(list.runs().size(), RunList::kMost);
        QCOMPARE(list.other()->flown_s, 10.0); // stays while it is compared
        QCOMPARE(list.runs()[1]->flown_s, 12.0);
        QCOMPARE(list.reference()->flown_s, 10.0 + static_cast<double>(RunList::kMost));
    }

    void choosesReferenceAndOther()
    {
        RunList list;
        const Scenario scenario = shortScenario();
        for (const PolicyKind kind :
             {PolicyKind::Nearest, PolicyKind::Uncertainty, PolicyKind::Path})
            list.add(recordOf(flownWith(scenario, policy(kind), 60)));
        list.add(recordOf(flownWith(shortScenario(8), policy(PolicyKind::Nearest), 60)));
        QVERIFY(list.reference() == list.runs()[3]);
        QVERIFY(list.other() == nullptr);
        list.setOther(0); // of another scenario
        QVERIFY(list.other() == nullptr);
        list.setReference(0);
        QVERIFY(list.other() == list.runs()[2]); // the newest run
        list.setOther(1);
        QVERIFY(list.other() == list.runs()[1]);
        list.setOther(0); // choosing the reference swaps the two
        QVERIFY(list.reference() == list.runs()[1] && list.other() == list.runs()[0]);
        QVERIFY(list.otherIn(scenario) == list.other());
        QVERIFY(list.otherIn(shortScenario(8)) == nullptr);
        list.remove(1);
        QVERIFY(list.reference() == list.runs()[0]); // the run compared with it
        QVERIFY(list.other() == list.runs()[1]);
        list.remove(0);
        list.remove(0);
        list.remove(0);
        QVERIFY(list.runs().empty() && list.reference() == nullptr && list.other() == nullptr);
    }

    void cancelLeavesNoRun()
    {
        RunList list;
        QSignalSpy finished(&list, &RunList::finished);
        QSignalSpy progress(&list, &RunList::progress);
        list.addFlown(endlessScenario(), policy(PolicyKind::Nearest));
        list.addFlown(endlessScenario(), policy(PolicyKind::Tour));
        QVERIFY(QTest::qWaitFor([&] { return progress.count() > 1; }, kPatience_ms));
        QCOMPARE(progress.back()[1].toDouble(), 500000.0);
        list.cancel();
        QVERIFY(ends(finished));
        QCOMPARE(finished[0][0].toString(), QString());
        QVERIFY(!list.isFlying());
        QVERIFY(list.runs().empty());
        list.addFlown(shortScenario(), policy(PolicyKind::Nearest)); // the list still works
        QVERIFY(QTest::qWaitFor([&] { return list.runs().size() == 1; }, kPatience_ms));
    }

    void closesDuringAFlight()
    {
        auto list = std::make_unique<RunList>();
        QSignalSpy progress(list.get(), &RunList::progress);
        list->addFlown(endlessScenario(), policy(PolicyKind::Visitation));
        QVERIFY(QTest::qWaitFor([&] { return progress.count() > 1; }, kPatience_ms));
        list.reset(); // waits for the thread
        QVERIFY(progress.count() > 1);
    }

    void brokenScenariosAreReported()
    {
        Scenario scenario = shortScenario();
        scenario.icebergs[0].q_m2ps = -1;
        RunList list;
        QSignalSpy finished(&list, &RunList::finished);
        list.addFlown(scenario, policy(PolicyKind::Nearest));
        list.addFlown(shortScenario(), policy(PolicyKind::Nearest));
        QVERIFY(ends(finished));
        QVERIFY(finished[0][0].toString().contains(u"q_m2ps"_s));
        QCOMPARE(list.runs().size(), std::size_t{1}); // the next one was still flown
    }

    void runFilesAreFlownAgain_data()
    {
        QTest::addColumn<bool>("record");
        QTest::newRow("with a record") << true;
        QTest::newRow("without") << false;
    }

    void runFilesAreFlownAgain()
    {
        QFETCH(bool, record);
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"ø.bergrun"_s);
        Scenario scenario = shortScenario();
        scenario.planner = policy(PolicyKind::Visitation, 0.5);
        Mission mission(scenario, {.record = record});
        mission.advance(150);
        mission.intervene({.policy = PolicyKind::Nearest});
        mission.advance(250);
        saveRun(runOf(mission), QFile::encodeName(path).toStdString());
        RunList list;
        QSignalSpy finished(&list, &RunList::finished);
        list.open(path);
        QVERIFY(ends(finished));
        QCOMPARE(finished[0][0].toString(), QString());
        QVERIFY(list.reference()->metrics == mission.metrics());
        QVERIFY(list.reference()->wasChanged);
        QCOMPARE(list.reference()->file, path);
        QCOMPARE(list.reference()->samples.size(), std::size_t{251});
    }

    void filesThatDoNotRepeatAreRefused()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"a.bergrun"_s);
        RunFile run = runOf(flownWith(shortScenario(), policy(PolicyKind::Nearest), 100));
        run.metrics.zeta_m2s += 1;
        saveRun(run, path.toStdString());
        RunList list;
        QSignalSpy finished(&list, &RunList::finished);
        list.open(path);
        QVERIFY(ends(finished));
        QVERIFY(finished[0][0].toString().contains(u"zeta"_s));
        QVERIFY(list.runs().empty());
        finished.clear();
        list.open(folder.filePath(u"none.bergrun"_s));
        QVERIFY(ends(finished));
        QVERIFY(!finished[0][0].toString().isEmpty());
    }
};

QTEST_MAIN(TestRunList)
#include "tst_run_list.moc"
