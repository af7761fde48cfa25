#include "core/coverage/coverage_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace berg {

namespace {

constexpr std::size_t kMostLegs = 2000;
/** Steps between checks of the watch, which take some 0.2 ms. */
constexpr int kStepsPerCheck = 32;
/** Temperature at the end, as a share of that at the beginning. */
constexpr double kCool = 0.02;
/** A candidate is discarded when it is behind by this share of the cost that is still to come. */
constexpr double kHope = 0.03;

} // namespace

CoverageSearch::CoverageSearch(const CoverageModel& model, const Random& random,
                               CoverageLimits limits)
    : m_model(model)
    , m_limits(std::move(limits))
    , m_moves(model, random, m_limits.any)
    , m_start(model.start())
{
}

CoverageResult CoverageSearch::completed(const CoveragePlan& plan)
{
    load(plan);
    return {.plan = m_now.legs, .total_m2s = m_now.total_m2s};
}

void CoverageSearch::load(const CoveragePlan& plan)
{
    m_start = m_model.start(); // The views of the other UAVs may have changed.
    m_now = {};
    m_candidate = plan;
    flyTail(0, std::numeric_limits<double>::infinity());
    accept(0);
}

CoverageResult CoverageSearch::improved(const CoverageResult& start, std::int64_t untilWork,
                                        double heat, const SolveWatch& watch)
{
    load(start.plan);
    CoverageResult best = start;
    report(best);
    anneal({.begin = m_work, .end = untilWork, .hottest_m2s = heat * m_now.total_m2s}, untilWork,
           watch, best);
    return best;
}

CoverageResult CoverageSearch::annealed(const CoveragePlan& now, const CoverageCooling& cooling,
                                        std::int64_t untilWork, const SolveWatch& watch,
                                        CoverageResult& best)
{
    load(now);
    if (m_now.total_m2s < best.total_m2s)
        best = {.plan = m_now.legs, .total_m2s = m_now.total_m2s};
    anneal(cooling, untilWork, watch, best);
    return {.plan = m_now.legs, .total_m2s = m_now.total_m2s};
}

void CoverageSearch::anneal(const CoverageCooling& cooling, std::int64_t untilWork,
                            const SolveWatch& watch, CoverageResult& best)
{
    for (int step = 0; m_work < untilWork && !m_now.legs.empty(); ++step) {
        if (step % kStepsPerCheck == 0 && watch.stopReason())
            break;
        const double left = static_cast<double>(cooling.end - m_work) /
                            static_cast<double>(cooling.end - cooling.begin);
        m_candidate = m_now.legs;
        std::size_t from = m_moves.change(m_candidate);
        // The random number of the Metropolis test is drawn first, so that the flight can end when
        // the test fails.
        const double worse_m2s =
            -cooling.hottest_m2s * (left * left + kCool) * std::log(1 - m_moves.uniform());
        ++m_work;
        for (const std::size_t all = std::min(m_candidate.size(), m_now.legs.size());
             from < all && m_candidate[from] == m_now.legs[from]; ++from)
            m_work += workOfLeg(); // The legs before the change are not flown again.
        if (!flyTail(from, m_now.total_m2s + worse_m2s))
            continue;
        accept(from);
        if (m_now.total_m2s < best.total_m2s) {
            best = {.plan = m_now.legs, .total_m2s = m_now.total_m2s};
            report(best);
        }
    }
}

void CoverageSearch::report(const CoverageResult& better)
{
    if (!m_listener || better.total_m2s >= m_reported_m2s)
        return;
    m_reported_m2s = better.total_m2s;
    m_listener(better);
}

/**
 * Flies the candidate from leg `from` on to the horizon. Returns false if it costs more than the
 * limit; the tail is then unusable.
 */
bool CoverageSearch::flyTail(std::size_t from, double limit_m2s)
{
    m_tail.legs.clear();
    std::size_t next = from;
    std::size_t place = from;
    // This is a function because the states move when there is no more room.
    const auto reached = [&]() -> const CoverageState& {
        return m_tail.legs.empty() ? stateBefore(from) : m_tail.states[m_tail.legs.size() - 1];
    };
    const bool flies =
        std::any_of(m_now.legs.begin(), m_now.legs.begin() + static_cast<std::ptrdiff_t>(from),
                    [](const CoverageLeg& leg) { return !leg.isHold(); });
    while (!m_model.atEnd(reached()) && m_tail.legs.size() < kMostLegs) {
        const bool planned = next < m_candidate.size();
        const bool isFirst = !flies && std::ranges::all_of(m_tail.legs, &CoverageLeg::isHold);
        if (!planned && m_model.tail() && from + m_tail.legs.size() > 0)
            break; // the patrol follows
        const std::optional<CoverageLeg> leg =
            planned ? m_candidate[next++] : greedyLeg(reached(), isFirst);
        if (!leg)
            break;
        if (planned && !mayFly(*leg, isFirst))
            continue;
        if (addToTail(reached(), *leg)) {
            if (hopeless(limit_m2s, place))
                return false;
        } else if (!planned) {
            break;
        }
    }
    m_tail.total_m2s = m_model.total_m2s(reached());
    return m_tail.total_m2s <= limit_m2s;
}

