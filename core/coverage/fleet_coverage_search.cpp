#include "core/coverage/fleet_coverage_search.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace berg {

namespace {

/** Work of a UAV's turn, in flights of its plan, of which two begin the turn. */
constexpr std::int64_t kFlightsOfTurn = 30;

/** The effects of a UAV's plan on the other UAVs: its views and the shift of its patrol. */
struct Effect
{
    std::vector<CoverageView> views;
    double shift_s = 0; ///< Delay of the patrol after the plan.
};

Effect effectOf(const CoverageModel& model, const CoveragePlan& plan)
{
    Effect effect;
    CoverageState state = model.start();
    for (const CoverageLeg& leg : plan)
        model.fly(state, leg, nullptr, &effect.views);
    if (model.tail())
        effect.shift_s = model.tail()->shift_s(state.uav, state.time_s);
    return effect;
}

} // namespace

/** A UAV with its plan, which stays unchanged while the others' plans change. */
struct FleetCoverageSearch::Member
{
    Member(CoverageFlyer flyer, const Random& random)
        : model(std::move(flyer.model))
        , first(flyer.limits.first)
        , search(model, random, std::move(flyer.limits))
    {
    }

    CoverageModel model;
    /** Places to which its first leg may go unless that of another UAV does. */
    std::vector<bool> first;
    CoverageSearch search;
    CoveragePlan plan;
    Effect effect; ///< Effect of the plan.
};

FleetCoverageSearch::FleetCoverageSearch(std::vector<CoverageFlyer> flyers, std::uint64_t seed,
                                         std::uint64_t stream, const PatrolTails* tails)
    : m_tails(tails)
{
    const std::vector<double> onTime_s(flyers.size(), 0);
    for (std::size_t u = 0; u < flyers.size(); ++u) {
        const std::uint64_t own = stream + (static_cast<std::uint64_t>(u) << 32U);
        if (m_tails)
            flyers[u].model.setTail(m_tails->tailOf(u, onTime_s));
        m_members.push_back(std::make_unique<Member>(std::move(flyers[u]), Random(seed, own)));
    }
}

FleetCoverageSearch::~FleetCoverageSearch() = default;

std::int64_t FleetCoverageSearch::work() const
{
    std::int64_t work = 0;
    for (const auto& member : m_members)
        work += member->search.work();
    return work;
}

FleetCoverage FleetCoverageSearch::completed(std::span<const CoveragePlan> plans)
{
    for (std::size_t u = 0; u < m_members.size(); ++u)
        fix(u, plans[u]);
    FleetCoverage result;
    for (std::size_t u = 0; u < m_members.size(); ++u) {
        updateOthers(u);
        CoverageResult found = m_members[u]->search.completed(plans[u]);
        result.total_m2s = found.total_m2s;
        fix(u, std::move(found.plan));
    }
    result.plans = this->plans();
    return result;
}

FleetCoverage FleetCoverageSearch::improved(const FleetCoverage& start, std::int64_t untilWork,
                                            double heat, const SolveWatch& watch)
{
    if (m_members.size() == 1 && (m_tails || m_members.front()->first.empty()))
        return improvedAlone(start, untilWork, heat, watch);
    FleetCoverage best = start;
    report(best);
    for (std::size_t u = 0; u < m_members.size(); ++u)
        fix(u, start.plans[u]);
    const CoverageCooling cooling{
        .begin = work(), .end = untilWork, .hottest_m2s = heat * start.total_m2s};
    std::int64_t before = -1;
    while (work() < untilWork && work() > before &&
           !watch.stopReason()) { // Without any leg no work is done.
        before = work();
        for (std::size_t u = 0; u < m_members.size(); ++u)
            turnOf(u, cooling, watch, best);
    }
    return best;
}

