#include "core/base/angles.h"
#include "core/geometry/enclosing_circle.h"
#include "core/mission/mission.h"
#include "core/mission/plan_requests.h"
#include "core/plan/policy/planner.h"
#include "core/sim/clusters.h"
#include "tests/support/approx.h"
#include "tests/support/flight/cluster_scenes.h"
#include "tests/support/plan/test_solvers.h"

#include <QTest>

#include <algorithm>
#include <numeric>
#include <set>

using namespace berg;
using namespace berg::test;

namespace {

/** A UAV at the origin that flies east and sees 300 m. */
ClusterRules rules()
{
    return {.time_s = 100, .cover_m = 300};
}

Groups clustersFor(const std::vector<Track>& tracks, const ClusterRules& rules)
{
    return clustersOf(tracks, std::span(&rules, 1));
}

Track trackAt(const Point& place_m, const Point& velocity_mps = Point::Zero(), double sigma_m2 = 4)
{
    return {.anchor_m = place_m,
            .anchor_s = 100,
            .velocity_mps = velocity_mps,
            .sigma_m2 = sigma_m2,
            .q_m2ps = 0.025};
}

std::vector<Track> randomTracks(Random& random, int count)
{
    std::vector<Track> tracks;
    for (int i = 0; i < count; ++i)
        tracks.push_back(trackAt({random.uniform(-2000, 2000), random.uniform(-2000, 2000)},
                                 {random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)},
                                 random.uniform(0, 100)));
    return tracks;
}

Circle circleAt(const std::vector<Track>& tracks, std::span<const int> members, double time_s)
{
    std::vector<Point> places_m;
    for (const int member : members)
        places_m.push_back(tracks[static_cast<std::size_t>(member)].estimate_m(time_s));
    return enclosingCircle(places_m);
}

} // namespace

/** Formation of clusters and their use in plans. */
class TestClusters : public QObject
{
    Q_OBJECT

private slots:
    void surelySeenDistanceOfEachShape()
    {
        QCOMPARE(surelySeen_m({.fov_m = {600, 400}, .shape = FovShape::Body}), 200.0);
        QCOMPARE(surelySeen_m({.fov_m = {300, 400}, .shape = FovShape::North}), 150.0);
        QCOMPARE(surelySeen_m({.fov_m = {600, 400}, .shape = FovShape::Disk}), 300.0);
    }

    void whatOneViewCovers_data()
    {
        QTest::addColumn<double>("apart_m");
        QTest::addColumn<double>("drift_mps"); // away from each other
        QTest::addColumn<double>("sigma_m2");
        QTest::addColumn<bool>("together");
        // 600 m less twice 10 m for the flying and twice 2 sqrt(4 + growth) m; 2400 m away, which
        // with a full turn takes 146 s: growth 3.6 m2.
        QTest::newRow("just") << 567.0 << 0.0 << 4.0 << true;
        QTest::newRow("not quite") << 571.0 << 0.0 << 4.0 << false;
        QTest::newRow("known well") << 571.0 << 0.0 << 0.0 << true;
        QTest::newRow("known badly") << 400.0 << 0.0 << 2500.0 << false;
        QTest::newRow("known badly, but near") << 300.0 << 0.0 << 2500.0 << true;
        QTest::newRow("parting") << 500.0 << 1.0 << 4.0 << false;
        QTest::newRow("meeting") << 700.0 << -1.0 << 4.0 << false;
        QTest::newRow("meeting, covered already") << 550.0 << -1.0 << 4.0 << true;
    }

    void whatOneViewCovers()
    {
        QFETCH(double, apart_m);
        QFETCH(double, drift_mps);
        QFETCH(double, sigma_m2);
        QFETCH(bool, together);
        const std::vector<Track> tracks{
            trackAt({2400, apart_m / 2}, {0, drift_mps / 2}, sigma_m2),
            trackAt({2400, -apart_m / 2}, {0, -drift_mps / 2}, sigma_m2)};
        QCOMPARE(clustersFor(tracks, rules()), (together ? Groups{{0, 1}} : Groups{}));
    }

