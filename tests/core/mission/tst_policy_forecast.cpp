#include "core/mission/policy_forecast.h"
#include "core/plan/policy/policy.h"
#include "core/presets/presets.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

#include <set>

using namespace berg;

namespace {

double flown_m2s(const Scenario& scenario)
{
    Mission mission(scenario);
    mission.advance(scenario.duration_s);
    return mission.metrics().zeta_m2s;
}

} // namespace

class TestPolicyForecast : public QObject
{
    Q_OBJECT

private slots:
    void everyPolicyIsFlown_data()
    {
        QTest::addColumn<PolicyKind>("policy");
        for (const auto& [policy, name] : kPolicyNames)
            QTest::newRow(std::string(name).c_str()) << policy;
    }
    void everyPolicyIsFlown()
    {
        QFETCH(PolicyKind, policy);
        Scenario scenario = randomScenario(11, {.icebergs = 6});
        scenario.duration_s = 300;
        const double drawn_m2s = drawnZeta_m2s(scenario, policy, 0).value();
        QVERIFY(drawn_m2s > 0);
        QCOMPARE(drawnZeta_m2s(scenario, policy, 0).value(), drawn_m2s);
        scenario.planner.policy = policy == PolicyKind::Tour ? PolicyKind::Path : PolicyKind::Tour;
        // The scenario's own policy does not matter.
        QCOMPARE(drawnZeta_m2s(scenario, policy, 0).value(), drawn_m2s);
    }

    void followsTau()
    {
        Scenario scenario = randomScenario(12);
        const double one_m2s = drawnZeta_m2s(scenario, PolicyKind::Visitation, 0).value();
        scenario.planner.tau = 0;
        QVERIFY(drawnZeta_m2s(scenario, PolicyKind::Visitation, 0).value() != one_m2s);
    }

    /** The recorded track of a beacon is not known before the flight. */
    void recordedTracksAreNotForeseen()
    {
        Scenario plain = randomScenario(13, {.icebergs = 4});
        plain.planner.policy = PolicyKind::Nearest;
        Scenario recorded = plain;
        RecordedTrack& track = recorded.icebergs[0].track;
        track.time_s = {0, 500};
        track.position_m = {recorded.icebergs[0].position_m,
                            recorded.icebergs[0].position_m + Point(800, 800)};
        QVERIFY(flown_m2s(recorded) != flown_m2s(plain));
        QCOMPARE(drawnZeta_m2s(recorded, PolicyKind::Nearest, 0).value(),
                 drawnZeta_m2s(plain, PolicyKind::Nearest, 0).value());
    }

    /** The worlds do not depend on the noise setting, and never have the scenario's own seed. */
    void drawnWorldsRepeatByNumber()
    {
        Scenario scenario = randomScenario(15, {.icebergs = 6});
        scenario.observer.model = ObserverModel::Kalman;
        for (Iceberg& iceberg : scenario.icebergs)
            iceberg.velocitySd_mps = 0.2;
        std::set<double> zetas;
        for (int flight = 0; flight < 6; ++flight)
            zetas.insert(drawnZeta_m2s(scenario, PolicyKind::Nearest, flight).value());
        QCOMPARE(zetas.size(), std::size_t{6});
        scenario.planner.policy = PolicyKind::Nearest;
        QVERIFY(!zetas.contains(flown_m2s(scenario)));
        scenario.noise = false;
        QVERIFY(zetas.contains(drawnZeta_m2s(scenario, PolicyKind::Nearest, 3).value()));

        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!drawnZeta_m2s(scenario, PolicyKind::Nearest, 0, stop.get_token()).has_value());
    }

    void whatCannotBeFlownThrows()
    {
        Scenario scenario = randomScenario(15);
        scenario.icebergs[0].q_m2ps = -1;
        QVERIFY_THROWS_EXCEPTION(Error, (void)drawnZeta_m2s(scenario, PolicyKind::Nearest, 0));
    }
};

QTEST_APPLESS_MAIN(TestPolicyForecast)
#include "tst_policy_forecast.moc"