/** A single UAV has one annealing without turns. */
FleetCoverage FleetCoverageSearch::improvedAlone(const FleetCoverage& start, std::int64_t untilWork,
                                                 double heat, const SolveWatch& watch)
{
    CoverageSearch& search = m_members.front()->search;
    if (m_listener)
        search.setListener([this](const CoverageResult& better) {
            report({.plans = {better.plan}, .total_m2s = better.total_m2s});
        });
    const CoverageResult best = search.improved(
        {.plan = start.plans.front(), .total_m2s = start.total_m2s}, untilWork, heat, watch);
    return {.plans = {best.plan}, .total_m2s = best.total_m2s};
}

/** Runs one part of the annealing for a UAV. */
void FleetCoverageSearch::turnOf(std::size_t member, const CoverageCooling& cooling,
                                 const SolveWatch& watch, FleetCoverage& best)
{
    Member& own = *m_members[member];
    updateOthers(member);
    const std::int64_t before = own.search.work();
    const std::int64_t others = work() - before;
    const auto flight = static_cast<std::int64_t>(own.plan.size() + 1) *
                        (CoverageSearch::kWorkOfLeg + own.model.placeCount());
    CoverageResult better{.plan = {}, .total_m2s = best.total_m2s};
    const CoverageResult now = own.search.annealed(
        own.plan,
        {.begin = cooling.begin - others,
         .end = cooling.end - others,
         .hottest_m2s = cooling.hottest_m2s},
        std::min(cooling.end - others, before + kFlightsOfTurn * flight), watch, better);
    if (better.total_m2s < best.total_m2s) {
        best = {.plans = plans(), .total_m2s = better.total_m2s};
        best.plans[member] = std::move(better.plan);
        report(best);
    }
    fix(member, now.plan);
}

/** Fixes the plan of a UAV and its effects on the others. */
void FleetCoverageSearch::fix(std::size_t member, CoveragePlan plan)
{
    Member& own = *m_members[member];
    own.effect = effectOf(own.model, plan);
    own.plan = std::move(plan);
}

/** Sets the views and patrols of the others for the UAV whose turn it is. */
void FleetCoverageSearch::updateOthers(std::size_t member)
{
    Member& own = *m_members[member];
    std::vector<CoverageView> views;
    std::vector<double> shifts_s;
    std::vector<bool> first = own.first;
    for (std::size_t v = 0; v < m_members.size(); ++v) {
        const Member& other = *m_members[v];
        shifts_s.push_back(v == member ? 0 : other.effect.shift_s);
        if (v == member)
            continue;
        views.insert(views.end(), other.effect.views.begin(), other.effect.views.end());
        if (const std::optional<ModelPlace> iceberg = firstIceberg(other.plan))
            first[toIndex(*iceberg)] = false;
    }
    own.model.setOthers(std::move(views));
    if (m_tails)
        own.model.setTail(m_tails->tailOf(member, shifts_s));
    own.search.setFirst(std::move(first));
}

std::vector<CoveragePlan> FleetCoverageSearch::plans() const
{
    std::vector<CoveragePlan> plans;
    for (const auto& member : m_members)
        plans.push_back(member->plan);
    return plans;
}

void FleetCoverageSearch::report(const FleetCoverage& better)
{
    if (!m_listener || better.total_m2s >= m_reported_m2s)
        return;
    m_reported_m2s = better.total_m2s;
    m_listener(better);
}

double fleetTotal_m2s(std::span<const CoverageModel> models, std::span<const CoveragePlan> plans,
                      const PatrolTails* tails)
{
    std::vector<CoverageView> views;
    const std::vector<double> onTime_s(models.size(), 0);
    std::vector<double> shifts_s(models.size(), 0);
    for (std::size_t u = 1; u < models.size(); ++u) {
        CoverageModel model = models[u];
        if (tails)
            model.setTail(tails->tailOf(u, onTime_s));
        const Effect own = effectOf(model, plans[u]);
        views.insert(views.end(), own.views.begin(), own.views.end());
        shifts_s[u] = own.shift_s;
    }
    CoverageModel merged = models.front();
    merged.setOthers(std::move(views));
    if (tails)
        merged.setTail(tails->tailOf(0, shifts_s));
    CoverageState state = merged.start();
    for (const CoverageLeg& leg : plans.front())
        merged.fly(state, leg);
    return merged.total_m2s(state);
}

} // namespace berg
