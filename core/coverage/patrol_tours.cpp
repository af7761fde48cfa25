#include "core/coverage/patrol_tours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace berg {

namespace {

constexpr std::size_t kMostVisitsOfRounds = 1500;
constexpr int kMostSweeps = 60;
/** Larger fields get fewer tries for their first tour. */
constexpr double kStopsOfTries = 60;
constexpr double kLeastGain_m = 1e-6;

/** One closed tour that is being shortened. */
class TourShortener
{
public:
    TourShortener(std::vector<int>& tour, std::span<const Point> places_m)
        : m_tour(tour), m_places_m(places_m), m_count(static_cast<int>(tour.size()))
    {
    }

    bool turnStretches()
    {
        bool isShorter = false;
        for (int i = 0; i + 1 < m_count; ++i)
            for (int j = i + 1; j < m_count; ++j) {
                if (i == 0 && j == m_count - 1)
                    continue;
                const double gain_m =
                    away_m(i - 1, i) + away_m(j, j + 1) - away_m(i - 1, j) - away_m(i, j + 1);
                if (gain_m <= kLeastGain_m)
                    continue;
                std::reverse(m_tour.begin() + i, m_tour.begin() + j + 1);
                isShorter = true;
            }
        return isShorter;
    }

    bool moveStretches()
    {
        bool isShorter = false;
        for (int length = 1; length <= std::min(3, m_count - 2); ++length)
            for (int i = 0; i + length <= m_count; ++i)
                isShorter = moveStretch(i, length) || isShorter;
        return isShorter;
    }

private:
    bool moveStretch(int first, int length)
    {
        const int last = first + length - 1;
        const double out_m =
            away_m(first - 1, first) + away_m(last, last + 1) - away_m(first - 1, last + 1);
        std::optional<int> best;
        bool bestTurned = false;
        double bestGain_m = kLeastGain_m;
        for (int k = 0; k < m_count; ++k) { // The stops move between k and k + 1.
            if ((k >= first - 1 && k <= last) || (first == 0 && k == m_count - 1))
                continue;
            const double edge_m = away_m(k, k + 1);
            const double straight_m = away_m(k, first) + away_m(last, k + 1) - edge_m;
            const double turned_m = away_m(k, last) + away_m(first, k + 1) - edge_m;
            const double gain_m = out_m - std::min(straight_m, turned_m);
            if (gain_m <= bestGain_m)
                continue;
            best = k;
            bestGain_m = gain_m;
            bestTurned = turned_m < straight_m;
        }
        if (!best)
            return false;
        const auto begin = m_tour.begin() + first;
        std::vector<int> stretch(begin, begin + length);
        if (bestTurned)
            std::reverse(stretch.begin(), stretch.end());
        m_tour.erase(begin, begin + length);
        const int to = *best < first ? *best + 1 : *best + 1 - length;
        m_tour.insert(m_tour.begin() + to, stretch.begin(), stretch.end());
        return true;
    }

    [[nodiscard]] const Point& place_m(int k) const
    {
        const int stop = m_tour[static_cast<std::size_t>((k + m_count) % m_count)];
        return m_places_m[static_cast<std::size_t>(stop)];
    }
    [[nodiscard]] double away_m(int a, int b) const { return (place_m(a) - place_m(b)).norm(); }