    /** Tight groups form before wide ones: 1 could join 0 or 2. */
    void theNearestFindEachOther()
    {
        const std::vector<Track> tracks{trackAt({2000, 0}), trackAt({2000, 500}),
                                        trackAt({2000, 900})};
        QCOMPARE(clustersFor(tracks, rules()), (Groups{{1, 2}}));
    }

    void noClusterInsideTheTurningCircle()
    {
        // The tightest turn has 106 m; the UAV cannot be at its centre at once.
        const std::vector<Track> beside{trackAt({0, 10}), trackAt({0, 240})};
        QVERIFY(clustersFor(beside, rules()).empty());
        const std::vector<Track> ahead{trackAt({400, 10}), trackAt({400, 240})};
        QCOMPARE(clustersFor(ahead, rules()), (Groups{{0, 1}}));
    }

    void noClusterTooCloseToTheFence()
    {
        const std::vector<Track> tracks{trackAt({1000, 100}), trackAt({1000, 300})};
        ClusterRules fenced = rules();
        const auto fence = [&](double north_m) {
            return std::make_shared<const Geofence>(
                std::vector<Point>{{-500, -500}, {2000, -500}, {2000, north_m}, {-500, north_m}},
                fenced.motion);
        };
        fenced.fence = fence(290); // the middle, at 200 m, is nearer than a circle
        QVERIFY(clustersFor(tracks, fenced).empty());
        fenced.fence = fence(600);
        QCOMPARE(clustersFor(tracks, fenced), (Groups{{0, 1}}));
    }

    /** A cluster suits every UAV that may visit all members. */
    void clustersSuitEveryUavThatMayVisit()
    {
        const std::vector<Track> tracks{trackAt({2000, 0}), trackAt({2000, 450})};
        std::vector<ClusterRules> uavs{rules(), rules()};
        QCOMPARE(clustersOf(tracks, uavs), (Groups{{0, 1}}));
        uavs[1].cover_m = 200;
        QVERIFY(clustersOf(tracks, uavs).empty());
        uavs[1].visitable = {true, false};
        QCOMPARE(clustersOf(tracks, uavs), (Groups{{0, 1}}));
        uavs[0].visitable = {false, true}; // no UAV may visit both
        QVERIFY(clustersOf(tracks, uavs).empty());
    }

    void randomClustersFitOneView()
    {
        Random random(21);
        int found = 0;
        for (int round = 0; round < 200; ++round) {
            const std::vector<Track> tracks = randomTracks(random, 25);
            ClusterRules flight = rules();
            flight.uav.psi_rad = random.uniform(-kPi, kPi);
            const Groups groups = clustersFor(tracks, flight);
            QVERIFY(std::ranges::is_sorted(groups));
            std::set<int> once;
            for (const std::vector<int>& members : groups) {
                QVERIFY(members.size() >= 2 && std::ranges::is_sorted(members));
                for (const int member : members)
                    QVERIFY(once.insert(member).second);
                const Circle now = circleAt(tracks, members, flight.time_s);
                const double wait_s =
                    longestTurn_s(flight.motion) + now.centre_m.norm() / flight.motion.airspeed_mps;
                for (const double share : {0.0, 0.1, 0.5, 0.8, 1.0})
                    for (const int member : members) {
                        const Circle then =
                            circleAt(tracks, members, flight.time_s + share * wait_s);
                        const double deviation_m = std::sqrt(
                            tracks[static_cast<std::size_t>(member)].sigmaAfter_m2(share * wait_s));
                        QVERIFY(then.radius_m + 2 * deviation_m + kFlownOver_m <=
                                flight.cover_m + 1e-9);
                    }
                ++found;
            }
        }
        QVERIFY2(found > 500, QByteArray::number(found));
    }

