#include "core/coverage/patrol_search.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

// This file proposes the changes that `PatrolSearch` tries.

namespace berg {

namespace {

/**
 * Limits of a random number below `kAllMoves` that choose the move; the moves of one visit come
 * first.
 */
constexpr std::uint64_t kInsertVisit = 22;
constexpr std::uint64_t kRemoveVisit = kInsertVisit + 12;
constexpr std::uint64_t kReplaceVisit = kRemoveVisit + 8;
constexpr std::uint64_t kMoveVisit = kReplaceVisit + 20;
constexpr std::uint64_t kTurnStretch = kMoveVisit + 16;
constexpr std::uint64_t kMoveStretch = kTurnStretch + 14;
constexpr std::uint64_t kAllMoves = kMoveStretch + 8;
/** With several UAVs, this percentage of moves assigns visits of one UAV to another. */
constexpr std::uint64_t kTransfers = 12;

constexpr std::size_t kNeighbours = 12;
/** Draws of places prefer the first ones by this power. */
constexpr double kEarlyPower = 1.2;
/**
 * Two visits that are changed together are no farther apart than this in a route. The second limit
 * is for visits that are drawn without regard to the icebergs.
 */
constexpr int kFarthest = 40;
constexpr int kNearby = 8;
constexpr int kLongestStretch = 4;
/**
 * Icebergs mix within a day, so lists of neighbours are made for this many parts of the time, each
 * at least this long.
 */
constexpr int kSlices = 16;
constexpr double kShortestSlice_s = 1800;

std::size_t toPlace(int place)
{
    return static_cast<std::size_t>(place);
}

} // namespace

PatrolSearch::PatrolSearch(PatrolProblem problem, const Random& random)
    : m_problem(std::move(problem))
    , m_random(random)
    , m_routes(m_problem.uavs.size())
    , m_seen(m_problem.icebergs.size())
    , m_slice_s(std::max(kShortestSlice_s, m_problem.length_s / kSlices))
    , m_old(m_problem.icebergs.size())
    , m_new(m_problem.icebergs.size())
    , m_isTouched(m_problem.icebergs.size(), 0)
{
    const auto slices = static_cast<std::size_t>(m_problem.length_s / m_slice_s) + 1;
    m_near.assign(slices, std::vector<std::vector<int>>(m_problem.icebergs.size()));
    account();
}

/**
 * Returns the neighbours of an iceberg, nearest first, in the middle of the part of the time that
 * holds `time_s`.
 */
const std::vector<int>& PatrolSearch::neighbours(int i, double time_s)
{
    const auto slice = std::min(m_near.size() - 1, static_cast<std::size_t>(time_s / m_slice_s));
    std::vector<int>& near = m_near[slice][toPlace(i)];
    if (!near.empty() || m_problem.icebergs.size() < 2)
        return near;
    const double middle_s = (static_cast<double>(slice) + 0.5) * m_slice_s;
    const Point place_m = iceberg(i).place.at(middle_s);
    m_distances.clear();
    for (int j = 0; j < static_cast<int>(m_problem.icebergs.size()); ++j)
        if (j != i)
            m_distances.emplace_back((iceberg(j).place.at(middle_s) - place_m).squaredNorm(), j);
    const auto last = m_distances.begin() +
                      static_cast<std::ptrdiff_t>(std::min(kNeighbours, m_distances.size()));
    std::partial_sort(m_distances.begin(), last, m_distances.end());
    std::transform(m_distances.begin(), last, std::back_inserter(near),
                   [](const auto& away) { return away.second; });
    return near;
}

/** Draws a neighbour; the nearer ones are drawn more often. */
int PatrolSearch::neighbour(int i, double time_s)
{
    const std::vector<int>& near = neighbours(i, time_s);
    if (near.empty())
        return i;
    const double uniform = m_random.uniform();
    const double share = uniform * std::sqrt(uniform);
    return near[std::min(near.size() - 1,
                         static_cast<std::size_t>(share * static_cast<double>(near.size())))];
}

/**
 * Returns a visit of an iceberg in a route, the first one from a place on or the last one before
 * it, or nullopt if there is none.
 */
std::optional<int> PatrolSearch::placeIn(std::size_t uav, int i, int near)
{
    std::optional<int> before;
    const bool wantsBefore = m_random.below(2) == 0;
    for (const Seen& seen : m_seen[toPlace(i)]) {
        if (seen.uav != uav)
            continue;
        if (seen.place < near)
            before = seen.place;
        else
            return wantsBefore && before ? before : seen.place;
    }
    return before;
}

/** Returns another visit to change together with this one, or nullopt if there is none. */
std::optional<int> PatrolSearch::partnerOf(std::size_t uav, int place)
{
    const Route& route = m_routes[uav];
    const int count = static_cast<int>(route.visits.size());
    std::optional<int> partner;
    if (m_random.below(3) != 0)
        partner = placeIn(
            uav, neighbour(route.visits[toPlace(place)], route.stops[toPlace(place)].time_s),
            place);
    else
        partner = place - kNearby + static_cast<int>(m_random.below(2 * kNearby + 1));
    const bool isPartner = partner && *partner >= 0 && *partner < count && *partner != place &&
                           std::abs(*partner - place) <= kFarthest;
    return isPartner ? partner : std::nullopt;
}

bool PatrolSearch::propose(Change& change, std::size_t uav)
{
    const Route& route = m_routes[uav];
    const int count = static_cast<int>(route.visits.size());
    change.uav = uav;
    change.visits.clear();
    if (count == 0)
        return false;
    const std::uint64_t dice = m_random.below(kAllMoves);
    const double share = std::pow(m_random.uniform(), kEarlyPower);
    const int place = std::min(count - 1, static_cast<int>(share * count));
    if (dice < kReplaceVisit) {
        proposeOne(change, place, dice);
        return isAllowed(change);
    }
    const std::optional<int> partner = partnerOf(uav, place);
    return partner && proposeTwo(change, place, *partner, dice) && isAllowed(change);
}

void PatrolSearch::proposeOne(Change& change, int place, std::uint64_t dice)
{
    const Route& route = m_routes[change.uav];
    change.begin = place;
    change.end = place + 1;
    if (dice < kInsertVisit) { // The new visit comes before or after the present one.
        change.begin += static_cast<int>(m_random.below(2));
        change.end = change.begin;
    }
    if (dice < kInsertVisit || dice >= kRemoveVisit)
        change.visits.push_back(
            neighbour(route.visits[toPlace(place)], route.stops[toPlace(place)].time_s));
}

bool PatrolSearch::proposeTwo(Change& change, int a, int b, std::uint64_t dice)
{
    const std::vector<int>& visits = m_routes[change.uav].visits;
    const auto at = [&](int place) { return visits.begin() + place; };
    std::vector<int>& list = change.visits;
    change.begin = std::min(a, b);
    change.end = std::max(a, b) + 1;
    if (dice < kMoveVisit || (dice >= kTurnStretch && dice < kMoveStretch)) {
        // One visit or a stretch from `a` on moves beside `b`.
        const bool isStretch = dice >= kTurnStretch;
        const int length =
            isStretch ? 2 + static_cast<int>(m_random.below(kLongestStretch - 1)) : 1;
        const int end = a + length;
        if (end > static_cast<int>(visits.size()) || (b >= a && b < end))
            return false;
        const int beside = m_random.below(2) == 0 ? b : b + 1;
        change.begin = std::min(a, beside);
        change.end = std::max(end, beside);
        if (beside > a)
            list.assign(at(end), at(beside));
        list.insert(list.end(), at(a), at(end));
        if (isStretch && m_random.below(2) == 0)
            std::reverse(list.end() - length, list.end());
        if (beside <= a)
            list.insert(list.end(), at(beside), at(a));
        return true;
    }
    if (dice < kTurnStretch) { // The reversed stretch makes the two visits neighbours.
        if (m_random.below(2) == 0)
            ++change.begin;
        else
            --change.end;
        if (change.end - change.begin < 2)
            return false;
        list.assign(at(change.begin), at(change.end));
        std::reverse(list.begin(), list.end());
        return true;
    }
    list.assign(at(change.begin), at(change.end));
    std::swap(list.front(), list.back());
    return true;
}

/**
 * Returns about how much longer a change makes the path, from line to line between the icebergs
 * where they are when the changed visits begin.
 */
double PatrolSearch::detour_m(const Change& change) const
{
    const Route& route = m_routes[change.uav];
    const bool isFirst = change.begin == 0;
    const PatrolStop from =
        isFirst ? patrolStart(m_problem.uavs[change.uav]) : route.stops[toPlace(change.begin - 1)];
    const auto place_m = [&](int i) { return iceberg(i).place.at(from.time_s); };
    const Point from_m = isFirst ? from.place_m : place_m(route.visits[toPlace(change.begin - 1)]);
    const auto length_m = [&](std::span<const int> visits) {
        double sum_m = 0;
        Point last_m = from_m;
        for (const int i : visits) {
            const Point next_m = place_m(i);
            sum_m += (next_m - last_m).norm();
            last_m = next_m;
        }
        if (toPlace(change.end) < route.visits.size())
            sum_m += (place_m(route.visits[toPlace(change.end)]) - last_m).norm();
        return sum_m;
    };
    return length_m(change.visits) -
           length_m(std::span(route.visits)
                        .subspan(toPlace(change.begin), toPlace(change.end - change.begin)));
}

bool PatrolSearch::isAllowed(const Change& change) const
{
    const PatrolUav& uav = m_problem.uavs[change.uav];
    if (uav.first.empty() && uav.any.empty())
        return true;
    for (const int i : change.visits)
        if (!uav.mayVisit(i, false))
            return false;
    if (change.begin > 0)
        return true;
    if (!change.visits.empty())
        return uav.mayVisit(change.visits.front(), true);
    const std::vector<int>& visits = m_routes[change.uav].visits;
    return change.end < static_cast<int>(visits.size()) &&
           uav.mayVisit(visits[toPlace(change.end)], true);
}

bool PatrolSearch::step(double limit_m2s)
{
    const std::size_t uavs = m_routes.size();
    if (uavs > 1 && m_random.below(100) < kTransfers)
        return transfer(limit_m2s);
    const std::size_t uav = uavs > 1 ? m_random.below(uavs) : 0;
    if (!propose(m_change, uav) || !costsLess(m_change, limit_m2s))
        return false;
    apply(m_change);
    return true;
}

/**
 * Moves one to three visits of one UAV to another UAV, beside a visit that is near in place and
 * time.
 */
bool PatrolSearch::transfer(double limit_m2s)
{
    const std::size_t uavs = m_routes.size();
    const std::size_t from = m_random.below(uavs);
    const std::size_t to = (from + 1 + m_random.below(uavs - 1)) % uavs;
    const int count = static_cast<int>(m_routes[from].visits.size());
    if (count == 0)
        return false;
    const int begin = static_cast<int>(m_random.below(static_cast<std::uint64_t>(count)));
    const int end = std::min(count, begin + 1 + static_cast<int>(m_random.below(3)));
    const Route& giver = m_routes[from];
    std::vector<int> moved(giver.visits.begin() + begin, giver.visits.begin() + end);
    const double time_s = giver.stops[toPlace(begin)].time_s;
    // The visit of the other UAV to a neighbour that is nearest in time.
    const int near = neighbour(moved.front(), time_s);
    int beside = -1;
    double least_s = m_problem.length_s;
    for (const Seen& seen : m_seen[toPlace(near)])
        if (seen.uav == to && std::abs(seen.time_s - time_s) < least_s) {
            beside = seen.place;
            least_s = std::abs(seen.time_s - time_s);
        }
    if (beside < 0)
        return false;
    beside += static_cast<int>(m_random.below(2));
    if (m_random.below(2) == 0)
        std::reverse(moved.begin(), moved.end());
    const Change give{.uav = from, .begin = begin, .end = end};
    const Change take{.uav = to, .begin = beside, .end = beside, .visits = moved};
    if (!isAllowed(give) || !isAllowed(take))
        return false;
    const double before_m2s = m_cost_m2s;
    std::vector<int> visits = giver.visits;
    apply(give);
    if (m_cost_m2s + changeOfCost_m2s(take) - before_m2s < limit_m2s) {
        apply(take);
        return true;
    }
    m_routes[from].visits = std::move(visits);
    fly(from, toPlace(std::max(0, begin - 1)));
    account();
    return false;
}

} // namespace berg
