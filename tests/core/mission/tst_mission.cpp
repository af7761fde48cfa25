#include "core/mission/mission.h"
#include "core/mission/mission_instant.h"
#include "core/plan/policy/policy.h"
#include "core/presets/presets.h"
#include "tests/support/flight/flown_plans.h"
#include "tests/support/flight/scenario_builder.h"

#include <QtTest>

#include <algorithm>
#include <set>

using namespace berg;

namespace {

/** Answers as `inner` for the first `good` solves, then never again. */
class FailingSolver final : public TvpSolver
{
public:
    explicit FailingSolver(int good) : m_good(good) {}
    [[nodiscard]] AnswerSource source() const override { return AnswerSource::Exact; }
    [[nodiscard]] std::optional<IssueReason> unsupportedReason(const TvpProblem&) const override
    {
        return std::nullopt;
    }

protected:
    [[nodiscard]] SolveOutcome doSolve(const TvpProblem& problem,
                                       const SolveOptions& options) const override
    {
        if (m_solves++ < m_good)
            return makeSolver(Backend::Exact)->solve(problem, options);
        return {.reason = StopReason::TimeLimit};
    }

private:
    int m_good;
    mutable int m_solves = 0;
};

/** Records whether each solve is one in flight. */
class NotingSolver final : public TvpSolver
{
public:
    explicit NotingSolver(std::vector<bool>& inFlight) : m_inFlight(inFlight) {}
    [[nodiscard]] AnswerSource source() const override { return AnswerSource::Exact; }
    [[nodiscard]] std::optional<IssueReason> unsupportedReason(const TvpProblem&) const override
    {
        return std::nullopt;
    }

protected:
    [[nodiscard]] SolveOutcome doSolve(const TvpProblem& problem,
                                       const SolveOptions& options) const override
    {
        m_inFlight.push_back(options.inFlight);
        return makeSolver(Backend::Exact)->solve(problem, options);
    }

private:
    std::vector<bool>& m_inFlight;
};

void flyToEnd(Mission& mission)
{
    QCOMPARE(mission.advance(mission.scenario().duration_s), AdvanceStatus::Finished);
}

void compareMissions(const Mission& a, const Mission& b)
{
    QVERIFY(a.simulation().state() == b.simulation().state());
    QVERIFY(a.metrics() == b.metrics());
    QVERIFY(std::ranges::equal(a.recorder().keyframes(), b.recorder().keyframes(), {},
                               &Simulation::state, &Simulation::state));
    QCOMPARE(a.plans().size(), b.plans().size());
    for (std::size_t i = 0; i < a.plans().size(); ++i) {
        QCOMPARE(a.plans()[i]->time_s, b.plans()[i]->time_s);
        QCOMPARE(a.plans()[i]->uavs[0].order, b.plans()[i]->uavs[0].order);
        QCOMPARE(a.plans()[i]->outcome.objective, b.plans()[i]->outcome.objective);
    }
}

} // namespace

class TestMission : public QObject
{
    Q_OBJECT

private slots:
    void sameScenarioSameResult()
    {
        Mission a(randomScenario(11));
        Mission b(randomScenario(11));
        flyToEnd(a);
        flyToEnd(b);
        compareMissions(a, b);
        QVERIFY(a.metrics().zeta_m2s > 0);
        QVERIFY(a.metrics().visits > 5);
    }

    void slicesDoNotMatter()
    {
        Mission whole(randomScenario(12));
        flyToEnd(whole);
        Mission sliced(randomScenario(12));
        Random random(1);
        double until_s = 0;
        while (sliced.advance(until_s) != AdvanceStatus::Finished)
            until_s += random.uniform(0, 20);
        compareMissions(whole, sliced);
    }

    void recordingDoesNotMatter()
    {
        Mission recorded(randomScenario(13));
        flyToEnd(recorded);
        Mission bare(randomScenario(13), {.record = false});
        flyToEnd(bare);
        QVERIFY(recorded.simulation().state() == bare.simulation().state());
        QVERIFY(bare.recorder().samples().empty());
        QVERIFY(bare.events().empty());
    }