    std::vector<int>& m_tour;
    std::span<const Point> m_places_m;
    int m_count;
};

double length_m(std::span<const int> tour, std::span<const Point> places_m)
{
    double sum_m = 0;
    for (std::size_t k = 0; k < tour.size(); ++k)
        sum_m += (places_m[static_cast<std::size_t>(tour[k])] -
                  places_m[static_cast<std::size_t>(tour[(k + 1) % tour.size()])])
                     .norm();
    return sum_m;
}

std::vector<Point> placesAt(const PatrolProblem& problem, double time_s)
{
    std::vector<Point> places_m;
    for (const PatrolIceberg& iceberg : problem.icebergs)
        places_m.push_back(iceberg.place.at(time_s));
    return places_m;
}

/** Exchanges two stretches of the tour, a change that reversals and moves do not undo. */
std::vector<int> doubleBridge(const std::vector<int>& tour, Random& random)
{
    constexpr std::size_t kFewest = 8;
    if (tour.size() < kFewest)
        return tour;
    std::array<std::size_t, 3> cuts{};
    for (std::size_t& cut : cuts)
        cut = 1 + random.below(tour.size() - 1);
    std::ranges::sort(cuts);
    const auto at = [&](std::size_t k) { return tour.begin() + static_cast<std::ptrdiff_t>(k); };
    std::vector<int> mixed(tour.begin(), at(cuts[0]));
    mixed.insert(mixed.end(), at(cuts[1]), at(cuts[2]));
    mixed.insert(mixed.end(), at(cuts[0]), at(cuts[1]));
    mixed.insert(mixed.end(), at(cuts[2]), tour.end());
    return mixed;
}

std::vector<int> nearestNext(std::span<const Point> places_m, Point from_m)
{
    std::vector<int> tour(places_m.size());
    std::iota(tour.begin(), tour.end(), 0);
    const auto away_m2 = [&](int i) {
        return (places_m[static_cast<std::size_t>(i)] - from_m).squaredNorm();
    };
    for (auto it = tour.begin(); it != tour.end(); ++it) {
        std::iter_swap(it, std::min_element(it, tour.end(),
                                            [&](int a, int b) { return away_m2(a) < away_m2(b); }));
        from_m = places_m[static_cast<std::size_t>(*it)];
    }
    return tour;
}

/** Returns the shortest tour found over the present places of all icebergs. */
std::vector<int> firstTour(const PatrolProblem& problem, int tries, Random& random)
{
    const std::vector<Point> places_m = placesAt(problem, 0);
    std::vector<int> best = nearestNext(places_m, problem.uavs.front().start.position_m);
    shortenTour(best, places_m);
    double best_m = length_m(best, places_m);
    // Shortening takes time in proportion to the square of the number of stops.
    const double share = std::min(1.0, kStopsOfTries / static_cast<double>(places_m.size()));
    tries = static_cast<int>(std::ceil(share * share * tries));
    for (int k = 1; k < tries; ++k) {
        std::vector<int> other = doubleBridge(best, random);
        shortenTour(other, places_m);
        const double other_m = length_m(other, places_m);
        if (other_m < best_m) {
            best = std::move(other);
            best_m = other_m;
        }
    }
    return best;
}

/** Returns pieces of about the same length, each assigned to the nearest UAV that has none. */
std::vector<std::vector<int>> piecesOf(const std::vector<int>& tour, const PatrolProblem& problem)
{
    const std::size_t uavs = problem.uavs.size();
    if (uavs == 1)
        return {tour};
    const std::vector<Point> places_m = placesAt(problem, 0);
    const double whole_m = length_m(tour, places_m);
    std::vector<std::vector<int>> cut(uavs);
    double flown_m = 0;
    for (std::size_t k = 0; k < tour.size(); ++k) {
        const double share = whole_m > 0 ? flown_m / whole_m : 0;
        cut[std::min(uavs - 1, static_cast<std::size_t>(share * static_cast<double>(uavs)))]
            .push_back(tour[k]);
        if (k + 1 < tour.size())
            flown_m += (places_m[static_cast<std::size_t>(tour[k])] -
                        places_m[static_cast<std::size_t>(tour[k + 1])])
                           .norm();
    }
    std::vector<std::vector<int>> pieces(uavs);
    for (std::size_t u = 0; u < uavs; ++u) {
        const auto away_m = [&](const std::vector<int>& piece) {
            double least_m = std::numeric_limits<double>::infinity();
            for (const int i : piece)
                least_m = std::min(least_m, (places_m[static_cast<std::size_t>(i)] -
                                             problem.uavs[u].start.position_m)
                                                .norm());
            return least_m;
        };
        const auto nearest = std::ranges::min_element(cut, {}, away_m);
        pieces[u] = std::move(*nearest);
        cut.erase(nearest);
    }
    return pieces;
}

/** Rotates the tour so that it begins at the nearest stop to which the UAV may fly first. */
void enter(std::vector<int>& tour, const PatrolProblem& problem, const PatrolUav& uav)
{
    const auto away_m = [&](int i) {
        return uav.mayVisit(i, true)
                   ? (problem.icebergs[static_cast<std::size_t>(i)].place.place_m -
                      uav.start.position_m)
                         .norm()
                   : std::numeric_limits<double>::infinity();
    };
    std::rotate(tour.begin(), std::ranges::min_element(tour, {}, away_m), tour.end());
}

std::vector<int> roundsOf(std::vector<int> tour, const PatrolProblem& problem, const PatrolUav& uav)
{
    /**
     * Length of a round with aims short of the icebergs, relative to the tour over the icebergs.
     */
    constexpr double kShorter = 0.8;
    std::vector<int> visits;
    double time_s = 0;
    while (!tour.empty() && time_s < problem.length_s && visits.size() < kMostVisitsOfRounds) {
        const int first = tour.front();
        const int second = tour[std::min<std::size_t>(1, tour.size() - 1)];
        const double round_s = length_m(tour, placesAt(problem, time_s)) / uav.speed_mps;
        const std::vector<Point> places_m =
            placesAt(problem, std::min(problem.length_s, time_s + round_s / 2));
        shortenTour(tour, places_m);
        std::rotate(tour.begin(), std::ranges::find(tour, first), tour.end());
        if (tour.back() == second && tour.size() > 2) // The tour has been reversed.
            std::reverse(tour.begin() + 1, tour.end());
        visits.insert(visits.end(), tour.begin(), tour.end());
        time_s += std::max(1.0, kShorter * length_m(tour, places_m) / uav.speed_mps);
    }
    visits.resize(std::min(visits.size(), kMostVisitsOfRounds));
    return visits;
}

} // namespace

void shortenTour(std::vector<int>& tour, std::span<const Point> places_m)
{
    if (tour.size() < 4)
        return;
    TourShortener shortener(tour, places_m);
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
        const bool isTurned = shortener.turnStretches();
        if (!shortener.moveStretches() && !isTurned)
            return;
    }
}

PatrolRoutes patrolRounds(const PatrolProblem& problem, const PatrolRounds& rounds, Random& random)
{
    PatrolRoutes routes = piecesOf(firstTour(problem, rounds.tries, random), problem);
    for (std::size_t u = 0; u < routes.size(); ++u) {
        if (rounds.reversed)
            std::ranges::reverse(routes[u]);
        if (routes[u].empty())
            continue;
        enter(routes[u], problem, problem.uavs[u]);
        routes[u] = roundsOf(std::move(routes[u]), problem, problem.uavs[u]);
    }
    return routes;
}

} // namespace berg
