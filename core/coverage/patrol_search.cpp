#include "core/coverage/patrol_search.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace berg {

namespace {

/** Largest number of visits of one UAV. */
constexpr std::size_t kMostVisits = 1500;
/** Number of moves between checks of the watch. */
constexpr int kMovesPerCheck = 256;
/** The value of a greedy visit is its sigma over its flight time plus this. */
constexpr double kGreedy_s = 10;

std::size_t placeIndex(int place)
{
    return static_cast<std::size_t>(place);
}

} // namespace

void PatrolSearch::set(PatrolRoutes routes)
{
    m_routes.assign(m_problem.uavs.size(), {});
    for (std::size_t u = 0; u < m_routes.size(); ++u) {
        for (const int i : routes[u])
            if (m_problem.uavs[u].mayVisit(i, m_routes[u].visits.empty()))
                m_routes[u].visits.push_back(i);
        fly(u, 0);
    }
    account();
}

PatrolRoutes PatrolSearch::routes() const
{
    PatrolRoutes routes;
    for (const Route& route : m_routes)
        routes.push_back(route.visits);
    return routes;
}

/** Recalculates a route from a visit on, and cuts visits that come too late. */
void PatrolSearch::fly(std::size_t uav, std::size_t from)
{
    Route& route = m_routes[uav];
    const std::size_t count = std::min(route.visits.size(), kMostVisits);
    route.stops.resize(count);
    PatrolStop now = from > 0 ? route.stops[from - 1] : patrolStart(m_problem.uavs[uav]);
    std::size_t k = from;
    for (; k < count; ++k) {
        now = flown(uav, now, route.visits[k],
                    k + 1 < count ? std::optional(route.visits[k + 1]) : std::nullopt);
        if (now.time_s >= end_s(uav))
            break;
        route.stops[k] = now;
    }
    route.visits.resize(k);
    route.stops.resize(k);
    if (m_problem.uavs[uav].sorties)
        measureLeeways(route);
}

void PatrolSearch::measureLeeways(Route& route) const
{
    route.leeways.resize(route.stops.size());
    Leeway leeway;
    for (std::size_t k = route.stops.size(); k-- > 0;) {
        const PatrolStop& stop = route.stops[k];
        leeway.later_s = std::min(leeway.later_s, stop.spare_s);
        route.leeways[k] = leeway;
        if (stop.tookOff)
            leeway = {.earlier_s = stop.missing_s};
    }
}

/**
 * Returns whether the visits after a place remain the same but for a shift, if the UAV reaches the
 * place in this state.
 */
bool PatrolSearch::isOnlyShifted(const Route& route, int place, const PatrolStop& now) const
{
    if (route.leeways.empty())
        return true;
    const PatrolStop& before = route.stops[placeIndex(place)];
    const Leeway& leeway = route.leeways[placeIndex(place)];
    const double late_s = now.time_s - before.time_s - (now.sortieEnd_s - before.sortieEnd_s);
    return now.tookOff == before.tookOff &&
           (now.tookOff || (late_s <= leeway.later_s && late_s > -leeway.earlier_s));
}

/**
 * Merges the visits of all UAVs, and calculates the derivatives of the cost with respect to shifts.
 */
void PatrolSearch::account()
{
    for (std::vector<Seen>& seen : m_seen)
        seen.clear();
    for (std::size_t u = 0; u < m_routes.size(); ++u) {
        Route& route = m_routes[u];
        route.slope_m2.assign(route.visits.size() + 2, 0);
        route.bend_m2ps.assign(route.visits.size() + 2, 0);
        for (std::size_t k = 0; k < route.visits.size(); ++k) {
            std::vector<Seen>& seen = m_seen[placeIndex(route.visits[k])];
            const double time_s = route.stops[k].time_s;
            auto at = seen.end(); // A linear search suffices because the lists are short.
            while (at != seen.begin() && std::prev(at)->time_s > time_s)
                --at;
            seen.insert(at, {.time_s = time_s, .uav = u, .place = static_cast<int>(k)});
        }
    }
    m_cost_m2s = 0;
    for (std::size_t i = 0; i < m_seen.size(); ++i)
        accountFor(static_cast<int>(i));
    for (Route& route : m_routes)
        for (std::size_t k = 1; k < route.slope_m2.size(); ++k) {
            route.slope_m2[k] += route.slope_m2[k - 1];
            route.bend_m2ps[k] += route.bend_m2ps[k - 1];
        }
}

