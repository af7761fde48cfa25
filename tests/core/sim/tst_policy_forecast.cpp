#include "core/plan/policy/policy.h"
#include "core/scenario/presets.h"
#include "core/sim/policy_forecast.h"
#include "tests/support/scenario_builder.h"

#include <QTest>

#include <set>

using namespace berg;

namespace {

Metrics flownWithoutNoise(Scenario scenario, PolicyKind policy)
{
    scenario.noise = false;
    scenario.planner.policy = policy;
    Mission mission(scenario);
    mission.advance(scenario.duration_s);
    return mission.metrics();
}

} // namespace

class TestPolicyForecast : public QObject
{
    Q_OBJECT

private slots:
    void isTheFlightWithoutNoise_data()
    {
        QTest::addColumn<PolicyKind>("policy");
        for (const auto& [policy, name] : kPolicyNames)
            QTest::newRow(std::string(name).c_str()) << policy;
    }
    void isTheFlightWithoutNoise()
    {
        QFETCH(PolicyKind, policy);
        const Scenario scenario = randomScenario(11, {.icebergs = 6});
        QVERIFY(scenario.noise);
        const std::optional<Metrics> forecast = forecastOf(scenario, policy);
        QVERIFY(forecast.has_value());
        QVERIFY(*forecast == flownWithoutNoise(scenario, policy));
        QVERIFY(forecast->zeta_m2s > 0 && forecast->visits > 0 && forecast->flown_m > 20000);
        QVERIFY(forecastOf(scenario, policy) == forecast);
    }

    void followsTau()
    {
        Scenario scenario = randomScenario(12);
        const Metrics one = forecastOf(scenario, PolicyKind::Visitation).value();
        scenario.planner.tau = 0;
        const Metrics other = forecastOf(scenario, PolicyKind::Visitation).value();
        QVERIFY(one.zeta_m2s != other.zeta_m2s);
        QVERIFY(other == flownWithoutNoise(scenario, PolicyKind::Visitation));
    }

    /** Where a beacon will have been is not known before. */
    void recordedTracksAreNotForeseen()
    {
        Scenario plain = randomScenario(13, {.icebergs = 4});
        Scenario recorded = plain;
        RecordedTrack& track = recorded.icebergs[0].track;
        track.time_s = {0, 500};
        track.position_m = {recorded.icebergs[0].position_m,
                            recorded.icebergs[0].position_m + Point(800, 800)};
        QVERIFY(!recorded.icebergs[0].track.empty());
        QVERIFY(forecastOf(recorded, PolicyKind::Nearest) ==
                forecastOf(plain, PolicyKind::Nearest));
        QVERIFY(forecastOf(recorded, PolicyKind::Nearest) !=
                flownWithoutNoise(recorded, PolicyKind::Nearest));
    }

    /** The same whether the flight itself has noise, and never that of its own seed. */
    void drawnWorlds()
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
        Mission own(scenario);
        own.advance(scenario.duration_s);
        QVERIFY(!zetas.contains(own.metrics().zeta_m2s));
        scenario.noise = false;
        QVERIFY(zetas.contains(drawnZeta_m2s(scenario, PolicyKind::Nearest, 3).value()));

        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!drawnZeta_m2s(scenario, PolicyKind::Nearest, 0, stop.get_token()).has_value());
    }

    void tellsHowFarItIs()
    {
        std::vector<double> shares;
        const auto forecast = forecastOf(randomScenario(14), PolicyKind::Nearest, {},
                                         [&](double share) { shares.push_back(share); });
        QVERIFY(forecast.has_value());
        QVERIFY(shares.size() > 100);
        QVERIFY(std::is_sorted(shares.begin(), shares.end()));
        QVERIFY(shares.front() > 0 && shares.back() <= 1);
    }

    void canBeStopped()
    {
        std::stop_source stop;
        double reached = 0;
        QVERIFY(!forecastOf(randomScenario(14), PolicyKind::Nearest, stop.get_token(),
                            [&](double share) {
                                reached = share;
                                if (share > 0.3)
                                    stop.request_stop();
                            }));
        QVERIFY(reached < 0.5);
    }

    void whatCannotBeFlownThrows()
    {
        Scenario scenario = randomScenario(15);
        scenario.icebergs[0].q_m2ps = -1;
        QVERIFY_THROWS_EXCEPTION(Error, (void)forecastOf(scenario, PolicyKind::Nearest));
    }
};

QTEST_APPLESS_MAIN(TestPolicyForecast)
#include "tst_policy_forecast.moc"