    void theOrderOfTheTracksDoesNotMatter()
    {
        Random random(22);
        for (int round = 0; round < 50; ++round) {
            const std::vector<Track> tracks = randomTracks(random, 20);
            std::vector<int> places(tracks.size());
            std::iota(places.begin(), places.end(), 0);
            for (std::size_t i = places.size() - 1; i > 0; --i)
                std::swap(places[i], places[random.below(i + 1)]);
            std::vector<Track> shuffled;
            for (const int place : places)
                shuffled.push_back(tracks[static_cast<std::size_t>(place)]);
            Groups groups = clustersFor(shuffled, rules());
            for (std::vector<int>& members : groups) {
                for (int& member : members)
                    member = places[static_cast<std::size_t>(member)];
                std::ranges::sort(members);
            }
            std::ranges::sort(groups);
            QCOMPARE(groups, clustersFor(tracks, rules()));
        }
    }

    void withoutClustersTheRequestIsUnchanged()
    {
        Scenario scenario = pairAhead();
        scenario.clusters = false;
        const Simulation simulation(scenario);
        const PlanRequest request = clusteredRequest(simulation);
        QCOMPARE(request.ids, (IcebergList{0, 1, 2}));
        QVERIFY(request.clusters.empty());
        QVERIFY(request.uavs[0].distance_m == planRequest(simulation).uavs[0].distance_m);
    }

    void oneNodeForTheTwo()
    {
        const PlanRequest request = clusteredRequest(Simulation(pairAhead()));
        QCOMPARE(request.clusters, (Clusters{{0, 2}}));
        QCOMPARE(request.ids, (IcebergList{0, 1}));
        QCOMPARE(request.sigma_m2, (std::vector<double>{0, 7, 5}));
        COMPARE_NEAR(request.uavs[0].distance_m(0, 1), 2000, 1e-9);
        COMPARE_NEAR(request.uavs[0].distance_m(1, 2), 3000, 1e-9);
        QCOMPARE(request.uavs[0].available, (std::vector<bool>{true, true}));
    }

    /** Priorities near an asset apply to each member. */
    void sigmasAreWeighted()
    {
        Scenario scenario = pairAhead();
        scenario.asset = Asset{.position_m = {2000, 1000}};
        const Simulation simulation(scenario);
        COMPARE_NEAR(
            clusteredRequest(simulation).sigma_m2[1],
            3 * priority(simulation.observer(), 0) + 4 * priority(simulation.observer(), 2), 1e-12);
        QVERIFY(priority(simulation.observer(), 0) > 1);
    }

    /** A sortie contains a cluster as a whole or not at all. */
    void sortiesHoldWholeClusters()
    {
        const Clusters clusters{{0, 2}};
        const IcebergList order{1, 0, 2};
        std::set<int> whole;
        std::set<int> one;
        bool isLeftToSingles = false;
        for (double endurance_s = 200; endurance_s < 900; endurance_s += 2) {
            Scenario scenario = pairAhead();
            scenario.uavs[0].spec.endurance_s = endurance_s;
            scenario.uavs[0].spec.reservePercent = 0;
            const Simulation simulation(scenario);
            whole.insert(thisSortie(simulation, 0, order, clusters).value());
            one.insert(thisSortie(simulation, 0, order, {}).value());
            const PlanRequest request = clusteredRequest(simulation);
            QVERIFY(request.clusters.empty() || thisSortie(simulation, 0, clusters[0], {}) == 2);
            isLeftToSingles =
                isLeftToSingles || (request.clusters.empty() && request.uavs[0].available[0]);
        }
        QCOMPARE(whole, (std::set<int>{0, 1, 3}));
        QCOMPARE(one, (std::set<int>{0, 1, 2, 3}));
        QVERIFY(isLeftToSingles);
        QVERIFY(!thisSortie(Simulation(pairAhead()), 0, order, clusters));
    }

    void policiesThatPlanSingles()
    {
        const Simulation simulation(pairAhead());
        for (const PolicyKind policy : {PolicyKind::Path, PolicyKind::Tour, PolicyKind::Coverage})
            QVERIFY(requestFor(simulation, policy).clusters.empty());
        for (const PolicyKind policy : {PolicyKind::Visitation, PolicyKind::Latency,
                                        PolicyKind::Nearest, PolicyKind::Uncertainty})
            QCOMPARE(requestFor(simulation, policy).clusters.size(), std::size_t{1});
    }