/**
 * Adds the gaps of an iceberg to the cost and its derivatives. A gap gets longer with shifts that
 * begin after the visit of the same UAV before it, if there is one, up to the visit that ends it.
 * It gets shorter with shifts up to the visit that begins it, unless the same UAV ends it.
 */
void PatrolSearch::accountFor(int i)
{
    const std::vector<Seen>& seen = m_seen[placeIndex(i)];
    const auto add = [](Route& route, int from, int to, double slope_m2, double bend_m2ps) {
        route.slope_m2[placeIndex(from)] += slope_m2;
        route.slope_m2[placeIndex(to) + 1] -= slope_m2;
        route.bend_m2ps[placeIndex(from)] += bend_m2ps;
        route.bend_m2ps[placeIndex(to) + 1] -= bend_m2ps;
    };
    double last_s = 0;
    for (std::size_t m = 0; m <= seen.size(); ++m) {
        const PatrolGrowth& growth = iceberg(i).after(m);
        const double gap_s = (m < seen.size() ? seen[m].time_s : m_problem.length_s) - last_s;
        const double slope_m2 = growth.sigma_m2(gap_s);
        const double bend_m2ps = growth.slope_m2ps(gap_s) / 2;
        m_cost_m2s += growth.cost_m2s(gap_s);
        const bool sameUav = m > 0 && m < seen.size() && seen[m].uav == seen[m - 1].uav;
        if (m < seen.size())
            add(m_routes[seen[m].uav], sameUav ? seen[m - 1].place + 1 : 0, seen[m].place, slope_m2,
                bend_m2ps);
        if (m > 0 && !sameUav)
            add(m_routes[seen[m - 1].uav], 0, seen[m - 1].place, -slope_m2, bend_m2ps);
        last_s = m < seen.size() ? seen[m].time_s : last_s;
    }
}

void PatrolSearch::apply(const Change& change)
{
    std::vector<int>& visits = m_routes[change.uav].visits;
    const auto begin = visits.begin() + change.begin;
    const int same = std::min(change.end - change.begin, static_cast<int>(change.visits.size()));
    std::copy_n(change.visits.begin(), same, begin);
    if (change.end - change.begin > same)
        visits.erase(begin + same, visits.begin() + change.end);
    else
        visits.insert(begin + same, change.visits.begin() + same, change.visits.end());
    fly(change.uav, placeIndex(std::max(0, change.begin - 1)));
    account();
}

/**
 * Returns the cost of an iceberg's gaps up to a visit of `uav` at `time_s`, or to the end. Visits
 * of other UAVs before `others_s` count.
 */
double PatrolSearch::follow(Chain& chain, int i, std::size_t uav, double time_s,
                            double others_s) const
{
    const std::vector<Seen>& seen = m_seen[placeIndex(i)];
    const PatrolIceberg& berg = iceberg(i);
    double cost_m2s = 0;
    for (; chain.next < seen.size() && seen[chain.next].time_s < others_s; ++chain.next) {
        if (seen[chain.next].uav == uav)
            continue;
        cost_m2s += berg.after(chain.visits++).cost_m2s(seen[chain.next].time_s - chain.last_s);
        chain.last_s = seen[chain.next].time_s;
    }
    cost_m2s += berg.after(chain.visits++).cost_m2s(time_s - chain.last_s);
    chain.last_s = time_s;
    return cost_m2s;
}

/** Begins both chains of an iceberg at its last visit by the UAV before place `begin`. */
void PatrolSearch::touch(int i, std::size_t uav, int begin)
{
    if (m_isTouched[placeIndex(i)] != 0)
        return;
    m_isTouched[placeIndex(i)] = 1;
    m_touched.push_back(i);
    const std::vector<Seen>& seen = m_seen[placeIndex(i)];
    Chain chain;
    for (std::size_t m = 0; m < seen.size(); ++m)
        if (seen[m].uav == uav) {
            if (seen[m].place >= begin)
                break;
            chain = {.last_s = seen[m].time_s, .visits = m + 1, .next = m + 1};
        }
    m_old[placeIndex(i)] = m_new[placeIndex(i)] = chain;
}

