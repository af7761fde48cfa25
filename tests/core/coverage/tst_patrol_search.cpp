#include "core/coverage/patrol_search.h"
#include "core/coverage/patrol_tails.h"
#include "core/coverage/patrol_tours.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

using namespace berg;

namespace {

constexpr double kSpeed_mps = 20;

/**
 * Makes a problem of icebergs that stand still and are seen only from above, by UAVs that turn on
 * the spot.
 */
PatrolProblem pointProblem(std::uint64_t seed, int icebergs, int uavs, double length_s)
{
    Random random(seed, 1);
    PatrolProblem problem{.length_s = length_s};
    for (int i = 0; i < icebergs; ++i) {
        const Point place_m{random.uniform(0, 6000), random.uniform(0, 6000)};
        const double q_m2ps = random.uniform(0.01, 0.1);
        PatrolIceberg iceberg{.place = {.place_m = place_m}, .growth = {}};
        iceberg.growth.fill({.rate_m2ps = q_m2ps});
        iceberg.growth[0].base_m2 = random.uniform(0, 20);
        problem.icebergs.push_back(iceberg);
    }
    for (int u = 0; u < uavs; ++u)
        problem.uavs.push_back({.start = {.position_m = {random.uniform(0, 6000), 0}},
                                .speed_mps = kSpeed_mps,
                                .radius_m = 0,
                                .reach_m = 0});
    return problem;
}

PatrolRoutes randomRoutes(const PatrolProblem& problem, int visits, Random& random)
{
    PatrolRoutes routes(problem.uavs.size());
    for (std::vector<int>& route : routes)
        while (static_cast<int>(route.size()) < visits) {
            const int i = static_cast<int>(random.below(problem.icebergs.size()));
            if (route.empty() || route.back() != i)
                route.push_back(i);
        }
    return routes;
}

/** Returns the cost of routes by a sum over all gaps of all icebergs, along straight lines. */
double costByHand(const PatrolProblem& problem, const PatrolRoutes& routes)
{
    std::vector<std::vector<double>> times_s(problem.icebergs.size());
    for (std::size_t u = 0; u < routes.size(); ++u) {
        Point from_m = problem.uavs[u].start.position_m;
        double time_s = 0;
        for (const int i : routes[u]) {
            const Point to_m = problem.icebergs[static_cast<std::size_t>(i)].place.place_m;
            time_s += (to_m - from_m).norm() / kSpeed_mps;
            from_m = to_m;
            if (time_s < problem.length_s)
                times_s[static_cast<std::size_t>(i)].push_back(time_s);
        }
    }
    double cost_m2s = 0;
    for (std::size_t i = 0; i < times_s.size(); ++i) {
        const auto& growth = problem.icebergs[i].growth;
        std::vector<double>& times = times_s[i];
        std::ranges::sort(times);
        times.push_back(problem.length_s);
        cost_m2s += growth[0].base_m2 * times.front();
        double last_s = 0;
        for (const double time_s : times) {
            cost_m2s += growth[1].rate_m2ps * (time_s - last_s) * (time_s - last_s) / 2;
            last_s = time_s;
        }
    }
    return cost_m2s;
}

/** Returns the least cost over all sequences of visits of one UAV. */
double leastByBruteForce(const PatrolProblem& problem)
{
    double least_m2s = costByHand(problem, {{}});
    std::vector<int> route;
    const std::function<void(Point, double)> extend = [&](Point from_m, double time_s) {
        for (int i = 0; i < static_cast<int>(problem.icebergs.size()); ++i) {
            if (!route.empty() && route.back() == i)
                continue;
            const Point to_m = problem.icebergs[static_cast<std::size_t>(i)].place.place_m;
            const double at_s = time_s + (to_m - from_m).norm() / kSpeed_mps;
            if (at_s >= problem.length_s)
                continue;
            route.push_back(i);
            least_m2s = std::min(least_m2s, costByHand(problem, {route}));
            extend(to_m, at_s);
            route.pop_back();
        }
    };
    extend(problem.uavs.front().start.position_m, 0);
    return least_m2s;
}

double tourLength_m(const std::vector<int>& tour, const std::vector<Point>& places_m)
{
    double sum_m = 0;
    for (std::size_t k = 0; k < tour.size(); ++k)
        sum_m += (places_m[static_cast<std::size_t>(tour[k])] -
                  places_m[static_cast<std::size_t>(tour[(k + 1) % tour.size()])])
                     .norm();
    return sum_m;
}

PatrolSearch::Change randomChange(const PatrolSearch& search, Random& random)
{
    PatrolSearch::Change change{.uav = random.below(search.problem().uavs.size())};
    const auto count = search.visits(change.uav).size();
    change.begin = static_cast<int>(random.below(count + 1));
    change.end =
        std::min(static_cast<int>(count), change.begin + static_cast<int>(random.below(5)));
    while (random.below(3) != 0)
        change.visits.push_back(static_cast<int>(random.below(search.problem().icebergs.size())));
    return change;
}

/** Returns, for each iceberg, the UAVs that visit it, in order. */
std::vector<std::vector<std::size_t>> turnsOf(const PatrolSearch& search)
{
    std::vector<std::vector<std::pair<double, std::size_t>>> seen(search.problem().icebergs.size());
    for (std::size_t u = 0; u < search.problem().uavs.size(); ++u)
        for (std::size_t k = 0; k < search.visits(u).size(); ++k)
            seen[static_cast<std::size_t>(search.visits(u)[k])].emplace_back(
                search.stops(u)[k].time_s, u);
    std::vector<std::vector<std::size_t>> turns;
    for (auto& visits : seen) {
        std::ranges::sort(visits);
        turns.emplace_back();
        for (const auto& [time_s, uav] : visits)
            turns.back().push_back(uav);
    }
    return turns;
}

const SolveOptions kNoLimits;

} // namespace

