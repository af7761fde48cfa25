#include "core/coverage/coverage_policy.h"

#include "core/coverage/coverage_answer.h"
#include "core/coverage/coverage_settings.h"
#include "core/coverage/coverage_starts.h"
#include "core/coverage/fleet_coverage_search.h"
#include "core/coverage/own_inputs.h"
#include "core/coverage/patrol_plans.h"
#include "core/coverage/plan_conversion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace berg {

namespace {

/** Reports better plans to the maker of the request, at most a few tens a second. */
class ProgressReporter
{
public:
    ProgressReporter(std::span<const CoverageModel> models, const PlanRequest& request,
                     const SolveOptions& options)
        : m_models(models), m_request(request), m_options(options)
    {
    }

    void operator()(const FleetCoverage& better)
    {
        constexpr double kBetween_s = 0.02;
        const double elapsed_s = m_clock.elapsed_s();
        if (elapsed_s < m_next_s)
            return;
        m_next_s = elapsed_s + kBetween_s;
        SolveProgress progress{.objective = better.total_m2s, .elapsed_s = elapsed_s};
        for (UavPlan& uav : describeFleet(m_models, m_request, better.plans)) {
            progress.orders.push_back(std::move(uav.order));
            progress.legs.push_back(std::move(uav.legs));
        }
        m_options.onProgress(progress);
    }

private:
    std::span<const CoverageModel> m_models;
    const PlanRequest& m_request;
    const SolveOptions& m_options;
    Stopwatch m_clock;
    double m_next_s = 0;
};

/**
 * Returns the probability of finding each iceberg; it falls with each flight in vain to a lost
 * iceberg.
 */
std::vector<double> chancesOf(std::span<const IcebergIndex> ids,
                              const std::map<IcebergIndex, int>& inVain)
{
    constexpr double kAfterMiss = 0.3;
    std::vector<double> chances;
    for (const IcebergIndex id : ids) {
        const auto times = inVain.find(id);
        chances.push_back(times == inVain.end()
                              ? kChanceOfLost
                              : kChanceOfLost * std::pow(kAfterMiss, times->second));
    }
    return chances;
}

bool isMeasured(std::span<const PredictionInput> inputs)
{
    return inputs.front().observer.model != ObserverModel::Simple;
}

/** Minimises predicted zeta over sequences of icebergs and aim points, with a patrol after them in
 * sparse fields and long runs. */
class CoveragePolicy final : public Policy
{
public:
    Plan plan(const PlanRequest& request, const SolveOptions& options) override;

private:
    [[nodiscard]] CoverageLimits limitsOf(const PlanRequest& request, std::size_t uav,
                                          const CoverageModel& model) const;
    [[nodiscard]] CoverageLimits limitsOfPatrol(const PlanRequest& request, std::size_t uav,
                                                const CoverageModel& model) const;
    [[nodiscard]] FleetCoverageSearch searchFor(const PlanRequest& request,
                                                std::span<const CoverageModel> models,
                                                const PatrolTails* tails) const;
    [[nodiscard]] FoundPlans planLegs(const PlanRequest& request,
                                      std::span<const PredictionInput> inputs,
                                      const SolveOptions& options, const SolveWatch& watch) const;
    [[nodiscard]] FoundPlans planPatrol(const PlanRequest& request,
                                        std::span<const PredictionInput> inputs,
                                        const SolveOptions& options, const SolveWatch& watch) const;
    [[nodiscard]] bool wantsRest(const PlanRequest& request) const;
    [[nodiscard]] PatrolRoutes restOfPatrol(const PlanRequest& request,
                                            std::span<const CoverageModel> models) const;
    [[nodiscard]] std::optional<CoveragePlans>
    warmStart(const PlanRequest& request, std::span<const CoverageModel> models) const;
    [[nodiscard]] FleetCoverage first(FleetCoverageSearch& search, const PlanRequest& request,
                                      const SolveOptions& options, const SolveWatch& watch) const;
    [[nodiscard]] FleetCoverage next(FleetCoverageSearch& search,
                                     const std::optional<CoveragePlans>& warm,
                                     const SolveOptions& options, const SolveWatch& watch) const;

    /** Returns the work of a plan of this fleet from that of a plan of one UAV. */
    [[nodiscard]] std::int64_t work(std::int64_t ofOne) const
    {
        return m_isAlone ? ofOne : ofOne * 3 / 2;
    }

