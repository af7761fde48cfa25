#include "core/coverage/coverage_policy.h"

#include "core/coverage/coverage_effort.h"
#include "core/coverage/described_plan.h"
#include "core/coverage/fleet_coverage_search.h"
#include "core/plan/fleet/fleet_solver.h"
#include "core/plan/solve/tuning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace berg {

namespace {

using Plans = std::vector<CoveragePlan>;

/** The UAV that has the iceberg in view; none is sure: the one nearest to it. */
std::size_t viewerOf(const PlanRequest& request, std::size_t iceberg)
{
    std::size_t nearest = 0;
    double nearest_m = std::numeric_limits<double>::infinity();
    for (std::size_t u = 0; u < request.uavs.size(); ++u) {
        const FlightPicture& picture = *request.uavs[u].picture;
        const Point place_m = picture.tracks[iceberg].estimate_m(picture.time_s);
        const double away_m = (place_m - picture.uav.position_m).norm();
        if (away_m < nearest_m) {
            nearest = u;
            nearest_m = away_m;
        }
    }
    return nearest;
}

bool isInViewOf(const FlightPicture& picture, std::size_t iceberg)
{
    return FieldOfView(picture.sensor, picture.uav.position_m, picture.uav.psi_rad)
        .contains(picture.tracks[iceberg].estimate_m(picture.time_s));
}

/** All UAVs know the places of lost icebergs, whoever may search there. */
void sharePlaces(std::vector<FlightPicture>& pictures)
{
    std::vector<std::vector<SearchPlace>>& all = pictures.front().places;
    for (const FlightPicture& picture : pictures)
        for (std::size_t i = 0; i < all.size(); ++i)
            if (all[i].empty())
                all[i] = picture.places[i];
    for (FlightPicture& picture : pictures)
        picture.places = all;
}

/** Tracks say what is in view of any UAV; here each picture says what is in view of its own. */
std::vector<FlightPicture> ownPictures(const PlanRequest& request)
{
    std::vector<FlightPicture> own;
    for (const UavRequest& uav : request.uavs) {
        require(uav.picture != nullptr, "CoveragePolicy: a UAV has no picture of its flight");
        own.push_back(*uav.picture);
    }
    for (std::size_t i = 0; i < request.ids.size(); ++i) {
        if (!own.front().tracks[i].inView)
            continue;
        bool isClear = false;
        for (FlightPicture& picture : own) {
            picture.tracks[i].inView = isInViewOf(picture, i);
            isClear = isClear || picture.tracks[i].inView;
        }
        if (!isClear)
            own[viewerOf(request, i)].tracks[i].inView = true;
    }
    sharePlaces(own);
    return own;
}

/** All are judged by what comes until the last of them ends its flight. */
std::vector<CoverageModel> modelsOf(std::span<const FlightPicture> pictures,
                                    std::optional<double> rest_s = std::nullopt)
{
    CoverageHorizon horizon = horizonOf(pictures);
    horizon.rest_s = rest_s.value_or(horizon.rest_s);
    std::vector<CoverageModel> models;
    for (const FlightPicture& picture : pictures) {
        horizon.flown_s = picture.until_s - picture.time_s;
        models.emplace_back(picture, horizon);
    }
    return models;
}

/** All icebergs, as the orders to start from see them, at tau = 1. */
FleetProblem fleetProblem(const PlanRequest& request)
{
    constexpr double kTau = 1;
    FleetProblem problem{.sigma_m2 = request.sigma_m2};
    problem.allowed.assign(request.uavs.size(), std::vector<bool>(problem.sigma_m2.size(), true));
    for (const UavRequest& uav : request.uavs)
        problem.distance_m.push_back(uav.distance_m);
    for (std::size_t k = 0; k < request.ids.size(); ++k) {
        const auto may = [k](const UavRequest& uav) { return uav.available[k]; };
        if (std::ranges::any_of(request.uavs, may)) // else in view now, and any may come later
            for (std::size_t u = 0; u < request.uavs.size(); ++u)
                problem.allowed[u][k + 1] = request.uavs[u].available[k];
    }
    problem.mu = fleetTuningWeight(problem, request.betweenUavs_m, kTau).mu;
    return problem;
}

/** The shortest tour over those icebergs, from the UAV and back. */
VisitOrder tourOf(TvpProblem problem, const VisitOrder& nodes, const SolveOptions& limits)
{
    problem.route = Route::Closed;
    problem.mu = 1;
    std::fill(problem.sigma_m2.begin(), problem.sigma_m2.end(), 0.0);
    const VisitOrder found =
        makeSolver(Backend::Auto)->solve(restrictedTo(problem, nodes), limits).order();
    VisitOrder tour;
    for (const int node : found)
        tour.push_back(nodes[static_cast<std::size_t>(node - 1)]);
    return tour;
}

/** Greedy, the orders at tau = 1, and round tours over what these give to each UAV. */
std::vector<Plans> firstPlans(const PlanRequest& request, const SolveOptions& limits)
{
    const FleetProblem problem = fleetProblem(request);
    FleetPlan orders = solveFleet(problem, Backend::Auto, limits).plan;
    orders.resize(request.uavs.size());
    Plans once;
    Plans round;
    for (std::size_t u = 0; u < orders.size(); ++u) {
        once.push_back(straightPlan(orders[u], 1));
        const TvpProblem own = problemOfUav(problem, static_cast<int>(u));
        round.push_back(straightPlan(tourOf(own, orders[u], limits), kRounds));
    }
    return {Plans(request.uavs.size()), once, round};
}

/** As `firstPlans`, with the order of least waiting, and the tour either way round. */
std::vector<Plans> firstPlansAlone(const PlanRequest& request, const SolveOptions& limits)
{
    const std::unique_ptr<TvpSolver> solver = makeSolver(Backend::Auto);
    TvpProblem problem = problemOfUav(fleetProblem(request), 0);
    const VisitOrder order = solver->solve(problem, limits).order();
    problem.mu = 1;
    VisitOrder soonest;
    if (*std::max_element(problem.sigma_m2.begin(), problem.sigma_m2.end()) > 0) {
        problem.criterion = Criterion::Latency;
        soonest = solver->solve(problem, limits).order();
        problem.criterion = Criterion::Visitation;
    }
    VisitOrder all(request.ids.size());
    std::iota(all.begin(), all.end(), 1);
    VisitOrder tour = tourOf(problem, all, limits);
    std::vector<Plans> starts{{{}}, {straightPlan(order, 1)}, {straightPlan(soonest, 1)}};
    starts.push_back({straightPlan(tour, kRounds)});
    std::reverse(tour.begin(), tour.end());
    starts.push_back({straightPlan(tour, kRounds)});
    return starts;
}

/** Predicted, without weights and with what comes after the horizon by `rest_s`. */
double zeta_m2s(std::vector<FlightPicture> pictures, std::optional<double> rest_s,
                std::span<const CoveragePlan> plans)
{
    for (FlightPicture& picture : pictures)
        picture.weights.clear();
    return fleetTotal_m2s(modelsOf(pictures, rest_s), plans);
}

double flown_m(const PlanRequest& request, std::span<const UavAnswer> answers)
{
    double sum_m = 0;
    for (std::size_t u = 0; u < answers.size(); ++u) {
        Eigen::Index from = 0;
        for (const int id : answers[u].order) {
            const auto it = std::find(request.ids.begin(), request.ids.end(), id);
            const Eigen::Index to = it - request.ids.begin() + 1;
            sum_m += request.uavs[u].distance_m(from, to);
            from = to;
        }
    }
    return sum_m;
}

/** The solve that found it is the caller's to tell of. */
PlanAnswer answerOf(const PlanRequest& request, std::span<const FlightPicture> pictures,
                    const FleetCoverage& found)
{
    const std::vector<FlightPicture> all(pictures.begin(), pictures.end());
    PlanAnswer answer{.uavs = describeFleet(modelsOf(pictures), request, found.plans)};
    answer.predictedZeta_m2s =
        isWeighted(all.front()) ? zeta_m2s(all, std::nullopt, found.plans) : found.total_m2s;
    const double outlook_m2s = zeta_m2s(all, 0, found.plans);
    for (UavAnswer& uav : answer.uavs)
        uav.outlook->zeta_m2s = outlook_m2s;
    answer.distance_m = flown_m(request, answer.uavs);
    return answer;
}

/** What Eq. (1) makes of the order of a UAV that is alone, and how far its legs go. */
void judgeAlone(PlanAnswer& answer, const PlanRequest& request)
{
    const UavAnswer& only = answer.uavs.front();
    VisitOrder nodes;
    for (const int id : only.order)
        nodes.push_back(static_cast<int>(std::ranges::find(request.ids, id) - request.ids.begin()) +
                        1);
    const TvpProblem problem = restrictedTo(
        {.distance_m = request.uavs.front().distance_m, .sigma_m2 = request.sigma_m2}, nodes);
    VisitOrder order(nodes.size());
    std::iota(order.begin(), order.end(), 1);
    answer.outcome.objective = objective(problem, order);
    answer.outcome.plan = {std::move(order)};
    answer.problem = problemOf(problem);
    answer.solvedIds = only.order;
    if (!only.outlook->sightings_s.empty())
        answer.distance_m = request.speed_mps * (only.outlook->sightings_s.back() -
                                                 request.uavs.front().picture->time_s);
}

/** Tells whoever made the request of better plans, a few tens a second at most. */
class ProgressTeller
{
public:
    ProgressTeller(std::span<const CoverageModel> models, const PlanRequest& request,
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
        for (UavAnswer& uav : describeFleet(m_models, m_request, better.plans)) {
            progress.plan.push_back(std::move(uav.order));
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

/** Each time a lost iceberg is flown to in vain there is less hope. */
std::vector<double> chancesOf(std::span<const int> ids, const std::map<int, int>& inVain)
{
    constexpr double kAfterMiss = 0.3;
    std::vector<double> chances;
    for (const int id : ids) {
        const auto times = inVain.find(id);
        chances.push_back(times == inVain.end()
                              ? kChanceOfLost
                              : kChanceOfLost * std::pow(kAfterMiss, times->second));
    }
    return chances;
}

/** Predicted zeta minimised over sequences of icebergs and aim points. */
class CoveragePolicy final : public Policy
{
public:
    PlanAnswer plan(const PlanRequest& request, const SolveOptions& options) override;

private:
    [[nodiscard]] CoverageLimits limitsOf(const PlanRequest& request, std::size_t uav,
                                          const CoverageModel& model) const;
    [[nodiscard]] FleetCoverageSearch searchFor(const PlanRequest& request,
                                                std::span<const CoverageModel> models) const;
    [[nodiscard]] std::optional<Plans> warmStart(const PlanRequest& request,
                                                 std::span<const CoverageModel> models) const;
    [[nodiscard]] FleetCoverage first(FleetCoverageSearch& search, const PlanRequest& request,
                                      const SolveOptions& options, const SolveWatch& watch) const;
    [[nodiscard]] FleetCoverage next(FleetCoverageSearch& search, const std::optional<Plans>& warm,
                                     const SolveOptions& options, const SolveWatch& watch) const;

    /** Plans of several UAVs take so much more work than those of one. */
    [[nodiscard]] std::int64_t work(std::int64_t ofOne) const
    {
        return m_isAlone ? ofOne : ofOne * 3 / 2;
    }

    [[nodiscard]] std::map<int, int> inVain(const PlanRequest& request) const;
    void keep(const PlanRequest& request, std::span<const CoverageModel> models,
              const FleetCoverage& found, const PlanAnswer& answer);

    /** What a UAV flies. */
    struct Flown
    {
        KeptPlan plan;
        double planned_s = 0;
        std::optional<double> sighting_s; ///< predicted for the first leg; none: a hold
    };
    std::map<int, Flown> m_last; ///< by number of the UAV; empty: no plan yet
    /** What they came to, where looks pay. */
    double m_total_m2s = std::numeric_limits<double>::infinity();
    /** How often a lost iceberg was flown to without being found, by id. */
    std::map<int, int> m_inVain;
    /** No other UAV has ever been planned for: the last one to fly goes on as one of several. */
    bool m_isAlone = true;
};

/** What is in view of one of several UAVs now may be visited again later, by any of them; places of
 * a lost one by those that may search there. */
CoverageLimits CoveragePolicy::limitsOf(const PlanRequest& request, std::size_t uav,
                                        const CoverageModel& model) const
{
    if (m_isAlone)
        return {};
    const UavRequest& own = request.uavs[uav];
    const std::vector<bool> any = availableToAny(request);
    CoverageLimits limits;
    for (int place = 0; place < model.placeCount(); ++place) {
        const auto k = static_cast<std::size_t>(model.icebergAt(place));
        const bool searches = k < own.picture->places.size() && !own.picture->places[k].empty();
        limits.first.push_back(own.available[k] || searches);
        limits.any.push_back(limits.first.back() || (!any[k] && !model.isSearched(place)));
    }
    return limits;
}

FleetCoverageSearch CoveragePolicy::searchFor(const PlanRequest& request,
                                              std::span<const CoverageModel> models) const
{
    std::vector<CoverageFlyer> flyers;
    for (std::size_t u = 0; u < models.size(); ++u)
        flyers.push_back({.model = models[u], .limits = limitsOf(request, u, models[u])});
    const FlightPicture& picture = *request.uavs.front().picture;
    return {std::move(flyers), picture.seed,
            stableHash("coverage") + static_cast<std::uint64_t>(picture.step)};
}

/** What is left of the plans that are flown. */
std::optional<Plans> CoveragePolicy::warmStart(const PlanRequest& request,
                                               std::span<const CoverageModel> models) const
{
    if (m_last.empty() || std::ranges::all_of(request.uavs, [](const UavRequest& uav) {
            return uav.lastRest.empty();
        }))
        return std::nullopt;
    Plans rests;
    for (std::size_t u = 0; u < models.size(); ++u) {
        const UavRequest& uav = request.uavs[u];
        const auto last = m_last.find(uav.uav);
        CoveragePlan& rest = rests.emplace_back();
        if (last == m_last.end())
            continue;
        rest = restOf(last->second.plan, models[u], request.ids);
        shorten(rest, models[u], *uav.picture, uav.picture->time_s - last->second.planned_s);
    }
    return rests;
}

/** As `m_inVain`, now. */
std::map<int, int> CoveragePolicy::inVain(const PlanRequest& request) const
{
    std::map<int, int> inVain = m_inVain;
    const FlightPicture& picture = *request.uavs.front().picture;
    const auto isLost = [&](int id) {
        const auto k = std::ranges::find(request.ids, id) - request.ids.begin();
        return k < std::ssize(request.ids) &&
               picture.tracks[static_cast<std::size_t>(k)].status != TrackStatus::Tracked;
    };
    std::erase_if(inVain, [&](const auto& entry) { return !isLost(entry.first); });
    for (const auto& [uav, last] : m_last)
        if (last.sighting_s && *last.sighting_s <= picture.time_s && isLost(last.plan.front().id))
            ++inVain[last.plan.front().id];
    return inVain;
}

void CoveragePolicy::keep(const PlanRequest& request, std::span<const CoverageModel> models,
                          const FleetCoverage& found, const PlanAnswer& answer)
{
    m_last.clear();
    if (models.front().paysForLooks())
        m_total_m2s = found.total_m2s;
    for (std::size_t u = 0; u < found.plans.size(); ++u) {
        if (found.plans[u].empty())
            continue;
        const AimedLeg& leg = answer.uavs[u].legs.front();
        m_last[request.uavs[u].uav] = {.plan = keptPlan(found.plans[u], models[u], request.ids),
                                       .planned_s = request.uavs[u].picture->time_s,
                                       .sighting_s = leg.end_s ? std::nullopt
                                                               : std::optional(leg.sighting_s)};
    }
}

FleetCoverage CoveragePolicy::first(FleetCoverageSearch& search, const PlanRequest& request,
                                    const SolveOptions& options, const SolveWatch& watch) const
{
    const bool paysForLooks = request.uavs.front().picture->observer.model != ObserverModel::Simple;
    const std::int64_t work =
        options.workLimit.value_or(this->work(kFirstWork) * (paysForLooks ? kWorkOfLooks : 1));
    const auto share = static_cast<std::int64_t>(kShareOfStart * static_cast<double>(work));
    const SolveOptions limits{.timeLimit_s = options.timeLimit_s,
                              .workLimit = std::min(kOrderWork, work),
                              .stop = options.stop};
    std::optional<FleetCoverage> best;
    for (const Plans& start :
         m_isAlone ? firstPlansAlone(request, limits) : firstPlans(request, limits)) {
        const FleetCoverage found =
            search.improved(search.completed(start), search.work() + share, kHeat, watch);
        if (!best || found.total_m2s < best->total_m2s)
            best = found;
    }
    return search.improved(*best, work, kHeat, watch);
}

FleetCoverage CoveragePolicy::next(FleetCoverageSearch& search, const std::optional<Plans>& warm,
                                   const SolveOptions& options, const SolveWatch& watch) const
{
    FleetCoverage start = search.completed(Plans(search.uavCount()));
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

PlanAnswer CoveragePolicy::plan(const PlanRequest& request, const SolveOptions& options)
{
    m_isAlone = m_isAlone && request.uavs.size() == 1;
    const Stopwatch clock;
    const SolveWatch watch(options);
    std::vector<FlightPicture> pictures = ownPictures(request);
    std::map<int, int> inVain = this->inVain(request);
    for (FlightPicture& picture : pictures)
        picture.chances = chancesOf(request.ids, inVain);
    PlanAnswer answer{.uavs = std::vector<UavAnswer>(request.uavs.size())};
    if (const std::vector<bool> any = availableToAny(request);
        std::find(any.begin(), any.end(), true) != any.end()) {
        const std::vector<CoverageModel> models = modelsOf(pictures);
        FleetCoverageSearch search = searchFor(request, models);
        if (options.onProgress && m_last.empty()) // later plans take a few milliseconds
            search.setListener(ProgressTeller(models, request, options));
        const std::optional<Plans> warm = warmStart(request, models);
        const FleetCoverage found = m_last.empty() ? first(search, request, options, watch)
                                                   : next(search, warm, options, watch);
        const std::optional<StopReason> cut = watch.cut();
        if (cut == StopReason::Cancelled)
            return {.outcome = {.reason = StopReason::Cancelled, .source = AnswerSource::Coverage}};
        answer = answerOf(request, pictures, found);
        if (m_isAlone)
            judgeAlone(answer, request);
        answer.outcome.reason = cut.value_or(StopReason::WorkLimit);
        answer.outcome.work = search.work();
        answer.outcome.hintUsed = warm.has_value();
        keep(request, models, found, answer);
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
