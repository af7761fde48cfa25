#include "core/coverage/coverage_policy.h"
#include "core/mission/mission.h"
#include "core/mission/plan_requests.h"
#include "core/presets/presets.h"
#include "core/scenario/limits.h"
#include "tests/support/flight/fleet_flight.h"
#include "tests/support/flight/flown_plans.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

#include <algorithm>
#include <map>
#include <set>
#include <thread>

using namespace berg;

namespace {

constexpr std::int64_t kWork = 2'000'000;

std::unique_ptr<Policy> coverage()
{
    static const std::unique_ptr<TvpSolver> solver = makeSolver(Backend::Auto);
    return makeFlownPolicy({.policy = PolicyKind::Coverage}, *solver);
}

/** Makes a scenario of icebergs about 4 km apart that runs for hours. */
Scenario sparseField(int seed, int icebergs, double duration_s, int uavs = 1)
{
    constexpr double kSpacing_m = 4000;
    FieldSpec field{.icebergs = icebergs, .speedMax_mps = 0.2};
    field.size_m *= kSpacing_m * std::sqrt(icebergs / field.size_m.prod());
    Scenario scenario = test::withUavs(randomScenario(seed, field), uavs);
    scenario.duration_s = duration_s;
    scenario.planner.policy = PolicyKind::Coverage;
    for (std::size_t u = 0; u < scenario.uavs.size(); ++u)
        scenario.uavs[u].spec.altitude_m += kLayerHeight_m * static_cast<double>(u);
    return scenario;
}

Plan firstPlan(const Scenario& scenario, std::int64_t workLimit = kWork)
{
    return coverage()->plan(planRequest(Simulation(scenario)), {.workLimit = workLimit});
}

double flown_m2s(Scenario scenario, PolicyKind policy)
{
    scenario.planner.policy = policy;
    Mission mission(scenario, {.record = false});
    mission.advance(scenario.duration_s);
    return mission.metrics().zeta_m2s;
}

bool hasLaterVisits(const Plan& answer)
{
    return std::ranges::any_of(answer.uavs,
                               [](const UavPlan& uav) { return !uav.laterVisits.empty(); });
}

} // namespace

class TestCoveragePatrol : public QObject
{
    Q_OBJECT

private slots:
    void shortRunsAndDenseFieldsHaveNone()
    {
        QVERIFY(!hasLaterVisits(firstPlan(sparseField(1, 12, 1000))));
        Scenario dense = randomScenario(1);
        dense.duration_s = 4000;
        QVERIFY(!hasLaterVisits(firstPlan(dense)));
        Scenario fading = sparseField(1, 12, 7200);
        test::letVelocitiesChange(fading);
        QVERIFY(!hasLaterVisits(firstPlan(fading)));
    }

    /** A patrol sees every iceberg, comes back to most, and its times fit those of the legs. */
    void laterVisitsOfAPatrol()
    {
        for (const int uavs : {1, 3}) {
            const Scenario scenario = sparseField(2, 20, 4 * 3600, uavs);
            const Plan answer = firstPlan(scenario);
            std::map<IcebergIndex, int> visits;
            for (const UavPlan& uav : answer.uavs) {
                QVERIFY(!uav.legs.empty());
                QVERIFY(!uav.laterVisits.empty());
                QCOMPARE(uav.outlook->sightings_s.size(), uav.order.size());
                QVERIFY(std::ranges::is_sorted(uav.outlook->sightings_s));
                for (const IcebergIndex id : uav.order)
                    ++visits[id];
                double before_s = uav.legs.back().sighting_s;
                for (const PlannedVisit& visit : uav.laterVisits) {
                    QVERIFY(visit.time_s >= before_s);
                    QVERIFY(visit.time_s < uav.outlook->until_s);
                    QVERIFY(visit.iceberg >= 0 && visit.iceberg < 20);
                    before_s = visit.time_s;
                    ++visits[visit.iceberg];
                }
            }
            QCOMPARE(visits.size(), 20U);
            QVERIFY(std::ranges::count_if(visits,
                                          [](const auto& entry) { return entry.second > 1; }) > 15);
            QVERIFY(static_cast<double>(answer.outcome.work) <= 1.05 * static_cast<double>(kWork));
        }
    }

    /** Plan and flight agree, so that legs and patrol are one prediction. */
    void predictsTheRun()
    {
        for (const int uavs : {1, 2}) {
            Scenario scenario = sparseField(3, 10, 4000, uavs);
            scenario.noise = false;
            const Plan answer = firstPlan(scenario, 30'000'000);
            QCOMPARE(answer.uavs.front().outlook->until_s, 4000.0);
            const double zeta_m2s = flown_m2s(scenario, PolicyKind::Coverage);
            const double off = *answer.predictedZeta_m2s / zeta_m2s - 1;
            QVERIFY2(std::abs(off) < 0.06, qPrintable(QString::number(off)));
        }
    }

    void isBetterThanLatency()
    {
        double own_m2s = 0;
        double latency_m2s = 0;
        for (const int seed : {4, 5, 6}) {
            const Scenario scenario = sparseField(seed, 12, 2 * 3600);
            own_m2s += flown_m2s(scenario, PolicyKind::Coverage);
            latency_m2s += flown_m2s(scenario, PolicyKind::Latency);
        }
        QVERIFY2(own_m2s < latency_m2s, qPrintable(QString::number(own_m2s / latency_m2s)));
    }

