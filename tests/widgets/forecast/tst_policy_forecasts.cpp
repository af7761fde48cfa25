#include "core/base/solving_guard.h"
#include "core/presets/presets.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "widgets/forecast/policy_forecasts.h"

#include <QSignalSpy>

using namespace berg;
using test::kPatience_ms;

namespace {

/** Returns few icebergs and a short flight, which every policy flies quickly. */
Scenario shortFlight(int seed)
{
    Scenario scenario = randomScenario(seed, {.icebergs = 3});
    scenario.duration_s = 120;
    return scenario;
}

/** Returns a day over hundreds of icebergs, which takes hours to plan. */
Scenario hugeField()
{
    Scenario scenario = randomScenario(1, {.icebergs = 300, .size_m = {60000, 60000}});
    scenario.duration_s = 86400;
    return scenario;
}

bool completes(const PolicyForecasts& runner)
{
    return QTest::qWaitFor([&] { return runner.isComplete(); }, kPatience_ms);
}

constexpr int kFlights = 2; // sanitizers make coverage slow

/** Returns the forecast that the runner must have. */
PolicyForecast flownAhead(const Scenario& scenario, PolicyKind policy)
{
    PolicyForecast forecast{.state = ForecastState::Known, .share = 1};
    for (int flight = 0; flight < kFlights; ++flight)
        forecast.drawn_m2s.push_back(drawnZeta_m2s(scenario, policy, flight).value());
    return forecast;
}

ForecastState stateOf(const PolicyForecasts& runner, PolicyKind policy)
{
    return runner.forecasts().at(policy).state;
}

} // namespace