/**
 * Returns the change of cost from the window to the iceberg's next visit by the UAV, or to the end.
 * If there are more or fewer visits before, the growth of later gaps changes, and the result covers
 * those as well.
 */
double PatrolSearch::changeOfRest_m2s(int i, const Change& change, int end, double shift_s)
{
    const std::vector<Seen>& seen = m_seen[placeIndex(i)];
    Chain& before = m_old[placeIndex(i)];
    Chain& after = m_new[placeIndex(i)];
    const std::size_t known = std::min(before.next, after.next);
    const auto rest = seen.begin() + static_cast<std::ptrdiff_t>(known);
    const auto next = std::find_if(rest, seen.end(), [&](const Seen& visit) {
        return visit.uav == change.uav && visit.place >= end;
    });
    // The cost before the change is that of the gap of the iceberg's next visit including the
    // shift, which the derivatives contain; it may be negative.
    const double was_s = next == seen.end() ? m_problem.length_s : next->time_s;
    const double until_s = next == seen.end() ? was_s : was_s + shift_s;
    double cost_m2s = follow(after, i, change.uav, until_s, until_s) -
                      follow(before, i, change.uav, until_s, was_s);
    if (next == seen.end() || before.visits == after.visits ||
        std::min(before.visits, after.visits) >= PatrolIceberg::kStages - 1)
        return cost_m2s;
    double last_s = until_s;
    for (auto visit = next + 1; true; ++visit) {
        double time_s = m_problem.length_s;
        if (visit != seen.end())
            time_s = visit->time_s + (visit->uav == change.uav ? shift_s : 0);
        cost_m2s += iceberg(i).after(after.visits++).cost_m2s(time_s - last_s) -
                    iceberg(i).after(before.visits++).cost_m2s(time_s - last_s);
        if (visit == seen.end())
            break;
        last_s = time_s;
    }
    return cost_m2s;
}

/** Returns a place of a route near `near` with these two consecutive visits, or nullopt. */
std::optional<int> PatrolSearch::formerPlace(const Route& route, std::pair<int, int> visits,
                                             int near)
{
    constexpr int kFarthestMoved = 4; // Moves of stretches shift visits by this number at most.
    const int first = std::max(0, near - kFarthestMoved);
    const int last = std::min(static_cast<int>(route.visits.size()) - 2, near + kFarthestMoved);
    for (int place = first; place <= last; ++place)
        if (route.visits[placeIndex(place)] == visits.first &&
            route.visits[placeIndex(place) + 1] == visits.second)
            return place;
    return std::nullopt;
}

/**
 * Returns the state after the visit at a place of a route if the UAV comes there by the same leg as
 * before at another time, from the state `now` at the place before; nullopt if it lands before or
 * did so.
 */
std::optional<PatrolStop> PatrolSearch::shiftedStop(const Route& route, int place,
                                                    const PatrolStop& now)
{
    const PatrolStop& before = route.stops[placeIndex(place - 1)];
    PatrolStop stop = route.stops[placeIndex(place)];
    if (stop.tookOff)
        return std::nullopt;
    const double shift_s = now.time_s - before.time_s;
    stop.time_s += shift_s;
    if (!route.leeways.empty()) {
        stop.spare_s -= shift_s - (now.sortieEnd_s - before.sortieEnd_s);
        stop.sortieEnd_s = now.sortieEnd_s;
        if (stop.spare_s < 0)
            return std::nullopt;
    }
    return stop;
}

/**
 * Flies the changed visits from `begin` on, and those after them until they are the same as before
 * but shifted. These are the visits from the second one after the change on and, with sorties, from
 * the first one on after which the UAV lands between the same visits as before. The third and later
 * ones of consecutive visits that follow each other as before are shifted, too.
 */
