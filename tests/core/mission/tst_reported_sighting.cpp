#include "core/io/files/run_json.h"
#include "core/mission/mission.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/files/file_texts.h"

#include <QTest>

using namespace berg;

namespace {

Scenario field(ObserverModel model)
{
    Scenario scenario = randomScenario(3, {.icebergs = 6});
    scenario.observer.model = model;
    return scenario;
}

/** Returns an iceberg that has long been out of view at this instant. */
IcebergIndex longUnseen(const Simulation& simulation)
{
    IcebergIndex found;
    for (const IcebergIndex i : simulation.icebergs())
        if (simulation.track(i).sigma_m2 > simulation.track(found).sigma_m2)
            found = i;
    return found;
}

} // namespace

/** Icebergs sighted by somebody else in the past. */
class TestReportedSighting : public QObject
{
    Q_OBJECT

private slots:
    void sigmaHasGrownSince_data()
    {
        QTest::addColumn<ObserverModel>("model");
        QTest::newRow("simple") << ObserverModel::Simple;
        QTest::newRow("Kalman") << ObserverModel::Kalman;
    }

    void sigmaHasGrownSince()
    {
        QFETCH(ObserverModel, model);
        const Scenario scenario = field(model);
        Mission mission(scenario);
        mission.advance(300);
        const IcebergIndex iceberg = longUnseen(mission.simulation());
        const Track before = mission.simulation().track(iceberg);
        const std::string id = scenario.icebergs[toIndex(iceberg)].id;
        mission.intervene({.seen = id, .seenAge_s = 60});
        const Track& after = mission.simulation().track(iceberg);
        const double lookSd_m = scenario.observer.positionSd_m;
        const double report_m2 = 60 * before.q_m2ps;
        if (model == ObserverModel::Simple) {
            QCOMPARE(after.sigma_m2, report_m2);
        } else { // two independent estimates of one place: 1/v = 1/a + 1/b
            const double each_m2 = report_m2 + lookSd_m * lookSd_m;
            COMPARE_NEAR(after.sigma_m2, 1 / (1 / before.sigma_m2 + 1 / each_m2), 1e-9);
        }
        QCOMPARE(after.seen_s, 240.0);
        QVERIFY(!after.inView);
    }

    /** An old report about an iceberg in view adds nothing. */
    void whatIsKnownBetterStays()
    {
        const Scenario scenario = field(ObserverModel::Simple);
        Mission mission(scenario);
        mission.advance(300);
        const IcebergIndex iceberg = longUnseen(mission.simulation());
        const Track before = mission.simulation().track(iceberg);
        const std::string id = scenario.icebergs[toIndex(iceberg)].id;
        mission.intervene({.seen = id, .seenAge_s = 1e6});
        QVERIFY(mission.simulation().track(iceberg) == before);
        QCOMPARE(mission.interventions().size(), std::size_t{1});
    }

    void reportedSightingReplays()
    {
        const Scenario scenario = field(ObserverModel::Kalman);
        Mission mission(scenario);
        mission.advance(300);
        const IcebergIndex iceberg = longUnseen(mission.simulation());
        const std::string id = scenario.icebergs[toIndex(iceberg)].id;
        mission.intervene({.seen = id, .seenAge_s = 45});
        mission.advance(600);
        const RunFile run = runFromJson(runToJson(runOf(mission)), "run");
        QCOMPARE(run.interventions.front().seenAge_s, 45.0);
        const Mission again = replay(run);
        QVERIFY(compareRun(run, runOf(again)).empty());
        QVERIFY(again.metrics() == mission.metrics());
    }
};

QTEST_APPLESS_MAIN(TestReportedSighting)
#include "tst_reported_sighting.moc"