    void cancelledAndCarriedOn()
    {
        Mission whole(randomScenario(14));
        flyToEnd(whole);
        Mission interrupted(randomScenario(14));
        std::stop_source stop;
        const auto status = interrupted.advance(1000, stop.get_token(), [&](double time_s) {
            if (time_s > 250)
                stop.request_stop();
        });
        QCOMPARE(status, AdvanceStatus::Cancelled);
        QVERIFY(interrupted.simulation().time_s() < 260);
        flyToEnd(interrupted);
        compareMissions(whole, interrupted);
    }

    void plansHoldNoIcebergInView()
    {
        Mission mission(randomScenario(15));
        double until_s = 0;
        std::size_t checked = 0;
        while (mission.advance(until_s) != AdvanceStatus::Finished) {
            until_s += 0.1;
            for (; checked < mission.plans().size(); ++checked)
                for (const IcebergIndex iceberg : mission.plans()[checked]->uavs[0].order)
                    QVERIFY(!mission.simulation().track(iceberg).inView);
        }
        QVERIFY(checked > 10);
    }

    /** If a solver fails, the rest of the previous plan is flown and the log reports it. */
    void fallsBackToTheLastPlan()
    {
        Mission mission(randomScenario(16), {}, std::make_unique<FailingSolver>(1));
        flyToEnd(mission);
        const auto plans = test::flownPlans(mission);
        QVERIFY(plans.size() > 8);
        QVERIFY(!plans[0].fellBack);
        const IcebergList& first = plans[0].order;
        for (std::size_t i = 1; i < 5; ++i) {
            QVERIFY(plans[i].fellBack);
            QCOMPARE(plans[i].plan->outcome.status, SolveStatus::None);
            QCOMPARE(plans[i].plan->outcome.reason, StopReason::TimeLimit);
            QVERIFY(plans[i].target());
            // The rest of the first plan, in its order.
            auto place = first.begin();
            for (const IcebergIndex iceberg : plans[i].order) {
                place = std::find(place, first.end(), iceberg);
                QVERIFY(place != first.end());
            }
        }
    }

    /** Later solves get a small part of the work, except the first with new settings. */
    void onlyTheFirstPlanIsNotInFlight()
    {
        std::vector<bool> inFlight;
        Mission mission(randomScenario(16), {}, std::make_unique<NotingSolver>(inFlight));
        mission.advance(500);
        QVERIFY(inFlight.size() > 3);
        QCOMPARE(std::ranges::count(inFlight, false), 1);
        QVERIFY(!inFlight.front());
        const std::size_t before = inFlight.size();
        mission.intervene({.tau = 0.25});
        flyToEnd(mission);
        QVERIFY(inFlight.size() > before + 2);
        QCOMPARE(std::ranges::count(inFlight, false), 2);
        QVERIFY(!inFlight[before]);
    }

    /** Without any plan the autopilot still has a target. */
    void fliesWithoutAnyPlan()
    {
        Mission mission(randomScenario(16), {}, std::make_unique<FailingSolver>(0));
        flyToEnd(mission);
        QVERIFY(mission.metrics().visits > 3);
        for (const test::FlownPlan& plan : test::flownPlans(mission))
            QVERIFY(plan.fellBack || !plan.target());
    }

    void everyPolicyFlies_data()
    {
        QTest::addColumn<int>("kind");
        for (const auto& row : kPolicyNames)
            QTest::addRow("%s", std::string(row.name).c_str()) << static_cast<int>(row.value);
    }
    void everyPolicyFlies()
    {
        QFETCH(int, kind);
        Scenario scenario = randomScenario(17);
        scenario.planner.policy = static_cast<PolicyKind>(kind);
        Mission mission(scenario);
        flyToEnd(mission);
        QVERIFY(mission.metrics().visits >= 5);
        std::set<std::optional<IcebergIndex>> targets;
        for (const test::FlownPlan& plan : test::flownPlans(mission))
            targets.insert(plan.target());
        // `nearest` may get stuck between a few icebergs; every other policy visits all of them.
        QVERIFY(targets.size() >= (scenario.planner.policy == PolicyKind::Nearest ? 2U : 5U));
    }