PatrolSearch::Shift PatrolSearch::flyChanged(const Change& change, int begin, Landings landings)
{
    constexpr int kFlownOfRun = 2;
    const Route& route = m_routes[change.uav];
    const int count = static_cast<int>(route.visits.size());
    const double end_s = this->end_s(change.uav);
    m_window.assign(route.visits.begin() + begin, route.visits.begin() + change.begin);
    m_window.insert(m_window.end(), change.visits.begin(), change.visits.end());
    const int changed = static_cast<int>(m_window.size());
    const int moved = change.end - changed; // Later visits have moved by this number of places.
    const auto before = [&](int place) {
        return place < count ? std::optional(route.visits[placeIndex(place)]) : std::nullopt;
    };
    const auto visitAt = [&](int w) {
        return w < changed ? std::optional(m_window[placeIndex(w)]) : before(w + moved);
    };
    Shift shift{.end = count};
    PatrolStop now =
        begin > 0 ? route.stops[placeIndex(begin - 1)] : patrolStart(m_problem.uavs[change.uav]);
    int place = begin; // Former place of the visit if `run` is positive.
    int run = 0;       // Number of visits up to this one that follow each other as before.
    for (int w = 0; w < changed + count - change.end; ++w, ++place) {
        const int i = *visitAt(w); // NOLINT(bugprone-unchecked-optional-access): `w` is in range
        const std::optional<int> next = visitAt(w + 1);
        if (run > 0 && before(place) == i) {
            ++run;
        } else {
            const std::optional<int> former =
                next ? formerPlace(route, {i, *next}, begin + w) : std::nullopt;
            place = former.value_or(place);
            run = former ? 1 : 0;
        }
        std::optional<PatrolStop> shifted;
        if (run > kFlownOfRun && before(place + 1) == next)
            shifted = shiftedStop(route, place, now);
        now = shifted ? *shifted : flown(change.uav, now, i, next);
        if (now.time_s >= end_s)
            break;
        if (w > changed) {
            const bool isExact = isOnlyShifted(route, w + moved, now);
            const PatrolStop& old = route.stops[placeIndex(w + moved)];
            if (isExact || (landings == Landings::AsBefore && now.tookOff == old.tookOff)) {
                shift.isGuess = !isExact;
                shift.end = w + moved;
                shift.shift_s = now.time_s - old.time_s;
                break;
            }
        }
        touch(i, change.uav, begin);
        shift.cost_m2s += follow(m_new[placeIndex(i)], i, change.uav, now.time_s, now.time_s);
    }
    shift.cost_m2s += shift.shift_s * (route.slope_m2[placeIndex(shift.end)] +
                                       shift.shift_s * route.bend_m2ps[placeIndex(shift.end)]);
    return shift;
}

double PatrolSearch::changeOfCost_m2s(const Change& change)
{
    return changeOfCost_m2s(change, Landings::Flown).cost_m2s;
}

PatrolSearch::Shift PatrolSearch::changeOfCost_m2s(const Change& change, Landings landings)
{
    const Route& route = m_routes[change.uav];
    const int begin = std::max(0, change.begin - 1);
    m_touched.clear();
    Shift shift = flyChanged(change, begin, landings);
    for (int k = begin; k < shift.end; ++k) {
        const int i = route.visits[placeIndex(k)];
        const double time_s = route.stops[placeIndex(k)].time_s;
        touch(i, change.uav, begin);
        shift.cost_m2s -= follow(m_old[placeIndex(i)], i, change.uav, time_s, time_s);
    }
    for (const int i : m_touched) {
        m_isTouched[placeIndex(i)] = 0;
        shift.cost_m2s += changeOfRest_m2s(i, change, shift.end, shift.shift_s);
    }
    return shift;
}

/**
 * Returns whether a change costs less than the limit. Changes are refused without a flight where
 * the delay of all later visits by the detour costs far more. With sorties, changes that would be
 * far worse if the UAV landed after the same visits as before are refused without flying on.
 */