bool CoverageSearch::addToTail(const CoverageState& before, const CoverageLeg& leg)
{
    const std::size_t k = m_tail.legs.size();
    if (m_tail.states.size() <= k) {
        CoverageState copy = before; // The state may be in the vector that is about to move.
        m_tail.states.push_back(std::move(copy));
        m_tail.soFar_m2s.push_back(0);
    } else {
        m_tail.states[k] = before;
    }
    m_work += workOfLeg();
    CoverageState& state = m_tail.states[k];
    if (!m_model.fly(state, leg))
        return false;
    if (!m_model.tail()) // Only `hopeless` reads it.
        m_tail.soFar_m2s[k] = m_model.costSoFar_m2s(state);
    m_tail.legs.push_back(leg);
    return true;
}

/**
 * Returns whether the tail's last leg has cost so much more than the present plan had at that time
 * that the rest will hardly make up for it. `place` is the index of a leg of the present plan
 * before that time; it advances with each call.
 */
bool CoverageSearch::hopeless(double limit_m2s, std::size_t& place) const
{
    if (m_model.tail())
        return false; // The patrol after the legs makes up for much.
    const std::size_t last = m_tail.legs.size() - 1;
    const double time_s = m_tail.states[last].time_s;
    while (place < m_now.legs.size() && m_now.states[place].time_s < time_s)
        ++place;
    if (place == m_now.legs.size() || !std::isfinite(limit_m2s))
        return false;
    const double from_s = stateBefore(place).time_s;
    const double from_m2s = place == 0 ? 0 : m_now.soFar_m2s[place - 1];
    const double share = (time_s - from_s) / (m_now.states[place].time_s - from_s);
    const double now_m2s = from_m2s + share * (m_now.soFar_m2s[place] - from_m2s);
    return m_tail.soFar_m2s[last] - now_m2s >
           limit_m2s - m_now.total_m2s + kHope * (m_now.total_m2s - now_m2s);
}

void CoverageSearch::accept(std::size_t from)
{
    const std::size_t count = from + m_tail.legs.size();
    m_now.legs.resize(from);
    m_now.legs.insert(m_now.legs.end(), m_tail.legs.begin(), m_tail.legs.end());
    if (m_now.states.size() < count) {
        m_now.states.resize(count);
        m_now.soFar_m2s.resize(count);
    }
    for (std::size_t k = from; k < count; ++k) {
        std::swap(m_now.states[k], m_tail.states[k - from]);
        m_now.soFar_m2s[k] = m_tail.soFar_m2s[k - from];
    }
    m_now.total_m2s = m_tail.total_m2s;
}

bool CoverageSearch::mayFly(const CoverageLeg& leg, bool isFirst) const
{
    if (leg.isHold())
        return true;
    const std::size_t i = toIndex(leg.iceberg);
    return (m_limits.any.empty() || m_limits.any[i]) &&
           (!isFirst || m_limits.first.empty() || m_limits.first[i]);
}

/**
 * Returns a leg to the place with the largest sigma per distance, or nullopt if every iceberg is in
 * view.
 */
std::optional<CoverageLeg> CoverageSearch::greedyLeg(const CoverageState& state, bool isFirst) const
{
    constexpr double kShortestPath_m = 50;
    std::optional<CoverageLeg> best;
    double bestScore = 0;
    for (const ModelPlace i : m_model.places()) {
        if (m_model.inView(state, i) || !mayFly({.iceberg = i}, isFirst))
            continue;
        const double path_m =
            std::max(kShortestPath_m, m_model.distance_m(state, i) - m_model.largestOffset_m());
        const double score = m_model.chanceAt(state, i) * m_model.sigma_m2(state, i) / path_m;
        if (!best || score > bestScore) {
            best = CoverageLeg{.iceberg = i, .offset_m = 0};
            bestScore = score;
        }
    }
    return best;
}

} // namespace berg