    void fixedRoutesKeepTheirSequence()
    {
        Scenario scenario = randomScenario(18);
        scenario.duration_s = 3000;
        scenario.planner.policy = PolicyKind::Tour;
        Mission mission(scenario);
        flyToEnd(mission);
        // After two laps the successor of an iceberg in the cycle never changes, except for
        // icebergs in view, which are skipped.
        const std::vector<test::FlownPlan> plans = test::flownPlans(mission);
        const IcebergList& cycle = plans[0].order;
        int backward = 0;
        for (std::size_t i = 1; i < plans.size(); ++i) {
            const auto placeOf = [&](std::optional<IcebergIndex> iceberg) {
                return std::find(cycle.begin(), cycle.end(), iceberg) - cycle.begin();
            };
            const auto from = placeOf(plans[i - 1].target());
            const auto to = placeOf(plans[i].target());
            backward += to <= from ? 1 : 0;
        }
        // The order ascends except for one step back per lap, and a lap visits most of the 12
        // icebergs.
        const auto visits = static_cast<int>(plans.size());
        QVERIFY2(backward >= 2 && 8 * backward <= visits,
                 qPrintable(QString("%1 of %2").arg(backward).arg(visits)));
    }

    void interventionsChangeTheFlight()
    {
        Mission plain(randomScenario(19));
        flyToEnd(plain);
        Mission steered(randomScenario(19));
        steered.advance(200);
        steered.intervene({.tau = 0.0});
        steered.advance(400);
        Iceberg added;
        added.id = "added";
        added.position_m = {2500, 6000};
        steered.intervene({.appears = added});
        flyToEnd(steered);

        QCOMPARE(steered.interventions().size(), 2U);
        QCOMPARE(steered.interventions()[0].time_s, 200.0);
        QCOMPARE(steered.interventions()[1].time_s, 400.0);
        QCOMPARE(steered.icebergs().size(), 13U);
        QVERIFY(steered.metrics().zeta_m2s != plain.metrics().zeta_m2s);
        int replanned = 0;
        // With tau = 0 the immediate plan goes to the most uncertain iceberg first.
        for (const test::FlownPlan& plan : test::flownPlans(steered))
            if (plan.time_s == 200.0 && plan.reason == PlanReason::Intervention) {
                ++replanned;
                QCOMPARE(plan.plan->problem.mu, 0.0);
            }
        QCOMPARE(replanned, 1);
    }

    /** A reported iceberg counts as in view now, and the new plan need not visit it. */
    void reportedSightingIsBelieved()
    {
        const Scenario scenario = randomScenario(3, {.icebergs = 6});
        Mission mission(scenario);
        mission.advance(50);
        const IcebergIndex target = test::flownPlans(mission).back().target().value();
        const std::size_t plans = mission.plans().size();
        const std::string id = scenario.icebergs[toIndex(target)].id;
        QVERIFY(mission.simulation().track(target).sigma_m2 > 0);
        mission.intervene({.seen = id});
        QCOMPARE(mission.simulation().track(target).sigma_m2, 0.0);
        QVERIFY(!mission.simulation().track(target).inView);
        QVERIFY(mission.simulation().observer().estimate_m(target) ==
                mission.simulation().truth_m(target));
        QVERIFY(mission.events().back().kind == EventKind::Sighted);
        QVERIFY(mission.events().back().reported);
        mission.advance(50.1);
        QCOMPARE(mission.plans().size(), plans + 1);
        QVERIFY(test::flownPlans(mission).back().target() != target); // it is no longer a target
    }

    void unknownSightingIsRefused()
    {
        Scenario scenario = randomScenario(3, {.icebergs = 6});
        scenario.icebergs[2].appears_s = 500;
        Mission mission(scenario);
        mission.advance(50);
        for (const std::string& id :
             {std::string("nobody"), std::string(), scenario.icebergs[2].id})
            QVERIFY_THROWS_EXCEPTION(Error, mission.intervene({.seen = id}));
        QVERIFY(mission.interventions().empty());
    }