bool PatrolSearch::costsLess(const Change& change, double limit_m2s)
{
    /**
     * Costs of visits that a change hardly ever saves beside the delay, which an aim at the edge of
     * the view shortens. About a third of all changes need no flight; of those that would be
     * accepted, fewer than 1 in 1000 are lost.
     */
    constexpr double kSaved = 1.5;
    /** Costs of visits by which later landings hardly ever make a change better. */
    constexpr double kVisits = 0.3;
    const Route& route = m_routes[change.uav];
    const double visit_m2s = m_cost_m2s / static_cast<double>(route.visits.size());
    const PatrolUav& uav = m_problem.uavs[change.uav];
    const double delay_s = (detour_m(change) - uav.reach_m) / uav.speed_mps;
    if (delay_s * route.slope_m2[placeIndex(change.end)] > limit_m2s + kSaved * visit_m2s)
        return false;
    const Shift shift = changeOfCost_m2s(change, Landings::AsBefore);
    if (!shift.isGuess)
        return shift.cost_m2s < limit_m2s;
    // A UAV that is late lands sooner, which makes the change even worse.
    const double gain_m2s = shift.shift_s > 0 ? 0 : kVisits * visit_m2s;
    return shift.cost_m2s < limit_m2s + gain_m2s && changeOfCost_m2s(change) < limit_m2s;
}

void PatrolSearch::extend()
{
    std::vector<double> lastSeen_s(m_seen.size(), 0);
    std::vector<std::size_t> visits(m_seen.size(), 0);
    for (std::size_t i = 0; i < m_seen.size(); ++i) {
        visits[i] = m_seen[i].size();
        if (!m_seen[i].empty())
            lastSeen_s[i] = m_seen[i].back().time_s;
    }
    std::vector<PatrolStop> now;
    for (std::size_t u = 0; u < m_routes.size(); ++u)
        now.push_back(m_routes[u].stops.empty() ? patrolStart(m_problem.uavs[u])
                                                : m_routes[u].stops.back());
    while (true) {
        const auto free = std::ranges::min_element(now, {}, &PatrolStop::time_s);
        const auto u = static_cast<std::size_t>(free - now.begin());
        Route& route = m_routes[u];
        if (!(free->time_s < end_s(u)))
            break;
        std::optional<int> best;
        double bestScore = 0;
        PatrolStop bestStop;
        for (int i = 0; i < static_cast<int>(m_seen.size()); ++i) {
            if (!m_problem.uavs[u].mayVisit(i, route.visits.empty()))
                continue;
            const PatrolStop stop = flown(u, *free, i, std::nullopt);
            const double flight_s = stop.time_s - free->time_s;
            if (!(flight_s > 0) || stop.time_s <= lastSeen_s[placeIndex(i)])
                continue;
            const double score = iceberg(i)
                                     .after(visits[placeIndex(i)])
                                     .sigma_m2(stop.time_s - lastSeen_s[placeIndex(i)]) /
                                 (flight_s + kGreedy_s);
            if (score > bestScore) {
                best = i;
                bestScore = score;
                bestStop = stop;
            }
        }
        if (!best || bestStop.time_s >= end_s(u) || route.visits.size() >= kMostVisits) {
            free->time_s = std::numeric_limits<double>::infinity();
            continue;
        }
        route.visits.push_back(*best);
        *free = bestStop;
        lastSeen_s[placeIndex(*best)] = bestStop.time_s;
        ++visits[placeIndex(*best)];
    }
    set(routes());
}

void PatrolSearch::improve(std::int64_t moves, double heat, const SolveWatch& watch)
{
    std::size_t count = 0;
    for (const Route& route : m_routes)
        count += route.visits.size();
    PatrolRoutes best = routes();
    double best_m2s = m_cost_m2s;
    const double hottest_m2s =
        heat * m_cost_m2s / static_cast<double>(std::max<std::size_t>(1, count));
    for (std::int64_t move = 0; move < moves && count > 0; ++move) {
        if (move % kMovesPerCheck == 0 && watch.stopReason())
            break;
        ++m_moves;
        const double left = 1 - static_cast<double>(move) / static_cast<double>(moves);
        // The random number of the Metropolis test is drawn first.
        const double limit_m2s = -hottest_m2s * left * left * std::log(1 - m_random.uniform());
        if (!step(limit_m2s))
            continue;
        if (m_cost_m2s < best_m2s * (1 - 1e-9)) {
            best_m2s = m_cost_m2s;
            best = routes();
        }
    }
    set(std::move(best));
}

} // namespace berg
