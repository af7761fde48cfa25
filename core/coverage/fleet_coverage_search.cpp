#include "core/coverage/fleet_coverage_search.h"

#include <algorithm>
#include <utility>

namespace berg {

namespace {

/** A UAV's turn takes so many times the work of its plan's flight, of which two begin it. */
constexpr std::int64_t kFlightsOfTurn = 30;

std::vector<CoverageView> viewsOf(const CoverageModel& model, const CoveragePlan& plan)
{
    std::vector<CoverageView> views;
    CoverageState state = model.start();
    for (const CoverageLeg& leg : plan)
        model.fly(state, leg, nullptr, &views);
    return views;
}

} // namespace

/** A UAV with the plan that stands while the others' change. */
struct FleetCoverageSearch::Member
{
    Member(CoverageFlyer flyer, const Random& random)
        : model(std::move(flyer.model))
        , first(flyer.limits.first)
        , search(model, random, std::move(flyer.limits))
    {
    }

    CoverageModel model;
    std::vector<bool> first; ///< to which its first leg may go if no other's does
    CoverageSearch search;
    CoveragePlan plan;
    std::vector<CoverageView> views; ///< of the plan
};

FleetCoverageSearch::FleetCoverageSearch(std::vector<CoverageFlyer> flyers, std::uint64_t seed,
                                         std::uint64_t stream)
{
    for (std::size_t u = 0; u < flyers.size(); ++u) {
        const std::uint64_t own = stream + (static_cast<std::uint64_t>(u) << 32U);
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
        lookAtOthers(u);
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
    if (m_members.size() == 1 && m_members.front()->first.empty())
        return improvedAlone(start, untilWork, heat, watch);
    FleetCoverage best = start;
    tell(best);
    for (std::size_t u = 0; u < m_members.size(); ++u)
        fix(u, start.plans[u]);
    const CoverageCooling cooling{
        .begin = work(), .end = untilWork, .hottest_m2s = heat * start.total_m2s};
    std::int64_t before = -1;
    while (work() < untilWork && work() > before && !watch.cut()) { // without any leg: no work
        before = work();
        for (std::size_t u = 0; u < m_members.size(); ++u)
            turnOf(u, cooling, watch, best);
    }
    return best;
}

/** There is nobody to take turns with: one annealing without a break. */
FleetCoverage FleetCoverageSearch::improvedAlone(const FleetCoverage& start, std::int64_t untilWork,
                                                 double heat, const SolveWatch& watch)
{
    CoverageSearch& search = m_members.front()->search;
    if (m_listener)
        search.setListener([this](const CoverageResult& better) {
            tell({.plans = {better.plan}, .total_m2s = better.total_m2s});
        });
    const CoverageResult best = search.improved(
        {.plan = start.plans.front(), .total_m2s = start.total_m2s}, untilWork, heat, watch);
    return {.plans = {best.plan}, .total_m2s = best.total_m2s};
}

/** One slice of the annealing. */
void FleetCoverageSearch::turnOf(std::size_t member, const CoverageCooling& cooling,
                                 const SolveWatch& watch, FleetCoverage& best)
{
    Member& own = *m_members[member];
    lookAtOthers(member);
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
        tell(best);
    }
    fix(member, now.plan);
}

/** The plan stands from now on. */
void FleetCoverageSearch::fix(std::size_t member, CoveragePlan plan)
{
    Member& own = *m_members[member];
    own.views = viewsOf(own.model, plan);
    own.plan = std::move(plan);
}

/** What the others' plans mean for a UAV whose turn it is. */
void FleetCoverageSearch::lookAtOthers(std::size_t member)
{
    Member& own = *m_members[member];
    std::vector<CoverageView> views;
    std::vector<bool> first = own.first;
    for (std::size_t v = 0; v < m_members.size(); ++v) {
        if (v == member)
            continue;
        const Member& other = *m_members[v];
        views.insert(views.end(), other.views.begin(), other.views.end());
        if (const int iceberg = firstIceberg(other.plan); iceberg >= 0)
            first[static_cast<std::size_t>(iceberg)] = false;
    }
    own.model.setOthers(std::move(views));
    own.search.setFirst(std::move(first));
}

std::vector<CoveragePlan> FleetCoverageSearch::plans() const
{
    std::vector<CoveragePlan> plans;
    for (const auto& member : m_members)
        plans.push_back(member->plan);
    return plans;
}

void FleetCoverageSearch::tell(const FleetCoverage& better)
{
    if (!m_listener || better.total_m2s >= m_told_m2s)
        return;
    m_told_m2s = better.total_m2s;
    m_listener(better);
}

double fleetTotal_m2s(std::span<const CoverageModel> models, std::span<const CoveragePlan> plans)
{
    std::vector<CoverageView> views;
    for (std::size_t u = 1; u < models.size(); ++u) {
        const std::vector<CoverageView> own = viewsOf(models[u], plans[u]);
        views.insert(views.end(), own.begin(), own.end());
    }
    CoverageModel merged = models.front();
    merged.setOthers(std::move(views));
    CoverageState state = merged.start();
    for (const CoverageLeg& leg : plans.front())
        merged.fly(state, leg);
    return merged.total_m2s(state);
}

} // namespace berg