class TestPolicyForecasts : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void forecastsEveryPolicy()
    {
        const Scenario scenario = shortFlight(2);
        PolicyForecastList expected;
        for (const PolicyKind policy :
             {PolicyKind::Visitation, PolicyKind::Path, PolicyKind::Tour, PolicyKind::Nearest,
              PolicyKind::Uncertainty, PolicyKind::Latency, PolicyKind::Coverage})
            expected[policy] = flownAhead(scenario, policy);
        const NoBlockingScope onThisThread; // a flight here would throw
        PolicyForecasts runner(nullptr, kPatience_ms, kFlights);
        QVERIFY(runner.isComplete() && runner.forecasts().empty());
        std::vector<PolicyKind> known;
        connect(&runner, &PolicyForecasts::updated, this, [&] {
            for (const auto& [policy, forecast] : runner.forecasts())
                if (forecast.state == ForecastState::Known &&
                    std::find(known.begin(), known.end(), policy) == known.end())
                    known.push_back(policy);
        });
        runner.setScenario(scenario);
        QVERIFY(!runner.isComplete());
        QVERIFY(completes(runner));
        QCOMPARE(runner.forecasts().size(), expected.size());
        QVERIFY(runner.forecasts() == expected);
        QCOMPARE(known.size(), expected.size()); // reported one by one, the slowest one last
        QVERIFY(known.front() == scenario.planner.policy);
        QVERIFY(known.back() == PolicyKind::Coverage);
        const PolicyForecast& nearest = expected[PolicyKind::Nearest];
        QVERIFY(nearest.prediction() == predictionOf(nearest.drawn_m2s));
        QVERIFY(!PolicyForecast{.state = ForecastState::Computing}.prediction());
    }

    /** Only forecasts that depend on the change are repeated; the others stay visible. */
    void changesKeepWhatStillHolds()
    {
        Scenario scenario = shortFlight(3);
        PolicyForecasts runner(nullptr, kPatience_ms, kFlights);
        runner.setScenario(scenario);
        QVERIFY(completes(runner));
        const PolicyForecastList before = runner.forecasts();
        scenario.planner.tau = 0;
        runner.setScenario(scenario);
        for (const auto& [policy, forecast] : runner.forecasts()) {
            if (policy == PolicyKind::Visitation)
                QVERIFY(forecast.state == ForecastState::Waiting);
            else
                QVERIFY(forecast == before.at(policy));
        }
        QVERIFY(completes(runner));
        QVERIFY(runner.forecasts().at(PolicyKind::Visitation) ==
                flownAhead(scenario, PolicyKind::Visitation));

        QSignalSpy updated(&runner, &PolicyForecasts::updated);
        scenario.name = "another";
        // A choice of the policy, not a change of its settings.
        scenario.planner.policy = PolicyKind::Coverage;
        runner.setScenario(scenario);
        QVERIFY(runner.isComplete());
        QCOMPARE(updated.count(), 0);

        scenario.icebergs[0].position_m.x() += 100;
        runner.setScenario(scenario);
        for (const auto& [policy, forecast] : runner.forecasts())
            QVERIFY(forecast.state == ForecastState::Waiting);
    }

    void newestScenarioWins()
    {
        Scenario scenario = shortFlight(4);
        PolicyForecasts runner(nullptr, kPatience_ms, kFlights);
        for (int i = 0; i < 30; ++i) {
            scenario.icebergs[0].position_m.x() += 10;
            runner.setScenario(scenario);
            QTest::qWait(i % 10 == 0 ? 320 : 0); // some are in progress by then
        }
        QVERIFY(completes(runner));
        for (const PolicyKind policy : {PolicyKind::Nearest, PolicyKind::Coverage})
            QVERIFY(runner.forecasts().at(policy) == flownAhead(scenario, policy));
    }

    /** A slow forecast is stopped, and the next one started. */
    void thereIsALimit()
    {
        PolicyForecasts runner(nullptr, 2000, kFlights);
        runner.setScenario(hugeField());
        QVERIFY(completes(runner));
        for (const PolicyKind policy :
             {PolicyKind::Visitation, PolicyKind::Latency, PolicyKind::Coverage})
            QVERIFY(stateOf(runner, policy) == ForecastState::TooLong);
        // It continues with flights that keep the limit. On a busy machine a short one may exceed
        // it, too; then the next one is tried.
        Scenario easy;
        int seed = 5;
        do {
            easy = shortFlight(seed);
            runner.setScenario(easy);
            QVERIFY(completes(runner));
        } while (stateOf(runner, PolicyKind::Nearest) != ForecastState::Known && ++seed < 60);
        QVERIFY(runner.forecasts().at(PolicyKind::Nearest) ==
                flownAhead(easy, PolicyKind::Nearest));
    }

    void brokenScenariosHaveNone()
    {
        Scenario scenario = shortFlight(6);
        PolicyForecasts runner(nullptr, kPatience_ms, kFlights);
        scenario.icebergs[0].q_m2ps = -1;
        runner.setScenario(scenario);
        QVERIFY(completes(runner));
        for (const auto& [policy, forecast] : runner.forecasts())
            QVERIFY(forecast.state == ForecastState::Impossible);
        runner.setScenario(shortFlight(6)); // corrected
        QVERIFY(completes(runner));
        QVERIFY(stateOf(runner, PolicyKind::Nearest) == ForecastState::Known);
    }

    void policiesThatCannotBeFlownSayWhy()
    {
        Scenario scenario = shortFlight(7);
        scenario.planner.backend = Backend::Cbc;
        PolicyForecasts runner(nullptr, kPatience_ms, kFlights);
        runner.setScenario(scenario);
        QVERIFY(completes(runner));
        const PolicyForecast& latency = runner.forecasts().at(PolicyKind::Latency);
        QVERIFY(latency.state == ForecastState::Impossible);
        QVERIFY(!latency.unsupportedReason.isEmpty());
        QVERIFY(stateOf(runner, PolicyKind::Nearest) == ForecastState::Known);
        scenario.planner.backend = Backend::Auto;
        runner.setScenario(scenario);
        QVERIFY(completes(runner));
        QVERIFY(stateOf(runner, PolicyKind::Latency) == ForecastState::Known);
    }

    /** Closing does not wait for the end of a day's flight. */
    void closesDuringAForecast()
    {
        PolicyForecasts runner(nullptr, kPatience_ms, kFlights);
        runner.setScenario(hugeField());
        QVERIFY(QTest::qWaitFor(
            [&] {
                const PolicyForecastList& list = runner.forecasts();
                return std::any_of(list.begin(), list.end(), [](const auto& entry) {
                    return entry.second.state == ForecastState::Computing;
                });
            },
            kPatience_ms));
    }
};

QTEST_MAIN(TestPolicyForecasts)
#include "tst_policy_forecasts.moc"
