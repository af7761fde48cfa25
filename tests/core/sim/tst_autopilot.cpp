#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/mission/mission_instant.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/flight/flown_plans.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace berg;

namespace {

/** Answers `good` solves, then throws at each of `silent` calls, then answers again. */
class FaultySolver final : public TvpSolver
{
public:
    FaultySolver(int good, int silent) : m_good(good), m_silent(silent) {}
    [[nodiscard]] AnswerSource source() const override { return AnswerSource::Exact; }
    [[nodiscard]] std::optional<IssueReason> unsupportedReason(const TvpProblem&) const override
    {
        return std::nullopt;
    }

protected:
    [[nodiscard]] SolveOutcome doSolve(const TvpProblem& problem,
                                       const SolveOptions& options) const override
    {
        const int call = m_calls++;
        if (call >= m_good && call < m_good + m_silent)
            throw std::runtime_error("out of order");
        return makeSolver(Backend::Exact)->solve(problem, options);
    }

private:
    int m_good;
    int m_silent;
    mutable int m_calls = 0;
};

std::ptrdiff_t failuresOf(const Mission& mission)
{
    return std::count_if(mission.events().begin(), mission.events().end(),
                         [](const MissionEvent& e) { return e.kind == EventKind::PlannerFailed; });
}

Scenario late(std::int64_t seed, double latency_s, PolicyKind policy = PolicyKind::Visitation)
{
    Scenario scenario = randomScenario(seed);
    scenario.planningTime_s = latency_s;
    scenario.planner.policy = policy;
    return scenario;
}

double zetaOf(const Scenario& scenario)
{
    Mission mission(scenario, {.workLimit = 20'000, .record = false});
    mission.advance(scenario.duration_s);
    return mission.metrics().zeta_m2s;
}

} // namespace

/** The autopilot flies on when the planner is late or fails. */
class TestAutopilot : public QObject
{
    Q_OBJECT

private slots:
    void aPlannerThatThrowsLeavesTheLastPlan()
    {
        Mission mission(randomScenario(2), {}, std::make_unique<FaultySolver>(2, 1'000'000));
        QCOMPARE(mission.advance(1000), AdvanceStatus::Finished);
        QVERIFY(mission.plans().size() > 5);
        QCOMPARE(failuresOf(mission), static_cast<std::ptrdiff_t>(mission.plans().size()) - 2);
        // The third plan continues the order of the second.
        const IcebergList second = test::flownPlans(mission)[1].order;
        QVERIFY(test::flownPlans(mission)[2].fellBack);
        QCOMPARE(test::flownPlans(mission)[2].target(), second[1]);
        // It still sees most icebergs.
        QVERIFY(mission.metrics().visits >= 6);
        const auto failure =
            std::find_if(mission.events().begin(), mission.events().end(),
                         [](const MissionEvent& e) { return e.kind == EventKind::PlannerFailed; });
        QVERIFY(failure->failure.find("out of order") != std::string::npos);
    }

    void aPlannerThatThrowsFromTheStart()
    {
        Mission mission(randomScenario(2), {}, std::make_unique<FaultySolver>(0, 1'000'000));
        QCOMPARE(mission.advance(1000), AdvanceStatus::Finished);
        QVERIFY(mission.metrics().visits > 0); // the nearest iceberg each time
    }

    void planningResumesWhenThePlannerRecovers()
    {
        Mission mission(randomScenario(2), {}, std::make_unique<FaultySolver>(1, 3));
        mission.advance(1000);
        QCOMPARE(failuresOf(mission), std::ptrdiff_t{3});
        QVERIFY(!test::flownPlans(mission).back().fellBack);
    }

    /**
     * A plan comes into force after the scenario's delay; until then the previous plan is flown.
     */
    void plansComeLate()
    {
        Mission mission(late(3, 12));
        mission.advance(1000);
        const std::vector<test::FlownPlan> plans = test::flownPlans(mission);
        QVERIFY(!plans[0].interim);
        QCOMPARE(plans[0].time_s, 0.0);
        std::size_t waits = 0;
        for (std::size_t i = 1; i < plans.size(); ++i)
            if (plans[i].interim && !plans[i - 1].interim) {
                const auto made =
                    std::find_if(plans.begin() + static_cast<std::ptrdiff_t>(i), plans.end(),
                                 [](const test::FlownPlan& p) { return !p.interim; });
                if (made == plans.end())
                    break; // the run ends first
                COMPARE_NEAR(made->time_s - plans[i].time_s, 12, 1e-6);
                // Meanwhile the rest of the previous plan is flown.
                if (plans[i].reason == PlanReason::TargetReached && plans[i - 1].order.size() > 1)
                    QCOMPARE(plans[i].target(), plans[i - 1].order[1]);
                ++waits;
            }
        QVERIFY(waits > 5);
        const auto made = std::count_if(plans.begin(), plans.end(),
                                        [](const test::FlownPlan& p) { return !p.interim; });
        QCOMPARE(mission.metrics().replans, static_cast<int>(made));
    }

    /** With any policy and delay the flight has no gap, and the delay costs little. */
    void everyPolicyFliesOn_data()
    {
        QTest::addColumn<int>("policy");
        for (const PolicyKind policy :
             {PolicyKind::Visitation, PolicyKind::Path, PolicyKind::Tour, PolicyKind::Nearest,
              PolicyKind::Uncertainty, PolicyKind::Latency, PolicyKind::Coverage})
            QTest::addRow("%d", static_cast<int>(policy)) << static_cast<int>(policy);
    }
    void everyPolicyFliesOn()
    {
        QFETCH(int, policy);
        for (const double latency_s : {0.5, 7.0, 400.0}) {
            Mission mission(late(5, latency_s, static_cast<PolicyKind>(policy)),
                            {.workLimit = 20'000});
            QCOMPARE(mission.advance(1000), AdvanceStatus::Finished);
            QVERIFY(mission.metrics().visits > 3);
            // There is one plan or its interim for each reason, and no more.
            QVERIFY(mission.plans().size() < 2 * mission.events().size() + 50);
        }
    }

    void aShortLatencyCostsLittle()
    {
        double prompt_m2s = 0;
        double late_m2s = 0;
        for (int seed = 1; seed <= 20; ++seed) {
            prompt_m2s += zetaOf(late(seed, 0));
            late_m2s += zetaOf(late(seed, 5));
        }
        QVERIFY(std::abs(late_m2s / prompt_m2s - 1) < 0.1);
    }

    void lateFlightsReplay()
    {
        for (const PolicyKind policy : {PolicyKind::Visitation, PolicyKind::Coverage}) {
            const auto fly = [&](double until_s) {
                Mission mission(late(6, 9, policy),
                                {.workLimit = 20'000, .keyframeInterval_s = 50});
                mission.advance(200);
                mission.intervene({.tau = 2});
                mission.advance(until_s);
                return mission;
            };
            const Mission mission = fly(800);
            const RunFile read = runFromJson(runToJson(runOf(mission)), "run");
            QVERIFY(read == runOf(mission));
            QVERIFY(compareRun(read, runOf(replay(read))).empty());
            for (const double time_s : {201.0, 333.0, 640.0}) {
                const Mission until = fly(time_s);
                const MissionInstant instant = instantAt(mission, time_s);
                QVERIFY(instant.simulation.state() == until.simulation().state());
                QCOMPARE(instant.metrics.replans, until.metrics().replans);
            }
        }
    }

    /** The result does not depend on how calls divide the time, even with a pending plan. */
    void slicesDoNotMatter()
    {
        Mission whole(late(7, 6));
        whole.advance(1000);
        Mission sliced(late(7, 6));
        for (double t = 0.7; t < 1001; t += 0.7)
            sliced.advance(t);
        QVERIFY(sliced.metrics() == whole.metrics());
        QVERIFY(sliced.simulation().state() == whole.simulation().state());
    }

    /** The turn rate is held between two commands. */
    void commandsAtTheirOwnRate()
    {
        Scenario scenario = randomScenario(4);
        scenario.uavs[0].spec.autopilot_s = 0.5;
        Mission mission(scenario, {.sampleInterval_s = 0.1});
        mission.advance(200);
        const std::vector<Sample>& samples = mission.recorder().samples();
        int changes = 0;
        for (std::size_t i = 2; i < samples.size(); ++i) {
            if (samples[i].uavs[0].u_radps == samples[i - 1].uavs[0].u_radps)
                continue;
            QCOMPARE((i - 1) % 5, 0U); // commands come with steps 1, 6, 11, ...
            ++changes;
        }
        QVERIFY(changes > 50);
        // A rate equal to the time step changes nothing.
        scenario.uavs[0].spec.autopilot_s = 0.1;
        Scenario plain = scenario;
        plain.uavs[0].spec.autopilot_s = 0;
        QCOMPARE(zetaOf(scenario), zetaOf(plain));
        // At a tenth of the rate it still reaches its targets.
        scenario.uavs[0].spec.autopilot_s = 1;
        QVERIFY(std::abs(zetaOf(scenario) / zetaOf(plain) - 1) < 0.1);
    }

    void ratesAndDelaysAreStoredAndChecked()
    {
        Scenario scenario = late(1, 2.5);
        scenario.uavs[0].spec.autopilot_s = 0.2;
        QVERIFY(scenarioFromJson(scenarioToJson(scenario), "s") == scenario);
        scenario.planningTime_s = -1;
        QVERIFY_THROWS_EXCEPTION(Error, Mission{scenario});
        scenario.planningTime_s = 0;
        scenario.uavs[0].spec.autopilot_s = 61;
        QVERIFY_THROWS_EXCEPTION(Error, Mission{scenario});
    }
};

QTEST_APPLESS_MAIN(TestAutopilot)
#include "tst_autopilot.moc"