    /** An intervention while a plan is due leaves the same record as in a replay. */
    void interventionsBeforeAPlanRepeat()
    {
        const auto intervene = [](Mission& mission) {
            mission.intervene({.tau = 0.2});
            mission.intervene({.tau = 3.0});
        };
        Mission live(randomScenario(23));
        intervene(live); // no plan yet
        flyToEnd(live);
        Mission replayed(randomScenario(23));
        replayed.advance(0);
        intervene(replayed);
        flyToEnd(replayed);
        compareMissions(live, replayed);
        QCOMPARE(test::flownPlans(live)[0].reason, PlanReason::Start);
        QCOMPARE(test::flownPlans(live)[2].reason, PlanReason::Intervention);
    }

    /** A removed iceberg no longer counts, and the area does not restore it. */
    void removedIcebergIsLeftAlone()
    {
        Scenario scenario = randomScenario(19);
        scenario.area_m = {{-9000, -9000}, {9000, -9000}, {9000, 9000}, {-9000, 9000}};
        Mission mission(scenario);
        mission.advance(100);
        const IcebergIndex target = test::flownPlans(mission).back().target().value();
        const std::string id = mission.icebergs()[toIndex(target)].id;
        const double before_m2 = mission.simulation().observer().sigmaSum_m2();
        mission.intervene({.removed = id});
        mission.advance(100.1);
        QVERIFY(mission.simulation().observer().sigmaSum_m2() < before_m2);
        flyToEnd(mission);
        QVERIFY(!mission.simulation().active(target));
        for (const test::FlownPlan& plan : test::flownPlans(mission))
            if (plan.time_s > 100)
                QVERIFY(std::ranges::find(plan.order, target) == plan.order.end());
        const auto removals = std::ranges::count_if(mission.events(), [&](const MissionEvent& e) {
            return e.kind == EventKind::Intervention && e.changed == ChangedPart::Removal &&
                   e.iceberg == target;
        });
        QCOMPARE(removals, 1);

        QVERIFY(instantAt(mission, 99).simulation.active(target));
        QVERIFY(!instantAt(mission, 500).simulation.active(target));
        QVERIFY_THROWS_EXCEPTION(Error, mission.intervene({.removed = "nobody"}));
    }

    /** A removed iceberg is not searched for, whether it was lost or is missed at its estimate. */
    void removedIcebergIsNotSearchedFor()
    {
        Scenario scenario = randomScenario(19);
        scenario.observer = {.model = ObserverModel::Kalman, .detection = 0.5};
        for (Iceberg& iceberg : scenario.icebergs)
            iceberg.velocitySd_mps = 0.5;
        scenario.duration_s = 3000;
        Mission mission(scenario);
        const auto lost = [&] {
            const auto& events = mission.events();
            return std::ranges::find(events, EventKind::Lost, &MissionEvent::kind);
        };
        while (lost() == mission.events().end() && !mission.simulation().finished())
            mission.advance(mission.simulation().time_s() + 5);
        QVERIFY(lost() != mission.events().end());
        const IcebergIndex iceberg = lost()->iceberg.value();
        const double removed_s = mission.simulation().time_s();
        mission.intervene({.removed = mission.icebergs()[toIndex(iceberg)].id});
        QCOMPARE(mission.interventions().size(), std::size_t{1});
        mission.advance(removed_s + 0.2);
        flyToEnd(mission);
        for (const MissionEvent& event : mission.events())
            if (event.time_s > removed_s)
                QVERIFY(event.iceberg != iceberg);
    }

    void badInterventionsAreRefused()
    {
        Mission mission(randomScenario(20));
        mission.advance(100);
        const WorldState before = mission.simulation().state();
        Iceberg twin;
        twin.id = "berg-1"; // taken
        Scenario later = randomScenario(20);
        later.icebergs[0].appears_s = 500;
        Mission early(later);
        early.advance(100);
        QVERIFY_THROWS_EXCEPTION(Error, early.intervene({.removed = later.icebergs[0].id}));
        QVERIFY_THROWS_EXCEPTION(Error, mission.intervene({.appears = twin}));
        QVERIFY_THROWS_EXCEPTION(Error, mission.intervene({.tau = -1.0}));
        QVERIFY(mission.simulation().state() == before);
        QVERIFY(mission.interventions().empty());
    }