class TestPatrolSearch : public QObject
{
    Q_OBJECT

private slots:
    void legsAreFlownToTheEdgeOfTheView()
    {
        const PatrolUav uav{.start = {}, .speed_mps = 20, .radius_m = 100, .reach_m = 300};
        const DriftingPlace ahead{.place_m = {2300, 0}};
        const PatrolStop straight = patrolLeg(uav, patrolStart(uav), ahead, nullptr);
        QCOMPARE(straight.place_m, Point(2000, 0));
        QCOMPARE(straight.time_s, 100.0);
        // With a next visit the iceberg is seen from the nearest point of the disk to that path.
        const DriftingPlace beyond{.place_m = {4000, 1000}};
        const PatrolStop cut = patrolLeg(uav, patrolStart(uav), ahead, &beyond);
        QVERIFY(std::abs((cut.place_m - ahead.place_m).norm() - 300) < 1e-9);
        QVERIFY(cut.place_m.y() > 200);
        // An iceberg that drifts away at 2 m/s is met about 10 % later.
        const DriftingPlace fleeing{.place_m = {2300, 0}, .velocity_mps = {2, 0}};
        const double met_s = patrolLeg(uav, patrolStart(uav), fleeing, nullptr).time_s;
        QVERIFY(met_s > 109 && met_s < 112); // The iteration would converge to 111.1 s.
        // An iceberg in view takes no time.
        const DriftingPlace near{.place_m = {200, 0}};
        QCOMPARE(patrolLeg(uav, patrolStart(uav), near, nullptr).time_s, 0.0);
    }

    /**
     * A turn takes the time of a turn of theta at the limit and the line from its end to a place
     * far away.
     */
    void turnsTakeTime()
    {
        const PatrolUav uav{.start = {}, .speed_mps = 20, .radius_m = 100, .reach_m = 0};
        for (double theta_rad = 0.3; theta_rad < 3.1; theta_rad += 0.2) {
            const DriftingPlace to{.place_m = turned({8000, 0}, theta_rad)};
            const double extra_s = patrolLeg(uav, patrolStart(uav), to, nullptr).time_s - 400;
            const double turn_s = (theta_rad - std::sin(theta_rad)) * 100 / 20;
            QVERIFY(std::abs(extra_s - turn_s) < 1e-3); // The error is that of the arc cosine.
        }
    }