    /** Each UAV always flies somewhere, to an iceberg of its own, until patrols end. */
    void noUavIsIdle()
    {
        for (const int uavs : {2, 3}) {
            const Scenario scenario = sparseField(7, 8 * uavs, 6000, uavs);
            Mission mission(scenario, {.workLimit = 200'000, .record = false});
            mission.advance(scenario.duration_s);
            double time_s = -1;
            std::set<IcebergIndex> targets;
            for (const test::FlownPlan& plan : test::flownPlans(mission)) {
                if (plan.time_s > time_s)
                    targets.clear();
                time_s = plan.time_s;
                QVERIFY2(plan.target(), qPrintable(QString::number(time_s)));
                QVERIFY(targets.insert(*plan.target()).second);
            }
            QVERIFY(!test::flownPlans(mission).front().laterVisits.empty());
            QVERIFY(
                test::flownPlans(mission).back().laterVisits.empty()); // less than 1000 s are left
        }
    }

    void isTheSameInEveryThread()
    {
        const Scenario scenario = sparseField(8, 15, 2 * 3600, 2);
        const double alone_m2s = flown_m2s(scenario, PolicyKind::Coverage);
        std::vector<double> together_m2s(3);
        {
            std::vector<std::jthread> threads;
            for (double& zeta_m2s : together_m2s)
                threads.emplace_back([&] { zeta_m2s = flown_m2s(scenario, PolicyKind::Coverage); });
        }
        for (const double zeta_m2s : together_m2s)
            QCOMPARE(zeta_m2s, alone_m2s);
    }

    /** A UAV with a limited endurance comes home in time, and its patrol counts the turn-around. */
    void sortiesComeHome()
    {
        Scenario scenario = sparseField(9, 12, 4 * 3600);
        scenario.noise = false;
        Uav& uav = scenario.uavs.front();
        uav.spec.endurance_s = 1800;
        uav.turnaround_s = 700;
        Mission mission(scenario, {.record = false});
        mission.advance(scenario.duration_s);
        const auto count = [&](EventKind kind) {
            return std::ranges::count(mission.events(), kind, &MissionEvent::kind);
        };
        QVERIFY(count(EventKind::Landed) >= 2);
        QCOMPARE(count(EventKind::LateHome), 0);
        const std::vector<PlannedVisit> later = test::flownPlans(mission).front().laterVisits;
        QVERIFY(!later.empty());
        double longest_s = 0;
        for (std::size_t k = 1; k < later.size(); ++k)
            longest_s = std::max(longest_s, later[k].time_s - later[k - 1].time_s);
        QVERIFY2(longest_s > uav.turnaround_s, qPrintable(QString::number(longest_s)));
    }

    /**
     * The UAV flies straight to measured icebergs, and by `latency` while velocities are unknown.
     */
    void measuredIcebergs()
    {
        Scenario scenario = sparseField(12, 12, 2 * 3600);
        scenario.observer.model = ObserverModel::Kalman;
        const Plan known = firstPlan(scenario);
        QVERIFY(known.uavs.front().legs.empty());
        QVERIFY(!known.uavs.front().outlook);
        QCOMPARE(known.uavs.front().order.size(), 12U);
        QVERIFY(known.uavs.front().laterVisits.size() > 12U);
        for (Iceberg& iceberg : scenario.icebergs)
            iceberg.velocitySd_mps = 0.1;
        const Plan unknown = firstPlan(scenario);
        QVERIFY(!hasLaterVisits(unknown));
        const std::unique_ptr<TvpSolver> solver = makeSolver(Backend::Auto);
        const PlanRequest request = planRequest(Simulation(scenario));
        QVERIFY(unknown.uavs.front().order == makePolicy({.policy = PolicyKind::Latency}, *solver)
                                                  ->plan(request, {.workLimit = kWork})
                                                  .uavs.front()
                                                  .order);
    }

    void limitsStillGiveAPlan()
    {
        const PlanRequest request = planRequest(Simulation(sparseField(10, 12, 7200)));
        const Plan hasty = coverage()->plan(request, {.timeLimit_s = 0});
        QVERIFY(hasty.outcome.reason == StopReason::TimeLimit);
        QVERIFY(!hasty.uavs.front().legs.empty());
        QVERIFY(!coverage()->plan(request, {.workLimit = 1}).uavs.front().legs.empty());
        std::stop_source source;
        source.request_stop();
        QVERIFY(coverage()->plan(request, {.stop = source.get_token()}).uavs.empty());
    }

    /** Icebergs may appear and disappear in flight. */
    void inputsMayChange()
    {
        const std::unique_ptr<Policy> policy = coverage();
        IcebergList rest;
        for (const int icebergs : {10, 14, 5, 1, 12}) {
            PlanRequest request = planRequest(Simulation(sparseField(11, icebergs, 7200)));
            request.uavs.front().lastRest = rest;
            const Plan answer = policy->plan(request, {.workLimit = kWork / 10});
            rest = answer.uavs.front().order;
            QCOMPARE(rest.size(), static_cast<std::size_t>(icebergs));
            for (const PlannedVisit& visit : answer.uavs.front().laterVisits)
                QVERIFY(visit.iceberg.number() < icebergs);
        }
    }
};

QTEST_APPLESS_MAIN(TestCoveragePatrol)
#include "tst_coverage_patrol.moc"