    [[nodiscard]] std::map<IcebergIndex, int> inVain(const PlanRequest& request) const;
    [[nodiscard]] Plan explore(const PlanRequest& request, const SolveOptions& options);
    void keep(const PlanRequest& request, const FoundPlans& plans, const Plan& answer);

    /** Last plan of a UAV. */
    struct Flown
    {
        KeptPlan plan; ///< The legs, followed by the patrol.
        /** Number of legs without the patrol; 0 if the UAV has flown home since. */
        std::size_t legs = 0;
        double planned_s = 0;
        /** Predicted sighting of the first leg; nullopt for a hold. */
        std::optional<double> sighting_s;
    };
    /** The key is the number of the UAV; the map is empty before the first plan. */
    std::map<int, Flown> m_last;
    /** Predicted cost of the last plans, if keeping icebergs in view pays. */
    double m_total_m2s = std::numeric_limits<double>::infinity();
    /** Number of flights in vain to each lost iceberg. */
    std::map<IcebergIndex, int> m_inVain;
    LastPlan m_lastKind = LastPlan::None;
    std::unique_ptr<TvpSolver> m_solver; ///< Solver of `m_latency`; both are null until needed.
    std::unique_ptr<Policy> m_latency;
    /**
     * No other UAV has ever been planned for. The last UAV of a fleet that still flies continues as
     * one of several.
     */
    bool m_isAlone = true;
};

/** Returns the places of a UAV's legs. Any of several UAVs may later come back to an iceberg that
 * is in view now; places of a lost one are left to the UAVs that may search there. */
CoverageLimits CoveragePolicy::limitsOf(const PlanRequest& request, std::size_t uav,
                                        const CoverageModel& model) const
{
    if (m_isAlone)
        return {};
    const UavRequest& own = request.uavs[uav];
    const std::vector<bool> any = availableToAny(request);
    CoverageLimits limits;
    for (const ModelPlace place : model.places()) {
        const std::size_t k = toIndex(model.icebergAt(place));
        const bool searches =
            k < own.prediction->places.size() && !own.prediction->places[k].empty();
        limits.first.push_back(own.available[k] || searches);
        limits.any.push_back(limits.first.back() || (!any[k] && !model.isSearched(place)));
    }
    return limits;
}

/** A UAV that is alone may come back to each iceberg, but begins with what is available. */
CoverageLimits CoveragePolicy::limitsOfPatrol(const PlanRequest& request, std::size_t uav,
                                              const CoverageModel& model) const
{
    CoverageLimits limits = limitsOf(request, uav, model);
    if (m_isAlone)
        limits.first = request.uavs[uav].available;
    return limits;
}

FleetCoverageSearch CoveragePolicy::searchFor(const PlanRequest& request,
                                              std::span<const CoverageModel> models,
                                              const PatrolTails* tails) const
{
    std::vector<CoverageFlyer> flyers;
    for (std::size_t u = 0; u < models.size(); ++u)
        flyers.push_back({.model = models[u],
                          .limits = tails ? limitsOfPatrol(request, u, models[u])
                                          : limitsOf(request, u, models[u])});
    const PredictionInput& input = *request.uavs.front().prediction;
    return {std::move(flyers), input.seed,
            stableHash("coverage") + static_cast<std::uint64_t>(input.step), tails};
}

/**
 * Returns the rests of the last plans, or nullopt if there are none or a warm start is not wanted.
 */
std::optional<CoveragePlans> CoveragePolicy::warmStart(const PlanRequest& request,
                                                       std::span<const CoverageModel> models) const
{
    if (m_last.empty() || std::ranges::all_of(request.uavs, [](const UavRequest& uav) {
            return uav.lastRest.empty();
        }))
        return std::nullopt;
    CoveragePlans rests;
    for (std::size_t u = 0; u < models.size(); ++u) {
        const UavRequest& uav = request.uavs[u];
        const auto last = m_last.find(uav.uav);
        CoveragePlan& rest = rests.emplace_back();
        if (last == m_last.end())
            continue;
        rest = restOf(last->second.plan, models[u], request.ids);
        shorten(rest, models[u], *uav.prediction, uav.prediction->time_s - last->second.planned_s);
    }
    return rests;
}

/** Returns `m_inVain` at the time of the request. */
std::map<IcebergIndex, int> CoveragePolicy::inVain(const PlanRequest& request) const
{
    std::map<IcebergIndex, int> inVain = m_inVain;
    const PredictionInput& input = *request.uavs.front().prediction;
    const auto isLost = [&](IcebergIndex id) {
        const auto k = std::ranges::find(request.ids, id) - request.ids.begin();
        return k < std::ssize(request.ids) &&
               input.tracks[static_cast<std::size_t>(k)].status != TrackStatus::Tracked;
    };
    std::erase_if(inVain, [&](const auto& entry) { return !isLost(entry.first); });
    for (const auto& [uav, last] : m_last)
        if (last.sighting_s && *last.sighting_s <= input.time_s)
            if (const std::optional<IcebergIndex>& id = last.plan.front().id; id && isLost(*id))
                ++inVain[*id];
    return inVain;
}

void CoveragePolicy::keep(const PlanRequest& request, const FoundPlans& plans, const Plan& answer)
{
    m_lastKind = plans.tails ? LastPlan::Patrol : LastPlan::Legs;
    if (!plans.tails) // A UAV on the ground continues its patrol.
        m_last.clear();
    if (plans.models.front().paysForSamples())
        m_total_m2s =
            plans.isStraight ? std::numeric_limits<double>::infinity() : plans.found.total_m2s;
    for (std::size_t u = 0; u < plans.found.plans.size(); ++u) {
        CoveragePlan plan = plans.found.plans[u];
        m_last.erase(request.uavs[u].uav);
        if (plans.tails)
            plan.insert(plan.end(), plans.patrols[u].begin(), plans.patrols[u].end());
        if (plan.empty())
            continue;
        Flown& last = m_last[request.uavs[u].uav];
        last = {.plan = keptPlan(plan, plans.models[u], request.ids),
                .legs = plans.found.plans[u].size(),
                .planned_s = request.uavs[u].prediction->time_s};
        if (const std::vector<AimedLeg>& legs = answer.uavs[u].legs;
            !legs.empty() && !legs.front().end_s)
            last.sighting_s = legs.front().sighting_s;
    }
}

FleetCoverage CoveragePolicy::first(FleetCoverageSearch& search, const PlanRequest& request,
                                    const SolveOptions& options, const SolveWatch& watch) const
{
    const bool paysForSamples =
        request.uavs.front().prediction->observer.model != ObserverModel::Simple;
    const std::int64_t work =
        options.workLimit.value_or(this->work(kFirstWork) * (paysForSamples ? kWorkOfSamples : 1));
    const auto share = static_cast<std::int64_t>(kShareOfStart * static_cast<double>(work));
    const SolveOptions limits{.timeLimit_s = options.timeLimit_s,
                              .workLimit = std::min(kOrderWork, work),
                              .stop = options.stop};
    std::optional<FleetCoverage> best;
    for (const CoveragePlans& start :
         m_isAlone ? firstPlansAlone(request, limits) : firstPlans(request, limits)) {
        const FleetCoverage found =
            search.improved(search.completed(start), search.work() + share, kHeat, watch);
        if (!best || found.total_m2s < best->total_m2s)
            best = found;
    }
    return search.improved(*best, work, kHeat, watch);
}

FleetCoverage CoveragePolicy::next(FleetCoverageSearch& search,
                                   const std::optional<CoveragePlans>& warm,
                                   const SolveOptions& options, const SolveWatch& watch) const
{
    FleetCoverage start = search.completed(CoveragePlans(search.uavCount()));
    if (warm) {
        FleetCoverage rest = search.completed(*warm);
        if (rest.total_m2s <= start.total_m2s)
            start = std::move(rest);
    }
    const bool isSetback = start.total_m2s > kSetback * m_total_m2s;
    const std::int64_t limit =
        options.workLimit.value_or(work(kNextWork) * (isSetback ? kWorkOfSetback : 1));
    if (isSetback)
        start =
            search.improved(start, limit - limit / kWorkOfSetback, kHeatOfSetback * kHeat, watch);
    return search.improved(start, limit, kHeat, watch);
}

/**
 * Returns whether a patrol continues the last one. The request has no rest of the last legs if a
 * warm start is not wanted, but also if these have all been flown.
 */
bool CoveragePolicy::wantsRest(const PlanRequest& request) const
{
    return std::ranges::all_of(request.uavs, [&](const UavRequest& uav) {
        const auto last = m_last.find(uav.uav);
        if (last == m_last.end() || !uav.lastRest.empty())
            return true;
        const auto legs = std::span(last->second.plan).first(last->second.legs);
        return std::ranges::none_of(legs, [&](const KeptLeg& kept) {
            const auto at = std::ranges::find(request.ids, kept.id) - request.ids.begin();
            return at < std::ssize(request.ids) && uav.available[static_cast<std::size_t>(at)];
        });
    });
}

/**
 * Returns the visits that are left of the last plans, or no visits if these are not continued. An
 * iceberg in view has been visited, although the UAV may have flown to another one.
 */
PatrolRoutes CoveragePolicy::restOfPatrol(const PlanRequest& request,
                                          std::span<const CoverageModel> models) const
{
    PatrolRoutes routes(models.size());
    if (!wantsRest(request))
        return {};
    bool isEmpty = true;
    for (std::size_t u = 0; u < models.size(); ++u) {
        const auto last = m_last.find(request.uavs[u].uav);
        if (last == m_last.end())
            continue;
        std::vector<bool> isVisited;
        for (const Track& track : request.uavs[u].prediction->tracks)
            isVisited.push_back(track.inView);
        const KeptPlan& kept = last->second.plan;
        for (std::size_t k = 0; k < kept.size(); ++k)
            for (const CoverageLeg& leg : restOf({kept[k]}, models[u], request.ids)) {
                if (leg.isHold())
                    continue;
                const ModelPlace iceberg = models[u].icebergAt(leg.iceberg);
                const std::size_t i = toIndex(iceberg);
                if (k < last->second.legs && isVisited[i])
                    isVisited[i] = false; // Its later visits remain.
                else
                    routes[u].push_back(iceberg.number());
            }
        isEmpty = isEmpty && routes[u].empty();
    }
    return isEmpty ? PatrolRoutes() : routes;
}

/** Plans aimed legs to the horizon. */
FoundPlans CoveragePolicy::planLegs(const PlanRequest& request,
                                    std::span<const PredictionInput> inputs,
                                    const SolveOptions& options, const SolveWatch& watch) const
{
    FoundPlans plans{.horizon = horizonOf(inputs)};
    plans.models = modelsOf(inputs, plans.horizon);
    FleetCoverageSearch search = searchFor(request, plans.models, nullptr);
    if (options.onProgress && m_last.empty()) // later plans take a few milliseconds
        search.setListener(ProgressReporter(plans.models, request, options));
    const std::optional<CoveragePlans> warm = warmStart(request, plans.models);
    plans.found = m_last.empty() ? first(search, request, options, watch)
                                 : next(search, warm, options, watch);
    plans.work = search.work();
    plans.wasWarm = warm.has_value();
    return plans;
}

/**
 * Plans a patrol of all UAVs, whose first visits become aimed legs. With measurements the UAV flies
 * straight to the first iceberg: if that is not at its estimate, the autopilot then searches for it
 * by pattern, which finds it farther away than plans do.
 */
FoundPlans CoveragePolicy::planPatrol(const PlanRequest& request,
                                      std::span<const PredictionInput> inputs,
                                      const SolveOptions& options, const SolveWatch& watch) const
{
    FoundPlans plans{.horizon = {.length_s = patrolLength_s(inputs)}};
    plans.models = modelsOf(inputs, plans.horizon);
    std::vector<CoverageLimits> limits;
    for (std::size_t u = 0; u < plans.models.size(); ++u)
        limits.push_back(limitsOfPatrol(request, u, plans.models[u]));
    PatrolRoutes rest = restOfPatrol(request, plans.models);
    plans.wasWarm = !rest.empty();
    const bool isFirst = m_lastKind != LastPlan::Patrol || rest.empty();
    const PredictionInput& input = inputs.front();
    const Random random(input.seed, stableHash("patrol") + static_cast<std::uint64_t>(input.step));
    PatrolSearch patrol(patrolProblem(inputs, limits), random);
    const PatrolEffort effort = patrolEffort(patrol.problem(), isFirst, options.workLimit);
    if (isFirst)
        findPatrol(patrol, rest, random, effort, watch);
    else
        improvePatrol(patrol, std::move(rest), effort, watch);

    plans.isStraight = plans.models.front().paysForSamples();
    std::vector<std::size_t> heads = headsOf(patrol);
    if (plans.isStraight)
        for (std::size_t& head : heads)
            head = std::min<std::size_t>(head, 1);
    plans.tails.emplace(patrol, heads);
    const std::vector<double> onTime_s(plans.models.size(), 0);
    std::size_t visits = 0;
    CoveragePlans start;
    for (std::size_t u = 0; u < plans.models.size(); ++u) {
        const std::size_t count = patrol.visits(u).size();
        visits += count;
        start.push_back(legsOf(patrol, u, {.begin = 0, .end = heads[u]}, plans.models[u]));
        plans.patrols.push_back(
            legsOf(patrol, u, {.begin = heads[u], .end = count}, plans.models[u]));
        plans.models[u].setTail(plans.tails->tailOf(u, onTime_s));
    }
    if (plans.isStraight) {
        plans.found.plans = std::move(start);
        plans.work = PatrolEffort::kWorkOfMove * patrol.moves();
        return plans;
    }
    FleetCoverageSearch search = searchFor(request, plans.models, &*plans.tails);
    if (options.onProgress && isFirst)
        search.setListener(ProgressReporter(plans.models, request, options));
    /** Patrols of this many visits have the heat of aimed plans, longer ones less for each leg. */
    constexpr double kVisitsOfHeat = 22;
    const double heat =
        kHeat * kVisitsOfHeat / std::max(kVisitsOfHeat, static_cast<double>(visits));
    plans.found = search.completed(start);
    plans.found = search.improved(plans.found, search.work() + effort.headWork, heat, watch);
    plans.work = search.work() + PatrolEffort::kWorkOfMove * patrol.moves();
    return plans;
}

/** Plans by least latency, which loses the fewest icebergs while velocities are unknown. */
Plan CoveragePolicy::explore(const PlanRequest& request, const SolveOptions& options)
{
    if (!m_latency) {
        m_solver = makeSolver(Backend::Auto);
        m_latency = makePolicy({.policy = PolicyKind::Latency}, *m_solver);
    }
    SolveOptions limited = options;
    const std::int64_t most = m_lastKind == LastPlan::None ? kFirstOrderWork : kNextOrderWork;
    limited.workLimit = std::min(most, options.workLimit.value_or(most));
    Plan answer = m_latency->plan(request, limited);
    if (answer.outcome.reason == StopReason::Cancelled)
        return answer;
    m_last.clear();
    m_lastKind = LastPlan::Patrol;
    return answer;
}

Plan CoveragePolicy::plan(const PlanRequest& request, const SolveOptions& options)
{
    m_isAlone = m_isAlone && request.uavs.size() == 1;
    const Stopwatch clock;
    const SolveWatch watch(options);
    std::vector<PredictionInput> inputs = ownInputs(request);
    std::map<IcebergIndex, int> inVain = this->inVain(request);
    for (PredictionInput& input : inputs)
        input.chances = chancesOf(request.ids, inVain);
    Plan answer{.uavs = std::vector<UavPlan>(request.uavs.size())};
    if (const std::vector<bool> any = availableToAny(request);
        std::find(any.begin(), any.end(), true) != any.end()) {
        const bool needsPatrol = berg::needsPatrol(inputs, m_lastKind);
        if (needsPatrol && isMeasured(inputs) && !knowsVelocities(inputs))
            return explore(request, options);
        const FoundPlans plans = needsPatrol ? planPatrol(request, inputs, options, watch)
                                             : planLegs(request, inputs, options, watch);
        const std::optional<StopReason> cut = watch.stopReason();
        if (cut == StopReason::Cancelled)
            return {.outcome = {.reason = StopReason::Cancelled, .source = AnswerSource::Coverage}};
        answer = answerOf(request, inputs, plans);
        if (m_isAlone)
            judgeAlone(answer, request);
        answer.outcome.reason = cut.value_or(StopReason::WorkLimit);
        answer.outcome.work = plans.work;
        answer.outcome.hintUsed = plans.wasWarm;
        keep(request, plans, answer);
    } else {
        for (const UavRequest& uav : request.uavs) // The legs that are left are for later.
            if (const auto last = m_last.find(uav.uav); last != m_last.end())
                last->second.legs = 0;
    }
    m_inVain = std::move(inVain);
    answer.outcome.status = SolveStatus::Feasible;
    answer.outcome.source = AnswerSource::Coverage;
    answer.outcome.elapsed_s = clock.elapsed_s();
    return answer;
}

} // namespace

std::unique_ptr<Policy> makeFlownPolicy(const PlannerSettings& settings, const TvpSolver& solver)
{
    if (settings.policy == PolicyKind::Coverage)
        return std::make_unique<CoveragePolicy>();
    return makePolicy(settings, solver);
}

} // namespace berg