    void refusesBrokenScenarios()
    {
        Scenario scenario = randomScenario(1);
        scenario.icebergs[2].q_m2ps = -1;
        try {
            Mission mission(scenario);
            QFAIL("a negative q was accepted");
        } catch (const Error& error) {
            QCOMPARE(error.code(), ErrorCode::InvalidInput);
            QVERIFY(QString::fromUtf8(error.what()).contains("icebergs[2].q_m2ps"));
        }
    }

    void samplesAndEventsAgreeWithTheFlight()
    {
        Mission mission(randomScenario(21));
        flyToEnd(mission);
        const auto& samples = mission.recorder().samples();
        QCOMPARE(samples.size(), 1001U);
        QCOMPARE(samples.front().time_s, 0.0);
        QCOMPARE(samples.back().zeta_m2s, mission.metrics().zeta_m2s);
        int reached = 0;
        for (const MissionEvent& event : mission.events())
            reached += event.kind == EventKind::Reached ? 1 : 0;
        QCOMPARE(reached, mission.metrics().visits);
        for (std::size_t row = 0; row < samples.size(); ++row) {
            double sum_m2 = 0;
            for (const IcebergSample& iceberg : mission.recorder().icebergs(row))
                sum_m2 += iceberg.sigma_m2;
            QVERIFY(std::abs(sum_m2 - samples[row].sigmaSum_m2) < 1e-9 * (1 + sum_m2));
        }
    }

    void missionWithoutIcebergsHoldsItsPlace()
    {
        Mission mission(test::emptySea(60));
        flyToEnd(mission);
        QCOMPARE(mission.metrics().zeta_m2s, 0.0);
        QCOMPARE(mission.metrics().visits, 0);
        QVERIFY(mission.simulation().uav(0).pose.position_m.norm() < 300); // holds where it is
    }

    void startPlanIsTheFirstPlanFlown()
    {
        const Scenario scenario = randomScenario(22);
        Mission mission(scenario);
        mission.advance(0);
        QCOMPARE(planFromStart(scenario).uavs[0].order, test::flownPlans(mission).at(0).order);
    }

    /** The listener gets the first aimed plan while it is being made, with its legs. */
    void incumbentsHaveLegs()
    {
        Scenario scenario = randomScenario(5);
        scenario.planner.policy = PolicyKind::Coverage;
        Mission mission(scenario, {.workLimit = 100'000});
        std::vector<PlanPointer> reported;
        mission.setIncumbentListener(
            [&](PlanPointer plan) { reported.push_back(std::move(plan)); });
        mission.advance(0);
        QVERIFY(!reported.empty());
        QVERIFY(!reported.front()->uavs[0].legs.empty());
        const test::FlownPlan plan = test::flownPlans(mission).front();
        QVERIFY(plan.outlook.has_value());
        QCOMPARE(plan.plan->distance_m, 22 * plan.outlook->sightings_s.back());
        const std::size_t first = reported.size();
        mission.advance(200);
        QVERIFY(mission.plans().size() > 2);
        QCOMPARE(reported.size(), first); // later ones take a moment only
        QVERIFY(mission.plans().back()->zeta_m2s > 0);
    }

    /** Studies draw the noise once for all settings and store only the figures. */
    void noiseDrawnOnceServesManyMissions()
    {
        Scenario scenario = randomScenario(23);
        const std::vector<DriftNoise> noise = drawNoise(scenario);
        for (const double tau : {0.5, 1.0, 2.0}) {
            scenario.planner.tau = tau;
            Mission alone(scenario);
            Mission sharing(scenario, {.record = false}, nullptr, noise);
            flyToEnd(alone);
            flyToEnd(sharing);
            QVERIFY(alone.metrics() == sharing.metrics());
            QVERIFY(alone.simulation().state() == sharing.simulation().state());
        }
    }
};

QTEST_APPLESS_MAIN(TestMission)
#include "tst_mission.moc"