    void costsAreThoseByHand()
    {
        Random random(7);
        for (std::uint64_t seed = 1; seed <= 60; ++seed) {
            const int uavs = 1 + static_cast<int>(seed % 3);
            PatrolSearch search(pointProblem(seed, 6, uavs, 4000), Random(seed));
            const PatrolRoutes routes = randomRoutes(search.problem(), 20, random);
            search.set(routes);
            QVERIFY(std::abs(search.cost_m2s() - costByHand(search.problem(), routes)) <
                    1e-9 * search.cost_m2s());
        }
    }

    /**
     * Predicted changes of cost are exact without drift, turns and a cut at the end, if the UAVs
     * visit each iceberg in the same order.
     */
    void changesOfCostAreThoseOfCostsAnew()
    {
        Random random(11);
        int compared = 0;
        for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
            const int uavs = 1 + static_cast<int>(seed % 3);
            PatrolSearch search(pointProblem(seed, 7, uavs, 50'000), Random(seed));
            search.set(randomRoutes(search.problem(), 12, random));
            const PatrolSearch::Change change = randomChange(search, random);
            const double before_m2s = search.cost_m2s();
            const double predicted_m2s = search.changeOfCost_m2s(change);
            const auto turns = turnsOf(search);
            search.apply(change);
            QVERIFY(std::abs(search.cost_m2s() - costByHand(search.problem(), search.routes())) <
                    1e-9 * search.cost_m2s());
            if (uavs > 1) {
                // Visits after the changed ones must not overtake the visits of others.
                PatrolSearch same(search.problem(), Random(seed));
                same.set(search.routes());
                if (change.visits.size() != static_cast<std::size_t>(change.end - change.begin) ||
                    turnsOf(same) != turns)
                    continue;
            }
            ++compared;
            QVERIFY2(std::abs(search.cost_m2s() - before_m2s - predicted_m2s) < 1e-9 * before_m2s,
                     qPrintable(QString::number(seed)));
        }
        QVERIFY(compared > 500);
    }

    /** Changes are exact for a growth that bends, and another growth after the first visit. */
    void changesKnowHowOftenAnIcebergWasSeen()
    {
        Random random(13);
        for (std::uint64_t seed = 1; seed <= 300; ++seed) {
            PatrolProblem problem = pointProblem(seed, 5, 1, 50'000);
            for (PatrolIceberg& iceberg : problem.icebergs) {
                iceberg.growth[0].rate_m2ps *= 3;
                iceberg.growth[1].rate_m2ps *= 2;
            }
            PatrolSearch search(problem, Random(seed));
            search.set(randomRoutes(problem, 10, random));
            const PatrolSearch::Change change = randomChange(search, random);
            const double before_m2s = search.cost_m2s();
            const double predicted_m2s = search.changeOfCost_m2s(change);
            search.apply(change);
            QVERIFY(std::abs(search.cost_m2s() - before_m2s - predicted_m2s) < 1e-9 * before_m2s);
        }
    }

    /**
     * The predictions of a patrol with sorties are exact as well, because it flies on to the next
     * take-off.
     */
    void changesAreExactWithSorties()
    {
        Random random(17);
        int sorties = 0;
        for (std::uint64_t seed = 1; seed <= 400; ++seed) {
            PatrolProblem problem = pointProblem(seed, 6, 1, 50'000);
            problem.uavs[0].sorties = PatrolSorties{
                .home = {.place_m = {3000, 0}}, .left_s = 900, .length_s = 1500, .ground_s = 300};
            PatrolSearch search(problem, Random(seed));
            search.set(randomRoutes(problem, 14, random));
            if (search.visits(0).size() < 5)
                continue;
            const PatrolSearch::Change change = randomChange(search, random);
            const double before_m2s = search.cost_m2s();
            const double predicted_m2s = search.changeOfCost_m2s(change);
            search.apply(change);
            sorties +=
                static_cast<int>(std::ranges::count_if(search.stops(0), &PatrolStop::tookOff));
            QVERIFY2(std::abs(search.cost_m2s() - before_m2s - predicted_m2s) < 1e-9 * before_m2s,
                     qPrintable(QString::number(seed)));
        }
        QVERIFY(sorties > 400);
    }

    /** Each sortie ends at home in time, and begins after the turn-around. */
    void sortiesComeHome()
    {
        PatrolProblem problem = pointProblem(3, 8, 1, 20'000);
        const PatrolSorties sorties{
            .home = {.place_m = {3000, 0}}, .left_s = 700, .length_s = 1500, .ground_s = 600};
        problem.uavs[0].sorties = sorties;
        PatrolSearch search(problem, Random(1));
        search.set({{}});
        search.extend();
        QVERIFY(search.visits(0).size() > 10);
        double takenOff_s = sorties.left_s - sorties.length_s;
        double before_s = 0;
        Point before_m = problem.uavs[0].start.position_m;
        int flown = 0;
        for (const PatrolStop& stop : search.stops(0)) {
            const auto home_s = [&](const Point& from_m) {
                return (from_m - sorties.home.place_m).norm() / kSpeed_mps;
            };
            if (stop.tookOff) {
                takenOff_s = before_s + home_s(before_m) + sorties.ground_s;
                QVERIFY(std::abs(stop.time_s - takenOff_s - home_s(stop.place_m)) < 1e-6);
                ++flown;
            }
            QVERIFY(stop.time_s + home_s(stop.place_m) <= takenOff_s + sorties.length_s + 1e-6);
            before_s = stop.time_s;
            before_m = stop.place_m;
        }
        QVERIFY(flown >= 7);
    }

    void findsTheBestOfAll()
    {
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            PatrolProblem problem = pointProblem(seed, 4, 1, 1100);
            for (std::size_t i = 0; i < 4; ++i) // The icebergs are far enough apart for few visits.
                problem.icebergs[i].place.place_m = problem.icebergs[i].place.place_m / 3 +
                                                    Point(i % 2 == 0 ? 0 : 4000, i < 2 ? 0 : 4000);
            PatrolSearch search(problem, Random(seed));
            const double least_m2s = leastByBruteForce(problem);
            double found_m2s = std::numeric_limits<double>::infinity();
            // The search may not leave a local minimum from a single start.
            for (int start = 0; start < 4; ++start) {
                search.set({{start}});
                search.extend();
                search.improve(10'000, 0.4, SolveWatch(kNoLimits));
                QVERIFY(search.cost_m2s() >= least_m2s * (1 - 1e-9));
                found_m2s = std::min(found_m2s, search.cost_m2s());
            }
            QVERIFY2(found_m2s <= least_m2s * (1 + 1e-9),
                     qPrintable(QString::number(found_m2s / least_m2s - 1)));
        }
    }

    /** All visits are allowed ones, and so is the first. */
    void obeysWhoMayVisitWhat()
    {
        PatrolProblem problem = pointProblem(5, 10, 2, 6000);
        for (int u = 0; u < 2; ++u) {
            PatrolUav& uav = problem.uavs[static_cast<std::size_t>(u)];
            for (int i = 0; i < 10; ++i) {
                uav.any.push_back(i % 5 != u);
                uav.first.push_back(i > 6);
            }
        }
        PatrolSearch search(problem, Random(1));
        search.set({{}, {}});
        search.extend();
        search.improve(20'000, 0.2, SolveWatch(kNoLimits));
        for (std::size_t u = 0; u < 2; ++u) {
            QVERIFY(!search.visits(u).empty());
            QVERIFY(search.visits(u).front() > 6);
            for (const int i : search.visits(u))
                QVERIFY(i % 5 != static_cast<int>(u));
        }
    }

    void theSameAgain()
    {
        std::vector<PatrolRoutes> found;
        for (int times = 0; times < 2; ++times) {
            Random random(4);
            PatrolSearch search(pointProblem(2, 12, 2, 9000), Random(3));
            search.set(patrolRounds(search.problem(), {}, random));
            const double before_m2s = search.cost_m2s();
            search.improve(5000, 0.1, SolveWatch(kNoLimits));
            QVERIFY(search.cost_m2s() < before_m2s);
            found.push_back(search.routes());
        }
        QVERIFY(found[0] == found[1]);
    }

    void toursAreShortened()
    {
        // On a circle the shortest tour goes round it.
        constexpr int kStops = 30;
        std::vector<Point> places_m;
        for (int k = 0; k < kStops; ++k)
            places_m.push_back(turned({1000, 0}, 2 * 3.14159265358979 * k / kStops));
        Random random(1);
        for (int times = 0; times < 20; ++times) {
            std::vector<int> tour(kStops);
            std::iota(tour.begin(), tour.end(), 0);
            for (std::size_t k = kStops; k > 1; --k)
                std::swap(tour[k - 1], tour[random.below(k)]);
            shortenTour(tour, places_m);
            QVERIFY(std::abs(tourLength_m(tour, places_m) -
                             2000 * kStops * std::sin(3.14159265358979 / kStops)) < 1e-6);
        }
    }

    /** Every round of some UAV visits every iceberg. */
    void roundsVisitAll()
    {
        for (const int uavs : {1, 2, 3}) {
            const PatrolProblem problem = pointProblem(9, 20, uavs, 20'000);
            Random random(2);
            const PatrolRoutes routes = patrolRounds(problem, {}, random);
            std::vector<int> visits(20, 0);
            for (const std::vector<int>& route : routes)
                for (const int i : route)
                    ++visits[static_cast<std::size_t>(i)];
            QVERIFY(std::ranges::min(visits) >= 2);
        }
    }

    /**
     * The rest of a route has the cost of that part of the whole, whichever UAV flies it, and its
     * cost changes with a shift by the amount of a new calculation.
     */
    void tailsAddUp()
    {
        Random random(3);
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            const std::size_t uavs = 1 + seed % 3;
            PatrolSearch search(pointProblem(seed, 5, static_cast<int>(uavs), 50'000), Random(1));
            search.set(randomRoutes(search.problem(), 12, random));
            const std::vector<std::size_t> cuts(uavs, 4);
            const PatrolTails tails(search, cuts);
            const PatrolTail tail = tails.tailOf(0, std::vector<double>(uavs, 0));
            // There is no shift if the legs are flown as planned.
            const PatrolStop& end = search.stops(0)[3];
            QVERIFY(std::abs(tail.shift_s({end.place_m, end.ahead}, end.time_s)) < 1e-9);
            QVERIFY(std::abs(tail.shift_s({end.place_m, end.ahead}, end.time_s + 50) - 50) < 1e-9);
            // The cost with a delay of one second is calculated by hand.
            double rest_m2s = 0;
            double later_m2s = 0;
            for (std::size_t i = 0; i < 5; ++i) {
                // Each entry has the planned and the delayed time.
                std::vector<std::pair<double, double>> times_s;
                for (std::size_t u = 0; u < uavs; ++u)
                    for (const PatrolVisit& visit : tails.visits(u))
                        if (visit.iceberg == ModelPlace::of(i))
                            times_s.emplace_back(visit.time_s, visit.time_s + (u == 0 ? 1 : 0));
                std::ranges::sort(times_s);
                times_s.emplace_back(50'000, 50'000);
                for (std::size_t k = 1; k < times_s.size(); ++k) {
                    const double q_m2ps = search.problem().icebergs[i].growth[1].rate_m2ps;
                    rest_m2s += q_m2ps * std::pow(times_s[k].first - times_s[k - 1].first, 2) / 2;
                    later_m2s +=
                        q_m2ps * std::pow(times_s[k].second - times_s[k - 1].second, 2) / 2;
                }
            }
            QVERIFY(std::abs(tail.rest_m2s - rest_m2s) < 1e-9 * rest_m2s);
            QVERIFY(std::abs(tail.slope_m2 + tail.bend_m2ps - (later_m2s - rest_m2s)) <
                    1e-6 * rest_m2s / 50'000 + 1e-9 * rest_m2s);
        }
    }
};

QTEST_APPLESS_MAIN(TestPatrolSearch)
#include "tst_patrol_search.moc"