    void forecastSeesThemTogether()
    {
        const Scenario scenario = pairAhead();
        const Mission mission(scenario);
        const Simulation& now = mission.simulation();
        const ForecastStart start{.world = now.state(),
                                  .active = {true, true, true},
                                  .time_s = 0,
                                  .airspeeds_mps = {now.motion(0).airspeed_mps}};
        const IcebergList order{0, 2, 1};
        const Clusters clusters{{0, 2}};
        const PlanForecast forecast = forecastPlan(start, {order}, 1000, clusters);
        COMPARE_NEAR(forecast.uavs[0].distance_m, 5000, 1e-9);
        QCOMPARE(forecast.uavs[0].visits.size(), std::size_t{3});
        COMPARE_NEAR(forecast.uavs[0].visits[0].leg_m, 2000, 1e-9);
        COMPARE_NEAR(forecast.uavs[0].visits[1].leg_m, 0, 0);
        COMPARE_NEAR(forecast.uavs[0].visits[1].arrival_s, 2000 / 22.0, 1e-9);
        COMPARE_NEAR(forecast.uavs[0].visits[1].arrivalSigma_m2, 4 + 0.025 * 2000 / 22, 1e-9);
        COMPARE_NEAR(forecast.uavs[0].visits[2].leg_m, 3000, 1e-9);
        QVERIFY(forecast.uavs[0].distance_m <
                forecastPlan(start, {order}, 1000).uavs[0].distance_m);

        const std::optional<PlanChange> change = planChanges(
            start, {IcebergList{0, 2, 1}}, {IcebergList{1, 0, 2}}, 1000, {.before = clusters})[0];
        QVERIFY(change);
        COMPARE_NEAR(change->distance_m,
                     forecastPlan(start, {IcebergList{1, 0, 2}}, 1000).uavs[0].distance_m - 5000,
                     1e-9);
    }

    void plannerNamesAllMembers()
    {
        const PlanRequest request = clusteredRequest(Simulation(pairAhead()));
        Planner planner({.policy = PolicyKind::Nearest});
        const Plan answer = planner.plan(request, {});
        QCOMPARE(answer.uavs[0].order, (IcebergList{0, 2, 1}));
        QCOMPARE(answer.uavs[0].clusters, (Clusters{{0, 2}}));
        QCOMPARE(answer.solvedIds, (IcebergList{0, 1}));
        // The cluster takes the place of its first member in a warm start.
        SolverScript script;
        Planner warm({.policy = PolicyKind::Visitation}, std::make_unique<ScriptedSolver>(script));
        (void)warm.plan(request, {});
        (void)warm.plan(planRequest(Simulation(pairAhead())), {});
        QCOMPARE(script.options.back().hint, (FleetPlan{{1, 3, 2}}));
    }

    /** If the planner throws, the members are still flown to. */
    void fallsBackToTheClusters()
    {
        const PlanRequest request = clusteredRequest(Simulation(pairAhead()));
        SolverScript script;
        script.answer = [&](const TvpProblem&) -> SolveOutcome {
            if (script.problems.size() > 1)
                throw std::runtime_error("out of order");
            return {.status = SolveStatus::Feasible, .plan = {{2, 1}}};
        };
        Planner planner({.policy = PolicyKind::Visitation},
                        std::make_unique<ScriptedSolver>(script));
        QCOMPARE(planner.plan(request, {}).uavs[0].order, (IcebergList{1, 0, 2}));
        const Plan answer = planner.plan(request, {});
        QVERIFY(answer.fellBack);
        QCOMPARE(answer.uavs[0].order, (IcebergList{1, 0, 2}));
        QCOMPARE(answer.uavs[0].clusters, (Clusters{{0, 2}}));
    }
};

QTEST_APPLESS_MAIN(TestClusters)
#include "tst_clusters.moc"
